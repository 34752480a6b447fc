/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/calibration.h"
#include "base/num.h"
#include "wind/terrain.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const no_yes[] = { "no", "yes", NULL };
static const char *const signs[] = { "+", "-", NULL };
static const char *const zeros[] = { "rest", "unloaded", NULL };
static const char *const joints[] = { "axis", "bridge", NULL };
static const char *const modes[] = { "sway", "lowest", NULL };
static const char *const rests[] = { "as-drawn", "stress-free", NULL };
static const char *const kinds[] = { "deflection",  "horizontal", "vertical", "tilt",
                                     "strain",      "extension",  "reach",    "rise",
                                     "base_moment", "frequency",  "damping",  NULL };

#define ROW(T, k, yaml, member) .key = k, .kind = yaml, .offset = offsetof(T, member)
#define QUANTITY(T, k, member, dim, u, from, to)                                                             \
    ROW(T, k, WF_YAML_QUANTITY, member), .dimension = dim, .unit = u, .low = from, .high = to
#define AZIMUTH(T) QUANTITY(T, "azimuth", azimuth, WF_DIM_ANGLE, "deg", -WF_TURN, WF_TURN)

#define T struct wf_calibration_tree
static const struct wf_yaml_row tree_rows[] = {
    { ROW(T, "name", WF_YAML_NAME, name), .required = true,
      .doc = "Name of the tree, for tests and parameters.", .example = "T3" },
    { ROW(T, "species", WF_YAML_TEXT, species), .required = true,
      .doc = "Species table: a file beside the study, or the name of a shipped one.",
      .example = "scots_pine" },
    { ROW(T, "model", WF_YAML_TEXT, model), .absent = "see qsm", .doc = "Tree model (YAML).",
      .example = "culm.yaml" },
    { ROW(T, "qsm", WF_YAML_TEXT, qsm), .absent = "see model",
      .doc = "Measured tree, any form that import reads." },
    { ROW(T, "joint", WF_YAML_CHOICE, joint), .choices = joints, .initial = "axis",
      .doc = "How branches of a measured tree are held." },
    { ROW(T, "tree_id", WF_YAML_TEXT, tree_id), .absent = "the file holds one tree",
      .doc = "Which tree of a table of several: a value of its column treeID.", .example = "12" },
    { ROW(T, "force", WF_YAML_ENUM, force), .choices = no_yes, .initial = "no",
      .doc = "Take a measured tree with stems more than 2 m apart or more than 25 % of unseen wood." },
    { ROW(T, "cap_children", WF_YAML_ENUM, cap_children), .choices = no_yes, .initial = "no",
      .doc = "Thin measured branches that are thicker than what they grow on." },
    { QUANTITY(T, "leaf_area", leaf_area, WF_DIM_AREA, "m2", 0, 1e4), .initial = "0 m2",
      .doc = "One-sided leaf area of a measured tree; a model has its own." },
    { QUANTITY(T, "scanned_leaf_area", scanned_leaf_area, WF_DIM_AREA, "m2", 0, 1e4), .absent = "leaf_area",
      .doc = "The same on the day of the scan: what the tree has gained or lost since bends it." },
    { ROW(T, "rest", WF_YAML_CHOICE, rest), .choices = rests,
      .absent = "a measured tree as-drawn, a model as its 'shape' says",
      .doc = "as-drawn: the shape is that of the tree under its weight, whose forces are in it; stress-free: "
             "its weight bends it further." },
    { QUANTITY(T, "root_stiffness", root_stiffness, WF_DIM_ROTATIONAL_STIFFNESS, "kN m/rad", 1, 1e12),
      .absent = "clamped, unless it is a free parameter", .doc = "Rotational stiffness of the root plate." },
    { QUANTITY(T, "gravity", gravity, WF_DIM_ACCELERATION, "m/s2", 0, 100), .initial = "9.81 m/s2",
      .doc = "0: without weight." },
    { 0 }
};
static const struct wf_yaml_table tree_table = {
    .title = "a tree", .row = tree_rows, .size = sizeof(T), .doc = ""
};
#undef T

