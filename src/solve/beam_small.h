/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_SMALL_H
#define WF_SOLVE_BEAM_SMALL_H
/* First-order response of a solved tree to a disturbance of its equilibrium: sensitivities without finite
 * differences, and the flexibility that natural frequencies need. */
#include "solve/beam_newton.h"

/* A disturbance of one element at its two Gauss points, at fixed shape, per unit of its cause. */
struct wf_beam_disturbance {
    double force[2][3];  /* on the axis, per reference length [N/m] */
    double couple[2][3]; /* on the axis, per reference length [N m/m] */
    double law[2][3]; /* change of the material law's moment at the present curvature [N m]; for a change of
                         ln E of the element this is the moment itself: wf_beam_law_moment */
};

/* Linearise about the present, solved state, which is not changed. frozen: wind acts as a dead load. Errors:
 * WF_ENOMEM; WF_EUNSTABLE when the tangent is singular. */
enum wf_status wf_beam_linearise(struct wf_beam *b, bool frozen, struct wf_arena *a, struct wf_err *e);

struct wf_beam_small_answer {
    double (*ends)[6]; /* per element: displacement and spin of its end, global axes; may be NULL */
    double *motion;    /* per element 8: displacement (3) and twist at each Gauss point; may be NULL */
    double ground[6];  /* change of force and moment (about the first root) on the ground */
};

/* Response to a disturbance. source(ctx, b, i, out): disturbance of element i, *out is zero on entry (NULL:
 * none). node: force and moment at the element ends (6 per element, may be NULL). root: moment on the root
 * plate of a row (3 per row, may be NULL); a unit change of the stiffness of a plate tilted by v acts as the
 * moment -v about that axis. Returned: *out. Exact except for the effect of stretch on the load within one
 * element (relative size (radius/length)^2 and below). */
void wf_beam_answer_small(struct wf_beam *b,
                          void (*source)(const void *ctx, const struct wf_beam *b, size_t i,
                                         struct wf_beam_disturbance *out),
                          const void *ctx, const double (*node)[6], const double (*root)[3],
                          struct wf_beam_small_answer *out);

/* Moment by the material law at the Gauss points of element i, global axes [N m]. */
void wf_beam_law_moment(const struct wf_beam *b, size_t i, double moment[2][3]);

/* Small motions about a solved state (wf_beam_linearise, wind frozen): mass at the Gauss points, and the
 * tree's response to inertia there. */

/* Length of a motion vector. A motion is, per element and for each of its two Gauss points, displacement (3)
 * and twist about the axis; then, where the tree has point masses, the displacement of each element's end. */
size_t wf_beam_motion_size(const struct wf_beam *b);

/* out = flexibility x mass x in: the motion under the inertia of `in`. node: work space, 6 per element; ends
 * (6 per element): displacement and spin of the element ends. */
void wf_beam_inertia_answer(struct wf_beam *b, const double *in, double *out, double (*node)[6],
                            double (*ends)[6]);

/* Mass of each entry of a motion [kg], of twist [kg m2]; rotary inertia in bending is omitted. */
void wf_beam_motion_mass(const struct wf_beam *b, double *mass);
#endif
