/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/abreast.h"
#include <limits.h> /* says whether the library is GNU's */

/* Sanitizers follow one stack. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ONE_STACK 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define ONE_STACK 1
#endif

static _Thread_local size_t inside; /* calls of wf_abreast that run on this thread */
bool wf_abreast_inside(void) { return inside > 0; }

#ifdef ONE_STACK

void wf_abreast(size_t copies, void *(*run)(void *context), void *context)
{
    (void)copies;
    inside++;
    (void)run(context);
    inside--;
}

void wf_abreast_join(wf_abreast_work *work, void *request) { (void)work(&request, 1); }

#else

#include <sys/mman.h>
#include <ucontext.h>

enum { STACK = 1 << 20, GUARD = 1 << 16 }; /* bytes; pages of the stack are had when they are used */

struct job {
    ucontext_t at;
    char *stack;
    bool runs; /* it has not returned */
    wf_abreast_work *work;
    void *request;
};

struct crew {
    ucontext_t home;
    struct job job[WF_ABREAST];
    size_t n, now;
    void *(*run)(void *context);
    void *context;
};
static _Thread_local struct crew *crew; /* of the job that runs on this thread; NULL: none */

static void start(void)
{
    struct crew *c = crew;
    (void)c->run(c->context);
    c->job[c->now].runs = false;
} /* and on at home */

/* A job's stack, above a page that cannot be written. */
static bool take_job(struct crew *c)
{
    struct job *j = &c->job[c->n];
    char *room =
        mmap(NULL, STACK + GUARD, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0);
    if (room == MAP_FAILED) return false;
    if (mprotect(room, GUARD, PROT_NONE) || getcontext(&j->at)) {
        (void)munmap(room, STACK + GUARD);
        return false;
    }
    j->stack = room;
    j->at.uc_stack.ss_sp = room + GUARD, j->at.uc_stack.ss_size = STACK;
    j->at.uc_link = &c->home;
    makecontext(&j->at, start, 0);
    j->runs = true;
    c->n++;
    return true;
}

/* Every job that can, until it waits or returns. */
static void run_all(struct crew *c)
{
    for (c->now = 0; c->now < c->n; c->now++) {
        struct job *j = &c->job[c->now];
        if (j->runs && !j->work) (void)swapcontext(&c->home, &j->at);
    }
}

static bool among(void *const *list, size_t n, const void *one)
{
    size_t i = 0;
    while (i < n && list[i] != one) i++;
    return i < n;
}

/* Some of the work that the first of those that wait is for. Returned: false where none waits. */
static bool work_once(struct crew *c)
{
    void *request[WF_ABREAST];
    size_t n = 0;
    wf_abreast_work *work = NULL;
    for (size_t i = 0; i < c->n; i++) {
        if (!work) work = c->job[i].work;
        if (work && c->job[i].work == work) request[n++] = c->job[i].request;
    }
    if (!work) return false;
    n = work(request, n);
    for (size_t i = 0; i < c->n; i++)
        if (c->job[i].work == work && !among(request, n, c->job[i].request)) c->job[i].work = NULL;
    return true;
}

void wf_abreast(size_t copies, void *(*run)(void *context), void *context)
{
    struct crew c = { .run = run, .context = context }, *outer = crew;
    while (c.n < copies && c.n < WF_ABREAST && take_job(&c)) continue;
    crew = c.n ? &c : NULL;
    inside++;
    if (!c.n) (void)run(context);
    do {
        run_all(&c);
    } while (work_once(&c));
    inside--;
    crew = outer;
    for (size_t i = 0; i < c.n; i++) (void)munmap(c.job[i].stack, STACK + GUARD);
}

void wf_abreast_join(wf_abreast_work *work, void *request)
{
    struct crew *c = crew;
    if (!c) {
        (void)work(&request, 1);
        return;
    }
    struct job *j = &c->job[c->now];
    j->work = work, j->request = request;
    (void)swapcontext(&j->at, &c->home);
}

#endif
