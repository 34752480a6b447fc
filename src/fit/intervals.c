/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/intervals.h"
#include "base/num.h"
#include "base/progress.h"
#include "base/random.h"
#include "fit/session.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Scatter of the readings about the fit: sigmas that are not given, correlation of neighbours, reduced
 * chi-square. */

static enum wf_status groups_of(const struct wf_experiment *x, struct wf_fit *out, struct wf_arena *a,
                                struct wf_err *e)
{
    size_t most = 0;
    for (size_t t = 0; t < x->tests; t++) most += x->test[t].sensors;
    out->groups = 0;
    if (!(out->group = WF_TAKE(a, most, struct wf_fit_group)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for groups");
    for (size_t t = 0; t < x->tests; t++)
        for (size_t s = 0; s < x->test[t].sensors; s++) {
            struct wf_fit_group g = { .test = t, .sensor = s, .inflation = 1 };
            for (size_t i = 0; i < x->data; i++) g.n += x->datum[i].test == t && x->datum[i].sensor == s;
            if (g.n) out->group[out->groups++] = g;
        }
    return WF_OK;
}

/* Residuals (measured - predicted) over a sigma, of one group. Returned: their number. */
static size_t collect(const struct wf_session *s, const struct wf_fit_group *g, bool plain, double *r)
{
    size_t n = 0;
    for (size_t i = 0; i < s->x->data; i++) {
        const struct wf_fit_datum *d = &s->x->datum[i];
        if (d->test != g->test || d->sensor != g->sensor) continue;
        r[n++] = (d->value - s->reading[i]) / (plain ? 1 : d->sigma);
    }
    return n;
}

/* Correlation of neighbouring residuals; 0 where it is not significant (two standard errors). */
static double neighbours(const double *r, size_t n)
{
    double square = 0, lag = 0;
    if (n < 10) return 0;
    for (size_t i = 0; i < n; i++) square += r[i] * r[i];
    for (size_t i = 1; i < n; i++) lag += r[i] * r[i - 1];
    double rho = square > 0 ? lag / square : 0;
    return rho > 2 / sqrt((double)n) ? fmin(rho, 1 - 2 / (double)n) : 0;
}

/* Estimate the sigmas of sensors without a given one. Returned: largest relative change. */
static double renew(struct wf_session *s, struct wf_fit *out, double *r, double *scratch)
{
    double most = 0, share = 1 - (double)s->n / (double)(s->x->data > s->n ? s->x->data : s->n + 1);
    for (size_t k = 0; k < out->groups; k++) {
        struct wf_fit_group *g = &out->group[k];
        size_t n = collect(s, g, true, r);
        double square = 0;
        for (size_t i = 0; i < n; i++) square += r[i] * r[i];
        g->rms = sqrt(square / (double)n);
        g->correlation = neighbours(r, n);
        g->inflation = sqrt((1 + g->correlation) / (1 - g->correlation));
        bool unknown = s->x->test[g->test].sensor[g->sensor].estimated, robust = s->o->loss != WF_LOSS_NONE;
        double sigma = (robust ? wf_robust_sd(r, n, scratch) : g->rms) / sqrt(fmax(share, 0.1)), sum = 0;
        for (size_t i = 0; i < s->x->data; i++) {
            struct wf_fit_datum *d = &s->x->datum[i];
            if (d->test != g->test || d->sensor != g->sensor) continue;
            if (unknown) {
                sigma = fmax(sigma, 1e-9 * fabs(d->value) + 1e-300);
                most = fmax(most, fabs(sigma / d->sigma - 1));
                d->sigma = sigma;
            }
            sum += d->sigma;
        }
        g->sigma = sum / (double)n;
        out->sigma_estimated |= unknown;
    }
    return most;
}

/* Reduced chi-square with the given sigmas; with a robust loss from the robust standard deviation. */
static void judge(struct wf_session *s, struct wf_fit *out, double *r, double *scratch)
{
    size_t m = s->x->data;
    out->chi_square = 0;
    out->freedom = m > s->n ? m - s->n : 0;
    for (size_t i = 0; i < m; i++) {
        const struct wf_fit_datum *d = &s->x->datum[i];
        r[i] = (d->value - s->reading[i]) / d->sigma;
        out->chi_square += r[i] * r[i];
    }
    out->reduced = out->freedom ? out->chi_square / (double)out->freedom : NAN;
    if (s->o->loss != WF_LOSS_NONE && out->freedom) {
        double sd = wf_robust_sd(r, m, scratch);
        out->reduced = sd * sd * (double)m / (double)out->freedom;
    }
}

static void take_part(struct wf_session *s, const struct wf_fit *out)
{
    double wide = sqrt(fmax(1, out->freedom ? out->reduced : 1));
    for (size_t k = 0; k < out->groups; k++)
        for (size_t i = 0; i < s->x->data; i++) {
            const struct wf_fit_datum *d = &s->x->datum[i];
            if (d->test == out->group[k].test && d->sensor == out->group[k].sensor)
                s->sigma[i] = d->sigma * out->group[k].inflation * wide;
        }
}

enum wf_status wf_fit_spread(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e)
{
    enum { ROUNDS = 12 };
    double *r = WF_TAKE(a, s->x->data, double), *scratch = WF_TAKE(a, s->x->data, double);
    if (!r || !scratch) return wf_fail(e, WF_ENOMEM, "not enough memory for the residuals");
    enum wf_status status = groups_of(s->x, out, a, e);
    wf_stage_begin(0, false, "rounds of the fit");
    for (int round = 0; !status && round < ROUNDS; round++) {
        wf_stage_step(round > 0);
        status = wf_session_solve(s, &out->lsq, e);
        if (status) break;
        if ((status = wf_predict(s->predictor, s->internal, s->reading, NULL, e))) break;
        double change = renew(s, out, r, scratch);
        double wide = out->reduced;
        judge(s, out, r, scratch);
        take_part(s, out);
        bool same = fabs(out->reduced - wide) <= 1e-3 * fmax(1, wide) || !out->freedom;
        if (out->lsq.stopped || (round > 0 && change < 1e-3 && same)) break;
    }
    return status;
}

/* Several start values, to find other minima; intervals by the bootstrap (Efron 1979). */

enum { START = 41, SAMPLE = 42 }; /* streams of random numbers */

enum wf_status wf_fit_restart(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e)
{
    double *best = WF_TAKE(a, s->n, double);
    struct wf_lsq_result r;
    if (!best) return wf_fail(e, WF_ENOMEM, "not enough memory for more starts");
    enum wf_status status = wf_session_solve(s, &r, e);
    if (status || r.stopped) return status;
    memcpy(best, s->internal, s->n * sizeof *best);
    double least = r.cost, first = r.cost;
    out->starts = out->starts_same = 1;
    wf_stage_begin(s->o->starts - 1, false, "further starts");
    for (size_t i = 1; i < s->o->starts; i++) {
        wf_stage_step(i > 1);
        struct wf_err why = { 0 };
        uint64_t stream = wf_random_stream(START, i, 0);
        for (size_t k = 0; k < s->n; k++) {
            double spread = 2 * wf_random_uniform(s->o->seed, stream, k) - 1;
            double from = wf_param_internal(&s->p[k], s->p[k].start);
            double x = wf_param_nuisance(&s->p[k]) ? from + spread : from + log(3) * spread;
            s->internal[k] = fmin(fmax(x, s->low[k]), s->high[k]);
        }
        if (wf_session_solve(s, &r, &why)) continue;
        if (r.stopped) break;
        out->starts++;
        double close = 1e-6 * (1 + least);
        if (r.cost < least - close) out->starts_same = 0;
        if (r.cost <= least + close) out->starts_same++;
        if (r.cost < least) {
            least = r.cost;
            memcpy(best, s->internal, s->n * sizeof *best);
        }
    }
    memcpy(s->internal, best, s->n * sizeof *best);
    /* residuals, and so sigmas, differ at another minimum */
    return least < first * (1 - 1e-6) ? wf_fit_spread(s, out, a, e) : wf_session_solve(s, &out->lsq, e);
}

static double quantile(const double *x, size_t n, double p)
{
    double at = p * (double)(n - 1);
    size_t i = (size_t)at;
    return i + 1 < n ? x[i] + (at - (double)i) * (x[i + 1] - x[i]) : x[n - 1];
}

enum { OWN = 8 }; /* readings of sensors with fewer are resampled as one pool */

/* Draw, with replacement, as many readings of every sensor as it has. A reading's weight is the number of
 * times it is drawn. */
static void draw(struct wf_session *s, const struct wf_fit *out, size_t *pool, uint64_t sample)
{
    for (size_t i = 0; i < s->x->data; i++) s->x->datum[i].weight = 0;
    for (size_t g = 0; g <= out->groups; g++) { /* the last: the pool of sensors with few readings */
        uint64_t stream = wf_random_stream(SAMPLE, sample, g);
        size_t n = 0;
        for (size_t i = 0; i < s->x->data; i++) {
            const struct wf_fit_datum *d = &s->x->datum[i];
            size_t k = 0;
            while (out->group[k].test != d->test || out->group[k].sensor != d->sensor) k++;
            bool own = out->group[k].n >= OWN;
            if (g < out->groups ? own && k == g : !own) pool[n++] = i;
        }
        for (size_t j = 0; j < n; j++)
            s->x->datum[pool[(size_t)(wf_random_uniform(s->o->seed, stream, j) * (double)n)]].weight += 1;
    }
}

/* Is a parameter of the best fit on a bound? */
static bool on_bound(const struct wf_session *s, const double *optimum, size_t k)
{
    double near = 1e-9 * (s->high[k] - s->low[k]);
    return !(optimum[k] - s->low[k] > near && s->high[k] - optimum[k] > near);
}

/* Fit one data set from the best fit. A search that begins on a bound may stay there although a lower minimum
 * lies inside, so where parameters of the best fit are on a bound it is repeated from their start values: the
 * lower one counts. */
static enum wf_status solve_resample(struct wf_session *s, const double *optimum, double *first,
                                     struct wf_lsq_result *r, struct wf_err *e)
{
    struct wf_lsq_result again;
    struct wf_err why = { 0 };
    bool any = false;
    memcpy(s->internal, optimum, s->n * sizeof *optimum);
    enum wf_status status = wf_session_solve(s, r, e);
    memcpy(first, s->internal, s->n * sizeof *first);
    for (size_t k = 0; k < s->n; k++) {
        bool bound = on_bound(s, optimum, k);
        s->internal[k] = bound ? wf_param_internal(&s->p[k], s->p[k].start) : optimum[k];
        any = any || bound;
    }
    if (any && !r->stopped && !wf_session_solve(s, &again, &why) && (status || again.cost < r->cost)) {
        *r = again;
        return WF_OK;
    }
    r->stopped = r->stopped || s->stopped;
    memcpy(s->internal, first, s->n * sizeof *first);
    return status;
}

enum wf_status wf_fit_resample(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e)
{
    size_t most = s->o->resamples;
    double *value = WF_TAKE(a, out->free * most, double), *optimum = WF_TAKE(a, s->n, double),
           *first = WF_TAKE(a, s->n, double);
    size_t *pool = WF_TAKE(a, s->x->data, size_t);
    if (!value || !optimum || !first || !pool)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu data sets", most);
    memcpy(optimum, s->internal, s->n * sizeof *optimum);
    wf_stage_begin(most, false, "data sets of the bootstrap");
    for (size_t b = 0; b < most; b++) {
        wf_stage_step(b > 0);
        struct wf_lsq_result r;
        struct wf_err why = { 0 };
        draw(s, out, pool, b);
        if (solve_resample(s, optimum, first, &r, &why)) continue;
        if (r.stopped) break;
        for (size_t k = 0; k < out->free; k++)
            value[k * most + out->resampled] = wf_param_value(&s->p[k], s->internal[k]);
        out->resampled++;
    }
    for (size_t i = 0; i < s->x->data; i++) s->x->datum[i].weight = 1;
    memcpy(s->internal, optimum, s->n * sizeof *optimum);
    for (size_t k = 0; k < out->free && out->resampled >= 20; k++) {
        qsort(value + k * most, out->resampled, sizeof *value, wf_ascending);
        out->estimate[k].resampled_low = quantile(value + k * most, out->resampled, 0.025);
        out->estimate[k].resampled_high = quantile(value + k * most, out->resampled, 0.975);
    }
    return WF_OK;
}

/* Covariance, bands and influence from the weighted slopes at the optimum. */

/* Least ratio of a singular value to the largest that is taken as information. */
static const double blind = 1e-9;

/* C = V diag(1/s^2) V' of the rows x n matrix W (destroyed); singular values below the limit are raised
 * to it, so that undetermined combinations get a very large variance. */
static enum wf_status inverse(gsl_matrix *W, size_t n, double *C, struct wf_err *e)
{
    gsl_matrix *V = gsl_matrix_alloc(n, n);
    gsl_vector *s = gsl_vector_alloc(n), *work = gsl_vector_alloc(n);
    int wrong = !V || !s || !work || gsl_linalg_SV_decomp(W, V, s, work);
    double top = wrong ? 0 : gsl_vector_get(s, 0);
    for (size_t i = 0; !wrong && i < n; i++)
        for (size_t j = 0; j < n; j++) {
            double sum = 0;
            for (size_t k = 0; k < n; k++) {
                double v = fmax(gsl_vector_get(s, k), blind * top);
                sum += gsl_matrix_get(V, i, k) * gsl_matrix_get(V, j, k) / (v * v);
            }
            C[i * n + j] = sum;
        }
    if (V) gsl_matrix_free(V);
    if (s) gsl_vector_free(s);
    if (work) gsl_vector_free(work);
    return wrong || !(top > 0) ? wf_fail(e, WF_EINPUT, "the readings do not change with any parameter")
                               : WF_OK;
}

/* Row of the weighted slopes: data first, then priors; columns of parameters at a bound are left out. */
static void weighted(const struct wf_session *s, size_t row, const bool *out, double *w)
{
    size_t m = s->x->data, prior = m;
    for (size_t k = 0; k < s->n; k++) {
        if (row < m)
            w[k] = out[k] ? 0 : s->slope[row * s->n + k] / s->sigma[row] * sqrt(s->x->datum[row].weight);
        else
            w[k] = 0;
        if (s->o->priors && s->p[k].prior_sd > 0 && prior++ == row && !out[k]) w[k] = 1 / s->p[k].prior_sd;
    }
}

static void multiply(const double *A, const double *B, size_t n, double *C)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            C[i * n + j] = 0;
            for (size_t k = 0; k < n; k++) C[i * n + j] += A[i * n + k] * B[k * n + j];
        }
}

