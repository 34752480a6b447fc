/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Winds named by a scale; averaging times. */
#include "close.h"
#include "wind/category.h"
#include "wind/climate.h"
#include <string.h>

static void grades(void **state)
{
    (void)state;
    struct wf_scale_wind w;
    struct wf_err e = { 0 };
    assert_int_equal(wf_wind_scale_parse("beaufort:8", &w, &e), WF_OK);
    assert_close(w.speed, 19.0, 1e-12);
    assert_string_equal(w.grade->text, "gale");
    assert_close(w.scale->averaging, 600, 0);
    assert_int_equal(wf_wind_scale_parse("CMA:Typhoon", &w, &e), WF_OK);
    assert_close(w.speed, 37.1, 1e-12);
    assert_close(w.scale->averaging, 120, 0);
    assert_int_equal(wf_wind_scale_parse("cma:super-typhoon", &w, &e), WF_OK);
    assert_close(w.speed, 51.0, 1e-12); /* no upper bound */
    assert_int_equal(wf_wind_scale_parse("hko:typhoon", &w, &e), WF_OK);
    assert_close(w.grade->low, 118.0 / 3.6, 1e-12);
}

/* Grades join without a gap, and the middle of Beaufort B is near 0.836 B^1.5. */
static void scales_are_whole(void **state)
{
    (void)state;
    for (const struct wf_wind_scale *s = wf_wind_scales; s->name; s++)
        for (const struct wf_wind_grade *g = s->grade; g->name; g++) {
            assert_true(g->low < g->high);
            if (g[1].name) assert_true(g->high == g[1].low);
            assert_ptr_equal(wf_wind_scale_grade(s, g->low), g);
        }
    const struct wf_wind_grade *g = wf_wind_scales[0].grade;
    for (int b = 2; b <= 12; b++)
        assert_close(0.5 * (g[b].low + g[b].high), 0.836 * pow(b, 1.5), b < 4 ? 0.07 : 0.025);
    assert_null(wf_wind_scale_grade(&wf_wind_scales[1], 5.0));
    assert_string_equal(wf_wind_scale_grade(&wf_wind_scales[0], 10.0)->text, "fresh breeze");
}

static void mistakes(void **state)
{
    (void)state;
    struct wf_scale_wind w;
    struct wf_err e = { 0 }, f = { 0 }, g = { 0 };
    assert_int_equal(wf_wind_scale_parse("beaufrot:8", &w, &e), WF_EUSAGE);
    assert_non_null(strstr(e.text, "did you mean 'beaufort'"));
    assert_int_equal(wf_wind_scale_parse("cma:typhon", &w, &f), WF_EUSAGE);
    assert_non_null(strstr(f.text, "did you mean 'typhoon'"));
    assert_int_equal(wf_wind_scale_parse("beaufort:33", &w, &g), WF_EUSAGE);
    assert_non_null(strstr(g.text, "33"));
    assert_true(wf_wind_scale_is("cma:typhoon") && !wf_wind_scale_is("10 m/s") &&
                !wf_wind_scale_is("5:40:1"));
}

static double to(const char *law, double speed, double from, double over)
{
    double out = NAN;
    struct wf_err e = { 0 };
    if (wf_wind_average(law, NULL, speed, from, over, &out, &e)) fail_msg("%s", e.text);
    return out;
}

static void averaging(void **state)
{
    (void)state;
    /* Durst's curve: 3 s 1.51 to 1.53, 10 min 1.05 to 1.07, 1 min 1.24 of the hourly mean */
    assert_close(to("durst", 1.0, 3600, 3), 1.52, 0.01);
    assert_close(to("durst", 1.0, 3600, 60), 1.24, 0.01);
    assert_close(to("durst", 1.0, 3600, 600), 1.06, 0.015);
    assert_close(to("durst", to("durst", 20.0, 600, 3), 3, 600), 20.0, 1e-12);
    assert_close(to("in-land", 20.0, 600, 3), 33.2, 1e-12);
    assert_close(to("in-land", 33.2, 3, 600), 20.0, 1e-12);
    assert_close(to("at-sea", 30.0, 600, 120), 30.6, 1e-12);
    for (const struct wf_averaging_law *l = wf_averaging_laws; l->name; l++) {
        double before = INFINITY;
        if (!strcmp(l->name, "en1991")) continue; /* below */
        static const double t[] = { 3, 60, 120, 180, 600, 3600 };
        for (int i = 0; i < 6; i++) { /* the longer the gust, the weaker */
            double speed = to(l->name, 10.0, 3600, t[i]);
            assert_true(speed < before && speed > 9.99);
            before = speed;
        }
    }
    double out;
    struct wf_err e = { 0 }, f = { 0 };
    assert_int_equal(wf_wind_average("durts", NULL, 10, 600, 3, &out, &e), WF_EUSAGE);
    assert_non_null(strstr(e.text, "did you mean 'durst'"));
    assert_int_equal(wf_wind_average("at-sea", NULL, 10, 600, 7, &out, &f), WF_EUSAGE);
    assert_non_null(strstr(f.text, "tabulated"));
}

/* A gust that is typed comes back: sqrt(1 + 7 I_v) of the terrain where it was measured, both ways. */
static void gusts(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    assert_string_equal(wf_averaging_usual(3), "en1991");
    assert_string_equal(wf_averaging_usual(60), "durst");
    for (const struct wf_category *c = wf_categories; c->name; c++) {
        const struct wf_wind_place at = { c, 10.0 };
        double mean = NAN, gust = NAN, turbulence = 1 / log(10 / c->roughness);
        assert_int_equal(wf_wind_average("en1991", &at, 36, 3, 600, &mean, &e), WF_OK);
        assert_int_equal(wf_wind_average("en1991", &at, mean, 600, 3, &gust, &e), WF_OK);
        assert_close(gust, 36, 1e-12);
        assert_close(mean * mean * (1 + 7 * turbulence), 36 * 36, 1e-9);
    }
    assert_close(to("en1991", 36, 3, 600), 23.628, 1e-4); /* open country; 36 / 1.5236 */
    assert_int_equal(wf_wind_average("en1991", NULL, 10, 600, 60, &(double){ 0 }, &e), WF_EUSAGE);
    assert_non_null(strstr(e.text, "gusts of 3 s"));
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(grades), cmocka_unit_test(scales_are_whole),
                                        cmocka_unit_test(mistakes), cmocka_unit_test(averaging),
                                        cmocka_unit_test(gusts) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
