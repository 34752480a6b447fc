/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_DRAG_KERNEL_H
#define WF_LOAD_DRAG_KERNEL_H
/* The drag laws as formulas, for a double or for many lanes (base/real.h); load/drag.h says what they mean.
 */
#include "base/log_exp.h"
#include "data/law.h"

/* Half width, in ln(U/reference), of the band in which the corner of the Vogel law at the reference speed is
 * rounded, so that the force has a continuous derivative. The largest deviation from the sharp law, at the
 * reference speed itself, is a factor exp(V/4 * 0.05): 0.9 % less drag for V = -0.7. Outside the band the
 * law is exact. */
#define WF_VOGEL_ROUNDING 0.05

/* ln(share) = V g(x), x = ln(speed/reference). The sharp law has g = 0 for x < 0 and g = x above, with a
 * corner at the reference speed that real crowns do not have. Within |x| < h the parabola (x+h)^2/(4h) joins
 * both branches with a continuous slope; outside that band the law is unchanged. */
WF_INLINE real vogel_share(real exponent, real reference, real speed, real *derivative)
{
    const double h = WF_VOGEL_ROUNDING;
    real_truth fast = real_below(reference * (1 - h), speed);
    *derivative = real_of(0);
    if (!real_any(fast)) return real_of(1);
    real held = real_choose(fast, speed, reference * (1 - h)),
         x = real_max(real_log(held / reference), real_of(-h));
    real_truth corner = real_below(x, real_of(h));
    real g = real_choose(corner, (x + h) * (x + h) * (1 / (4 * h)), x);
    real slope = real_choose(corner, (x + h) * (1 / (2 * h)), real_of(1));
    real share = real_exp(exponent * g);
    *derivative = real_choose(fast, share * exponent * slope / held, real_of(0));
    return real_choose(fast, share, real_of(1));
}

/* Interpolation of measured points by a smooth curve that never overshoots them: cubic Hermite pieces;
 * slopes by the rule of Steffen (1990, A simple method for monotonic interpolation in one dimension, Astron.
 * Astrophys. 239:443-450). The slope at the first and last point is zero, so that the curve joins the
 * constant beyond the ends with a continuous derivative. */

/* Slope at point i (0 < i < n-1) of n points x (rising), y. */
static inline double wf_smooth_slope(const double *x, const double *y, size_t n, size_t i)
{
    if (i == 0 || i + 1 >= n) return 0;
    double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i];
    double s0 = (y[i] - y[i - 1]) / h0, s1 = (y[i + 1] - y[i]) / h1;
    if (s0 * s1 <= 0) return 0;
    double p = (s0 * h1 + s1 * h0) / (h0 + h1);
    return copysign(2 * fmin(fmin(fabs(s0), fabs(s1)), 0.5 * fabs(p)), s0);
}

/* The cubic over 0 <= u <= 1 with values y0, y1 and slopes d0, d1 (per x) across a width h; its slope dy/dx.
 */
WF_INLINE real smooth_piece(real y0, real y1, real d0, real d1, real h, real u, real *slope)
{
    real a = h * d0, rise = y1 - y0, c = h * (d0 + d1) - 2 * rise, b = 3 * rise - h * (2 * d0 + d1);
    *slope = (a + u * (2 * b + 3 * u * c)) / h;
    return y0 + u * (a + u * (b + u * c));
}

/* The curve through a table that all lanes share. rise: its slopes at the points; NULL: they are computed. */
WF_INLINE real table_share(const struct wf_law_values *p, const double *rise, real speed, real *derivative)
{
    const double *x = p->list[0], *y = p->list[1];
    size_t n = p->n;
    *derivative = real_of(0);
    if (n == 0) return real_of(1);
    real share = real_of(y[0]);
    for (size_t i = 1; i < n; i++) {
        real_truth here = real_not_above(real_of(x[i - 1]), speed);
        if (!real_any(here)) break;
        double h = x[i] - x[i - 1], d0 = rise ? rise[i - 1] : wf_smooth_slope(x, y, n, i - 1);
        double d1 = rise ? rise[i] : wf_smooth_slope(x, y, n, i);
        real slope, at = smooth_piece(real_of(y[i - 1]), real_of(y[i]), real_of(d0), real_of(d1), real_of(h),
                                      (speed - x[i - 1]) / h, &slope);
        share = real_choose(here, at, share), *derivative = real_choose(here, slope, *derivative);
    }
    real_truth beyond = real_not_above(real_of(x[n - 1]), speed),
               before = real_not_above(speed, real_of(x[0]));
    *derivative = real_choose(beyond | before, real_of(0), *derivative);
    return real_choose(beyond, real_of(y[n - 1]), share);
}

