/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/qsm_repair.h"
#include "base/vec3.h"
#include "grow/qsm.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Step 1: ids to rows. */

static bool same_row(const struct wf_qsm *q, size_t i, size_t k)
{
    return q->parent_id[i] == q->parent_id[k] && q->x0[i] == q->x0[k] && q->y0[i] == q->y0[k] &&
           q->z0[i] == q->z0[k] && q->x1[i] == q->x1[k] && q->y1[i] == q->y1[k] && q->z1[i] == q->z1[k];
}

/* Is 0 the id of a row? Then a parent of 0 is that row, else it marks a root. */
static bool counts_from_zero(const struct wf_qsm *q)
{
    for (size_t i = 0; i < q->n; i++)
        if (q->id[i] == 0) return true;
    return false;
}

/* The file's mark of a root, as opposed to a parent that is not in the file. */
static bool marked_root(const struct wf_qsm *q, size_t i, bool zero_is_id)
{
    return q->parent_id[i] < 0 || (q->parent_id[i] == 0 && !zero_is_id);
}

/* Two roots with one id: the numbering starts again, and parents could be rows of either tree. */
static enum wf_status refuse_restart(const struct wf_qsm *q, size_t i, size_t k, struct wf_err *e)
{
    return wf_fail(
        e, WF_EINPUT,
        "%s:%zu: error: id %lld is that of an earlier root: the table holds several trees, one "
        "from (%.6g, %.6g, %.6g), one from (%.6g, %.6g, %.6g); put each into a file of its own, or "
        "write a column treeID and choose one by --tree-id",
        q->file, q->line[i], (long long)q->id[i], q->x0[k], q->y0[k], q->z0[k], q->x0[i], q->y0[i], q->z0[i]);
}

/* Build the index of ids. A repetition of an earlier row is removed; another row with the id of an earlier
 * one gets a new id. */
static enum wf_status enter_ids(struct wf_qsm *q, struct wf_ids *ids, struct wf_arena *a, struct wf_err *e)
{
    int32_t *keep = WF_TAKE(a, q->n, int32_t);
    if (!keep) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", q->n);
    enum wf_status s = wf_ids_begin(ids, q->id, q->n, a, e);
    if (s) return s;
    int64_t fresh = 0;
    bool zero_is_id = counts_from_zero(q);
    for (size_t i = 0; i < q->n; i++)
        if (q->id[i] > fresh) fresh = q->id[i];
    size_t kept = 0;
    for (size_t i = 0; i < q->n; i++) {
        int32_t earlier = wf_ids_enter(ids, (int32_t)i);
        if (earlier != (int32_t)i) {
            if (same_row(q, i, (size_t)earlier)) {
                wf_qsm_count(q, WF_REPAIR_SAME_ROW, 1, q->id[i]);
                continue;
            }
            if (marked_root(q, i, zero_is_id) && marked_root(q, (size_t)earlier, zero_is_id))
                return refuse_restart(q, i, (size_t)earlier, e);
            wf_qsm_count(q, WF_REPAIR_SAME_ID, 1, q->id[i]);
            q->id[i] = ++fresh;
            (void)wf_ids_enter(ids, (int32_t)i);
        }
        keep[kept++] = (int32_t)i;
    }
    if (kept == q->n) return WF_OK;
    if ((s = wf_qsm_pick(q, keep, kept, a, e))) return s;
    if ((s = wf_ids_begin(ids, q->id, q->n, a, e))) return s;
    for (size_t i = 0; i < q->n; i++) (void)wf_ids_enter(ids, (int32_t)i);
    return WF_OK;
}

static int32_t parent_row(struct wf_qsm *q, const struct wf_ids *ids, size_t i, bool zero_is_id)
{
    int64_t p = q->parent_id[i];
    if (p < 0) {
        wf_qsm_count(q, WF_NOTE_ROOT_MARK, 1, q->id[i]);
        return -1;
    }
    if (p == 0 && !zero_is_id) return -1;
    int32_t row = wf_ids_find(ids, p);
    if (row < 0) wf_qsm_count(q, WF_REPAIR_NO_PARENT, 1, q->id[i]);
    return row;
}

