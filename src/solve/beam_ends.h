/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_ENDS_H
#define WF_SOLVE_BEAM_ENDS_H
/* What acts at the ends of elements: point masses, point loads, cables to the ground; and links (struct
 * wf_link), each of which joins two ends that the elimination, from the tips to the base, takes one after
 * the other.
 *
 * The force N of a link is an unknown of its own, for one that is stiffer than the tree would turn small
 * errors of places into large forces. The elimination takes the forces as given and leaves the stiffness of
 * the links out, which is then added by a low rank (Woodbury; Hager 1989, SIAM Rev. 31:221). Let d be how far
 * the second end of a link moves away from the first along the link's axes, d0 the same without its
 * stiffness, D its stiffness there (k along it, N/L across, with its length L), F the flexibility of the tree
 * to unit forces that pull the ends together, and gap, along it, by what the ends are farther apart than the
 * link is long under its force. The force changes by phi = D (d + gap), and d = d0 - F phi, so that (1/D + F)
 * phi = d0 + gap. The same holds for all links together; directions without stiffness are left out.
 *
 * With n(A) negative pivots of A, n(J + U D U') = n(J) + p(1/D + F) - p(1/D), p counting positive ones
 * (Haynsworth 1968, Linear Algebra Appl. 1:73): a tree that stands only by its cables is stable. */
#include "solve/beam_state.h"

/* Forces at the element ends, into b->wrench (after wf_beam_sweep_up). */
void wf_beam_ends_load(struct wf_beam *b);
/* How they change with the motion of their ends, into b->node, without the links. */
void wf_beam_ends_react(struct wf_beam *b);

/* Memory of links, b->links, in `a`, and of small motions, in `newton`. Errors: WF_ENOMEM. */
enum wf_status wf_beam_links_take(struct wf_beam *b, struct wf_arena *a, struct wf_arena *newton,
                                  struct wf_err *e);
/* After a sweep down: add the energy of the gaps to b->misfit.bending. With `tangent`, add the stiffness of
 * the links to the tangent that was just eliminated: to the correction (b->answer, b->node, b->root_step,
 * b->root_change) and to the number of unstable directions (count may be NULL). false: it is singular. All
 * elements move. */
bool wf_beam_links_join(struct wf_beam *b, bool tangent, struct wf_beam_stability *count);
/* Start forces on a mesh from those on another one. */
void wf_beam_links_carry(const struct wf_beam *from, struct wf_beam *to);
/* Forces of the links [N]; 0 where there are none. */
void wf_beam_links_read(const struct wf_beam *b, double force[WF_LINKS_MAX]);
/* What else the correction changes: the links' forces, and the strains g of the elements that carry links. A
 * link that is stiffer than they are would otherwise be stretched by what they give. wf_beam_links_keep:
 * those of the last tangent are the correction's; wf_beam_links_stretch: add a share of them. */
void wf_beam_links_keep(struct wf_beam *b);
void wf_beam_links_stretch(struct wf_beam *b, double share);
/* The same for small motions about the present state (wf_beam_linearise). */
bool wf_beam_links_linearise(struct wf_beam *b);
/* Given: b->sides[].y, changes of the ends without the stiffness of the links. Adds what the links' forces
 * change by to b->sides[].push. */
void wf_beam_links_answer(struct wf_beam *b);
#endif
