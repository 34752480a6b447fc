/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/experiment.h"
#include "base/num.h"
#include <math.h>
#include <stdlib.h>

const struct wf_sensor_row wf_sensor_rows[WF_SENSOR_KINDS] = {
    [WF_SENSOR_DEFLECTION] = { "deflection", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_HORIZONTAL] = { "horizontal", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_VERTICAL] = { "vertical", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_TILT] = { "tilt", WF_DIM_ANGLE, "deg", 180 / WF_PI, true },
    [WF_SENSOR_STRAIN] = { "strain", WF_DIM_NONE, "um/m", 1e6, true },
    [WF_SENSOR_EXTENSION] = { "extension", WF_DIM_LENGTH, "um", 1e6, true },
    [WF_SENSOR_REACH] = { "reach", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_RISE] = { "rise", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_MOMENT] = { "base_moment", WF_DIM_MOMENT, "kN m", 1e-3, false },
    [WF_SENSOR_FREQUENCY] = { "frequency", WF_DIM_FREQUENCY, "Hz", 1, false },
    [WF_SENSOR_DAMPING] = { "damping", WF_DIM_NONE, "%", 100, false },
};

/* Division of a tree's rows where something is measured or pulled. */

enum { PLACES_MAX = 64 };
static const double least = 1e-3; /* places nearer than this to a row's end are taken as that end [m] */

/* Find the main axis: from the first base, at every fork the thickest child. above: scratch, one per row. */
static void main_axis(const struct wf_tree *t, int32_t *above, bool *axis)
{
    for (size_t i = 0; i < t->n; i++) above[i] = -1, axis[i] = false;
    for (size_t i = 0; i < t->n; i++) {
        int32_t p = t->parent[i];
        if (p >= 0 && (above[p] < 0 || t->r0[i] > t->r0[above[p]])) above[p] = (int32_t)i;
    }
    for (int32_t i = 0; i >= 0; i = above[i]) axis[i] = true;
}

/* The main axis of a tree, and the distance along it to the base of every row [m]. */
struct axis {
    const bool *on;
    const double *start;
};

static enum wf_status axis_of(const struct wf_tree *t, struct wf_arena *a, struct axis *out, struct wf_err *e)
{
    int32_t *above = WF_TAKE(a, t->n, int32_t);
    bool *on = WF_TAKE(a, t->n, bool);
    double *start = WF_TAKE(a, t->n, double);
    if (!above || !on || !start) return wf_fail(e, WF_ENOMEM, "not enough memory to divide the tree");
    main_axis(t, above, on);
    for (size_t i = 0; i < t->n; i++) {
        int32_t p = t->parent[i];
        start[i] = p < 0 ? 0 : start[p] + wf_tree_length(t, (size_t)p);
    }
    *out = (struct axis){ on, start };
    return WF_OK;
}

static double axis_length(const struct wf_tree *t, const struct axis *axis)
{
    double most = 0;
    for (size_t i = 0; i < t->n; i++)
        if (axis->on[i]) most = fmax(most, axis->start[i] + wf_tree_length(t, i));
    return most;
}

/* Coordinates of a row's base and end: along the axis or above its base [m]. */
static void range_of(const struct wf_tree *t, const struct axis *axis, size_t i, bool along, double *from,
                     double *to)
{
    *from = along ? axis->start[i] : t->z0[i] - t->z0[0];
    *to = along ? axis->start[i] + wf_tree_length(t, i) : t->z1[i] - t->z0[0];
}

/* The lowest row of the axis that contains a place. Returned: row and position in it, 0..1. */
static bool row_at(const struct wf_tree *t, const struct axis *axis, const struct wf_fit_place *p,
                   size_t *row, double *s)
{
    for (size_t i = 0; i < t->n; i++) {
        double from, to;
        range_of(t, axis, i, p->along, &from, &to);
        if (!axis->on[i] || p->at <= from - least || p->at > to + least || to <= from) continue;
        *row = i;
        *s = (p->at - from) / (to - from);
        return true;
    }
    return false;
}

