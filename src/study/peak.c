/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/peak.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include <math.h>
#include <string.h>

static void parts_none(struct wf_peak_parts *out)
{
    *out = (struct wf_peak_parts){ .factor = 1.0,
                                   .frequency = NAN,
                                   .participation = NAN,
                                   .mass = NAN,
                                   .damping = NAN,
                                   .air = NAN,
                                   .gust = { NAN, NAN, NAN, NAN, NAN, NAN } };
}

/* ---- Sways ---- */

static void columns(const struct wf_peak *p, double speed[], double frequency[], double air[])
{
    for (size_t i = 0; i < p->sways; i++) {
        speed[i] = p->sway[i].speed;
        frequency[i] = p->sway[i].frequency;
        air[i] = p->sway[i].air;
    }
}

/* The slopes by which a curve through the sways leaves each of them upwards: those of wf_curve_slopes, from
 * the next sway below that is not so near that the slope would be that of rounding; where the curve has
 * turned below, that of the chord above. */
static void slopes_upwards(size_t n, const double *speed, const double *value, double *slope)
{
    const double near = 1.0; /* [m/s] */
    slope[0] = (value[1] - value[0]) / (speed[1] - speed[0]);
    slope[n - 1] = 0.0; /* nothing is above */
    for (size_t i = 1; i + 1 < n; i++) {
        size_t k = i - 1;
        while (k && speed[i] - speed[k] < near) k--;
        const double x[] = { speed[k], speed[i], speed[i + 1] }, y[] = { value[k], value[i], value[i + 1] };
        double at[3];
        wf_curve_slopes(3, x, y, at);
        slope[i] = at[1] != 0.0 ? at[1] : (y[2] - y[1]) / (x[2] - x[1]);
    }
}

void wf_peak_sways_take(struct wf_peak *p)
{
    double speed[WF_PEAK_SWAYS], frequency[WF_PEAK_SWAYS], air[WF_PEAK_SWAYS];
    columns(p, speed, frequency, air);
    if (p->sways < 2) return;
    slopes_upwards(p->sways, speed, frequency, p->slope[0]);
    slopes_upwards(p->sways, speed, air, p->slope[1]);
    if (speed[0] == 0.0) p->slope[0][0] = 0.0; /* loads grow with the square of the wind */
}

/* Index of the last sway at or below a speed, at most the last but one. */
static size_t sway_below(size_t n, const double *speed, double at)
{
    size_t i = 0;
    while (i + 2 < n && at >= speed[i + 1]) i++;
    return i;
}

/* A number of the sway between two of them: a parabola with the slope of the curve at the lower one, which
 * does not overshoot (that slope is at most twice the chord's) and depends on no sway above the two. */
static double between(size_t n, const double *speed, const double *value, const double *slope, double at)
{
    const size_t i = sway_below(n, speed, at);
    const double width = speed[i + 1] - speed[i], rise = value[i + 1] - value[i];
    const double s = fmin(fmax((at - speed[i]) / width, 0.0), 1.0), tangent = width * slope[i];
    return value[i] + s * (tangent + s * (rise - tangent));
}

/* Damping of the air. Above still air a parabola that begins with that of a light wind, up to that of the
 * first sway: the maximum that crowns which streamline have between is left out, on the safe side. Where it
 * falls it does so ever more slowly, by equal ratios: a parabola would be too high. */
static double air_at(const struct wf_peak *p, const double *speed, const double *air, double at)
{
    const size_t i = sway_below(p->sways, speed, at);
    const double *value = air + i, s = fmin(fmax((at - speed[i]) / (speed[i + 1] - speed[i]), 0.0), 1.0);
    if (i == 0 && speed[0] == 0.0) {
        const double begin = p->air_rises * speed[1];
        return fmin(value[1], s * (begin + s * (value[1] - begin)));
    }
    if (value[1] > 0.0 && value[1] < value[0]) return value[0] * pow(value[1] / value[0], s);
    return between(p->sways, speed, air, p->slope[1], at);
}

