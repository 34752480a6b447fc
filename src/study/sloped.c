/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/sloped.h"
#include "data/species.h"
#include "fail/crossing.h"
#include "study/peak.h"
#include <math.h>
#include <stdlib.h>

int wf_sloped_middle(const struct wf_analysis *an, double low, double high)
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

/* ---- Totals between two solved wind speeds ---- */

/* A quantity between two speeds. */
struct span {
    double a, b, x; /* speeds whose squares grow with the load (pace_of) [m/s] */
    double log_a, log_b, log_x;
    double per[2]; /* d (named speed) / d (such a speed) at both ends */
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

/* The speed at which a part of the tree is taken: its square grows with the peak load, gusts included, whose
 * factor is known at every speed and may have corners (limits of the damping). */
struct pace {
    double speed, per; /* named speed times the root of the factor; d (named speed) / d speed */
};

static struct pace pace_of(const struct wf_analysis *an, enum wf_node_part part, double speed)
{
    const enum wf_part of = part == WF_NODE_STEM ? WF_PART_STEM : WF_PART_BRANCHES;
    const double share = 1e-6;
    struct pace out = { speed, 1.0 };
    if (!an->peak || an->peak->method->mean || !(speed > 0.0)) return out;
    double at = wf_peak_factor(an->peak, speed, of), next = speed * (1.0 + share);
    if (!(at > 0.0)) return out;
    out.speed = speed * sqrt(at);
    out.per = (next - speed) / (next * sqrt(wf_peak_factor(an->peak, next, of)) - out.speed);
    return out;
}

/* Nodes of one part of the tree at both ends, and that in still air (NULL: unknown). */
struct between {
    const struct wf_analysis *an;
    enum wf_node_part part;
    const struct wf_node *low, *high, *still;
    struct pace end[2];
};

static struct span span_at(const struct between *n, double speed)
{
    struct span s = span_of(n->end[0].speed, n->end[1].speed, pace_of(n->an, n->part, speed).speed);
    s.per[0] = n->end[0].per, s.per[1] = n->end[1].per;
    if (s.a < s.x && s.x < s.b && s.per[0] > 0.0 && s.per[1] > 0.0) return s;
    s = span_of(n->low->at.speed, n->high->at.speed, speed);
    s.per[0] = s.per[1] = 1.0;
    return s;
}

/* The largest of a column in the part, by both curves: of the stress on all its rows, else of those in a
 * scope. Rows that cannot reach the smaller of the values at the ends are passed over. */
static void largest(const struct between *n, size_t column, enum wf_scope scope, const struct span *s,
                    const double at_ends[2], double out[2])
{
    const struct wf_tree *t = &n->an->tree;
    const double least = 0.8 * fmin(at_ends[0], at_ends[1]);
    const float *y0 = n->low->column[column].value, *y1 = n->high->column[column].value,
                *d0 = n->low->column[column].gain, *d1 = n->high->column[column].gain,
                *rest = n->still ? n->still->column[column].value : NULL;
    out[0] = out[1] = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double top = fmax((double)y0[i], (double)y1[i]);
        double turns = s->per[0] * fabs((double)d0[i]) + s->per[1] * fabs((double)d1[i]);
        if (!(top > 0.0) || top + (s->b - s->a) * turns < least) continue;
        if (!wf_node_part_holds(n->an, n->part, i)) continue;
        if (column != WF_NODE_STRESS && !wf_scope_holds(scope, t, i)) continue;
        struct ends q = { { (double)y0[i], (double)y1[i] },
                          { (double)d0[i] * s->per[0], (double)d1[i] * s->per[1] },
                          rest ? (double)rest[i] : 0.0 };
        out[0] = fmax(out[0], drawn(s, &q));
        out[1] = fmax(out[1], compared(s, &q));
    }
}

/* The moment on the ground, by both curves of its parts: of a tree that is blown upright it passes zero, near
 * which its size has a corner. */
