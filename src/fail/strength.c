/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of a section of wood: what it bears, and the stress that is compared with it; see docs/failure.md.
 */
#include "base/num.h"
#include "data/section.h"
#include "fail/fail.h"
#include <math.h>

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
    return hypot(l->stress, l->twist * t->strength[i] / t->shearing[i]);
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
    return wf_wall_splits(t->youngs[i], t->tangential[i], wf_wall_share(t, i, s));
}

static bool ovalisation_known(const struct wf_tree *t, size_t i)
{
    return t->transverse[i] > 0 && thin_wall(t, i);
}

static double ovalisation_limit(const struct wf_tree *t, size_t i, double s)
{
    return wf_wall_flattens(t->youngs[i], t->transverse[i], wf_wall_share(t, i, s));
}

const struct wf_section_rule wf_section_rules[WF_SECTION_RULES] = {
    [WF_RULE_BENDING] = { NULL, bending_known, bending_stress, bending_strength },
    [WF_RULE_ELASTIC] = { NULL, elastic_known, elastic_stress, elastic_limit },
    [WF_RULE_TORSION] = { NULL, torsion_known, torsion_stress, bending_strength },
    [WF_RULE_SPLITTING] = { thin_wall, splitting_known, nominal_stress, splitting_limit },
    [WF_RULE_OVALISATION] = { thin_wall, ovalisation_known, nominal_stress, ovalisation_limit },
};
