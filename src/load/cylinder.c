/* Drag of a rough cylinder from a table at Re = 1, 2 and 5 of every decade, smooth in log Re. */
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
    1.20, 1.14, 1.05, /* 1e5: bark is past the drag crisis of a smooth cylinder */
    1.05, 1.05, 1.05, /* 1e6  */
    1.05,             /* 1e7  */
};
/* d drag / d log10 Re at the points by the rule of load/smooth.h, worked out beforehand because this function
 * is called for every load point of every element. */
static const double rise[] = {
    0,
    -63.788542506732597,
    -30.691640612488143, /* 1e-1 */
    -16.941833283925543,
    -10.027972788855955,
    -5.2998439468210314, /* 1e0  */
    -3.1890509710918673,
    -1.9353015759351511,
    -0.91402574605560827, /* 1e1  */
    -0.49828921423310435,
    -0.35682198881671667,
    -0.37573450418485604, /* 1e2  */
    -0.29897352853986248,
    0,
    0.24323840551433046, /* 1e3  */
    0.28236388806542562,
    0.15077649568392379,
    0, /* 1e4  */
    0,
    -0.21087894550811814,
    0, /* 1e5  */
    0,
    0,
    0, /* 1e6  */
    0, /* 1e7  */
};
enum { POINTS = sizeof drag / sizeof *drag };

double wf_cylinder_drag(double speed, double diameter, double viscosity, double *derivative)
{
    double re = speed * diameter / viscosity, slope;
    *derivative = 0;
    if (!(re > 0.1)) return drag[0];
    if (re >= 1e7) return drag[POINTS - 1];
    double x = fmax(log(re) * (1 / M_LN10), -1), part = x - floor(x);
    size_t i = 3 * (size_t)(floor(x) + 1) + (part >= LG2) + (part >= LG5);
    if (i > POINTS - 2) i = POINTS - 2; /* rounding of the logarithm just below the last point */
    double h = log_re[i + 1] - log_re[i];
    double cd = wf_smooth_piece(drag[i], drag[i + 1], rise[i], rise[i + 1], h, (x - log_re[i]) / h, &slope);
    *derivative = slope / (speed * M_LN10);
    return cd;
}
