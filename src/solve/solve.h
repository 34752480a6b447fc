/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_SOLVE_H
#define WF_SOLVE_SOLVE_H
/* Solvers are rows: a tree and its loads in, its bent shape and internal forces out. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The answer, one row a tree segment; the arrays belong to the arena it was made from. Vectors are global. */
struct wf_response {
    size_t n;
    double *end;  /* 3n: displacement of the segment's end [m]                         */
    double *turn; /* 3n: rotation vector of the segment's end [rad]                    */
    double *force0,
        *moment0; /* 3n: force and moment the upper part puts on the section at the segment's base [N, N m] */
    double *force1, *moment1;    /* 3n: the same just below the segment's end                  */
    double *tangent0, *tangent1; /* 3n: unit axis direction of the bent segment at base and end */
    double *load;                /* 3n: distributed load on the segment, summed [N]                   */
    double base_force[3], base_moment[3]; /* put on the ground, moment about the (first) base [N, N m] */
    double imbalance;   /* |base force - sum of loads on the bent shape| / largest load, and moments likewise:
                           the larger [-] */
    double load_factor; /* share of the load carried: 1 when converged                       */
    size_t iterations, steps;
    bool small_deflection; /* linear answer: limits of validity apply                      */
};
enum wf_status wf_response_alloc(struct wf_response *r, size_t n, struct wf_arena *a, struct wf_err *e);

struct wf_solve_options {
    double tolerance;      /* relative accuracy asked of a converged answer, default 1e-9 */
    double mesh_tolerance; /* relative error accepted from the mesh, default 1e-6; 0 = one element a row */
    size_t iterations_max; /* per load step, default 100 */
    bool inextensible, shear_flexible; /* beam models K / EB (default) / SR */
    double shear_factor;               /* k in k G A; 0 = Cowper 1966, circular sections */
    size_t threads; /* processors for solutions that do not depend on each other, default 1; 0: all; the
                     * answers are the same */
    double root_stiffness[2]; /* rotational springs of the root plate about x and y [N m/rad]; 0 = clamped */
};
void wf_solve_options_default(struct wf_solve_options *o);

struct wf_solver {
    const char *name;  /* "beam", "chain", "chain-as-printed", "linear" */
    const char *title; /* for reports                                   */
    const char *source, *validity;
    bool small_deflection; /* answers void beyond 10 % of height or 15 deg  */
    bool as_printed;       /* reproduces a paper's formula, not physics     */
    enum wf_status (*solve)(const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *r,
                            struct wf_diag *d, struct wf_err *e);
};
/* All solvers (solvers.c); ends at NULL; the first is the default. */
extern const struct wf_solver *const wf_solvers[];
/* The row of that name; NULL when there is none. */
const struct wf_solver *wf_solver_named(const char *name);

/* Refuse what no solver can take: a tree wf_tree_check refuses, loads that are not finite or act on rows that
 * are not there. Returned: WF_EINPUT, each bad row a line in *d; with d NULL *e names the first. */
enum wf_status wf_solve_check(const struct wf_tree *t, const struct wf_loads *l, struct wf_diag *d,
                              struct wf_err *e);

/* Refuse sections that are not round, which `what` does not know. Returned: WF_EINPUT. */
enum wf_status wf_solve_check_round(const struct wf_tree *t, const char *what, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
