/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Made and read ground, exposure, speed-up. */
#include "close.h"
#include "wind/terrain.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PI 3.14159265358979323846
static struct wf_arena arena;
static struct wf_err err;

static int clean(void **state)
{
    (void)state;
    wf_arena_free(&arena);
    memset(&err, 0, sizeof err);
    return 0;
}

static void diamond_square(void **state)
{
    (void)state;
    struct wf_terrain t, again, other;
    assert_int_equal(wf_terrain_make(7, 20.0, 0.8, 35.0, 5, &arena, &t, &err), WF_OK);
    assert_int_equal(wf_terrain_make(7, 20.0, 0.8, 35.0, 5, &arena, &again, &err), WF_OK);
    assert_int_equal(wf_terrain_make(7, 20.0, 0.8, 35.0, 6, &arena, &other, &err), WF_OK);
    assert_int_equal(t.columns, 129);
    assert_int_equal(t.rows, 129);
    size_t n = t.columns * t.rows;
    assert_memory_equal(t.z, again.z, n * sizeof *t.z);
    assert_true(memcmp(t.z, other.z, n * sizeof *t.z) != 0);
    double mean = 0, square = 0, low = INFINITY;
    for (size_t i = 0; i < n; i++) mean += t.z[i] / (double)n, low = fmin(low, t.z[i]);
    for (size_t i = 0; i < n; i++) square += (t.z[i] - mean) * (t.z[i] - mean) / (double)n;
    assert_close(sqrt(square), 35.0, 1e-9);
    assert_true(low == 0.0);
}

/* Height differences grow with distance d about as d^H, over eight maps. Midpoint displacement is known to
 * miss the exponent of true fractional Brownian ground; smooth maps come out rougher than asked. */
static void roughness_exponent(void **state)
{
    (void)state;
    static const double h[] = { 0.3, 0.6, 0.9 };
    double before = 0.0;
    for (int i = 0; i < 3; i++) {
        double near = 0, far = 0;
        for (uint64_t seed = 1; seed <= 8; seed++) {
            struct wf_terrain t;
            assert_int_equal(wf_terrain_make(7, 1.0, h[i], 1.0, seed, &arena, &t, &err), WF_OK);
            for (size_t r = 0; r < t.rows; r++)
                for (size_t c = 0; c + 16 < t.columns; c++) {
                    const double *z = t.z + r * t.columns + c;
                    near += (z[2] - z[0]) * (z[2] - z[0]);
                    far += (z[16] - z[0]) * (z[16] - z[0]);
                }
        }
        double got = 0.5 * log(far / near) / log(8.0);
        if (fabs(got - h[i]) > 0.17) fail_msg("H = %g: %g", h[i], got);
        assert_true(got > before + 0.1);
        before = got;
    }
}

static void make_mistakes(void **state)
{
    (void)state;
    struct wf_terrain t;
    static const struct {
        unsigned n;
        double cell, h, relief;
    } bad[] = {
        { 0, 10, 0.5, 10 }, { 13, 10, 0.5, 10 }, { 5, -1, 0.5, 10 }, { 5, 10, 1.5, 10 }, { 5, 10, 0.5, -3 }
    };
    for (size_t i = 0; i < 5; i++) {
        memset(&err, 0, sizeof err);
        assert_int_not_equal(
            wf_terrain_make(bad[i].n, bad[i].cell, bad[i].h, bad[i].relief, 1, &arena, &t, &err), WF_OK);
        assert_true(err.text[0] != '\0');
    }
}

static char path[64];
static enum wf_status read_text(const char *text, struct wf_terrain *t)
{
    strcpy(path, "/tmp/wf_terrainXXXXXX");
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), strlen(text));
    close(fd);
    memset(&err, 0, sizeof err);
    enum wf_status s = wf_terrain_read(path, &arena, t, &err);
    unlink(path);
    return s;
}

