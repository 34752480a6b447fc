/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/winter.h"
#include "base/num.h"
#include <math.h>

double wf_crown_projection(const struct wf_tree *t, double width)
{
    double low[2] = { INFINITY, INFINITY }, high[2] = { -INFINITY, -INFINITY };
    for (size_t i = 0; i < t->n; i++) {
        if (!(t->sail0[i] + t->sail1[i] > 0)) continue;
        const double end[2][2] = { { t->x0[i], t->y0[i] }, { t->x1[i], t->y1[i] } };
        for (int k = 0; k < 4; k++) {
            low[k % 2] = fmin(low[k % 2], end[k / 2][k % 2]);
            high[k % 2] = fmax(high[k % 2], end[k / 2][k % 2]);
        }
    }
    if (!(high[0] >= low[0])) return 0;
    return WF_PI / 4 * fmax((high[0] - low[0]) * (high[1] - low[1]), width > 0 ? width * width : 0);
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
