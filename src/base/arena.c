/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/arena.h"
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum { ALIGN = 64, FIRST_BLOCK = 1 << 14, LARGEST_STEP = 1 << 24 };

struct wf_arena_block {
    struct wf_arena_block *older;
    unsigned char *room; /* aligned start of the payload */
    size_t size, used;   /* of the payload [bytes] */
};

/* Large blocks are read from end to end many times: with large pages that takes fewer page faults and fewer
 * address look-ups. Only a hint, without effect where the system has no such pages. Not beyond the first 256
 * MB of an arena: a virtual machine can take longer to find that many large pages than they save. */
static void ask_for_large_pages(const struct wf_arena *a, void *block, size_t bytes)
{
#ifdef MADV_HUGEPAGE
    const uintptr_t page = (uintptr_t)1 << 21;
    uintptr_t start = ((uintptr_t)block + page - 1) & ~(page - 1);
    uintptr_t end = ((uintptr_t)block + bytes) & ~(page - 1);
    if (end > start && a->used < (size_t)1 << 28) (void)madvise((void *)start, end - start, MADV_HUGEPAGE);
#else
    (void)a, (void)block, (void)bytes;
#endif
}

/* Allocate a new block with room for at least `bytes`. Each block is twice as large as the one before, up to
 * LARGEST_STEP, so few are needed. calloc, because the operating system zeroes the pages of a large block
 * only when they are first used. */
static struct wf_arena_block *arena_block(struct wf_arena *a, size_t bytes)
{
    size_t size = a->block ? a->block->size * 2 : FIRST_BLOCK;
    if (size > LARGEST_STEP) size = LARGEST_STEP;
    if (size < bytes) size = bytes;
    const size_t head = sizeof(struct wf_arena_block) + ALIGN;
    if (size > SIZE_MAX - head) return NULL;
    struct wf_arena_block *b = calloc(1, size + head);
    if (!b) return NULL;
    ask_for_large_pages(a, b, size + head);
    uintptr_t start = (uintptr_t)(b + 1);
    b->room = (unsigned char *)(b + 1) + (ALIGN - start % ALIGN) % ALIGN;
    b->size = size;
    b->older = a->block;
    a->block = b;
    return b;
}

static void *arena_bytes(struct wf_arena *a, size_t bytes, size_t align)
{
    struct wf_arena_block *b = a->block;
    size_t pad = b ? (align - b->used % align) % align : 0;
    bool fits = b && pad <= b->size - b->used && bytes <= b->size - b->used - pad;
    if (!fits) pad = 0;
    if (bytes > SIZE_MAX - pad - a->used) return NULL;
    if (a->limit && a->used + pad + bytes > a->limit) return NULL;
    if (!fits && !(b = arena_block(a, bytes))) return NULL;
    void *p = b->room + b->used + pad;
    b->used += pad + bytes;
    a->used += pad + bytes;
    return p;
}

void *wf_arena_take(struct wf_arena *a, size_t n, size_t size)
{
    if (size && n > SIZE_MAX / size) return NULL;
    return arena_bytes(a, n * size, ALIGN);
}

char *wf_arena_text(struct wf_arena *a, const char *text)
{
    size_t bytes = strlen(text) + 1;
    char *p = arena_bytes(a, bytes, 1);
    return p ? memcpy(p, text, bytes) : NULL;
}

char *wf_arena_print(struct wf_arena *a, const char *fmt, ...)
{
    va_list args, again;
    va_start(args, fmt);
    va_copy(again, args);
    int n = vsnprintf(NULL, 0, fmt, args);
    char *p = n < 0 ? NULL : arena_bytes(a, (size_t)n + 1, 1);
    if (p) (void)vsnprintf(p, (size_t)n + 1, fmt, again);
    va_end(again);
    va_end(args);
    return p;
}

void wf_arena_join(struct wf_arena *a, struct wf_arena *from)
{
    struct wf_arena_block **oldest = &a->block;
    while (*oldest) oldest = &(*oldest)->older;
    *oldest = from->block;
    a->used += from->used;
    from->block = NULL;
    from->used = 0;
}

void wf_arena_free(struct wf_arena *a)
{
    for (struct wf_arena_block *b = a->block, *older; b; b = older) {
        older = b->older;
        free(b);
    }
    a->block = NULL;
    a->piped = NULL;
    a->used = 0;
}
