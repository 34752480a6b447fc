/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/parallel.h"
#include "base/abreast.h"
#include "base/arena.h"
#include "base/interrupt.h"
#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

enum { THREADS_MAX = 64 };

struct parallel_job {
    size_t n;
    size_t abreast;     /* jobs of a thread by turns */
    atomic_size_t next; /* lowest k that no thread has started */
    enum wf_status (*one)(void *context, size_t k, struct wf_err *e);
    void *context;
    struct wf_err *why; /* n; code WF_OK: no error */
};

size_t wf_parallel_threads(size_t asked)
{
    long processors = asked ? (long)asked : sysconf(_SC_NPROCESSORS_ONLN);
    return processors < 1 ? 1 : processors > THREADS_MAX ? THREADS_MAX : (size_t)processors;
}

static void *parallel_worker(void *parallel_job)
{
    struct parallel_job *c = parallel_job;
    for (size_t k; !wf_interrupted() && (k = atomic_fetch_add(&c->next, 1)) < c->n;) {
        enum wf_status s = c->one(c->context, k, &c->why[k]);
        c->why[k].code = s;
    }
    return NULL;
}

static void *thread_begins(void *parallel_job)
{
    struct parallel_job *c = parallel_job;
    if (c->abreast < 2) return parallel_worker(c);
    wf_abreast(c->abreast < c->n ? c->abreast : c->n, parallel_worker, c);
    return NULL;
}

/* If a thread cannot be started, the others do its work. */
static void run_on_threads(struct parallel_job *c, size_t threads)
{
    pthread_t thread[THREADS_MAX];
    size_t wanted = wf_parallel_threads(threads), started = 0;
    while (started + 1 < wanted && started + 1 < c->n &&
           pthread_create(&thread[started], NULL, thread_begins, c) == 0)
        started++;
    (void)thread_begins(c);
    for (size_t k = 0; k < started; k++) pthread_join(thread[k], NULL);
}

static enum wf_status run(size_t n, size_t threads, size_t abreast,
                          enum wf_status (*one)(void *context, size_t k, struct wf_err *e), void *context,
                          struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct parallel_job c = {
        .n = n, .abreast = abreast, .one = one, .context = context, .why = WF_TAKE(&scratch, n, struct wf_err)
    };
    if (n && !c.why) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu solutions", n);
    run_on_threads(&c, threads);
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < n && !s; k++)
        if (c.why[k].code) s = wf_fail(e, c.why[k].code, "%s", c.why[k].text);
    if (!s && c.next < n) s = wf_fail(e, WF_EINTERRUPTED, "interrupted");
    wf_arena_free(&scratch);
    return s;
}

enum wf_status wf_parallel(size_t n, size_t threads,
                           enum wf_status (*one)(void *context, size_t k, struct wf_err *e), void *context,
                           struct wf_err *e)
{
    return run(n, threads, 1, one, context, e);
}

enum wf_status wf_parallel_abreast(size_t n, size_t threads,
                                   enum wf_status (*one)(void *context, size_t k, struct wf_err *e),
                                   void *context, struct wf_err *e)
{
    return run(n, threads, WF_ABREAST, one, context, e);
}
