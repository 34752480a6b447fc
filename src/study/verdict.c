/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/verdict.h"
#include <math.h>

double wf_verdict_bound(const struct wf_critical *c)
{
    switch (c->outcome) {
    case WF_CRITICAL_FOUND:
        return c->speed;
    case WF_CRITICAL_SELF_WEIGHT:
        return 0;
    case WF_CRITICAL_ABOVE:
        return c->speed_high;
    case WF_CRITICAL_UNSOLVED:
    case WF_CRITICAL_UNSEARCHED:
    case WF_CRITICAL_INTERRUPTED:
        return c->speed_low;
    case WF_CRITICAL_NO_STRENGTH:
        break;
    }
    return INFINITY;
}

struct wf_verdict wf_verdict_of(const struct wf_break (*breaks)[WF_SCOPES])
{
    struct wf_verdict v = { .loss = NULL };
    double lowest = INFINITY;
    for (int c = 0; c < WF_CRITERIA; c++) {
        if (!wf_criteria[c].loses_tree) continue;
        const struct wf_break *b = &breaks[c][WF_SCOPE_STEM];
        double bound = wf_verdict_bound(&b->critical);
        v.assessed[c] = b->critical.outcome != WF_CRITICAL_NO_STRENGTH;
        if (v.loss && !(bound < lowest)) continue;
        v.loss = b, v.criterion = (enum wf_criterion_id)c, lowest = bound;
    }
    return v;
}
