/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The searches of an analysis: critical wind speeds, by criterion and part of the tree, and the curves;
 * declared in analysis.h. */
#include "base/interrupt.h"
#include "base/num.h"
#include "base/parallel.h"
#include "data/species.h"
#include "study/analysis.h"
#include <math.h>
#include <time.h>

/* Large trees are solved one at a time: answers do not depend on the number of threads. */
enum { SOLUTIONS_BYTES = 1 << 30 };

static size_t threads_for(const struct wf_analysis *an, const struct wf_solve_options *o)
{
    size_t threads = wf_parallel_threads(o->threads), most = SOLUTIONS_BYTES / WF_SOLUTION_BYTES / an->tree.n;
    return threads < most ? threads : most ? most : 1;
}

/* ---- The critical wind speeds, by criterion and part of the tree ---- */

/* Results at speeds already solved: all searches use the same speeds at first. */
enum { KNOWN_MAX = 200 };
struct known {
    double deadline; /* of the process's time [s] */
    bool over;       /* the deadline ended a search */
    int n;
    double tolerance[KNOWN_MAX]; /* of the mesh */
    struct wf_at_speed at[KNOWN_MAX];
};

struct search {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    enum wf_criterion_id criterion;
    enum wf_scope scope;
    struct known *known;
    double speed_max; /* [m/s] */
};

