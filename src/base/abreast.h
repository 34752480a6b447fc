/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_ABREAST_H
#define WF_BASE_ABREAST_H
/* Jobs of one thread by turns, each on a stack of its own: a job that comes to work which vector instructions
 * do for several at once waits for the others that come to it too. */
#include <stdbool.h>
#include <stddef.h>

/* Jobs of a thread at most. */
enum { WF_ABREAST = 24 };

/* Call run(context) so many times by turns, and return when all have returned. Where stacks cannot be
 * exchanged (sanitizers) or had: one call. May be called in a job. */
void wf_abreast(size_t copies, void *(*run)(void *context), void *context);

/* Is this a job? Also where stacks cannot be exchanged. */
bool wf_abreast_inside(void);

/* Work on requests, at least one of n. Those that are done are taken out of the list, the others stay in it
 * in their order. Returned: how many are left; they come again, with those of jobs that have gone on
 * meanwhile. */
typedef size_t wf_abreast_work(void **request, size_t n);
/* In a job: wait until all jobs have returned or wait; then the requests of those that wait for the same work
 * are worked on. Elsewhere: this one alone. Which requests come together must not change what becomes of
 * each. */
void wf_abreast_join(wf_abreast_work *work, void *request);
#endif
