/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_print.h"
#include "cmd/analyze_print.h"
#include "cmd/option.h"
#include "cmd/print_measures.h"
#include "data/model.h"
#include "data/species.h"
#include "fail/anchorage.h"
#include "grow/silhouette.h"
#include "out/verdict_part.h"
#include "study/interval.h"
#include "study/peak.h"
#include "study/verdict.h"
#include "wind/category.h"
#include "wind/design.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double degrees(double rad) { return rad * 180.0 / M_PI; }
/* Where a wind comes from, to a tenth of a degree. */
static double compass(double rad) { return fmod(round(10 * degrees(rad)) / 10 + 360, 360); }

static void print_number(FILE *to, int width, double x)
{
    if (isfinite(x))
        wf_show(to, "%*.*f", width, x < 10 ? 2 : 1, x);
    else
        wf_show(to, "%*s", width, isinf(x) ? "> 100" : "-");
}

/* A safety, on the side of 1 and of the required one that it is on: 1.497 and not 1.50. */
static const char *safety_text(double x, double required, char out[static 32])
{
    int digits = x < 10 ? 2 : 1;
    double shown = NAN;
    for (; digits < 8 && isnan(shown); digits++) {
        (void)snprintf(out, 32, "%.*f", digits, x);
        double at = strtod(out, NULL);
        if ((at < required) == (x < required) && (at < 1) == (x < 1) && (at > 1) == (x > 1)) shown = at;
    }
    return out;
}

static void print_safety(FILE *to, int width, double x, double required)
{
    char text[32];
    if (isfinite(x))
        wf_show(to, "%*s", width, safety_text(x, required, text));
    else
        print_number(to, width, x);
}

static void print_tree(FILE *to, const struct wf_analysis *an)
{
    const struct wf_outline_size seen = wf_silhouette_size(an->model, an->tallness);
    wf_show(to, "%s: %s, %s\n", an->model->name, an->species->name,
            an->species->latin ? an->species->latin : an->species->key);
    wf_show(to, "  height %.4g m", an->tallness);
    if (isfinite(seen.centre))
        wf_show(to, "; crown from the side %.4g m2, its centre at %.3g m", seen.area, seen.centre);
    if (an->model->lean > 0) wf_show(to, "; leans %.3g deg", degrees(an->model->lean));
    wf_show(to, "%s\n", an->model->season == WF_LEAF_OFF ? "; without leaves" : "");
    for (size_t k = 0; k < an->model->cavities; k++)
        wf_show(
            to,
            an->model->cavity[k].to_assumed
                ? "  cavity at %.4g m: taken from %.4g to %.4g m above the ground, the upper end is assumed\n"
                : "  cavity at %.4g m: from %.4g to %.4g m above the ground\n",
            an->model->cavity[k].at, an->model->cavity[k].from, an->model->cavity[k].to);
}

static void print_wind(FILE *to, const struct wf_analysis *an)
{
    const struct wf_scenario *s = &an->scenario;
    const struct wf_wind_place at = wf_scenario_place(s);
    double speed = an->assessment->speed;
    wf_show(
        to,
        "  wind: %s%s%.1f m/s 10-min mean at %.4g m over terrain %s, 3-s gust %.1f m/s; load of gusts: %s",
        s->design ? s->design->title : "", s->design ? ", " : "", speed, at.height, at.terrain->name,
        wf_scenario_gust(s, speed), an->peak ? an->peak->method->name : "none");
    if (s->snow > 0)
        wf_show(to, "\n        with snow on the crown, %.3g kg/m2 of its area from above", s->snow);
    if (s->ice > 0) wf_show(to, "\n        with %.3g mm of ice on what is drawn", 1e3 * s->ice);
    if (s->winter < 1)
        wf_show(to, "\n        of all winds named here %.3g %% blows while it is on the tree",
                100 * s->winter);
    double there = wf_scenario_speed(s, speed);
    if (there != speed)
        wf_show(to, "\n        at the tree, terrain %s, %.1f m/s at %.4g m", s->category->name, there,
                s->reference_height);
    wf_show(to, "\n");
}

