/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_DROP_SHAPE_H
#define WF_LOAD_DROP_SHAPE_H
/* Shapes and holding forces of drops on a leaf: formulas of Yang & Wu 2011 (equations in brackets are
 * theirs), as printed and corrected. Lengths [m], angles [rad], masses [kg]. */
#include <stdbool.h>
#include <stddef.h>

#define WF_WATER_DENSITY 998.0 /* [kg m-3] at 20 C */
#define WF_WATER_TENSION 0.072 /* surface tension of water [N/m] */
#define WF_DROP_LARGEST 8e-3   /* larger drops break up in air [m] */

/* Radius of the sphere that a cap of this mass and contact angle is part of (6). As printed density is left
 * out: right only for grams and centimetres. */
double wf_cap_radius(double mass, double angle);
double wf_cap_radius_printed(double mass, double angle); /* the formula with m in kg, r in m, as it stands */
/* Volume of the cap of a sphere of radius r; as printed 3 pi r^3/8 whatever the angle. */
double wf_cap_volume(double r, double angle);
double wf_cap_volume_printed(double r);
/* Radius of the wetted circle: r sin(angle). */
double wf_cap_base(double r, double angle);
/* Height of the drop at the distance r1 from its middle, 0 outside: sqrt(r^2 - r1^2) - r cos(angle); printed
 * (18): r sin(angle) in place of r cos(angle). Times omega (19). */
double wf_cap_height(double r, double angle, double r1, double omega, bool printed);
/* omega of a drop on a tilted leaf: lambda^kappa, kappa = leaf normal . normal of the drop's surface there.
 */
double wf_cap_omega(double lambda, double kappa);

/* Radii of n trailing subdrops: r_i = beta r_(i-1) for i > 1, their cubes summing to r0^3 (9): first of them.
 * beta = 1: equal ones. */
double wf_tail_first(double r0, double beta, size_t n);

/* Force that holds a drop on a tilted leaf before it runs: pi/4 gamma w (cos receding - cos advancing) [N], w
 * the width of its contact circle. Source: hysteresis of the contact angle; the factor is exact to first
 * order in the tilt (arXiv:1610.06725). */
double wf_drop_retention(double width, double receding, double advancing);
/* Largest mass that hangs at an edge with a contact circle of diameter d: gamma pi d/g (Tate 1864) [kg]; the
 * part that falls is smaller. */
double wf_drop_hanging(double diameter, double gravity);
/* Attraction of two drops (12): -log(d/(R1 + R2)), 0 beyond; a pure number, as printed a force [N]. */
double wf_drop_attraction(double d, double r1, double r2);

/* What a drop of mass m leaves of its energy in a body of effective mass M that it sticks to: m M/(m + M)^2
 * of its kinetic energy in the body, m/(m + M) in both together. */
double wf_impact_share(double m, double body);
#endif
