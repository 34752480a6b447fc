/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rod solver against the beam engine without stretch, statics at forks and tips, and the printed form. */
#include "beam_cases.h"
#include "solve/rod.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"

static double apart(const double *a, const double *b, size_t n)
{
    double sum = 0, size = 0;
    for (size_t i = 0; i < n; i++) sum += (a[i] - b[i]) * (a[i] - b[i]), size += b[i] * b[i];
    return sqrt(sum) / sqrt(size);
}

static void rod_solve(struct beam_case *c)
{
    if (beam_try(c, &wf_solver_rod)) fail_msg("%s", c->err.text);
    if (!(c->out.imbalance < 1e-8)) fail_msg("imbalance %g", c->out.imbalance);
}

/* Places, turns, section forces and reactions of both solvers agree to `share`. */
static void agree(struct beam_case *c, double share)
{
    c->options.inextensible = true;
    c->options.mesh_tolerance = 1e-8;
    beam_solve(c);
    struct wf_response beam = c->out;
    rod_solve(c);
    size_t n = 3 * c->tree.n;
    assert_true(apart(c->out.end, beam.end, n) < share);
    assert_true(apart(c->out.turn, beam.turn, n) < share);
    assert_true(apart(c->out.force0, beam.force0, n) < share);
    assert_true(apart(c->out.moment0, beam.moment0, n) < share);
    assert_true(apart(c->out.tangent1, beam.tangent1, n) < share);
    assert_true(apart(c->out.base_force, beam.base_force, 3) < share);
    assert_true(apart(c->out.base_moment, beam.base_moment, 3) < share);
    assert_close(c->out.load_factor, 1, 0);
}

static void elastica(void **state)
{
    (void)state;
    for (int load = 0; load < 3; load++) {
        struct beam_case c;
        beam_unit(&c, 1, 0);
        beam_push(&c, 0, load == 1 ? WF_POINT_FOLLOWER : WF_POINT_DEAD, load == 2 ? 20 : 8, 0, 0);
        agree(&c, 1e-6);
        beam_free(&c);
    }
}

/* Half a turn under a pure end moment: a circle (closed form). */
static void rolls_into_a_circle(void **state)
{
    (void)state;
    struct beam_case c;
    beam_unit(&c, 1, 0);
    c.loads.points = 1;
    c.point[0] = (struct wf_point_load){ .segment = 0, .moment = { 0, PI, 0 } };
    rod_solve(&c);
    assert_close(c.out.end[0], 2 / PI, 1e-9);
    assert_close(c.out.end[1], 0, 1e-12);
    assert_close(c.out.end[2], -1, 1e-9);
    beam_free(&c);
}

/* Bent arc of 45 degrees, force out of its plane: bending about two axes and torsion. */
static void bend45(void **state)
{
    (void)state;
    const size_t n = 8;
    struct beam_case c;
    beam_new(&c, n);
    c.tree.stiff = WF_TAKE(&c.arena, 4 * n, double);
    c.tree.bend = WF_TAKE(&c.arena, 3 * n, double);
    for (size_t i = 0; i < n; i++) {
        double a[2][3];
        for (size_t k = 0; k < 2; k++) {
            double s = (double)(i + k) / (double)n * PI / 4;
            a[k][0] = 100 * (1 - cos(s)), a[k][1] = 100 * sin(s), a[k][2] = 0;
        }
        beam_row(&c, i, (int32_t)i - 1, a[0], a[1], 0.1, 0.1);
        c.tree.bend[3 * i + 2] = -0.01;
        c.tree.stiff[4 * i] = 1e7, c.tree.stiff[4 * i + 1] = 5e6;
        c.tree.stiff[4 * i + 2] = c.tree.stiff[4 * i + 3] = 1e7 / 12;
    }
    beam_push(&c, n - 1, WF_POINT_DEAD, 0, 0, 600);
    agree(&c, 1e-6);
    assert_true(fabs(c.out.end[3 * n - 1] - 53.4748587918252) < 0.01); /* stretch and shear are small here */
    beam_free(&c);
}

static void trees(void **state)
{
    (void)state;
    static const double wind[3][3] = { { 35, 0, 0 }, { 20, -25, 0 }, { 0, 0, 30 } };
    for (int k = 0; k < 6; k++) {
        struct beam_case c;
        k % 2 ? beam_tree7(&c) : beam_tree3(&c);
        for (size_t i = 0; i < c.tree.n; i++) c.tree.youngs[i] = 1.5e9, c.tree.shear[i] = 1.5e9 / 2.6;
        c.loads.gravity = 9.81;
        beam_blow(&c, wind[k / 2][0], wind[k / 2][1], wind[k / 2][2]);
        agree(&c, 1e-6);
        beam_free(&c);
    }
}