/* Huber's sandwich covariance: outer matrix from slopes of psi (at least 0.05 psi/r), inner from psi^2. */
static enum wf_status sandwich(const struct wf_session *s, const bool *at_bound, const size_t *of, size_t n,
                               gsl_matrix *W, double *w, double *C, struct wf_arena *a, struct wf_err *e)
{
    double *fill = WF_TAKE(a, n * n, double), *half = WF_TAKE(a, n * n, double),
           *bread = WF_TAKE(a, n * n, double);
    if (!fill || !half || !bread) return wf_fail(e, WF_ENOMEM, "not enough memory for the covariance");
    size_t rows = s->x->data + s->priors;
    for (size_t i = 0; i < rows; i++) {
        double psi = 1, slope = 1;
        weighted(s, i, at_bound, w);
        if (i < s->x->data) {
            double r = (s->x->datum[i].value - s->reading[i]) / s->sigma[i];
            wf_losses[s->o->loss].slopes(s->scale, r, &psi, &slope);
            /* psi can fall with r; the lower limit keeps the outer matrix positive definite */
            slope = fmax(slope, 0.05 * (r != 0 ? psi / r : 1));
        }
        for (size_t j = 0; j < n; j++) {
            gsl_matrix_set(W, i, j, sqrt(slope) * w[of[j]]);
            for (size_t k = 0; k < n; k++) fill[j * n + k] += psi * psi * w[of[j]] * w[of[k]];
        }
    }
    enum wf_status status = inverse(W, n, bread, e);
    if (status) return status;
    multiply(bread, fill, n, half);
    multiply(half, bread, n, C);
    double more = (double)s->x->data / fmax(1, (double)s->x->data - (double)s->n);
    for (size_t j = 0; j < n * n; j++) C[j] *= more;
    return WF_OK;
}

