/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/limits.h"
#include "base/num.h"
#include "data/model.h"
#include "data/section.h"
#include "data/species.h"
#include "fail/anchorage.h"
#include "grow/silhouette.h"
#include "load/drag.h"
#include "load/interception.h"
#include "load/winter.h"
#include "study/analysis.h"
#include "study/verdict.h"
#include "wind/category.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void limits_wind(const struct wf_analysis *an, struct wf_diag *d);

#define DEGREES (180.0 / WF_PI)

/* Speeds whose `test` holds, as "15, 25" or, when more than four, "12 wind speeds from 15 to 40", into buf.
 * Returned: their number. */
static size_t speeds_where(const struct wf_analysis *an, bool (*test)(const struct wf_at_speed *), char *buf,
                           size_t size)
{
    size_t found = 0, used = 0;
    double first = 0.0, last = 0.0;
    buf[0] = '\0';
    for (size_t k = 0; k < an->n; k++) {
        if (!test(&an->at[k])) continue;
        if (++found == 1) first = an->at[k].speed;
        last = an->at[k].speed;
        if (used < size)
            used += (size_t)snprintf(buf + used, size - used, "%s%.6g", used ? ", " : "", an->at[k].speed);
    }
    if (found > 4) (void)snprintf(buf, size, "%zu wind speeds from %.6g to %.6g", found, first, last);
    return found;
}

static double largest_turn(const struct wf_at_speed *at)
{
    double largest = at->tip_angle; /* results kept as totals have no rows */
    for (size_t i = 0; i < at->response.n; i++) largest = fmax(largest, at->figures.slope[i]);
    return largest;
}

static bool solved(const struct wf_at_speed *at) { return at->status == WF_OK; }
static bool unsolved(const struct wf_at_speed *at) { return !solved(at); }

bool wf_limits_small_passed(const struct wf_at_speed *at)
{
    return solved(at) && at->response.small_deflection &&
           (at->tip_deflection_share > WF_SMALL_DEFLECTION_SHARE ||
            largest_turn(at) > WF_SMALL_DEFLECTION_TURN);
}

/* The answer at the critical wind speed is checked too: it is mostly far above the given wind speeds. */
static void check_small_critical(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_break *first = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE];
    const struct wf_at_speed *at = &first->at;
    if (first->critical.outcome != WF_CRITICAL_FOUND || !wf_limits_small_passed(at)) return;
    wf_diag_warn(
        d, "small-deflection",
        "%s: the critical wind speed of %.4g m/s by solver '%s' is outside its validity: at that wind it "
        "puts the tip deflection at %.0f %% of the height (limit %.0f %%) and the slope at %.0f deg (limit "
        "%.0f deg); use the large-deflection solver 'beam'",
        an->species->name, first->critical.speed, an->solver->name, 100.0 * at->tip_deflection_share,
        100.0 * WF_SMALL_DEFLECTION_SHARE, at->tip_angle * DEGREES, WF_SMALL_DEFLECTION_TURN * DEGREES);
}

static void check_small_deflection(const struct wf_analysis *an, struct wf_diag *d)
{
    char speeds[160];
    double share = 0.0, turn = 0.0;
    if (!speeds_where(an, wf_limits_small_passed, speeds, sizeof speeds)) return;
    for (size_t k = 0; k < an->n; k++)
        if (wf_limits_small_passed(&an->at[k])) {
            share = fmax(share, an->at[k].tip_deflection_share);
            turn = fmax(turn, largest_turn(&an->at[k]));
        }
    wf_diag_warn(
        d, "small-deflection",
        "%s: the small-deflection answers of solver '%s' at %s m/s are outside their validity: tip "
        "deflection up to %.0f %% of the height (limit %.0f %%), slope up to %.0f deg (limit %.0f deg); use "
        "the large-deflection solver 'beam'",
        an->species->name, an->solver->name, speeds, 100.0 * share, 100.0 * WF_SMALL_DEFLECTION_SHARE,
        turn * DEGREES, WF_SMALL_DEFLECTION_TURN * DEGREES);
}