/* Any tree, with point masses, lift, leaves and dead loads. */
static void wild_trees(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed < 6; seed++) {
        struct beam_case c;
        beam_wild(&c, 30, seed);
        beam_masses(&c);
        for (size_t i = 0; i < c.tree.n; i++) {
            c.tree.lift[i] = 0.2, c.tree.sail0[i] = 0.02, c.tree.sail1[i] = 0.05;
            c.tree.mass1[i] = 0.05;
        }
        c.loads.gravity = 9.81;
        c.wind.sample = wf_profile_named("log")->sample;
        beam_line(&c, 0, 0.3, -0.2);
        beam_blow(&c, 12, 5, 0);
        agree(&c, 1e-6);
        beam_free(&c);
    }
}

/* Hanging twig 1 m long and 1 mm thin, 0.3 GPa: tension rules, errors of a guess would grow by e^11. */
static void hanging(void **state)
{
    (void)state;
    const double down[3] = { 0, 0, -1 };
    struct beam_case c;
    beam_stem(&c, 10, down, 1, 1e-3, 1e-3);
    for (size_t i = 0; i < 10; i++) c.tree.youngs[i] = 3e8, c.tree.shear[i] = 1e8, c.tree.density[i] = 900;
    c.loads.gravity = 9.81;
    beam_blow(&c, 3.5, 0, 0);
    agree(&c, 1e-6);
    double x = c.out.end[27], z = c.out.end[29] - 1; /* clamped vertically, so less than the free angle */
    double weight = 900 * PI * 1e-6 * 9.81, drag = 0.5 * 1.225 * 2e-3 * 3.5 * 3.5;
    /* far from the clamp the drag across the twig balances its weight across: sin a = (drag/weight) cos2 a */
    double a = 0;
    for (int k = 0; k < 60; k++) a = asin(drag / weight * cos(a) * cos(a)) * 0.5 + a * 0.5;
    assert_true(atan2(x, -z) < a && atan2(x, -z) > 0.8 * a);
    beam_free(&c);
}

/* A column half as heavy again as stands by itself leans in the wind and hangs over: the beam engine's
 * answer. */
static void falls_over(void **state)
{
    (void)state;
    struct beam_case c;
    beam_unit(&c, 8, 1);
    c.loads.gravity = 12;
    beam_line(&c, 0.25, 0, 0);
    agree(&c, 1e-6);
    assert_true(c.out.end[3 * 7 + 2] < -0.5 && c.out.end[3 * 7] > 0);
    beam_free(&c);
}

/* Upright in still air: weight alone, no bending; and without any load at all. */
static void at_rest(void **state)
{
    (void)state;
    for (int heavy = 0; heavy < 2; heavy++) {
        struct beam_case c;
        beam_stem(&c, 40, upright, 14, 0.05, 0.01);
        c.loads.gravity = heavy ? 9.81 : 0;
        rod_solve(&c);
        assert_true(fabs(c.out.end[3 * 39]) < 1e-12 && fabs(c.out.end[3 * 39 + 2]) < 1e-12);
        assert_int_equal(beam_try(&c, &wf_solver_rod_as_printed), WF_OK);
        beam_free(&c);
    }
}

static void root_plate(void **state)
{
    (void)state;
    struct beam_case c;
    beam_tree7(&c);
    c.loads.gravity = 9.81;
    beam_blow(&c, 20, 25, 0);
    c.options.root_stiffness[0] = 4e3, c.options.root_stiffness[1] = 2e3;
    agree(&c, 1e-6);
    beam_free(&c);
}

/* Eqs 4 and 5: what a branch bears at a fork is the sum of what its continuation and its child put on it;
 * the tips are free. */
static void forks_and_tips(void **state)
{
    (void)state;
    struct beam_case c;
    beam_tree7(&c);
    c.loads.gravity = 9.81;
    beam_blow(&c, 30, 10, 0);
    rod_solve(&c);
    const double *f0 = c.out.force0, *m0 = c.out.moment0, *f1 = c.out.force1, *m1 = c.out.moment1;
    for (size_t k = 0; k < 3; k++) {
        for (size_t i = 0; i < 3; i++) {
            double force = f0[3 * (2 * i + 1) + k] + f0[3 * (2 * i + 2) + k];
            double moment = m0[3 * (2 * i + 1) + k] + m0[3 * (2 * i + 2) + k];
            assert_true(fabs(f1[3 * i + k] - force) < 1e-6 * 100);
            assert_true(fabs(m1[3 * i + k] - moment) < 1e-6 * 100);
        }
        for (size_t i = 3; i < 7; i++) assert_true(fabs(f1[3 * i + k]) < 1e-7 && fabs(m1[3 * i + k]) < 1e-7);
    }
    beam_free(&c);
}

