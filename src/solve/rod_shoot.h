/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_ROD_SHOOT_H
#define WF_SOLVE_ROD_SHOOT_H
/* The boundary-value problem of a tree of rods, by multiple shooting on the tree.
 *
 * Unknowns are position, rotation, force and moment at the base of every piece. Integrated to its end, each
 * piece must meet the bases of the pieces on it, and its force and moment must equal the sum of theirs and
 * of the loads at its end (Feng et al. 1999, eqs 4 and 5); at a free tip that sum is empty. Newton's
 * equations have the structure of the tree: from the tips down, the change of force and moment at a piece's
 * base is computed as a linear function of the change of its pose, a 6 x 6 block per piece; from the root up
 * the changes follow. Damping by the natural monotonicity test (Deuflhard 2004, Newton Methods for Nonlinear
 * Problems, sec. 3.3); a derivative is reused while convergence is fast enough. */
#include "solve/rod_integrate.h"
#include "solve/solve.h"

struct wf_rod_node { /* one a piece */
    struct wf_rod_pose pose;
    struct wf_rod_wrench wrench; /* at the piece's base */
    double tilt[3];              /* tilt of the root plate, for pieces on the ground */
};
struct wf_rod_end { /* where the integration of a piece arrives */
    struct wf_rod_pose pose;
    struct wf_rod_wrench wrench;
    double tally[3];
};
struct wf_rod_block {
    double J[144];        /* derivative of the end by the base */
    double K[36], lu[36]; /* change of the base's wrench by its pose; factor of the 6x6 block */
    size_t order[6];      /* its row order */
    double root[9];       /* for pieces on a root plate: change of tilt by moment */
};

struct wf_rod {
    const struct wf_tree *tree;
    struct wf_loads loads; /* a copy of the caller's */
    const struct wf_solve_options *options;
    struct wf_rod_integrator integrator;
    size_t n;
    struct wf_rod_piece *piece;
    int32_t *last; /* per row: its last piece */
    struct wf_rod_node *node, *trial;
    struct wf_rod_end *end;
    struct wf_rod_block *block;
    double (*off)[12];                  /* residual: pose against the end below, wrench at the end */
    double (*step)[12];                 /* Newton step */
    double (*next)[12];                 /* next (simplified) Newton step, with the same derivative */
    double (*tilt)[3], (*next_tilt)[3]; /* of the root plates */
    double (*change)[6];                /* change of the ends' poses, while solving */
    int32_t *first_point, *next_point;  /* per row, per load: point loads of a row; -1 ends */
    double size;                        /* length that scales positions [m] */
    size_t iterations, steps;
    const char *fault;
};

/* Cut the tree into pieces and start from its unloaded shape. `r` must not move. wf_rod_done frees what is
 * not in the arena. Errors: WF_EUSAGE (point load on a row that does not exist), WF_ENOMEM. */
enum wf_status wf_rod_init(struct wf_rod *r, const struct wf_tree *t, const struct wf_loads *l,
                           const struct wf_solve_options *o, bool printed, struct wf_arena *a,
                           struct wf_err *e);
void wf_rod_done(struct wf_rod *r);

/* Newton's method at the present loads from the present nodes. Returned: true with ends that belong to the
 * nodes; false when it stalled, with the nodes reached. */
bool wf_rod_newton(struct wf_rod *r);

/* External force and moment at the end of a piece that ends its row: point mass, dead and follower loads.
 * Given: rotation q of the end. Returned: added to *w; by_spin (36, may be NULL): derivative by (position,
 * spin), added. */
void wf_rod_end_load(const struct wf_rod *r, size_t piece, const double q[4], struct wf_rod_wrench *w,
                     double *by_spin);
#endif
