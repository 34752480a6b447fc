/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SPEED_H
#define WF_STUDY_SPEED_H
/* One tree at one wind speed: wind -> load -> solve -> fail -> figures; and the struct of an analysis. */
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

struct wf_anchorage;
struct wf_model;
struct wf_peak;
struct wf_species;

/* Loads and displacements of the segments, as columns. */
struct wf_figures {
    double *projected_area; /* of axis and crown across the wind, bent shape [m2] */
    double *drag, *lift;    /* along and across the wind [N]                      */
    double *deflection;     /* of the end, distance from the unloaded position [m]   */
    double *slope;          /* of the end, angle between the axis and its unloaded direction [rad] */
};

/* Totals of the state in the mean wind alone, without gusts; NAN: no equilibrium. */
struct wf_steady {
    double drag, tip_deflection, top_deflection, tip_angle, base_shear, base_moment; /* as wf_at_speed */
};

/* One wind speed. The results are those of the peak of the load (study/peak.h), of stem and branches each at
 * its own peak; with the method 'mean' they are those of the mean wind. */
struct wf_at_speed {
    double speed;          /* at reference height, mean wind [m/s] */
    bool interpolated;     /* in curves: between the speeds that were solved; sections (rows) are then -1 */
    enum wf_status status; /* WF_OK, or why there is no result (response.load_factor: load reached) */
    struct wf_response response;
    struct wf_breakage breakage;
    struct wf_worst worst[WF_CRITERIA][WF_SCOPES];
    struct wf_figures figures;
    double drag, lift, weight;      /* whole tree [N] */
    double tip_deflection;          /* horizontal and vertical together [m], of the stem's highest point */
    double tip_deflection_share;    /* of tree height [-] */
    double top_deflection;          /* of the crown's top (wf_top_row) [m]; NAN where interpolated */
    double tip_angle;               /* between unloaded and loaded axis at the stem tip [rad] */
    double base_shear, base_moment; /* [N], [N m] */
    double tie[WF_TIES_MAX];        /* forces in the cables that hold the tree [N] */
    double link[WF_LINKS_MAX];      /* in those between two points of it, at the peak of the load of stem or
                                       branches, the larger; negative: a rod pushes [N] */
    struct wf_steady steady;        /* of the given speeds; of others unknown */
};

/* Wind speed and section at which a tree, or a part of it, fails by a criterion. */
struct wf_break {
    struct wf_critical critical;
    struct wf_at_speed at; /* totals at the critical speed; speed NAN where there is none */
    int32_t row;           /* governing section at the critical speed, -1 none            */
    double place;          /* where on it, from its base (0) to its end (1) [-]           */
    double height;         /* its height above ground on the unbent tree [m]              */
};

/* Measured: memory of one solution for a row of the tree (two meshes of the beam solver, the finer of about
 * two elements a row). */
enum { WF_SOLUTION_BYTES = 4500 };

struct wf_analysis;
/* Solutions that the searches for critical speeds take in most trees: for the share that progress shows. */
enum { WF_SEARCH_SOLUTIONS = 12 };
/* Range and bound of the searches for critical wind speeds and of the curves. */
struct wf_search {
    double speed_max; /* highest speed searched [m/s]; where the tree fails at a given speed above it, the
                         search goes on to the lowest such speed */
    double beyond; /* at least this many times the highest given speed is searched; 0: speed_max alone [-] */
    double
        seconds; /* processor time after which the search, and again the curves, end [s]; INFINITY: no end */
    double branches_from; /* diameter from which branches are listed; thinner ones are twigs [m] */
    bool unions;          /* unions of such branches are listed (study/unions.h) */
    bool bare; /* of the stem alone the given winds, and the lowest in which it is lost: other criteria are
                  then WF_CRITICAL_UNSEARCHED; there are neither curves nor modes, nor columns of the given
                  winds */
    /* Called when the given speeds are solved and the searches have not begun; NULL: not called. */
    void (*solved)(const struct wf_analysis *an, void *context);
    void *context;
};
/* Up to 60 m/s, no lower than any 10-min mean on record, or 1.2 times the highest given speed where that is
 * more; without a bound. */
void wf_search_default(struct wf_search *s);

/* A tree in still air, in its state at rest. */
struct wf_still {
    struct wf_response response;
    struct wf_breakage breakage; /* stresses of its weight alone */
};

struct wf_directions;
struct wf_wetted;
struct wf_sway_modes;
struct wf_interval;
struct wf_assessment;
struct wf_unions;
struct wf_besides;
/* How a sample of a tree differs from the tree as measured. */
struct wf_misread {
    double radius, height; /* factors on all its radii; on all its lengths [-] */
    bool *doubtful;        /* rows in doubt of the tree as measured (struct wf_tree), also of the sample */
};
/* Forces of what holds the tree in the wind in which it is lost; NAN: there is none, or they are not known.
 */
