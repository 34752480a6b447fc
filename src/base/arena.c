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

/* Sizes of blocks, with their heads [bytes] */
enum { ALIGN = 64, FIRST_BLOCK = 1 << 14, LARGEST_STEP = 1 << 24 };

struct wf_arena_block {
    struct wf_arena_block *older;
    unsigned char *room; /* aligned start of the payload */
    size_t size, used;   /* of the payload [bytes] */
    size_t dirty;        /* so many bytes of it may not be zero */
    size_t mapped;       /* bytes from the system, in large pages; 0: from the heap */
};
static const size_t head = sizeof(struct wf_arena_block) + ALIGN;

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

/* The smallest block of at least that size and at most four times it, of several the last that was freed;
 * where there is none, the largest that has room for `bytes`. NULL: neither is spare. */
static struct wf_arena_block *take_spare(size_t size, size_t bytes)
{
    struct wf_arena_block **fits = NULL, **less = NULL, *b = NULL;
    pthread_mutex_lock(&spare.lock);
    for (struct wf_arena_block **at = &spare.first; *at; at = &(*at)->older) {
        const size_t has = (*at)->size;
        if (has >= size && (has + head) / 4 <= size + head && (!fits || has < (*fits)->size)) fits = at;
        if (has < size && has >= bytes && (!less || has > (*less)->size)) less = at;
    }
    if (!fits) fits = less;
    if (fits) b = *fits, *fits = b->older, spare.bytes -= b->size;
    pthread_mutex_unlock(&spare.lock);
    return b;
}

static void give_back(struct wf_arena_block *b)
{
    if (b->mapped)
        (void)munmap(b, b->mapped);
    else
        free(b);
}

void wf_arena_drop_spare(void)
{
    pthread_mutex_lock(&spare.lock);
    struct wf_arena_block *b = spare.first;
    spare.first = NULL, spare.bytes = 0;
    pthread_mutex_unlock(&spare.lock);
    for (struct wf_arena_block *older; b; b = older) {
        older = b->older;
        give_back(b);
    }
}

static void free_block(struct wf_arena_block *b)
{
    if (b->dirty < b->used) b->dirty = b->used;
    b->used = 0;
    bool keep = b->size >= SPARE_LEAST;
    if (keep) {
        pthread_mutex_lock(&spare.lock);
        keep = spare.bytes + b->size <= SPARE_MOST;
        if (keep) b->older = spare.first, spare.first = b, spare.bytes += b->size;
        pthread_mutex_unlock(&spare.lock);
    }
    if (!keep) give_back(b);
}

/* Large blocks are read from end to end many times: in large pages that takes fewer page faults and fewer
 * address look-ups. Only a hint, without effect where the system has no such pages. Not beyond the first 256
 * MB of an arena: a virtual machine can take longer to find that many large pages than they save. */
enum { LARGE_PAGE = 1 << 21, LARGE_MOST = 1 << 28 };

/* Zeroed memory of whole large pages. NULL: the system has none so. */
static void *map_large(size_t bytes)
{
#if defined(MADV_HUGEPAGE) && defined(MAP_ANONYMOUS)
    if (SPARE_MOST == 0 || bytes > SIZE_MAX - LARGE_PAGE) return NULL;
    unsigned char *p =
        mmap(NULL, bytes + LARGE_PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) return NULL;
    const size_t before = (LARGE_PAGE - (uintptr_t)p % LARGE_PAGE) % LARGE_PAGE;
    if (before) (void)munmap(p, before);
    if (before < LARGE_PAGE) (void)munmap(p + before + bytes, LARGE_PAGE - before);
    (void)madvise(p + before, bytes, MADV_HUGEPAGE);
    return p + before;
#else
    (void)bytes;
    return NULL;
#endif
}

/* A new block of that size. calloc, because the operating system zeroes the pages of a large block only when
 * they are first used. */
static struct wf_arena_block *new_block(const struct wf_arena *a, size_t size)
{
    const size_t bytes = size + head;
    struct wf_arena_block *b = NULL;
    if (bytes % LARGE_PAGE == 0 && a->used < LARGE_MOST && (b = map_large(bytes))) b->mapped = bytes;
    if (!b && !(b = calloc(1, bytes))) return NULL;
    uintptr_t start = (uintptr_t)(b + 1);
    b->room = (unsigned char *)(b + 1) + (ALIGN - start % ALIGN) % ALIGN;
    b->size = size;
    return b;
}

/* Add a block with room for at least `bytes`: twice as large as the one before, up to LARGEST_STEP, so few
 * are needed; a large one has whole large pages. */
static struct wf_arena_block *arena_block(struct wf_arena *a, size_t bytes)
{
    size_t size = a->block ? 2 * (a->block->size + head) : FIRST_BLOCK;
    if (bytes > SIZE_MAX - head - LARGE_PAGE) return NULL;
    if (size > LARGEST_STEP) size = LARGEST_STEP;
    if (size < bytes + head) size = bytes + head;
    if (size > LARGE_PAGE / 2) size += (LARGE_PAGE - size % LARGE_PAGE) % LARGE_PAGE;
    size -= head;
    struct wf_arena_block *b = size >= SPARE_LEAST ? take_spare(size, bytes) : NULL;
    if (!b && !(b = new_block(a, size))) return NULL;
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
