/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_CHECK_H
#define WF_SOLVE_BEAM_CHECK_H
/* From one mesh of a tree to another: the start shape, the error of a solution, and the pieces of a mesh that
 * meets a tolerance. */
#include "solve/beam_newton.h"

/* Start shape of `fine` (same tree, another mesh) from the solved shape of `coarse`. */
void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine);
/* Does the tree stand in its given shape? Every mesh has that solution. */
bool wf_beam_unmoved(const struct wf_beam *b);
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
/* Distributed load on each row as integrated on the mesh, 3n [N]. */
void wf_beam_row_loads(const struct wf_beam *b, double *load);
/* The error of a solved beam's mesh, from a solution on a mesh twice as fine. Returned: *error, of what the
 * tolerance allows [-] (at most 1: the mesh meets it); where it is more, pieces[n] of a mesh that does, no
 * row coarser than now. Errors: WF_ENOMEM. */
enum wf_status wf_beam_mesh_off(const struct wf_beam *b, double tolerance, double *error, int32_t *pieces,
                                struct wf_err *e);
#endif
