#ifndef WF_GROW_QSM_INDEX_H
#define WF_GROW_QSM_INDEX_H
/* Small indices over a table of cylinders: row of an id, children of a row. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>
#include <stdint.h>

/* Open-addressing hash from id to row; the first row with an id keeps it. */
struct wf_ids {
    size_t slots; /* a power of two, at least twice the ids */
    int32_t *row; /* -1 = free                              */
    const int64_t *id;
};
enum wf_status wf_ids_begin(struct wf_ids *x, const int64_t *id, size_t n, struct wf_arena *a,
                            struct wf_err *e);
/* Enter row i under id[i]. Returned: i, or the earlier row that has this id. */
int32_t wf_ids_enter(struct wf_ids *x, int32_t i);
/* Row of an id; -1 when there is none. */
int32_t wf_ids_find(const struct wf_ids *x, int64_t id);

/* Children of row i: child[begin[i] .. begin[i+1]), in row order; roots: child[begin[n] .. begin[n+1]). */
struct wf_children {
    int32_t *begin, *child;
};
enum wf_status wf_children_of(const int32_t *parent, size_t n, struct wf_arena *a, struct wf_children *out,
                              struct wf_err *e);
#endif
