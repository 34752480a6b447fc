/* Lengths and radii that a file lacks or gets wrong. */
#include "grow/qsm_parts.h"
#include <math.h>

static const double NO_LENGTH = 1e-9; /* [m] */

/* Remove rows without length; whoever hung on them hangs on what they hung on. Parents come first, so one
 * pass. */
static enum wf_status remove_points(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    int32_t *keep = WF_TAKE(a, q->n, int32_t);
    uint8_t *gone = WF_TAKE(a, q->n, uint8_t);
    if (!keep || !gone) return wf_fail(e, WF_ENOMEM, "no room for %zu cylinders", q->n);
    size_t kept = 0;
    for (size_t i = 0; i < q->n; i++) {
        int32_t p = q->parent[i];
        if (p >= 0 && gone[p]) {
            q->parent[i] = q->parent[p];
            if (q->parent[i] >= 0 && q->next[q->parent[i]] == p)
                q->next[q->parent[i]] = q->next[p] == (int32_t)i ? (int32_t)i : -1;
        }
        gone[i] = !(wf_qsm_distance(q, i) > NO_LENGTH);
        if (gone[i])
            wf_qsm_count(q, WF_REPAIR_ZERO_LENGTH, 1, q->id[i]);
        else
            keep[kept++] = (int32_t)i;
    }
    return kept == q->n ? WF_OK : wf_qsm_pick(q, keep, kept, a, e);
}

/* A radius from the row below, else from the other end, else from the first row above that has one. */
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

enum wf_status wf_qsm_fill(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    enum wf_status s = remove_points(q, a, e);
    if (s) return s;
    if (!q->n) return wf_fail(e, WF_EINPUT, "%s: no row has a length", q->name);
    for (size_t i = 0; i < q->n; i++) {
        double d = wf_qsm_distance(q, i), stated = q->length[i];
        if (stated > 0 && fabs(stated - d) > 0.01 * d && fabs(stated - d) > 1e-3)
            wf_qsm_count(q, WF_REPAIR_LENGTH, 1, q->id[i]);
        else if (stated > 0 && fabs(stated - d) <= 0.01 * d)
            continue; /* the rounding of the file: what it states stays */
        q->length[i] = d;
    }
    return fill_radii(q, e);
}
