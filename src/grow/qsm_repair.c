/* The order in which a table of cylinders is made sound. */
#include "grow/qsm_parts.h"
#include <math.h>

/* Base of the main stem (the standing root thickest at its base) to x = y = 0, the lowest base to z = 0. */
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

static enum wf_status refuse(const struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
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

enum wf_status wf_qsm_repair(struct wf_qsm *q, bool strict, struct wf_arena *a, struct wf_diag *d,
                             struct wf_err *e)
{
    if (!q->n) return wf_fail(e, WF_EINPUT, "%s: no cylinder in it", q->name);
    enum wf_status s = wf_qsm_resolve(q, a, e);
    if (!s) s = wf_qsm_join(q, a, e);
    if (!s) s = wf_qsm_sort(q, a, e);
    if (!s) s = wf_qsm_fill(q, a, e);
    if (!s) s = wf_qsm_branches(q, a, e);
    if (s) return s;
    to_origin(q);
    return strict ? refuse(q, d, e) : WF_OK;
}
