/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sections that are not round: two bending stiffnesses that turn with the section, torsion, weight to one
 * side. */
#include "base/vec3.h"
#include "beam_cases.h"
#include "data/section.h"
#include "solve/modes.h"
#include "solve/solve.h"

/* All rows of one shape; the height is measured along `up` made square to the row. */
static void section(struct beam_case *c, enum wf_section_shape shape, double width, double height,
                    const double up[3])
{
    struct wf_tree *t = &c->tree;
    struct wf_section of;
    wf_section_of(shape, width, height, &of);
    assert_int_equal(wf_tree_alloc_sections(t, &c->arena, &c->err), WF_OK);
    struct wf_tree_sections *s = t->section;
    for (size_t i = 0; i < t->n; i++) {
        double d[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] }, u[3], size;
        for (int k = 0; k < 3; k++) u[k] = up[k] - wf_dot(up, d) / wf_dot(d, d) * d[k];
        size = sqrt(wf_dot(u, u));
        for (size_t k = 0; k < 3; k++) s->up[3 * i + k] = u[k] / size;
        s->width0[i] = s->width1[i] = width, s->height0[i] = s->height1[i] = height;
        s->mix0[3 * i + shape] = s->mix1[3 * i + shape] = 1;
        t->r0[i] = t->r1[i] = sqrt(of.area / PI);
    }
}

static const double along_x[3] = { 1, 0, 0 };

static void constants(void **state)
{
    (void)state;
    struct wf_section s;
    wf_section_of(WF_SECTION_ELLIPSE, 0.2, 0.2, &s); /* a circle */
    assert_close(s.area, PI * 0.01, 1e-14);
    assert_close(s.upright, PI * 1e-4 / 4, 1e-14);
    assert_close(s.lying, s.upright, 1e-14);
    assert_close(s.torsion, PI * 1e-4 / 2, 1e-14);
    wf_section_of(WF_SECTION_RECTANGLE, 1, 1, &s); /* Timoshenko & Goodier 1970, table in art. 109 */
    assert_close(s.torsion, 0.1406, 1e-4 / 0.1406);
    wf_section_of(WF_SECTION_RECTANGLE, 1, 2, &s);
    assert_close(s.torsion, 2 * 0.229, 1e-3 / 0.229);
    assert_close(s.upright, 8. / 12, 1e-14);
    assert_close(s.lying, 2. / 12, 1e-14);
    wf_section_of(WF_SECTION_RECTANGLE, 1000, 1, &s);
    assert_close(s.torsion, 1000. / 3 * (1 - 0.63e-3), 1e-6);
    wf_section_of(WF_SECTION_TRIANGLE, 1, sqrt(3) / 2, &s); /* equal sides: exact */
    assert_close(s.torsion, sqrt(3) / 80, 1e-14);
    assert_close(s.upright, sqrt(3) / 96, 1e-14);
    assert_close(s.lying, sqrt(3) / 96, 1e-14);
    wf_section_of(WF_SECTION_TRIANGLE, sqrt(2), sqrt(0.5), &s); /* right angle: 0.0261 (Roark), from below */
    assert_true(s.torsion < 0.0261 && s.torsion > 0.0261 * 0.955);
}

/* Equal stiffnesses about both axes are the round section, in everything else too. */
static void round_again(void **state)
{
    (void)state;
    struct beam_case plain, flat;
    beam_wild(&plain, 30, 7), beam_wild(&flat, 30, 7);
    for (int k = 0; k < 2; k++) {
        struct beam_case *c = k ? &flat : &plain;
        for (size_t i = 0; i < c->tree.n; i++) c->tree.r0[i] = c->tree.r1[i] = 0.02;
        c->options.mesh_tolerance = 0, c->options.tolerance = 1e-12;
        c->loads.gravity = 9.81;
        c->wind.sample = wf_profile_named("log")->sample;
        beam_blow(c, 9, 3, 0);
        if (k) section(c, WF_SECTION_ELLIPSE, 0.04, 0.04, (double[]){ 0.3, 1, 0.2 });
        beam_solve(c);
    }
    for (size_t i = 0; i < 3 * plain.tree.n; i++) {
        if (!(fabs(plain.out.end[i] - flat.out.end[i]) < 1e-10)) fail_msg("end %zu differs", i);
        if (!(fabs(plain.out.turn[i] - flat.out.turn[i]) < 1e-10)) fail_msg("turn %zu differs", i);
    }
    beam_free(&plain), beam_free(&flat);
}

