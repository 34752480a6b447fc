/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_MESH_H
#define WF_SOLVE_BEAM_MESH_H
/* Mesh of the beam solvers: each row is cut into pieces, each piece is one element with two Gauss points.
 * Pieces of a row are equal, but in a wind that changes with height those of a row on the ground become
 * shorter towards it where the mesh is to meet a tolerance: the load grows there with a low power of height.
 * Everything that does not change with
 * the deformation is computed here, once. */
#include "base/arena.h"
#include "base/err.h"
#include "base/real.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"
#include <stdint.h>

/* A wind of the same form that is faster and denser by these shares, to first order. */
struct wf_beam_growth {
    double speed, density;
};

/* Two-stage Gauss collocation on 0..1 (Hairer, Lubich & Wanner 2006, Geometric Numerical Integration,
 * II.1.3). Both weights are 1/2. */

/* position of the stages */
static const double gauss_place[2] = { 0.21132486540518711775, 0.78867513459481288225 };
#define GAUSS_ROOT3 1.7320508075688772935
/* integral from the base to stage i = h sum_j up[i][j] f_j */
static const double gauss_up[2][2] = { { 0.25, 0.25 - GAUSS_ROOT3 / 6 }, { 0.25 + GAUSS_ROOT3 / 6, 0.25 } };
/* integral from stage i to the end = h sum_j down[i][j] f_j */
static const double gauss_down[2][2] = { { 0.25, 0.25 + GAUSS_ROOT3 / 6 }, { 0.25 - GAUSS_ROOT3 / 6, 0.25 } };
/* slope at stage i of the quadratic that is 0 at the base: f'_i = sum_j slope[i][j] f_j / h (inverse of up)
 */
static const double gauss_slope[2][2] = { { 3, -3 + 2 * GAUSS_ROOT3 }, { -3 - 2 * GAUSS_ROOT3, 3 } };
/* its value at the end: sum_j gauss_end[j] f_j */
static const double gauss_end[2] = { -GAUSS_ROOT3, GAUSS_ROOT3 };

/* Constants of an element; index 0/1 = Gauss point nearer the base / the end. */
struct wf_beam_part {
    int32_t parent;      /* element below; -1 = ground */
    int32_t row;         /* tree row it belongs to */
    double h;            /* arc length [m] */
    double t[2][3];      /* unloaded unit tangent */
    double ei[2], gj[2]; /* bending and torsion stiffness [N m2] */
    double ca[2], cs[2]; /* axial and shear compliance [1/N]; 0 = rigid */
    double spin[2];      /* torsional inertia per length [kg m] */
    struct wf_line_point line[2];
    double dead[2][3];         /* dead line load [N/m] */
    double k0[2][3], g0[2][3]; /* curvature [1/m] and strain of the section's law in the given shape, which
                                  the weight of a standing tree makes (solve/beam_rest.h); 0 = stress-free */
};

/* Additional constants of an element whose section is not round; unloaded in the mesh, rotated with the
 * element in struct wf_beam. Its bending stiffness is ei + more about the width, ei about the height. */
struct wf_beam_flat {
    real more[2],
        give[2];       /* stiffness about the width minus ei [N m2]; likewise for the compliance [1/(N m2)] */
    real across[2][3]; /* unit vector along the width, to the left */
    real side[2];      /* first moment of the burden along `across`, per length [kg] */
    real weight;       /* weight of a unit mass [m/s2] */
};

/* What an element had to carry on the day its shape was given. */
struct wf_beam_standing {
    double mass[2];    /* wood and burden per length at the Gauss points [kg/m] */
    double side[2];    /* first moment of the burden, as in struct wf_beam_flat [kg] */
    double n[3], m[3]; /* force and moment that the part above exerts on its end [N, N m] */
};

