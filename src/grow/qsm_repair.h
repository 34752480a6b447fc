/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_QSM_REPAIR_H
#define WF_GROW_QSM_REPAIR_H
/* Repair of a table of cylinders after reading. */
#include "grow/import_file.h"
#include "grow/qsm.h"

/* Make a table valid: every parent comes before its children, there is one stem or several that start at the
 * ground within 2 m, radii and lengths are positive and finite, branch orders count from 0 at the stem, and
 * the base of the main stem is the origin. All changes are counted in q->repairs. Given: the options of the
 * import. `strict`: refuse a table that needs repairs, with an error in `d` for each kind. `force`: take
 * stems that stand further apart. `cap_children`: thin rows that are thicker by a tenth than what they grow
 * on. Errors: WF_EINPUT when no usable row is left, when the parents do not fit the ids, when the table holds
 * several trees, or when refused; WF_ENOMEM. */
enum wf_status wf_qsm_repair(struct wf_qsm *q, const struct wf_import_options *o, struct wf_arena *a,
                             struct wf_diag *d, struct wf_err *e);
#endif
