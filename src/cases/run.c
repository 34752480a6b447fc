/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases/run.h"
#include "cases/measure.h"
#include "fit/build.h"
#include "fit/fit.h"
#include "fit/predict.h"
#include "solve/modes.h"
#include <math.h>
#include <string.h>

/* Solver results compared with the wanted values. */

static bool wanted_by(const struct wf_case *c, enum wf_answer by, size_t *modes)
{
    const struct wf_want *w = c->wants.data;
    bool any = false;
    for (size_t i = 0; i < c->wants.n; i++) {
        any |= w[i].quantity->by == by;
        if (modes && w[i].quantity->by == by && w[i].number > *modes) *modes = w[i].number;
    }
    return any;
}

static enum wf_status compute_answers(struct wf_measured *m, const struct wf_setup *s, struct wf_err *e)
{
    if (m->solver) {
        struct wf_response *r = WF_TAKE(m->arena, 1, struct wf_response);
        if (!r) return wf_fail(e, WF_ENOMEM, "no memory");
        if (wf_setup_solve(s, m->solver, m->arena, r, e)) return e->code;
        m->response = r;
    }
    if (wanted_by(m->of, WF_BY_MODES, &m->modes)) {
        double *f = WF_TAKE(m->arena, m->modes, double);
        if (!f) return wf_fail(e, WF_ENOMEM, "no memory");
        if (wf_modes(&s->tree, &s->loads, &s->options, m->modes, m->arena, f, NULL, e)) return e->code;
        m->frequency = f;
    }
    if (wanted_by(m->of, WF_BY_BUCKLING, NULL))
        return wf_buckling(&s->tree, &s->loads, &s->options, m->arena, &m->buckling_factor, e);
    return WF_OK;
}

/* The size that a relative tolerance of a want refers to: the wanted value, or the norm of the wanted
 * vector. */
static double want_scale(const struct wf_want *w)
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++)
        if (!isnan(w->value[k])) sum += w->value[k] * w->value[k];
    return sqrt(sum);
}

static void check_component(struct wf_verdict *v, const struct wf_want *w, int component, double got,
                            double wanted)
{
    struct wf_check *c = &v->check[v->n++];
    double scale = want_scale(w);
    *c = (struct wf_check){ .want = w, .component = component, .got = got, .wanted = wanted };
    c->error = fabs(got - wanted);
    c->allowed = w->absolute ? w->tolerance : w->tolerance * scale;
    c->relative = scale > 0.0 ? c->error / scale : NAN;
    c->passed = c->error <= c->allowed; /* false for NaN */
    if (!c->passed) v->failed++;
    double use = isnan(c->error) ? HUGE_VAL : c->error / c->allowed;
    if (use > v->worst) v->worst = use;
}

/* The value of one want [SI]. */
typedef enum wf_status want_answer(void *ctx, const struct wf_want *w, double out[3], struct wf_err *e);

static enum wf_status compare_wants(const struct wf_case *c, want_answer *answer, void *ctx,
                                    struct wf_verdict *v, struct wf_err *e)
{
    const struct wf_want *w = c->wants.data;
    for (size_t i = 0; i < c->wants.n; i++) {
        double got[3] = { NAN, NAN, NAN };
        if (answer(ctx, &w[i], got, e)) return e->code;
        if (!w[i].quantity->vector || w[i].component >= 0) {
            double one = !w[i].quantity->vector ? got[0]
                         : w[i].component == 3  ? sqrt(got[0] * got[0] + got[1] * got[1] + got[2] * got[2])
                                                : got[w[i].component];
            check_component(v, &w[i], w[i].component, one, w[i].value[0]);
        } else {
            for (int k = 0; k < 3; k++)
                if (!isnan(w[i].value[k])) check_component(v, &w[i], k, got[k], w[i].value[k]);
        }
    }
    return WF_OK;
}

/* Verdict from a run's status and message and from its comparisons. WF_ENOMEM is an error of the program,
 * not of the case. */
