/* Branches of a table of cylinders: which row continues which, and of what order each is. */
#include "grow/qsm_parts.h"
#include <math.h>

/* Distance from the end of row p to the start of row i [m]. */
static double step(const struct wf_qsm *q, int32_t p, int32_t i)
{
    double dx = q->x0[i] - q->x1[p], dy = q->y0[i] - q->y1[p], dz = q->z0[i] - q->z1[p];
    return sqrt(dx * dx + dy * dy + dz * dz);
}

/* The child that continues row p: of p's own order when orders are known (nearest start wins), else the
 * thickest that starts within one radius of p's end. -1 when none does. */
static int32_t continuation(const struct wf_qsm *q, const struct wf_children *c, int32_t p)
{
    int32_t best = -1;
    double best_step = INFINITY;
    for (int32_t k = c->begin[p]; k < c->begin[p + 1]; k++) {
        int32_t i = c->child[k];
        double d = step(q, p, i);
        if (q->order[i] >= 0) {
            if (q->order[i] == q->order[p] && d < best_step) best = i, best_step = d;
        } else if (d <= q->r1[p] && (best < 0 || q->r0[i] > q->r0[best])) {
            best = i;
        }
    }
    return best;
}

/* Some programs name as extension the first row of a branch: what differs in order does not continue. */
static bool false_step(const struct wf_qsm *q, size_t i)
{
    int32_t next = q->next[i];
    return next >= 0 && q->order[i] >= 0 && q->order[next] >= 0 && q->order[next] != q->order[i];
}

static void shift_orders(struct wf_qsm *q)
{
    int32_t low = INT32_MAX;
    for (size_t i = 0; i < q->n; i++)
        if (q->parent[i] < 0 && q->order[i] >= 0 && q->order[i] < low) low = q->order[i];
    if (low == INT32_MAX || low == 0) return;
    wf_qsm_count(q, WF_NOTE_ORDER_FROM, q->n, -1);
    for (size_t i = 0; i < q->n; i++)
        if (q->order[i] >= 0) q->order[i] = q->order[i] > low ? q->order[i] - low : 0;
}

/* The way up along the thickest wood. */
static void limbs(struct wf_qsm *q)
{
    for (size_t i = 0; i < q->n; i++) q->limb[i] = q->next[i];
    for (size_t i = 0; i < q->n; i++) {
        int32_t p = q->parent[i];
        if (p < 0 || q->next[p] >= 0) continue;
        if (q->limb[p] < 0 || q->r0[i] > q->r0[q->limb[p]]) q->limb[p] = (int32_t)i;
    }
}

enum wf_status wf_qsm_branches(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e)
{
    struct wf_children c;
    enum wf_status s = wf_children_of(q->parent, q->n, a, &c, e);
    if (s) return s;
    shift_orders(q);
    int32_t branches = 0;
    for (size_t i = 0; i < q->n; i++) {
        int32_t p = q->parent[i];
        if (false_step(q, i)) q->next[i] = -1;
        bool goes_on = p >= 0 && q->next[p] == (int32_t)i;
        if (q->order[i] < 0) {
            wf_qsm_count(q, WF_NOTE_ORDER_MADE, 1, q->id[i]);
            q->order[i] = p < 0 ? 0 : q->order[p] + !goes_on;
        }
        q->branch[i] = goes_on ? q->branch[p] : ++branches;
        q->place[i] = goes_on ? q->place[p] + 1 : 1;
        if (q->next[i] < 0) q->next[i] = continuation(q, &c, (int32_t)i);
        if (goes_on && q->r0[i] > 1.1 * q->r1[p]) wf_qsm_count(q, WF_NOTE_THICKENING, 1, q->id[i]);
    }
    limbs(q);
    return WF_OK;
}