/* What the mesh was found to be in one wind, from a comparison with another. */
struct wf_beam_good {
    double pace;     /* speed of the wind with the same load on a stiff tree [m/s]; 0: still air */
    double along[3]; /* its direction */
    double place;    /* error of positions, relative to the largest displacement [-] */
    double loads;    /* of loads, relative to the force of the wind (struct wf_beam_check) [-] */
    double turn;     /* of the turn of the tree's tip, of what is allowed [-] */
};
enum { WF_BEAM_GOOD = 8 };
struct wf_beam_goods {
    size_t n; /* so many were found: the last of them are kept */
    struct wf_beam_good at[WF_BEAM_GOOD];
};

struct wf_beam_mesh {
    const struct wf_tree *tree;
    size_t n;    /* elements */
    bool graded; /* rows on the ground have pieces that are shorter towards it */
    struct wf_beam_goods goods;
    struct wf_beam_part *part;
    struct wf_beam_flat *flat;         /* per element; NULL = all sections are round */
    int32_t *last;                     /* per row: its last element */
    int32_t *first;                    /* per row: its first element */
    double *mass1;                     /* per element: point mass at its end [kg]; NULL = none */
    struct wf_beam_standing *standing; /* per element; NULL: the given shape is stress-free */
    double (*root)[3];                 /* per row, for roots: moment on the ground in the given shape [N m];
                                          NULL as `standing` */
    double (*still)[3]; /* per row: its end in the given shape as placed on this mesh [m], so that
                           a standing tree at rest has moved by nothing; NULL as `standing` */
};

/* Elements of a row. */
static inline int32_t wf_beam_pieces(const struct wf_beam_mesh *m, size_t row)
{
    return m->last[row] - m->first[row] + 1;
}

/* Do the pieces of a row become shorter towards the ground? */
static inline bool wf_beam_graded(const struct wf_beam_mesh *m, size_t row)
{
    return m->graded && m->tree->parent[row] < 0;
}
/* Arc fraction (0..1) of a row that is cut into so many pieces at which its first k pieces end. */
static inline double wf_beam_cut(const struct wf_beam_mesh *m, size_t row, int32_t k, int32_t pieces)
{
    const double x = (double)k / pieces, cube = x * x * x;
    return wf_beam_graded(m, row) ? cube / (cube + 1 - x) : x;
}
/* The piece of a row, from 0, in which arc fraction s lies, and *x, the fraction of the piece there. */
int32_t wf_beam_piece_at(const struct wf_beam_mesh *m, size_t row, double s, double *x);

/* Build the mesh. Given: tree, loads (for dead line loads), options (beam model), pieces[n] per row (NULL =
 * 1 each). Returned: *out, in `arena`. Errors: WF_ENOMEM; WF_EINPUT naming a row that is not connected to
 * its parent's end. Method: the stiffness of an element is given by two moments of its compliance, so that
 * the integrals of 1/EI and s/EI over the element are exact for any taper (to eight-point Gauss-Legendre
 * quadrature). */
enum wf_status wf_beam_mesh_build(const struct wf_tree *tree, const struct wf_loads *loads,
                                  const struct wf_solve_options *options, const int32_t *pieces,
                                  struct wf_arena *arena, struct wf_beam_mesh *out, struct wf_err *e);

/* Pieces per row of the first mesh, pieces[n]: where a mesh tolerance is given, a tree of few rows gets at
 * least 24 elements, and of one of many those on the ground get some. */
void wf_beam_first_pieces(const struct wf_tree *tree, const struct wf_solve_options *options,
                          int32_t *pieces);
/* Pieces per row of the mesh that it is compared with: twice as many; more in rows on the ground, where that
 * takes few elements: the error of the load there would outweigh those of all other rows. */
void wf_beam_second_pieces(const struct wf_tree *tree, int32_t *pieces);

/* Position [m] and unit tangent of the unloaded axis at arc fraction s (0..1) of row i. */
void wf_row_axis(const struct wf_tree *tree, size_t i, double s, double position[3], double tangent[3]);
/* Where the end of row i is before it moves [m]. */
static inline void wf_beam_still_at(const struct wf_beam_mesh *m, size_t i, double place[3])
{
    const struct wf_tree *t = m->tree;
    const double drawn[3] = { t->x1[i], t->y1[i], t->z1[i] };
    memcpy(place, m->still ? m->still[i] : drawn, sizeof drawn);
}
#endif
