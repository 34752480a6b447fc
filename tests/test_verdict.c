/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The headline: loss of the tree by the weaker of its criteria, never a twig; branches by thickness; what was
 * not assessed and what no field data verify, in the library, results.json and on the terminal. */
#include "close.h"
#include "data/out/document.h"
#include "fail/anchorage.h"
#include "grow/grow.h"
#include "made.h"
#include "solve/solve.h"
#include "study/verdict.h"
#include <string.h>

static const double winds[] = { 5, 12, 30 };
enum { WINDS = 3 };

/* Given: moment at 0.25 deg [N m], 0: nothing is said; thinnest branch [m]. */
static void analyse(struct made *m, const char *model, double pull, double from)
{
    made_read(m, "species/weeping_willow.yaml", model);
    m->scenario.peak.method = "mean";
    struct wf_anchorage_request *root = WF_TAKE(&m->arena, 1, struct wf_anchorage_request);
    assert_non_null(root);
    *root = (struct wf_anchorage_request){ .pull_moment = pull, .secant = NAN };
    if (pull > 0) m->scenario.anchorage = root;
    m->search.branches_from = from;
    made_analyse(m, winds, WINDS);
}

static bool warned(const struct made *m, const char *code)
{
    for (const struct wf_finding *f = m->diag.first; f; f = f->next)
        if (f->code && !strcmp(f->code, code)) return true;
    return false;
}

/* C17 has no conversion to a pointer to rows of const. */
static struct wf_verdict verdict_of(struct wf_break (*b)[WF_SCOPES])
{
    return wf_verdict_of((const struct wf_break(*)[WF_SCOPES])b);
}

static const struct wf_critical none = { .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN };

static struct wf_critical at_speed(double speed)
{
    return (struct wf_critical){ .outcome = WF_CRITICAL_FOUND, .speed = speed };
}

/* The weaker governs; what does not lose the tree, and branches, do not. */
static void weaker_governs(void **state)
{
    (void)state;
    struct wf_break b[WF_CRITERIA][WF_SCOPES];
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++) b[c][s] = (struct wf_break){ .critical = none };
    struct wf_verdict v = verdict_of(b);
    assert_false(v.assessed[WF_BREAKAGE] || v.assessed[WF_OVERTURNING]);
    b[WF_BREAKAGE][WF_SCOPE_TREE].critical = b[WF_BREAKAGE][WF_SCOPE_BRANCHES].critical = at_speed(4);
    b[WF_BREAKAGE][WF_SCOPE_STEM].critical = at_speed(30);
    b[WF_TORSION][WF_SCOPE_STEM].critical = at_speed(30 * (1 - 1e-8)); /* hardly twisted */
    b[WF_ELASTIC_LIMIT][WF_SCOPE_STEM].critical = at_speed(12);
    b[WF_OVERTURNING_WETTEST][WF_SCOPE_STEM].critical = at_speed(10);
    v = verdict_of(b);
    assert_int_equal(v.criterion, WF_BREAKAGE);
    assert_close(v.loss->critical.speed, 30, 0);
    b[WF_OVERTURNING][WF_SCOPE_STEM].critical = at_speed(25);
    v = verdict_of(b);
    assert_int_equal(v.criterion, WF_OVERTURNING);
    assert_true(v.assessed[WF_BREAKAGE] && v.assessed[WF_OVERTURNING]);
    b[WF_OVERTURNING][WF_SCOPE_STEM].critical =
        (struct wf_critical){ .outcome = WF_CRITICAL_UNSEARCHED, .speed_low = 28, .speed_high = 60 };
    assert_int_equal(verdict_of(b).criterion, WF_OVERTURNING); /* it may be below the other */
    b[WF_OVERTURNING][WF_SCOPE_STEM].critical =
        (struct wf_critical){ .outcome = WF_CRITICAL_ABOVE, .speed_high = 60 };
    assert_int_equal(verdict_of(b).criterion, WF_BREAKAGE);
    b[WF_SPLITTING][WF_SCOPE_STEM].critical = at_speed(20);
    assert_int_equal(verdict_of(b).criterion, WF_SPLITTING);
    b[WF_BREAKAGE][WF_SCOPE_STEM].critical = b[WF_TORSION][WF_SCOPE_STEM].critical =
        b[WF_SPLITTING][WF_SCOPE_STEM].critical = none;
    assert_int_equal(verdict_of(b).criterion, WF_OVERTURNING);
}

