/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_ARENA_H
#define WF_BASE_ARENA_H
/* An arena allocator: memory for one run is allocated in pieces and freed all at once. What wf_arena_take
 * returns is aligned to 64 bytes and zeroed. A zero-initialised struct wf_arena is empty and has no limit. */
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_arena_block;
struct wf_piped;
struct wf_arena {
    struct wf_arena_block *block; /* newest block */
    size_t used;                  /* bytes handed out so far */
    size_t limit;                 /* refuse beyond this many bytes; 0 = no limit */
    struct wf_piped *piped;       /* pipes that were read into it (base/file.c) */
};

/* Allocate n elements of `size` bytes, zeroed. Returned: a pointer, or NULL when memory or the limit is
 * exhausted or n * size overflows. n == 0 gives a valid non-NULL pointer. */
void *wf_arena_take(struct wf_arena *a, size_t n, size_t size);
/* The same, not zeroed. */
void *wf_arena_take_unset(struct wf_arena *a, size_t n, size_t size);
/* Copy a string into the arena. Returned: the copy; NULL when memory or the limit is exhausted. */
char *wf_arena_text(struct wf_arena *a, const char *text);
/* printf into the arena. Returned: the text; NULL when memory or the limit is exhausted. */
char *wf_arena_print(struct wf_arena *a, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
/* Move everything that `from` holds to `a`; addresses do not change. `from` is then empty. */
void wf_arena_join(struct wf_arena *a, struct wf_arena *from);
/* Free all memory of the arena; it is then empty and can be used again. Large blocks are kept, up to 512 MB, for
 * arenas of this process; wf_arena_drop_spare gives them back to the system. */
void wf_arena_free(struct wf_arena *a);
void wf_arena_drop_spare(void);

/* n zeroed elements of type T from arena `a`, or NULL. */
#define WF_TAKE(a, n, T) ((T *)wf_arena_take((a), (n), sizeof(T)))

#ifdef __cplusplus
}
#endif
#endif
