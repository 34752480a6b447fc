/* Covariance, bands and influence from the weighted slopes at the optimum. */
#include "base/quiet.h"
#include "fit/session.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_linalg.h>
#include <math.h>

/* Smallest singular value over the largest that still counts as information. */
static const double blind = 1e-9;

/* C = V diag(1/s^2) V' of the rows x n matrix W (destroyed); values too small to count are taken at the
 * limit, so what they leave open shows as an enormous variance. */
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

/* Huber's sandwich: bread from the slopes of psi (from psi/r where they do not suffice), filling from psi^2.
 */
static enum wf_status sandwich(const struct wf_session *s, const bool *at_bound, const size_t *of, size_t n,
                               gsl_matrix *W, double *w, double *C, struct wf_arena *a, struct wf_err *e)
{
    double *fill = WF_TAKE(a, n * n, double), *half = WF_TAKE(a, n * n, double),
           *bread = WF_TAKE(a, n * n, double);
    if (!fill || !half || !bread) return wf_fail(e, WF_ENOMEM, "no room for the covariance");
    size_t rows = s->x->data + s->priors;
    for (size_t i = 0; i < rows; i++) {
        double psi = 1, slope = 1;
        weighted(s, i, at_bound, w);
        if (i < s->x->data) {
            double r = (s->x->datum[i].value - s->reading[i]) / s->sigma[i];
            wf_loss_slopes(s->o->loss, s->scale, r, &psi, &slope);
            /* the smaller of both keeps the bread positive where a loss turns down again */
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
    if (rows < n) return wf_fail(e, WF_EINPUT, "%zu readings cannot fix %zu parameters", rows, n);
    gsl_matrix *W = gsl_matrix_calloc(rows, n);
    if (!W) return wf_fail(e, WF_ENOMEM, "no room for the covariance");
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
        wf_loss_slopes(s->o->loss, s->scale, r, &psi, &slope);
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
    if (!at_bound || !of || !C || !w) return wf_fail(e, WF_ENOMEM, "no room for the covariance");
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
