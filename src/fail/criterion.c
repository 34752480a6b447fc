/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fail/fail.h"
#include <math.h>

const struct wf_criterion wf_criteria[WF_CRITERIA] = {
    [WF_BREAKAGE] = { .name = "breakage",
                      .source = "elementary bending: Timoshenko S. 1955. Strength of Materials I",
                      .validity =
                          "sound, round stems and branches; shear stress and torsion are not included",
                      .known = wf_breakage_known,
                      .utilisation = wf_breakage_utilisation },
};

bool wf_criterion_known(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope)
{
    for (size_t i = 0; i < t->n; i++)
        if (wf_scope_holds(scope, t, i) && c->known(t, i)) return true;
    return false;
}

void wf_criteria_check(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                       struct wf_worst (*worst)[WF_SCOPES])
{
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++) {
            worst[c][s] = (struct wf_worst){ .safety = NAN, .row = -1 };
            if (r) wf_criteria[c].utilisation(t, r, b, (enum wf_scope)s, &worst[c][s]);
        }
}
