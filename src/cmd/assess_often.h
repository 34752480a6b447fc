/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_OFTEN_H
#define WF_CMD_ASSESS_OFTEN_H
/* How often winds blow at a tree that is assessed: from a fit of annual maxima, or the maxima themselves. */
#include "base/arena.h"
#include "base/err.h"
#include "cmd/analyze_request.h"
#include "study/assessment.h"

/* Given: a results folder of 'windfirm wind extremes', whose fit is taken, or a table of annual maxima,
 * 10-min means at 10 m over open country, to whose squares Gumbel's distribution is fitted by moments.
 * Returned: extreme, source and band of *out in the arena. Errors: WF_EINPUT with mistakes in `d`. Warning
 * `few-years` for less than 20 years. */
enum wf_status wf_assess_often_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                    struct wf_assess_often *out, struct wf_err *e);
/* The file that was read. Errors: as wf_inputs_note. */
enum wf_status wf_assess_often_note(const char *path, struct wf_inputs *in, struct wf_err *e);
#endif
