/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_MESH_H
#define WF_SOLVE_BEAM_MESH_H
/* Elements of a tree for the beam solvers: each row cut into equal pieces, each piece one element with two
 * Gauss points, where everything that does not change while the tree bends is worked out once. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"
#include <stdint.h>

/* Two-stage Gauss collocation on 0..1 (Hairer, Lubich & Wanner 2006, Geometric Numerical Integration,
 * II.1.3). Weights are 1/2 each. */

/* where the stages are */
static const double gauss_place[2] = { 0.21132486540518711775, 0.78867513459481288225 };
#define GAUSS_ROOT3 1.7320508075688772935
/* from the base up to stage i: integral = h sum_j up[i][j] f_j */
static const double gauss_up[2][2] = { { 0.25, 0.25 - GAUSS_ROOT3 / 6 }, { 0.25 + GAUSS_ROOT3 / 6, 0.25 } };
/* from stage i up to the end */
static const double gauss_down[2][2] = { { 0.25, 0.25 + GAUSS_ROOT3 / 6 }, { 0.25 - GAUSS_ROOT3 / 6, 0.25 } };
/* slope at stage i of the quadratic that is 0 at the base: f'_i = sum_j slope[i][j] f_j / h (inverse of up)
 */
static const double gauss_slope[2][2] = { { 3, -3 + 2 * GAUSS_ROOT3 }, { -3 - 2 * GAUSS_ROOT3, 3 } };
/* its value at the end: sum_j gauss_end[j] f_j */
static const double gauss_end[2] = { -GAUSS_ROOT3, GAUSS_ROOT3 };

/* What an element is made of; index 0/1 = Gauss point nearer the base / the end. */
struct wf_beam_part {
    int32_t parent;      /* element below; -1 = ground                                          */
    int32_t row;         /* tree row it belongs to                                              */
    double h;            /* arc length [m]                                                      */
    double t[2][3];      /* unloaded unit tangent                                               */
    double ei[2], gj[2]; /* bending and torsion stiffness [N m2]                            */
    double ca[2], cs[2]; /* axial and shear compliance [1/N]; 0 = rigid                     */
    double spin[2];      /* torsional inertia per length [kg m]                                 */
    struct wf_line_point line[2];
    double dead[2][3]; /* dead line load [N/m]                                              */
};

/* What a section that is not round adds to a part; in the mesh unloaded, in the beam turned with it. Its
 * stiffness is ei + more about the width, ei about the height. */
struct wf_beam_flat {
    double more[2], give[2]; /* stiffness about the width less ei [N m2]; compliance likewise [1/(N m2)] */
    double across[2][3];     /* unit vector along the width, to the left                              */
    double side[2];          /* first moment of the burden towards it, per length [kg]                */
    double weight;           /* of a unit mass [m/s2]                                                 */
};

struct wf_beam_mesh {
    const struct wf_tree *tree;
    size_t n; /* elements                                                     */
    struct wf_beam_part *part;
    struct wf_beam_flat *flat; /* per element; NULL = all sections are round            */
    int32_t *last;             /* per row: its last element                                    */
    int32_t *first;            /* per row: its first element                                   */
    double *mass1;             /* per element: point mass at its end [kg]; NULL = none         */
};

/* Given: tree, loads (for dead line loads), options (beam model), pieces[n] per row (NULL = 1 each).
 * Returned: WF_OK; WF_ENOMEM; WF_EINPUT naming a row that is not connected to its parent's end.
 * Method: tapered stiffness enters by two moments, so that the integrals of 1/EI and s/EI over an element are
 * exact whatever the taper (to eight-point Gauss-Legendre quadrature). */
enum wf_status wf_beam_mesh_build(const struct wf_tree *tree, const struct wf_loads *loads,
                                  const struct wf_solve_options *options, const int32_t *pieces,
                                  struct wf_arena *arena, struct wf_beam_mesh *out, struct wf_err *e);

/* Pieces each row starts with where a mesh tolerance is asked for: a tree of few rows has at least 24
 * elements. */
int32_t wf_beam_first_pieces(const struct wf_tree *tree, const struct wf_solve_options *options);

/* Reference position, tangent of the row's axis at arc fraction s (0..1) of row i. */
void wf_row_axis(const struct wf_tree *tree, size_t i, double s, double position[3], double tangent[3]);
#endif
