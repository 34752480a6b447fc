/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/analyze_print.h"
#include "base/num.h"
#include "cmd/option.h"
#include "data/model.h"
#include "data/species.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include "study/directions.h"
#include "study/interval.h"
#include "study/peak.h"
#include "study/wetted.h"
#include "wind/category.h"
#include "wind/climate.h"
#include <math.h>

static double degrees(double rad) { return rad * 180.0 / M_PI; }

static void print_cell(FILE *to, int width, int digits, double x)
{
    if (isfinite(x))
        wf_show(to, "%*.*f", width, digits, x);
    else
        wf_show(to, "%*s", width, "-");
}

/* At the strongest specified wind. */
static void print_direction(FILE *to, const struct wf_analysis *an, const struct wf_direction *d)
{
    const struct wf_at_speed *at = &d->at[an->n - 1];
    wf_show(to, "%8g", degrees(d->from));
    print_cell(to, 13, 3, at->base_moment / 1e3);
    print_cell(to, 11, 3, at->tip_deflection);
    print_cell(to, 9, 2, at->status ? NAN : at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety);
    print_cell(to, 12, 2, d->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed);
    print_cell(to, 10, 2, d->breaks[WF_BREAKAGE][WF_SCOPE_TREE].height);
    print_cell(to, 12, 2, d->breaks[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed);
    const struct wf_directions_request *q = &an->directions->request;
    if (q->speed_up) print_cell(to, 10, 3, q->speed_up[d - an->directions->direction]);
    if (q->rose) {
        print_cell(to, 12, 3, WF_HOURS_A_YEAR * d->hourly);
        print_cell(to, 12, 3, WF_HOURS_A_YEAR * d->strongest);
    }
    fputc('\n', to);
}

static void print_climate(FILE *to, const struct wf_analysis *an)
{
    const struct wf_directions *x = an->directions;
    wf_show(to, "%-*s", x->request.speed_up ? 85 : 75, "     all, hours a year");
    print_cell(to, 12, 3, WF_HOURS_A_YEAR * x->hourly);
    print_cell(to, 12, 3, WF_HOURS_A_YEAR * x->strongest);
    wf_show(to,
            "\n  The critical wind is a sustained one, a 10-min mean at %.6g m. Hours a year: with an hourly "
            "mean above "
            "it;\n  with a 10-min mean above it, %.3f of the hourly mean by the law '%s'. Climate: %s.\n",
            an->scenario.reference_height, x->gust, x->request.law, x->request.climate_file);
    if (x->above)
        wf_show(to, "  '-': no breakage up to %.4g m/s; these directions count as 0 hours.\n",
                an->search.speed_max);
}

/* The table of one analysis; nothing where it has no directions. */
static void print_directions(FILE *to, const struct wf_analysis *an)
{
    const struct wf_directions *x = an->directions;
    if (!x) return;
    bool rose = x->request.rose, site = x->request.speed_up;
    wf_show(to, "\n  Wind from all around, clockwise from north; north is ");
    if (x->request.north == 0.0)
        wf_show(to, "+y, east +x of the model\n");
    else
        wf_show(to, "%g deg clockwise from +y of the model\n", degrees(x->request.north));
    wf_show(to, "%8s%13s%11s%9s%12s%10s%12s%s%s\n", "from", "base moment", "tip moves", "safety", "critical",
            "breaks", "stem alone", site ? "  exposure" : "", rose ? "  hours/year with wind" : "");
    wf_show(to, "%8s%13s%11s%9s%12s%10s%12s%s%s\n", "deg", "kN m", "m", "factor", "wind m/s", "at m", "m/s",
            site ? "          " : "", rose ? "  above: mean      10 min" : "");
    for (size_t k = 0; k < x->request.n; k++) print_direction(to, an, &x->direction[k]);
    if (rose) print_climate(to, an);
    const struct wf_wind_place place = wf_scenario_place(&an->scenario);
    wf_show(
        to,
        "  Moment, movement and safety at %.6g m/s. Critical winds are 10-min means at %.6g m over terrain "
        "%s; their 3-s gusts are %.4g times as fast.\n",
        an->at[an->n - 1].speed, place.height, place.terrain->name, wf_scenario_gust(&an->scenario, 1.0));
}

static void print_number(FILE *to, int width, int digits, double value)
{
    if (isfinite(value))
        wf_show(to, "%*.*f", width, digits, value);
    else
        wf_show(to, "%*s", width, isinf(value) ? "inf" : "-");
}

/* One row: the mean wind, and with a peak method the peak of the load. */
static void print_speed(FILE *to, const struct wf_analysis *an, const struct wf_at_speed *at)
{
    const struct wf_steady *m = &at->steady;
    print_number(to, 10, fmod(at->speed, 1.0) == 0.0 ? 0 : 2, at->speed);
    wf_show(to, "%9.4g", wf_scenario_gust(&an->scenario, at->speed));
    if (at->status) {
        wf_show(to, "   no equilibrium; the last one is at %.0f %% of the load\n",
                100.0 * at->response.load_factor);
        return;
    }
    print_number(to, 12, 3, m->tip_deflection);
    print_number(to, 10, 1, 100.0 * m->tip_deflection / an->tallness);
    print_number(to, 10, 1, degrees(m->tip_angle));
    print_number(to, 13, 3, m->base_moment / 1e3);
    if (wf_peak_differs(an->peak)) {
        print_number(to, 11, 2, wf_peak_gusts(an->peak, at->speed));
        print_number(to, 12, 3, at->base_moment / 1e3);
    }
    print_number(to, 12, 2, at->breakage.largest_stress / 1e6);
    print_number(to, 10, 2, at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety);
    fputc('\n', to);
}

/* The segment that fails: its id in the file of the tree, branching order, diameter. */
static void print_failing(FILE *to, const struct wf_analysis *an, int32_t row)
{
    const struct wf_tree *t = &an->tree;
    wf_show(to, " (id %lld, order %d, %.3g mm thick)", (long long)t->id[row], t->level[row],
            2e3 * fmax(t->r0[row], t->r1[row]));
}

static void print_critical(FILE *to, const struct wf_analysis *an, const char *what, const struct wf_break *b)
{
    const struct wf_critical *c = &b->critical;
    if (c->outcome == WF_CRITICAL_UNSEARCHED) {
        wf_show(to, "  %s: not found in the time for the search; above %.4g m/s, %s %.4g m/s\n", what,
                c->speed_low, c->speed_high < an->search.speed_max ? "below" : "not searched to",
                c->speed_high);
        return;
    }
    if (c->outcome == WF_CRITICAL_ABOVE) {
        wf_show(to, "  %s > %.4g m/s, the highest searched\n", what, an->search.speed_max);
        return;
    }
    if (c->outcome != WF_CRITICAL_FOUND) {
        wf_show(to, "  %s: none; %s", what, wf_critical_text(c->outcome));
        if (b->row >= 0) {
            wf_show(to, ": the %s", wf_model_level_name(an->model, an->species, an->tree.level[b->row]));
            print_failing(to, an, b->row);
            wf_show(to, " %.2f m above the ground", b->height);
        }
        fputc('\n', to);
        return;
    }
    const struct wf_wind_place at = wf_scenario_place(&an->scenario);
    wf_show(to, "  %s %.2f m/s (%.0f km/h), 3-s gust %.1f m/s, at %.6g m over terrain %s", what, c->speed,
            3.6 * c->speed, wf_scenario_gust(&an->scenario, c->speed), at.height, at.terrain->name);
    if (b->row >= 0) {
        wf_show(to, "; the %s breaks%s %.2f m above the ground",
                wf_model_level_name(an->model, an->species, an->tree.level[b->row]),
                b == &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE] ? " first" : "", b->height);
        print_failing(to, an, b->row);
    }
    fputc('\n', to);
}

