/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_REDUCTION_H
#define WF_STUDY_REDUCTION_H
/* A drawn crown that is cut back all round, to its own outline made smaller. */
#include "study/speed.h"

/* Cut the scenario's reduction off the tree, a rule: from the point of the stem's axis where the lowest
 * branch leaves it the crown reaches as far in each direction as the farthest tip within 20 degrees of it;
 * what lies beyond the share of that, or the length less, is cut, with all that it carries, the top of the
 * stem too. Given: an analysis whose tree is grown and has lost what the scenario removes. Returned: its
 * tree, and `cut` with what is thinned. Errors: WF_EINPUT for a tree without drawn branches, or of whose
 * crown less than a twentieth is left; WF_ENOMEM. */
enum wf_status wf_reduction_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e);
#endif
