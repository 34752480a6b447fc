/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time series of balances: steady wind is one answer, a gust follows it, trends of the papers hold. */
#include "base/file.h"
#include "close.h"
#include "data/species.h"
#include "out/series.h"
#include "scratch.h"
#include "series_cases.h"
#include <stdlib.h>
#include <string.h>

static double deflection(struct made *m)
{
    if (try(m)) fail_msg("%s", m->err.text);
    return m->series.deflection[0];
}

/* Faster wind or softer culm bends more, by beam theory and as printed. */
static void trends_of_tang(void **state)
{
    (void)state;
    for (int printed = 0; printed < 2; printed++) {
        struct made m;
        start(&m, "species/moso_bamboo.yaml", "models/papers/moso_few_segments.yaml");
        m.run.preset = printed ? "tang2012" : "corrected";
        m.run.youngs = 10e9;
        double slow = deflection(&m);
        m.run.wind = 15;
        double fast = deflection(&m);
        m.run.wind = 12;
        double stiff = deflection(&m);
        m.run.youngs = 8e9;
        double soft = deflection(&m);
        assert_true(slow < stiff && stiff < fast && stiff < soft);
        if (printed) assert_close(fast / slow, 2.25, 0.01); /* U^2, no weight; a little by the drag law */
        if (printed) assert_close(soft / stiff, 10. / 8, 1e-9);
        wf_arena_free(&m.arena);
    }
}

static const char *found(const struct made *m, const char *code)
{
    for (const struct wf_finding *f = m->diag.first; f; f = f->next)
        if (f->code && !strcmp(f->code, code)) return f->text;
    return NULL;
}

/* A steady wind is one balance, drawn once and said; the deflect scheme settles, so its frames stay. */
static void steady_is_one_frame(void **state)
{
    (void)state;
    struct made m;
    start(&m, "species/moso_bamboo.yaml", "models/moso_culm.yaml");
    double alone = deflection(&m);
    m.run.duration = 10, m.run.keys = 8;
    assert_null(found(&m, "steady-wind"));
    assert_close(deflection(&m), alone, 0);
    assert_true(m.series.frames == 20 && m.series.spec.keys == 1);
    for (size_t k = 0; k < 20; k++) {
        assert_close(m.series.deflection[k], alone, 0);
        assert_close(m.series.safety[k], m.series.safety[0], 0);
    }
    assert_non_null(found(&m, "steady-wind"));
    m.run.solver = "deflect", m.run.damping = 0.1;
    if (try(&m)) fail_msg("%s", m.err.text);
    assert_true(m.series.spec.keys == 8 && isnan(m.series.safety[0]));
    wf_arena_free(&m.arena);
}

/* From the first frame whose stress reaches the strength on, frames are beyond breakage; a gust before is
 * not. */
static void beyond_breakage(void **state)
{
    (void)state;
    struct made m;
    start(&m, "species/moso_bamboo.yaml", "models/moso_culm.yaml");
    m.run.gust = "cosine", m.run.intensity = 0.5, m.run.period = 10, m.run.duration = 10, m.run.keys = 4;
    if (try(&m)) fail_msg("%s", m.err.text);
    assert_true(m.series.broken == m.series.frames && m.series.safety[0] > 1);
    assert_null(found(&m, "broken"));
    m.run.wind = 24; /* beyond 20 m/s the crown is held; the culm splits */
    if (try(&m)) fail_msg("%s", m.err.text);
    const struct wf_series *s = &m.series;
    assert_true(s->broken > 0 && s->broken < s->frames);
    assert_true(s->safety[s->broken] <= 1 && s->safety[s->broken - 1] > 1);
    assert_non_null(found(&m, "broken"));
    wf_arena_free(&m.arena);
}

static void wind_and_tip(void **state)
{
    (void)state;
    struct made m;
    start(&m, "species/moso_bamboo.yaml", "models/moso_culm.yaml");
    m.run.gust = "cosine", m.run.intensity = 0.2, m.run.period = 10, m.run.duration = 10, m.run.keys = 4;
    if (try(&m)) fail_msg("%s", m.err.text);
    const struct wf_series *s = &m.series;
    assert_int_equal(s->frames, 20);
    assert_true(s->failed == 0 && s->key[0] == 0 && s->key[3] == 15);
    for (size_t i = 0; i < 20; i++)
        for (size_t k = 0; k < 20; k++)
            if (s->wind[i] > s->wind[k] + 1e-9) assert_true(s->deflection[i] > s->deflection[k]);
    double low = 1e9, high = 0; /* amplitude of the stem from its own place */
    for (size_t k = 0; k < 20; k++) {
        double x = s->place[(k * s->an.tree.n + s->tip) * 3];
        low = fmin(low, x), high = fmax(high, x);
    }
    assert_close(s->level[0].swing_mean, 0.5 * (high - low), 1e-12);
    wf_arena_free(&m.arena);
}

