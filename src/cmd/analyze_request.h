/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ANALYZE_REQUEST_H
#define WF_CMD_ANALYZE_REQUEST_H
/* Options of windfirm analyze and compare, and what they mean for the library. The rows, wf_analyze_options,
 * are declared in cmd/commands.h. */
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "out/results.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include "study/directions.h"
#include "study/interval.h"
#include "study/preset.h"

struct wf_analyze_options {
    struct wf_args args;
    struct wf_tree_asked tree;
    struct wf_speeds wind;
    struct wf_averaging averaging;   /* with the climate */
    struct wf_profile_words profile; /* with the map of the ground */
    struct wf_peak_asked peak;
    struct wf_anchorage_asked anchorage;
    const char *output, *solver, *preset, *shelter, *branch_strength;
    const char *directions, *at; /* NULL: not given                                */
    size_t threads;
    double azimuth, north;          /* [rad]                                     */
    double temperature, altitude;   /* [K], [m]                                  */
    double air_density;             /* [kg m-3]; NAN: from the two above         */
    double search_to, search_time;  /* [m/s], NAN: the library's default; [s]    */
    double mesh_tolerance;          /* [-]                                       */
    size_t samples, seed;           /* of the interval */
    const char *weight_stress;      /* "total" or "change"                        */
    double snow, snow_density, ice; /* [m], [kg m-3], [m]; NAN: not given        */
    double winter_wind;             /* share of the wind named [-] */
    struct wf_water_asked water;
    double root_stiffness, speed_up;              /* [N m rad-1]; [-]; NAN: not given          */
    double branches_from;                         /* [m]                                       */
    double corridor, corridor_towards, tip_angle; /* [m], [rad], [rad]; NAN: not given */
    double node_spacing;                          /* [m]; NAN: not given */
    bool unions;
    const char *guys, *cables, *rods; /* NULL: none */
    /* beside the tree as it stands; NULL, NAN: not given */
    const char *scenarios, *remove, *root_loss; /* "40 %" or "30deg:120deg:40 %" */
    const char *reduce;                         /* "20 %" or "3 m" */
    double thin, cavity_growth;                 /* [-], [m] */
    bool leaf_off;
    struct wf_pages pages;
    struct wf_job job;
};

/* The options, converted to structs of the library. */
struct wf_analyze_request {
    struct wf_scenario scenario;
    struct wf_search search;
    struct wf_interval_request interval; /* samples 0: none */
    struct wf_solve_options solve;
    const struct wf_solver *solver;
    const struct wf_preset *preset;
    struct wf_directions_request directions; /* n = 0: none */
};

/* Convert the options to a request, but for what is beside the tree as it stands (cmd/scenarios.h). Files are
 * read: a measured profile, a climate, a table of anchorage;
 * their mistakes are in `d`, any other error is in `e`. */
enum wf_status wf_analyze_request_read(const struct wf_analyze_options *o, struct wf_arena *a,
                                       struct wf_diag *d, struct wf_analyze_request *out, struct wf_err *e);

/* Files that a run has read. */
struct wf_inputs {
    struct wf_arena *arena;
    size_t n;
    struct wf_input_file *item; /* with room for species, the model, the study or the table, and */
};
enum { WF_OPTION_FILES = 12 + 2 * WF_CAVITIES_MAX };
/* One more. Errors: WF_EMISSING, WF_ENOMEM. */
enum wf_status wf_inputs_note(struct wf_inputs *in, const char *role, const char *path, struct wf_err *e);
/* Those that options of a request name, but for the tree and the species: cavities with their rays, the
 * crown's outline, winds, peak loads, anchorage, ground. Errors: as above. */
enum wf_status wf_analyze_files_note(const struct wf_analyze_options *o, const struct wf_analyze_request *q,
                                     const struct wf_model *m, struct wf_inputs *in, struct wf_err *e);
#endif
