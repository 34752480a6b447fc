/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_SIDE_H
#define WF_SOLVE_BEAM_SIDE_H
/* The change of a solution to that under other loads (b->other), whose wind has another speed and wind_scale
 * and is else the same: one more right-hand side of the tangent of Newton's method. */
#include "solve/beam_newton.h"

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
