/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wind profiles and air. */
#include "close.h"
#include "wind/wind.h"
#include <string.h>

static struct wf_wind blowing(const char *name)
{
    return (struct wf_wind){ .sample = wf_profile_named(name)->sample,
                             .speed = 20,
                             .direction = { 0.6, 0.8, 0 },
                             .reference_height = 10,
                             .roughness = 0.1,
                             .displacement = 1.5,
                             .exponent = 0.16 };
}

static double speed_at(const struct wf_wind *w, double z, double *slope)
{
    double x[3] = { 3, -4, z }, u[3], du[9];
    w->sample(w, x, u, du);
    assert_close(u[2], 0, 0);
    assert_close(u[0] * 0.8 - u[1] * 0.6, 0, 1e-13);
    for (int i = 0; i < 3; i++) assert_true(du[3 * i] == 0 && du[3 * i + 1] == 0);
    *slope = du[2] * 0.6 + du[5] * 0.8;
    return u[0] * 0.6 + u[1] * 0.8;
}

static void reference_height_has_the_named_speed(void **state)
{
    (void)state;
    double slope;
    for (const struct wf_profile *p = wf_profiles; p->name; p++) {
        if (p->sample == wf_measured_sample) continue; /* needs a file: test_gust_profiles */
        struct wf_wind w = blowing(p->name);
        assert_close(speed_at(&w, 10, &slope), 20, 1e-14);
        assert_true(p->source && p->validity && wf_profile_named(p->name) == p);
    }
    assert_null(wf_profile_named("logarithm"));
    assert_null(wf_profile_named(NULL));
}

static void closed_forms(void **state)
{
    (void)state;
    double slope;
    struct wf_wind w = blowing("log");
    assert_close(speed_at(&w, 5, &slope), 20 * log(35) / log(85), 1e-14);
    assert_close(slope, 20 / log(85) / 3.5, 1e-14);
    w = blowing("power");
    assert_close(speed_at(&w, 5, &slope), 20 * pow(0.5, 0.16), 1e-14);
    assert_close(slope, 20 * 0.16 * pow(0.5, 0.16) / 5, 1e-14);
    w = blowing("terrain");
    w.roughness = 0.3, w.least = 5;
    assert_close(speed_at(&w, 20, &slope), 20 * log(20 / 0.3) / log(10 / 0.3), 1e-14);
    assert_close(slope, 20 / log(10 / 0.3) / 20, 1e-14);
    assert_close(speed_at(&w, 5, &slope), 20 * log(5 / 0.3) / log(10 / 0.3), 1e-14);
    assert_close(speed_at(&w, -1, &slope), 20 * log(5 / 0.3) / log(10 / 0.3), 1e-14);
    assert_close(slope, 0, 0);
    w = blowing("code"); /* the speed named is that of the lowest height */
    w.exponent = 0.22, w.least = 15;
    assert_close(speed_at(&w, 2, &slope), 20, 1e-14);
    assert_close(slope, 0, 0);
    assert_close(speed_at(&w, 30, &slope), 20 * pow(2, 0.22), 1e-14);
    assert_close(slope, 0.22 * 20 * pow(2, 0.22) / 30, 1e-14);
    w = blowing("uniform");
    assert_close(speed_at(&w, -3, &slope), 20, 1e-14);
    assert_close(slope, 0, 0);
}

static void calm_below_the_ground(void **state)
{
    (void)state;
    double slope;
    struct wf_wind w = blowing("log");
    for (double z = -2; z <= 1.6; z += 0.1) {
        assert_close(speed_at(&w, z, &slope), 0, 0);
        assert_close(slope, 0, 0);
    }
    w = blowing("power");
    for (double z = -2; z <= 0; z += 0.5) {
        assert_close(speed_at(&w, z, &slope), 0, 0);
        assert_close(slope, 0, 0);
    }
}

/* Continuous, rising, gradient that of the speed and bounded: down to the last millimetre. */
static void smooth_near_the_ground(void **state)
{
    (void)state;
    for (const struct wf_profile *p = wf_profiles; p->name; p++) {
        if (p->sample == wf_measured_sample) continue; /* needs a file: test_gust_profiles */
        struct wf_wind w = blowing(p->name);
        double floor = strcmp(p->name, "log") ? 0 : 1.6, before = 0, slope, ignored;
        for (double z = 1e-7; z < 5; z *= 1.1) {
            double u = speed_at(&w, floor + z, &slope), h = 1e-4 * z;
            double difference =
                (speed_at(&w, floor + z + h, &ignored) - speed_at(&w, floor + z - h, &ignored)) / (2 * h);
            assert_true(u >= before && isfinite(slope) && fabs(slope) <= 1e4);
            if (fabs(z - 1e-3) > 1e-4)
                assert_true(fabs(difference - slope) <= 1e-6 * fabs(slope) + 1e-9 * u / h);
            before = u;
        }
    }
    struct wf_wind w = blowing("power");
    double below, above;
    assert_close(speed_at(&w, 1e-3 * (1 - 1e-9), &below), speed_at(&w, 1e-3 * (1 + 1e-9), &above), 1e-8);
    assert_close(below, above, 1e-7);
}

static void check_refuses(void **state)
{
    (void)state;
    struct wf_wind good = blowing("log"), bad = good;
    struct wf_err e = { 0 }, other = { 0 };
    bad.sample = wf_measured_sample;
    assert_int_equal(wf_wind_check(&bad, &other), WF_EINPUT);
    bad = good;
    assert_int_equal(wf_wind_check(&good, &e), WF_OK);
    bad.reference_height = 1.6;
    assert_int_equal(wf_wind_check(&bad, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "calm layer"));
    bad = good, bad.speed = -1;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_EINPUT);
    bad = good, bad.speed = NAN;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_EINPUT);
    bad = good, bad.direction[0] = 1;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_EINPUT);
    bad = good, bad.roughness = 0;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_EINPUT);
    bad = good, bad.displacement = -1;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_EINPUT);
    bad = blowing("power"), bad.exponent = 1.5;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_EINPUT);
    bad = blowing("power"), bad.reference_height = 0;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_EINPUT);
    bad = blowing("uniform"), bad.reference_height = 0;
    assert_int_equal(wf_wind_check(&bad, NULL), WF_OK);
}

/* ISO 2533:1975, tables of the standard atmosphere */
static void air(void **state)
{
    (void)state;
    assert_close(wf_air_density(288.15, 0), 1.225, 1e-5);
    assert_close(wf_air_density(281.65, 1000), 1.11164, 1e-5);
    assert_close(wf_air_density(255.65, 5000), 0.736116, 1e-5);
    assert_close(wf_air_density(303.15, 0), 1.225 * 288.15 / 303.15, 1e-5);
    assert_close(wf_air_viscosity(288.15, 1.225), 1.4607e-5, 1e-4);
    assert_close(wf_air_viscosity(255.65, 0.736116), 2.2110e-5, 1e-3);
    assert_true(isnan(wf_air_density(288.15, 12000)) && isnan(wf_air_density(0, 0)));
    assert_true(isnan(wf_air_viscosity(288.15, 0)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reference_height_has_the_named_speed),
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(calm_below_the_ground),
        cmocka_unit_test(smooth_near_the_ground),
        cmocka_unit_test(check_refuses),
        cmocka_unit_test(air),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
