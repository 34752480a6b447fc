/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_PROGRAM_H
#define WF_OUT_PROGRAM_H
/* Outside programs: found on PATH, run without a shell, listened to. */
#include "base/err.h"

enum { WF_SAID_MAX = 512 };

/* Given: argv, ending at NULL, argv[0] the program's name; the Debian package that brings it. Its input is
 * empty; what it prints is kept, the first WF_SAID_MAX - 1 bytes of it, in `said`.
 * Returned: WF_OK when it ended with status 0; WF_EMISSING naming the package when it is not installed;
 * WF_EOUTPUT with its own words when it failed. */
enum wf_status wf_program_run(const char *const *argv, const char *package, char said[static WF_SAID_MAX],
                              struct wf_err *e);
#endif
