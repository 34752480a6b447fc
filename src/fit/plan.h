#ifndef WF_FIT_PLAN_H
#define WF_FIT_PLAN_H
/* Readings a test would give: for planning one, and to see whether a fit gives a known tree back. */
#include "fit/param.h"

/* What the sensors of an experiment read when the parameters have their start values, and the sigma of every
 * datum. Given: slope: data x n, may be NULL. Returned: reading[data] [SI]. Errors: WF_EINPUT for a sensor
 * without a sigma; as wf_predict. */
enum wf_status wf_fit_expect(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                             struct wf_arena *a, double *reading, double *slope, struct wf_err *e);
/* Make the data such readings with normal noise of so many sigmas: the same seed, the same noise. */
void wf_fit_make_up(struct wf_experiment *x, const double *reading, uint64_t seed, double noise);
#endif
