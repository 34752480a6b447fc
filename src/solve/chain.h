/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_CHAIN_H
#define WF_SOLVE_CHAIN_H
/* A tree as a chain of cantilevers: each row bends as a cantilever fixed to the end of the row below it,
 * under its own line load and the forces and moments passed down from the rows above. Loads are those on the
 * undeformed tree; small deflection. Source: Tang L., Zou J., Lin D., Chen C. 2012. Visual simulating
 * virtual tree movement in wind. Trans. Chin. Soc. Agric. Mach. 43(1):165-168, eqs 5 to 12.
 *
 * The paper passes down the force but neither moment nor rotation; refining the chain then drives the
 * deflection of a given tree to zero like 1/(2 N^2). wf_solver_chain passes both and integrates the taper of
 * each row; it is exact in small-deflection Euler-Bernoulli theory for any number of rows (with torsion,
 * without axial stretch). wf_solver_chain_as_printed reproduces the paper's scheme. */
#include "solve/solve.h"

/* What is passed between the rows. Every entry is a factor, 0 or 1, so that the inner loop needs no
 * branches. */
struct wf_chain_scheme {
    double smear;  /* force from above: 1 spread over the row (eq 12), 0 acting at its end */
    double moment; /* moment from above bends the row */
    double carry;  /* rotation of the end below is added to the base of a row */
    double taper;  /* section: 1 varies along the row, 0 that of the mean radius */
    double weight; /* weight is included in the loads */
};
extern const struct wf_chain_scheme wf_chain_corrected, wf_chain_printed;

/* Solve with a scheme. Given and returned as wf_solver.solve; small_deflection is true. turn: rotation of
 * the row's end; where `carry` is 0, that of the row alone, on a base without rotation. Internal forces
 * satisfy statics on the undeformed tree in every scheme. */
enum wf_status wf_chain_solve(const struct wf_chain_scheme *scheme, const struct wf_tree *t,
                              const struct wf_loads *l, const struct wf_solve_options *o, struct wf_arena *a,
                              struct wf_response *r, struct wf_diag *d, struct wf_err *e);

extern const struct wf_solver wf_solver_chain, wf_solver_chain_as_printed;

/* Schemes between the printed and the corrected chain, which show the effect of each missing term: for
 * validation cases only.
 *   S1 force passed down, spread over the row (eq 12); S2 force at the row's end; S3, S4 as S1, S2 with
 *   the moment. chain-S1 ... chain-S4: no row takes over the rotation below it; ...-turned: it does.
 *   S4-turned is the corrected chain, S1 the printed one except for taper and weight. */

extern const struct wf_solver *const wf_chain_variants[]; /* ends at NULL */
#endif
