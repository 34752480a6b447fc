/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/arena.h"
#include <pthread.h>
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
    size_t dirty;        /* so many bytes of it may not be zero */
};

/* Blocks that were freed, for the next arena: solutions follow each other with as much memory each, and new
 * pages from the operating system cost a tenth of their time. None where an address sanitizer is to notice
 * what is used after it was freed. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WATCHED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(WATCHED)
enum { SPARE_MOST = 0 };
#else
enum { SPARE_MOST = 1 << 29 };
#endif
enum { SPARE_LEAST = 1 << 16 }; /* bytes of a block that is kept */
static struct {
    pthread_mutex_t lock;
    struct wf_arena_block *first;
    size_t bytes;
} spare = { .lock = PTHREAD_MUTEX_INITIALIZER };

/* A block of at least that size and not much more; NULL: none is spare. */
static struct wf_arena_block *take_spare(size_t size)
{
    pthread_mutex_lock(&spare.lock);
    struct wf_arena_block **at = &spare.first, *b;
    while ((b = *at) && (b->size < size || b->size / 2 > size)) at = &b->older;
    if (b) *at = b->older, spare.bytes -= b->size;
    pthread_mutex_unlock(&spare.lock);
    return b;
}

void wf_arena_drop_spare(void)
{
    pthread_mutex_lock(&spare.lock);
    struct wf_arena_block *b = spare.first;
    spare.first = NULL, spare.bytes = 0;
    pthread_mutex_unlock(&spare.lock);
    for (struct wf_arena_block *older; b; b = older) {
        older = b->older;
        free(b);
    }
}

static void free_block(struct wf_arena_block *b)
{
    if (b->dirty < b->used) b->dirty = b->used;
    b->used = 0;
    bool keep = b->size >= SPARE_LEAST && b->size <= LARGEST_STEP;
    if (keep) {
        pthread_mutex_lock(&spare.lock);
        keep = spare.bytes + b->size <= SPARE_MOST;
        if (keep) b->older = spare.first, spare.first = b, spare.bytes += b->size;
        pthread_mutex_unlock(&spare.lock);
    }
    if (!keep) free(b);
}

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
    struct wf_arena_block *b = size >= SPARE_LEAST ? take_spare(size) : NULL;
    if (!b) {
        if (!(b = calloc(1, size + head))) return NULL;
        ask_for_large_pages(a, b, size + head);
        uintptr_t start = (uintptr_t)(b + 1);
        b->room = (unsigned char *)(b + 1) + (ALIGN - start % ALIGN) % ALIGN;
        b->size = size;
    }
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

void *wf_arena_take_unset(struct wf_arena *a, size_t n, size_t size)
{
    return size && n > SIZE_MAX / size ? NULL : arena_bytes(a, n * size, ALIGN);
}

void *wf_arena_take(struct wf_arena *a, size_t n, size_t size)
{
    unsigned char *p = wf_arena_take_unset(a, n, size);
    if (!p) return NULL;
    size_t from = (size_t)(p - a->block->room), dirty = a->block->dirty;
    if (from < dirty) memset(p, 0, n * size < dirty - from ? n * size : dirty - from);
    return p;
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
        free_block(b);
    }
    a->block = NULL;
    a->piped = NULL;
    a->used = 0;
}
