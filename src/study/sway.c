/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/sway.h"
#include "base/arena.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "data/section.h"
#include "data/species.h"
#include "grow/silhouette.h"
#include "load/winter.h"
#include "solve/beam.h"
#include "solve/modes.h"
#include "solve/track.h"
#include "study/peak.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Aerodynamic damping ---- */

static double norm3(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* Mean wind at the middle of a row as it stands in the wind [m/s]. */
static double wind_at(const struct wf_analysis *an, const struct wf_response *r, double speed, size_t i)
{
    const struct wf_tree *t = &an->tree;
    double x[3] = { 0.5 * (t->x0[i] + t->x1[i]), 0.5 * (t->y0[i] + t->y1[i]), 0.5 * (t->z0[i] + t->z1[i]) };
    double u[3], gradient[9];
    struct wf_wind wind = an->wind;
    int32_t below = t->parent[i];
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    for (int k = 0; k < 3; k++)
        x[k] += 0.5 * (r->end[3 * i + (size_t)k] + (below >= 0 ? r->end[3 * below + k] : 0.0));
    wind.sample(&wind, x, u, gradient);
    return norm3(u);
}

/* Mean square over a row of a motion's component along the axis k, linear between its ends. */
static double mean_square(const struct wf_tree *t, const double *shape, size_t i, const double axis[3])
{
    const double *p = shape + 3 * i, *q = t->parent[i] < 0 ? NULL : shape + 3 * t->parent[i];
    double end = 0.0, base = 0.0;
    for (int k = 0; k < 3; k++) end += p[k] * axis[k], base += q ? q[k] * axis[k] : 0.0;
    return (base * base + base * end + end * end) / 3.0;
}

/* Sum over the rows of F/U (2 phi^2 + `crosswise` psi^2): F the wind load of a row, U the mean wind there,
 * phi and psi its motion along the wind and athwart it. A load by the square of the wind relative to the
 * moving tree, in the direction of that wind. */
static double damping_sum(const struct wf_analysis *an, const struct wf_response *r, double speed,
                          double crosswise, const double *shape)
{
    const struct wf_tree *t = &an->tree;
    const double *to = an->wind.direction;
    const double along[3] = { to[0], to[1], 0.0 }, left[3] = { -to[1], to[0], 0.0 },
                 up[3] = { 0.0, 0.0, 1.0 };
    double sum = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        const double *load = r->load + 3 * i;
        double wind = wind_at(an, r, speed, i), force = load[0] * to[0] + load[1] * to[1];
        if (!(wind > 0.0 && force > 0.0)) continue;
        double athwart =
            crosswise > 0.0 ? mean_square(t, shape, i, left) + mean_square(t, shape, i, up) : 0.0;
        sum += force / wind * (2.0 * mean_square(t, shape, i, along) + crosswise * athwart);
    }
    return sum;
}

/* Wind loads on the rows, in a light wind on the tree as it stands in still air [N]. */
static void light_loads(const struct wf_analysis *an, const struct wf_response *still, double speed,
                        double *load)
{
    const struct wf_tree *t = &an->tree;
    struct wf_wind wind = an->wind;
    struct wf_loads loads = an->loads;
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    wf_loads_blow(&loads, &wind);
    for (size_t i = 0; i < t->n; i++) {
        const int32_t below = t->parent[i];
        double from[3] = { t->x0[i], t->y0[i], t->z0[i] }, to[3] = { t->x1[i], t->y1[i], t->z1[i] }, axis[3];
        for (int k = 0; k < 3; k++)
            from[k] += below < 0 ? 0.0 : still->end[3 * below + k], to[k] += still->end[3 * (int32_t)i + k];
        for (int k = 0; k < 3; k++) axis[k] = to[k] - from[k];
        const double length = wf_tree_length(t, i), chord = norm3(axis);
        for (int k = 0; k < 3; k++) axis[k] /= chord, load[3 * i + (size_t)k] = 0.0;
        for (int j = 0; j < 2; j++) {
            const struct wf_line_point point = wf_line_point_of(t, i, gauss_place[j]);
            struct wf_line_parts parts;
            double x[3];
            for (int k = 0; k < 3; k++) x[k] = wf_between(from[k], to[k], gauss_place[j]);
            wf_load_parts_on_line(&loads, &point, x, axis, &parts);
            for (int k = 0; k < 3; k++)
                load[3 * i + (size_t)k] += 0.5 * length * (parts.drag_axis[k] + parts.drag_crown[k]);
        }
    }
}

