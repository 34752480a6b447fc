/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/prism_blocks.h"
#include "base/vec3.h"
#include <math.h>
#include <string.h>

/* ---- Pattern ---- */

/* Unknown sections that a vertex depends on, without repeats. Returned: how many. */
static size_t blocks_of(const struct wf_prism *p, int32_t vertex, int32_t block[4])
{
    size_t n = 0;
    int32_t s = vertex / 3;
    if (!p->bonded[s]) {
        if (p->free[s] >= 0) block[n++] = p->free[s];
        return n;
    }
    for (int i = 0; i < 4; i++) {
        int32_t f = p->free[p->bond[vertex].on[i] / 3];
        bool there = f < 0;
        for (size_t k = 0; k < n; k++) there |= block[k] == f;
        if (!there) block[n++] = f;
    }
    return n;
}

static void mark(uint8_t *full, size_t n, int32_t i, int32_t j)
{
    full[(size_t)(i > j ? j : i) * n + (size_t)(i > j ? i : j)] = 1;
}

/* Which blocks of the lower triangle are not zero: full[column n + row]; then what fills in. */
static void pattern(const struct wf_prism *p, uint8_t *full, size_t n)
{
    for (size_t k = 0; k < n; k++) full[k * n + k] = 1;
    for (size_t s = 0; s < p->springs; s++) {
        int32_t block[8];
        size_t m = blocks_of(p, p->spring[s].a, block);
        if (p->spring[s].b >= 0) m += blocks_of(p, p->spring[s].b, block + m);
        for (size_t i = 0; i < m; i++)
            for (size_t j = 0; j < m; j++) mark(full, n, block[i], block[j]);
    }
    for (size_t k = 0; k < n; k++)
        for (size_t i = k + 1; i < n; i++)
            if (full[k * n + i])
                for (size_t j = i; j < n; j++)
                    if (full[k * n + j]) full[i * n + j] = 1;
}