#define MODE(T)                                                                                              \
    ROW(T, "mode", WF_YAML_CHOICE, mode),                                                                    \
        .choices = modes, .absent = "sway",                                                                  \
        .doc = "Which mode a frequency is of: sway, the lowest that carries at least half as much of the "   \
               "overturning by inertia (of that direction) as the one that carries most; lowest, which may " \
               "be a "                                                                                       \
               "branch's."
#define T struct wf_calibration_sensor
static const struct wf_yaml_row sensor_rows[] = {
    { ROW(T, "name", WF_YAML_NAME, name), .required = true, .doc = "Name of the sensor.",
      .example = "clino_1" },
    { ROW(T, "kind", WF_YAML_ENUM, kind), .required = true, .choices = kinds,
      .doc =
          "What it measures: deflection along an azimuth, horizontal and vertical displacement, tilt of "
          "the axis "
          "towards an azimuth, strain of the bark over a gauge length or its extension, place of a point of "
          "the axis: horizontally along an azimuth (reach) or upwards (rise) from the stem's base, "
          "overturning moment on the "
          "ground, natural frequency, damping ratio." },
    { ROW(T, "column", WF_YAML_TEXT, column), .absent = "needs value, or a plan without data",
      .doc = "Column of the data file; its name ends in the unit: tilt_deg, deflection_mm, strain_um_m." },
    { ROW(T, "unit", WF_YAML_TEXT, unit), .absent = "by the column's name",
      .doc = "Unit of a column that does not name it." },
    { ROW(T, "value", WF_YAML_TEXT, value),
      .absent = "read from the column; a planned test of free sway needs none",
      .doc = "A single measured value.", .example = "0.29 Hz" },
    { QUANTITY(T, "height", height, WF_DIM_LENGTH, "m", 0, 150),
      .absent = "not for base_moment, frequency, damping",
      .doc = "Above the ground; middle of a gauge; 0 is the root plate." },
    { QUANTITY(T, "along", along, WF_DIM_LENGTH, "m", 0, 150), .absent = "by 'height'",
      .doc = "The same as a distance along the stem's axis from its base, for leaning stems and branches." },
    { AZIMUTH(T), .absent = "that of the load",
      .doc = "Direction measured, from +x towards +y; for strain the side of the stem, for a frequency the "
             "direction of "
             "sway." },
    { MODE(T) },
    { QUANTITY(T, "gauge", gauge, WF_DIM_LENGTH, "mm", 1e-3, 10), .absent = "100 mm",
      .doc = "Length over which strain or extension is taken." },
    { ROW(T, "sign", WF_YAML_ENUM, sign), .choices = signs, .initial = "+",
      .doc = "- where the column has the opposite sign." },
    { ROW(T, "sigma", WF_YAML_TEXT, sigma),
      .absent = "estimated from the scatter, unless sigma_share is given",
      .doc = "Standard uncertainty of a reading.", .example = "0.05 deg" },
    { QUANTITY(T, "sigma_share", sigma_share, WF_DIM_NONE, NULL, 0, 1), .absent = "none",
      .doc = "The same as a share of the reading; both add in squares.", .example = "2 %" },
    { ROW(T, "offset", WF_YAML_ENUM, offset), .choices = no_yes, .initial = "no",
      .doc = "Its zero is unknown and is fitted." },
    { ROW(T, "drift", WF_YAML_ENUM, drift), .choices = no_yes, .initial = "no",
      .doc = "Its zero drifts linearly with time." },
    { 0 }
};
static const struct wf_yaml_table sensor_table = {
    .title = "a sensor", .row = sensor_rows, .size = sizeof(T), .doc = ""
};
#undef T

