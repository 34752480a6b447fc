/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/verdict_part.h"
#include "base/num.h"
#include "data/model.h"
#include "fail/anchorage.h"
#include "out/beside_part.h"
#include "out/extremes.h"
#include "out/tables.h"
#include "study/assessment.h"
#include "study/limits.h"
#include "study/unions.h"
#include "study/verdict.h"
#include <math.h>
#include <string.h>

json_t *wf_part_section(struct wf_doc *d, const struct wf_analysis *a, int32_t row, double s, double height)
{
    const struct wf_tree *t = &a->tree;
    if (row < 0 || (size_t)row >= t->n) return json_null();
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "segment", (size_t)row + 1);
    wf_doc_count(d, o, "level", t->level[row] > 0 ? (size_t)t->level[row] : 0);
    wf_doc_text(d, o, "part", wf_model_level_name(a->model, a->species, t->level[row]));
    wf_doc_count(d, o, "id", t->id[row] > 0 ? (size_t)t->id[row] : 0);
    wf_doc_quantity(d, o, "diameter", wf_tree_thickness(t, (size_t)row, s), "m", NULL);
    wf_doc_quantity(d, o, "position", s, "1", "the segment as a whole is named");
    wf_doc_quantity(d, o, "height", height, "m", NULL);
    wf_doc_quantity(d, o, "weight_stress", a->still ? a->still->breakage.peak[row] : NAN, "Pa",
                    "the state at rest was not computed");
    return o;
}

/* Outcome, mean and gust of a critical wind, and where it fails. */
static void put_critical(struct wf_doc *d, json_t *o, const struct wf_analysis *a, const struct wf_break *b)
{
    const struct wf_critical *c = &b->critical;
    const char *text = wf_critical_text(c->outcome);
    wf_doc_text(d, o, "outcome", wf_part_outcome(c->outcome));
    wf_doc_text(d, o, "outcome_text", text);
    wf_doc_quantity(d, o, "critical_speed", c->speed, "m/s", text);
    wf_doc_quantity(d, o, "critical_gust", wf_scenario_gust(&a->scenario, c->speed), "m/s", text);
    wf_doc_flag(d, o, "within_limits", !(c->outcome == WF_CRITICAL_FOUND && wf_limits_small_passed(&b->at)));
    wf_doc_quantity(d, o, "speed_low", c->speed_low, "m/s", text);
    wf_doc_quantity(d, o, "speed_high", c->speed_high, "m/s", text);
}

json_t *wf_part_loss(struct wf_doc *d, const struct wf_analysis *a,
                     const struct wf_break (*breaks)[WF_SCOPES])
{
    struct wf_verdict v = wf_verdict_of(breaks);
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "criterion", v.loss ? wf_criteria[v.criterion].name : NULL);
    if (v.loss) put_critical(d, o, a, v.loss);
    return o;
}

static double own_safety(const struct wf_at_speed *at, int criterion)
{
    return at ? at->worst[criterion][wf_criterion_scope(&wf_criteria[criterion])].safety : (double)NAN;
}

/* The criteria that lose the tree, those that bound them and those of its movement, each with its result. */
static json_t *criteria(struct wf_doc *d, const struct wf_analysis *a, const struct wf_verdict *v)
{
    json_t *list = wf_doc_array(d);
    const struct wf_at_speed *at = wf_verdict_wind(a);
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_break *b = &a->breaks[c][wf_criterion_scope(&wf_criteria[c])];
        if (!(wf_criteria[c].loses_tree || !wf_criteria[c].section) ||
            b->critical.outcome == WF_CRITICAL_NO_STRENGTH)
            continue;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "criterion", wf_criteria[c].name);
        wf_doc_flag(d, o, "loses_tree", wf_criteria[c].loses_tree);
        wf_doc_flag(d, o, "governs", b == v->loss);
        put_critical(d, o, a, b);
        wf_doc_quantity(d, o, "height", b->height, "m", "no place is known");
        wf_doc_quantity(d, o, "safety", own_safety(at, c), "1", "unloaded, or no equilibrium was found");
        wf_doc_text(d, o, "source", wf_criteria[c].source);
        wf_doc_text(d, o, "validity", wf_criteria[c].validity);
    }
    return list;
}

