/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Critical wind speeds by values and slopes against those by the steps of wf_critical_search, on random
 * trees: upwind and hanging branches, twigs that snap, streamlining by each law, the drag crisis. */
#include "beam_cases.h"
#include "data/species.h"
#include "load/drag.h"
#include "study/analysis.h"
#include "study/node.h"
#include <stdlib.h>

enum { TREES = 24, STEM = 8, BRANCHES = 14, PIECES = 3, ROWS = STEM + BRANCHES * PIECES };

static double between(uint64_t *seed, double low, double high)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

static void branch(struct beam_case *c, size_t k, uint64_t *seed)
{
    int32_t below = (int32_t)between(seed, 2, STEM);
    double azimuth = between(seed, 0, 2 * PI), rise = between(seed, -0.9, 1.4);
    double length = between(seed, 0.4, 3), radius = length * between(seed, 2.5e-3, 1.2e-2);
    double sag = between(seed, 0, 0.3), strength = between(seed, 25e6, 70e6), sail = between(seed, 0, 0.12);
    double from[3] = { c->tree.x1[below], c->tree.y1[below], c->tree.z1[below] };
    for (size_t j = 0; j < PIECES; j++) {
        double up = rise - sag * (double)j, to[3], h = length / PIECES;
        to[0] = from[0] + h * cos(up) * cos(azimuth), to[1] = from[1] + h * cos(up) * sin(azimuth);
        to[2] = from[2] + h * sin(up);
        size_t row = STEM + k * PIECES + j;
        beam_row(c, row, below, from, to, radius * (1 - 0.2 * (double)j), radius * (0.8 - 0.2 * (double)j));
        c->tree.level[row] = 1;
        c->tree.strength[row] = strength;
        c->tree.drag[row] = NAN;
        c->tree.sail0[row] = c->tree.sail1[row] = sail;
        c->tree.burden0[row] = c->tree.burden1[row] = between(seed, 0, 0.3);
        memcpy(from, to, sizeof to);
        below = (int32_t)row;
    }
}

static void random_tree(struct beam_case *c, uint64_t seed, double (*table)[4])
{
    beam_new(c, ROWS);
    c->loads.gravity = 9.81;
    double height = between(&seed, 4, 14), radius = height * between(&seed, 6e-3, 1.6e-2);
    double lean = between(&seed, -0.15, 0.15), strength = between(&seed, 25e6, 70e6);
    for (int i = 0; i < STEM; i++) {
        double z0 = height * i / STEM, z1 = height * (i + 1) / STEM;
        beam_row(c, (size_t)i, i - 1, (double[]){ lean * z0, 0, z0 }, (double[]){ lean * z1, 0, z1 },
                 radius * (1 - 0.09 * i), radius * (1 - 0.09 * (i + 1)));
        c->tree.strength[i] = strength;
        c->tree.drag[i] = NAN;
    }
    for (size_t k = 0; k < BRANCHES; k++) branch(c, k, &seed);
    beam_blow(c, 10, 0, 0);
    switch (seed >> 62) {
    case 0:
        break;
    case 1:
        c->loads.streamline =
            wf_streamline_named("table"); /* the sail falls faster than the wind's square rises */
        table[0][0] = between(&seed, 4, 12), table[0][1] = table[0][0] + between(&seed, 1, 6);
        table[0][2] = table[0][1] + between(&seed, 2, 12), table[0][3] = 60;
        table[1][0] = 1, table[1][1] = between(&seed, 0.3, 0.9), table[1][2] = between(&seed, 0.1, 0.5);
        table[1][3] = 0.1;
        c->loads.streamline_par = (struct wf_law_values){ .list = { table[0], table[1] }, .n = 4 };
        break;
    default:
        c->loads.streamline = wf_streamline_named("vogel");
        c->loads.streamline_par =
            (struct wf_law_values){ .number = { between(&seed, -1.1, -0.2), between(&seed, 3, 12) } };
    }
}

static void analysis_of(struct beam_case *c, const struct wf_solver *solver, struct wf_analysis *an)
{
    static const struct wf_species wood = { .name = "wood" };
    *an = (struct wf_analysis){
        .species = &wood, .solver = solver, .tree = c->tree, .loads = c->loads, .wind = c->wind
    };
    wf_scenario_default(&an->scenario);
    an->scenario.peak.method = "mean";
    wf_search_default(&an->search);
    an->tallness = wf_tree_height(&an->tree);
}

static void breaks_of(struct beam_case *c, const struct wf_solver *solver, struct wf_break (*out)[WF_SCOPES])
{
    struct wf_analysis an;
    analysis_of(c, solver, &an);
    struct wf_nodes *nodes = wf_nodes_open(&an, NULL);
    assert_non_null(nodes);
    if (wf_analysis_breaks(&an, &c->options, nodes, out, &c->err)) fail_msg("%s", c->err.text);
    wf_nodes_close(nodes);
}

