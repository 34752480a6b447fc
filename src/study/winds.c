/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/winds.h"
#include "base/num.h"
#include "base/parallel.h"
#include <math.h>
#include <string.h>

/* Large trees are solved one at a time: answers do not depend on the number of threads. */
enum { SOLUTIONS_BYTES = 1 << 30 };

static size_t threads_for(const struct wf_analysis *an, const struct wf_solve_options *o)
{
    size_t threads = wf_parallel_threads(o->threads), most = SOLUTIONS_BYTES / WF_SOLUTION_BYTES / an->tree.n;
    return threads < most ? threads : most ? most : 1;
}

/* ---- The critical wind speeds, by criterion and part of the tree ---- */

struct search {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    enum wf_criterion_id criterion;
    enum wf_scope scope;
    struct wf_known *known;
};

static int recall(const struct search *q, double speed)
{
    const struct wf_known *k = q->known;
    for (int i = 0; i < k->n; i++)
        if (k->at[i].speed == speed && k->tolerance[i] == q->o->mesh_tolerance) return i;
    return -1;
}

static void keep(struct wf_known *k, double tolerance, bool used, const struct wf_at_speed *at)
{
    if (k->n == WF_KNOWN_MAX) return;
    k->tolerance[k->n] = tolerance;
    k->used[k->n] = used;
    k->at[k->n++] = *at;
}

static enum wf_status search_totals(const struct search *q, double speed, struct wf_at_speed *at,
                                    struct wf_err *e)
{
    int known = recall(q, speed);
    if (known >= 0) {
        q->known->used[known] = true;
        *at = q->known->at[known];
        return WF_OK;
    }
    enum wf_status s = wf_speed_totals(q->an, q->o, speed, at, e);
    if (!s) keep(q->known, q->o->mesh_tolerance, true, at);
    return s;
}

static double safety(const struct search *q, const struct wf_at_speed *at)
{
    return at->worst[q->criterion][q->scope].safety;
}

static bool falls(const struct search *q, const struct wf_at_speed *at)
{
    return at->status || !(safety(q, at) > 1.0);
}

/* Load over resistance at the worst section. */
static enum wf_status utilisation(void *ctx, double speed, double *value, struct wf_err *e)
{
    const struct search *s = ctx;
    struct wf_at_speed at;
    enum wf_status status = search_totals(s, speed, &at, e);
    if (status) return status;
    if (at.status) return wf_fail(e, at.status, "no equilibrium at %.6g m/s", speed);
    *value = 1.0 / safety(s, &at);
    return WF_OK;
}

/* Refine the critical speed found on a coarse mesh to the mesh tolerance of the options, by secant steps with
 * the coarse mesh's slope, which differs little. Returned: c->speed, and *at, the totals at it. */
static enum wf_status polish(const struct search *search, struct wf_critical *c, struct wf_at_speed *at,
                             struct wf_err *e)
{
    const double near = 3e-6; /* of the resistance */
    for (int k = 0;; k++) {
        enum wf_status s = search_totals(search, c->speed, at, e);
        c->evaluations++;
        if (s || at->status) return s;
        double excess = 1.0 / safety(search, at) - 1.0;
        double step = excess / c->gradient;
        if (fabs(excess) <= near || k == 4 || !(fabs(step) < 0.02 * c->speed)) return WF_OK;
        c->speed -= step;
    }
}

/* A batch of speeds solved in parallel. */
struct batch {
    const struct search *search;
    double speed[WF_CRITICAL_RUNGS_MAX + 1];
    struct wf_at_speed at[WF_CRITICAL_RUNGS_MAX + 1];
    bool kept[WF_CRITICAL_RUNGS_MAX + 1];
};

static enum wf_status rung(void *context, size_t k, struct wf_err *e)
{
    struct batch *b = context;
    b->kept[k] = !wf_speed_totals(b->search->an, b->search->o, b->speed[k], &b->at[k], e);
    return WF_OK;
}

/* Solve the speeds that wf_critical_search will step through, as many at a time as there are threads, until
 * the tree fails at one, and store the results. Errors are ignored: wf_critical_search solves that speed
 * again and reports them. */
