#include "cases/fit.h"
#include "cases/measure.h"
#include "fit/build.h"
#include "fit/fit.h"
#include "fit/predict.h"
#include <math.h>
#include <string.h>

struct trial {
    const struct wf_case *of;
    const char *share; /* folder of the shipped species and models */
    struct wf_fit_study study;
    struct wf_experiment x;
    struct wf_fit_param *param;
    size_t params;
    double *value, *covered; /* per parameter: last estimate, intervals that held the truth */
    double *truth;           /* NULL: the data are measured                                 */
};

static enum wf_status build(struct trial *t, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_case *c = t->of;
    const char *slash = *c->fit_study == '/' ? NULL : strrchr(c->file, '/');
    const char *path =
        wf_arena_print(a, "%.*s%s", slash ? (int)(slash + 1 - c->file) : 0, c->file, c->fit_study);
    struct wf_diag d = { .arena = a };
    struct wf_fit_build b = { .study = &t->study, .share = t->share, .plan = !isnan(c->data_sets) };
    if (!path) return wf_fail(e, WF_ENOMEM, "no memory");
    enum wf_status s = wf_fit_study_read(path, a, &t->study, &d, e);
    struct wf_fit_input *in = s ? NULL : WF_TAKE(a, t->study.tests, struct wf_fit_input);
    if (!s && !in) s = wf_fail(e, WF_ENOMEM, "no memory");
    if (!s) s = wf_fit_build(&b, a, &d, &t->x, in, e);
    if (!s) s = wf_fit_params(&t->study, c->fit_free, &t->x, b.plan, a, &t->param, &t->params, e);
    if (s) return s;
    t->value = WF_TAKE(a, t->params, double), t->covered = WF_TAKE(a, t->params, double);
    return t->value && t->covered ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
}

static enum wf_status fit(struct trial *t, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_diag d = { .arena = &work };
    struct wf_fit_options o;
    struct wf_fit f;
    wf_fit_options_default(&o);
    o.profile = false;
    enum wf_status s = wf_fit_run(&t->x, t->param, t->params, &o, &work, &d, &f, e);
    for (size_t k = 0; !s && k < t->params; k++) {
        const struct wf_estimate *q = &f.estimate[k];
        t->value[k] = q->at_low || q->at_high ? (double)NAN : q->value;
        t->covered[k] += t->truth && q->low <= t->truth[k] && t->truth[k] <= q->high;
    }
    wf_arena_free(&work);
    return s;
}

/* The parameters' start values are the truth; a fit of made-up data starts a fifth away from it. */
static enum wf_status made_up(struct trial *t, struct wf_arena *a, struct wf_err *e)
{
    const double away = 1.2;
    double *reading = WF_TAKE(a, t->x.data, double), *truth = t->truth = WF_TAKE(a, t->params, double);
    if (!reading || !truth) return wf_fail(e, WF_ENOMEM, "no memory");
    enum wf_status s = wf_fit_expect(&t->x, t->param, t->params, a, reading, NULL, e);
    for (size_t k = 0; k < t->params; k++) truth[k] = t->param[k].start;
    for (uint64_t seed = 1; !s && seed <= (uint64_t)t->of->data_sets; seed++) {
        wf_fit_make_up(&t->x, reading, seed, isnan(t->of->noise) ? 1 : t->of->noise);
        struct wf_fit_param *p = t->param;
        for (size_t k = 0; k < t->params; k++) p[k].start = fmin(fmax(truth[k] * away, p[k].low), p[k].high);
        s = fit(t, e);
        for (size_t k = 0; k < t->params; k++) p[k].start = truth[k];
    }
    return s;
}

static enum wf_status answer(void *ctx, const struct wf_want *w, double out[3], struct wf_err *e)
{
    struct trial *t = ctx;
    bool count = !strcmp(w->quantity->name, "intervals_that_cover");
    for (size_t k = 0; k < t->params; k++)
        if (!strcmp(t->param[k].name, w->name)) {
            out[0] = count ? t->covered[k] : t->value[k];
            return WF_OK;
        }
    return wf_fail(e, WF_EINPUT, "%s:%zu: the study fits no parameter '%s'", t->of->file, w->line, w->name);
}

enum wf_status wf_case_fit(const struct wf_case *c, const char *share, struct wf_arena *a,
                           struct wf_verdict *v, struct wf_err *e)
{
    struct trial t = { .of = c, .share = share };
    struct wf_err own = { WF_OK, "" };
    enum wf_status s = build(&t, a, &own);
    if (!s) s = isnan(c->data_sets) ? fit(&t, &own) : made_up(&t, a, &own);
    if (!s) return wf_case_hold(c, "fit", answer, &t, a, v, e);
    *v = (struct wf_verdict){ .of = c, .solver = "fit", .why = wf_arena_text(a, own.text) };
    v->outcome = s == WF_EMISSING ? WF_SKIPPED : WF_FAILED;
    return v->why ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
}