/* Stress of the weight alone in the segment that breaks first. */
static void print_weight(FILE *to, const struct wf_analysis *an, const struct wf_break *b)
{
    if (!an->still || b->row < 0) return;
    double stress = an->still->breakage.peak[b->row], strength = an->tree.strength[b->row];
    wf_show(to, "  at rest its weight alone stresses this segment to %.3g MPa, %.0f %% of its strength%s\n",
            stress / 1e6, 100 * stress / strength,
            an->scenario.weight_unstressed ? ", which is not counted: unsafe for leaning trees and limbs"
                                           : "");
}

void wf_print_site(FILE *to, const struct wf_scenario *s)
{
    const struct wf_wind_place at = wf_scenario_place(s);
    wf_show(
        to,
        "Wind speeds are 10-min means at %.6g m over terrain %s; their 3-s gusts are %.4g times as fast\n",
        at.height, at.terrain->name, wf_scenario_gust(s, 1.0));
    wf_show(to, "Site: terrain %s%s (%s)%s%s; ", s->category->name, s->category_said ? "" : ", assumed",
            s->category->text, s->site_kind ? "; " : "", s->site_kind ? s->site_kind : "");
    if (s->site)
        wf_show(to, "exposure %.4g, from the map of the ground", s->speed_up);
    else
        wf_show(to, s->speed_up != 1.0 ? "exposure %.4g" : "level ground", s->speed_up);
    double ratio = wf_scenario_speed(s, 1.0);
    if (ratio != 1.0)
        wf_show(to,
                "; the wind at the tree at %.6g m is %.4g times the wind named, critical speeds are of the "
                "wind named",
                s->reference_height, ratio);
    fputc('\n', to);
}