/* The printed angles: the error halves or better when segments are halved, on a stem that bends in two planes
 * and twists. */
static void printed_converges(void **state)
{
    (void)state;
    double off[3];
    for (int k = 0; k < 3; k++) {
        size_t n = (size_t)5 << k;
        struct beam_case c;
        beam_stem(&c, n, upright, 1, 1e-3, 1e-3);
        c.tree.stiff = WF_TAKE(&c.arena, 4 * n, double);
        for (size_t i = 0; i < 4 * n; i++) c.tree.stiff[i] = 1;
        beam_push(&c, n - 1, WF_POINT_DEAD, 3, 0, 0)->moment[2] = 0.5;
        beam_push(&c, n / 5 * 2, WF_POINT_DEAD, 0, 4, 0);
        c.options.inextensible = true;
        rod_solve(&c);
        struct wf_response exact = c.out;
        assert_int_equal(beam_try(&c, &wf_solver_rod_as_printed), WF_OK);
        off[k] = apart(c.out.end + 3 * n - 3, exact.end + 3 * n - 3, 3);
        beam_free(&c);
    }
    assert_true(off[0] > 1e-6 && off[0] < 0.05);
    assert_true(off[1] < 0.55 * off[0] && off[2] < 0.55 * off[1]);
}

/* The axes the printed angles turn about must not jump while a branch moves. Axes chosen on the loaded branch
 * did, where two of its components are equal: branches of a tree that is symmetric about the wind's bearing
 * of 45 degrees. */
static void printed_any_bearing(void **state)
{
    (void)state;
    struct beam_case c;
    const double foot[3] = { 0 }, fork[3] = { 0, 0, 4 };
    beam_new(&c, 9);
    beam_row(&c, 0, -1, foot, fork, 0.08, 0.05);
    for (int k = 0; k < 8; k++) {
        double a = (k / 2) * PI / 2 + PI / 4, lean = k % 2 ? 1 : 0.3, from[3], to[3];
        memcpy(from, fork, sizeof from);
        if (k % 2) from[0] = c.tree.x1[k], from[1] = c.tree.y1[k], from[2] = c.tree.z1[k];
        to[0] = from[0] + lean * cos(a), to[1] = from[1] + lean * sin(a), to[2] = from[2] + 1;
        beam_row(&c, (size_t)k + 1, k % 2 ? k : 0, from, to, 0.012, 0.006);
    }
    c.loads.gravity = 9.81;
    c.options.inextensible = true;
    for (int k = 0; k < 12; k++) {
        beam_blow(&c, 8 * cos(PI / 4 + 1e-4 * k), 8 * sin(PI / 4 + 1e-4 * k), 0);
        rod_solve(&c);
        struct wf_response exact = c.out;
        if (beam_try(&c, &wf_solver_rod_as_printed)) fail_msg("bearing %d: %s", k, c.err.text);
        assert_true(apart(c.out.end, exact.end, 27) < 0.3);
    }
    beam_free(&c);
}

/* Three angles are not defined where a segment has turned by 90 degrees. */
static void printed_refuses(void **state)
{
    (void)state;
    struct beam_case c;
    const double along[3] = { 1, 0, 0 };
    beam_stem(&c, 1, along, 1, 1e-3, 1e-3);
    c.tree.stiff = WF_TAKE(&c.arena, 4, double);
    for (size_t i = 0; i < 4; i++) c.tree.stiff[i] = 1;
    c.loads.points = 1;
    c.point[0] = (struct wf_point_load){ .segment = 0, .moment = { 0, 0, 3 } };
    assert_int_equal(beam_try(&c, &wf_solver_rod_as_printed), WF_ENOCONV);
    assert_non_null(strstr(c.err.text, "90 degrees"));
    rod_solve(&c);
    beam_free(&c);
}

/* Shelter of the trees' own: ratios of neighbouring cells jump, the field's curvature with them. The answer
 * is the beam engine's, on the branch no other bends. */
