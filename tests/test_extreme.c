/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest wind of a year: fits against closed forms and published constants, coverage of the band. */
#include "base/random.h"
#include "close.h"
#include "wind/extreme.h"
#include <math.h>
#include <string.h>

/* Speeds at the plotting positions i / (n + 1) of Gumbel's distribution: mean and standard deviation of the
 * reduced variates are the published constants C2 and C1. */
static void moments_of_few_years(void **state)
{
    static const struct {
        size_t n;
        double c1, c2; /* GB 50009-2012, annex E; Gumbel 1958, table 6.2.3 (a copy of the former has 0.5182
                          for 15 years) */
    } table[] = { { 15, 1.02057, 0.5128 },  { 20, 1.06283, 0.52355 }, { 25, 1.09145, 0.53086 },
                  { 30, 1.11238, 0.53622 }, { 50, 1.16066, 0.54853 }, { 100, 1.20649, 0.56002 } };
    (void)state;
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        double x[100], mean = 0, square = 0;
        size_t n = table[k].n;
        for (size_t i = 0; i < n; i++) {
            x[i] = 20 + (double)i * (double)i * 0.01; /* any data */
            mean += x[i] / (double)n;
        }
        for (size_t i = 0; i < n; i++) square += (x[i] - mean) * (x[i] - mean);
        double s = sqrt(square / (double)(n - 1));
        struct wf_extreme fit;
        assert_int_equal(wf_extreme_fit(WF_MOMENTS, false, x, n, &fit, NULL), WF_OK);
        assert_close(fit.scale, s / table[k].c1, 2e-4);
        assert_close((mean - fit.mode) / fit.scale, table[k].c2, 2e-4);
    }
}

/* At the maximum of the likelihood its derivatives by mode and scale vanish. */
static void likelihood_has_its_maximum(void **state)
{
    double x[40], best = -INFINITY;
    struct wf_extreme fit;
    (void)state;
    for (size_t i = 0; i < 40; i++) x[i] = 25 - 3 * log(-log(wf_random_uniform(7, 1, i)));
    assert_int_equal(wf_extreme_fit(WF_LIKELIHOOD, false, x, 40, &fit, NULL), WF_OK);
    for (int k = 0; k < 5; k++) {
        double mode = fit.mode + (k == 1) * 1e-3 - (k == 2) * 1e-3,
               scale = fit.scale + (k == 3) * 1e-3 - (k == 4) * 1e-3;
        double sum = 0;
        for (size_t i = 0; i < 40; i++) {
            double y = (x[i] - mode) / scale;
            sum += -log(scale) - y - exp(-y);
        }
        if (k == 0) best = sum;
        assert_true(sum <= best);
    }
}

/* Of very many years every method finds the distribution; the shape of a GEV too. */
static void many_years(void **state)
{
    static double x[10000];
    (void)state;
    for (int method = 0; method < WF_EXTREME_METHODS; method++)
        for (int squared = 0; squared < 2; squared++) {
            struct wf_extreme fit;
            double shape = method == WF_GEV ? 0.15 : 0;
            for (size_t i = 0; i < 10000; i++) {
                double h = -log(wf_random_uniform(3, 5, i));
                double y = shape > 0 ? (1 - pow(h, shape)) / shape : -log(h);
                x[i] = squared ? sqrt(400 + 60 * y + 200) : 20 + 2 * y;
            }
            assert_int_equal(wf_extreme_fit((enum wf_extreme_method)method, squared, x, 10000, &fit, NULL),
                             WF_OK);
            assert_close(fit.scale, squared ? 60 : 2, 0.03);
            assert_close(fit.mode, squared ? 600 : 20, 0.005);
            assert_true(fabs(fit.shape - shape) < 0.02);
        }
}

static void speeds_and_periods_agree(void **state)
{
    static const double shapes[] = { 0, 0.2, -0.15 }, years[] = { 1.5, 10, 50, 1e4, 1e9 };
    (void)state;
    for (size_t s = 0; s < 3; s++)
        for (int squared = 0; squared < 2; squared++)
            for (size_t k = 0; k < 5; k++) {
                struct wf_extreme x = { squared ? 500 : 20, squared ? 80 : 2, shapes[s], squared };
                double speed = wf_extreme_speed(&x, years[k]);
                assert_close(wf_extreme_return_period(&x, speed), years[k], 1e-7);
            }
    struct wf_extreme x = { 20, 2, 0, false };
    assert_close(wf_extreme_speed(&x, 50), 20 - 2 * log(-log(0.98)), 1e-12);
    assert_true(wf_extreme_exceedance(&x, 120) > 1e-23 && wf_extreme_exceedance(&x, 120) < 1e-21);
    assert_close(wf_extreme_over_years(0.02, 50), 1 - pow(0.98, 50), 1e-12);
    x.shape = 0.25; /* bounded at 28 m/s */
    assert_true(wf_extreme_exceedance(&x, 28.1) == 0);
}

/* The 50-year hourly wind on top of a Sitka spruce stand: published 16.8 m/s, from k 1.55 and A 3.46 m/s. */
static void hours_of_a_weibull_distribution(void **state)
{
    struct wf_extreme x;
    (void)state;
    assert_int_equal(wf_extreme_of_weibull(3.46, 1.55, &x, NULL), WF_OK);
    assert_close(wf_extreme_speed(&x, 50), 16.79, 5e-4);
    assert_close(wf_extreme_speed(&x, 10), 15.15, 5e-4);
    assert_int_equal(wf_extreme_of_weibull(1, 1.85, &x, NULL), WF_OK);
    assert_close(sqrt(x.mode), 3.0614, 2e-5);
    assert_close(wf_extreme_dams_scale(14), 5.028, 1e-4);
    assert_int_equal(wf_extreme_of_weibull(5, 9, &x, NULL), WF_EUSAGE);
}

