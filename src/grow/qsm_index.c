#include "grow/qsm_index.h"

static size_t slot(const struct wf_ids *x, int64_t id)
{
    /* multiplicative hashing, Knuth 1998 (TAOCP 3, 6.4): the golden ratio spreads consecutive ids */
    return (size_t)(((uint64_t)id * UINT64_C(0x9E3779B97F4A7C15)) >> 20) & (x->slots - 1);
}

enum wf_status wf_ids_begin(struct wf_ids *x, const int64_t *id, size_t n, struct wf_arena *a,
                            struct wf_err *e)
{
    x->id = id;
    for (x->slots = 16; x->slots < 2 * n; x->slots *= 2) {
    }
    x->row = WF_TAKE(a, x->slots, int32_t);
    if (!x->row) return wf_fail(e, WF_ENOMEM, "no room for the index of %zu ids", n);
    for (size_t k = 0; k < x->slots; k++) x->row[k] = -1;
    return WF_OK;
}

int32_t wf_ids_enter(struct wf_ids *x, int32_t i)
{
    size_t k = slot(x, x->id[i]);
    for (; x->row[k] >= 0; k = (k + 1) & (x->slots - 1))
        if (x->id[x->row[k]] == x->id[i]) return x->row[k];
    x->row[k] = i;
    return i;
}

int32_t wf_ids_find(const struct wf_ids *x, int64_t id)
{
    for (size_t k = slot(x, id); x->row[k] >= 0; k = (k + 1) & (x->slots - 1))
        if (x->id[x->row[k]] == id) return x->row[k];
    return -1;
}

enum wf_status wf_children_of(const int32_t *parent, size_t n, struct wf_arena *a, struct wf_children *out,
                              struct wf_err *e)
{
    int32_t *begin = WF_TAKE(a, n + 2, int32_t), *child = WF_TAKE(a, n, int32_t);
    int32_t *at = WF_TAKE(a, n + 1, int32_t);
    if (!begin || !child || !at) return wf_fail(e, WF_ENOMEM, "no room for the branching of %zu rows", n);
    for (size_t i = 0; i < n; i++) begin[(parent[i] < 0 ? n : (size_t)parent[i]) + 1]++;
    for (size_t i = 0; i <= n; i++) {
        begin[i + 1] += begin[i];
        at[i] = begin[i];
    }
    for (size_t i = 0; i < n; i++) child[at[parent[i] < 0 ? n : (size_t)parent[i]]++] = (int32_t)i;
    *out = (struct wf_children){ begin, child };
    return WF_OK;
}