/* Remove repeated rows, renumber repeated ids, find the rows of parents and continuations. */
static enum wf_status qsm_resolve(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    struct wf_ids ids;
    enum wf_status s = enter_ids(q, &ids, a, e);
    if (s) return s;
    bool zero_is_id = wf_ids_find(&ids, 0) >= 0;
    if (zero_is_id) wf_qsm_count(q, WF_NOTE_FROM_ZERO, q->n, -1);
    for (size_t i = 0; i < q->n; i++) q->parent[i] = parent_row(q, &ids, i, zero_is_id);
    for (size_t i = 0; i < q->n; i++) {
        int32_t next = q->next_id[i] > 0 ? wf_ids_find(&ids, q->next_id[i]) : -1;
        q->next[i] = next >= 0 && q->parent[next] == (int32_t)i ? next : -1;
    }
    return WF_OK;
}

/* Steps 2 and 3: make the parents a tree (no cycles, no loose parts) and sort the rows. */

static const double STANDS = 0.5;       /* highest start of a stem above the ground level [m]       */
static const double SUBSTANTIAL = 0.01; /* least wood of a part that can define the ground level, of that of
                                           the largest part [-] */

/* Find the root of every row. A cycle of parents is cut at its lowest row, which becomes a root. */
static enum wf_status roots_of(struct wf_qsm *q, int32_t *root, struct wf_arena *a, struct wf_err *e)
{
    int32_t *path = WF_TAKE(a, q->n, int32_t);
    uint8_t *open = WF_TAKE(a, q->n, uint8_t);
    if (!path || !open) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", q->n);
    for (size_t i = 0; i < q->n; i++) root[i] = -1;
    for (size_t i = 0; i < q->n; i++) {
        size_t depth = 0;
        int32_t k = (int32_t)i;
        while (root[k] < 0 && !open[k]) {
            open[k] = 1;
            path[depth++] = k;
            if (q->parent[k] < 0) {
                root[k] = k;
                break;
            }
            k = q->parent[k];
        }
        if (root[k] < 0) { /* k is on the path: a cycle */
            int32_t low = k;
            for (int32_t m = q->parent[k]; m != k; m = q->parent[m])
                if (q->z0[m] < q->z0[low]) low = m;
            wf_qsm_count(q, WF_REPAIR_CYCLE, 1, q->id[low]);
            if (q->next[q->parent[low]] == low) q->next[q->parent[low]] = -1;
            q->parent[low] = -1;
            root[low] = k = low;
        }
        for (size_t d = 0; d < depth; d++) root[path[d]] = root[k];
    }
    return WF_OK;
}

/* Distance from a point to the surface of row i, negative inside [m]. */
static double to_surface(const struct wf_qsm *q, size_t i, double x, double y, double z)
{
    double ax = q->x1[i] - q->x0[i], ay = q->y1[i] - q->y0[i], az = q->z1[i] - q->z0[i];
    double px = x - q->x0[i], py = y - q->y0[i], pz = z - q->z0[i];
    double length2 = ax * ax + ay * ay + az * az;
    double s = length2 > 0 ? (px * ax + py * ay + pz * az) / length2 : 0;
    s = s < 0 ? 0 : s > 1 ? 1 : s;
    px -= s * ax, py -= s * ay, pz -= s * az;
    double r = q->r0[i] > 0 ? q->r0[i] : 0;
    return sqrt(px * px + py * py + pz * pz) - r;
}

enum { LOOSE = 1000 }; /* most loose parts: each needs a search over all rows */

struct loose {
    double z;
    int32_t row;
};

static int loose_by_height(const void *x, const void *y)
{
    const struct loose *a = x, *b = y;
    return a->z < b->z ? -1 : a->z > b->z ? 1 : (a->row > b->row) - (a->row < b->row);
}

static double ground_level(const struct wf_qsm *q, const double *wood)
{
    double most = 0, low = INFINITY;
    for (size_t i = 0; i < q->n; i++) most = wood[i] > most ? wood[i] : most;
    for (size_t i = 0; i < q->n; i++)
        if (q->parent[i] < 0 && wood[i] >= SUBSTANTIAL * most && q->z0[i] < low) low = q->z0[i];
    return low;
}

