/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/assessment.h"
#include "base/num.h"
#include "data/model.h"
#include "study/directions.h"
#include "study/interval.h"
#include "study/peak.h"
#include "study/sway.h"
#include "study/verdict.h"
#include "wind/category.h"
#include "wind/design.h"
#include "wind/extreme.h"
#include <math.h>
#include <string.h>

const struct wf_assess_row wf_assess_rows[WF_ASSESS_WORDS] = {
    [WF_ASSESS_UNKNOWN] = { "unknown", "no verdict: whether the stem breaks was not assessed" },
    [WF_ASSESS_LOST] = { "lost", "as computed, the tree is lost in this wind" },
    [WF_ASSESS_INSUFFICIENT] = { "insufficient", "the safety is below the required one" },
    [WF_ASSESS_UNCERTAIN] = { "uncertain", "enough as computed, but that is not sure" },
    [WF_ASSESS_INCOMPLETE] = { "incomplete", "what was assessed is enough, but not all was assessed" },
    [WF_ASSESS_SUFFICIENT] = { "sufficient", "enough by all that was assessed" },
};

const char *const wf_assess_reasons[] = { "no-overturning", "no-elastic-limit", "no-interval",
                                          "low-end",        "saturated-soil",   "no-strength",
                                          "no-equilibrium", "winter-wind",      NULL };

/* ---- Safeties at a wind ---- */

static double part_height(const struct wf_tree *t, const struct wf_worst *w)
{
    return w->row < 0 ? (double)NAN : t->z0[w->row] + w->place * (t->z1[w->row] - t->z0[w->row]);
}

/* Does a criterion lose the tree, or does practice want more than 1 of it? */
static bool is_counted(enum wf_criterion_id c)
{
    return wf_criteria[c].loses_tree || wf_criteria[c].required > 0;
}

static struct wf_assess_part part_of(const struct wf_tree *t, const struct wf_at_speed *at,
                                     enum wf_criterion_id c)
{
    const struct wf_worst *w = &at->worst[c][WF_SCOPE_STEM];
    return (struct wf_assess_part){ w->safety, c, w->row, part_height(t, w), NAN };
}

/* The least safety of the stem by criteria of its sections, or by those of the whole tree. */
static struct wf_assess_part part_at(const struct wf_tree *t, const struct wf_at_speed *at, bool whole)
{
    struct wf_assess_part out = { .safety = NAN, .row = -1, .height = NAN, .from = NAN };
    for (enum wf_criterion_id c = 0; c < WF_CRITERIA; c++) {
        const struct wf_criterion *x = &wf_criteria[c];
        if (x->whole != whole || !is_counted(c) || !wf_criterion_known(x, t, WF_SCOPE_STEM)) continue;
        struct wf_assess_part one = part_of(t, at, c);
        if (at->status) one.safety = 0;
        if (!isnan(one.safety) && !(out.safety <= one.safety)) out = one;
    }
    return out;
}

/* The same by each criterion. Without equilibrium none is told from the others. */
static void parts_at(const struct wf_tree *t, const struct wf_at_speed *at, double from,
                     struct wf_assess_part *out)
{
    for (enum wf_criterion_id c = 0; c < WF_CRITERIA; c++) {
        out[c] = part_of(t, at, c);
        out[c].from = from;
        if (at->status || !is_counted(c)) out[c].safety = NAN;
    }
}

/* The tree of a scenario in one wind. Returned: *an, with tree and peak, its columns in `a`. */
static enum wf_status set_up(struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                             struct wf_arena *a, struct wf_err *e)
{
    struct wf_diag unsaid = { .arena = a };
    enum wf_status s = wf_analysis_set_up(an, o, a, &unsaid, e);
    return s ? s : wf_sway_set_up(an, o, &speed, 1, a, NULL, e);
}

/* The criteria that lose the tree: bits by their ids. */
static unsigned losers_of(const struct wf_assess_part *part)
{
    unsigned out = 0;
    for (int c = 0; c < WF_CRITERIA; c++)
        if (wf_criteria[c].loses_tree && part[c].safety <= 1) out |= 1U << c;
    return out;
}

