/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_LEAVES_H
#define WF_GROW_LEAVES_H
/* Leaves on the axes of a branched tree. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "data/tree.h"

struct wf_species;

/* Distribute the model's leaf area over the tree. Given: a grown tree whose leaf0, leaf1 hold the share of
 * each row that has leaves. Returned in the tree: one-sided leaf area per length, the same on all leafy
 * lengths, in total m->leaf_area; still-air sail = leaf area x frontal_share x drag_coefficient; burden = leaf
 * area x leaf_mass_per_area. Errors: WF_EINPUT when the species has no crown, or no axis has leaves. */
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
