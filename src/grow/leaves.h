#ifndef WF_GROW_LEAVES_H
#define WF_GROW_LEAVES_H
/* Leaves on the axes of a branched tree. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "data/species.h"
#include "data/tree.h"

/* Given: a grown tree whose leaf0, leaf1 hold the share of each row that bears leaves. Returned in the tree:
 * one-sided leaf area per length, the same on every leafy length, in all m->leaf_area; still-air sail = leaf
 * area x frontal_share x drag_coefficient; burden = leaf area x leaf_mass_per_area. Errors: WF_EINPUT when
 * the species has no crown, or when no axis bears leaves. */
enum wf_status wf_leaves_spread(const struct wf_model *m, const struct wf_species *sp, struct wf_tree *t,
                                struct wf_err *e);

/* Single leaves or clusters of one kind, columns: one model scaled and turned (Zhao and Zhang 2013), hanging
 * on the tree and moved by the wind (Tang and others 2012, equation 13: turns proportional to the wind
 * speed). */
struct wf_leaves {
    size_t n;
    int32_t *row;        /* segment it hangs on                                            */
    double *place;       /* on it, 0..1                                                    */
    double *area;        /* one-sided [m2]; the sum is the model's leaf area               */
    double *size;        /* of the leaf over the mean leaf [-]                             */
    double *direction;   /* 3n: unit vector from the hanging point along the leaf          */
    double *side;        /* 3n: unit vector across it, in the leaf's plane                 */
    double swing, twist; /* turn about the hanging point and about the vertical [rad s/m] */
};

/* Given: a tree after wf_leaves_spread and its model. Returned: the model's count of leaves, placed at equal
 * steps of leaf area, each turned by 137.5 degrees about its axis from the one before; none where the model
 * counts none or in the leafless season. Sizes and angles are random by the model's seed. WF_ENOMEM. */
enum wf_status wf_leaves_place(const struct wf_model *m, const struct wf_tree *t, struct wf_arena *a,
                               struct wf_leaves *out, struct wf_err *e);
#endif