static json_t *not_assessed(struct wf_doc *d, const struct wf_analysis *a, const struct wf_verdict *v)
{
    json_t *list = wf_doc_array(d);
    for (int c = 0; c < WF_CRITERIA; c++) {
        const char *why = wf_verdict_unassessed(a, v, (enum wf_criterion_id)c);
        if (!why) continue;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "criterion", wf_criteria[c].name);
        wf_doc_text(d, o, "reason", why);
        bool unsaid = c == WF_OVERTURNING && !strcmp(why, WF_ANCHORAGE_UNSAID);
        wf_doc_flag(d, o, "unsaid", unsaid);
    }
    const struct {
        bool is;
        const char *name, *why;
    } others[] = { { wf_verdict_size(a) > 0, "size-effect", WF_SIZE_UNASSESSED },
                   { wf_verdict_any_soil(a), "soil", WF_SOIL_UNASSESSED } };
    for (size_t k = 0; k < WF_COUNT(others); k++) {
        if (!others[k].is) continue;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "criterion", others[k].name);
        wf_doc_text(d, o, "reason", others[k].why);
        wf_doc_flag(d, o, "unsaid", false);
    }
    return list;
}

static json_t *anchorage(struct wf_doc *d, const struct wf_anchorage *q)
{
    if (!q || !q->method) return json_null();
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "name", q->method->name);
    wf_doc_text(d, o, "title", q->method->title);
    wf_doc_text(d, o, "source", q->method->source);
    wf_doc_text(d, o, "validity", q->method->validity);
    wf_doc_text(d, o, "text", q->text);
    wf_doc_said(d, o, q->said);
    wf_doc_flag(d, o, "counts_self_weight", q->method->counts_self_weight);
    wf_doc_quantity(d, o, "moment", q->moment, "N m", NULL);
    wf_doc_quantity(d, o, "moment_by_method", q->by_method, "N m", NULL);
    wf_doc_quantity(d, o, "moment_carried", q->carried > 0 ? q->carried : (double)NAN, "N m",
                    "no test put a moment on the root");
    wf_doc_number(d, o, "scatter", q->scatter);
    wf_doc_number(d, o, "saturated_low", WF_SATURATED_LOW);
    wf_doc_number(d, o, "saturated_high", WF_SATURATED_HIGH);
    return o;
}

static json_t *branches(struct wf_doc *d, const struct wf_analysis *a)
{
    struct wf_branch_class k[WF_BRANCH_CLASSES];
    const struct wf_at_speed *at = wf_verdict_wind(a);
    json_t *list = wf_doc_array(d);
    for (size_t i = 0, n = wf_branch_classes(a, k); i < n; i++) {
        if (!k[i].segments) continue;
        const struct wf_worst *w = &k[i].worst;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_quantity(d, o, "thickness_low", k[i].from, "m", NULL);
        wf_doc_quantity(d, o, "thickness_high", k[i].to, "m", "no bound");
        wf_doc_count(d, o, "segments", k[i].segments);
        wf_doc_text(d, o, "criterion", w->row < 0 ? NULL : wf_criteria[k[i].criterion].name);
        wf_doc_quantity(d, o, "safety", at ? w->safety : (double)NAN, "1",
                        "no strength is known, or unloaded");
        wf_doc_quantity(d, o, "fails_at", k[i].fails, "m/s", "it stands the given winds");
        wf_doc_put(d, o, "governing_section",
                   wf_part_section(d, a, w->row, w->place, wf_part_height(&a->tree, w->row, w->place)));
    }
    return list;
}

json_t *wf_part_verdict(struct wf_doc *d, const struct wf_analysis *a)
{
    struct wf_verdict v = wf_verdict_of(a->breaks);
    const struct wf_at_speed *at = wf_verdict_wind(a);
    enum wf_criterion_id nearest = v.criterion;
    json_t *o = wf_part_loss(d, a, a->breaks);
    double safety = at ? wf_verdict_safety(at, &nearest) : (double)NAN;
    wf_doc_quantity(d, o, "speed", at ? at->speed : (double)NAN, "m/s", "no given wind has a solution");
    wf_doc_quantity(d, o, "safety", safety, "1", "no resistance is known, or nothing is loaded");
    wf_doc_text(d, o, "safety_criterion", isnan(safety) ? NULL : wf_criteria[nearest].name);
    wf_doc_put(d, o, "criteria", criteria(d, a, &v));
    wf_doc_put(d, o, "not_assessed", not_assessed(d, a, &v));
    wf_doc_put(d, o, "anchorage", anchorage(d, a->anchorage));
    wf_doc_quantity(d, o, "branches_from", a->search.branches_from, "m", NULL);
    wf_doc_put(d, o, "thicknesses", branches(d, a));
    return o;
}

