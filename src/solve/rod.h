/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_ROD_H
#define WF_SOLVE_ROD_H
/* A tree of inextensible rods, integrated in arc length from the root to the tips, branch after branch, with
 * balance of force and moment at every fork. Source: Feng J., Yan T., Chen Y., Wu E. 1999. Research on whole
 * tree's movement and tree's inner wind field, eqs 1 to 5. The paper integrates from a known force and
 * moment at the root; here these, and those at the base of every branch, are unknowns: the tips are free,
 * and the loads depend on the deformed shape. docs/papers.md derives the equations. */
#include "solve/solve.h"

/* `rod`: rotation of the frame by a unit quaternion, without singularity. `rod-as-printed`: three angles per
 * segment, eqs 2 and 3, which omit products of first derivatives; agrees with `rod` as segments are
 * refined. */
extern const struct wf_solver wf_solver_rod, wf_solver_rod_as_printed;
#endif
