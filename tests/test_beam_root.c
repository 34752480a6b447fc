/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The elastic root plate: a stem too stiff to bend, on springs. */
#include "beam_cases.h"
#include "solve/modes.h"

static const double length = 4, soft[2] = { 3000, 1000 }; /* N m/rad about x and y */

static void plate(struct beam_case *c)
{
    beam_stem(c, 3, upright, length, 0.03, 0.03);
    for (size_t i = 0; i < 3; i++) c->tree.youngs[i] = 1e18, c->tree.shear[i] = 4e17;
    memcpy(c->options.root_stiffness, soft, sizeof soft);
}

/* k angle = P L cos(angle), in either direction, up to large tilts. */
static void tilts(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++)
        for (double angle = 0.01; angle < 1.3; angle += 0.4) {
            struct beam_case c;
            plate(&c);
            double P = soft[k] * angle / (length * cos(angle));
            beam_push(&c, 2, WF_POINT_DEAD, k ? P : 0, k ? 0 : -P, 0);
            beam_solve(&c);
            assert_close(c.out.turn[6 + k], angle, 1e-8);
            assert_close(c.out.turn[k], angle, 1e-8);
            assert_close(c.out.end[6 + (k ? 0 : 1)], (k ? 1 : -1) * length * sin(angle), 1e-8);
            assert_close(c.out.base_moment[k], soft[k] * angle, 1e-8);
            beam_free(&c);
        }
}

static void tilts_a_little(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++)
        for (int large = 0; large < 2; large++) {
            struct beam_case c;
            plate(&c);
            beam_push(&c, 2, WF_POINT_DEAD, 1e-3, -1e-3, 0);
            assert_int_equal(beam_try(&c, large ? &wf_solver_beam : &wf_solver_linear), WF_OK);
            assert_close(c.out.turn[6 + k], 1e-3 * length / soft[k], 1e-5);
            assert_close(c.out.tangent0[k ? 0 : 1], (k ? 1 : -1) * 1e-3 * length / soft[k], 1e-5);
            beam_free(&c);
        }
}

/* One spring only: the other axis is clamped. */
static void one_axis(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct beam_case c;
        plate(&c);
        c.options.root_stiffness[1 - k] = 0;
        double f = soft[k] * 0.5 / (length * cos(0.5));
        beam_push(&c, 2, WF_POINT_DEAD, f, -f, 0);
        beam_solve(&c);
        assert_close(c.out.turn[6 + k], 0.5, 1e-8);
        assert_true(fabs(c.out.turn[6 + 1 - k]) < 1e-7);
        beam_free(&c);
    }
}

/* A heavy rod on a spring falls when W L/2 = k, and first about the softer axis; past that it leans at k
 * angle = W L/2 sin(angle). */
static void falls(void **state)
{
    (void)state;
    struct beam_case c;
    double factor, share = 1.3;
    plate(&c);
    double weight = 800 * PI * 9e-4 * length * 9.81;
    c.loads.gravity = 9.81;
    assert_int_equal(wf_buckling(&c.tree, &c.loads, &c.options, &c.arena, &factor, &c.err), WF_OK);
    assert_close(factor, soft[1] / (weight * length / 2), 1e-8);
    c.loads.gravity *= factor * 0.999;
    beam_solve(&c);
    assert_true(c.out.load_factor == 1 && fabs(c.out.end[6]) < 1e-9 && !c.diag.warnings);
    c.loads.gravity *= share / 0.999;
    beam_solve(&c);
    assert_close(c.out.load_factor, 1 / share, 1e-3);
    assert_int_equal(c.diag.warnings, 1);
    assert_string_equal(c.diag.first->code, "limit-point");
    double angle = c.out.turn[1];
    assert_true(fabs(angle) > 0.5);
    assert_close(angle, share * sin(angle), 1e-7);
    beam_free(&c);
}

/* omega^2 = k / (m L^2/3), and with weight (k - W L/2) / (m L^2/3). */
static void sways(void **state)
{
    (void)state;
    struct beam_case c;
    plate(&c);
    double m = 800 * PI * 9e-4 * length, inertia = m * length * length / 3, f[2], shape[2 * 9];
    assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 2, &c.arena, f, shape, &c.err), WF_OK);
    assert_close(f[0], sqrt(soft[1] / inertia) / (2 * PI), 1e-6);
    assert_close(f[1], sqrt(soft[0] / inertia) / (2 * PI), 1e-6);
    assert_close(fabs(shape[6]), 1, 1e-12);
    assert_close(shape[0] / shape[6], 1. / 3, 1e-6);
    c.loads.gravity = 9.81;
    assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 1, &c.arena, f, NULL, &c.err), WF_OK);
    assert_close(f[0], sqrt((soft[1] - m * 9.81 * length / 2) / inertia) / (2 * PI), 1e-6);
    beam_free(&c);
}

/* Two stems, each on its own plate: they do not know of each other; moments are about the first base. */
static void two_roots(void **state)
{
    (void)state;
    struct beam_case c;
    beam_new(&c, 2);
    for (size_t i = 0; i < 2; i++) {
        double x = 5 * (double)i;
        beam_row(&c, i, -1, (double[3]){ x, 0, 0 }, (double[3]){ x, 0, length }, 0.03, 0.03);
        c.tree.youngs[i] = 1e18, c.tree.shear[i] = 4e17;
    }
    memcpy(c.options.root_stiffness, soft, sizeof soft);
    double P = soft[1] * 0.7 / (length * cos(0.7));
    beam_push(&c, 1, WF_POINT_DEAD, P, 0, 0);
    c.loads.gravity = 0;
    beam_solve(&c);
    assert_close(c.out.turn[4], 0.7, 1e-8);
    assert_true(c.out.turn[1] == 0 && c.out.end[0] == 0);
    assert_close(c.out.base_moment[1], soft[1] * 0.7, 1e-8);
    c.point[0].force[2] = 7;
    c.point[0].force[0] = 0;
    beam_solve(&c);
    assert_close(c.out.base_moment[1], -35, 1e-9);
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tilts), cmocka_unit_test(tilts_a_little), cmocka_unit_test(one_axis),
        cmocka_unit_test(falls), cmocka_unit_test(sways),          cmocka_unit_test(two_roots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
