/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Critical wind speeds of an analysis, by criterion and part of the tree; declared in analysis.h. */
#include "base/parallel.h"
#include "fail/crossing.h"
#include "study/analysis.h"
#include "study/node.h"
#include <math.h>
#include <stdlib.h>

/* ---- The critical wind speeds, by criterion and part of the tree ---- */

struct search {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    enum wf_criterion_id criterion;
    enum wf_scope scope;
    struct wf_nodes *nodes;
    double speed_max; /* [m/s] */
    double enough;    /* crossings above are of no interest [m/s]; INFINITY: all are */
};

static enum wf_status search_totals(const struct search *q, double speed, struct wf_at_speed *at,
                                    struct wf_err *e)
{
    struct wf_node *known = wf_nodes_find(q->nodes, speed, q->o->mesh_tolerance);
    if (known) {
        known->used = true;
        *at = known->at;
        return WF_OK;
    }
    enum wf_status s = wf_nodes_ready(q->nodes, e);
    if (!s) s = wf_speed_totals(q->an, q->o, speed, at, e);
    if (!s) wf_nodes_add(q->nodes, q->o->mesh_tolerance, true, at);
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

/* Totals at a speed that differs by `step` from that of a node, by its slopes. */
static void move_totals(const struct search *q, const struct wf_node *node, double step,
                        struct wf_at_speed *at)
{
    double v[WF_TOTALS];
    wf_totals_read(&node->at, v);
    for (int k = 0; k < WF_TOTALS; k++) v[k] += step * node->slope[k];
    struct wf_at_speed moved = node->at;
    wf_totals_write(v, q->an->tallness, &moved);
    moved.breakage.largest_stress_row = node->at.breakage.largest_stress_row;
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++) {
            moved.worst[c][s].row = node->at.worst[c][s].row;
            moved.worst[c][s].place = node->at.worst[c][s].place;
        }
    moved.speed += step;
    *at = moved;
}

/* Newton's step to the lowest crossing: that of the governing row, unless another row reaches 1 before. */
static double step_to_crossing(const struct search *q, const struct wf_node *node, double *slope)
{
    const struct wf_node_column *column = &node->column[q->criterion];
    double excess = 1.0 / safety(q, &node->at) - 1.0, step;
    *slope = node->slope[WF_TOTAL_UTILISATION + (int)q->criterion * WF_SCOPES + (int)q->scope];
    step = -excess / *slope;
    for (size_t i = 0; i < q->an->tree.n; i++) {
        double value = (double)column->value[i], gain = (double)column->gain[i];
        double own = (1.0 - value) / gain;
        if (!(gain > 0.0 && own < step - 1e-7 * node->at.speed) || !wf_scope_holds(q->scope, &q->an->tree, i))
            continue;
        step = own, *slope = gain;
    }
    return step;
}

/* Refine the critical speed found on a coarse mesh to the mesh tolerance of the options by Newton's method.
 * Returned: c->speed, and *at, the totals there; after the last step by the slopes, with errors of the square
 * of the step. */
static enum wf_status polish_sloped(const struct search *q, struct wf_critical *c, struct wf_at_speed *at,
                                    struct wf_err *e)
{
    const double near = 2e-4; /* of the resistance */
    for (int k = 0;; k++) {
        struct wf_node stem;
        const struct wf_node *node = &stem;
        enum wf_status s = q->scope == WF_SCOPE_STEM ? wf_nodes_solve_stem(q->nodes, q->o, c->speed, &stem, e)
                                                     : wf_nodes_solve(q->nodes, q->o, c->speed, &node, e);
        c->evaluations++;
        if (s) return s;
        *at = node->at;
        if (at->status) return WF_OK;
        double slope, step = step_to_crossing(q, node, &slope);
        if (!(slope > 0.0)) return WF_OK;
        c->gradient = slope;
        if (!(fabs(step) < 0.02 * c->speed)) return WF_OK;
        c->speed_low = c->speed - fabs(step), c->speed_high = c->speed + fabs(step);
        c->speed += step;
        if (fabs(step * slope) > near && k < 4) continue;
        move_totals(q, node, step, at);
        return WF_OK;
    }
}

