/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The wind in a stand, a measured profile, a wind climate. */
#include "close.h"
#include "wind/wind.h"
#include "wind/climate.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static double speed_at(const struct wf_wind *w, double z, double *slope)
{
    double x[3] = { 1, 2, z }, u[3], du[9];
    w->sample(w, x, u, du);
    *slope = du[2];
    return u[0];
}

/* A stand of 20 m, d = 14 m, z0 = 1.6 m, wind named at 30 m. */
static struct wf_wind stand(double attenuation)
{
    return (struct wf_wind){ .sample = wf_canopy_sample,
                             .speed = 10,
                             .direction = { 1, 0, 0 },
                             .reference_height = 30,
                             .roughness = 1.6,
                             .displacement = 14,
                             .canopy_height = 20,
                             .attenuation = attenuation };
}

static void canopy(void **state)
{
    (void)state;
    double slope, below, above;
    struct wf_wind w = stand(3.0);
    assert_close(speed_at(&w, 30, &slope), 10, 1e-14);
    double top = 10 * log(6 / 1.6) / log(16 / 1.6);
    assert_close(speed_at(&w, 20, &slope), top, 1e-14);
    assert_close(speed_at(&w, 10, &slope), top * exp(-1.5), 1e-14);
    assert_close(slope, top * exp(-1.5) * 3 / 20, 1e-14);
    assert_close(speed_at(&w, 25, &slope), 10 * log(11 / 1.6) / log(10), 1e-14);
    assert_close(speed_at(&w, 20 - 1e-9, &below), speed_at(&w, 20 + 1e-9, &above), 1e-8);
    /* left to itself the join is smooth, and the attenuation the usual 2.5 */
    w = stand(0);
    speed_at(&w, 20 - 1e-9, &below);
    speed_at(&w, 20 + 1e-9, &above);
    assert_close(below, above, 1e-7);
    assert_close(log(speed_at(&w, 20, &slope) / speed_at(&w, 0, &slope)), 20 / (6 * log(6 / 1.6)), 1e-12);
    /* canopy height from the displacement; the log law where there is no stand */
    w.canopy_height = 0;
    double same = speed_at(&w, 10, &slope);
    w = stand(0);
    assert_close(speed_at(&w, 10, &slope), same, 1e-12);
    struct wf_wind open = { .sample = wf_canopy_sample,
                            .speed = 10,
                            .direction = { 1, 0, 0 },
                            .reference_height = 10,
                            .roughness = 0.05 };
    assert_close(speed_at(&open, 5, &slope), 10 * log(100) / log(200), 1e-14);
    struct wf_err e = { 0 };
    assert_int_equal(wf_wind_check(&w, &e), WF_OK);
    w.roughness = 7;
    assert_int_equal(wf_wind_check(&w, &e), WF_EINPUT);
}

static char path[64];
static struct wf_arena arena;
static struct wf_diag diag;
static struct wf_err err;

static const char *written(const char *text)
{
    wf_arena_free(&arena);
    diag = (struct wf_diag){ .arena = &arena };
    memset(&err, 0, sizeof err);
    strcpy(path, "/tmp/wf_profileXXXXXX");
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), strlen(text));
    close(fd);
    return path;
}

static void measured(void **state)
{
    (void)state;
    struct wf_measured_profile p;
    struct wf_wind w = { .speed = 20, .direction = { 1, 0, 0 }, .reference_height = 10 };
    double slope, ignored;
    assert_int_equal(
        wf_measured_read(written("height_m,speed_ms\n2,3\n5,4\n10,5\n40,8\n"), &arena, &diag, &p, &err),
        WF_OK);
    assert_int_equal(wf_measured_blow(&p, &w, &err), WF_OK);
    assert_close(speed_at(&w, 10, &slope), 20, 1e-12);
    assert_close(speed_at(&w, 2, &slope), 12, 1e-12);
    assert_close(speed_at(&w, 100, &slope), 32, 1e-12);
    assert_close(slope, 0, 0);
    assert_close(speed_at(&w, 0, &slope), 0, 0);
    double before = 0;
    for (double z = 0.01; z < 39.9;
         z += 0.1) { /* rises between rising points; the gradient is that of the speed */
        double u = speed_at(&w, z, &slope), h = 1e-5;
        assert_true(u >= before && slope >= 0);
        assert_close(slope, (speed_at(&w, z + h, &ignored) - speed_at(&w, z - h, &ignored)) / (2 * h), 1e-3);
        before = u;
    }
    unlink(path);
    assert_int_equal(wf_measured_read(written("height_m,speed_ms\n5,4\n2,3\nx,5\n"), &arena, &diag, &p, &err),
                     WF_EINPUT);
    assert_int_equal(diag.errors, 2);
    unlink(path);
    assert_int_equal(wf_measured_read(written("height_m,speed_ms\n5,4\n"), &arena, &diag, &p, &err),
                     WF_EINPUT);
    unlink(path);
    wf_arena_free(&arena);
}

static void rose(void **state)
{
    (void)state;
    struct wf_rose r;
    static const char text[] =
        "direction_deg,frequency,weibull_scale_ms,weibull_shape\n0,10,5,2\n45,10,5,2\n90,10,5,2\n"
        "135,10,5,2\n180,20,5,2\n225,20,8,2\n270,10,5,2\n315,10,5,2\n";
    assert_int_equal(wf_rose_read(written(text), &arena, &diag, &r, &err), WF_OK);
    unlink(path);
    assert_int_equal(r.sectors, 8);
    assert_close(r.typed_sum, 100, 1e-12);
    assert_close(r.frequency[4], 0.2, 1e-12);
    assert_close(r.from[6], 1.5 * 3.14159265358979, 1e-12);
    assert_close(wf_rose_sector_above(&r, 5, 8), exp(-1), 1e-12);
    assert_close(wf_rose_above(&r, 10), 0.8 * exp(-4) + 0.2 * exp(-100.0 / 64), 1e-12);
    assert_close(wf_rose_above(&r, 0), 1, 1e-12);
    assert_close(wf_rose_mean(&r), (0.8 * 5 + 0.2 * 8) * sqrt(3.14159265358979) / 2, 1e-10);
    assert_close(wf_rose_above(&r, wf_rose_speed(&r, 0.01)), 0.01, 1e-7);
    static const char *const bad[] = {
        "direction_deg,frequency,weibull_scale_ms,weibull_shape\n0,10,5,2\n90,10,5,2\n",
        "direction_deg,frequency,weibull_scale_ms,weibull_shape\n0,10,5,9\n",
        "direction_deg,frequency,weibull_scale\n0,10,5\n",
    };
    for (int i = 0; i < 3; i++) {
        assert_int_equal(wf_rose_read(written(bad[i]), &arena, &diag, &r, &err), WF_EINPUT);
        unlink(path);
    }
    char *twice = strdup(text);
    memcpy(strstr(twice, "\n45,"), "\n90,", 4);
    assert_int_equal(wf_rose_read(written(twice), &arena, &diag, &r, &err), WF_EINPUT);
    assert_non_null(strstr(diag.first->text, "given twice"));
    unlink(path);
    free(twice);
    wf_arena_free(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(canopy), cmocka_unit_test(measured),
                                        cmocka_unit_test(rose) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