static enum wf_status conclude_run(struct wf_verdict *v, enum wf_status status, const struct wf_err *own,
                                   struct wf_arena *a, struct wf_err *e)
{
    if (status == WF_ENOMEM) return wf_fail(e, status, "%s", own->text);
    v->outcome = status == WF_EMISSING ? WF_SKIPPED : status || v->failed ? WF_FAILED : WF_PASSED;
    if (status && !(v->why = wf_arena_text(a, own->text))) return wf_fail(e, WF_ENOMEM, "no memory");
    return WF_OK;
}

static enum wf_status hold_wants(const struct wf_case *c, const char *solver, want_answer *answer, void *ctx,
                                 struct wf_arena *a, struct wf_verdict *v, struct wf_err *e)
{
    struct wf_err own = { WF_OK, "" };
    *v = (struct wf_verdict){ .of = c, .solver = solver };
    if (!(v->check = WF_TAKE(a, 3 * c->wants.n, struct wf_check))) return wf_fail(e, WF_ENOMEM, "no memory");
    enum wf_status status = compare_wants(c, answer, ctx, v, &own);
    return conclude_run(v, status, &own, a, e);
}

static enum wf_status measured_answer(void *ctx, const struct wf_want *w, double out[3], struct wf_err *e)
{
    return w->quantity->measure(ctx, w, out, e);
}

static enum wf_status attempt_run(const struct wf_case *c, size_t k, size_t pieces, double mesh_tolerance,
                                  struct wf_arena *a, struct wf_verdict *v, struct wf_err *e)
{
    struct wf_setup *s = WF_TAKE(a, 1, struct wf_setup);
    struct wf_measured m = {
        .of = c, .setup = s, .arena = a, .solver = k < c->solvers ? c->solver[k] : NULL
    };
    struct wf_err own = { WF_OK, "" };
    *v = (struct wf_verdict){ .of = c, .solver = m.solver ? m.solver->name : "modes" };
    if (!m.solver && wanted_by(c, WF_BY_BUCKLING, NULL)) v->solver = "buckling";
    if (!m.solver && wanted_by(c, WF_BY_SETUP, NULL)) v->solver = "section";
    if (!m.solver && c->shape == WF_SHAPE_FLOW) v->solver = "flow";
    if (c->shape == WF_SHAPE_GUST) v->solver = "gust";
    if (!m.solver && wanted_by(c, WF_BY_STAND, NULL)) v->solver = "stand";
    v->check = WF_TAKE(a, 3 * c->wants.n, struct wf_check);
    if (!s || !v->check) return wf_fail(e, WF_ENOMEM, "no memory");
    bool flow = c->shape == WF_SHAPE_FLOW || c->shape == WF_SHAPE_GUST; /* no tree, loads or mesh */
    enum wf_status status = WF_OK;
    if (c->shape == WF_SHAPE_FIT)
        status = wf_fail(&own, WF_EUSAGE, "a case with a fit is run by wf_case_fit");
    else if (!flow)
        status = wf_setup_build(c, pieces, a, s, &own);
    if (!status && !isnan(mesh_tolerance)) s->options.mesh_tolerance = mesh_tolerance;
    if (!status && !flow) status = compute_answers(&m, s, &own);
    if (!status) status = compare_wants(c, measured_answer, &m, v, &own);
    return conclude_run(v, status, &own, a, e);
}

enum wf_status wf_case_run(const struct wf_case *c, size_t k, size_t pieces, struct wf_arena *a,
                           struct wf_verdict *v, struct wf_err *e)
{
    return attempt_run(c, k, pieces, NAN, a, v, e);
}

enum wf_status wf_case_order(const struct wf_case *c, size_t k, struct wf_arena *a,
                             struct wf_verdict *verdicts, struct wf_err *e)
{
    for (size_t i = 0; i < c->pieces; i++)
        if (attempt_run(c, k, c->piece[i], 0.0, a, &verdicts[i], e)) return e->code;
    return WF_OK;
}

/* Cases that are calibrations. */

