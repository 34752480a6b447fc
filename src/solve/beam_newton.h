/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_NEWTON_H
#define WF_SOLVE_BEAM_NEWTON_H
/* Sweeps up and down the tree, Newton's method, and what to do when Newton
 * stalls. */
#include "solve/beam_state.h"

/* Build the mesh and the state with the unloaded shape. Mesh and shape (shape, pose, tilt, base) are in `a`;
 * what Newton's method works with (stage, wrench, load, node, answer, change, dv), two thirds of the memory,
 * in `newton`, which may be `a`; NULL: only sweeps down without the tangent will be made. Errors: WF_ENOMEM,
 * WF_EINPUT (rows not connected). */
enum wf_status wf_beam_init(struct wf_beam *b, const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, const int32_t *pieces, struct wf_arena *a,
                            struct wf_arena *newton, struct wf_err *e);
/* Take what Newton's method works with anew, from `newton`, for a beam without links; then sweep up. false:
 * not enough memory. */
bool wf_beam_take_newton(struct wf_beam *b, struct wf_arena *newton);

/* Base to tips: position and rotation of every element from the unknowns. */
void wf_beam_sweep_up(struct wf_beam *b);
/* Can the change to the other loads come with the tangent (solve/beam_small.h)? */
bool wf_beam_has_side(const struct wf_beam *b);
/* Tips to base: internal forces and residual; with `tangent` also the tangent, eliminated; with count (may
 * be NULL) also the number of unstable directions. false when the tangent is singular. */
bool wf_beam_sweep_down(struct wf_beam *b, bool tangent, struct wf_beam_stability *count);

/* Tolerance up to which the last step of Newton's method may be made without a tangent of the shape it leads
 * to (b->finished). */
#define WF_BEAM_TIGHT 1e-8

/* Newton's method with line search at the present loads, from the present shape. Returned: WF_OK; WF_ENOCONV
 * with the shape where it stalled. */
enum wf_status wf_beam_newton(struct wf_beam *b);

/* Is the present equilibrium stable (after wf_beam_sweep_up)? Used by every solver that relies on the beam
 * solver. Unstable directions make the tree unstable unless the parts that have them carry less than a
 * hundredth of the force on the ground; such parts are counted in b->loose. */
bool wf_beam_stable(struct wf_beam *b);

/* Newton's method at the present loads from the present shape: does it converge to a stable equilibrium? */
bool wf_beam_rests(struct wf_beam *b);

/* One Newton step from the present shape (after wf_beam_sweep_up) at the present loads, and the forces of the
 * shape it leads to: from the equilibrium at loads that differ by d, the error is of order d^2. *stable
 * (NULL: not wanted): as wf_beam_stable, of the present shape, without a sweep of its own. wf_beam_finish:
 * the same with the tangent of the last sweep, after which neither shape nor loads have changed. false: the
 * tangent is singular. */
bool wf_beam_step(struct wf_beam *b, bool *stable);
bool wf_beam_finish(struct wf_beam *b);

/* Pose of the base of element i: the end of the element below, or the root plate (written to *ground).
 * Returned: a pointer to one of the two. */
const struct wf_beam_pose *wf_beam_base(const struct wf_beam *b, size_t i, struct wf_beam_pose *ground);
#endif
