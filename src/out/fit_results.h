/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FIT_RESULTS_H
#define WF_OUT_FIT_RESULTS_H
/* The results of a calibration: results.json, tables, figures and pages of its folder. Nothing here depends
 * on the command line. */
#include "fit/build.h"
#include "fit/fit.h"
#include "out/results.h"

/* Second fit to the same data with the opposite root: clamped if the first was elastic, and vice versa. */
struct wf_fit_rival {
    bool made;
    const char *text; /* "clamped root" or "flexible root plate" */
    struct wf_fit fit;
    double aicc, own; /* of this fit, and of the first with the same sigmas [-] */
};

struct wf_fit_results {
    const char *command, *date; /* as typed; ISO 8601, UTC                          */
    const char *loss;           /* name of the loss that weighs residuals: "none"... */
    bool priors;                /* the species table's ranges were used              */
    struct wf_calibration calibration;
    struct wf_experiment x;
    struct wf_fit_input *input; /* per test                        */
    struct wf_fit_param *param; /* `params` of them, as in fit     */
    size_t params;
    struct wf_fit fit;
    struct wf_fit_rival rival;
    struct wf_diag diag; /* warnings of the fit             */
    size_t files;
    struct wf_input_file *file; /* calibration, species, trees, data */
};

/* Write FOLDER/results.json, tables/{parameters,readings,profiles,records}.csv and plots/run.csv; the folder
 * is made. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_fit_results_write(const struct wf_fit_results *of, const char *folder, struct wf_err *e);
#endif
