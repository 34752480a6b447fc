/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/ring_down.h"
#include "base/num.h"
#include "fit/lsq.h"
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

enum { N = 5 }; /* cosine and sine part, decay rate, angular frequency, mean */

struct data {
    const double *t, *y;
    size_t n;
};

static bool model(void *ctx, const double *p, double *residual, double *jacobian)
{
    const struct data *d = ctx;
    for (size_t i = 0; i < d->n; i++) {
        double t = d->t[i] - d->t[0], fade = exp(-p[2] * t), c = fade * cos(p[3] * t),
               s = fade * sin(p[3] * t);
        residual[i] = p[0] * c + p[1] * s + p[4] - d->y[i];
        if (!jacobian) continue;
        double *J = jacobian + N * i;
        J[0] = c, J[1] = s, J[2] = -t * (p[0] * c + p[1] * s), J[3] = t * (p[1] * c - p[0] * s), J[4] = 1;
    }
    return true;
}

/* Frequency of the highest peak of the spectrum between `low` and `high` [Hz]. */
static double strongest(const struct data *d, double mean, double low, double high)
{
    double best = low, most = -1;
    size_t steps = (size_t)fmin(4000, 8 * (high - low) * (d->t[d->n - 1] - d->t[0])) + 2;
    for (size_t k = 0; k < steps; k++) {
        double f = low + (high - low) * (double)k / (double)(steps - 1), c = 0, s = 0;
        for (size_t i = 0; i < d->n; i++) {
            c += (d->y[i] - mean) * cos(WF_TURN * f * d->t[i]);
            s += (d->y[i] - mean) * sin(WF_TURN * f * d->t[i]);
        }
        if (c * c + s * s > most) most = c * c + s * s, best = f;
    }
    return best;
}

static enum wf_status errors(const struct data *d, const double *p, double *r, double *J, double *C,
                             struct wf_err *e)
{
    double square = 0, lag = 0;
    model((void *)d, p, r, J);
    for (size_t i = 0; i < d->n; i++) square += r[i] * r[i], lag += i ? r[i] * r[i - 1] : 0;
    double rho = square > 0 ? fmin(fmax(lag / square, 0), 0.99) : 0;
    double variance = square / (double)(d->n - N) * (1 + rho) / (1 - rho);
    wf_quiet_begin();
    gsl_matrix *A = gsl_matrix_calloc(N, N);
    for (size_t i = 0; A && i < d->n; i++)
        for (size_t j = 0; j < N; j++)
            for (size_t k = 0; k < N; k++) *gsl_matrix_ptr(A, j, k) += J[N * i + j] * J[N * i + k];
    bool ok = A && !gsl_linalg_cholesky_decomp1(A) && !gsl_linalg_cholesky_invert(A);
    for (size_t j = 0; ok && j < N; j++)
        for (size_t k = 0; k < N; k++) C[N * j + k] = variance * gsl_matrix_get(A, j, k);
    if (A) gsl_matrix_free(A);
    wf_quiet_end();
    return ok ? WF_OK
              : wf_fail(e, WF_ENOCONV, "the sway record does not determine a frequency and a damping");
}

enum wf_status wf_ring_down(const double *t, const double *y, size_t n, struct wf_arena *a,
                            struct wf_ring_down *out, struct wf_err *e)
{
    struct data d = { t, y, n };
    double mean = 0, variance = 0, span = n > 1 ? t[n - 1] - t[0] : 0;
    double *r = WF_TAKE(a, n, double), *J = WF_TAKE(a, N * n, double), C[N * N];
    if (!r || !J) return wf_fail(e, WF_ENOMEM, "not enough memory for a record of %zu samples", n);
    if (n < 12 || !(span > 0))
        return wf_fail(e, WF_EINPUT, "a sway record needs at least 12 samples in time; there are %zu", n);
    for (size_t i = 0; i < n; i++) mean += y[i] / (double)n;
    for (size_t i = 0; i < n; i++) variance += (y[i] - mean) * (y[i] - mean) / (double)n;
    if (!(variance > 0)) return wf_fail(e, WF_EINPUT, "the sway record is constant");
    double low = 1.0 / span, high = 0.5 * (double)(n - 1) / span, f = strongest(&d, mean, low, high),
           least = INFINITY;
    double best[N] = { 0 };
    for (int k = 0; k < 6; k++) { /* starts: slow and fast decay, frequencies at and beside the peak */
        double size = sqrt(2 * variance), decay = (k % 3 == 0 ? 0.01 : k % 3 == 1 ? 0.05 : 0.2) * WF_TURN * f;
        double p[N] = { y[0] - mean, k < 3 ? 0 : size, decay, WF_TURN * f * (k < 3 ? 1 : 1.05), mean };
        const double lows[N] = { -1e3 * size, -1e3 * size, 0, 0.3 * WF_TURN * low, mean - 1e2 * size };
        const double highs[N] = { 1e3 * size, 1e3 * size, WF_TURN * high, WF_TURN * high, mean + 1e2 * size };
        struct wf_lsq q = {
            .params = N, .residuals = n, .low = lows, .high = highs, .model = model, .ctx = &d
        };
        struct wf_lsq_result got;
        for (int j = 0; j < N; j++) p[j] = fmin(fmax(p[j], lows[j]), highs[j]);
        if (wf_lsq_solve(&q, p, &got, &(struct wf_err){ 0 }) || got.cost >= least) continue;
        least = got.cost;
        memcpy(best, p, sizeof best);
    }
    if (isinf(least)) return wf_fail(e, WF_ENOCONV, "no damped sway could be fitted to the record");
    enum wf_status status = errors(&d, best, r, J, C, e);
    if (status) return status;
    double w = best[3], k = best[2], whole = hypot(w, k);
    *out = (struct wf_ring_down){ .frequency = whole / WF_TURN,
                                  .damping = k / whole,
                                  .amplitude = hypot(best[0], best[1]),
                                  .phase = atan2(-best[1], best[0]),
                                  .mean = best[4],
                                  .decay = k,
                                  .turn = w,
                                  .explained = 1 - 2 * least / ((double)n * variance) };
    out->frequency_sd = sqrt(fmax(0, k * k * C[12] + 2 * k * w * C[13] + w * w * C[18])) / whole / WF_TURN;
    /* zeta = k / hypot(k, w): d zeta = (w^2 dk - k w dw) / hypot^3 */
    out->damping_sd =
        w * sqrt(fmax(0, w * w * C[12] - 2 * k * w * C[13] + k * k * C[18])) / (whole * whole * whole);
    if (span * w < 1.5 * WF_TURN)
        return wf_fail(e, WF_EINPUT, "the sway record is shorter than a period and a half");
    return WF_OK;
}

double wf_ring_down_at(const struct wf_ring_down *r, double t)
{
    return r->amplitude * exp(-r->decay * t) * cos(r->turn * t + r->phase) + r->mean;
}
