/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_SMALL_H
#define WF_SOLVE_BEAM_SMALL_H
/* First-order response of a solved tree to a disturbance of its equilibrium: sensitivities without finite
 * differences, and the flexibility that natural frequencies need. */
#include "base/vec3.h"
#include "solve/beam_newton.h"
#include "solve/beam_path.h"

/* Linearise about the present, solved state, which is not changed. frozen: wind acts as a dead load. Errors:
 * WF_ENOMEM; WF_EUNSTABLE when the tangent is singular. */
enum wf_status wf_beam_linearise(struct wf_beam *b, bool frozen, struct wf_arena *a, struct wf_err *e);

struct wf_beam_small_answer {
    wf_four (*ends)[6]; /* per element: displacement and spin of its end, global axes; may be NULL */
    wf_four *motion;    /* per element 8: displacement (3) and twist at each Gauss point; may be NULL */
    wf_four ground[6];  /* change of force and moment (about the first root) on the ground */
};

/* Response to disturbances, one a side. source(ctx, b, i, out): disturbances of element i, *out is zero on
 * entry (NULL: none). node: force and moment at the element ends (per element, may be NULL). root: moment on
 * the root plate of a row (per row, may be NULL); a unit change of the stiffness of a plate tilted by v acts
 * as the moment -v about that axis. Returned: *out; the changes of the root plates in b->root_moved. Exact
 * except for the effect of stretch on the load within one element (relative size (radius/length)^2 and
 * below). */
void wf_beam_answer_small(struct wf_beam *b,
                          void (*source)(const void *ctx, const struct wf_beam *b, size_t i,
                                         struct wf_beam_disturbance *out),
                          const void *ctx, const wf_four (*node)[6], const wf_four (*root)[3],
                          struct wf_beam_small_answer *out);

/* Moment by the material law at the Gauss points of element i, global axes [N m]; of a standing tree the part
 * of it that the change from the given shape makes. */
void wf_beam_law_moment(const struct wf_beam *b, size_t i, double moment[2][3]);

/* Turn vectors that are fixed to the section at the Gauss points of element i from the given shape to the
 * present one. */
void wf_beam_turn_along(const struct wf_beam *b, size_t i, const double given[2][3], double turned[2][3]);

/* Small motions about a solved state (wf_beam_linearise, wind frozen): mass at the Gauss points, and the
 * tree's response to inertia there. */

/* Length of a motion vector. A motion is, per element and for each of its two Gauss points, displacement (3)
 * and twist about the axis; then, where the tree has point masses, the displacement of each element's end. */
size_t wf_beam_motion_size(const struct wf_beam *b);

/* The tree's response to inertia in symmetric form: out = sqrt(mass) flexibility sqrt(mass) in, for motions
 * `in` times sqrt(mass). root: sqrt(mass) of each entry; out may be `in`. b->sides[].y: displacement and spin
 * of the element ends. */
void wf_beam_inertia_answer(struct wf_beam *b, const double *root, const wf_four *in, wf_four *out);

/* Mass of each entry of a motion [kg], of twist [kg m2]; rotary inertia in bending is omitted. */
void wf_beam_motion_mass(const struct wf_beam *b, double *mass);
#endif
