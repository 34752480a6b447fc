/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sensitivities that a fit relies on, against central differences of whole solutions. */
#include "data/species.h"
#include "fit_case.h"

/* Every reading and every parameter: exact sensitivity against differences extrapolated from two steps. */
static void compare(struct set *s, double tolerance)
{
    struct wf_predictor *w;
    size_t n = s->params, m = s->x.data;
    double x[MOST], y[24], slope[24 * MOST], side[4][24];
    for (size_t p = 0; p < n; p++) x[p] = wf_param_internal(&s->param[p], s->param[p].start);
    assert_int_equal(wf_predictor_open(&s->x, s->param, n, &s->arena, &w, &s->err), WF_OK);
    if (wf_predict(w, x, y, slope, &s->err)) fail_msg("%s", s->err.text);
    for (size_t p = 0; p < n; p++) {
        const double step = 2e-3, at = x[p], shift[4] = { step, -step, step / 2, -step / 2 };
        for (int k = 0; k < 4; k++) {
            x[p] = at + shift[k];
            if (wf_predict(w, x, side[k], NULL, &s->err)) fail_msg("%s", s->err.text);
        }
        x[p] = at;
        for (size_t i = 0; i < m; i++) {
            double coarse = (side[0][i] - side[1][i]) / (2 * step), fine = (side[2][i] - side[3][i]) / step;
            double want = fine + (fine - coarse) / 3, got = slope[i * n + p];
            /* relative to the reading, where the parameter hardly matters to it */
            if (!(fabs(got - want) <= tolerance * fmax(fabs(want), 0.1 * fabs(y[i]))))
                fail_msg("%s, sensor %zu, state %zu: %.12g, differences give %.12g (%.2g)", s->param[p].name,
                         s->datum[i].sensor, s->datum[i].state, got, want, got / want - 1);
        }
    }
    wf_predictor_close(w);
}

static void tree_of_a_thousand(void **unused)
{
    (void)unused;
    struct set s = { 0 };
    static const char *const names[] = { "level0.youngs_modulus",   "wood.youngs_modulus",
                                         "level1.shear_modulus",    "level1.density",
                                         "level0.drag_coefficient", "root.stiffness",
                                         "youngs_modulus_tip_share" };
    thousand(&s, 1);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) free_parameter(&s, names[k]);
    compare(&s, 1e-6);
    wf_arena_free(&s.arena);
}

static void crown_in_wind(void **unused)
{
    (void)unused;
    struct set s = { 0 };
    static const char *const names[] = { "level0.youngs_modulus",  "level0.density",
                                         "level0.radius_factor",   "level0.drag_coefficient",
                                         "crown.drag_coefficient", "crown.streamlining.exponent",
                                         "root.stiffness" };
    stem(&s, WF_FIT_WIND);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) free_parameter(&s, names[k]);
    compare(&s, 1e-6);
    wf_arena_free(&s.arena);
}

static void rope_that_follows(void **unused)
{
    (void)unused;
    struct set s = { 0 };
    static const char *const names[] = { "level0.youngs_modulus", "level0.radius_factor", "root.stiffness" };
    stem(&s, WF_FIT_PULL);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) free_parameter(&s, names[k]);
    compare(&s, 1e-6);
    wf_arena_free(&s.arena);
}

static void stands(struct set *s)
{
    if (wf_tree_stand(&s->tree.tree, &s->tree.tree, &s->arena, &s->err)) fail_msg("%s", s->err.text);
}

/* Natural frequencies, along the lean and whatever the direction, of a leaning stem with a crown and of the
 * tree of a thousand rows; with and without weight, free of stress and standing in their shape; of a crooked
 * tree with branches. */
static void natural_frequencies(void **unused)
{
    (void)unused;
    static const char *const names[] = { "level0.youngs_modulus", "youngs_modulus_tip_share",
                                         "level0.density",        "level0.radius_factor",
                                         "root.stiffness",        "damping_ratio" };
    for (int k = 0; k < 7; k++) {
        struct set s = { 0 };
        if (k < 2 || k == 4)
            stem(&s, WF_FIT_WIND);
        else if (k < 6)
            thousand(&s, 1);
        else
            crooked(&s, WF_FIT_WIND);
        if (k >= 4) stands(&s);
        if (k < 4 && k % 2) s.tree.loads.gravity = 0;
        s.test.load = WF_FIT_FREE, s.test.states = 1, s.test.sensors = 3;
        s.sensor[0] = (struct wf_fit_sensor){ .kind = WF_SENSOR_FREQUENCY, .azimuth = NAN };
        s.sensor[1] = (struct wf_fit_sensor){ .kind = WF_SENSOR_FREQUENCY, .azimuth = 1.2 };
        s.sensor[2] = (struct wf_fit_sensor){ .kind = WF_SENSOR_DAMPING, .azimuth = NAN };
        s.x.data = 3;
        for (size_t i = 0; i < 3; i++)
            s.datum[i] = (struct wf_fit_datum){ .sensor = i, .sigma = 1, .weight = 1 };
        for (size_t i = 0; i < sizeof names / sizeof *names; i++) free_parameter(&s, names[i]);
        compare(&s, 1e-6);
        wf_arena_free(&s.arena);
    }
}

/* Trees that stand in their shape: the state at rest follows the masses. Pulled, the axis may stretch; in
 * wind the answers leave out how the stretch changes with what the wind does to a tree that has moved. */
static void standing(struct set *s, const char *const *name, bool from_rest)
{
    stands(s);
    s->test.from_rest = from_rest;
    s->tree.options.inextensible = s->test.load != WF_FIT_PULL;
    for (; *name; name++) free_parameter(s, *name);
    compare(s, 1e-6);
    wf_arena_free(&s->arena);
}

static void standing_trees(void **unused)
{
    (void)unused;
    static const char *const branched[] = { "level0.youngs_modulus",
                                            "wood.youngs_modulus",
                                            "level1.shear_modulus",
                                            "level0.density",
                                            "level1.density",
                                            "level0.radius_factor",
                                            "level1.radius_factor",
                                            "level0.drag_coefficient",
                                            "root.stiffness",
                                            "youngs_modulus_tip_share",
                                            NULL },
                             *const single[] = { "level0.youngs_modulus",  "level0.density",
                                                 "level0.radius_factor",   "level0.drag_coefficient",
                                                 "crown.drag_coefficient", "crown.streamlining.exponent",
                                                 "root.stiffness",         NULL };
    for (int k = 0; k < 4; k++) {
        struct set s[3] = { { .params = 0 } };
        stem(&s[0], k % 2 ? WF_FIT_WIND : WF_FIT_PULL);
        standing(&s[0], single, k < 2);
        crooked(&s[1], k % 2 ? WF_FIT_WIND : WF_FIT_PULL);
        standing(&s[1], branched, k < 2);
        if (k % 2 == 0) continue;
        thousand(&s[2], 1);
        standing(&s[2], branched, k < 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tree_of_a_thousand), cmocka_unit_test(crown_in_wind),
        cmocka_unit_test(rope_that_follows),  cmocka_unit_test(natural_frequencies),
        cmocka_unit_test(standing_trees),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
