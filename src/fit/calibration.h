/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_CALIBRATION_H
#define WF_FIT_CALIBRATION_H
/* A calibration (YAML file): trees, tests on them, sensors and free parameters. */
#include "base/err.h"
#include "base/yaml.h"
#include "fit/experiment.h"
#include "load/scene.h"

struct wf_calibration_tree {
    const char *name, *species, *model, *qsm, *joint;
    const char *tree_id;                       /* of a table of several trees; NULL: not given */
    size_t force, cap_children;                /* index in no, yes: as the options of an import */
    double leaf_area, root_stiffness, gravity; /* [m2], [N m/rad]: NAN clamped, [m s-2] */
    const char *rest; /* "as-drawn", "stress-free"; NULL: a measured tree as drawn, a model as it says */
    double scanned_leaf_area; /* on the day of the scan [m2]; NAN: leaf_area */
};
struct wf_calibration_sensor {
    const char *name, *column, *unit, *sigma, *value, *group;
    const char *mode; /* "sway", "lowest"; NULL: not given, sway */
    enum wf_sensor_kind kind;
    double height, along, azimuth, gauge, sigma_share; /* NAN: not given */
    size_t sign;                                       /* index in +, -  */
    size_t offset, drift;                              /* index in no, yes */
};
struct wf_calibration_pull {
    const char *column, *unit;
    double height, azimuth, elevation, anchor_distance, anchor_height; /* [m], [rad], [m] */
    double from, to;                                                   /* shares of the largest force */
    size_t loads;
    double *load; /* for planning [N] */
    bool given;
};
struct wf_calibration_wind {
    const char *column, *unit;
    struct wf_profile_words profile;           /* its file as named in the calibration */
    double azimuth;                            /* [rad] */
    double temperature, altitude, air_density; /* [K], [m], [kg m-3]; NAN: not given */
    double speed_up, north;                    /* exposure of the site [-], NAN: not given; [rad] */
    const char *dem, *at; /* terrain file as named in the calibration; "x,y" of the tree on it */
    struct wf_yaml_mark profile_file_place, dem_place; /* of these keys in the calibration file */
    size_t speeds;
    double *speed; /* for planning [m/s] */
    bool given;
};
struct wf_calibration_sway {
    const char *column, *mode; /* mode: as of a sensor */
    double azimuth;            /* of the mode; NAN: any */
    bool given;
};
struct wf_calibration_test {
    const char *name, *tree, *data, *time, *along;
    size_t rows_n;
    struct wf_yaml_pair *rows; /* only rows with this text in this column are used */
    struct wf_calibration_pull pull;
    struct wf_calibration_wind wind;
    struct wf_calibration_sway sway;
    size_t zero; /* index in rest, unloaded */
    size_t points;
    double rate;                 /* of rows without a time column [1/s]; NAN: not known */
    const char *missing, *dates; /* missing marks, order of dates; NULL: not said */
    double after, until;         /* [s] from the first row */
    size_t sensors;
    struct wf_calibration_sensor *sensor;
};
struct wf_calibration_free {
    const char *parameter, *start, *low, *high;
};
struct wf_calibration {
    const char *key, *name, *note, *source, *reference, *file;
    size_t trees, tests, frees;
    struct wf_calibration_tree *tree;
    struct wf_calibration_test *test;
    struct wf_calibration_free *free;
};
extern const struct wf_yaml_table wf_calibration_table;

/* The part of a test's wind scene that needs no file: profile, air, exposure where it is a number. It is
 * checked unless it has a measured profile, which is read later. Errors: as wf_scenario_words and
 * wf_scenario_check. */
enum wf_status wf_calibration_wind_scene(const struct wf_calibration_wind *w, struct wf_scenario *out,
                                         struct wf_err *e);

enum wf_status wf_calibration_read(const char *path, struct wf_arena *a, struct wf_calibration *out,
                                   struct wf_diag *d, struct wf_err *e);

/* Path of a file named in a calibration: "${WINDFIRM_REFERENCE}/..." is expanded from the environment; other
 * names are looked up in the folder of the calibration file, then as they are. Returned: text in the arena.
 * Errors: WF_EMISSING where the variable is not set or the file does not exist. */
enum wf_status wf_calibration_path(const struct wf_calibration *s, const char *name, struct wf_arena *a,
                                   const char **out, struct wf_err *e);
#endif