static void check_equilibrium(const struct wf_analysis *an, struct wf_diag *d)
{
    char speeds[160];
    double share = 1.0;
    if (!speeds_where(an, unsolved, speeds, sizeof speeds)) return;
    for (size_t k = 0; k < an->n; k++)
        if (unsolved(&an->at[k])) share = fmin(share, an->at[k].response.load_factor);
    wf_diag_warn(
        d, "no-equilibrium",
        "%s: no equilibrium was found at %s m/s; the least share of the load with an equilibrium is %.3g",
        an->species->name, speeds, share);
}

double wf_limits_ground(const struct wf_tree *t, const double *end, bool moved, const char *who,
                        const char *when, struct wf_diag *d)
{
    size_t row = 0;
    double lowest = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double z = end[3 * i + 2] + (moved ? t->z1[i] : 0.0);
        if (t->z1[i] < 0.0 || !(z < -1e-3) || !(z < lowest)) continue;
        lowest = z, row = i;
    }
    if (lowest < 0.0 && d)
        wf_diag_warn(
            d, "through-ground",
            "%s: %s parts of the tree hang through the ground, segment %lld by %.3g m; the ground does "
            "not hold them here, so their deflection, and what they load, is not that of a tree that "
            "touches it",
            who, when, (long long)t->id[row], -lowest);
    return lowest;
}

static void check_ground(const struct wf_analysis *an, struct wf_diag *d)
{
    char when[60];
    for (size_t k = 0; k < an->n; k++) {
        const struct wf_at_speed *at = &an->at[k];
        if (!solved(at) || at->response.n != an->tree.n) continue;
        (void)snprintf(when, sizeof when, "at %.6g m/s", at->speed);
        if (wf_limits_ground(&an->tree, at->response.end, true, an->species->name, when, d) < 0.0) return;
    }
}

static void check_critical(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_critical *c = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    const char *who = an->species->name;
    if (c->outcome == WF_CRITICAL_NO_STRENGTH)
        wf_diag_warn(d, "no-strength",
                     "%s: the species table gives no modulus of rupture, so there is no safety factor and no "
                     "critical wind speed",
                     who);
    if (c->outcome == WF_CRITICAL_FOUND && c->speed > an->search.speed_max)
        wf_diag_warn(
            d, "searched-further",
            "%s: the tree fails at a given wind speed above %.6g m/s, the highest speed to be searched; "
            "the search went on to that wind speed",
            who, an->search.speed_max);
    if (c->outcome == WF_CRITICAL_UNSEARCHED && !an->search.bare)
        wf_diag_warn(
            d, "search-ended",
            "%s: the search for the critical wind speed ended after %.4g s of processor time: it stands "
            "up to %.4g m/s%s; wind speeds from there to %.4g m/s were not searched",
            who, an->search.seconds, c->speed_low,
            c->speed_high < an->search.speed_max ? " and fails above" : "", c->speed_high);
    if (c->outcome == WF_CRITICAL_ABOVE && c->speed_high >= an->search.speed_max) /* not for another loss */
        wf_diag_warn(d, "critical-above-range",
                     "%s: no section reaches its strength up to %.6g m/s, the highest speed searched", who,
                     an->search.speed_max);
    if (c->outcome == WF_CRITICAL_UNSOLVED)
        wf_diag_warn(d, "no-equilibrium",
                     "%s: the critical wind speed could not be bracketed: no equilibrium was found between "
                     "%.4g and %.4g m/s",
                     who, c->speed_low, c->speed_high);
}