/* Lower the branch order of every row by step[its root], to 0 at the least. */
static void lower_orders(struct wf_qsm *q, const int32_t *root, const int32_t *step)
{
    for (size_t i = 0; i < q->n; i++)
        if (q->order[i] >= 0) q->order[i] = q->order[i] > step[root[i]] ? q->order[i] - step[root[i]] : 0;
}

/* Files that count orders from 1 at the stem. Only roots that the file marks count: where the stem was
 * removed, the lowest order left is that of a branch, and stays one. */
static void shift_orders(struct wf_qsm *q, const int32_t *root, const uint8_t *standing, int32_t *step)
{
    int32_t low = INT32_MAX;
    bool zero_is_id = counts_from_zero(q);
    for (size_t i = 0; i < q->n; i++)
        if (standing[i] && q->parent[i] < 0 && marked_root(q, i, zero_is_id) && q->order[i] >= 0 &&
            q->order[i] < low)
            low = q->order[i];
    if (low == INT32_MAX || low == 0) return;
    wf_qsm_count(q, WF_NOTE_ORDER_FROM, q->n, -1);
    for (size_t i = 0; i < q->n; i++) step[i] = low;
    lower_orders(q, root, step);
}

/* A stem has order 0. Where the file gives a root the order of a branch, the orders of its part are lowered.
 * Given: the root of every row; standing[root], NULL: all roots are stems. */
static enum wf_status zero_roots(struct wf_qsm *q, const int32_t *root, const uint8_t *standing,
                                 struct wf_arena *a, struct wf_err *e)
{
    int32_t *step = WF_TAKE(a, q->n, int32_t);
    if (!step) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", q->n);
    if (standing) shift_orders(q, root, standing, step);
    for (size_t i = 0; i < q->n; i++) {
        bool stem = q->parent[i] < 0 && (!standing || standing[i]) && q->order[i] > 0;
        step[i] = stem ? q->order[i] : 0;
        if (stem) wf_qsm_count(q, WF_REPAIR_ROOT_ORDER, 1, q->id[i]);
    }
    lower_orders(q, root, step);
    return WF_OK;
}

/* Raise the branch orders of a part that was joined to row `onto`, so that it is one order above that row. */
static void raise_orders(struct wf_qsm *q, const int32_t *root, int32_t part, int32_t onto)
{
    int32_t step = q->order[onto] + 1 - q->order[part];
    if (q->order[onto] < 0 || q->order[part] < 0 || q->order[part] >= q->order[onto]) return;
    for (size_t i = 0; i < q->n; i++)
        if (root[i] == part) q->order[i] += step;
}

/* Join a loose part to the nearest row whose branch order is not above its own, so that the orders of the
 * file stay; if there is none, to the nearest of all. */
static void join_part(struct wf_qsm *q, const int32_t *root, uint8_t *standing, int32_t part)
{
    double best = INFINITY, nearest = INFINITY;
    int32_t onto = -1, other = -1;
    for (size_t i = 0; i < q->n; i++) {
        if (!standing[root[i]]) continue;
        double d = to_surface(q, i, q->x0[part], q->y0[part], q->z0[part]);
        if (d < nearest) nearest = d, other = (int32_t)i;
        if (d < best && (q->order[part] < 0 || q->order[i] <= q->order[part])) best = d, onto = (int32_t)i;
    }
    wf_qsm_count(q, WF_REPAIR_LOOSE, 1, q->id[part]);
    if (onto < 0) onto = other;
    q->parent[part] = onto;
    raise_orders(q, root, part, onto);
    standing[part] = 1;
}

static const double APART = 2; /* largest distance of a further stem's base from the main one's [m] */

/* Further stems that stand apart are another tree, unless `force` takes them. Given: the parts, and the wood
 * of each by its root; parts below 1 % of the largest are not looked at. */
