/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gusts given by a formula, what a specification may hold, and what is said of one that is wrong. */
#include "close.h"
#include "wind/gust.h"
#include "wind/gust_report.h"
#include "wind/noise.h"
#include "wind/spectrum.h"
#include <stdlib.h>
#include <string.h>

static struct wf_arena arena;
static struct wf_diag diag;
static struct wf_err err;

static int clean(void **state)
{
    (void)state;
    wf_arena_free(&arena);
    diag = (struct wf_diag){ .arena = &arena };
    memset(&err, 0, sizeof err);
    return 0;
}

static struct wf_gust_spec named(const char *model, size_t steps)
{
    struct wf_gust_spec s;
    wf_gust_spec_default(wf_gust_named(model), &s);
    s.steps = steps;
    return s;
}

static double *run(const struct wf_gust_spec *s)
{
    struct wf_gust g;
    if (wf_gust_open(s, &arena, &diag, &g, &err)) fail_msg("%s", err.text);
    double *block = WF_TAKE(&arena, s->components * s->points * g.block, double),
           *x = WF_TAKE(&arena, s->steps, double);
    assert_int_equal(wf_gust_history(&g, 0, 0, block, x, &err), WF_OK);
    wf_gust_close(&g);
    return x;
}

/* Whole periods: mean and intensity are exact, and the phase stays as it was drawn. */
static void cosine(void **state)
{
    (void)state;
    struct wf_gust_spec s = named("cosine", 2000);
    struct wf_gust_stats got;
    double *x = run(&s);
    assert_int_equal(wf_gust_stats(x, s.steps, s.step, 3, 600, &arena, &got, &err), WF_OK);
    assert_close(got.mean, 10.0, 1e-12);
    assert_close(got.intensity, 0.2, 1e-12);
    assert_close(got.high, 10 * (1 + 0.2 * sqrt(2)), 1e-3);
    for (size_t i = 0; i + 200 < s.steps; i++) assert_true(fabs(x[i + 200] - x[i]) < 1e-9);
    double first = x[0];
    s.seed = 2;
    assert_true(fabs(run(&s)[0] - first) > 1e-6);
}

/* As printed: the sine alone swings from 0 to twice the mean, the noise adds 0..epsilon. */
static void zhao_as_printed(void **state)
{
    (void)state;
    struct wf_gust_spec s = named("sine-perlin-as-printed", 24000);
    s.step = 1.0 / 61.0; /* a frame */
    assert_int_equal(wf_gust_set(&s, "epsilon", 0, &err), WF_OK);
    double *x = run(&s);
    for (size_t i = 0; i < s.steps; i++)
        assert_true(fabs(x[i] - (10 + 10 * sin(3.14 / 120 * (double)i))) < 1e-9);
    assert_int_equal(wf_gust_set(&s, "epsilon", 4, &err), WF_OK);
    double *y = run(&s), shift = 0;
    for (size_t i = 0; i < s.steps; i++) {
        assert_true(y[i] >= x[i] && y[i] <= x[i] + 4);
        shift += (y[i] - x[i]) / (double)s.steps;
    }
    assert_close(shift, 2.0, 0.05);
    assert_int_equal(diag.warnings, 1);
    assert_string_equal(diag.first->code, "as-printed");
    assert_close(sqrt(wf_gust_variance(&s, 0, WF_ALONG)) / 10, 0.7145, 1e-3);
}

static void zhao_corrected(void **state)
{
    (void)state;
    struct wf_gust_spec s = named("sine-perlin", 1 << 16);
    struct wf_gust_stats got;
    assert_int_equal(wf_gust_stats(run(&s), s.steps, s.step, 3, 600, &arena, &got, &err), WF_OK);
    assert_close(got.mean, 10, 0.01);
    assert_close(got.intensity, 0.2, 0.06);
    assert_int_equal(diag.warnings, 0);
}

