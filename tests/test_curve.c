/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of an analysis: interpolated rows against direct solutions; range of the search; threads. */
#include "made.h"
#include "study/node.h"
#include <string.h>

static void analyse_by(struct made *m, const char *peak, const char *species, const char *model,
                       const struct wf_search *search, double wind, size_t threads)
{
    made_read(m, species, model);
    if (search) m->search = *search;
    m->scenario.peak.method = peak;
    m->options.mesh_tolerance = 1e-4;
    m->options.threads = threads;
    made_analyse(m, &wind, 1);
}

static void analyse(struct made *m, const char *species, const char *model, const struct wf_search *search,
                    double wind, size_t threads)
{
    analyse_by(m, "mean", species, model, search, wind, threads);
}

/* 0.5 % of the direct solution, for every total of sweep.csv. Returned: interpolated rows below and above the
 * critical speed. */
static void compare(const struct made *m, size_t sides[2])
{
    const struct wf_critical *c = &m->an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    for (size_t k = 0; k < m->an.sweep_n; k++) {
        const struct wf_at_speed *row = &m->an.sweep[k];
        struct wf_at_speed at;
        if (!row->interpolated) continue;
        assert_int_equal(wf_speed_totals(&m->an, &m->options, row->speed, &at, NULL), WF_OK);
        assert_int_equal(row->status, at.status);
        sides[c->outcome == WF_CRITICAL_FOUND && row->speed > c->speed]++;
        assert_close(row->tip_deflection, at.tip_deflection, 5e-3);
        assert_close(row->tip_deflection_share, at.tip_deflection_share, 5e-3);
        assert_close(row->tip_angle, at.tip_angle, 5e-3);
        assert_close(row->drag, at.drag, 5e-3);
        assert_close(row->weight, at.weight, 5e-3);
        assert_close(row->base_shear, at.base_shear, 5e-3);
        assert_close(row->base_moment, at.base_moment, 5e-3);
        assert_close(row->breakage.largest_stress, at.breakage.largest_stress, 5e-3);
        for (int s = 0; s < WF_SCOPES; s++)
            if (!isnan(at.worst[WF_BREAKAGE][s].safety)) /* a culm has no branches */
                assert_close(1 / row->worst[WF_BREAKAGE][s].safety, 1 / at.worst[WF_BREAKAGE][s].safety,
                             5e-3);
    }
}

static void rows_agree_with_solutions(void **state)
{
    (void)state;
    static const struct {
        const char *species, *model;
    } trees[] = { { "species/weeping_willow.yaml", "tests/data/limbs.yaml" },
                  { "species/moso_bamboo.yaml", "models/culm.yaml" },
                  { "species/weeping_willow.yaml", "models/culm.yaml" },
                  { "species/moso_bamboo.yaml", "models/moso_culm.yaml" },
                  { "species/scots_pine.yaml", "models/culm.yaml" } };
    size_t sides[2] = { 0 };
    for (size_t k = 0; k < sizeof trees / sizeof *trees; k++) {
        struct made m;
        analyse(&m, trees[k].species, trees[k].model, NULL, 20, 1);
        compare(&m, sides);
        wf_arena_free(&m.arena);
    }
    print_message("%zu and %zu rows\n", sides[0], sides[1]);
    assert_true(sides[0] >= 40 && sides[1] >= 5);
}

/* Branches have a peak of their own: their curve is drawn from other speeds than that of the stem. */
static void parts_agree_with_solutions(void **state)
{
    (void)state;
    static const struct {
        const char *species, *model;
        double wind;
    } trees[] = { { "species/weeping_willow.yaml", "tests/data/limbs.yaml", 12 },
                  { "species/weeping_willow.yaml", "tests/data/limbs.yaml", 30 },
                  { "species/oak.yaml", "tests/data/limbs.yaml", 20 } };
    size_t sides[2] = { 0 }, apart = 0;
    for (size_t k = 0; k < sizeof trees / sizeof *trees; k++) {
        struct made m;
        struct wf_nodes *nodes;
        analyse_by(&m, "en1991", trees[k].species, trees[k].model, NULL, trees[k].wind, 1);
        compare(&m, sides);
        assert_non_null(nodes = wf_nodes_open(&m.an, NULL));
        assert_int_equal(wf_analysis_breaks(&m.an, &m.options, nodes, m.an.breaks, &m.err), WF_OK);
        assert_int_equal(wf_analysis_sweep(&m.an, &m.options, nodes, &m.arena, &m.diag, &m.err), WF_OK);
        for (size_t i = 0; i < wf_nodes_count(nodes); i++) apart += !wf_nodes_at(nodes, i)->whole;
        wf_nodes_close(nodes);
        wf_arena_free(&m.arena);
    }
    print_message("%zu and %zu rows\n", sides[0], sides[1]);
    assert_true(sides[0] >= 40 && sides[1] >= 5 && apart >= 6);
}

