/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_ARENA_H
#define WF_BASE_ARENA_H
/* Memory of one run: taken in pieces, given back all at once. Blocks are 64-byte aligned and zeroed. */
#include <stddef.h>

struct wf_arena_block;
struct wf_arena {
    struct wf_arena_block *block; /* newest block */
    size_t used;                  /* bytes handed out so far */
    size_t limit;                 /* refuse beyond this many bytes; 0 = no limit */
};

/* A zero-initialised struct is an empty arena without a limit. */

/* Take n elements of `size` bytes, zeroed. Returned: pointer, or NULL when memory or the limit is
 * exhausted or n*size overflows. n == 0 gives a valid non-NULL pointer. */
void *wf_arena_take(struct wf_arena *a, size_t n, size_t size);
/* A copy of a string in the arena; NULL when there is no room. */
char *wf_arena_text(struct wf_arena *a, const char *text);
/* printf into the arena; NULL when there is no room. */
char *wf_arena_print(struct wf_arena *a, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
/* Give everything back; the arena is empty and usable again. */
void wf_arena_free(struct wf_arena *a);

#define WF_TAKE(a, n, T) ((T *)wf_arena_take((a), (n), sizeof(T)))
#endif