/* Answers that nobody has seen come true. */
static void check_unverified(const struct wf_analysis *an, struct wf_diag *d)
{
    const double safety_seen = 5.0, wind_seen = 60.0;
    const struct wf_at_speed *at = wf_verdict_wind(an);
    double safety = at ? wf_verdict_safety(at, NULL) : (double)NAN;
    struct wf_verdict v = wf_verdict_of(an->breaks);
    double bound = v.loss ? wf_verdict_bound(&v.loss->critical) : (double)NAN;
    if (isfinite(safety) && safety > safety_seen)
        wf_diag_warn(d, "unverified-safety",
                     "%s: the safety against loss of the tree, %.3g at %.6g m/s, is above %g; no field data "
                     "verify such values",
                     an->species->name, safety, at->speed, safety_seen);
    bool above = v.loss && v.loss->critical.outcome == WF_CRITICAL_ABOVE && bound >= wind_seen;
    if (above || (isfinite(bound) && bound > wind_seen))
        wf_diag_warn(d, "unverified-wind",
                     "%s: the critical wind speed is above %g m/s; no field data verify such values",
                     an->species->name, wind_seen);
}

/* A tree that falls without wind stands all the same. */
static void check_stands(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_verdict v = wf_verdict_of(an->breaks);
    if (v.loss && v.loss->critical.outcome == WF_CRITICAL_SELF_WEIGHT)
        wf_diag_warn(
            d, "self-weight",
            "%s: as it is described it is lost under its own weight, without wind. A tree that stands "
            "is not so: check its height and thickness, the crown with its mass, and the anchorage; "
            "safeties in wind say little",
            an->species->name);
}

/* Strengths of small specimens on a thick stem. */
static void check_size(const struct wf_analysis *an, struct wf_diag *d)
{
    const double large = 0.05, small = 0.02, power = 1.0 / 9.0; /* specimens [m]; of timber design */
    double diameter = wf_verdict_size(an);
    if (diameter > 0)
        wf_diag_warn(
            d, "size-effect",
            "%s: the stem breaks, or is nearest to it, where its wood is %.2g m thick, and its modulus of "
            "rupture is taken as it was measured, as a rule on clear specimens of 20 to 50 mm. Thick timber "
            "breaks at lower stresses; that is not applied, and the critical wind of breakage may be too "
            "high. "
            "The rule of timber design (power 1/9 of the depth, above 12 in) makes the strength %.0f to %.0f "
            "%% "
            "lower; by Virot et al. 2016 it falls more",
            an->species->name, diameter, 100 * (1 - pow(large / diameter, power)),
            100 * (1 - pow(small / diameter, power)));
}

/* Anchorage of other trees on a soil that none of them is known to have stood on. */
static void check_soil(const struct wf_analysis *an, struct wf_diag *d)
{
    if (!wf_verdict_any_soil(an)) return;
    const struct wf_soil *soil = an->anchorage->soil;
    if (!soil->known || soil->held == 1) return;
    wf_diag_warn(
        d, WF_ANCHORAGE_SOIL,
        "%s: the anchorage, %.4g kN m, is that of other trees, none of which is known to have stood on %s: "
        "it may be too strong. Of one stem mass, conifers pulled in Britain held %.2f times as much there "
        "as on freely draining mineral soil (ForestGALES' table after Nicoll et al. 2006), which only "
        "widens the interval here; of broadleaves nothing was read. A pulling test says more",
        an->species->name, an->anchorage->moment / 1e3, soil->text, soil->held);
}

/* Diaphragms that are counted, and by how much where the wall is nearest to splitting or flattening. */
static void check_diaphragms(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_tree *t = &an->tree;
    const struct wf_at_speed *at = wf_verdict_wind(an);
    double times = 1;
    if (!(t->node_spacing > 0)) return;
    for (int c = WF_SPLITTING; at && c <= WF_OVALISATION; c++) {
        const struct wf_worst *w = &at->worst[c][WF_SCOPE_STEM];
        if (w->row < 0) continue;
        struct wf_wall wall = wf_section_wall(t, (size_t)w->row, w->place);
        times = fmax(times, wf_wall_held(t->node_spacing, t->youngs[w->row], t->transverse[w->row],
                                         wall.radius, wall.thickness));
    }
    wf_diag_warn(
        d, "diaphragms",
        "%s: the culm's diaphragms, %.3g m apart, are counted by judgement, not by measurement: where "
        "the wall is nearest to splitting or flattening it bears up to %.3g times as much. Poles of "
        "bamboo with their diaphragms did crack along the grain in bending tests; without "
        "--node-spacing they are left out, which is on the safe side",
        an->species->name, t->node_spacing, times);
}