#define T struct wf_calibration_pull
static const struct wf_yaml_row pull_rows[] = {
    { ROW(T, "column", WF_YAML_TEXT, column), .absent = "needed where there is data",
      .doc = "Column of the force in the rope, with its unit: force_kN." },
    { ROW(T, "unit", WF_YAML_TEXT, unit), .absent = "by the column's name",
      .doc = "Unit of a column that does not name it." },
    { QUANTITY(T, "height", height, WF_DIM_LENGTH, "m", 1e-2, 150), .required = true,
      .doc = "Of the strap on the stem.", .example = "4.8 m" },
    { AZIMUTH(T), .initial = "0 deg", .doc = "Direction of the pull, from +x towards +y." },
    { QUANTITY(T, "elevation", elevation, WF_DIM_ANGLE, "deg", -WF_TURN / 4, WF_TURN / 4), .initial = "0 deg",
      .doc = "Of the rope seen from the strap; negative: down. Not used with an anchor." },
    { QUANTITY(T, "anchor_distance", anchor_distance, WF_DIM_LENGTH, "m", 0.1, 1000),
      .absent = "the rope keeps its direction",
      .doc = "Horizontal, from the stem's base to where the rope ends; the rope then follows the strap." },
    { QUANTITY(T, "anchor_height", anchor_height, WF_DIM_LENGTH, "m", -100, 100), .initial = "0 m",
      .doc = "Of the rope's end above the stem's base." },
    { QUANTITY(T, "from", from, WF_DIM_NONE, NULL, 0, 1), .initial = "0.1",
      .doc = "Share of the largest force at which the loading branch begins." },
    { QUANTITY(T, "to", to, WF_DIM_NONE, NULL, 0, 1), .initial = "0.9", .doc = "Share at which it ends." },
    { ROW(T, "loads", WF_YAML_QUANTITIES, load), .count = offsetof(T, loads), .dimension = WF_DIM_FORCE,
      .unit = "kN", .low = 0, .high = 1e7, .absent = "read from the data",
      .doc = "Forces of a test that is only planned.", .example = "[0.5 kN, 1 kN]" },
    { 0 }
};
static const struct wf_yaml_table pull_table = { .title = "a pull", .row = pull_rows, .doc = "" };
#undef T

#define T struct wf_calibration_wind
static const struct wf_yaml_row wind_rows[] = {
    { ROW(T, "column", WF_YAML_TEXT, column), .absent = "needed where there is data",
      .doc = "Column of the wind speed, with its unit: wind_m_s." },
    { ROW(T, "unit", WF_YAML_TEXT, unit), .absent = "by the column's name",
      .doc = "Unit of a column that does not name it." },
    { ROW(T, "profile", WF_YAML_CHOICE, profile.name), .choices = wf_profile_names,
      .absent = "power; measured with profile_file", .doc = "Growth with height." },
    { ROW(T, "profile_file", WF_YAML_TEXT, profile.file), .absent = "none",
      .doc = "Measured mean winds, a CSV with columns height_m and speed_ms; only their ratios count.",
      .example = "mast.csv" },
    { QUANTITY(T, "reference_height", profile.reference_height, WF_DIM_LENGTH, "m", 0.01, 1000),
      .initial = "10 m", .doc = "Where the speed was measured." },
    WF_PROFILE_KEYS(T, profile),
    { AZIMUTH(T), .initial = "0 deg", .doc = "Towards which it blows, from +x towards +y." },
    { QUANTITY(T, "temperature", temperature, WF_DIM_TEMPERATURE, "degC", 213.15, 333.15),
      .absent = "15 degC", .doc = "Of the air.", .example = "-5 degC" },
    { QUANTITY(T, "altitude", altitude, WF_DIM_LENGTH, "m", -500, 9000), .absent = "0 m",
      .doc = "Of the site above the sea, for the density of the air.", .example = "2000 m" },
    { QUANTITY(T, "air_density", air_density, WF_DIM_DENSITY, "kg/m3", 0.1, 2),
      .absent = "from temperature and altitude", .doc = "In place of the one from temperature and altitude.",
      .example = "1.1 kg/m3" },
    { QUANTITY(T, "speed_up", speed_up, WF_DIM_NONE, NULL, 0.1, 5), .absent = "1",
      .doc = "Exposure of the site: wind at the tree over the wind measured.", .example = "1.2" },
    { ROW(T, "dem", WF_YAML_TEXT, dem), .absent = "level ground, or speed_up",
      .doc =
          "Heights of the ground, an ESRI ASCII grid, on which the exposure is found as 'windfirm terrain' "
          "does, at the reference height.",
      .example = "hill.asc" },
    { ROW(T, "at", WF_YAML_JOINED, at), .absent = "needed with dem",
      .doc = "Where the tree stands on it [m].", .example = "450,1200" },
    { QUANTITY(T, "north", north, WF_DIM_ANGLE, "deg", -WF_TURN, WF_TURN), .initial = "0 deg",
      .doc = "Where north of dem is in the model: clockwise from +y as seen from above." },
    { ROW(T, "speeds", WF_YAML_QUANTITIES, speed), .count = offsetof(T, speeds), .dimension = WF_DIM_SPEED,
      .unit = "m/s", .low = 0, .high = 200, .absent = "read from the data",
      .doc = "Speeds of a test that is only planned." },
    { 0 }
};

