/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_FIT_H
#define WF_FIT_FIT_H
/* Fit of parameters to sensor readings, with their uncertainty. */
#include "base/err.h"
#include "fit/intervals.h"

void wf_fit_options_default(struct wf_fit_options *o);

/* Akaike's criterion with the correction for few data (Hurvich and Tsai 1989), variance unknown: n ln(S/m) +
 * 2 k + 2 k (k+1)/(n-k-1), S = squared residuals over the sigmas of `like`, m = readings, k = parameters + 1,
 * n = number of independent readings (each sensor's number over its inflation squared, of `like`). Two fits
 * of the same data can be compared when both have the same `like`. NAN where there are too few data. */
double wf_fit_aicc(const struct wf_fit *f, const struct wf_fit *like);

/* Fit. Given: experiment, parameters (free ones first, then nuisance) with start and bounds, options.
 * Returned: WF_OK and *out, all from `a`; warnings in d. Errors: WF_EUSAGE, WF_EINPUT as wf_lsq_solve.
 * Method: least squares of readings over their sigma. Sigmas not given are estimated from the residuals of
 * each sensor by iteration. Where neighbouring residuals of a sensor are correlated (r of lag 1), sigma is
 * enlarged by sqrt((1+r)/(1-r)), the loss of independent readings in a first-order autoregressive series
 * (Bartlett 1946). A reduced chi-square above 1 enlarges all sigmas by its square root. Covariance: inverse
 * of J'J; with a robust loss the sandwich of Huber 1967. */
enum wf_status wf_fit_run(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                          const struct wf_fit_options *o, struct wf_arena *a, struct wf_diag *d,
                          struct wf_fit *out, struct wf_err *e);
#endif