/* Is a safety less in wind from another direction than the assessment's? */
static bool is_elsewhere(const struct wf_assessment *x, const struct wf_assess_part *p)
{
    return isfinite(p->from) && p->from != x->from;
}

/* By what the tree is lost: the least safety of all directions, and where that wind comes from. */
static void print_losers(FILE *to, const struct wf_assessment *x)
{
    char text[32];
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_assess_part *p = &x->least[c];
        if (!(x->lost_by & (1U << c))) continue;
        const char *safety = safety_text(p->safety, x->required, text);
        if (is_elsewhere(x, p))
            wf_show(to, "    it is lost by %s: safety %s in wind from %.4g deg\n", wf_criteria[c].name,
                    safety, compass(p->from));
        else
            wf_show(to, "    it is lost by %s: safety %s\n", wf_criteria[c].name, safety);
    }
}

/* One reason a line. */
static void print_reasons(FILE *to, const struct wf_analysis *an)
{
    const struct wf_assessment *x = an->assessment;
    char text[32], high[32];
    print_losers(to, x);
    if (x->because & WF_ASSESS_NO_EQUILIBRIUM)
        wf_show(to, "    the tree has no equilibrium in this wind: it goes down in the computation\n");
    if (x->because & WF_ASSESS_LOW_END)
        wf_show(to, "    at the low end of the interval the safety is %s, %s the required %.6g\n",
                safety_text(x->low, x->required, text),
                x->high < x->required ? "as at its high end below" : "below", x->required);
    if (x->because & WF_ASSESS_WET)
        wf_show(to,
                x->wet_high < 1 ? "    in saturated soil it overturns: safety %s to %s\n"
                                : "    in saturated soil it may overturn: safety %s to %s\n",
                safety_text(x->wet_low, x->required, text), safety_text(x->wet_high, x->required, high));
    if (x->because & WF_ASSESS_NO_OVERTURNING)
        wf_show(to, "    overturning is not assessed: this says nothing of the roots\n");
    if (x->because & WF_ASSESS_NO_STRENGTH)
        wf_show(
            to,
            "    the species has no strength: breakage is not assessed, and nothing here says that the stem "
            "holds\n");
    if (x->because & WF_ASSESS_NO_ELASTIC)
        wf_show(to, "    the species has no compressive strength: breakage is by the modulus of rupture, "
                    "which is up to twice as high\n");
    if (x->because & WF_ASSESS_WINTER)
        wf_show(
            to,
            "    with what is on it in %.0f %% of this wind: without, in the whole of it, it is not assessed "
            "here\n",
            100 * an->scenario.winter);
    if (x->because & WF_ASSESS_NO_INTERVAL) wf_show(to, "    how sure it is was not computed\n");
}

static void print_safeties(FILE *to, const struct wf_assessment *x)
{
    wf_show(to, "\n%24s%10s%10s%10s%16s\n", "safety", "now", "sound", "required", "90 % between");
    const double q = x->required;
    char low[32], high[32];
    wf_show(to, "%24s", "against breakage");
    print_safety(to, 10, x->breakage.safety, q);
    print_safety(to, 10, x->sound, q);
    wf_show(to, "%10.6g\n%24s", q, "against overturning");
    if (isnan(x->overturning.safety)) {
        wf_show(to, "%34s\n", "not assessed");
    } else {
        print_safety(to, 10, x->overturning.safety, q);
        wf_show(to, "%10s%10.6g\n%24s%10s to %s\n", "", q, "in saturated soil",
                safety_text(x->wet_low, q, low), safety_text(x->wet_high, q, high));
    }
    wf_show(to, "%24s", isnan(x->overturning.safety) ? "least" : "least, not saturated");
    print_safety(to, 10, isnan(x->breakage.safety) ? NAN : fmin(x->breakage.safety, x->overturning.safety),
                 q);
    wf_show(to, "%20s", "");
    if (isfinite(x->low))
        wf_show(to, "%9s to %s\n", safety_text(x->low, q, low), safety_text(x->high, q, high));
    else
        wf_show(to, "%16s\n", "-");
}

