/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Critical wind speeds of an analysis, by criterion and part of the tree; declared in analysis.h. */
#include "base/num.h"
#include "base/parallel.h"
#include "fail/crossing.h"
#include "study/analysis.h"
#include "study/node.h"
#include "study/sway.h"
#include "study/verdict.h"
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
    struct wf_break *out;
    /* of those by values and slopes, which go on together */
    enum wf_crossing_next next;
    double wanted; /* the speed to be solved next [m/s] */
    size_t items;
    size_t *item; /* rows */
};

static enum wf_node_part part_of(const struct search *q)
{
    return q->scope == WF_SCOPE_BRANCHES ? WF_NODE_BRANCHES : WF_NODE_STEM;
}

static const struct wf_at_speed *state_of(const struct search *q, const struct wf_node *node)
{
    return q->scope == WF_SCOPE_TREE ? &node->at : &node->state[part_of(q)].at;
}

/* Is what the search looks at known at a node? */
static bool knows(const struct search *q, const struct wf_node *node)
{
    return q->scope == WF_SCOPE_TREE ? node->whole : node->state[part_of(q)].known;
}

static enum wf_status search_totals(const struct search *q, double speed, struct wf_at_speed *at,
                                    struct wf_err *e)
{
    struct wf_node *known = wf_nodes_find(q->nodes, speed, q->o->mesh_tolerance);
    if (known && knows(q, known)) {
        known->used = true;
        *at = *state_of(q, known);
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

/* The step to where a utilisation reaches 1, which follows a power of the speed closely. */
static double power_step(double speed, double value, double slope)
{
    return speed * expm1(-log(value) * value / (slope * speed));
}

/* Step to the lowest crossing: that of the governing row, unless another row reaches 1 before. */
static double step_to_crossing(const struct search *q, const struct wf_node *node, double *slope)
{
    const struct wf_node_column *column = &node->column[q->criterion];
    const int32_t row = state_of(q, node)->worst[q->criterion][q->scope].row;
    double value = 1.0 / safety(q, state_of(q, node));
    *slope = row < 0 ? 0.0 : (double)column->gain[row];
    if (!(*slope > 0.0)) return NAN;
    double first = (1.0 - value) / *slope;
    for (size_t i = 0; i < q->an->tree.n; i++) {
        const double at = (double)column->value[i], gain = (double)column->gain[i], own = (1.0 - at) / gain;
        if (!(gain > 0.0 && own < first - 1e-7 * node->at.speed) ||
            !wf_scope_holds(q->scope, &q->an->tree, i))
            continue;
        first = own, value = at, *slope = gain;
    }
    return power_step(node->at.speed, value, *slope);
}

/* Share of the speed over which a crossing is taken from a node by a power law. */
static const double short_step = 3e-4;

/* The node of this mesh from which the crossing is taken: a very near one that is known, for another
 * criterion, or that at the speed. */
static enum wf_status node_near(const struct search *q, double speed, const struct wf_node **out,
                                struct wf_err *e)
{
    for (size_t i = 0; i < wf_nodes_count(q->nodes); i++) {
        const struct wf_node *node = wf_nodes_at(q->nodes, i);
        if (node->tolerance != q->o->mesh_tolerance || !node->state[part_of(q)].sloped) continue;
        if (fabs(node->at.speed - speed) > short_step * speed) continue;
        *out = node;
        return WF_OK;
    }
    return wf_nodes_solve_part(q->nodes, q->o, speed, part_of(q), out, e);
}

/* Refine the critical speed found on a coarse mesh to that of the options by Newton's method in logarithms.
 * Returned: c->speed, and the node it was taken from, with *step from it, whose errors are those of a power
 * law over so short a step; *step NAN: values and slopes do not lead to the crossing. */
static enum wf_status polish_sloped(const struct search *q, struct wf_critical *c,
                                    const struct wf_node **node, double *step, struct wf_err *e)
{
    const double near = 5e-4; /* of the resistance */
    for (int k = 0;; k++) {
        enum wf_status s = node_near(q, c->speed, node, e);
        c->evaluations++;
        *step = NAN;
        if (s || state_of(q, *node)->status) return s;
        double slope, next = step_to_crossing(q, *node, &slope);
        if (!(slope > 0.0)) return WF_OK;
        c->gradient = slope;
        if (!(fabs(next) < 0.02 * c->speed)) return WF_OK;
        c->speed = (*node)->at.speed + next;
        c->speed_low = c->speed - fabs(next), c->speed_high = c->speed + fabs(next);
        if (fabs(next * slope) <= near || fabs(next) <= short_step * c->speed) {
            *step = next;
            return WF_OK;
        }
        if (k == 4) return WF_OK;
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
            if (known && knows(q, known))
                fell = fell || falls(q, state_of(q, known));
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
    out->row = w->row, out->place = w->place;
    out->height = t->z0[w->row] + w->place * (t->z1[w->row] - t->z0[w->row]);
}

/* The lowest given wind in which this part of the tree fails [m/s]; INFINITY: none. */
static double fails_given(const struct search *q)
{
    double lowest = INFINITY;
    for (size_t k = 0; q->an->at && k < q->an->n; k++)
        if (q->an->at[k].status || safety(q, &q->an->at[k]) < 1.0) lowest = fmin(lowest, q->an->at[k].speed);
    return lowest;
}

/* The highest speed to be searched: the range given, or the lowest given speed above it at which this part of
 * the tree failed. */
static double search_top(const struct search *q)
{
    const double range = q->an->search.speed_max, fails = fails_given(q);
    return fails > range && isfinite(fails) ? fails : range;
}

/* What is known of a search that was ended: between which speeds the tree fails. */
static void bracket(const struct search *q, struct wf_critical *c)
{
    *c = (struct wf_critical){ WF_CRITICAL_UNSEARCHED, NAN, 0.0, q->speed_max, NAN, 0 };
    for (size_t i = 0; i < wf_nodes_count(q->nodes); i++) {
        const struct wf_node *node = wf_nodes_at(q->nodes, i);
        if (knows(q, node) && falls(q, state_of(q, node)))
            c->speed_high = fmin(c->speed_high, node->at.speed);
    }
    for (size_t i = 0; i < wf_nodes_count(q->nodes); i++) {
        const struct wf_node *node = wf_nodes_at(q->nodes, i);
        if (!knows(q, node) || falls(q, state_of(q, node))) continue;
        if (node->at.speed < c->speed_high) c->speed_low = fmax(c->speed_low, node->at.speed);
    }
}

static const struct wf_break nothing = { .at = { .speed = NAN }, .row = -1, .place = NAN, .height = NAN };

/* Is there something to be searched? Else the result says why not. */
static bool begin_search(struct search *q)
{
    *q->out = nothing;
    q->speed_max = search_top(q);
    if (wf_criterion_known(&wf_criteria[q->criterion], &q->an->tree, q->scope)) return true;
    q->out->critical =
        (struct wf_critical){ .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .gradient = NAN };
    return false;
}

/* A search ended by an error: where its time was used up, what is known so far is the result. */
static enum wf_status end_search(const struct search *q, enum wf_status s, const struct wf_err *why,
                                 struct wf_err *e)
{
    if (!s) return WF_OK;
    if (!wf_nodes_late(q->nodes)) return wf_fail(e, s, "%s", why->text);
    *q->out = nothing;
    bracket(q, &q->out->critical);
    return WF_OK;
}

/* ---- By steps ---- */

static enum wf_status search_by_steps(struct search *q, const struct wf_solve_options *quick,
                                      const struct wf_solve_options *fine, struct wf_err *e)
{
    struct wf_critical *c = &q->out->critical;
    struct wf_at_speed at;
    q->o = quick;
    wf_sway_reach(q->an, INFINITY); /* how far the steps go depends on the number of threads */
    enum wf_status s = climb(q, e);
    if (!s) s = wf_critical_search(utilisation, q, q->speed_max, 1e-4, c, e);
    if (s || !wf_verdict_reached(c)) return s;
    const struct wf_worst *worst = &at.worst[q->criterion][q->scope];
    bool found = c->outcome == WF_CRITICAL_FOUND;
    /* of a tree that fails at rest the place alone is wanted, and that of the search is good enough */
    if (!found) s = search_totals(q, 0.0, &at, e);
    q->o = fine;
    if (found)
        s = polish(q, c, &at, e);
    else if (!s && (at.status || worst->row < 0))
        s = search_totals(q, 0.0, &at, e);
    if (s || at.status || worst->row < 0) return s;
    if (found) q->out->at = at;
    place_at(&q->an->tree, worst, q->out);
    return WF_OK;
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
        const struct wf_node_state *state = &node->state[part_of(q)];
        if (node->tolerance != q->o->mesh_tolerance || !(state->sloped || state->at.status)) continue;
        if (node->at.speed > q->speed_max) continue;
        bool solved = !state->at.status;
        out[n++] = (struct wf_crossing_node){ node->at.speed, solved, 1.0,
                                              solved ? node->column[q->criterion].value : NULL,
                                              solved ? node->column[q->criterion].gain : NULL };
        if (state->irregular) out[n - 1].trusted = q->scope == WF_SCOPE_STEM ? loose_stem : loose;
    }
    qsort(out, n, sizeof *out, by_speed);
    return n;
}

static enum wf_status take_rows(struct search *q, struct wf_arena *scratch, struct wf_err *e)
{
    if (!(q->item = WF_TAKE(scratch, q->an->tree.n, size_t)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    for (size_t i = 0; i < q->an->tree.n; i++)
        if (wf_scope_holds(q->scope, &q->an->tree, i) &&
            wf_criterion_knows(&wf_criteria[q->criterion], &q->an->tree, i))
            q->item[q->items++] = i;
    return WF_OK;
}

/* What the nodes say of a search: its end, or the speed it wants. */
static void look(struct search *q, struct wf_crossing_node *all)
{
    const double tolerance = 2e-3; /* what is left is for the finer mesh */
    struct wf_crossing at;
    size_t n = gather(q, all);
    q->next = wf_crossing_step(all, n, q->item, q->items, q->speed_max, tolerance, &at);
    q->wanted = at.speed;
    q->out->critical = (struct wf_critical){ WF_CRITICAL_ABOVE, NAN, at.low, at.high, NAN, n };
    if (q->next != WF_CROSSING_FOUND) return;
    q->out->critical.outcome = WF_CRITICAL_FOUND;
    q->out->critical.speed = at.speed, q->out->critical.gradient = at.gradient;
}

/* The searches of one part of the tree by wf_crossing_step, from speed 0 and the first given speed. Of the
 * speeds that they want the lowest is solved next, so that solutions start near others, and it serves all.
 * Returned: in each, `next`: FOUND, ABOVE, or LOST where the steps of wf_critical_search are needed. */
static enum wf_status descend(struct search *list, size_t n, struct wf_err *e)
{
    const struct wf_node *node;
    const struct search *q = list;
    const double first = q->an->at ? q->an->at[0].speed : 0.0;
    struct wf_arena scratch = { 0 };
    struct wf_crossing_node *all = WF_TAKE(&scratch, WF_NODES_MAX, struct wf_crossing_node);
    enum wf_status s =
        all ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    for (size_t i = 0; i < n && !s; i++) s = take_rows(&list[i], &scratch, e);
    if (!s) s = wf_nodes_solve_part(q->nodes, q->o, 0.0, part_of(q), &node, e);
    if (!s && !state_of(q, node)->status && first > 0.0 && first <= q->speed_max)
        s = wf_nodes_solve_part(q->nodes, q->o, first, part_of(q), &node, e);
    for (int k = 0; k < DESCENT_MAX && !s; k++) {
        double lowest = INFINITY;
        for (size_t i = 0; i < n; i++) {
            look(&list[i], all);
            if (list[i].next == WF_CROSSING_SOLVE) lowest = fmin(lowest, list[i].wanted);
        }
        if (isinf(lowest)) break;
        s = wf_nodes_solve_part(q->nodes, q->o, lowest, part_of(q), &node, e);
    }
    for (size_t i = 0; i < n; i++)
        if (list[i].next == WF_CROSSING_SOLVE) list[i].next = WF_CROSSING_LOST;
    wf_arena_free(&scratch);
    return s;
}

/* The stem's state with slopes by a mesh tolerance that is nearest to a speed, if it is so near that its
 * totals follow from the slopes; NULL: none. */
static const struct wf_node *stem_beside(const struct search *q, double tolerance, double speed)
{
    const struct wf_node *out = NULL;
    double least = 0.01 * speed;
    for (size_t i = 0; i < wf_nodes_count(q->nodes); i++) {
        const struct wf_node *node = wf_nodes_at(q->nodes, i);
        const struct wf_node_state *stem = &node->state[WF_NODE_STEM];
        if (node->tolerance != tolerance || !stem->known || !stem->sloped || stem->irregular) continue;
        const double apart = fabs(node->at.speed - speed);
        if (apart < least) out = node, least = apart;
    }
    return out;
}

/* Totals at the critical speed. A node of branches with a peak of their own has no totals of the tree: they
 * are those of the mesh of the search, which is good for the figures that are printed. */
static enum wf_status totals_there(const struct search *q, const struct wf_solve_options *quick,
                                   const struct wf_node *node, double step, struct wf_err *e)
{
    struct wf_break *out = q->out;
    const double speed = node->at.speed;
    const struct wf_node *stem = node;
    enum wf_status s = WF_OK;
    if (!node->state[WF_NODE_STEM].known) {
        stem = stem_beside(q, quick->mesh_tolerance, speed + step);
        if (!stem) s = wf_nodes_solve_part(q->nodes, quick, speed, WF_NODE_STEM, &stem, e);
    }
    if (s || stem->at.status) return s;
    move_totals(q, stem, speed + step - stem->at.speed, &out->at);
    if (stem == node) return WF_OK;
    struct wf_at_speed branches;
    move_totals(q, node, step, &branches);
    wf_speed_take_branches(q->an, &branches, &out->at);
    return WF_OK;
}

static const double coarser = 10.0; /* than the specified mesh tolerance */

/* Is the crossing on a coarser mesh than specified good enough? By what it moved from the mesh of the search
 * the rest is bounded: errors of loads summed over all branches (criteria of the shape are not searched so)
 * fall with the tolerance of the mesh or faster, of one branch also with the third power of its elements. */
static bool settled(const struct search *q, const struct wf_solve_options *quick, const struct wf_node *node,
                    double before, double now)
{
    const double coarse = quick->mesh_tolerance, between = q->o->mesh_tolerance;
    const int32_t row = state_of(q, node)->worst[q->criterion][q->scope].row;
    double falls = coarse / between;
    if (q->scope == WF_SCOPE_BRANCHES)
        falls = fmin(falls, pow(wf_nodes_finer(q->nodes, WF_NODE_BRANCHES, coarse, between, row), 3));
    return falls > 1 && fabs(now - before) * coarser <= (falls - 1) * between * now;
}

/* Is a coarser mesh to be tried? For a branch where it is much finer than that of the search. */
static bool worth_between(const struct search *q, const struct wf_solve_options *quick, double between)
{
    if (wf_criteria[q->criterion].shape || coarser * between > quick->mesh_tolerance) return false;
    return q->scope == WF_SCOPE_STEM ||
           wf_nodes_finer(q->nodes, WF_NODE_STEM, quick->mesh_tolerance, between, -1) >= 2;
}

/* Options of the solutions with slopes that a crossing is taken from: what Newton's method leaves is squared
 * by the step that gives the slopes, and need not be less than the mesh's error before. */
static struct wf_solve_options polished(const struct wf_solve_options *fine, double times)
{
    struct wf_solve_options out = *fine;
    out.mesh_tolerance *= times;
    out.tolerance = fmax(fine->tolerance, fmin(sqrt(fine->tolerance), 0.1 * out.mesh_tolerance));
    return out;
}

/* A search that is through: the crossing on the specified mesh, the place, the totals there. */
static enum wf_status finish(struct search *q, const struct wf_solve_options *quick,
                             const struct wf_solve_options *fine, struct wf_err *e)
{
    struct wf_critical *c = &q->out->critical;
    const struct wf_solve_options exact = polished(fine, 1.0), between = polished(fine, coarser);
    const struct wf_node *node;
    double step = 0.0, before = c->speed;
    if (q->an->search.bare && quick->mesh_tolerance == fine->mesh_tolerance) return WF_OK;
    const bool between_first = worth_between(q, quick, between.mesh_tolerance);
    q->o = between_first ? &between : &exact;
    enum wf_status s = polish_sloped(q, c, &node, &step, e);
    if (!s && between_first && !settled(q, quick, node, before, c->speed)) {
        q->o = &exact;
        s = polish_sloped(q, c, &node, &step, e);
    }
    if (s) return s;
    if (isnan(step)) return search_by_steps(q, quick, fine, e);
    const struct wf_worst *worst = &state_of(q, node)->worst[q->criterion][q->scope];
    if (worst->row < 0) return WF_OK;
    place_at(&q->an->tree, worst, q->out);
    return totals_there(q, quick, node, step, e);
}

/* Where the part fails in a given wind below the critical speed, a twig has another equilibrium, which the
 * search did not follow: each state is then solved by itself, as that of the given wind was, up to this. */
static enum wf_status heed_given(struct search *q, const struct wf_solve_options *quick,
                                 const struct wf_solve_options *fine, struct wf_err *e)
{
    const double clearly = 1.0 - 1e-3;
    const double lowest = fails_given(q);
    if (!(lowest > 0.0 && lowest < clearly * wf_verdict_bound(&q->out->critical))) return WF_OK;
    *q->out = nothing, q->speed_max = lowest;
    enum wf_status s = search_by_steps(q, quick, fine, e);
    if (s || wf_verdict_bound(&q->out->critical) < lowest) return s;
    *q->out = nothing;
    bracket(q, &q->out->critical);
    return WF_OK;
}

static int by_critical(const void *a, const void *b)
{
    const struct search *x = *(const struct search *const *)a, *y = *(const struct search *const *)b;
    const double p = x->out->critical.speed, q = y->out->critical.speed;
    return p != q ? (p > q) - (p < q) : (x > y) - (x < y);
}

/* All criteria in one part of the tree. */
static enum wf_status search_part(struct search *list, size_t n, const struct wf_solve_options *quick,
                                  const struct wf_solve_options *fine, struct wf_err *e)
{
    struct wf_err why = { 0 };
    struct search *order[WF_CRITERIA];
    size_t found = 0;
    for (size_t i = 0; i < n; i++) list[i].o = quick;
    enum wf_status s = n ? descend(list, n, &why) : WF_OK;
    for (size_t i = 0; i < n; i++) {
        struct search *q = &list[i];
        enum wf_status own = q->next == WF_CROSSING_LOST && !s ? search_by_steps(q, quick, fine, &why) : s;
        if ((own = end_search(q, own, &why, e))) return own;
        if (!s && q->next == WF_CROSSING_FOUND) order[found++] = q;
    }
    qsort(order, found, sizeof(order[0]), by_critical);
    enum wf_status own = WF_OK;
    for (size_t i = 0; i < found && !own; i++)
        own = end_search(order[i], finish(order[i], quick, fine, &why), &why, e);
    for (size_t i = 0; i < n && !own; i++)
        own = end_search(&list[i], heed_given(&list[i], quick, fine, &why), &why, e);
    return own;
}

/* ---- All ---- */

/* The lowest speed at which a search may have a crossing. */
static double bound(const struct wf_break *b) { return wf_verdict_bound(&b->critical); }

/* Result of the whole tree from those of its stem and its branches, of which the latter were searched up to
 * the former. */
static void join(const struct wf_break *stem, const struct wf_break *branches, struct wf_break *out)
{
    *out = bound(branches) < bound(stem) ? *branches : *stem;
    if (out->critical.outcome == WF_CRITICAL_UNSEARCHED)
        out->critical.speed_high = fmin(stem->critical.speed_high, branches->critical.speed_high);
    if (branches->critical.outcome != WF_CRITICAL_NO_STRENGTH)
        out->critical.evaluations = stem->critical.evaluations + branches->critical.evaluations;
}

/* Result of the branches as far as it follows from that of the whole tree. */
static void branches_of(const struct wf_analysis *an, const struct wf_criterion *c,
                        const struct wf_break *tree, struct wf_break *out)
{
    bool known = wf_criterion_known(c, &an->tree, WF_SCOPE_BRANCHES);
    *out = *tree;
    if (known && (tree->row < 0 || an->tree.level[tree->row] > 0)) return;
    *out = nothing;
    out->critical = (struct wf_critical){ .outcome = known ? WF_CRITICAL_UNSEARCHED : WF_CRITICAL_NO_STRENGTH,
                                          .speed = NAN,
                                          .gradient = NAN };
    if (!known) return;
    out->critical.speed_low = tree->critical.outcome == WF_CRITICAL_FOUND ? tree->critical.speed_low : 0.0;
    out->critical.speed_high = an->search.speed_max;
}

/* By values and slopes: stem and branches, each in its own state. */
static enum wf_status search_parts(const struct wf_analysis *an, const struct wf_solve_options *o,
                                   struct wf_nodes *nodes, struct wf_break (*out)[WF_SCOPES],
                                   struct wf_err *e)
{
    static const enum wf_scope scope[] = { WF_SCOPE_STEM, WF_SCOPE_BRANCHES };
    const struct wf_solve_options quick = wf_nodes_quick(o);
    for (size_t p = 0; p < WF_COUNT(scope); p++) {
        struct search list[WF_CRITERIA];
        size_t n = 0;
        for (int c = 0; c < WF_CRITERIA; c++) {
            struct search q = {
                .an = an, .criterion = (enum wf_criterion_id)c, .scope = scope[p], .nodes = nodes
            };
            q.out = &out[c][scope[p]];
            if (!begin_search(&q)) continue;
            const struct wf_break *stem = &out[c][WF_SCOPE_STEM];
            if (p && stem->critical.outcome == WF_CRITICAL_SELF_WEIGHT) continue;
            if (p && stem->critical.outcome == WF_CRITICAL_FOUND)
                q.speed_max = fmin(q.speed_max, stem->critical.speed);
            list[n++] = q;
        }
        enum wf_status s = search_part(list, n, &quick, o, e);
        if (s) return s;
    }
    for (int c = 0; c < WF_CRITERIA; c++)
        join(&out[c][WF_SCOPE_STEM], &out[c][WF_SCOPE_BRANCHES], &out[c][WF_SCOPE_TREE]);
    return WF_OK;
}

/* By steps: the whole tree, then the stem. */
static enum wf_status search_scope(const struct wf_analysis *an, const struct wf_solve_options *o,
                                   struct wf_nodes *nodes, int c, enum wf_scope scope, struct wf_break *out,
                                   struct wf_err *e)
{
    const struct wf_solve_options quick = wf_nodes_quick(o);
    struct wf_err why = { 0 };
    struct search q = { .an = an, .criterion = (enum wf_criterion_id)c, .scope = scope, .nodes = nodes };
    q.out = out;
    return begin_search(&q) ? end_search(&q, search_by_steps(&q, &quick, o, &why), &why, e) : WF_OK;
}

/* Nothing is searched yet. */
static void unsearched(const struct wf_analysis *an, struct wf_break (*out)[WF_SCOPES])
{
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int scope = 0; scope < WF_SCOPES; scope++) {
            bool known = wf_criterion_known(&wf_criteria[c], &an->tree, (enum wf_scope)scope);
            out[c][scope] = nothing;
            out[c][scope].critical =
                (struct wf_critical){ .outcome = known ? WF_CRITICAL_UNSEARCHED : WF_CRITICAL_NO_STRENGTH,
                                      .speed = NAN,
                                      .speed_high = an->search.speed_max,
                                      .gradient = NAN };
        }
}

/* The lowest wind in which the stem is lost: each criterion is searched below what was found alone. */
static enum wf_status bare_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_nodes *nodes, struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    const struct wf_solve_options quick = wf_nodes_quick(o);
    enum wf_criterion_id order[WF_CRITERIA];
    double lowest = INFINITY;
    enum wf_status s = WF_OK;
    unsearched(an, out);
    for (size_t k = 0, n = wf_verdict_nearest(an, order); k < n && !s && lowest > 0; k++) {
        struct wf_break *b = &out[order[k]][WF_SCOPE_STEM];
        struct search q = {
            .an = an, .criterion = order[k], .scope = WF_SCOPE_STEM, .nodes = nodes, .out = b
        };
        if (!begin_search(&q)) continue;
        q.speed_max = fmin(q.speed_max, lowest);
        struct wf_err why = { 0 };
        s = wf_nodes_tracked(an) ? search_part(&q, 1, &quick, o, e)
                                 : end_search(&q, search_by_steps(&q, &quick, o, &why), &why, e);
        if (!s && wf_verdict_reached(&b->critical))
            lowest = fmin(lowest, b->critical.outcome == WF_CRITICAL_FOUND ? b->critical.speed : 0.0);
    }
    for (int c = 0; c < WF_CRITERIA; c++)
        if (!wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_BRANCHES))
            out[c][WF_SCOPE_TREE] = out[c][WF_SCOPE_STEM];
    return s;
}

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_nodes *nodes, struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    const bool tracked = wf_nodes_tracked(an);
    wf_nodes_deadline(nodes, an->search.seconds);
    if (an->search.bare) return bare_breaks(an, o, nodes, out, e);
    enum wf_status s = tracked ? search_parts(an, o, nodes, out, e) : WF_OK;
    for (int c = 0; c < WF_CRITERIA && !s; c++) {
        bool branches = wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_BRANCHES);
        if (!tracked) s = search_scope(an, o, nodes, c, WF_SCOPE_TREE, &out[c][WF_SCOPE_TREE], e);
        if (!tracked && !s && branches)
            s = search_scope(an, o, nodes, c, WF_SCOPE_STEM, &out[c][WF_SCOPE_STEM], e);
        if (!branches) out[c][WF_SCOPE_STEM] = out[c][WF_SCOPE_TREE];
        branches_of(an, &wf_criteria[c], &out[c][WF_SCOPE_TREE], &out[c][WF_SCOPE_BRANCHES]);
    }
    return s;
}

void wf_search_default(struct wf_search *s)
{
    *s = (struct wf_search){ .speed_max = 60.0, .beyond = 1.2, .seconds = INFINITY, .branches_from = 0.05 };
}