static enum wf_status reduced_covariance(const struct wf_session *s, const bool *at_bound, const size_t *of,
                                         size_t n, double *C, double *w, struct wf_arena *a, struct wf_err *e)
{
    size_t rows = s->x->data + s->priors;
    if (rows < n) return wf_fail(e, WF_EINPUT, "%zu readings cannot determine %zu parameters", rows, n);
    gsl_matrix *W = gsl_matrix_calloc(rows, n);
    if (!W) return wf_fail(e, WF_ENOMEM, "not enough memory for the covariance");
    enum wf_status status;
    if (s->o->loss != WF_LOSS_NONE) {
        status = sandwich(s, at_bound, of, n, W, w, C, a, e);
    } else {
        for (size_t i = 0; i < rows; i++) {
            weighted(s, i, at_bound, w);
            for (size_t j = 0; j < n; j++) gsl_matrix_set(W, i, j, w[of[j]]);
        }
        status = inverse(W, n, C, e);
    }
    gsl_matrix_free(W);
    return status;
}

/* Leverage, band and one-step influence of every reading (Cook 1977; Belsley, Kuh and Welsch 1980). */
static void readings(const struct wf_session *s, struct wf_fit *out, const bool *at_bound, double *w)
{
    size_t n = s->n;
    for (size_t i = 0; i < s->x->data; i++) {
        double lever = 0, r = (s->x->datum[i].value - s->reading[i]) / s->sigma[i], psi, slope;
        weighted(s, i, at_bound, w);
        wf_losses[s->o->loss].slopes(s->scale, r, &psi, &slope);
        for (size_t j = 0; j < n; j++)
            for (size_t k = 0; k < n; k++) lever += w[j] * out->covariance[j * n + k] * w[k];
        lever = fmin(lever, 1 - 1e-9);
        out->reading[i] = s->reading[i];
        out->sigma[i] = s->sigma[i];
        out->residual[i] = r;
        out->band[i] = out->quantile * sqrt(fmax(lever, 0)) * s->sigma[i];
        for (size_t k = 0; k < out->free; k++) {
            double change = 0, sd = out->estimate[k].sd;
            for (size_t j = 0; j < n; j++) change += out->covariance[k * n + j] * w[j];
            change = fabs(change * psi / (1 - lever)) / sd;
            if (sd > 0 && change > out->influence[i]) out->influence[i] = change, out->influenced[i] = k;
        }
    }
}

