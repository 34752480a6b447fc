/* Cutting rows of a tree where something is measured or pulled. */
#include "fit/experiment.h"
#include <math.h>
#include <stdlib.h>

enum { PLACES_MAX = 64 };
static const double least = 1e-3; /* nearer than this to a row's end is that end [m] */

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The main axis: from the first base, at every fork the thickest way on. above: scratch, one per row. */
static void main_axis(const struct wf_tree *t, int32_t *above, bool *axis)
{
    for (size_t i = 0; i < t->n; i++) above[i] = -1, axis[i] = false;
    for (size_t i = 0; i < t->n; i++) {
        int32_t p = t->parent[i];
        if (p >= 0 && (above[p] < 0 || t->r0[i] > t->r0[above[p]])) above[p] = (int32_t)i;
    }
    for (int32_t i = 0; i >= 0; i = above[i]) axis[i] = true;
}

/* The axis' row that passes a height, and where in it; the lowest such row. */
static bool row_at(const struct wf_tree *t, const bool *axis, double height, size_t *row, double *s)
{
    double ground = t->z0[0];
    for (size_t i = 0; i < t->n; i++) {
        double from = t->z0[i] - ground, to = t->z1[i] - ground;
        if (!axis[i] || height <= from - least || height > to + least || to <= from) continue;
        *row = i;
        *s = (height - from) / (to - from);
        return true;
    }
    return false;
}

/* Shares of a row at which it is cut, 0 and 1 included. */
static size_t cuts_of(const struct wf_tree *t, const bool *axis, size_t i, double length,
                      const double *height, size_t n, double *cut)
{
    double far = wf_tree_length(t, i), s;
    size_t k = 0, pieces = (size_t)fmin(ceil(far / length - 1e-9), 1000), row;
    double fixed[PLACES_MAX + 2];
    fixed[k++] = 0;
    fixed[k++] = 1;
    for (size_t j = 0; j < n; j++)
        if (height[j] > least && row_at(t, axis, height[j], &row, &s) && row == i && s * far > least &&
            (1 - s) * far > least)
            fixed[k++] = s;
    qsort(fixed, k, sizeof *fixed, ascending);
    size_t m = 0;
    for (size_t j = 0; j + 1 < k; j++) {
        double share = fixed[j + 1] - fixed[j];
        if (share * far <= least) continue;
        size_t steps = (size_t)ceil(share * (double)(pieces ? pieces : 1) - 1e-9);
        if (!steps) steps = 1;
        for (size_t q = 0; q < steps; q++) cut[m++] = fixed[j] + share * (double)q / (double)steps;
    }
    cut[m] = 1;
    return m;
}

static double between(double a, double b, double s) { return s <= 0 ? a : s >= 1 ? b : a + (b - a) * s; }

static void copy_part(const struct wf_tree *from, size_t i, double s0, double s1, struct wf_tree *to,
                      size_t at)
{
    double *const ends[][4] = {
        { from->x0, from->x1, to->x0, to->x1 },
        { from->y0, from->y1, to->y0, to->y1 },
        { from->z0, from->z1, to->z0, to->z1 },
        { from->r0, from->r1, to->r0, to->r1 },
        { from->i0, from->i1, to->i0, to->i1 },
        { from->sail0, from->sail1, to->sail0, to->sail1 },
        { from->leaf0, from->leaf1, to->leaf0, to->leaf1 },
        { from->burden0, from->burden1, to->burden0, to->burden1 },
    };
    double *const single[][2] = { { from->youngs, to->youngs },   { from->shear, to->shear },
                                  { from->density, to->density }, { from->strength, to->strength },
                                  { from->drag, to->drag },       { from->lift, to->lift },
                                  { from->damping, to->damping } };
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
        ends[k][2][at] = between(ends[k][0][i], ends[k][1][i], s0);
        ends[k][3][at] = between(ends[k][0][i], ends[k][1][i], s1);
    }
    for (size_t k = 0; k < sizeof single / sizeof *single; k++) single[k][1][at] = single[k][0][i];
    to->level[at] = from->level[i];
    to->id[at] = from->id[i];
}

enum wf_status wf_fit_divide(struct wf_tree *t, double length, const double *height, size_t n, int32_t *row,
                             struct wf_arena *a, struct wf_err *e)
{
    size_t total = 0, place;
    double s;
    double *cut = WF_TAKE(a, 1100 + 2 * PLACES_MAX, double);
    int32_t *last = WF_TAKE(a, t->n, int32_t);
    bool *axis = WF_TAKE(a, t->n, bool);
    if (!cut || !last || !axis) return wf_fail(e, WF_ENOMEM, "no room to divide the tree");
    if (n > PLACES_MAX)
        return wf_fail(e, WF_EINPUT, "%zu places on one tree; at most %d", n, (int)PLACES_MAX);
    if (t->bend || t->stiff || t->mass1)
        return wf_fail(e, WF_EINTERNAL, "only straight rows without masses are divided");
    main_axis(t, last, axis);
    for (size_t j = 0; j < n; j++)
        if (!(height[j] >= 0) || (height[j] > least && !row_at(t, axis, height[j], &place, &s)))
            return wf_fail(e, WF_EINPUT, "the stem has no place %g m above the ground; it ends at %g m",
                           height[j], wf_tree_height(t));
    for (size_t i = 0; i < t->n; i++) total += cuts_of(t, axis, i, length, height, n, cut);
    struct wf_tree out;
    enum wf_status status = wf_tree_alloc(&out, total, a, e);
    if (status) return status;
    out.name = t->name;
    bool *axis_out = WF_TAKE(a, total, bool);
    if (!axis_out) return wf_fail(e, WF_ENOMEM, "no room to divide the tree");
    for (size_t i = 0, at = 0; i < t->n; i++) {
        size_t m = cuts_of(t, axis, i, length, height, n, cut);
        for (size_t k = 0; k < m; k++, at++) {
            copy_part(t, i, cut[k], cut[k + 1], &out, at);
            axis_out[at] = axis[i];
            out.parent[at] = k ? (int32_t)at - 1 : t->parent[i] < 0 ? -1 : last[t->parent[i]];
        }
        last[i] = (int32_t)at - 1;
    }
    for (size_t j = 0; j < n; j++) {
        row[j] = -1;
        for (size_t i = 0; height[j] > least && i < out.n && row[j] < 0; i++)
            if (axis_out[i] && fabs(out.z1[i] - out.z0[0] - height[j]) <= 2 * least) row[j] = (int32_t)i;
    }
    *t = out;
    return WF_OK;
}
