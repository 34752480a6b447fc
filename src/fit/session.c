/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/session.h"
#include "base/num.h"
#include "base/progress.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum wf_status wf_session_open(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                               const struct wf_fit_options *o, struct wf_arena *a, struct wf_session *s,
                               struct wf_err *e)
{
    *s = (struct wf_session){ .x = x, .p = p, .n = n, .o = o };
    for (size_t k = 0; k < n; k++) s->priors += o->priors && p[k].prior_sd > 0;
    size_t m = x->data;
    s->sigma = WF_TAKE(a, m, double), s->internal = WF_TAKE(a, n, double), s->held = WF_TAKE(a, n, bool);
    s->low = WF_TAKE(a, n, double), s->high = WF_TAKE(a, n, double);
    s->reading = WF_TAKE(a, m, double), s->slope = WF_TAKE(a, m * n, double);
    s->chain = WF_TAKE(a, n, double), s->start = WF_TAKE(a, n, double), s->free_low = WF_TAKE(a, n, double),
    s->free_high = WF_TAKE(a, n, double);
    if (!s->sigma || !s->internal || !s->held || !s->low || !s->high || !s->reading || !s->slope ||
        !s->chain || !s->start || !s->free_low || !s->free_high)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the fit of %zu readings", m);
    for (size_t k = 0; k < n; k++) {
        s->low[k] = wf_param_internal(&p[k], p[k].low);
        s->high[k] = wf_param_internal(&p[k], p[k].high);
        s->internal[k] = wf_param_internal(&p[k], p[k].start);
    }
    for (size_t i = 0; i < m; i++) s->sigma[i] = x->datum[i].sigma;
    return wf_predictor_open(x, p, n, a, &s->predictor, e);
}

void wf_session_close(struct wf_session *s)
{
    if (s->predictor) wf_predictor_close(s->predictor);
}

/* Stiffnesses are passed to the solver as flexibilities relative to the start value. Readings are nearly
 * linear in them, so the valley of the cost along which stem and root compensate each other is straight. */
static bool flexible(const struct wf_fit_param *p)
{
    return p->quantity == WF_FIT_YOUNGS || p->quantity == WF_FIT_SHEAR || p->quantity == WF_FIT_ROOT;
}

static double packed_of(const struct wf_session *s, size_t k, double internal)
{
    double x = fmin(fmax(internal, s->low[k]), s->high[k]);
    return flexible(&s->p[k]) ? exp(wf_param_internal(&s->p[k], s->p[k].start) - x) : internal;
}

/* slope: derivative of the internal value by the packed one. */
static double internal_of(const struct wf_session *s, size_t k, double packed, double *slope)
{
    *slope = 1;
    if (!flexible(&s->p[k])) return packed;
    *slope = -1 / packed;
    double x = wf_param_internal(&s->p[k], s->p[k].start) - log(packed);
    return fmin(fmax(x, s->low[k]), s->high[k]);
}

/* A tree without an equilibrium, or a value out of range, is an answer for these parameters: the step is
 * rejected. Any other failure says nothing about them, so that a fit which went on without this prediction
 * would end elsewhere. */
static void note_fatal(struct wf_session *s, const struct wf_err *why)
{
    bool about_the_values = why->code == WF_EUNSTABLE || why->code == WF_ENOCONV || why->code == WF_EINPUT;
    if (!about_the_values) wf_fail(&s->fatal, why->code, "%s", why->text);
}

static bool model(void *ctx, const double *packed, double *residual, double *jacobian)
{
    struct wf_session *s = ctx;
    size_t m = s->x->data, row = m, column = 0, wide = 0;
    for (size_t k = 0; k < s->n; k++)
        if (!s->held[k]) s->internal[k] = internal_of(s, k, packed[wide], &s->chain[k]), wide++;
    if (s->fatal.code) return false;
    s->model = (struct wf_err){ 0 };
    if (wf_predict(s->predictor, s->internal, s->reading, jacobian ? s->slope : NULL, &s->model)) {
        note_fatal(s, &s->model);
        return false;
    }
    for (size_t i = 0; i < m; i++) {
        double w = sqrt(s->x->datum[i].weight) / s->sigma[i];
        residual[i] = w * (s->reading[i] - s->x->datum[i].value);
        column = 0;
        for (size_t k = 0; jacobian && k < s->n; k++)
            if (!s->held[k]) jacobian[i * wide + column++] = w * s->slope[i * s->n + k] * s->chain[k];
    }
    column = 0;
    for (size_t k = 0; k < s->n; k++) {
        bool prior = s->o->priors && s->p[k].prior_sd > 0;
        if (prior) {
            residual[row] = (s->internal[k] - s->p[k].prior_mean) / s->p[k].prior_sd;
            for (size_t c = 0; jacobian && c < wide; c++) jacobian[row * wide + c] = 0;
            if (jacobian && !s->held[k]) jacobian[row * wide + column] = s->chain[k] / s->p[k].prior_sd;
            row++;
        }
        column += !s->held[k];
    }
    return true;
}

