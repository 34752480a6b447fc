/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_FIT_H
#define WF_CMD_ASSESS_FIT_H
/* From a fitted pulling test to an assessment: what a results folder of windfirm fit says of one tree. */
#include "base/arena.h"
#include "base/err.h"
#include "cmd/analyze_request.h"
#include "data/species.h"
#include "study/assessment.h"
#include <stdio.h>

/* A line of a record: what one sensor shows under the force of a rope, or in wind. */
struct wf_assess_record {
    const char *test, *sensor;
    double height;      /* of the sensor [m] */
    double rope, level; /* height at which the rope pulls [m]; its horizontal share of the force [-] */
    double azimuth;     /* towards which the tree was pulled [rad] */
    double quarter;     /* moment on the ground at 0.25 deg of the plate [N m]; NAN: not reached */
    double slope;       /* strain over force [1/N]; NAN: it is no strain */
    double gauge;       /* length by which an extension is a strain [m]; 1: it is one [-] */
    bool offset;        /* readings do not begin at 0: slopes are from the first one */
    double first[2];    /* reading and force of that; NAN: none yet */
    double most;        /* largest reading, or what it rose by from the first [rad] or [-] */
    double force;       /* largest of the rope [N] */
    bool in_wind;       /* a tilt of the root plate in wind: of the above `most` alone */
    double wind;        /* at that reading [m/s] */
};
enum { WF_ASSESS_RECORDS = 16 };

struct wf_assess_fit {
    const char *study, *species, *model; /* files */
    struct wf_value youngs, root;        /* fitted; not given: the fit left it. [Pa], [N m rad-1] */
    size_t records;
    struct wf_assess_record record[WF_ASSESS_RECORDS];
};

/* Read FOLDER, the study that it names, which must be the one that was fitted, and the readings. Errors:
 * WF_EINPUT with mistakes in `d`: no fit of one tree, none of the two values; a study that has changed. */
enum wf_status wf_assess_fit_read(const char *folder, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_assess_fit *out, struct wf_err *e);

/* Its tree, with what the options say beside it. Errors: mistakes in `d`; any other error is in `e`. */
enum wf_status wf_assess_fit_model(const struct wf_assess_fit *f, const struct wf_analyze_options *o,
                                   struct wf_arena *a, struct wf_model *out, struct wf_diag *d,
                                   struct wf_err *e);
/* Its root onto a request, as its spring and, unless the options name an anchorage, as what that is found by.
 */
enum wf_status wf_assess_fit_onto(const struct wf_assess_fit *f, const struct wf_analyze_options *o,
                                  struct wf_arena *a, struct wf_analyze_request *q, struct wf_err *e);

/* Second safeties straight from the record, and the direction of the pull beside the weakest. Given: a
 * finished analysis whose strongest wind has its columns; the compressive strength over the fitted modulus is
 * the limit of strain. Returned: out->record. Errors: WF_ENOMEM. */
enum wf_status wf_assess_fit_say(const struct wf_assess_fit *f, const struct wf_analysis *an,
                                 struct wf_arena *a, struct wf_assessment *out, struct wf_err *e);
void wf_assess_fit_print(FILE *to, const struct wf_assess_fit *f, const struct wf_assessment *x);
#endif