/* Positions 0..1 at which a row is divided, 0 and 1 included. Returned: number of parts. */
static size_t cuts_of(const struct wf_tree *t, const struct axis *axis, size_t i, double length,
                      const struct wf_fit_place *place, size_t n, double *cut)
{
    double far = wf_tree_length(t, i), s;
    size_t k = 0, pieces = (size_t)fmin(ceil(far / length - 1e-9), 1000), row;
    double fixed[PLACES_MAX + 2];
    fixed[k++] = 0;
    fixed[k++] = 1;
    for (size_t j = 0; j < n; j++)
        if (place[j].at > least && row_at(t, axis, &place[j], &row, &s) && row == i && s * far > least &&
            (1 - s) * far > least)
            fixed[k++] = s;
    qsort(fixed, k, sizeof *fixed, wf_ascending);
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

/* Find the rows whose ends are at the places. */
static void find_rows(const struct wf_tree *t, const struct axis *axis, const struct wf_fit_place *place,
                      size_t n, int32_t *row)
{
    for (size_t j = 0; j < n; j++) {
        row[j] = -1;
        for (size_t i = 0; place[j].at > least && i < t->n && row[j] < 0; i++) {
            double from, to;
            range_of(t, axis, i, place[j].along, &from, &to);
            if (axis->on[i] && fabs(to - place[j].at) <= 2 * least) row[j] = (int32_t)i;
        }
    }
}

enum wf_status wf_fit_divide(struct wf_tree *t, double length, const struct wf_fit_place *place, size_t n,
                             int32_t *row, struct wf_arena *a, struct wf_err *e)
{
    size_t total = 0, found;
    double s;
    double *cut = WF_TAKE(a, 1100 + 2 * PLACES_MAX, double);
    int32_t *last = WF_TAKE(a, t->n, int32_t);
    struct axis axis, axis_out;
    if (!cut || !last) return wf_fail(e, WF_ENOMEM, "not enough memory to divide the tree");
    if (n > PLACES_MAX)
        return wf_fail(e, WF_EINPUT, "%zu places on one tree; at most %d", n, (int)PLACES_MAX);
    if (t->bend || t->stiff || t->mass1)
        return wf_fail(e, WF_EINTERNAL, "only straight rows without masses are divided");
    enum wf_status status = axis_of(t, a, &axis, e);
    if (status) return status;
    for (size_t j = 0; j < n; j++)
        if (!(place[j].at >= 0) || (place[j].at > least && !row_at(t, &axis, &place[j], &found, &s)))
            return wf_fail(e, WF_EINPUT, "the stem has no place %g m %s; it ends at %g m", place[j].at,
                           place[j].along ? "from its base" : "above the ground",
                           place[j].along ? axis_length(t, &axis) : wf_tree_height(t));
    for (size_t i = 0; i < t->n; i++) total += cuts_of(t, &axis, i, length, place, n, cut);
    struct wf_tree out;
    status = wf_tree_alloc(&out, total, a, e);
    if (!status && t->section) status = wf_tree_alloc_sections(&out, a, e);
    if (!status && t->standing) status = wf_tree_stand(&out, &out, a, e);
    if (status) return status;
    out.name = t->name;
    for (size_t i = 0, at = 0; i < t->n; i++) {
        size_t m = cuts_of(t, &axis, i, length, place, n, cut);
        for (size_t k = 0; k < m; k++, at++) {
            wf_tree_copy_part(t, i, cut[k], cut[k + 1], &out, at);
            out.parent[at] = k ? (int32_t)at - 1 : t->parent[i] < 0 ? -1 : last[t->parent[i]];
        }
        last[i] = (int32_t)at - 1;
    }
    status = axis_of(&out, a, &axis_out, e);
    if (!status) find_rows(&out, &axis_out, place, n, row);
    *t = out;
    return status;
}