void wf_print_head(FILE *to, const struct wf_analysis *first)
{
    const struct wf_scenario *s = &first->scenario;
    wf_show(to, "Model %s, %.6g m high; wind profile %s; air %.3f kg/m3; solver %s\n", first->model->key,
            first->tallness, s->profile, first->loads.air_density, first->solver->name);
    wf_print_site(to, s);
    wf_show(to, "Peak load: %s", first->peak ? first->peak->method->name : "mean");
    if (first->peak && first->peak->rule) wf_show(to, ", terrain %s", first->peak->rule->called(s->category));
    wf_show(to, "%s\n", wf_peak_differs(first->peak) ? "" : ", a steady wind without gusts");
}

void wf_print_speeds(FILE *to, const struct wf_analysis *an)
{
    wf_show(to, "\n%s (%s)\n", an->species->name, an->species->latin ? an->species->latin : an->species->key);
    bool peak = wf_peak_differs(an->peak);
    if (peak) wf_show(to, "%19s%45s%45s\n", "", "in the mean wind", "at the peak of the load");
    wf_show(to, "%10s%9s%12s%10s%10s%13s", "wind", "gust", "tip moves", "", "tip turns", "base moment");
    if (peak) wf_show(to, "%11s%12s", "gusts", "moment");
    wf_show(to, "%12s%10s\n%10s%9s%12s%10s%10s%13s", "stress", "safety", "m/s", "m/s", "m", "% height", "deg",
            "kN m");
    if (peak) wf_show(to, "%11s%12s", "x load", "kN m");
    wf_show(to, "%12s%10s\n", "MPa", "factor");
    for (size_t i = 0; i < an->n; i++) print_speed(to, an, &an->at[i]);
}

/* A critical speed, or what is known of it. */
static void print_found(FILE *to, const struct wf_critical *c)
{
    if (isfinite(c->speed))
        wf_show(to, "%.2f m/s", c->speed);
    else if (c->outcome == WF_CRITICAL_ABOVE)
        wf_show(to, "> %.4g m/s", c->speed_high);
    else
        wf_show(to, "%s", wf_critical_text(c->outcome));
}

static void print_speed_to(FILE *to, int digits, double x, double end, const char *before)
{
    if (isfinite(x))
        wf_show(to, "%s%.*f", before, digits, x);
    else
        wf_show(to, "%sabove %.4g", before, end);
}

