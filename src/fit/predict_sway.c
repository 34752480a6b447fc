/* Natural frequencies and damping of free sway. */
#include "fit/predict_parts.h"
#include "solve/modes.h"
#include <math.h>
#include <string.h>

/* The tree with the parameters in place, in still air. */
static void stand(const struct wf_predictor *w, size_t tree, const double *internal, struct wf_loads *loads,
                  struct wf_solve_options *options)
{
    wf_param_apply(w->x, w->p, w->params, internal, tree, &w->tree[tree], loads, options);
    options->mesh_tolerance = 0;
}

/* The lowest mode that moves the tree's top within 45 degrees of an azimuth: its frequency and number. */
static enum wf_status frequency(struct wf_predictor *w, size_t index, const struct wf_fit_sensor *s,
                                const double *internal, struct wf_modes_kept *kept, size_t *number,
                                double *out, struct wf_err *e)
{
    enum { MODES = 4 };
    const struct wf_fit_test *t = &w->x->test[index];
    struct wf_tree *tree = &w->tree[t->tree];
    struct wf_loads loads;
    struct wf_solve_options options;
    double f[MODES];
    size_t count = isnan(s->azimuth) ? 1 : MODES, top = 0;
    stand(w, t->tree, internal, &loads, &options);
    double *shape = WF_TAKE(&w->scratch, count * 3 * tree->n, double);
    if (!shape) return wf_fail(e, WF_ENOMEM, "no room for the modes");
    enum wf_status status =
        wf_modes_keep(tree, &loads, &options, count, &w->scratch, f, count > 1 ? shape : NULL, kept, e);
    if (status) return status;
    for (size_t i = 0; i < tree->n; i++)
        if (!tree->level[i] && tree->z1[i] > tree->z1[top]) top = i;
    *number = 0;
    for (size_t k = count; k-- > 0 && count > 1;) {
        const double *v = shape + 3 * tree->n * k + 3 * top;
        double along = v[0] * cos(s->azimuth) + v[1] * sin(s->azimuth);
        if (2 * along * along >= v[0] * v[0] + v[1] * v[1] && f[k] > 0) *number = k;
    }
    *out = f[*number];
    if (!(*out > 0)) return wf_fail(e, WF_EUNSTABLE, "the tree does not stand under its own weight");
    return WF_OK;
}

/* Change of the frequency with each internal value: Rayleigh's quotient of the mode held, on either side. Its
 * equilibrium is found anew, so the weight's part is in it. */
static enum wf_status by_parameter(struct wf_predictor *w, size_t tree, const double *internal,
                                   const struct wf_modes_kept *kept, size_t number, double *row,
                                   struct wf_err *e)
{
    const double step = 1e-4;
    struct wf_loads loads;
    struct wf_solve_options options;
    double *x = WF_TAKE(&w->scratch, w->params, double), side[2];
    if (!x) return wf_fail(e, WF_ENOMEM, "no room for a prediction");
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

/* An earlier datum that is the same frequency of the same tree; `at` when there is none. */
static size_t earlier(const struct wf_experiment *x, size_t at, double azimuth)
{
    const struct wf_fit_datum *d = x->datum;
    for (size_t i = 0; i < at; i++) {
        const struct wf_fit_test *t = &x->test[d[i].test];
        const struct wf_fit_sensor *s = &t->sensor[d[i].sensor];
        bool mode = s->azimuth == azimuth || (isnan(s->azimuth) && isnan(azimuth));
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

enum wf_status wf_sway_test(struct wf_predictor *w, size_t index, const double *internal, double *reading,
                            double *slope, size_t *at, struct wf_err *e)
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
        size_t same = earlier(w->x, *at, s->azimuth), number = 0;
        if (same < *at) {
            reading[*at] = reading[same];
            if (row) memcpy(row, slope + same * w->params, w->params * sizeof *row);
            continue;
        }
        struct wf_modes_kept kept;
        status = frequency(w, index, s, internal, row ? &kept : NULL, &number, &reading[*at], e);
        if (!status && row) status = by_parameter(w, t->tree, internal, &kept, number, row, e);
    }
    return status;
}
