/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/wetted.h"
#include "base/progress.h"
#include "data/species.h"
#include "load/interception.h"
#include "solve/modes.h"
#include "study/node.h"
#include "study/sway.h"
#include "study/verdict.h"
#include <math.h>

/* Lowest frequency about the equilibrium in still air. */
static enum wf_status sway(const struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                           double *frequency, struct wf_err *e)
{
    struct wf_loads still = an->loads;
    struct wf_err why = { 0 };
    still.wind = NULL;
    enum wf_status s = wf_modes(&an->tree, &still, o, 1, a, frequency, NULL, &why);
    if (s == WF_ENOMEM || s == WF_EINTERRUPTED) return wf_fail(e, s, "%s", why.text);
    if (s || *frequency < 0.0) *frequency = NAN; /* it does not stand */
    return WF_OK;
}

static double burden_of(const struct wf_tree *t)
{
    double sum = 0.0;
    for (size_t i = 0; i < t->n; i++) sum += 0.5 * (t->burden0[i] + t->burden1[i]) * wf_tree_length(t, i);
    return sum;
}

/* What came onto the tree. */
static enum wf_status weigh(const struct wf_analysis *wet, const struct wf_analysis *dry,
                            enum wf_burden burden, struct wf_wetted *out, struct wf_err *e)
{
    out->leaf_area = wf_tree_leaf_area(&wet->tree);
    if (burden == WF_BURDEN_WINTER) {
        out->mass = burden_of(&wet->tree) - burden_of(&dry->tree);
        return WF_OK;
    }
    out->film = wet->scenario.water;
    out->mass = out->film * out->leaf_area;
    if (out->mass > 0) return WF_OK;
    return wf_fail(e, WF_EINPUT,
                   "the tree has no leaves that could hold rain; give --leaf-area or a season with leaves");
}

static void take(const struct wf_at_speed *at, int k, struct wf_wetted *out)
{
    out->drag[k] = at->drag, out->moment[k] = at->base_moment, out->deflection[k] = at->tip_deflection;
}

/* Loads at the highest of the given winds that has a result. */
static enum wf_status load(const struct wf_analysis *wet, const struct wf_analysis *dry,
                           const struct wf_solve_options *o, struct wf_wetted *out, struct wf_err *e)
{
    struct wf_at_speed at = { 0 };
    size_t k = wet->n;
    while (k > 0 && wet->at[k - 1].status) k--;
    if (!k) return WF_OK;
    out->speed = wet->at[k - 1].speed;
    take(&wet->at[k - 1], WF_WET, out);
    enum wf_status s = wf_speed_totals(dry, o, out->speed, &at, e);
    if (!s && !at.status) take(&at, WF_DRY, out);
    return s;
}

static enum wf_status search(const struct wf_analysis *wet, const struct wf_analysis *dry,
                             const struct wf_solve_options *o, struct wf_arena *a, struct wf_wetted *out,
                             struct wf_err *e)
{
    struct wf_break(*breaks)[WF_SCOPES] = wf_arena_take(a, WF_CRITERIA, sizeof *breaks);
    wf_stage_begin(WF_SEARCH_SOLUTIONS, true, "%s: the same tree without it", wet->species->name);
    struct wf_nodes *nodes = breaks ? wf_nodes_open(dry, NULL) : NULL;
    if (!nodes) return wf_fail(e, WF_ENOMEM, "not enough memory for the dry tree");
    enum wf_status s = wf_analysis_breaks(dry, o, nodes, breaks, e);
    wf_nodes_close(nodes);
    if (s) return s;
    out->critical[WF_DRY] = wf_verdict_of((const struct wf_break(*)[WF_SCOPES])breaks).loss->critical;
    out->critical[WF_WET] = wf_verdict_of(wet->breaks).loss->critical;
    return WF_OK;
}

enum wf_status wf_wetted_compare(const struct wf_analysis *wet, enum wf_burden burden,
                                 const struct wf_solve_options *o, struct wf_arena *a, struct wf_wetted *out,
                                 struct wf_err *e)
{
    struct wf_analysis dry = *wet;
    struct wf_diag unsaid = { .arena = a };
    dry.given = NULL;         /* what is known of the wet tree's meshes */
    dry.at = NULL, dry.n = 0; /* its states */
    if (burden == WF_BURDEN_RAIN)
        dry.scenario.water = 0;
    else
        dry.scenario.snow = dry.scenario.ice = 0;
    dry.diag = &unsaid;
    dry.search.solved = NULL;
    double given[] = { wet->n ? wet->at[wet->n - 1].speed : 0.0 };
    *out = (struct wf_wetted){
        .speed = NAN, .drag = { NAN, NAN }, .moment = { NAN, NAN }, .deflection = { NAN, NAN }
    };
    enum wf_status s = wf_analysis_set_up(&dry, o, a, &unsaid, e);
    if (!s) s = wf_sway_set_up(&dry, o, given, 1, a, &unsaid, e);
    if (!s) s = weigh(wet, &dry, burden, out, e);
    if (!s) s = sway(&dry, o, a, &out->frequency[WF_DRY], e);
    if (!s) s = sway(wet, o, a, &out->frequency[WF_WET], e);
    if (!s) s = load(wet, &dry, o, out, e);
    return s ? s : search(wet, &dry, o, a, out, e);
}
