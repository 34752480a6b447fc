/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_CHECK_H
#define WF_SOLVE_BEAM_CHECK_H
/* From one mesh of a tree to another: the start shape, the error of a solution, and the pieces of a mesh that
 * meets a tolerance. */
#include "solve/beam_newton.h"

/* Start shape of `fine` (same tree, another mesh) from the solved shape of `coarse`. */
void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine);
/* The unloaded shape. */
void wf_beam_unbend(struct wf_beam *b);
/* Does the tree stand in its given shape? Every mesh has that solution. */
bool wf_beam_unmoved(const struct wf_beam *b);
/* Comparison of solutions on a mesh and on a finer one, row by row. */
struct wf_beam_check {
    double *reach;             /* per row: path length from its end to the farthest tip [m] */
    double *share;             /* per row: its own share of the errors of position [m], */
    double *bear, *order;      /* of the load's integral over the row [-], and with which power of the piece
                                  length that falls */
    double *before, *load;     /* 3 per row: distributed load on the coarse and on the fine mesh [N] */
    double *again, *closer;    /* likewise in the shape of the fine mesh, on the coarse one and on one twice
                                  as fine as the fine one, of rows for which it matters [N] */
    double depth;              /* rows on the longest path from the ground */
    double *rest, *root;       /* work space */
    double scale, worst, left; /* likewise */
    bool *looked;              /* likewise: rows whose loads were computed on other meshes too */
    double moved, rough;       /* errors of all loads by that of the shape, and on the coarse mesh [-] */
    double place, loads;       /* returned: errors of the fine mesh, of positions relative to the largest
                                  displacement and of loads relative to the force of the wind on the
                                  ground, but at least a fiftieth of all that acts there [-] */
    double turn;               /* of the turn of the tree's tip on the coarse mesh, of what is allowed [-] */
};
enum wf_status wf_beam_check_make(const struct wf_tree *t, struct wf_arena *a, struct wf_beam_check *c,
                                  struct wf_err *e);
/* Does the fine mesh meet options->mesh_tolerance? Given: of the beams only mesh, options, poses, tilt and
 * the force on the ground, of the fine one also loads and rotation vectors; `before` and `load`. Returned:
 * the answer, the errors; `before` is the load on the fine mesh. After it: */
bool wf_beam_check_meets(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c);
/* pieces[n] of the next mesh, no row coarser than the fine mesh; */
void wf_beam_check_choose(const struct wf_beam *fine, struct wf_beam_check *c, int32_t *pieces);
/* where the fine mesh is at least twice as fine in all rows, pieces[n] of the coarse mesh with few rows
 * refined, and what is expected of it: it meets the tolerance well (false: that takes many elements);
 * likewise the coarse mesh itself. */
bool wf_beam_check_few(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c,
                       int32_t *pieces, struct wf_beam_good *expected);
struct wf_beam_good wf_beam_check_first(const struct wf_beam *coarse, const struct wf_beam *fine,
                                        struct wf_beam_check *c, int32_t *pieces);
/* Distributed load on each row as integrated on the mesh, 3n [N]. Given: per element, the load at its Gauss
 * points (wf_beam.load). */
void wf_beam_row_loads(const struct wf_beam_mesh *m, const double (*at)[2][3], double *load);
/* The error of a solved beam's mesh, from a solution on a mesh twice as fine. Returned: *out; where the mesh
 * does not meet the tolerance, pieces[n] of one that does, no row coarser than now. Errors: WF_ENOMEM. */
enum wf_status wf_beam_mesh_off(const struct wf_beam *b, double tolerance, struct wf_beam_good *out,
                                int32_t *pieces, struct wf_err *e);
/* What is found of the fine mesh. */
struct wf_beam_good wf_beam_check_fine(const struct wf_beam_check *c, const struct wf_loads *l);

/* The speed of a wind with the same load on a stiff tree [m/s]; still air: 0. */
double wf_beam_pace(const struct wf_loads *l);
void wf_beam_note_good(struct wf_beam_goods *g, const struct wf_beam_good *found);
/* The error of a mesh at these loads, of what the tolerance allows, as it is expected from what is known,
 * whatever the direction, if it grows with a power of the wind; in a weaker wind, of whose smaller
 * displacements it is a share, it grows slowly. INFINITY: not known. By far: even with the load of the wind,
 * faster than it grows, it stays so small that the mesh is not looked at. */
double wf_beam_expected_error(const struct wf_beam_goods *g, const struct wf_loads *l, double tolerance,
                              double power);
bool wf_beam_good_by_far(const struct wf_beam_goods *g, const struct wf_loads *l, double tolerance);
#endif