/* Frequency and aerodynamic damping at a speed; participation and mass are those of the nearest speed. */
static struct wf_sway sway_at(const struct wf_peak *p, double at)
{
    double speed[WF_PEAK_SWAYS], frequency[WF_PEAK_SWAYS], air[WF_PEAK_SWAYS];
    struct wf_sway out = p->sway[0];
    for (size_t i = 1; i < p->sways; i++)
        if (fabs(p->sway[i].speed - at) < fabs(out.speed - at)) out = p->sway[i];
    if (p->sways < 2) return out;
    columns(p, speed, frequency, air);
    out.frequency = between(p->sways, speed, frequency, p->slope[0], at);
    out.air = air_at(p, speed, air, at);
    return out;
}

/* Frequency at which the spectrum of EN 1991-1-4 has most energy. */
static double most_resonant(const struct wf_peak *p, double mean)
{
    double z = p->rule->at(p->tree.terrain, p->tree.height);
    return 0.147 * mean / wf_category_length(p->tree.terrain, z);
}

/* ---- Methods ---- */

static void parts_mean(const struct wf_peak *p, double speed, enum wf_part part, struct wf_peak_parts *out)
{
    (void)p, (void)speed, (void)part;
    parts_none(out);
}

static void parts_table(const struct wf_peak *p, double speed, enum wf_part part, struct wf_peak_parts *out)
{
    const struct wf_peak_table *t = p->request.table;
    size_t i = 1;
    (void)part;
    parts_none(out);
    while (i + 1 < t->n && speed >= t->speed[i]) i++;
    double s = t->n < 2 ? 0.0 : (speed - t->speed[i - 1]) / (t->speed[i] - t->speed[i - 1]);
    out->factor =
        t->n < 2 ? t->factor[0] : wf_between(t->factor[i - 1], t->factor[i], fmin(fmax(s, 0.0), 1.0));
}

static void parts_stand(const struct wf_peak *p, double speed, enum wf_part part, struct wf_peak_parts *out)
{
    (void)speed, (void)part;
    parts_none(out);
    const struct wf_stand *s = &p->request.stand;
    out->factor = wf_stand_gust(s->height, s->spacing, s->edge, s->gap);
}

/* Moment about the ground of the wind load on the tree at rest, along the wind, and the drag area of its
 * crown in the wind at the canopy top: that of its leaves, or of its bare axes where that is more. */
static double own_moment(const struct wf_peak *p, double speed, double *area, double *top)
{
    static const double gauss[2] = { 0.21132486540518712, 0.78867513459481288 };
    const struct wf_tree *t = &p->body;
    struct wf_wind wind = p->wind;
    struct wf_loads loads = p->loads;
    double moment = 0.0, u[3], gradient[9], unused, high[3] = { 0.0, 0.0, p->request.stand.height };
    wind.speed = speed * p->exposure * p->top;
    loads.wind = &wind;
    wind.sample(&wind, high, u, gradient);
    *top = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    double leaves = 0.0, axes = 0.0, pressure = 0.5 * loads.air_density * *top * *top;
    double share =
        loads.streamline ? wf_streamline_share(loads.streamline, &loads.streamline_par, *top, &unused) : 1.0;
    for (size_t i = 0; i < t->n; i++) {
        const double from[3] = { t->x0[i], t->y0[i], t->z0[i] }, to[3] = { t->x1[i], t->y1[i], t->z1[i] };
        double axis[3], length = wf_tree_length(t, i);
        for (int k = 0; k < 3; k++) axis[k] = (to[k] - from[k]) / length;
        for (int j = 0; j < 2; j++) {
            struct wf_line_point point = wf_line_point_of(t, i, gauss[j]);
            struct wf_line_parts parts;
            double x[3], axis_along = 0.0, along = 0.0;
            for (int k = 0; k < 3; k++) x[k] = wf_between(from[k], to[k], gauss[j]);
            wf_load_parts_on_line(&loads, &point, x, axis, &parts);
            for (int k = 0; k < 2; k++) {
                axis_along += parts.drag_axis[k] * wind.direction[k];
                along += (parts.drag_axis[k] + parts.drag_crown[k]) * wind.direction[k];
            }
            moment += 0.5 * length * along * x[2];
            axes += 0.5 * length * axis_along / pressure;
            leaves += 0.5 * length * point.sail * share;
        }
    }
    *area = fmax(leaves, axes);
    return moment;
}

