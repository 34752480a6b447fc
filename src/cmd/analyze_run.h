/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ANALYZE_RUN_H
#define WF_CMD_ANALYZE_RUN_H
/* A run of windfirm analyze or compare: read, analyse, print, write, draw. */
#include "cmd/analyze_request.h"
#include "data/model.h"
#include "out/results.h"
#include <time.h>

enum {
    OTHER_FILES = 6 + 2 * WF_CAVITIES_MAX
}; /* model, study, profile, climate, ground, anchorage; of cavities */

/* Everything of one run, in one arena. */
struct wf_analyze_work {
    struct wf_arena arena;
    struct wf_analyze_options options;
    struct wf_analyze_request request;
    const char *folder;
    struct wf_run_folder results;
    struct wf_model model;
    struct wf_species *species;
    struct wf_analysis *analysis;
    size_t inputs;
    struct wf_input_file *input;
    struct wf_diag *diag; /* one per species */
    size_t solved;        /* trees whose given speeds were printed */
    bool all_models;      /* of the scan: say how far they differ */
    struct wf_diag tree;  /* warnings about the file of the tree */
    struct timespec started;
};

/* Read the model and the species, analyse each, print what was found, and put results, tables, plots and
 * pages into the folder. Given: options that wf_args_read has filled, the folder, when the run was started;
 * the command line as typed. The caller leaves the results folder (wf_run_abandon) and frees the arena.
 * Errors: of reading, of the analysis, of writing; mistakes in files and warnings have been printed. */
enum wf_status wf_analyze_run(struct wf_analyze_work *w, int argc, char **argv, struct wf_err *e);
#endif
