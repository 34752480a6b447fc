/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_SOLVE_H
#define WF_SOLVE_SOLVE_H
/* The solver interface: a tree and its loads in, its deformed shape and internal forces out. Each solver is
 * a row (solve/solvers.h). */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The response, one row per tree segment; the arrays are in the arena of wf_response_alloc. Vectors are in
 * global axes. */
struct wf_response {
    size_t n;
    double *end;                 /* 3n: displacement of the segment's end [m] */
    double *turn;                /* 3n: rotation vector of the segment's end [rad] */
    double *force0, *moment0;    /* 3n: force and moment that the upper part exerts on the section at the
                                    segment's base [N, N m] */
    double *force1, *moment1;    /* 3n: the same just below the segment's end */
    double *tangent0, *tangent1; /* 3n: unit axis direction of the deformed segment at base and end */
    double *load;                /* 3n: distributed load on the segment, summed [N] */
    double base_force[3], base_moment[3]; /* exerted on the ground, moment about the (first) base [N, N m] */
    double imbalance; /* |base force - sum of loads on the deformed shape| / largest load, likewise for
                         moments; the larger of both [-] */
    double link[WF_LINKS_MAX]; /* forces in links; negative: a rod pushes [N] */
    double load_factor;        /* share of the load carried: 1 when converged */
    size_t iterations, steps;
    bool small_deflection; /* linear solution: limits of validity apply */
};
/* Allocate the arrays of a response of n rows, zeroed, in the arena. Errors: WF_ENOMEM. */
enum wf_status wf_response_alloc(struct wf_response *r, size_t n, struct wf_arena *a, struct wf_err *e);

/* Turn of the axis at the end of a row from its unloaded direction, without twist [rad]. */
double wf_response_slope(const struct wf_tree *t, const struct wf_response *r, size_t row);

struct wf_solve_options {
    double tolerance;      /* relative accuracy of a converged solution, default 1e-9 */
    double mesh_tolerance; /* error accepted from the mesh, of positions relative to the largest displacement
                              and of loads relative to the wind's, default 1e-6; 0 = one element per row */
    size_t iterations_max; /* per load step, default 100 */
    bool inextensible, shear_flexible; /* beam models K / EB (default) / SR */
    double shear_factor;               /* k in k G A; 0 = Cowper 1966, circular sections */
    size_t threads; /* threads for independent solutions, default 1; 0: one per processor; results do not
                       depend on it */
    double root_stiffness[2]; /* rotational springs of the root plate about x and y [N m/rad]; 0 = clamped */
};
/* Defaults as stated above: tolerances 1e-9 and 1e-6, model EB, clamped, one thread. */
void wf_solve_options_default(struct wf_solve_options *o);

struct wf_solver {
    const char *name;  /* "beam", "chain", "chain-as-printed", "linear" */
    const char *title; /* for reports */
    const char *source, *validity;
    bool small_deflection; /* not valid beyond 10 % of height or 15 deg */
    bool as_printed;       /* reproduces a paper's formula, not physics */
    bool unmeshed;         /* takes the segments as they are: mesh_tolerance has no effect */
    bool tracked;          /* wf_track_solve gives its solutions */
    bool clamped;          /* holds the base: root_stiffness has no effect */
    bool ties;             /* takes cables (struct wf_tie) */
    bool stands; /* takes a standing tree (struct wf_tree_standing); others, its stress-free shape */
    enum wf_status (*solve)(const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *r,
                            struct wf_diag *d, struct wf_err *e);
};
/* All solvers (solvers.c); ends at NULL; the first is the default. */
extern const struct wf_solver *const wf_solvers[];
/* The row of that name; NULL when there is none. */
const struct wf_solver *wf_solver_named(const char *name);

/* Check what every solver needs: a tree that passes wf_tree_check, finite loads that act on existing rows.
 * Errors: WF_EINPUT, each bad row an error in *d; with d NULL *e names the first. */
enum wf_status wf_solve_check(const struct wf_tree *t, const struct wf_loads *l, struct wf_diag *d,
                              struct wf_err *e);

/* Refuse a tree with sections that are not round, on behalf of the solver `what` (named in the message).
 * Errors: WF_EINPUT. */
enum wf_status wf_solve_check_round(const struct wf_tree *t, const char *what, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
