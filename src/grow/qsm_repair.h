/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_QSM_REPAIR_H
#define WF_GROW_QSM_REPAIR_H
/* From a table of cylinders as it was read to a sound one. */
#include "grow/qsm.h"

/* From what was read to a sound table: every parent before its children, one or several grounded stems, radii
 * and lengths positive and finite, branch order from 0 at the stem, base of the main stem at the origin.
 * Everything changed is counted in q->repairs. `strict`: refuse instead, naming every repair in `d`. Errors:
 * WF_EINPUT when nothing usable is left or strict refuses. */
enum wf_status wf_qsm_repair(struct wf_qsm *q, bool strict, struct wf_arena *a, struct wf_diag *d,
                             struct wf_err *e);
#endif