/* At the critical wind of the tree the safety against loss is 1, at every wind the least of the criteria's.
 */
static void safety_of_the_tree(void **state)
{
    (void)state;
    struct made m;
    analyse(&m, "tests/data/limbs.yaml", 250, 0.005);
    struct wf_verdict v = verdict_of(m.an.breaks);
    struct wf_at_speed at;
    assert_int_equal(v.criterion, WF_OVERTURNING);
    assert_int_equal(v.loss->critical.outcome, WF_CRITICAL_FOUND);
    assert_int_equal(wf_speed_totals(&m.an, &m.options, v.loss->critical.speed, &at, &m.err), WF_OK);
    enum wf_criterion_id nearest = WF_BREAKAGE;
    assert_close(wf_verdict_safety(&at, &nearest), 1, 1e-6);
    assert_int_equal(nearest, WF_OVERTURNING);
    for (size_t k = 0; k < WINDS; k++) {
        const struct wf_at_speed *x = &m.an.at[k];
        double least = INFINITY;
        for (int c = 0; c < WF_CRITERIA; c++)
            if (wf_criteria[c].loses_tree) least = fmin(least, x->worst[c][WF_SCOPE_STEM].safety);
        assert_close(wf_verdict_safety(x, NULL), least, 0);
        assert_true(wf_verdict_lost(&v, x) == (x->speed > v.loss->critical.speed));
        assert_close(x->worst[WF_OVERTURNING][WF_SCOPE_STEM].safety, 2.5 * 250 / x->base_moment, 1e-12);
    }
    assert_ptr_equal(wf_verdict_wind(&m.an), &m.an.at[WINDS - 1]);
    wf_arena_free(&m.arena);
}

