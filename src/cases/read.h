/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_READ_H
#define WF_CASES_READ_H
/* Validation files to cases. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "cases/case.h"

/* Read a case file. Every mistake becomes a line of `d`. Returned: *list, *n; WF_EINPUT when there was any.
 */
enum wf_status wf_case_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_case **list,
                            size_t *n, struct wf_err *e);

const char *wf_case_kind_name(enum wf_case_kind k); /* "closed-form", ... */
#endif
