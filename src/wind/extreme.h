/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_EXTREME_H
#define WF_WIND_EXTREME_H
/* How often a wind is exceeded: distributions of the largest wind of a year, fitted to annual maxima or
 * derived from the distribution of all hours. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Generalised extreme value distribution of the annual maximum of x, the wind speed or its square:
 * F(x) = exp(-(1 - k (x - mode) / scale)^(1/k)); k = 0 is Gumbel's, F = exp(-exp(-(x - mode) / scale)). */
struct wf_extreme {
    double mode, scale; /* [m/s], or [m2/s2] where squared; scale above 0 */
    double shape;       /* k [-]: above 0, winds have an upper bound; 0: Gumbel's */
    bool squared;       /* x is the square of the speed, which is proportional to pressure */
};

/* Ways to fit Gumbel's distribution; the last fits the shape too. Rows. */
enum wf_extreme_method { WF_MOMENTS, WF_LIKELIHOOD, WF_L_MOMENTS, WF_GEV, WF_EXTREME_METHODS };
struct wf_extreme_row {
    const char *name, *title, *source;
    bool shaped; /* fits the shape */
};
extern const struct wf_extreme_row wf_extreme_rows[WF_EXTREME_METHODS];

enum { WF_EXTREME_YEARS_MIN = 5, WF_EXTREME_YEARS_MAX = 10000 };

/* Fit a distribution to annual maxima. Given: n speeds [m/s], of one year each, in any order. Returned: *out.
 * Method: moments: scale = s / C1, mode = mean - C2 scale, with standard deviation s and constants C1, C2 of
 * the reduced variates -ln(-ln(i / (n + 1))) of n years (Gumbel E.J. 1958, Statistics of Extremes, table
 * 6.2.3; GB 50009-2012, annex E). likelihood: scale = mean - sum(x e^(-x/scale)) / sum(e^(-x/scale)).
 * l-moments: scale = l2 / ln 2, mode = l1 - 0.5772 scale; gev: Hosking J.R.M., Wallis J.R., Wood E.F. 1985,
 * Technometrics 27:251-261. Errors: WF_EINPUT for fewer than WF_EXTREME_YEARS_MIN years, a speed that is not
 * above 0, or years that are all alike; WF_ENOMEM. */
enum wf_status wf_extreme_fit(enum wf_extreme_method method, bool squared, const double *speed, size_t n,
                              struct wf_extreme *out, struct wf_err *e);

/* The largest hourly wind of a year where all hours follow a Weibull distribution. Given: scale A [m/s],
 * shape k. Returned: *out, of the squared speed. Source: the method of ForestGALES (Quine C.P. 2000; Cook
 * N.J. 1985, The designer's guide to wind loading): mode (u A)^2 with u = -0.5903 k^3 + 4.4345 k^2 - 11.8633
 * k + 13.569, scale mode / 5. Validity: k of 1.5 to 2.2, climates without tropical cyclones. Errors:
 * WF_EUSAGE. */
enum wf_status wf_extreme_of_weibull(double scale, double shape, struct wf_extreme *out, struct wf_err *e);
/* Weibull scale [m/s] of a DAMS score (detailed aspect method of scoring, Quine 2000): -0.9626 + 0.4279 DAMS.
 */
double wf_extreme_dams_scale(double dams);

/* Probability that a speed [m/s] is exceeded in a year [-]; accurate where it is small. */
double wf_extreme_exceedance(const struct wf_extreme *x, double speed);
/* The same in at least one of n years. */
double wf_extreme_over_years(double a_year, double years);
/* Years between exceedances on average: 1 / probability a year. */
double wf_extreme_return_period(const struct wf_extreme *x, double speed);
/* Speed that is exceeded once in a number of years above 1, on average [m/s]. */
double wf_extreme_speed(const struct wf_extreme *x, double years);

/* Band of the speed of each return period by the parametric bootstrap: `sets` samples of n years drawn from
 * *x and fitted by the same method. Given: method; n; return periods; share of the band, 0.9: 5 % of trials
 * lie below and above it. Returned: low[count], high[count] [m/s]; sets that cannot be fitted are drawn
 * again. Method: studentised: the error of a fitted quantile over the fitted scale has a distribution that
 * does not depend on mode and scale, so that the band of Gumbel's distribution has the share named whatever
 * the method's bias (Efron B., Tibshirani R.J. 1993, An Introduction to the Bootstrap, ch. 12). With a fitted
 * shape that distribution depends on the shape, and the studentised band fell with the return period: there
 * the ends are points of the fitted quantiles themselves (ch. 13), which ascend with the return period. The
 * true wind lies above their 95 % point more often than named, on the unsafe side; so the upper end is their
 * 99 % point, or that of Gumbel's band by L-moments where it is higher. Errors: WF_EUSAGE, WF_ENOMEM. */
enum wf_status wf_extreme_band(const struct wf_extreme *x, enum wf_extreme_method method, size_t n,
                               const double *years, size_t count, double share, size_t sets, uint64_t seed,
                               double *low, double *high, struct wf_err *e);

/* A distribution with the speeds of some return periods. */
struct wf_extreme_levels {
    enum wf_extreme_method method; /* of a fit                                                       */
    struct wf_extreme x;
    size_t n;                   /* annual maxima that it was fitted to; 0: it is not of a sample      */
    size_t count;               /* return periods                                                     */
    const double *years;        /* count, each above 1                                                */
    double *speed, *low, *high; /* count [m/s]; the band of 90 % is NAN where n is 0                  */
};
/* Sets of the band's bootstrap, and its seed: the same data give the same band. */
enum { WF_EXTREME_SETS = 2000, WF_EXTREME_SEED = 1 };
/* Fill speed, low, high. Given: the members before them. Errors: WF_ENOMEM; WF_EUSAGE for a return period
 * that is not above 1. */
enum wf_status wf_extreme_levels_make(struct wf_extreme_levels *l, struct wf_arena *a, struct wf_err *e);
#endif