/* ---- All directions ---- */

bool wf_assess_is_round(const struct wf_model *m, const struct wf_scenario *sc)
{
    const struct wf_anchorage_request *roots = sc->anchorage;
    bool round = m->generator == WF_GENERATOR_STEM && m->lean == 0 && !m->sections;
    if (sc->site || sc->guys || sc->braces || (roots && roots->lost > 0 && roots->lost_half < M_PI))
        return false;
    for (size_t k = 0; k < m->cavities && round; k++)
        round = !isnan(m->cavity[k].wall) && m->cavity[k].offset == 0 && m->cavity[k].opening == 0;
    return round;
}

/* One direction of an analysis that is set up; its sway is that along this wind. Safeties are of the stem:
 * the state at the peak of the branches' load is not computed. */
static enum wf_status turn(const struct wf_analysis *from, const struct wf_solve_options *o, double speed,
                           double azimuth, double north, struct wf_at_speed *at, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_analysis an = *from;
    enum wf_status s = wf_scenario_turn(&an.scenario, azimuth, north, e);
    if (s) return s;
    an.wind.direction[0] = cos(azimuth), an.wind.direction[1] = sin(azimuth);
    an.loads.wind = &an.wind;
    wf_analysis_turned(&an);
    s = wf_sway_set_up(&an, o, &speed, 1, &scratch, NULL, e);
    struct wf_peak stem = *an.peak;
    stem.branches = false, an.peak = &stem;
    if (!s) s = wf_speed_totals(&an, o, speed, at, e);
    wf_arena_free(&scratch);
    return s;
}

static double azimuth_of(const struct wf_model *m, size_t k)
{
    return remainder(m->lean_azimuth + 2 * M_PI * (double)k / WF_ASSESS_DIRECTIONS, 2 * M_PI);
}

/* Where the tree is clearly lost first as the wind rises: where that is far from the given wind, directions
 * that were near to the first are compared again in winds nearer to it. Given: their safeties in `speed`, the
 * least of which is *worst's. */
static enum wf_status find_first(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                                 double north, const struct wf_assess_direction *d, double *worst,
                                 struct wf_err *e)
{
    enum { PASSES = 2 };
    const double near = 1.1, others = 1.25, clear = 0.03, highest = 60;
    double loss[WF_ASSESS_DIRECTIONS], least = INFINITY;
    size_t first = 0;
    for (size_t k = 0; k < WF_ASSESS_DIRECTIONS; k++) {
        loss[k] = d[k].loss, least = fmin(least, loss[k]);
        if (azimuth_of(an->model, k) == *worst) first = k;
    }
    for (int pass = 0; pass < PASSES && isfinite(least) && fmax(least, 1 / least) > near; pass++) {
        const double limit = others * least;
        speed *= fmin(fmax(pow(least, 0.6), 0.5), 2); /* loads grow less than as its square */
        if (speed > highest) break;
        least = INFINITY;
        size_t lowest = first;
        for (size_t k = 0; k < WF_ASSESS_DIRECTIONS; k++) {
            struct wf_at_speed at;
            if (!(loss[k] <= limit) && k != first) continue;
            enum wf_status s = turn(an, o, speed, azimuth_of(an->model, k), north, &at, e);
            if (s) return s;
            loss[k] = at.status ? 0 : wf_verdict_safety(&at, NULL);
            if (loss[k] < least) lowest = k, least = loss[k];
        }
        if (least < (1 - clear) * loss[first]) first = lowest;
    }
    *worst = azimuth_of(an->model, first);
    return WF_OK;
}

