/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/shelter.h"
#include "base/num.h"
#include "base/raster.h"
#include "base/vec3.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum wf_status wf_shelter_request_check(const struct wf_shelter_request *q, struct wf_err *e)
{
    const struct {
        const char *name, *unit;
        double value, low, high;
    } limit[] = {
        { "number of slabs", "", (double)q->slabs, 1, 512 },
        { "number of cells", "", (double)q->cells, 8, 1024 },
        { "transmission of a covered cell", "", q->transmission, 0, 1 },
        { "drag coefficient of wood", "", q->wood_drag, 1e-3, 10 },
        { "drag coefficient of the crown", "", q->crown_drag, 1e-3, 10 },
        { "share of the sail", "", q->sail_share, 0, 1 },
        { "reach of leaves", " m", q->leaf_reach, 1e-3, 100 },
        { "coverage of an open cell", "", q->clear, 0, 0.5 },
        { "coverage of a full cell", "", q->full, 0.5, 1 },
        { "widest gap", " cells", (double)q->gap, 1, 64 },
        { "growth of a wake", "", q->wake_growth, 0, 1 },
    };
    if (!q->law) return wf_fail(e, WF_EUSAGE, "no shelter law is named");
    for (size_t i = 0; i < WF_COUNT(limit); i++)
        if (!(limit[i].value >= limit[i].low && limit[i].value <= limit[i].high))
            return wf_fail(e, WF_EUSAGE, "%s %.6g%s is outside %.6g..%.6g", limit[i].name, limit[i].value,
                           limit[i].unit, limit[i].low, limit[i].high);
    if (q->slabs * q->cells * q->cells > WF_SHELTER_CELLS_MAX)
        return wf_fail(e, WF_EUSAGE, "%zu slabs of %zu by %zu cells are more than the %d cells allowed",
                       q->slabs, q->cells, q->cells, WF_SHELTER_CELLS_MAX);
    return WF_OK;
}

double wf_shelter_speed_share(const struct wf_shelter_request *q)
{
    return q->energy ? sqrt(q->transmission) : q->transmission;
}

double wf_shelter_coverage(const struct wf_shelter *s, size_t cell)
{
    double leaf = s->leaf[cell];
    return leaf > 0.0 ? 1.0 - (1.0 - s->wood[cell]) * exp(-leaf) : s->wood[cell];
}

/* Classes of cells; the rules are in wind/shelter.h. */

/* One slab: `up` rows of `across` cells. */
struct slab_sheet {
    const struct wf_shelter *s;
    size_t first; /* cell of the slab's corner */
    uint8_t *class;
    double *width;
};

static bool is_covered(const struct slab_sheet *h, long i, long k)
{
    if (i < 0 || k < 0 || i >= (long)h->s->across || k >= (long)h->s->up) return false;
    uint8_t c = h->class[(size_t)k * h->s->across + (size_t)i];
    return c == WF_CELL_TRANSMITTING || c == WF_CELL_CYLINDER;
}

/* Mark cylinders along a line of `n` cells that are `stride` apart: runs of covered cells that end at open
 * cells and are narrow enough. `sign` marks the direction of the line. */
static void mark_cylinders(struct slab_sheet *h, size_t start, size_t stride, size_t n, double step,
                           double widest, double sign)
{
    for (size_t i = 0; i < n;) {
        size_t end = i;
        double solid = 0.0;
        for (; end < n && h->class[start + end * stride] != WF_CELL_NONE; end++)
            solid += step * wf_shelter_coverage(h->s, h->first + start + end * stride);
        if (end > i && (double)(end - i) * step <= widest + 2.0 * step)
            for (size_t j = i; j < end; j++) {
                size_t cell = start + j * stride;
                if (h->class[cell] == WF_CELL_CYLINDER && fabs(h->width[cell]) <= solid) continue;
                h->class[cell] = WF_CELL_CYLINDER;
                h->width[cell] = sign * solid;
            }
        i = end + 1;
    }
}

/* Whether there is a covered cell within `gap` cells in the direction (di, dk). */
static bool has_wall(const struct slab_sheet *h, size_t i, size_t k, long di, long dk)
{
    for (long step = 1; step <= (long)h->s->request.gap; step++)
        if (is_covered(h, (long)i + step * di, (long)k + step * dk)) return true;
    return false;
}