/* The largest stress is that of all rows, also of those that are not credible and have no utilisation. */
static void doubtful_rows_have_stress(void **state)
{
    (void)state;
    struct made m;
    struct wf_nodes *nodes;
    size_t sides[2] = { 0 };
    analyse(&m, "species/weeping_willow.yaml", "tests/data/limbs.yaml", NULL, 20, 1);
    m.an.tree.doubtful = WF_TAKE(&m.arena, m.an.tree.n, bool);
    for (size_t i = 0; i < m.an.tree.n; i++)
        m.an.tree.doubtful[i] = m.an.at[0].breakage.peak[i] > 0.8 * m.an.at[0].breakage.largest_stress;
    m.an.n = 0; /* the safeties of the given wind are of all rows */
    assert_non_null(nodes = wf_nodes_open(&m.an, NULL));
    assert_int_equal(wf_analysis_breaks(&m.an, &m.options, nodes, m.an.breaks, &m.err), WF_OK);
    assert_int_equal(wf_analysis_sweep(&m.an, &m.options, nodes, &m.arena, &m.diag, &m.err), WF_OK);
    wf_nodes_close(nodes);
    compare(&m, sides);
    assert_true(sides[0] + sides[1] >= 5);
    wf_arena_free(&m.arena);
}

static void threads_do_not_matter(void **state)
{
    (void)state;
    struct made one, two;
    analyse(&one, "species/weeping_willow.yaml", "tests/data/limbs.yaml", NULL, 10, 1);
    analyse(&two, "species/weeping_willow.yaml", "tests/data/limbs.yaml", NULL, 10, 2);
    assert_int_equal(one.an.sweep_n, two.an.sweep_n);
    for (size_t k = 0; k < one.an.sweep_n; k++) {
        const struct wf_at_speed *a = &one.an.sweep[k], *b = &two.an.sweep[k];
        assert_int_equal(a->interpolated, b->interpolated);
        assert_close(a->tip_deflection, b->tip_deflection, 0);
        assert_close(a->base_moment, b->base_moment, 0);
        assert_close(a->breakage.largest_stress, b->breakage.largest_stress, 0);
    }
    wf_arena_free(&one.arena);
    wf_arena_free(&two.arena);
}

/* The search ends at 60 m/s or 1.2 times the highest wind; a narrower one finds the same speed. */
static void range_of_the_search(void **state)
{
    (void)state;
    struct made m;
    analyse(&m, "species/weeping_willow.yaml", "tests/data/limbs.yaml", NULL, 10, 1);
    const struct wf_critical c = m.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    assert_close(m.an.search.speed_max, 60, 0);
    assert_int_equal(c.outcome, WF_CRITICAL_FOUND);
    wf_arena_free(&m.arena);
    analyse(&m, "species/weeping_willow.yaml", "tests/data/limbs.yaml", NULL, 55, 1);
    assert_close(m.an.search.speed_max, 66, 1e-12);
    wf_arena_free(&m.arena);
    const struct wf_search near = { .speed_max = 0.5 * ceil(2 * c.speed) + 1, .seconds = 1e6 };
    analyse(&m, "species/weeping_willow.yaml", "tests/data/limbs.yaml", &near, 10, 1);
    assert_close(m.an.search.speed_max, near.speed_max, 0);
    assert_close(m.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, c.speed, 1e-6);
    assert_int_equal(wf_critical_rungs(10), 4);
    assert_close(wf_critical_rung(10, 3), 9.375, 0);
    assert_close(wf_critical_rung(10, 4), 10, 0);
    assert_int_equal(wf_critical_rungs(1000), WF_CRITICAL_RUNGS_MAX);
    wf_arena_free(&m.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(rows_agree_with_solutions),
                                        cmocka_unit_test(parts_agree_with_solutions),
                                        cmocka_unit_test(doubtful_rows_have_stress),
                                        cmocka_unit_test(threads_do_not_matter),
                                        cmocka_unit_test(range_of_the_search) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
