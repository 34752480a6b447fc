/* Profile likelihood: one parameter held at a row of values, the others refitted at each. */
#include "fit/session.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 12 }; /* points on each side at most */

struct walk {
    struct wf_session *s;
    size_t k;
    double best; /* cost at the optimum                  */
    const double *optimum;
    double limit; /* rise at which the interval ends      */
    struct wf_profile_point *point;
    size_t n;
};

/* From the optimum outwards until the rise passes the limit or the bound is met. Returned: internal value
 * where it passes, NAN where it does not. */
static double side(struct walk *w, double step)
{
    struct wf_session *s = w->s;
    double x = w->optimum[w->k], root = 0, bound = step > 0 ? s->high[w->k] : s->low[w->k];
    memcpy(s->internal, w->optimum, s->n * sizeof *s->internal);
    for (int i = 0; i < SIDE; i++) {
        struct wf_lsq_result r;
        struct wf_err e = { 0 };
        double from = x;
        x += step;
        bool last = step > 0 ? x >= bound : x <= bound;
        if (last) x = bound;
        s->internal[w->k] = x;
        if (wf_session_solve(s, &r, &e) || r.stopped) return NAN;
        double rise = fmax(2 * (r.cost - w->best), 0), now = sqrt(rise), goal = sqrt(w->limit);
        w->point[w->n++] = (struct wf_profile_point){ wf_param_value(&s->p[w->k], x), rise };
        if (now >= goal) return now > root ? from + (x - from) * (goal - root) / (now - root) : x;
        /* the root of the rise is nearly straight: aim a little beyond the limit */
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
    double *optimum = WF_TAKE(a, s->n, double);
    struct wf_lsq_result here;
    if (!optimum) return wf_fail(e, WF_ENOMEM, "no room for the profiles");
    enum wf_status status = wf_session_solve(s, &here, e);
    if (status || here.stopped) return status;
    memcpy(optimum, s->internal, s->n * sizeof *optimum);
    for (size_t k = 0; k < out->free; k++) {
        struct wf_estimate *q = &out->estimate[k];
        struct walk w = {
            .s = s, .k = k, .best = here.cost, .optimum = optimum, .limit = out->quantile * out->quantile
        };
        if (!(w.point = WF_TAKE(a, 2 * SIDE + 1, struct wf_profile_point)))
            return wf_fail(e, WF_ENOMEM, "no room for the profiles");
        w.point[w.n++] = (struct wf_profile_point){ wf_param_value(&s->p[k], optimum[k]), 0 };
        double step = q->sd > 0 && q->sd < 0.5 ? q->sd : 0.5;
        s->held[k] = true;
        double low = q->at_low ? NAN : side(&w, -0.7 * step), high = q->at_high ? NAN : side(&w, 0.7 * step);
        s->held[k] = false;
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