/* ---- Unions ---- */

static json_t *union_part(struct wf_doc *d, const struct wf_analysis *a, const struct wf_union *u)
{
    json_t *o = wf_doc_object(d);
    wf_doc_put(d, o, "branch", wf_part_section(d, a, u->branch, 0, u->height));
    wf_doc_put(d, o, "above", wf_part_section(d, a, u->above, 0, u->height));
    wf_doc_quantity(d, o, "height", u->height, "m", NULL);
    wf_doc_quantity(d, o, "branch_diameter", u->branch_diameter, "m", NULL);
    wf_doc_quantity(d, o, "above_diameter", u->above_diameter, "m", NULL);
    wf_doc_quantity(d, o, "below_diameter", u->below_diameter, "m", "they part at the ground");
    wf_doc_number(d, o, "aspect_ratio", u->ratio);
    wf_doc_text(d, o, "kind", u->in->name);
    return o;
}

json_t *wf_part_unions(struct wf_doc *d, const struct wf_analysis *a)
{
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "number", a->unions->n);
    wf_doc_text(d, o, "text", WF_UNIONS_UNASSESSED);
    wf_doc_text(d, o, "source", WF_UNIONS_SOURCE);
    json_t *list = wf_doc_put(d, o, "union_classes", wf_doc_array(d));
    for (size_t k = 0; k < WF_UNION_CLASSES; k++) {
        json_t *x = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, x, "kind", wf_union_classes[k].name);
        wf_doc_text(d, x, "text", wf_union_classes[k].text);
        wf_doc_number(d, x, "ratio_from", wf_union_classes[k].from);
        wf_doc_count(d, x, "number", wf_unions_of(a->unions, &wf_union_classes[k]));
    }
    list = wf_doc_put(d, o, "largest_unions", wf_doc_array(d));
    for (size_t k = 0; k < a->unions->n && k < WF_UNIONS_SHOWN; k++)
        wf_doc_add(d, list, union_part(d, a, &a->unions->item[k]));
    return o;
}

/* ---- Is the safety enough? ---- */

static json_t *safety_part(struct wf_doc *d, const struct wf_assess_part *p)
{
    json_t *o = wf_doc_object(d);
    wf_doc_quantity(d, o, "safety", p->safety, "1", "not assessed");
    wf_doc_text(d, o, "criterion", isnan(p->safety) ? NULL : wf_criteria[p->criterion].name);
    wf_doc_quantity(d, o, "height", p->height, "m", "no place is known");
    wf_doc_quantity(d, o, "from", p->from, "rad", "the same from all directions");
    return o;
}

/* The least by each criterion that is assessed. */
static json_t *least_part(struct wf_doc *d, const struct wf_assess_part *least)
{
    json_t *list = wf_doc_array(d);
    for (int c = 0; c < WF_CRITERIA; c++)
        if (isfinite(least[c].safety)) wf_doc_add(d, list, safety_part(d, &least[c]));
    return list;
}

static json_t *reasons_part(struct wf_doc *d, unsigned because, unsigned lost_by)
{
    char lost[60];
    json_t *list = wf_doc_array(d);
    for (unsigned k = 0; wf_assess_reasons[k]; k++)
        if (because & (1U << k)) {
            json_t *o = wf_doc_add(d, list, wf_doc_object(d));
            wf_doc_text(d, o, "reason", wf_assess_reasons[k]);
        }
    for (int c = 0; c < WF_CRITERIA; c++)
        if (lost_by & (1U << c)) {
            json_t *o = wf_doc_add(d, list, wf_doc_object(d));
            (void)snprintf(lost, sizeof lost, "lost-by-%s", wf_criteria[c].name);
            wf_doc_text(d, o, "reason", lost);
        }
    return list;
}

