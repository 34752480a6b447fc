/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The curves of an analysis: totals by wind speed; declared in analysis.h. */
#include "base/num.h"
#include "base/parallel.h"
#include "data/species.h"
#include "fail/crossing.h"
#include "study/analysis.h"
#include "study/node.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Without slopes ---- */

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

/* Two nodes closer than this share of their speed would amplify their mesh errors. */
static const double node_gap = 0.02;

/* Add a node, unless it lies within node_gap of another; a row then replaces a node that is none. */
static void add_node(struct curve *c, const struct wf_at_speed *at, bool row)
{
    int k = 0;
    for (int i = 0; i < c->n; i++) {
        double other = c->node[i].at.speed;
        if (!row && fabs(other - at->speed) <= node_gap * fmax(other, at->speed)) return;
    }
    for (int i = 0; i < c->n; i++) {
        double other = c->node[i].at.speed;
        bool near = fabs(other - at->speed) <= node_gap * fmax(other, at->speed);
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

/* The row nearest to the middle between two nodes; -1: none between them. */
static int middle_row(const struct wf_analysis *an, double low, double high)
{
    double best = INFINITY, middle = low > 0.0 ? sqrt(low * high) : 0.5 * high;
    int row = -1;
    for (size_t k = 0; k < an->sweep_n; k++) {
        double speed = an->sweep[k].speed;
        if (speed > low && speed < high && fabs(speed - middle) < best)
            best = fabs(speed - middle), row = (int)k;
    }
    return row;
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
            int row = middle_row(c->an, c->node[i].at.speed, c->node[i + 1].at.speed);
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

/* ---- With slopes: totals between two solved wind speeds, from the values and slopes at both ---- */

/* A quantity between two speeds. */
struct span {
    double a, b, x; /* speeds [m/s] */
    double log_a, log_b, log_x;
};

struct ends {
    double y[2], slope[2];
    double rest; /* the value in still air; 0: unknown */
};

static struct span span_of(double a, double b, double x)
{
    struct span s = { .a = a, .b = b, .x = x };
    if (a > 0.0) s.log_a = log(a), s.log_b = log(b), s.log_x = log(x);
    return s;
}

/* Does what the wind adds to the value at rest follow a power of the speed at both ends? */
static bool powers(const struct span *s, const double added[2], const double slope[2], double power[2])
{
    const double least = 0.1, most = 8.0;
    power[0] = s->a * slope[0] / added[0], power[1] = s->b * slope[1] / added[1];
    for (int k = 0; k < 2; k++)
        if (!(power[k] > least && power[k] < most)) return false;
    return added[0] * added[1] > 0.0;
}

static double by_square(const struct span *s, const struct ends *q)
{
    return wf_crossing_cubic(s->a * s->a, s->b * s->b, q->y[0], q->y[1], q->slope[0] / (2.0 * s->a),
                             q->slope[1] / (2.0 * s->b), s->x * s->x);
}

/* The curve that is drawn. */
static double drawn(const struct span *s, const struct ends *q)
{
    const double *y = q->y, *d = q->slope, added[2] = { y[0] - q->rest, y[1] - q->rest };
    double power[2];
    if (!(s->a > 0.0)) {
        double to = s->b * d[1] / (y[1] - y[0]); /* not finite: the ends are equal */
        if (!(to > 0.0 && to < 8.0)) return wf_crossing_cubic(s->a, s->b, y[0], y[1], d[0], d[1], s->x);
        return y[0] + (y[1] - y[0]) * pow(s->x / s->b, to);
    }
    if (!powers(s, added, d, power)) return by_square(s, q);
    double size = wf_crossing_cubic(s->log_a, s->log_b, log(fabs(added[0])), log(fabs(added[1])), power[0],
                                    power[1], s->log_x);
    return q->rest + copysign(exp(size), added[0]);
}

/* The curve it is compared with. */
static double compared(const struct span *s, const struct ends *q)
{
    const double *y = q->y, *d = q->slope, added[2] = { y[0] - q->rest, y[1] - q->rest };
    double power[2];
    if (s->a > 0.0 && powers(s, added, d, power)) return by_square(s, q);
    return wf_crossing_cubic(s->a, s->b, y[0], y[1], d[0], d[1], s->x);
}

/* Nodes at both ends, and that in still air (NULL: unknown). */
struct between {
    const struct wf_tree *tree;
    const struct wf_node *low, *high, *still;
};

/* The largest of a column, by both curves: of the stress on all rows, else of those in a scope. Rows that
 * cannot reach the smaller of the values at the ends are passed over. */
static void largest(const struct between *n, size_t column, enum wf_scope scope, const struct span *s,
                    const double at_ends[2], double out[2])
{
    const struct wf_tree *t = n->tree;
    const double least = 0.8 * fmin(at_ends[0], at_ends[1]);
    const float *y0 = n->low->column[column].value, *y1 = n->high->column[column].value,
                *d0 = n->low->column[column].gain, *d1 = n->high->column[column].gain,
                *rest = n->still ? n->still->column[column].value : NULL;
    out[0] = out[1] = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double top = fmax((double)y0[i], (double)y1[i]);
        if (!(top > 0.0) || top + (s->b - s->a) * (fabs((double)d0[i]) + fabs((double)d1[i])) < least)
            continue;
        if (column != WF_NODE_STRESS && !wf_scope_holds(scope, t, i)) continue;
        struct ends q = { { (double)y0[i], (double)y1[i] },
                          { (double)d0[i], (double)d1[i] },
                          rest ? (double)rest[i] : 0.0 };
        out[0] = fmax(out[0], drawn(s, &q));
        out[1] = fmax(out[1], compared(s, &q));
    }
}

/* The moment on the ground, by both curves of its parts: of a tree that is blown upright it passes zero, near
 * which its size has a corner. */
static void moment_between(const struct between *n, const struct span *s, double out[2])
{
    const double *a = n->low->at.response.base_moment, *b = n->high->at.response.base_moment,
                 *rest = n->still ? n->still->at.response.base_moment : NULL;
    double part[2][2];
    for (int k = 0; k < 2; k++) {
        const struct ends q = { { a[k], b[k] },
                                { n->low->turning[k], n->high->turning[k] },
                                rest ? rest[k] : 0.0 };
        part[0][k] = drawn(s, &q), part[1][k] = compared(s, &q);
    }
    for (int k = 0; k < 2; k++) out[k] = hypot(part[k][0], part[k][1]);
}

/* What an error of a total is compared with: its value, but at least a thousandth of its largest value; a
 * fiftieth where it is the size of a vector that may vanish (a leaning tree is blown upright). */
static double yardstick(const double v[WF_TOTALS], const double size[WF_TOTALS], int k)
{
    bool vector = k == WF_TOTAL_DEFLECTION || k == WF_TOTAL_ANGLE || k == WF_TOTAL_MOMENT;
    double least = (vector ? 0.02 : 1e-3) * size[k];
    return fmax(fabs(v[k]), least);
}

/* Largest relative difference of two sets of totals. Given: size[WF_TOTALS], the largest value of each total
 * on the curve. What no curve is drawn of does not count: lift,
 * and criteria but the first. */
static double totals_apart(const double a[WF_TOTALS], const double b[WF_TOTALS], const double size[WF_TOTALS])
{
    double worst = 0.0;
    for (int k = 0; k < WF_TOTAL_UTILISATION + WF_SCOPES; k++) {
        if (k == WF_TOTAL_LIFT) continue;
        double off = fabs(b[k] - a[k]) / yardstick(a, size, k);
        if (isfinite(a[k]) && size[k] > 0.0) worst = fmax(worst, isfinite(off) ? off : INFINITY);
    }
    return worst;
}

/* Given: tree; two nodes with slopes, low below high; a speed between them [m/s]. Returned: v[WF_TOTALS]; and
 * other[WF_TOTALS], by a second curve with the same values and slopes: their difference bounds the error
 * where it is small. Method: what the wind adds to the value at rest is a cubic of logarithms of value and
 * speed where it follows a power of the speed at both ends, compared with a cubic of the speed's square;
 * where it does not, that cubic, compared with one of the speed. From speed 0 a power of the speed beside the
 * value there. Utilisation and largest stress are the largest of those of the rows, so that a curve may pass
 * from one governing row to another. */
static void totals_between(const struct between *n, double speed, double v[WF_TOTALS],
                           double other[WF_TOTALS])
{
    const struct wf_node *low = n->low, *high = n->high;
    const struct span s = span_of(low->at.speed, high->at.speed, speed);
    double ends[2][WF_TOTALS], rest[WF_TOTALS] = { 0 };
    wf_totals_read(&low->at, ends[0]);
    wf_totals_read(&high->at, ends[1]);
    if (n->still) wf_totals_read(&n->still->at, rest);
    for (int k = 0; k < WF_TOTALS; k++) {
        const struct ends q = { { ends[0][k], ends[1][k] }, { low->slope[k], high->slope[k] }, rest[k] };
        int part = k - WF_TOTAL_UTILISATION;
        double by[2] = { drawn(&s, &q), compared(&s, &q) };
        if (k == WF_TOTAL_MOMENT) moment_between(n, &s, by);
        if (isfinite(q.y[0]) && isfinite(q.y[1]) && k == WF_TOTAL_STRESS)
            largest(n, WF_NODE_STRESS, WF_SCOPE_TREE, &s, q.y, by);
        else if (isfinite(q.y[0]) && isfinite(q.y[1]) && part >= 0)
            largest(n, (size_t)(part / WF_SCOPES), (enum wf_scope)(part % WF_SCOPES), &s, q.y, by);
        v[k] = by[0], other[k] = by[1];
    }
}

/* ---- With slopes: the curves ---- */

/* Nodes with slopes, or without an equilibrium, in the order of their speeds. */
struct sloped {
    const struct wf_analysis *an;
    struct wf_nodes *nodes;
    size_t n;
    const struct wf_node *node[WF_NODES_MAX];
    double size[WF_TOTALS];
};

static int compare_nodes(const void *a, const void *b)
{
    const struct wf_node *x = *(const struct wf_node *const *)a, *y = *(const struct wf_node *const *)b;
    if (x->at.speed != y->at.speed) return x->at.speed < y->at.speed ? -1 : 1;
    return (x->tolerance > y->tolerance) - (x->tolerance < y->tolerance);
}

/* All nodes that are there; of two that are close, that of the finer mesh. */
static void order_nodes(struct sloped *c)
{
    size_t all = wf_nodes_count(c->nodes), n = 0;
    c->n = 0;
    for (size_t k = 0; k < all; k++) {
        const struct wf_node *node = wf_nodes_at(c->nodes, k);
        if (node->sloped || node->at.status) c->node[n++] = node;
    }
    qsort(c->node, n, sizeof(c->node[0]), compare_nodes);
    for (size_t k = 0; k < n; k++) {
        const struct wf_node *node = c->node[k], *last = c->n ? c->node[c->n - 1] : NULL;
        bool close = last && node->at.speed - last->at.speed <= node_gap * node->at.speed;
        if (close && node->tolerance >= last->tolerance) continue;
        c->node[close ? c->n - 1 : c->n++] = node;
    }
    for (size_t k = 0; k < c->n; k++) {
        double v[WF_TOTALS];
        wf_totals_read(&c->node[k]->at, v);
        for (int q = 0; q < WF_TOTALS && !c->node[k]->at.status; q++)
            if (isfinite(v[q])) c->size[q] = fmax(c->size[q], fabs(v[q]));
    }
}

static struct between between(const struct sloped *c, size_t low, size_t high)
{
    bool still = c->node[0]->at.speed == 0.0 && !c->node[0]->at.status;
    return (struct between){ &c->an->tree, c->node[low], c->node[high], still ? c->node[0] : NULL };
}

static bool positive(const struct sloped *c, size_t i)
{
    return i < c->n && !c->node[i]->at.status && c->node[i]->at.speed > 0.0;
}

/* Largest error between node i and the next, from how well the nodes beside node k (one of the two) predict
 * it. Where laws have corners (streamlining begins at a speed), the error of a cubic by values and slopes
 * falls with the distance of its ends alone. NAN: k has no nodes beside it. */
static double error_by_node(const struct sloped *c, size_t i, size_t k)
{
    double v[WF_TOTALS], other[WF_TOTALS], at[WF_TOTALS];
    if (k == 0 || !positive(c, k - 1) || !positive(c, k) || !positive(c, k + 1)) return NAN;
    double low = log(c->node[k - 1]->at.speed), middle = log(c->node[k]->at.speed),
           high = log(c->node[k + 1]->at.speed), wide = log(c->node[i + 1]->at.speed / c->node[i]->at.speed);
    const struct between n = between(c, k - 1, k + 1);
    totals_between(&n, c->node[k]->at.speed, v, other);
    wf_totals_read(&c->node[k]->at, at);
    return totals_apart(at, v, c->size) * wide * (high - low) / (4.0 * (middle - low) * (high - middle));
}

/* Is the curve between node i and the next known? Both estimates are larger than the error. */
static bool drawn_between(const struct sloped *c, size_t i)
{
    const double enough = 3e-3, apart_most = 2e-2;
    const struct wf_node *low = c->node[i], *high = c->node[i + 1];
    const struct between n = between(c, i, i + 1);
    double v[WF_TOTALS], other[WF_TOTALS];
    if (low->at.status || high->at.status) return low->at.status && high->at.status;
    if (low->at.speed > 0.0 && !(fmax(error_by_node(c, i, i), error_by_node(c, i, i + 1)) <= enough))
        return false;
    for (int k = 1; k < 4; k++) {
        double speed = low->at.speed + 0.25 * k * (high->at.speed - low->at.speed);
        totals_between(&n, speed, v, other);
        if (!(totals_apart(v, other, c->size) <= apart_most)) return false;
    }
    return true;
}

/* A speed between two nodes at which the state of the stem, or of the branches, is known, not near either:
 * half a solution makes it a node. Else that of the row. */
static double half_solved(const struct sloped *c, const struct wf_solve_options *o, size_t i, double row)
{
    const double margin = 0.25;
    double low = c->node[i]->at.speed, high = c->node[i + 1]->at.speed;
    for (size_t k = 0; k < wf_nodes_count(c->nodes) && low > 0.0; k++) {
        const struct wf_node *node = wf_nodes_at(c->nodes, k);
        double place = log(node->at.speed / low) / log(high / low);
        if (!node->whole && !node->at.status && node->tolerance == o->mesh_tolerance && place >= margin &&
            place <= 1.0 - margin)
            return node->at.speed;
    }
    return row;
}

/* Solve the first two rows and the last, then rows in the middle of what is not known, from the lowest speed
 * up. */
static enum wf_status refine_sloped(struct sloped *c, const struct wf_solve_options *o, struct wf_err *e)
{
    const struct wf_analysis *an = c->an;
    const struct wf_node *node;
    double pick[WF_NODES_MAX] = { an->sweep[0].speed, an->sweep[1].speed, an->sweep[an->sweep_n - 1].speed };
    size_t picked = 3;
    order_nodes(c);
    if (c->n && c->node[c->n - 1]->at.speed >= pick[2]) picked = 2;
    for (;;) {
        for (size_t k = 0; k < picked; k++) {
            enum wf_status s = wf_nodes_solve(c->nodes, o, pick[k], &node, e);
            if (s) return s;
        }
        order_nodes(c);
        picked = 0;
        for (size_t i = 0; i + 1 < c->n; i++) {
            int row = middle_row(an, c->node[i]->at.speed, c->node[i + 1]->at.speed);
            /* a row that was solved and left out, because another node is close, brings nothing new */
            if (row >= 0 && !drawn_between(c, i) &&
                !wf_nodes_find(c->nodes, an->sweep[row].speed, o->mesh_tolerance))
                pick[picked++] = half_solved(c, o, i, an->sweep[row].speed);
        }
        if (!picked) return WF_OK;
    }
}

static void fill_sloped(const struct sloped *c, struct wf_at_speed *row)
{
    size_t i = 0;
    double speed = row->speed, v[WF_TOTALS], other[WF_TOTALS];
    while (i + 1 < c->n && c->node[i + 1]->at.speed <= speed) i++;
    *row = c->node[i]->at;
    if (row->speed == speed) return;
    row->speed = speed;
    row->interpolated = true;
    if (row->status) return;
    if (i + 1 == c->n) { /* the last row, which was left out, because this node is close below it */
        const struct wf_node *last = c->node[i];
        wf_totals_read(&last->at, v);
        for (int q = 0; q < WF_TOTALS; q++) v[q] += (speed - last->at.speed) * last->slope[q];
        wf_totals_write(v, c->an->tallness, row);
        return;
    }
    const struct between n = between(c, i, i + 1);
    totals_between(&n, speed, v, other);
    wf_totals_write(v, c->an->tallness, row);
}

static enum wf_status draw_sloped(struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_nodes *nodes, struct wf_arena *scratch, struct wf_err *e)
{
    struct sloped *c = WF_TAKE(scratch, 1, struct sloped);
    if (!c) return wf_fail(e, WF_ENOMEM, "not enough memory for the curves");
    c->an = an;
    c->nodes = nodes;
    enum wf_status s = refine_sloped(c, o, e);
    for (size_t k = 0; k < an->sweep_n && !s; k++) {
        fill_sloped(c, &an->sweep[k]);
        for (size_t j = 0; j < an->n; j++)
            if (an->at[j].speed == an->sweep[k].speed) an->sweep[k] = an->at[j];
    }
    return s;
}

/* ---- Both ---- */

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
        s = draw_sloped(an, &c.o, nodes, &scratch, e);
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
