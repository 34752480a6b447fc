/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ANALYZE_BESIDE_H
#define WF_CMD_ANALYZE_BESIDE_H
/* The scenarios of windfirm analyze and compare: the tree as it stands beside itself with something changed. */
#include "cmd/analyze_run.h"

/* Read the scenarios of the options, each with its tree. Given: a run whose model is read. Returned: w->beside.
 * Errors: mistakes in `d`; any other error is in `e`. */
enum wf_status wf_analyze_beside_read(struct wf_analyze_work *w, struct wf_diag *d, struct wf_err *e);
/* Can they be drawn with this species? Asked before anything is computed. Errors: of the first that cannot. */
enum wf_status wf_analyze_beside_check(const struct wf_analyze_work *w, const struct wf_species *sp,
                                       struct wf_err *e);
/* Analyse them, after the tree as it stands. Roots and anchorage are those of that; one that stands in its
 * shape stands in it also as it is changed. Returned: an->beside. */
enum wf_status wf_analyze_beside_run(struct wf_analyze_work *w, struct wf_analysis *an, struct wf_err *e);
#endif
