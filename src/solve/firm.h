/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_FIRM_H
#define WF_SOLVE_FIRM_H
/* Does a standing tree (struct wf_tree_standing) stand firm? Its shape is an equilibrium with any wood, but
 * with wood that is too soft, or radii that are too small, not a stable one. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"

/* A part that would not stand: a row and all above it, down to where its axis leaves another. */
struct wf_firm_part {
    size_t row;
    double mass;   /* of the part [kg] */
    double factor; /* of its own weight that it would carry, its base held [-] */
    double raise;  /* factor by which E and G of its rows were raised [-] */
};
struct wf_firm {
    size_t n;
    struct wf_firm_part *part;
    double mass;  /* of the tree [kg] */
    bool root;    /* the root plate would not hold the tree */
    bool gave_up; /* it does not stand: part[n - 1] is too heavy to be stiffened, or the root, or no end was
                     found */
    int32_t refused; /* row of the part that is too heavy; -1: none */
};

/* Stiffen what would not stand. Given: a standing tree, its loads (only weight is used), options (root plate,
 * beam model); `share`, parts below this share of the tree's mass are stiffened; `load_factor` up to which.
 * Returned: *out; youngs and shear of the tree are new columns in `a` where parts were stiffened. Errors:
 * WF_ENOMEM, those of the beam's mesh. Method: negative pivots of the tangent in the given shape; the load
 * factor of a part, its base held, by bisection of the weight. Where a part that is too heavy would not
 * stand, the light ones above it that carry less than the load factor are stiffened first: what stands with
 * soft wood, whose light parts are stiffened because they fall, then also stands with stiffer wood, whose
 * light parts just do not. */
enum wf_status wf_firm(struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                       double share, double load_factor, struct wf_arena *a, struct wf_firm *out,
                       struct wf_err *e);
#endif
