/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_LIVE_H
#define WF_OUT_LIVE_H
/* What the slider of a report's page shows: the shapes of its trees at every wind with an answer, with their
 * numbers. reports/live.js reads it. */
#include "base/arena.h"
#include "base/err.h"
#include <jansson.h>

/* Given: a results folder and its document. Returned: *out, JSON in the arena that can stand in a <script> of
 * a page: its texts are keys, all else are numbers. Where the shapes have more points than a page should
 * carry, stems alone are taken. Errors: WF_EINPUT for a table that cannot be read, WF_ENOMEM. */
enum wf_status wf_live_data(const char *folder, const json_t *results, const char *units, struct wf_arena *a, const char **out,
                            struct wf_err *e);
#endif
