/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_LSQ_H
#define WF_FIT_LSQ_H
/* Bounded nonlinear least squares with robust losses. Implemented with Ceres, of which this header exposes
 * nothing. */
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum wf_loss {
    WF_LOSS_NONE,   /* squares                                            */
    WF_LOSS_HUBER,  /* linear beyond the scale (Huber 1964)                */
    WF_LOSS_CAUCHY, /* logarithmic beyond the scale                       */
    WF_LOSS_TUKEY   /* constant beyond the scale (Beaton and Tukey 1974)  */
};
/* A loss as a row. Its scale a is the residual, in standard deviations, at which it departs from squares.
 * With usual_scale it has 95 % of the efficiency of least squares for normal errors (Holland and Welsch 1977,
 * Commun. Statist. A6:813). */
struct wf_loss_row {
    const char *name, *source;
    double usual_scale;
    double (*rho)(double a, double residual); /* twice the cost of a residual */
    /* psi = d (rho / 2) / d residual, and its slope, for the covariance of a robust estimate. */
    void (*slopes)(double a, double residual, double *psi, double *slope);
};
extern const struct wf_loss_row wf_losses[]; /* by enum wf_loss; ends at name == NULL */

/* Residuals (and, unless NULL, their Jacobian, row-major residuals x params) at p. Returned: false when the
 * model has no solution there; the step is then shortened. Called from one thread only. */
typedef bool wf_lsq_model(void *ctx, const double *p, double *residual, double *jacobian);
/* Called after every iteration with the cost; returned: true to stop with the best so far. */
typedef bool wf_lsq_progress(void *ctx, size_t iteration, double cost);

struct wf_lsq {
    size_t params, residuals;
    const double *low, *high; /* bounds, inclusive                               */
    wf_lsq_model *model;
    wf_lsq_progress *progress; /* may be NULL                                     */
    void *ctx;
    enum wf_loss loss;
    double loss_scale;     /* residual at which the loss departs from squares */
    size_t plain;          /* the last `plain` residuals are without a loss   */
    size_t iterations_max; /* 0: 100                                          */
};

struct wf_lsq_result {
    double cost0, cost; /* half the sum of the losses, at start and end    */
    size_t iterations, evaluations;
    bool converged, stopped; /* stopped: by progress; p is the best so far      */
    char message[256];
};

/* Minimise 1/2 sum loss(residual^2). Given: *q, p = start within its bounds. Returned: WF_OK and p, also when
 * the iterations were used up or progress stopped it (see *out); WF_EUSAGE for a start outside the bounds or
 * fewer residuals than parameters; WF_EINPUT where the model has no finite answer at the start; WF_ENOCONV.
 * Method: Levenberg-Marquardt on the trust region with dense QR (Agarwal, Mierle and others, Ceres Solver);
 * bounds by an active set, so that the result satisfies the conditions of Karush, Kuhn and Tucker. */
enum wf_status wf_lsq_solve(const struct wf_lsq *q, double *p, struct wf_lsq_result *out, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
