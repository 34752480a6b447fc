/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_CHAIN_H
#define WF_SOLVE_CHAIN_H
/* A tree as a chain of cantilevers: each row bends as a cantilever on the end of the row below it, under its
 * own line load and what the rows above hand down. Loads are those on the unbent tree; small deflection.
 * Source: Tang L., Zou J., Lin D., Chen C. 2012. Visual simulating virtual tree movement in wind. Trans.
 * Chin. Soc. Agric. Mach. 43(1):165-168, eqs 5 to 12.
 *
 * The paper hands down force but neither moment nor rotation; refining the chain then drives the deflection
 * of a given tree to zero like 1/(2 N^2). wf_solver_chain hands down both and integrates the taper of each
 * row; it is exact in small-deflection Euler-Bernoulli theory for any number of rows (with torsion, without
 * axial stretch). wf_solver_chain_as_printed keeps the paper's scheme. */
#include "solve/solve.h"

/* What is handed on between the rows. Every entry is a factor, 0 or 1, so that the kernel has no options to
 * branch on. */
struct wf_chain_scheme {
    double smear;  /* force from above: 1 spread over the row (eq 12), 0 acting at its end       */
    double moment; /* moment from above bends the row                                            */
    double carry;  /* the base of a row takes over the rotation of the end below it              */
    double taper;  /* section: 1 varies along the row, 0 that of the mean radius                 */
    double weight; /* weight counts among the loads                                              */
};
extern const struct wf_chain_scheme wf_chain_corrected, wf_chain_printed;

/* Solve with a scheme. Given and returned as wf_solver.solve; small_deflection is true.
 * turn: rotation of the row's end; where `carry` is 0, that of the row alone, on an upright base.
 * Internal forces are those of statics on the unbent tree in every scheme. */
enum wf_status wf_chain_solve(const struct wf_chain_scheme *scheme, const struct wf_tree *t,
                              const struct wf_loads *l, const struct wf_solve_options *o, struct wf_arena *a,
                              struct wf_response *r, struct wf_diag *d, struct wf_err *e);

extern const struct wf_solver wf_solver_chain, wf_solver_chain_as_printed;

/* The ways between the printed and the corrected chain, to see which missing piece does what: for validation
 * cases alone.
 *   S1 force handed down, spread over the row (eq 12); S2 force at the row's end; S3, S4 the same with the
 * moment. chain-S1 ... chain-S4: every row on an upright base; ...-turned: it takes over the rotation below.
 * S4-turned is the corrected chain, S1 the printed one but for taper and weight. */

extern const struct wf_solver *const wf_chain_variants[]; /* ends at NULL */
#endif
