/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/kmeans.h"
#include "base/file.h"
#include "base/num.h"
#include "base/random.h"
#include <math.h>
#include <string.h>

enum { ROUNDS_MOST = 1000, POINTS_MOST = 2000000, PLACE_MOST = 10000, LISTED = 20, PURPOSE_START = 74 };

static bool blank(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r'; }

/* One line. Returned: numbers read, 0 for an empty one, -1 for anything else. */
static int read_line(const char *s, const char *end, double x[3])
{
    int n = 0;
    for (;;) {
        while (s < end && blank(*s)) s++;
        if (s == end || *s == '#') return n == 0 || n == 3 ? n : -1;
        if (n == 3 || !(s = wf_number_read(s, end, '.', &x[n]))) return -1;
        n++;
        if (s < end && !blank(*s) && *s != '#') return -1;
    }
}

enum wf_status wf_cloud_read(const char *path, struct wf_arena *a, struct wf_cloud *out, struct wf_diag *d,
                             struct wf_err *e)
{
    struct wf_bytes b;
    enum wf_status s = wf_file_read_text(path, a, &b, e);
    size_t lines = 1, line = 1;
    if (s) return s;
    for (size_t i = 0; i < b.size; i++) lines += b.data[i] == '\n';
    if (lines > POINTS_MOST) return wf_fail(e, WF_EINPUT, "%s: more than %d points", path, POINTS_MOST);
    *out = (struct wf_cloud){ .at = WF_TAKE(a, 3 * lines, double) };
    if (!out->at) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its points", path);
    for (const char *at = b.data, *end = b.data + b.size; at < end; line++) {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        int n = read_line(at, stop ? stop : end, out->at + 3 * out->n);
        const double *x = out->at + 3 * out->n;
        bool far =
            n == 3 && !(fabs(x[0]) <= PLACE_MOST && fabs(x[1]) <= PLACE_MOST && fabs(x[2]) <= PLACE_MOST);
        if (n < 0 && d->errors < LISTED)
            wf_diag_error(d, path, line, 1, "a point is three numbers, x y z in metres, with blanks between");
        else if (far && d->errors < LISTED)
            wf_diag_error(d, path, line, 1, "a place is at most %d m from the origin; are these metres?",
                          PLACE_MOST);
        else if (n < 0 || far)
            d->errors++;
        out->n += n == 3;
        at = stop ? stop + 1 : end;
    }
    if (d->errors) return wf_fail(e, WF_EINPUT, "%s: %zu lines are no points", path, d->errors);
    return out->n ? WF_OK : wf_fail(e, WF_EINPUT, "%s: has no points", path);
}

static double square(const double *x, const double *y)
{
    double a = x[0] - y[0], b = x[1] - y[1], c = x[2] - y[2];
    return a * a + b * b + c * c;
}

/* Start: each further centre is a point drawn in proportion to its square distance from those there are. */
static void start(const struct wf_cloud *p, size_t n, uint64_t seed, double *near, double *centre)
{
    uint64_t stream = wf_random_stream(PURPOSE_START, 0, 0);
    size_t first = (size_t)(wf_random_uniform(seed, stream, 0) * (double)p->n);
    memcpy(centre, p->at + 3 * first, 3 * sizeof *centre);
    for (size_t i = 0; i < p->n; i++) near[i] = square(p->at + 3 * i, centre);
    for (size_t k = 1; k < n; k++) {
        double sum = 0;
        for (size_t i = 0; i < p->n; i++) sum += near[i];
        double want = wf_random_uniform(seed, stream, k) * sum;
        size_t i = 0;
        while (i + 1 < p->n && (want -= near[i]) > 0) i++;
        memcpy(centre + 3 * k, p->at + 3 * i, 3 * sizeof *centre);
        for (size_t j = 0; j < p->n; j++) near[j] = fmin(near[j], square(p->at + 3 * j, centre + 3 * k));
    }
}

/* Give every point to its nearest centre. Returned: points that changed. */
static size_t assign(const struct wf_cloud *p, struct wf_clusters *c)
{
    size_t changed = 0;
    memset(c->count, 0, c->n * sizeof *c->count);
    c->spread = 0;
    for (size_t i = 0; i < p->n; i++) {
        int32_t best = 0;
        double least = INFINITY;
        for (size_t k = 0; k < c->n; k++) {
            double far = square(p->at + 3 * i, c->centre + 3 * k);
            if (far < least) least = far, best = (int32_t)k;
        }
        changed += c->of[i] != best;
        c->of[i] = best;
        c->count[best]++;
        c->spread += sqrt(least) / (double)p->n;
    }
    return changed;
}

static void recentre(const struct wf_cloud *p, struct wf_clusters *c)
{
    memset(c->centre, 0, 3 * c->n * sizeof *c->centre);
    for (size_t i = 0; i < p->n; i++)
        for (size_t k = 0; k < 3; k++)
            c->centre[3 * (size_t)c->of[i] + k] += p->at[3 * i + k] / (double)c->count[c->of[i]];
}

/* Order along the branch: the end is the centre farthest from the one farthest from it that lies nearer to
 * base. */
static enum wf_status put_in_order(const struct wf_cloud *p, struct wf_clusters *c, const double base[3],
                                   struct wf_arena *a, struct wf_err *e)
{
    double *sorted = WF_TAKE(a, 3 * c->n, double);
    int32_t *place = WF_TAKE(a, c->n, int32_t);
    size_t *count = WF_TAKE(a, c->n, size_t), end[2] = { 0, 0 };
    if (!sorted || !place || !count) return wf_fail(e, WF_ENOMEM, "not enough memory for the clusters");
    for (int k = 0; k < 2; k++) { /* the farthest from any, then the farthest from that */
        size_t from = end[0] = end[1];
        for (size_t i = 0; i < c->n; i++)
            if (square(c->centre + 3 * i, c->centre + 3 * from) >
                square(c->centre + 3 * end[1], c->centre + 3 * from))
                end[1] = i;
    }
    size_t at =
        square(c->centre + 3 * end[0], base) <= square(c->centre + 3 * end[1], base) ? end[0] : end[1];
    for (size_t i = 0; i < c->n; i++) place[i] = -1;
    for (size_t k = 0; k < c->n; k++) {
        place[at] = (int32_t)k;
        memcpy(sorted + 3 * k, c->centre + 3 * at, 3 * sizeof *sorted);
        count[k] = c->count[at];
        size_t next = c->n;
        for (size_t i = 0; i < c->n; i++)
            if (place[i] < 0 && (next == c->n || square(c->centre + 3 * i, c->centre + 3 * at) <
                                                     square(c->centre + 3 * next, c->centre + 3 * at)))
                next = i;
        if (next < c->n) at = next;
    }
    for (size_t i = 0; i < p->n; i++) c->of[i] = place[c->of[i]];
    c->centre = sorted, c->count = count;
    return WF_OK;
}

enum wf_status wf_kmeans(const struct wf_cloud *p, size_t n, uint64_t seed, const double base[3],
                         struct wf_arena *a, struct wf_clusters *out, struct wf_err *e)
{
    if (n < 2 || p->n < n)
        return wf_fail(e, WF_EINPUT,
                       "%zu clusters of %zu points: at least two clusters and a point for each are needed", n,
                       p->n);
    *out = (struct wf_clusters){ .n = n,
                                 .centre = WF_TAKE(a, 3 * n, double),
                                 .of = WF_TAKE(a, p->n, int32_t),
                                 .count = WF_TAKE(a, n, size_t) };
    double *near = WF_TAKE(a, p->n, double);
    if (!out->centre || !out->of || !out->count || !near)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the clusters");
    start(p, n, seed, near, out->centre);
    for (size_t i = 0; i < p->n; i++) out->of[i] = -1;
    while (out->rounds++ < ROUNDS_MOST) {
        size_t changed = assign(p, out);
        for (size_t k = 0; k < n; k++)
            if (!out->count[k])
                return wf_fail(
                    e, WF_EINPUT,
                    "cluster %zu of %zu stays empty: points lie on top of one another; take fewer clusters",
                    k + 1, n);
        out->moving = changed;
        if (!changed) break;
        recentre(p, out);
    }
    return put_in_order(p, out, base, a, e);
}
