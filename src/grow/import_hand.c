/* Coordinates for a table of lengths, diameters and angles. */
#include "base/vec.h"
#include "grow/import_readers.h"
#include "grow/qsm_index.h"
#include <math.h>

static const double GOLDEN = 137.50776405003785 / 180 * M_PI; /* divergence of spiral leaf positions [rad] */

/* Unit vector across `t` that points as nearly as can be to the azimuth `az`. */
static void across(const double t[3], double az, double out[3])
{
    double h[3] = { cos(az), sin(az), 0 };
    double along = wf_dot(h, t);
    for (int k = 0; k < 3; k++) out[k] = h[k] - along * t[k];
    double norm = sqrt(wf_dot(out, out));
    if (norm < 1e-9) { /* the parent lies along the azimuth: tilt upwards */
        out[0] = out[1] = 0, out[2] = 1;
        norm = 1;
    }
    for (int k = 0; k < 3; k++) out[k] /= norm;
}

struct place {
    struct wf_qsm *q;
    const struct wf_hand *hand;
    double azimuth; /* given to the next branch whose own was not measured */
};

static double azimuth_of(struct place *p, size_t i, bool leaning)
{
    double az = p->hand->azimuth[i];
    if (!isnan(az) || !leaning) return isnan(az) ? 0 : az;
    wf_qsm_count(p->q, WF_REPAIR_AZIMUTH, 1, p->q->id[i]);
    p->azimuth += GOLDEN;
    return p->azimuth;
}

static void put(struct place *p, size_t i, int32_t parent)
{
    struct wf_qsm *q = p->q;
    const struct wf_hand *h = p->hand;
    double start[3] = { 0, 0, 0 }, t[3] = { 0, 0, 1 }, d[3], u[3];
    if (parent >= 0) {
        size_t k = (size_t)parent;
        double length = wf_qsm_distance(q, k);
        double s = !isnan(h->distance[i]) ? h->distance[i] / length : isnan(h->share[i]) ? 1 : h->share[i];
        s = s < 0 ? 0 : s > 1 ? 1 : s;
        t[0] = (q->x1[k] - q->x0[k]) / length, t[1] = (q->y1[k] - q->y0[k]) / length;
        t[2] = (q->z1[k] - q->z0[k]) / length;
        start[0] = q->x0[k] + s * length * t[0], start[1] = q->y0[k] + s * length * t[1];
        start[2] = q->z0[k] + s * length * t[2];
    }
    double up[3] = { 0, 0, 1 };
    bool from_vertical = !isnan(h->zenith[i]);
    double angle = from_vertical ? h->zenith[i] : isnan(h->angle[i]) ? 0 : h->angle[i];
    const double *from = from_vertical ? up : t;
    across(from, azimuth_of(p, i, fabs(angle) > 1e-9), u);
    for (int k = 0; k < 3; k++) d[k] = q->length[i] * (cos(angle) * from[k] + sin(angle) * u[k]);
    q->x0[i] = start[0], q->y0[i] = start[1], q->z0[i] = start[2];
    q->x1[i] = start[0] + d[0], q->y1[i] = start[1] + d[1], q->z1[i] = start[2] + d[2];
}

/* Row of each parent; 0, -1, an empty cell and an unknown id make a root, as in wf_qsm_resolve. */
static enum wf_status parents(const struct wf_qsm *q, int32_t *parent, struct wf_arena *a, struct wf_err *e)
{
    struct wf_ids ids;
    enum wf_status s = wf_ids_begin(&ids, q->id, q->n, a, e);
    if (s) return s;
    for (size_t i = 0; i < q->n; i++) (void)wf_ids_enter(&ids, (int32_t)i);
    for (size_t i = 0; i < q->n; i++)
        parent[i] = q->parent_id[i] < 0 ? -1 : wf_ids_find(&ids, q->parent_id[i]);
    return WF_OK;
}

enum wf_status wf_import_place(struct wf_qsm *q, const struct wf_hand *hand, struct wf_arena *a,
                               struct wf_err *e)
{
    struct place p = { .q = q, .hand = hand };
    struct wf_children c;
    int32_t *parent = WF_TAKE(a, q->n, int32_t), *queue = WF_TAKE(a, q->n, int32_t);
    if (!parent || !queue) return wf_fail(e, WF_ENOMEM, "no room for %zu rows", q->n);
    enum wf_status s = parents(q, parent, a, e);
    if (!s) s = wf_children_of(parent, q->n, a, &c, e);
    if (s) return s;
    for (size_t i = 0; i < q->n; i++)
        if (!(q->length[i] > 0))
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: length: row %lld has no length, and no coordinates either",
                           q->file, q->line[i], (long long)q->id[i]);
    size_t n = 0;
    for (int32_t k = c.begin[q->n]; k < c.begin[q->n + 1]; k++) queue[n++] = c.child[k];
    for (size_t k = 0; k < n; k++) {
        int32_t i = queue[k];
        put(&p, (size_t)i, parent[i]);
        for (int32_t m = c.begin[i]; m < c.begin[i + 1]; m++) queue[n++] = c.child[m];
    }
    for (size_t i = 0; i < q->n && n < q->n; i++)
        if (isnan(q->x0[i]))
            return wf_fail(
                e, WF_EINPUT,
                "%s:%zu: error: parent: row %lld is its own ancestor; without coordinates it has no place",
                q->file, q->line[i], (long long)q->id[i]);
    return WF_OK;
}
