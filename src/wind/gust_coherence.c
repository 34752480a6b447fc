#include "wind/gust_coherence.h"
#include <math.h>
#include <string.h>

/* Ratio of neighbouring rungs; linear interpolation of the weights between them is the only error for few
 * points and is measured in the tests. */
static const double RUNG_RATIO = 1.12;
/* Added to the diagonal of the conditioning matrix, so that points at one place stay solvable. */
static const double NUGGET = 1e-11;

static double distance(const double *a, const double *b)
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* Farthest-point order: the first is the point nearest to the middle. */
static enum wf_status put_in_order(struct wf_coherence *c, const double *at, struct wf_arena *a,
                                   struct wf_err *e)
{
    double middle[3] = { 0 }, best = INFINITY;
    double *gap = WF_TAKE(a, c->n, double);
    if (!gap) return wf_fail(e, WF_ENOMEM, "no room to order %zu points", c->n);
    for (size_t i = 0; i < c->n; i++)
        for (int k = 0; k < 3; k++) middle[k] += at[3 * i + (size_t)k] / (double)c->n;
    size_t next = 0;
    for (size_t i = 0; i < c->n; i++) {
        double r = distance(at + 3 * i, middle);
        if (r < best) best = r, next = i;
        gap[i] = INFINITY;
    }
    for (size_t turn = 0; turn < c->n; turn++) {
        c->order[turn] = next;
        c->closest[turn] = gap[next];
        memcpy(c->stretched + 3 * turn, at + 3 * next, 3 * sizeof(double));
        size_t taken = next;
        gap[taken] = -1.0;
        for (size_t i = 0; i < c->n; i++) {
            if (gap[i] < 0.0) continue;
            double r = distance(at + 3 * i, at + 3 * taken);
            if (r < gap[i]) gap[i] = r;
            if (gap[next] < 0.0 || gap[i] > gap[next]) next = i;
        }
    }
    return WF_OK;
}

/* The `near` closest earlier turns, by insertion. */
static void find_neighbours(struct wf_coherence *c, size_t turn)
{
    double r[WF_COHERENCE_NEAR];
    size_t *list = c->neighbour + turn * c->near, held = 0;
    for (size_t j = 0; j < turn; j++) {
        double d = distance(c->stretched + 3 * turn, c->stretched + 3 * j);
        if (held == c->near && d >= r[held - 1]) continue;
        size_t at = held < c->near ? held++ : held - 1;
        for (; at > 0 && r[at - 1] > d; at--) r[at] = r[at - 1], list[at] = list[at - 1];
        r[at] = d, list[at] = j;
    }
    c->count[turn] = held;
}

/* Weights and rest of one turn at one g: solve K b = k, d = 1 - k.b, by Cholesky. */
static void condition(const struct wf_coherence *c, size_t turn, double g, double *weight, double *rest)
{
    double l[WF_COHERENCE_NEAR][WF_COHERENCE_NEAR], k[WF_COHERENCE_NEAR], y[WF_COHERENCE_NEAR];
    size_t m = c->count[turn];
    const size_t *list = c->neighbour + turn * c->near;
    for (size_t i = 0; i < m; i++) {
        const double *at = c->stretched + 3 * list[i];
        k[i] = exp(-g * distance(at, c->stretched + 3 * turn));
        for (size_t j = 0; j <= i; j++) {
            double s = i == j ? 1.0 + NUGGET : exp(-g * distance(at, c->stretched + 3 * list[j]));
            for (size_t q = 0; q < j; q++) s -= l[i][q] * l[j][q];
            l[i][j] = i == j ? sqrt(fmax(s, NUGGET)) : s / l[j][j];
        }
    }
    double explained = 0.0;
    for (size_t i = 0; i < m; i++) {
        y[i] = k[i];
        for (size_t q = 0; q < i; q++) y[i] -= l[i][q] * y[q];
        y[i] /= l[i][i];
        explained += y[i] * y[i];
    }
    for (size_t i = m; i-- > 0;) {
        weight[i] = y[i];
        for (size_t q = i + 1; q < m; q++) weight[i] -= l[q][i] * weight[q];
        weight[i] /= l[i][i];
    }
    *rest = fmax(1.0 - explained, 0.0);
}