struct wf_held {
    double tie[WF_TIES_MAX], link[WF_LINKS_MAX]; /* as struct wf_at_speed [N] */
};
struct wf_analysis {
    const struct wf_species *species;
    const struct wf_model *model;
    const struct wf_solver *solver;
    struct wf_scenario scenario;
    struct wf_search search;          /* of critical speeds, also of those by direction */
    const struct wf_misread *misread; /* of the tree that is grown; NULL: none */
    struct wf_tree tree;
    struct wf_loads loads;
    struct wf_wind wind;
    const struct wf_branch_strength *branch_strength; /* what branches bear (fail/fail.h) */
    const struct wf_peak *peak;                       /* by study/sway.h; NULL: the load of the mean wind */
    const struct wf_still *still; /* by study/rest.h: of a standing tree, and where the scenario takes the
                                     weight off the stresses; NULL: not computed */
    const struct wf_sway_modes *modes;    /* the lowest in still air (study/sway.h); NULL: not computed */
    const struct wf_anchorage *anchorage; /* fail/anchorage.h; by wf_analysis_set_up */
    size_t n;
    struct wf_at_speed *at; /* results at the given speeds                     */
    size_t sweep_n;
    struct wf_at_speed *sweep; /* totals for curves: speeds from 0, at first four times closer; the given
                                  speeds alone where the time for them was used up */
    struct wf_break breaks[WF_CRITERIA][WF_SCOPES];
    const struct wf_wetted *wetted;         /* beside the dry tree (study/wetted.h); NULL: no water    */
    const struct wf_wetted *winter;         /* the same of snow and ice; NULL: none                    */
    const struct wf_directions *directions; /* results by wind direction; NULL: not computed */
    const struct wf_interval *interval;     /* how sure (study/interval.h); NULL: not computed */
    const struct wf_assessment *assessment; /* study/assessment.h; NULL: not specified */
    const struct wf_unions *unions;         /* where search.unions says so (study/unions.h); else NULL */
    const struct wf_besides *beside;        /* beside itself with something changed; NULL: nothing is */
    double cut;                             /* share of the crown that the scenario's removal took [-] */
    double branch_safety; /* `bare`: the least of the listed branches in the strongest given wind that has a
                             solution [-]; NAN: none */
    struct wf_held held;
    struct wf_given *given; /* what solutions at the given speeds leave; NULL: none */
    double tallness;        /* height [m] */
    struct wf_diag *diag;   /* validity warnings                               */
};

/* What solutions at given speeds leave for further ones: the states at the first of them, until it is closed,
 * and a mesh, in the arena. NULL: not enough memory. */
struct wf_given;
struct wf_beam_few; /* solve/beam.h */
struct wf_given *wf_given_open(struct wf_arena *a);
void wf_given_close(struct wf_given *g, struct wf_arena *a);      /* NULL is allowed */
const struct wf_beam_few *wf_given_few(const struct wf_given *g); /* NULL for NULL */

/* Given: an analysis whose tree, wind, loads, species, solver are set; a speed at the reference height [m/s];
 * what is known from other speeds, to which this is added (NULL: nothing). Returned: WF_OK and *out, its
 * columns in `a`; where the solver finds no equilibrium (WF_EUNSTABLE, WF_ENOCONV) also WF_OK with that
 * status in out->status, the totals NAN and the load factor in out->response; another code when the run must
 * end. */
enum wf_status wf_speed_solve(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                              struct wf_given *given, struct wf_arena *a, struct wf_diag *d,
                              struct wf_at_speed *out, struct wf_err *e);
/* One wind speed at the reference height [m/s] of an analysis after wf_analysis_set_up; its columns are not
 * kept: only the totals and the worst sections of *out are valid afterwards. Returned: WF_OK and *out; where
 * the solver finds no equilibrium (WF_EUNSTABLE, WF_ENOCONV) also WF_OK with that status in out->status, the
 * totals NAN and the load factor in out->response; another code when the run must end. */
enum wf_status wf_speed_totals(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                               struct wf_at_speed *out, struct wf_err *e);
/* As wf_speed_totals for n winds on one tree, given by their analyses, which differ in wind and air alone,
 * and their speeds. The beam solver solves eight at a time side by side (solve/beam_many.h): out[k] then
 * depends, within the mesh tolerance, on the others of its eight in the order given. */
enum wf_status wf_speed_totals_many(const struct wf_analysis *const *an, const double *speed, size_t n,
                                    const struct wf_solve_options *o, struct wf_at_speed *out,
                                    struct wf_err *e);
/* Clear the columns of a solution whose arena is freed; totals and worst sections stay. */
void wf_speed_drop_columns(struct wf_at_speed *at);

/* Copy what holds for branches from the state at the peak of their load: sections, worst places. */
void wf_speed_take_branches(const struct wf_analysis *an, const struct wf_at_speed *branches,
                            struct wf_at_speed *at);

struct wf_track; /* solve/track.h */
struct wf_track_start;
struct wf_speed_answers {
    struct wf_at_speed at, side; /* at the speed, and first-order at the speed plus `step`; without figures */
    double step;                 /* [m/s]; 0: there is no side */
    bool irregular;              /* as struct wf_tracked */
};
/* As wf_speed_totals, in one state, for a solver that can be tracked: `track` is one of the analysis' tree;
 * `near` says where it may start, its share is not looked at (NULL: by the track itself). Columns of the
 * answers are in `a`. */
enum wf_status wf_speed_track(const struct wf_analysis *an, enum wf_part part, struct wf_track *track,
                              double speed, const struct wf_track_start *near, struct wf_arena *a,
                              struct wf_speed_answers *out, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
