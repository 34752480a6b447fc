/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/wetted.h"
#include "base/progress.h"
#include "data/species.h"
#include "load/interception.h"
#include "solve/modes.h"
#include "study/node.h"
#include "study/sway.h"
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
    if (s) *frequency = NAN;
    return WF_OK;
}

enum wf_status wf_wetted_compare(const struct wf_analysis *wet, const struct wf_solve_options *o,
                                 struct wf_arena *a, struct wf_wetted *out, struct wf_err *e)
{
    struct wf_analysis dry = *wet;
    struct wf_diag unsaid = { .arena = a };
    struct wf_break(*breaks)[WF_SCOPES] = wf_arena_take(a, WF_CRITERIA, sizeof *breaks);
    struct wf_at_speed at = { 0 };
    if (!breaks) return wf_fail(e, WF_ENOMEM, "not enough memory for the dry tree");
    dry.scenario.water = 0;
    dry.diag = &unsaid;
    dry.search.solved = NULL;
    double given[] = { wet->n ? wet->at[wet->n - 1].speed : 0.0 };
    enum wf_status s = wf_analysis_set_up(&dry, a, &unsaid, e);
    if (!s) s = wf_sway_set_up(&dry, o, given, 1, a, &unsaid, e);
    if (s) return s;
    *out = (struct wf_wetted){ .film = wet->scenario.water,
                               .leaf_area = wf_tree_leaf_area(&wet->tree),
                               .speed = NAN,
                               .moment = { NAN, NAN },
                               .deflection = { NAN, NAN } };
    out->mass = out->film * out->leaf_area;
    if (!(out->mass > 0))
        return wf_fail(
            e, WF_EINPUT,
            "the tree has no leaves that could hold rain; give --leaf-area or a season with leaves");
    if ((s = sway(&dry, o, a, &out->frequency[WF_DRY], e)) ||
        (s = sway(wet, o, a, &out->frequency[WF_WET], e)))
        return s;
    for (size_t k = wet->n; k-- > 0 && isnan(out->speed);)
        if (!wet->at[k].status)
            out->speed = wet->at[k].speed, out->moment[WF_WET] = wet->at[k].base_moment,
            out->deflection[WF_WET] = wet->at[k].tip_deflection;
    if (!isnan(out->speed)) {
        if ((s = wf_speed_totals(&dry, o, out->speed, &at, e))) return s;
        if (!at.status) out->moment[WF_DRY] = at.base_moment, out->deflection[WF_DRY] = at.tip_deflection;
    }
    wf_stage_begin(WF_SEARCH_SOLUTIONS, true, "%s: the same tree dry", wet->species->name);
    struct wf_nodes *nodes = wf_nodes_open(&dry, NULL);
    if (!nodes) return wf_fail(e, WF_ENOMEM, "not enough memory for the dry tree");
    s = wf_analysis_breaks(&dry, o, nodes, breaks, e);
    wf_nodes_close(nodes);
    if (s) return s;
    out->critical[WF_DRY] = breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    out->critical[WF_WET] = wet->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    return WF_OK;
}
