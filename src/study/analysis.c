/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/analysis.h"
#include "base/num.h"
#include "base/parallel.h"
#include "grow/grow.h"
#include "load/scene.h"
#include "solve/unload.h"
#include "study/limits.h"
#include "study/speed.h"
#include <math.h>

static enum wf_status check_call(const struct wf_scenario *sc, const double *speeds, size_t n,
                                 struct wf_err *e)
{
    if (n == 0) return wf_fail(e, WF_EUSAGE, "no wind speed is given");
    for (size_t k = 0; k < n; k++)
        if (!(speeds[k] >= 0.0 && speeds[k] <= 200.0))
            return wf_fail(e, WF_EUSAGE, "wind speed %.6g m/s is outside 0..200 m/s", speeds[k]);
    return wf_scenario_check(sc, e);
}

/* The stress-free shape of a tree drawn or measured as it stands under its own weight. */
static enum wf_status unload(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_solve_options o;
    struct wf_loads weight = an->loads;
    struct wf_tree free;
    double left, moved;
    weight.wind = NULL;
    wf_solve_options_default(&o);
    enum wf_status s = wf_unload(&an->tree, &weight, &o, a, &free, &left, &moved, e);
    if (s) return s;
    an->tree = free;
    wf_diag_warn(
        d, "unloaded",
        "%s, %s: taken as standing under its own weight. Its stress-free shape is up to %.3g m away; under "
        "its weight it comes back to the shape given within %.2g m. Deflections count from the stress-free "
        "shape",
        an->model->name, an->species->name, moved, left);
    return WF_OK;
}

enum wf_status wf_analysis_set_up(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e)
{
    enum wf_status s = wf_grow(an->model, an->species, a, &an->tree, d, e);
    if (s || (s = wf_tree_check(&an->tree, d, e))) return s;
    an->tallness = wf_tree_height(&an->tree);
    s = wf_scenario_loads(&an->scenario, an->species, &an->wind, &an->loads, e);
    return !s && an->model->shape == WF_SHAPE_UNDER_WEIGHT ? unload(an, a, d, e) : s;
}

bool wf_analysis_grown(const struct wf_analysis *an, size_t level)
{
    for (size_t i = 0; i < an->tree.n; i++)
        if (wf_model_wood(an->model, an->species, &an->tree, i) == &an->species->level[level]) return true;
    return false;
}

/* Points of the curves. */
struct curve {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    struct wf_at_speed *at;
};

static enum wf_status point(void *context, size_t k, struct wf_err *e)
{
    const struct curve *c = context;
    return wf_speed_totals(c->an, c->o, c->at[k].speed, &c->at[k], e);
}

/* Speeds from 0 past the asked and the critical ones, at a step a reader can name; a quarter of it for the
 * first steps, where a slender tree bends fastest. */
static enum wf_status sweep(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                            struct wf_err *e)
{
    enum { QUARTERED = 5, STEPS = 40 };
    static const double steps[] = { 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0 };
    struct wf_solve_options curve = *o;
    double top = 1.0, step = 0.0;
    if (o->mesh_tolerance > 0.0) curve.mesh_tolerance = fmax(o->mesh_tolerance, 1e-4); /* no line is finer */
    for (size_t k = 0; k < an->n; k++) top = fmax(top, an->at[k].speed);
    const struct wf_critical *first = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    if (first->outcome == WF_CRITICAL_FOUND)
        top = fmax(top, fmin(1.1 * first->speed, an->scenario.speed_max));
    for (size_t k = 0; k < WF_COUNT(steps); k++)
        if ((step = steps[k]) * STEPS >= top) break;
    an->sweep_n = (size_t)ceil(top / step - 1e-9) + 3 * QUARTERED + 1;
    if (!(an->sweep = WF_TAKE(a, an->sweep_n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "no room for a sweep of %zu speeds", an->sweep_n);
    for (size_t k = 0; k < an->sweep_n; k++)
        an->sweep[k].speed = step * (k < 4 * QUARTERED ? 0.25 * (double)k : (double)k - 3 * QUARTERED);
    struct curve c = { an, &curve, an->sweep };
    return wf_together(an->sweep_n, o->threads, point, &c, e);
}

enum wf_status wf_analyze(const struct wf_species *sp, const struct wf_model *m, const struct wf_scenario *sc,
                          const struct wf_solver *solver, const struct wf_solve_options *o,
                          const double *speeds, size_t n, struct wf_arena *a, struct wf_diag *d,
                          struct wf_analysis *out, struct wf_err *e)
{
    enum wf_status s = check_call(sc, speeds, n, e);
    if (s) return s;
    *out = (struct wf_analysis){
        .species = sp, .model = m, .solver = solver, .scenario = *sc, .n = n, .diag = d
    };
    if ((s = wf_analysis_set_up(out, a, d, e))) return s;
    if (!(out->at = WF_TAKE(a, n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "no room for %zu speeds", n);
    for (size_t k = 0; k < n; k++)
        if ((s = wf_speed_solve(out, o, speeds[k], a, d, &out->at[k], e))) return s;
    if ((s = wf_analysis_breaks(out, o, out->breaks, e))) return s;
    if ((s = sweep(out, o, a, e))) return s;
    wf_limits_check(out, d);
    return WF_OK;
}
