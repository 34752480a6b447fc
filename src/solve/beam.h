/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_H
#define WF_SOLVE_BEAM_H
/* The beam solvers: geometrically exact beams on a mesh refined to a tolerance, and one linear step on the
 * same elements. */
#include "base/arena.h"
#include "solve/beam_newton.h"
#include "solve/solve.h"

/* Start shape of `fine` (same tree, another mesh) from the solved shape of `coarse`. */
void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine);

extern const struct wf_solver wf_solver_beam;   /* large deflections, loads on the deformed shape */
extern const struct wf_solver wf_solver_linear; /* one linear step, loads on the undeformed shape */

/* Equilibrium on a mesh that meets options->mesh_tolerance. Given: tree, loads, options; `from`, a solved
 * beam of the same tree whose shape the first mesh starts from (NULL: unloaded); the memory of *b is taken
 * from `work`. Returned: as wf_beam_settle; *out tells how the full load was reached. Method: the
 * first meshes differ by a factor 2; each row is then refined by its own share of the estimated error. */
enum wf_status wf_beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_beam *from,
                             struct wf_arena *work, struct wf_beam *b, struct wf_beam_outcome *out,
                             struct wf_err *e);
/* Does the mesh of a solved beam meet a tolerance? It is compared with a solution on a mesh twice as fine.
 * Returned: *meets. Errors: WF_ENOMEM. */
enum wf_status wf_beam_mesh_meets(const struct wf_beam *b, double tolerance, bool *meets, struct wf_err *e);
/* Fill the columns of the response, which is allocated for the tree's rows, from a solved beam. */
void wf_beam_read(const struct wf_beam *b, struct wf_response *r);
/* Warnings about a solution: small parts that are not stable, a limit point on the way to the full load. d
 * may be NULL. */
void wf_beam_warn(const struct wf_beam *b, const struct wf_beam_outcome *out, struct wf_diag *d);
#endif
