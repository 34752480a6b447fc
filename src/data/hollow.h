/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_HOLLOW_H
#define WF_DATA_HOLLOW_H
/* The section of a stem with a cavity: area, centroid, second moments, torsion constant, stress at its
 * fibres. Lengths are in units of the local radius of the wood, so that one shape serves a stem that tapers.
 * Axes: x and y across the stem, from its axis. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

/* Two of its values are in units of the radius; areas in its square, moments in its fourth power. */
struct wf_hollow_edge; /* straight or an arc */
struct wf_hollow {
    size_t edges;
    struct wf_hollow_edge *edge; /* around the sound wood */
    double area, centroid[2];
    double xx, yy, xy; /* integrals of x x, y y, x y about the centroid */
    double torsion;    /* Saint-Venant's constant */
    double twist;      /* moment of torsion over the largest shear stress, in the radius' third power */
    double wall;       /* thinnest sound wall; 0 at an opening that was measured as such */
    double radius;     /* of the circle that has the area within the outer outline */
    bool open;         /* the wall has an opening */
};

/* A round stem with a round cavity. Given: radius of the cavity, distance of its centre from the axis and
 * direction of it [rad], opening of the wall seen from the cavity's centre [rad] (0: closed), where the
 * middle of the opening faces [rad]. Returned: *out; its edges in the arena. The integrals are exact.
 * Torsion: closed, Bredt's 4 A_m^2 / int ds/t with a quarter of int t^3 ds, exact for a ring of any
 * thickness; open, a third of int t^3 ds. Shear: closed, the larger of Bredt's at the thinnest wall and that
 * of a ring of this torsion constant; open, by the thickest wall. Errors: WF_EINPUT for a cavity that is not
 * within the stem or an opening that leaves no wall; WF_ENOMEM. */
enum wf_status wf_hollow_round(double cavity, double offset, double towards, double opening, double facing,
                               struct wf_arena *a, struct wf_hollow *out, struct wf_err *e);

/* A section by n rays from the stem's axis, anticlockwise: direction [rad], distance of the outer outline and
 * of the inner end of the sound wood. Where both are equal there is no wall: it is open. Straight between
 * rays. Without cavity torsion is A^4 / (4 pi^2 I_p), exact for ellipses (Saint-Venant). Errors as above. */
enum wf_status wf_hollow_rays(size_t n, const double *angle, const double *outer, const double *sound,
                              struct wf_arena *a, struct wf_hollow *out, struct wf_err *e);

/* Lowest and highest stress at the fibres of a section of that radius, tension positive [Pa]. Given: axial
 * force on the stem's axis [N], moment vector about x and y [N m]: sigma = N/A + g.(p - c), with g by the
 * tensor. */
void wf_hollow_stress(const struct wf_hollow *h, double radius, double axial, double mx, double my,
                      double range[2]);

/* Section modulus for bending towards a direction [rad], least of its two sides, over that of the solid
 * circle of radius 1 [-]. */
double wf_hollow_modulus(const struct wf_hollow *h, double towards);

/* Least second moment of area over that of the solid circle of radius 1 [-]; *along: direction of bending in
 * which it is least [rad]. */
double wf_hollow_least(const struct wf_hollow *h, double *along);

/* A polyline around the sound wood, for a picture: up to `most` points; breaks between closed lines are NAN.
 * Returned: number of points. */
size_t wf_hollow_outline(const struct wf_hollow *h, size_t most, double (*point)[2]);
#endif
