/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_CRITICAL_H
#define WF_FAIL_CRITICAL_H
/* Critical wind speed: the lowest speed at which a criterion (load / resistance) reaches 1. */
#include "base/err.h"
#include <stddef.h>

enum wf_critical_outcome {
    WF_CRITICAL_FOUND,
    WF_CRITICAL_ABOVE,       /* criterion stays below 1 up to the highest speed searched     */
    WF_CRITICAL_SELF_WEIGHT, /* fails without wind                                            */
    WF_CRITICAL_NO_STRENGTH, /* no row has a modulus of rupture                               */
    WF_CRITICAL_UNSOLVED,    /* the model had no answer beyond `speed_low`: bracket is reported */
    WF_CRITICAL_UNSEARCHED   /* not searched for; it is not below `speed_low`                */
};
struct wf_critical {
    enum wf_critical_outcome outcome;
    double speed;                 /* [m/s]; NAN unless found                               */
    double speed_low, speed_high; /* bracket at the end, or range searched [m/s]           */
    double gradient;              /* d criterion / d speed at the answer [s/m]              */
    size_t evaluations;
};
/* Given: criterion(ctx, speed [m/s], &value) returning WF_OK, WF_ENOCONV or WF_EUNSTABLE where no equilibrium
 * exists, or another failure, which ends the search and is returned; highest speed [m/s]; tolerance on the
 * speed, relative. A value that is not a number without wind means that there is no strength to compare with.
 * Returned: WF_OK and *out, whatever the outcome; WF_EUSAGE, WF_ENOMEM, WF_EINTERNAL (not a number in wind).
 * Method: 32 even steps from 0 to speed_max until the criterion reaches 1 or has no value, so that the lowest
 * crossing is found where crossings lie more than a step apart; then Brent's method (GSL), whose bracket is
 * proven on both sides; where the model has no answer, halving down to the last speed that has one, watching
 * for a crossing. */
enum wf_status
wf_critical_search(enum wf_status (*criterion)(void *ctx, double speed, double *value, struct wf_err *e),
                   void *ctx, double speed_max, double tolerance, struct wf_critical *out, struct wf_err *e);
/* Speed of the k-th of those steps, k = 0..WF_CRITICAL_RUNGS [m/s]: a caller that has several processors may
 * work out some before the search asks for them. */
enum { WF_CRITICAL_RUNGS = 32 };
double wf_critical_rung(double speed_max, int k);
const char *wf_critical_text(enum wf_critical_outcome o);
#endif
