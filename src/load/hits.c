/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/hits.h"
#include "base/vec3.h"
#include <math.h>
#include <stdlib.h>

enum { BODIES_LEAF = 4, DEEPEST = 64 };

/* ---- Building ---- */

static void box_of(const struct wf_body *b, const double *place, double low[3], double high[3])
{
    for (int k = 0; k < 3; k++) {
        if (b->at[k] < 0) break;
        double r = b->at[2] < 0 ? (k ? b->r1 : b->r0) : 0;
        for (int c = 0; c < 3; c++) {
            double v = place[3 * b->at[k] + c];
            if (v - r < low[c]) low[c] = v - r;
            if (v + r > high[c]) high[c] = v + r;
        }
    }
}

static void empty(double low[3], double high[3])
{
    for (int c = 0; c < 3; c++) low[c] = INFINITY, high[c] = -INFINITY;
}

struct sorted {
    struct wf_body body;
    double middle[3];
};

static int axis_sorted; /* of the comparison; building is not done by several threads at once */
static int by_middle(const void *a, const void *b)
{
    const struct sorted *x = a, *y = b;
    double d = x->middle[axis_sorted] - y->middle[axis_sorted];
    return d < 0 ? -1 : d > 0;
}

/* Boxes of the bodies from first on: halves along the longest side. */
static void split(struct wf_hits *h, struct sorted *s, int32_t first, int32_t count)
{
    struct wf_box *b = &h->box[h->boxes++];
    double low[3], high[3];
    if (count <= BODIES_LEAF) {
        *b = (struct wf_box){ .first = first, .count = count };
        return;
    }
    empty(low, high);
    for (int32_t i = first; i < first + count; i++)
        for (int c = 0; c < 3; c++)
            low[c] = fmin(low[c], s[i].middle[c]), high[c] = fmax(high[c], s[i].middle[c]);
    axis_sorted = 0;
    for (int c = 1; c < 3; c++)
        if (high[c] - low[c] > high[axis_sorted] - low[axis_sorted]) axis_sorted = c;
    qsort(s + first, (size_t)count, sizeof *s, by_middle);
    split(h, s, first, count / 2);
    *b = (struct wf_box){ .first = (int32_t)h->boxes };
    split(h, s, first + count / 2, count - count / 2);
}

enum wf_status wf_hits_build(const struct wf_body *body, size_t n, const double *place, struct wf_arena *a,
                             struct wf_hits *out, struct wf_err *e)
{
    if (!n || n > INT32_MAX / 4) return wf_fail(e, WF_EINPUT, "nothing that drops could hit");
    struct sorted *s = WF_TAKE(a, n, struct sorted);
    *out = (struct wf_hits){ .n = n,
                             .body = WF_TAKE(a, n, struct wf_body),
                             .box = WF_TAKE(a, 2 * n, struct wf_box) };
    if (!s || !out->body || !out->box) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu bodies", n);
    for (size_t i = 0; i < n; i++) {
        double low[3], high[3];
        empty(low, high);
        box_of(&body[i], place, low, high);
        s[i].body = body[i];
        for (int c = 0; c < 3; c++) s[i].middle[c] = 0.5 * (low[c] + high[c]);
    }
    split(out, s, 0, (int32_t)n);
    for (size_t i = 0; i < n; i++) out->body[i] = s[i].body;
    wf_hits_refit(out, place);
    return WF_OK;
}

void wf_hits_refit(struct wf_hits *h, const double *place)
{
    for (size_t k = h->boxes; k-- > 0;) { /* children stand behind their box */
        struct wf_box *b = &h->box[k];
        empty(b->low, b->high);
        for (int32_t i = b->first; i < b->first + b->count; i++) box_of(&h->body[i], place, b->low, b->high);
        for (int child = 0; child < 2 && !b->count; child++) {
            const struct wf_box *of = child ? &h->box[b->first] : b + 1;
            for (int c = 0; c < 3; c++) {
                if (of->low[c] < b->low[c]) b->low[c] = of->low[c];
                if (of->high[c] > b->high[c]) b->high[c] = of->high[c];
            }
        }
    }
}

/* ---- Meeting ---- */

struct way {
    double from[3], go[3], radius;
};

/* Segment and triangle (Moeller & Trumbore 1997). */
static bool meet_triangle(const struct way *w, const struct wf_body *b, const double *place,
                          struct wf_hit *out)
{
    const double *p = place + 3 * b->at[0], *q = place + 3 * b->at[1], *r = place + 3 * b->at[2];
    double u[3], v[3], h[3], s[3], k[3];
    for (int c = 0; c < 3; c++) u[c] = q[c] - p[c], v[c] = r[c] - p[c], s[c] = w->from[c] - p[c];
    wf_cross(w->go, v, h);
    double det = wf_dot(u, h);
    if (det == 0) return false;
    double a = wf_dot(s, h) / det;
    if (a < 0 || a > 1) return false;
    wf_cross(s, u, k);
    double c = wf_dot(w->go, k) / det, t = wf_dot(v, k) / det;
    if (c < 0 || a + c > 1 || t < 0 || t > 1) return false;
    out->when = t;
    out->weight[0] = 1 - a - c, out->weight[1] = a, out->weight[2] = c;
    return true;
}

