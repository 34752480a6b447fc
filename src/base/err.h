/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_ERR_H
#define WF_BASE_ERR_H
/* Errors. Every function that can fail returns a status code, which its callers pass on, and writes a message
 * to a struct wf_err, where the first message is kept. The library never prints and never exits. */
#include "base/arena.h"
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum wf_status {
    WF_OK = 0,
    WF_EUSAGE,       /* a wrong call or command line                         -> exit 2 */
    WF_EINPUT,       /* an input file or value is missing, unreadable, wrong -> exit 2 */
    WF_EOUTPUT,      /* a result could not be written                        -> exit 1 */
    WF_ENOMEM,       /* no memory, or an arena's limit reached               -> exit 1 */
    WF_ENOCONV,      /* an iteration did not converge                        -> exit 1 */
    WF_EUNSTABLE,    /* no equilibrium of the tree under its loads was found -> exit 1 */
    WF_EMISSING,     /* an outside program or optional part is not installed -> exit 1 */
    WF_EINTERNAL,    /* a fault of this library                              -> exit 1 */
    WF_EINTERRUPTED, /* ended early by a signal                            -> exit 128 + its number */
    WF_STATUS_COUNT
};

struct wf_err {
    enum wf_status code; /* WF_OK: no error yet; initialise with { 0 } */
    char text[1024];
};

/* Record an error. Given: e (may be NULL), code, a printf format. Returned: code, so that callers can write
 * `return wf_fail(e, ...)`. When `e` already holds an error it is left unchanged. */
enum wf_status wf_fail(struct wf_err *e, enum wf_status code, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));

/* A status code in words; never NULL. */
const char *wf_status_text(enum wf_status code);

#ifdef __cplusplus
}
#endif

/* A list of findings: all mistakes of an input file (so that a user can correct them at once), and the
 * warnings of a run, such as a law used outside the range of its evidence. */

#ifdef __cplusplus
extern "C" {
#endif

enum wf_severity { WF_WARNING, WF_ERROR };

struct wf_said;
struct wf_finding {
    enum wf_severity severity;
    const char *file;    /* NULL: the finding is not about a file */
    size_t line, column; /* 1-based; 0 = unknown */
    const char *code;    /* short stable name for warnings, e.g. "small-deflection"; NULL for errors */
    const char *text;
    const struct wf_said *said; /* the text by parts, of a warning (base/said.h); NULL: none */
    struct wf_finding *next;
};

struct wf_diag {
    struct wf_arena *arena; /* set by the caller before first use */
    struct wf_finding *first, *last;
    size_t errors, warnings;
    bool mute; /* set by the caller: warnings are not wanted */
};

/* Add an error. Given: file (NULL: none), line and column (1-based; 0: unknown), a printf format. An error is
 * counted even when there is no memory to keep its text. */
void wf_diag_error(struct wf_diag *d, const char *file, size_t line, size_t column, const char *fmt, ...)
    __attribute__((format(printf, 5, 6)));
/* Add a warning. Given: code, a short name that does not change between versions; a printf format. A warning
 * of the same code and text is added only once. */
void wf_diag_warn(struct wf_diag *d, const char *code, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* Add a warning of another list. */
void wf_diag_pass(struct wf_diag *d, const struct wf_finding *warning);
/* Sort the findings after `before` (NULL: all) by line and column. Findings at the same place keep their
 * order; those without a line come last. */
void wf_diag_sort(struct wf_diag *d, struct wf_finding *before);
/* Write the place of a finding, "file:line:column: ", to buf[size]; empty where it has none. Returned: buf.
 */
char *wf_finding_place(const struct wf_finding *f, char *buf, size_t size);
/* Write "file:line:column: error: text" to buf[size], without the parts that are unknown. Returned: buf. */
char *wf_finding_print(const struct wf_finding *f, char *buf, size_t size);

#ifdef __cplusplus
}
#endif
#endif