/* Elements of a row and of the rows that carry it and that it carries, one by one, on the mesh of a fresh
 * solution at a tolerance. */
static void finer_counts_the_rows_on_the_way(void **state)
{
    (void)state;
    static const double tolerance[2] = { 1e-3, 1e-7 };
    struct beam_case c;
    struct wf_analysis an;
    double table[2][4];
    random_tree(&c, 7919, table);
    analysis_of(&c, &wf_solver_beam, &an);
    struct wf_nodes *nodes = wf_nodes_open(&an, NULL);
    assert_non_null(nodes);
    assert_true(wf_nodes_finer(nodes, WF_NODE_STEM, tolerance[0], tolerance[1], -1) == 0);
    for (int k = 0; k < 2; k++) {
        const struct wf_node *node;
        struct wf_solve_options o = c.options;
        o.mesh_tolerance = tolerance[k];
        assert_int_equal(wf_nodes_solve(nodes, &o, 12, &node, &c.err), WF_OK);
    }
    const double all = wf_nodes_finer(nodes, WF_NODE_STEM, tolerance[0], tolerance[1], -1);
    const double back = wf_nodes_finer(nodes, WF_NODE_STEM, tolerance[1], tolerance[0], -1);
    const double foot = wf_nodes_finer(nodes, WF_NODE_STEM, tolerance[0], tolerance[1], 0);
    assert_true(all > 1.5 && foot == all); /* the lowest row carries all others */
    assert_true(fabs(all * back - 1) < 1e-12);
    assert_true(wf_nodes_finer(nodes, WF_NODE_STEM, tolerance[0], 1e-5, -1) == 0);
    double apart = 0;
    for (int32_t i = STEM; i < ROWS; i++) {
        const double here = wf_nodes_finer(nodes, WF_NODE_BRANCHES, tolerance[0], tolerance[1], i);
        /* pieces of a branch are carried by the same rows, and the first carries the rest */
        assert_true(here == wf_nodes_finer(nodes, WF_NODE_BRANCHES, tolerance[0], tolerance[1],
                                           STEM + (i - STEM) / PIECES * PIECES));
        apart = fmax(apart, fabs(here / all - 1));
    }
    assert_true(apart > 0.02);
    wf_nodes_close(nodes);
    beam_free(&c);
}

/* The crossing of a branch may be taken from a coarser mesh, but not at the cost of its accuracy. */
static void branches_are_as_accurate_as_specified(void **state)
{
    (void)state;
    size_t found = 0;
    for (uint64_t seed = 1; seed <= TREES; seed++) {
        struct wf_break at[WF_CRITERIA][WF_SCOPES], fine[WF_CRITERIA][WF_SCOPES];
        struct beam_case c;
        double table[2][4];
        random_tree(&c, seed * 7919, table);
        breaks_of(&c, &wf_solver_beam, at);
        c.options.mesh_tolerance = 1e-8;
        breaks_of(&c, &wf_solver_beam, fine);
        for (int k = 0; k < WF_CRITERIA; k++) {
            const struct wf_critical *a = &at[k][WF_SCOPE_BRANCHES].critical,
                                     *b = &fine[k][WF_SCOPE_BRANCHES].critical;
            if (a->outcome != WF_CRITICAL_FOUND || b->outcome != WF_CRITICAL_FOUND) continue;
            assert_close(a->speed, b->speed, 2e-7); /* a fifth of the tolerance of the mesh */
            found++;
        }
        beam_free(&c);
    }
    assert_true(found > TREES / 4);
}

/* Least safety at the speed found, by the beam solver alone on a fine mesh. NAN: it finds no equilibrium. */
static double safety_at(struct beam_case *c, const struct wf_break *b, enum wf_scope scope)
{
    struct wf_analysis an;
    struct wf_at_speed at;
    struct wf_solve_options fine = c->options;
    fine.mesh_tolerance = 1e-7;
    analysis_of(c, &wf_solver_beam, &an);
    assert_int_equal(wf_speed_totals(&an, &fine, b->critical.speed, &at, &c->err), WF_OK);
    return at.worst[WF_BREAKAGE][scope].safety;
}

