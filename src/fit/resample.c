/* Other starts and other data: several minima, and intervals by the bootstrap (Efron 1979). */
#include "base/random.h"
#include "fit/session.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { START = 41, SAMPLE = 42 }; /* streams of random numbers */

enum wf_status wf_fit_restart(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e)
{
    double *best = WF_TAKE(a, s->n, double);
    struct wf_lsq_result r;
    if (!best) return wf_fail(e, WF_ENOMEM, "no room for more starts");
    enum wf_status status = wf_session_solve(s, &r, e);
    if (status || r.stopped) return status;
    memcpy(best, s->internal, s->n * sizeof *best);
    double least = r.cost, first = r.cost;
    out->starts = out->starts_same = 1;
    for (size_t i = 1; i < s->o->starts; i++) {
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
    /* another minimum has residuals, and sigmas, of its own */
    return least < first * (1 - 1e-6) ? wf_fit_spread(s, out, a, e) : wf_session_solve(s, &out->lsq, e);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(const double *x, size_t n, double p)
{
    double at = p * (double)(n - 1);
    size_t i = (size_t)at;
    return i + 1 < n ? x[i] + (at - (double)i) * (x[i + 1] - x[i]) : x[n - 1];
}

enum { OWN = 8 }; /* sensors with fewer readings are drawn from together */

/* Draw as many readings of every sensor as it has, with replacement: how often each was drawn is its weight.
 */
static void draw(struct wf_session *s, const struct wf_fit *out, size_t *pool, uint64_t sample)
{
    for (size_t i = 0; i < s->x->data; i++) s->x->datum[i].weight = 0;
    for (size_t g = 0; g <= out->groups; g++) { /* the last: all small sensors */
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

enum wf_status wf_fit_resample(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e)
{
    size_t most = s->o->resamples;
    double *value = WF_TAKE(a, out->free * most, double), *optimum = WF_TAKE(a, s->n, double);
    size_t *pool = WF_TAKE(a, s->x->data, size_t);
    if (!value || !optimum || !pool) return wf_fail(e, WF_ENOMEM, "no room for %zu data sets", most);
    memcpy(optimum, s->internal, s->n * sizeof *optimum);
    for (size_t b = 0; b < most; b++) {
        struct wf_lsq_result r;
        struct wf_err why = { 0 };
        draw(s, out, pool, b);
        memcpy(s->internal, optimum, s->n * sizeof *optimum);
        if (wf_session_solve(s, &r, &why)) continue;
        if (r.stopped) break;
        for (size_t k = 0; k < out->free; k++)
            value[k * most + out->resampled] = wf_param_value(&s->p[k], s->internal[k]);
        out->resampled++;
    }
    for (size_t i = 0; i < s->x->data; i++) s->x->datum[i].weight = 1;
    memcpy(s->internal, optimum, s->n * sizeof *optimum);
    for (size_t k = 0; k < out->free && out->resampled >= 20; k++) {
        qsort(value + k * most, out->resampled, sizeof *value, ascending);
        out->estimate[k].resampled_low = quantile(value + k * most, out->resampled, 0.025);
        out->estimate[k].resampled_high = quantile(value + k * most, out->resampled, 0.975);
    }
    return WF_OK;
}