/* Within the documented range, and falling as f^-(1+2H) through the band of its octaves. */
static void perlin(void **state)
{
    (void)state;
    enum { N = 1 << 16, BANDS = 64 };
    struct wf_gust_spec s = named("perlin", N);
    struct wf_octaves o;
    struct wf_band band[BANDS];
    size_t bands = wf_bands(N, s.step, 10, band, BANDS);
    double *mean = WF_TAKE(&arena, N / 2 + 1, double), *one = WF_TAKE(&arena, N / 2 + 1, double);
    wf_gust_octaves(&s, &o);
    double bound = 2.0 * wf_noise_range(&o) / sqrt(wf_noise_variance(&o));
    for (s.seed = 1; s.seed <= 4; s.seed++) {
        double *x = run(&s);
        for (size_t i = 0; i < N; i++) assert_true(fabs(x[i] - 10) <= bound);
        assert_int_equal(wf_spectrum_welch(x, N, s.step, N, one, NULL, &arena, &err), WF_OK);
        for (size_t k = 0; k <= N / 2; k++) mean[k] += one[k];
    }
    /* 30 s lattice, six octaves: 1/30 Hz to 32/30 Hz */
    assert_close(wf_spectrum_slope(band, bands, mean, 1.0 / 30, 32.0 / 30), -5.0 / 3.0, 0.12);
}

/* IEC's gust: the crest is 0.74 of the amplitude above the mean in its middle, the whole range 1 amplitude.
 */
static void extreme_gust(void **state)
{
    (void)state;
    struct wf_gust_spec s = named("eog", 4000);
    s.step = 0.01;
    double *x = run(&s), low = INFINITY, high = -INFINITY, a = wf_gust_eog_amplitude(&s);
    assert_close(a, 3.3 * 2.0 / (1 + 0.1 * 5 / 7.0), 1e-12);
    for (size_t i = 0; i < s.steps; i++) low = fmin(low, x[i]), high = fmax(high, x[i]);
    assert_close(high - 10, 0.74 * a, 1e-6);
    assert_close(x[500 + 525], high, 1e-6);
    assert_close(high - low, a, 0.01);
    assert_true(x[499] == 10 && x[500 + 1051] == 10);
    assert_int_equal(wf_gust_set(&s, "annual-extreme", 13, &err), WF_OK);
    assert_close(wf_gust_eog_amplitude(&s), 1.35 * 3, 1e-12);
}

static void refuse(struct wf_gust_spec s, const char *say)
{
    struct wf_gust g;
    clean(NULL);
    assert_int_equal(wf_gust_open(&s, &arena, &diag, &g, &err), WF_EUSAGE);
    for (struct wf_finding *f = diag.first; f; f = f->next)
        if (strstr(f->text, say)) return;
    fail_msg("nothing is said of '%s' but: %s", say, diag.first ? diag.first->text : err.text);
}

static void mistakes(void **state)
{
    (void)state;
    struct wf_gust_spec good = named("kaimal", 1000), s;
    const double far_away[3] = { 0, 0, -5 };
    s = good, s.intensity = 5, refuse(s, "turbulence intensity = 5 is outside 0..1");
    s = good, s.intensity = NAN, refuse(s, "turbulence intensity");
    s = good, s.points = 0, refuse(s, "points = 0 is outside 1..20000");
    s = good, s.points = 4, refuse(s, "4 points need places");
    s = good, s.place = far_away, refuse(s, "point 0");
    s = good, s.speed = -3, refuse(s, "wind speed = -3");
    s = good, s.step = 0, refuse(s, "step = 0");
    s = good, s.steps = 0, refuse(s, "steps = 0");
    s = good, s.components = 2, refuse(s, "1 or 3");
    s = good, s.block = 1000, refuse(s, "power of two");
    s = good, s.height = -1, refuse(s, "height = -1");
    s = named("von-karman", 1000), s.value[0] = -60, refuse(s, "length = -60 is outside 1..1000 m");
    s = named("davenport", 1000), s.components = 3, refuse(s, "kaimal, von-karman or record");
    s = named("one-over-f", 1000), s.step = 10, s.value[1] = 0.5, refuse(s, "half the sampling frequency");
    s = named("record", 1000), refuse(s, "needs a file");
    clean(NULL);
    s = good, s.intensity = 5, s.step = -1, s.points = 0;
    struct wf_gust g;
    assert_int_equal(wf_gust_open(&s, &arena, &diag, &g, &err), WF_EUSAGE);
    assert_int_equal(diag.errors, 3); /* all at once */
    static const char *const set[][2] = { { "decay-upp", "did you mean 'decay-up'" },
                                          { "wavelength", "it has" } };
    for (int i = 0; i < 2; i++) {
        clean(NULL);
        assert_int_equal(wf_gust_set(&good, set[i][0], 1, &err), WF_EUSAGE);
        assert_non_null(strstr(err.text, set[i][1]));
    }
    clean(NULL);
    assert_int_equal(wf_gust_set(&good, "decay-up", -1, &err), WF_EUSAGE);
    assert_non_null(strstr(err.text, "outside 0..100"));
}

