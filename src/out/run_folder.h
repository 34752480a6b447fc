/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_RUN_FOLDER_H
#define WF_OUT_RUN_FOLDER_H
/* A results folder in the hands of one run.
 *
 * A run writes into a stage, FOLDER/.windfirm-PID, which is made before anything is computed. When it is
 * done, its files are moved into the folder one by one, results.json last. results.json lists every other
 * file with size and SHA-256, so that files of two runs that stand together (the system stopped between two
 * moves) are noticed by `windfirm report`. While a run has a folder it holds a lock on FOLDER/.windfirm.lock.
 * Files that no run made are neither moved nor replaced nor removed. */
#include "base/err.h"
#include "base/file.h"
#include <jansson.h>
#include <stdbool.h>

/* A folder while a run has it; { 0 } before. */
struct wf_run_folder {
    char path[WF_PATH_MAX];  /* as given                                                       */
    char stage[WF_PATH_MAX]; /* where the run writes: PATH/.windfirm-PID                        */
    char name[32];           /* of the stage in the folder                                      */
    bool held;               /* the three below are valid                                       */
    int dir, lock;           /* descriptors: folder, lock                                       */
    size_t there;            /* bytes of `path` that name folders which were there before       */
    bool again;              /* pages of results that are there are drawn again                 */
    bool unlisted;           /* the earlier results.json is of a version that listed no files   */
    json_t *before;          /* files of the earlier results.json: name, size, sha256           */
    json_t *kept;            /* those of them that are as listed and stay; only with `again`    */
};

/* Take a folder for a new run: make it, lock it, remove stages of runs that died in it, make the stage with
 * tables/ and plots/. page: name of the page that is to be drawn ("report" for report.html and report.pdf),
 * NULL: none. Errors: WF_EOUTPUT where the folder cannot be written, another run has it, or files are in the
 * way that no run made; the folder is then as it was. */
enum wf_status wf_run_begin(struct wf_run_folder *r, const char *folder, const char *page, struct wf_err *e);
/* Take a folder to draw its pages again: as wf_run_begin, but the folder must hold results, and those that
 * are to be drawn are copied into the stage, checked against the list of results.json. no_pdf: a PDF of the
 * run before is removed at the commit, because none is made in its place; so is a .docx that is not made anew. Figures and pages that do not match
 * are warnings (they are drawn again), as is a results.json without a list. Errors: WF_EINPUT naming what is
 * missing or is not of this run. */
enum wf_status wf_run_reopen(struct wf_run_folder *r, const char *folder, bool no_pdf, struct wf_diag *d,
                             struct wf_err *e);
/* Write "status" into the stage's results.json: "complete" or "interrupted". The pages show it. */
enum wf_status wf_run_mark(const struct wf_run_folder *r, const char *status, struct wf_err *e);
/* Move the files of the stage into the folder and give the folder free. Unchanged files of the earlier run
 * that this one does not have are removed. Errors: WF_EOUTPUT; with a file in the way that no run made,
 * nothing was moved. */
enum wf_status wf_run_commit(struct wf_run_folder *r, struct wf_err *e);
/* Remove the stage, and the folder where the run made it and it is empty; give the folder free. Does nothing
 * after a commit or an earlier call. */
void wf_run_abandon(struct wf_run_folder *r);
/* Take the stage's name out of a message, so that it names the folder's files. Changes `text`. */
void wf_run_plain(const struct wf_run_folder *r, char *text);
#endif
