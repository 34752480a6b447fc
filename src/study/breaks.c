/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The critical wind speeds, by criterion and part of the tree. */
#include "base/parallel.h"
#include "study/analysis.h"
#include "study/speed.h"
#include <math.h>

/* Answers at speeds already asked for: all searches go up the same ladder. */
enum { KNOWN_MAX = 200 };
struct known {
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
};

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

static enum wf_status totals(const struct search *q, double speed, struct wf_at_speed *at, struct wf_err *e)
{
    const struct wf_at_speed *known = recall(q, speed);
    if (known) *at = *known;
    if (known) return WF_OK;
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

/* Load over resistance at the worst place. */
static enum wf_status utilisation(void *ctx, double speed, double *value, struct wf_err *e)
{
    const struct search *s = ctx;
    struct wf_at_speed at;
    enum wf_status status = totals(s, speed, &at, e);
    if (status) return status;
    if (at.status) return wf_fail(e, at.status, "no equilibrium at %.6g m/s", speed);
    *value = 1.0 / safety(s, &at);
    return WF_OK;
}

/* The speed found on a quick mesh, brought to the asked one by secants on its slope, which hardly differ;
 * *at: totals there. */
static enum wf_status polish(const struct search *search, struct wf_critical *c, struct wf_at_speed *at,
                             struct wf_err *e)
{
    const double near = 3e-6; /* of the resistance */
    for (int k = 0;; k++) {
        enum wf_status s = totals(search, c->speed, at, e);
        c->evaluations++;
        if (s || at->status) return s;
        double excess = 1.0 / safety(search, at) - 1.0;
        double step = excess / c->gradient;
        if (fabs(excess) <= near || k == 4 || !(fabs(step) < 0.02 * c->speed)) return WF_OK;
        c->speed -= step;
    }
}

/* A batch of rungs at once. */
struct batch {
    const struct search *search;
    double speed[WF_CRITICAL_RUNGS + 1];
    struct wf_at_speed at[WF_CRITICAL_RUNGS + 1];
    bool kept[WF_CRITICAL_RUNGS + 1];
};

static enum wf_status rung(void *context, size_t k, struct wf_err *e)
{
    struct batch *b = context;
    b->kept[k] = !wf_speed_totals(b->search->an, b->search->o, b->speed[k], &b->at[k], e);
    return WF_OK;
}

/* Up the ladder that wf_critical_search will climb, as many rungs at a time as there are threads, until one
 * falls; what was found is kept for it. Faults are left for it to meet again. */
static enum wf_status climb(const struct search *q, struct wf_err *e)
{
    struct known *known = q->known;
    size_t threads = wf_together_threads(q->o->threads);
    struct wf_arena scratch = { 0 };
    struct batch *b = WF_TAKE(&scratch, 1, struct batch);
    if (!b) return wf_fail(e, WF_ENOMEM, "no room for the search of the critical speed");
    b->search = q;
    bool fell = threads < 2;
    for (int k = 0; k <= WF_CRITICAL_RUNGS && !fell;) {
        size_t n = 0;
        for (; k <= WF_CRITICAL_RUNGS && n < threads; k++) {
            double speed = wf_critical_rung(q->an->scenario.speed_max, k);
            const struct wf_at_speed *at = recall(q, speed);
            if (at)
                fell = fell || falls(q, at);
            else
                b->speed[n++] = speed;
        }
        enum wf_status s = wf_together(n, q->o->threads, rung, b, e);
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
    if (!s) s = wf_critical_search(utilisation, &search, an->scenario.speed_max, 1e-4, c, e);
    if (s || (c->outcome != WF_CRITICAL_FOUND && c->outcome != WF_CRITICAL_SELF_WEIGHT)) return s;
    search.o = o;
    s = c->outcome == WF_CRITICAL_FOUND ? polish(&search, c, &at, e) : totals(&search, 0.0, &at, e);
    const struct wf_worst *worst = &at.worst[search.criterion][search.scope];
    if (s || at.status || worst->row < 0) return s;
    if (c->outcome == WF_CRITICAL_FOUND) out->at = at;
    place_at(&an->tree, worst, out);
    return WF_OK;
}

/* The branches' answer as far as that of the whole tree tells it. */
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
    out->critical.speed_high = an->scenario.speed_max;
}

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct known *known = WF_TAKE(&scratch, 1, struct known);
    enum wf_status s = WF_OK;
    if (!known) return wf_fail(e, WF_ENOMEM, "no room for the search of the critical speed");
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
    wf_arena_free(&scratch);
    return s;
}