static void no_failure_is_passed_over(void **state)
{
    (void)state;
    struct wf_solver steps = wf_solver_beam;
    const char *more = getenv("WINDFIRM_TREES");
    long wanted = more ? strtol(more, NULL, 10) : TREES, same = 0, lower = 0, solved = 0,
         evaluations[2] = { 0 };
    steps.tracked = false;
    for (uint64_t seed = 1; seed <= (uint64_t)wanted; seed++) {
        struct beam_case c;
        double table[2][4];
        struct wf_break old[WF_CRITERIA][WF_SCOPES], new[WF_CRITERIA][WF_SCOPES];
        random_tree(&c, seed * 7919, table);
        breaks_of(&c, &steps, old);
        breaks_of(&c, &wf_solver_beam, new);
        for (int s = 0; s < WF_SCOPE_BRANCHES; s++) {
            const struct wf_critical *a = &old[WF_BREAKAGE][s].critical, *b = &new[WF_BREAKAGE][s].critical;
            evaluations[0] += (long)a->evaluations, evaluations[1] += (long)b->evaluations;
            bool found = a->outcome == WF_CRITICAL_FOUND && b->outcome == WF_CRITICAL_FOUND;
            /* the steps end within 3e-6 of the resistance: a higher speed is right where the safety at it is
             * 1 */
            double end = found ? 1e-6 + 3e-6 / (a->gradient * a->speed) : 0;
            bool above = found && b->speed > a->speed * (1 + 1e-6);
            if (above && !(b->speed < a->speed * (1 + 2 * end) &&
                           fabs(safety_at(&c, &new[WF_BREAKAGE][s], (enum wf_scope)s) - 1) < 1e-6))
                fail_msg("tree %lu: %.9g m/s, by steps %.9g", (unsigned long)seed, b->speed, a->speed);
            /* from a neighbouring solution an equilibrium may be found where the beam solver alone finds none
             */
            bool now = a->outcome == WF_CRITICAL_UNSOLVED && b->outcome != WF_CRITICAL_UNSOLVED;
            solved += now;
            if (!found && !now && b->outcome != a->outcome && b->outcome != WF_CRITICAL_FOUND)
                fail_msg("tree %lu: outcome %d, by steps %d (%g..%g)", (unsigned long)seed, b->outcome,
                         a->outcome, a->speed_low, a->speed_high);
            bool less =
                b->outcome == WF_CRITICAL_FOUND && !now && (!found || b->speed < a->speed * (1 - end));
            if (less) {
                print_message("tree %lu scope %d: %.9g m/s, by steps %.9g\n", (unsigned long)seed, s,
                              b->speed, a->speed);
                print_message("    safety there %.9g\n",
                              safety_at(&c, &new[WF_BREAKAGE][s], (enum wf_scope)s));
            }
            lower += less, same += !less;
        }
        beam_free(&c);
    }
    print_message(
        "%ld critical speeds the same, %ld lower, %ld not solved by steps; %ld solutions, by steps %ld\n",
        same, lower, solved, evaluations[1], evaluations[0]);
    assert_true(same > 9 * lower);
}

/* Branches that are said to fail in a given wind below the critical one are not said to hold up to it. */
static void a_failure_in_a_given_wind_is_heeded(void **state)
{
    (void)state;
    struct beam_case c;
    double table[2][4];
    struct wf_analysis an;
    struct wf_break free[WF_CRITERIA][WF_SCOPES], out[WF_CRITERIA][WF_SCOPES];
    random_tree(&c, 7919, table);
    analysis_of(&c, &wf_solver_beam, &an);
    breaks_of(&c, &wf_solver_beam, free);
    const struct wf_critical *alone = &free[WF_BREAKAGE][WF_SCOPE_TREE].critical,
                             *now = &out[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    assert_int_equal(alone->outcome, WF_CRITICAL_FOUND);
    for (int k = 0; k < 3; k++) { /* as it is, failing by another shape, without equilibrium */
        struct wf_at_speed at;
        an.at = NULL, an.n = 0;
        assert_int_equal(wf_speed_totals(&an, &c.options, 0.8 * alone->speed, &at, &c.err), WF_OK);
        for (int s = 0; s < WF_SCOPES && k == 1; s++) at.worst[WF_BREAKAGE][s].safety = 0.9;
        if (k == 2) at.status = WF_EUNSTABLE;
        an.at = &at, an.n = 1;
        struct wf_nodes *nodes = wf_nodes_open(&an, NULL);
        assert_non_null(nodes);
        assert_int_equal(wf_analysis_breaks(&an, &c.options, nodes, out, &c.err), WF_OK);
        wf_nodes_close(nodes);
        if (k == 0) {
            assert_int_equal(now->outcome, WF_CRITICAL_FOUND);
            assert_close(now->speed, alone->speed, 1e-6);
            continue;
        }
        assert_int_equal(now->outcome, WF_CRITICAL_UNSEARCHED);
        assert_true(now->speed_high == at.speed);
        assert_true(now->speed_low < at.speed);
    }
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(no_failure_is_passed_over),
                                        cmocka_unit_test(a_failure_in_a_given_wind_is_heeded),
                                        cmocka_unit_test(finer_counts_the_rows_on_the_way),
                                        cmocka_unit_test(branches_are_as_accurate_as_specified) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
