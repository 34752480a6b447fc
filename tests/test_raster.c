/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Area coverage by outlines against exact geometry. */
#include "base/random.h"
#include "close.h"
#include "base/raster.h"
#include <string.h>

static const double pi = 3.14159265358979323846;

static double total(const struct wf_outline *o, size_t n, size_t nx, size_t ny, double *cell)
{
    struct wf_arena a = { 0 };
    struct wf_raster r;
    double *out, sum = 0.0;
    assert_int_equal(wf_raster_make(&r, nx, ny, &a, NULL), WF_OK);
    out = WF_TAKE(&a, nx * ny, double);
    assert_int_equal(wf_raster_union(&r, o, n, out, NULL), WF_OK);
    for (size_t i = 0; i < nx * ny; i++) {
        assert_true(out[i] >= 0.0 && out[i] <= 1.0);
        sum += out[i];
    }
    if (cell) memcpy(cell, out, nx * ny * sizeof *cell);
    wf_arena_free(&a);
    return sum;
}

static struct wf_outline box(double x0, double y0, double x1, double y1)
{
    return (struct wf_outline){ 4, { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } } };
}

/* The same outline on a grid k times as fine. */
static struct wf_outline finer(const struct wf_outline *o, double k)
{
    struct wf_outline out = *o;
    for (size_t i = 0; i < o->n; i++) out.x[i][0] *= k, out.x[i][1] *= k;
    return out;
}

static void silhouettes_have_the_area_of_cylinders_and_cones(void **state)
{
    (void)state;
    struct wf_outline o;
    const double p0[2] = { 1.2, 2.1 }, p1[2] = { 5.7, 8.3 };
    double length = hypot(4.5, 6.2);
    assert_true(wf_outline_frustum(p0, p1, 0.4, 0.1, 0, false, false, &o));
    assert_close(wf_outline_area(&o), 0.5 * length, 1e-14);
    assert_true(wf_outline_frustum(p0, p1, 0.3, 0.3, 0.6, true, true, &o));
    assert_close(wf_outline_area(&o), 0.6 * length + pi * 0.09 * 0.6, 1e-14);
    assert_true(wf_outline_frustum(p0, p0, 0.3, 0.3, 1, true, true, &o));
    assert_close(wf_outline_area(&o), pi * 0.09, 1e-14);
    assert_false(wf_outline_frustum(p0, p0, 0.3, 0.3, 1, false, false, &o));
}

static void one_outline_covers_its_area_on_every_grid(void **state)
{
    (void)state;
    struct wf_outline o;
    const double p0[2] = { 1.2, 2.1 }, p1[2] = { 5.7, 8.3 };
    assert_true(wf_outline_frustum(p0, p1, 0.4, 0.1, 0.3, true, true, &o));
    for (size_t k = 1; k <= 16; k *= 2) {
        struct wf_outline f = finer(&o, (double)k);
        assert_close(total(&f, 1, 10 * k, 10 * k, NULL), wf_outline_area(&f), 1e-12);
    }
    double cell[4];
    struct wf_outline b = box(0.25, 0.5, 1.5, 2.0);
    assert_close(total(&b, 1, 2, 2, cell), 1.25 * 1.5, 1e-14);
    assert_close(cell[0], 0.75 * 0.5, 1e-14);
    assert_close(cell[1], 0.5 * 0.5, 1e-14);
    assert_close(cell[2], 0.75, 1e-14);
    assert_close(cell[3], 0.5, 1e-14);
}

static void overlaps_and_shared_edges_cover_once(void **state)
{
    (void)state;
    const struct wf_outline cross[] = { box(1, 3, 7, 5), box(3, 1, 5, 7) };
    assert_close(total(cross, 2, 8, 8, NULL), 20, 1e-14);
    const struct wf_outline twice[] = { box(1.3, 3.1, 6.2, 4.9), box(1.3, 3.1, 6.2, 4.9),
                                        box(1.3, 3.1, 6.2, 4.9) };
    assert_close(total(twice, 3, 8, 8, NULL), 4.9 * 1.8, 1e-14);
    const struct wf_outline next[] = { box(1.3, 3.1, 4.1, 4.9), box(4.1, 3.1, 6.2, 4.9),
                                       box(2, 3.1, 5, 4.9) };
    assert_close(total(next, 3, 8, 8, NULL), 4.9 * 1.8, 1e-14);
    /* on the lines of the grid, and partly outside */
    const struct wf_outline grid[] = { box(2, 2, 4, 4), box(4, 2, 6, 4), box(6, 6, 12, 12) };
    assert_close(total(grid, 3, 8, 8, NULL), 12, 1e-14);
    /* a stem of rows that are straight but for rounding */
    struct wf_outline chain[7];
    const double a[2] = { 1.1, 0.7 }, d[2] = { 0.83 / 3.0, 1.07 / 1.1 };
    double sum = 0.0;
    for (int i = 0; i < 7; i++) {
        const double p0[2] = { a[0] + i * d[0], a[1] + i * d[1] },
                     p1[2] = { a[0] + (i + 1) * d[0], a[1] + (i + 1) * d[1] };
        assert_true(wf_outline_frustum(p0, p1, 0.31, 0.31, 0, false, false, &chain[i]));
        sum += wf_outline_area(&chain[i]);
    }
    assert_close(total(chain, 7, 10, 10, NULL), sum, 1e-12);
}

