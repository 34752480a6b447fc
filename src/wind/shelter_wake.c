/* The law "wake": drag takes momentum out of the wind, and the gap it leaves spreads and fills.
 *
 * Momentum. A slab's drag area per area of a cell is k = Cd_wood (-ln(1 - wood)) + Cd_crown tau: for sparse
 * parts their own drag area, for dense ones what parts standing behind each other at random amount to. The
 * air of a cell loses speed by rho u du = -1/2 rho u^2 dk, so without a limit it leaves with exp(-k/2) of its
 * speed. A cell that is covered altogether still lets T through, hence the share
 *     t = T + (1 - T) exp(-k / (2 (1 - T))),   1 - k/2 for sparse cells, T for full ones.
 *
 * Recovery. The loss made in a slab, u (1 - t) of the undisturbed speed, is carried along the wind and spread
 * to both sides by turbulence as a Gaussian of standard deviation (growth x distance): the sum of the loss
 * over the cross-section stays (momentum), its peak falls. Behind a crown of radius R the loss has halved
 * where growth x distance is about R. Losses of all slabs add up, each made from the wind that arrives at its
 * slab. The ground reflects. Source: Bastankhah & Porte-Agel (2014); superposition Niayifar & Porte-Agel
 * (2016), who give the growth 0.38 I + 0.004 for a turbulence intensity I.
 *
 * To save work, losses of old slabs that have nearly the same distance are spread together. */
#include "wind/shelter_parts.h"
#include <math.h>
#include <string.h>

enum { TAPS = 512 };

/* Losses of one or several slabs. */
struct source {
    double *loss; /* up*across */
    double place; /* slab, mean weighted by loss */
    double total;
    size_t row[2], column[2]; /* cells outside are zero: first, one behind the last */
};

/* Shares of a cell's loss that come to lie 0, 1, 2... cells away; returned: how many. */
static size_t kernel(double sigma, double tap[TAPS])
{
    size_t n = (size_t)ceil(3.0 * sigma + 0.5);
    double sum = 0.0;
    if (n >= TAPS) n = TAPS - 1;
    for (size_t i = 0; i <= n; i++) {
        double a = ((double)i - 0.5) / (sigma * sqrt(2.0)), b = ((double)i + 0.5) / (sigma * sqrt(2.0));
        tap[i] = 0.5 * (erf(b) - erf(a));
        sum += i ? 2.0 * tap[i] : tap[i];
    }
    for (size_t i = 0; i <= n; i++) tap[i] /= sum;
    return n + 1;
}

static void add_row(double *restrict out, const double *restrict in, double factor, size_t n)
{
    for (size_t i = 0; i < n; i++) out[i] += factor * in[i];
}

/* Add one source, spread by sigma [m], to a plane; `work` is a plane. */
static void spread(const struct wf_shelter *s, const struct source *from, double sigma, double *work,
                   double *plane)
{
    double tap[TAPS];
    long across = (long)s->across, up = (long)s->up;
    long c0 = (long)from->column[0], c1 = (long)from->column[1];
    long r0 = (long)from->row[0], r1 = (long)from->row[1];
    if (r1 <= r0) return;
    if (sigma < 0.02 * fmin(s->step[1], s->step[2])) { /* not a thousandth leaves its cell */
        for (long k = r0; k < r1; k++)
            add_row(plane + k * across + c0, from->loss + k * across + c0, 1.0, (size_t)(c1 - c0));
        return;
    }
    long n = (long)kernel(sigma / s->step[1], tap);
    long low = c0 - n + 1 > 0 ? c0 - n + 1 : 0, high = c1 + n - 1 < across ? c1 + n - 1 : across;
    for (long k = r0; k < r1; k++) {
        double *row = work + k * across;
        const double *loss = from->loss + k * across;
        memset(row + low, 0, (size_t)(high - low) * sizeof *row);
        for (long j = 1 - n; j < n; j++) {
            long first = c0 + j > 0 ? c0 + j : 0, last = c1 + j < across ? c1 + j : across;
            if (last > first)
                add_row(row + first, loss + first - j, tap[j < 0 ? -j : j], (size_t)(last - first));
        }
    }
    n = (long)kernel(sigma / s->step[2], tap);
    for (long k = r0; k < r1; k++)
        for (long j = 1 - n; j < n; j++) {
            long to = k + j < 0 ? -1 - k - j : k + j; /* reflected at the ground */
            if (to < up)
                add_row(plane + to * across + low, work + k * across + low, tap[j < 0 ? -j : j],
                        (size_t)(high - low));
        }
}