/* Segment and the side of a frustum, grown by the drop's radius: |x - axis(s)| = r(s), s in 0..1. */
static bool meet_frustum(const struct way *w, const struct wf_body *b, const double *place,
                         struct wf_hit *out)
{
    const double *p = place + 3 * b->at[0], *q = place + 3 * b->at[1];
    double d[3], m[3];
    for (int c = 0; c < 3; c++) d[c] = q[c] - p[c], m[c] = w->from[c] - p[c];
    double dd = wf_dot(d, d), s0 = wf_dot(m, d) / dd, s1 = wf_dot(w->go, d) / dd;
    double r0 = b->r0 + w->radius, slope = b->r1 - b->r0;
    double x0[3], x1[3];
    for (int c = 0; c < 3; c++) x0[c] = m[c] - s0 * d[c], x1[c] = w->go[c] - s1 * d[c];
    double k0 = r0 + slope * s0, k1 = slope * s1; /* radius at the foot, linear along the way */
    double A = wf_dot(x1, x1) - k1 * k1, B = wf_dot(x0, x1) - k0 * k1, C = wf_dot(x0, x0) - k0 * k0;
    if (C <= 0) return false; /* the drop left from here */
    double root = B * B - A * C;
    if (root < 0 || B >= 0) return false;
    double t = C / (-B + sqrt(root)), s = s0 + t * s1;
    if (!(t >= 0 && t <= 1 && s >= 0 && s <= 1)) return false;
    out->when = t;
    out->weight[0] = s, out->weight[1] = out->weight[2] = 0;
    return true;
}

static void try_body(const struct wf_hits *h, const struct way *w, const double *place, int32_t i,
                     struct wf_hit *best)
{
    const struct wf_body *b = &h->body[i];
    struct wf_hit hit = { .body = i, .part = b->part };
    bool met = b->at[2] < 0 ? meet_frustum(w, b, place, &hit) : meet_triangle(w, b, place, &hit);
    /* of two at the same place the one that was given first, whatever the boxes */
    if (!met || hit.when > best->when) return;
    if (hit.when == best->when && best->body >= 0 && best->body < i) return;
    for (int c = 0; c < 3; c++) hit.place[c] = w->from[c] + hit.when * w->go[c];
    *best = hit;
}

/* Whether the way up to `until` passes a box grown by the drop's radius. */
static bool passes(const struct way *w, const struct wf_box *b, double until)
{
    double enter = 0, leave = until;
    for (int c = 0; c < 3; c++) {
        double low = b->low[c] - w->radius - w->from[c], high = b->high[c] + w->radius - w->from[c];
        if (w->go[c] == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        double a = low / w->go[c], z = high / w->go[c];
        enter = fmax(enter, fmin(a, z)), leave = fmin(leave, fmax(a, z));
    }
    return enter <= leave;
}

static struct way way_of(const double from[3], const double to[3], double radius)
{
    struct way w = { .radius = radius };
    for (int c = 0; c < 3; c++) w.from[c] = from[c], w.go[c] = to[c] - from[c];
    return w;
}

bool wf_hits_first(const struct wf_hits *h, const double *place, const double from[3], const double to[3],
                   double radius, struct wf_hit *out, size_t *tests)
{
    struct way w = way_of(from, to, radius);
    struct wf_hit best = { .when = 1, .body = -1 };
    int32_t stack[DEEPEST], top = 0;
    stack[top++] = 0;
    while (top) {
        int32_t k = stack[--top];
        const struct wf_box *b = &h->box[k];
        if (!passes(&w, b, best.when)) continue;
        for (int32_t i = b->first; i < b->first + b->count; i++) try_body(h, &w, place, i, &best);
        if (tests) *tests += (size_t)b->count;
        if (!b->count) stack[top++] = b->first, stack[top++] = k + 1;
    }
    *out = best;
    return best.body >= 0;
}

bool wf_hits_first_of_all(const struct wf_hits *h, const double *place, const double from[3],
                          const double to[3], double radius, struct wf_hit *out)
{
    struct way w = way_of(from, to, radius);
    struct wf_hit best = { .when = 1, .body = -1 };
    for (size_t i = 0; i < h->n; i++) try_body(h, &w, place, (int32_t)i, &best);
    *out = best;
    return best.body >= 0;
}
