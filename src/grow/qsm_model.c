/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/qsm_model.h"
#include "base/num.h"
#include "grow/qsm.h"
#include <math.h>
#include <stdlib.h>

/* Where each row of a table of cylinders is attached to its parent. */

enum hold_place {
    HOLD_GROUND,
    HOLD_END,  /* at the end of the parent                */
    HOLD_BASE, /* at the parent's base                    */
    HOLD_AXIS  /* at a share of the parent's length       */
};

struct hold_row {
    enum hold_place at;
    double share;   /* of the parent's modelled axis, for HOLD_AXIS */
    double gap;     /* from the point of attachment to the row's start [m] */
    double radius;  /* of the parent there [m]                         */
    bool straight;  /* the row starts at the point of attachment itself */
    double base[3]; /* where the row's own wood starts [m]             */
};

static const double POINT = 1e-3; /* [m] */

/* Distance below which points are treated as one [m]: 1 mm or a tenth of the radius there. */
static double joint_tolerance(double radius) { return fmax(POINT, 0.1 * radius); }

static double distance_between(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

static void copy_point(double to[3], const double from[3])
{
    for (int k = 0; k < 3; k++) to[k] = from[k];
}

/* Attachment of a lateral branch: the point of the parent's axis nearest to its start, or an end of the
 * parent if that point is within the tolerance of it. */
static void hold_lateral(const struct wf_qsm *q, size_t p, const struct hold_row *parent,
                         const double start[3], struct hold_row *h)
{
    double end[3] = { q->x1[p], q->y1[p], q->z1[p] }, axis[3], from[3], dot = 0, length2 = 0;
    for (int k = 0; k < 3; k++) {
        axis[k] = end[k] - parent->base[k];
        from[k] = start[k] - parent->base[k];
        dot += axis[k] * from[k];
        length2 += axis[k] * axis[k];
    }
    double length = sqrt(length2), s = length > 0 ? fmin(fmax(dot / length2, 0), 1) : 1;
    h->radius = q->r0[p] + s * (q->r1[p] - q->r0[p]);
    double tolerance = joint_tolerance(h->radius);
    h->at = HOLD_AXIS;
    if ((1 - s) * length <= tolerance)
        h->at = HOLD_END, s = 1;
    else if (s * length <= tolerance) {
        /* at the base of the stem: attach the branch to the stem just above, because a row attached to the
         * ground would be a stem of its own */
        if (parent->at != HOLD_GROUND)
            h->at = HOLD_BASE, s = 0;
        else
            s = tolerance / length;
    }
    h->share = s;
    double point[3];
    for (int k = 0; k < 3; k++) point[k] = parent->base[k] + s * axis[k];
    h->gap = distance_between(start, point);
    h->straight = h->gap <= tolerance;
    copy_point(h->base, h->straight ? point : start);
}

/* Find the attachments of all rows. Given: a sorted table and the way of joining. Returned: hold[n]. */
static void find_holds(const struct wf_qsm *q, enum wf_joint joint, struct hold_row *hold)
{
    for (size_t i = 0; i < q->n; i++) {
        struct hold_row *h = &hold[i];
        double start[3] = { q->x0[i], q->y0[i], q->z0[i] };
        *h = (struct hold_row){ .at = HOLD_GROUND, .share = 1, .straight = true };
        if (q->parent[i] < 0) {
            copy_point(h->base, start);
            continue;
        }
        size_t p = (size_t)q->parent[i];
        double end[3] = { q->x1[p], q->y1[p], q->z1[p] };
        bool goes_on = q->next[p] == (int32_t)i;
        hold_lateral(q, p, &hold[p], start, h);
        if (joint == WF_JOINT_AXIS &&
            !(goes_on && (h->at == HOLD_END || distance_between(start, end) <= q->r1[p])))
            continue;
        h->at = HOLD_END, h->share = 1, h->radius = q->r1[p];
        h->gap = distance_between(start, end);
        h->straight = true;
        copy_point(h->base, end);
    }
}

static const double SHORTEST = 1e-3, NO_LENGTH = 1e-9; /* [m] */

/* Where a branch is attached along its parent. */
struct branch_station {
    double share;
    int32_t row;
};

struct joining {
    const struct wf_qsm *q;
    const struct hold_row *hold;
    struct wf_children children;
    struct wf_qsm_model *m;
    struct wf_tree *t;
    double shortest;               /* shorter rows become points [m]                        */
    int32_t *head;                 /* per row: segment whose end is the row's base; -1 ground */
    int32_t *tail;                 /* per row: segment whose end is the row's end             */
    int32_t *held;                 /* per row: segment to whose end it is attached            */
    struct branch_station *sorted; /* room for the children of one row                 */
};

/* Append a segment from the end of segment `below` (or `base` at the ground) to `end`. */
static int32_t append_segment(struct joining *b, int32_t below, const double base[3], const double end[3],
                              double r0, double r1, enum wf_segment_kind kind, size_t row)
{
    struct wf_tree *t = b->t;
    size_t k = t->n++;
    bool ground = below < 0;
    t->parent[k] = below;
    t->level[k] = b->q->order[row];
    t->id[k] = b->q->id[row];
    t->x0[k] = ground ? base[0] : t->x1[below];
    t->y0[k] = ground ? base[1] : t->y1[below];
    t->z0[k] = ground ? base[2] : t->z1[below];
    t->x1[k] = end[0], t->y1[k] = end[1], t->z1[k] = end[2];
    t->r0[k] = r0, t->r1[k] = r1;
    b->m->kind[k] = (uint8_t)kind;
    b->m->row[k] = (int32_t)row;
    double volume = WF_PI / 3 * wf_tree_length(t, k) * (r0 * r0 + r0 * r1 + r1 * r1);
    if (kind != WF_SEGMENT_LINK) b->m->volume += volume;
    if (kind == WF_SEGMENT_BRIDGE) b->m->bridge_volume += volume;
    return (int32_t)k;
}

static void point_held_at(const struct joining *b, size_t i, double out[3])
{
    int32_t held = b->held[i];
    for (int k = 0; k < 3; k++) out[k] = b->hold[i].base[k];
    if (held >= 0) out[0] = b->t->x1[held], out[1] = b->t->y1[held], out[2] = b->t->z1[held];
}

/* Add what connects the attachment of row i to the start of its own wood: nothing, a link, or a link and a
 * bridge. Returned: the segment whose end is the row's base. */
static int32_t link_to_row(struct joining *b, size_t i)
{
    const struct hold_row *h = &b->hold[i];
    double from[3], to[3], across[3], r = b->q->r0[i];
    if (h->straight) {
        if (h->gap > joint_tolerance(h->radius)) b->m->gaps++;
        return b->held[i];
    }
    point_held_at(b, i, from);
    for (int k = 0; k < 3; k++) across[k] = h->base[k] - from[k];
    double gap = sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
    bool beyond = gap > h->radius + joint_tolerance(h->radius);
    for (int k = 0; k < 3; k++) to[k] = from[k] + across[k] * (beyond ? h->radius / gap : 1);
    double stout = fmax(r, fmin(h->radius, 3 * r));
    int32_t at = b->held[i];
    if (!beyond || h->radius > SHORTEST) {
        at = append_segment(b, at, from, to, stout, stout, WF_SEGMENT_LINK, i);
        b->m->links++;
    }
    if (!beyond) return at;
    b->m->bridges++;
    return append_segment(b, at, to, h->base, r, r, WF_SEGMENT_BRIDGE, i);
}

static int station_by_share(const void *x, const void *y)
{
    const struct branch_station *a = x, *b = y;
    return a->share < b->share ? -1 : a->share > b->share ? 1 : (a->row > b->row) - (a->row < b->row);
}

/* Collect the children of row i that are attached along its axis, sorted by their place. Returned: how many.
 */
static size_t sort_stations(struct joining *b, size_t i)
{
    size_t n = 0;
    for (int32_t k = b->children.begin[i]; k < b->children.begin[i + 1]; k++) {
        int32_t c = b->children.child[k];
        if (b->hold[c].at == HOLD_AXIS) b->sorted[n++] = (struct branch_station){ b->hold[c].share, c };
    }
    qsort(b->sorted, n, sizeof *b->sorted, station_by_share);
    return n;
}

/* Add the segments of row i, divided where branches are attached; branches closer to each other than the
 * tolerance share a point. */
static void add_wood(struct joining *b, size_t i)
{
    const struct wf_qsm *q = b->q;
    double base[3], end[3] = { q->x1[i], q->y1[i], q->z1[i] }, length = 0;
    int32_t below = b->head[i];
    for (int k = 0; k < 3; k++) base[k] = b->hold[i].base[k];
    if (below >= 0) base[0] = b->t->x1[below], base[1] = b->t->y1[below], base[2] = b->t->z1[below];
    for (int k = 0; k < 3; k++) length += (end[k] - base[k]) * (end[k] - base[k]);
    length = sqrt(length);
    size_t n = sort_stations(b, i);
    double done = 0, r = q->r0[i];
    if (length < b->shortest) {
        b->m->short_rows++;
        for (size_t k = 0; k < n; k++) b->held[b->sorted[k].row] = below;
        b->tail[i] = below;
        return;
    }
    for (size_t k = 0; k < n; k++) {
        size_t c = (size_t)b->sorted[k].row;
        double s = b->hold[c].share, point[3];
        double least = joint_tolerance(b->hold[c].radius) / length;
        if (!(done > 0 && s - done <= least) && 1 - s > 0.5 * least) {
            double r1 = q->r0[i] + s * (q->r1[i] - q->r0[i]);
            for (int d = 0; d < 3; d++) point[d] = base[d] + s * (end[d] - base[d]);
            below = append_segment(b, below, base, point, r, r1, WF_SEGMENT_WOOD, i);
            done = s, r = r1;
        }
        b->held[c] = below;
    }
    b->tail[i] = append_segment(b, below, base, end, r, q->r1[i], WF_SEGMENT_WOOD, i);
}

static void model_row(struct joining *b, size_t i)
{
    const struct hold_row *h = &b->hold[i];
    int32_t p = b->q->parent[i];
    if (h->at == HOLD_GROUND) b->held[i] = -1;
    if (h->at == HOLD_END) b->held[i] = b->tail[p];
    if (h->at == HOLD_BASE) b->held[i] = b->head[p];
    if (p >= 0 && b->q->next[p] != (int32_t)i) b->m->laterals++;
    double gap = h->gap - (h->straight ? 0 : h->radius);
    if (p >= 0 && gap > b->m->widest_gap) b->m->widest_gap = gap, b->m->widest_row = (int32_t)i;
    b->head[i] = link_to_row(b, i);
    add_wood(b, i);
}

static enum wf_status take_joining(struct joining *b, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_qsm *q = b->q;
    size_t most = q->n;
    for (size_t i = 0; i < q->n; i++)
        most += (b->hold[i].at == HOLD_AXIS ? 1U : 0U) + (b->hold[i].straight ? 0U : 2U);
    enum wf_status s = wf_tree_alloc(b->t, most, a, e);
    if (!s) s = wf_children_of(q->parent, q->n, a, &b->children, e);
    if (s) return s;
    b->m->kind = WF_TAKE(a, most, uint8_t);
    b->m->row = WF_TAKE(a, most, int32_t);
    b->head = WF_TAKE(a, q->n, int32_t);
    b->tail = WF_TAKE(a, q->n, int32_t);
    b->held = WF_TAKE(a, q->n, int32_t);
    b->sorted = WF_TAKE(a, q->n, struct branch_station);
    if (!b->m->kind || !b->m->row || !b->head || !b->tail || !b->held || !b->sorted)
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu segments", q->name, most);
    b->t->n = 0;
    b->t->name = q->name;
    return WF_OK;
}

enum wf_status wf_qsm_to_tree(const struct wf_qsm *q, enum wf_joint joint, struct wf_arena *a,
                              struct wf_qsm_model *out, struct wf_err *e)
{
    *out = (struct wf_qsm_model){ .widest_row = -1 };
    struct hold_row *hold = WF_TAKE(a, q->n, struct hold_row);
    if (!hold) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu rows", q->name, q->n);
    find_holds(q, joint, hold);
    struct joining b = { .q = q, .hold = hold, .m = out, .t = &out->tree };
    b.shortest = joint == WF_JOINT_AXIS ? SHORTEST : NO_LENGTH;
    enum wf_status s = take_joining(&b, a, e);
    if (s) return s;
    for (size_t i = 0; i < q->n; i++) model_row(&b, i);
    return out->tree.n ? WF_OK
                       : wf_fail(e, WF_EINPUT, "%s: no row is longer than %g mm", q->name, b.shortest * 1e3);
}
