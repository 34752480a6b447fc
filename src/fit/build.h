/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_BUILD_H
#define WF_FIT_BUILD_H
/* From a study and its files to an experiment. */
#include "fit/calibration.h"
#include "fit/param.h"
#include "fit/record.h"
#include "fit/ring_down.h"
#include "grow/import_file.h"

/* What was read for one test, kept for figures. */
struct wf_fit_input {
    const char *path; /* NULL: no data file                                  */
    struct wf_fit_record record;
    bool swung;
    struct wf_ring_down sway;
    const char *profile, *ground;      /* measured profile and heights of the ground; NULL: none */
    const char *load_name, *load_unit; /* "pull" "kN", "wind" "m/s"             */
    double load_factor;                /* SI to that unit                       */
};

struct wf_fit_build {
    const struct wf_fit_study *study;
    const char *share;       /* folder with the shipped species/ and models/             */
    const char *const *data; /* files of tests that name none, in the order of the tests */
    size_t datas;
    bool plan;             /* loads and speeds of the study in place of data           */
    wf_import_reader *mat; /* of MATLAB files, as in struct wf_import_options       */
};

/* Trees: materials, rows cut where something is measured. Errors: WF_EINPUT with mistakes in d; WF_EMISSING
 * where a file is not there. in: one per test. */
enum wf_status wf_fit_build(const struct wf_fit_build *b, struct wf_arena *a, struct wf_diag *d,
                            struct wf_experiment *x, struct wf_fit_input *in, struct wf_err *e);

/* Parameters of the study, or of `names` (comma-separated) where it is not NULL, and the sensors' offsets and
 * drifts. plan: start values are the species table's, whatever the study says. Returned: *out, *n. */
enum wf_status wf_fit_params(const struct wf_fit_study *s, const char *names, const struct wf_experiment *x,
                             bool plan, struct wf_arena *a, struct wf_fit_param **out, size_t *n,
                             struct wf_err *e);

#endif
