/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The curves of an analysis, totals by wind speed, declared in analysis.h: of solvers that give no slopes
 * here, of others in sloped.c. */
#include "base/num.h"
#include "base/parallel.h"
#include "data/species.h"
#include "study/analysis.h"
#include "study/node.h"
#include "study/sloped.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct node {
    struct wf_at_speed at;
    bool row; /* its speed is that of a row */
};

struct curve {
    const struct wf_analysis *an;
    struct wf_solve_options o;
    size_t threads;
    int n; /* nodes, in the order of their speeds */
    struct node *node;
    double size[WF_TOTALS]; /* largest value at the nodes */
    int picked;
    struct wf_at_speed *pick; /* rows to be solved next */
    struct wf_nodes *nodes;   /* of the searches */
    bool *skipped;            /* the deadline came before this row of them */
    bool late;                /* and before one of all rows */
};

/* Add a node, unless it lies within WF_CURVE_GAP of another; a row then replaces a node that is none. */
static void add_node(struct curve *c, const struct wf_at_speed *at, bool row)
{
    int k = 0;
    for (int i = 0; i < c->n; i++) {
        double other = c->node[i].at.speed;
        if (!row && fabs(other - at->speed) <= WF_CURVE_GAP * fmax(other, at->speed)) return;
    }
    for (int i = 0; i < c->n; i++) {
        double other = c->node[i].at.speed;
        bool near = fabs(other - at->speed) <= WF_CURVE_GAP * fmax(other, at->speed);
        if (c->node[i].row || !near) c->node[k++] = c->node[i];
    }
    c->n = k;
    for (; k > 0 && c->node[k - 1].at.speed > at->speed; k--) c->node[k] = c->node[k - 1];
    c->node[k] = (struct node){ *at, row };
    c->n++;
    double v[WF_TOTALS];
    wf_totals_read(at, v);
    for (int q = 0; q < WF_TOTALS && !at->status; q++)
        if (isfinite(v[q])) c->size[q] = fmax(c->size[q], fabs(v[q]));
    c->size[WF_TOTAL_LIFT] = fmax(c->size[WF_TOTAL_LIFT], c->size[WF_TOTAL_DRAG]);
}

static bool usable(const struct curve *c, int i)
{
    return i >= 0 && i < c->n && !c->node[i].at.status && c->node[i].at.speed > 0.0;
}

/* The nodes nearest to a speed, two on each side where there are, without a gap; node `skip` does not count.
 */
static int nearest(const struct curve *c, double speed, int skip, int out[4])
{
    int high = 0, n = 0, below = 0;
    while (high < c->n && (high == skip || c->node[high].at.speed <= speed)) high++;
    for (int low = high - 1; n < 4; n++) {
        low -= low == skip, high += high == skip;
        bool left = usable(c, low), right = usable(c, high);
        if (!left && !right) break;
        if (left && (!right || 2 * below <= n))
            out[n] = low--, below++;
        else
            out[n] = high++;
    }
    return n;
}

/* Lagrange's polynomial through the nearest nodes, of the logarithms where all values are positive: at low
 * speeds the totals are powers of the speed. false: there are fewer than four nodes. */
static bool predict(const struct curve *c, double speed, int skip, double out[WF_TOTALS])
{
    int at[4], n = nearest(c, speed, skip, at);
    double weight[4], v[4][WF_TOTALS];
    for (int i = 0; i < n; i++) {
        wf_totals_read(&c->node[at[i]].at, v[i]);
        weight[i] = 1.0;
        for (int j = 0; j < n; j++)
            if (j != i)
                weight[i] *= log(speed / c->node[at[j]].at.speed) /
                             log(c->node[at[i]].at.speed / c->node[at[j]].at.speed);
    }
    for (int q = 0; q < WF_TOTALS; q++) {
        bool positive = true;
        out[q] = 0.0;
        for (int i = 0; i < n; i++) positive = positive && v[i][q] > 0.0;
        for (int i = 0; i < n; i++) out[q] += weight[i] * (positive ? log(v[i][q]) : v[i][q]);
        if (positive) out[q] = exp(out[q]);
    }
    return n == 4;
}

/* How well the other nodes predict node i: largest relative error of a total; values below 1e-4 of the
 * largest are not judged as precisely. Returned: INFINITY where they cannot, -1 at both ends, where nothing
 * is bracketed. */
