/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_ROD_H
#define WF_SOLVE_ROD_H
/* A tree of inextensible rods, integrated in arc length from the root to the tips, branch after branch, with
 * balance of force and moment at every fork.
 * Source: Feng J., Yan T., Chen Y., Wu E. 1999. Research on whole tree's movement and tree's inner wind
 * field, eqs 1 to 5. The paper integrates from a force and moment at the root it takes as known; here they,
 * and those at the base of every branch, are found: the tips are free, and the loads belong to the bent
 * shape. docs/papers.md derives the equations. */
#include "solve/solve.h"

/* `rod`: the frame turns as a unit quaternion, no singularity. `rod-as-printed`: three angles a segment,
 * eqs 2 and 3, in which products of first derivatives are left out; agrees with `rod` as segments are
 * refined.
 */
extern const struct wf_solver wf_solver_rod, wf_solver_rod_as_printed;
#endif