static void warnings(void **state)
{
    (void)state;
    struct wf_gust_spec s = named("kaimal", 100);
    s.intensity = 0.5;
    s.height = 1;
    run(&s);
    assert_int_equal(diag.warnings, 2);
    assert_string_equal(diag.first->code, "gaussian");
    assert_string_equal(diag.last->code, "spectrum-height");
}

/* Memory that runs out at any point is refused cleanly. */
static void little_memory(void **state)
{
    (void)state;
    struct wf_gust_spec s = named("kaimal", 100);
    struct wf_gust g;
    size_t refused = 0;
    s.block = 64;
    s.components = 3;
    for (size_t limit = 1;; limit += 1777) {
        struct wf_arena a = { .limit = limit };
        struct wf_diag d = { .arena = &a };
        struct wf_err e = { 0 };
        enum wf_status status = wf_gust_open(&s, &a, &d, &g, &e);
        wf_gust_close(&g);
        wf_arena_free(&a);
        if (!status) break;
        assert_int_equal(status, WF_ENOMEM);
        refused++;
    }
    assert_true(refused > 3);
}

/* The report finds every shipped model to do what it is asked, and tells when one does not. */
static void reports(void **state)
{
    (void)state;
    static const double place[6] = { 0, 0, 10, 0, 4, 10 };
    for (const struct wf_gust_model *m = wf_gust_models; m->name; m++) {
        struct wf_gust_spec s = named(m->name, 20000);
        struct wf_gust_report r;
        clean(NULL);
        if (strcmp(m->name, "record") == 0) continue;
        s.points = 2;
        s.place = place;
        assert_int_equal(wf_gust_report_make(&s, &arena, &diag, &r, &err), WF_OK);
        assert_int_equal(r.findings, m->spectrum                   ? (strcmp(m->name, "one-over-f") ? 4 : 5)
                                     : strcmp(m->name, "eog") == 0 ? 0
                                     : strcmp(m->name, "perlin") == 0 ? 3
                                                                      : 2);
        for (size_t i = 0; i < r.findings; i++)
            if (!r.finding[i].within)
                fail_msg("%s: %s: asked %g, got %g", m->name, r.finding[i].name, r.finding[i].asked,
                         r.finding[i].got);
        size_t all = 0;
        for (int b = 0; b < WF_REPORT_BINS; b++) all += r.bin[b];
        assert_int_equal(all, s.steps);
        assert_int_equal(r.pairs, 1);
        if (m->spectrum)
            assert_true(r.coherence_error < 1e-3 && r.joint < 0.05);
        else
            assert_close(r.coherence[0], 1.0, 1e-9); /* one wind for all points */
        assert_close(r.apart[0], 4.0, 1e-12);
    }
}

static void rows_are_complete(void **state)
{
    (void)state;
    for (const struct wf_gust_model *m = wf_gust_models; m->name; m++) {
        assert_true(m->title && m->source && m->validity && m->par && m->open && m->fill);
        assert_ptr_equal(wf_gust_named(m->name), m);
        size_t n = 0;
        for (; m->par[n].name; n++)
            assert_true(m->par[n].low <= m->par[n].fallback && m->par[n].fallback <= m->par[n].high &&
                        m->par[n].help);
        assert_true(n <= WF_GUST_PARS);
    }
    assert_null(wf_gust_named("kaimall"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(cosine, clean, clean),
        cmocka_unit_test_setup_teardown(zhao_as_printed, clean, clean),
        cmocka_unit_test_setup_teardown(zhao_corrected, clean, clean),
        cmocka_unit_test_setup_teardown(perlin, clean, clean),
        cmocka_unit_test_setup_teardown(extreme_gust, clean, clean),
        cmocka_unit_test_setup_teardown(mistakes, clean, clean),
        cmocka_unit_test_setup_teardown(warnings, clean, clean),
        cmocka_unit_test_setup_teardown(little_memory, clean, clean),
        cmocka_unit_test_setup_teardown(reports, clean, clean),
        cmocka_unit_test_setup_teardown(rows_are_complete, clean, clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