static double misfit(const struct curve *c, int i)
{
    double v[WF_TOTALS], by[WF_TOTALS], worst = 0.0;
    const struct wf_at_speed *at = &c->node[i].at;
    if (i == 0 || i == c->n - 1) return -1.0;
    if (at->status) return c->node[i - 1].at.status && c->node[i + 1].at.status ? 0.0 : INFINITY;
    if (c->node[i - 1].at.speed == 0.0) return -1.0;
    if (!predict(c, at->speed, i, by)) return INFINITY;
    wf_totals_read(at, v);
    for (int q = 0; q < WF_TOTALS; q++) {
        double off = fabs(by[q] - v[q]) / fmax(fabs(v[q]), 1e-4 * c->size[q]);
        if (isfinite(v[q]) && c->size[q] > 0.0) worst = fmax(worst, isfinite(off) ? off : INFINITY);
    }
    return worst;
}

/* Estimated error between two nodes `wide` apart, from the misfit of one of them. A node with another close
 * by is easily predicted, which says less about the wider gap beside it. */
static double error_beside(const struct curve *c, int i, double wide)
{
    double off = misfit(c, i);
    if (!(off > 0.0) || isinf(off)) return off;
    double near = fmin(log(c->node[i].at.speed / c->node[i - 1].at.speed),
                       log(c->node[i + 1].at.speed / c->node[i].at.speed));
    return off * fmax(1.0, wide / near);
}

/* Does the worst place jump to another part of the tree? The curve has a kink there. */
static bool jumps(const struct wf_tree *t, int32_t a, int32_t b)
{
    if (a < 0 || b < 0) return a != b;
    return a != b && t->parent[a] != b && t->parent[b] != a;
}

static bool kinked(const struct curve *c, const struct wf_at_speed *a, const struct wf_at_speed *b)
{
    const struct wf_tree *t = &c->an->tree;
    if (jumps(t, a->breakage.largest_stress_row, b->breakage.largest_stress_row)) return true;
    for (int k = 0; k < WF_CRITERIA; k++)
        if (jumps(t, a->worst[k][WF_SCOPE_TREE].row, b->worst[k][WF_SCOPE_TREE].row)) return true;
    return false;
}

/* Is the curve between node i and the next known? The error falls with the fourth power of the distance of
 * the nodes, at a kink with the distance, and a misfit is that of at least twice the distance. */
static bool known_between(const struct curve *c, int i)
{
    const double enough = 0.015;
    const struct wf_at_speed *low = &c->node[i].at, *high = &c->node[i + 1].at;
    if (!low->status != !high->status || kinked(c, low, high)) return false;
    double wide = log(high->speed / low->speed);
    double off = fmax(error_beside(c, i, wide), error_beside(c, i + 1, wide));
    return off >= 0.0 && off <= enough;
}

static enum wf_status solve_row(void *context, size_t k, struct wf_err *e)
{
    const struct curve *c = context;
    c->skipped[k] = wf_nodes_late(c->nodes);
    if (c->skipped[k]) return WF_OK;
    return wf_speed_totals(c->an, &c->o, c->pick[k].speed, &c->pick[k], e);
}

static enum wf_status solve_picked(struct curve *c, struct wf_err *e)
{
    enum wf_status s = wf_parallel((size_t)c->picked, c->threads, solve_row, c, e);
    for (int k = 0; k < c->picked && !s; k++) c->late = c->late || c->skipped[k];
    for (int k = 0; k < c->picked && !s && !c->late; k++) add_node(c, &c->pick[k], true);
    c->picked = 0;
    return s;
}

/* Solve further rows until every part of the curve is known. The rows of a round do not depend on each other,
 * so the curve does not depend on the number of threads. */
static enum wf_status refine(struct curve *c, struct wf_err *e)
{
    while (!c->late) {
        for (int i = 0; i + 1 < c->n; i++) {
            int row = wf_sloped_middle(c->an, c->node[i].at.speed, c->node[i + 1].at.speed);
            if (row >= 0 && !known_between(c, i)) c->pick[c->picked++].speed = c->an->sweep[row].speed;
        }
        if (c->picked == 0) return WF_OK;
        enum wf_status s = solve_picked(c, e);
        if (s) return s;
    }
    return WF_OK;
}

/* A solution that may become a node. */
struct candidate {
    const struct wf_at_speed *at;
    double tolerance;
    bool row;
};

static int compare_candidates(const void *a, const void *b)
{
    const struct candidate *x = a, *y = b;
    if (x->row != y->row) return x->row ? -1 : 1;
    if (x->tolerance != y->tolerance) return x->tolerance < y->tolerance ? -1 : 1;
    return (x->at->speed > y->at->speed) - (x->at->speed < y->at->speed);
}