static bool progress(void *ctx, size_t iteration, double cost)
{
    struct wf_session *s = ctx;
    wf_stage_step(0);
    s->stopped = s->stopped || (s->o->progress && s->o->progress(s->o->progress_ctx, iteration, cost));
    return s->stopped;
}

/* No parameter is free: compute the cost alone. */
static enum wf_status evaluate(struct wf_session *s, struct wf_lsq_result *out, struct wf_err *e)
{
    *out = (struct wf_lsq_result){ .converged = true };
    struct wf_err why = { 0 };
    if (wf_predict(s->predictor, s->internal, s->reading, NULL, &why)) {
        note_fatal(s, &why);
        return wf_fail(e, why.code, "%s", why.text);
    }
    for (size_t i = 0; i < s->x->data; i++) {
        double r = (s->reading[i] - s->x->datum[i].value) / s->sigma[i] * sqrt(s->x->datum[i].weight);
        out->cost += 0.5 * wf_losses[s->o->loss].rho(s->scale, r);
    }
    for (size_t k = 0; k < s->n; k++)
        if (s->o->priors && s->p[k].prior_sd > 0) {
            double r = (s->internal[k] - s->p[k].prior_mean) / s->p[k].prior_sd;
            out->cost += 0.5 * r * r;
        }
    out->stopped = progress(s, 0, out->cost);
    return WF_OK;
}

static enum wf_status search(struct wf_session *s, struct wf_lsq_result *out, struct wf_err *e)
{
    struct wf_lsq q = { .residuals = s->x->data + s->priors,
                        .low = s->free_low,
                        .high = s->free_high,
                        .model = model,
                        .progress = progress,
                        .ctx = s,
                        .loss = s->o->loss,
                        .loss_scale = s->scale,
                        .plain = s->priors };
    for (size_t k = 0; k < s->n; k++) {
        if (s->held[k]) continue;
        double low = packed_of(s, k, s->low[k]), high = packed_of(s, k, s->high[k]);
        s->start[q.params] = packed_of(s, k, s->internal[k]);
        s->free_low[q.params] = fmin(low, high), s->free_high[q.params++] = fmax(low, high);
    }
    if (!q.params) return evaluate(s, out, e);
    struct wf_err why = { 0 };
    enum wf_status status = wf_lsq_solve(&q, s->start, out, &why);
    if (status == WF_ENOMEM) wf_fail(&s->fatal, status, "%s", why.text);
    if (s->fatal.code) return wf_fail(e, s->fatal.code, "%s", s->fatal.text);
    if (status == WF_EINPUT && s->model.code)
        (void)wf_fail(e, status, "at the start values: %.900s", s->model.text);
    else if (status)
        (void)wf_fail(e, status, "%s", why.text);
    for (size_t k = 0, c = 0; k < s->n; k++)
        if (!s->held[k]) s->internal[k] = internal_of(s, k, s->start[c], &s->chain[k]), c++;
    return status;
}

/* How often parts of the trees were stiffened so far. */
static size_t stiffened(const struct wf_session *s)
{
    size_t n = 0;
    for (size_t k = 0; k < s->x->trees; k++)
        if (s->x->tree[k].props) n += s->x->tree[k].props->times;
    return n;
}

enum wf_status wf_session_solve(struct wf_session *s, struct wf_lsq_result *out, struct wf_err *e)
{
    enum { AGAIN = 8 };
    size_t before = stiffened(s);
    enum wf_status status = search(s, out, e);
    /* a part that was stiffened on the way made another tree: the least squares are those of one tree */
    for (int k = 0; k < AGAIN && !status && !out->stopped && stiffened(s) > before; k++) {
        before = stiffened(s);
        status = search(s, out, e);
    }
    return !status && s->fatal.code ? wf_fail(e, s->fatal.code, "%s", s->fatal.text) : status;
}

double wf_robust_sd(const double *x, size_t n, double *scratch)
{
    if (!n) return 0;
    for (size_t i = 0; i < n; i++) scratch[i] = fabs(x[i]);
    qsort(scratch, n, sizeof *scratch, wf_ascending);
    double middle = n % 2 ? scratch[n / 2] : 0.5 * (scratch[n / 2 - 1] + scratch[n / 2]);
    return 1.4826 * middle;
}
