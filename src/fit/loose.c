/* Which combinations of parameters the data leave open, in words. */
#include "base/quiet.h"
#include "fit/session.h"
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdio.h>

/* A combination is loose beyond this standard deviation of a logarithm: a factor of e either way within 95 %.
 */
static const double loose_sd = 0.5;

/* "level0.youngs_modulus rises while root.stiffness falls": all that share a fifth of the direction. */
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

/* A single parameter that is no estimate: on its bound, or without an end to its profile. */
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
    if (!f->loose || !v) return wf_fail(e, WF_ENOMEM, "no room for the verdict");
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
    return ok || !n ? WF_OK : wf_fail(e, WF_ENOMEM, "no room for the verdict");
}
