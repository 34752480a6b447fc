/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/raster.h"
#include "base/num.h"
#include <math.h>
#include <string.h>

/* Silhouettes of frustums. */

/* Add the outline of one end: half an ellipse from one end of its chord to the other, in steps of equal
 * angle, or the chord alone. The polygon is stretched along the axis to have the area of the half ellipse. */
static void add_cap(struct wf_outline *o, const double centre[2], const double along[2], double radius,
                    double cosine, bool disc)
{
    size_t n = disc ? WF_OUTLINE_ROUND : 1;
    double stretch = disc ? WF_PI / ((double)n * sin(WF_PI / (double)n)) : 0.0;
    for (size_t k = 0; k <= n; k++) {
        double angle = WF_PI * ((double)k / (double)n - 0.5);
        double out = k == 0 || k == n ? 0.0 : stretch * cosine * cos(angle), side = sin(angle);
        o->x[o->n][0] = centre[0] + radius * (out * along[0] - side * along[1]);
        o->x[o->n][1] = centre[1] + radius * (out * along[1] + side * along[0]);
        o->n++;
    }
}

bool wf_outline_frustum(const double p0[2], const double p1[2], double r0, double r1, double cosine,
                        bool disc0, bool disc1, struct wf_outline *out)
{
    double d[2] = { p1[0] - p0[0], p1[1] - p0[1] }, length = hypot(d[0], d[1]);
    const double up[2] = { 0.0, 1.0 };
    bool end_on = length <= 1e-12 * (r0 + r1);
    double along[2] = { end_on ? up[0] : d[0] / length, end_on ? up[1] : d[1] / length };
    double back[2] = { -along[0], -along[1] };
    out->n = 0;
    if (end_on && !(cosine > 0.0 && (disc0 || disc1))) return false;
    add_cap(out, p1, along, r1, cosine, disc1 && cosine > 0.0);
    add_cap(out, p0, back, r0, cosine, disc0 && cosine > 0.0);
    return true;
}

double wf_outline_area(const struct wf_outline *o)
{
    double twice = 0.0;
    const double *p = o->x[0];
    for (size_t i = 1; i + 1 < o->n; i++)
        twice +=
            (o->x[i][0] - p[0]) * (o->x[i + 1][1] - p[1]) - (o->x[i][1] - p[1]) * (o->x[i + 1][0] - p[0]);
    return 0.5 * twice;
}

/* Area of a union of outlines within a cell. */

struct edge_span {
    double from, to;
};

/* Edges that lie on one line within this distance [cells] are treated as coincident; edges that outlines
 * share differ by rounding only, about 1e-15. */
static const double coincident = 1e-10;

/* Part of the edge p..q inside a convex outline. An edge that lies on one of the outline's own edges counts
 * as inside when both run the same way and `same` is set, else as outside. */
static bool edge_inside(const double p[2], const double q[2], const struct wf_outline *o, bool same,
                        struct edge_span *out)
{
    double from = 0.0, to = 1.0;
    const double *a = o->x[o->n - 1];
    for (size_t i = 0; i < o->n; i++) {
        const double *b = o->x[i];
        double ex = b[0] - a[0], ey = b[1] - a[1];
        double dp = ex * (p[1] - a[1]) - ey * (p[0] - a[0]), dq = ex * (q[1] - a[1]) - ey * (q[0] - a[0]);
        double size = fabs(ex) + fabs(ey), near = coincident * size;
        a = b;
        if (size == 0.0) continue;
        if (fabs(dp) <= near && fabs(dq) <= near) {
            if (!(same && ex * (q[0] - p[0]) + ey * (q[1] - p[1]) > 0.0)) return false;
            continue;
        }
        if (dp < 0.0 && dq < 0.0) return false;
        if (dp < 0.0)
            from = fmax(from, dp / (dp - dq));
        else if (dq < 0.0)
            to = fmin(to, dp / (dp - dq));
        if (from >= to) return false;
    }
    *out = (struct edge_span){ from, to };
    return true;
}

/* Length of `of` that no span of the list covers. Sorts the list. */
static double length_left_over(struct edge_span of, struct edge_span *list, size_t n)
{
    double left = 0.0, at = of.from;
    for (size_t i = 1; i < n; i++) {
        struct edge_span s = list[i];
        size_t k = i;
        for (; k > 0 && list[k - 1].from > s.from; k--) list[k] = list[k - 1];
        list[k] = s;
    }
    for (size_t i = 0; i < n && at < of.to; i++) {
        if (list[i].from > at) left += fmin(list[i].from, of.to) - at;
        at = fmax(at, list[i].to);
    }
    return at < of.to ? left + of.to - at : left;
}

/* The outlines' part of the border integral: twice the area between the cell's corner and those parts of
 * their edges that lie in the cell and in no other outline. */