enum wf_status wf_calibration_wind_scene(const struct wf_calibration_wind *w, struct wf_scenario *out,
                                         struct wf_err *e)
{
    wf_scenario_default(out);
    enum wf_status status = wf_scenario_words(out, &w->profile, e);
    out->azimuth = w->azimuth;
    if (!isnan(w->temperature)) out->temperature = w->temperature;
    if (!isnan(w->altitude)) out->altitude = w->altitude;
    if (!isnan(w->air_density)) out->air_density = w->air_density;
    if (!isnan(w->speed_up)) out->speed_up = w->speed_up;
    return status || w->profile.file ? status : wf_scenario_check(out, e);
}

/* False when a number was invalid, or is of another profile, which is reported: further checks would report
 * its consequences. */
static bool wind_numbers_are_right(struct wf_yaml *y, const struct wf_calibration_wind *w)
{
    const char *const key[] = { "reference_height", "exponent",    "roughness", "displacement",
                                "canopy_height",    "attenuation", "azimuth",   "temperature",
                                "altitude",         "air_density", "speed_up" };
    const double value[] = { w->profile.reference_height,
                             w->profile.exponent,
                             w->profile.roughness,
                             w->profile.displacement,
                             w->profile.canopy_height,
                             w->profile.attenuation,
                             w->azimuth,
                             w->temperature,
                             w->altitude,
                             w->air_density,
                             w->speed_up };
    bool right = true;
    char why[160];
    for (const struct wf_profile_number *n = wf_profile_numbers; n->key; n++)
        if (wf_profile_unused(&w->profile, n->said, why, sizeof why)) {
            wf_yaml_error(y, n->key, "has no effect %s", why);
            right = false;
        }
    for (size_t k = 0; k < WF_COUNT(key); k++) right = right && !(isnan(value[k]) && wf_yaml_has(y, key[k]));
    return right && (w->profile.name || !wf_yaml_has(y, "profile"));
}

/* Report keys of a wind that exclude each other. */
static void wind_finish(struct wf_yaml *y, void *wind)
{
    struct wf_calibration_wind *w = wind;
    struct wf_scenario scene;
    struct wf_err why = { 0 };
    double x, z;
    if (!w->given) return;
    w->profile.ground = w->dem;
    w->profile_file_place = wf_yaml_where(y, "profile_file");
    w->dem_place = wf_yaml_where(y, "dem");
    if (wind_numbers_are_right(y, w) && wf_calibration_wind_scene(w, &scene, &why))
        wf_yaml_error(y, wf_yaml_has(y, "profile") ? "profile" : "", "%s", why.text);
    if (w->dem && !isnan(w->speed_up)) wf_yaml_error(y, "dem", "give one of 'speed_up' and 'dem', not both");
    if (w->dem && !w->at) wf_yaml_error(y, "dem", "needs 'at', where the tree stands on it");
    if (!isnan(w->altitude) && !isnan(w->air_density))
        wf_yaml_error(y, "altitude", "has no effect beside 'air_density'");
    if (!w->dem && w->at) wf_yaml_error(y, "at", "needs 'dem', the heights of the ground");
    if (!w->dem && wf_yaml_has(y, "north"))
        wf_yaml_error(y, "north", "applies only with 'dem', which is not given");
    if (w->dem && w->at && !wf_site_place(w->at, &x, &z))
        wf_yaml_error(y, "at", "'%.100s': the tree's place is written x,y in m, for example 450,1200", w->at);
}

