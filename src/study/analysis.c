#include "study/analysis.h"
#include "grow/grow.h"
#include "solve/unload.h"
#include "study/limits.h"
#include "study/scenario.h"
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

/* Answers at speeds already asked for: two searches go up the same ladder. */
enum { KNOWN_MAX = 200 };
struct known {
    int n;
    double tolerance[KNOWN_MAX]; /* of the mesh */
    struct wf_at_speed at[KNOWN_MAX];
};

struct search {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    bool stem; /* the stem alone */
    struct known *known;
};

static enum wf_status totals(const struct search *q, double speed, struct wf_at_speed *at, struct wf_err *e)
{
    struct known *k = q->known;
    for (int i = 0; i < k->n; i++)
        if (k->at[i].speed == speed && k->tolerance[i] == q->o->mesh_tolerance) {
            *at = k->at[i];
            return WF_OK;
        }
    enum wf_status s = wf_speed_totals(q->an, q->o, speed, at, e);
    if (s || k->n == KNOWN_MAX) return s;
    k->tolerance[k->n] = q->o->mesh_tolerance;
    k->at[k->n++] = *at;
    return WF_OK;
}

/* Stress over strength at the worst section. */
static enum wf_status utilisation(void *ctx, double speed, double *value, struct wf_err *e)
{
    const struct search *s = ctx;
    struct wf_at_speed at;
    enum wf_status status = totals(s, speed, &at, e);
    if (status) return status;
    if (at.status) return wf_fail(e, at.status, "no equilibrium at %.6g m/s", speed);
    *value = 1.0 / (s->stem ? at.breakage.stem_safety : at.breakage.least_safety);
    return WF_OK;
}

/* The speed found on a quick mesh, brought to the asked one by secants on its slope, which hardly differ;
 * *at: totals there. */
static enum wf_status polish(const struct search *search, struct wf_critical *c, struct wf_at_speed *at,
                             struct wf_err *e)
{
    const double near = 3e-6; /* of the strength */
    for (int k = 0;; k++) {
        enum wf_status s = totals(search, c->speed, at, e);
        c->evaluations++;
        if (s || at->status) return s;
        double excess = 1.0 / (search->stem ? at->breakage.stem_safety : at->breakage.least_safety) - 1.0;
        double step = excess / c->gradient;
        if (fabs(excess) <= near || k == 4 || !(fabs(step) < 0.02 * c->speed)) return WF_OK;
        c->speed -= step;
    }
}

/* Has any row a strength, on the stem (level 0) or on the branches? */
static bool strong(const struct wf_tree *t, bool stem)
{
    for (size_t i = 0; i < t->n; i++)
        if (t->strength[i] > 0.0 && (t->level[i] == 0) == stem) return true;
    return false;
}

static enum wf_status find_break(const struct wf_analysis *an, const struct wf_solve_options *o, bool stem,
                                 struct known *known, struct wf_break *out, struct wf_err *e)
{
    struct wf_solve_options quick = *o;
    if (o->mesh_tolerance > 0.0) quick.mesh_tolerance = fmax(o->mesh_tolerance, 1e-4);
    struct search search = { an, &quick, stem, known };
    struct wf_critical *c = &out->critical;
    struct wf_at_speed at;
    *out = (struct wf_break){ .at = { .speed = NAN }, .row = -1, .height = NAN };
    if (!strong(&an->tree, true) && (stem || !strong(&an->tree, false))) {
        *c = (struct wf_critical){ .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .gradient = NAN };
        return WF_OK;
    }
    enum wf_status s = wf_critical_search(utilisation, &search, an->scenario.speed_max, 1e-4, c, e);
    if (s || (c->outcome != WF_CRITICAL_FOUND && c->outcome != WF_CRITICAL_SELF_WEIGHT)) return s;
    search.o = o;
    s = c->outcome == WF_CRITICAL_FOUND ? polish(&search, c, &at, e) : totals(&search, 0.0, &at, e);
    int32_t row = stem ? at.breakage.stem_governing : at.breakage.governing;
    double place = stem ? at.breakage.stem_governing_s : at.breakage.governing_s;
    if (s || at.status || row < 0) return s;
    if (c->outcome == WF_CRITICAL_FOUND) out->at = at;
    out->row = row;
    out->height = an->tree.z0[row] + place * (an->tree.z1[row] - an->tree.z0[row]);
    return WF_OK;
}

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_break *first, struct wf_break *stem, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct known *known = WF_TAKE(&scratch, 1, struct known);
    if (!known) return wf_fail(e, WF_ENOMEM, "no room for the search of the critical speed");
    enum wf_status s = find_break(an, o, false, known, first, e);
    *stem = *first;
    if (!s && strong(&an->tree, false)) s = find_break(an, o, true, known, stem, e);
    wf_arena_free(&scratch);
    return s;
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
    if (an->breaks.critical.outcome == WF_CRITICAL_FOUND)
        top = fmax(top, fmin(1.1 * an->breaks.critical.speed, an->scenario.speed_max));
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++)
        if ((step = steps[k]) * STEPS >= top) break;
    an->sweep_n = (size_t)ceil(top / step - 1e-9) + 3 * QUARTERED + 1;
    if (!(an->sweep = WF_TAKE(a, an->sweep_n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "no room for a sweep of %zu speeds", an->sweep_n);
    for (size_t k = 0; k < an->sweep_n; k++) {
        double steps_up = k < 4 * QUARTERED ? 0.25 * (double)k : (double)k - 3 * QUARTERED;
        enum wf_status s = wf_speed_totals(an, &curve, step * steps_up, &an->sweep[k], e);
        if (s) return s;
    }
    return WF_OK;
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
    if ((s = wf_analysis_breaks(out, o, &out->breaks, &out->stem, e))) return s;
    if ((s = sweep(out, o, a, e))) return s;
    wf_limits_check(out, d);
    return WF_OK;
}
