/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/hollow.h"
#include "base/num.h"
#include <math.h>

/* Radius 0: straight from `from` to `to`. Else an arc about the centre; the sound wood is to its left. */
struct wf_hollow_edge {
    double from[2], to[2], centre[2], radius, start, sweep;
};

static struct wf_hollow_edge line(double x0, double y0, double x1, double y1)
{
    return (struct wf_hollow_edge){ .from = { x0, y0 }, .to = { x1, y1 } };
}

static struct wf_hollow_edge arc(double cx, double cy, double r, double start, double sweep)
{
    return (struct wf_hollow_edge){ .from = { cx + r * cos(start), cy + r * sin(start) },
                                    .to = { cx + r * cos(start + sweep), cy + r * sin(start + sweep) },
                                    .centre = { cx, cy },
                                    .radius = r,
                                    .start = start,
                                    .sweep = sweep };
}

/* Point and derivative at share u of an edge. */
static void edge_at(const struct wf_hollow_edge *g, double u, double p[2], double slope[2])
{
    double angle = g->start + u * g->sweep;
    if (g->radius > 0) {
        p[0] = g->centre[0] + g->radius * cos(angle), p[1] = g->centre[1] + g->radius * sin(angle);
        slope[0] = -g->radius * g->sweep * sin(angle), slope[1] = g->radius * g->sweep * cos(angle);
        return;
    }
    for (int k = 0; k < 2; k++) p[k] = wf_between(g->from[k], g->to[k], u), slope[k] = g->to[k] - g->from[k];
}

/* Integrals over the area by Green's theorem, along an edge: 1, x, y, x x, y y, x y. Gauss' rule of three
 * points is exact for straight edges; arcs are cut at steps of 2 degrees, which leaves 1e-11. */
static void add_edge(const struct wf_hollow_edge *g, double sum[6])
{
    static const double place[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 },
                        weight[3] = { 5. / 18, 8. / 18, 5. / 18 };
    int pieces = g->radius > 0 ? 1 + (int)(fabs(g->sweep) * 90 / WF_PI) : 1;
    for (int i = 0; i < pieces; i++)
        for (int k = 0; k < 3; k++) {
            double p[2], d[2], w = weight[k] / pieces;
            edge_at(g, (i + place[k]) / pieces, p, d);
            double x = p[0], y = p[1];
            sum[0] += w * 0.5 * (x * d[1] - y * d[0]);
            sum[1] += w * 0.5 * x * x * d[1];
            sum[2] -= w * 0.5 * y * y * d[0];
            sum[3] += w * x * x * x * d[1] / 3;
            sum[4] -= w * y * y * y * d[0] / 3;
            sum[5] += w * 0.5 * x * x * y * d[1];
        }
}

static enum wf_status integrate(struct wf_hollow *h, struct wf_err *e)
{
    double s[6] = { 0 };
    for (size_t i = 0; i < h->edges; i++) add_edge(&h->edge[i], s);
    h->area = s[0];
    if (!(h->area > 1e-6)) return wf_fail(e, WF_EINPUT, "no sound wood is left of the section");
    h->centroid[0] = s[1] / s[0], h->centroid[1] = s[2] / s[0];
    h->xx = s[3] - s[1] * h->centroid[0];
    h->yy = s[4] - s[2] * h->centroid[1];
    h->xy = s[5] - s[1] * h->centroid[1];
    return WF_OK;
}

/* ---- The wall, for torsion ---- */

/* Integrals along the middle of the wall: of ds/t and t^3 ds, area within. */
struct wall {
    double by_thickness, cubes, within, least, most;
    bool open;
};

/* Add the wall between two rays: points of its middle, thickness there. */
static void add_wall(struct wall *w, const double a[2], const double b[2], double ta, double tb)
{
    double t = 0.5 * (ta + tb), length = hypot(b[0] - a[0], b[1] - a[1]);
    w->least = fmin(w->least, fmin(ta, tb)), w->most = fmax(w->most, fmax(ta, tb));
    w->within += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    if (!(ta > 0 && tb > 0)) w->open = true;
    if (!(t > 0)) return;
    w->by_thickness += length / t;
    w->cubes += length * t * t * t;
}

static void set_torsion(const struct wall *w, struct wf_hollow *h)
{
    double polar = h->xx + h->yy; /* an upper bound of every section's */
    double closed = 4 * w->within * w->within / w->by_thickness + w->cubes / 4;
    h->torsion = fmin(w->open ? w->cubes / 3 : closed, polar);
    h->twist = w->open ? h->torsion / w->most : fmin(2 * w->within * w->least, h->torsion / h->radius);
}