/* Of a row and all that grows on it [m2]. */
static double leaves_on(const struct wf_tree *t, size_t row)
{
    double sum = 0;
    for (size_t i = row; i < t->n; i++) {
        int32_t at = (int32_t)i;
        while (at > (int32_t)row) at = t->parent[at]; /* parents come first */
        if (at == (int32_t)row) sum += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
    }
    return sum;
}

/* A twig that breaks first because the leaves of many are on the few that are drawn. */
static void check_twig(const struct wf_analysis *an, struct wf_diag *d)
{
    const double most = 1e4; /* leaves over wood that real shoots have, a rule of ours [m2 m-2] */
    const struct wf_break *b = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE];
    const struct wf_tree *t = &an->tree;
    if (b->row < 0 || t->level[b->row] == 0) return;
    size_t twig = (size_t)b->row;
    double thickness = wf_tree_thickness(t, twig, NAN), leaves = leaves_on(t, twig);
    double wood = wf_ring_area(0.5 * thickness, 0);
    if (!(thickness < an->search.branches_from) || !(leaves > most * wood)) return;
    wf_diag_warn(d, "twig-leaves",
                 "%s: the twig that breaks first, %.3g mm thick, carries %.2g m2 of leaves, %.2g m2 on each "
                 "cm2 of its wood; shoots carry up to about 1 (a rule). The leaves of many twigs are on the "
                 "few that are drawn: that it breaks in so weak a wind is an artefact",
                 an->model->name, 1e3 * thickness, leaves, 1e-4 * leaves / wood);
}

/* A crown in leaf whose leaves do not cover the ground under it once catches less wind than real ones. */
static void check_few_leaves(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_tree *t = &an->tree;
    const double breadth = wf_silhouette_size(an->model, an->tallness).breadth,
                 ground = wf_crown_projection(t, isnan(breadth) ? 0 : breadth);
    const double leaves = wf_tree_leaf_area(t);
    if (an->model->season == WF_LEAF_OFF || wf_silhouette_area(&an->model->silhouette) > 0) return;
    if (!(leaves > 0 && leaves < ground)) return;
    wf_diag_warn(
        d, "few-leaves",
        "%s: %.3g m2 of leaves in a crown over %.3g m2 of ground, %.2g m2 on each: less than one layer. "
        "Crowns in full leaf carry several; with them the load is higher and the critical wind lower "
        "(--leaf-area)",
        an->model->name, leaves, ground, leaves / ground);
}

/* Wood that yields: the stem is not elastic any more. */
static void check_elastic(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_critical *c = &an->breaks[WF_ELASTIC_LIMIT][WF_SCOPE_STEM].critical;
    const struct wf_at_speed *at = wf_verdict_wind(an);
    if (!at || at->status || !wf_verdict_reached(c) ||
        !(at->worst[WF_ELASTIC_LIMIT][WF_SCOPE_STEM].safety < 1))
        return;
    wf_diag_warn(
        d, "beyond-elastic",
        "%s: at %.6g m/s the stem's compressed wood is beyond its elastic limit, which it reaches at %.3g "
        "m/s: from there on it bends more than computed, and keeps some of it",
        an->species->name, at->speed, wf_verdict_bound(c));
}

void wf_limits_root(const struct wf_analysis *an, const double stiffness[2], struct wf_diag *d)
{
    const double linear = 0.25 / DEGREES;
    const struct wf_at_speed *at = wf_verdict_wind(an);
    double softest = fmin(stiffness[0], stiffness[1]);
    double turn = at && softest > 0.0 ? at->base_moment / softest : 0.0;
    if (turn > linear)
        wf_diag_warn(d, "root-linear",
                     "%s: at %.6g m/s the root plate turns by about %.2g deg. Its stiffness is taken as "
                     "constant; roots soften beyond 0.25 deg, so that the tree leans further than computed",
                     an->species->name, at->speed, turn * DEGREES);
}

