/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strength of sections: the stress at the fibres of those that are not rings, what a section bears by each
 * criterion, and what branches bear over the clear wood of their stem; see docs/failure.md. */
#include "base/num.h"
#include "base/vec3.h"
#include "data/hollow.h"
#include "data/section.h"
#include "data/species.h"
#include "fail/fail.h"
#include <math.h>
#include <string.h>

/* ---- Stress at the fibres of sections that are not rings ---- */

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

/* ---- Bending ---- */

static bool bending_known(const struct wf_tree *t, size_t i) { return t->strength[i] > 0; }

static double bending_stress(const struct wf_tree *t, size_t i, double s, const struct wf_section_load *l)
{
    (void)t, (void)i, (void)s;
    return l->stress;
}

static double bending_strength(const struct wf_tree *t, size_t i, double s)
{
    (void)s;
    return t->strength[i];
}

/* ---- The elastic limit: the compressed side yields first ---- */

static bool elastic_known(const struct wf_tree *t, size_t i) { return t->compressive[i] > 0; }

static double elastic_stress(const struct wf_tree *t, size_t i, double s, const struct wf_section_load *l)
{
    (void)t, (void)i, (void)s;
    return fmax(0, l->compression);
}

static double elastic_limit(const struct wf_tree *t, size_t i, double s)
{
    (void)s;
    return t->compressive[i];
}

/* ---- Bending with torsion: the bending stress that uses as much of the section as both together ---- */

static bool torsion_known(const struct wf_tree *t, size_t i)
{
    return t->strength[i] > 0 && t->shearing[i] > 0;
}

static double torsion_stress(const struct wf_tree *t, size_t i, double s, const struct wf_section_load *l)
{
    (void)s;
    const double twist = l->twist * t->strength[i] / t->shearing[i];
    return sqrt(l->stress * l->stress + twist * twist);
}

/* ---- Walls of hollow sections ---- */

double wf_wall_share(const struct wf_tree *t, size_t i, double s)
{
    struct wf_wall w = wf_section_wall(t, i, s);
    return w.thickness / (w.radius - 0.5 * w.thickness);
}

/* Is the row hollow and closed, with a thin wall at one end at least? */
static bool thin_wall(const struct wf_tree *t, size_t i)
{
    if (t->stiff || (wf_section_is_ring(t, i) ? !(t->i0[i] > 0 && t->i1[i] > 0)
                                              : !t->section->hollow || !t->section->hollow[i]))
        return false;
    return !wf_section_wall(t, i, 0).open &&
           (wf_wall_share(t, i, 0) < WF_THICK_WALL || wf_wall_share(t, i, 1) < WF_THICK_WALL);
}

double wf_wall_splits(double youngs, double tangential, double share)
{
    return sqrt(2.0 / 3 * youngs * tangential * share);
}

double wf_wall_flattens(double youngs, double transverse, double share)
{
    return 2 * sqrt(2) / 9 * share * sqrt(youngs * transverse);
}

double wf_wall_held(double spacing, double youngs, double transverse, double radius, double thickness)
{
    const double middle = radius - 0.5 * thickness;
    double decay = pow(3 * transverse * thickness * thickness / (youngs * pow(middle, 6)), 0.25); /* [1/m] */
    double half = 0.5 * spacing * fmax(decay, WF_PI / (WF_NODES_APART * 2 * radius));
    if (!(half < 0.5 * WF_PI)) return 1;
    double flattened = 1 - 2 * cosh(half) * cos(half) / (cosh(2 * half) + cos(2 * half));
    return fmax(1, 1 / sqrt(flattened));
}

/* Of a row at a place; 1 where no diaphragms are counted. */
static double held(const struct wf_tree *t, size_t i, double s)
{
    if (!(t->node_spacing > 0) || t->level[i] != 0) return 1;
    struct wf_wall w = wf_section_wall(t, i, s);
    return wf_wall_held(t->node_spacing, t->youngs[i], t->transverse[i], w.radius, w.thickness);
}