static void mark_gaps(struct slab_sheet *h)
{
    for (size_t k = 0; k < h->s->up; k++)
        for (size_t i = 0; i < h->s->across; i++) {
            uint8_t *c = &h->class[k * h->s->across + i];
            if (*c != WF_CELL_NONE) continue;
            bool beside = has_wall(h, i, k, -1, 0) && has_wall(h, i, k, 1, 0),
                 above = has_wall(h, i, k, 0, -1) && has_wall(h, i, k, 0, 1);
            if (beside && above)
                *c = WF_CELL_HOLE;
            else if (beside || above)
                *c = WF_CELL_SLIT;
            if (*c == WF_CELL_SLIT) h->width[k * h->s->across + i] = beside ? h->s->step[1] : -h->s->step[2];
        }
}

static void shelter_classify(struct wf_shelter *s, double thickest)
{
    size_t cells = s->up * s->across;
    for (size_t p = 0; p < s->slabs; p++) {
        struct slab_sheet h = { s, p * cells, s->class + p * cells, s->width + p * cells };
        bool any = false;
        for (size_t c = 0; c < cells; c++) {
            bool solid = (s->wood[h.first + c] > 0.0 || s->leaf[h.first + c] > 0.0) &&
                         wf_shelter_coverage(s, h.first + c) > s->request.clear;
            h.class[c] = solid ? WF_CELL_TRANSMITTING : WF_CELL_NONE;
            any = any || solid;
        }
        if (!any) continue;
        for (size_t k = 0; k < s->up; k++)
            mark_cylinders(&h, k * s->across, 1, s->across, s->step[1], thickest, 1.0);
        for (size_t i = 0; i < s->across; i++)
            mark_cylinders(&h, i, s->across, s->up, s->step[2], thickest, -1.0);
        mark_gaps(&h);
    }
}

/* Division of a tree into slabs, and their projection on the grid. */

enum { MARGIN = 2 }; /* open cells beside and above the tree */

/* Set the axes along, across and up. For a vertical wind "across" is the x axis. */
static void turn_axes(struct wf_shelter *s, const double to[3])
{
    double flat = hypot(to[0], to[1]);
    const double across[3] = { flat > 1e-9 ? -to[1] / flat : 1.0, flat > 1e-9 ? to[0] / flat : 0.0, 0.0 };
    for (int i = 0; i < 3; i++) {
        s->axis[0][i] = to[i];
        s->axis[1][i] = across[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        s->axis[2][i] = to[j] * across[k] - to[k] * across[j];
    }
}

/* Ends of a row in the axes of the wind [m]. */
static void row_ends(const struct wf_shelter *s, const struct wf_tree *t, size_t i, double p0[3],
                     double p1[3])
{
    const double a[3] = { t->x0[i], t->y0[i], t->z0[i] }, b[3] = { t->x1[i], t->y1[i], t->z1[i] };
    wf_shelter_turn(s, a, p0);
    wf_shelter_turn(s, b, p1);
}

static bool is_leafy(const struct wf_tree *t, size_t i) { return t->sail0[i] + t->sail1[i] > 0.0; }

/* Place the grid around wood and leaves. Its depth and height are at least a hundredth of the tree's size,
 * its width at least a quarter, so that the wakes of a slender tree fit on the grid. */
static void place_grid(struct wf_shelter *s, const struct wf_tree *t)
{
    double low[3] = { DBL_MAX, DBL_MAX, DBL_MAX }, high[3] = { -DBL_MAX, -DBL_MAX, -DBL_MAX }, size = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double p[2][3], r[2] = { t->r0[i], t->r1[i] }, d[3], length2 = 0.0;
        row_ends(s, t, i, p[0], p[1]);
        for (int k = 0; k < 3; k++) d[k] = p[1][k] - p[0][k], length2 += d[k] * d[k];
        for (int end = 0; end < 2; end++)
            for (int k = 0; k < 3; k++) {
                double disc = r[end] * sqrt(fmax(1.0 - d[k] * d[k] / length2, 0.0));
                double reach = is_leafy(t, i) ? fmax(disc, s->request.leaf_reach) : disc;
                low[k] = fmin(low[k], p[end][k] - reach);
                high[k] = fmax(high[k], p[end][k] + reach);
            }
    }
    if (!t->n) /* no tree: any grid will do */
        for (int k = 0; k < 3; k++) low[k] = 0.0, high[k] = 1.0;
    for (int k = 0; k < 3; k++) size = fmax(size, high[k] - low[k]);
    const size_t n[3] = { s->slabs, s->across - 2 * MARGIN, s->up - MARGIN };
    for (int k = 0; k < 3; k++) {
        double thin = (k == 1 ? 0.25 : 0.01) * size - (high[k] - low[k]);
        if (thin > 0.0) low[k] -= 0.5 * thin, high[k] += 0.5 * thin;
        double pad = 1e-9 * size;
        s->step[k] = (high[k] - low[k] + 2.0 * pad) / (double)n[k];
        s->low[k] = low[k] - pad - (k == 1 ? MARGIN * s->step[k] : 0.0);
    }
}