static enum wf_status stems_together(struct wf_qsm *q, const uint8_t *standing, const double *wood,
                                     bool force, struct wf_arena *a, struct wf_err *e)
{
    size_t first = 0, apart = 0;
    char list[512] = "";
    for (size_t i = 0; i < q->n; i++)
        if (q->parent[i] < 0 && standing[i] && (!standing[first] || wood[i] > wood[first])) first = i;
    for (size_t i = 0; i < q->n; i++) {
        if (q->parent[i] >= 0 || !standing[i] || wood[i] < SUBSTANTIAL * wood[first]) continue;
        double away = hypot(q->x0[i] - q->x0[first], q->y0[i] - q->y0[first]);
        if (away <= APART) continue;
        size_t n = strlen(list);
        if (apart++ < 4)
            (void)snprintf(list + n, sizeof list - n, "%sid %lld at (%.6g, %.6g), %.3g m away", n ? "; " : "",
                           (long long)q->id[i], q->x0[i], q->y0[i], away);
        wf_qsm_count(q, WF_NOTE_APART, 1, q->id[i]);
    }
    if (!apart) return WF_OK;
    if (force) {
        q->detail[WF_NOTE_APART] = wf_arena_text(a, list);
        return WF_OK;
    }
    return wf_fail(
        e, WF_EINPUT,
        "%s: error: %zu stem%s more than %g m from the main one (id %lld at (%.6g, %.6g)): %s%s; put "
        "each tree into a file of its own; --force takes them as stems of one tree",
        q->file, apart, apart == 1 ? " stands" : "s stand", APART, (long long)q->id[first], q->x0[first],
        q->y0[first], list, apart > 4 ? "; and others" : "");
}

/* Cut cycles and join loose parts. The ground level is the lowest start of a root whose part has at least 1 %
 * of the wood of the largest part. A root up to 0.5 m above it is a stem; the others are loose parts. From
 * the lowest up, each of them becomes a child of the row whose surface is nearest to its start, and keeps the
 * branch orders of the file. Errors: WF_EINPUT for more than 1000 loose parts, because then the parent column
 * does not fit the ids, and for stems that stand apart. */
static enum wf_status qsm_join(struct wf_qsm *q, bool force, struct wf_arena *a, struct wf_err *e)
{
    int32_t *root = WF_TAKE(a, q->n, int32_t);
    double *wood = WF_TAKE(a, q->n, double);
    uint8_t *standing = WF_TAKE(a, q->n, uint8_t);
    struct loose *part = WF_TAKE(a, q->n, struct loose);
    if (!root || !wood || !standing || !part)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", q->n);
    enum wf_status s = roots_of(q, root, a, e);
    if (s) return s;
    for (size_t i = 0; i < q->n; i++) {
        double r = q->r0[i] > 0 ? q->r0[i] : 0;
        wood[root[i]] += r * r * wf_qsm_distance(q, i);
    }
    double z = ground_level(q, wood);
    size_t parts = 0, stems = 0;
    for (size_t i = 0; i < q->n; i++) {
        if (q->parent[i] >= 0) continue;
        standing[i] = q->z0[i] <= z + STANDS;
        if (standing[i])
            stems++;
        else
            part[parts++] = (struct loose){ q->z0[i], (int32_t)i };
    }
    if (parts > LOOSE)
        return wf_fail(
            e, WF_EINPUT,
            "%s: %zu of %zu rows have no parent below them; the parent column does not fit the ids", q->name,
            parts, q->n);
    if (stems > 1) wf_qsm_count(q, WF_NOTE_STEMS, stems - 1, -1);
    if ((s = stems_together(q, standing, wood, force, a, e)) || (s = zero_roots(q, root, standing, a, e)))
        return s;
    qsort(part, parts, sizeof *part, loose_by_height);
    for (size_t k = 0; k < parts; k++) join_part(q, root, standing, part[k].row);
    return WF_OK;
}

/* Sort the rows so that every parent comes before its children. The file's order is kept if it does already.
 */
