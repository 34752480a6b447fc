/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_SMALL_H
#define WF_SOLVE_BEAM_SMALL_H
/* First-order response of a solved tree to a disturbance of its equilibrium: sensitivities without finite
 * differences; and its change to the solution under other loads (b->other), whose wind has another speed and
 * wind_scale and is else the same: one more right-hand side of the tangent of Newton's method. */
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

/* The change to first order at the present shape, of all unknowns, into b->side and b->root_side. Given: a
 * last sweep with a tangent, since which neither shape nor loads have changed; where the change has not come
 * with it there is another sweep. false: it has no such change (links; a wind that is not known to grow in
 * proportion). *stable (NULL: not wanted): as wf_beam_stable. Overwrites nothing that wf_beam_finish needs.
 */
bool wf_beam_side_find(struct wf_beam *b, bool *stable);

/* Take the change from the present shape, that of wf_beam_side_find or one step of Newton's method from it,
 * to the other loads, and sweep down. The error of the difference of both is of order d^2, where the loads
 * differ by d, and of d times what Newton's method had left; the stretch by what the motion adds to the
 * forces is left out (beam_element.h), which cables make the larger part of it. false: the shape is not
 * finite. */
bool wf_beam_side_take(struct wf_beam *b);

/* Where there is no such change: from the present unknowns, a solution, one Newton step at the other loads
 * (wf_beam_step). */
bool wf_beam_side_step(struct wf_beam *b, bool *stable);
#endif
