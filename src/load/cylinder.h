#ifndef WF_LOAD_CYLINDER_H
#define WF_LOAD_CYLINDER_H
/* Drag coefficient of a circular cylinder in cross-flow as a function of Reynolds number. */

/* Given: speed across the axis [m/s], diameter [m], kinematic viscosity [m2/s]. Returned: Cd [-] and
 * *derivative = dCd/dspeed [s/m]. Smooth, positive, valid 1 <= Re <= 1e7 (clamped outside). */
double wf_cylinder_drag(double speed, double diameter, double viscosity, double *derivative);
#endif