static void ascii_grid(void **state)
{
    (void)state;
    struct wf_terrain t;
    assert_int_equal(
        read_text("NCOLS 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -9999\n"
                  "1 2 3\n4 -9999 6.5\n",
                  &t),
        WF_OK);
    assert_close(t.x0, 105, 1e-12);
    assert_close(t.y0, 205, 1e-12);
    assert_close(t.z[0], 4, 0); /* the last row of the file is the southern one */
    assert_close(t.z[3], 1, 0);
    assert_true(isnan(t.z[1]));
    assert_close(wf_terrain_height(&t, 110, 215), 1.5, 1e-12);
    assert_true(isnan(wf_terrain_height(&t, 110, 205)));
    assert_true(isnan(wf_terrain_height(&t, 90, 205)));
    assert_int_equal(wf_terrain_write("/tmp/wf_terrain_out.asc", &t, NULL, &err), WF_OK);
    struct wf_terrain back;
    assert_int_equal(wf_terrain_read("/tmp/wf_terrain_out.asc", &arena, &back, &err), WF_OK);
    for (size_t i = 0; i < 6; i++) assert_true(isnan(t.z[i]) ? isnan(back.z[i]) : t.z[i] == back.z[i]);
    assert_close(back.x0, t.x0, 1e-12);
    unlink("/tmp/wf_terrain_out.asc");
}

