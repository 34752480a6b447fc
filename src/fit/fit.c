/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/fit.h"
#include "fit/free_sway.h"
#include "fit/plant.h"
#include <math.h>
#include <string.h>

static bool fit_at_bound(const struct wf_fit *f);

void wf_fit_options_default(struct wf_fit_options *o)
{
    *o = (struct wf_fit_options){
        .loss = WF_LOSS_NONE, .loss_scale = NAN, .profile = true, .starts = 1, .seed = 1
    };
}

/* Scale of the loss that has 95 % efficiency for normal errors. */
static double usual_scale(const struct wf_fit_options *o)
{
    return isnan(o->loss_scale) ? wf_losses[o->loss].usual_scale : o->loss_scale;
}

static enum wf_status room(struct wf_fit *f, struct wf_arena *a, struct wf_err *e)
{
    size_t n = f->params, m = f->x->data;
    f->internal = WF_TAKE(a, n, double), f->estimate = WF_TAKE(a, n, struct wf_estimate);
    f->covariance = WF_TAKE(a, n * n, double), f->correlation = WF_TAKE(a, n * n, double);
    f->reading = WF_TAKE(a, m, double), f->slope = WF_TAKE(a, m * n, double),
    f->sigma = WF_TAKE(a, m, double);
    f->residual = WF_TAKE(a, m, double), f->band = WF_TAKE(a, m, double);
    f->influence = WF_TAKE(a, m, double), f->influenced = WF_TAKE(a, m, size_t);
    bool ok = f->internal && f->estimate && f->covariance && f->correlation && f->reading && f->slope &&
              f->sigma && f->residual && f->band && f->influence && f->influenced;
    return ok ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the answers of a fit");
}

/* Check the number of parameters, their bounds and start values. */
static enum wf_status check(const struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                            struct wf_err *e)
{
    if (!n) return wf_fail(e, WF_EUSAGE, "nothing is free: name parameters with --free or in the study");
    if (x->data < n) {
        size_t nuisance = 0;
        for (size_t k = 0; k < n; k++) nuisance += wf_param_nuisance(&p[k]);
        return wf_fail(e, WF_EUSAGE, "%zu reading%s cannot determine %zu parameter%s%s", x->data,
                       x->data == 1 ? "" : "s", n, n == 1 ? "" : "s",
                       nuisance ? " (offsets and drifts of sensors included)" : "");
    }
    for (size_t k = 0; k < n; k++)
        if (!(p[k].low < p[k].high))
            return wf_fail(e, WF_EUSAGE, "%s: its lower bound is not below its upper bound", p[k].name);
    for (size_t k = 0; k < n; k++)
        if (!(p[k].start >= p[k].low && p[k].start <= p[k].high)) {
            double factor;
            const char *unit = wf_param_unit(x, &p[k], &factor);
            return wf_fail(e, WF_EUSAGE, "%s starts at %.6g %s, outside its bounds %.6g to %.6g %s",
                           p[k].name, p[k].start * factor, unit, p[k].low * factor, p[k].high * factor, unit);
        }
    return WF_OK;
}

/* Start values of sigmas to be estimated: 2 % of the largest reading of the sensor. */
static void first_sigmas(struct wf_experiment *x)
{
    for (size_t t = 0; t < x->tests; t++)
        for (size_t s = 0; s < x->test[t].sensors; s++) {
            double most = 0;
            if (!x->test[t].sensor[s].estimated) continue;
            for (size_t i = 0; i < x->data; i++)
                if (x->datum[i].test == t && x->datum[i].sensor == s)
                    most = fmax(most, fabs(x->datum[i].value));
            for (size_t i = 0; i < x->data; i++)
                if (x->datum[i].test == t && x->datum[i].sensor == s)
                    x->datum[i].sigma = most > 0 ? 0.02 * most : 1;
        }
}

/* Refuse a parameter on which no reading depends: the data cannot determine it. */
static enum wf_status moves(struct wf_session *s, struct wf_err *e)
{
    enum wf_status status = wf_predict(s->predictor, s->internal, s->reading, s->slope, e);
    for (size_t k = 0; !status && k < s->n; k++) {
        double most = 0;
        for (size_t i = 0; i < s->x->data; i++) most = fmax(most, fabs(s->slope[i * s->n + k]) / s->sigma[i]);
        bool prior = s->o->priors && s->p[k].prior_sd > 0;
        if (!(most > 1e-12) && !prior)
            return wf_fail(e, WF_EINPUT, "no reading depends on %s; take it out of the free parameters",
                           s->p[k].name);
    }
    return status;
}

/* How far the readings still pull the estimates, in standard deviations: the linear step to the least
 * squares. Returned: also the parameter that it moves most. */
static double pull_left(const struct wf_fit *f, size_t *which)
{
    double sum = 0, most = 0;
    *which = 0;
    for (size_t k = 0; k < f->params; k++) {
        double step = 0, own = 0;
        for (size_t j = 0; j < f->params; j++) {
            double pull = 0;
            for (size_t i = 0; i < f->x->data; i++)
                pull += f->slope[i * f->params + j] / f->sigma[i] * f->residual[i];
            step += f->covariance[k * f->params + j] * pull;
            if (j == k) own = pull;
        }
        sum += own * step;
        double far = fabs(step) / f->estimate[k].sd;
        if (far > most) most = far, *which = k; /* not where sd is 0 or NAN: on a bound */
    }
    return sqrt(fmax(sum, 0));
}

/* A fit that ended on a step of the answers is not one. Robust losses and priors pull too and are left out.
 */
