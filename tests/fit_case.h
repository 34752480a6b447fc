/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_FIT_CASE_H
#define WF_TESTS_FIT_CASE_H
/* Trees with sensors on them, for the tests of calibration. */
#include "cases/build.h"
#include "close.h"
#include "fit/fit.h"
#include "fit/predict.h"
#include "grow/stem.h"
#include <string.h>

enum { MOST = 12 };
struct set {
    struct wf_arena arena;
    struct wf_err err;
    struct wf_level level[2];
    struct wf_species species;
    struct wf_fit_tree tree;
    struct wf_fit_test test;
    struct wf_fit_sensor sensor[8];
    struct wf_fit_state state[10];
    struct wf_fit_datum datum[80];
    struct wf_experiment x;
    struct wf_fit_param param[MOST];
    size_t params;
};

static inline void materials(struct set *s)
{
    for (int k = 0; k < 2; k++) {
        struct wf_level *l = &s->level[k];
        l->youngs_modulus = (struct wf_value){ .value = 9e9, .low = 7e9, .high = 11e9, .given = true };
        l->shear_modulus = (struct wf_value){ .value = 7e8, .low = 5e8, .high = 9e8, .given = true };
        l->density = (struct wf_value){ .value = 800, .low = 700, .high = 900 };
        l->drag_coefficient = (struct wf_value){ .value = 1, .low = .8, .high = 1.2, .given = true };
        l->knot_factor.value = 1;
    }
    s->species =
        (struct wf_species){ .key = "wood",
                             .levels = 2,
                             .level = s->level,
                             .crown.drag_coefficient = { .value = 0.5, .given = true },
                             .crown.leaf_mass_per_area = { .value = 0.2 },
                             .crown.frontal_share = { .value = 0.4 },
                             .streamlining = { .law = "vogel",
                                               .parameter = { { .value = -0.7 }, { .value = 5 } } } };
}

/* Sensors about half a height, rows cut where they sit and to at most `length`. */
static inline void sensors(struct set *s, double height, double length)
{
    static const enum wf_sensor_kind kind[] = { WF_SENSOR_DEFLECTION, WF_SENSOR_HORIZONTAL,
                                                WF_SENSOR_VERTICAL,   WF_SENSOR_TILT,
                                                WF_SENSOR_STRAIN,     WF_SENSOR_EXTENSION,
                                                WF_SENSOR_MOMENT,     WF_SENSOR_TILT };
    struct wf_fit_place place[3] = { { height / 2, false },
                                     { height / 2 + 0.2, false },
                                     { height * 0.6, false } };
    int32_t row[3];
    struct wf_tree *t = &s->tree.tree;
    if (wf_fit_divide(t, length, place, 3, row, &s->arena, &s->err)) fail_msg("%s", s->err.text);
    for (int k = 0; k < 8; k++)
        s->sensor[k] = (struct wf_fit_sensor){
            .name = "s", .kind = kind[k], .azimuth = 0.4, .row = row[1], .low_row = row[0]
        };
    s->sensor[7].row = -1;
    s->test.pull_row = row[2];
    s->test.sensors = 8, s->test.sensor = s->sensor, s->test.state = s->state;
    s->x = (struct wf_experiment){
        .trees = 1, .tests = 1, .tree = &s->tree, .test = &s->test, .datum = s->datum
    };
    for (size_t i = 0; i < s->test.states; i++)
        for (size_t k = 0; k < 8; k++)
            s->datum[s->x.data++] = (struct wf_fit_datum){ .state = i, .sensor = k, .sigma = 1, .weight = 1 };
    s->tree.species = &s->species;
    s->tree.height = height;
    wf_solve_options_default(&s->tree.options);
    s->tree.options.tolerance = 1e-12;
    s->tree.options.inextensible = true; /* the answers leave out how stretch changes with E */
    s->tree.options.root_stiffness[0] = s->tree.options.root_stiffness[1] = 2e6;
}

static inline void free_parameter(struct set *s, const char *name)
{
    if (wf_param_add(&s->x, name, &s->arena, s->param, &s->params, &s->err)) fail_msg("%s", s->err.text);
}

/* A stem with a crown in wind, and pulled by a rope that follows it. */
static inline void stem(struct set *s, enum wf_fit_load load)
{
    static double share[] = { 0.3 }, at[] = { 0 };
    materials(s);
    s->level[0].shear_modulus.given = false;
    s->level[0].wall = (struct wf_along){ 1, at, share };
    struct wf_model m = { .key = "stem",
                          .name = "stem",
                          .height = 10,
                          .radius = 0.06,
                          .taper = WF_TAPER_LINEAR,
                          .tip_ratio = 0.3,
                          .segments = 30,
                          .crown_base = 4,
                          .crown_top = 10,
                          .leaf_area = 9,
                          .lean = 0.05 };
    if (wf_grow_stem(&m, &s->species, &s->arena, &s->tree.tree, &s->err)) fail_msg("%s", s->err.text);
    wf_loads_default(&s->tree.loads);
    s->tree.loads.streamline = wf_streamline_named("vogel");
    s->tree.loads.streamline_par = (struct wf_law_values){ .number = { -0.7, 5 } };
    s->test = (struct wf_fit_test){ .name = "stem",
                                    .load = load,
                                    .states = 2,
                                    .from_rest = true,
                                    .anchored = true,
                                    .anchor = { 9, 2, -0.5 } };
    s->test.wind = (struct wf_wind){ .sample = wf_profile_named("power")->sample,
                                     .direction = { 1, 0, 0 },
                                     .reference_height = 10,
                                     .exponent = 0.2 };
    s->state[0].load = load == WF_FIT_PULL ? 200 : 9;
    s->state[1].load = load == WF_FIT_PULL ? 900 : 22;
    sensors(s, 9, 0.3);
    s->tree.options.root_stiffness[0] = s->tree.options.root_stiffness[1] = 4e4;
}