/* The mean load that a stand lets a tree have, over that of the profile on the tree alone. */
static double mean_stand(const struct wf_peak *p, double speed)
{
    const struct wf_stand *s = &p->request.stand;
    double area, top, own = own_moment(p, fmax(speed, 0.5), &area, &top);
    if (!(own > 0.0)) return 0.0; /* nothing meets the wind */
    return wf_stand_moment(p->loads.air_density, top, s->height, s->spacing, area) / own;
}

double wf_peak_damping(double structural, bool known, double air)
{
    const double most = 0.20, most_unknown = 0.10;
    return fmin(structural + fmax(air, 0.0), known ? most : most_unknown);
}

/* Exponent of the crown's load between the mean wind and a gust of `ratio` times its speed. */
static double secant_exponent(const struct wf_peak *p, double mean, double ratio)
{
    double unused, at = wf_streamline_share(p->law, &p->law_par, mean, &unused);
    double gust = wf_streamline_share(p->law, &p->law_par, mean * ratio, &unused);
    return fmax(0.0, 2.0 + log(gust / at) / log(ratio));
}

/* Given: the sway; NULL: unknown. */
static void parts_swaying(const struct wf_peak *p, double speed, enum wf_part part,
                          const struct wf_sway *sway, struct wf_peak_parts *out)
{
    const double least = 0.5; /* [m/s] */
    struct wf_gust_case c = p->tree;
    c.open = fmax(speed, least);
    c.mean = fmax(speed * p->profile, least);
    parts_none(out);
    if (sway) {
        out->frequency = sway->frequency;
        out->participation = sway->participation;
        out->mass = sway->mass;
        out->air = sway->air;
    } else {
        out->frequency = most_resonant(p, c.mean);
    }
    c.frequency = out->frequency;
    c.damping = out->damping = wf_peak_damping(p->damping, p->damping_known, sway ? out->air : 0.0);
    c.small = part == WF_PART_BRANCHES;
    p->rule->parts(&c, &out->gust);
    if (p->law) {
        c.exponent = secant_exponent(p, c.mean, sqrt(out->gust.factor));
        p->rule->parts(&c, &out->gust);
    }
    out->factor = fmax(out->gust.factor, p->least);
}

/* Do other modes take over between a sway and the next? Trees stiffen with the wind as they hang from their
 * base, by less than this, and hardly soften. At which speed is not known. */
static bool changes(const struct wf_sway *s)
{
    const double stiffer = 1.5, softer = 0.9, ratio = s[1].frequency / s[0].frequency;
    return ratio > stiffer || ratio < softer;
}

/* The lower of the sways on both sides of a speed, where modes change between them. NULL: they do not. */
static const struct wf_sway *before_change(const struct wf_peak *p, double at)
{
    for (size_t i = 0; i + 1 < p->sways; i++)
        if (p->sway[i].speed < at && at < p->sway[i + 1].speed)
            return changes(&p->sway[i]) ? &p->sway[i] : NULL;
    return NULL;
}

/* The sway `s` of the upper or lower of two speeds at another between them. The damping of the air grows with
 * the wind: that of the lower is kept, that of the upper is in proportion; above still air it is that without
 * a change of modes. */
static struct wf_sway sway_moved(const struct wf_peak *p, const struct wf_sway *s, double at)
{
    struct wf_sway out = *s;
    out.speed = at;
    if (at < p->sway[1].speed && p->sway[0].speed == 0.0)
        out.air = sway_at(p, at).air;
    else if (at < s->speed)
        out.air *= at / s->speed;
    return out;
}

/* From which speed on the upper sway may have taken over: its modes do so when their share is the larger one.
 * The share of the lower, where it falls, is followed as it fell before, and only part of the way is trusted.
 */
