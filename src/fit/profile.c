/* Profile likelihood: one parameter held at a row of values, the others refitted at each. */
#include "fit/session.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 12, NARROW = 8 }; /* points on each side at most; and to narrow its end down */

struct walk {
    struct wf_session *s;
    size_t k;
    double best; /* cost at the optimum                  */
    const double *optimum;
    double *inside; /* parameters at the last point below the limit */
    double limit;   /* rise at which the interval ends      */
    struct wf_profile_point *point;
    size_t n;
};

/* Root of the rise with the parameter held at x, the others refitted from where they are; NAN where nothing
 * can be fitted. */
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

/* Where the root of the rise passes the goal between `in` and `out`: interpolated, after steps inwards while
 * the outer point is above it by more than a twentieth, because there the curve is not straight. w->inside:
 * the other parameters at `in`. */
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

/* From the optimum outwards until the rise passes the limit or the bound is met. Returned: internal value
 * where it passes, NAN where it does not. */
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
    double *optimum = WF_TAKE(a, s->n, double), *inside = WF_TAKE(a, s->n, double);
    struct wf_lsq_result here;
    if (!optimum || !inside) return wf_fail(e, WF_ENOMEM, "no room for the profiles");
    enum wf_status status = wf_session_solve(s, &here, e);
    if (status || here.stopped) return status;
    memcpy(optimum, s->internal, s->n * sizeof *optimum);
    for (size_t k = 0; k < out->free; k++) {
        struct wf_estimate *q = &out->estimate[k];
        struct walk w = { .s = s,
                          .k = k,
                          .best = here.cost,
                          .optimum = optimum,
                          .inside = inside,
                          .limit = out->quantile * out->quantile };
        if (!(w.point = WF_TAKE(a, 2 * (SIDE + NARROW) + 1, struct wf_profile_point)))
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