/* Nothing said of soil and root does not change what is said of the stem. */
static void not_assessed(void **state)
{
    (void)state;
    struct made with, without;
    analyse(&with, "tests/data/limbs.yaml", 1e6, 0.05);
    analyse(&without, "tests/data/limbs.yaml", 0, 0.05);
    struct wf_verdict v = verdict_of(without.an.breaks);
    assert_string_equal(wf_verdict_unassessed(&without.an, &v, WF_OVERTURNING), WF_ANCHORAGE_UNSAID);
    assert_null(wf_verdict_unassessed(&without.an, &v, WF_BREAKAGE));
    assert_null(wf_verdict_unassessed(&without.an, &v, WF_OVERTURNING_WET));
    assert_null(wf_verdict_unassessed(&without.an, &v, WF_SPLITTING)); /* it is solid */
    assert_int_equal(v.criterion, WF_TORSION);                         /* its branches twist it */
    v = verdict_of(with.an.breaks);
    assert_null(wf_verdict_unassessed(&with.an, &v, WF_OVERTURNING));
    for (int s = 0; s < WF_SCOPES; s++)
        assert_int_equal(with.an.breaks[WF_BREAKAGE][s].critical.outcome,
                         without.an.breaks[WF_BREAKAGE][s].critical.outcome);
    assert_close(with.an.breaks[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed,
                 without.an.breaks[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed, 1e-6);
    wf_arena_free(&with.arena);
    wf_arena_free(&without.arena);
}

/* Each segment of a branch that is thick enough is in the class of its diameter; the worst of all classes is
 * the worst of the branches where none is a twig. */
static void branches_by_thickness(void **state)
{
    (void)state;
    struct made m;
    struct wf_branch_class k[WF_BRANCH_CLASSES];
    analyse(&m, "tests/data/limbs.yaml", 0, 0.004);
    size_t n = wf_branch_classes(&m.an, k), thick[WF_BRANCH_CLASSES] = { 0 }, twigs = 0;
    for (size_t i = 0; i < m.an.tree.n; i++) {
        double d = 2 * fmax(m.an.tree.r0[i], m.an.tree.r1[i]);
        if (m.an.tree.level[i] == 0) continue;
        twigs += d < 0.004;
        for (size_t c = 0; c < WF_BRANCH_CLASSES; c++) thick[c] += d >= k[c].from && d < k[c].to;
    }
    const struct wf_at_speed *last = &m.an.at[WINDS - 1];
    double least = INFINITY, fails = INFINITY;
    assert_true(n > 1);
    for (size_t c = 0; c < n; c++) {
        assert_int_equal(k[c].segments, thick[c]);
        assert_close(k[c].from, 0.004 * pow(2, (double)c), 1e-12);
        if (k[c].worst.row >= 0) {
            double d = 2 * fmax(m.an.tree.r0[k[c].worst.row], m.an.tree.r1[k[c].worst.row]);
            assert_true(d >= k[c].from && d < k[c].to);
            assert_close(k[c].worst.safety,
                         m.an.tree.strength[k[c].worst.row] / last->breakage.peak[k[c].worst.row], 1e-12);
        }
        least = fmin(least, k[c].worst.safety);
        if (!isnan(k[c].fails)) fails = fmin(fails, k[c].fails);
    }
    assert_int_equal(twigs, 0);
    assert_close(least, last->worst[WF_BREAKAGE][WF_SCOPE_BRANCHES].safety, 0);
    double first = INFINITY;
    for (size_t w = WINDS; w-- > 0;)
        if (m.an.at[w].worst[WF_BREAKAGE][WF_SCOPE_BRANCHES].safety <= 1) first = winds[w];
    assert_true(isfinite(first));
    assert_close(fails, first, 0);
    m.an.search.branches_from = 1; /* all are twigs */
    assert_int_equal(wf_branch_classes(&m.an, k), 0);
    wf_arena_free(&m.arena);
}

/* A stem too strong for any wind that was ever measured gets its line. */
static void unverified(void **state)
{
    (void)state;
    struct made m;
    analyse(&m, "models/culm.yaml", 0, 0.05);
    assert_false(warned(&m, "unverified-safety") || warned(&m, "unverified-wind"));
    wf_arena_free(&m.arena);
    analyse(&m, "models/culm.yaml", 0, 0.05);
    m.diag = (struct wf_diag){ .arena = &m.arena };
    m.species.level[0].modulus_of_rupture.value *= 1e3;
    struct wf_analysis again;
    assert_int_equal(wf_analyze(&m.species, &m.model, &m.scenario, &m.search, wf_solvers[0], &m.options,
                                winds, WINDS, &m.arena, &m.diag, &again, &m.err),
                     WF_OK);
    assert_true(warned(&m, "unverified-safety") && warned(&m, "unverified-wind"));
    wf_arena_free(&m.arena);
}

/* ---- results.json ---- */

static void results(void **state)
{
    (void)state;
    for (int pulled = 0; pulled < 2; pulled++) {
        struct made m;
        analyse(&m, "tests/data/limbs.yaml", pulled ? 250 : 0, 0.005);
        json_t *o = document(&m.an);
        const json_t *tree = json_array_get(json_object_get(o, "trees"), 0),
                     *v = json_object_get(tree, "verdict"), *missing = json_object_get(v, "not_assessed"),
                     *winds_of = json_object_get(tree, "winds");
        struct wf_verdict own = verdict_of(m.an.breaks);
        assert_string_equal(text(v, "criterion"), pulled ? "overturning" : "torsion");
        assert_close(number(v, "critical_speed"), own.loss->critical.speed, 0);
        assert_close(number(v, "critical_gust"), wf_scenario_gust(&m.scenario, own.loss->critical.speed), 0);
        assert_close(number(v, "safety"), wf_verdict_safety(&m.an.at[WINDS - 1], NULL), 0);
        assert_close(number(v, "speed"), winds[WINDS - 1], 0);
        assert_int_equal(json_array_size(missing), !pulled);
        if (!pulled) {
            assert_string_equal(text(json_array_get(missing, 0), "criterion"), "overturning");
            assert_string_equal(text(json_array_get(missing, 0), "reason"), WF_ANCHORAGE_UNSAID);
            assert_true(json_is_null(json_object_get(v, "anchorage")));
        } else {
            assert_string_equal(text(json_object_get(v, "anchorage"), "name"), "pull");
            assert_close(number(json_object_get(v, "anchorage"), "moment"), 625, 1e-12);
        }
        assert_int_equal(json_array_size(json_object_get(v, "criteria")), pulled ? 5 : 2);
        assert_true(json_array_size(json_object_get(v, "thicknesses")) > 0);
        for (size_t k = 0; k < WINDS; k++)
            assert_true(json_is_true(json_object_get(json_array_get(winds_of, k), "beyond_loss")) ==
                        (winds[k] > own.loss->critical.speed));
        json_decref(o);
        wf_arena_free(&m.arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weaker_governs), cmocka_unit_test(safety_of_the_tree),
        cmocka_unit_test(not_assessed),   cmocka_unit_test(branches_by_thickness),
        cmocka_unit_test(unverified),     cmocka_unit_test(results),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