/* ---- For the peak load ---- */

/* Extent of the wind load across the wind and up: its standard deviation times sqrt(12), which is the width
 * of a uniform load. */
static double breadth_of(const struct wf_analysis *an, const double *load)
{
    const struct wf_tree *t = &an->tree;
    const double *to = an->wind.direction;
    double sum = 0.0, first = 0.0, second = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double y0 = t->y0[i] * to[0] - t->x0[i] * to[1], y1 = t->y1[i] * to[0] - t->x1[i] * to[1];
        double y = 0.5 * (y0 + y1), share = fmax(0.0, load[3 * i] * to[0] + load[3 * i + 1] * to[1]);
        sum += share, first += share * y, second += share * (y * y + (y1 - y0) * (y1 - y0) / 12.0);
    }
    return sum > 0.0 ? sqrt(12.0 * fmax(0.0, second / sum - first * first / (sum * sum))) : 0.0;
}

/* The sway about a state in the mean wind. */
static struct wf_sway sway_of(const struct wf_analysis *an, const struct wf_at_speed *at,
                              const struct wf_modes_sway *m, const double *shape)
{
    const double *tip = shape + 3 * wf_tip_row(&an->tree), *to = an->wind.direction;
    double moved = tip[0] * to[0] + tip[1] * to[1], modal = m->share * m->inertia;
    double air = at->speed > 0.0 ? damping_sum(an, &at->response, at->speed, 0.0, shape) : 0.0;
    return (struct wf_sway){ .speed = at->speed,
                             .frequency = m->frequency,
                             .participation = m->share,
                             .mass = modal / (moved * moved),
                             .air = air / (2.0 * WF_TURN * m->frequency * modal) };
}

/* What a light wind does to the tree in still air, where loads grow with the square of the wind: the slope of
 * the damping by the wind speed, and the extent of the load. */