static double processor_seconds(void)
{
    struct timespec t;
    return clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t) ? 0.0 : (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static const struct wf_at_speed *recall(const struct search *q, double speed)
{
    const struct known *k = q->known;
    for (int i = 0; i < k->n; i++)
        if (k->at[i].speed == speed && k->tolerance[i] == q->o->mesh_tolerance) return &k->at[i];
    return NULL;
}

static void keep(struct known *k, double tolerance, const struct wf_at_speed *at)
{
    if (k->n == KNOWN_MAX) return;
    k->tolerance[k->n] = tolerance;
    k->at[k->n++] = *at;
}

static enum wf_status search_totals(const struct search *q, double speed, struct wf_at_speed *at,
                                    struct wf_err *e)
{
    const struct wf_at_speed *known = recall(q, speed);
    if (known) *at = *known;
    if (known) return WF_OK;
    if (wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted");
    q->known->over = q->known->over || processor_seconds() > q->known->deadline;
    /* any status that is no answer about the tree ends the search; find_break then looks at `over` */
    if (q->known->over) return wf_fail(e, WF_EINTERNAL, "the time of the search is used up");
    enum wf_status s = wf_speed_totals(q->an, q->o, speed, at, e);
    if (!s) keep(q->known, q->o->mesh_tolerance, at);
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
    double speed[WF_CRITICAL_RUNGS + 1];
    struct wf_at_speed at[WF_CRITICAL_RUNGS + 1];
    bool kept[WF_CRITICAL_RUNGS + 1];
};

static enum wf_status rung(void *context, size_t k, struct wf_err *e)
{
    struct batch *b = context;
    b->kept[k] = false;
    if (processor_seconds() > b->search->known->deadline) return WF_OK;
    b->kept[k] = !wf_speed_totals(b->search->an, b->search->o, b->speed[k], &b->at[k], e);
    return WF_OK;
}

/* Solve the speeds that wf_critical_search will step through, as many at a time as there are threads, until
 * the tree fails at one, and store the results. Errors are ignored: wf_critical_search solves that speed
 * again and reports them. */
static enum wf_status climb(const struct search *q, struct wf_err *e)
{
    struct known *known = q->known;
    size_t threads = threads_for(q->an, q->o);
    struct wf_arena scratch = { 0 };
    struct batch *b = WF_TAKE(&scratch, 1, struct batch);
    if (!b) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    b->search = q;
    bool fell = threads < 2;
    for (int k = 0; k <= WF_CRITICAL_RUNGS && !fell;) {
        size_t n = 0;
        for (; k <= WF_CRITICAL_RUNGS && n < threads; k++) {
            double speed = wf_critical_rung(q->speed_max, k);
            const struct wf_at_speed *at = recall(q, speed);
            if (at)
                fell = fell || falls(q, at);
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
            if (b->kept[i]) keep(known, q->o->mesh_tolerance, &b->at[i]);
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

/* The highest speed to be searched: the range given, or the lowest given speed above it at which this part of
 * the tree failed. */
static double search_top(const struct search *q)
{
    double top = INFINITY;
    for (size_t k = 0; q->an->at && k < q->an->n; k++) {
        const struct wf_at_speed *at = &q->an->at[k];
        if (at->speed <= q->an->search.speed_max && falls(q, at)) return q->an->search.speed_max;
        if (falls(q, at)) top = fmin(top, at->speed);
    }
    return isfinite(top) ? top : q->an->search.speed_max;
}

/* What is known of a search that was ended: between which speeds the tree fails. */
static void bracket(const struct search *q, struct wf_critical *c)
{
    *c = (struct wf_critical){ WF_CRITICAL_UNSEARCHED, NAN, 0.0, q->speed_max, NAN, 0 };
    for (int i = 0; i < q->known->n; i++)
        if (falls(q, &q->known->at[i])) c->speed_high = fmin(c->speed_high, q->known->at[i].speed);
    for (int i = 0; i < q->known->n; i++) {
        double speed = q->known->at[i].speed;
        if (speed < c->speed_high && !falls(q, &q->known->at[i])) c->speed_low = fmax(c->speed_low, speed);
    }
}

/* The search itself, and the result at its end. */
static enum wf_status search_break(struct search *search, const struct wf_solve_options *quick,
                                   const struct wf_solve_options *fine, struct wf_break *out,
                                   struct wf_err *e)
{
    struct wf_critical *c = &out->critical;
    struct wf_at_speed at;
    search->o = quick;
    enum wf_status s = climb(search, e);
    if (!s) s = wf_critical_search(utilisation, search, search->speed_max, 1e-4, c, e);
    if (s || (c->outcome != WF_CRITICAL_FOUND && c->outcome != WF_CRITICAL_SELF_WEIGHT)) return s;
    search->o = fine;
    s = c->outcome == WF_CRITICAL_FOUND ? polish(search, c, &at, e) : search_totals(search, 0.0, &at, e);
    const struct wf_worst *worst = &at.worst[search->criterion][search->scope];
    if (s || at.status || worst->row < 0) return s;
    if (c->outcome == WF_CRITICAL_FOUND) out->at = at;
    place_at(&search->an->tree, worst, out);
    return WF_OK;
}

static enum wf_status find_break(struct search search, struct wf_break *out, struct wf_err *e)
{
    const struct wf_solve_options *fine = search.o;
    struct wf_solve_options quick = *fine;
    struct wf_err why = { 0 };
    if (fine->mesh_tolerance > 0.0) quick.mesh_tolerance = fmax(fine->mesh_tolerance, 1e-4);
    const struct wf_break nothing = { .at = { .speed = NAN }, .row = -1, .height = NAN };
    *out = nothing;
    if (!wf_criterion_known(&wf_criteria[search.criterion], &search.an->tree, search.scope)) {
        out->critical =
            (struct wf_critical){ .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .gradient = NAN };
        return WF_OK;
    }
    search.speed_max = search_top(&search);
    enum wf_status s = search_break(&search, &quick, fine, out, &why);
    if (!s) return WF_OK;
    if (!search.known->over) return wf_fail(e, s, "%s", why.text);
    *out = nothing;
    bracket(&search, &out->critical);
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

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct known *known = WF_TAKE(&scratch, 1, struct known);
    enum wf_status s = WF_OK;
    if (!known) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    known->deadline = processor_seconds() + an->search.seconds;
    for (int c = 0; c < WF_CRITERIA && !s; c++) {
        struct search search = { an, o, (enum wf_criterion_id)c, WF_SCOPE_TREE, known, NAN };
        s = find_break(search, &out[c][WF_SCOPE_TREE], e);
        if (s) break;
        out[c][WF_SCOPE_STEM] = out[c][WF_SCOPE_TREE];
        branches(an, &wf_criteria[c], &out[c][WF_SCOPE_TREE], &out[c][WF_SCOPE_BRANCHES]);
        search.scope = WF_SCOPE_STEM;
        if (wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_BRANCHES))
            s = find_break(search, &out[c][WF_SCOPE_STEM], e);
    }
    wf_arena_free(&scratch);
    return s;
}

/* ---- The curves ---- */

/* Points of the curves. */
struct sweep_points {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    struct wf_at_speed *at;
    double deadline; /* of the process's time [s] */
    bool *skipped;   /* the deadline came before this point */
};

static enum wf_status sweep_point(void *context, size_t k, struct wf_err *e)
{
    const struct sweep_points *c = context;
    c->skipped[k] = processor_seconds() > c->deadline;
    if (c->skipped[k]) return WF_OK;
    return wf_speed_totals(c->an, c->o, c->at[k].speed, &c->at[k], e);
}

/* Totals at speeds from 0 beyond the given and the critical speeds, at a round step; a quarter of it for the
 * first steps, where the deflection of a slender tree grows fastest. */
enum wf_status wf_analysis_sweep(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                                 struct wf_diag *d, struct wf_err *e)
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
    struct sweep_points c = { an, &curve, an->sweep, processor_seconds() + an->search.seconds,
                              WF_TAKE(a, an->sweep_n, bool) };
    if (!c.skipped) return wf_fail(e, WF_ENOMEM, "not enough memory for a sweep of %zu speeds", an->sweep_n);
    if (an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome == WF_CRITICAL_UNSEARCHED) c.deadline = 0.0;
    enum wf_status s = wf_parallel(an->sweep_n, threads_for(an, o), sweep_point, &c, e);
    bool whole = true;
    for (size_t k = 0; k < an->sweep_n; k++) whole = whole && !c.skipped[k];
    if (s || whole) return s;
    an->sweep_n = an->n, an->sweep = an->at; /* no more than the speeds given */
    wf_diag_warn(d, "search-ended",
                 "%s: the time for the curves (%.4g s) is used up: curves join the given wind speeds alone",
                 an->species->name, an->search.seconds);
    return WF_OK;
}

void wf_search_default(struct wf_search *s) { *s = (struct wf_search){ 100.0, INFINITY, NULL, NULL }; }
