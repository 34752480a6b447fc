/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fail/fail.h"
#include <math.h>

#define OVERTURNING "statics of the whole tree; the anchorage has a source of its own"
#define SATURATED "camphor near saturation, 35 to 50 % less: Forests 2022, 13:1875"
#define STATIC                                                                                               \
    "static, an upper bound in a gale: gusts loosen roots; the moment is that of the bent tree with its "    \
    "weight"

const struct wf_criterion wf_criteria[WF_CRITERIA] = {
    [WF_BREAKAGE] = { .name = "breakage",
                      .source = "elementary bending: Timoshenko S. 1955. Strength of Materials I",
                      .validity =
                          "sound, round stems and branches; shear stress and torsion are not included",
                      .loses_tree = true,
                      .known = wf_breakage_known,
                      .safety = wf_breakage_safety },
    [WF_OVERTURNING] = { .name = "overturning",
                         .source = OVERTURNING,
                         .validity = STATIC,
                         .loses_tree = true,
                         .whole = true,
                         .known = wf_overturning_known,
                         .safety = wf_overturning_safety },
    [WF_OVERTURNING_WET] = { .name = "overturning-saturated-high",
                             .source = SATURATED,
                             .validity = "one species; 0.65 of the anchorage; " STATIC,
                             .whole = true,
                             .known = wf_overturning_known,
                             .safety = wf_overturning_safety_wet },
    [WF_OVERTURNING_WETTEST] = { .name = "overturning-saturated-low",
                                 .source = SATURATED,
                                 .validity = "one species; 0.50 of the anchorage; " STATIC,
                                 .whole = true,
                                 .known = wf_overturning_known,
                                 .safety = wf_overturning_safety_wettest },
};

bool wf_criterion_known(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope)
{
    for (size_t i = 0; i < t->n; i++)
        if (wf_scope_holds(scope, t, i) && c->known(t, i)) return true;
    return false;
}

/* The place nearest to failure in a scope. */
static void find_worst(const struct wf_criterion *c, const struct wf_tree *t, const struct wf_response *r,
                       const struct wf_breakage *b, enum wf_scope scope, struct wf_worst *out)
{
    for (size_t i = 0; i < t->n; i++) {
        double place = 0, safety = wf_scope_holds(scope, t, i) ? c->safety(t, r, b, i, &place) : NAN;
        if (isnan(safety) || out->safety <= safety) continue;
        *out = (struct wf_worst){ .safety = safety, .row = (int32_t)i, .place = place };
    }
}

void wf_criteria_check(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                       struct wf_worst (*worst)[WF_SCOPES])
{
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++) {
            worst[c][s] = (struct wf_worst){ .safety = NAN, .row = -1 };
            if (r) find_worst(&wf_criteria[c], t, r, b, (enum wf_scope)s, &worst[c][s]);
        }
}