/* A load askew to both axes: each component bends about its own. The error falls with the load squared. */
static void askew(void **state)
{
    (void)state;
    const double push = 1e-2, w = 0.03, h = 0.05, turn = 0.4;
    struct beam_case c;
    beam_stem(&c, 4, along_x, 2, 0.02, 0.02);
    section(&c, WF_SECTION_RECTANGLE, w, h, (double[]){ 0, -sin(turn), cos(turn) });
    beam_push(&c, 3, WF_POINT_DEAD, 0, push, 0);
    beam_solve(&c);
    /* along height (0, -s, c) and width up x axis = (0, c, s) */
    double high = -sin(turn) * push * 8 / (3 * 9e9 * w * h * h * h / 12);
    double wide = cos(turn) * push * 8 / (3 * 9e9 * h * w * w * w / 12);
    assert_close(c.out.end[10], -sin(turn) * high + cos(turn) * wide, 1e-8);
    assert_close(c.out.end[11], cos(turn) * high + sin(turn) * wide, 1e-8);
    beam_free(&c);
}

/* Elastica under an end load P L^2 = EI: tip moves 0.301721 L across, 0.05643 L along (Mattiasson 1981, Int.
 * J. Numer. Methods Eng. 17:145), in either plane with that plane's EI. */
static void elastica(void **state)
{
    (void)state;
    const double w = 0.02, h = 0.03; /* a flatter one would tip over sideways */
    for (int plane = 0; plane < 2; plane++) {
        struct beam_case c;
        double ei = 9e9 * (plane ? w * h * h * h : h * w * w * w) / 12;
        beam_stem(&c, 8, along_x, 1, 0.02, 0.02);
        c.options.inextensible = true;
        section(&c, WF_SECTION_RECTANGLE, w, h, (double[]){ 0, 0, 1 });
        beam_push(&c, 7, WF_POINT_DEAD, 0, plane ? 0 : ei, plane ? ei : 0);
        beam_solve(&c);
        assert_close(c.out.end[21], -0.05643, 2e-4);
        assert_close(c.out.end[plane ? 23 : 22], 0.301720773799814, 1e-6);
        assert_true(fabs(c.out.end[plane ? 22 : 23]) < 1e-12);
        /* the round section of the same EI */
        struct beam_case r;
        beam_unit(&r, 8, 0);
        beam_push(&r, 7, WF_POINT_DEAD, 1, 0, 0);
        beam_solve(&r);
        assert_close(c.out.end[plane ? 23 : 22], r.out.end[21], 1e-7);
        assert_close(c.out.end[21], r.out.end[23], 1e-6);
        beam_free(&c), beam_free(&r);
    }
}

/* Negative pivots of a horizontal strip under an end load along its height, as a share of 4.0126 sqrt(EI
 * GJ)/L^2 (Prandtl 1899, Michell 1899; Timoshenko & Gere 1961, art. 6.3). */
static size_t unstable(double share)
{
    const double w = 1e-3, h = 0.1, length = 2;
    struct beam_case c;
    struct wf_section s;
    struct wf_beam b;
    struct wf_beam_stability count = { .margin = 0 };
    wf_section_of(WF_SECTION_RECTANGLE, w, h, &s);
    beam_stem(&c, 40, along_x, length, 0.02, 0.02);
    section(&c, WF_SECTION_RECTANGLE, w, h, (double[]){ 0, 0, 1 });
    c.options.mesh_tolerance = 0, c.options.inextensible = true;
    double load = share * 4.0126 * sqrt(9e9 * s.lying * 9e9 / 2.6 * s.torsion) / (length * length);
    beam_push(&c, 39, WF_POINT_DEAD, 0, 0, -load);
    assert_int_equal(wf_beam_init(&b, &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err),
                     WF_OK);
    assert_int_equal(wf_beam_newton(&b), WF_OK); /* along the plane, stable or not */
    assert_true(wf_beam_sweep_down(&b, true, &count));
    beam_free(&c);
    return count.negative;
}

static void tips_over(void **state)
{
    (void)state;
    assert_int_equal(unstable(0.999), 0);
    assert_int_equal(unstable(1.001), 1);
    assert_int_equal(unstable(2.4), 1);
}

/* The whole turned about the vertical gives the answer turned. */
static void turned(void **state)
{
    (void)state;
    const double angle = 0.7;
    struct beam_case c[2];
    for (int k = 0; k < 2; k++) {
        double a = k * angle, axis[3] = { 0.8 * cos(a), 0.8 * sin(a), 0.6 };
        beam_stem(&c[k], 10, axis, 3, 0.02, 0.02);
        section(&c[k], WF_SECTION_TRIANGLE, 0.03, 0.02, (double[]){ sin(a), -cos(a), 2 });
        for (size_t i = 0; i < 10; i++)
            c[k].tree.section->side0[i] = c[k].tree.section->side1[i] = 0.01, c[k].tree.burden0[i] = 0.4;
        c[k].loads.gravity = 9.81;
        beam_solve(&c[k]);
    }
    const double *p = c[0].out.end + 27, *q = c[1].out.end + 27;
    assert_true(fabs(p[1]) > 1e-3);
    assert_true(fabs(q[0] - (cos(angle) * p[0] - sin(angle) * p[1])) < 1e-9);
    assert_true(fabs(q[1] - (sin(angle) * p[0] + cos(angle) * p[1])) < 1e-9);
    assert_true(fabs(q[2] - p[2]) < 1e-9);
    beam_free(&c[0]), beam_free(&c[1]);
}

