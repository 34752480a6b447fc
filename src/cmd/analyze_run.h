/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ANALYZE_RUN_H
#define WF_CMD_ANALYZE_RUN_H
/* A run of windfirm analyze or compare: read, analyse, print, write, draw. */
#include "cmd/analyze_scenarios.h"
#include "data/model.h"
#include "out/results.h"
#include <time.h>

struct wf_analyze_work;
/* What another command does at some points of the run, with its own struct, which begins with the work. */
struct wf_analyze_hooks {
    /* In place of reading the tree: sets w->model. Mistakes are in `d`, any other error in `e`. */
    enum wf_status (*tree)(struct wf_analyze_work *w, struct wf_diag *d, struct wf_err *e);
    /* All is read; nothing is computed. */
    enum wf_status (*before)(struct wf_analyze_work *w, struct wf_err *e);
    /* In place of printing a finished analysis. */
    enum wf_status (*after)(struct wf_analyze_work *w, struct wf_analysis *an, struct wf_err *e);
};

/* Everything of one run, in one arena. */
struct wf_analyze_work {
    struct wf_arena arena;
    struct wf_analyze_options options;
    struct wf_bytes picture[WF_JOB_PICTURES]; /* photograph and logo of the page */
    struct wf_analyze_request request;
    struct wf_analyze_list scenarios;
    const char *folder;
    struct wf_run_folder results;
    struct wf_model model;
    struct wf_species *species;
    struct wf_analysis *analysis;
    struct wf_inputs inputs;
    struct wf_diag *diag; /* one per species */
    size_t solved;        /* trees whose given speeds were printed */
    bool all_models;      /* of the scan: say how far they differ */
    struct wf_diag tree;  /* warnings about the file of the tree */
    struct timespec started;
    const struct wf_analyze_hooks *hooks; /* NULL: none */
};

/* Read the model and the species, analyse each, print what was found, and put results, tables, plots and
 * pages into the folder. Given: options that wf_args_read has filled, the folder (NULL: nothing is written),
 * when the run was started; the command line as typed. The caller leaves the results folder (wf_run_abandon)
 * and frees the arena. Errors: of reading, of the analysis, of writing; mistakes in files and warnings have
 * been printed. */
enum wf_status wf_analyze_run(struct wf_analyze_work *w, int argc, char **argv, struct wf_err *e);
#endif
