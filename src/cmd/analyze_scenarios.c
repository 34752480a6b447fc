/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/analyze_scenarios.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "cmd/scenarios.h"
#include "data/species.h"
#include "study/beside.h"
#include <math.h>
#include <string.h>

/* One scenario, read. */
struct wf_analyze_scenario {
    const char *name;
    bool removal;
    struct wf_analyze_options options;
    struct wf_analyze_request request;
    struct wf_model model;
};

/* ---- Reading ---- */

/* The tree of a scenario: that of the run, unless it changes what is drawn. Leaves that have fallen are still
 * those that it stood with: an area given for the tree as it stands is no contradiction. */
static enum wf_status read_tree(const struct wf_model *whole, const struct wf_scenario_words *x,
                                struct wf_arena *a, struct wf_diag *d, struct wf_analyze_scenario *out,
                                struct wf_err *e)
{
    struct wf_tree_asked asked = out->options.tree;
    const char *path;
    out->model = *whole;
    if (!wf_scenario_draws(x, &out->options.args)) return WF_OK;
    bool fallen = asked.season && !strcmp(asked.season, "leaf_off") && whole->season == WF_LEAF_ON;
    if (fallen) asked.leaf_area = NAN;
    enum wf_status s = wf_tree_asked_read(&asked, NULL, a, &out->model, &path, d, e);
    if (!s && fallen) out->model.leaf_area_on = whole->leaf_area_on;
    return s;
}

static enum wf_status read_one(const struct wf_analyze_options *o, const struct wf_model *whole,
                               const struct wf_scenario_words *x, struct wf_units *units, struct wf_arena *a,
                               struct wf_diag *d, struct wf_analyze_scenario *out, struct wf_err *e)
{
    struct wf_diag own = { .arena = a };
    struct wf_err why = { WF_OK, "" };
    *out = (struct wf_analyze_scenario){ .name = x->name, .removal = x->removal, .options = *o };
    size_t before = d->errors;
    enum wf_status s = wf_scenario_options(&o->args, "analyze", x, units, a, d, &out->options.args, e);
    if (s || d->errors > before) return s;
    out->options.tree.scan = o->tree.scan; /* of several models the one that stands */
    s = read_tree(whole, x, a, &own, out, &why);
    if (!s) s = wf_analyze_request_read(&out->options, a, &own, &out->request, &why);
    if (!s) s = wf_scenario_onto(&out->options, false, whole, NAN, a, &out->request, &out->model, &why);
    const struct wf_finding *f = own.first;
    while (f && f->severity != WF_ERROR) f = f->next;
    if (s == WF_ENOMEM) return wf_fail(e, s, "%s", why.text);
    if (s) wf_diag_error(d, NULL, 0, 0, "scenario '%s': %s", x->name, f ? f->text : why.text);
    return WF_OK;
}

enum wf_status wf_analyze_list_read(const struct wf_analyze_options *o, const struct wf_model *whole,
                                    struct wf_arena *a, struct wf_diag *d, struct wf_analyze_list *out,
                                    struct wf_err *e)
{
    struct wf_units *units = NULL;
    struct wf_scenario_list *words = WF_TAKE(a, 1, struct wf_scenario_list);
    *out = (struct wf_analyze_list){ 0, NULL };
    if (!words) return wf_fail(e, WF_ENOMEM, "not enough memory for scenarios");
    size_t before = d->errors;
    enum wf_status s = wf_scenarios_split(o, a, d, words, e);
    if (!s && words->n) {
        out->item = WF_TAKE(a, words->n, struct wf_analyze_scenario);
        s = out->item ? wf_units_open(&units, e) : wf_fail(e, WF_ENOMEM, "not enough memory for scenarios");
    }
    for (size_t k = 0; k < words->n && !s; k++)
        s = read_one(o, whole, &words->item[k], units, a, d, &out->item[k], e);
    if (units) wf_units_close(units);
    if (!s) out->n = words->n;
    return s || d->errors == before ? s : wf_fail(e, WF_EUSAGE, "a scenario is wrong");
}

enum wf_status wf_analyze_list_check(const struct wf_analyze_list *list, const struct wf_species *sp,
                                     struct wf_err *e)
{
    for (size_t k = 0; k < list->n; k++) {
        const struct wf_analyze_scenario *x = &list->item[k];
        struct wf_err why = { WF_OK, "" };
        enum wf_status s = wf_beside_check(sp, &x->model, &x->request.scenario, &why);
        if (s) return wf_fail(e, s, "scenario '%s': %s", x->name, why.text);
    }
    return WF_OK;
}

/* ---- Running ---- */

static enum wf_status run_one(const struct wf_analysis *whole, struct wf_analyze_scenario *x,
                              struct wf_arena *a, struct wf_beside *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag unsaid = { .arena = &scratch };
    struct wf_analysis an;
    struct wf_analyze_request *q = &x->request;
    const struct wf_speeds *wind = &x->options.wind;
    struct wf_anchorage_request roots;
    struct wf_err why = { WF_OK, "" };
    q->search.bare = true, q->search.unions = false;
    if (q->scenario.anchorage) { /* they grew with the whole tree */
        roots = *q->scenario.anchorage;
        if (!(roots.grown > 0)) roots.grown = whole->tallness;
    }
    const struct wf_anchorage_request *said = q->scenario.anchorage;
    const struct wf_stand stand = q->scenario.peak.stand;
    if (!(stand.height > 0)) q->scenario.peak.stand.height = whole->tallness;
    if (said) q->scenario.anchorage = &roots;
    wf_stage_begin(WF_SEARCH_SOLUTIONS, true, "%s: %s", whole->species->name, x->name);
    enum wf_status s = wf_analyze(whole->species, &x->model, &q->scenario, &q->search, q->solver, &q->solve,
                                  wind->speed, wind->n, &scratch, &unsaid, &an, &why);
    if (!s) s = wf_beside_take(&an, a, out, &why);
    if (!s) wf_beside_pass(&unsaid, whole->diag);
    out->name = x->name, out->removal = x->removal;
    q->scenario.anchorage = said, q->scenario.peak.stand = stand;
    wf_arena_free(&scratch);
    return s ? wf_fail(e, s, "scenario '%s': %s", x->name, why.text) : WF_OK;
}

enum wf_status wf_analyze_list_run(const struct wf_analyze_list *list, struct wf_arena *a,
                                   struct wf_analysis *an, struct wf_err *e)
{
    struct wf_besides *out = WF_TAKE(a, 1, struct wf_besides);
    struct wf_beside *item = WF_TAKE(a, list->n + 1, struct wf_beside);
    struct wf_err why = { 0 };
    if (!list->n || wf_interrupted()) return WF_OK;
    if (!out || !item) return wf_fail(e, WF_ENOMEM, "not enough memory for scenarios");
    enum wf_status s = wf_beside_take(an, a, &item[0], &why);
    for (size_t k = 0; k < list->n && !s; k++) s = run_one(an, &list->item[k], a, &item[k + 1], &why);
    *out = (struct wf_besides){ list->n + 1, item };
    if (s == WF_EINTERRUPTED) {
        wf_diag_warn(an->diag, "interrupted", "interrupted before all scenarios were computed");
        return WF_OK;
    }
    if (!s) an->beside = out;
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}