static int32_t entry_of(const struct wf_prism_blocks *b, size_t column, int32_t row)
{
    int32_t low = b->begin[column], high = b->begin[column + 1] - 1;
    while (low < high) {
        int32_t mid = (low + high) / 2;
        if (b->row[mid] < row)
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

/* Where each product of two entries of a column is subtracted. */
static enum wf_status plan_updates(struct wf_prism_blocks *b, struct wf_arena *a, struct wf_err *e)
{
    size_t total = 0;
    b->pairs = WF_TAKE(a, b->n + 1, size_t);
    if (!b->pairs) return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    for (size_t k = 0; k < b->n; k++) {
        size_t m = (size_t)(b->begin[k + 1] - b->begin[k] - 1);
        b->pairs[k] = total;
        total += m * (m + 1) / 2;
    }
    b->target = WF_TAKE(a, total, int32_t);
    if (!b->target) return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    for (size_t k = 0, t = 0; k < b->n; k++)
        for (int32_t j = b->begin[k] + 1; j < b->begin[k + 1]; j++)
            for (int32_t i = j; i < b->begin[k + 1]; i++)
                b->target[t++] = entry_of(b, (size_t)b->row[j], b->row[i]);
    return WF_OK;
}

enum wf_status wf_prism_blocks_make(const struct wf_prism *p, struct wf_arena *a, struct wf_prism_blocks *out,
                                    struct wf_err *e)
{
    size_t n = out->n = p->unknown, entries = 0;
    uint8_t *full = WF_TAKE(a, n * n, uint8_t);
    out->begin = WF_TAKE(a, n + 1, int32_t);
    if (!full || !out->begin) return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    pattern(p, full, n);
    for (size_t k = 0; k < n * n; k++) entries += full[k];
    out->row = WF_TAKE(a, entries, int32_t);
    out->value = WF_TAKE(a, entries * WF_PRISM_BLOCK, double);
    out->flip = WF_TAKE(a, entries * WF_PRISM_BLOCK, double);
    if (!out->row || !out->value || !out->flip)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    for (size_t k = 0, at = 0; k < n; k++) {
        for (size_t i = k; i < n; i++)
            if (full[k * n + i]) out->row[at++] = (int32_t)i;
        out->begin[k + 1] = (int32_t)at;
    }
    return plan_updates(out, a, e);
}

/* ---- Filling ---- */

/* An unknown vertex with its share in the place of an end of a spring. */
struct share {
    int32_t section, vertex; /* number among the unknown ones; 0..2 */
    double of;
};

static size_t shares_of(const struct wf_prism *p, int32_t vertex, double sign, struct share out[4])
{
    size_t n = 0;
    int32_t s = vertex / 3;
    if (!p->bonded[s]) {
        if (p->free[s] >= 0) out[n++] = (struct share){ p->free[s], vertex % 3, sign };
        return n;
    }
    const struct wf_prism_bond *b = &p->bond[vertex];
    for (int i = 0; i < 4; i++)
        if (p->free[b->on[i] / 3] >= 0)
            out[n++] = (struct share){ p->free[b->on[i] / 3], b->on[i] % 3, sign * b->share[i] };
    return n;
}

static void add_spring(const struct wf_prism *p, const double *x, const double *y,
                       const struct wf_prism_spring *s, double factor, double dash, bool whole,
                       struct wf_prism_blocks *b)
{
    double K[9] = { 0 }, d[3], g[3], mean[3];
    struct share end[8];
    size_t n = shares_of(p, s->a, -1, end);
    if (s->b < 0)
        K[0] = K[4] = K[8] = factor * s->k;
    else {
        n += shares_of(p, s->b, 1, end + n);
        for (int c = 0; c < 3; c++) {
            d[c] = x[3 * s->b + c] - x[3 * s->a + c], g[c] = y[3 * s->b + c] - y[3 * s->a + c];
            mean[c] = 0.5 * (d[c] + g[c]);
        }
        double l = 0.5 * (sqrt(wf_dot(d, d)) + sqrt(wf_dot(g, g))), pull = 1 - s->rest / l;
        if (pull < 0 && !whole) pull = 0;
        K[0] = K[4] = K[8] = factor * s->k * pull;
        m3_add_outer(K, s->k * (factor * s->rest / l + dash) / (l * l), mean, mean);
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            if (end[i].section < end[j].section) continue; /* the lower triangle; diagonal blocks whole */
            double *v =
                b->value + WF_PRISM_BLOCK * (size_t)entry_of(b, (size_t)end[j].section, end[i].section);
            double w = end[i].of * end[j].of;
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    v[9 * (3 * end[i].vertex + r) + 3 * end[j].vertex + c] += w * K[3 * r + c];
        }
}

void wf_prism_blocks_fill(const struct wf_prism *p, const double *x, const double *y, double mass_share,
                          double stiffness_share, double dash_share, bool whole, struct wf_prism_blocks *b)
{
    memset(b->value, 0, (size_t)b->begin[b->n] * WF_PRISM_BLOCK * sizeof *b->value);
    for (size_t k = 0; k < b->n && mass_share > 0; k++) {
        const double *m = p->mass + 9 * p->order[k];
        double *v = b->value + WF_PRISM_BLOCK * (size_t)b->begin[k];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int c = 0; c < 3; c++) v[9 * (3 * i + c) + 3 * j + c] = mass_share * m[3 * i + j];
    }
    for (size_t s = 0; s < p->springs; s++)
        add_spring(p, x, y, &p->spring[s], stiffness_share, dash_share, whole, b);
}

/* ---- Factor and answer ---- */

WF_INLINE bool cholesky(double *v)
{
    for (int j = 0; j < 9; j++) {
        double d = v[10 * j];
        for (int k = 0; k < j; k++) d -= v[9 * j + k] * v[9 * j + k];
        if (!(d > 0)) return false;
        v[10 * j] = sqrt(d);
        for (int i = j + 1; i < 9; i++) {
            double s = v[9 * i + j];
            for (int k = 0; k < j; k++) s -= v[9 * i + k] * v[9 * j + k];
            v[9 * i + j] = s / v[10 * j];
        }
    }
    return true;
}

/* B <- B L^-T, column by column of B; flip: the result transposed, which is how it is made. */
WF_INLINE void divide(double *b, const double *l, double *flip)
{
    for (int r = 0; r < 9; r++)
        for (int j = 0; j < 9; j++) flip[9 * j + r] = b[9 * r + j];
    for (int j = 0; j < 9; j++) {
        double *to = flip + 9 * j;
        for (int k = 0; k < j; k++)
            for (int r = 0; r < 9; r++) to[r] -= flip[9 * k + r] * l[9 * j + k];
        double d = 1 / l[10 * j];
        for (int r = 0; r < 9; r++) to[r] *= d;
    }
    for (int r = 0; r < 9; r++)
        for (int j = 0; j < 9; j++) b[9 * r + j] = flip[9 * j + r];
}

/* C -= A B', B given transposed */
WF_INLINE void subtract(double *c, const double *a, const double *flip)
{
    for (int i = 0; i < 9; i++) {
        double row[9];
        for (int j = 0; j < 9; j++) row[j] = c[9 * i + j];
        for (int k = 0; k < 9; k++)
            for (int j = 0; j < 9; j++) row[j] -= a[9 * i + k] * flip[9 * k + j];
        for (int j = 0; j < 9; j++) c[9 * i + j] = row[j];
    }
}

WF_WIDE bool wf_prism_blocks_factor(struct wf_prism_blocks *b)
{
    for (size_t k = 0; k < b->n; k++) {
        double *v = b->value, *flip = b->flip, *l = v + WF_PRISM_BLOCK * (size_t)b->begin[k];
        if (!cholesky(l)) return false;
        for (int32_t i = b->begin[k] + 1; i < b->begin[k + 1]; i++)
            divide(v + WF_PRISM_BLOCK * i, l, flip + WF_PRISM_BLOCK * i);
        const int32_t *to = b->target + b->pairs[k];
        for (int32_t j = b->begin[k] + 1; j < b->begin[k + 1]; j++)
            for (int32_t i = j; i < b->begin[k + 1]; i++)
                subtract(v + WF_PRISM_BLOCK * *to++, v + WF_PRISM_BLOCK * i, flip + WF_PRISM_BLOCK * j);
    }
    return true;
}

/* y <- L^-1 y, then to -= M y for the blocks below. */
WF_INLINE void forward(const struct wf_prism_blocks *b, size_t k, double *v)
{
    const double *l = b->value + WF_PRISM_BLOCK * (size_t)b->begin[k];
    double *y = v + 9 * k;
    for (int j = 0; j < 9; j++) {
        double s = y[j];
        for (int i = 0; i < j; i++) s -= l[9 * j + i] * y[i];
        y[j] = s / l[10 * j];
    }
    for (int32_t i = b->begin[k] + 1; i < b->begin[k + 1]; i++) {
        const double *flip = b->flip + WF_PRISM_BLOCK * i;
        double *to = v + 9 * b->row[i];
        for (int c = 0; c < 9; c++)
            for (int r = 0; r < 9; r++) to[r] -= flip[9 * c + r] * y[c];
    }
}

WF_INLINE void backward(const struct wf_prism_blocks *b, size_t k, double *v)
{
    const double *l = b->value + WF_PRISM_BLOCK * (size_t)b->begin[k];
    double *y = v + 9 * k;
    for (int32_t i = b->begin[k] + 1; i < b->begin[k + 1]; i++) {
        const double *m = b->value + WF_PRISM_BLOCK * i, *from = v + 9 * b->row[i];
        for (int r = 0; r < 9; r++)
            for (int c = 0; c < 9; c++) y[c] -= m[9 * r + c] * from[r];
    }
    for (int j = 8; j >= 0; j--) {
        y[j] /= l[10 * j];
        for (int i = 0; i < j; i++) y[i] -= l[9 * j + i] * y[j];
    }
}

WF_WIDE void wf_prism_blocks_solve(const struct wf_prism_blocks *b, double *v)
{
    for (size_t k = 0; k < b->n; k++) forward(b, k, v);
    for (size_t k = b->n; k-- > 0;) backward(b, k, v);
}
