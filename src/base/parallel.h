/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_PARALLEL_H
#define WF_BASE_PARALLEL_H
/* Solutions that do not depend on each other, shared out to the processors: the only threads of the library.
 */
#include "base/err.h"
#include <stddef.h>

/* Threads that so many are asked for come to: 0 is as many as there are processors; at most 64. */
size_t wf_together_threads(size_t asked);
/* Call one(context, k, e) for k = 0..n-1, in any order, from so many threads (see above) at once; the calling
 * one is among them. `one` writes what belongs to k alone, so that any number of threads gives the same
 * bytes. Returned: WF_OK, or status and error of the lowest k that failed; WF_ENOMEM. */
enum wf_status wf_together(size_t n, size_t threads,
                           enum wf_status (*one)(void *context, size_t k, struct wf_err *e), void *context,
                           struct wf_err *e);
#endif
