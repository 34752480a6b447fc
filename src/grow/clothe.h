/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_CLOTHE_H
#define WF_GROW_CLOTHE_H
/* A species' materials and leaves on the segments of a tree. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
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

/* Leaves on the axes of a branched tree. */

struct wf_species;

/* Distribute the model's leaf area over the tree. Given: a grown tree whose leaf0, leaf1 hold the share of
 * each row that has leaves. Returned in the tree: one-sided leaf area per length, the same on all leafy
 * lengths, in total m->leaf_area; still-air sail = leaf area x frontal_share x drag_coefficient; burden =
 * leaf area x leaf_mass_per_area. Errors: WF_EINPUT when the species has no crown, or no axis has leaves. */
enum wf_status wf_leaves_spread(const struct wf_model *m, const struct wf_species *sp, struct wf_tree *t,
                                struct wf_err *e);

/* Single leaves or clusters of leaves, as columns. All have one shape, scaled and rotated (Zhao and Zhang
 * 2013); each hangs from a point of the tree and is rotated by the wind in proportion to its speed (Tang and
 * others 2012, equation 13). */
struct wf_leaves {
    size_t n;
    int32_t *row;      /* row of the tree that it hangs on                               */
    double *place;     /* place on the row, 0..1                                         */
    double *area;      /* one-sided [m2]; the sum is the model's leaf area               */
    double *size;      /* over the root mean square size of all leaves [-]               */
    double *direction; /* 3n: unit vector from the hanging point along the leaf          */
    double *side;      /* 3n: unit vector across it, in the leaf's plane                 */
    double swing,
        twist; /* rotation about the hanging point and about the vertical, per wind speed [rad s/m] */
};

/* Place single leaves on a tree. Given: a tree after wf_leaves_spread, and its model. Returned: as many
 * leaves as the model counts, at equal steps of leaf area, each rotated by 137.5 degrees about its axis from
 * the one before; none if the model counts none or in the leafless season. Sizes and angles are random,
 * determined by the model's seed. Errors: WF_ENOMEM. */
enum wf_status wf_leaves_place(const struct wf_model *m, const struct wf_tree *t, struct wf_arena *a,
                               struct wf_leaves *out, struct wf_err *e);
#endif
