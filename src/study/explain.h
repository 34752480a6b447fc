/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_EXPLAIN_H
#define WF_STUDY_EXPLAIN_H
/* Difference of each method from beam theory by branch: the same tree in the same wind by every solver. */
#include "study/analysis.h"

enum { WF_EXPLAIN_METHODS = 8 };

struct wf_explain_axis { /* one a branch */
    size_t first, last;  /* rows       */
    int32_t level;
    double length, radius, height; /* of the base [m] */
    double beam; /* displacement of its end less the rigid motion with its base, by the beam solver [m] */
    double ratio[WF_EXPLAIN_METHODS]; /* the same by each method over the beam's [-]; NAN: no result */
};
struct wf_explain {
    size_t methods, axes;
    const struct wf_solver *method[WF_EXPLAIN_METHODS];
    enum wf_status status[WF_EXPLAIN_METHODS];
    struct wf_explain_axis *axis;
    double *room;                   /* axes; scratch for sorting */
    double tip[WF_EXPLAIN_METHODS]; /* total deflection of the stem's tip over the beam's [-] */
};

/* Given: an analysis after wf_analysis_set_up, a wind speed [m/s]. Every solver of wf_solvers but the
 * beam is a method. A branch's own deflection is that of its end less the motion of a straight, rigid branch
 * fixed to its base, so that errors of its parent are not counted again. Errors: those of the beam solver
 * when it has no result. */
enum wf_status wf_explain_run(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                              struct wf_arena *a, struct wf_diag *d, struct wf_explain *out,
                              struct wf_err *e);

int32_t wf_explain_top(const struct wf_explain *x); /* highest level */
struct wf_explain_spread {
    size_t branches, answers;
    double low, middle, high; /* ratios; NAN: no result [-] */
};
/* Ratios of a method over the branches of a level. */
void wf_explain_spread(const struct wf_explain *x, size_t method, int32_t level,
                       struct wf_explain_spread *out);
/* Share of all branches whose ratio is within `off` of 1 [-]. */
double wf_explain_share(const struct wf_explain *x, size_t method, double off);
#endif
