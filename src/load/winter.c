/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/winter.h"
#include "base/num.h"
#include <math.h>

/* End k of the rows, seen from above. Returned: whether it carries sail and is of a branch. */
static bool end_at(const struct wf_tree *t, size_t k, double out[2])
{
    size_t i = k / 2;
    out[0] = k % 2 ? t->x1[i] : t->x0[i], out[1] = k % 2 ? t->y1[i] : t->y0[i];
    return t->level[i] > 0 && t->sail0[i] + t->sail1[i] > 0;
}

/* The next corner of the convex hull after p, counterclockwise. Returned: false where all ends are at p. */
static bool next_corner(const struct wf_tree *t, const double p[2], double next[2])
{
    double farthest = 0, q[2];
    for (size_t k = 0; k < 2 * t->n; k++) {
        if (!end_at(t, k, q)) continue;
        double dx = q[0] - p[0], dy = q[1] - p[1], far = dx * dx + dy * dy;
        double cross = farthest > 0 ? (next[0] - p[0]) * dy - (next[1] - p[1]) * dx : -1;
        if (!(far > 0) || cross > 0 || (cross == 0 && far <= farthest)) continue;
        next[0] = q[0], next[1] = q[1], farthest = far;
    }
    return farthest > 0;
}

double wf_crown_projection(const struct wf_tree *t, double width)
{
    double first[2] = { INFINITY, INFINITY }, p[2], next[2] = { 0, 0 }, around = 0;
    bool any = false;
    for (size_t k = 0; k < 2 * t->n; k++) {
        any = any || t->sail0[k / 2] + t->sail1[k / 2] > 0;
        if (end_at(t, k, p) && (p[0] < first[0] || (p[0] == first[0] && p[1] < first[1])))
            first[0] = p[0], first[1] = p[1];
    }
    if (!any) return 0;
    p[0] = first[0], p[1] = first[1];
    for (size_t k = 0; k < 2 * t->n && isfinite(p[0]) && next_corner(t, p, next); k++) {
        around += hypot(next[0] - p[0], next[1] - p[1]);
        p[0] = next[0], p[1] = next[1];
        if (p[0] == first[0] && p[1] == first[1]) break;
    }
    double mean = fmax(around / WF_PI, width); /* Cauchy: width of a convex figure, over all directions */
    return WF_PI / 4 * mean * mean;
}

void wf_snow_onto(struct wf_tree *t, double mass)
{
    double sail = 0;
    for (size_t i = 0; i < t->n; i++) sail += 0.5 * (t->sail0[i] + t->sail1[i]) * wf_tree_length(t, i);
    for (size_t i = 0; i < t->n; i++)
        t->burden0[i] += mass * t->sail0[i] / sail, t->burden1[i] += mass * t->sail1[i] / sail;
}

double wf_ice_onto(struct wf_tree *t, double thickness)
{
    const double density = 917, drag = 1.2, b = thickness; /* [kg m-3], [-], [m] */
    double sum = 0;
    for (size_t i = 0; i < t->n; i++) {
        if (!(t->density[i] > 0)) continue; /* a link lies in the wood it joins */
        double at[2], d = t->r0[i] + t->r1[i];
        at[0] = density * (WF_PI * b * (2 * t->r0[i] + b) + 2 * b * t->leaf0[i]);
        at[1] = density * (WF_PI * b * (2 * t->r1[i] + b) + 2 * b * t->leaf1[i]);
        t->burden0[i] += at[0], t->burden1[i] += at[1];
        sum += 0.5 * (at[0] + at[1]) * wf_tree_length(t, i);
        t->drag[i] = (isnan(t->drag[i]) ? drag : t->drag[i]) * (d + 2 * b) / d;
    }
    return sum;
}
