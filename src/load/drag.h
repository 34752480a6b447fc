/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_DRAG_H
#define WF_LOAD_DRAG_H
/* Drag laws, one row each: streamlining (the share of a crown's still-air drag area that remains in wind)
 * and the drag coefficient of a bare axis. A new law is a row and a function in drag.c; the species reader,
 * the schema, results and fitted species files iterate over the rows. */
#include "data/law.h"
#include "load/drag_kernel.h"
#include <math.h>
#include <stddef.h>

/* Formulas of load/drag_kernel.h, by which many states are computed at once. A law without one is evaluated
 * for one state after the other. */
enum wf_share_form { WF_SHARE_BY_CALL, WF_SHARE_NONE, WF_SHARE_VOGEL, WF_SHARE_TABLE };
enum wf_drag_form { WF_DRAG_BY_CALL, WF_DRAG_BARK };

/* Streamlining of a crown. law.low..law.high is the range of wind speeds [m/s] covered by measurements. */
struct wf_streamline_law {
    struct wf_law law;
    bool rigid; /* share = 1 at every speed: no range of speeds to warn about */
    /* Given: parameters, speed >= 0 [m/s]. Returned: share of still-air drag area [-], continuous with its
     * derivative *derivative [s/m]. It does not know where the evidence ends: see wf_streamline_share. */
    double (*share)(const struct wf_law_values *p, double speed, double *derivative);
    enum wf_share_form form; /* the same by lanes */
};
extern const struct wf_streamline_law wf_streamline_laws[]; /* none, vogel, table; ends at law.name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_streamline_law *wf_streamline_named(const char *name);
/* The share by a law that is held above p->held [m/s], with its derivative, which is 0 there. The drag then
 * grows as the square of the speed. */
static inline double wf_streamline_share(const struct wf_streamline_law *law, const struct wf_law_values *p,
                                         double speed, double *derivative)
{
    bool held = p->held > 0 && speed > p->held;
    double share = law->share(p, held ? p->held : speed, derivative);
    if (held) *derivative = 0;
    return share;
}

/* Drag coefficient of a long axis in cross-flow, used where the species gives no constant coefficient.
 * law.low..law.high is the range of Reynolds numbers [-]. */
struct wf_axis_drag_law {
    struct wf_law law;
    /* Given: parameters, speed across the axis [m/s], diameter [m], kinematic viscosity [m2/s]. Returned:
     * Cd [-] and *derivative = dCd/dspeed [s/m]. Positive, with a continuous derivative. */
    double (*coefficient)(const struct wf_law_values *p, double speed, double diameter, double viscosity,
                          double *derivative);
    enum wf_drag_form form; /* the same by lanes */
};
/* The first row is the default law.
 *
 * bark: a long circular cylinder with bark as a function of Reynolds number, monotone cubic pieces in log10
 * Re, constant below 0.1 and above 5e5. Below Re = 1e5 roughness does not raise the drag, and the law is
 * that of the smooth cylinder: measurements of Wieselsberger (1921, Neuere Feststellungen ueber die Gesetze
 * des Fluessigkeits- und Luftwiderstands, Phys. Z. 22:321-328) as drawn by Hoerner (1965, Fluid-Dynamic
 * Drag, ch. 3) and Schlichting (1979, Boundary-Layer Theory, fig. 1.4), the low end checked by Lamb's
 * formula (58 at Re = 0.1) and Tritton (1959, J. Fluid Mech. 6:547-567). Values read off at 1, 2 and 5 of
 * every decade; the experiments scatter by 5 to 10 %.
 *
 * Above Re = 1e5 the drag of a smooth cylinder falls to 0.3 at Re = 5e5 (the drag crisis) and rises again to
 * 0.7 at 3.5e6 (Roshko 1961, J. Fluid Mech. 10:345-356). A rough cylinder has an earlier and shallower
 * crisis, and its drag is near 1 again from a few 1e5 on (Achenbach 1971, Influence of surface roughness on
 * the cross-flow around a circular cylinder, J. Fluid Mech. 46:321-335; measurements collected in ESDU
 * 80025). The furrows of bark are some hundredths of the diameter deep. For such roughness design codes give
 * 1.05 for 0.01 diameters and more (DNV-RP-C205, 2010, section 6.7) and 1.02 to 1.15 for 0.01 to 0.05 at Re
 * = 1e6 (EN 1991-1-4:2005, figure 7.28). The law falls from 1.2 at 1e5 to 1.05 at 5e5 and is constant above.
 *
 * The law is conservative (high drag), because overestimating a critical wind speed is the worse error: the
 * shallow minimum of rough cylinders between 5e4 and 5e5 (0.6 to 0.9, its place depending on roughness and
 * turbulence) is omitted. Trunks with bark were measured in this range below the smooth cylinder (Tanaka et
 * al. 2011, Int. J. River Basin Manag., doi:10.1080/15715124.2011.606427). Above 5e4 the true coefficient is
 * expected between 0.6 and 1.2; for a smooth culm or young stem it may be as low as 0.3. A known coefficient
 * is given in the species table as drag_coefficient. */
extern const struct wf_axis_drag_law wf_axis_drag_laws[]; /* bark; ends at law.name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_axis_drag_law *wf_axis_drag_named(const char *name);
#endif