/* Of which wind the critical wind is, and what is less in wind from elsewhere. */
static void print_direction(FILE *to, const struct wf_assessment *x)
{
    if (!x->directions) return;
    if (x->one)
        wf_show(to,
                "  wind from %.4g deg, as specified: safeties, critical wind and interval are of it alone\n",
                compass(x->from));
    else
        wf_show(
            to,
            "  governing direction: wind from %.4g deg, in which the tree is lost first: critical wind and "
            "interval are of it, safeties the least of all %zu directions\n",
            compass(x->from), x->directions);
    if (is_elsewhere(x, &x->breakage))
        wf_show(to, "    least against breakage in wind from %.4g deg\n", compass(x->breakage.from));
    if (is_elsewhere(x, &x->overturning))
        wf_show(to, "    least against overturning in wind from %.4g deg\n", compass(x->overturning.from));
}

static void print_governing(FILE *to, const struct wf_analysis *an)
{
    const struct wf_assess_part *p = &an->assessment->breakage;
    if (p->row >= 0)
        wf_show(to, "  governing section: %.2f m above the ground, %.3g mm thick; the stem %s there (%s)\n",
                p->height, 2e3 * an->tree.r0[p->row], wf_criteria[p->criterion].event,
                wf_criteria[p->criterion].name);
    print_direction(to, an->assessment);
}

static void print_critical(FILE *to, const struct wf_analysis *an)
{
    struct wf_verdict v = wf_verdict_of(an->breaks);
    const struct wf_critical *c = &v.loss->critical;
    const struct wf_wind_place at = wf_scenario_place(&an->scenario);
    wf_show(to, "  critical wind: ");
    if (c->outcome == WF_CRITICAL_FOUND)
        wf_show(to, "%.1f m/s mean (%.0f km/h), 3-s gust %.1f m/s, at %.4g m over terrain %s; the tree %s\n",
                c->speed, 3.6 * c->speed, wf_scenario_gust(&an->scenario, c->speed), at.height,
                at.terrain->name,
                wf_criteria[v.criterion].whole ? "overturns" : wf_criteria[v.criterion].event);
    else if (c->outcome == WF_CRITICAL_ABOVE)
        wf_show(to, "not lost up to %.4g m/s, the highest searched\n", c->speed_high);
    else
        wf_show(to, "%s\n", wf_critical_text(c->outcome));
    const struct wf_interval *i = an->interval;
    if (i && isfinite(i->high))
        wf_show(to, "    90 %% of %zu samples between %.0f and %.0f m/s\n", i->n, i->low, i->high);
    else if (i && isfinite(i->low))
        wf_show(to, "    90 %% of %zu samples above %.0f m/s\n", i->n, i->low);
}

/* What the band of the extremes says of the return period. */
static void print_band(FILE *to, const struct wf_assessment *x)
{
    const double low = x->years_low, high = x->years_high;
    const int low_digits = low < 10 ? 2 : 3, high_digits = high < 10 ? 2 : 3;
    if (isnan(low)) {
        if (x->years_by)
            wf_show(to,
                    "    how sure that is, is not known: the fit has no band, or one that does not ascend\n");
    } else if (!(high > 0)) {
        wf_show(to, "    90 %% band of the fit: less than its shortest return period\n");
    } else if (isinf(low)) {
        wf_show(to, "    90 %% band of the fit: more than its longest return period\n");
    } else if (low > 0 && isfinite(high)) {
        wf_show(to, "    90 %% band of the fit: %.*g to %.*g years\n", low_digits, low, high_digits, high);
    } else if (low > 0) {
        wf_show(to, "    90 %% band of the fit: %.*g years to more than its longest return period\n",
                low_digits, low);
    } else if (isfinite(high)) {
        wf_show(to, "    90 %% band of the fit: less than its shortest return period to %.*g years\n",
                high_digits, high);
    } else {
        wf_show(to,
                "    90 %% band of the fit: less than its shortest return period to more than its longest\n");
    }
}