static enum wf_status qsm_sort(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    size_t late = 0;
    int64_t first = 0;
    for (size_t i = 0; i < q->n; i++)
        if (q->parent[i] > (int32_t)i && !late++) first = q->id[i];
    if (!late) return WF_OK;
    wf_qsm_count(q, WF_NOTE_SORTED, late, first);
    struct wf_children c;
    enum wf_status s = wf_children_of(q->parent, q->n, a, &c, e);
    if (s) return s;
    int32_t *stack = WF_TAKE(a, q->n, int32_t), *pick = WF_TAKE(a, q->n, int32_t);
    if (!stack || !pick) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", q->n);
    size_t depth = 0, n = 0;
    for (int32_t k = c.begin[q->n + 1]; k-- > c.begin[q->n];) stack[depth++] = c.child[k];
    while (depth) { /* depth first, children in the order of the file */
        int32_t i = pick[n++] = stack[--depth];
        for (int32_t k = c.begin[i + 1]; k-- > c.begin[i];) stack[depth++] = c.child[k];
    }
    return wf_qsm_pick(q, pick, n, a, e);
}

/* Step 4: lengths and radii that are missing or wrong. */

static const double NO_LENGTH = 1e-9; /* [m] */

/* Remove rows without length; their children become children of their parent. One pass is enough because
 * parents come first. */
static enum wf_status remove_points(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    int32_t *keep = WF_TAKE(a, q->n, int32_t);
    uint8_t *gone = WF_TAKE(a, q->n, uint8_t);
    if (!keep || !gone) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", q->n);
    size_t kept = 0;
    for (size_t i = 0; i < q->n; i++) {
        if (q->parent[i] >= 0 && gone[q->parent[i]]) q->parent[i] = q->parent[q->parent[i]];
        int32_t p = q->parent[i];
        gone[i] = !(wf_qsm_distance(q, i) > NO_LENGTH);
        if (!gone[i]) {
            keep[kept++] = (int32_t)i;
            continue;
        }
        wf_qsm_count(q, WF_REPAIR_ZERO_LENGTH, 1, q->id[i]);
        if (p >= 0 && q->next[p] == (int32_t)i) q->next[p] = q->next[i];
    }
    return kept == q->n ? WF_OK : wf_qsm_pick(q, keep, kept, a, e);
}

/* Fill missing radii: from the row below, from the row's other end, or, for a root, from its child. */
static enum wf_status fill_radii(struct wf_qsm *q, struct wf_err *e)
{
    for (size_t i = q->n; i-- > 0;) { /* from the tips down: a root may need its child's */
        int32_t p = q->parent[i];
        if (p >= 0 && q->parent[p] < 0 && !(q->r0[p] > 0) && !(q->r1[p] > 0) && q->r0[i] > 0) {
            wf_qsm_count(q, WF_REPAIR_RADIUS, 1, q->id[p]);
            q->r0[p] = q->r1[p] = q->r0[i];
        }
    }
    for (size_t i = 0; i < q->n; i++) {
        if (q->r0[i] > 0 && q->r1[i] > 0) continue;
        int32_t p = q->parent[i];
        double below = p >= 0 ? q->r1[p] : (double)NAN;
        if (isnan(q->r1[i]) && q->r0[i] > 0) { /* one radius a row: a cylinder */
            q->r1[i] = q->r0[i];
            continue;
        }
        wf_qsm_count(q, WF_REPAIR_RADIUS, 1, q->id[i]);
        if (q->r1[i] > 0)
            q->r0[i] = below > 0 ? below : q->r1[i];
        else
            q->r0[i] = q->r1[i] = q->r0[i] > 0 ? q->r0[i] : below;
        if (!(q->r0[i] > 0))
            return wf_fail(e, WF_EINPUT, "%s: row with id %lld has no radius and none below to take it from",
                           q->name, (long long)q->id[i]);
    }
    return WF_OK;
}

