/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Coherent noise: lattice zeros, continuity, range, symmetry, octaves, variance. */
#include "base/random.h"
#include "close.h"
#include "wind/noise.h"

static void zero_at_lattice(void **state)
{
    (void)state;
    const struct wf_octaves o = { 5, 0.5, 2.0, 0 };
    for (int k = -50; k <= 50; k++) {
        assert_true(wf_noise_gradient(1, 2, k) == 0.0);
        assert_true(wf_noise_octaves(1, 2, &o, k) == 0.0);
    }
}

/* Value and slope run on through lattice points; between them the change over h is at most h times the
 * steepest slope (|n'| <= 1 + 2 * 15/8 * 1/2 < 3). */
static void continuous(void **state)
{
    (void)state;
    const double h = 1e-6;
    for (int k = -20; k <= 20; k++) {
        double left = wf_noise_gradient(3, 4, k - h), right = wf_noise_gradient(3, 4, k + h);
        assert_true(fabs(left) < 1.1e-6 && fabs(right) < 1.1e-6);
        /* the slope at a lattice point is that point's number, from both sides */
        double slope = 2.0 * wf_random_uniform(3, 4, (uint64_t)(int64_t)k) - 1.0;
        assert_true(fabs(right / h - slope) < 1e-4 && fabs(-left / h - slope) < 1e-4);
    }
    for (double x = -5.0; x < 5.0; x += 0.001)
        assert_true(fabs(wf_noise_gradient(3, 4, x + h) - wf_noise_gradient(3, 4, x)) < 3.0 * h);
}

/* The bound is reached by slopes of +1 and -1 in the middle of a cell and never exceeded. */
static void range(void **state)
{
    (void)state;
    assert_close(wf_noise_gradient_cell(1.0, -1.0, 0.5), 0.5, 1e-15);
    assert_close(wf_noise_gradient_cell(-1.0, 1.0, 0.5), -0.5, 1e-15);
    for (double t = 0.0; t <= 1.0; t += 1e-4)
        assert_true(fabs(wf_noise_gradient_cell(1.0, -1.0, t)) <= 0.5 + 1e-15);
    const struct wf_octaves o = { 4, 0.7, 2.0, 1 };
    assert_close(wf_noise_range(&o), 0.5 * (1 + 0.7 + 0.49 + 0.343), 1e-15);
    double most = 0.0;
    for (uint64_t i = 0; i < 100000; i++) {
        double x = (double)i * 0.0371, v = wf_noise_value(5, 6, x), n = wf_noise_gradient(5, 6, x);
        assert_true(v >= 0.0 && v <= 1.0 && fabs(n) <= 0.5);
        most = fmax(most, fabs(wf_noise_octaves(5, 6, &o, x)));
    }
    assert_true(most <= wf_noise_range(&o) && most > 0.5 * wf_noise_range(&o));
}

/* Opposite slopes give the opposite noise; a mirrored cell the mirrored noise. */
static void symmetric(void **state)
{
    (void)state;
    for (double t = 0.0; t <= 1.0; t += 0.01) {
        assert_true(wf_noise_gradient_cell(0.3, -0.8, t) == -wf_noise_gradient_cell(-0.3, 0.8, t));
        assert_close(wf_noise_gradient_cell(0.3, -0.8, t), wf_noise_gradient_cell(0.8, -0.3, 1.0 - t), 1e-11);
    }
}

/* One octave is the noise itself; more are the sum of what each gives at its own frequency and stream. */
static void octave_sum(void **state)
{
    (void)state;
    const struct wf_octaves three = { 3, 0.6, 2.5, 1 };
    for (double x = -3.0; x < 3.0; x += 0.17) {
        double sum = 0.0;
        for (unsigned i = 0; i < 3; i++) {
            const struct wf_octaves upto = { i + 1, 0.6, 2.5, 1 }, below = { i, 0.6, 2.5, 1 };
            double part = wf_noise_octaves(8, 9, &upto, x) - (i ? wf_noise_octaves(8, 9, &below, x) : 0.0);
            assert_true(fabs(part) <= 0.5 * pow(0.6, i) + 1e-15);
            sum += part;
        }
        assert_true(fabs(sum - wf_noise_octaves(8, 9, &three, x)) < 1e-15);
    }
}

/* Zero mean and the exact variance, over many cells. */
static void mean_and_variance(void **state)
{
    (void)state;
    const struct wf_octaves one = { 1, 0.5, 2.0, 0 }, many = { 6, 0.794, 2.0, 1 };
    assert_close(wf_noise_variance(&one), 535.0 / 27027.0, 1e-15);
    double sum[2] = { 0 }, square[2] = { 0 };
    enum { N = 400000 };
    for (int i = 0; i < N; i++) {
        double x = i * 0.0618034, a = wf_noise_octaves(2, 3, &one, x), b = wf_noise_octaves(2, 3, &many, x);
        sum[0] += a, square[0] += a * a, sum[1] += b, square[1] += b * b;
    }
    /* 25000 cells: about 1 % standard error of the variance, 0.06 standard errors of the of it */
    assert_true(fabs(sum[0] / N) < 0.002 && fabs(sum[1] / N) < 0.004);
    assert_close(square[0] / N, wf_noise_variance(&one), 0.03);
    assert_close(square[1] / N, wf_noise_variance(&many), 0.03);
}

static void leaf_angles(void **state)
{
    (void)state;
    const struct wf_leaf_flutter f = { { 3, 0.5, 2.0, 1 }, { 0.2, 0.3, 0.4 }, 0.5 };
    const struct wf_leaf_flutter loose = { { 3, 0.5, 2.0, 1 }, { 0.2, 0.3, 0.4 }, 0.0 };
    double a[3], b[3], other[3];
    wf_noise_leaf(1, 17, &f, 3.3, a);
    wf_noise_leaf(1, 17, &loose, 3.3, b);
    wf_noise_leaf(1, 18, &f, 3.3, other);
    assert_true(a[0] == b[0] && a[1] == b[1]);
    assert_close(a[2], b[2] + 0.5 * a[0], 1e-15);
    assert_true(a[0] != other[0] && a[1] != other[1]);
    assert_true(fabs(a[0]) <= 0.2 * wf_noise_range(&f.octaves));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zero_at_lattice), cmocka_unit_test(continuous), cmocka_unit_test(range),
        cmocka_unit_test(symmetric),       cmocka_unit_test(octave_sum), cmocka_unit_test(mean_and_variance),
        cmocka_unit_test(leaf_angles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
