/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of failure by part of the tree, and what results.json says of them. */
#include "close.h"
#include "data/out/document.h"
#include "fail/fail.h"
#include "load/scene.h"
#include "made.h"
#include "solve/solve.h"
#include "study/directions.h"
#include "study/verdict.h"
#include <string.h>

static const double winds[] = { 8, 300.0 / 9 };
enum { WINDS = 2 };

/* With two directions around. */
struct turned {
    struct made made;
    struct wf_directions around;
};

static void analyse(struct turned *t, const char *model)
{
    struct made *m = &t->made;
    const struct wf_directions_request q = { .n = 2 };
    made_read(m, "species/weeping_willow.yaml", model);
    m->scenario.peak.method = "mean";
    m->options.mesh_tolerance = 1e-3;
    made_analyse(m, winds, WINDS);
    if (wf_directions_run(&m->an, &m->options, &q, &m->arena, &t->around, &m->err))
        fail_msg("%s", m->err.text);
    m->an.directions = &t->around;
}

static void rows_are_complete(void **state)
{
    (void)state;
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_criterion *r = &wf_criteria[c];
        assert_true(r->name && r->source && r->validity && (r->section || (r->known && r->safety)));
    }
    struct wf_worst worst[WF_CRITERIA][WF_SCOPES];
    wf_criteria_check(NULL, NULL, NULL, worst);
    assert_true(isnan(worst[WF_BREAKAGE][WF_SCOPE_STEM].safety));
    assert_int_equal(worst[WF_BREAKAGE][WF_SCOPE_BRANCHES].row, -1);
}

