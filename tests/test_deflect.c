/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The frame-by-frame method: the printed formula to the digit, the corrected one against chain and beam, and
 * how leaves ride. */
#include "base/vec3.h"
#include "beam_cases.h"
#include "solve/chain.h"
#include "solve/deflect.h"
#include "study/series.h"

static const double R = 0.02, L = 2, E = 9e9;

static void one(struct beam_case *c, double speed)
{
    beam_stem(c, 1, upright, L, R, R);
    c->loads.gravity = 9.81;
    beam_blow(c, speed, 0, 0);
}

static void open(struct beam_case *c, const struct wf_deflect_scheme *s, struct wf_deflect *d)
{
    assert_int_equal(wf_deflect_open(&c->tree, &c->loads, s, &c->arena, d, &c->err), WF_OK);
}

/* Eqs 1, 3, 4: an upright row, drag at right angles to it. */
static void printed_formula(void **state)
{
    (void)state;
    struct beam_case c;
    one(&c, 10);
    assert_int_equal(beam_try(&c, &wf_solver_deflect_as_printed), WF_OK);
    double force = 0.5 * 1.225 * 2 * R * L * 100, delta = 4 * force * pow(L, 3) / (3 * PI * E * pow(R, 3));
    assert_close(c.out.end[0], delta, 1e-12);
    assert_close(c.out.end[2], L * sqrt(1 - delta * delta / (L * L)) - L, 1e-6);
    assert_close(c.out.turn[1], asin(delta / L), 1e-12);
    assert_close(c.out.tangent1[0], delta / L, 1e-12);
    beam_free(&c);
}

/* The printed cube is R (in metres) times too small against the same force at the tip with R^4. */
static void cube_for_fourth_power(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 1, upright, L, R, R);
    beam_blow(&c, 4, 0, 0);
    double force = 0.5 * 1.225 * 2 * R * L * 16;
    assert_int_equal(beam_try(&c, &wf_solver_deflect_as_printed), WF_OK);
    double printed = c.out.end[0];
    c.loads.wind = NULL;
    beam_push(&c, 0, WF_POINT_DEAD, force, 0, 0);
    assert_int_equal(beam_try(&c, &wf_solver_deflect), WF_OK);
    assert_close(printed / c.out.end[0], R, 1e-12);
    beam_free(&c);
}

/* A lean of 30 degrees: only the part across bends; lift pushes across wind and axis. */
static void only_the_part_across(void **state)
{
    (void)state;
    const double lean[3] = { 0.5, 0, 0.86602540378443864676 };
    struct beam_case c;
    struct wf_deflect d;
    beam_stem(&c, 1, lean, L, R, R);
    beam_blow(&c, 10, 0, 0);
    open(&c, &(struct wf_deflect_scheme){ .printed = true }, &d);
    wf_deflect_frame(&d, 1, 0);
    double across = 10 * lean[2], force = 0.5 * 1.225 * 2 * R * L * across * across;
    assert_close(d.worst_ratio, 4 * force * L * L / (3 * PI * E * pow(R, 3)), 1e-12);
    c.tree.drag[0] = 0, c.tree.lift[0] = 1;
    assert_int_equal(beam_try(&c, &wf_solver_deflect_as_printed), WF_OK);
    assert_true(fabs(c.out.end[0]) < 1e-6 && c.out.end[1] > 1e-5);
    beam_free(&c);
}

static void restoring_settles(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_deflect d;
    one(&c, 10);
    struct wf_deflect_scheme s = { .printed = true };
    open(&c, &s, &d);
    wf_deflect_frame(&d, 1, 0);
    double free_sine = d.worst_ratio, last = 0;
    s.restoring = 0.5;
    open(&c, &s, &d);
    for (int k = 0; k < 60; k++) {
        wf_deflect_frame(&d, 1, 0.1);
        if (k == 1) assert_close(d.worst_ratio, 0.5 * free_sine, 1e-4);
        last = d.worst_ratio;
    }
    assert_close(last, free_sine / 1.5, 1e-3); /* drag follows the lean, which is small */
    beam_free(&c);
}