static void intervals(const struct wf_session *s, struct wf_fit *out)
{
    size_t n = s->n;
    bool normal = !out->sigma_estimated && !(out->reduced > 1) && s->o->loss == WF_LOSS_NONE;
    out->quantile = 1.959963984540054;
    if (!normal && out->freedom) out->quantile = gsl_cdf_tdist_Pinv(0.975, (double)out->freedom);
    for (size_t k = 0; k < n; k++) {
        struct wf_estimate *q = &out->estimate[k];
        double x = s->internal[k], sd = sqrt(out->covariance[k * n + k]);
        bool open = q->at_low || q->at_high || !(sd < 100);
        *q = (struct wf_estimate){ .value = wf_param_value(&s->p[k], x),
                                   .sd = sd,
                                   .low = NAN,
                                   .high = NAN,
                                   .profile_low = NAN,
                                   .profile_high = NAN,
                                   .resampled_low = NAN,
                                   .resampled_high = NAN,
                                   .at_low = q->at_low,
                                   .at_high = q->at_high };
        if (open) continue;
        q->low = wf_param_value(&s->p[k], x - out->quantile * sd);
        q->high = wf_param_value(&s->p[k], x + out->quantile * sd);
    }
}

enum wf_status wf_fit_covariance(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                                 struct wf_err *e)
{
    size_t n = s->n, m = 0;
    bool *at_bound = WF_TAKE(a, n, bool);
    size_t *of = WF_TAKE(a, n, size_t);
    double *C = WF_TAKE(a, n * n, double), *w = WF_TAKE(a, n, double);
    if (!at_bound || !of || !C || !w) return wf_fail(e, WF_ENOMEM, "not enough memory for the covariance");
    enum wf_status status = wf_predict(s->predictor, s->internal, s->reading, s->slope, e);
    if (status) return status;
    for (size_t k = 0; k < n; k++) {
        struct wf_estimate *q = &out->estimate[k];
        double near = 1e-6 * (s->high[k] - s->low[k]);
        q->at_low = s->internal[k] - s->low[k] <= near;
        q->at_high = s->high[k] - s->internal[k] <= near;
        at_bound[k] = q->at_low || q->at_high;
        if (!at_bound[k]) of[m++] = k;
    }
    wf_quiet_begin();
    if (m) status = reduced_covariance(s, at_bound, of, m, C, w, a, e);
    for (size_t j = 0; !status && j < m; j++)
        for (size_t k = 0; k < m; k++) out->covariance[of[j] * n + of[k]] = C[j * m + k];
    if (!status) intervals(s, out);
    wf_quiet_end();
    if (status) return status;
    for (size_t j = 0; j < n; j++)
        for (size_t k = 0; k < n; k++) {
            double both = out->estimate[j].sd * out->estimate[k].sd;
            out->correlation[j * n + k] = j == k ? 1 : both > 0 ? out->covariance[j * n + k] / both : 0;
        }
    readings(s, out, at_bound, w);
    for (size_t i = 0; i < s->x->data * n; i++) out->slope[i] = s->slope[i];
    return WF_OK;
}