static double takes_over(const struct wf_peak *p, const struct wf_sway *below)
{
    const double trusted = 0.6, share = below[0].participation,
                 fell = below[0].participation - below[1].participation;
    if (below == p->sway || changes(below - 1) || !(fell > 0.0)) return below[0].speed;
    const double falls = (below[-1].participation - share) / (below[0].speed - below[-1].speed);
    return falls > 0.0 ? below[0].speed + trusted * fell / falls : below[0].speed;
}

/* The sway at a speed between two where modes change: that of the two with the larger factor in the middle.
 * That of the upper begins where it may have taken over, that of the lower lasts to the end, but for an edge.
 */
static struct wf_sway safe_sway(const struct wf_peak *p, const struct wf_sway *below, double at,
                                enum wf_part part)
{
    const double width = below[1].speed - below[0].speed, edge = 0.05 * width,
                 middle = below[0].speed + 0.5 * width, end = below[1].speed - edge;
    double factor[2];
    for (int k = 0; k < 2; k++) {
        const struct wf_sway sway = sway_moved(p, &below[k], middle);
        struct wf_peak_parts parts;
        parts_swaying(p, middle, part, &sway, &parts);
        factor[k] = parts.factor;
    }
    const bool early = factor[1] > factor[0];
    const double from = early ? fmin(takes_over(p, below), end) : end,
                 share = fmin(fmax((at - from) / edge, 0.0), 1.0);
    const struct wf_sway low = early ? sway_at(p, at) : sway_moved(p, &below[0], at),
                         high = sway_moved(p, &below[1], at);
    struct wf_sway out = share < 0.5 ? low : high;
    out.frequency = wf_between(low.frequency, high.frequency, share);
    out.air = wf_between(low.air, high.air, share);
    return out;
}

static void parts_rule(const struct wf_peak *p, double speed, enum wf_part part, struct wf_peak_parts *out)
{
    struct wf_sway sway = { 0 };
    const struct wf_sway *below = p->sways ? before_change(p, speed) : NULL;
    if (p->sways) sway = below ? safe_sway(p, below, speed, part) : sway_at(p, speed);
    parts_swaying(p, speed, part, p->sways ? &sway : NULL, out);
}

void wf_peak_doubt(const struct wf_peak *p, double speed, double frequency[2], double factor[2])
{
    struct wf_peak_parts parts;
    wf_peak_parts_at(p, speed, WF_PART_STEM, &parts);
    frequency[0] = frequency[1] = parts.frequency;
    factor[0] = factor[1] = parts.factor;
    for (size_t k = 0; p && k < p->others; k++) {
        parts_swaying(p, speed, WF_PART_STEM, &p->other[k], &parts);
        frequency[0] = fmin(frequency[0], parts.frequency),
        frequency[1] = fmax(frequency[1], parts.frequency);
        factor[0] = fmin(factor[0], parts.factor), factor[1] = fmax(factor[1], parts.factor);
    }
}

static const char steady[] = "The steady wind alone: no gusts, no resonance. Loads of real wind are higher";

const struct wf_peak_method wf_peak_methods[] = {
    { "en1991", "peak load by the gust response factor of EN 1991-1-4", "EN 1991-1-4:2005 + A1:2010, Annex B",
      "single tree or edge of a group; turbulence intensity up to 0.35; linear response of one mode about "
      "the "
      "state in the mean wind",
      true, false, parts_rule, NULL },
    { "mean", "mean wind, steady", "-", steady, false, false, parts_mean, NULL },
    { "gust", "steady wind of the gust's speed", "EN 1991-1-4:2005, 4.5",
      "no resonance, no size reduction: the gust lasts until the tree rests in it", false, true, parts_mean,
      NULL },
    { "table", "factor on the mean wind load from a table", "the table given", "as the table", false, false,
      parts_table, NULL },
    { "gb50009", "peak load by the wind vibration factor of GB 50009", "GB 50009-2012, 8.4", "as the code",
      true, false, parts_rule, NULL },
    { "asce7", "peak load by the gust effect of ASCE 7", "ASCE/SEI 7-16, 26.11.5",
      "as the code; factor of the hourly mean, taken on the 10-min mean", true, false, parts_rule, NULL },
    { "gales", "largest over mean moment in a stand",
      "Gardiner, Peltola & Kellomaki 2000, Ecol. Model. 129:1",
      "tree in a stand or at its edge; the mean moment is that of the momentum which the stand takes from "
      "the wind, well "
      "inside it; the wind is the mean at the canopy top",
      false, false, parts_stand, mean_stand },
    { 0 },
};

