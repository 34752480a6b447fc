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

static bool corridor_known(const struct wf_tree *t, size_t row)
{
    (void)row;
    return t->room.corridor > 0;
}

/* The row's end with its radius, from the base of the stem towards the corridor. */
static double corridor_safety(const struct wf_tree *t, const struct wf_response *r,
                              const struct wf_breakage *b, size_t row, double *place)
{
    const double *to = t->room.towards, *moved = r->end + 3 * row;
    (void)b;
    *place = 1;
    if (!(t->room.corridor > 0)) return NAN;
    double reach =
        (t->x1[row] + moved[0] - t->x0[0]) * to[0] + (t->y1[row] + moved[1] - t->y0[0]) * to[1] + t->r1[row];
    return reach > 0 ? t->room.corridor / reach : INFINITY;
}

static bool tip_angle_known(const struct wf_tree *t, size_t row)
{
    return t->room.tip_angle > 0 && t->parent[row] < 0;
}

static double tip_angle_safety(const struct wf_tree *t, const struct wf_response *r,
                               const struct wf_breakage *b, size_t row, double *place)
{
    (void)b;
    *place = 0;
    if (!tip_angle_known(t, row)) return NAN;
    double turn = wf_response_slope(t, r, wf_tip_row(t));
    return turn > 0 ? t->room.tip_angle / turn : INFINITY;
}

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
                         .event = "overturns",
                         .source = OVERTURNING,
                         .validity = STATIC,
                         .loses_tree = true,
                         .whole = true,
                         .known = wf_overturning_known,
                         .safety = wf_overturning_safety },
    [WF_OVERTURNING_WET] = { .name = "overturning-saturated-high",
                             .event = "overturns",
                             .source = SATURATED,
                             .validity = "one species; 0.65 of the anchorage; " STATIC,
                             .whole = true,
                             .known = wf_overturning_known,
                             .safety = wf_overturning_safety_wet },
    [WF_OVERTURNING_WETTEST] = { .name = "overturning-saturated-low",
                                 .event = "overturns",
                                 .source = SATURATED,
                                 .validity = "one species; 0.50 of the anchorage; " STATIC,
                                 .whole = true,
                                 .known = wf_overturning_known,
                                 .safety = wf_overturning_safety_wettest },
    [WF_CORRIDOR] = { .name = "corridor",
                      .event = "reaches the corridor",
                      .source = "geometry of the bent tree",
                      .validity = "parts that are drawn, with their radius, at any height; the crown of a "
                                  "stem without branches is not",
                      .shape = true,
                      .known = corridor_known,
                      .safety = corridor_safety },
    [WF_TIP_ANGLE] = { .name = "tip-angle",
                       .event = "turns its tip to the limit",
                       .source = "geometry of the bent tree",
                       .validity = "from the unloaded shape, of a standing tree from the shape drawn",
                       .whole = true,
                       .shape = true,
                       .known = tip_angle_known,
                       .safety = tip_angle_safety },
};

enum wf_scope wf_criterion_scope(const struct wf_criterion *c)
{
    return c->section || c->whole ? WF_SCOPE_STEM : WF_SCOPE_TREE;
}

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

/* Is nothing known of any row? */
static bool unknown(const struct wf_criterion *c, const struct wf_breakage *b)
{
    return c->section && c != &wf_criteria[WF_BREAKAGE] && !b->use[c - wf_criteria];
}

/* The place nearest to failure in each scope. */
static void find_worst(const struct wf_criterion *c, const struct wf_tree *t, const struct wf_response *r,
                       const struct wf_breakage *b, struct wf_worst out[WF_SCOPES])
{
    for (size_t i = 0; i < t->n; i++) {
        double place = 0, safety = wf_criterion_safety(c, t, r, b, i, &place);
        if (isnan(safety)) continue;
        for (int s = 0; s < WF_SCOPES; s++)
            if (!(out[s].safety <= safety) && wf_scope_holds((enum wf_scope)s, t, i))
                out[s] = (struct wf_worst){ .safety = safety, .row = (int32_t)i, .place = place };
    }
}

void wf_criteria_check(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                       struct wf_worst (*worst)[WF_SCOPES])
{
    for (int c = 0; c < WF_CRITERIA; c++) {
        for (int s = 0; s < WF_SCOPES; s++) worst[c][s] = (struct wf_worst){ .safety = NAN, .row = -1 };
        if (r && !unknown(&wf_criteria[c], b)) find_worst(&wf_criteria[c], t, r, b, worst[c]);
    }
}
