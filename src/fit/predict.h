/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_PREDICT_H
#define WF_FIT_PREDICT_H
/* What the engine says every sensor reads, and how that changes with every parameter. */
#include "fit/param.h"

struct wf_predictor;

/* Working memory for an experiment and its parameters, all from `a`; both must outlive it. Errors: WF_ENOMEM.
 */
enum wf_status wf_predictor_open(const struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                                 struct wf_arena *a, struct wf_predictor **out, struct wf_err *e);
/* Give back what grew outside the arena. */
void wf_predictor_close(struct wf_predictor *w);

/* Given: internal parameter values. Returned: reading[data] [SI], slope[data x n] (may be NULL): change with
 * each internal value. Method: geometrically exact beams; sensitivities are first-order answers of the solved
 * tree to the change a parameter makes in its balance (solve/beam_small.h), exact but for the stretch of the
 * axis; those of natural frequencies are Rayleigh quotients of the mode held (wf_modes_held). Errors:
 * WF_EUNSTABLE, WF_ENOCONV where the tree has no equilibrium. */
enum wf_status wf_predict(struct wf_predictor *w, const double *internal, double *reading, double *slope,
                          struct wf_err *e);

/* Readings a test would give: for planning one, and to see whether a fit gives a known tree back. */

/* What the sensors of an experiment read when the parameters have their start values, and the sigma of every
 * datum. Given: slope: data x n, may be NULL. Returned: reading[data] [SI]. Errors: WF_EINPUT for a sensor
 * without a sigma; as wf_predict. */
enum wf_status wf_fit_expect(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                             struct wf_arena *a, double *reading, double *slope, struct wf_err *e);
/* Make the data such readings with normal noise of so many sigmas: the same seed, the same noise. */
void wf_fit_make_up(struct wf_experiment *x, const double *reading, uint64_t seed, double noise);
#endif
