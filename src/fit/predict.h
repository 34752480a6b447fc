/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_PREDICT_H
#define WF_FIT_PREDICT_H
/* Predicted readings of all sensors and their derivatives by all parameters. */
#include "fit/param.h"

struct wf_predictor;

/* Working memory for an experiment and its parameters, all from `a`; both must outlive it. Errors: WF_ENOMEM.
 */
enum wf_status wf_predictor_open(const struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                                 struct wf_arena *a, struct wf_predictor **out, struct wf_err *e);
/* Free the memory outside the arena. */
void wf_predictor_close(struct wf_predictor *w);

/* Given: internal parameter values. Returned: reading[data] [SI], slope[data x n] (may be NULL): derivatives
 * by the internal values. Method: geometrically exact beams; derivatives are the linearised response of the
 * solved tree to the change of equilibrium by a parameter (solve/beam_small.h), exact but for the stretch
 * that follows from a change of wind by motion; those of natural frequencies are differences of Rayleigh
 * quotients with the mode shape fixed (wf_modes_held). Small parts of standing trees that would fall with
 * these values are stiffened, in the experiment's trees (struct wf_fit_props). Errors: WF_EUNSTABLE,
 * WF_ENOCONV where the tree has no equilibrium. */
enum wf_status wf_predict(struct wf_predictor *w, const double *internal, double *reading, double *slope,
                          struct wf_err *e);

/* Simulated readings: to plan a test, and to check that a fit recovers a known tree. */

/* Predicted readings of an experiment at the parameters' start values, and the sigma of every datum. Given:
 * slope: data x n, may be NULL. Returned: reading[data] [SI]; warnings about stiffened parts and unclear
 * modes. Errors: WF_EINPUT for a sensor without a sigma; as wf_predict. */
enum wf_status wf_fit_expect(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                             struct wf_arena *a, double *reading, double *slope, struct wf_diag *d,
                             struct wf_err *e);
/* Set the data to those readings plus normal noise of `noise` sigmas, which depends on the seed only. */
void wf_fit_make_up(struct wf_experiment *x, const double *reading, uint64_t seed, double noise);
#endif