static const struct wf_yaml_table wind_table = {
    .title = "a wind", .row = wind_rows, .finish = wind_finish, .doc = ""
};
#undef T

#define T struct wf_calibration_sway
static const struct wf_yaml_row sway_rows[] = {
    { ROW(T, "column", WF_YAML_TEXT, column), .required = true,
      .doc = "Column of a free oscillation after a release, in any unit; frequency and damping are fitted to "
             "it." },
    { AZIMUTH(T), .absent = "any direction", .doc = "Direction of sway." },
    { MODE(T) },
    { 0 }
};
static const struct wf_yaml_table sway_table = { .title = "a free sway", .row = sway_rows, .doc = "" };
#undef T

#define T struct wf_calibration_test
static const struct wf_yaml_row test_rows[] = {
    { ROW(T, "name", WF_YAML_NAME, name), .required = true, .doc = "Name of the test." },
    { ROW(T, "tree", WF_YAML_NAME, tree), .absent = "the only tree", .doc = "Which tree it was made on." },
    { ROW(T, "data", WF_YAML_TEXT, data), .absent = "named on the command line, or none",
      .doc = "CSV file; ${WINDFIRM_REFERENCE}/... is looked for in the folder that variable names." },
    { ROW(T, "rows", WF_YAML_TEXTS, rows), .count = offsetof(T, rows_n), .absent = "all rows",
      .doc = "Only rows with these texts in these columns.", .example = "{tree: T3, pull: P1}" },
    { ROW(T, "time", WF_YAML_TEXT, time), .absent = "rows have no time",
      .doc = "Column of the time: a number with its unit (t_s), dates and times (2020-07-29T16:31:52Z, "
             "29.07.2020 "
             "16:31:52) or times of day (16:31:52). Free sway, a drift, 'after' and 'until' need it, or "
             "'rate'." },
    { QUANTITY(T, "rate", rate, WF_DIM_FREQUENCY, "Hz", 1e-6, 1e6), .absent = "not known",
      .doc = "Rows a second, where there is no column of the time.", .example = "20 Hz" },
    { ROW(T, "dates", WF_YAML_TEXT, dates), .absent = "seen from a number above 12",
      .doc = "day-first or month-first, for dates such as 05/01/2024.", .example = "day-first" },
    { ROW(T, "missing", WF_YAML_TEXT, missing),
      .absent = "cells that are empty or NA; of a wind also numbers that "
                "are found to be marks",
      .doc = "Numbers that mean 'no reading' in the file, separated by commas; none: every wind is one.",
      .example = "-99.9,999" },
    { QUANTITY(T, "after", after, WF_DIM_TIME, "s", 0, 1e9), .absent = "from the first row",
      .doc = "Earlier rows are ignored." },
    { QUANTITY(T, "until", until, WF_DIM_TIME, "s", 0, 1e9), .absent = "to the last row",
      .doc = "Later rows are ignored." },
    { ROW(T, "points", WF_YAML_INTEGER, points), .low = 2, .high = 2000, .initial = "50",
      .doc = "Neighbouring rows are averaged down to this number." },
    { ROW(T, "along", WF_YAML_TEXT, along), .absent = "sensors have places of their own",
      .doc =
          "Column of the distance along the stem's axis at which all sensors of a row sit; for a test under "
          "weight alone. Rows at 0 are left out.",
      .example = "along_m" },
    { ROW(T, "zero", WF_YAML_ENUM, zero), .choices = zeros, .initial = "rest",
      .doc =
          "State from which readings are measured: the tree at rest under its weight, or its unloaded shape. "
          "A test without pull, wind and sway bends the tree by its weight alone and needs 'unloaded'." },
    { ROW(T, "pull", WF_YAML_TABLE, pull), .table = &pull_table, .given = 1 + offsetof(T, pull.given),
      .absent = "no pull", .doc = "A rope." },
    { ROW(T, "wind", WF_YAML_TABLE, wind), .table = &wind_table, .given = 1 + offsetof(T, wind.given),
      .absent = "no wind", .doc = "Steady wind." },
    { ROW(T, "sway", WF_YAML_TABLE, sway), .table = &sway_table, .given = 1 + offsetof(T, sway.given),
      .absent = "no record", .doc = "A record of free sway." },
    { ROW(T, "sensors", WF_YAML_LIST, sensor), .count = offsetof(T, sensors), .table = &sensor_table,
      .absent = "those of the sway record", .doc = "The sensors." },
    { 0 }
};
static const struct wf_yaml_table test_table = {
    .title = "a test", .row = test_rows, .size = sizeof(T), .doc = ""
};
#undef T