/* The tree is as near to failing as the nearer of its parts, and every part's place is in it. */
static void parts_make_the_tree(void **state)
{
    (void)state;
    struct turned m;
    analyse(&m, "tests/data/limbs.yaml");
    for (size_t k = 0; k < WINDS; k++)
        for (int c = 0; c < WF_CRITERIA; c++) {
            const struct wf_worst *w = m.made.an.at[k].worst[c];
            if (m.made.an.at[k].status ||
                m.made.an.breaks[c][WF_SCOPE_TREE].critical.outcome == WF_CRITICAL_NO_STRENGTH)
                continue;
            assert_close(w[WF_SCOPE_TREE].safety, fmin(w[WF_SCOPE_STEM].safety, w[WF_SCOPE_BRANCHES].safety),
                         0);
            for (int s = 0; s < WF_SCOPES; s++)
                assert_true(w[s].row < 0 ||
                            wf_scope_holds((enum wf_scope)s, &m.made.an.tree, (size_t)w[s].row));
        }
    const struct wf_break *b = m.made.an.breaks[WF_BREAKAGE];
    assert_int_equal(b[WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_FOUND);
    assert_true(m.made.an.tree.level[b[WF_SCOPE_TREE].row] > 0); /* of this tree a branch breaks first */
    assert_close(b[WF_SCOPE_BRANCHES].critical.speed, b[WF_SCOPE_TREE].critical.speed, 0);
    assert_true(b[WF_SCOPE_STEM].critical.speed > b[WF_SCOPE_TREE].critical.speed);
    wf_arena_free(&m.made.arena);
}

/* An entry against `critical` or `critical_stem`, and against the winds. */
static void agrees(const json_t *tree, size_t entry, const char *scope, const char *critical)
{
    const json_t *x = json_array_get(json_object_get(tree, "criteria"), entry),
                 *c = json_object_get(tree, critical);
    assert_string_equal(text(x, "criterion"), "breakage");
    assert_string_equal(text(x, "scope"), scope);
    assert_string_equal(text(x, "outcome"), text(c, "outcome"));
    if (!strcmp(text(c, "outcome"), "found"))
        assert_close(number(x, "critical_speed"), number(c, "speed"), 0);
    else
        assert_true(isnan(number(x, "critical_speed")));
    assert_true(json_equal(json_object_get(x, "governing_section"), json_object_get(c, "governing_section")));
}

/* The part that fails first is that of the lowest critical wind of all criteria that lose a stem. */
static void first_is_lowest(const json_t *tree)
{
    const json_t *first = json_object_get(tree, "first"), *x;
    double lowest = INFINITY;
    const json_t *by = NULL;
    size_t i;
    json_array_foreach(json_object_get(tree, "criteria"), i, x)
    {
        const double speed = number(x, "critical_speed");
        if (strcmp(text(x, "scope"), "tree") != 0 || !json_is_true(json_object_get(x, "loses_tree")))
            continue;
        if (!strcmp(text(x, "criterion"), "overturning") || !(speed < lowest * (1 - WF_VERDICT_SAME)))
            continue;
        lowest = speed, by = x;
    }
    if (!by) {
        assert_string_not_equal(text(first, "outcome"), "found");
        return;
    }
    assert_string_equal(text(first, "criterion"), text(by, "criterion"));
    assert_close(number(first, "speed"), lowest, 0);
    assert_true(
        json_equal(json_object_get(first, "governing_section"), json_object_get(by, "governing_section")));
}

/* The thickness named is that at the place named. */
static void thickness_is_of_the_place(const struct wf_tree *t, const json_t *section)
{
    if (!json_is_object(section)) return;
    const size_t row = (size_t)json_integer_value(json_object_get(section, "segment")) - 1;
    const double at = number(section, "position");
    assert_true(at >= 0 && at <= 1);
    assert_close(number(section, "diameter"), 2 * (t->r0[row] + at * (t->r1[row] - t->r0[row])), 1e-12);
    assert_close(number(section, "height"), t->z0[row] + at * (t->z1[row] - t->z0[row]), 1e-9);
}

static void winds_agree(const json_t *tree)
{
    const json_t *list = json_object_get(tree, "winds"),
                 *of = json_object_get(json_array_get(json_object_get(tree, "criteria"), 0), "winds");
    assert_int_equal(json_array_size(list), json_array_size(of));
    for (size_t k = 0; k < json_array_size(list); k++) {
        const json_t *wind = json_array_get(list, k), *x = json_array_get(of, k);
        assert_close(number(x, "speed"), number(wind, "speed"), 0);
        if (strcmp(text(wind, "status"), "ok") != 0) continue;
        assert_close(number(x, "safety"), number(wind, "least_safety"), 0);
        assert_close(number(x, "utilisation"), 1 / number(wind, "least_safety"), 1e-15);
        assert_true(
            json_equal(json_object_get(x, "governing_section"), json_object_get(wind, "governing_section")));
    }
}

static void results_agree(void **state)
{
    (void)state;
    static const char *const models[] = { "tests/data/limbs.yaml", "models/culm.yaml" };
    for (int k = 0; k < 2; k++) {
        struct turned m;
        analyse(&m, models[k]);
        json_t *o = document(&m.made.an);
        const json_t *tree = json_array_get(json_object_get(o, "trees"), 0), *d;
        size_t i;
        agrees(tree, 0, "tree", "critical");
        agrees(tree, 1, "stem", "critical_stem");
        winds_agree(tree);
        first_is_lowest(tree);
        thickness_is_of_the_place(&m.made.an.tree,
                                  json_object_get(json_object_get(tree, "critical"), "governing_section"));
        const json_t *first = json_object_get(tree, "first"),
                     *at = json_object_get(first, "governing_section");
        thickness_is_of_the_place(&m.made.an.tree, at);
        const int32_t row = (int32_t)json_integer_value(json_object_get(at, "segment")) - 1;
        assert_int_equal(json_is_true(json_object_get(first, "twig")),
                         m.made.an.tree.level[row] > 0 &&
                             wf_tree_thickness(&m.made.an.tree, (size_t)row, NAN) <
                                 m.made.an.search.branches_from);
        size_t entries = 0;
        for (int c = 0; c < WF_CRITERIA; c++) entries += wf_criteria[c].whole ? 1 : WF_SCOPES;
        assert_int_equal(json_array_size(json_object_get(tree, "criteria")), entries);
        const json_t *branches = json_array_get(json_object_get(tree, "criteria"), 2);
        assert_string_equal(text(branches, "scope"), "branches");
        assert_string_equal(text(branches, "outcome"), k ? "no-strength" : "found");
        json_array_foreach(json_object_get(json_object_get(tree, "directions"), "directions"), i, d)
        {
            agrees(d, 0, "tree", "critical");
            agrees(d, 1, "stem", "critical_stem");
            winds_agree(d);
            first_is_lowest(d);
        }
        json_decref(o);
        wf_arena_free(&m.made.arena);
    }
}

static void versions_that_are_read(void **state)
{
    (void)state;
    assert_true(wf_results_readable(1, 1));
    assert_false(wf_results_readable(0, 1)); /* the first version has none before it */
    assert_false(wf_results_readable(2, 1));
    assert_true(wf_results_readable(1, 2) && wf_results_readable(2, 2));
    assert_false(wf_results_readable(0, 2) || wf_results_readable(3, 2) || wf_results_readable(1, 3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_complete),
        cmocka_unit_test(parts_make_the_tree),
        cmocka_unit_test(results_agree),
        cmocka_unit_test(versions_that_are_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
