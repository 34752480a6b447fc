/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_PROGRAM_H
#define WF_OUT_PROGRAM_H
/* The external programs that draw (gnuplot) and print pages (WeasyPrint), and the files of reports/ that they
 * are given. A program is found on PATH and run without a shell. Its environment is that of windfirm in the
 * locale C.UTF-8; no file of windfirm is open in it; processor time (600 s) and memory (8 GiB) are limited.
 * It dies with windfirm. */
#include "base/err.h"
#include "base/file.h"
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

enum { WF_SAID_MAX = 2048 }; /* what is kept of what a program prints [bytes] */

/* A program that was found: its file, what messages call it, the Debian package that contains it, its
 * arguments and the folder it runs in (NULL: the current one). */
struct wf_program {
    char path[WF_PATH_MAX];
    const char *name, *package, *const *argv, *folder;
};

/* A program that runs: what is written to `in` it reads (-1: it has no input); `out` are both its outputs. */
struct wf_running {
    pid_t child;
    int in, out;
};

/* The file of a program. Only absolute folders of PATH are searched: a relative one would mean a place below
 * the folder in which the program is run, which may be a stranger's. Returned: whether there is one, in
 * `path`. */
bool wf_program_found(const char *name, char path[static WF_PATH_MAX]);
/* WF_EMISSING, with the package to install. */
enum wf_status wf_program_missing(const struct wf_program *p, struct wf_err *e);
/* Run a program to its end, with an empty input. What it prints is kept, the first WF_SAID_MAX - 1 bytes of
 * it, in `said`. Errors: WF_EOUTPUT with its output when it failed; WF_EMISSING when it says, by status 127,
 * that a part of it is not there. */
enum wf_status wf_program_run(const struct wf_program *p, char said[static WF_SAID_MAX], struct wf_err *e);

/* Start a program; talks: it reads what wf_program_tell writes. To be ended by wf_program_end. Errors:
 * WF_EOUTPUT. */
enum wf_status wf_program_start(const struct wf_program *p, bool talks, struct wf_running *r,
                                struct wf_err *e);
/* Write n bytes to its input. Returned: false when it has ended. */
bool wf_program_tell(const struct wf_running *r, const void *bytes, size_t n);
/* Add what it prints to `said`, up to a zero byte, which is an answer's end, or the end of its output. Output
 * that does not fit is read and dropped, so that a full pipe never blocks the program. Returned: whether it
 * was an answer. */
bool wf_program_hear(const struct wf_running *r, char said[static WF_SAID_MAX]);
/* Close its input and wait for its end. Added to `said`: the rest of its output. Errors: as wf_program_run.
 */
enum wf_status wf_program_end(const struct wf_program *p, struct wf_running *r, char said[static WF_SAID_MAX],
                              struct wf_err *e);

/* Path of a file of the report: $WINDFIRM_SHARE/reports/NAME, else where it was installed. Returned: WF_OK
 * and `path`, or WF_EINPUT when there is no such file. */
enum wf_status wf_report_asset(const char *name, char *path, size_t size, struct wf_err *e);
/* The same as a path that holds wherever a program is run. Errors: as wf_report_asset. */
enum wf_status wf_report_asset_anywhere(const char *name, char path[static WF_PATH_MAX], struct wf_err *e);
#endif
