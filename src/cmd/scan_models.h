/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_SCAN_MODELS_H
#define WF_CMD_SCAN_MODELS_H
/* The models of a scan. Programs that fit cylinders to a scan give another model at each run; how far the
 * answers of the models differ is part of how sure the answer is. */
#include "cmd/option_groups.h"
#include "data/species.h"
#include "study/analysis.h"

struct wf_scan_models {
    const struct wf_tree_asked *tree; /* the file of the scan                       */
    size_t models;                    /* in it                                      */
    size_t n;                         /* species                                    */
    const struct wf_species *species;
    const struct wf_analysis *first;    /* analyses of model 1, one a species          */
    struct wf_diag *diag;               /* one a species                               */
    const struct wf_scenario *scenario; /* of all analyses, as of wf_analyze        */
    const struct wf_search *search;
    const struct wf_solver *solver;
    const struct wf_solve_options *solve;
    const struct wf_speeds *wind;
};

/* Analyse the other models. Returned: a warning `scan-models` in each diag with the range of the critical
 * wind speed and the height over the models; after an interrupt, over those that were analysed. Errors: those
 * of wf_tree_asked_read and wf_analyze. */
enum wf_status wf_scan_models_analyse(const struct wf_scan_models *w, struct wf_arena *a, struct wf_err *e);
#endif
