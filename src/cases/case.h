/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_CASE_H
#define WF_CASES_CASE_H
/* Validation cases as data (docs/validation-cases.md). A case states what a solver must compute; a file
 * holds one case or several. Each names its source, a structure, loads, solvers and wanted values. */
#include "base/arena.h"
#include "base/err.h"
#include "cases/words.h"
#include "load/drag.h"
#include "solve/solve.h"
#include "wind/gust_factor.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum wf_case_kind {
    WF_CASE_CLOSED_FORM,
    WF_CASE_PUBLISHED,
    WF_CASE_COMPUTED_REFERENCE,
    WF_CASE_FIELD,
    WF_CASE_REGRESSION, /* detects changes; never counted as evidence */
    WF_CASE_KIND_COUNT
};

enum wf_place_kind {
    WF_PLACE_NONE,
    WF_PLACE_BASE,
    WF_PLACE_TIP,  /* end of the last row of a cantilever or arc */
    WF_PLACE_NODE, /* end of the branch that leads to this node */
    WF_PLACE_ROW,  /* end of the row with this id */
    WF_PLACE_AT,   /* share of the length of a cantilever, from its base */
    WF_PLACE_POINT /* of a flow field */
};
struct wf_place {
    enum wf_place_kind kind;
    int64_t id;
    double share, point[3];
    int32_t row; /* set when the case is built; -1 = the base */
};

struct wf_case_load {
    struct wf_place at;
    bool follower, moment;
    double value[3]; /* [N] or [N m] */
    size_t line;
};
struct wf_case_mass {
    struct wf_place at;
    double mass; /* [kg] */
    size_t line;
};
struct wf_case_node {
    int64_t id;
    double x[3];
    size_t line;
};
struct wf_case_branch {
    int64_t from, to;
    double radius[2];
    size_t line;
};

struct wf_quantity;
struct wf_want {
    const struct wf_quantity *quantity;
    struct wf_place at;
    size_t number;      /* of a mode, from 1 */
    const char *name;   /* of a fitted parameter */
    int component;      /* 0..2 = x, y, z; 3 = norm; -1 = all three */
    double value[3];    /* SI; NAN = not given; scalars use value[0] */
    double tolerance;   /* NAN = the case's */
    bool absolute;      /* tolerance in the quantity's SI unit; else relative to the wanted value (vector: its
                           norm) */
    const char *unit;   /* as written; "" when dimensionless */
    double unit_factor; /* SI per unit, for printing */
    size_t line;
};

enum wf_case_shape {
    WF_SHAPE_NONE,
    WF_SHAPE_CANTILEVER,
    WF_SHAPE_ARC,
    WF_SHAPE_BRANCHES,
    WF_SHAPE_TREE,
    WF_SHAPE_FLOW,
    WF_SHAPE_GUST, /* a code's gust factor, without a tree (cases/gusts.h) */
    WF_SHAPE_FIT   /* a calibration, run by wf_case_fit */
};
enum wf_case_model { WF_MODEL_K, WF_MODEL_EB, WF_MODEL_SR };
enum { WF_CASE_KEYS_MAX = 96, WF_CASE_SOLVERS_MAX = 6, WF_CASE_PIECES_MAX = 8 };

/* Gusts: of a code's factor, and of a stem in a stand. */
struct wf_case_gust {
    const struct wf_gust_rule *rule;
    const struct wf_category *terrain;
    double height, breadth, frequency, damping;              /* [m], [m], [Hz], of critical [-] */
    double basic_wind, mean_wind;                            /* as in struct wf_gust_case: open, mean [m/s] */
    double crown_depth, crown_width, crown_drag, crown_mass; /* [m], [m], [-], [kg] */
    double strength;                                         /* [Pa] */
    double displacement, roughness;                          /* of the stand [m] */
    double spacing, edge_distance, gap;                      /* as in wf_stand_gust [m] */
};

/* One case; every number in SI (or consistent units when nondimensional), NAN = not given. */
struct wf_case {
    const char *file, *name, *title, *source, *note;
    size_t line;                    /* of its `case` line, or 1 */
    bool faulty;                    /* one of its lines has an error */
    size_t given[WF_CASE_KEYS_MAX]; /* line a key was given on; 0 = not */
    int kind, model, nondimensional;
    enum wf_case_shape shape;
    double length, direction[3];
    double rows;
    double arc[2], arc_from[3],
        arc_towards[3]; /* radius [m], angle [rad]; root tangent, direction it bends towards */
    const char *tree_file;
    struct wf_list nodes, branches;
    double radius[2], inner[2], taper, taper_power;
    double youngs, poisson, shear, density;
    double ea, ga, ei, gj, mass_per_length;
    double shear_factor, spring[2];
    struct wf_list loads, masses;
    double line_load[3], line_by_radius[3];
    const struct wf_axis_drag_law *axis_drag; /* NULL: not given */
    const struct wf_streamline_law *streamlining;
    struct wf_law_values axis_drag_par, streamlining_par;
    double crown_area, air_viscosity; /* still-air crown area times its Cd per length [m]; [m2/s] */
    double wind[3], air_density, drag, cauchy, gravity, weight_parameter;
    const char *fit_calibration; /* name of its file, beside the case */
    const char *fit_free;        /* free parameters; NULL: those of the calibration */
    double data_sets,
        noise; /* number of synthetic data sets and their noise in sigmas; NAN: the calibration's data, 1 */
    struct wf_case_gust gust;
    const char *flow;
    double flow_speed, flow_radius, flow_circulation, flow_strength, flow_segment[2];
    const struct wf_solver *solver[WF_CASE_SOLVERS_MAX];
    size_t solvers;
    double mesh_tolerance, accuracy, tolerance;
    size_t piece[WF_CASE_PIECES_MAX], pieces; /* parts per row on each mesh, for the order of convergence */
    struct wf_list wants;
};
#endif
