#include "fit/plan.h"
#include "base/random.h"
#include "fit/predict.h"
#include <math.h>

enum { NOISE = 43 }; /* stream of random numbers */

enum wf_status wf_fit_expect(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                             struct wf_arena *a, double *reading, double *slope, struct wf_err *e)
{
    struct wf_predictor *w = NULL;
    double *at = WF_TAKE(a, n, double);
    if (!at) return wf_fail(e, WF_ENOMEM, "no room for the plan");
    for (size_t k = 0; k < n; k++) at[k] = wf_param_internal(&p[k], p[k].start);
    enum wf_status s = wf_predictor_open(x, p, n, a, &w, e);
    if (!s) s = wf_predict(w, at, reading, slope, e);
    if (w) wf_predictor_close(w);
    for (size_t i = 0; i < x->data && !s; i++) {
        struct wf_fit_datum *q = &x->datum[i];
        const struct wf_fit_sensor *sensor = &x->test[q->test].sensor[q->sensor];
        if (sensor->estimated)
            return wf_fail(e, WF_EINPUT, "test %s: sensor %s: a plan needs its 'sigma' or 'sigma_share'",
                           x->test[q->test].name, sensor->name);
        q->sigma =
            fmax(hypot(sensor->sigma, sensor->sigma_share * reading[i]), 1e-12 * fabs(reading[i]) + 1e-300);
    }
    return s;
}

void wf_fit_make_up(struct wf_experiment *x, const double *reading, uint64_t seed, double noise)
{
    for (size_t i = 0; i < x->data; i++) {
        struct wf_fit_datum *q = &x->datum[i];
        q->value =
            reading[i] +
            noise * q->sigma * wf_random_normal(seed, wf_random_stream(NOISE, q->test, q->sensor), q->state);
    }
}