static enum wf_status take_still(const struct wf_analysis *an, const struct wf_response *still,
                                 const struct wf_modes_sway *m, const double *shape, struct wf_arena *scratch,
                                 struct wf_peak *p, struct wf_err *e)
{
    const double light = 1.0 /* [m/s] */, per = 2.0 * WF_TURN * m->frequency * m->share * m->inertia * light;
    struct wf_response r = *still;
    if (!(r.load = WF_TAKE(scratch, 3 * an->tree.n, double)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
    light_loads(an, still, light, r.load);
    p->air_rises = damping_sum(an, &r, light, 0.0, shape) / per;
    p->tree.breadth = breadth_of(an, r.load);
    return WF_OK;
}

/* Of a sway's frequency: half the width of a mode with a damping of 0.1; and bands for comparison, of damping
 * between 0.08 and 0.125: in a crowd of modes a mode at the edge decides. */
enum { BANDS = 1 + WF_PEAK_OTHERS };
static const double band[BANDS] = { 0.1, 0.08, 0.125 };

/* Add the sway at a speed, with its shapes (3n each). Given: the next speed; with `compared` also those of
 * other bands. Returned: whether the tree has a state in that mean wind. */
static bool add_sway(const struct wf_analysis *an, struct wf_peak *p, struct wf_track *track, double speed,
                     double next, bool compared, double *shape)
{
    struct wf_arena scratch = { 0 };
    struct wf_speed_answers r;
    struct wf_modes_sway m[BANDS];
    struct wf_err why = { 0 };
    const size_t bands = compared ? BANDS : 1;
    const struct wf_track_start near = { .alone = next > WF_TRACK_NEAR * speed };
    enum wf_status s = wf_speed_track(an, WF_PART_MEAN, track, speed, &near, &scratch, &r, &why);
    bool known = !s && !r.at.status && !wf_track_sway(track, an->wind.direction, band, bands, m, shape, &why);
    if (known && speed == 0.0) known = !take_still(an, &r.at.response, &m[0], shape, &scratch, p, &why);
    if (known) p->sway[p->sways++] = sway_of(an, &r.at, &m[0], shape);
    for (size_t k = 1; k < bands && known; k++)
        p->other[p->others++] = sway_of(an, &r.at, &m[k], shape + 3 * an->tree.n * k);
    wf_arena_free(&scratch);
    return known;
}

/* Is a speed among those, or nearer to one than that? */
static bool beside(const double *speed, size_t n, double x, double near)
{
    while (n && fabs(speed[n - 1] - x) > near) n--;
    return n > 0;
}

/* Speeds of sways: still air, the end of the search, the given ones (where they are many some of them, the
 * lowest and the highest among these), and fixed ones that are not near any of these. */
static size_t pick_speeds(const struct wf_analysis *an, const double *given, size_t n, double *out)
{
    const double fixed[] = { 12, 24, 42, 60, 90, 140 }, near = 1, same = 0.05; /* [m/s] */
    const double end = an->search.speed_max, top = fmax(end, n ? given[n - 1] : 0.0);
    const size_t room = WF_PEAK_SWAYS - 2 - WF_COUNT(fixed), some = n < room ? n : room;
    size_t k = 2;
    out[0] = 0.0, out[1] = end;
    for (size_t i = 0; i < some; i++) {
        const double speed = given[some > 1 ? i * (n - 1) / (some - 1) : n - 1];
        if (!beside(out, k, speed, same)) out[k++] = speed;
    }
    for (size_t i = 0; i < WF_COUNT(fixed) && fixed[i] < top; i++)
        if (!beside(out, k, fixed[i], near)) out[k++] = fixed[i];
    return k;
}

static enum wf_status check_request(const struct wf_scenario *s, const struct wf_peak_request *r,
                                    const struct wf_peak_method **method, struct wf_err *e)
{
    *method = wf_peak_method_named(r->method);
    if (!*method) return wf_fail(e, WF_EUSAGE, "unknown peak load '%.100s'", r->method);
    if (!strcmp(r->method, "table") && (!r->table || !r->table->n))
        return wf_fail(e, WF_EUSAGE, "the peak load 'table' needs a table of wind speeds and factors");
    if (!strcmp(r->method, "gales") && !(r->stand.spacing > 0.0))
        return wf_fail(e, WF_EUSAGE, "the peak load 'gales' needs the spacing of the stand (--spacing)");
    if (!strcmp(r->method, "gales") && (s->speed_up != 1.0 || s->site))
        return wf_fail(
            e, WF_EUSAGE,
            "the peak load 'gales' is that of a stand on even ground: without --speed-up and --dem");
    return WF_OK;
}

/* The height of the stand is at least that of the tree: a lower one would let the stand take the load of a
 * tree that stands out of it. */
static enum wf_status take_stand(const struct wf_analysis *an, struct wf_stand *s, struct wf_err *e)
{
    const double least = 0.9; /* rule of ours: a dominant tree over the largest trees' mean height */
    double said = s->height > 0.0 ? s->height : an->tallness;
    s->height = fmax(said, an->tallness);
    if (said >= least * an->tallness) return WF_OK;
    return wf_fail(
        e, WF_EINPUT,
        "the stand is %.4g m high and the tree %.4g m: the peak load 'gales' is that of a tree whose "
        "stand has at least 0.9 of its height. Give the mean height of the stand's largest trees, or "
        "none (the tree's is taken); a tree that stands out of its stand is assessed without a stand",
        said, an->tallness);
}

/* Structural damping: as requested, of the species, or assumed. */
static double take_damping(const struct wf_analysis *an, bool *known)
{
    const double assumed = 0.05;
    const struct wf_value *own = &an->species->level[0].damping_ratio;
    double given = an->scenario.peak.damping;
    *known = !isnan(given) || own->given;
    return !isnan(given) ? given : own->given ? own->value : assumed;
}

/* Mean wind of the tree at a height over the named wind. */
static double profile_at(const struct wf_analysis *an, double z)
{
    const double x[3] = { 0.0, 0.0, z };
    double u[3], gradient[9];
    struct wf_wind wind;
    wf_scenario_wind(&an->scenario, &wind);
    wind.speed = wf_scenario_speed(&an->scenario, 1.0);
    wind.sample(&wind, x, u, gradient);
    return norm3(u);
}

static const double rough = 3e-4; /* of the mesh that sways are found on: with 1e-3 a mode at the edge of the
                                     band of a willow's sway moved its gust factor by 3e-3 */

/* Sways at speeds in rising order, until there is no state in the mean wind. */
struct wf_sway_search {
    const struct wf_analysis *an;
    struct wf_peak *peak;
    struct wf_solve_options coarse;
    struct wf_track *track;
    size_t n, next; /* speeds, and which is the next */
    double at[WF_PEAK_SWAYS];
    double highest; /* specified speed, at which, or at the next below, bands are compared; NAN: they are not,
                       for nobody is told */
    double *first, *shape; /* of the sway in still air, of the next */
};

/* like: as for wf_track_open. */
static enum wf_status open_search(const struct wf_analysis *an, struct wf_peak *p,
                                  const struct wf_solve_options *o, const struct wf_track *like,
                                  double highest, struct wf_arena *a, struct wf_sway_search *q,
                                  struct wf_err *e)
{
    q->an = an, q->peak = p, q->coarse = *o, q->highest = highest;
    q->first = WF_TAKE(a, 3 * an->tree.n, double), q->shape = WF_TAKE(a, BANDS * 3 * an->tree.n, double);
    if (!q->first || !q->shape) return wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
    qsort(q->at, q->n, sizeof *q->at, wf_ascending);
    if (o->mesh_tolerance > 0.0) q->coarse.mesh_tolerance = fmax(o->mesh_tolerance, rough);
    p->more = q, p->partial = true;
    enum wf_status s = wf_track_open(&an->tree, &q->coarse, like, &q->track, e);
    if (!s) p->about = q->track;
    return s;
}

/* No more sways are found. */
static void close_search(struct wf_sway_search *q)
{
    wf_track_close(q->track);
    q->peak->more = NULL, q->peak->about = NULL;
}

/* Are the sways known on which those up to a speed depend: one at it or above? */
static bool covers(const struct wf_sway_search *q, double speed)
{
    const size_t n = q->peak->sways;
    return n >= 2 && q->peak->sway[n - 1].speed >= speed;
}

/* An interrupt leaves sways out. */
static void find_sways(struct wf_sway_search *q, double speed)
{
    while (q->next < q->n && !wf_interrupted() && !covers(q, speed)) {
        const size_t i = q->next++;
        double next = q->next < q->n ? q->at[q->next] : INFINITY;
        bool compared = i > 0 && q->at[i] <= q->highest && next > q->highest;
        if (!add_sway(q->an, q->peak, q->track, q->at[i], next, compared, i ? q->shape : q->first))
            q->next = q->n;
    }
    wf_peak_sways_take(q->peak);
    if (q->peak->sways && q->at[0] == 0.0) q->peak->still = q->first;
    if (q->next == q->n) q->peak->partial = false;
}

void wf_sway_reach(const struct wf_analysis *an, double speed)
{
    if (an->peak && an->peak->more) find_sways(an->peak->more, speed);
}

void wf_sway_end(const struct wf_analysis *an)
{
    if (an->peak && an->peak->more) close_search(an->peak->more);
}

/* Of a tree in a stand: the square of the gust factor 2.1 measured over 15 months at the canopy top of a
 * Sitka spruce plantation (abstract of "Extreme wind speeds over a Sitka spruce plantation in Scotland"). */
static const double stand_factor = 4.4;

/* Where the sway is that of a crowd of modes, and which of them are taken changes the load. */
static void note_crowd(const struct wf_peak *p, const char *name, double speed, struct wf_diag *d)
{
    const double slight = 0.005; /* of the gust load factor */
    double frequency[2], factor[2], taken = wf_peak_gusts(p, speed);
    wf_peak_doubt(p, speed, frequency, factor);
    if (factor[1] - factor[0] <= slight * taken) return;
    wf_diag_warn(
        d, "peak-crowd",
        "%s: in wind of %.3g m/s the tree sways in a crowd of modes, and which of them act together is "
        "not certain: %.3g to %.3g Hz; the gust load factor lies between %.4g and %.4g, and %.4g is "
        "taken",
        name, speed, frequency[0], frequency[1], factor[0], factor[1], taken);
}

/* Where a method is used beyond its validity or on little knowledge, at the highest given wind. */
static void note_limits(const struct wf_analysis *an, const struct wf_peak *p, double speed,
                        struct wf_diag *d)
{
    const double turbulence = 0.35, share = 0.3; /* rules of ours */
    const char *name = an->species->name;
    struct wf_peak_parts at;
    wf_peak_parts_at(p, speed, WF_PART_STEM, &at);
    if (at.gust.turbulence > turbulence)
        wf_diag_warn(
            d, "peak-turbulence",
            "%s: the turbulence intensity %.2f at the tree is above %.2f: the peak load of '%s' is outside "
            "its validity and too low",
            name, at.gust.turbulence, turbulence, p->method->name);
    if (!p->sways)
        wf_diag_warn(d, "peak-sway",
                     "%s: how the tree sways was not found; the frequency of most resonance is taken", name);
    else if (at.participation < share)
        wf_diag_warn(d, "peak-sway",
                     "%s: the modes about %.3g Hz, from which the resonance of gusts is computed, carry %.0f "
                     "%% of the "
                     "overturning by inertia; no sway of the tree carries more (%.0f %% are wanted)",
                     name, at.frequency, 100.0 * at.participation, 100.0 * share);
    note_crowd(p, name, speed, d);
    if (p->least > 0.0)
        wf_diag_warn(
            d, "peak-stand",
            "%s: in a stand or at its edge the peak load of '%s' is outside its validity; the factor is at "
            "least %.2g, from gusts of 2.1 times the mean measured at the top of a Sitka spruce stand. "
            "--spacing takes the peak load 'gales'",
            name, p->method->name, p->least);
    if (!p->damping_known)
        wf_diag_warn(
            d, "peak-damping",
            "%s: the structural damping of its sway is assumed, %.2g of critical; with the air %.2g is taken "
            "(%.2g without our limit). --damping sets it",
            name, p->damping, at.damping, p->damping + fmax(at.air, 0.0));
    if (p->law)
        wf_diag_warn(
            d, "peak-exponent",
            "%s: the load of gusts follows the crown's streamlining law, which was measured in steady wind: "
            "lower load than by the square of the speed",
            name);
}

/* A stand whose crowns are much wider than the ground that each tree has: one of the two is wrong, and the
 * wind's momentum is shared by too many trees. */
static void note_stand(const struct wf_analysis *an, const struct wf_peak *p, struct wf_diag *d)
{
    const double most = 2.0; /* rule of ours */
    double seen = wf_silhouette_size(an->model, an->tallness).breadth, spacing = p->request.stand.spacing;
    double width = sqrt(4.0 / WF_PI * wf_crown_projection(&an->tree, isnan(seen) ? 0.0 : seen));
    if (width > most * spacing)
        wf_diag_warn(
            d, "stand-crowded",
            "%s: the crown is %.3g m wide and the trees of the stand are %.3g m apart: the wind's load "
            "on a tree, which follows from the ground that it has, is too low unless the spacing is "
            "right",
            an->species->name, width, spacing);
}

/* All of a peak but its sways. */
static enum wf_status begin(struct wf_analysis *an, struct wf_arena *a, struct wf_peak **out,
                            struct wf_err *e)
{
    const double ten = 10.0, reached = 0.6; /* [m]; of a tree's height: z_s of EN 1991-1-4 */
    const struct wf_peak_method *method;
    const struct wf_peak_request *r = &an->scenario.peak;
    struct wf_peak *p = *out = WF_TAKE(a, 1, struct wf_peak);
    an->peak = NULL;
    if (!p) return wf_fail(e, WF_ENOMEM, "not enough memory for the peak load");
    enum wf_status s = check_request(&an->scenario, r, &method, e);
    if (s) return s;
    *p = (struct wf_peak){ .method = method, .request = *r, .rule = wf_gust_rule_named(method->name) };
    p->tree =
        (struct wf_gust_case){ .terrain = an->scenario.category, .height = an->tallness, .exponent = 2.0 };
    p->gust = wf_scenario_squall(&an->scenario, fmin(ten, reached * an->tallness));
    if (method->mean) {
        if (take_stand(an, &p->request.stand, e)) return e->code;
        p->top = profile_at(an, p->request.stand.height) / wf_scenario_speed(&an->scenario, 1.0);
        an->wind.sample = wf_profile_named("uniform")->sample;
    }
    p->body = an->tree, p->loads = an->loads, p->wind = an->wind;
    p->exposure = wf_scenario_speed(&an->scenario, 1.0);
    const struct wf_site_kind *kind = wf_site_kind_named(an->scenario.site_kind);
    if (kind && kind->stand) p->least = stand_factor;
    p->damping = take_damping(an, &p->damping_known);
    if (r->exponent_by_law) p->law = an->loads.streamline, p->law_par = an->loads.streamline_par;
    if (method->sways) {
        p->profile = profile_at(an, p->rule->at(p->tree.terrain, p->tree.height));
        p->branches = wf_tree_branched(&an->tree);
    }
    return WF_OK;
}

/* As wf_sway_reach. Errors: WF_EINTERRUPTED where an interrupt left one out: the peak load would be another.
 */
static enum wf_status reach_all(const struct wf_analysis *an, double speed, struct wf_err *e)
{
    wf_sway_reach(an, speed);
    const struct wf_sway_search *left = an->peak ? an->peak->more : NULL;
    return left && left->next < left->n && !covers(left, speed) ? wf_fail(e, WF_EINTERRUPTED, "interrupted")
                                                                : WF_OK;
}

static enum wf_status begin_search(struct wf_analysis *an, const struct wf_solve_options *o,
                                   const struct wf_track *like, const double *speeds, size_t n,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_peak *p;
    struct wf_sway_search *q = WF_TAKE(a, 1, struct wf_sway_search);
    if (!q) return wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
    q->n = pick_speeds(an, speeds, n, q->at);
    const double highest = n ? speeds[n - 1] : 0.0;
    enum wf_status s = begin(an, a, &p, e);
    if (s) return s;
    an->peak = p;
    if (p->method->sways) s = open_search(an, p, o, like, n && d ? highest : NAN, a, q, e);
    if (!s) s = reach_all(an, highest, e);
    if (!s && d && p->method->sways) note_limits(an, p, highest, d);
    if (!s && d && an->model && p->method->mean) note_stand(an, p, d);
    return s;
}

enum wf_status wf_sway_begin(struct wf_analysis *an, const struct wf_solve_options *o, const double *speeds,
                             size_t n, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    return begin_search(an, o, NULL, speeds, n, a, d, e);
}

/* All sways at once. like: as for wf_track_open. */
static enum wf_status set_up(struct wf_analysis *an, const struct wf_solve_options *o,
                             const struct wf_track *like, const double *speeds, size_t n, struct wf_arena *a,
                             struct wf_diag *d, struct wf_err *e)
{
    enum wf_status s = begin_search(an, o, like, speeds, n, a, d, e);
    if (!s) s = reach_all(an, INFINITY, e);
    wf_sway_end(an);
    return s;
}

enum wf_status wf_sway_turned(struct wf_analysis *an, const struct wf_peak *first,
                              const struct wf_solve_options *o, const double *speeds, size_t n,
                              struct wf_arena *a, struct wf_err *e)
{
    return set_up(an, o, first->about, speeds, n, a, NULL, e);
}

enum wf_status wf_sway_set_up(struct wf_analysis *an, const struct wf_solve_options *o, const double *speeds,
                              size_t n, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    return set_up(an, o, NULL, speeds, n, a, d, e);
}

enum wf_status wf_sway_complete(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                                struct wf_err *e)
{
    if (!an->peak || !an->peak->partial || !an->n) return WF_OK;
    double *speeds = WF_TAKE(a, an->n, double);
    if (!speeds) return wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
    for (size_t k = 0; k < an->n; k++) speeds[k] = an->at[k].speed;
    return wf_sway_set_up(an, o, speeds, an->n, a, NULL, e);
}

/* What the sway of a whole tree depends on, by a shape that grows with the square of the height. */
struct swing {
    double compliance; /* of the stem at its top, bending alone [m/N] */
    double mass;       /* of all rows by the square of the shape [kg] */
    double drag;       /* drag area by the square of the shape [m2] */
};

static struct swing swing_of(const struct wf_analysis *an, double speed)
{
    const struct wf_tree *t = &an->tree;
    const struct wf_loads *l = &an->loads;
    double unused, top = t->z0[0] + an->tallness;
    double share =
        l->streamline ? wf_streamline_share(l->streamline, &l->streamline_par, speed, &unused) : 1.0;
    struct swing out = { 0 };
    for (size_t i = 0; i < t->n; i++) {
        double z = 0.5 * (t->z0[i] + t->z1[i]), length = wf_tree_length(t, i), arm = top - z;
        double moves = pow((z - t->z0[0]) / an->tallness, 4.0);
        double r = 0.5 * (t->r0[i] + t->r1[i]), hole = 0.5 * (t->i0[i] + t->i1[i]);
        if (t->level[i] == 0)
            out.compliance += length * arm * arm / (t->youngs[i] * wf_ring_inertia(r, hole));
        out.mass += moves * length * wf_line_point_of(t, i, 0.5).mass;
        out.drag += moves * length * (2.0 * r + 0.5 * share * (t->sail0[i] + t->sail1[i]));
    }
    out.drag *= l->wind_scale;
    return out;
}

/* The sways of another tree, by the ratios of what they depend on. */
static void take_alike(struct wf_peak *p, const struct wf_peak *like, const struct swing *own,
                       const struct swing *other)
{
    double mass = own->mass / other->mass;
    double frequency = sqrt(other->compliance / own->compliance / mass);
    double air = own->drag / other->drag / (mass * frequency);
    p->sways = like->sways, p->others = 0;
    p->tree.breadth = like->tree.breadth, p->air_rises = like->air_rises * air;
    for (size_t i = 0; i < p->sways; i++) {
        p->sway[i] = like->sway[i];
        p->sway[i].frequency *= frequency, p->sway[i].mass *= mass, p->sway[i].air *= air;
    }
    wf_peak_sways_take(p);
}

enum wf_status wf_sway_alike(struct wf_analysis *an, const struct wf_analysis *like, double speed,
                             struct wf_arena *a, struct wf_peak **out, struct wf_err *e)
{
    enum wf_status s = begin(an, a, out, e);
    if (s) return s;
    const struct swing own = swing_of(an, speed), other = swing_of(like, speed);
    if ((*out)->method->sways) take_alike(*out, like->peak, &own, &other);
    an->peak = *out;
    return WF_OK;
}

/* ---- Modes ---- */

/* Damping of the wood in a motion: that of the rows by their mass and the square of their motion; a row whose
 * wood has none of its own has the stem's. */
static double structural_of(const struct wf_analysis *an, const double *shape, double stem)
{
    static const double axis[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    const struct wf_tree *t = &an->tree;
    double sum = 0.0, all = 0.0;
    if (!isnan(an->scenario.peak.damping) || !an->species->level[0].damping_ratio.given) return stem;
    for (size_t i = 0; i < t->n; i++) {
        double mass = wf_line_point_of(t, i, 0.5).mass * wf_tree_length(t, i), square = 0.0;
        if (t->mass1) mass += t->mass1[i];
        for (int k = 0; k < 3; k++) square += mean_square(t, shape, i, axis[k]);
        sum += mass * square * (t->damping[i] > 0.0 ? t->damping[i] : stem), all += mass * square;
    }
    return all > 0.0 ? sum / all : stem;
}

/* Two modes of almost one frequency, both of modal mass 1, mix at will: the first becomes the one with all of
 * their overturning along the wind. */
static void turn_pair(struct wf_modes_part part[2], double *p, double *q, size_t size)
{
    double angle = atan2(part[1].turn[0], part[0].turn[0]), c = cos(angle), s = sin(angle);
    struct wf_modes_part first = part[0], second = part[1];
    for (int k = 0; k < 3; k++) {
        part[0].mass[k] = c * first.mass[k] + s * second.mass[k];
        part[1].mass[k] = c * second.mass[k] - s * first.mass[k];
    }
    for (int k = 0; k < 2; k++) {
        part[0].turn[k] = c * first.turn[k] + s * second.turn[k];
        part[1].turn[k] = c * second.turn[k] - s * first.turn[k];
    }
    for (size_t i = 0; i < size; i++) {
        double a = p[i], b = q[i];
        p[i] = c * a + s * b, q[i] = c * b - s * a;
    }
}

/* Make the largest component of a shape 1. Returned: what it was. */
static double scale_shape(double *shape, size_t size)
{
    double most = 0.0;
    for (size_t i = 0; i < size; i++)
        if (fabs(shape[i]) > fabs(most)) most = shape[i];
    for (size_t i = 0; i < size && most != 0.0; i++) shape[i] /= most;
    return most;
}

/* A mode from its shape of modal mass 1, which gets its largest component 1. */
static struct wf_sway_mode mode_of(const struct wf_analysis *an, const struct wf_response *r, double speed,
                                   double frequency, const struct wf_modes_part *part, double *shape)
{
    const double *tip = shape + 3 * wf_tip_row(&an->tree);
    struct wf_sway_mode out = { .frequency = frequency, .shape = shape };
    bool known;
    double moved = norm3(tip), stem = take_damping(an, &known);
    double air = speed > 0.0 ? damping_sum(an, r, speed, 1.0, shape) : 0.0;
    for (int k = 0; k < 3; k++) out.share[k] = part->mass[k] * part->mass[k];
    for (int k = 0; k < 2; k++) out.turn[k] = part->turn[k] * part->turn[k];
    out.structural = structural_of(an, shape, stem);
    out.air = frequency > 0.0 ? air / (2.0 * WF_TURN * frequency) : NAN;
    out.damping = frequency > 0.0 ? wf_peak_damping(out.structural, known, out.air) : NAN;
    double most = scale_shape(shape, 3 * an->tree.n);
    out.mass = moved > 0.1 * fabs(most) ? 1.0 / (moved * moved) : NAN;
    return out;
}

/* The sway of the whole tree, of that shape. */
static void take_sway(const struct wf_analysis *an, const struct wf_sway *sway, double *shape,
                      struct wf_sway_modes *out)
{
    out->sway = *sway;
    double stem = take_damping(an, &out->damping_known);
    out->shape = shape;
    out->damping = wf_peak_damping(structural_of(an, shape, stem), out->damping_known, out->sway.air);
    (void)scale_shape(shape, 3 * an->tree.n);
}

/* The state in the mean wind, with its loads, and the sway of the whole tree about it. Of still air the loads
 * are left out where the sway is known. */
static enum wf_status find_state(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                                 struct wf_arena *a, struct wf_response *r, struct wf_sway_modes *out,
                                 struct wf_err *e)
{
    struct wf_speed_answers at;
    struct wf_modes_sway m;
    struct wf_track *track;
    double *shape = WF_TAKE(a, 3 * an->tree.n, double);
    if (!shape) return wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
    if (!(speed > 0.0) && an->peak && an->peak->still &&
        !(o->mesh_tolerance < rough && o->mesh_tolerance > 0.0)) {
        memcpy(shape, an->peak->still, 3 * an->tree.n * sizeof *shape);
        take_sway(an, &an->peak->sway[0], shape, out);
        return WF_OK;
    }
    enum wf_status s = wf_track_open(&an->tree, o, NULL, &track, e);
    if (s) return s;
    s = wf_speed_track(an, WF_PART_MEAN, track, speed, NULL, a, &at, e);
    if (!s && at.at.status) s = wf_fail(e, at.at.status, "%s", wf_status_text(at.at.status));
    if (!s) s = wf_track_sway(track, an->wind.direction, band, 1, &m, shape, e);
    wf_track_close(track);
    if (s) return s;
    *r = at.at.response;
    const struct wf_sway sway = sway_of(an, &at.at, &m, shape);
    take_sway(an, &sway, shape, out);
    return WF_OK;
}

enum wf_status wf_sway_modes(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                             size_t most, size_t count, struct wf_arena *a, struct wf_sway_modes *out,
                             struct wf_err *e)
{
    const double alike = 0.01; /* relative difference of frequencies that are almost one */
    const size_t size = 3 * an->tree.n;
    struct wf_wind wind = an->wind;
    struct wf_loads loads = an->loads;
    struct wf_response r = { 0 };
    size_t found = count + 2; /* the last one wanted may have a companion of its frequency */
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    wf_loads_blow(&loads, &wind);
    double *frequency = WF_TAKE(a, found, double), *shape = WF_TAKE(a, found * size, double);
    struct wf_modes_part *part = WF_TAKE(a, found, struct wf_modes_part);
    struct wf_sway_mode *mode = WF_TAKE(a, count, struct wf_sway_mode);
    if (!frequency || !shape || !part || !mode)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", count);
    *out = (struct wf_sway_modes){ .mode = mode };
    enum wf_status s = find_state(an, o, speed, a, &r, out, e);
    if (!s)
        s = wf_modes_parts(&an->tree, &loads, o, most, &found, an->wind.direction, a, frequency, part, shape,
                           e);
    if (s) return s;
    for (size_t k = 0; k + 1 < found; k++)
        if (fabs(frequency[k + 1] - frequency[k]) <= alike * fabs(frequency[k])) {
            turn_pair(part + k, shape + k * size, shape + (k + 1) * size, size);
            k++;
        }
    out->count = found < count ? found : count;
    for (size_t k = 0; k < out->count; k++)
        mode[k] = mode_of(an, &r, speed, frequency[k], &part[k], shape + k * size);
    return WF_OK;
}