/* ---- A round stem with a round cavity ---- */

/* Distance from a point within the circle of radius 1 to it, along a direction. */
static double way_out(const double from[2], double angle)
{
    double along = from[0] * cos(angle) + from[1] * sin(angle),
           across = from[0] * sin(angle) - from[1] * cos(angle);
    return sqrt(1 - across * across) - along;
}

/* Direction from the axis of the place where a ray from the cavity's centre leaves the stem. */
static double leaves_at(const double centre[2], double angle)
{
    double way = way_out(centre, angle);
    return atan2(centre[1] + way * sin(angle), centre[0] + way * cos(angle));
}

static void round_wall(struct wf_hollow *h, const double centre[2], double cavity, double start, double sweep)
{
    enum { STEPS = 2880 };
    struct wall w = { .least = INFINITY, .open = h->open };
    double before[2] = { 0 }, thick = 0;
    for (int k = 0; k <= STEPS; k++) {
        double angle = start + sweep * k / STEPS, t = way_out(centre, angle) - cavity, r = cavity + 0.5 * t;
        double at[2] = { centre[0] + r * cos(angle), centre[1] + r * sin(angle) };
        if (k) add_wall(&w, before, at, thick, t);
        before[0] = at[0], before[1] = at[1], thick = t;
    }
    double thinnest = fmod(atan2(centre[1], centre[0]) - start + 3 * WF_TURN, WF_TURN);
    if (thinnest <= sweep) w.least = 1 - cavity - hypot(centre[0], centre[1]);
    h->wall = w.least;
    set_torsion(&w, h);
}

enum wf_status wf_hollow_round(double cavity, double offset, double towards, double opening, double facing,
                               struct wf_arena *a, struct wf_hollow *out, struct wf_err *e)
{
    const double c[2] = { offset * cos(towards), offset * sin(towards) };
    const double start = facing + 0.5 * opening, sweep = WF_TURN - opening;
    *out = (struct wf_hollow){ .radius = 1, .open = opening > 0 };
    if (!(cavity > 0 && offset >= 0 && cavity + offset < 1))
        return wf_fail(e, WF_EINPUT, "the cavity is not within the stem");
    if (!(opening >= 0 && sweep > 0)) return wf_fail(e, WF_EINPUT, "the opening leaves no wall");
    if (!(out->edge = WF_TAKE(a, 4, struct wf_hollow_edge)))
        return wf_fail(e, WF_ENOMEM, "no memory for a section");
    double first = leaves_at(c, start), last = leaves_at(c, start + sweep), turn = WF_TURN;
    if (out->open) {
        turn = fmod(last - first + 2 * WF_TURN, WF_TURN);
        if (turn < 0.5 * sweep && sweep > WF_PI) turn += WF_TURN; /* an opening of almost nothing */
    }
    struct wf_hollow_edge outer = arc(0, 0, 1, first, turn),
                          inner = arc(c[0], c[1], cavity, start + sweep, -sweep);
    out->edge[out->edges++] = outer;
    out->edge[out->edges++] = inner;
    if (out->open) {
        out->edge[out->edges++] = line(outer.to[0], outer.to[1], inner.from[0], inner.from[1]);
        out->edge[out->edges++] = line(inner.to[0], inner.to[1], outer.from[0], outer.from[1]);
    }
    enum wf_status s = integrate(out, e);
    if (!s) round_wall(out, c, cavity, start, sweep);
    return s;
}

/* ---- By rays ---- */

static void ray_point(const double *angle, const double *way, size_t k, double p[2])
{
    p[0] = way[k] * cos(angle[k]), p[1] = way[k] * sin(angle[k]);
}

static void ray_wall(struct wf_hollow *h, size_t n, const double *angle, const double *outer,
                     const double *sound)
{
    struct wall w = { .least = INFINITY };
    double cavity = 0;
    for (size_t i = 0; i < n; i++) {
        size_t k = (i + 1) % n;
        const double middle[2] = { 0.5 * (outer[i] + sound[i]), 0.5 * (outer[k] + sound[k]) };
        double a[2], b[2];
        ray_point(&angle[i], &middle[0], 0, a);
        ray_point(&angle[k], &middle[1], 0, b);
        add_wall(&w, a, b, outer[i] - sound[i], outer[k] - sound[k]);
        cavity = fmax(cavity, sound[i]);
    }
    h->open = w.open;
    h->wall = w.least;
    set_torsion(&w, h);
    if (cavity > 0) return;
    h->torsion = pow(h->area, 4) / (4 * WF_PI * WF_PI * (h->xx + h->yy));
    h->twist = h->torsion / (2 * w.most);
}

