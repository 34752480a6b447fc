/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_CLOTHE_H
#define WF_GROW_CLOTHE_H
/* A species' materials and leaves on the segments of a tree. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"

struct wf_species;

struct wf_clothing {
    double leaf_area;    /* one-sided, whole tree [m2]; 0: leaf-off */
    const uint8_t *kind; /* enum wf_segment_kind per segment (grow/qsm_model.h); NULL: all wood */
};

/* Given: a tree with geometry and levels, a species, what it wears. Returned: E, G, density, strength (MOR
 * times knot factor; 0 when the species has no MOR), drag (NAN: Reynolds law), lift, damping and inner radius
 * of every row by its level (measured trees, those with `kind`: wf_species_wood), levels beyond the species'
 * last clamped to it; wall by the position along the row's branch (rows of one level joined end to end).
 * Links get stiffness but no mass, drag or strength. Leaves: spread evenly over the length of the terminal
 * shoots, that is, of all rows with a single tip above them; still-air sail = leaf area x the crown's
 * frontal_share x drag_coefficient, burden = leaf area x leaf_mass_per_area. Errors: WF_EINPUT for a species
 * without levels or a negative leaf area; WF_ENOMEM. */
enum wf_status wf_clothe(struct wf_tree *t, const struct wf_species *sp, const struct wf_clothing *c,
                         struct wf_arena *a, struct wf_err *e);

/* The same without the leaves, whose columns stay as they are. `c` may be NULL: all wood. */
enum wf_status wf_clothe_wood(struct wf_tree *t, const struct wf_species *sp, const struct wf_clothing *c,
                              struct wf_err *e);
#endif
