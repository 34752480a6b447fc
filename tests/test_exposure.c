/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ground around a tree: level ground changes nothing, the factor is that of the map, and the load feels it.
 */
#include "data/model.h"
#include "data/species.h"
#include "solve/solve.h"
#include "load/drag.h"
#include "close.h"
#include "study/analysis.h"
#include "wind/terrain.h"
#include "load/scene.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct wf_arena arena;

/* A map with the heights of `z`, written and read again. */
static struct wf_site site(double (*z)(double x, double y), double x, double y)
{
    enum { N = 65 };
    struct wf_terrain t;
    struct wf_err e = { 0 };
    static char path[] = "/tmp/wf_exposureXXXXXX";
    memcpy(path + sizeof path - 7, "XXXXXX", 6);
    close(mkstemp(path));
    assert_int_equal(wf_terrain_alloc(&t, N, N, 20, &arena, &e), WF_OK);
    for (size_t i = 0; i < N * N; i++) t.z[i] = z(20.0 * (double)(i % N), 20.0 * (double)(i / N));
    assert_int_equal(wf_terrain_write(path, &t, NULL, &e), WF_OK);
    struct wf_site s = { .file = path, .x = x, .y = y };
    enum wf_status status = wf_site_read(&s, &arena, &e);
    unlink(path);
    if (status) s.file = NULL;
    return s;
}

static double level(double x, double y)
{
    (void)x, (void)y;
    return 120;
}
static double hill(double x, double y)
{
    return 20 * exp(-(pow(x - 640, 2) + pow(y - 640, 2)) / (2 * 150.0 * 150.0));
}
static double cliff(double x, double y)
{
    (void)y;
    return x > 630 ? 300 : 0;
}

static void factor_of_the_ground(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    double factor, other;
    struct wf_site flat = site(level, 333, 500), top = site(hill, 640, 640), foot = site(hill, 640, 260);
    assert_int_equal(wf_site_speed_up(&flat, 1, 10, 0.03, &factor, &e), WF_OK);
    assert_close(factor, 1, 1e-12);
    /* on a grid point: the number of wf_terrain_speedup itself */
    const struct wf_speedup_request q = { .from = 0.5, .height = 10, .roughness = 0.03 };
    struct wf_speedup map;
    assert_int_equal(wf_terrain_speedup(&top.ground, &q, &arena, &map, &e), WF_OK);
    assert_int_equal(wf_site_speed_up(&top, 0.5, 10, 0.03, &factor, &e), WF_OK);
    assert_close(factor, 1 + map.ds[32 * 65 + 32], 1e-15);
    /* a round hill: the same from every side on its top, faster than level ground there, slower at its foot
     * when the wind comes over it or meets it */
    assert_int_equal(wf_site_speed_up(&top, 0.5 + M_PI / 2, 10, 0.03, &other, &e), WF_OK);
    assert_close(other, factor, 1e-6);
    assert_true(factor > 1.1);
    assert_int_equal(wf_site_speed_up(&foot, 0, 10, 0.03, &other, &e), WF_OK);
    assert_true(other < 1);
    assert_close(top.edge, 640, 1e-9);
    assert_true(top.steepest > 0.07 && top.steepest < 0.09); /* 20/150 exp(-1/2) = 0.081 */
}

static void mistakes(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    double factor;
    assert_null(site(level, 2000, 10).file);
    struct wf_site s = site(cliff, 560, 640);
    assert_int_equal(wf_site_speed_up(&s, M_PI / 2, 10, 0.03, &factor, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "too steep for the linear speed-up"));
}

/* Wind named U on a site of 1.25 is wind of 1.25 U: equal answers, critical speed down by the same factor. */
static void load_feels_it(void **state)
{
    (void)state;
    struct wf_diag d = { .arena = &arena };
    struct wf_err e = { 0 };
    struct wf_species sp;
    struct wf_model m;
    struct wf_scenario sc;
    struct wf_solve_options o;
    struct wf_analysis plain, exposed;
    const double named = 8, met = 10;
    if (wf_species_read("species/weeping_willow.yaml", &wf_laws, &arena, &sp, &d, &e) ||
        wf_model_read("models/culm.yaml", &arena, &m, &d, &e))
        fail_msg("%s", e.text);
    wf_scenario_default(&sc);
    wf_solve_options_default(&o);
    assert_int_equal(wf_analyze(&sp, &m, &sc, NULL, wf_solvers[0], &o, &met, 1, &arena, &d, &plain, &e), WF_OK);
    sc.speed_up = 1.25;
    assert_int_equal(wf_analyze(&sp, &m, &sc, NULL, wf_solvers[0], &o, &named, 1, &arena, &d, &exposed, &e), WF_OK);
    assert_close(exposed.at[0].speed, 8, 0);
    assert_close(exposed.at[0].base_moment, plain.at[0].base_moment, 1e-9 * plain.at[0].base_moment);
    assert_close(1.25 * exposed.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, plain.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, 1e-3);
    sc.speed_up = 0;
    assert_int_equal(wf_analyze(&sp, &m, &sc, NULL, wf_solvers[0], &o, &named, 1, &arena, &d, &exposed, &e),
                     WF_EUSAGE);
    wf_arena_free(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(factor_of_the_ground), cmocka_unit_test(mistakes),
                                        cmocka_unit_test(load_feels_it) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
