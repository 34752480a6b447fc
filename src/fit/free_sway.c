/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/free_sway.h"
#include "base/num.h"
#include "solve/modes.h"
#include <math.h>
#include <string.h>

/* Apply the parameters to the tree, in still air. */
static void stand(const struct wf_predictor *w, size_t tree, const double *internal, struct wf_loads *loads,
                  struct wf_solve_options *options)
{
    wf_param_apply(w->x, w->p, w->params, internal, tree, &w->tree[tree], loads, options);
    options->mesh_tolerance = 0;
}

static bool branched(const struct wf_tree *t)
{
    for (size_t i = 0; i < t->n; i++)
        if (t->level[i]) return true;
    return false;
}

/* Share of the overturning by inertia that a mode carries, along the azimuth where there is one. */
static double share_of(const struct wf_fit_sensor *s, const double turn[2])
{
    double along = turn[0] * cos(s->azimuth) + turn[1] * sin(s->azimuth);
    return isnan(s->azimuth) ? 0.5 * (turn[0] * turn[0] + turn[1] * turn[1]) : along * along;
}

static const double much = 0.5; /* of the largest share; a rule of this program */

/* The lowest mode that carries much of the overturning, and the next but those that near it in frequency,
 * which are the same sway in another direction. */
static size_t swaying(const struct wf_fit_sensor *s, const double *f, size_t count, const double *turn,
                      struct wf_sway_found *found)
{
    const double near = 0.1;
    double most = 0;
    size_t best = 0;
    *found = (struct wf_sway_found){ .share = 0 };
    for (size_t k = 0; k < count; k++)
        if (f[k] > 0) most = fmax(most, share_of(s, turn + 2 * k));
    while (best + 1 < count && !(f[best] > 0 && share_of(s, turn + 2 * best) >= much * most)) best++;
    found->share = share_of(s, turn + 2 * best), found->frequency = f[best];
    for (size_t k = 0; k < count; k++)
        if (f[k] > 0 && fabs(f[k] / f[best] - 1) > near && share_of(s, turn + 2 * k) > found->other_share)
            found->other_share = share_of(s, turn + 2 * k), found->other = f[k];
    return best;
}

/* The lowest mode that moves the stem's top within 45 degrees of the azimuth. */
static size_t lowest_along(const struct wf_fit_sensor *s, const struct wf_tree *t, const double *f,
                           size_t count, const double *shape)
{
    size_t number = 0, top = 0;
    for (size_t i = 0; i < t->n; i++)
        if (!t->level[i] && t->z1[i] > t->z1[top]) top = i;
    for (size_t k = count; k-- > 0;) {
        const double *v = shape + 3 * t->n * k + 3 * top;
        double along = v[0] * cos(s->azimuth) + v[1] * sin(s->azimuth);
        if (2 * along * along >= v[0] * v[0] + v[1] * v[1] && f[k] > 0) number = k;
    }
    return number;
}

