/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_SESSION_H
#define WF_FIT_SESSION_H
/* Internal to a fit: residuals for the least squares solver, with some parameters held. */
#include "base/err.h"
#include "fit/lsq.h"
#include "fit/param.h"
#include "fit/predict.h"

struct wf_fit_options {
    enum wf_loss loss;
    double loss_scale; /* in robust standard deviations; NAN: 1.345 Huber, 2.385 Cauchy, 4.685 Tukey (95 %
                        * efficient for normal errors; Holland and Welsch 1977)                          */
    bool priors;       /* the ranges of the species table are used as normal prior distributions         */
    bool profile;      /* also compute intervals by profile likelihood                                   */
    size_t starts, resamples; /* starting points (1: the given one), bootstrap data sets (0: none)          */
    uint64_t seed;
    wf_lsq_progress *progress; /* may be NULL; ctx is progress_ctx */
    void *progress_ctx;
};

struct wf_session {
    struct wf_experiment *x;
    const struct wf_fit_param *p;
    size_t n, priors; /* parameters; residuals of priors, after those of the data */
    const struct wf_fit_options *o;
    struct wf_predictor *predictor;
    double *sigma;    /* per datum, as used in the fit                            */
    double *internal; /* all parameters                                           */
    bool *held;
    double *low, *high; /* internal bounds                                          */
    double *reading, *slope;
    double *chain;                        /* derivative of an internal value by the solver's variable */
    double *start, *free_low, *free_high; /* scratch of that solver, packed                     */
    double scale;                         /* of the loss, in sigma                                    */
    bool stopped;                         /* by progress                                              */
    struct wf_err model;                  /* reason of the model's last failure                       */
    struct wf_err fatal; /* a failure for which the whole fit must end: no memory, a fault; later predictions
                          * are not tried */
};

enum wf_status wf_session_open(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                               const struct wf_fit_options *o, struct wf_arena *a, struct wf_session *s,
                               struct wf_err *e);
void wf_session_close(struct wf_session *s);
/* Minimise over the parameters that are not held, from s->internal to s->internal. out->cost: half the sum of
 * losses. */
enum wf_status wf_session_solve(struct wf_session *s, struct wf_lsq_result *out, struct wf_err *e);
/* Robust standard deviation 1.4826 MAD of n numbers (about 0); scratch: n. */
double wf_robust_sd(const double *x, size_t n, double *scratch);
#endif
