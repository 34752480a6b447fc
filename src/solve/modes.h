/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_MODES_H
#define WF_SOLVE_MODES_H
/* Largest eigenvalues of a symmetric operator. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"

struct wf_lanczos {
    size_t size;                                             /* length of a vector                       */
    void (*apply)(void *ctx, const double *in, double *out); /* out = A in; A symmetric                  */
    void *ctx;
    size_t wanted;
    double tolerance; /* on |A x - value x| / |value|; the value itself is good to about its square */
};

/* Block Lanczos (Golub & Underwood 1977) with full, twice repeated orthogonalisation and blocks of three, so
 * that equal eigenvalues (a round stem sways alike in all directions) are all found. Returned: value[wanted]
 * by falling magnitude, NAN where the space has fewer; vector (wanted x size, may be NULL), of unit norm.
 * WF_ENOCONV with *out the best so far; WF_ENOMEM. */
enum wf_status wf_lanczos(const struct wf_lanczos *l, double *value, double *vector, struct wf_arena *a,
                          struct wf_err *e);

/* Natural frequencies and self-buckling of a tree. */

/* The lowest natural frequencies of small undamped motions about the equilibrium under `l` (its prestress
 * counts; wind acts as a dead load, so the answer has no aerodynamic stiffness). Mass: wood, burden, point
 * masses; torsional but no bending rotary inertia. Given: count >= 1. Returned: frequency[count] in rising
 * order of omega^2 [Hz]; a negative figure -f means omega^2 =
 * -(2 pi f)^2: that motion grows, the state does not stand; NAN where the mesh has fewer motions. shape
 * (count x 3n, may be NULL): displacement of each row's end, largest component 1. Errors: as the beam
 * solver's; WF_ENOCONV. Method: shift-invert block Lanczos on the tree's own factor; the mesh is refined
 * until the figures change by less than options->mesh_tolerance (0: one element a row). Accuracy h^4. */
enum wf_status wf_modes(const struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                        size_t count, struct wf_arena *a, double *frequency, double *shape, struct wf_err *e);

/* What wf_modes found, kept to ask how a frequency changes when the tree's values do. */
struct wf_beam_shape;
struct wf_modes_kept {
    int32_t *pieces;             /* elements of each row               */
    size_t size;                 /* of a motion                        */
    double *motion;              /* count x size, as in beam_vibrate.h */
    struct wf_beam_shape *shape; /* the equilibrium they sway about    */
    double (*tilt)[3];
};
/* As wf_modes, with what it found in *kept (from `a`). The motions are found to 1e-8, not only the figures.
 */
enum wf_status wf_modes_keep(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, size_t count, struct wf_arena *a,
                             double *frequency, double *shape, struct wf_modes_kept *kept, struct wf_err *e);
/* Frequency of kept mode k with its motion held, of a tree with the same rows whose other values differ a
 * little, about that tree's own equilibrium [Hz; sign as wf_modes]. By Rayleigh's principle the figure is
 * stationary in the motion: it differs from the tree's own frequency in second order of what differs, so a
 * difference of two is a derivative without a search for modes. Errors: as wf_modes. */
enum wf_status wf_modes_held(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_modes_kept *kept, size_t k,
                             double *frequency, struct wf_err *e);

/* Generalised Greenhill factor: the multiple of the weight (gravity of `l`, wood, burden, point masses) at
 * which the unloaded shape, prestressed by that weight, loses its stiffness (linear buckling; wind and other
 * loads are left out). For an upright stem this is the exact bifurcation: Greenhill 1881, factor 7.8373 E I /
 * (w L^3) for a uniform one. Returned: *factor; INFINITY when the tree stands at any multiple up to 1e6 (a
 * hanging one, or weightless). */
enum wf_status wf_buckling(const struct wf_tree *t, const struct wf_loads *l,
                           const struct wf_solve_options *o, struct wf_arena *a, double *factor,
                           struct wf_err *e);
#endif