enum wf_status wf_coherence_make(size_t n, const double *place, const double decay[3], double g_low,
                                 double g_high, struct wf_arena *a, struct wf_coherence *c, struct wf_err *e)
{
    memset(c, 0, sizeof *c);
    c->n = n;
    c->near = n > WF_COHERENCE_NEAR ? WF_COHERENCE_NEAR : (n > 1 ? n - 1 : 1);
    c->rungs = 2 + (size_t)ceil(log(g_high / g_low) / log(RUNG_RATIO));
    double *at = WF_TAKE(a, 3 * n, double);
    c->order = WF_TAKE(a, n, size_t);
    c->count = WF_TAKE(a, n, size_t);
    c->neighbour = WF_TAKE(a, n * c->near, size_t);
    c->stretched = WF_TAKE(a, 3 * n, double);
    c->closest = WF_TAKE(a, n, double);
    c->rung = WF_TAKE(a, c->rungs, double);
    c->weight = WF_TAKE(a, c->rungs * n * c->near, double);
    c->rest = WF_TAKE(a, c->rungs * n, double);
    if (!at || !c->order || !c->count || !c->neighbour || !c->stretched || !c->closest || !c->rung ||
        !c->weight || !c->rest)
        return wf_fail(e, WF_ENOMEM, "no room for the coherence of %zu points", n);
    for (size_t i = 0; i < 3 * n; i++) at[i] = place[i] * decay[i % 3];
    if (put_in_order(c, at, a, e)) return e ? e->code : WF_ENOMEM;
    for (size_t turn = 0; turn < n; turn++) find_neighbours(c, turn);
    for (size_t q = 0; q < c->rungs; q++) {
        c->rung[q] = g_low * pow(RUNG_RATIO, (double)q);
        for (size_t turn = 0; turn < n; turn++)
            condition(c, turn, c->rung[q], c->weight + (q * n + turn) * c->near, c->rest + q * n + turn);
    }
    return WF_OK;
}

void wf_coherence_find(const struct wf_coherence *c, double g, size_t *rung, double *share)
{
    if (!(g > c->rung[0])) {
        *rung = 0, *share = 0.0;
        return;
    }
    size_t q = (size_t)(log(g / c->rung[0]) / log(RUNG_RATIO));
    if (q > c->rungs - 2) q = c->rungs - 2;
    *rung = q;
    *share = fmin((g - c->rung[q]) / (c->rung[q + 1] - c->rung[q]), 1.0);
}

/* Covariance of the made field by the recursion itself: row by row, each new point against all earlier. */
double wf_coherence_error(const struct wf_coherence *c, double g, struct wf_arena *a)
{
    size_t n = c->n < 400 ? c->n : 400, q;
    double share, worst = 0.0;
    double *made = WF_TAKE(a, n * n, double);
    if (!made) return NAN;
    wf_coherence_find(c, g, &q, &share);
    for (size_t i = 0; i < n; i++) {
        const double *w0 = c->weight + (q * c->n + i) * c->near, *w1 = w0 + c->n * c->near;
        double rest = (1.0 - share) * c->rest[q * c->n + i] + share * c->rest[(q + 1) * c->n + i];
        for (size_t j = 0; j <= i; j++) {
            double s = i == j ? rest : 0.0;
            for (size_t k = 0; k < c->count[i]; k++) {
                size_t from = c->neighbour[i * c->near + k];
                double b = (1.0 - share) * w0[k] + share * w1[k];
                s += b * (j == i ? made[i * n + from] : made[from > j ? from * n + j : j * n + from]);
            }
            made[i * n + j] = s;
            double want = exp(-g * distance(c->stretched + 3 * i, c->stretched + 3 * j));
            worst = fmax(worst, fabs(s - want));
        }
    }
    return worst;
}