static void deflect_keeps_its_memory(void **state)
{
    (void)state;
    struct made m;
    start(&m, "species/poplar.yaml", "models/moso_culm.yaml");
    m.run.preset = "zhao2013", m.run.duration = 30, m.run.restoring = 0.4;
    if (try(&m)) fail_msg("%s", m.err.text);
    const double *d = m.series.deflection;
    assert_true(d[1] < d[0] && d[2] > d[1]);   /* F1, then F1 (1 - k), ... */
    assert_close(d[59] / d[0], 1 / 1.4, 1e-3); /* and at last F1/(1 + k)   */
    m.run.restoring = 1;
    assert_int_equal(try(&m), WF_EUSAGE);
    m.run.preset = "corrected", m.run.restoring = 0.4;
    assert_int_equal(try(&m), WF_EUSAGE); /* the beam has no such factor */
    wf_arena_free(&m.arena);
}

static void presets_tell_their_departures(void **state)
{
    (void)state;
    static const char *const preset[] = { "tang2012", "feng1999", "zhao2013" };
    static const char *const code[] = { "no-moment", "modulus-outlier", "r-cubed" };
    for (int k = 0; k < 3; k++) {
        struct made m;
        bool found = false;
        start(&m, k == 1 ? "species/willow_feng1999.yaml" : "species/poplar.yaml", "models/moso_culm.yaml");
        m.run.preset = preset[k], m.run.wind = 1;
        m.model.radius = 0.05, m.model.height = 3, m.model.crown_base = 1, m.model.crown_top = 3;
        m.model.leaf_area = 0.2;
        if (try(&m)) fail_msg("%s", m.err.text);
        assert_true(m.spec.solver->as_printed);
        for (const struct wf_finding *f = m.diag.first; f; f = f->next)
            found = found || (f->code && !strcmp(f->code, code[k]));
        assert_true(found);
        wf_arena_free(&m.arena);
    }
}

static void words_that_name_nothing(void **state)
{
    (void)state;
    struct made m;
    start(&m, "species/poplar.yaml", "models/moso_culm.yaml");
    for (int k = 0; k < 4; k++) {
        struct wf_series_plan_run kept = m.run;
        *(k == 0   ? &m.run.preset
          : k == 1 ? &m.run.solver
          : k == 2 ? &m.run.gust
                   : &m.run.shelter) = "nonesuch";
        assert_int_equal(try(&m), WF_EUSAGE);
        assert_non_null(strstr(m.err.text, "nonesuch"));
        m.run = kept;
    }
    wf_arena_free(&m.arena);
}

static void shipped_plans(void **state)
{
    (void)state;
    static const char *const name[] = { "tang2012", "feng1999", "zhao2013" };
    for (int k = 0; k < 3; k++) {
        struct wf_arena a = { 0 };
        struct wf_diag d = { .arena = &a };
        struct wf_err e = { 0 };
        struct wf_series_plan plan;
        char path[100];
        snprintf(path, sizeof path, "models/papers/%s.yaml", name[k]);
        if (wf_series_plan_read(path, &a, &plan, &d, &e)) fail_msg("%s", d.first ? d.first->text : e.text);
        assert_string_equal(plan.key, name[k]);
        assert_true(plan.runs >= 3);
        wf_arena_free(&a);
    }
}

static void leaves_swing_with_the_wind(void **state)
{
    (void)state;
    double far[2];
    for (int k = 0; k < 2; k++) {
        struct made m;
        start(&m, "species/poplar.yaml", "models/zhao2013_ifs.yaml");
        m.run.wind = k ? 4 : 2, m.run.solver = "deflect", m.run.profile.name = "uniform";
        for (size_t i = 0; i < m.species.levels; i++)
            m.species.level[i].youngs_modulus.value = 1e15; /* stiff */
        if (try(&m)) fail_msg("%s", m.err.text);
        size_t n = m.series.leaves.n;
        assert_int_equal(n, 800);
        double *at = WF_TAKE(&m.arena, 3 * n, double), *tip = WF_TAKE(&m.arena, 3 * n, double), turn = 0;
        wf_series_leaves(&m.series, 0, at, tip);
        for (size_t i = 0; i < n; i++) {
            double length = 0, z = tip[3 * i + 2] - at[3 * i + 2];
            for (size_t x = 0; x < 3; x++) length += pow(tip[3 * i + x] - at[3 * i + x], 2);
            assert_close(length, m.series.leaves.area[i], 1e-9);
            turn += fabs(acos(z / sqrt(length)) - acos(m.series.leaves.direction[3 * i + 2]));
        }
        far[k] = turn / (double)n;
        wf_arena_free(&m.arena);
    }
    assert_true(far[1] > 1.8 * far[0] && far[1] < 2.2 * far[0]); /* but for leaves that reach the vertical */
}