static void refuses_k(void **state)
{
    (void)state;
    const double bad[] = { 1, 1.5, -0.1, NAN };
    struct beam_case c;
    struct wf_deflect d;
    one(&c, 10);
    for (int i = 0; i < 4; i++) {
        struct wf_deflect_scheme s = { .printed = true, .restoring = bad[i] };
        c.err = (struct wf_err){ 0 };
        assert_int_equal(wf_deflect_open(&c.tree, &c.loads, &s, &c.arena, &d, &c.err), WF_EUSAGE);
        assert_non_null(strstr(c.err.text, "oscillates or diverges"));
    }
    struct wf_deflect_scheme s = { .damping = -1 };
    c.err = (struct wf_err){ 0 };
    assert_int_equal(wf_deflect_open(&c.tree, &c.loads, &s, &c.arena, &d, &c.err), WF_EUSAGE);
    beam_free(&c);
}

static void clamps_with_a_warning(void **state)
{
    (void)state;
    struct beam_case c;
    one(&c, 10);
    c.tree.youngs[0] = 1e3;
    assert_int_equal(beam_try(&c, &wf_solver_deflect_as_printed), WF_OK);
    assert_close(c.out.end[0], L, 1e-12);
    assert_close(c.out.end[2], -L, 1e-12);
    assert_true(c.diag.warnings == 1 && !strcmp(c.diag.first->code, "asin-clamped"));
    beam_free(&c);
}

/* Frames compose: the child rides on its parent; no row changes its length. */
static void frames_compose(void **state)
{
    (void)state;
    for (int printed = 0; printed < 2; printed++) {
        struct beam_case c;
        struct wf_deflect d;
        beam_tree7(&c);
        c.loads.gravity = 9.81;
        beam_blow(&c, 20, 5, 0);
        for (size_t i = 0; i < 7; i++) c.tree.youngs[i] *= printed ? 0.05 : 1;
        open(&c, &(struct wf_deflect_scheme){ .printed = printed }, &d);
        wf_deflect_frame(&d, 1, 0);
        for (size_t i = 0; i < 7; i++) {
            double base[3] = { 0, 0, 0 }, length = 0;
            for (int k = 0; k < 3; k++) {
                if (i) base[k] = d.end[c.tree.parent[i]][k];
                length += pow(d.end[i][k] - base[k], 2);
            }
            assert_close(sqrt(length), wf_tree_length(&c.tree, i), 1e-12);
            const double *T = d.turn[i];
            for (int r = 0; r < 3; r++)
                for (int k = 0; k < 3; k++) {
                    double sum =
                        T[3 * r] * T[3 * k] + T[3 * r + 1] * T[3 * k + 1] + T[3 * r + 2] * T[3 * k + 2];
                    assert_true(fabs(sum - (r == k)) < 1e-12);
                }
        }
        beam_free(&c);
    }
}

/* In a light wind the corrected form is the chain of cantilevers, row for row. */
static void corrected_is_the_chain(void **state)
{
    (void)state;
    struct beam_case c;
    beam_tree7(&c);
    for (size_t i = 0; i < 7; i++) c.tree.r1[i] = c.tree.r0[i]; /* both take the same section */
    c.loads.gravity = 1e-4;
    beam_push(&c, 3, WF_POINT_DEAD, 1e-4, 2e-4, -1e-4)->moment[2] = 1e-4;
    beam_blow(&c, 0.01, 0.02, 0);
    assert_int_equal(beam_try(&c, &wf_solver_chain), WF_OK);
    struct wf_response chain = c.out;
    assert_int_equal(beam_try(&c, &wf_solver_deflect), WF_OK);
    for (size_t i = 0; i < 21; i++) {
        assert_true(fabs(c.out.end[i] - chain.end[i]) < 1e-5 * fabs(chain.end[9]));
        assert_true(fabs(c.out.turn[i] - chain.turn[i]) < 1e-5 * fabs(chain.turn[13]) + 1e-9);
    }
    beam_free(&c);
}

