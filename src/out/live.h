/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_LIVE_H
#define WF_OUT_LIVE_H
/* What the sliders of pages show: of a report the shapes of its trees at every wind with an answer
 * (reports/live.js reads it), of runs in time their key frames (reports/frames.js), of rain those of branch, leaves and drops
 * (reports/rain.js), with their numbers. */
#include "base/arena.h"
#include "base/err.h"
#include <jansson.h>

/* Given: a results folder and its document. Returned: *out, JSON in the arena that can stand in a <script> of
 * a page: its texts are keys, all else are numbers; NULL where nothing moves (no run of several key frames,
 * or too many of them for a page). Where the shapes have more points than a page should carry, stems alone
 * are taken. Errors: WF_EINPUT for a table that cannot be read, WF_ENOMEM. */
enum wf_status wf_live_data(const char *folder, const json_t *results, const char *units, struct wf_arena *a,
                            const char **out, struct wf_err *e);
#endif
