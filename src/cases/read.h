/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_READ_H
#define WF_CASES_READ_H
/* Reading validation files. */
#include "base/arena.h"
#include "base/err.h"
#include "cases/case.h"

/* Read a case file. Given: path. Returned: *list, *n, from the arena; every mistake is an error in `d` with
 * its line. Errors: WF_EINPUT when there was any, WF_ENOMEM, and those of reading the file. */
enum wf_status wf_case_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_case **list,
                            size_t *n, struct wf_err *e);

const char *wf_case_kind_name(enum wf_case_kind k); /* "closed-form", ... */
#endif
