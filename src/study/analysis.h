/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_ANALYSIS_H
#define WF_STUDY_ANALYSIS_H
/* One tree in a list of winds: wind -> load -> solve -> fail, and the critical wind speed. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "fail/fail.h"
#include "load/load.h"
#include "load/scene.h"
#include "solve/solve.h"
#include "wind/wind.h"
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_model;
struct wf_species;

/* Loads and displacements of the segments, as columns. */
struct wf_figures {
    double *projected_area; /* of axis and crown across the wind, bent shape [m2] */
    double *drag, *lift;    /* along and across the wind [N]                      */
    double *deflection;     /* of the end, distance from the unloaded position [m]   */
    double *slope;          /* of the end, angle between the axis and its unloaded direction [rad] */
};

struct wf_at_speed {
    double speed;          /* at reference height [m/s] */
    bool interpolated;     /* in curves: between the speeds that were solved; sections (rows) are then -1 */
    enum wf_status status; /* WF_OK, or why there is no result (response.load_factor: load reached) */
    struct wf_response response;
    struct wf_breakage breakage;
    struct wf_worst worst[WF_CRITERIA][WF_SCOPES];
    struct wf_figures figures;
    double drag, lift, weight;      /* whole tree [N] */
    double tip_deflection;          /* horizontal and vertical together [m], of the stem's highest point */
    double tip_deflection_share;    /* of tree height [-] */
    double tip_angle;               /* between unloaded and loaded axis at the stem tip [rad] */
    double base_shear, base_moment; /* [N], [N m] */
};

/* Wind speed and section at which a tree, or a part of it, fails by a criterion. */
struct wf_break {
    struct wf_critical critical;
    struct wf_at_speed at; /* totals at the critical speed; speed NAN where there is none */
    int32_t row;           /* governing section at the critical speed, -1 none            */
    double height;         /* its height above ground on the unbent tree [m]              */
};

/* Measured: memory of one solution for a row of the tree (two meshes of the beam solver, the finer of about
 * two elements a row). */
enum { WF_SOLUTION_BYTES = 4500 };

struct wf_analysis;
/* Range and bound of the searches for critical wind speeds and of the curves. */
struct wf_search {
    double speed_max; /* highest speed searched [m/s]; where the tree fails at a given speed above it, the
                         search goes on to the lowest such speed */
    double beyond; /* at least this many times the highest given speed is searched; 0: speed_max alone [-] */
    double
        seconds; /* processor time after which the search, and again the curves, end [s]; INFINITY: no end */
    /* Called when the given speeds are solved and the searches have not begun; NULL: not called. */
    void (*solved)(const struct wf_analysis *an, void *context);
    void *context;
};
/* Up to 60 m/s, no lower than any 10-min mean on record, or 1.2 times the highest given speed where that is
 * more; without a bound. */
void wf_search_default(struct wf_search *s);

struct wf_directions;
struct wf_wetted;
struct wf_analysis {
    const struct wf_species *species;
    const struct wf_model *model;
    const struct wf_solver *solver;
    struct wf_scenario scenario;
    struct wf_search search; /* of critical speeds, also of those by direction */
    struct wf_tree tree;
    struct wf_loads loads;
    struct wf_wind wind;
    size_t n;
    struct wf_at_speed *at; /* results at the given speeds                     */
    size_t sweep_n;
    struct wf_at_speed *sweep; /* totals for curves: speeds from 0, at first four times closer; the given
                                  speeds alone where the time for them was used up */
    struct wf_break breaks[WF_CRITERIA][WF_SCOPES];
    const struct wf_wetted *wetted;         /* beside the dry tree (study/wetted.h); NULL: no water        */
    const struct wf_directions *directions; /* results by wind direction; NULL: not computed */
    double tallness;                        /* height [m] */
    struct wf_diag *diag;                   /* validity warnings                               */
};

/* Grow the tree and make its wind field and loads; nothing is solved. Given: *an with species, model,
 * scenario and solver. Returned: tree, tallness, wind (at speed 0) and loads of *an. */
enum wf_status wf_analysis_set_up(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e);

/* One wind speed at the reference height [m/s] of an analysis after wf_analysis_set_up; its columns are not
 * kept: only the totals and the worst sections of *out are valid afterwards. Returned: WF_OK and *out; where
 * the solver finds no equilibrium (WF_EUNSTABLE, WF_ENOCONV) also WF_OK with that status in out->status, the
 * totals NAN and the load factor in out->response; another code when the run must end. */
enum wf_status wf_speed_totals(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                               struct wf_at_speed *out, struct wf_err *e);
/* The row that ends highest on level 0. */
size_t wf_tip_row(const struct wf_tree *t);

/* Solutions at single speeds, none at first. NULL: not enough memory. */
struct wf_known;
struct wf_known *wf_known_take(struct wf_arena *a);

/* Wind speed at which each part of the tree fails by each criterion. Given: an analysis after
 * wf_analysis_set_up with its search, in the direction of its wind. The whole tree and the stem alone are
 * searched; where no branch has a known resistance, the stem's result is that of the whole tree. The
 * branches' result is the tree's where they fail first or nothing fails, else WF_CRITICAL_UNSEARCHED, which
 * is also the outcome of a search that its bound ended. All searches share their solutions, which *known
 * gains. */
enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_known *known, struct wf_break (*out)[WF_SCOPES],
                                  struct wf_err *e);

/* Totals for curves: an->sweep, at speeds from 0 beyond the given and the critical speeds, after
 * wf_analysis_breaks with *known. The solutions at hand are nodes; further rows are solved until the nodes
 * predict each other; the other rows are interpolated by cubics of logarithms. Where their time is used up,
 * the given speeds alone, with a warning search-ended. */
enum wf_status wf_analysis_sweep(struct wf_analysis *an, const struct wf_solve_options *o,
                                 const struct wf_known *known, struct wf_arena *a, struct wf_diag *d,
                                 struct wf_err *e);

/* Does the tree have a row with the wood of that level? Given: an analysis after wf_analysis_set_up. */
bool wf_analysis_grown(const struct wf_analysis *an, size_t level);

/* Given: species, model, scenario, search (NULL: the default), solver, options, n speeds [m/s]. Returned:
 * WF_OK and *out, even where single speeds have no result (their status is the reason); another code when
 * nothing could be computed. */
enum wf_status wf_analyze(const struct wf_species *sp, const struct wf_model *m, const struct wf_scenario *sc,
                          const struct wf_search *search, const struct wf_solver *solver,
                          const struct wf_solve_options *o, const double *speeds, size_t n,
                          struct wf_arena *a, struct wf_diag *d, struct wf_analysis *out, struct wf_err *e);

/* The last step of an analysis, in limits.c: check it against the validity of its laws and methods.
 * Given: an analysis complete except for its warnings. Returned: the warnings added to `d`. */
void wf_limits_check(const struct wf_analysis *an, struct wf_diag *d);

#ifdef __cplusplus
}
#endif
#endif
