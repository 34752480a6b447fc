/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_DIAG_H
#define WF_BASE_DIAG_H
/* A list of findings: all mistakes of an input file (so that a user can correct them at once), and the
 * warnings of a run, such as a law used outside the range of its evidence. */
#include "base/arena.h"
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum wf_severity { WF_WARNING, WF_ERROR };

struct wf_finding {
    enum wf_severity severity;
    const char *file;    /* NULL: the finding is not about a file */
    size_t line, column; /* 1-based; 0 = unknown */
    const char *code;    /* short stable name for warnings, e.g. "small-deflection"; NULL for errors */
    const char *text;
    struct wf_finding *next;
};

struct wf_diag {
    struct wf_arena *arena; /* set by the caller before first use */
    struct wf_finding *first, *last;
    size_t errors, warnings;
};

/* Add an error. Given: file (NULL: none), line and column (1-based; 0: unknown), a printf format. An error is
 * counted even when there is no memory to keep its text. */
void wf_diag_error(struct wf_diag *d, const char *file, size_t line, size_t column, const char *fmt, ...)
    __attribute__((format(printf, 5, 6)));
/* Add a warning. Given: code, a short name that does not change between versions; a printf format. A warning
 * of the same code and text is added only once. */
void wf_diag_warn(struct wf_diag *d, const char *code, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* Sort the findings after `before` (NULL: all) by line and column. Findings at the same place keep their
 * order; those without a line come last. */
void wf_diag_sort(struct wf_diag *d, struct wf_finding *before);
/* Write "file:line:column: error: text" to buf[size], without the parts that are unknown. Returned: buf. */
char *wf_finding_print(const struct wf_finding *f, char *buf, size_t size);

#ifdef __cplusplus
}
#endif
#endif
