/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_H
#define WF_SOLVE_BEAM_H
/* The structural engine as solver rows, on the mesh a tolerance asks for. */
#include "base/arena.h"
#include "solve/beam_newton.h"
#include "solve/solve.h"

/* Start `fine` (same tree, another mesh) from the shape of `coarse`. */
void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine);

extern const struct wf_solver wf_solver_beam;   /* large deflections, loads on the bent shape */
extern const struct wf_solver wf_solver_linear; /* one linear step, loads on the unbent shape */

/* Equilibrium on the mesh that options->mesh_tolerance asks for; the beam's memory is in `work`.
 * Returned: as wf_beam_settle; *out tells how the load was carried. */
enum wf_status wf_beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, struct wf_arena *work, struct wf_beam *b,
                             struct wf_beam_outcome *out, struct wf_err *e);
/* Findings of an answer: small parts that are not stable, a limit point on the way. d may be NULL. */
void wf_beam_warn(const struct wf_beam *b, const struct wf_beam_outcome *out, struct wf_diag *d);
#endif