/* Description of the combinations of parameters that the data do not determine. */

/* A combination is undetermined above this standard deviation of a logarithm: the 95 % interval is then a
 * factor of e in both directions. */
static const double loose_sd = 0.5;

/* "level0.youngs_modulus rises while root.stiffness falls": parameters whose component of the unit vector is
 * 0.2 or more. */
static const char *describe(const struct wf_fit *f, const double *v, double sd, struct wf_arena *a)
{
    char text[600];
    size_t used = 0, parts = 0, most = 0;
    for (size_t k = 0; k < f->free; k++)
        parts += fabs(v[k]) >= 0.2, most = fabs(v[k]) > fabs(v[most]) ? k : most;
    size_t named = 0;
    for (size_t k = 0; k < f->free && used < sizeof text; k++) {
        if (fabs(v[k]) < 0.2) continue;
        const char *way = parts == 1 ? "" : v[k] * v[most] > 0 ? " rises" : " falls";
        int m = snprintf(text + used, sizeof text - used, "%s%s%s", named++ ? " while " : "",
                         f->param[k].name, way);
        if (m < 0) break;
        used += (size_t)m;
    }
    if (parts == 1)
        return sd > 20 ? wf_arena_print(a, "%s at all", text)
                       : wf_arena_print(a, "%s better than within a factor of %.2g", text, exp(1.96 * sd));
    return sd > 20 ? wf_arena_print(a, "one combination at all: %s leaves every reading as it is", text)
                   : wf_arena_print(a, "one combination better than within a factor of %.2g: %s",
                                    exp(1.96 * sd), text);
}