static void check_as_printed(const struct wf_analysis *an, struct wf_diag *d)
{
    if (an->solver->as_printed)
        wf_diag_warn(d, "as-printed", "solver '%s' reproduces a published formula, not mechanics: %s",
                     an->solver->name, an->solver->validity);
    if (an->species->preset && strcmp(an->species->preset, "corrected") != 0)
        wf_diag_warn(d, "as-printed",
                     "%s: the table holds the numbers printed in '%s'; some are not physical (see its notes)",
                     an->species->name, an->species->preset);
}

/* A text, appended to, of assumed values by part: "culm: density, shear_modulus; crown: ...". */
struct assumed {
    char *buf;
    size_t size, used;
    const char *part; /* the last one named */
};

/* table: the table of the part that contains the value's key. */
static void add_assumed(struct assumed *to, const char *part, const char *table, const struct wf_property *p)
{
    if (p->value->standing != WF_ASSUMED || to->used >= to->size) return;
    bool same = to->part == part;
    const char *before = same ? ", " : to->used ? "; " : "";
    int n = snprintf(to->buf + to->used, to->size - to->used, "%s%s%s%s%s", before, same ? "" : part,
                     same ? "" : ": ", table, p->key);
    to->used += (size_t)n;
    to->part = part;
}

static bool has_crown(const struct wf_tree *t)
{
    for (size_t i = 0; i < t->n; i++)
        if (t->sail0[i] > 0.0 || t->sail1[i] > 0.0) return true;
    return false;
}

static void level_assumed(const struct wf_analysis *an, size_t level, struct assumed *to)
{
    const struct wf_level *l = &an->species->level[level];
    struct wf_property p;
    to->part = NULL;
    for (size_t i = 0; wf_level_property(l, i, &p); i++)
        if ((p.acts == WF_ACTS_ALWAYS && p.value->value > 0) || (p.acts == WF_ACTS_GIVEN && p.value->given))
            add_assumed(to, l->name, "", &p);
    for (size_t i = 0; level == 0 && isnan(an->model->radius) && wf_level_property(l, i, &p); i++)
        if (p.acts == WF_ACTS_SIZE) add_assumed(to, l->name, "", &p);
    p = (struct wf_property){ .key = "wall", .value = &l->wall_note };
    if (l->wall.n) add_assumed(to, l->name, "", &p);
}

/* The values of the species that are assumptions and are used (levels grown, radius where the model gives
 * none), as one text ("culm: density, shear_modulus; crown: ..."), or "" when there is none. Returned: buf.
 */
static char *limits_assumed(const struct wf_analysis *an, char *buf, size_t size)
{
    const struct wf_species *sp = an->species;
    const struct wf_law *law = an->loads.streamline ? &an->loads.streamline->law : NULL;
    struct assumed to = { .buf = buf, .size = size };
    struct wf_property p;
    buf[0] = '\0';
    for (size_t i = 0; i < sp->levels; i++)
        if (wf_analysis_grown(an, i)) level_assumed(an, i, &to);
    if (!has_crown(&an->tree)) return buf;
    for (size_t i = 0; wf_crown_property(sp, i, &p); i++)
        if (p.acts != WF_ACTS_DROPS) add_assumed(&to, "crown", "", &p);
    for (size_t i = 0; wf_law_property(law, &sp->streamlining, i, &p); i++)
        add_assumed(&to, "crown", "streamlining.", &p);
    return buf;
}

static void check_assumed(const struct wf_analysis *an, struct wf_diag *d)
{
    char list[900];
    if (*limits_assumed(an, list, sizeof list))
        wf_diag_warn(d, "assumed-values", "%s: these values are assumptions, not measurements: %s",
                     an->species->name, list);
}