enum wf_status wf_hollow_rays(size_t n, const double *angle, const double *outer, const double *sound,
                              struct wf_arena *a, struct wf_hollow *out, struct wf_err *e)
{
    double whole = 0;
    *out = (struct wf_hollow){ .edge = WF_TAKE(a, 2 * n, struct wf_hollow_edge) };
    if (!out->edge) return wf_fail(e, WF_ENOMEM, "no memory for a section of %zu rays", n);
    for (size_t i = 0; i < n; i++) {
        size_t k = (i + 1) % n;
        double p[2], q[2], in[2], on[2];
        ray_point(angle, outer, i, p), ray_point(angle, outer, k, q);
        ray_point(angle, sound, i, in), ray_point(angle, sound, k, on);
        whole += 0.5 * (p[0] * q[1] - p[1] * q[0]);
        if (outer[i] <= sound[i] && outer[k] <= sound[k]) continue; /* no wall between the two */
        out->edge[out->edges++] = line(p[0], p[1], q[0], q[1]);
        out->edge[out->edges++] = line(on[0], on[1], in[0], in[1]);
    }
    out->radius = sqrt(whole / WF_PI);
    enum wf_status s = integrate(out, e);
    if (!s) ray_wall(out, n, angle, outer, sound);
    return s;
}

/* ---- Stress ---- */

static void widen(double range[2], double x) { range[0] = fmin(range[0], x), range[1] = fmax(range[1], x); }

/* Widen a range by the values of c + g.p on an edge: at its ends, and on an arc where g is across it. */
static void edge_range(const struct wf_hollow_edge *g, double constant, const double slope[2],
                       double range[2])
{
    widen(range, constant + slope[0] * g->from[0] + slope[1] * g->from[1]);
    widen(range, constant + slope[0] * g->to[0] + slope[1] * g->to[1]);
    if (!(g->radius > 0)) return;
    double middle = constant + slope[0] * g->centre[0] + slope[1] * g->centre[1];
    double size = g->radius * hypot(slope[0], slope[1]), angle = atan2(slope[1], slope[0]);
    double low = fmin(g->start, g->start + g->sweep), span = fabs(g->sweep);
    for (int side = 0; side < 2; side++) {
        double there = fmod(angle + side * WF_PI - low, WF_TURN);
        if (there < 0) there += WF_TURN;
        if (there <= span) widen(range, middle + (side ? -size : size));
    }
}

void wf_hollow_stress(const struct wf_hollow *h, double radius, double axial, double mx, double my,
                      double range[2])
{
    double r2 = radius * radius, force = axial / r2;
    /* the moment of the stresses about the stem's axis has mx = int y sigma, my = -int x sigma */
    double ax = -my / (r2 * radius) - force * h->centroid[0],
           ay = mx / (r2 * radius) - force * h->centroid[1];
    double det = h->xx * h->yy - h->xy * h->xy;
    double slope[2] = { (h->yy * ax - h->xy * ay) / det, (h->xx * ay - h->xy * ax) / det };
    double constant = force / h->area - slope[0] * h->centroid[0] - slope[1] * h->centroid[1];
    range[0] = INFINITY, range[1] = -INFINITY;
    for (size_t i = 0; i < h->edges; i++) edge_range(&h->edge[i], constant, slope, range);
}

double wf_hollow_modulus(const struct wf_hollow *h, double towards)
{
    double range[2];
    wf_hollow_stress(h, 1, 0, -sin(towards), cos(towards), range);
    return 4 / (WF_PI * fmax(range[1], -range[0]));
}

double wf_hollow_least(const struct wf_hollow *h, double *along)
{
    double mean = 0.5 * (h->xx + h->yy), half = 0.5 * (h->xx - h->yy), spread = hypot(half, h->xy);
    *along = 0.5 * atan2(h->xy, half) + 0.5 * WF_PI;
    return 4 * (mean - spread) / WF_PI;
}

size_t wf_hollow_outline(const struct wf_hollow *h, size_t most, double (*point)[2])
{
    size_t n = 0;
    for (size_t i = 0; i < h->edges; i++) {
        const struct wf_hollow_edge *g = &h->edge[i];
        int pieces = g->radius > 0 ? 1 + (int)(fabs(g->sweep) * 36 / WF_PI) : 1;
        if (n + (size_t)pieces + 2 > most) return n;
        for (int k = 0; k <= pieces; k++) {
            double slope[2];
            edge_at(g, (double)k / pieces, point[n++], slope);
        }
        point[n][0] = point[n][1] = NAN, n++;
    }
    return n;
}
