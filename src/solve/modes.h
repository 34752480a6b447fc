/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_MODES_H
#define WF_SOLVE_MODES_H
/* Natural frequencies and self-buckling of a tree. */
#include "base/arena.h"
#include "base/err.h"
#include "base/vec3.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"

/* Vectors that an operator of wf_lanczos is applied to at once: entry i of a block has component i of each.
 */
enum { WF_LANCZOS_BLOCK = 4 };

/* A symmetric eigenvalue problem: the eigenvalues of largest magnitude are wanted. */
struct wf_lanczos {
    size_t size;                                               /* length of a vector */
    void (*apply)(void *ctx, const wf_four *in, wf_four *out); /* out = A in, for a block; A symmetric */
    void *ctx;
    size_t wanted;
    double tolerance; /* on |A x - value x| / |value|; the error of the value itself is about its square */
};

/* Largest eigenvalues by block Lanczos (Golub & Underwood 1977) with full orthogonalisation, repeated where
 * little of a vector remains, and blocks of WF_LANCZOS_BLOCK vectors, so that eigenvalues of at most that
 * multiplicity (a round stem sways alike in all directions) are all found.
 * Returned: value[wanted] by falling magnitude, NAN where the space has fewer; vector (wanted x size, may be
 * NULL), of unit norm. Errors: WF_ENOCONV with the best values found; WF_ENOMEM. */
enum wf_status wf_lanczos(const struct wf_lanczos *l, double *value, double *vector, struct wf_arena *a,
                          struct wf_err *e);

/* The lowest natural frequencies of small undamped motions about the equilibrium under `l` (including its
 * prestress; wind acts as a dead load, so there is no aerodynamic stiffness). Mass: wood, burden, point
 * masses; torsional but no bending rotary inertia. Given: count >= 1. Returned: frequency[count] in rising
 * order of omega^2 [Hz]; a negative value -f means omega^2 = -(2 pi f)^2: that motion grows, the equilibrium
 * is unstable; NAN where the mesh has fewer motions. shape (count x 3n, may be NULL): displacement of each
 * row's end, largest component 1. Errors: as the beam solver's; WF_ENOCONV. Method: shift-invert block
 * Lanczos on the factorised tangent of the tree; the mesh is refined until the frequencies change by less
 * than options->mesh_tolerance (0: one element per row). Accuracy h^4. */
enum wf_status wf_modes(const struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                        size_t count, struct wf_arena *a, double *frequency, double *shape, struct wf_err *e);

/* Results of wf_modes, kept to compute how a frequency changes with the tree's properties. */
struct wf_beam_shape;
struct wf_modes_kept {
    int32_t *pieces;             /* elements of each row */
    size_t size;                 /* length of a motion */
    double *motion;              /* count x size, as in solve/beam_small.h */
    struct wf_beam_shape *shape; /* the equilibrium of the motions */
    double (*tilt)[3];
};
/* As wf_modes, with its results in *kept (from `a`). The motions converge to 1e-8, not only the
 * frequencies. */
enum wf_status wf_modes_keep(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, size_t count, struct wf_arena *a,
                             double *frequency, double *shape, struct wf_modes_kept *kept, struct wf_err *e);
/* Frequency of kept mode k, with its motion held fixed, of a tree with the same rows and slightly different
 * properties, about that tree's own equilibrium [Hz; sign as wf_modes]. By Rayleigh's principle the
 * frequency is stationary in the motion: its error is of second order in the difference between the trees,
 * so a difference of two such frequencies is a derivative that needs no new eigenvalue search. Errors: as
 * wf_modes. */
enum wf_status wf_modes_held(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_modes_kept *kept, size_t k,
                             double *frequency, struct wf_err *e);

/* Generalised Greenhill factor: the multiple of the weight (gravity of `l`, wood, burden, point masses) at
 * which the unloaded shape, prestressed by that weight, loses its stiffness (linear buckling; wind and other
 * loads are omitted). For an upright stem this is the exact bifurcation: Greenhill 1881, factor 7.8373 E I /
 * (w L^3) for a uniform one. Returned: *factor; INFINITY when the tree is stable at any multiple up to 1e6
 * (a hanging or weightless tree). */
enum wf_status wf_buckling(const struct wf_tree *t, const struct wf_loads *l,
                           const struct wf_solve_options *o, struct wf_arena *a, double *factor,
                           struct wf_err *e);
#endif