static void sheltered_wind(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_shelter s;
    struct wf_shelter_request q;
    struct wf_wind field;
    beam_tree7(&c);
    c.loads.gravity = 9.81;
    for (size_t i = 0; i < c.tree.n; i++) c.tree.sail0[i] = c.tree.sail1[i] = 0.1;
    beam_blow(&c, 25, 0, 0);
    wf_shelter_request_default(&q);
    q.law = wf_shelter_law_named("feng1999");
    q.slabs = 24, q.cells = 96;
    if (wf_shelter_make(&c.tree, &c.wind, &q, &c.arena, &s, &c.err)) fail_msg("%s", c.err.text);
    wf_shelter_field(&s, &field);
    c.loads.wind = &field;
    assert_non_null(field.clear);
    c.options.inextensible = true;
    c.options.mesh_tolerance = 1e-7;
    beam_solve(&c);
    struct wf_response beam = c.out;
    rod_solve(&c);
    size_t n = 3 * c.tree.n;
    assert_true(apart(c.out.end, beam.end, n) < 1e-4); /* the beam's mesh does not know the faces */
    assert_true(apart(c.out.base_moment, beam.base_moment, 3) < 1e-4);
    beam_free(&c);
}

/* A wind that grows with height: the beam in which the rod begins has its pieces. */
static void sheared_wind(void **state)
{
    (void)state;
    for (size_t rows = 1; rows <= 3; rows += 2)
        for (double speed = 5; speed < 100; speed *= 2.5) {
            struct beam_case c;
            beam_stem(&c, rows, upright, 14, 0.03, 0.006);
            beam_blow(&c, speed, 0, 0);
            c.wind.sample = wf_profile_named("power")->sample;
            c.wind.reference_height = 10, c.wind.exponent = 0.2;
            c.loads.gravity = 9.81;
            for (size_t i = 0; i < rows; i++) c.tree.sail0[i] = c.tree.sail1[i] = 0.1;
            agree(&c, 1e-5);
            beam_free(&c);
        }
}

/* A twig too long to stand by itself on a tree that does: both solvers answer and warn; as heavy as the tree
 * it is not let through as it stands. */
static void loose_twig(void **state)
{
    (void)state;
    for (int heavy = 0; heavy < 2; heavy++) {
        struct beam_case c;
        beam_new(&c, 2);
        const double a[3] = { 0, 0, 0 }, b[3] = { 0, 0, 2 }, tip[3] = { 0, 0, 4.5 };
        beam_row(&c, 0, -1, a, b, 0.05, 0.05);
        beam_row(&c, 1, 0, b, tip, heavy ? 0.01 : 0.002, heavy ? 0.01 : 0.002);
        c.tree.youngs[1] = 1e9, c.tree.shear[1] = 4e8;
        c.tree.burden0[1] = c.tree.burden1[1] = heavy ? 5 : 0;
        c.loads.gravity = 9.81;
        const struct wf_solver *solver[] = { &wf_solver_beam, &wf_solver_rod };
        for (int k = 0; k < 2; k++) {
            bool loose = false, limit = false;
            c.diag = (struct wf_diag){ .arena = &c.arena };
            if (beam_try(&c, solver[k])) fail_msg("%s: %s", solver[k]->name, c.err.text);
            for (const struct wf_finding *f = c.diag.first; f; f = f->next)
                loose = loose || !strcmp(f->code, "loose-parts"),
                limit = limit || !strcmp(f->code, "limit-point");
            assert_true(loose == !heavy && limit == heavy);
        }
        beam_free(&c);
    }
}

static void refuses_bad_input(void **state)
{
    (void)state;
    struct beam_case c;
    beam_unit(&c, 2, 0);
    beam_push(&c, 5, WF_POINT_DEAD, 1, 0, 0);
    assert_int_equal(beam_try(&c, &wf_solver_rod), WF_EUSAGE);
    c.loads.points = 0;
    c.tree.r0[1] = -1;
    assert_int_not_equal(beam_try(&c, &wf_solver_rod), WF_OK);
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elastica),
        cmocka_unit_test(rolls_into_a_circle),
        cmocka_unit_test(bend45),
        cmocka_unit_test(trees),
        cmocka_unit_test(wild_trees),
        cmocka_unit_test(hanging),
        cmocka_unit_test(falls_over),
        cmocka_unit_test(root_plate),
        cmocka_unit_test(at_rest),
        cmocka_unit_test(forks_and_tips),
        cmocka_unit_test(printed_converges),
        cmocka_unit_test(printed_any_bearing),
        cmocka_unit_test(printed_refuses),
        cmocka_unit_test(sheltered_wind),
        cmocka_unit_test(sheared_wind),
        cmocka_unit_test(loose_twig),
        cmocka_unit_test(refuses_bad_input),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