#define T struct wf_calibration_free
static const struct wf_yaml_row free_rows[] = {
    { ROW(T, "parameter", WF_YAML_TEXT, parameter), .required = true, .doc = "Its name.",
      .example = "level0.youngs_modulus" },
    { ROW(T, "start", WF_YAML_TEXT, start), .absent = "the species table's value", .doc = "Start.",
      .example = "9 GPa" },
    { ROW(T, "low", WF_YAML_TEXT, low), .absent = "a wide default", .doc = "Lower bound." },
    { ROW(T, "high", WF_YAML_TEXT, high), .absent = "a wide default", .doc = "Upper bound." },
    { 0 }
};
static const struct wf_yaml_table free_table = {
    .title = "a free parameter", .row = free_rows, .size = sizeof(T), .doc = ""
};
#undef T

/* Report a name that occurs twice in a list: names identify tests and parameters. */
static void twice(struct wf_yaml *y, const char *list, const void *first, size_t n, size_t size, size_t at)
{
    const char *base = first;
    char place[64];
    for (size_t i = 1; base && i < n; i++)
        for (size_t k = 0; k < i; k++) {
            const char *a = *(const char *const *)(const void *)(base + i * size + at),
                       *b = *(const char *const *)(const void *)(base + k * size + at);
            snprintf(place, sizeof place, "%s[%zu]", list, i);
            if (a && b && !strcmp(a, b)) {
                wf_yaml_error(y, place, "the name '%s' is given twice", a);
                break;
            }
        }
}

/* Check a sensor of a test without pull and wind, where only weight bends the tree. */
static void under_weight(struct wf_yaml *y, const struct wf_calibration_test *t, const char *place,
                         const struct wf_calibration_sensor *q)
{
    const char *name = wf_sensor_rows[q->kind].name;
    bool directed = q->kind == WF_SENSOR_DEFLECTION || q->kind == WF_SENSOR_TILT ||
                    q->kind == WF_SENSOR_REACH || q->kind == WF_SENSOR_STRAIN ||
                    q->kind == WF_SENSOR_EXTENSION || q->kind == WF_SENSOR_MOMENT;
    if (t->zero == 0)
        wf_yaml_error(y, place, "a %s needs a pull or a wind, or 'zero: unloaded' to be of weight alone",
                      name);
    if (directed && isnan(q->azimuth))
        wf_yaml_error(y, place, "a %s under weight alone needs 'azimuth'", name);
    if (!t->along && !q->value) wf_yaml_error(y, place, "a %s under weight alone needs 'value'", name);
}