/* Loss of a slab from the wind that arrives; the cells that have any. */
static void lose(const struct wf_shelter *s, size_t slab, const double *arriving, struct source *out)
{
    const struct wf_shelter_request *q = &s->request;
    size_t cells = s->up * s->across;
    const double *wood = s->wood + slab * cells, *leaf = s->leaf + slab * cells;
    double least = wf_shelter_speed_share(q), span = 1.0 - least;
    *out = (struct source){
        .loss = out->loss, .place = (double)slab, .row = { s->up }, .column = { s->across }
    };
    for (size_t c = 0; c < cells; c++) {
        out->loss[c] = 0.0;
        if (!(wood[c] > 0.0 || leaf[c] > 0.0) || span <= 0.0) continue;
        double k = (wood[c] > 0.0 ? -q->wood_drag * log1p(-wood[c]) : 0.0) + q->crown_drag * leaf[c];
        double loss = (1.0 - arriving[c]) * span * -expm1(-k / (2.0 * span));
        size_t row = c / s->across, column = c % s->across;
        if (!(loss > 0.0)) continue;
        out->loss[c] = loss;
        out->total += loss;
        if (row < out->row[0]) out->row[0] = row;
        if (row >= out->row[1]) out->row[1] = row + 1;
        if (column < out->column[0]) out->column[0] = column;
        if (column >= out->column[1]) out->column[1] = column + 1;
    }
}

static void unite(struct source *a, const struct source *b, size_t cells)
{
    double total = a->total + b->total;
    add_row(a->loss, b->loss, 1.0, cells);
    if (total > 0.0) a->place = (a->place * a->total + b->place * b->total) / total;
    a->total = total;
    for (int k = 0; k < 2; k++) {
        size_t *mine = k ? a->column : a->row;
        const size_t *other = k ? b->column : b->row;
        if (other[0] < mine[0]) mine[0] = other[0];
        if (other[1] > mine[1]) mine[1] = other[1];
    }
}

/* Neighbours whose distances to `plane` differ by less than a sixth become one. Returned: how many are left;
 * memory of those taken in moves behind them. */
static size_t gather(struct source *list, size_t n, double plane, size_t cells)
{
    size_t kept = 0;
    for (size_t i = 1; i < n; i++) {
        struct source *last = &list[kept];
        if (list[i].place - last->place <= (plane - list[i].place) / 6.0) {
            unite(last, &list[i], cells);
            continue;
        }
        struct source swap = list[++kept];
        list[kept] = list[i];
        list[i] = swap;
    }
    return n ? kept + 1 : 0;
}

enum wf_status wf_shelter_wake(struct wf_shelter *s, struct wf_arena *scratch, struct wf_err *e)
{
    size_t cells = s->up * s->across, n = 0;
    struct source *list = WF_TAKE(scratch, s->slabs, struct source);
    double *work = WF_TAKE(scratch, cells, double), *still = WF_TAKE(scratch, cells, double);
    if (!list || !work || !still) return wf_fail(e, WF_ENOMEM, "no room for wakes");
    for (size_t p = 0; p < s->planes; p++) {
        double *plane = s->part[0] + p * cells;
        if (p < s->slabs) {
            if (!list[n].loss && !(list[n].loss = WF_TAKE(scratch, cells, double)))
                return wf_fail(e, WF_ENOMEM, "no room for wakes");
            lose(s, p, p ? plane - cells : still, &list[n]);
            if (list[n].total > 0.0) n++;
        }
        n = gather(list, n, (double)p, cells);
        for (size_t i = 0; i < n; i++) {
            double distance = ((double)p + WF_SHELTER_LAG - list[i].place) * s->step[0];
            spread(s, &list[i], s->request.wake_growth * distance, work, plane);
        }
        for (size_t c = 0; c < cells; c++) plane[c] = fmin(plane[c], 1.0);
    }
    return WF_OK;
}
