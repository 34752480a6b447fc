/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_HELD_H
#define WF_STUDY_HELD_H
/* Forces of cables, rods and guys in the wind in which the tree is lost. */
#include "study/speed.h"

struct wf_nodes; /* study/node.h */
/* Branches are solved in their own state too, on the mesh of the search. Given: an analysis with its critical
 * winds and the nodes of their search. Returned: an->held; not known where the time of the search is used up.
 * Errors: WF_ENOMEM, WF_EINTERRUPTED. */
enum wf_status wf_held_find(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_nodes *nodes,
                            struct wf_err *e);
#endif