/* Remove rows shorter than 1e-9 m, fill missing radii and lengths. The rows must be sorted. */
static enum wf_status qsm_fill(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    enum wf_status s = remove_points(q, a, e);
    if (s) return s;
    if (!q->n) return wf_fail(e, WF_EINPUT, "%s: no row has a length", q->name);
    for (size_t i = 0; i < q->n; i++) {
        double d = wf_qsm_distance(q, i), stated = q->length[i];
        if (stated > 0 && fabs(stated - d) > 0.01 * d && fabs(stated - d) > 1e-3)
            wf_qsm_count(q, WF_REPAIR_LENGTH, 1, q->id[i]);
        else if (stated > 0 && fabs(stated - d) <= 0.01 * d)
            continue; /* a difference by the file's rounding: keep the stated length */
        q->length[i] = d;
    }
    return fill_radii(q, e);
}

/* Step 5: branches. Which row continues which, and the order of each row. */

/* Distance from the end of row p to the start of row i [m]. */
static double gap_to_child(const struct wf_qsm *q, int32_t p, int32_t i)
{
    double dx = q->x0[i] - q->x1[p], dy = q->y0[i] - q->y1[p], dz = q->z0[i] - q->z1[p];
    return sqrt(dx * dx + dy * dy + dz * dz);
}

/* The child that continues row p: if orders are known, the child of p's order that starts nearest to p's end;
 * otherwise the thickest that starts within one radius of p's end. -1: none. */
static int32_t find_continuation(const struct wf_qsm *q, const struct wf_children *c, int32_t p)
{
    int32_t best = -1;
    double best_step = INFINITY;
    for (int32_t k = c->begin[p]; k < c->begin[p + 1]; k++) {
        int32_t i = c->child[k];
        double d = gap_to_child(q, p, i);
        if (q->order[i] >= 0) {
            if (q->order[i] == q->order[p] && d < best_step) best = i, best_step = d;
        } else if (d <= q->r1[p] && (best < 0 || q->r0[i] > q->r0[best])) {
            best = i;
        }
    }
    return best;
}

/* Whether the continuation that the file names has another branch order. Some programs give the first row of
 * a lateral branch as the extension. */
static bool continues_other_order(const struct wf_qsm *q, size_t i)
{
    int32_t next = q->next[i];
    return next >= 0 && q->order[i] >= 0 && q->order[next] >= 0 && q->order[next] != q->order[i];
}

/* Rows that became roots when a row without length was removed are stems too. The rows must be sorted. */
static enum wf_status stems_of_order_0(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    int32_t *root = WF_TAKE(a, q->n, int32_t);
    if (!root) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", q->n);
    for (size_t i = 0; i < q->n; i++) root[i] = q->parent[i] < 0 ? (int32_t)i : root[q->parent[i]];
    return zero_roots(q, root, NULL, a, e);
}

/* Set branch orders (0 at the stem), continuations and branch numbers. The rows must be sorted. */
static enum wf_status qsm_branches(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    struct wf_children c;
    enum wf_status s = wf_children_of(q->parent, q->n, a, &c, e);
    if (!s) s = stems_of_order_0(q, a, e);
    if (s) return s;
    int32_t branches = 0;
    for (size_t i = 0; i < q->n; i++) {
        int32_t p = q->parent[i];
        if (continues_other_order(q, i)) q->next[i] = -1;
        bool goes_on = p >= 0 && q->next[p] == (int32_t)i;
        if (q->order[i] < 0) {
            wf_qsm_count(q, WF_NOTE_ORDER_MADE, 1, q->id[i]);
            q->order[i] = p < 0 ? 0 : q->order[p] + !goes_on;
        }
        q->branch[i] = goes_on ? q->branch[p] : ++branches;
        q->place[i] = goes_on ? q->place[p] + 1 : 1;
        if (q->next[i] < 0) q->next[i] = find_continuation(q, &c, (int32_t)i);
    }
    return WF_OK;
}

/* Step 6: rows that are thicker than what they grow on. */

static const double THICKER = 1.1; /* times the radius below, above which a row is counted [-] */

/* Radius of what row i grows on: of the row below in its branch at its end; of the parent where the branch
 * leaves it [m]. */