/* The 90 % band of the 50-year wind holds the true one in 90 of 100 sets of 30 years. */
static void band_covers(void **state)
{
    enum { SETS = 500, YEARS = 30 };
    const struct wf_extreme true_one = { 22, 2.2, 0, false };
    const double fifty = 50, wanted = wf_extreme_speed(&true_one, 50);
    static const enum wf_extreme_method methods[] = { WF_MOMENTS, WF_LIKELIHOOD };
    (void)state;
    for (size_t m = 0; m < 2; m++) {
        int held = 0;
        for (uint64_t set = 0; set < SETS; set++) {
            double x[YEARS], low, high;
            struct wf_extreme fit;
            for (uint64_t i = 0; i < YEARS; i++) x[i] = 22 - 2.2 * log(-log(wf_random_uniform(11, set, i)));
            assert_int_equal(wf_extreme_fit(methods[m], false, x, YEARS, &fit, NULL), WF_OK);
            assert_int_equal(
                wf_extreme_band(&fit, methods[m], YEARS, &fifty, 1, 0.9, 300, set, &low, &high, NULL), WF_OK);
            held += low <= wanted && wanted <= high;
        }
        print_message("%s: the band holds the 50-year wind in %.1f %% of %d sets\n",
                      wf_extreme_rows[methods[m]].name, 100.0 * held / SETS, SETS);
        assert_true(fabs(100.0 * held / SETS - 90) <= 4);
    }
}

/* Ten years with one outlier: both ends of the band of every method ascend, and hold the fit between them. */
static void band_ascends(void **state)
{
    enum { PERIODS = 9 };
    const double ten[] = { 14, 15, 14.5, 16, 15.2, 13.9, 14.8, 15.5, 16.2, 24 },
                 even[] = { 14, 15, 16, 17, 18, 19, 20, 20.5, 20.6, 20.7 },
                 years[PERIODS] = { 1.5, 2, 5, 10, 50, 100, 200, 1000, 1e5 };
    (void)state;
    for (int k = 0; k < 2 * 2 * WF_EXTREME_METHODS; k++) {
        struct wf_extreme fit;
        double low[PERIODS], high[PERIODS];
        enum wf_extreme_method m = (enum wf_extreme_method)(k / 4);
        assert_int_equal(wf_extreme_fit(m, k & 1, k & 2 ? even : ten, 10, &fit, NULL), WF_OK);
        assert_int_equal(
            wf_extreme_band(&fit, m, 10, years, PERIODS, 0.9, WF_EXTREME_SETS, 1, low, high, NULL), WF_OK);
        for (size_t i = 0; i < PERIODS; i++) {
            double speed = wf_extreme_speed(&fit, years[i]);
            assert_true(low[i] < speed && speed < high[i]);
            assert_true(!i || (low[i] > low[i - 1] && high[i] > high[i - 1]));
        }
    }
}

/* Of 30 years the 200-year wind lies above the band of a GEV in no more than 7 of 100 sets, whatever the
 * shape between -0.1 and 0.1, and seldom below it; 5 are meant. */
static void band_of_a_shape_covers(void **state)
{
    enum { SETS = 300, YEARS = 30 };
    const double period = 200;
    (void)state;
    for (int k = -1; k <= 1; k++) {
        const struct wf_extreme true_one = { 500, 80, 0.1 * k, true };
        const double wanted = wf_extreme_speed(&true_one, period);
        int above = 0, below = 0;
        for (uint64_t set = 0; set < SETS; set++) {
            double x[YEARS], low, high;
            struct wf_extreme fit;
            for (uint64_t i = 0; i < YEARS; i++)
                x[i] = wf_extreme_speed(&true_one, 1 / (1 - wf_random_uniform(11, set, i)));
            assert_int_equal(wf_extreme_fit(WF_GEV, true, x, YEARS, &fit, NULL), WF_OK);
            assert_int_equal(
                wf_extreme_band(&fit, WF_GEV, YEARS, &period, 1, 0.9, 300, set, &low, &high, NULL), WF_OK);
            above += wanted > high, below += wanted < low;
        }
        print_message("shape %.1f: the 200-year wind is above the band in %.1f %%, below it in %.1f %%\n",
                      true_one.shape, 100.0 * above / SETS, 100.0 * below / SETS);
        assert_true(above <= 0.07 * SETS && below <= 0.05 * SETS);
    }
}

static void refused(void **state)
{
    const double few[] = { 20, 21, 22 }, same[] = { 20, 20, 20, 20, 20 }, wrong[] = { 20, 21, -3, 22, 24 };
    struct wf_extreme fit;
    struct wf_err e = { 0 };
    (void)state;
    assert_int_equal(wf_extreme_fit(WF_MOMENTS, false, few, 3, &fit, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "3 annual maxima"));
    e = (struct wf_err){ 0 };
    assert_int_equal(wf_extreme_fit(WF_MOMENTS, true, same, 5, &fit, &e), WF_EINPUT);
    e = (struct wf_err){ 0 };
    assert_int_equal(wf_extreme_fit(WF_MOMENTS, true, wrong, 5, &fit, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "year 3 is -3 m/s"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moments_of_few_years),
        cmocka_unit_test(likelihood_has_its_maximum),
        cmocka_unit_test(many_years),
        cmocka_unit_test(speeds_and_periods_agree),
        cmocka_unit_test(hours_of_a_weibull_distribution),
        cmocka_unit_test(band_covers),
        cmocka_unit_test(band_ascends),
        cmocka_unit_test(band_of_a_shape_covers),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
