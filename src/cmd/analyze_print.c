/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/analyze_print.h"
#include "base/num.h"
#include "cmd/option.h"
#include "cmd/print_measures.h"
#include "cmd/print_walls.h"
#include "data/model.h"
#include "data/species.h"
#include "fail/anchorage.h"
#include "grow/silhouette.h"
#include "out/tables.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include "study/directions.h"
#include "study/interval.h"
#include "study/peak.h"
#include "study/unions.h"
#include "study/verdict.h"
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

/* 0: it fails without wind. */
static double critical_speed(const struct wf_critical *c)
{
    return c->outcome == WF_CRITICAL_SELF_WEIGHT ? 0.0 : c->speed;
}

/* At the strongest specified wind. */
static void print_direction(FILE *to, const struct wf_analysis *an, const struct wf_direction *d)
{
    const struct wf_at_speed *at = &d->at[an->n - 1];
    wf_show(to, "%8g", degrees(d->from));
    print_cell(to, 13, 3, at->base_moment / 1e3);
    print_cell(to, 8, 2, d->gusts[an->n - 1]);
    print_cell(to, 11, 3, at->tip_deflection);
    struct wf_verdict v = wf_verdict_of(d->breaks);
    print_cell(to, 9, 2, wf_verdict_safety(at, NULL));
    print_cell(to, 12, 2, critical_speed(&v.loss->critical));
    wf_show(to, "  %-11s", isfinite(critical_speed(&v.loss->critical)) ? wf_criteria[v.criterion].name : "-");
    print_cell(to, 9, 2, at->status ? NAN : at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety);
    print_cell(to, 12, 2, critical_speed(&d->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical));
    print_cell(to, 10, 2, d->breaks[WF_BREAKAGE][WF_SCOPE_TREE].height);
    const struct wf_directions_request *q = &an->directions->request;
    if (q->speed_up) print_cell(to, 10, 3, q->speed_up[d - an->directions->direction]);
    if (q->rose) {
        print_cell(to, 12, 3, WF_HOURS_A_YEAR * d->hourly);
        print_cell(to, 12, 3, WF_HOURS_A_YEAR * d->strongest);
    }
    wf_show(to, "\n");
}