enum wf_status wf_assess_around(const struct wf_species *sp, const struct wf_model *m,
                                const struct wf_scenario *sc, const struct wf_solver *solver,
                                const struct wf_solve_options *o, double speed, double north,
                                struct wf_assess_direction *out, double *worst, struct wf_err *e)
{
    const double alike = 1e-6;
    const struct wf_directions_request place = { .north = north };
    struct wf_arena scratch = { 0 };
    struct wf_analysis an = { .species = sp, .model = m, .solver = solver, .scenario = *sc };
    double least = INFINITY, lost = INFINITY;
    enum wf_status s = set_up(&an, o, speed, &scratch, e);
    for (size_t k = 0; k < WF_ASSESS_DIRECTIONS && !s; k++) {
        struct wf_at_speed at;
        double azimuth = azimuth_of(m, k);
        if ((s = turn(&an, o, speed, azimuth, north, &at, e))) break;
        out[k] = (struct wf_assess_direction){ .from = wf_direction_from(&place, azimuth),
                                               .breakage = part_at(&an.tree, &at, false),
                                               .overturning = part_at(&an.tree, &at, true),
                                               .loss = at.status ? 0 : wf_verdict_safety(&at, NULL) };
        out[k].breakage.from = out[k].overturning.from = out[k].from;
        parts_at(&an.tree, &at, out[k].from, out[k].by);
        for (size_t i = 0; i < an.loads.ties; i++) out[k].tie[i] = at.status ? (double)NAN : at.tie[i];
        for (size_t i = 0; i < an.loads.links; i++) out[k].link[i] = at.status ? (double)NAN : at.link[i];
        /* in one direction the elastic limit may be nearest, in another what loses the tree */
        double own = fmin(out[k].breakage.safety, out[k].overturning.safety),
               loss = isnan(out[k].loss) ? INFINITY : out[k].loss;
        bool first = loss < lost * (1 - alike), tied = loss <= lost * (1 + alike) || isinf(lost);
        if (first || (tied && own < least)) *worst = azimuth, least = own;
        lost = fmin(lost, loss);
    }
    if (!s) s = find_first(&an, o, speed, north, out, worst, e);
    wf_arena_free(&scratch);
    return s;
}

/* ---- One analysis ---- */

/* Safety against breakage with sound and full sections, in the same wind. */
static enum wf_status find_sound(const struct wf_analysis *an, const struct wf_solve_options *o,
                                 struct wf_assessment *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_model sound = *an->model;
    struct wf_analysis beside = {
        .species = an->species, .model = &sound, .solver = an->solver, .scenario = an->scenario
    };
    struct wf_at_speed at;
    out->sound = out->breakage.safety;
    if (!an->model->cavities) return WF_OK;
    sound.cavities = 0;
    enum wf_status s = set_up(&beside, o, out->speed, &scratch, e);
    if (!s) s = wf_speed_totals(&beside, o, out->speed, &at, e);
    if (!s) out->sound = part_at(&beside.tree, &at, false).safety;
    wf_arena_free(&scratch);
    return s;
}

/* Return period at which a bound of the band reaches a speed; 0: below the first, INFINITY: above the last.
 */
static double band_years(const struct wf_assess_often *q, const double *bound, double speed)
{
    size_t k = 0;
    while (k < q->levels && bound[k] < speed) k++;
    if (k == 0) return 0;
    if (k == q->levels) return INFINITY;
    double share = (speed - bound[k - 1]) / (bound[k] - bound[k - 1]);
    return exp(wf_between(log(q->years[k - 1]), log(q->years[k]), share));
}

/* By the distribution of annual maxima, which are 10-min means at 10 m over open country. */
static void years_of_extremes(const struct wf_analysis *an, const struct wf_assess_often *q, double speed,
                              struct wf_assessment *out)
{
    const double rarest = 0.999e-6; /* a year: a sample says nothing of what is rarer */
    const struct wf_wind_place at = wf_scenario_place(&an->scenario);
    out->years_by = q->source;
    if (strcmp(at.terrain->name, "II") || fabs(at.height - 10) > 1e-9) {
        out->years_unknown = "the winds are not named at 10 m over open country, where the extremes are";
        return;
    }
    double p = wf_extreme_exceedance(q->extreme, speed);
    out->years_most = out->years_most || p < rarest;
    out->exceedance = fmax(p, rarest);
    out->years = fmin(1 / out->exceedance, 1e6);
    if (q->levels)
        out->years_low = band_years(q, q->high, speed), out->years_high = band_years(q, q->low, speed);
    if (an->interval && isfinite(an->interval->low))
        out->exceedance_low = fmax(wf_extreme_exceedance(q->extreme, an->interval->low), rarest);
}

