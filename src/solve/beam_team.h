/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_TEAM_H
#define WF_SOLVE_BEAM_TEAM_H
/* Sweeps of stems without branches, of different trees, side by side. */
#include "solve/beam_groups.h"

/* In a job of base/abreast.h: the sweep of a tree of which each element stands on the one before, with those
 * that other jobs wait for; not of the element on the ground. As `chains_up` and `chains_down` of struct
 * wf_groups_kernel; the same bytes whatever the others are. */
void wf_beam_team_up(struct wf_groups_sweep *x);
bool wf_beam_team_down(struct wf_groups_sweep *x);
#endif
