/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_STEM_H
#define WF_GROW_STEM_H
/* A tree from a stem model and a species' materials. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "data/tree.h"

struct wf_species;

/* Given: a model and a species whose level 0 clothes the stem. Returned: the tree, one row after the other
 * from the ground to the tip. Rows: about m->segments equal ones; a row also ends at the crown's base and top
 * and at every knot of the taper, wall and crown tables, and an equal step within a tenth of its length of
 * such a place gives way to it. Radii and walls are exact at row ends; linear tapers and tables are exact
 * everywhere. Crown: leaf area per length follows the model's shape, zero outside the crown, scaled so that
 * the rows add up to m->leaf_area; sail = leaf area x frontal_share x drag_coefficient; burden = leaf area x
 * leaf mass. Strength is the modulus of rupture times the knot factor, 0 where the species has none. Errors:
 * WF_EINPUT for leaves without a crown in the species table, for sections of a hollow species; WF_ENOMEM. */
enum wf_status wf_grow_stem(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                            struct wf_tree *out, struct wf_err *e);

#endif