/* How often the critical wind blows. */
static void find_years(const struct wf_analysis *an, const struct wf_assess_often *q,
                       struct wf_assessment *out)
{
    struct wf_verdict v = wf_verdict_of(an->breaks);
    const struct wf_critical *c = v.loss ? &v.loss->critical : NULL;
    bool coded = q && q->design && q->design->code, found = c && c->outcome == WF_CRITICAL_FOUND;
    out->years = out->years_low = out->years_high = NAN;
    out->exceedance = out->over_life = out->exceedance_low = NAN;
    out->life = q ? q->life : (double)NAN;
    if (an->scenario.winter < 1) {
        out->years_unknown = "how often that share of it blows while snow or ice is on the tree is not known";
    } else if (!coded && !(q && q->extreme)) {
        out->years_unknown = "the wind was not given by a code, nor extremes (--extremes)";
    } else if (!found && !(c && c->outcome == WF_CRITICAL_ABOVE)) {
        out->years_unknown = "no critical wind was found";
    } else {
        double speed = found ? c->speed : c->speed_high;
        int end = 0;
        out->years_most = !found;
        if (q->extreme) {
            years_of_extremes(an, q, speed, out);
        } else {
            out->years = wf_design_years(q->design, speed / out->speed, &end);
            out->years_least = end<0, out->years_most = end> 0 || !found;
            out->exceedance = 1 / out->years;
            if (isnan(out->years)) out->years_unknown = "the code says nothing of other return periods";
        }
    }
    out->over_life = wf_extreme_over_years(out->exceedance, out->life);
}

static void find_reasons(const struct wf_analysis *an, struct wf_assessment *out)
{
    const struct wf_criterion *elastic = &wf_criteria[WF_ELASTIC_LIMIT];
    if (isnan(out->overturning.safety)) out->because |= WF_ASSESS_NO_OVERTURNING;
    const struct wf_at_speed *at = &an->at[an->n - 1];
    if (at->status) out->because |= WF_ASSESS_NO_EQUILIBRIUM;
    out->lost_by = losers_of(out->least);
    if (isnan(out->breakage.safety))
        out->because |= WF_ASSESS_NO_STRENGTH;
    else if (!wf_criterion_known(elastic, &an->tree, WF_SCOPE_STEM))
        out->because |= WF_ASSESS_NO_ELASTIC;
    if (isnan(out->low)) out->because |= WF_ASSESS_NO_INTERVAL;
    if (out->low < out->required) out->because |= WF_ASSESS_LOW_END;
    if (out->wet_low <= 1) out->because |= WF_ASSESS_WET;
    if (an->scenario.winter < 1) out->because |= WF_ASSESS_WINTER;
}

static enum wf_assess_word word_of(const struct wf_assessment *x, bool lost)
{
    double least = fmin(x->breakage.safety, x->overturning.safety);
    const unsigned doubt = WF_ASSESS_LOW_END | WF_ASSESS_WET;
    if (lost) return WF_ASSESS_LOST;
    if (isnan(x->breakage.safety)) return least < x->required ? WF_ASSESS_INSUFFICIENT : WF_ASSESS_UNKNOWN;
    if (least < x->required) return WF_ASSESS_INSUFFICIENT;
    if (x->because & doubt) return WF_ASSESS_UNCERTAIN;
    return x->because ? WF_ASSESS_INCOMPLETE : WF_ASSESS_SUFFICIENT;
}