static void warn_of_pull(const struct wf_fit *f, const struct wf_fit_options *o, struct wf_diag *d)
{
    size_t which;
    if (o->loss != WF_LOSS_NONE || o->priors || f->lsq.stopped || !(pull_left(f, &which) > 0.5)) return;
    wf_diag_warn(
        d, "not-converged",
        "the fit ended where it is not the best: the readings still pull %s by %.2g standard deviations "
        "or more, but the answers jump there, because another mode sways the tree or a part of it would "
        "no longer stand. The estimates are not to be used; other starts, or a tree without the parts in "
        "doubt, may lead further",
        f->param[which].name, pull_left(f, &which));
}

static void warn(const struct wf_fit *f, struct wf_diag *d)
{
    for (size_t k = 0; k < f->x->trees; k++) wf_fit_tree_warn(&f->x->tree[k], d);
    for (size_t k = 0; k < f->free; k++) {
        const struct wf_estimate *q = &f->estimate[k];
        if (q->at_low || q->at_high)
            wf_diag_warn(d, "at-bound",
                         "%s ended on its %s bound: this is no estimate; the best fit lies beyond the bound",
                         f->param[k].name, q->at_low ? "lower" : "upper");
    }
    if (fit_at_bound(f) && f->free > 1)
        wf_diag_warn(
            d, "conditional",
            "the other parameters and their intervals by covariance hold only for the one at its bound");
    for (size_t i = 0; i < f->loose_n; i++)
        if (!f->loose[i].bound)
            wf_diag_warn(d, "not-determined", "the data do not determine %s", f->loose[i].text);
    if (!f->sigma_estimated && f->freedom && f->reduced > 2)
        wf_diag_warn(
            d, "misfit",
            "reduced chi-square %.3g: the readings scatter %.2g times as much as their stated uncertainties; "
            "intervals are widened by that factor",
            f->reduced, sqrt(f->reduced));
    for (size_t i = 0; i < f->groups; i++)
        if (f->group[i].correlation > 0.5)
            wf_diag_warn(
                d, "trend",
                "%s: neighbouring residuals are correlated (%.2f): a trend the model does not follow; "
                "intervals are widened by %.3g",
                f->x->test[f->group[i].test].sensor[f->group[i].sensor].name, f->group[i].correlation,
                f->group[i].inflation);
    if (f->lsq.stopped)
        wf_diag_warn(d, "stopped",
                     "the fit was interrupted: the best parameters so far are given, without profiles");
    else if (f->stopped)
        wf_diag_warn(d, "stopped", "interrupted after the fit itself: profiles or bootstrap are incomplete");
    if (!f->freedom)
        wf_diag_warn(
            d, "nothing-left",
            "as many parameters as readings: no degrees of freedom remain, so the fit cannot test the model");
    if (!f->lsq.stopped && !f->lsq.converged)
        wf_diag_warn(d, "not-converged", "the fit did not converge: %s", f->lsq.message);
    if (f->starts > 1 && f->starts_same < f->starts)
        wf_diag_warn(d, "several-minima", "only %zu of %zu starting points led to the best fit",
                     f->starts_same, f->starts);
}

/* Is a parameter other than a nuisance parameter on a bound? */
static bool fit_at_bound(const struct wf_fit *f)
{
    bool any = false;
    for (size_t k = 0; k < f->free; k++) any |= f->estimate[k].at_low || f->estimate[k].at_high;
    return any;
}

double wf_fit_aicc(const struct wf_fit *f, const struct wf_fit *like)
{
    double m = (double)f->x->data, alone = 0, k = (double)f->params + 1, sum = 0;
    for (size_t i = 0; i < f->x->data; i++) {
        double r = (f->x->datum[i].value - f->reading[i]) / like->sigma[i];
        sum += r * r;
    }
    for (size_t i = 0; i < like->groups; i++)
        alone += (double)like->group[i].n / (like->group[i].inflation * like->group[i].inflation);
    return alone > k + 1 ? alone * log(sum / m) + 2 * k + 2 * k * (k + 1) / (alone - k - 1) : (double)NAN;
}

enum wf_status wf_fit_run(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                          const struct wf_fit_options *o, struct wf_arena *a, struct wf_diag *d,
                          struct wf_fit *out, struct wf_err *e)
{
    struct wf_session s = { 0 };
    *out = (struct wf_fit){ .x = x, .param = p, .params = n, .aicc = NAN };
    for (size_t k = 0; k < n; k++) out->free += !wf_param_nuisance(&p[k]);
    enum wf_status status = check(x, p, n, e);
    if (status || (status = room(out, a, e))) return status;
    first_sigmas(x);
    status = wf_session_open(x, p, n, o, a, &s, e);
    s.scale = usual_scale(o);
    if (!status) status = moves(&s, e);
    if (!status) status = wf_fit_spread(&s, out, a, e);
    if (!status && !out->lsq.stopped && o->starts > 1) status = wf_fit_restart(&s, out, a, e);
    if (!status) status = wf_fit_covariance(&s, out, a, e);
    if (!status) wf_free_sway_warn(s.predictor, d);
    if (!status) memcpy(out->internal, s.internal, n * sizeof *out->internal);
    if (!status && !out->lsq.stopped && o->profile) status = wf_fit_profiles(&s, out, a, e);
    if (!status && !out->lsq.stopped && o->resamples) status = wf_fit_resample(&s, out, a, e);
    if (!status) status = wf_fit_loose(out, a, e);
    if (!status && s.fatal.code) status = wf_fail(e, s.fatal.code, "%s", s.fatal.text);
    wf_session_close(&s);
    out->stopped = s.stopped;
    if (!status) out->aicc = wf_fit_aicc(out, out);
    if (!status) warn(out, d);
    if (!status) warn_of_pull(out, o, d);
    return status;
}
