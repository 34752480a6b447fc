/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_DRAG_H
#define WF_LOAD_DRAG_H
/* Laws of drag, one row each: how much of a crown's still-air drag area is left in the wind, and the drag
 * coefficient of a bare axis. A new law is a row here and its function in drag.c; the species reader, the
 * schema, results and fitted tables follow the row. */
#include "data/law.h"
#include <math.h>
#include <stddef.h>

/* Streamlining of a crown. Its range is that of the law's own evidence in wind speed [m/s]. */
struct wf_streamline_law {
    struct wf_law law;
    bool rigid; /* the share is 1 at every speed: it needs no evidence from the species */
    /* Given: parameters, speed >= 0 [m/s]. Returned: share of still-air drag area [-], continuous with its
     * derivative *derivative [s/m]. */
    double (*share)(const struct wf_law_values *p, double speed, double *derivative);
};
extern const struct wf_streamline_law wf_streamline_laws[]; /* none, vogel, table; ends at law.name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_streamline_law *wf_streamline_named(const char *name);

/* The corner of the Vogel law at the reference speed is rounded within this distance in ln(U/reference), so
 * that the force has a continuous derivative. The largest departure from the sharp law, at the reference
 * speed itself, is a factor exp(V/4 * 0.05): 0.9 % less drag for V = -0.7. Outside the band: exact. */
#define WF_VOGEL_ROUNDING 0.05

/* Drag coefficient of a long axis in cross-flow where the species gives no constant one. Its range is in
 * Reynolds number [-]. */
struct wf_axis_drag_law {
    struct wf_law law;
    /* Given: parameters, speed across the axis [m/s], diameter [m], kinematic viscosity [m2/s]. Returned:
     * Cd [-] and *derivative = dCd/dspeed [s/m]. Positive, with a continuous derivative. */
    double (*coefficient)(const struct wf_law_values *p, double speed, double diameter, double viscosity,
                          double *derivative);
};
/* The first is the law of an axis nobody said anything about.
 *
 * bark: a long circular cylinder with bark as a function of Reynolds number, monotone cubic pieces in
 * log10 Re, constant below 0.1 and above 5e5. Below Re = 1e5 roughness does not raise the drag, and the law
 * is that of the smooth cylinder: measurements of Wieselsberger (1921, Neuere Feststellungen ueber die
 * Gesetze des Fluessigkeits- und Luftwiderstands, Phys. Z. 22:321-328) as drawn by Hoerner (1965,
 * Fluid-Dynamic Drag, ch. 3) and Schlichting (1979, Boundary-Layer Theory, fig. 1.4), the low end checked by
 * Lamb's formula (58 at Re = 0.1) and Tritton (1959, J. Fluid Mech. 6:547-567). Read off at 1, 2 and 5 of
 * every decade; the experiments scatter by 5 to 10 %.
 *
 * Above, a smooth cylinder falls to 0.3 at Re = 5e5 (the drag crisis) and comes back to 0.7 at 3.5e6 (Roshko
 * 1961, J. Fluid Mech. 10:345-356). A rough one has its crisis earlier and shallower, and its drag is back
 * near 1 from a few 1e5 on (Achenbach 1971, Influence of surface roughness on the cross-flow around a
 * circular cylinder, J. Fluid Mech. 46:321-335; measurements collected in ESDU 80025). Of bark, the furrows
 * are some hundredths of the diameter deep. There the rules of practice say: 1.05 for a roughness of 0.01
 * diameters and more (DNV-RP-C205, 2010, section 6.7); 1.02 to 1.15 for 0.01 to 0.05 at Re = 1e6 (EN
 * 1991-1-4:2005, figure 7.28). The law goes from 1.2 at 1e5 to 1.05 at 5e5 and stays.
 *
 * It keeps to the upper side, because a stem that breaks unforeseen is worse than one thought
 * weaker than it is: the shallow dip of rough cylinders between 5e4 and 5e5 (to 0.6 .. 0.9, wherever
 * roughness and gustiness of the air put it) is left out. Trunks with bark were measured there below the
 * smooth cylinder (Tanaka et al. 2011, Int. J. River Basin Manag., doi:10.1080/15715124.2011.606427). Above
 * 5e4 expect the true coefficient within 0.6 and 1.2; of a smooth culm or young stem it may be as low as 0.3.
 * Who knows it writes drag_coefficient into the species table. */
extern const struct wf_axis_drag_law wf_axis_drag_laws[]; /* bark; ends at law.name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_axis_drag_law *wf_axis_drag_named(const char *name);

/* A smooth curve through measured points that never overshoots them: cubic Hermite pieces; slopes by the rule
 * of Steffen (1990, A simple method for monotonic interpolation in one dimension, Astron. Astrophys.
 * 239:443-450). The slope at the first and last point is zero, so that the curve joins the constant beyond
 * the ends with a continuous derivative. */

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