/* The values that move the critical wind most, each alone. */
static void print_tornado(FILE *to, const struct wf_interval *i)
{
    enum { SHOWN = 3 };
    bool shown[WF_VARIED_MAX] = { false };
    wf_show(to, "  most of it by");
    for (size_t n = 0; n < SHOWN && n < i->variation.n; n++) {
        size_t best = 0;
        double widest = -1.0;
        for (size_t k = 0; k < i->variation.n; k++) {
            double from = fmin(i->arm[k].at_low, i->searched_to),
                   to_ = fmin(i->arm[k].at_high, i->searched_to);
            if (!shown[k] && fabs(to_ - from) > widest) widest = fabs(to_ - from), best = k;
        }
        const struct wf_varied *v = &i->variation.varied[best];
        shown[best] = true;
        wf_show(to, "%s %s%s", n ? ";" : "", wf_varied_prefix(v), v->name);
        print_speed_to(to, 0, fmin(i->arm[best].at_low, i->arm[best].at_high), i->searched_to, " (");
        print_speed_to(to, 0, fmax(i->arm[best].at_low, i->arm[best].at_high), i->searched_to, " to ");
        wf_show(to, ")");
    }
    wf_show(to, "\n");
}

static void print_safeties(FILE *to, const struct wf_interval *i)
{
    enum { SHOWN = 3 };
    for (size_t k = 0; k < i->winds; k++) {
        if (i->winds > SHOWN && k && k + 1 < i->winds) continue;
        wf_show(to, "%s at %.4g m/s %.1f to %.1f", k ? ";" : "  safety of stem and root", i->at[k].speed,
                i->at[k].low, i->at[k].high);
    }
    wf_show(to, i->winds ? "\n" : "");
}

void wf_print_interval(FILE *to, const struct wf_analysis *an)
{
    const struct wf_interval *i = an->interval;
    if (!i) return;
    int digits = wf_interval_decimals(i->low, i->high);
    double times = wf_scenario_gust(&an->scenario, 1.0);
    print_speed_to(to, digits, i->middle, i->searched_to, "  the tree is lost at about ");
    print_speed_to(to, digits, i->low, i->searched_to, " m/s mean, ");
    print_speed_to(to, digits, i->high, i->searched_to, " to ");
    wf_show(to, " (90 %% of %zu samples)", i->n);
    print_speed_to(to, digits, times * i->middle, times * i->searched_to, "; 3-s gust ");
    print_speed_to(to, digits, times * i->low, times * i->searched_to, ", ");
    print_speed_to(to, digits, times * i->high, times * i->searched_to, " to ");
    wf_show(to, "\n");
    print_safeties(to, i);
    print_tornado(to, i);
}

static void print_wetted(FILE *to, const struct wf_wetted *w)
{
    if (!w) return;
    wf_show(to, "  rain on the leaves: %.4g kg, %.3g mm on %.4g m2; dry -> wet: ", w->mass, w->film,
            w->leaf_area);
    wf_show(to, "sways at %.4f -> %.4f Hz, ", w->frequency[WF_DRY], w->frequency[WF_WET]);
    if (isfinite(w->speed))
        wf_show(to, "base moment at %.4g m/s %.4g -> %.4g kN m, ", w->speed, w->moment[WF_DRY] / 1000,
                w->moment[WF_WET] / 1000);
    wf_show(to, "critical ");
    print_found(to, &w->critical[WF_DRY]);
    wf_show(to, " -> ");
    print_found(to, &w->critical[WF_WET]);
    wf_show(to, "\n");
}

void wf_print_searched(FILE *to, const struct wf_analysis *an)
{
    const struct wf_break *b = an->breaks[WF_BREAKAGE];
    bool beyond = false;
    for (size_t i = 0; i < an->n; i++)
        beyond = beyond || (!an->at[i].status && an->at[i].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety <= 1.0);
    if (beyond)
        wf_show(
            to,
            "  safety of 1 or less: broken before; the row shows what a tree that cannot break would do\n");
    print_critical(to, an, "critical wind speed", &b[WF_SCOPE_TREE]);
    print_weight(to, an, &b[WF_SCOPE_TREE]);
    if (b[WF_SCOPE_TREE].row >= 0 && an->tree.level[b[WF_SCOPE_TREE].row] > 0)
        print_critical(to, an, "of the stem alone", &b[WF_SCOPE_STEM]),
            print_weight(to, an, &b[WF_SCOPE_STEM]);
    wf_print_interval(to, an);
    print_wetted(to, an->wetted);
    print_directions(to, an);
}