static void sensor_finish(struct wf_yaml *y, const struct wf_calibration_test *t, const char *place,
                          const struct wf_calibration_sensor *q)
{
    const struct wf_sensor_row *r = &wf_sensor_rows[q->kind];
    bool sway = q->kind == WF_SENSOR_FREQUENCY || q->kind == WF_SENSOR_DAMPING;
    bool absolute = q->kind == WF_SENSOR_REACH || q->kind == WF_SENSOR_RISE;
    if (r->placed && isnan(q->height) && isnan(q->along) && !t->along)
        wf_yaml_error(y, place, "a sensor of kind %s needs 'height' or 'along'", r->name);
    if (!isnan(q->height) && !isnan(q->along)) wf_yaml_error(y, place, "has both 'height' and 'along'");
    if (t->along && !(isnan(q->height) && isnan(q->along)))
        wf_yaml_error(y, place, "has a place of its own beside the test's 'along'");
    if (q->mode && q->kind != WF_SENSOR_FREQUENCY)
        wf_yaml_error(y, place, "'mode' applies to a frequency, not to a %s", r->name);
    if (sway && (t->pull.given || t->wind.given || t->along))
        wf_yaml_error(y, place, "a %s is of free sway: give it a test of its own", r->name);
    if (absolute && t->zero == 0)
        wf_yaml_error(y, place, "a %s is a place, not counted from rest; it needs 'zero: unloaded'", r->name);
    if (!sway && !t->pull.given && !t->wind.given) under_weight(y, t, place, q);
}

static void test_finish(struct wf_yaml *y, const struct wf_calibration *s, size_t i)
{
    const struct wf_calibration_test *t = &s->test[i];
    char place[64];
    size_t sways = 0;
    snprintf(place, sizeof place, "tests[%zu]", i);
    if (t->pull.given + t->wind.given + t->sway.given > 1)
        wf_yaml_error(y, place, "has more than one of 'pull', 'wind' and 'sway'");
    if (t->along && (t->pull.given || t->wind.given || t->sway.given))
        wf_yaml_error(y, place, "'along' is for a test under weight alone");
    if (!t->sensors && !t->sway.given) wf_yaml_error(y, place, "needs 'sensors'");
    if (t->pull.from >= t->pull.to) wf_yaml_error(y, place, "pull: 'from' is not below 'to'");
    if (!t->tree && s->trees > 1) wf_yaml_error(y, place, "needs 'tree': the study has %zu", s->trees);
    for (size_t k = 0; t->sensor && k < t->sensors; k++)
        sways += t->sensor[k].kind == WF_SENSOR_FREQUENCY || t->sensor[k].kind == WF_SENSOR_DAMPING;
    if (sways && sways < t->sensors && !t->pull.given && !t->wind.given)
        wf_yaml_error(y, place, "has sensors of free sway and others: give each a test of its own");
    for (size_t k = 0; t->sensor && k < t->sensors; k++) {
        snprintf(place, sizeof place, "tests[%zu].sensors[%zu]", i, k);
        sensor_finish(y, t, place, &t->sensor[k]);
    }
}

/* Report keys of a tree that have no effect beside others. */
static void tree_finish(struct wf_yaml *y, const struct wf_calibration_tree *t, size_t i)
{
    char place[64];
    bool drawn = t->rest && !strcmp(t->rest, "as-drawn"), free = t->rest && !drawn;
    snprintf(place, sizeof place, "trees[%zu]", i);
    if (!t->model == !t->qsm) wf_yaml_error(y, place, "needs either 'model' or 'qsm'");
    snprintf(place, sizeof place, "trees[%zu].rest", i);
    if (t->rest && t->gravity == 0)
        wf_yaml_error(y, place, "has no effect beside 'gravity: 0': without weight every shape is at rest");
    snprintf(place, sizeof place, "trees[%zu].scanned_leaf_area", i);
    if (isnan(t->scanned_leaf_area)) return;
    if (!t->qsm) wf_yaml_error(y, place, "applies only with 'qsm'; a model has 'scanned'");
    if (free) wf_yaml_error(y, place, "has no effect beside 'rest: stress-free'");
    if (t->gravity == 0) wf_yaml_error(y, place, "has no effect beside 'gravity: 0'");
}

