/* Rings, loose parts and order of the rows: from any parent column to a tree. */
#include "grow/qsm_parts.h"
#include <math.h>
#include <stdlib.h>

static const double STANDS = 0.5;       /* a root this far above the ground still stands on it [m]   */
static const double SUBSTANTIAL = 0.01; /* of the largest part: a part that may define the ground */

/* Colour every row by the root it hangs from; a ring found on the way is cut at its lowest row. */
static enum wf_status roots_of(struct wf_qsm *q, int32_t *root, struct wf_arena *a, struct wf_err *e)
{
    int32_t *path = WF_TAKE(a, q->n, int32_t);
    uint8_t *open = WF_TAKE(a, q->n, uint8_t);
    if (!path || !open) return wf_fail(e, WF_ENOMEM, "no room for %zu cylinders", q->n);
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
        if (root[k] < 0) { /* k is on the path: a ring */
            int32_t low = k;
            for (int32_t m = q->parent[k]; m != k; m = q->parent[m])
                if (q->z0[m] < q->z0[low]) low = m;
            wf_qsm_count(q, WF_REPAIR_CYCLE, 1, q->id[low]);
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

enum { LOOSE = 1000 }; /* parts; more are no tree, and each takes a search over all rows */

struct loose {
    double z;
    int32_t row;
};

static int lower(const void *x, const void *y)
{
    const struct loose *a = x, *b = y;
    return a->z < b->z ? -1 : a->z > b->z ? 1 : (a->row > b->row) - (a->row < b->row);
}

static double ground(const struct wf_qsm *q, const double *wood)
{
    double most = 0, low = INFINITY;
    for (size_t i = 0; i < q->n; i++) most = wood[i] > most ? wood[i] : most;
    for (size_t i = 0; i < q->n; i++)
        if (q->parent[i] < 0 && wood[i] >= SUBSTANTIAL * most && q->z0[i] < low) low = q->z0[i];
    return low;
}

/* Children of a part that begins at order 0 again follow the order of what it was joined to. */
static void raise(struct wf_qsm *q, const int32_t *root, int32_t part, int32_t onto)
{
    int32_t step = q->order[onto] + 1 - q->order[part];
    if (q->order[onto] < 0 || q->order[part] < 0 || q->order[part] >= q->order[onto]) return;
    for (size_t i = 0; i < q->n; i++)
        if (root[i] == part) q->order[i] += step;
}

static void join(struct wf_qsm *q, const int32_t *root, uint8_t *standing, int32_t part)
{
    double best = INFINITY;
    int32_t onto = -1;
    for (size_t i = 0; i < q->n; i++) {
        if (!standing[root[i]]) continue;
        double d = to_surface(q, i, q->x0[part], q->y0[part], q->z0[part]);
        if (d < best) best = d, onto = (int32_t)i;
    }
    wf_qsm_count(q, WF_REPAIR_LOOSE, 1, q->id[part]);
    q->parent[part] = onto;
    raise(q, root, part, onto);
    standing[part] = 1;
}

enum wf_status wf_qsm_join(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    int32_t *root = WF_TAKE(a, q->n, int32_t);
    double *wood = WF_TAKE(a, q->n, double);
    uint8_t *standing = WF_TAKE(a, q->n, uint8_t);
    struct loose *part = WF_TAKE(a, q->n, struct loose);
    if (!root || !wood || !standing || !part) return wf_fail(e, WF_ENOMEM, "no room for %zu cylinders", q->n);
    enum wf_status s = roots_of(q, root, a, e);
    if (s) return s;
    for (size_t i = 0; i < q->n; i++) {
        double r = q->r0[i] > 0 ? q->r0[i] : 0;
        wood[root[i]] += r * r * wf_qsm_distance(q, i);
    }
    double z = ground(q, wood);
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
    qsort(part, parts, sizeof *part, lower);
    for (size_t k = 0; k < parts; k++) join(q, root, standing, part[k].row);
    return WF_OK;
}

enum wf_status wf_qsm_sort(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
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
    if (!stack || !pick) return wf_fail(e, WF_ENOMEM, "no room for %zu cylinders", q->n);
    size_t depth = 0, n = 0;
    for (int32_t k = c.begin[q->n + 1]; k-- > c.begin[q->n];) stack[depth++] = c.child[k];
    while (depth) { /* depth first, children in the order of the file */
        int32_t i = pick[n++] = stack[--depth];
        for (int32_t k = c.begin[i + 1]; k-- > c.begin[i];) stack[depth++] = c.child[k];
    }
    return wf_qsm_pick(q, pick, n, a, e);
}
