/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_H
#define WF_SOLVE_BEAM_H
/* The beam solvers: geometrically exact beams on a mesh refined to a tolerance, and one linear step on the
 * same elements. */
#include "base/arena.h"
#include "solve/beam_check.h"
#include "solve/beam_settle.h"
#include "solve/solve.h"

extern const struct wf_solver wf_solver_beam;   /* large deflections, loads on the deformed shape */
extern const struct wf_solver wf_solver_linear; /* one linear step, loads on the undeformed shape */

/* A mesh that hardly differs from the first one of a tree and what is known of both, as expected from the
 * errors of solutions. */
struct wf_beam_few {
    struct wf_arena memory; /* of the caller, to be freed by it */
    int32_t *pieces;        /* per row; NULL: there is none */
    struct wf_beam_goods goods, first;
};
/* Is that mesh, if there is one (few: NULL, none), good by far at these loads? */
bool wf_beam_few_good(const struct wf_beam_few *few, const struct wf_loads *l, double tolerance);
/* What is known of the same tree at other loads; each may be NULL. */
struct wf_beam_known {
    const struct wf_beam *from;      /* a solution whose mesh and shape are begun with; else the first mesh,
                                        unloaded */
    const struct wf_beam *near;      /* one whose shape is tried where Newton's method stalls */
    const struct wf_beam *soon;      /* without `from`: one whose shape is tried first */
    const struct wf_beam_mesh *good; /* a mesh that met the tolerance */
    struct wf_beam_few *few;         /* given and returned */
};

/* Equilibrium on a mesh that meets options->mesh_tolerance. Given: tree, loads, options; what is known (NULL:
 * nothing); the memory of *b is taken from `work`, that of what Newton's method works with, two thirds of it,
 * from `newton`, which may be `work`. Returned: as wf_beam_settle; *out tells how the full load was reached,
 * b->mesh.goods what was found of the mesh. Method: that of few more elements than the first is the only one
 * where it is good by far. Else the first meshes differ by a factor 2, the second taking the pieces of what
 * was good at other loads where these are few more; each row is then refined by its own share of the
 * estimated error. */
enum wf_status wf_beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_beam_known *known,
                             struct wf_arena *work, struct wf_arena *newton, struct wf_beam *b,
                             struct wf_beam_outcome *out, struct wf_err *e);
/* Fill the columns of the response, which is allocated for the tree's rows, from a solved beam. */
void wf_beam_read(const struct wf_beam *b, struct wf_response *r);
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
