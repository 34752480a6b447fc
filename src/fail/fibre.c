/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fail/fibre.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/hollow.h"
#include "data/section.h"
#include <math.h>

/* A direction of the section on the bent tree: turned with the row's end, then put across the axis. */
static void turned(const struct wf_response *r, size_t i, const double was[3], const double axis[3],
                   double out[3])
{
    double R[9];
    rotation_matrix(r->turn + 3 * i, R);
    m3_apply(R, was, out);
    double along = wf_dot(out, axis);
    for (int k = 0; k < 3; k++) out[k] -= along * axis[k];
    double size = sqrt(wf_dot(out, out));
    for (int k = 0; k < 3 && size > 0; k++) out[k] /= size;
}

static struct wf_fibre hollow_stress(const struct wf_tree *t, const struct wf_response *r, size_t i, double s,
                                     const double force[3], const double moment[3], const double axis[3])
{
    const struct wf_hollow *h = t->section->hollow[i];
    double radius = wf_wood_radius(t, i, s), range[2];
    double was[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] }, x[3], y[3], first[3];
    wf_section_axes(was, first, y);
    turned(r, i, first, axis, x);
    wf_cross(axis, x, y);
    wf_hollow_stress(h, radius, wf_dot(force, axis), wf_dot(moment, x), wf_dot(moment, y), range);
    return (struct wf_fibre){ range[0], range[1],
                              fabs(wf_dot(moment, axis)) / (h->twist * radius * radius * radius) };
}

/* Bending stress of one shape. Given: its width and height; moments over second moments, in the planes of
 * height and width. */
static double shape_stress(enum wf_section_shape shape, double w, double h, double high, double wide)
{
    switch (shape) {
    case WF_SECTION_ELLIPSE:
        return hypot(high * h / 2, wide * w / 2);
    case WF_SECTION_TRIANGLE:
        return fmax(high * 2 * h / 3, high * h / 3 + wide * w / 2);
    default:
        return high * h / 2 + wide * w / 2;
    }
}

struct wf_fibre wf_fibre_stress(const struct wf_tree *t, const struct wf_response *r, size_t i, double s,
                                const double force[3], const double moment[3], const double axis[3])
{
    const struct wf_tree_sections *c = t->section;
    if (c->hollow && c->hollow[i]) return hollow_stress(t, r, i, s, force, moment, axis);
    double up[3], across[3], most = 0;
    struct wf_section of;
    wf_section_at(t, i, s, &of);
    turned(r, i, c->up + 3 * i, axis, up);
    wf_cross(up, axis, across);
    double high = fabs(wf_dot(moment, across)) / of.upright, wide = fabs(wf_dot(moment, up)) / of.lying;
    double w = wf_between(c->width0[i], c->width1[i], s), h = wf_between(c->height0[i], c->height1[i], s);
    for (size_t k = 0; k < WF_SECTION_SHAPES; k++)
        if (c->mix0[WF_SECTION_SHAPES * i + k] > 0 || c->mix1[WF_SECTION_SHAPES * i + k] > 0)
            most = fmax(most, shape_stress((enum wf_section_shape)k, w, h, high, wide));
    double drawn = wf_dot(force, axis) / of.area;
    return (struct wf_fibre){ drawn - most, drawn + most,
                              fabs(wf_dot(moment, axis)) * fmin(w, h) / of.torsion };
}
