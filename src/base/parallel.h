/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_PARALLEL_H
#define WF_BASE_PARALLEL_H
/* A parallel for over independent solves. The library starts threads nowhere else. */
#include "base/err.h"
#include <stddef.h>

/* Number of threads used when `asked` are requested: 0 = one per processor; at most 64. */
size_t wf_parallel_threads(size_t asked);
/* Call one(context, k, e) for k = 0..n-1, in any order, on wf_parallel_threads(threads) threads, of which the
 * caller's is one. `one` must write only what belongs to k; the result then does not depend on the number of
 * threads. If a thread cannot be started, the others do its work. After an interrupt (base/interrupt.h) no
 * further k is begun. Returned: WF_OK, or status and message of the lowest k that failed; WF_EINTERRUPTED
 * when some were not begun; WF_ENOMEM. */
enum wf_status wf_parallel(size_t n, size_t threads,
                           enum wf_status (*one)(void *context, size_t k, struct wf_err *e), void *context,
                           struct wf_err *e);
/* The same, with several k by turns on each thread (base/abreast.h). */
enum wf_status wf_parallel_abreast(size_t n, size_t threads,
                                   enum wf_status (*one)(void *context, size_t k, struct wf_err *e),
                                   void *context, struct wf_err *e);
#endif
