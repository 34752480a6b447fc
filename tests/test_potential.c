/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Potential flows: published closed forms, and what any of them must satisfy. */
#include "close.h"
#include "wind/shelter_laws.h"

static const double pi = 3.14159265358979323846;

static void cylinder_holds_the_stream_off(void **state)
{
    (void)state;
    double u[2];
    for (int k = 0; k < 24; k++) { /* no flow through the surface, whatever the circulation */
        double t = 2 * pi * (k + 0.3) / 24, x[2] = { 0.7 * cos(t), 0.7 * sin(t) };
        wf_flow_cylinder(12, 0.7, 5, x, u);
        assert_close(u[0] * x[0] + u[1] * x[1], 0, 1e-13);
        wf_flow_cylinder(12, 0.7, 0, x, u);
        assert_close(hypot(u[0], u[1]), fabs(24 * sin(t)), 1e-13);
        assert_close(wf_flow_pressure(12, u), 1 - 4 * sin(t) * sin(t), 1e-12);
    }
    /* on the axis behind it the stream is back to 96 % at 5 radii and 98 % at 7 */
    wf_flow_cylinder(1, 0.7, 0, (double[]){ 3.5, 0 }, u);
    assert_close(u[0], 1 - 1.0 / 25, 1e-15);
    wf_flow_cylinder(1, 0.7, 0, (double[]){ 4.9, 0 }, u);
    assert_close(u[0], 1 - 1.0 / 49, 1e-15);
}

/* Flow out of a sphere around the sources, by the product rule in z and angle. */
static double outflow(void (*flow)(double, const double *, double *), double radius)
{
    enum { N = 400 };
    double sum = 0, u[3];
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 16; k++) {
            double c = -1 + 2 * (i + 0.5) / N, s = sqrt(1 - c * c), t = 2 * pi * k / 16;
            const double n[3] = { s * cos(t), s * sin(t), c },
                         x[3] = { radius * n[0], radius * n[1], radius * c };
            flow(3, x, u);
            sum += u[0] * n[0] + u[1] * n[1] + u[2] * n[2];
        }
    return sum * 4 * pi * radius * radius / (N * 16);
}

static void segment(double q, const double *x, double *u) { wf_flow_segment_source(q, -0.4, 0.3, x, u); }
static void point(double q, const double *x, double *u) { wf_flow_point_source(q, x, u); }

static void sources_give_what_they_are_asked_for(void **state)
{
    (void)state;
    assert_close(outflow(point, 0.9), 3, 1e-12);
    assert_close(outflow(segment, 0.9), 3 * 0.7, 1e-5);
    double line[3], far[3], near[3];
    const double x[3] = { 0.02, 0.03, 0.05 };
    wf_flow_line_source(3, x, line); /* a long segment is an infinite line */
    wf_flow_segment_source(3, -1e4, 1e4, x, far);
    for (int i = 0; i < 2; i++) assert_close(far[i], line[i], 1e-9);
    const double away[3] = { 300, -400, 200 }; /* a short one a point */
    wf_flow_segment_source(3, -0.05, 0.05, away, far);
    wf_flow_point_source(0.3, away, near);
    for (int i = 0; i < 3; i++) assert_close(far[i], near[i], 1e-7);
    /* just off the axis beyond the end: radial flow grows like the distance from it */
    wf_flow_segment_source(3, 0, 2, (double[]){ 1e-7, 0, 5 }, near);
    assert_close(near[0], 3 / (4 * pi) * 0.5 * (1.0 / 9 - 1.0 / 25) * 1e-7, 1e-12);
    wf_flow_segment_source(3, 0, 2, (double[]){ 1e-7, 0, -3 }, near);
    assert_close(near[0], 3 / (4 * pi) * 0.5 * (1.0 / 9 - 1.0 / 25) * 1e-7, 1e-12);
}

/* The printed potentials and the velocities belong together. */
static void printed_forms_and_their_velocities(void **state)
{
    (void)state;
    const double x[2] = { 1.3, -0.8 }, h = 1e-5;
    double lo[2], hi[2], u[3], flow[2];
    wf_flow_cylinder(10, 1, 0, x, u);
    for (int i = 0; i < 2; i++) {
        double a[2] = { x[0], x[1] }, b[2] = { x[0], x[1] };
        a[i] -= h, b[i] += h;
        wf_feng_cylinder_potential(10, 1, a, lo);
        wf_feng_cylinder_potential(10, 1, b, hi);
        assert_close((hi[0] - lo[0]) / (2 * h), u[i], 1e-8);
        flow[1 - i] = (hi[1] - lo[1]) / (2 * h) * (i ? 1 : -1);
    }
    assert_close(flow[0], u[0], 1e-8);
    assert_close(flow[1], u[1], 1e-8);
    wf_flow_line_source(6, (double[]){ x[0], x[1], 0 }, u);
    for (int i = 0; i < 2; i++) {
        double a[2] = { x[0], x[1] }, b[2] = { x[0], x[1] };
        a[i] -= h, b[i] += h;
        wf_feng_hole_potential(6, a, lo);
        wf_feng_hole_potential(6, b, hi);
        assert_close((hi[0] - lo[0]) / (2 * h), u[i], 1e-8);
    }
    wf_feng_slit(10, 2, x, u);
    assert_close(u[0],
                 (wf_feng_slit_stream(10, 2, (double[]){ x[0], x[1] + h }) -
                  wf_feng_slit_stream(10, 2, (double[]){ x[0], x[1] - h })) /
                     (2 * h),
                 1e-8);
    assert_close(u[1],
                 -(wf_feng_slit_stream(10, 2, (double[]){ x[0] + h, x[1] }) -
                   wf_feng_slit_stream(10, 2, (double[]){ x[0] - h, x[1] })) /
                     (2 * h),
                 1e-8);
    wf_feng_slit(10, 2, (double[]){ 1, 1e-9 }, u);
    assert_close(u[1], 20, 1e-12);
    wf_feng_slit(10, 2, (double[]){ 1, 1e3 }, u);
    assert_close(u[1], 10 * 2 / 1e3, 1e-6);
    /* the axisymmetric velocity from the same stream function is that of the line source */
    double radial = 4 * pi * 10, want[3];
    wf_flow_segment_source(radial, 0, 2, (double[]){ 0.8, 0, 1.3 }, want);
    wf_feng_slit(10, 2, (double[]){ 1.3, 0.8 }, u);
    assert_close(u[1] / 0.8, want[0], 1e-13);
    assert_close(-u[0] / 0.8, -want[2], 1e-13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cylinder_holds_the_stream_off),
        cmocka_unit_test(sources_give_what_they_are_asked_for),
        cmocka_unit_test(printed_forms_and_their_velocities),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
