/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/held.h"
#include "study/node.h"
#include "study/verdict.h"
#include <math.h>

enum wf_status wf_held_find(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_nodes *nodes,
                            struct wf_err *e)
{
    const struct wf_solve_options quick = wf_nodes_quick(o);
    const struct wf_node *node;
    struct wf_at_speed at;
    struct wf_err why = { WF_OK, "" };
    for (size_t k = 0; k < WF_TIES_MAX; k++) an->held.tie[k] = NAN;
    for (size_t k = 0; k < WF_LINKS_MAX; k++) an->held.link[k] = NAN;
    if (!an->loads.ties && !an->loads.links) return WF_OK;
    const struct wf_break *loss = wf_verdict_of((const struct wf_break(*)[WF_SCOPES])an->breaks).loss;
    if (!loss || loss->critical.outcome != WF_CRITICAL_FOUND) return WF_OK;
    const double speed = loss->critical.speed;
    enum wf_status s;
    if (!wf_nodes_tracked(an))
        s = wf_speed_totals(an, o, speed, &at, &why);
    else if (!(s = wf_nodes_solve(nodes, &quick, speed, &node, &why)))
        at = node->at;
    if (s && wf_nodes_late(nodes)) return WF_OK;
    if (s) return wf_fail(e, s, "%s", why.text);
    for (size_t k = 0; k < an->loads.ties && !at.status; k++) an->held.tie[k] = at.tie[k];
    for (size_t k = 0; k < an->loads.links && !at.status; k++) an->held.link[k] = at.link[k];
    return WF_OK;
}