static void print_years(FILE *to, const struct wf_analysis *an)
{
    const struct wf_assessment *x = an->assessment;
    char year[40], life[40];
    if (isnan(x->years)) {
        wf_show(to, "  return period of that wind: unknown: %s\n", x->years_unknown);
        return;
    }
    wf_show(to,
            x->years >= 1e5
                ? "  return period of that wind: %s%.*f years by %s, winds of all directions together\n"
                : "  return period of that wind: %s%.*g years by %s, winds of all directions together\n",
            x->years_most    ? "more than "
            : x->years_least ? "less than "
                             : "about ",
            x->years >= 1e5 ? 0
            : x->years < 10 ? 2
                            : 3,
            x->years, x->years_by ? x->years_by : an->scenario.design->title);
    wf_show(to, "    probability that it blows: %s a year, %s in %.4g years\n",
            wf_assess_chance(x, x->exceedance, year), wf_assess_chance(x, x->over_life, life), x->life);
    if (isnan(x->overturning.safety))
        wf_show(to,
                "    of the stem alone: the roots were not assessed and may fail in less wind, more often\n");
    print_band(to, x);
    if (isfinite(x->exceedance_low) && an->interval)
        wf_show(to, "    at the low end of the critical wind, %.0f m/s: %s a year\n", an->interval->low,
                wf_assess_chance(&(struct wf_assessment){ .years_most = x->exceedance_low <= 1e-6 },
                                 x->exceedance_low, year));
}

static void print_around(FILE *to, size_t n, const struct wf_assess_direction *d, double required)
{
    for (size_t k = 0; k < n; k++) {
        wf_show(to, "%7.4g deg", compass(d[k].from));
        print_safety(to, 7, d[k].breakage.safety, required);
        print_safety(to, 7, d[k].overturning.safety, required);
        if (k % 4 == 3 || k + 1 == n) wf_show(to, "\n");
    }
}

static void print_directions(FILE *to, const struct wf_assessment *x)
{
    if (!x->directions) {
        wf_show(to,
                "  nothing that is given makes directions differ: the wind's direction does not matter\n");
        return;
    }
    wf_show(to, "\n  safety by the direction the wind comes from: breakage, overturning\n");
    print_around(to, x->directions, x->direction, x->required);
}

static void print_missing(FILE *to, const struct wf_analysis *an)
{
    struct wf_verdict v = wf_verdict_of(an->breaks);
    wf_show(to, "  not assessed: limbs, forks and unions");
    if (an->model->judged_to > 0)
        wf_show(to, ", and the stem above the middle of the crown (%.3g m)",
                an->model->judged_to * cos(an->model->lean));
    wf_show(
        to,
        "; its flare and the roots as they are; decay other than the cavities given; wear by many gusts\n");
    for (int c = 0; c < WF_CRITERIA; c++) {
        const char *why = wf_verdict_unassessed(an, &v, (enum wf_criterion_id)c);
        if (!why) continue;
        const char *key = strchr(why, ' ') ? "" : "the species table has no ";
        wf_show(to, "  %s not assessed: %s%s\n", wf_criteria[c].name, key, why);
    }
    if (wf_verdict_size(an) > 0) wf_show(to, "  size effect not assessed: %s\n", WF_SIZE_UNASSESSED);
    if (wf_verdict_any_soil(an)) wf_show(to, "  kind of soil not assessed: %s\n", WF_SOIL_UNASSESSED);
    const struct wf_anchorage *roots = an->anchorage;
    if (!roots || !roots->method) return;
    wf_show(to, "  anchorage %.4g kN m: %s\n", roots->by_method / 1e3, roots->text);
    if (roots->by_method < roots->carried)
        wf_show(
            to,
            "    taken is the largest moment of the test instead, %.4g kN m: the root carried it, and may "
            "carry more\n",
            roots->carried / 1e3);
}

/* The wind in which the tree is lost: 0 where it falls without wind; above the search where none was found.
 */
static void print_lost_at(FILE *to, int width, const struct wf_beside *x)
{
    char text[32];
    if (isnan(x->critical) && isfinite(x->searched)) {
        (void)snprintf(text, sizeof text, "> %.0f", x->searched);
        wf_show(to, "%*s", width, text);
    } else
        print_number(to, width, isnan(x->critical) && x->word == WF_ASSESS_LOST ? 0.0 : x->critical);
}