static const struct wf_at_speed *row_at(const struct wf_analysis *an, double speed)
{
    for (size_t k = 0; k < an->sweep_n; k++)
        if (an->sweep[k].speed == speed) return &an->sweep[k];
    return NULL;
}

/* Nodes from the solutions at hand, and the first, second and last row. */
static enum wf_status first_nodes(struct curve *c, struct candidate *all, struct wf_err *e)
{
    const struct wf_analysis *an = c->an;
    const size_t ends[] = { 0, 1, an->sweep_n - 1 };
    size_t n = 0;
    for (size_t k = 0; k < an->n; k++) all[n++] = (struct candidate){ &an->at[k], 0.0, false };
    for (size_t k = 0; k < wf_nodes_count(c->nodes); k++) {
        const struct wf_node *node = wf_nodes_at(c->nodes, k);
        if (node->used) all[n++] = (struct candidate){ &node->at, node->tolerance, false };
    }
    for (size_t k = 0; k < n; k++) all[k].row = row_at(an, all[k].at->speed);
    qsort(all, n, sizeof *all, compare_candidates);
    for (size_t k = 0; k < n; k++) add_node(c, all[k].at, all[k].row);
    for (size_t k = 0; k < WF_COUNT(ends); k++) {
        bool solved = false;
        for (int i = 0; i < c->n; i++) solved = solved || c->node[i].at.speed == an->sweep[ends[k]].speed;
        if (!solved) c->pick[c->picked++].speed = an->sweep[ends[k]].speed;
    }
    return solve_picked(c, e);
}

/* A row from the nodes around it. */
static void fill_row(const struct curve *c, struct wf_at_speed *row)
{
    int i = 0;
    double speed = row->speed, v[WF_TOTALS];
    while (i + 1 < c->n && c->node[i + 1].at.speed <= speed) i++;
    *row = c->node[i].at;
    if (row->speed == speed) return;
    row->speed = speed;
    row->interpolated = true;
    if (row->status) return;
    predict(c, speed, -1, v);
    wf_totals_write(v, c->an->tallness, row);
}

/* Rows from 0 beyond the given and the critical speeds, at a round step; a quarter of it for the first steps,
 * where the deflection of a slender tree grows fastest. */
static enum wf_status take_rows(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    enum { QUARTERED = 5, STEPS = 40 };
    static const double steps[] = { 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0 };
    double top = 1.0, step = 0.0;
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
    return WF_OK;
}

/* The nodes, then the rows. */
static enum wf_status draw(struct curve *c, struct wf_analysis *an, struct wf_arena *scratch,
                           struct wf_err *e)
{
    size_t most = an->n + wf_nodes_count(c->nodes) + an->sweep_n;
    c->node = WF_TAKE(scratch, most, struct node);
    c->pick = WF_TAKE(scratch, most, struct wf_at_speed);
    c->skipped = WF_TAKE(scratch, most, bool);
    struct candidate *all = WF_TAKE(scratch, most, struct candidate);
    if (!c->node || !c->pick || !c->skipped || !all)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a sweep of %zu speeds", most);
    enum wf_status s = first_nodes(c, all, e);
    if (!s) s = refine(c, e);
    for (size_t k = 0; k < an->sweep_n && !s && !c->late; k++) fill_row(c, &an->sweep[k]);
    return s;
}

enum wf_status wf_analysis_sweep(struct wf_analysis *an, const struct wf_solve_options *o,
                                 struct wf_nodes *nodes, struct wf_arena *a, struct wf_diag *d,
                                 struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct curve c = { .an = an, .o = wf_nodes_quick(o), .threads = wf_nodes_threads(an, o), .nodes = nodes };
    enum wf_status s = take_rows(an, a, e);
    if (s) return s;
    wf_nodes_deadline(nodes, an->search.seconds);
    c.late = an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome == WF_CRITICAL_UNSEARCHED;
    if (!c.late && wf_nodes_tracked(an)) {
        s = wf_sloped_draw(an, &c.o, nodes, &scratch, e);
        if (s && s != WF_EINTERRUPTED && wf_nodes_late(nodes)) s = WF_OK, c.late = true;
    } else if (!c.late)
        s = draw(&c, an, &scratch, e);
    wf_arena_free(&scratch);
    if (s || !c.late) return s;
    an->sweep_n = an->n, an->sweep = an->at; /* no more than the speeds given */
    wf_diag_warn(d, "search-ended",
                 "%s: the time for the curves (%.4g s) is used up: curves join the given wind speeds alone",
                 an->species->name, an->search.seconds);
    return WF_OK;
}