/* A level bar with its weight S per length to the left twists by GJ q'' = -S g cos q, whatever else: with the
 * first integral, length = int dq / sqrt(2 S g / GJ (sin q1 - sin q)) from 0 to the end's q1. */
static void hangs_to_one_side(void **state)
{
    (void)state;
    const double q1 = 1.2, w = 0.02, h = 0.03, g = 9.81, moment = 3;
    struct beam_case c;
    struct wf_section s;
    wf_section_of(WF_SECTION_RECTANGLE, w, h, &s);
    double gj = 9e9 / 2.6 * s.torsion, length = 0;
    const int n = 2000; /* q = q1 - x^2 takes the root out; Simpson */
    for (int k = 0; k <= n; k++) {
        double x = sqrt(q1) * k / n, q = q1 - x * x;
        double y = k ? 2 * x / sqrt(sin(q1) - sin(q)) : 2 / sqrt(cos(q1));
        length += (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * y * sqrt(q1) / n / 3;
    }
    length *= sqrt(gj / (2 * moment * g));
    beam_stem(&c, 10, along_x, length, 0.02, 0.02);
    section(&c, WF_SECTION_RECTANGLE, w, h, (double[]){ 0, 0, 1 });
    for (size_t i = 0; i < 10; i++) {
        c.tree.density[i] = 0;
        c.tree.section->side0[i] = c.tree.section->side1[i] = moment;
    }
    c.loads.gravity = g;
    beam_solve(&c);
    assert_close(c.out.turn[27], -q1, 1e-6); /* the left sinks */
    assert_true(fabs(c.out.end[28]) < 1e-9 && fabs(c.out.end[29]) < 1e-9);
    assert_close(-c.out.base_moment[0], gj * sqrt(2 * moment * g / gj * sin(q1)), 1e-6);
    beam_free(&c);
}

/* Bent and twisted far: the error of the end falls with h^4. */
static void order(void **state)
{
    (void)state;
    double end[4][3], error[3];
    for (int k = 0; k < 4; k++) {
        struct beam_case c;
        size_t n = k < 3 ? (size_t)4 << k : 128;
        beam_stem(&c, n, (double[]){ 0.6, 0, 0.8 }, 3, 0.02, 0.02);
        section(&c, WF_SECTION_RECTANGLE, 0.04, 0.012, (double[]){ 0, 1, 1 });
        for (size_t i = 0; i < n; i++)
            c.tree.burden0[i] = c.tree.burden1[i] = 1,
            c.tree.section->side0[i] = c.tree.section->side1[i] = 0.05;
        c.options.mesh_tolerance = 0, c.options.tolerance = 1e-13;
        c.loads.gravity = 9.81;
        beam_solve(&c);
        memcpy(end[k], c.out.end + 3 * (n - 1), sizeof end[k]);
        beam_free(&c);
    }
    for (int k = 0; k < 3; k++) {
        double d[3] = { end[k][0] - end[3][0], end[k][1] - end[3][1], end[k][2] - end[3][2] };
        error[k] = sqrt(wf_dot(d, d));
    }
    assert_true(sqrt(wf_dot(end[3], end[3])) > 1);
    if (!(error[0] / error[1] > 12 && error[1] / error[2] > 12))
        fail_msg("errors %g %g %g", error[0], error[1], error[2]);
}

/* Clamped bar: 3.51602 sqrt(EI / (mass L^4)) in each plane. */
static void sways(void **state)
{
    (void)state;
    const double w = 0.02, h = 0.03, length = 2, root = 1.87510406871;
    double f[2];
    struct beam_case c;
    beam_stem(&c, 20, along_x, length, 0.02, 0.02);
    section(&c, WF_SECTION_RECTANGLE, w, h, (double[]){ 0, 0, 1 });
    assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 2, &c.arena, f, NULL, &c.err), WF_OK);
    double base = root * root / (2 * PI) / (length * length) * sqrt(9e9 / 800);
    assert_close(f[0], base * w / sqrt(12), 1e-5);
    assert_close(f[1], base * h / sqrt(12), 1e-5);
    beam_free(&c);
}

static void refused(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 4, along_x, 2, 0.02, 0.02);
    section(&c, WF_SECTION_RECTANGLE, 0.02, 0.03, (double[]){ 0, 0, 1 });
    for (size_t k = 0; wf_solvers[k]; k++)
        assert_int_equal(beam_try(&c, wf_solvers[k]), wf_solvers[k] == &wf_solver_beam ? WF_OK : WF_EINPUT);
    c.tree.section->up[3] = 1;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    assert_non_null(strstr(c.diag.first->text, "not measured across"));
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants),         cmocka_unit_test(round_again), cmocka_unit_test(askew),
        cmocka_unit_test(elastica),          cmocka_unit_test(tips_over),   cmocka_unit_test(turned),
        cmocka_unit_test(hangs_to_one_side), cmocka_unit_test(order),       cmocka_unit_test(sways),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