/* Add a single parameter that is not determined: on its bound, or with a profile that does not reach the
 * limit. */
static void single(struct wf_fit *f, size_t k, struct wf_arena *a)
{
    const struct wf_estimate *q = &f->estimate[k];
    bool low = isnan(q->profile_low), high = isnan(q->profile_high), bound = q->at_low || q->at_high;
    if (!bound && !(q->profiled && (low || high))) return;
    const char *why = q->at_low ? ": the fit ended on its lower bound" : ": the fit ended on its upper bound";
    if (!bound) why = low && high ? " on either side" : low ? " from below" : " from above";
    struct wf_loose *l = &f->loose[f->loose_n++];
    *l = (struct wf_loose){ .sd = NAN,
                            .bound = bound,
                            .text = wf_arena_print(a, "%s%s", f->param[k].name, why) };
    if (!l->text) l->text = f->param[k].name;
}

enum wf_status wf_fit_loose(struct wf_fit *f, struct wf_arena *a, struct wf_err *e)
{
    size_t n = f->free;
    f->loose_n = 0;
    f->loose = WF_TAKE(a, 2 * n, struct wf_loose);
    double *v = WF_TAKE(a, n, double);
    if (!f->loose || !v) return wf_fail(e, WF_ENOMEM, "not enough memory for the verdict");
    wf_quiet_begin();
    gsl_matrix *C = n ? gsl_matrix_alloc(n, n) : NULL, *V = n ? gsl_matrix_alloc(n, n) : NULL;
    gsl_vector *value = n ? gsl_vector_alloc(n) : NULL;
    gsl_eigen_symmv_workspace *work = n ? gsl_eigen_symmv_alloc(n) : NULL;
    bool ok = C && V && value && work;
    for (size_t i = 0; ok && i < n; i++)
        for (size_t j = 0; j < n; j++) gsl_matrix_set(C, i, j, f->covariance[i * f->params + j]);
    if (ok) ok = !gsl_eigen_symmv(C, value, V, work);
    for (size_t k = 0; ok && k < n; k++) {
        double sd = sqrt(fmax(gsl_vector_get(value, k), 0));
        if (!(sd > loose_sd)) continue;
        for (size_t i = 0; i < n; i++) v[i] = gsl_matrix_get(V, i, k);
        struct wf_loose *l = &f->loose[f->loose_n++];
        *l = (struct wf_loose){ .sd = sd, .text = describe(f, v, sd, a) };
        if (!l->text) l->text = "a combination of the parameters";
    }
    for (size_t k = 0; ok && k < n; k++) single(f, k, a);
    if (C) gsl_matrix_free(C);
    if (V) gsl_matrix_free(V);
    if (value) gsl_vector_free(value);
    if (work) gsl_eigen_symmv_free(work);
    wf_quiet_end();
    return ok || !n ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the verdict");
}

