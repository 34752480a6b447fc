/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fail/crossing.h"
#include "fail/fail.h"
#include <math.h>

double wf_crossing_cubic(double a, double b, double ya, double yb, double da, double db, double x)
{
    double h = b - a, u = (x - a) / h, rise = yb - ya, first = h * da, last = h * db;
    return ya + u * (first + u * ((3 * rise - 2 * first - last) + u * (first + last - 2 * rise)));
}

/* ---- One utilisation in an interval ---- */

struct piece {
    double a, b, ya, yb, da, db;
};

static struct piece piece_of(const struct wf_crossing_node *low, const struct wf_crossing_node *high,
                             size_t i)
{
    return (struct piece){ low->speed,     high->speed,   low->value[i],
                           high->value[i], low->slope[i], high->slope[i] };
}

static double cubic(const struct piece *p, double x)
{
    return wf_crossing_cubic(p->a, p->b, p->ya, p->yb, p->da, p->db, x);
}

/* Power of the speed between speed 0 and b. */
static double power(const struct piece *p) { return p->b * p->db / (p->yb - p->ya); }

/* The second curve through the same values and slopes. */
static double second(const struct piece *p, double x)
{
    if (p->a > 0)
        return wf_crossing_cubic(p->a * p->a, p->b * p->b, p->ya, p->yb, p->da / (2 * p->a),
                                 p->db / (2 * p->b), x * x);
    return p->ya + (p->yb - p->ya) * pow(x / p->b, fmin(fmax(power(p), 0.25), 6));
}

/* Do the slopes at both ends agree with the mean slope, all by the square of the speed, within a factor 5? */
static bool even(const struct piece *p)
{
    const double factor = 5;
    double mean = (p->yb - p->ya) / (p->b * p->b - p->a * p->a), end[2] = { mean, p->db / (2 * p->b) };
    if (p->a > 0) end[0] = p->da / (2 * p->a);
    for (int k = 0; k < 2; k++)
        if (!(end[k] * mean > 0 && fabs(end[k]) <= factor * fabs(mean) &&
              fabs(mean) <= factor * fabs(end[k])))
            return false;
    return true;
}

/* A bound of both curves from their ends, without sampling them. */
static double bound(const struct piece *p)
{
    return fmax(p->ya, p->yb) + (p->b - p->a) * (fabs(p->da) + fabs(p->db)) * 4 / 27;
}

enum { SAMPLES = 16 };

static double sample(const struct piece *p, int k) { return p->a + (p->b - p->a) * k / SAMPLES; }

/* Is the utilisation below 1 at speeds up to `end`? */
static bool stays_below(const struct piece *p, double end, double trusted)
{
    const double low = 0.4;     /* changes of a small utilisation do not matter */
    const double slight = 0.05; /* so little the slopes can add */
    const double wide = 12.5;   /* [m/s], over which a part might rise and fall again unseen */
    double most = 0;
    if (bound(p) < low) return true;
    if (p->b - p->a > wide) return false;
    for (int k = 1; k < SAMPLES && sample(p, k) < end; k++) {
        double y = cubic(p, sample(p, k)), other = second(p, sample(p, k));
        y = fmax(y, other) + 3 * fabs(y - other);
        if (!(y < 1)) return false;
        most = fmax(most, y);
    }
    if (most < low) return true;
    return most < trusted && (even(p) || bound(p) - fmax(p->ya, p->yb) < slight);
}

/* Lowest speed at which the cubic reaches 1, INFINITY: none. */
static double cubic_crossing(const struct piece *p)
{
    double below = p->a;
    for (int k = 1; k <= SAMPLES; k++) {
        double above = k < SAMPLES ? sample(p, k) : p->b;
        if (!((k < SAMPLES ? cubic(p, above) : p->yb) >= 1)) {
            below = above;
            continue;
        }
        for (int step = 0; step < 50; step++) {
            double middle = 0.5 * (below + above);
            if (cubic(p, middle) >= 1)
                above = middle;
            else
                below = middle;
        }
        return 0.5 * (below + above);
    }
    return INFINITY;
}

/* Where a power of the speed from speed 0 through the value and slope at `at` reaches 1. */
static double power_crossing(const struct piece *p)
{
    if (!(p->db > 0 && p->yb > p->ya)) return INFINITY;
    return p->b * pow((1 - p->ya) / (p->yb - p->ya), 1 / fmin(fmax(power(p), 0.5), 4));
}

/* ---- All of them ---- */

struct task {
    const struct wf_crossing_node *node;
    size_t n;
    const size_t *item;
    size_t items;
    double speed_max, tolerance;
};

static size_t governing(const struct task *q, size_t k)
{
    size_t worst = q->item[0];
    for (size_t i = 0; i < q->items; i++)
        if (q->node[k].value[q->item[i]] > q->node[k].value[worst]) worst = q->item[i];
    return worst;
}