/* Drag of a bare axis. */

#define LG2 0.30102999566398120 /* log10 2 */
#define LG5 0.69897000433601880 /* log10 5 */

/* A point of the law: log10 Re, coefficient, and d coefficient / d log10 Re by wf_smooth_slope, tabulated
 * because this law is evaluated at every load point of every element. A point and the next one are read at
 * once. */
struct bark_point {
    double log_re, drag, rise, spare;
};
static const struct bark_point bark_at[] = {
    { -1, 58, 0, 0 },
    { -1 + LG2, 34, -63.788542506732597, 0 },
    { -1 + LG5, 17, -30.691640612488143, 0 },
    { 0, 10.5, -16.941833283925543, 0 },
    { LG2, 6.8, -10.027972788855955, 0 },
    { LG5, 4.0, -5.2998439468210314, 0 },
    { 1, 2.8, -3.1890509710918673, 0 },
    { 1 + LG2, 2.08, -1.9353015759351511, 0 },
    { 1 + LG5, 1.55, -0.91402574605560827, 0 },
    { 2, 1.37, -0.49828921423310435, 0 },
    { 2 + LG2, 1.25, -0.35682198881671667, 0 },
    { 2 + LG5, 1.13, -0.37573450418485604, 0 },
    { 3, 1.00, -0.29897352853986248, 0 },
    { 3 + LG2, 0.95, 0, 0 },
    { 3 + LG5, 1.00, 0.24323840551433046, 0 },
    { 4, 1.10, 0.28236388806542562, 0 },
    { 4 + LG2, 1.17, 0.15077649568392379, 0 },
    { 4 + LG5, 1.20, 0, 0 },
    { 5, 1.20, 0, 0 }, /* rough bark, beyond the drag crisis of a smooth cylinder */
    { 5 + LG2, 1.14, -0.21087894550811814, 0 },
    { 5 + LG5, 1.05, 0, 0 },
    { 6, 1.05, 0, 0 },
    { 6 + LG2, 1.05, 0, 0 },
    { 6 + LG5, 1.05, 0, 0 },
    { 7, 1.05, 0, 0 },
};
enum { BARK_POINTS = sizeof bark_at / sizeof *bark_at };

/* The points on both sides of x = log10 Re, of each lane. */
WF_INLINE void bark_ends(real x, real ends[8])
{
    const real within = real_min(real_max(x, real_of(-1)), real_of(7));
    const double *row[WF_WIDTH];
    for (int k = 0; k < WF_WIDTH; k++) {
        double at = real_lane(within, k);
        int decade = (int)(at + 1);
        double part = at - (decade - 1);
        size_t i = 3 * (size_t)decade + (part >= LG2) + (part >= LG5);
        if (i > BARK_POINTS - 2)
            i = BARK_POINTS - 2; /* rounding of the logarithm just below the last point */
        row[k] = &bark_at[i].log_re;
    }
    real_gather(row, 8, ends);
}

/* The points from the first to the last are 0.1 <= Re < 1e7; outside, the law is constant. */
WF_INLINE real bark_drag_law(real speed, real diameter, real viscosity, real *derivative)
{
    real re = speed * diameter / viscosity, x = real_log(re) * (1 / M_LN10);
    real_truth low = real_not_above(re, real_of(0.1)), high = real_not_above(real_of(1e7), re);
    real ends[8], slope; /* a point and the next one */
    bark_ends(x, ends);
    real from = ends[0], h = ends[4] - from;
    real cd = smooth_piece(ends[1], ends[5], ends[2], ends[6], h, (x - from) / h, &slope);
    *derivative = real_choose(low | high, real_of(0), slope / (speed * M_LN10));
    return real_choose(low, real_of(bark_at[0].drag),
                       real_choose(high, real_of(bark_at[BARK_POINTS - 1].drag), cd));
}
#endif
