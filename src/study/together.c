#include "study/together.h"
#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

enum { THREADS_MAX = 64 };

struct crowd {
    size_t n;
    atomic_size_t next; /* nobody has taken it yet */
    void (*one)(void *context, size_t k);
    void *context;
};

size_t wf_together_threads(size_t asked)
{
    long processors = asked ? (long)asked : sysconf(_SC_NPROCESSORS_ONLN);
    return processors < 1 ? 1 : processors > THREADS_MAX ? THREADS_MAX : (size_t)processors;
}

static void *work(void *crowd)
{
    struct crowd *c = crowd;
    for (size_t k; (k = atomic_fetch_add(&c->next, 1)) < c->n;) c->one(c->context, k);
    return NULL;
}

/* Threads that cannot be started are not missed. */
void wf_together(size_t n, size_t threads, void (*one)(void *context, size_t k), void *context)
{
    struct crowd c = { .n = n, .one = one, .context = context };
    pthread_t thread[THREADS_MAX];
    size_t wanted = wf_together_threads(threads), started = 0;
    while (started + 1 < wanted && started + 1 < n && pthread_create(&thread[started], NULL, work, &c) == 0)
        started++;
    work(&c);
    for (size_t k = 0; k < started; k++) pthread_join(thread[k], NULL);
}
