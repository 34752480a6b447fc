/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_SIDE_H
#define WF_SOLVE_BEAM_SIDE_H
/* The change of a solution to that under other loads, which differ a little in the wind: one more right-hand
 * side of the tangent of Newton's method (b->other). */
#include "solve/beam_newton.h"

/* The change to first order at the present shape, of all unknowns, into b->side. Given: a last sweep with a
 * tangent that came with it (b->sided), since which neither shape nor loads have changed. Overwrites nothing
 * that wf_beam_finish needs. */
void wf_beam_side_find(struct wf_beam *b);

/* Take the change from the present shape, that of wf_beam_side_find or one step of Newton's method from it, to
 * the other loads, and sweep down: from the equilibrium at loads that differ by d, the error is of order d^2
 * and of d times that step. false: the shape is not finite. */
bool wf_beam_side_take(struct wf_beam *b);
#endif
