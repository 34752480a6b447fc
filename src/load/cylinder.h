#ifndef WF_LOAD_CYLINDER_H
#define WF_LOAD_CYLINDER_H
/* Drag coefficient of a smooth, long circular cylinder in cross-flow as a function of Reynolds number.
 *
 * Source: the measurements of Wieselsberger (1921, Neuere Feststellungen ueber die Gesetze des Fluessigkeits-
 * und Luftwiderstands, Phys. Z. 22:321-328) as drawn by Hoerner (1965, Fluid-Dynamic Drag, ch. 3) and
 * Schlichting (1979, Boundary-Layer Theory, fig. 1.4), the low end checked by Lamb's formula (58 at Re = 0.1)
 * and Tritton (1959, J. Fluid Mech. 6:547-567); beyond 1e6 Roshko (1961, J. Fluid Mech. 10:345-356): 0.7
 * from 3.5e6 on. Read off at 1, 2 and 5 of every decade; the experiments scatter by 5 to 10 %, in and beyond
 * the drag crisis by 30 %.
 *
 * Rough bark and gusty air bring the crisis to a lower Re and fill it: at a relative roughness of 0.005 it
 * lies below 1e5 and Cd is again about 1 from 3e5 on (Achenbach 1971, J. Fluid Mech. 46:321-335). So this law
 * suits smooth culms and young stems; for a rough-barked trunk above Re = 1e5 (0.1 m at 15 m/s) it would
 * understate the drag, and a constant coefficient near 1 belongs in the species table. */

/* Given: speed across the axis [m/s], diameter [m], kinematic viscosity [m2/s]. Returned: Cd [-] and
 * *derivative = dCd/dspeed [s/m]. Positive, with a continuous derivative; for 1 <= Re <= 1e7, constant below
 * 0.1 and above 1e7. Method: monotone cubic pieces in log10 Re (load/smooth.h). */
double wf_cylinder_drag(double speed, double diameter, double viscosity, double *derivative);
#endif
