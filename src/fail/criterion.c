/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fail/fail.h"
#include <math.h>

#define TUBE                                                                                                 \
    "closed rings with a wall below 0.3 of the mean radius; diaphragms of culms are left out, which would "  \
    "stiffen them"
#define OVERTURNING "statics of the whole tree; the anchorage has a source of its own"
#define SATURATED "camphor near saturation, 35 to 50 % less: Forests 2022, 13:1875"
#define STATIC                                                                                               \
    "static, an upper bound in a gale: gusts loosen roots; the moment is that of the bent tree with its "    \
    "weight"

const struct wf_criterion wf_criteria[WF_CRITERIA] = {
    [WF_BREAKAGE] = { .name = "breakage",
                      .event = "breaks",
                      .source = "elementary bending: Timoshenko S. 1955. Strength of Materials I",
                      .validity = "sound, round stems and branches; torsion is not included",
                      .loses_tree = true,
                      .wants = "modulus_of_rupture",
                      .section = &wf_section_rules[WF_RULE_BENDING] },
    [WF_ELASTIC_LIMIT] = { .name = "elastic-limit",
                           .event = "yields",
                           .source =
                               "arborists' statics: the compressed side yields first; Detter et al. 2015, "
                               "quoted by sag-baumstatik.org",
                           .validity =
                               "green wood; the compressive strength of standard tests is taken as the "
                               "limit; a required safety of 1.5 is this program's rule",
                           .required = 1.5,
                           .wants = "compressive_strength",
                           .section = &wf_section_rules[WF_RULE_ELASTIC] },
    [WF_TORSION] = { .name = "torsion",
                     .event = "breaks, bent and twisted,",
                     .source = "quadratic interaction of bending and shear stress (assumed)",
                     .validity = "sound, round stems and branches",
                     .loses_tree = true,
                     .wants = "modulus_of_rupture",
                     .section = &wf_section_rules[WF_RULE_TORSION] },
    [WF_SPLITTING] = { .name = "splitting",
                       .event = "splits",
                       .source =
                           "bending of a flattened ring, docs/failure.md; modes of Huang et al. 2017, R. "
                           "Soc. Open Sci. 4:160972",
                       .validity = TUBE,
                       .loses_tree = true,
                       .wants = "tangential_strength",
                       .section = &wf_section_rules[WF_RULE_SPLITTING] },
    [WF_OVALISATION] = { .name = "ovalisation",
                         .event = "flattens",
                         .source =
                             "Brazier's limit of an orthotropic tube, docs/failure.md; modes of Huang et "
                             "al. 2017, R. Soc. Open Sci. 4:160972",
                         .validity = TUBE,
                         .loses_tree = true,
                         .wants = "tangential_modulus",
                         .section = &wf_section_rules[WF_RULE_OVALISATION] },
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

bool wf_criterion_knows(const struct wf_criterion *c, const struct wf_tree *t, size_t row)
{
    return c->section ? c->section->known(t, row) : c->known(t, row);
}

double wf_criterion_safety(const struct wf_criterion *c, const struct wf_tree *t, const struct wf_response *r,
                           const struct wf_breakage *b, size_t row, double *place)
{
    size_t id = (size_t)(c - wf_criteria);
    if (!c->section) return c->safety(t, r, b, row, place);
    if (id == WF_BREAKAGE) {
        *place = b->peak_place[row];
        return wf_safety_factor(t->strength[row], b->peak[row]);
    }
    if (!b->use[id] || isnan(b->use[id][row])) return NAN;
    *place = b->use_place[id][row];
    return wf_safety_factor(1, b->use[id][row]);
}

double wf_criterion_resistance(const struct wf_criterion *c, const struct wf_tree *t,
                               const struct wf_worst *at)
{
    return c->section && at->row >= 0 ? c->section->resistance(t, (size_t)at->row, at->place) : NAN;
}

bool wf_criterion_applies(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope)
{
    for (size_t i = 0; i < t->n; i++)
        if (wf_scope_holds(scope, t, i) && (!c->section || !c->section->applies || c->section->applies(t, i)))
            return true;
    return false;
}

bool wf_criterion_known(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope)
{
    for (size_t i = 0; i < t->n; i++)
        if (wf_scope_holds(scope, t, i) && wf_criterion_knows(c, t, i)) return true;
    return false;
}

/* The place nearest to failure in a scope. */
static void find_worst(const struct wf_criterion *c, const struct wf_tree *t, const struct wf_response *r,
                       const struct wf_breakage *b, enum wf_scope scope, struct wf_worst *out)
{
    for (size_t i = 0; i < t->n; i++) {
        double place = 0,
               safety = wf_scope_holds(scope, t, i) ? wf_criterion_safety(c, t, r, b, i, &place) : NAN;
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