/* `listed`: with the safety of branches. */
static void print_scenario(FILE *to, const struct wf_beside *x, bool listed, double required)
{
    wf_print_name(to, x->name ? x->name : "as it stands", 36);
    if (x->cut > 0)
        wf_show(to, "%7.0f %%%s", 100 * x->cut, x->cut > WF_ASSESS_CUT_FLAGGED ? "!" : " ");
    else
        wf_show(to, "%10s", "- ");
    print_safety(to, 10, x->breakage, required);
    print_safety(to, 13, x->overturning, required);
    if (listed) print_number(to, 10, x->branches);
    print_lost_at(to, 13, x);
    wf_show(to, "  %s\n", wf_assess_rows[x->word].name);
}

static void print_table(FILE *to, const struct wf_besides *all, double required)
{
    bool listed = false;
    for (size_t k = 0; k < all->n; k++) listed = listed || isfinite(all->item[k].branches);
    wf_show(to, "\n%36s%10s%10s%13s", "what is done", "crown cut", "breakage", "overturning");
    if (listed) wf_show(to, "%10s", "branches");
    wf_show(to, "%13s  %s\n", "critical m/s", "verdict");
    for (size_t k = 0; k < all->n; k++) print_scenario(to, &all->item[k], listed, required);
}

/* The tree as it stands beside what may be done to it. */
static void print_scenarios(FILE *to, const struct wf_analysis *an)
{
    const struct wf_assessment *x = an->assessment;
    bool flagged = x->reduction_cut > WF_ASSESS_CUT_FLAGGED;
    if (isfinite(x->reduction))
        wf_show(to,
                "  least reduction of the crown for a safety of %.6g: %.0f %% of its height and width, %.0f "
                "%% of "
                "its area\n",
                x->required, 100 * x->reduction, 100 * x->reduction_cut);
    else if (isinf(x->reduction))
        wf_show(to, "  no reduction of the crown up to %.0f %% reaches a safety of %.6g\n",
                100 * x->reduction_most, x->required);
    else if (x->reduction_unknown)
        wf_show(to, "  the least reduction of the crown was not searched: %s\n", x->reduction_unknown);
    if (an->beside) {
        print_table(to, an->beside, x->required);
        wf_print_beside_gusts(to, an->beside->n, an->beside->item);
    }
    for (size_t k = 0; k < x->scenarios; k++) flagged = flagged || x->scenario[k].cut > WF_ASSESS_CUT_FLAGGED;
    if (x->scenarios) wf_show(to, "  scenarios are without an interval: 'incomplete' may be uncertain\n");
    wf_print_beside_holds(to, x->scenarios, x->scenario);
    for (size_t k = 0; k < x->scenarios; k++) {
        const struct wf_beside *q = &x->scenario[k];
        if (!q->directions) continue;
        wf_show(to, "\n  %s: safety by the direction the wind comes from: breakage, overturning\n", q->name);
        print_around(to, q->directions, q->direction, x->required);
    }
    if (flagged)
        wf_show(to, "  !: more than %.0f %% of the crown: a loss that harms the tree\n",
                100 * WF_ASSESS_CUT_FLAGGED);
}

void wf_print_assessment(FILE *to, const struct wf_analysis *an)
{
    static const char *const shown[WF_ASSESS_WORDS] = { "UNKNOWN",   "LOST",       "INSUFFICIENT",
                                                        "UNCERTAIN", "INCOMPLETE", "SUFFICIENT" };
    const struct wf_assessment *x = an->assessment;
    print_tree(to, an);
    print_wind(to, an);
    wf_show(to, "\n  %s: %s\n", shown[x->word], wf_assess_rows[x->word].text);
    print_reasons(to, an);
    print_safeties(to, x);
    print_governing(to, an);
    print_critical(to, an);
    print_years(to, an);
    wf_print_holds(to, an);
    wf_print_wetted(to, an);
    print_directions(to, x);
    print_scenarios(to, an);
    print_missing(to, an);
}
