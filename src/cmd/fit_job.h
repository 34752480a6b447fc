#ifndef WF_CMD_FIT_JOB_H
#define WF_CMD_FIT_JOB_H
/* One calibration on its way from files to results, pages and a species table. */
#include "cmd/cmd.h"
#include "fit/build.h"
#include "fit/fit.h"
#include "out/results.h"
#include <stdio.h>

struct wf_fit_rival { /* the same data without, or with, a root plate that gives */
    bool made;
    const char *text; /* "clamped root" or "root plate that gives" */
    struct wf_fit fit;
    double aicc, own; /* of the rival, and of the fit itself with the same sigmas */
};

struct fit_options;
struct wf_fit_job {
    struct wf_arena arena;
    const struct fit_options *options; /* as typed */
    const char *folder, *command, *date, *loss;
    bool priors;
    struct wf_fit_study study;
    struct wf_experiment x;
    struct wf_fit_input *input; /* per test */
    struct wf_fit_param *param;
    size_t params;
    struct wf_fit fit;
    struct wf_fit_rival rival;
    struct wf_diag diag;
    size_t files;
    struct wf_input_file *file; /* study, species, trees, data */
};

/* results.json, tables/ and plots/run.gp of the folder. */
enum wf_status wf_fit_write(const struct wf_fit_job *j, struct wf_err *e);
/* plots/ *.svg, calibration.html and calibration.pdf of the folder; parts that could not be made are
 * warnings. */
enum wf_status wf_fit_pages(const char *folder, struct wf_diag *d, struct wf_err *e);
/* The species table of the first tree with the fitted values in place. */
enum wf_status wf_fit_write_species(const struct wf_fit_job *j, const char *path, struct wf_err *e);
#endif
