/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/lsq.h"
#include <math.h>

/* The losses as Ceres has them: rho(s) of s = r^2 with rho'(0) = 1, cost rho/2, so psi = r rho'(r^2). */
void wf_loss_slopes(enum wf_loss loss, double a, double r, double *psi, double *slope)
{
    double u = r / a, u2 = u * u;
    switch (loss) {
    case WF_LOSS_HUBER:
        *psi = fabs(u) <= 1 ? r : copysign(a, r);
        *slope = fabs(u) <= 1 ? 1 : 0;
        return;
    case WF_LOSS_CAUCHY:
        *psi = r / (1 + u2);
        *slope = (1 - u2) / ((1 + u2) * (1 + u2));
        return;
    case WF_LOSS_TUKEY:
        *psi = u2 < 1 ? r * (1 - u2) * (1 - u2) : 0;
        *slope = u2 < 1 ? (1 - u2) * (1 - 5 * u2) : 0;
        return;
    default:
        *psi = r;
        *slope = 1;
    }
}
