/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Winds from all around: where they come from, symmetry, the same bytes on any number of threads, climate. */
#include "load/scene.h"
#include "made.h"
#include "solve/solve.h"
#include "study/directions.h"
#include "study/peak.h"
#include "wind/climate.h"
#include <string.h>

static const double winds[] = { 8, 15 };
enum { WINDS = 2, N = 8 };

/* A culm that leans by `lean` towards `azimuth`. */
static void start(struct made *m, double lean, double azimuth)
{
    made_read(m, "species/weeping_willow.yaml", "models/culm.yaml");
    m->model.lean = lean, m->model.lean_azimuth = azimuth;
    m->scenario.peak.method = "mean";
    m->options.mesh_tolerance = 1e-4;
}

static void analyse(struct made *m, double azimuth)
{
    m->scenario.azimuth = azimuth;
    made_analyse(m, winds, WINDS);
}

static void around(struct made *m, const struct wf_directions_request *q, struct wf_directions *out)
{
    if (wf_directions_run(&m->an, &m->options, q, &m->arena, out, &m->err)) fail_msg("%s", m->err.text);
}

static void names_of_directions(void **state)
{
    (void)state;
    struct wf_directions_request q = { .n = N };
    const double quarter = 0.5 * M_PI;
    for (int k = 0; k < 4; k++) { /* from north it blows towards -y, from east towards -x, ... */
        static const double to[4][2] = { { 0, -1 }, { -1, 0 }, { 0, 1 }, { 1, 0 } };
        double azimuth = wf_direction_azimuth(&q, k * quarter);
        assert_close(cos(azimuth), to[k][0], 1e-15);
        assert_close(sin(azimuth), to[k][1], 1e-15);
        assert_close(wf_direction_from(&q, azimuth), k * quarter, 1e-14);
    }
    q.north = quarter; /* north is +x: a wind from there blows towards -x */
    assert_close(cos(wf_direction_azimuth(&q, 0)), -1, 1e-15);
    assert_close(wf_direction_from(&q, M_PI), 0, 1e-14);
}

/* A direction is the same as the analysis with that azimuth; a straight stem knows no direction. */
static void each_direction_is_an_analysis(void **state)
{
    (void)state;
    struct made m, one;
    struct wf_directions straight, leaning;
    const struct wf_directions_request q = { .n = N };
    start(&m, 0, 0);
    analyse(&m, 0.3);
    around(&m, &q, &straight);
    for (size_t k = 0; k < N; k++) {
        assert_close(straight.direction[k].at[1].base_moment, m.an.at[1].base_moment,
                     1e-7 * m.an.at[1].base_moment);
        assert_close(straight.direction[k].breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed,
                     m.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, 1e-4);
    }
    wf_arena_free(&m.arena);
    start(&m, 0.2, 0.7);
    analyse(&m, 0);
    around(&m, &q, &leaning);
    double least = INFINITY, most = 0;
    for (size_t k = 0; k < N; k++) {
        start(&one, 0.2, 0.7);
        analyse(&one, wf_direction_azimuth(&q, leaning.direction[k].from));
        for (size_t w = 0; w < WINDS; w++) {
            /* on the meshes of eight directions */
            const double mesh = m.options.mesh_tolerance;
            assert_close(leaning.direction[k].at[w].base_moment, one.an.at[w].base_moment, mesh);
            assert_close(leaning.direction[k].at[w].tip_deflection, one.an.at[w].tip_deflection, mesh);
        }
        /* directions share their meshes */
        assert_close(leaning.direction[k].breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed,
                     one.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, 1e-6);
        least = fmin(least, one.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed),
        most = fmax(most, one.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed);
        wf_arena_free(&one.arena);
    }
    assert_true(most > 1.05 * least); /* a leaning tree is weaker to the wind in its back */
    wf_arena_free(&m.arena);
}

/* A straight stem of few rows is the same to all winds, sways and searches included: all have one mesh. */
static void alike_from_all_around(void **state)
{
    (void)state;
    struct made m;
    struct wf_directions all;
    const struct wf_directions_request q = { .n = N };
    made_read(&m, "species/weeping_willow.yaml", "models/culm.yaml");
    m.model.segments = 1, m.model.crown_base = 0;
    analyse(&m, 0);
    around(&m, &q, &all);
    for (size_t k = 0; k < N; k++) {
        const struct wf_critical *one = &all.direction[k].breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical,
                                 *first = &all.direction[0].breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
        assert_true(first->outcome == WF_CRITICAL_FOUND);
        assert_close(one->speed, first->speed, 1e-8);
        assert_close(all.direction[k].at[1].base_moment, all.direction[0].at[1].base_moment, 1e-8);
    }
    wf_arena_free(&m.arena);
}

/* Turning the tree turns the answers: leaning to the north instead of the east is a quarter back. */
/* Meshes of further directions are those of the first, in which other branches govern: critical winds of
 * branches are as accurate as specified all the same. */
static void branches_from_all_around(void **state)
{
    (void)state;
    static const double tolerance[2] = { 1e-6, 1e-8 };
    struct made m[2];
    struct wf_directions all[2];
    const struct wf_directions_request q = { .n = N };
    size_t found = 0;
    for (int k = 0; k < 2; k++) {
        made_read(&m[k], "species/lime.yaml", "models/papers/broadleaf_few_shoots.yaml");
        m[k].scenario.peak.method = "en1991";
        m[k].options.mesh_tolerance = tolerance[k];
        made_analyse(&m[k], (double[]){ 40 }, 1);
        around(&m[k], &q, &all[k]);
    }
    for (size_t i = 0; i < N; i++)
        for (int c = 0; c < WF_CRITERIA; c++) {
            const struct wf_critical *a = &all[0].direction[i].breaks[c][WF_SCOPE_BRANCHES].critical,
                                     *b = &all[1].direction[i].breaks[c][WF_SCOPE_BRANCHES].critical;
            assert_int_equal(a->outcome, b->outcome);
            if (a->outcome != WF_CRITICAL_FOUND) continue;
            assert_close(a->speed, b->speed, 1e-6);
            found++;
        }
    assert_true(found >= N);
    wf_arena_free(&m[0].arena), wf_arena_free(&m[1].arena);
}

