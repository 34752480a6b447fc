/* Cutting a tree across the wind into slabs and projecting each on the grid. */
#include "wind/raster.h"
#include "wind/shelter.h"
#include "wind/shelter_parts.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum { MARGIN = 2 }; /* open cells left beside and above the tree */

/* Axes of the view. A wind straight up or down has no "across": the x axis takes its place. */
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

/* Ends of a row in the frame of the wind. */
static void ends(const struct wf_shelter *s, const struct wf_tree *t, size_t i, double p0[3], double p1[3])
{
    const double a[3] = { t->x0[i], t->y0[i], t->z0[i] }, b[3] = { t->x1[i], t->y1[i], t->z1[i] };
    wf_shelter_turn(s, a, p0);
    wf_shelter_turn(s, b, p1);
}

static bool leafy(const struct wf_tree *t, size_t i) { return t->sail0[i] + t->sail1[i] > 0.0; }

/* The grid around wood and leaves. A depth that is almost nothing becomes a hundredth of the tree; a width
 * less than a quarter becomes a quarter, so that the wakes of a slender tree find room beside it. */
static void place_grid(struct wf_shelter *s, const struct wf_tree *t)
{
    double low[3] = { DBL_MAX, DBL_MAX, DBL_MAX }, high[3] = { -DBL_MAX, -DBL_MAX, -DBL_MAX }, size = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double p[2][3], r[2] = { t->r0[i], t->r1[i] }, d[3], length2 = 0.0;
        ends(s, t, i, p[0], p[1]);
        for (int k = 0; k < 3; k++) d[k] = p[1][k] - p[0][k], length2 += d[k] * d[k];
        for (int end = 0; end < 2; end++)
            for (int k = 0; k < 3; k++) {
                double disc = r[end] * sqrt(fmax(1.0 - d[k] * d[k] / length2, 0.0));
                double reach = leafy(t, i) ? fmax(disc, s->request.leaf_reach) : disc;
                low[k] = fmin(low[k], p[end][k] - reach);
                high[k] = fmax(high[k], p[end][k] + reach);
            }
    }
    if (!t->n) /* any grid does */
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
struct piece {
    uint32_t row;
    double from, to; /* shares of the row's length */
};

struct pieces {
    struct piece *list; /* by slab */
    size_t *first;      /* slabs + 1 */
};

/* Slabs a row's axis passes, ascending along the wind. */
static void passed(const struct wf_shelter *s, const double p0[3], const double p1[3], size_t *first,
                   size_t *last)
{
    double a = (fmin(p0[0], p1[0]) - s->low[0]) / s->step[0],
           b = (fmax(p0[0], p1[0]) - s->low[0]) / s->step[0];
    *first = (size_t)fmin(fmax(a, 0.0), (double)s->slabs - 1.0);
    *last = (size_t)fmin(fmax(b, 0.0), (double)s->slabs - 1.0);
}

static enum wf_status cut(const struct wf_shelter *s, const struct wf_tree *t, struct wf_arena *a,
                          struct pieces *out, struct wf_err *e)
{
    size_t first, last;
    double p0[3], p1[3];
    size_t *next = WF_TAKE(a, s->slabs + 1, size_t);
    out->first = WF_TAKE(a, s->slabs + 1, size_t);
    if (!next || !out->first) return wf_fail(e, WF_ENOMEM, "no room for %zu slabs", s->slabs);
    for (size_t i = 0; i < t->n; i++) {
        ends(s, t, i, p0, p1);
        passed(s, p0, p1, &first, &last);
        for (size_t k = first; k <= last; k++) out->first[k + 1]++;
    }
    for (size_t k = 0; k < s->slabs; k++) out->first[k + 1] += out->first[k];
    memcpy(next, out->first, (s->slabs + 1) * sizeof *next);
    if (!(out->list = WF_TAKE(a, out->first[s->slabs], struct piece)))
        return wf_fail(e, WF_ENOMEM, "no room for %zu pieces of %zu segments", out->first[s->slabs], t->n);
    for (size_t i = 0; i < t->n; i++) {
        ends(s, t, i, p0, p1);
        passed(s, p0, p1, &first, &last);
        double depth = p1[0] - p0[0];
        for (size_t k = first; k <= last; k++) {
            double front = s->low[0] + (double)k * s->step[0], back = front + s->step[0];
            double at0 = (front - p0[0]) / depth, at1 = (back - p0[0]) / depth;
            double from = depth > 0.0 ? at0 : at1, to = depth > 0.0 ? at1 : at0;
            if (depth > 0.0 ? k == first : k == last) from = 0.0;
            if (depth > 0.0 ? k == last : k == first) to = 1.0;
            out->list[next[k]++] = (struct piece){ (uint32_t)i, from, to };
        }
    }
    return WF_OK;
}

