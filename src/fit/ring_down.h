/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_RING_DOWN_H
#define WF_FIT_RING_DOWN_H
/* Frequency and damping of free sway. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>

struct wf_ring_down {
    double frequency, frequency_sd; /* undamped, f = f_d / sqrt(1 - zeta^2) [Hz]        */
    double damping, damping_sd;     /* share of critical [-]                            */
    double amplitude, phase, mean;  /* of the fitted curve, in the unit of the samples  */
    double decay, turn;             /* rate [1/s]; angular frequency as damped [rad/s]  */
    double explained;               /* share of the variance that the curve explains    */
};

/* Fit y = A exp(-d t) cos(w t + p) + c. Given: n >= 12 samples, times [s] rising. Errors: WF_EINPUT for
 * samples that do not oscillate or cover less than 1.5 periods; WF_ENOCONV. Method: bounded least
 * squares, started at the highest peak of the spectrum; standard errors enlarged for correlated residuals
 * (fit/fit.h). */
enum wf_status wf_ring_down(const double *t, const double *y, size_t n, struct wf_arena *a,
                            struct wf_ring_down *out, struct wf_err *e);
double wf_ring_down_at(const struct wf_ring_down *r, double t);
#endif