/* A row of a tree made by hand, from the end of the row below or from the ground. */
static inline int32_t row_onto(struct wf_tree *t, int32_t below, int32_t level, const double by[3], double r0,
                               double r1)
{
    size_t i = t->n++;
    t->parent[i] = below, t->level[i] = level;
    t->x0[i] = below < 0 ? 0 : t->x1[below], t->x1[i] = t->x0[i] + by[0];
    t->y0[i] = below < 0 ? 0 : t->y1[below], t->y1[i] = t->y0[i] + by[1];
    t->z0[i] = below < 0 ? 0 : t->z1[below], t->z1[i] = t->z0[i] + by[2];
    t->r0[i] = r0, t->r1[i] = r1, t->i0[i] = 0.2 * r0, t->i1[i] = 0.2 * r1;
    t->youngs[i] = 9e9, t->shear[i] = 7e8, t->density[i] = 800, t->drag[i] = 1;
    t->burden0[i] = t->burden1[i] = level ? 0.4 : 0;
    return (int32_t)i;
}

/* A stem that leans and winds, as a scan shows it, with long branches that fork and hang over, pulled by a
 * rope that follows it or in wind. */
static inline void crooked(struct set *s, enum wf_fit_load load)
{
    enum { STEM = 16, BRANCH = 4 };
    materials(s);
    struct wf_tree *t = &s->tree.tree;
    if (wf_tree_alloc(t, 16 + 7 * 2 * BRANCH, &s->arena, &s->err)) fail_msg("%s", s->err.text);
    t->n = 0;
    int32_t stem[STEM];
    for (int32_t i = 0; i < STEM; i++) {
        const double by[3] = { 0.1 + 0.12 * sin(0.9 * i), 0.12 * cos(1.3 * i), 0.7 };
        stem[i] = row_onto(t, i ? stem[i - 1] : -1, 0, by, 0.16 - 0.008 * i, 0.152 - 0.008 * i);
    }
    for (int32_t i = 5; i < STEM - 4; i++) {
        int32_t at = stem[i];
        for (int k = 0; k < 2 * BRANCH; k++) {
            double angle = 2.4 * i + 0.15 * k + (k >= BRANCH ? 0.8 : 0), r = 0.04 - 0.006 * (k % BRANCH);
            const double by[3] = { 0.5 * cos(angle), 0.5 * sin(angle), 0.25 - 0.12 * (k % BRANCH) };
            if (k == BRANCH) at = at - 2; /* forks */
            at = row_onto(t, at, 1, by, r, r - 0.005);
        }
    }
    wf_loads_default(&s->tree.loads);
    s->test = (struct wf_fit_test){
        .name = "crooked", .load = load, .states = 2, .anchored = true, .anchor = { 11, 3, -0.5 }
    };
    s->test.wind = (struct wf_wind){ .sample = wf_profile_named("power")->sample,
                                     .direction = { 0.8, 0.6, 0 },
                                     .reference_height = 10,
                                     .exponent = 0.2 };
    s->state[0].load = load == WF_FIT_PULL ? 1000 : 12;
    s->state[1].load = load == WF_FIT_PULL ? 6000 : 30;
    sensors(s, 10, 0.5);
}

/* The tree of 1000 rows in a steady wind of n speeds. */
static inline void thousand(struct set *s, size_t n)
{
    materials(s);
    struct wf_tree *t = &s->tree.tree;
    if (wf_case_tree_read("validation/computed_reference/bench_tree_1k.csv", &s->arena, t, &s->err))
        fail_msg("%s", s->err.text);
    for (size_t i = 0; i < t->n; i++)
        t->youngs[i] = 9e9, t->shear[i] = 7e8, t->density[i] = 800, t->drag[i] = 1;
    wf_loads_default(&s->tree.loads);
    s->test = (struct wf_fit_test){ .name = "wind", .load = WF_FIT_WIND, .states = n, .from_rest = true };
    s->test.wind = (struct wf_wind){ .sample = wf_profile_named("uniform")->sample,
                                     .direction = { 0.8, 0.6, 0 },
                                     .reference_height = 10 };
    for (size_t i = 0; i < n; i++) s->state[i].load = 40.0 * (double)(i + 1) / (double)n;
    sensors(s, wf_tree_height(t) * 0.4, INFINITY);
}
#endif
