/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_PLANT_H
#define WF_FIT_PLANT_H
/* Trees of a fit: from the calibration's keys to segments with their materials, which stand in their shape or
 * are free of stress in it. */
#include "fit/calibration.h"
#include "fit/experiment.h"
#include "grow/import_file.h"

/* The tree of index `index` of a calibration: its species, its model or scan, its loads, and the options of
 * its solution. A measured tree, or a model with shape under_weight, stands in its shape with what it carried
 * on that day, unless the calibration says otherwise. Given: the folder of the shipped species/ and models/;
 * mat, the reader of MATLAB files. Errors: WF_EINPUT with mistakes in d; WF_EMISSING. */
enum wf_status wf_fit_tree_build(const struct wf_calibration *c, size_t index, const char *share,
                                 wf_import_reader *mat, struct wf_arena *a, struct wf_diag *d,
                                 struct wf_fit_tree *out, struct wf_err *e);

/* Room for the parts of a standing tree that have to be stiffened, once its rows are final. Errors:
 * WF_ENOMEM.
 */
enum wf_status wf_fit_tree_prop(struct wf_fit_tree *t, struct wf_arena *a, struct wf_err *e);

/* Does a standing tree carry the same as on the day of its shape? */
bool wf_fit_tree_unchanged(const struct wf_fit_tree *t);

/* Let a standing tree stand firm. Given: `now`, its columns with the values that are tried, their loads and
 * options. Small parts that would not stand are stiffened, in `now` and for good (struct wf_fit_props).
 * Errors: WF_EUNSTABLE where the stem, a large part or the root would not stand. */
enum wf_status wf_fit_tree_firm(const struct wf_fit_tree *t, struct wf_tree *now, const struct wf_loads *l,
                                const struct wf_solve_options *o, struct wf_err *e);

/* Say which parts were stiffened. */
void wf_fit_tree_warn(const struct wf_fit_tree *t, struct wf_diag *d);
#endif