static double area_of_own_edges(const struct wf_outline *const *list, size_t n, const struct wf_outline *cell)
{
    struct edge_span within, hidden[WF_UNION_MAX];
    const double *corner = cell->x[0];
    double twice = 0.0;
    for (size_t i = 0; i < n; i++) {
        const double *p = list[i]->x[list[i]->n - 1];
        for (size_t k = 0; k < list[i]->n; k++) {
            const double *q = list[i]->x[k], *start = p;
            size_t m = 0;
            p = q;
            if (!edge_inside(start, q, cell, false, &within)) continue;
            for (size_t j = 0; j < n; j++)
                if (j != i && edge_inside(start, q, list[j], j < i, &hidden[m])) m++;
            double share = m ? length_left_over(within, hidden, m) : within.to - within.from;
            twice += share * ((start[0] - corner[0]) * (q[1] - corner[1]) -
                              (start[1] - corner[1]) * (q[0] - corner[0]));
        }
    }
    return twice;
}

/* Area of the union of n outlines, at most WF_UNION_MAX, within the unit square at `corner`. */
static double union_in_cell(const struct wf_outline *const *list, size_t n, const double corner[2])
{
    const double x = corner[0], y = corner[1];
    const struct wf_outline cell = { 4, { { x, y }, { x + 1, y }, { x + 1, y + 1 }, { x, y + 1 } } };
    double twice = area_of_own_edges(list, n, &cell);
    /* the cell's border: the sides that do not pass through the corner, each at distance 1 */
    for (size_t side = 1; side <= 2; side++) {
        struct edge_span whole = { 0.0, 1.0 }, part[WF_UNION_MAX];
        size_t m = 0;
        for (size_t j = 0; j < n; j++)
            if (edge_inside(cell.x[side], cell.x[side + 1], list[j], true, &part[m])) m++;
        if (m) twice += 1.0 - length_left_over(whole, part, m);
    }
    return fmin(fmax(0.5 * twice, 0.0), 1.0);
}

/* Grids: the union of outlines in every cell. */

enum wf_status wf_raster_make(struct wf_raster *r, size_t nx, size_t ny, struct wf_arena *a, struct wf_err *e)
{
    *r = (struct wf_raster){ .nx = nx, .ny = ny, .arena = a };
    r->head = WF_TAKE(a, nx * ny, int32_t);
    r->touched = WF_TAKE(a, nx * ny, int32_t);
    r->edge = WF_TAKE(a, (nx + 2) * ny, double);
    if (!r->head || !r->touched || !r->edge)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a grid of %zu by %zu cells", nx, ny);
    memset(r->head, 0xff, nx * ny * sizeof *r->head);
    return WF_OK;
}

static bool chain_to_cell(struct wf_raster *r, size_t cell, size_t outline)
{
    if (r->links == r->room) {
        size_t room = r->room ? 2 * r->room : 4 * r->nx * r->ny;
        int32_t *item = WF_TAKE(r->arena, room, int32_t), *next = WF_TAKE(r->arena, room, int32_t);
        if (!item || !next || room > INT32_MAX) return false;
        if (r->links) {
            memcpy(item, r->item, r->links * sizeof *item);
            memcpy(next, r->next, r->links * sizeof *next);
        }
        r->item = item;
        r->next = next;
        r->room = room;
    }
    if (r->head[cell] < 0) r->touched[r->cells++] = (int32_t)cell;
    r->item[r->links] = (int32_t)outline;
    r->next[r->links] = r->head[cell];
    r->head[cell] = (int32_t)r->links++;
    return true;
}

/* Lowest and highest x of an outline within the band y0..y0+1. */
static void reach_in_band(const struct wf_outline *o, double y0, double *low, double *high)
{
    double y1 = y0 + 1.0;
    const double *a = o->x[o->n - 1];
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t i = 0; i < o->n; i++) {
        const double *b = o->x[i];
        double x[2] = { a[0], b[0] };
        double bottom = fmin(a[1], b[1]), top = fmax(a[1], b[1]);
        if (bottom <= y1 && top >= y0) {
            double slope = top > bottom ? (b[0] - a[0]) / (b[1] - a[1]) : 0.0;
            for (int k = 0; k < 2; k++) {
                double y = k ? b[1] : a[1];
                if (y < y0) x[k] += slope * (y0 - y);
                if (y > y1) x[k] += slope * (y1 - y);
                *low = fmin(*low, x[k]);
                *high = fmax(*high, x[k]);
            }
        }
        a = b;
    }
}

static size_t clamp_to_cell(double v, size_t most)
{
    return v <= 0.0 ? 0 : v >= (double)most ? most : (size_t)v;
}