static void print_climate(FILE *to, const struct wf_analysis *an)
{
    const struct wf_directions *x = an->directions;
    wf_show(to, "%-*s", x->request.speed_up ? 115 : 105, "     all, hours a year");
    print_cell(to, 12, 3, WF_HOURS_A_YEAR * x->hourly);
    print_cell(to, 12, 3, WF_HOURS_A_YEAR * x->strongest);
    wf_show(to,
            "\n  The critical wind is a 10-min mean at %.6g m. Hours a year: with an hourly "
            "mean above "
            "it;\n  with a 10-min mean above it, %.3f of the hourly mean by the law '%s'. Climate: %s.\n",
            wf_scenario_place(&an->scenario).height, x->gust, x->request.law, x->request.climate_file);
    if (x->above)
        wf_show(to, "  '-': not lost up to %.4g m/s; these directions count as 0 hours.\n",
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
    static const char heads[] = "%8s%13s%8s%11s%9s%12s  %-11s%9s%12s%10s%s%s\n";
    wf_show(to, heads, "from", "base moment", "gusts", "tip moves", "safety", "tree lost", "by", "least",
            "part breaks", "breaks", site ? "  exposure" : "", rose ? "  hours/year with wind" : "");
    wf_show(to, heads, "deg", "kN m", "x load", "m", "of tree", "wind m/s", "", "safety", "wind m/s", "at m",
            site ? "          " : "", rose ? "  above: mean      10 min" : "");
    for (size_t k = 0; k < x->request.n; k++) print_direction(to, an, &x->direction[k]);
    if (rose) print_climate(to, an);
    const struct wf_wind_place place = wf_scenario_place(&an->scenario);
    wf_show(to,
            "  Moment, movement and safety at %.6g m/s; 'least safety' is that of breakage anywhere. Winds "
            "are 10-min means at %.6g m over terrain "
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
static void print_speed(FILE *to, const struct wf_analysis *an, const struct wf_at_speed *at, bool lost)
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
    print_number(to, 10, 2, wf_verdict_safety(at, NULL));
    wf_show(to, "%s\n", lost ? " *" : "");
}

/* The segment that fails: its id in the file of the tree, branching order, diameter. */
static void print_failing(FILE *to, const struct wf_analysis *an, int32_t row, double place)
{
    const struct wf_tree *t = &an->tree;
    wf_show(to, " (id %lld, order %d, %.3g mm thick)", (long long)t->id[row], t->level[row],
            1e3 * wf_tree_thickness(t, (size_t)row, place));
}

/* A critical wind, or what is known of it. */
static void print_wind(FILE *to, const struct wf_analysis *an, const struct wf_critical *c)
{
    switch (c->outcome) {
    case WF_CRITICAL_FOUND:
        wf_show(to, "%.2f m/s (%.0f km/h), 3-s gust %.1f m/s", c->speed, 3.6 * c->speed,
                wf_scenario_gust(&an->scenario, c->speed));
        break;
    case WF_CRITICAL_ABOVE:
        wf_show(to, "> %.4g m/s, the highest searched", c->speed_high);
        break;
    case WF_CRITICAL_UNSEARCHED:
        wf_show(to, "not found in the time for the search; above %.4g m/s, %s %.4g m/s", c->speed_low,
                c->speed_high < an->search.speed_max ? "below" : "not searched to", c->speed_high);
        break;
    case WF_CRITICAL_UNSOLVED:
        wf_show(to, "not known: no equilibrium was found from %.4g m/s on; it may be lost there",
                c->speed_low);
        break;
    default:
        wf_show(to, "none; %s", wf_critical_text(c->outcome));
    }
}

/* What happens, and where. */
static void print_event(FILE *to, const struct wf_analysis *an, enum wf_criterion_id criterion,
                        const struct wf_break *b)
{
    if (b->row < 0) return;
    if (wf_criteria[criterion].whole) {
        wf_show(to, "; the tree %s", wf_criteria[criterion].event);
        return;
    }
    wf_show(to, "; the %s %s %.2f m above the ground",
            wf_model_level_name(an->model, an->species, an->tree.level[b->row]), wf_criteria[criterion].event,
            b->height);
    print_failing(to, an, b->row, b->place);
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

/* Breakage and overturning where they do not govern, and what was not assessed of them. The other criteria
 * are in a table. */
static void print_others(FILE *to, const struct wf_analysis *an, const struct wf_verdict *v)
{
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_break *b = &an->breaks[c][WF_SCOPE_STEM];
        const char *why = wf_verdict_unassessed(an, v, (enum wf_criterion_id)c);
        if (c != WF_BREAKAGE && wf_criteria[c].section) continue;
        if (why) wf_show(to, "  %s not assessed: %s\n", wf_criteria[c].name, why);
        if (why || !wf_criteria[c].loses_tree || b == v->loss) continue;
        wf_show(to, "  %s%s: ", wf_criteria[c].name, wf_criteria[c].whole ? "" : " of the stem");
        print_wind(to, an, &b->critical);
        print_event(to, an, (enum wf_criterion_id)c, b);
        wf_show(to, "\n");
        if (!wf_criteria[c].whole) print_weight(to, an, b);
    }
    if (wf_verdict_size(an) > 0) wf_show(to, "  size effect not assessed: %s\n", WF_SIZE_UNASSESSED);
    if (wf_verdict_any_soil(an)) wf_show(to, "  kind of soil not assessed: %s\n", WF_SOIL_UNASSESSED);
}

static void print_anchorage(FILE *to, const struct wf_analysis *an)
{
    const struct wf_anchorage *q = an->anchorage;
    if (!q || !q->method) return;
    wf_show(to, "  in saturated soil it overturns at ");
    print_wind(to, an, &an->breaks[WF_OVERTURNING_WETTEST][WF_SCOPE_STEM].critical);
    wf_show(to, ", to ");
    print_wind(to, an, &an->breaks[WF_OVERTURNING_WET][WF_SCOPE_STEM].critical);
    wf_show(
        to,
        "\n  anchorage %.4g kN m: %s%s; %.2f to %.2f of it in saturated soil (camphor, one study). Static "
        "result, an upper bound in a gale\n",
        q->moment / 1e3, q->text, q->method->counts_self_weight ? ", weight included" : "", WF_SATURATED_LOW,
        WF_SATURATED_HIGH);
    const struct wf_at_speed *last = wf_verdict_wind(an);
    if (last)
        wf_show(to,
                "  safety against overturning at %.6g m/s: %.2f as tested, %.2f to %.2f in saturated soil\n",
                last->speed, last->worst[WF_OVERTURNING][WF_SCOPE_STEM].safety,
                last->worst[WF_OVERTURNING_WETTEST][WF_SCOPE_STEM].safety,
                last->worst[WF_OVERTURNING_WET][WF_SCOPE_STEM].safety);
    if (q->scatter > 0)
        wf_show(to, "  two of three such trees lie within a factor %.2f of that anchorage\n",
                exp(q->scatter));
}

/* How far the tree moves, where limits are given; they do not lose it. */
static void print_room(FILE *to, const struct wf_analysis *an)
{
    static const enum wf_criterion_id room[] = { WF_CORRIDOR, WF_TIP_ANGLE };
    const struct wf_scenario *s = &an->scenario;
    const struct wf_at_speed *last = wf_verdict_wind(an);
    for (size_t k = 0; k < WF_COUNT(room); k++) {
        const struct wf_criterion *x = &wf_criteria[room[k]];
        enum wf_scope scope = wf_criterion_scope(x);
        const struct wf_break *b = &an->breaks[room[k]][scope];
        if (b->critical.outcome == WF_CRITICAL_NO_STRENGTH) continue;
        if (room[k] == WF_CORRIDOR)
            wf_show(to, "  corridor at %.4g m from the base of the stem: ", s->corridor);
        else
            wf_show(to, "  limit of %.4g deg for the turn of the tip: ", degrees(s->tip_angle));
        if (b->critical.outcome == WF_CRITICAL_SELF_WEIGHT)
            wf_show(to, "in still air");
        else
            print_wind(to, an, &b->critical);
        print_event(to, an, room[k], b);
        double safety = last ? last->worst[room[k]][scope].safety : (double)NAN;
        if (isfinite(safety)) wf_show(to, "; at %.6g m/s %.0f %% of the limit", last->speed, 100 / safety);
        wf_show(to, "\n");
    }
}

/* One class of branches: what is nearest to failing at the strongest given wind. */
static void print_class(FILE *to, const struct wf_analysis *an, const struct wf_branch_class *k)
{
    char name[40];
    (void)snprintf(name, sizeof name, isinf(k->to) ? "from %.3g cm" : "%.3g to %.3g cm", 100 * k->from,
                   100 * k->to);
    wf_show(to, "%18s%10zu", name, k->segments);
    print_number(to, 10, 2, k->worst.safety);
    print_number(to, 14, 2, k->fails);
    if (k->worst.row >= 0) {
        wf_show(to, "   %s, %.2f m above the ground", wf_criteria[k->criterion].name,
                wf_part_height(&an->tree, k->worst.row, k->worst.place));
        print_failing(to, an, k->worst.row, k->worst.place);
    }
    wf_show(to, "\n");
}

static void print_branches(FILE *to, const struct wf_analysis *an)
{
    struct wf_branch_class k[WF_BRANCH_CLASSES];
    const struct wf_at_speed *at = wf_verdict_wind(an);
    size_t n = at ? wf_branch_classes(an, k) : 0;
    if (!n) return;
    wf_show(
        to, "\n  Branches from %.3g cm; thinner ones are twigs. Safety at %.6g m/s\n%18s%10s%10s%14s   %s\n",
        100 * k[0].from, at->speed, "thickness", "segments", "safety", "fails at m/s", "nearest to failing");
    for (size_t i = 0; i < n; i++)
        if (k[i].segments) print_class(to, an, &k[i]);
    wf_show(to, "  'fails at': the lowest of the given winds at which one of them fails\n");
}

static void print_union(FILE *to, const struct wf_analysis *an, const struct wf_union *u)
{
    print_number(to, 10, 2, u->height);
    print_number(to, 10, 1, 100 * u->branch_diameter);
    print_number(to, 10, 1, 100 * u->above_diameter);
    print_number(to, 10, 1, 100 * u->below_diameter);
    print_number(to, 10, 2, u->ratio);
    wf_show(to, "   %s (id %lld beside %lld)\n", u->in->text, (long long)an->tree.id[u->branch],
            (long long)an->tree.id[u->above]);
}

/* Unions, where they are listed: how many of each class, the largest aspect ratios. */
static void print_unions(FILE *to, const struct wf_analysis *an)
{
    const struct wf_unions *u = an->unions;
    if (!u) return;
    wf_show(to, "\n  Unions of branches from %.3g cm and forks: %zu", 100 * an->search.branches_from, u->n);
    if (!u->n) wf_show(to, "; none is drawn");
    for (size_t k = WF_UNION_CLASSES; u->n && k-- > 0;)
        wf_show(to, "%s %zu %s", k == WF_UNION_CLASSES - 1 ? ":" : ",", wf_unions_of(u, &wf_union_classes[k]),
                wf_union_classes[k].text);
    wf_show(to, "\n");
    if (u->n)
        wf_show(to, "%10s%10s%10s%10s%10s   %s\n%10s%10s%10s%10s\n", "at m", "branch", "parent", "parent",
                "aspect", "class (" WF_UNIONS_SOURCE ")", "", "cm", "above, cm", "below, cm");
    for (size_t k = 0; k < u->n && k < WF_UNIONS_SHOWN; k++) print_union(to, an, &u->item[k]);
    if (u->n > WF_UNIONS_SHOWN)
        wf_show(to, "  the %d largest aspect ratios; all are in tables/unions.csv\n", WF_UNIONS_SHOWN);
    wf_show(to, "  " WF_UNIONS_UNASSESSED "; included bark is not seen\n");
}

/* The part that fails first, where it is not the stem; it does not make the headline. */
static void print_first(FILE *to, const struct wf_analysis *an)
{
    enum wf_criterion_id by;
    const struct wf_break *b = wf_verdict_first(an->breaks, &by);
    const struct wf_tree *t = &an->tree;
    if (b->row < 0 || t->level[b->row] == 0) return;
    const char *part = wf_model_level_name(an->model, an->species, t->level[b->row]);
    if (by == WF_BREAKAGE)
        wf_show(to, "  the %s breaks first: ", part);
    else
        wf_show(to, "  the %s fails first: ", part);
    print_wind(to, an, &b->critical);
    wf_show(to, "; %.2f m above the ground", b->height);
    print_failing(to, an, b->row, b->place);
    if (by != WF_BREAKAGE) wf_show(to, ", by %s", wf_criteria[by].name);
    wf_show(to, "%s\n", wf_verdict_twig(an, b->row) ? ", a twig" : "");
    print_weight(to, an, b);
}

/* The headline: at which wind the tree is lost. */
static void print_verdict(FILE *to, const struct wf_analysis *an)
{
    struct wf_verdict v = wf_verdict_of(an->breaks);
    const struct wf_wind_place at = wf_scenario_place(&an->scenario);
    bool beyond = false;
    for (size_t k = 0; k < an->n; k++) beyond = beyond || wf_verdict_lost(&v, &an->at[k]);
    if (beyond)
        wf_show(to, "  *: the tree is lost before; the row shows what a tree that cannot be lost would do\n");
    wf_show(to, "  critical wind speed ");
    if (v.loss) print_wind(to, an, &v.loss->critical);
    if (v.loss &&
        (v.loss->critical.outcome == WF_CRITICAL_FOUND || v.loss->critical.outcome == WF_CRITICAL_ABOVE))
        wf_show(to, ", at %.6g m over terrain %s", at.height, at.terrain->name);
    if (v.loss) print_event(to, an, v.criterion, v.loss);
    wf_show(to, "\n");
    if (v.loss && !wf_criteria[v.criterion].whole) print_weight(to, an, v.loss);
    print_others(to, an, &v);
    print_anchorage(to, an);
    wf_print_holds(to, an);
    print_room(to, an);
    print_first(to, an);
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
    if (s->winter != 1.0) wf_show(to, "; %.4g of the wind while snow or ice is on the tree", s->winter);
    double ratio = wf_scenario_speed(s, 1.0);
    if (ratio != 1.0)
        wf_show(to,
                "; the wind at the tree at %.6g m is %.4g times the wind named, critical speeds are of the "
                "wind named",
                s->reference_height, ratio);
    wf_show(to, "\n");
}

/* The crown's outline, so that a wrong scale is seen. */
static void print_crown(FILE *to, const struct wf_analysis *an)
{
    const struct wf_outline_size seen = wf_silhouette_size(an->model, an->tallness);
    if (isnan(seen.centre)) return;
    wf_show(to, "Crown from the side: %.4g m2, its centre at %.4g m; %.4g m broad over %.4g m of height\n",
            seen.area, seen.centre, seen.breadth, seen.height);
}

/* The stand whose trees share the wind. */
static void print_stand(FILE *to, const struct wf_stand *s)
{
    wf_show(to, ", stand of %.4g m height and %.4g m spacing", s->height, s->spacing);
    if (isfinite(s->edge))
        wf_show(to, ", %.4g m behind its edge", s->edge);
    else
        wf_show(to, ", well inside");
    if (isfinite(s->gap)) wf_show(to, ", a gap of %.4g m before the edge", s->gap);
}

void wf_print_head(FILE *to, const struct wf_analysis *first)
{
    const struct wf_scenario *s = &first->scenario;
    wf_show(to, "Model %s, %.6g m high; wind profile %s; air %.3f kg/m3; solver %s\n", first->model->key,
            first->tallness, s->profile, first->loads.air_density, first->solver->name);
    print_crown(to, first);
    wf_print_site(to, s);
    wf_show(to, "Peak load: %s", first->peak ? first->peak->method->name : "mean");
    if (first->peak && first->peak->method->mean) print_stand(to, &first->peak->request.stand);
    if (first->peak && first->peak->rule) wf_show(to, ", terrain %s", first->peak->rule->called(s->category));
    wf_show(to, "%s\n", wf_peak_differs(first->peak) ? "" : ", a steady wind without gusts");
}

/* The movement of a crown that reaches above its stem. */
static void print_top(FILE *to, const struct wf_analysis *an)
{
    size_t top = wf_top_row(&an->tree);
    if (an->tree.level[top] == 0) return;
    wf_show(to,
            "  the tip is that of the stem; the crown's top, %.4g m high on a %s, moves in the mean wind:\n",
            an->tree.z1[top], wf_model_level_name(an->model, an->species, an->tree.level[top]));
    for (size_t i = 0; i < an->n; i++) {
        wf_show(to, i ? ", " : "    ");
        if (isfinite(an->at[i].steady.top_deflection))
            wf_show(to, "%.3g m at %.6g m/s", an->at[i].steady.top_deflection, an->at[i].speed);
        else
            wf_show(to, "no equilibrium at %.6g m/s", an->at[i].speed);
    }
    wf_show(to, "\n");
}

void wf_print_speeds(FILE *to, const struct wf_analysis *an)
{
    wf_show(to, "\n%s (%s)\n", an->species->name, an->species->latin ? an->species->latin : an->species->key);
    bool peak = wf_peak_differs(an->peak);
    if (peak) wf_show(to, "%19s%45s%45s\n", "", "in the mean wind", "at the peak of the load");
    wf_show(to, "%10s%9s%12s%10s%10s%13s", "wind", "gust", "tip moves", "", "tip turns", "base moment");
    if (peak) wf_show(to, "%11s%12s", "gusts", "moment");
    wf_show(to, "%12s%10s%10s\n%10s%9s%12s%10s%10s%13s", "stress", "least", "safety", "m/s", "m/s", "m",
            "% height", "deg", "kN m");
    if (peak) wf_show(to, "%11s%12s", "x load", "kN m");
    wf_show(to, "%12s%10s%10s\n", "MPa", "safety", "of tree");
    bool lost = false;
    for (size_t i = 0; i < an->n; i++) {
        lost = lost || wf_verdict_safety(&an->at[i], NULL) <= 1;
        print_speed(to, an, &an->at[i], lost);
    }
    print_top(to, an);
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

/* How far one value moves the critical wind; a tree that does not stand is lost at 0 [m/s]. */
static double arm_width(const struct wf_interval *i, size_t k)
{
    double at_low = isnan(i->arm[k].at_low) ? 0.0 : fmin(i->arm[k].at_low, i->searched_to);
    double at_high = isnan(i->arm[k].at_high) ? 0.0 : fmin(i->arm[k].at_high, i->searched_to);
    return fabs(at_high - at_low);
}

/* The values that move the critical wind most, each alone. */
static void print_tornado(FILE *to, const struct wf_interval *i)
{
    enum { SHOWN = 3 };
    bool shown[WF_VARIED_MAX] = { false };
    char range[80], key[80];
    const char *before = "  most of it by ";
    for (size_t n = 0; n < SHOWN && n < i->variation.n; n++) {
        size_t best = 0;
        double widest = -1.0;
        for (size_t k = 0; k < i->variation.n; k++)
            if (!shown[k] && arm_width(i, k) > widest) widest = arm_width(i, k), best = k;
        const struct wf_varied *v = &i->variation.varied[best];
        shown[best] = true;
        if (!wf_interval_arm_text(i, best, range, sizeof range)) continue;
        (void)snprintf(key, sizeof key, "%s%s", wf_varied_prefix(v), v->name);
        wf_show(to, "%s%s (%s)", before, key, range);
        before = "; ";
    }
    if (*before == ';') wf_show(to, "\n");
}

static void print_safeties(FILE *to, const struct wf_interval *i, bool rooted)
{
    enum { SHOWN = 3 };
    for (size_t k = 0; k < i->winds; k++) {
        if (i->winds > SHOWN && k && k + 1 < i->winds) continue;
        if (!k) wf_show(to, "  safety of the stem%s", rooted ? " and root" : "");
        wf_show(to, "%s at %.4g m/s %.1f to %.1f", k ? ";" : "", i->at[k].speed, i->at[k].low, i->at[k].high);
    }
    wf_show(to, i->winds ? "\n" : "");
}

void wf_print_interval(FILE *to, const struct wf_analysis *an)
{
    const struct wf_interval *i = an->interval;
    if (!i) return;
    int digits = wf_interval_decimals(i->low, i->high);
    double times = wf_scenario_gust(&an->scenario, 1.0);
    bool rooted = wf_interval_rooted(an);
    const char *who = rooted ? "the tree is lost" : "the stem is lost";
    wf_show(to, "  how sure: ");
    if (!isfinite(i->low)) {
        wf_show(to, "%s above %.4g m/s mean in more than 95 %% of %zu samples; 3-s gust above %.4g\n", who,
                i->searched_to, i->n, times * i->searched_to);
        print_safeties(to, i, rooted);
        return;
    }
    if (isfinite(i->middle))
        wf_show(to, "%s at about %.*f", who, digits, i->middle);
    else
        wf_show(to, "%s above %.4g", who, i->searched_to);
    print_speed_to(to, digits, i->low, i->searched_to, " m/s mean, ");
    print_speed_to(to, digits, i->high, i->searched_to, " to ");
    wf_show(to, " (90 %% of %zu samples)", i->n);
    print_speed_to(to, digits, times * i->middle, times * i->searched_to, "; 3-s gust ");
    print_speed_to(to, digits, times * i->low, times * i->searched_to, ", ");
    print_speed_to(to, digits, times * i->high, times * i->searched_to, " to ");
    wf_show(to, "\n");
    print_safeties(to, i, rooted);
    print_tornado(to, i);
}

static void print_wetted(FILE *to, const struct wf_wetted *w)
{
    if (!w) return;
    if (w->film > 0)
        wf_show(to, "  rain on the leaves: %.4g kg, %.3g mm on %.4g m2; dry -> wet: ", w->mass, w->film,
                w->leaf_area);
    else
        wf_show(to, "  snow and ice: %.4g kg; without -> with: ", w->mass);
    wf_show(to, isfinite(w->frequency[WF_DRY]) ? "sways at %.4f Hz -> " : "does not stand -> ",
            w->frequency[WF_DRY]);
    wf_show(to, isfinite(w->frequency[WF_WET]) ? "%.4f Hz, " : "does not stand, ", w->frequency[WF_WET]);
    if (isfinite(w->speed))
        wf_show(to, "at %.4g m/s drag %.4g -> %.4g kN, base moment %.4g -> %.4g kN m, ", w->speed,
                w->drag[WF_DRY] / 1000, w->drag[WF_WET] / 1000, w->moment[WF_DRY] / 1000,
                w->moment[WF_WET] / 1000);
    wf_show(to, "lost at ");
    print_found(to, &w->critical[WF_DRY]);
    wf_show(to, " -> ");
    print_found(to, &w->critical[WF_WET]);
    wf_show(to, "\n");
}

void wf_print_wetted(FILE *to, const struct wf_analysis *an)
{
    print_wetted(to, an->winter);
    print_wetted(to, an->wetted);
}

/* The stem by one criterion: at a given wind, and the wind in which it is reached. */
static void print_criterion(FILE *to, const struct wf_analysis *an, const struct wf_at_speed *at, int c)
{
    const struct wf_criterion *x = &wf_criteria[c];
    const struct wf_worst *w = &at->worst[c][WF_SCOPE_STEM];
    const struct wf_critical *k = &an->breaks[c][WF_SCOPE_STEM].critical;
    double resistance = wf_criterion_resistance(x, &an->tree, w);
    wf_show(to, "%18s", x->name);
    print_number(to, 9, 2, w->safety);
    wf_show(to, "%8.3g", fmax(1.0, x->required));
    if (k->outcome == WF_CRITICAL_ABOVE)
        wf_show(to, "%9s%-5.4g", "> ", k->speed_high);
    else
        print_number(to, 14, 2, k->speed);
    print_number(to, 8, 1, wf_scenario_gust(&an->scenario, k->speed));
    print_number(to, 8, 2, wf_part_height(&an->tree, w->row, w->place));
    print_number(to, 10, 2, 1e-6 * resistance / w->safety);
    print_number(to, 10, 2, 1e-6 * resistance);
    wf_show(to, "%s\n", (int)wf_verdict_of(an->breaks).criterion == c ? "  governs" : "");
}

/* Criteria that apply to the stem and want a value that the species table does not give. */
static void print_unassessed(FILE *to, const struct wf_analysis *an)
{
    const char *before = "  not assessed: ";
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_criterion *x = &wf_criteria[c];
        if (!x->section || wf_criterion_known(x, &an->tree, WF_SCOPE_STEM) ||
            !wf_criterion_applies(x, &an->tree, WF_SCOPE_STEM))
            continue;
        wf_show(to, "%s%s (the species has no %s)", before, x->name, x->wants);
        before = ", ";
    }
    if (*before == ',') wf_show(to, "\n");
}

/* Which limit of a thin wall is reached first, and what it is with the low end of the strength across the
 * grain. */
static void print_wall(FILE *to, const struct wf_analysis *an, const struct wf_at_speed *at)
{
    static const enum wf_criterion_id limit[] = { WF_BREAKAGE, WF_SPLITTING, WF_OVALISATION };
    static const char *const does[] = { "breaks in bending", "splits", "flattens" };
    const struct wf_value *strength = &an->species->level[0].tangential_strength;
    double least = INFINITY, lowest = INFINITY;
    size_t first = 0;
    for (size_t k = 0; k < WF_COUNT(limit); k++) {
        double safety = at->worst[limit[k]][WF_SCOPE_STEM].safety;
        double bound = wf_verdict_bound(&an->breaks[limit[k]][WF_SCOPE_STEM].critical);
        if (!(bound < lowest) && !(bound == lowest && safety < least)) continue;
        lowest = bound, least = safety, first = k;
    }
    if (!wf_criterion_known(&wf_criteria[WF_SPLITTING], &an->tree, WF_SCOPE_STEM) || isinf(least)) return;
    const struct wf_critical *k = &an->breaks[limit[first]][WF_SCOPE_STEM].critical;
    wf_show(to, "  of the three limits of the thin wall the least governs: it %s first", does[first]);
    if (k->outcome == WF_CRITICAL_FOUND)
        wf_show(to, ", at %.2f m/s, 3-s gust %.1f m/s", k->speed, wf_scenario_gust(&an->scenario, k->speed));
    wf_show(to, "; splitting with the low end of tangential_strength, %.3g MPa: safety %.2f\n",
            1e-6 * strength->low,
            at->worst[WF_SPLITTING][WF_SCOPE_STEM].safety * sqrt(strength->low / strength->value));
}

/* Criteria of the stem, at the strongest given wind that has a solution. */
static void print_criteria(FILE *to, const struct wf_analysis *an)
{
    const struct wf_branch_strength *b = an->branch_strength;
    const struct wf_at_speed *at = wf_verdict_wind(an);
    bool known = false;
    for (int c = 0; c < WF_CRITERIA; c++)
        known = known ||
                (wf_criteria[c].section && wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_STEM));
    if (!at || !known) return;
    wf_show(to,
            "\n  Stem by criteria; safety, place and stresses at %.6g m/s\n%18s%9s%8s%14s%8s%8s%10s%10s\n",
            at->speed, "", "safety", "wanted", "critical m/s", "gust", "at m", "stress", "bears MPa");
    for (int c = 0; c < WF_CRITERIA; c++)
        if (wf_criteria[c].section && wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_STEM))
            print_criterion(to, an, at, c);
    print_unassessed(to, an);
    print_wall(to, an, at);
    if (b && b->source && wf_criterion_known(&wf_criteria[WF_BREAKAGE], &an->tree, WF_SCOPE_BRANCHES))
        wf_show(to, "  branches bear at most %.2f of the stem's clear wood: %s (%s)\n", b->factor, b->text,
                b->source);
}

void wf_print_searched(FILE *to, const struct wf_analysis *an)
{
    print_verdict(to, an);
    print_criteria(to, an);
    wf_print_interval(to, an);
    print_branches(to, an);
    print_unions(to, an);
    wf_print_beside(to, an);
    wf_print_walls(to, an);
    wf_print_wetted(to, an);
    print_directions(to, an);
}