static void the_tree_turned(void **state)
{
    (void)state;
    struct made a, b;
    struct wf_directions east, north;
    const struct wf_directions_request q = { .n = N };
    start(&a, 0.2, 0), start(&b, 0.2, 0.5 * M_PI);
    analyse(&a, 0), analyse(&b, 0);
    around(&a, &q, &east), around(&b, &q, &north);
    for (size_t k = 0; k < N; k++) {
        const struct wf_direction *x = &east.direction[(k + N / 4) % N], *y = &north.direction[k];
        assert_close(y->at[1].base_moment, x->at[1].base_moment, 1e-6 * x->at[1].base_moment);
        assert_close(y->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed,
                     x->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, 1e-3);
    }
    wf_arena_free(&a.arena), wf_arena_free(&b.arena);
}

static void any_number_of_threads(void **state)
{
    (void)state;
    struct made m;
    struct wf_directions one, four;
    start(&m, 0.2, 0.7);
    analyse(&m, 0);
    m.options.threads = 1;
    around(&m, &(struct wf_directions_request){ .n = N }, &one);
    m.options.threads = 4;
    around(&m, &(struct wf_directions_request){ .n = N }, &four);
    for (size_t k = 0; k < N; k++) {
        assert_memory_equal(one.direction[k].at, four.direction[k].at, WINDS * sizeof *one.direction[k].at);
        assert_memory_equal(one.direction[k].breaks, four.direction[k].breaks,
                            sizeof one.direction[k].breaks);
    }
    wf_arena_free(&m.arena);
}

/* A stem that breaks at one speed in every direction: the climate's share above that speed. */
static void hours_of_a_climate(void **state)
{
    (void)state;
    double column[4][N];
    struct wf_rose r = { N, column[0], column[1], column[2], column[3], 1, NULL };
    struct made m;
    struct wf_directions out;
    double factor;
    for (size_t k = 0; k < N; k++)
        r.frequency[k] = (double)(k + 1) / 36, r.scale[k] = 6 + 0.5 * (double)k, r.shape[k] = 1.5;
    start(&m, 0, 0);
    analyse(&m, 0);
    around(&m, &(struct wf_directions_request){ .n = N, .rose = &r, .law = "durst" }, &out);
    double speed = m.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed;
    assert_int_equal(wf_wind_average("durst", NULL, 1, 3600, 600, &factor, &m.err), WF_OK);
    assert_close(out.gust, factor, 1e-15);
    assert_true(factor > 1.04 && factor < 1.06); /* Durst 1960: 1.05 or so */
    assert_close(out.hourly, wf_rose_above(&r, speed), 1e-4 * out.hourly);
    assert_close(out.strongest, wf_rose_above(&r, speed / factor), 1e-4 * out.strongest);
    assert_true(out.hourly > 1e-6 && out.strongest > out.hourly && !out.above);
    wf_arena_free(&m.arena);
}

/* The factor of gusts is that of an analysis with the wind from there; in the mean wind it is 1. */
static void gusts_of_each_direction(void **state)
{
    (void)state;
    struct made m, one;
    struct wf_directions mean, peak;
    const struct wf_directions_request q = { .n = 4 };
    start(&m, 0.2, 0.7);
    analyse(&m, 0);
    around(&m, &q, &mean);
    m.scenario.peak.method = "en1991";
    analyse(&m, 0);
    around(&m, &q, &peak);
    for (size_t k = 0; k < q.n; k++) {
        start(&one, 0.2, 0.7);
        one.scenario.peak.method = "en1991";
        analyse(&one, wf_direction_azimuth(&q, peak.direction[k].from));
        for (size_t w = 0; w < WINDS; w++) {
            assert_close(mean.direction[k].gusts[w], 1, 1e-15);
            assert_true(peak.direction[k].gusts[w] > 1.5);
            assert_close(peak.direction[k].gusts[w], wf_peak_gusts(one.an.peak, winds[w]), 2e-3);
        }
        wf_arena_free(&one.arena);
    }
    wf_arena_free(&m.arena);
}

static void mistakes(void **state)
{
    (void)state;
    struct made m;
    struct wf_directions out;
    struct wf_rose r = { .sectors = 12 };
    struct wf_err e[3] = { { 0 } };
    start(&m, 0, 0);
    analyse(&m, 0);
    const struct wf_directions_request bad[] = { { .n = 1 },
                                                 { .n = 8, .rose = &r, .law = "durst" },
                                                 { .n = 12, .rose = &r, .law = "drst" } };
    static const char *const say[] = { "2..360", "the climate has 12 directions", "did you mean 'durst'" };
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(wf_directions_run(&m.an, &m.options, &bad[k], &m.arena, &out, &e[k]), WF_EUSAGE);
        assert_non_null(strstr(e[k].text, say[k]));
    }
    wf_arena_free(&m.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_of_directions),      cmocka_unit_test(each_direction_is_an_analysis),
        cmocka_unit_test(the_tree_turned),          cmocka_unit_test(alike_from_all_around),
        cmocka_unit_test(branches_from_all_around), cmocka_unit_test(any_number_of_threads),
        cmocka_unit_test(hours_of_a_climate),       cmocka_unit_test(mistakes),
        cmocka_unit_test(gusts_of_each_direction)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