/* The same where the solver gives no slope: secant steps with the coarse mesh's slope, which differs little.
 */
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
    b->kept[k] = false;
    if (wf_nodes_late(b->search->nodes)) return WF_OK;
    b->kept[k] = !wf_speed_totals(b->search->an, b->search->o, b->speed[k], &b->at[k], e);
    return WF_OK;
}

/* Solve the speeds that wf_critical_search will step through, as many at a time as there are threads, until
 * the tree fails at one, and store the results. Errors are ignored: wf_critical_search solves that speed
 * again and reports them. */
static enum wf_status climb(const struct search *q, struct wf_err *e)
{
    size_t threads = wf_nodes_threads(q->an, q->o);
    struct wf_arena scratch = { 0 };
    struct batch *b = WF_TAKE(&scratch, 1, struct batch);
    if (!b) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    b->search = q;
    bool fell = threads < 2;
    for (int k = 0, rungs = wf_critical_rungs(q->speed_max); k <= rungs && !fell;) {
        size_t n = 0;
        for (; k <= rungs && n < threads; k++) {
            double speed = wf_critical_rung(q->speed_max, k);
            const struct wf_node *known = wf_nodes_find(q->nodes, speed, q->o->mesh_tolerance);
            if (known)
                fell = fell || falls(q, &known->at);
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
            if (b->kept[i]) wf_nodes_add(q->nodes, q->o->mesh_tolerance, false, &b->at[i]);
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
    for (size_t i = 0; i < wf_nodes_count(q->nodes); i++) {
        const struct wf_at_speed *at = &wf_nodes_at(q->nodes, i)->at;
        if (falls(q, at)) c->speed_high = fmin(c->speed_high, at->speed);
    }
    for (size_t i = 0; i < wf_nodes_count(q->nodes); i++) {
        const struct wf_at_speed *at = &wf_nodes_at(q->nodes, i)->at;
        if (at->speed < c->speed_high && !falls(q, at)) c->speed_low = fmax(c->speed_low, at->speed);
    }
}

/* ---- By values and slopes ---- */

enum { DESCENT_MAX = 60 };

static int by_speed(const void *a, const void *b)
{
    const struct wf_crossing_node *x = a, *y = b;
    return (x->speed > y->speed) - (x->speed < y->speed);
}

/* The nodes of this mesh tolerance, ascending. Returned: their number. */
static size_t gather(const struct search *q, struct wf_crossing_node *out)
{
    const double loose_stem = 0.95, loose = 0.6;
    size_t n = 0;
    for (size_t i = 0; i < wf_nodes_count(q->nodes); i++) {
        const struct wf_node *node = wf_nodes_at(q->nodes, i);
        if (node->tolerance != q->o->mesh_tolerance || !(node->sloped || node->at.status)) continue;
        if (node->at.speed > q->speed_max) continue;
        bool solved = !node->at.status;
        out[n++] = (struct wf_crossing_node){ node->at.speed, solved, 1.0,
                                              solved ? node->column[q->criterion].value : NULL,
                                              solved ? node->column[q->criterion].gain : NULL };
        if (node->irregular) out[n - 1].trusted = q->scope == WF_SCOPE_STEM ? loose_stem : loose;
    }
    qsort(out, n, sizeof *out, by_speed);
    return n;
}

static size_t rows_of(const struct search *q, size_t *item)
{
    size_t n = 0;
    for (size_t i = 0; i < q->an->tree.n; i++)
        if (wf_scope_holds(q->scope, &q->an->tree, i) &&
            wf_criterion_knows(&wf_criteria[q->criterion], &q->an->tree, i))
            item[n++] = i;
    return n;
}

/* The search by wf_crossing_step, from speed 0 and the given speeds. Returned: *next, FOUND with c->speed and
 * c->gradient on the mesh of the options; ABOVE; LOST where the steps of wf_critical_search are needed. */
static enum wf_status descend(const struct search *q, enum wf_crossing_next *next, struct wf_critical *c,
                              struct wf_arena *scratch, struct wf_err *e)
{
    const double tolerance = 2e-4;
    const struct wf_node *node;
    struct wf_crossing at;
    size_t *item = WF_TAKE(scratch, q->an->tree.n, size_t);
    struct wf_crossing_node *all = WF_TAKE(scratch, WF_NODES_MAX, struct wf_crossing_node);
    if (!item || !all) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    size_t items = rows_of(q, item);
    enum wf_status s = wf_nodes_solve(q->nodes, q->o, 0.0, &node, e);
    double first = q->an->at ? q->an->at[0].speed : 0.0;
    if (!s && !falls(q, &node->at) && first > 0.0 && first <= q->speed_max)
        s = wf_nodes_solve(q->nodes, q->o, first, &node, e);
    *next = WF_CROSSING_LOST;
    for (int k = 0; k < DESCENT_MAX && !s; k++) {
        *next = wf_crossing_step(all, gather(q, all), item, items, q->speed_max, tolerance, &at);
        *c = (struct wf_critical){ WF_CRITICAL_ABOVE, NAN, at.low, at.high, NAN, (size_t)k };
        if (*next == WF_CROSSING_FOUND)
            c->outcome = WF_CRITICAL_FOUND, c->speed = at.speed, c->gradient = at.gradient;
        if (*next != WF_CROSSING_SOLVE) return WF_OK;
        s = wf_nodes_solve(q->nodes, q->o, at.speed, &node, e);
        *next = WF_CROSSING_LOST;
    }
    return s;
}

/* The search itself: by slopes where the solver gives them and the curves are smooth, else by steps. */
static enum wf_status search_crossing(struct search *q, struct wf_critical *c, struct wf_err *e)
{
    enum wf_crossing_next next = WF_CROSSING_LOST;
    struct wf_arena scratch = { 0 };
    enum wf_status s = wf_nodes_tracked(q->an) ? descend(q, &next, c, &scratch, e) : WF_OK;
    wf_arena_free(&scratch);
    if (s || next != WF_CROSSING_LOST) return s;
    s = climb(q, e);
    return s ? s : wf_critical_search(utilisation, q, q->speed_max, 1e-4, c, e);
}

/* The result at its end. */
static enum wf_status search_break(struct search *search, const struct wf_solve_options *quick,
                                   const struct wf_solve_options *fine, struct wf_break *out,
                                   struct wf_err *e)
{
    struct wf_critical *c = &out->critical;
    struct wf_at_speed at;
    search->o = quick;
    enum wf_status s = search_crossing(search, c, e);
    if (s || (c->outcome != WF_CRITICAL_FOUND && c->outcome != WF_CRITICAL_SELF_WEIGHT)) return s;
    search->o = fine;
    if (c->outcome == WF_CRITICAL_FOUND && quick->mesh_tolerance == fine->mesh_tolerance) return WF_OK;
    if (c->outcome != WF_CRITICAL_FOUND)
        s = search_totals(search, 0.0, &at, e);
    else if (wf_nodes_tracked(search->an))
        s = polish_sloped(search, c, &at, e);
    else
        s = polish(search, c, &at, e);
    const struct wf_worst *worst = &at.worst[search->criterion][search->scope];
    if (s || at.status || worst->row < 0) return s;
    if (c->outcome == WF_CRITICAL_FOUND) out->at = at;
    place_at(&search->an->tree, worst, out);
    return WF_OK;
}

static enum wf_status find_break(struct search search, struct wf_break *out, struct wf_err *e)
{
    const struct wf_solve_options *fine = search.o;
    struct wf_solve_options quick = wf_nodes_quick(fine);
    struct wf_err why = { 0 };
    const struct wf_break nothing = { .at = { .speed = NAN }, .row = -1, .height = NAN };
    *out = nothing;
    if (!wf_criterion_known(&wf_criteria[search.criterion], &search.an->tree, search.scope)) {
        out->critical =
            (struct wf_critical){ .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .gradient = NAN };
        return WF_OK;
    }
    if (search.an->search.bare && fine->mesh_tolerance == 0.0) quick.mesh_tolerance = 0.0;
    search.speed_max = fmin(search_top(&search), search.enough);
    enum wf_status s = search_break(&search, &quick, fine, out, &why);
    if (!s) return WF_OK;
    if (!wf_nodes_late(search.nodes)) return wf_fail(e, s, "%s", why.text);
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

/* Criteria that lose the tree, the nearest to its limit at the strongest given wind first. Returned: how
 * many.
 */
static size_t by_nearness(const struct wf_analysis *an, enum wf_criterion_id order[WF_CRITERIA])
{
    const struct wf_at_speed *at = an->at && an->n ? &an->at[an->n - 1] : NULL;
    size_t n = 0;
    for (int c = 0; c < WF_CRITERIA; c++) {
        if (!wf_criteria[c].loses_tree) continue;
        size_t k = n++;
        for (; k && at && at->worst[c][WF_SCOPE_STEM].safety < at->worst[order[k - 1]][WF_SCOPE_STEM].safety;
             k--)
            order[k] = order[k - 1];
        order[k] = (enum wf_criterion_id)c;
    }
    return n;
}

/* The lowest wind in which the stem is lost: each criterion is searched below what was found alone. */
static enum wf_status bare_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_nodes *nodes, struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    enum wf_criterion_id order[WF_CRITERIA];
    double lowest = INFINITY;
    enum wf_status s = WF_OK;
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int scope = 0; scope < WF_SCOPES; scope++) {
            bool known = wf_criterion_known(&wf_criteria[c], &an->tree, (enum wf_scope)scope);
            out[c][scope] = (struct wf_break){ .at = { .speed = NAN }, .row = -1, .height = NAN };
            out[c][scope].critical =
                (struct wf_critical){ .outcome = known ? WF_CRITICAL_UNSEARCHED : WF_CRITICAL_NO_STRENGTH,
                                      .speed = NAN,
                                      .speed_high = an->search.speed_max,
                                      .gradient = NAN };
        }
    for (size_t k = 0, n = by_nearness(an, order); k < n && !s; k++) {
        struct search search = { an, o, order[k], WF_SCOPE_STEM, nodes, NAN, lowest };
        struct wf_break *b = &out[order[k]][WF_SCOPE_STEM];
        s = find_break(search, b, e);
        if (!s && b->critical.outcome == WF_CRITICAL_SELF_WEIGHT) lowest = 0;
        if (!s && b->critical.outcome == WF_CRITICAL_FOUND) lowest = fmin(lowest, b->critical.speed);
        if (!(lowest > 0)) break;
    }
    for (int c = 0; c < WF_CRITERIA; c++)
        if (!wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_BRANCHES))
            out[c][WF_SCOPE_TREE] = out[c][WF_SCOPE_STEM];
    return s;
}

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_nodes *nodes, struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    enum wf_status s = WF_OK;
    wf_nodes_deadline(nodes, an->search.seconds);
    if (an->search.bare) return bare_breaks(an, o, nodes, out, e);
    for (int c = 0; c < WF_CRITERIA && !s; c++) {
        struct search search = { an, o, (enum wf_criterion_id)c, WF_SCOPE_TREE, nodes, NAN, INFINITY };
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

void wf_search_default(struct wf_search *s)
{
    *s = (struct wf_search){ .speed_max = 60.0, .beyond = 1.2, .seconds = INFINITY, .branches_from = 0.05 };
}