static void put_scenarios(struct wf_doc *d, json_t *o, const struct wf_assessment *x)
{
    wf_doc_put(d, o, "scenarios", wf_part_beside(d, x->scenarios, x->scenario));
    wf_doc_number(d, o, "least_reduction", x->reduction);
    wf_doc_number(d, o, "least_reduction_tried", x->reduction_most > 0 ? x->reduction_most : (double)NAN);
    wf_doc_text(d, o, "least_reduction_unknown", x->reduction_unknown);
    wf_doc_number(d, o, "least_reduction_cut", isfinite(x->reduction) ? x->reduction_cut : (double)NAN);
}

const char *wf_assess_chance(const struct wf_assessment *x, double p, char text[static 40])
{
    char share[32];
    const char *bound = x->years_most ? "< " : x->years_least ? "> " : "";
    const char *said = wf_extremes_share(p, share);
    (void)snprintf(text, 40, "%s%s", *said == '<' || *said == '>' ? "" : bound, said);
    return text;
}

/* Where a bound of the band of return periods lies; NULL: there is no band. */
static const char *bound_word(double years)
{
    if (isnan(years)) return NULL;
    return isinf(years) ? "longer" : years > 0 ? "equal" : "shorter";
}

/* How often the critical wind blows. */
static void put_often(struct wf_doc *d, json_t *o, const struct wf_assessment *x)
{
    char text[40];
    bool known = isfinite(x->exceedance);
    wf_doc_text(d, o, "return_period_by", x->years_by);
    const double band[] = { x->years_low, x->years_high };
    static const char *const ends[] = { "return_period_low", "return_period_high" };
    static const char *const bounds[] = { "return_period_low_bound", "return_period_high_bound" };
    for (size_t k = 0; k < WF_COUNT(band); k++) {
        wf_doc_number(d, o, ends[k], isfinite(band[k]) && band[k] > 0 ? band[k] : (double)NAN);
        wf_doc_text(d, o, bounds[k], bound_word(band[k]));
    }
    wf_doc_number(d, o, "exceedance_a_year", x->exceedance);
    wf_doc_text(d, o, "exceedance_a_year_text", known ? wf_assess_chance(x, x->exceedance, text) : NULL);
    wf_doc_number(d, o, "exceedance_over_life", x->over_life);
    wf_doc_text(d, o, "exceedance_over_life_text", known ? wf_assess_chance(x, x->over_life, text) : NULL);
    wf_doc_number(d, o, "life_years", x->life);
    bool low = isfinite(x->exceedance_low);
    const struct wf_assessment end = { .years_most = x->exceedance_low <= 1e-6 };
    wf_doc_number(d, o, "exceedance_at_low_end", x->exceedance_low);
    wf_doc_text(d, o, "exceedance_at_low_end_text",
                low ? wf_assess_chance(&end, x->exceedance_low, text) : NULL);
}

json_t *wf_part_assessment(struct wf_doc *d, const struct wf_assessment *x)
{
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "word", wf_assess_rows[x->word].name);
    wf_doc_put(d, o, "because", reasons_part(d, x->because, x->lost_by));
    wf_doc_number(d, o, "required", x->required);
    wf_doc_quantity(d, o, "speed", x->speed, "m/s", NULL);
    wf_doc_put(d, o, "breakage", safety_part(d, &x->breakage));
    wf_doc_put(d, o, "overturning", safety_part(d, &x->overturning));
    wf_doc_put(d, o, "criteria", least_part(d, x->least));
    wf_doc_quantity(d, o, "sound", x->sound, "1", "not assessed");
    wf_doc_number(d, o, "saturated_low", x->wet_low);
    wf_doc_number(d, o, "saturated_high", x->wet_high);
    wf_doc_number(d, o, "low", x->low);
    wf_doc_number(d, o, "high", x->high);
    wf_doc_quantity(d, o, "return_period", x->years, "year", x->years_unknown);
    wf_doc_text(d, o, "return_period_bound",
                isnan(x->years)  ? NULL
                : x->years_most  ? "more"
                : x->years_least ? "less"
                                 : "equal");
    put_often(d, o, x);
    wf_doc_quantity(d, o, "from", x->from, "rad", "the same from all directions");
    wf_doc_flag(d, o, "from_specified", x->one);
    wf_doc_put(d, o, "directions", wf_part_around(d, x->directions, x->direction));
    put_scenarios(d, o, x);
    if (x->record) wf_doc_warnings(d, wf_doc_put(d, o, "record", wf_doc_array(d)), x->record);
    return o;
}