static enum wf_status climb(const struct search *q, struct wf_err *e)
{
    struct wf_known *known = q->known;
    size_t threads = threads_for(q->an, q->o);
    struct wf_arena scratch = { 0 };
    struct batch *b = WF_TAKE(&scratch, 1, struct batch);
    if (!b) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    b->search = q;
    bool fell = threads < 2;
    const double speed_max = q->an->search.speed_max;
    for (int k = 0, rungs = wf_critical_rungs(speed_max); k <= rungs && !fell;) {
        size_t n = 0;
        for (; k <= rungs && n < threads; k++) {
            double speed = wf_critical_rung(speed_max, k);
            int at = recall(q, speed);
            if (at >= 0)
                fell = fell || falls(q, &known->at[at]);
            else
                b->speed[n++] = speed;
        }
        enum wf_status s = wf_parallel(n, threads, rung, b, e);
        if (s) {
            wf_arena_free(&scratch);
            return s;
        }
        for (size_t i = 0; i < n; i++) {
            fell = fell || !b->kept[i] || falls(q, &b->at[i]);
            if (b->kept[i]) keep(known, q->o->mesh_tolerance, false, &b->at[i]);
        }
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

static void place_at(const struct wf_tree *t, const struct wf_worst *w, struct wf_break *out)
{
    out->row = w->row;
    out->height = t->z0[w->row] + w->place * (t->z1[w->row] - t->z0[w->row]);
}

static enum wf_status find_break(struct search search, struct wf_break *out, struct wf_err *e)
{
    const struct wf_analysis *an = search.an;
    const struct wf_solve_options *o = search.o;
    struct wf_solve_options quick = *o;
    if (o->mesh_tolerance > 0.0) quick.mesh_tolerance = fmax(o->mesh_tolerance, 1e-4);
    search.o = &quick;
    struct wf_critical *c = &out->critical;
    struct wf_at_speed at;
    *out = (struct wf_break){ .at = { .speed = NAN }, .row = -1, .height = NAN };
    if (!wf_criterion_known(&wf_criteria[search.criterion], &an->tree, search.scope)) {
        *c = (struct wf_critical){ .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .gradient = NAN };
        return WF_OK;
    }
    enum wf_status s = climb(&search, e);
    if (!s) s = wf_critical_search(utilisation, &search, an->search.speed_max, 1e-4, c, e);
    if (s || (c->outcome != WF_CRITICAL_FOUND && c->outcome != WF_CRITICAL_SELF_WEIGHT)) return s;
    search.o = o;
    s = c->outcome == WF_CRITICAL_FOUND ? polish(&search, c, &at, e) : search_totals(&search, 0.0, &at, e);
    const struct wf_worst *worst = &at.worst[search.criterion][search.scope];
    if (s || at.status || worst->row < 0) return s;
    if (c->outcome == WF_CRITICAL_FOUND) out->at = at;
    place_at(&an->tree, worst, out);
    return WF_OK;
}

/* Result of the branches as far as it follows from that of the whole tree. */
static void branches(const struct wf_analysis *an, const struct wf_criterion *c, const struct wf_break *tree,
                     struct wf_break *out)
{
    bool known = wf_criterion_known(c, &an->tree, WF_SCOPE_BRANCHES);
    *out = *tree;
    if (known && (tree->row < 0 || an->tree.level[tree->row] > 0)) return;
    *out = (struct wf_break){ .at = { .speed = NAN }, .row = -1, .height = NAN };
    out->critical = (struct wf_critical){ .outcome = known ? WF_CRITICAL_UNSEARCHED : WF_CRITICAL_NO_STRENGTH,
                                          .speed = NAN,
                                          .gradient = NAN };
    if (!known) return;
    out->critical.speed_low = tree->critical.outcome == WF_CRITICAL_FOUND ? tree->critical.speed_low : 0.0;
    out->critical.speed_high = an->search.speed_max;
}

enum wf_status wf_known_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                               struct wf_known *known, struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (int c = 0; c < WF_CRITERIA && !s; c++) {
        struct search search = { an, o, (enum wf_criterion_id)c, WF_SCOPE_TREE, known };
        s = find_break(search, &out[c][WF_SCOPE_TREE], e);
        if (s) break;
        out[c][WF_SCOPE_STEM] = out[c][WF_SCOPE_TREE];
        branches(an, &wf_criteria[c], &out[c][WF_SCOPE_TREE], &out[c][WF_SCOPE_BRANCHES]);
        search.scope = WF_SCOPE_STEM;
        if (wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_BRANCHES))
            s = find_break(search, &out[c][WF_SCOPE_STEM], e);
    }
    return s;
}

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_known *known = WF_TAKE(&scratch, 1, struct wf_known);
    enum wf_status s = known
                           ? wf_known_breaks(an, o, known, out, e)
                           : wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    wf_arena_free(&scratch);
    return s;
}

/* ---- Curves ---- */

/* Points of the curves. */
struct sweep_points {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    struct wf_at_speed *at;
};

static enum wf_status sweep_point(void *context, size_t k, struct wf_err *e)
{
    const struct sweep_points *c = context;
    return wf_speed_totals(c->an, c->o, c->at[k].speed, &c->at[k], e);
}

/* Totals at speeds from 0 beyond the given and the critical speeds, at a round step; a quarter of it for the
 * first steps, where the deflection of a slender tree grows fastest. */
enum wf_status wf_known_curve(struct wf_analysis *an, const struct wf_solve_options *o,
                              struct wf_arena *a, struct wf_err *e)
{
    enum { QUARTERED = 5, STEPS = 40 };
    static const double steps[] = { 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0 };
    struct wf_solve_options curve = *o;
    double top = 1.0, step = 0.0;
    if (o->mesh_tolerance > 0.0) curve.mesh_tolerance = fmax(o->mesh_tolerance, 1e-4); /* finer than drawn */
    for (size_t k = 0; k < an->n; k++) top = fmax(top, an->at[k].speed);
    const struct wf_critical *first = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    if (first->outcome == WF_CRITICAL_FOUND) top = fmax(top, fmin(1.1 * first->speed, an->search.speed_max));
    for (size_t k = 0; k < WF_COUNT(steps); k++)
        if ((step = steps[k]) * STEPS >= top) break;
    an->sweep_n = (size_t)ceil(top / step - 1e-9) + 3 * QUARTERED + 1;
    if (!(an->sweep = WF_TAKE(a, an->sweep_n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a sweep of %zu speeds", an->sweep_n);
    for (size_t k = 0; k < an->sweep_n; k++)
        an->sweep[k].speed = step * (k < 4 * QUARTERED ? 0.25 * (double)k : (double)k - 3 * QUARTERED);
    struct sweep_points c = { an, &curve, an->sweep };
    return wf_parallel(an->sweep_n, threads_for(an, o), sweep_point, &c, e);
}
