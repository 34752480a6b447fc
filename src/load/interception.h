/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_INTERCEPTION_H
#define WF_LOAD_INTERCEPTION_H
/* Rain that the leaves of a tree hold, as mass on its segments. */
#include "data/tree.h"

/* How much water leaves store, per one-sided area [kg m-2 = mm]; each with how it was found. */
struct wf_storage {
    const char *name, *source;
    double film;
};
extern const struct wf_storage wf_storages[]; /* the default first; ends at name == NULL */
const struct wf_storage *wf_storage_named(const char *name);

/* Put a film on the leaves of a tree: its burden grows by film times leaf area, spread as the leaves are.
 * Given: film per one-sided leaf area [kg m-2]. Returned: mass of the water [kg]; 0 for a tree without
 * leaves. */
double wf_intercept(struct wf_tree *t, double film);
/* Leaves of a crown that is known by its frontal area alone: one-sided leaf area per axis length = sail over
 * drag coefficient and frontal share, spread as the sail is. Returned: their area [m2]; 0 without sail. */
double wf_leaves_of_sail(struct wf_tree *t, double drag_coefficient, double frontal_share);
/* One-sided leaf area of a tree [m2]. */
double wf_tree_leaf_area(const struct wf_tree *t);
#endif
