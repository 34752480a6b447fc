/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/latin.h"
#include "base/num.h"
#include "base/random.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PURPOSE = 0x4c }; /* of random streams */
enum { STREAM_ORDER, STREAM_PLACE };

double wf_normal_quantile(double share) { return gsl_cdf_ugaussian_Pinv(share); }

/* ---- Orders ---- */

struct keyed {
    double key;
    size_t i;
};

static int by_key(const void *a, const void *b)
{
    const struct keyed *x = a, *y = b;
    if (x->key != y->key) return x->key < y->key ? -1 : 1;
    return (x->i > y->i) - (x->i < y->i);
}

/* rank[i]: how many keys of `from` (with a stride) are below that of i. */
static void ranks_of(const double *from, size_t n, size_t stride, struct keyed *work, size_t *rank)
{
    for (size_t i = 0; i < n; i++) work[i] = (struct keyed){ from[i * stride], i };
    qsort(work, n, sizeof *work, by_key);
    for (size_t r = 0; r < n; r++) rank[work[r].i] = r;
}

/* ---- Small matrices ---- */

/* Lower factor of a symmetric matrix, in place. Returned: false where it is not positive definite. */
static bool cholesky(double *m, size_t k)
{
    for (size_t j = 0; j < k; j++)
        for (size_t i = j; i < k; i++) {
            double sum = m[i * k + j];
            for (size_t q = 0; q < j; q++) sum -= m[i * k + q] * m[j * k + q];
            if (i == j && !(sum > 1e-10)) return false;
            m[i * k + j] = i == j ? sqrt(sum) : sum / m[j * k + j];
        }
    return true;
}

/* x becomes L^-1 x, and L x. */
static void solve_lower(const double *l, size_t k, double *x)
{
    for (size_t i = 0; i < k; i++) {
        for (size_t q = 0; q < i; q++) x[i] -= l[i * k + q] * x[q];
        x[i] /= l[i * k + i];
    }
}

static void times_lower(const double *l, size_t k, double *x)
{
    for (size_t i = k; i-- > 0;) {
        double sum = 0.0;
        for (size_t q = 0; q <= i; q++) sum += l[i * k + q] * x[q];
        x[i] = sum;
    }
}

/* Correlations of the columns of n rows, whose means are 0. */
static void correlate(const double *score, size_t n, size_t k, double *out)
{
    for (size_t a = 0; a < k; a++)
        for (size_t b = 0; b <= a; b++) {
            double sum = 0.0;
            for (size_t i = 0; i < n; i++) sum += score[i * k + a] * score[i * k + b];
            out[a * k + b] = out[b * k + a] = sum;
        }
    for (size_t a = 0; a < k; a++)
        for (size_t b = 0; b < a; b++)
            out[a * k + b] = out[b * k + a] = out[a * k + b] / sqrt(out[a * k + a] * out[b * k + b]);
    for (size_t a = 0; a < k; a++) out[a * k + a] = 1.0;
}

/* ---- Samples ---- */

struct latin {
    uint64_t seed;
    size_t n, k;
    double *score;  /* n x k: normal quantiles, each column in an order of its own */
    double *ranked; /* the same, uniform about 0 */
    double *own, *wanted;
    struct keyed *work;
    size_t *rank;
};

/* Numbers become the normal quantiles of their ranks. */
static void score(const struct latin *l)
{
    for (size_t v = 0; v < l->k; v++) {
        ranks_of(l->score + v, l->n, l->k, l->work, l->rank);
        for (size_t i = 0; i < l->n; i++)
            l->score[i * l->k + v] = wf_normal_quantile(((double)l->rank[i] + 1.0) / ((double)l->n + 1.0));
    }
}

static void draw_scores(const struct latin *l)
{
    for (size_t v = 0; v < l->k; v++)
        for (size_t i = 0; i < l->n; i++)
            l->score[i * l->k + v] =
                wf_random_uniform(l->seed, wf_random_stream(PURPOSE, v, STREAM_ORDER), i);
    score(l);
}

/* The correlation of normal scores that gives a correlation of ranks (Pearson K. 1907). */
static double of_scores(double rank) { return 2.0 * sin(WF_PI / 6.0 * rank); }

/* Mix the scores so that correlations `own` become `wanted`, both factorised; without `own` as they are. */
static void mix(const struct latin *l, bool known)
{
    for (size_t i = 0; i < l->n; i++) {
        if (known) solve_lower(l->own, l->k, l->score + i * l->k);
        times_lower(l->wanted, l->k, l->score + i * l->k);
    }
    score(l);
}