struct trial {
    const struct wf_case *of;
    const char *share; /* folder of the shipped species and models */
    wf_import_reader *mat;
    struct wf_calibration calibration;
    struct wf_experiment x;
    struct wf_fit_param *param;
    size_t params;
    double *value,
        *covered;  /* per parameter: last estimate; number of intervals that contained the true value */
    double *truth; /* NULL: measured data */
};

static enum wf_status build_trial(struct trial *t, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_case *c = t->of;
    const char *slash = *c->fit_calibration == '/' ? NULL : strrchr(c->file, '/');
    const char *path =
        wf_arena_print(a, "%.*s%s", slash ? (int)(slash + 1 - c->file) : 0, c->file, c->fit_calibration);
    struct wf_diag d = { .arena = a };
    struct wf_fit_build b = {
        .calibration = &t->calibration, .share = t->share, .plan = !isnan(c->data_sets), .mat = t->mat
    };
    if (!path) return wf_fail(e, WF_ENOMEM, "no memory");
    enum wf_status s = wf_calibration_read(path, a, &t->calibration, &d, e);
    struct wf_fit_input *in = s ? NULL : WF_TAKE(a, t->calibration.tests, struct wf_fit_input);
    if (!s && !in) s = wf_fail(e, WF_ENOMEM, "no memory");
    if (!s) s = wf_fit_build(&b, a, &d, &t->x, in, e);
    if (!s) s = wf_fit_params(&t->calibration, c->fit_free, &t->x, b.plan, a, &t->param, &t->params, e);
    if (s) return s;
    t->value = WF_TAKE(a, t->params, double), t->covered = WF_TAKE(a, t->params, double);
    return t->value && t->covered ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
}

static enum wf_status fit_trial(struct trial *t, struct wf_err *e)
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

/* Fits to synthetic data. The parameters' start values are taken as true values; every fit starts 20 % away
 * from them. */
static enum wf_status fit_made_up(struct trial *t, struct wf_arena *a, struct wf_err *e)
{
    const double away = 1.2;
    double *reading = WF_TAKE(a, t->x.data, double), *truth = t->truth = WF_TAKE(a, t->params, double);
    if (!reading || !truth) return wf_fail(e, WF_ENOMEM, "no memory");
    struct wf_diag unsaid = { .arena = a };
    enum wf_status s = wf_fit_expect(&t->x, t->param, t->params, a, reading, NULL, &unsaid, e);
    for (size_t k = 0; k < t->params; k++) truth[k] = t->param[k].start;
    for (uint64_t seed = 1; !s && seed <= (uint64_t)t->of->data_sets; seed++) {
        wf_fit_make_up(&t->x, reading, seed, isnan(t->of->noise) ? 1 : t->of->noise);
        struct wf_fit_param *p = t->param;
        for (size_t k = 0; k < t->params; k++) p[k].start = fmin(fmax(truth[k] * away, p[k].low), p[k].high);
        s = fit_trial(t, e);
        for (size_t k = 0; k < t->params; k++) p[k].start = truth[k];
    }
    return s;
}

static enum wf_status fitted_answer(void *ctx, const struct wf_want *w, double out[3], struct wf_err *e)
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

enum wf_status wf_case_fit(const struct wf_case *c, const char *share, wf_import_reader *mat,
                           struct wf_arena *a, struct wf_verdict *v, struct wf_err *e)
{
    struct trial t = { .of = c, .share = share, .mat = mat };
    struct wf_err own = { WF_OK, "" };
    enum wf_status s = build_trial(&t, a, &own);
    if (!s) s = isnan(c->data_sets) ? fit_trial(&t, &own) : fit_made_up(&t, a, &own);
    if (!s) return hold_wants(c, "fit", fitted_answer, &t, a, v, e);
    *v = (struct wf_verdict){ .of = c, .solver = "fit", .why = wf_arena_text(a, own.text) };
    v->outcome = s == WF_EMISSING ? WF_SKIPPED : WF_FAILED;
    return v->why ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
}