static void finish(struct wf_yaml *y, void *calibration)
{
    struct wf_calibration *s = calibration;
    char place[64];
    for (size_t i = 0; s->tree && i < s->trees; i++) tree_finish(y, &s->tree[i], i);
    twice(y, "trees", s->tree, s->trees, sizeof *s->tree, offsetof(struct wf_calibration_tree, name));
    twice(y, "tests", s->test, s->tests, sizeof *s->test, offsetof(struct wf_calibration_test, name));
    for (size_t i = 0; s->test && i < s->tests; i++) {
        snprintf(place, sizeof place, "tests[%zu].sensors", i);
        twice(y, place, s->test[i].sensor, s->test[i].sensors, sizeof *s->test[i].sensor,
              offsetof(struct wf_calibration_sensor, name));
        test_finish(y, s, i);
    }
}

#define T struct wf_calibration
static const struct wf_yaml_row calibration_rows[] = {
    { ROW(T, "fit", WF_YAML_NAME, key), .required = true, .doc = "Key of the study, as its file's name." },
    { ROW(T, "name", WF_YAML_TEXT, name), .required = true, .doc = "Readable name." },
    { ROW(T, "note", WF_YAML_TEXT, note), .absent = "no note",
      .doc = "Assumptions, and what a reader should know." },
    { ROW(T, "source", WF_YAML_TEXT, source), .absent = "no source",
      .doc = "Where the measurements come from." },
    { ROW(T, "reference", WF_YAML_TEXT, reference), .absent = "none",
      .doc = "What others found, for comparison." },
    { ROW(T, "trees", WF_YAML_LIST, tree), .required = true, .count = offsetof(T, trees),
      .table = &tree_table, .doc = "The trees." },
    { ROW(T, "tests", WF_YAML_LIST, test), .required = true, .count = offsetof(T, tests),
      .table = &test_table, .doc = "The tests." },
    { ROW(T, "free", WF_YAML_LIST, free), .count = offsetof(T, frees), .table = &free_table,
      .absent = "named by --free", .doc = "What is fitted, unless --free names it." },
    { 0 }
};
const struct wf_yaml_table wf_calibration_table = {
    .title = "a calibration study",
    .row = calibration_rows,
    .size = sizeof(T),
    .finish = finish,
    .doc = "A calibration study (YAML): trees, tests made on them, sensors, and what is to be fitted. A "
           "complete example: models/field/sample_pull.yaml."
};
#undef T

enum wf_status wf_calibration_read(const char *path, struct wf_arena *a, struct wf_calibration *out,
                                   struct wf_diag *d, struct wf_err *e)
{
    *out = (struct wf_calibration){ .file = wf_arena_text(a, path) };
    if (!out->file) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    return wf_yaml_read(path, &wf_calibration_table, out, a, d, e);
}

enum wf_status wf_calibration_path(const struct wf_calibration *s, const char *name, struct wf_arena *a,
                                   const char **out, struct wf_err *e)
{
    static const char variable[] = "${WINDFIRM_REFERENCE}/";
    bool outside = !strncmp(name, variable, sizeof variable - 1);
    const char *folder = getenv("WINDFIRM_REFERENCE"), *slash = strrchr(s->file, '/');
    if (outside) {
        if (!folder || !*folder)
            return wf_fail(
                e, WF_EMISSING,
                "%s is not shipped; the variable WINDFIRM_REFERENCE can name a folder that holds %s", name,
                name + sizeof variable - 1);
        *out = wf_arena_print(a, "%s/%s", folder, name + sizeof variable - 1);
    } else if (*name == '/' || !slash)
        *out = wf_arena_text(a, name);
    else
        *out = wf_arena_print(a, "%.*s/%s", (int)(slash - s->file), s->file, name);
    if (!*out) return wf_fail(e, WF_ENOMEM, "%s: no memory", name);
    if (access(*out, R_OK) && access(name, R_OK) == 0) *out = name;
    if (!access(*out, R_OK)) return WF_OK;
    return wf_fail(e, outside ? WF_EMISSING : WF_EINPUT, "%s: names '%s', which cannot be read: %s", s->file,
                   *out, strerror(errno));
}
