/* How far the readings scatter about the fit: sigmas that were not given, correlation of neighbours, reduced
 * chi-square. */
#include "fit/session.h"
#include <math.h>
#include <stdio.h>

static enum wf_status groups_of(const struct wf_experiment *x, struct wf_fit *out, struct wf_arena *a,
                                struct wf_err *e)
{
    size_t most = 0;
    for (size_t t = 0; t < x->tests; t++) most += x->test[t].sensors;
    out->groups = 0;
    if (!(out->group = WF_TAKE(a, most, struct wf_fit_group)))
        return wf_fail(e, WF_ENOMEM, "no room for groups");
    for (size_t t = 0; t < x->tests; t++)
        for (size_t s = 0; s < x->test[t].sensors; s++) {
            struct wf_fit_group g = { .test = t, .sensor = s, .inflation = 1 };
            for (size_t i = 0; i < x->data; i++) g.n += x->datum[i].test == t && x->datum[i].sensor == s;
            if (g.n) out->group[out->groups++] = g;
        }
    return WF_OK;
}

/* Residuals (measured - predicted) over a sigma, of one group; returned: how many. */
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

/* Correlation of neighbouring residuals; 0 where it is within what chance gives. */
static double neighbours(const double *r, size_t n)
{
    double square = 0, lag = 0;
    if (n < 10) return 0;
    for (size_t i = 0; i < n; i++) square += r[i] * r[i];
    for (size_t i = 1; i < n; i++) lag += r[i] * r[i - 1];
    double rho = square > 0 ? lag / square : 0;
    return rho > 2 / sqrt((double)n) ? fmin(rho, 1 - 2 / (double)n) : 0;
}

/* New sigmas for sensors whose sigma is not known. Returned: largest relative change. */
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

/* Reduced chi-square of the sigmas given; with a robust loss by the robust spread. */
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
    if (!r || !scratch) return wf_fail(e, WF_ENOMEM, "no room for the residuals");
    enum wf_status status = groups_of(s->x, out, a, e);
    for (int round = 0; !status && round < ROUNDS; round++) {
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
