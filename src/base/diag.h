/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_DIAG_H
#define WF_BASE_DIAG_H
/* A list of findings: every mistake of an input file at once, and every validity warning of a run. */
#include "base/arena.h"
#include <stdbool.h>
#include <stddef.h>

enum wf_severity { WF_WARNING, WF_ERROR };

struct wf_finding {
    enum wf_severity severity;
    const char *file;    /* NULL when not about a file */
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

/* Add an error about a place of a file. */
void wf_diag_error(struct wf_diag *d, const char *file, size_t line, size_t column, const char *fmt, ...)
    __attribute__((format(printf, 5, 6)));
/* Add a warning of a run: `code` is a stable short name; the same code and text is kept once. */
void wf_diag_warn(struct wf_diag *d, const char *code, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* Put the findings after `before` (NULL: all) in the order of their lines and columns; those that were at one
 * place keep their order, those without a line come last. */
void wf_diag_sort(struct wf_diag *d, struct wf_finding *before);
/* Write "file:line:column: error: text" (parts that are unknown left out) to buf. Returned: buf. */
char *wf_finding_print(const struct wf_finding *f, char *buf, size_t size);
#endif
