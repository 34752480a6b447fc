/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_EXPERIMENT_H
#define WF_FIT_EXPERIMENT_H
/* Trees, loads, sensors and measured data: the input of a fit. */
#include "base/units.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/firm.h"
#include "solve/solve.h"
#include "wind/wind.h"
#include <stdbool.h>
#include <stdint.h>

struct wf_species;

enum wf_sensor_kind {
    WF_SENSOR_DEFLECTION, /* horizontal displacement of the axis along an azimuth [m]           */
    WF_SENSOR_HORIZONTAL, /* its horizontal displacement, in any direction [m]                  */
    WF_SENSOR_VERTICAL,   /* its vertical displacement, up positive [m]                         */
    WF_SENSOR_TILT,       /* inclination of the axis towards an azimuth [rad]                   */
    WF_SENSOR_STRAIN,     /* mean strain of a surface fibre over a gauge length [-]             */
    WF_SENSOR_EXTENSION,  /* change of that gauge length [m]                                    */
    WF_SENSOR_REACH,      /* horizontal coordinate of the axis along an azimuth, from the stem's base [m] */
    WF_SENSOR_RISE,       /* its height above the stem's base [m]                               */
    WF_SENSOR_MOMENT,     /* overturning moment on the ground towards an azimuth [N m]          */
    WF_SENSOR_FREQUENCY,  /* natural frequency of free sway [Hz]                                */
    WF_SENSOR_DAMPING,    /* damping ratio of free sway [-]                                     */
    WF_SENSOR_KINDS
};
struct wf_sensor_row {
    const char *name;
    enum wf_dimension dimension;
    const char *unit; /* shown in reports */
    double factor;    /* SI to that unit  */
    bool placed;      /* needs a height   */
};
extern const struct wf_sensor_row wf_sensor_rows[WF_SENSOR_KINDS];

struct wf_fit_sensor {
    const char *name;
    enum wf_sensor_kind kind;
    double height, azimuth, gauge; /* [m], [rad], [m]; NAN where the kind has none             */
    bool along;                    /* height counts along the axis from its base               */
    bool lowest;                   /* a frequency is that of the lowest mode, not of the sway  */
    double sigma, sigma_share;     /* uncertainty: absolute [SI] and as a share of the value   */
    bool estimated;                /* sigma is not given: estimated from the residuals         */
    bool offset, drift;            /* has nuisance parameters: zero, its change with time      */
    int32_t row, low_row;          /* rows at whose ends it is; -1: the ground                 */
};

enum wf_fit_load { WF_FIT_FREE, WF_FIT_PULL, WF_FIT_WIND, WF_FIT_WEIGHT };
struct wf_fit_state {
    double load; /* rope force [N], wind speed [m/s]; under weight alone the sensors' position along the axis
                    [m] */
    double time; /* since the first row of the data [s]  */
    size_t rows; /* rows of the data averaged in it      */
    int32_t row; /* under weight alone: row of all sensors in this state; below -1: their own rows */
};

struct wf_fit_test {
    const char *name;
    size_t tree;
    enum wf_fit_load load;
    int32_t pull_row;          /* row to whose end the strap is fixed                       */
    double azimuth, elevation; /* of the pull; elevation above the horizontal [rad]         */
    bool anchored;             /* the rope's direction follows the strap to `anchor`        */
    double anchor[3];          /* [m]                                                       */
    struct wf_wind wind;
    double speed_up;                   /* wind speed at the tree over the given one [-]; 0: 1 */
    double air_density, air_viscosity; /* [kg m-3], [m2/s]; 0: those of the tree's loads    */
    bool from_rest;                    /* readings are zero under weight alone, without wind and pull      */
    size_t sensors, states;
    struct wf_fit_sensor *sensor;
    struct wf_fit_state *state;
};

/* Parts of a standing tree that were stiffened, because they would not stand with a wood or root that was
 * tried. They stay so. */
struct wf_fit_props {
    double *raise;      /* per row: factor on E and G */
    struct wf_firm all; /* all of them, with the smallest load factor found */
    size_t times;       /* how often parts were stiffened */
};

struct wf_fit_tree {
    const char *name;
    const char *file; /* model or measured tree that it is made from; NULL: none */
    const struct wf_species *species;
    struct wf_tree tree; /* one element a row                                           */
    struct wf_loads loads;
    struct wf_solve_options options; /* include the root stiffness                      */
    struct wf_fit_props *props;      /* NULL: the tree does not stand, or has no weight */
    double height, size;             /* vertical; length of a stem model's axis, else the height [m] */
};

/* One measured number. */
struct wf_fit_datum {
    size_t test, state, sensor;
    double value, sigma; /* [SI of the sensor's kind] */
    double weight;       /* 1; in a resampled data set 0, 1, 2, ... */
    size_t line;         /* of its file, first of those averaged; 0: given in the calibration */
};

struct wf_experiment {
    size_t trees, tests, data;
    struct wf_fit_tree *tree;
    struct wf_fit_test *test;
    struct wf_fit_datum *datum; /* by test, state, sensor */
};

/* A position on the main axis. */
struct wf_fit_place {
    double at; /* above the first base, or from it along the axis [m] */
    bool along;
};
/* Divide the tree's rows so that every row is at most `length` long and a row of the main axis ends at each
 * of n places; row[k] = that row, -1 for places within 1 mm of the base. Errors: WF_EINPUT for a place beyond
 * the stem, WF_ENOMEM. Properties are linear along a row, so division does not change the tree. */
enum wf_status wf_fit_divide(struct wf_tree *t, double length, const struct wf_fit_place *place, size_t n,
                             int32_t *row, struct wf_arena *a, struct wf_err *e);
#endif
