/* Outlines: silhouettes of frustums, and the area of their union within a cell. */
#include "wind/raster.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* Half an ellipse around an end, from one end of its chord to the other, in steps of equal angle. The
 * polygon's area is made that of the half ellipse by stretching it along the axis. */
static void cap(struct wf_outline *o, const double centre[2], const double along[2], double radius,
                double cosine, bool disc)
{
    size_t n = disc ? WF_OUTLINE_ROUND : 1;
    double stretch = disc ? pi / ((double)n * sin(pi / (double)n)) : 0.0;
    for (size_t k = 0; k <= n; k++) {
        double angle = pi * ((double)k / (double)n - 0.5);
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
    cap(out, p1, along, r1, cosine, disc1 && cosine > 0.0);
    cap(out, p0, back, r0, cosine, disc0 && cosine > 0.0);
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

struct span {
    double from, to;
};

/* Edges that lie on one line within this distance [cells] are taken as coincident: rounding puts edges that
 * are shared at 1e-15. */
static const double together = 1e-10;

/* Part of the edge p..q inside a convex outline. An edge that lies on one of the outline's own edges counts
 * as inside when both run the same way and `same` is set, else as outside. */
static bool inside(const double p[2], const double q[2], const struct wf_outline *o, bool same,
                   struct span *out)
{
    double from = 0.0, to = 1.0;
    const double *a = o->x[o->n - 1];
    for (size_t i = 0; i < o->n; i++) {
        const double *b = o->x[i];
        double ex = b[0] - a[0], ey = b[1] - a[1];
        double dp = ex * (p[1] - a[1]) - ey * (p[0] - a[0]), dq = ex * (q[1] - a[1]) - ey * (q[0] - a[0]);
        double size = fabs(ex) + fabs(ey), near = together * size;
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
    *out = (struct span){ from, to };
    return true;
}

/* Length of `of` that no span of the list covers; the list is sorted on the way. */
static double left_over(struct span of, struct span *list, size_t n)
{
    double left = 0.0, at = of.from;
    for (size_t i = 1; i < n; i++) {
        struct span s = list[i];
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

/* Twice the area under the outlines' own edges within the cell, seen from the cell's corner. */
static double own_edges(const struct wf_outline *const *list, size_t n, const struct wf_outline *cell)
{
    struct span within, hidden[WF_UNION_MAX];
    const double *corner = cell->x[0];
    double twice = 0.0;
    for (size_t i = 0; i < n; i++) {
        const double *p = list[i]->x[list[i]->n - 1];
        for (size_t k = 0; k < list[i]->n; k++) {
            const double *q = list[i]->x[k], *start = p;
            size_t m = 0;
            p = q;
            if (!inside(start, q, cell, false, &within)) continue;
            for (size_t j = 0; j < n; j++)
                if (j != i && inside(start, q, list[j], j < i, &hidden[m])) m++;
            double share = m ? left_over(within, hidden, m) : within.to - within.from;
            twice += share * ((start[0] - corner[0]) * (q[1] - corner[1]) -
                              (start[1] - corner[1]) * (q[0] - corner[0]));
        }
    }
    return twice;
}

double wf_outline_union(const struct wf_outline *const *list, size_t n, const double corner[2])
{
    const double x = corner[0], y = corner[1];
    const struct wf_outline cell = { 4, { { x, y }, { x + 1, y }, { x + 1, y + 1 }, { x, y + 1 } } };
    double twice = own_edges(list, n, &cell);
    /* the cell's border: the sides that do not pass through the corner, each at distance 1 */
    for (size_t side = 1; side <= 2; side++) {
        struct span whole = { 0.0, 1.0 }, part[WF_UNION_MAX];
        size_t m = 0;
        for (size_t j = 0; j < n; j++)
            if (inside(cell.x[side], cell.x[side + 1], list[j], true, &part[m])) m++;
        if (m) twice += 1.0 - left_over(whole, part, m);
    }
    return fmin(fmax(0.5 * twice, 0.0), 1.0);
}