/* A crown that is not drawn reaches further than the stem. */
static void check_corridor(const struct wf_analysis *an, struct wf_diag *d)
{
    bool crown = false;
    if (!(an->tree.room.corridor > 0)) return;
    for (size_t i = 0; i < an->tree.n; i++) {
        if (an->tree.level[i] > 0) return;
        crown = crown || an->tree.sail0[i] > 0 || an->tree.sail1[i] > 0;
    }
    if (crown)
        wf_diag_warn(d, "corridor-crown",
                     "%s: the crown of a stem without branches is not drawn: its reach is not counted, and "
                     "it comes into "
                     "the corridor in weaker wind than the stem does",
                     an->species->name);
}

/* A tree without the leaves that its kind keeps catches far less wind. */
static void check_evergreen(const struct wf_analysis *an, struct wf_diag *d)
{
    if (an->model->season != WF_LEAF_OFF || !wf_species_is_evergreen(an->species)) return;
    wf_diag_warn(
        d, WF_EVERGREEN,
        "%s keeps its leaves in winter: without them (season leaf_off) it is a tree that has lost them, "
        "as a dead one, and a living one catches far more wind than is computed. Dead wood loses its "
        "strength, which is not computed",
        an->species->name);
}

void wf_limits_check(const struct wf_analysis *an, struct wf_diag *d)
{
    check_evergreen(an, d);
    check_equilibrium(an, d);
    check_small_deflection(an, d);
    check_small_critical(an, d);
    check_ground(an, d);
    limits_wind(an, d);
    check_critical(an, d);
    check_corridor(an, d);
    check_stands(an, d);
    check_unverified(an, d);
    check_size(an, d);
    check_soil(an, d);
    check_diaphragms(an, d);
    check_twig(an, d);
    check_few_leaves(an, d);
    check_elastic(an, d);
    check_as_printed(an, d);
    check_assumed(an, d);
}

