/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_NODES_H
#define WF_SOLVE_BEAM_NODES_H
/* What acts at the ends of elements: point masses, dead and follower forces and moments, cables. */
#include "solve/beam_newton.h"

/* Set b->wrench to the loads at the ends in the present shape. */
void wf_beam_load_nodes(struct wf_beam *b);
/* Set b->node to their change by the motion of the ends. */
void wf_beam_react_nodes(struct wf_beam *b);
#endif