/* Add an outline to the chain of every cell that it may touch. Returned: false without memory. */
static bool chain_outline(struct wf_raster *r, const struct wf_outline *o, size_t index)
{
    double bottom = INFINITY, top = -INFINITY, low, high;
    for (size_t i = 0; i < o->n; i++) bottom = fmin(bottom, o->x[i][1]), top = fmax(top, o->x[i][1]);
    if (!(top >= 0.0 && bottom <= (double)r->ny)) return true;
    for (size_t k = clamp_to_cell(bottom, r->ny - 1), last = clamp_to_cell(top, r->ny - 1); k <= last; k++) {
        reach_in_band(o, (double)k, &low, &high);
        if (!(high >= 0.0 && low <= (double)r->nx)) continue;
        for (size_t i = clamp_to_cell(low, r->nx - 1), end = clamp_to_cell(high, r->nx - 1); i <= end; i++)
            if (!chain_to_cell(r, k * r->nx + i, index)) return false;
    }
    return true;
}

enum wf_status wf_raster_union(struct wf_raster *r, const struct wf_outline *o, size_t n, double *out,
                               struct wf_err *e)
{
    r->links = r->cells = 0;
    memset(out, 0, r->nx * r->ny * sizeof *out);
    bool room = true;
    for (size_t i = 0; i < n && room; i++) room = chain_outline(r, &o[i], i);
    for (size_t c = 0; c < r->cells; c++) {
        size_t cell = (size_t)r->touched[c], m = 0;
        const double corner[2] = { (double)(cell % r->nx), (double)(cell / r->nx) };
        const struct wf_outline *list[WF_UNION_MAX];
        double open = 1.0;
        for (int32_t l = r->head[cell]; l >= 0; l = r->next[l]) {
            list[m++] = &o[r->item[l]];
            if (m < WF_UNION_MAX && r->next[l] >= 0) continue;
            open *= 1.0 - union_in_cell(list, m, corner);
            m = 0;
        }
        out[cell] = 1.0 - open;
        r->head[cell] = -1;
    }
    return room ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for %zu outlines on the grid", n);
}

/* Grids: the weighted sum of outlines in every cell. */

/* Add to one row the area to the right of a piece of an edge that runs from x0 to x1 and rises by `rise`. The
 * entries are differences: their running sum along the row is the area in each cell. */
static void add_edge_in_row(double *row, double x0, double x1, double rise)
{
    double left = fmin(x0, x1), right = fmax(x0, x1);
    size_t first = (size_t)left, last = (size_t)right;
    if (first == last) {
        double middle = 0.5 * (x0 + x1) - (double)first;
        row[first] += rise * (1.0 - middle);
        row[first + 1] += rise * middle;
        return;
    }
    double per = rise / (right - left), before = 0.0;
    for (size_t i = first; i <= last; i++) {
        /* area right of the edge, of the part of the edge left of the cell's end */
        double enter_at = fmax(left, (double)i), leave_at = fmin(right, (double)i + 1.0);
        double risen = per * (leave_at - enter_at);
        double area = per * (enter_at - left) + risen * ((double)i + 1.0 - 0.5 * (enter_at + leave_at));
        row[i] += area - before;
        before = area;
    }
    row[last + 1] += rise - before;
}

void wf_raster_add(struct wf_raster *r, const struct wf_outline *o, double weight)
{
    double width = (double)r->nx, height = (double)r->ny;
    const double *a = o->x[o->n - 1];
    for (size_t i = 0; i < o->n; i++) {
        const double *b = o->x[i];
        /* downwards on the left of a counter-clockwise outline: counted positive */
        double sign = a[1] > b[1] ? weight : -weight;
        const double *low = a[1] > b[1] ? b : a, *high = a[1] > b[1] ? a : b;
        double slope = (high[0] - low[0]) / (high[1] - low[1]);
        double y = fmax(low[1], 0.0), end = fmin(high[1], height);
        a = b;
        while (y < end) {
            size_t k = (size_t)y;
            double stop = fmin((double)k + 1.0, end);
            double x0 = low[0] + slope * (y - low[1]), x1 = low[0] + slope * (stop - low[1]);
            x0 = fmin(fmax(x0, 0.0), width);
            x1 = fmin(fmax(x1, 0.0), width);
            add_edge_in_row(r->edge + k * (r->nx + 2), x0, x1, sign * (stop - y));
            y = stop;
        }
    }
}

void wf_raster_sum(struct wf_raster *r, double *out)
{
    for (size_t k = 0; k < r->ny; k++) {
        double *row = r->edge + k * (r->nx + 2), sum = 0.0, size = 0.0;
        for (size_t i = 0; i < r->nx; i++) {
            sum += row[i];
            size = fmax(size, fabs(sum));
            /* beyond the end of a closed outline the sum is zero except for rounding */
            out[k * r->nx + i] = sum > 1e-12 * size ? sum : 0.0;
        }
        memset(row, 0, (r->nx + 2) * sizeof *row);
    }
}