/* Against counting points, and the same on finer grids. */
static void many_outlines_against_points(void **state)
{
    (void)state;
    enum { N = 40, SIDE = 8, FINE = 400 };
    struct wf_outline o[N], f[N];
    for (uint64_t i = 0; i < N; i++) {
        double v[8];
        for (uint64_t k = 0; k < 8; k++) v[k] = wf_random_uniform(5, i, k);
        const double p0[2] = { 1 + 6 * v[0], 1 + 6 * v[1] }, p1[2] = { 1 + 6 * v[2], 1 + 6 * v[3] };
        assert_true(wf_outline_frustum(p0, p1, 0.3 * v[4], 0.3 * v[5], v[6], true, v[7] > 0.5, &o[i]));
    }
    double area = total(o, N, SIDE, SIDE, NULL), hits = 0.0;
    for (int y = 0; y < FINE; y++)
        for (int x = 0; x < FINE; x++) {
            double px = (x + 0.5) * SIDE / FINE, py = (y + 0.5) * SIDE / FINE;
            bool in = false;
            for (int i = 0; i < N && !in; i++) {
                bool within = true;
                for (size_t k = 0; k < o[i].n && within; k++) {
                    const double *a = o[i].x[k], *b = o[i].x[(k + 1) % o[i].n];
                    within = (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]) >= 0;
                }
                in = within;
            }
            hits += in;
        }
    assert_close(area, hits * SIDE * SIDE / ((double)FINE * FINE), 2e-3);
    for (size_t k = 2; k <= 16; k *= 2) {
        for (int i = 0; i < N; i++) f[i] = finer(&o[i], (double)k);
        assert_close(total(f, N, SIDE * k, SIDE * k, NULL), area * (double)(k * k), 1e-10);
    }
}

static void sums_are_exact_and_add_up(void **state)
{
    (void)state;
    enum { N = 30, SIDE = 16, CELLS = SIDE * SIDE };
    struct wf_arena a = { 0 };
    struct wf_raster r;
    struct wf_outline o[N];
    double weight[N], sum[CELLS], cover[CELLS], each[CELLS] = { 0 }, all = 0.0, want = 0.0;
    assert_int_equal(wf_raster_make(&r, SIDE, SIDE, &a, NULL), WF_OK);
    for (uint64_t i = 0; i < N; i++) {
        double v[6];
        for (uint64_t k = 0; k < 6; k++) v[k] = wf_random_uniform(9, i, k);
        const double p0[2] = { 2 + 12 * v[0], 2 + 12 * v[1] }, p1[2] = { 2 + 12 * v[2], 2 + 12 * v[3] };
        assert_true(wf_outline_frustum(p0, p1, 1.5 * v[4], 1.5 * v[4], v[5], true, true, &o[i]));
        weight[i] = 0.1 + v[0];
        want += weight[i] * wf_outline_area(&o[i]);
        wf_raster_add(&r, &o[i], weight[i]);
    }
    wf_raster_sum(&r, sum);
    for (int i = 0; i < N; i++) {
        assert_int_equal(wf_raster_union(&r, &o[i], 1, cover, NULL), WF_OK);
        for (int c = 0; c < CELLS; c++) each[c] += weight[i] * cover[c];
    }
    for (int c = 0; c < CELLS; c++) {
        assert_true(fabs(sum[c] - each[c]) <= 1e-12);
        all += sum[c];
    }
    assert_close(all, want, 1e-13);
    wf_raster_sum(&r, sum);
    for (int c = 0; c < CELLS; c++) assert_true(sum[c] == 0.0);
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(silhouettes_have_the_area_of_cylinders_and_cones),
        cmocka_unit_test(one_outline_covers_its_area_on_every_grid),
        cmocka_unit_test(overlaps_and_shared_edges_cover_once),
        cmocka_unit_test(many_outlines_against_points),
        cmocka_unit_test(sums_are_exact_and_add_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