static bool stands(const struct task *q, size_t k)
{
    return q->node[k].solved && q->node[k].value[governing(q, k)] < 1;
}

/* The step of wf_critical_rung nearest to the middle of an interval; NAN where none is inside. */
static double middle_rung(const struct task *q, double a, double b)
{
    double best = NAN;
    for (int k = 1, rungs = wf_critical_rungs(q->speed_max); k <= rungs; k++) {
        double at = wf_critical_rung(q->speed_max, k);
        if (at <= a || at >= b) continue;
        if (!(fabs(at - 0.5 * (a + b)) >= fabs(best - 0.5 * (a + b)))) best = at;
    }
    return best;
}

/* Is no crossing between node k and the next, up to the speed `end`? */
static bool clear(const struct task *q, size_t k, double end)
{
    const struct wf_crossing_node *low = &q->node[k], *high = low + 1;
    double trusted = fmin(low->trusted, high->trusted);
    for (size_t i = 0; i < q->items; i++) {
        struct piece p = piece_of(low, high, q->item[i]);
        if (!stays_below(&p, end, trusted)) return false;
    }
    return true;
}

/* Distance from a node to the crossing by the slope there. */
static bool near_crossing(const struct task *q, size_t k, struct wf_crossing *out)
{
    size_t i = governing(q, k);
    double slope = q->node[k].slope[i], step = (1 - q->node[k].value[i]) / slope;
    if (!(slope > 0 && fabs(step) <= q->tolerance * q->node[k].speed)) return false;
    out->speed = q->node[k].speed + step;
    out->gradient = slope;
    return true;
}

/* Between node k, where all stand, and the next, where one fails. */
static enum wf_crossing_next between(const struct task *q, size_t k, struct wf_crossing *out)
{
    const struct wf_crossing_node *low = &q->node[k], *high = low + 1;
    double rung = middle_rung(q, low->speed, high->speed), first = INFINITY;
    out->low = low->speed, out->high = high->speed;
    bool near = near_crossing(q, k + 1, out) || near_crossing(q, k, out);
    if (near && out->speed > low->speed && (isnan(rung) || clear(q, k, out->speed))) return WF_CROSSING_FOUND;
    if (high->speed - low->speed <= q->tolerance * high->speed) return WF_CROSSING_LOST;
    for (size_t i = 0; i < q->items; i++) {
        struct piece p = piece_of(low, high, q->item[i]);
        if (bound(&p) >= 1) first = fmin(first, cubic_crossing(&p));
    }
    out->speed = near || !(first > low->speed && first < high->speed) ? rung : first;
    if (isnan(out->speed)) out->speed = 0.5 * (low->speed + high->speed);
    return WF_CROSSING_SOLVE;
}

/* Beyond the last node, where all stand. */
static enum wf_crossing_next beyond(const struct task *q, struct wf_crossing *out)
{
    const double most = 2, first = 12.5; /* times the last speed; [m/s] */
    const struct wf_crossing_node *still = &q->node[0], *last = &q->node[q->n - 1];
    double next = q->speed_max;
    out->low = last->speed, out->high = q->speed_max;
    if (last->speed >= q->speed_max) return WF_CROSSING_ABOVE;
    if (near_crossing(q, q->n - 1, out)) {
        if (out->speed > q->speed_max) return WF_CROSSING_ABOVE;
        out->high = out->speed;
        return WF_CROSSING_FOUND;
    }
    for (size_t i = 0; i < q->items && last > still; i++) {
        struct piece p = piece_of(still, last, q->item[i]);
        next = fmin(next, power_crossing(&p));
    }
    next = fmin(next, last > still ? most * last->speed : first);
    out->speed = fmin(fmax(next, last->speed * (1 + 0.5 * q->tolerance)), q->speed_max);
    return WF_CROSSING_SOLVE;
}

enum wf_crossing_next wf_crossing_step(const struct wf_crossing_node *node, size_t n, const size_t *item,
                                       size_t items, double speed_max, double tolerance,
                                       struct wf_crossing *out)
{
    const struct task q = { node, n, item, items, speed_max, tolerance };
    *out = (struct wf_crossing){ .speed = 0, .high = speed_max, .gradient = NAN };
    if (n == 0 || node[0].speed > 0) return WF_CROSSING_SOLVE;
    if (items == 0 || !stands(&q, 0)) return WF_CROSSING_LOST;
    for (size_t k = 0; k + 1 < n; k++) {
        if (!node[k + 1].solved) return WF_CROSSING_LOST;
        if (!stands(&q, k + 1)) return between(&q, k, out);
        double rung = middle_rung(&q, node[k].speed, node[k + 1].speed);
        if (isnan(rung) || clear(&q, k, node[k + 1].speed)) continue;
        out->speed = rung;
        return WF_CROSSING_SOLVE;
    }
    return beyond(&q, out);
}
