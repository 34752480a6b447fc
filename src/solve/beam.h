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
 * beam of the same tree whose shape the first mesh starts from (NULL: unloaded); `near` (NULL: none), one
 * whose shape is tried where Newton's method stalls, before load steps; the memory of *b is taken
 * from `work`. Returned: as wf_beam_settle; *out tells how the full load was reached. Method: the
 * first meshes differ by a factor 2; each row is then refined by its own share of the estimated error. */
enum wf_status wf_beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_beam *from,
                             const struct wf_beam *near, struct wf_arena *work, struct wf_beam *b,
                             struct wf_beam_outcome *out, struct wf_err *e);
/* Does the mesh of a solved beam meet a tolerance? It is compared with a solution on a mesh twice as fine.
 * Returned: *meets. Errors: WF_ENOMEM. */
enum wf_status wf_beam_mesh_meets(const struct wf_beam *b, double tolerance, bool *meets, struct wf_err *e);
/* Fill the columns of the response, which is allocated for the tree's rows, from a solved beam. */
void wf_beam_read(const struct wf_beam *b, struct wf_response *r);
/* Comparison of solutions on a mesh and on a finer one, row by row. */
struct wf_beam_check {
    double *reach;         /* per row: path length from its end to the farthest tip [m] */
    double *share, *bear;  /* per row: its own share of the errors of position [m] and of the loads [-] */
    double *before, *load; /* 3 per row: distributed load on the coarse and on the fine mesh [N] */
    double depth;          /* rows on the longest path from the ground */
};
enum wf_status wf_beam_check_make(const struct wf_tree *t, struct wf_arena *a, struct wf_beam_check *c,
                                  struct wf_err *e);
/* Does the fine mesh meet options->mesh_tolerance? Given: of the beams only mesh, options, poses, tilt and
 * the force on the ground; `before` and `load`. Returned: the answer; where it is no, pieces[n] of the next
 * mesh; `before` is the load on the fine mesh. */
bool wf_beam_check_meets(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c,
                         int32_t *pieces);
/* Parts of a response: displacement, rotation and tangents of row i from the rotation of its base and the
 * pose of its end; force and moment on the ground, and their imbalance against the sums of all loads and of
 * their moments. */
void wf_beam_read_shape(const struct wf_beam_mesh *m, size_t i, const double base_L[9],
                        const struct wf_beam_pose *end, struct wf_response *r);
void wf_beam_read_balance(const struct wf_beam_wrench *ground, const double force[3], const double moment[3],
                          struct wf_response *r);
/* Warnings about a solution: small parts that are not stable, a limit point on the way to the full load. d
 * may be NULL. */
void wf_beam_warn(const struct wf_beam *b, const struct wf_beam_outcome *out, struct wf_diag *d);
#endif
