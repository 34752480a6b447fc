/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_ENDS_H
#define WF_SOLVE_BEAM_ENDS_H
/* What acts at the ends of elements: point masses, point loads, cables to the ground; and links (struct
 * wf_link), each of which joins two ends that the elimination, from the tips to the base, takes one after
 * the other.
 *
 * The elimination takes the forces of links as given and leaves their stiffness out, which is then added by
 * a low rank (Woodbury; Hager 1989, SIAM Rev. 31:221). Let d be how far the second end of a link moves
 * away from the first along the link's axes, d0 the same without its stiffness, D its stiffness there (k
 * along it, N/L across, with the force N and the length L), F the flexibility of the tree to unit forces that
 * pull the ends together. Its force changes by phi = D d, and d = d0 - F phi, so that (1/D + F) phi = d0. The
 * same holds for all links together; directions without stiffness are left out.
 *
 * With n(A) negative pivots of A, n(J + U D U') = n(J) + p(1/D + F) - p(1/D), p counting positive ones
 * (Haynsworth 1968, Linear Algebra Appl. 1:73): a tree that stands only by its cables is stable. */
#include "solve/beam_state.h"

/* Forces at the element ends, into b->wrench (after wf_beam_sweep_up). */
void wf_beam_ends_load(struct wf_beam *b);
/* How they change with the motion of their ends, into b->node, without the links. */
void wf_beam_ends_react(struct wf_beam *b);

/* Memory of links, b->links, and of small motions. Errors: WF_ENOMEM. */
enum wf_status wf_beam_links_take(struct wf_beam *b, struct wf_arena *a, struct wf_err *e);
/* Add the stiffness of the links to a tangent that was just eliminated: to the correction (b->answer,
 * b->node, b->root_step, b->root_change) and to the number of unstable directions (count may be NULL). false:
 * the tangent is singular. All elements move. */
bool wf_beam_links_join(struct wf_beam *b, struct wf_beam_stability *count);
/* The same for small motions about the present state (wf_beam_linearise). */
bool wf_beam_links_linearise(struct wf_beam *b);
/* Given: b->sides[].y, changes of the ends without the stiffness of the links. Adds what the links' forces
 * change by to b->sides[].push. */
void wf_beam_links_answer(struct wf_beam *b);
#endif
