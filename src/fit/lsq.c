/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/lsq.h"
#include <math.h>

/* The losses as Ceres has them: rho(s) of s = r^2 with rho'(0) = 1, cost rho/2, so psi = r rho'(r^2). In
 * each, u2 = (r/a)^2. */
static double rho_none(double a, double r)
{
    (void)a;
    return r * r;
}

static void slopes_none(double a, double r, double *psi, double *slope)
{
    (void)a;
    *psi = r;
    *slope = 1;
}

static double rho_huber(double a, double r)
{
    double a2 = a * a, u2 = r * r / a2;
    return u2 > 1 ? 2 * a * fabs(r) - a2 : r * r;
}

static void slopes_huber(double a, double r, double *psi, double *slope)
{
    double u = r / a;
    *psi = fabs(u) <= 1 ? r : copysign(a, r);
    *slope = fabs(u) <= 1 ? 1 : 0;
}

static double rho_cauchy(double a, double r)
{
    double a2 = a * a, u2 = r * r / a2;
    return a2 * log1p(u2);
}

static void slopes_cauchy(double a, double r, double *psi, double *slope)
{
    double u = r / a, u2 = u * u;
    *psi = r / (1 + u2);
    *slope = (1 - u2) / ((1 + u2) * (1 + u2));
}

static double rho_tukey(double a, double r)
{
    double a2 = a * a, u2 = r * r / a2;
    return a2 / 3 * (u2 < 1 ? 1 - pow(1 - u2, 3) : 1);
}

static void slopes_tukey(double a, double r, double *psi, double *slope)
{
    double u = r / a, u2 = u * u;
    *psi = u2 < 1 ? r * (1 - u2) * (1 - u2) : 0;
    *slope = u2 < 1 ? (1 - u2) * (1 - 5 * u2) : 0;
}

const struct wf_loss_row wf_losses[] = {
    [WF_LOSS_NONE] = { "none", "least squares", 1, rho_none, slopes_none },
    [WF_LOSS_HUBER] = { "huber", "Huber 1964, Ann. Math. Statist. 35:73", 1.345, rho_huber, slopes_huber },
    [WF_LOSS_CAUCHY] = { "cauchy", "Cauchy", 2.385, rho_cauchy, slopes_cauchy },
    [WF_LOSS_TUKEY] = { "tukey", "Beaton and Tukey 1974, Technometrics 16:147", 4.685, rho_tukey,
                        slopes_tukey },
    { .name = NULL },
};
