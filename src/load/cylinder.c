/* Cylinder drag from a table at Re = 1, 2 and 5 of every decade, smooth in log Re. */
#include "load/cylinder.h"
#include "load/smooth.h"
#include <math.h>

#define LG2 0.30102999566398120 /* log10 2 */
#define LG5 0.69897000433601880 /* log10 5 */
#define DECADE(d) (d), (d) + LG2, (d) + LG5

static const double log_re[] = { DECADE(-1), DECADE(0), DECADE(1), DECADE(2), DECADE(3),
                                 DECADE(4),  DECADE(5), DECADE(6), 7 };
static const double drag[] = {
    58,   34,   17,   /* 1e-1 */
    10.5, 6.8,  4.0,  /* 1e0  */
    2.8,  2.08, 1.55, /* 1e1  */
    1.37, 1.25, 1.13, /* 1e2  */
    1.00, 0.95, 1.00, /* 1e3  */
    1.10, 1.17, 1.20, /* 1e4  */
    1.20, 1.17, 0.30, /* 1e5: the drag crisis */
    0.36, 0.50, 0.70, /* 1e6  */
    0.70,             /* 1e7  */
};
enum { POINTS = sizeof drag / sizeof *drag };

double wf_cylinder_drag(double speed, double diameter, double viscosity, double *derivative)
{
    double re = speed * diameter / viscosity;
    *derivative = 0;
    if (!(re > 0.1)) return drag[0];
    if (re >= 1e7) return drag[POINTS - 1];
    double x = log10(re), whole = floor(x), part = x - whole;
    size_t i = (size_t)(3 * ((int)whole + 1)) + (part >= LG2) + (part >= LG5);
    double h = log_re[i + 1] - log_re[i], slope;
    double cd = wf_smooth_piece(drag[i], drag[i + 1], wf_smooth_slope(log_re, drag, POINTS, i),
                                wf_smooth_slope(log_re, drag, POINTS, i + 1), h, (x - log_re[i]) / h, &slope);
    *derivative = slope / (speed * M_LN10);
    return cd;
}
