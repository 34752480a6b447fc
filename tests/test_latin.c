/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Latin hypercube samples: strata, correlations of ranks, seeds; order statistics, bands, a lognormal law. */
#include "base/latin.h"
#include "close.h"
#include <stdlib.h>
#include <string.h>

enum { N = 256, K = 18 };

static const double wanted = 0.7; /* of the first three variables */

static void fill_ranks(double *rank)
{
    for (int i = 0; i < K; i++)
        for (int j = 0; j < K; j++) rank[i * K + j] = i == j ? 1.0 : i < 3 && j < 3 ? wanted : 0.0;
}

static void draw(uint64_t seed, double *out)
{
    double rank[K * K];
    struct wf_err e = { 0 };
    fill_ranks(rank);
    if (wf_latin(seed, N, K, rank, out, &e)) fail_msg("%s", e.text);
}

/* In an n-th of (0, 1): each of them holds one draw of each variable. */
static void one_draw_in_each_stratum(void **state)
{
    (void)state;
    static double u[N * K];
    draw(7, u);
    for (int v = 0; v < K; v++) {
        int seen[N] = { 0 };
        for (int i = 0; i < N; i++) {
            double x = u[i * K + v];
            assert_true(x > 0.0 && x < 1.0);
            seen[(int)(x * N)]++;
        }
        for (int i = 0; i < N; i++) assert_int_equal(seen[i], 1);
    }
}

/* Spearman's correlation; the rank of a draw is its stratum. */
static double rank_correlation(const double *u, int a, int b)
{
    double sum = 0.0;
    for (int i = 0; i < N; i++) {
        double d = floor(u[i * K + a] * N) - floor(u[i * K + b] * N);
        sum += d * d;
    }
    return 1.0 - 6.0 * sum / ((double)N * ((double)N * N - 1.0));
}

static void reaches_rank_correlations(void **state)
{
    (void)state;
    static double u[N * K];
    for (uint64_t seed = 1; seed <= 20; seed++) {
        draw(seed, u);
        for (int a = 0; a < K; a++)
            for (int b = 0; b < a; b++) {
                double got = rank_correlation(u, a, b), want = a < 3 && b < 3 ? wanted : 0.0;
                if (fabs(got - want) > 0.05)
                    fail_msg("seed %d: rank correlation of %d and %d is %.3f, want %.3f", (int)seed, a, b,
                             got, want);
            }
    }
}

static void seed_and_only_seed_matters(void **state)
{
    (void)state;
    static double a[N * K], b[N * K];
    draw(3, a);
    draw(3, b);
    assert_memory_equal(a, b, sizeof a);
    draw(4, b);
    assert_memory_not_equal(a, b, sizeof a);
}

static void refuses_contradictions(void **state)
{
    (void)state;
    const double rank[9] = { 1, 0.9, -0.9, 0.9, 1, 0.9, -0.9, 0.9, 1 };
    double u[60];
    struct wf_err e = { 0 };
    assert_int_equal(wf_latin(1, 20, 3, rank, u, &e), WF_EINTERNAL);
    assert_non_null(strstr(e.text, "contradict"));
}

/* Fewer samples than variables still have one draw in each stratum. */
static void few_samples(void **state)
{
    (void)state;
    double rank[K * K], u[10 * K];
    struct wf_err e = { 0 };
    fill_ranks(rank);
    assert_int_equal(wf_latin(1, 10, K, rank, u, &e), WF_OK);
    for (int v = 0; v < K; v++) {
        unsigned seen = 0;
        for (int i = 0; i < 10; i++) seen |= 1u << (int)(u[i * K + v] * 10);
        assert_int_equal(seen, 1023);
    }
}

static void order_statistics(void **state)
{
    (void)state;
    const double x[] = { 1, 2, 4, 8, INFINITY };
    assert_close(wf_order_statistic(x, 5, 2.0 / 6), 2, 1e-12);
    assert_close(wf_order_statistic(x, 5, 2.5 / 6), 3, 1e-12);
    assert_close(wf_order_statistic(x, 5, 0.001), 1, 0);
    assert_true(isinf(wf_order_statistic(x, 5, 4.5 / 6)));
    assert_true(isinf(wf_order_statistic(x, 5, 0.99)));
    assert_true(isnan(wf_order_statistic(x, 0, 0.5)));
}

/* By Wilson's formula, computed apart. */
static void bands(void **state)
{
    (void)state;
    double low, high;
    wf_binomial_band(10, 100, 1.6448536269514722, &low, &high);
    assert_close(low, 0.060718667015, 1e-9);
    assert_close(high, 0.160355509611, 1e-9);
    wf_binomial_band(0, 50, 1.6448536269514722, &low, &high);
    assert_close(low, 0, 0);
    assert_close(high, 0.051333185786, 1e-9);
    wf_binomial_band(50, 50, 1.6448536269514722, &low, &high);
    assert_close(high, 1, 0);
    assert_close(low, 1 - 0.051333185786, 1e-9);
}

/* Quantiles of a law, of which those above a bound are hidden, give the law back. */
static void lognormal_with_hidden_values(void **state)
{
    (void)state;
    enum { MANY = 2000 };
    static double x[MANY];
    const double median = 20, beta = 0.3;
    for (int hidden = 0; hidden <= 60; hidden += 20) {
        double bound = median * exp(beta * wf_normal_quantile(1 - 0.01 * hidden - 1e-9));
        for (int i = 0; i < MANY; i++) {
            x[i] = median * exp(beta * wf_normal_quantile((i + 0.5) / MANY));
            if (hidden && x[i] > bound) x[i] = INFINITY;
        }
        struct wf_lognormal l = wf_lognormal_fit(x, MANY, hidden ? bound : 1e9);
        assert_int_equal(l.above, MANY * hidden / 100);
        assert_close(l.median, median, 5e-3);
        assert_close(l.beta, beta, 1e-2);
        assert_close(wf_lognormal_share(&l, median), 0.5, 1e-2);
    }
    for (int i = 0; i < MANY; i++) x[i] = i < 4 ? 10 : INFINITY;
    assert_true(isnan(wf_lognormal_fit(x, MANY, 30).median));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_draw_in_each_stratum),
        cmocka_unit_test(reaches_rank_correlations),
        cmocka_unit_test(seed_and_only_seed_matters),
        cmocka_unit_test(refuses_contradictions),
        cmocka_unit_test(few_samples),
        cmocka_unit_test(order_statistics),
        cmocka_unit_test(bands),
        cmocka_unit_test(lognormal_with_hidden_values),
    };
    return cmocka_run_group_tests_name("latin", tests, NULL, NULL);
}
