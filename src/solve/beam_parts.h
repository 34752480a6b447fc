/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_PARTS_H
#define WF_SOLVE_BEAM_PARTS_H
/* Small parts of a tree by themselves, the motion of their bases given: a twig that turns over need not hold
 * up the solution of the whole tree (nonlinear elimination: Lanzkron, Rose & Wilkes 1996, SIAM J. Sci.
 * Comput. 17:538). */
#include "solve/beam_state.h"

/* The small parts in which the residual of the last sweep down with tangent is: each begins at an element and
 * carries at most a fifth of the force on the ground. Given: by what share of the largest residual of
 * an element another belongs to one. Returned: the elements in them, sorted by part, in b->part.id[..n]; all
 * else in b->part.held; `share`, of the residual, that is in them; large: some of it is in elements that
 * carry more. */
struct wf_beam_parts {
    size_t n;
    double share;
    bool large;
};
struct wf_beam_parts wf_beam_find_parts(struct wf_beam *b, double slight);
/* Solve each of them by itself, its base held, until `most` elements were passed by iterations. `solve`: from
 * the present shape, of the elements that b->only lists. Returned: whether all were solved. */
bool wf_beam_each_part(struct wf_beam *b, size_t n, double most,
                       bool (*solve)(struct wf_beam *b, void *context), void *context);

/* Let only those elements move that b->part.held does not hold, until b->only is NULL again. */
void wf_beam_move_only(struct wf_beam *b);
#endif
