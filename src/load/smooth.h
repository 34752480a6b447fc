#ifndef WF_LOAD_SMOOTH_H
#define WF_LOAD_SMOOTH_H
/* A smooth curve through measured points that never overshoots them.
 * Cubic Hermite pieces; slopes by the rule of Steffen (1990, A simple method for monotonic interpolation
 * in one dimension, Astron. Astrophys. 239:443-450). The slope at the first and last point is zero, so
 * that the curve joins the constant beyond the ends with a continuous derivative. */
#include <math.h>
#include <stddef.h>

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
static inline double wf_smooth_piece(double y0, double y1, double d0, double d1, double h, double u,
                                     double *slope)
{
    double a = h * d0, rise = y1 - y0, c = h * (d0 + d1) - 2 * rise, b = 3 * rise - h * (2 * d0 + d1);
    *slope = (a + u * (2 * b + 3 * u * c)) / h;
    return y0 + u * (a + u * (b + u * c));
}
#endif