static void ascii_mistakes(void **state)
{
    (void)state;
    struct wf_terrain t;
    static const char *const bad[][2] = {
        { "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 x\n",
          ":7:3: error: a height: expected a number, got 'x'" },
        { "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3\n", "the file ends" },
        { "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4 5\n", "more heights" },
        { "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\n1 2\n3 4\n", "no cellsize" },
        { "ncols 2\nrows 2\n", "unknown header word 'rows'" },
        { "ncols 2.5\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n", "ncols = 2.5" },
        { "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize -4\n1 2 3 4", "cellsize = -4 m" },
        { "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 4\n1 2 3 -32768", "no-data" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(read_text(bad[i][0], &t), WF_EINPUT);
        if (!strstr(err.text, bad[i][1])) fail_msg("'%s' does not say '%s'", err.text, bad[i][1]);
    }
}

static void fill(struct wf_terrain *t, size_t n, double cell, double (*height)(double x, double y))
{
    assert_int_equal(wf_terrain_alloc(t, n, n, cell, &arena, &err), WF_OK);
    t->x0 = t->y0 = -0.5 * (double)(n - 1) * cell;
    for (size_t r = 0; r < n; r++)
        for (size_t c = 0; c < n; c++)
            t->z[r * n + c] = height(t->x0 + (double)c * cell, t->y0 + (double)r * cell);
}

static double flat(double x, double y) { return 0.0 * (x + y); }
static double plane(double x, double y) { return 0.1 * x + 0.0 * y; }
static double bowl(double x, double y) { return hypot(x, y) > 95.0 ? 50.0 : 0.0; }
static double cone(double x, double y) { return -0.2 * hypot(x, y); }

static void topex(void **state)
{
    (void)state;
    struct wf_terrain t;
    double seen;
    fill(&t, 41, 10, flat);
    assert_close(wf_terrain_topex(&t, 20, 20, 150, &seen), 0, 1e-12);
    assert_close(seen, 1.0, 0);
    (void)wf_terrain_topex(&t, 1, 20, 150, &seen);
    assert_close(seen, 5.0 / 8.0, 1e-12); /* three of eight leave the map */
    fill(&t, 41, 10, plane);              /* an inclined plane: uphill and downhill angles cancel */
    assert_close(wf_terrain_topex(&t, 20, 20, 150, NULL), 0, 1e-12);
    bool on_map;
    assert_close(wf_terrain_horizon(&t, 20, 20, PI / 2, 150, &on_map), atan(0.1), 1e-12);
    fill(&t, 41, 10, bowl); /* a wall of 50 m all round, first at 100 m (diagonals: 99 m) */
    assert_close(wf_terrain_topex(&t, 20, 20, 150, NULL), 4 * atan(0.5) + 4 * atan(50 / (70 * sqrt(2))),
                 1e-9);
    assert_close(wf_terrain_topex(&t, 20, 20, 80, NULL), 0,
                 1e-12); /* beyond the distance it does not count */
    fill(&t, 41, 10, cone);
    assert_close(wf_terrain_topex(&t, 20, 20, 150, NULL), -8 * atan(0.2), 1e-9);
}

enum { RIDGE_H = 20, RIDGE_L = 150 };
static double ridge(double x, double y) { return RIDGE_H / (1 + x * x / (RIDGE_L * RIDGE_L)) + 0.0 * y; }
static double hill(double x, double y)
{
    return RIDGE_H / pow(1 + (x * x + y * y) / (RIDGE_L * RIDGE_L), 1.5);
}

/* Closed forms. A long ridge h = H/(1+x^2/L^2) has dS = gain H L Re (L + z + ix)^-2; a round hill
 * H/(1+r^2/L^2)^1.5 has gain (H/L) (L/(L+z))^3 over its summit (Hankel transform of k^2/2 exp(-kL)). */
static void speedup_closed_form(void **state)
{
    (void)state;
    struct wf_terrain t;
    struct wf_speedup s;
    struct wf_speedup_request q = { .from = -PI / 2, .height = 10, .roughness = 0.05, .length = RIDGE_L };
    size_t n = 401, mid = 200;
    fill(&t, n, 15, ridge);
    assert_int_equal(wf_terrain_speedup(&t, &q, &arena, &s, &err), WF_OK);
    assert_close(s.inner * log(s.inner / 0.05), 0.32 * RIDGE_L, 1e-12);
    double ratio = log(RIDGE_L / 0.05) / log(fmax(10, s.inner) / 0.05);
    assert_close(s.gain, ratio * ratio, 1e-12);
    for (size_t i = 0; i <= 20; i += 4) {
        double x = 15.0 * (double)i, b = RIDGE_L + 10.0, r2 = b * b + x * x;
        double want = s.gain * RIDGE_H * RIDGE_L * (b * b - x * x) / (r2 * r2);
        double scale = s.gain * RIDGE_H / RIDGE_L;
        if (fabs(s.ds[mid * n + mid + i] - want) > 0.02 * scale)
            fail_msg("x = %g m: dS = %g, want %g", x, s.ds[mid * n + mid + i], want);
        assert_true(fabs(s.ds[mid * n + mid + i] - s.ds[mid * n + mid - i]) < 1e-9); /* mirror */
    }
    /* the guideline of Taylor & Lee for ridges, 2 h/L, within a third */
    assert_true(fabs(s.ds[mid * n + mid] - 2.0 * RIDGE_H / RIDGE_L) < 0.67 * RIDGE_H / RIDGE_L);
    fill(&t, n, 15, hill);
    assert_int_equal(wf_terrain_speedup(&t, &q, &arena, &s, &err), WF_OK);
    assert_close(s.ds[mid * n + mid], s.gain * RIDGE_H / RIDGE_L * pow(RIDGE_L / (RIDGE_L + 10.0), 3), 0.02);
}

static void speedup_limits(void **state)
{
    (void)state;
    struct wf_terrain t;
    struct wf_speedup s, along;
    struct wf_speedup_request q = { .from = 0, .height = 10, .roughness = 0.05 };
    fill(&t, 101, 15, flat);
    assert_int_equal(wf_terrain_speedup(&t, &q, &arena, &s, &err), WF_OK);
    for (size_t i = 0; i < 101 * 101; i++) assert_true(s.ds[i] == 0.0);
    /* wind along a ridge meets no hill */
    fill(&t, 301, 15, ridge);
    q.from = -PI / 2;
    assert_int_equal(wf_terrain_speedup(&t, &q, &arena, &s, &err), WF_OK);
    q.from = 0;
    assert_int_equal(wf_terrain_speedup(&t, &q, &arena, &along, &err), WF_OK);
    for (size_t i = 0; i < 301 * 301; i++) assert_true(fabs(along.ds[i]) < 1e-12);
    /* the length found on the map is of the ridge's own order */
    assert_true(s.length > 0.5 * RIDGE_L && s.length < 4 * RIDGE_L);
    q.roughness = 0;
    assert_int_equal(wf_terrain_speedup(&t, &q, &arena, &s, &err), WF_EUSAGE);
    q.roughness = 0.05;
    t.z[7] = NAN;
    memset(&err, 0, sizeof err);
    assert_int_equal(wf_terrain_speedup(&t, &q, &arena, &s, &err), WF_EINPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(diamond_square, clean),
        cmocka_unit_test_teardown(roughness_exponent, clean),
        cmocka_unit_test_teardown(make_mistakes, clean),
        cmocka_unit_test_teardown(ascii_grid, clean),
        cmocka_unit_test_teardown(ascii_mistakes, clean),
        cmocka_unit_test_teardown(topex, clean),
        cmocka_unit_test_teardown(speedup_closed_form, clean),
        cmocka_unit_test_teardown(speedup_limits, clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
