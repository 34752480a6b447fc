/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_SAID_H
#define WF_BASE_SAID_H
/* A sentence with its arguments apart, so that it can be said in another language: the English sentence with
 * "{1}" for each conversion of its printf format, by which a translation is found, and each argument as the
 * format prints it. */
#include "base/arena.h"
#include <stdarg.h>
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WF_SAID_MOST = 16 }; /* arguments */

struct wf_said {
    const char *message; /* "the crown is {1} m wide"; NULL: not known */
    size_t n;
    const char *arg[WF_SAID_MOST];
    int width[WF_SAID_MOST]; /* of the field that the format gives an argument; negative: to the left */
};

/* Take a printf format and its arguments apart. Given: arena, format without %n and $, its arguments.
 * Returned: the parts in *out, without the blanks that fill a field; false without memory, or when there are
 * more than WF_SAID_MOST arguments. */
bool wf_said_take(struct wf_arena *a, const char *fmt, va_list args, struct wf_said *out);

/* A copy in another arena. Returned: NULL for NULL, and without memory. */
const struct wf_said *wf_said_copy(const struct wf_said *said, struct wf_arena *a);

/* A text with "{1}", "{2}" ... replaced. Given: n texts for them. Returned: the text, NULL without memory. */
char *wf_said_put(struct wf_arena *a, const char *message, const char *const *arg, size_t n);

#ifdef __cplusplus
}
#endif
#endif