const struct wf_peak_method *wf_peak_method_named(const char *name)
{
    for (const struct wf_peak_method *m = wf_peak_methods; m->name; m++)
        if (strcmp(m->name, name) == 0) return m;
    return NULL;
}

enum { TABLE_MAX = 1000 };

/* The next row of a table, checked. */
static void read_row(struct wf_csv *csv, size_t speeds, double unit, size_t factors, size_t n, double *speed,
                     double *factor)
{
    const double most = 20.0;
    if (!wf_column_number(csv, speeds, unit, 0.0, 200.0, &speed[n]) ||
        !wf_column_number(csv, factors, 1.0, 1.0, most, &factor[n]))
        return;
    if (n && speed[n] <= speed[n - 1])
        wf_csv_mistake(csv, speeds, "speeds must ascend; %.6g m/s follows %.6g m/s", speed[n], speed[n - 1]);
}

enum wf_status wf_peak_table_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_peak_table *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    struct wf_units *units;
    double unit = 1.0, *speed = WF_TAKE(a, TABLE_MAX, double), *factor = WF_TAKE(a, TABLE_MAX, double);
    size_t errors = d->errors, n = 0;
    if (!speed || !factor) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a table", path);
    enum wf_status s = wf_csv_open(&csv, path, a, d, e);
    if (!s) s = wf_units_open(&units, e);
    if (s) return s;
    size_t speeds = wf_column_need(&csv, units, "speed_ms", WF_DIM_SPEED, &unit, e);
    size_t factors = wf_csv_need(&csv, "factor");
    wf_units_close(units);
    while (d->errors == errors && n < TABLE_MAX && wf_csv_next(&csv))
        read_row(&csv, speeds, unit, factors, n, speed, factor), n++;
    if (d->errors == errors && !n) wf_diag_error(d, path, 0, 0, "the table has no rows");
    if (d->errors == errors && n == TABLE_MAX && wf_csv_next(&csv))
        wf_diag_error(d, path, 0, 0, "the table has more than %d rows", (int)TABLE_MAX);
    *out = (struct wf_peak_table){ n, speed, factor };
    return d->errors > errors ? wf_fail(e, WF_EINPUT, "%s: not a table of factors", path) : WF_OK;
}

/* ---- For an analysis ---- */

void wf_peak_parts_at(const struct wf_peak *p, double speed, enum wf_part part, struct wf_peak_parts *out)
{
    if (!p || part == WF_PART_MEAN)
        parts_none(out);
    else
        p->method->parts(p, speed, part, out);
}

double wf_peak_factor(const struct wf_peak *p, double speed, enum wf_part part)
{
    struct wf_peak_parts parts;
    wf_peak_parts_at(p, speed, part, &parts);
    return parts.factor * (p && p->method->mean ? p->method->mean(p, speed) : 1.0);
}

double wf_peak_gusts(const struct wf_peak *p, double speed)
{
    struct wf_peak_parts parts;
    wf_peak_parts_at(p, speed, WF_PART_STEM, &parts);
    return parts.factor;
}

double wf_peak_wind(const struct wf_peak *p, enum wf_part part)
{
    if (!p) return 1.0;
    if (p->method->mean)
        return p->top; /* on the whole tree: bent in a gust, its crown is not in calmer air */
    return p->method->by_gust && part != WF_PART_MEAN ? p->gust : 1.0;
}

bool wf_peak_differs(const struct wf_peak *p) { return p && strcmp(p->method->name, "mean") != 0; }