/* A part of a row within one slab. */
struct slab_piece {
    uint32_t row;
    double from, to; /* shares of the row's length */
};

struct slab_pieces {
    struct slab_piece *list; /* by slab */
    size_t *first;           /* slabs + 1 */
};

/* First and last slab that a row's axis passes through. */
static void slabs_passed(const struct wf_shelter *s, const double p0[3], const double p1[3], size_t *first,
                         size_t *last)
{
    double a = (fmin(p0[0], p1[0]) - s->low[0]) / s->step[0],
           b = (fmax(p0[0], p1[0]) - s->low[0]) / s->step[0];
    *first = (size_t)fmin(fmax(a, 0.0), (double)s->slabs - 1.0);
    *last = (size_t)fmin(fmax(b, 0.0), (double)s->slabs - 1.0);
}

static enum wf_status cut_into_slabs(const struct wf_shelter *s, const struct wf_tree *t, struct wf_arena *a,
                                     struct slab_pieces *out, struct wf_err *e)
{
    size_t first, last;
    double p0[3], p1[3];
    size_t *next = WF_TAKE(a, s->slabs + 1, size_t);
    out->first = WF_TAKE(a, s->slabs + 1, size_t);
    if (!next || !out->first) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu slabs", s->slabs);
    for (size_t i = 0; i < t->n; i++) {
        row_ends(s, t, i, p0, p1);
        slabs_passed(s, p0, p1, &first, &last);
        for (size_t k = first; k <= last; k++) out->first[k + 1]++;
    }
    for (size_t k = 0; k < s->slabs; k++) out->first[k + 1] += out->first[k];
    memcpy(next, out->first, (s->slabs + 1) * sizeof *next);
    if (!(out->list = WF_TAKE(a, out->first[s->slabs], struct slab_piece)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu pieces of %zu segments", out->first[s->slabs],
                       t->n);
    for (size_t i = 0; i < t->n; i++) {
        row_ends(s, t, i, p0, p1);
        slabs_passed(s, p0, p1, &first, &last);
        double depth = p1[0] - p0[0];
        for (size_t k = first; k <= last; k++) {
            double front = s->low[0] + (double)k * s->step[0], back = front + s->step[0];
            double at0 = (front - p0[0]) / depth, at1 = (back - p0[0]) / depth;
            double from = depth > 0.0 ? at0 : at1, to = depth > 0.0 ? at1 : at0;
            if (depth > 0.0 ? k == first : k == last) from = 0.0;
            if (depth > 0.0 ? k == last : k == first) to = 1.0;
            out->list[next[k]++] = (struct slab_piece){ (uint32_t)i, from, to };
        }
    }
    return WF_OK;
}

/* State while slabs are projected. */
struct slab_view {
    const struct wf_shelter *s;
    const struct wf_tree *t;
    const bool *carries; /* per row: it has a child */
    struct wf_outline *outline;
    size_t n;
    struct wf_raster raster;
};

static void to_cells(const struct wf_shelter *s, struct wf_outline *o)
{
    for (size_t i = 0; i < o->n; i++)
        for (int k = 0; k < 2; k++) o->x[i][k] = (o->x[i][k] - s->low[k + 1]) / s->step[k + 1];
}

static void project_piece(struct slab_view *v, const struct slab_piece *p)
{
    const struct wf_tree *t = v->t;
    size_t i = p->row;
    double a[3], b[3], p0[3], p1[3], from = p->from, to = p->to;
    struct wf_outline *o = &v->outline[v->n], cloud;
    row_ends(v->s, t, i, a, b);
    for (int k = 0; k < 3; k++) {
        p0[k] = a[k] + from * (b[k] - a[k]);
        p1[k] = a[k] + to * (b[k] - a[k]);
    }
    double length = sqrt(pow(b[0] - a[0], 2.0) + pow(b[1] - a[1], 2.0) + pow(b[2] - a[2], 2.0));
    double cosine = fabs(b[0] - a[0]) / length;
    double r0 = t->r0[i] + from * (t->r1[i] - t->r0[i]), r1 = t->r0[i] + to * (t->r1[i] - t->r0[i]);
    /* include discs only at free ends; other ends are covered by the adjacent rows */
    bool disc0 = from <= 0.0 && t->parent[i] < 0, disc1 = to >= 1.0 && !v->carries[i];
    double cell = fmin(v->s->step[1], v->s->step[2]);
    if (wf_outline_frustum(&p0[1], &p1[1], r0, r1, cosine, disc0 && r0 * cosine > 1e-3 * cell,
                           disc1 && r1 * cosine > 1e-3 * cell, o)) {
        to_cells(v->s, o);
        v->n++;
    }
    if (!is_leafy(t, i)) return;
    double reach = v->s->request.leaf_reach, middle = 0.5 * (from + to);
    double sail = (t->sail0[i] + middle * (t->sail1[i] - t->sail0[i])) * (to - from) * length;
    if (!(sail > 0.0)) return;
    if (!wf_outline_frustum(&p0[1], &p1[1], reach, reach, fmax(cosine, 0.05), true, true, &cloud)) return;
    to_cells(v->s, &cloud);
    double frontal = sail * v->s->request.sail_share / v->s->request.crown_drag;
    double area = wf_outline_area(&cloud) * v->s->step[1] * v->s->step[2];
    wf_raster_add(&v->raster, &cloud, frontal / area);
}

static enum wf_status project_all(struct wf_shelter *s, const struct wf_tree *t, struct wf_arena *scratch,
                                  struct wf_err *e)
{
    struct slab_pieces pieces;
    struct slab_view v = { .s = s, .t = t };
    size_t most = 0, cells = s->up * s->across;
    bool *carries = WF_TAKE(scratch, t->n, bool), leaves = false;
    if (!carries) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++) {
        if (t->parent[i] >= 0) carries[t->parent[i]] = true;
        leaves = leaves || is_leafy(t, i);
    }
    if (cut_into_slabs(s, t, scratch, &pieces, e) || wf_raster_make(&v.raster, s->across, s->up, scratch, e))
        return e->code;
    for (size_t k = 0; k < s->slabs; k++)
        most = pieces.first[k + 1] - pieces.first[k] > most ? pieces.first[k + 1] - pieces.first[k] : most;
    v.carries = carries;
    if (!(v.outline = WF_TAKE(scratch, most, struct wf_outline)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu outlines", most);
    for (size_t k = 0; k < s->slabs; k++) {
        v.n = 0;
        for (size_t i = pieces.first[k]; i < pieces.first[k + 1]; i++) project_piece(&v, &pieces.list[i]);
        if (wf_raster_union(&v.raster, v.outline, v.n, s->wood + k * cells, e)) return e->code;
        if (leaves) wf_raster_sum(&v.raster, s->leaf + k * cells);
    }
    return WF_OK;
}

/* Grid and coverage of a shelter. */
static enum wf_status shelter_cover(const struct wf_tree *t, const struct wf_wind *base,
                                    const struct wf_shelter_request *q, struct wf_arena *a,
                                    struct wf_shelter *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_err why = { 0 };
    enum wf_status s = wf_shelter_request_check(q, e);
    if (s) return s;
    *out = (struct wf_shelter){ .request = *q,
                                .base = *base,
                                .slabs = q->slabs,
                                .across = q->cells,
                                .up = q->cells,
                                .planes = 2 * q->slabs };
    turn_axes(out, base->direction);
    place_grid(out, t);
    size_t n = q->slabs * q->cells * q->cells;
    out->wood = WF_TAKE(a, n, double);
    out->leaf = WF_TAKE(a, n, double);
    out->class = WF_TAKE(a, n, uint8_t);
    out->width = WF_TAKE(a, n, double);
    if (!out->wood || !out->leaf || !out->class || !out->width)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu slabs of %zu by %zu cells", q->slabs,
                       q->cells, q->cells);
    s = project_all(out, t, &scratch, &why);
    wf_arena_free(&scratch);
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}

/* The sheltered wind at any point, from the ratios at planes and cells. */

/* The three neighbours of a coordinate in cells (centres at 0.5, 1.5, ...), their weights in the quadratic
 * B-spline, and the slopes of the weights per cell. */
static void spline_weights(double at, long index[3], double weight[3], double slope[3])
{
    double cell = floor(at), t = at - cell;
    for (int k = 0; k < 3; k++) index[k] = (long)cell - 1 + k;
    weight[0] = 0.5 * (1.0 - t) * (1.0 - t);
    weight[1] = 0.5 + t * (1.0 - t);
    weight[2] = 0.5 * t * t;
    slope[0] = t - 1.0;
    slope[1] = 1.0 - 2.0 * t;
    slope[2] = t;
}

/* Index of each neighbour in the arrays; -1 where the wind is undisturbed. Behind the last plane the last
 * plane is used, below the grid the lowest cells. */
static void clip_to_grid(int axis, long n, long index[3])
{
    for (int k = 0; k < 3; k++) {
        if (index[k] < 0) index[k] = axis == 2 ? 0 : -1;
        if (index[k] >= n) index[k] = axis == 0 ? n - 1 : -1;
    }
}

static double clamped(double v, double low, double high) { return fmin(fmax(v, low), high); }

void wf_shelter_ratio(const struct wf_shelter *s, const double x[3], double ratio[3], double slope[9])
{
    double local[3], weight[3][3], rise[3][3], value[3] = { 0 }, by[3][3] = { { 0 } };
    long index[3][3];
    const long n[3] = { (long)s->planes, (long)s->across, (long)s->up };
    wf_shelter_turn(s, x, local);
    for (int k = 0; k < 3; k++) {
        double at = (local[k] - s->low[k]) / s->step[k] - (k == 0 ? WF_SHELTER_LAG : 0.0);
        spline_weights(clamped(at, -9.0, (double)n[k] + 9.0), index[k], weight[k], rise[k]);
        clip_to_grid(k, n[k], index[k]);
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++) {
                if (index[0][i] < 0 || index[1][j] < 0 || index[2][k] < 0) continue;
                size_t cell =
                    ((size_t)index[0][i] * s->up + (size_t)index[2][k]) * s->across + (size_t)index[1][j];
                double w[3] = { weight[0][i], weight[1][j], weight[2][k] };
                for (size_t p = 0; p < s->request.law->parts; p++) {
                    double v = s->part[p][cell];
                    value[p] += w[0] * w[1] * w[2] * v;
                    by[p][0] += rise[0][i] * w[1] * w[2] * v;
                    by[p][1] += w[0] * rise[1][j] * w[2] * v;
                    by[p][2] += w[0] * w[1] * rise[2][k] * v;
                }
            }
    for (int p = 0; p < 3; p++) {
        ratio[p] = (p == 0 ? 1.0 : 0.0) - value[p];
        for (int j = 0; j < 3; j++) {
            slope[3 * p + j] = 0.0;
            for (int k = 0; k < 3; k++) slope[3 * p + j] -= by[p][k] / s->step[k] * s->axis[k][j];
        }
    }
}

/* u = base + q ((r0 - 1) e0 + r1 e1 + r2 e2), q the undisturbed speed along the wind. */
static void shelter_sample(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    const struct wf_shelter *s = w->field;
    struct wf_wind base = s->base;
    double ratio[3], slope[9], q = 0.0, dq[3] = { 0 };
    base.speed = w->speed;
    base.sample(&base, x, u, du);
    wf_shelter_ratio(s, x, ratio, slope);
    for (int i = 0; i < 3; i++) {
        q += s->axis[0][i] * u[i];
        for (int j = 0; j < 3; j++) dq[j] += s->axis[0][i] * du[3 * i + j];
    }
    ratio[0] -= 1.0;
    for (int i = 0; i < 3; i++)
        for (int p = 0; p < 3; p++) {
            u[i] += q * ratio[p] * s->axis[p][i];
            for (int j = 0; j < 3; j++)
                du[3 * i + j] += (dq[j] * ratio[p] + q * slope[3 * p + j]) * s->axis[p][i];
        }
}

/* Distance to the next face between cells, where the curvature of the splines jumps; a face closer than 2e-3
 * cells counts as passed. */
static double shelter_clear(const struct wf_wind *w, const double x[3], const double t[3])
{
    const struct wf_shelter *s = w->field;
    const double at_hand = 2e-3; /* cells */
    double local[3], nearest = INFINITY;
    wf_shelter_turn(s, x, local);
    for (int k = 0; k < 3; k++) {
        double at = (local[k] - s->low[k]) / s->step[k] - (k == 0 ? WF_SHELTER_LAG : 0.0);
        double rate = wf_dot(s->axis[k], t) / s->step[k], ahead = floor(at) + 1.0 - at;
        if (rate < 0.0) rate = -rate, ahead = at + 1.0 - ceil(at);
        if (ahead < at_hand) ahead += 1.0;
        if (rate > 0.0) nearest = fmin(nearest, ahead / rate);
    }
    return nearest;
}

void wf_shelter_field(const struct wf_shelter *s, struct wf_wind *out)
{
    *out = s->base;
    out->sample = shelter_sample;
    out->clear = shelter_clear;
    out->field = s;
}

/* The shelter as a whole. */

/* Mean ratio and volume flux of the wind that arrives at a slab, from plane `plane`; < 0: undisturbed. */
static void slab_flux(struct wf_shelter *s, long plane, struct wf_shelter_slab *out)
{
    size_t cells = s->up * s->across;
    double ratio = 0.0, flow = 0.0, all = 0.0;
    for (size_t k = 0; k < s->up; k++) {
        double row = (double)s->across, x[3], u[3], du[9];
        if (plane >= 0)
            for (size_t i = 0; i < s->across; i++)
                row -= s->part[0][(size_t)plane * cells + k * s->across + i];
        for (int i = 0; i < 3; i++)
            x[i] = s->axis[0][i] * s->low[0] +
                   s->axis[1][i] * (s->low[1] + 0.5 * (double)s->across * s->step[1]) +
                   s->axis[2][i] * (s->low[2] + ((double)k + 0.5) * s->step[2]);
        s->base.sample(&s->base, x, u, du);
        double speed = u[0] * s->axis[0][0] + u[1] * s->axis[0][1] + u[2] * s->axis[0][2];
        ratio += row;
        flow += row * speed;
        all += (double)s->across * speed;
    }
    out->speed = ratio / (double)cells;
    out->flux = all > 0.0 ? flow / all : out->speed;
}

static void measure_slabs(struct wf_shelter *s)
{
    size_t cells = s->up * s->across;
    double area = s->step[1] * s->step[2];
    for (size_t k = 0; k <= s->slabs; k++) {
        struct wf_shelter_slab *out = &s->slab[k];
        slab_flux(s, (long)k - 1, out);
        for (size_t c = k * cells; k < s->slabs && c < (k + 1) * cells; c++) {
            double coverage = wf_shelter_coverage(s, c);
            out->cells[s->class[c]]++;
            out->full += coverage >= s->request.full;
            out->wood += s->wood[c] * area;
            out->leaf += s->leaf[c] * area;
            out->covered += coverage * area;
        }
    }
}

static enum wf_status shelter_wind(struct wf_shelter *s, struct wf_arena *a, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    size_t n = s->planes * s->up * s->across;
    s->slab = WF_TAKE(a, s->slabs + 1, struct wf_shelter_slab);
    for (size_t i = 0; i < s->request.law->parts; i++)
        if (!(s->part[i] = WF_TAKE(a, n, double))) s->slab = NULL;
    if (!s->slab) return wf_fail(e, WF_ENOMEM, "not enough memory for a wind field of %zu points", n);
    enum wf_status status = s->request.law->fill(s, &scratch, e);
    wf_arena_free(&scratch);
    if (!status) measure_slabs(s);
    return status;
}

enum wf_status wf_shelter_make(const struct wf_tree *t, const struct wf_wind *base,
                               const struct wf_shelter_request *q, struct wf_arena *a, struct wf_shelter *out,
                               struct wf_err *e)
{
    double thickest = 0.0;
    enum wf_status s = shelter_cover(t, base, q, a, out, e);
    if (s) return s;
    for (size_t i = 0; i < t->n; i++) thickest = fmax(thickest, wf_tree_thickness(t, i, NAN));
    shelter_classify(out, thickest);
    return shelter_wind(out, a, e);
}
