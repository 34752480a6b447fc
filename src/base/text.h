/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_TEXT_H
#define WF_BASE_TEXT_H
/* Is it text? RFC 3629: no overlong forms, no surrogates, nothing beyond U+10FFFF; NUL is not text either. */
#include <stdbool.h>
#include <stddef.h>

struct wf_utf8_fault {
    size_t line, column; /* 1-based; the column counts characters */
    unsigned byte;
};

/* Given: size bytes. Returned: true when all are UTF-8 text; else false and the first offending place. */
bool wf_utf8_valid(const char *text, size_t size, struct wf_utf8_fault *fault);
#endif
