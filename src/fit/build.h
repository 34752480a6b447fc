/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_BUILD_H
#define WF_FIT_BUILD_H
/* Makes an experiment from a calibration and its data files. */
#include "fit/calibration.h"
#include "fit/param.h"
#include "fit/ring_down.h"
#include "fit/test_data.h"
#include "grow/import_file.h"

/* Input of one test, kept for figures. */
struct wf_fit_input {
    const char *path; /* NULL: no data file                                  */
    struct wf_test_data data;
    bool swung;
    struct wf_ring_down sway;
    const char *profile, *ground;      /* files of the measured profile and of the terrain; NULL: none */
    const char *load_name, *load_unit; /* "pull" "kN", "wind" "m/s"             */
    double load_factor;                /* SI to that unit                       */
};

struct wf_fit_build {
    const struct wf_calibration *calibration;
    const char *share;       /* folder that contains the shipped species/ and models/    */
    const char *const *data; /* data files for tests without one, in the order of the tests */
    size_t datas;
    bool plan;             /* use loads and speeds of the calibration in place of data */
    wf_import_reader *mat; /* of MATLAB files, as in struct wf_import_options */
};

/* Build trees, with rows divided where something is measured, tests and data. Returned: *out, and `in`, one
 * for each test. Errors: WF_EINPUT with mistakes in d; WF_EMISSING for a file that does not exist. */
enum wf_status wf_fit_build(const struct wf_fit_build *b, struct wf_arena *a, struct wf_diag *d,
                            struct wf_experiment *x, struct wf_fit_input *in, struct wf_err *e);

/* Parameters of the calibration, or of `names` (comma-separated) where it is not NULL, and the sensors'
 * offsets and drifts. plan: start values are those of the species table, not of the calibration. Returned:
 * *out, *n. */
enum wf_status wf_fit_params(const struct wf_calibration *s, const char *names, const struct wf_experiment *x,
                             bool plan, struct wf_arena *a, struct wf_fit_param **out, size_t *n,
                             struct wf_err *e);

#endif