static void moment_between(const struct between *n, const struct span *s, double out[2])
{
    const double *a = n->low->state[n->part].at.response.base_moment,
                 *b = n->high->state[n->part].at.response.base_moment,
                 *rest = n->still ? n->still->state[n->part].at.response.base_moment : NULL;
    double part[2][2];
    for (int k = 0; k < 2; k++) {
        const struct ends q = { { a[k], b[k] },
                                { n->low->turning[k] * s->per[0], n->high->turning[k] * s->per[1] },
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

/* The totals that curves are drawn of, without lift: the first ones, with one criterion. */
enum { DRAWN = WF_TOTAL_UTILISATION + WF_SCOPES };

/* Largest relative difference of two sets of totals. Given: size[WF_TOTALS], the largest value of each total
 * on the curve. What no curve is drawn of does not count. */
static double totals_apart(const double a[WF_TOTALS], const double b[WF_TOTALS], const double size[WF_TOTALS])
{
    double worst = 0.0;
    for (int k = 0; k < DRAWN; k++) {
        if (k == WF_TOTAL_LIFT) continue;
        double off = fabs(b[k] - a[k]) / yardstick(a, size, k);
        if (isfinite(a[k]) && size[k] > 0.0) worst = fmax(worst, isfinite(off) ? off : INFINITY);
    }
    return worst;
}

/* The totals of one part at a node; NAN: those that are not its own. The largest of both parts are those of
 * the tree. */
static void read_part(const struct wf_analysis *an, enum wf_node_part part, const struct wf_node *node,
                      double v[WF_TOTALS])
{
    wf_totals_read(&node->state[part].at, v);
    if (!wf_peak_branches(an->peak)) return;
    for (int k = 0; k < WF_TOTAL_STRESS && part == WF_NODE_BRANCHES; k++) v[k] = NAN;
    for (int k = WF_TOTAL_UTILISATION; k < WF_TOTALS; k++) {
        int scope = (k - WF_TOTAL_UTILISATION) % WF_SCOPES;
        if (scope != (part == WF_NODE_STEM ? WF_SCOPE_STEM : WF_SCOPE_BRANCHES)) v[k] = NAN;
    }
}

/* Given: two nodes of a part, with slopes, low below high; a speed between them [m/s]. Returned: the first
 * `most` of v[WF_TOTALS]; and of other[WF_TOTALS], by a second curve with the same values and slopes: their
 * difference bounds the error where it is small. Method: what the wind adds to the value at rest is a cubic
 * of logarithms of value and speed where it follows a power of the speed at both ends, compared with a cubic
 * of the speed's square; where it does not, that cubic, compared with one of the speed. From speed 0 a power
 * of the speed beside the value there. Utilisation and largest stress are the largest of those of the rows,
 * so that a curve may pass from one governing row to another. */
static void totals_between(const struct between *n, double speed, int most, double v[WF_TOTALS],
                           double other[WF_TOTALS])
{
    const struct wf_node *low = n->low, *high = n->high;
    const struct span s = span_at(n, speed);
    double ends[2][WF_TOTALS], rest[WF_TOTALS] = { 0 };
    read_part(n->an, n->part, low, ends[0]);
    read_part(n->an, n->part, high, ends[1]);
    if (n->still) read_part(n->an, n->part, n->still, rest);
    for (int k = 0; k < most; k++) {
        const struct ends q = { { ends[0][k], ends[1][k] },
                                { low->slope[k] * s.per[0], high->slope[k] * s.per[1] },
                                rest[k] };
        int part = k - WF_TOTAL_UTILISATION;
        double by[2] = { NAN, NAN };
        if (isfinite(q.y[0]) && isfinite(q.y[1])) {
            if (k == WF_TOTAL_STRESS)
                largest(n, WF_NODE_STRESS, WF_SCOPE_TREE, &s, q.y, by);
            else if (part >= 0)
                largest(n, (size_t)(part / WF_SCOPES), (enum wf_scope)(part % WF_SCOPES), &s, q.y, by);
            else if (k == WF_TOTAL_MOMENT)
                moment_between(n, &s, by);
            else
                by[0] = drawn(&s, &q), by[1] = compared(&s, &q);
        }
        v[k] = by[0], other[k] = by[1];
    }
}

/* ---- The curves ---- */

/* Nodes at which one part of the tree is known with slopes, or has no equilibrium, in the order of their
 * speeds. */
struct sloped {
    const struct wf_analysis *an;
    struct wf_nodes *nodes;
    enum wf_node_part part;
    size_t n;
    const struct wf_node *node[WF_NODES_MAX];
    struct pace pace[WF_NODES_MAX];
    double size[WF_TOTALS];
};

static int compare_nodes(const void *a, const void *b)
{
    const struct wf_node *x = *(const struct wf_node *const *)a, *y = *(const struct wf_node *const *)b;
    if (x->at.speed != y->at.speed) return x->at.speed < y->at.speed ? -1 : 1;
    return (x->tolerance > y->tolerance) - (x->tolerance < y->tolerance);
}

static const struct wf_node_state *state_at(const struct sloped *c, size_t i)
{
    return &c->node[i]->state[c->part];
}

/* All nodes that were asked for (how many were not depends on the number of threads); of two that are close,
 * that of the finer mesh. */
static void order_nodes(struct sloped *c)
{
    size_t all = wf_nodes_count(c->nodes), n = 0;
    c->n = 0;
    for (size_t k = 0; k < all; k++) {
        const struct wf_node *node = wf_nodes_at(c->nodes, k);
        const struct wf_node_state *s = &node->state[c->part];
        if (node->used && s->known && (s->sloped || s->at.status)) c->node[n++] = node;
    }
    qsort(c->node, n, sizeof(c->node[0]), compare_nodes);
    for (size_t k = 0; k < n; k++) {
        const struct wf_node *node = c->node[k], *last = c->n ? c->node[c->n - 1] : NULL;
        bool close = last && node->at.speed - last->at.speed <= WF_CURVE_GAP * node->at.speed;
        if (close && node->tolerance >= last->tolerance) continue;
        c->node[close ? c->n - 1 : c->n++] = node;
    }
    for (size_t k = 0; k < c->n; k++) {
        double v[WF_TOTALS];
        c->pace[k] = pace_of(c->an, c->part, c->node[k]->at.speed);
        read_part(c->an, c->part, c->node[k], v);
        for (int q = 0; q < WF_TOTALS && !state_at(c, k)->at.status; q++)
            if (isfinite(v[q])) c->size[q] = fmax(c->size[q], fabs(v[q]));
    }
}

static struct between between(const struct sloped *c, size_t low, size_t high)
{
    bool still = c->node[0]->at.speed == 0.0 && !state_at(c, 0)->at.status;
    return (struct between){ c->an,
                             c->part,
                             c->node[low],
                             c->node[high],
                             still ? c->node[0] : NULL,
                             { c->pace[low], c->pace[high] } };
}

static bool positive(const struct sloped *c, size_t i)
{
    return i < c->n && !state_at(c, i)->at.status && c->node[i]->at.speed > 0.0;
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
    totals_between(&n, c->node[k]->at.speed, DRAWN, v, other);
    read_part(c->an, c->part, c->node[k], at);
    return totals_apart(at, v, c->size) * wide * (high - low) / (4.0 * (middle - low) * (high - middle));
}

/* Is the curve between node i and the next known? Both estimates are larger than the error. */
static bool drawn_between(const struct sloped *c, size_t i)
{
    const double enough = 2.5e-3, apart_most = 2e-2;
    const struct wf_node *low = c->node[i], *high = c->node[i + 1];
    const bool lost = state_at(c, i)->at.status, lost_above = state_at(c, i + 1)->at.status;
    const struct between n = between(c, i, i + 1);
    double v[WF_TOTALS], other[WF_TOTALS];
    if (lost || lost_above) return lost && lost_above;
    if (low->at.speed > 0.0 && !(fmax(error_by_node(c, i, i), error_by_node(c, i, i + 1)) <= enough))
        return false;
    for (int k = 1; k < 4; k++) {
        double speed = low->at.speed + 0.25 * k * (high->at.speed - low->at.speed);
        totals_between(&n, speed, DRAWN, v, other);
        if (!(totals_apart(v, other, c->size) <= apart_most)) return false;
    }
    return true;
}

/* Solve the first two rows and the last, up to where the stem has no equilibrium, then rows in the middle of
 * what is not known, from the lowest speed up. */
static enum wf_status refine_sloped(struct sloped *c, const struct wf_solve_options *o, double lost,
                                    struct wf_err *e)
{
    const struct wf_analysis *an = c->an;
    const struct wf_node *node;
    double pick[WF_NODES_MAX] = { an->sweep[0].speed, an->sweep[1].speed, an->sweep[an->sweep_n - 1].speed };
    size_t picked = 3;
    order_nodes(c);
    if (pick[2] >= lost || (c->n && c->node[c->n - 1]->at.speed >= pick[2])) picked = 2;
    for (;;) {
        for (size_t k = 0; k < picked; k++) {
            enum wf_status s = wf_nodes_solve_part(c->nodes, o, pick[k], c->part, &node, e);
            if (s) return s;
        }
        order_nodes(c);
        picked = 0;
        for (size_t i = 0; i + 1 < c->n; i++) {
            int row = wf_sloped_middle(an, c->node[i]->at.speed, c->node[i + 1]->at.speed);
            if (row < 0 || an->sweep[row].speed >= lost || drawn_between(c, i)) continue;
            /* a row that was solved and left out, because another node is close, brings nothing new */
            node = wf_nodes_find(c->nodes, an->sweep[row].speed, o->mesh_tolerance);
            if (!node || !node->used || !node->state[c->part].known) pick[picked++] = an->sweep[row].speed;
        }
        if (!picked) return WF_OK;
    }
}

/* The lowest speed at which a part was found to have no equilibrium; INFINITY: none. */
static double lost_at(const struct sloped *c)
{
    for (size_t i = 0; i < c->n; i++)
        if (state_at(c, i)->at.status) return c->node[i]->at.speed;
    return INFINITY;
}

static size_t node_below(const struct sloped *c, double speed)
{
    size_t i = 0;
    while (i + 1 < c->n && c->node[i + 1]->at.speed <= speed) i++;
    return i;
}

/* The totals of a part at a speed. Returned: its status there. */
static enum wf_status totals_of(const struct sloped *c, double speed, double v[WF_TOTALS])
{
    const size_t i = node_below(c, speed);
    const struct wf_node *low = c->node[i];
    double other[WF_TOTALS];
    if (state_at(c, i)->at.status) return state_at(c, i)->at.status;
    if (low->at.speed < speed && positive(c, i + 1)) {
        const struct between n = between(c, i, i + 1);
        totals_between(&n, speed, WF_TOTALS, v, other);
        return WF_OK;
    }
    /* a row that was left out, because this node is close below it */
    read_part(c->an, c->part, low, v);
    for (int q = 0; q < WF_TOTALS && low->at.speed < speed; q++)
        if (isfinite(low->slope[q])) v[q] += (speed - low->at.speed) * low->slope[q];
    return WF_OK;
}

/* A row from its stem and its branches. */
static void fill_sloped(const struct sloped *part, size_t parts, struct wf_at_speed *row)
{
    const double speed = row->speed;
    const struct wf_node *below = part[0].node[node_below(&part[0], speed)];
    double v[WF_TOTALS], branches[WF_TOTALS];
    *row = below->at;
    if (row->speed == speed && (below->whole || row->status)) return;
    row->speed = speed;
    row->interpolated = true;
    row->status = totals_of(&part[0], speed, v);
    if (!row->status && parts > 1) row->status = totals_of(&part[1], speed, branches);
    if (row->status) return;
    for (int k = WF_TOTAL_STRESS; k < WF_TOTALS && parts > 1; k++) v[k] = fmax(v[k], branches[k]);
    for (int c = 0; c < WF_CRITERIA && parts > 1; c++) {
        double *use = v + WF_TOTAL_UTILISATION + c * WF_SCOPES;
        use[WF_SCOPE_TREE] = fmax(use[WF_SCOPE_STEM], use[WF_SCOPE_BRANCHES]);
    }
    wf_totals_write(v, part[0].an->tallness, row);
}

enum wf_status wf_sloped_draw(struct wf_analysis *an, const struct wf_solve_options *o,
                              struct wf_nodes *nodes, struct wf_arena *scratch, struct wf_err *e)
{
    const size_t parts = wf_peak_branches(an->peak) ? WF_NODE_PARTS : 1;
    struct sloped *part = WF_TAKE(scratch, parts, struct sloped);
    double lost = INFINITY;
    enum wf_status s = part ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the curves");
    for (size_t p = 0; p < parts && !s; p++) {
        part[p].an = an, part[p].nodes = nodes, part[p].part = (enum wf_node_part)p;
        s = refine_sloped(&part[p], o, lost, e);
        lost = fmin(lost, lost_at(&part[p]));
    }
    for (size_t k = 0; k < an->sweep_n && !s; k++) {
        fill_sloped(part, parts, &an->sweep[k]);
        for (size_t j = 0; j < an->n; j++)
            if (an->at[j].speed == an->sweep[k].speed) an->sweep[k] = an->at[j];
    }
    return s;
}
