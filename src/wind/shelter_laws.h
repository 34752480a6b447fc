/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_SHELTER_LAWS_H
#define WF_WIND_SHELTER_LAWS_H
/* Laws of shelter, as rows: the wind behind a slab from the coverage of its cells. Also the elementary
 * potential flows that they use, and the three forms of Feng, Yan, Chen & Wu (1999, Research on whole tree's
 * movement and tree's inner wind field, section 3) as that paper prints them. Source of the elementary flows:
 * Milne-Thomson L.M. 1968, Theoretical Hydrodynamics, 5th ed. They are exact solutions for air without
 * friction; a real cylinder has a wake, which potential flow has not. */
#include "wind/shelter.h"

/* Velocity of a uniform stream [m/s] towards +x around a cylinder of radius [m] at the origin with
 * circulation [m2/s], clockwise positive (faster above): u - iv = U(1 - a^2/z^2) + i Gamma/(2 pi z). Given: a
 * point [m] on or outside the cylinder. Returned: u[2] [m/s]. */
void wf_flow_cylinder(double stream, double radius, double circulation, const double x[2], double u[2]);
/* Pressure coefficient at a point of velocity u in that stream: 1 - |u|^2/U^2 [-]. */
double wf_flow_pressure(double stream, const double u[2]);

/* Velocity u[3] [m/s] at x [m] of an infinite line source on the z axis, strength per length [m2/s]: Q/(2 pi
 * r), radial. */
void wf_flow_line_source(double strength, const double x[3], double u[3]);
/* The same for a point source at the origin, strength [m3/s]: Q/(4 pi r^2), radial. */
void wf_flow_point_source(double strength, const double x[3], double u[3]);
/* The same for a line source on the z axis from `from` to `to` [m], strength per length [m2/s]. Near the axis
 * beyond its ends the radial velocity is computed without cancellation; on the source itself it is infinite.
 */
void wf_flow_segment_source(double strength, double from, double to, const double x[3], double u[3]);

/* The paper's eq. (6), f = Q(z + a^2/z): real and imaginary part f[2] [m2/s] at z = x[0] + i x[1]. */
void wf_feng_cylinder_potential(double stream, double radius, const double x[2], double f[2]);
/* Eq. (7), f = Q/(2 pi) ln z: potential and stream function f[2] [m2/s]. */
void wf_feng_hole_potential(double strength, const double x[2], double f[2]);
/* Eq. (8), psi = -Q(R - R1) [m2/s]: R the distance from the slit's start at the origin, R1 from its end at
 * (length, 0). */
double wf_feng_slit_stream(double stream, double length, const double x[2]);
/* Velocity of eq. (8) as printed, {d psi/dy, -d psi/dx} [m/s]: on the middle of the slit 2Q, at a distance y
 * much beyond its length Q length/y. R - R1 is the axisymmetric stream function of a line source; its
 * velocity has a further factor 1/y, which the paper leaves out. */
void wf_feng_slit(double stream, double length, const double x[2], double u[2]);

/* The laws. */

extern const struct wf_shelter_law wf_shelter_laws[]; /* wake, feng1999; ends at name == NULL */
/* The law of that name; NULL: none. */
const struct wf_shelter_law *wf_shelter_law_named(const char *name);
/* Default request: law wake, 32 slabs, 128 cells, transmission 20 % of the energy, Cd of wood 1, of the crown
 * 1, whole sail, reach of leaves 0.25 m, open up to 0.05, full from 0.95, gap 1 cell, growth of wakes 0.08.
 */
void wf_shelter_request_default(struct wf_shelter_request *q);
#endif