/* Bending stress of a thin wall, M / (pi R^2 t). */
static double nominal_stress(const struct wf_tree *t, size_t i, double s, const struct wf_section_load *l)
{
    if (!wf_section_is_ring(t, i))
        return l->stress; /* with an eccentric cavity the stress is not the same all around */
    struct wf_wall w = wf_section_wall(t, i, s);
    double radius = w.radius - 0.5 * w.thickness;
    return l->bending / (WF_PI * radius * radius * w.thickness);
}

static bool splitting_known(const struct wf_tree *t, size_t i)
{
    return t->tangential[i] > 0 && thin_wall(t, i);
}

static double splitting_limit(const struct wf_tree *t, size_t i, double s)
{
    return held(t, i, s) * wf_wall_splits(t->youngs[i], t->tangential[i], wf_wall_share(t, i, s));
}

static bool ovalisation_known(const struct wf_tree *t, size_t i)
{
    return t->transverse[i] > 0 && thin_wall(t, i);
}

static double ovalisation_limit(const struct wf_tree *t, size_t i, double s)
{
    return held(t, i, s) * wf_wall_flattens(t->youngs[i], t->transverse[i], wf_wall_share(t, i, s));
}

const struct wf_section_rule wf_section_rules[WF_SECTION_RULES] = {
    [WF_RULE_BENDING] = { NULL, bending_known, bending_stress, bending_strength },
    [WF_RULE_ELASTIC] = { NULL, elastic_known, elastic_stress, elastic_limit },
    [WF_RULE_TORSION] = { NULL, torsion_known, torsion_stress, bending_strength },
    [WF_RULE_SPLITTING] = { thin_wall, splitting_known, nominal_stress, splitting_limit },
    [WF_RULE_OVALISATION] = { thin_wall, ovalisation_known, nominal_stress, ovalisation_limit },
};

/* ---- Branches ---- */

#define KANE "Kane B. 2007. Branch strength of Bradford pear. Arboric. Urban For. 33(4), table 3: 26 branches"

enum { FULL, INSIDE_BARK, OVER_BARK, OVER_BARK_CIRCLE };

const struct wf_branch_strength wf_branch_strengths[] = {
    [FULL] = { "full", "as in the species table", NULL, 1 },
    [INSIDE_BARK] = { "inside-bark", "thickness inside bark, as an ellipse", KANE, 0.72 },
    [OVER_BARK] = { "over-bark", "thickness over bark, as an ellipse", KANE, 0.55 },
    [OVER_BARK_CIRCLE] = { "over-bark-circle", "thickness over bark, as a circle of one diameter", KANE,
                           0.40 },
    { .name = NULL },
};

/* Does the species repeat a publication? */
static bool printed(const struct wf_species *sp)
{
    return sp->preset && strcmp(sp->preset, "corrected") != 0;
}

static const struct wf_branch_strength *strength_named(const char *name, const struct wf_species *sp,
                                                       const struct wf_tree *t)
{
    for (const struct wf_branch_strength *b = wf_branch_strengths; name && b->name; b++)
        if (!strcmp(b->name, name)) return b;
    return &wf_branch_strengths[printed(sp) ? FULL : t->bark0 ? INSIDE_BARK : OVER_BARK];
}

/* The lower of what is known. */
static void limit(double *strength, const struct wf_value *clear, double factor)
{
    if (clear->value > 0) *strength = fmin(*strength, factor * clear->value);
}

const struct wf_branch_strength *wf_branches_limit(const char *name, const struct wf_species *sp,
                                                   struct wf_tree *t)
{
    const struct wf_branch_strength *b = strength_named(name, sp, t);
    const struct wf_level *clear = sp->level;
    for (size_t i = 0; i < t->n && b->factor < 1; i++) {
        if (t->level[i] == 0) continue;
        limit(&t->strength[i], &clear->modulus_of_rupture, b->factor);
        limit(&t->compressive[i], &clear->compressive_strength, b->factor);
        limit(&t->shearing[i], &clear->shear_strength, b->factor);
    }
    return b;
}