/* The sensor's mode: its frequency and number. */
static enum wf_status frequency(struct wf_predictor *w, size_t index, const struct wf_fit_sensor *s,
                                const double *internal, struct wf_modes_kept *kept, size_t *number,
                                double *out, struct wf_err *e)
{
    enum { MODES = 6 };
    const struct wf_fit_test *t = &w->x->test[index];
    struct wf_tree *tree = &w->tree[t->tree];
    struct wf_loads loads;
    struct wf_solve_options options;
    double f[MODES], *shape = NULL;
    bool first = isnan(s->azimuth) && (s->lowest || !branched(tree)), along = !isnan(s->azimuth) && s->lowest;
    size_t count = first ? 1 : MODES;
    stand(w, t->tree, internal, &loads, &options);
    if (along && !(shape = WF_TAKE(&w->scratch, count * 3 * tree->n, double)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the modes");
    enum wf_status status = wf_modes_keep(tree, &loads, &options, count, &w->scratch, f, shape, kept, e);
    if (status) return status;
    *number = first   ? 0
              : along ? lowest_along(s, tree, f, count, shape)
                      : swaying(s, f, count, kept->turn, &w->sway[index]);
    *out = f[0] > 0 ? f[*number] : f[0];
    if (!(*out > 0)) return wf_fail(e, WF_EUNSTABLE, "the tree has no equilibrium under its own weight");
    return WF_OK;
}

/* Derivative of the frequency by each internal value: central difference of Rayleigh quotients with the mode
 * shape fixed. The equilibrium is solved again, so the effect of weight is included. */
static enum wf_status by_parameter(struct wf_predictor *w, size_t tree, const double *internal,
                                   const struct wf_modes_kept *kept, size_t number, double *row,
                                   struct wf_err *e)
{
    const double step = 1e-4;
    struct wf_loads loads;
    struct wf_solve_options options;
    double *x = WF_TAKE(&w->scratch, w->params, double), side[2];
    if (!x) return wf_fail(e, WF_ENOMEM, "not enough memory for a prediction");
    memcpy(x, internal, w->params * sizeof *x);
    for (size_t p = 0; p < w->params; p++) {
        row[p] = 0;
        if (!wf_disturbs(&w->p[p], tree)) continue;
        for (int k = 0; k < 2; k++) {
            x[p] = internal[p] + (k ? step : -step);
            stand(w, tree, x, &loads, &options);
            enum wf_status status =
                wf_modes_held(&w->tree[tree], &loads, &options, kept, number, &side[k], e);
            if (status) return status;
        }
        x[p] = internal[p];
        row[p] = (side[1] - side[0]) / (2 * step);
    }
    return WF_OK;
}

/* Index of an earlier datum of the same frequency of the same tree; `at` when there is none. */
static size_t earlier(const struct wf_experiment *x, size_t at, double azimuth, bool lowest)
{
    const struct wf_fit_datum *d = x->datum;
    for (size_t i = 0; i < at; i++) {
        const struct wf_fit_test *t = &x->test[d[i].test];
        const struct wf_fit_sensor *s = &t->sensor[d[i].sensor];
        bool mode = s->lowest == lowest && (s->azimuth == azimuth || (isnan(s->azimuth) && isnan(azimuth)));
        if (s->kind == WF_SENSOR_FREQUENCY && mode && t->tree == x->test[d[at].test].tree) return i;
    }
    return at;
}

static void damping(const struct wf_predictor *w, size_t tree, const double *internal, double *reading,
                    double *row)
{
    *reading = 0;
    for (size_t p = 0; p < w->params; p++) {
        bool acts = w->p[p].quantity == WF_FIT_DAMPING && (w->p[p].tree < 0 || (size_t)w->p[p].tree == tree);
        if (acts) *reading = exp(internal[p]);
        if (row) row[p] = acts ? *reading : 0;
    }
}

enum wf_status wf_free_sway_test(struct wf_predictor *w, size_t index, const double *internal,
                                 double *reading, double *slope, size_t *at, struct wf_err *e)
{
    const struct wf_fit_test *t = &w->x->test[index];
    enum wf_status status = WF_OK;
    for (; !status && *at < w->x->data && w->x->datum[*at].test == index; ++*at) {
        const struct wf_fit_sensor *s = &t->sensor[w->x->datum[*at].sensor];
        double *row = slope ? slope + *at * w->params : NULL;
        if (s->kind == WF_SENSOR_DAMPING) {
            damping(w, t->tree, internal, &reading[*at], row);
            continue;
        }
        size_t same = earlier(w->x, *at, s->azimuth, s->lowest), number = 0;
        if (same < *at) {
            reading[*at] = reading[same];
            if (row) memcpy(row, slope + same * w->params, w->params * sizeof *row);
            continue;
        }
        struct wf_modes_kept kept;
        status = frequency(w, index, s, internal, &kept, &number, &reading[*at], e);
        if (!status && row) status = by_parameter(w, t->tree, internal, &kept, number, row, e);
    }
    return status;
}

void wf_free_sway_warn(const struct wf_predictor *w, struct wf_diag *d)
{
    for (size_t k = 0; k < w->x->tests; k++) {
        const struct wf_sway_found *q = &w->sway[k];
        if (!(q->other_share > much * q->share)) continue;
        wf_diag_warn(
            d, "several-modes",
            "test %s: the mode taken, of %.4g Hz, carries %.0f %% of the overturning by inertia, another "
            "of %.4g Hz %.0f %%: a heavy branch sways by itself, and the record may be of either. "
            "'mode: lowest' takes the lowest mode",
            w->x->test[k].name, q->frequency, 100 * q->share, q->other, 100 * q->other_share);
    }
}
