/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_RUN_H
#define WF_CASES_RUN_H
/* Validation cases that are calibrations. */
#include "cases/case.h"

/* Fit the study of a case (WF_SHAPE_FIT), to its data or to made-up ones, and hold the answers against what
 * is wanted. Given: the case; share: folder of the shipped species and models. Returned: as wf_case_run; a
 * study whose data are not there is skipped. */
enum wf_status wf_case_fit(const struct wf_case *c, const char *share, struct wf_arena *a,
                           struct wf_verdict *v, struct wf_err *e);
#endif