static double radius_below(const struct wf_qsm *q, size_t i)
{
    size_t p = (size_t)q->parent[i];
    if (q->next[p] == (int32_t)i) return q->r1[p];
    double axis[3] = { q->x1[p] - q->x0[p], q->y1[p] - q->y0[p], q->z1[p] - q->z0[p] };
    double from[3] = { q->x0[i] - q->x0[p], q->y0[i] - q->y0[p], q->z0[i] - q->z0[p] };
    double share = wf_dot(from, axis) / wf_dot(axis, axis);
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    return q->r0[p] + share * (q->r1[p] - q->r0[p]);
}

/* Count the rows that are thicker by a tenth than what they grow on, and name the worst of each kind; with
 * `cap`, thin them. The rows must be sorted: what grows on a thinned row is compared with the thinned radius.
 */
static void find_thick_rows(struct wf_qsm *q, bool cap, struct wf_arena *a)
{
    double worst[WF_REPAIR_COUNT] = { 0 };
    for (size_t i = 0; i < q->n; i++) {
        if (q->parent[i] < 0) continue;
        double below = radius_below(q, i), r = q->r0[i];
        if (r <= THICKER * below) continue;
        bool goes_on = q->next[q->parent[i]] == (int32_t)i;
        enum wf_repair what = cap ? WF_REPAIR_CAPPED : goes_on ? WF_NOTE_THICKENING : WF_NOTE_THICK_CHILD;
        wf_qsm_count(q, what, 1, q->id[i]);
        if (r / below > worst[what]) {
            worst[what] = r / below;
            q->detail[what] = wf_arena_print(a, "most: id %lld, %.3g mm on %.3g mm", (long long)q->id[i],
                                             2e3 * r, 2e3 * below);
        }
        if (cap) q->r0[i] = below, q->r1[i] = fmin(q->r1[i], below);
    }
}

/* Step 7: the origin. */

/* Move the tree: base of the main stem (the root with the largest base radius) to x = y = 0, lowest base to
 * z = 0. */
static void to_origin(struct wf_qsm *q)
{
    size_t main_root = 0;
    double low = INFINITY, thickest = 0;
    for (size_t i = 0; i < q->n; i++) {
        if (q->parent[i] >= 0) continue;
        if (q->r0[i] > thickest) thickest = q->r0[i], main_root = i;
        if (q->z0[i] < low) low = q->z0[i];
    }
    double bx = q->x0[main_root], by = q->y0[main_root];
    if (bx == 0 && by == 0 && low == 0) return;
    wf_qsm_count(q, WF_NOTE_OFFSET, 1, -1);
    q->base[0] = bx, q->base[1] = by, q->base[2] = low;
    for (size_t i = 0; i < q->n; i++) {
        q->x0[i] -= bx, q->x1[i] -= bx;
        q->y0[i] -= by, q->y1[i] -= by;
        q->z0[i] -= low, q->z1[i] -= low;
    }
}

static enum wf_status refuse_repairs(const struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    size_t kinds = 0;
    for (int k = 0; k < WF_REPAIR_COUNT; k++) {
        if (wf_repair_rows[k].note || !q->repairs.count[k]) continue;
        kinds++;
        wf_diag_error(d, q->file, 0, 0, "%s: %zu %s", wf_repair_rows[k].code, q->repairs.count[k],
                      wf_repair_rows[k].text);
    }
    if (!kinds) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s: needs %zu kinds of repair, which a strict import refuses", q->name,
                   kinds);
}

enum wf_status wf_qsm_repair(struct wf_qsm *q, const struct wf_import_options *o, struct wf_arena *a,
                             struct wf_diag *d, struct wf_err *e)
{
    if (!q->n) return wf_fail(e, WF_EINPUT, "%s: no cylinder in it", q->name);
    enum wf_status s = qsm_resolve(q, a, e);
    if (!s) s = qsm_join(q, o->force, a, e);
    if (!s) s = qsm_sort(q, a, e);
    if (!s) s = qsm_fill(q, a, e);
    if (!s) s = qsm_branches(q, a, e);
    if (s) return s;
    find_thick_rows(q, o->cap_children, a);
    to_origin(q);
    return o->strict ? refuse_repairs(q, d, e) : WF_OK;
}
