/* Ids of a table of cylinders to rows. */
#include "grow/qsm_parts.h"

static bool same_row(const struct wf_qsm *q, size_t i, size_t k)
{
    return q->parent_id[i] == q->parent_id[k] && q->x0[i] == q->x0[k] && q->y0[i] == q->y0[k] &&
           q->z0[i] == q->z0[k] && q->x1[i] == q->x1[k] && q->y1[i] == q->y1[k] && q->z1[i] == q->z1[k];
}

/* Enter every id; a repeated row is dropped, another row under a known id gets a fresh one. */
static enum wf_status enter(struct wf_qsm *q, struct wf_ids *ids, struct wf_arena *a, struct wf_err *e)
{
    int32_t *keep = WF_TAKE(a, q->n, int32_t);
    if (!keep) return wf_fail(e, WF_ENOMEM, "no room for %zu cylinders", q->n);
    enum wf_status s = wf_ids_begin(ids, q->id, q->n, a, e);
    if (s) return s;
    int64_t fresh = 0;
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

enum wf_status wf_qsm_resolve(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    struct wf_ids ids;
    enum wf_status s = enter(q, &ids, a, e);
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
