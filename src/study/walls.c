/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/walls.h"
#include "base/num.h"
#include "data/hollow.h"
#include "data/model.h"
#include "data/section.h"
#include <math.h>

const struct wf_wall_limit wf_wall_limits[WF_WALL_LIMITS] = {
    [WF_WALL_BREAKS] = { "breakage", 1.0 },
    [WF_WALL_BREAKS2] = { "breakage", 1.5 },
    [WF_WALL_YIELDS] = { "elastic-limit", 1.5 },
};

/* Stress of a ring with a wall of that share of its radius. */
static double ring_stress(double moment, double axial, double radius, double share, bool compressed)
{
    double inner = radius * (1 - share), area = wf_ring_area(radius, inner);
    return moment * radius / wf_ring_inertia(radius, inner) + (compressed ? -axial : fabs(axial)) / area;
}

/* Does the ring carry it with the required safety? */
static bool holds(double moment, double axial, double radius, double share, const struct wf_ring_wood *w)
{
    double middle = radius * (1 - 0.5 * share), thin = share * radius / middle;
    double nominal = w->required * moment / (WF_PI * middle * middle * share * radius);
    if (w->required * ring_stress(moment, axial, radius, share, w->compressed) > w->strength) return false;
    if (thin >= WF_THICK_WALL) return true;
    return !(w->tangential > 0 && nominal > wf_wall_splits(w->youngs, w->tangential, thin)) &&
           !(w->transverse > 0 && nominal > wf_wall_flattens(w->youngs, w->transverse, thin));
}

double wf_wall_needed(double moment, double axial, double radius, const struct wf_ring_wood *w)
{
    double low = 0, high = 1;
    if (!(w->strength > 0) || isnan(moment + axial)) return NAN;
    if (!holds(moment, axial, radius, 1, w)) return INFINITY;
    while (high - low > 1e-12) { /* stresses fall and limits rise as the wall grows */
        double middle = 0.5 * (low + high);
        if (holds(moment, axial, radius, middle, w))
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* A place of a row: its basic safety and the walls needed there. */
static void place_add(const struct wf_tree *t, size_t i, int end, double moment, double axial,
                      struct wf_wall_safety *out)
{
    double radius = wf_wood_end(t, i, end), stress = ring_stress(moment, axial, radius, 1, false);
    if (t->strength[i] > 0) out->basic = fmin(out->basic, t->strength[i] / stress);
    for (int l = 0; l < WF_WALL_LIMITS; l++) {
        const struct wf_ring_wood wood = { .strength = l == WF_WALL_YIELDS ? t->compressive[i] : t->strength[i],
                                           .compressed = l == WF_WALL_YIELDS,
                                           .youngs = t->youngs[i],
                                           .tangential = t->tangential[i],
                                           .transverse = t->transverse[i],
                                           .required = wf_wall_limits[l].required };
        /* fmax leaves out NAN */
        out->share[l] = fmax(out->share[l], wf_wall_needed(moment, axial, radius, &wood));
    }
}

/* Least safety of a row by the criteria that break it as a stem: bending, splitting, flattening. */
static double row_safety(const struct wf_tree *t, const struct wf_breakage *b, size_t i)
{
    double least = t->strength[i] > 0 ? t->strength[i] / b->peak[i] : NAN;
    if (b->use[WF_SPLITTING]) least = fmin(least, 1 / b->use[WF_SPLITTING][i]);
    if (b->use[WF_OVALISATION]) least = fmin(least, 1 / b->use[WF_OVALISATION][i]);
    return least;
}

static struct wf_wall_safety safety_at(const struct wf_tree *t, int32_t cavity, const struct wf_at_speed *at)
{
    struct wf_wall_safety s = { NAN, NAN, { NAN, NAN, NAN } };
    const struct wf_breakage *b = &at->breakage;
    for (size_t i = 0; i < t->n && !at->status; i++) {
        if (t->section->cavity[i] != cavity) continue;
        place_add(t, i, 0, b->bending0[i], b->axial0[i], &s);
        place_add(t, i, 1, b->bending1[i], b->axial1[i], &s);
        s.present = fmin(s.present, row_safety(t, b, i));
    }
    return s;
}

static void losses(const struct wf_hollow *h, double azimuth, struct wf_walls *w)
{
    enum { STEPS = 360 };
    double least = INFINITY, along;
    for (int k = 0; k < STEPS; k++) {
        double angle = WF_PI * k / STEPS, z = wf_hollow_modulus(h, angle);
        if (z < least) least = z, w->worst = angle;
    }
    w->strength_loss = 1 - least;
    w->with_wind = 1 - wf_hollow_modulus(h, azimuth);
    w->stiffness_loss = 1 - wf_hollow_least(h, &along);
}

/* The row of a cavity in which it was measured, or the nearest. */
static size_t measured_row(const struct wf_tree *t, int32_t cavity, double at)
{
    size_t found = t->n;
    double nearest = INFINITY;
    for (size_t i = 0; i < t->n; i++) {
        double away = fmax(fmin(t->z0[i], t->z1[i]) - at, at - fmax(t->z0[i], t->z1[i]));
        if (t->section->cavity[i] == cavity && away < nearest) nearest = away, found = i;
    }
    return found;
}

enum wf_status wf_walls_assess(const struct wf_analysis *an, struct wf_arena *a, struct wf_walls **out,
                               size_t *n, struct wf_err *e)
{
    const struct wf_tree *t = &an->tree;
    const struct wf_model *m = an->model;
    *n = 0, *out = NULL;
    if (!t->section || !t->section->cavity) return WF_OK;
    struct wf_walls *w = *out = WF_TAKE(a, m->cavities, struct wf_walls);
    for (size_t c = 0; w && c < m->cavities; c++) {
        size_t i = measured_row(t, (int32_t)c, m->cavity[c].at);
        if (i == t->n) continue; /* less than a millimetre of it is on the stem */
        double rise = t->z1[i] - t->z0[i], s = fmin(fmax((m->cavity[c].at - t->z0[i]) / rise, 0), 1);
        struct wf_walls *x = &w[(*n)++];
        x->cavity = &m->cavity[c], x->hollow = t->section->hollow[i];
        x->radius = wf_wood_radius(t, i, s);
        x->wall = wf_section_wall(t, i, s).thickness;
        losses(x->hollow, an->scenario.azimuth, x);
        if (!(x->at = WF_TAKE(a, an->n, struct wf_wall_safety))) return wf_fail(e, WF_ENOMEM, "no memory");
        for (size_t k = 0; k < an->n; k++) x->at[k] = safety_at(t, (int32_t)c, &an->at[k]);
    }
    return w ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory for %zu cavities", m->cavities);
}