/* Profile likelihood: one parameter fixed at several values, the others refitted at each. */

enum { SIDE = 12, NARROW = 8 }; /* largest number of points on each side, and of steps to bracket its end */

struct walk {
    struct wf_session *s;
    size_t k;
    double best; /* cost at the optimum                  */
    const double *optimum;
    double *inside; /* parameters at the last point below the limit */
    double limit;   /* rise at the end of the interval      */
    struct wf_profile_point *point;
    size_t n;
};

/* Square root of the rise with the parameter fixed at x and the others refitted from their present values;
 * NAN where the fit fails. */
static double rise_at(struct walk *w, double x)
{
    struct wf_session *s = w->s;
    struct wf_lsq_result r;
    s->internal[w->k] = x;
    if (wf_session_solve(s, &r, &(struct wf_err){ 0 }) || r.stopped) return NAN;
    double rise = fmax(2 * (r.cost - w->best), 0);
    w->point[w->n++] = (struct wf_profile_point){ wf_param_value(&s->p[w->k], x), rise };
    return sqrt(rise);
}

/* Value between `in` and `out` at which the root of the rise reaches the limit, by linear interpolation. The
 * bracket is narrowed first while the outer point exceeds the limit by more than 5 %, because the curve is
 * not linear there. w->inside: the other parameters at `in`. */