/* Wind at the unloaded end of a row when the speed at reference height is `speed` [m/s]. */
static double wind_at_end(const struct wf_analysis *an, size_t i, double speed)
{
    struct wf_wind wind = an->wind;
    const double x[3] = { an->tree.x1[i], an->tree.y1[i], an->tree.z1[i] };
    double u[3], gradient[9];
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    wind.sample(&wind, x, u, gradient);
    return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

/* Least and largest wind speed at the crown for one speed; false without a crown. */
static bool crown_wind(const struct wf_analysis *an, double speed, double *low, double *high)
{
    *low = INFINITY;
    *high = 0.0;
    for (size_t i = 0; i < an->tree.n; i++) {
        if (an->tree.sail1[i] <= 0.0) continue;
        double u = wind_at_end(an, i, speed);
        *low = fmin(*low, u);
        *high = fmax(*high, u);
    }
    return *high > 0.0;
}

/* The wind at the crown, up to `largest`, is beyond the evidence of its streamlining law. */
static void say_beyond(const struct wf_analysis *an, double end, double largest, bool critical,
                       struct wf_diag *d)
{
    const struct wf_law_use *law = &an->species->streamlining;
    const struct wf_streamline_law *row = an->loads.streamline;
    struct wf_law_values extended = an->loads.streamline_par;
    const char *with = critical ? " (critical speed included)" : "";
    double slope, beyond = 100.0 * (largest / end - 1.0);
    extended.held = 0;
    if (law->beyond == WF_BEYOND_EXTEND)
        wf_diag_warn(
            d, "streamline-range",
            "%s: the wind at the crown is up to %.1f m/s%s; the evidence for its streamlining law '%s' "
            "ends at %.3g m/s (%.0f %% beyond); it is extended: lower load than if held, down to "
            "%.0f %% of it; 'beyond: hold' in the species table holds it",
            an->species->name, largest, with, law->law, end, beyond,
            100.0 * wf_streamline_share(row, &extended, largest, &slope) /
                wf_streamline_share(row, &extended, end, &slope));
    else
        wf_diag_warn(
            d, "streamline-range",
            "%s: the wind at the crown is up to %.1f m/s%s; the evidence for its streamlining law '%s' "
            "ends at %.3g m/s (%.0f %% beyond); there its share is held, and the drag grows as the "
            "square of the wind speed",
            an->species->name, largest, with, law->law, end, beyond);
}

static void check_streamline(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_law_use *law = &an->species->streamlining;
    const struct wf_streamline_law *row = an->loads.streamline;
    double least = INFINITY, largest = 0.0, low, high;
    const struct wf_critical *lost = &wf_verdict_of(an->breaks).loss->critical;
    bool critical = lost->outcome == WF_CRITICAL_FOUND;
    if (!row || row->rigid) return;
    double from = isnan(law->low) ? row->law.low : law->low;
    double end = isnan(law->high) ? row->law.high : law->high;
    for (size_t k = 0; k < an->n + critical; k++) {
        double speed = k < an->n ? an->at[k].speed : lost->speed;
        if (!crown_wind(an, speed, &low, &high)) continue;
        least = fmin(least, low);
        largest = fmax(largest, high);
    }
    if (largest > end) say_beyond(an, end, largest, critical, d);
    if (least < from)
        wf_diag_warn(d, "streamline-range",
                     "%s: the wind at the crown is down to %.1f m/s; the evidence for its streamlining law "
                     "'%s' begins "
                     "at %.3g m/s (%.0f %% below)",
                     an->species->name, least, law->law, from, 100.0 * (1.0 - least / from));
}

static void check_reynolds(const struct wf_analysis *an, struct wf_diag *d)
{
    const double law_low = an->loads.axis_drag->law.low, law_high = an->loads.axis_drag->law.high;
    double least = INFINITY, largest = 0.0;
    for (size_t k = 0; k < an->n; k++)
        for (size_t i = 0; i < an->tree.n; i++) {
            double wind = wind_at_end(an, i, an->at[k].speed);
            double re = wind * 2.0 * an->tree.r1[i] / an->loads.air_viscosity;
            if (!isnan(an->tree.drag[i]) || wind <= 0.0) continue;
            least = fmin(least, re);
            largest = fmax(largest, re);
        }
    if (largest > law_high || least < law_low)
        wf_diag_warn(d, "reynolds-range",
                     "%s: Reynolds numbers of the axes run from %.3g to %.3g; the drag law of the cylinder "
                     "is measured "
                     "for %.0g to %.0g and held constant outside",
                     an->species->name, least, largest, law_low, law_high);
}

static void check_measured(const struct wf_scenario *s, double tallness, const char *tree, struct wf_diag *d)
{
    const struct wf_measured_profile *p = s->measured;
    double low = p->z[1], high = p->z[p->n - 1];
    if (tallness > high)
        wf_diag_warn(
            d, "profile-range",
            "%s: the tree is %.4g m high, the measured profile ends at %.4g m; above it the wind is taken "
            "as constant, which is less than it is over open ground",
            tree, tallness, high);
    if (low > 0.1 * tallness)
        wf_diag_warn(d, "profile-range",
                     "%s: the lowest %.4g m of the tree (%.0f %% of its height) stand below the lowest wind "
                     "measured; there it is taken to fall to 0 at the ground",
                     tree, fmin(low, tallness), fmin(100.0, 100.0 * low / tallness));
    if (s->reference_height > high || s->reference_height < low)
        wf_diag_warn(d, "profile-range",
                     "the reference height of %.4g m is outside the heights measured (%.4g to %.4g m)",
                     s->reference_height, low, high);
}

/* The logarithmic profile is valid above its zero plane and inside the surface layer, some 100 m deep (Stull
 * 1988, An Introduction to Boundary Layer Meteorology); power-law exponents are fitted up to some 200 m
 * (Davenport 1960). */
void wf_limits_profile(const struct wf_scenario *s, double tallness, const char *tree, struct wf_diag *d)
{
    bool logarithmic = strcmp(s->profile, "log") == 0, power = strcmp(s->profile, "power") == 0;
    double bottom = s->displacement + s->roughness, top = logarithmic ? 100.0 : 200.0;
    if (logarithmic && bottom > 0.05 * tallness)
        wf_diag_warn(
            d, "profile-range",
            "%s: the lowest %.2f m of the tree (%.0f %% of its height) stand below displacement + roughness "
            "length, where the logarithmic profile has speed 0",
            tree, fmin(bottom, tallness), fmin(100.0, 100.0 * bottom / tallness));
    if ((logarithmic || power) && tallness > top)
        wf_diag_warn(d, "profile-range",
                     "%s: the tree is %.0f m high; the '%s' profile is valid up to about %.0f m", tree,
                     tallness, s->profile, top);
    if (s->measured && strcmp(s->profile, "measured") == 0) check_measured(s, tallness, tree, d);
}

void wf_limits_site(const struct wf_site *s, struct wf_diag *d)
{
    if (!s) return;
    if (s->steepest > 0.3)
        wf_diag_warn(d, "steep",
                     "%s: slopes up to %.2f: the linear speed-up is valid to about 0.3; beyond, the wind "
                     "separates in the "
                     "lee and is overestimated there",
                     s->file, s->steepest);
    if (s->edge < 1000.0)
        wf_diag_warn(
            d, "map-edge",
            "%s: the tree stands %.0f m from the edge of the map; ground beyond it is taken as the mirror "
            "image of what is known",
            s->file, s->edge);
}

/* Mean wind at the top of a closed stand of a height [m] over the wind named in open country: the log law of
 * its roughness, 0.1 and 0.7 of the height being roughness and displacement as in the canopy profile. */
static double stand_top(double height)
{
    const struct wf_category stand = { .roughness = 0.1 * height };
    return wf_category_factor(&stand, 0.3 * height) / wf_category_factor(wf_category_open(), 10.0);
}

/* A measured tree may stand in a forest; the wind of open country is then far too much for it. */
static void check_site(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_scenario *s = &an->scenario;
    if (an->model->generator != WF_GENERATOR_MEASURED || s->category_said || strcmp(s->profile, "power"))
        return;
    double x[3] = { 0.0, 0.0, an->tallness }, u[3], du[9];
    struct wf_wind wind;
    wf_scenario_wind(s, &wind);
    wind.speed = 1.0;
    wind.sample(&wind, x, u, du);
    double open = hypot(u[0], u[1]), stand = stand_top(an->tallness);
    wf_diag_warn(
        d, "site-assumed",
        "%s: nothing says where the measured tree stands, and the wind of open country is taken. If it "
        "stands in a forest, the mean wind at its top is %.2f instead of %.2f times the wind named, and "
        "the critical wind higher, by up to a factor of %.1f; --site says where it stands",
        an->model->name, stand, open, open / stand);
}

/* Scans are taken of bare trees as a rule. */
static void check_leaves(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_tree *t = &an->tree;
    if (an->model->generator != WF_GENERATOR_MEASURED || an->model->season != WF_LEAF_ON) return;
    for (size_t i = 0; i < t->n; i++)
        if (t->sail0[i] > 0.0 || t->sail1[i] > 0.0 || t->leaf0[i] > 0.0 || t->leaf1[i] > 0.0) return;
    wf_diag_warn(
        d, "no-leaves",
        "%s: the measured tree has neither leaves nor a crown's area, and the wind acts on its wood alone. "
        "In leaf it carries several times that load and fails in a much weaker wind: give the crown "
        "(--crown-width with --crown-depth, --frontal-area, --leaf-area); --leaf-off says that it is bare",
        an->model->name);
}

/* The limits that depend on the wind: site-assumed, no-leaves, streamline-range, profile-range,
 * reynolds-range, steep, map-edge. */
static void limits_wind(const struct wf_analysis *an, struct wf_diag *d)
{
    check_site(an, d);
    check_leaves(an, d);
    check_streamline(an, d);
    wf_limits_profile(&an->scenario, an->tallness, an->model->name, d);
    check_reynolds(an, d);
    wf_limits_site(an->scenario.site, d);
}