/* Refined, the corrected form goes to beam theory (order 2), the printed one to nothing. */
static void refinement(void **state)
{
    (void)state;
    double corrected[3], printed[3], beam;
    for (int k = 0; k < 3; k++) {
        struct beam_case c;
        beam_stem(&c, (size_t)8 << k, upright, 4, 0.04, 0.01);
        beam_blow(&c, 1, 0, 0);
        size_t tip = 3 * (c.tree.n - 1);
        beam_solve(&c);
        beam = c.out.end[tip];
        assert_int_equal(beam_try(&c, &wf_solver_deflect), WF_OK);
        corrected[k] = fabs(c.out.end[tip] / beam - 1);
        assert_int_equal(beam_try(&c, &wf_solver_deflect_as_printed), WF_OK);
        printed[k] = c.out.end[tip] / beam;
        beam_free(&c);
    }
    assert_true(corrected[0] < 0.05 && corrected[1] < 0.3 * corrected[0] &&
                corrected[2] < 0.3 * corrected[1]);
    assert_true(printed[1] < 0.6 * printed[0] && printed[2] < 0.6 * printed[1]);
}

/* As printed the damping force lies along the axis: it bends nothing. Corrected it holds the motion back. */
static void damping(void **state)
{
    (void)state;
    double moved[2][2];
    for (int printed = 0; printed < 2; printed++)
        for (int damped = 0; damped < 2; damped++) {
            struct beam_case c;
            struct wf_deflect d;
            one(&c, 10);
            open(&c, &(struct wf_deflect_scheme){ .printed = printed, .damping = damped ? 500 : 0 }, &d);
            for (int k = 1; k <= 3; k++) wf_deflect_frame(&d, 0.3 * k, 0.1);
            moved[printed][damped] = d.end[0][0];
            beam_free(&c);
        }
    assert_close(moved[1][1], moved[1][0], 1e-12);
    assert_true(moved[0][1] < 0.999 * moved[0][0] && moved[0][1] > 0);
}

/* Eq 13: turns in proportion to the wind, the leaf stays a unit vector and hangs where it hung. */
static void leaves(void **state)
{
    (void)state;
    double angle[2];
    for (int k = 0; k < 2; k++) {
        struct wf_leaf_pose p = { .tip = { 0.6, 0, -0.8 }, .side = { 0, 1, 0 } };
        double before = acos(-p.tip[2]);
        wf_leaf_swing(0.02 * 5 * (k + 1), 0, &p);
        angle[k] = acos(-p.tip[2]) - before;
        assert_close(wf_dot(p.tip, p.tip), 1, 1e-12);
        wf_leaf_swing(0, 0.3, &p);
        assert_close(atan2(p.tip[1], p.tip[0]), 0.3, 1e-12);
    }
    assert_close(angle[0], 0.1, 1e-9);
    assert_close(angle[1], 2 * angle[0], 1e-9);
    const double turn[1][9] = { { 0, -1, 0, 1, 0, 0, 0, 0, 1 } }, end[1][3] = { { 1, 2, 3 } };
    const double still[3] = { 0, 0, 0 };
    double M[9];
    struct wf_leaf_stand s = {
        .along = 0.5, .axis = { 1, 0, 0 }, .direction = { 1, 0, 0 }, .side = { 0, 0, 1 }
    };
    struct wf_leaf_pose p;
    wf_leaf_matrix(still, M);
    wf_leaf_place(&s, turn, end, M, &p);
    assert_close(p.at[0], 1, 1e-15);
    assert_close(p.at[1], 1.5, 1e-15);
    assert_close(p.tip[1], 1, 1e-15);
    assert_close(p.side[2], 1, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(printed_formula),
        cmocka_unit_test(cube_for_fourth_power),
        cmocka_unit_test(only_the_part_across),
        cmocka_unit_test(restoring_settles),
        cmocka_unit_test(refuses_k),
        cmocka_unit_test(clamps_with_a_warning),
        cmocka_unit_test(frames_compose),
        cmocka_unit_test(corrected_is_the_chain),
        cmocka_unit_test(refinement),
        cmocka_unit_test(damping),
        cmocka_unit_test(leaves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