enum wf_status wf_assess(const struct wf_analysis *an, const struct wf_solve_options *o, double required,
                         const struct wf_assess_often *often, struct wf_assessment *out, struct wf_err *e)
{
    const struct wf_at_speed *at = &an->at[an->n - 1];
    *out = (struct wf_assessment){ .required = required,
                                   .speed = at->speed,
                                   .breakage = part_at(&an->tree, at, false),
                                   .overturning = part_at(&an->tree, at, true),
                                   .wet_low = at->worst[WF_OVERTURNING_WETTEST][WF_SCOPE_STEM].safety,
                                   .wet_high = at->worst[WF_OVERTURNING_WET][WF_SCOPE_STEM].safety,
                                   .low = NAN,
                                   .high = NAN,
                                   .from = NAN,
                                   .reduction = NAN };
    if (an->interval) {
        const struct wf_interval_at *i = &an->interval->at[an->interval->winds - 1];
        out->low = i->wanted_low, out->high = i->wanted_high;
    }
    enum wf_status s = find_sound(an, o, out, e);
    if (s) return s;
    parts_at(&an->tree, at, NAN, out->least);
    find_years(an, often, out);
    find_reasons(an, out);
    out->word = word_of(out, at->status || wf_verdict_safety(at, NULL) <= 1);
    return WF_OK;
}

/* The lesser of two safeties. */
static struct wf_assess_part lesser(const struct wf_assess_part *a, const struct wf_assess_part *b)
{
    return b->safety < a->safety || (isnan(a->safety) && !isnan(b->safety)) ? *b : *a;
}

/* The least of a safety over all directions. Another direction is named where it is less by more than the
 * solution's error and what the mirror image of a direction differs by. */
static struct wf_assess_part named(const struct wf_assess_part *own, struct wf_assess_part least)
{
    const double alike = 5e-3;
    if (least.safety >= own->safety * (1 - alike)) least.from = own->from;
    return least;
}

/* Safeties of the analysis and in the first n directions become the least of both. */
static void take_least(struct wf_assessment *x, size_t n)
{
    struct wf_assess_part breakage = x->breakage, overturning = x->overturning;
    for (size_t k = 0; k < n; k++) {
        breakage = lesser(&breakage, &x->direction[k].breakage);
        overturning = lesser(&overturning, &x->direction[k].overturning);
    }
    x->breakage = named(&x->breakage, breakage), x->overturning = named(&x->overturning, overturning);
    for (int c = 0; c < WF_CRITERIA; c++) {
        struct wf_assess_part least = x->least[c];
        for (size_t k = 0; k < n; k++) least = lesser(&least, &x->direction[k].by[c]);
        x->least[c] = named(&x->least[c], least);
    }
    x->lost_by = losers_of(x->least);
}

void wf_assess_all_around(struct wf_assessment *x, const struct wf_assess_direction *direction, double from,
                          bool one)
{
    const double before = fmin(x->breakage.safety, x->overturning.safety), fell = x->overturning.safety;
    const bool full = x->sound <= x->breakage.safety;
    const size_t n = WF_ASSESS_DIRECTIONS, counted = one ? 0 : n;
    bool lost = x->word == WF_ASSESS_LOST;
    x->directions = n, x->direction = direction, x->from = from, x->one = one;
    x->breakage.from = x->overturning.from = from;
    for (int c = 0; c < WF_CRITERIA; c++) x->least[c].from = from;
    take_least(x, counted);
    for (size_t k = 0; k < counted; k++) lost = lost || direction[k].loss <= 1;
    double share = fmin(x->breakage.safety, x->overturning.safety) / before;
    if (one || !(before > 0) || isnan(share)) return;
    if (full) x->sound = x->breakage.safety;
    x->low *= share, x->high *= share;
    if (fell > 0) x->wet_low *= x->overturning.safety / fell, x->wet_high *= x->overturning.safety / fell;
    x->because &= ~(unsigned)(WF_ASSESS_LOW_END | WF_ASSESS_WET);
    if (x->low < x->required) x->because |= WF_ASSESS_LOW_END;
    if (x->wet_low <= 1) x->because |= WF_ASSESS_WET;
    x->word = word_of(x, lost);
}