static double crossing(struct walk *w, double in, double root_in, double out, double root_out)
{
    const double goal = sqrt(w->limit);
    for (int i = 0; i < NARROW && root_out > 1.05 * goal; i++) {
        double share = fmin(fmax((goal - root_in) / (root_out - root_in), 0.25), 0.75),
               x = in + share * (out - in);
        memcpy(w->s->internal, w->inside, w->s->n * sizeof *w->inside);
        double root = rise_at(w, x);
        if (isnan(root)) return NAN;
        if (root >= goal) {
            out = x, root_out = root;
            continue;
        }
        in = x, root_in = root;
        memcpy(w->inside, w->s->internal, w->s->n * sizeof *w->inside);
    }
    return root_out > root_in ? in + (out - in) * (goal - root_in) / (root_out - root_in) : out;
}

/* Step from the optimum outwards until the rise exceeds the limit or the bound is reached. Returned: internal
 * value at the limit, NAN where it is not reached. */
static double side(struct walk *w, double step)
{
    struct wf_session *s = w->s;
    const double goal = sqrt(w->limit), bound = step > 0 ? s->high[w->k] : s->low[w->k];
    double x = w->optimum[w->k], root = 0;
    memcpy(s->internal, w->optimum, s->n * sizeof *s->internal);
    for (int i = 0; i < SIDE; i++) {
        double from = x;
        x += step;
        bool last = step > 0 ? x >= bound : x <= bound;
        if (last) x = bound;
        memcpy(w->inside, s->internal, s->n * sizeof *w->inside);
        double now = rise_at(w, x);
        if (isnan(now)) return NAN;
        if (now >= goal) return crossing(w, from, root, x, now);
        /* the root of the rise is nearly linear: step 5 % beyond the extrapolated limit */
        double slope = (now - root) / (x - from);
        root = now;
        if (last) return NAN;
        if (i > 1 && slope * step > 0)
            step = copysign(fmin(fmax(fabs((goal - now) / slope) * 1.05, 0.3 * fabs(step)), 3 * fabs(step)),
                            step);
    }
    return NAN;
}

static int by_value(const void *a, const void *b)
{
    const struct wf_profile_point *x = a, *y = b;
    return (x->value > y->value) - (x->value < y->value);
}

enum wf_status wf_fit_profiles(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e)
{
    double *optimum = WF_TAKE(a, s->n, double), *inside = WF_TAKE(a, s->n, double);
    struct wf_lsq_result here;
    if (!optimum || !inside) return wf_fail(e, WF_ENOMEM, "not enough memory for the profiles");
    enum wf_status status = wf_session_solve(s, &here, e);
    if (status || here.stopped) return status;
    memcpy(optimum, s->internal, s->n * sizeof *optimum);
    wf_stage_begin(out->free, false, "profiles");
    for (size_t k = 0; k < out->free; k++) {
        struct wf_estimate *q = &out->estimate[k];
        struct walk w = { .s = s,
                          .k = k,
                          .best = here.cost,
                          .optimum = optimum,
                          .inside = inside,
                          .limit = out->quantile * out->quantile };
        if (!(w.point = WF_TAKE(a, 2 * (SIDE + NARROW) + 1, struct wf_profile_point)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for the profiles");
        w.point[w.n++] = (struct wf_profile_point){ wf_param_value(&s->p[k], optimum[k]), 0 };
        double step = q->sd > 0 && q->sd < 0.5 ? q->sd : 0.5;
        s->held[k] = true;
        double low = q->at_low ? NAN : side(&w, -0.7 * step), high = q->at_high ? NAN : side(&w, 0.7 * step);
        s->held[k] = false;
        wf_stage_step(1);
        if (s->stopped) break;
        q->profiled = true;
        q->profile_low = isnan(low) ? NAN : wf_param_value(&s->p[k], low);
        q->profile_high = isnan(high) ? NAN : wf_param_value(&s->p[k], high);
        q->point = w.point, q->points = w.n;
        qsort(q->point, q->points, sizeof *q->point, by_value);
    }
    memcpy(s->internal, optimum, s->n * sizeof *optimum);
    return WF_OK;
}
