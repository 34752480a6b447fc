/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/section.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/hollow.h"
#include <math.h>

const char *const wf_section_words[] = { "ellipse", "rectangle", "triangle", NULL };

/* J / (long side * short side^3): 1/3 (1 - 192/pi^5 short/long sum_odd tanh(n pi long / (2 short)) / n^5). */
static double rectangle_torsion(double w, double h)
{
    double shorter = fmin(w, h), longer = fmax(w, h), sum = 0;
    for (int n = 1; n < 100; n += 2) sum += tanh(n * WF_PI * longer / (2 * shorter)) / pow(n, 5);
    double cut = 192 / pow(WF_PI, 5) * shorter / longer * sum;
    return longer * shorter * shorter * shorter * (1 - cut) / 3;
}

void wf_section_of(enum wf_section_shape shape, double w, double h, struct wf_section *out)
{
    double area = w * h, w2 = w * w, h2 = h * h;
    switch (shape) {
    case WF_SECTION_ELLIPSE:
        area *= WF_PI / 4;
        *out = (struct wf_section){ area, area * h2 / 16, area * w2 / 16, area * w2 * h2 / (4 * (w2 + h2)) };
        return;
    case WF_SECTION_TRIANGLE:
        *out = (struct wf_section){ area / 2, area * h2 / 36, area * w2 / 48,
                                    area * area * area / (15 * w2 + 20 * h2) };
        return;
    default:
        *out = (struct wf_section){ area, area * h2 / 12, area * w2 / 12, rectangle_torsion(w, h) };
    }
}

void wf_section_axes(const double axis[3], double first[3], double second[3])
{
    double length = sqrt(wf_dot(axis, axis)), unit[3];
    for (int k = 0; k < 3; k++) unit[k] = axis[k] / length;
    int from = fabs(unit[0]) < 0.9 ? 0 : 1;
    for (int k = 0; k < 3; k++) first[k] = (k == from) - unit[from] * unit[k];
    double size = sqrt(wf_dot(first, first));
    for (int k = 0; k < 3; k++) first[k] /= size;
    wf_cross(unit, first, second);
}

/* Section of a row that is a ring or has a cavity. */
static void by_radius(const struct wf_tree *t, size_t i, double s, struct wf_section *out)
{
    const struct wf_hollow *h = t->section->hollow ? t->section->hollow[i] : NULL;
    double r = wf_wood_radius(t, i, s), inner = wf_between(t->i0[i], t->i1[i], s);
    if (!h) {
        double inertia = wf_ring_inertia(r, inner);
        *out = (struct wf_section){ wf_ring_area(r, inner), inertia, inertia, 2 * inertia };
        return;
    }
    double r2 = r * r, mean = 0.5 * (h->xx + h->yy), spread = hypot(0.5 * (h->xx - h->yy), h->xy);
    *out = (struct wf_section){ h->area * r2, (mean + spread) * r2 * r2, (mean - spread) * r2 * r2,
                                h->torsion * r2 * r2 };
}

struct wf_wall wf_section_wall(const struct wf_tree *t, size_t i, double s)
{
    double r = wf_wood_radius(t, i, s), inner = wf_between(t->i0[i], t->i1[i], s);
    const struct wf_hollow *h = t->section && t->section->hollow ? t->section->hollow[i] : NULL;
    if (!h) return (struct wf_wall){ r - inner, r, false };
    return (struct wf_wall){ h->wall * r, h->radius * r, h->open };
}

void wf_section_at(const struct wf_tree *t, size_t i, double s, struct wf_section *out)
{
    const struct wf_tree_sections *c = t->section;
    if (c->width0[i] == 0 && c->width1[i] == 0) {
        by_radius(t, i, s, out);
        return;
    }
    double w = wf_between(c->width0[i], c->width1[i], s), h = wf_between(c->height0[i], c->height1[i], s);
    *out = (struct wf_section){ 0 };
    for (size_t k = 0; k < WF_SECTION_SHAPES; k++) {
        double share = wf_between(c->mix0[WF_SECTION_SHAPES * i + k], c->mix1[WF_SECTION_SHAPES * i + k], s);
        struct wf_section one;
        if (!(share > 0)) continue;
        wf_section_of((enum wf_section_shape)k, w, h, &one);
        out->area += share * one.area;
        out->upright += share * one.upright;
        out->lying += share * one.lying;
        out->torsion += share * one.torsion;
    }
}

double wf_tree_area(const struct wf_tree *t, size_t i, double s)
{
    double outer = wf_between(t->r0[i], t->r1[i], s), inner = wf_between(t->i0[i], t->i1[i], s);
    struct wf_section of;
    if (wf_section_is_ring(t, i) || t->section->hollow) return wf_ring_area(outer, inner);
    wf_section_at(t, i, s, &of);
    return of.area;
}
