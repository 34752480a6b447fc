/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_CRITICAL_H
#define WF_FAIL_CRITICAL_H
/* Critical wind speed: the lowest speed at which a criterion (load / resistance) reaches 1. */
#include "base/err.h"
#include <stddef.h>

enum wf_critical_outcome {
    WF_CRITICAL_FOUND,
    WF_CRITICAL_ABOVE,       /* criterion stays below 1 up to the highest speed searched */
    WF_CRITICAL_SELF_WEIGHT, /* fails without wind */
    WF_CRITICAL_NO_STRENGTH, /* no row has a modulus of rupture */
    WF_CRITICAL_UNSOLVED,    /* no equilibrium was found above `speed_low`: the bracket is reported */
    WF_CRITICAL_UNSEARCHED   /* not searched for; it is not below `speed_low` */
};
struct wf_critical {
    enum wf_critical_outcome outcome;
    double speed;                 /* [m/s]; NAN unless found */
    double speed_low, speed_high; /* bracket at the end, or range searched [m/s] */
    double gradient;              /* d criterion / d speed at `speed` [s/m] */
    size_t evaluations;
};
/* Search for the critical wind speed. Given: criterion(ctx, speed [m/s], &value) returning WF_OK, WF_ENOCONV
 * or WF_EUNSTABLE where no equilibrium exists, or another error, which ends the search and is returned;
 * highest speed [m/s]; relative tolerance on the speed. A value that is not a number at speed 0 means that
 * no strength is known. Returned: WF_OK and *out, whatever the outcome; WF_EUSAGE, WF_ENOMEM, WF_EINTERNAL
 * (not a number in wind). Method: 32 even steps from 0 to speed_max until the criterion reaches 1 or no
 * equilibrium is found, so that the lowest crossing is found where crossings are more than a step apart;
 * then Brent's method (GSL) until evaluations on both sides confirm a bracket within the tolerance. Where no
 * equilibrium is found, bisection towards the highest speed that has one; a crossing found on the way takes
 * precedence. */
enum wf_status
wf_critical_search(enum wf_status (*criterion)(void *ctx, double speed, double *value, struct wf_err *e),
                   void *ctx, double speed_max, double tolerance, struct wf_critical *out, struct wf_err *e);
/* Speed of the k-th of these steps, k = 0..WF_CRITICAL_RUNGS [m/s]. A caller with several processors may
 * evaluate some of them in parallel before the search. */
enum { WF_CRITICAL_RUNGS = 32 };
double wf_critical_rung(double speed_max, int k);
/* The outcome in words, for reports. */
const char *wf_critical_text(enum wf_critical_outcome o);
#endif
