/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_PRESS_H
#define WF_CMD_PRESS_H
/* Pages of many results folders: while some are printed the next are drawn. Printing takes most of the time
 * of a report, and each WeasyPrint prints one page at a time. */
#include "cmd/commands.h"
#include "out/printer.h"
#include "out/run_folder.h"

enum { WF_PRESS_MAX = 4 }; /* that print at the same time */

/* A page that is being printed. */
struct wf_press_place {
    struct wf_printer printer;
    struct wf_run_folder run;
    bool taken;
    size_t number; /* of the caller's, of the folder */
    enum wf_status drawn;
    struct wf_err why;
};
struct wf_press {
    size_t places, next;
    size_t failed; /* the least number of a folder that failed; SIZE_MAX: none */
    struct wf_press_place place[WF_PRESS_MAX];
};

/* Print on as many processors as `threads` asks for (base/parallel.h), at most WF_PRESS_MAX. */
void wf_press_open(struct wf_press *p, size_t threads);
/* As wf_results_end, but the page is printed while the caller goes on; the folder is the press's from now on.
 * An error may be that of a folder that was given before: `failed` says which is the first. */
enum wf_status wf_press_put(struct wf_press *p, struct wf_run_folder *r, size_t number,
                            const struct wf_pages *pages, struct wf_arena *a, struct wf_err *e);
/* The least number of a folder that is not in place, at most `end`. */
size_t wf_press_placed(const struct wf_press *p, size_t end);
/* Wait until all folders are in place. Errors: as wf_results_end, of the first that failed. */
enum wf_status wf_press_drain(struct wf_press *p, struct wf_err *e);
/* End all processes; folders that are not in place are given up. */
void wf_press_close(struct wf_press *p);
#endif