/* One slab being projected. */
struct view {
    const struct wf_shelter *s;
    const struct wf_tree *t;
    const bool *carries; /* rows that carry another */
    struct wf_outline *outline;
    size_t n;
    struct wf_raster raster;
};

static void to_cells(const struct wf_shelter *s, struct wf_outline *o)
{
    for (size_t i = 0; i < o->n; i++)
        for (int k = 0; k < 2; k++) o->x[i][k] = (o->x[i][k] - s->low[k + 1]) / s->step[k + 1];
}

static void project(struct view *v, const struct piece *p)
{
    const struct wf_tree *t = v->t;
    size_t i = p->row;
    double a[3], b[3], p0[3], p1[3], from = p->from, to = p->to;
    struct wf_outline *o = &v->outline[v->n], cloud;
    ends(v->s, t, i, a, b);
    for (int k = 0; k < 3; k++) {
        p0[k] = a[k] + from * (b[k] - a[k]);
        p1[k] = a[k] + to * (b[k] - a[k]);
    }
    double length = sqrt(pow(b[0] - a[0], 2.0) + pow(b[1] - a[1], 2.0) + pow(b[2] - a[2], 2.0));
    double cosine = fabs(b[0] - a[0]) / length;
    double r0 = t->r0[i] + from * (t->r1[i] - t->r0[i]), r1 = t->r0[i] + to * (t->r1[i] - t->r0[i]);
    /* discs close only what ends there: other ends are covered by the rows that join */
    bool disc0 = from <= 0.0 && t->parent[i] < 0, disc1 = to >= 1.0 && !v->carries[i];
    double cell = fmin(v->s->step[1], v->s->step[2]);
    if (wf_outline_frustum(&p0[1], &p1[1], r0, r1, cosine, disc0 && r0 * cosine > 1e-3 * cell,
                           disc1 && r1 * cosine > 1e-3 * cell, o)) {
        to_cells(v->s, o);
        v->n++;
    }
    if (!leafy(t, i)) return;
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
    struct pieces pieces;
    struct view v = { .s = s, .t = t };
    size_t most = 0, cells = s->up * s->across;
    bool *carries = WF_TAKE(scratch, t->n, bool), leaves = false;
    if (!carries) return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++) {
        if (t->parent[i] >= 0) carries[t->parent[i]] = true;
        leaves = leaves || leafy(t, i);
    }
    if (cut(s, t, scratch, &pieces, e) || wf_raster_make(&v.raster, s->across, s->up, scratch, e))
        return e->code;
    for (size_t k = 0; k < s->slabs; k++)
        most = pieces.first[k + 1] - pieces.first[k] > most ? pieces.first[k + 1] - pieces.first[k] : most;
    v.carries = carries;
    if (!(v.outline = WF_TAKE(scratch, most, struct wf_outline)))
        return wf_fail(e, WF_ENOMEM, "no room for %zu outlines", most);
    for (size_t k = 0; k < s->slabs; k++) {
        v.n = 0;
        for (size_t i = pieces.first[k]; i < pieces.first[k + 1]; i++) project(&v, &pieces.list[i]);
        if (wf_raster_union(&v.raster, v.outline, v.n, s->wood + k * cells, e)) return e->code;
        if (leaves) wf_raster_sum(&v.raster, s->leaf + k * cells);
    }
    return WF_OK;
}

enum wf_status wf_shelter_cover(const struct wf_tree *t, const struct wf_wind *base,
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
        return wf_fail(e, WF_ENOMEM, "no room for %zu slabs of %zu by %zu cells", q->slabs, q->cells,
                       q->cells);
    s = project_all(out, t, &scratch, &why);
    wf_arena_free(&scratch);
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}
