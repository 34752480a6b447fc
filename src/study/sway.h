/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SWAY_H
#define WF_STUDY_SWAY_H
/* How a tree sways about its state in a mean wind, for its peak load. */
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Complete an->peak for the scenario's method: size of the tree across the wind, terrain, damping, and sways
 * at some wind speeds, among them the given ones. Given: an analysis after wf_analysis_set_up. Returned:
 * an->peak, in `a`; an->wind, where the method has a wind of its own; warnings in `d` (NULL: none) where a
 * method is used beyond its validity. Errors: WF_EUSAGE for an unknown method or a request that does not go
 * together. */
enum wf_status wf_sway_set_up(struct wf_analysis *an, const struct wf_solve_options *o, const double *speeds,
                              size_t n, struct wf_arena *a, struct wf_diag *d, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