/* First by the correlations of the scores; then, a little, by those of the ranks themselves. */
static bool impose(const struct latin *l, const double *rank)
{
    enum { PASSES = 4 };
    size_t k = l->k;
    for (size_t i = 0; i < k * k; i++) l->wanted[i] = i % (k + 1) ? of_scores(rank[i]) : 1.0;
    if (!cholesky(l->wanted, k)) return false;
    correlate(l->score, l->n, k, l->own);
    bool known = l->n > k && cholesky(l->own, k);
    mix(l, known);
    memcpy(l->wanted, rank, k * k * sizeof *rank);
    if (!cholesky(l->wanted, k)) return false;
    for (int pass = 1; pass < PASSES && known; pass++) {
        for (size_t i = 0; i < l->n * k; i++) l->ranked[i] = gsl_cdf_ugaussian_P(l->score[i]) - 0.5;
        correlate(l->ranked, l->n, k, l->own);
        if (cholesky(l->own, k)) mix(l, true);
    }
    return true;
}

/* The draw of each sample in the n-th that its score has by rank. */
static void place_draws(const struct latin *l, double *out)
{
    for (size_t v = 0; v < l->k; v++) {
        ranks_of(l->score + v, l->n, l->k, l->work, l->rank);
        for (size_t i = 0; i < l->n; i++) {
            double inside =
                wf_random_uniform(l->seed, wf_random_stream(PURPOSE, v, STREAM_PLACE), l->rank[i]);
            out[i * l->k + v] = ((double)l->rank[i] + inside) / (double)l->n;
        }
    }
}

enum wf_status wf_latin(uint64_t seed, size_t n, size_t k, const double *rank, double *out, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct latin l = { seed,
                       n,
                       k,
                       WF_TAKE(&a, n * k, double),
                       WF_TAKE(&a, n * k, double),
                       WF_TAKE(&a, k * k, double),
                       WF_TAKE(&a, k * k, double),
                       WF_TAKE(&a, n, struct keyed),
                       WF_TAKE(&a, n, size_t) };
    enum wf_status s = WF_OK;
    if (n && k && (!l.score || !l.ranked || !l.own || !l.wanted || !l.work || !l.rank))
        s = wf_fail(e, WF_ENOMEM, "not enough memory for %zu samples of %zu values", n, k);
    if (!s) draw_scores(&l);
    if (!s && !impose(&l, rank))
        s = wf_fail(e, WF_EINTERNAL, "the correlations of %zu values contradict each other", k);
    if (!s) place_draws(&l, out);
    wf_arena_free(&a);
    return s;
}

/* ---- What samples say ---- */

double wf_order_statistic(const double *ascending, size_t n, double share)
{
    double at = share * ((double)n + 1.0) - 1.0;
    if (!n) return NAN;
    if (at <= 0.0) return ascending[0];
    if (at >= (double)n - 1.0) return ascending[n - 1];
    size_t i = (size_t)at;
    double s = at - (double)i, low = ascending[i], high = ascending[i + 1];
    return s > 0.0 && low != high ? wf_between(low, high, s) : low;
}

void wf_binomial_band(size_t hits, size_t n, double z, double *low, double *high)
{
    double m = (double)n, p = (double)hits / m, square = z * z;
    double middle = (p + square / (2.0 * m)) / (1.0 + square / m);
    double half = z / (1.0 + square / m) * sqrt(p * (1.0 - p) / m + square / (4.0 * m * m));
    *low = hits ? fmax(0.0, middle - half) : 0.0;
    *high = hits < n ? fmin(1.0, middle + half) : 1.0;
}

/* Expected normal value, and its square, above the standardised bound b. */
static void above(double b, double mean, double sd, double *first, double *second)
{
    double hazard = gsl_ran_ugaussian_pdf(b) / gsl_cdf_ugaussian_Q(b);
    if (b > 30.0) hazard = b; /* its limit, where both underflow */
    *first = mean + sd * hazard;
    *second = mean * mean + 2.0 * mean * sd * hazard + sd * sd * (1.0 + b * hazard);
}

struct wf_lognormal wf_lognormal_fit(const double *value, size_t n, double bound)
{
    enum { LEAST = 5, ROUNDS = 500 };
    struct wf_lognormal out = { .median = NAN, .beta = NAN };
    double sum = 0.0, squares = 0.0;
    for (size_t i = 0; i < n; i++) {
        if (isinf(value[i])) continue;
        double x = log(value[i]);
        sum += x, squares += x * x, out.seen++;
    }
    out.above = n - out.seen;
    if (out.seen < LEAST) return out;
    double mean = sum / (double)out.seen, variance = squares / (double)out.seen - mean * mean;
    for (int k = 0; k < ROUNDS && out.above && variance > 0.0; k++) {
        double sd = sqrt(variance), first, second, before = mean;
        above((log(bound) - mean) / sd, mean, sd, &first, &second);
        mean = (sum + (double)out.above * first) / (double)n;
        variance = (squares + (double)out.above * second) / (double)n - mean * mean;
        if (fabs(mean - before) < 1e-12 * sd && fabs(sqrt(variance) - sd) < 1e-12 * sd) break;
    }
    if (!(variance > 1e-20)) return out;
    out.median = exp(mean), out.beta = sqrt(variance);
    return out;
}

double wf_lognormal_share(const struct wf_lognormal *l, double x)
{
    return x > 0.0 ? gsl_cdf_ugaussian_P(log(x / l->median) / l->beta) : 0.0;
}
