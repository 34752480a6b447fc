/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_SMALL_H
#define WF_SOLVE_BEAM_SMALL_H
/* First-order answers of a solved tree to whatever disturbs its balance: sensitivities without differencing,
 * and the flexibility that natural frequencies need. */
#include "solve/beam_newton.h"

/* A disturbance of one element at its two Gauss points, at fixed shape, per unit of whatever causes it. */
struct wf_beam_disturbance {
    double force[2][3];  /* on the axis, per reference length [N/m]                                  */
    double couple[2][3]; /* likewise [N m/m]                                                         */
    double law[2][3]; /* more moment that the material law gives for the present curvature [N m]; for a change
                       * of ln E of the element it is that moment itself: wf_beam_law_moment         */
};

/* Linearise about the present, solved state. frozen: wind acts as a dead load. The state stays as it is.
 * Errors: WF_ENOMEM; WF_EUNSTABLE when the tangent is singular. */
enum wf_status wf_beam_linearise(struct wf_beam *b, bool frozen, struct wf_arena *a, struct wf_err *e);

struct wf_beam_small_answer {
    double (*ends)[6]; /* per element: change of its end, place and spin, global; may be NULL         */
    double *motion;    /* per element 8: change of place (3) and twist at its Gauss points; may be NULL */
    double ground[6];  /* change of force and moment (about the first root) on the ground             */
};

/* Answer to a disturbance. source(ctx, b, i, out): that of element i, *out comes zeroed (NULL: none). node:
 * force and moment at the element ends (6 per element, may be NULL). root: moment on the root plate of a row
 * (3 per row, may be NULL); a unit change of the stiffness of a plate tilted by v acts as the moment -v about
 * that axis. Exact but for the effect of stretch on the load within one element (relative size
 * (radius/length)^2 and below). */
void wf_beam_answer_small(struct wf_beam *b,
                          void (*source)(const void *ctx, const struct wf_beam *b, size_t i,
                                         struct wf_beam_disturbance *out),
                          const void *ctx, const double (*node)[6], const double (*root)[3],
                          struct wf_beam_small_answer *out);

/* Moment that the material law gives at the Gauss points of element i, global axes [N m]. */
void wf_beam_law_moment(const struct wf_beam *b, size_t i, double moment[2][3]);

/* Small motions about a solved state (wf_beam_linearise, wind frozen): the mass at the Gauss points, and the
 * tree's answer to inertia there. */

/* A motion: per element, at each of its two Gauss points, displacement (3) and twist about the axis; then,
 * where the tree has point masses, the displacement of each element's end. */
size_t wf_beam_motion_size(const struct wf_beam *b);

/* out = flexibility x mass x in: the motion under the inertia of `in`. node: room for 6 per element; ends (6
 * per element): changes of the element ends (place, spin). */
void wf_beam_inertia_answer(struct wf_beam *b, const double *in, double *out, double (*node)[6],
                            double (*ends)[6]);

/* Mass that goes with each entry of a motion [kg], twist: [kg m2]; rotary inertia in bending is left out. */
void wf_beam_motion_mass(const struct wf_beam *b, double *mass);
#endif