static void files(void **state)
{
    (void)state;
    struct made m;
    struct scratch s;
    char folder[300], path[400], command[600];
    start(&m, "species/moso_bamboo.yaml", "models/moso_culm.yaml");
    m.run.gust = "cosine", m.run.duration = 5, m.run.keys = 2;
    if (try(&m)) fail_msg("%s", m.err.text);
    scratch_write(&s, "", 0);
    snprintf(folder, sizeof folder, "%s.d", s.path);
    const struct wf_series_page_run run = { &m.series, &m.diag };
    const struct wf_series_page page = {
        .title = "t", .command = "c", .date = "d", .version = "v", .n = 1, .run = &run
    };
    if (wf_series_tables(&page, folder, &m.err)) fail_msg("%s", m.err.text);
    if (wf_series_vtk(&page, folder, &m.err)) fail_msg("%s", m.err.text);
    static const char *const name[] = { "tables/series.csv", "tables/frames.csv", "tables/trajectories.csv" };
    size_t n = m.series.an.tree.n;
    const size_t rows[] = { 10, 3 * n, 10 * n };
    for (int k = 0; k < 3; k++) assert_int_equal(lines(folder, name[k], &m.arena), rows[k] + 1);
    struct wf_bytes b;
    snprintf(path, sizeof path, "%s/vtk/run1_00003.vtp", folder);
    if (wf_file_read(path, &m.arena, &b, &m.err)) fail_msg("%s", m.err.text);
    assert_non_null(strstr(b.data, "</VTKFile>"));
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
    scratch_remove(&s);
    wf_arena_free(&m.arena);
}

/* A recorded wind that blows level from the side by turns: each frame is the answer to that wind, and a wind
 * of three components bends the tree off the plane of its mean. */
static void winds_that_turn(void **state)
{
    (void)state;
    enum { FRAMES = 24 };
    struct made m, one;
    char path[] = "/tmp/windfirm-test-XXXXXX";
    FILE *f = fdopen(mkstemp(path), "w");
    assert_non_null(f);
    fputs("t_s,u_ms,v_ms,w_ms\n", f);
    for (int k = 0; k < FRAMES; k++)
        fprintf(f, "%g,6,%d,%g\n", 0.5 * k, k % 4 < 2 ? 3 : -3, k % 2 ? 0.5 : -0.5);
    fclose(f);
    start(&m, "species/weeping_willow.yaml", "models/culm.yaml");
    m.run.gust = "record", m.run.file = path, m.run.duration = FRAMES * 0.5, m.run.profile.name = "uniform";
    if (try(&m)) fail_msg("%s", m.err.text);
    const struct wf_series *s = &m.series;
    assert_non_null(s->across);
    size_t n = s->an.tree.n, tip = 3 * s->tip;
    for (size_t k = 0; k < 4; k++) { /* the same wind straight ahead bends as far */
        double level = hypot(s->wind[k], s->across[k]);
        assert_close(s->wind[k], 6, 1e-9);
        assert_close(fabs(s->across[k]), 3, 1e-9);
        start(&one, "species/weeping_willow.yaml", "models/culm.yaml");
        one.run.wind = level, one.run.profile.name = "uniform";
        double far = deflection(&one);
        assert_close(s->deflection[k], far, 0.02 * far); /* the rising part changes it a little */
        const double *p = s->place + 3 * n * k + tip;
        assert_close(atan2(p[1], p[0]), atan2(s->across[k], s->wind[k]), 1e-3);
        wf_arena_free(&one.arena);
    }
    m.run.components = 1; /* along the wind only: the tip stays in the plane */
    if (try(&m)) fail_msg("%s", m.err.text);
    assert_null(m.series.across);
    assert_close(m.series.place[tip + 1], 0, 1e-9);
    m.run.components = 0, m.run.solver = "deflect"; /* has one direction, and says so */
    if (try(&m)) fail_msg("%s", m.err.text);
    assert_null(m.series.across);
    const struct wf_finding *w = m.diag.first;
    while (w && strcmp(w->code ? w->code : "", "along-wind-only") != 0) w = w->next;
    assert_non_null(w);
    unlink(path);
    wf_arena_free(&m.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(trends_of_tang),
        cmocka_unit_test(steady_is_one_frame),
        cmocka_unit_test(beyond_breakage),
        cmocka_unit_test(wind_and_tip),
        cmocka_unit_test(deflect_keeps_its_memory),
        cmocka_unit_test(presets_tell_their_departures),
        cmocka_unit_test(words_that_name_nothing),
        cmocka_unit_test(shipped_plans),
        cmocka_unit_test(leaves_swing_with_the_wind),
        cmocka_unit_test(winds_that_turn),
        cmocka_unit_test(files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
