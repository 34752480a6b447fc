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
    double *turn;                /* count x 2: signed roots of the shares of the tree's moment of inertia: how
                                    much of the overturning by inertia along x and y each mode carries [-] */
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

/* What a mode moves, as the signed root of its share. */
struct wf_modes_part {
    double mass[3]; /* of the tree's mass: effective modal mass along `to`, to the left of it, up [-] */
    double
        turn[2]; /* of the tree's moment of inertia: the overturning by inertia along `to`, to the left [-] */
};
/* As wf_modes, with what the modes move. Given: `to`, horizontal unit vector. Returned: *count, fewer where
 * the mesh has fewer motions; frequency, out: one a mode; shape (count x 3n): displacement of each row's end
 * where the modal mass is 1 kg. Mass and overturning are those of the unloaded shape. `most` limits the work:
 * the vectors of the space in which the motions are searched (0: as many as it takes). Errors: also
 * WF_ENOCONV where these do not suffice, as in trees whose lowest motions are those of many twigs. */
enum wf_status wf_modes_parts(const struct wf_tree *t, const struct wf_loads *l,
                              const struct wf_solve_options *o, size_t most, size_t *count,
                              const double to[2], struct wf_arena *a, double *frequency,
                              struct wf_modes_part *out, double *shape, struct wf_err *e);

struct wf_beam;
/* How a tree sways along a horizontal direction. */
struct wf_modes_sway {
    double frequency; /* [Hz] */
    double share; /* of the tree's moment of inertia: how much of the overturning by inertia it carries [-] */
    double inertia; /* of the tree about its base [kg m2] */
};
/* The modes with the largest share of the moment that inertia along a direction exerts on the base, of those
 * whose frequencies lie within width[0] (relative) of each other: damped modes that near act as one, and the
 * branches of a tree divide its sway among many. Given: a solved beam, which is left as it is; `to`, unit
 * vector; bands: how many widths, of which the others are for comparison, in the space that the first takes.
 * Returned: out[bands]; shape (bands times 3n): displacement of each row's end in the part of a rigid turn
 * about the base by 1 that these modes have. Errors: WF_EUNSTABLE where no motion along it is stable;
 * WF_ENOMEM. Method: Ritz vectors of that turn (Wilson E.L., Yuan M.W., Dickens J.M. 1982, Earthquake Eng.
 * Struct. Dyn. 10:813-821), by Lanczos with full orthogonalisation: the shares of the Ritz values have the
 * moments of the distribution of inertia over squared periods. Wind acts as a dead load. */
enum wf_status wf_modes_sway(struct wf_beam *b, const double to[3], const double *width, size_t bands,
                             struct wf_modes_sway *out, double *shape, struct wf_err *e);

/* Generalised Greenhill factor: the multiple of the weight (gravity of `l`, wood, burden, point masses) at
 * which the unloaded shape, prestressed by that weight, loses its stiffness (linear buckling; wind and other
 * loads are omitted). For an upright stem this is the exact bifurcation: Greenhill 1881, factor 7.8373 E I /
 * (w L^3) for a uniform one. Returned: *factor; INFINITY when the tree is stable at any multiple up to 1e6
 * (a hanging or weightless tree). */
enum wf_status wf_buckling(const struct wf_tree *t, const struct wf_loads *l,
                           const struct wf_solve_options *o, struct wf_arena *a, double *factor,
                           struct wf_err *e);
#endif
