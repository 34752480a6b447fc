/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_EDITED_H
#define WF_TESTS_EDITED_H
/* A good text with one place changed, and the findings that must follow: one row a mistake. */
#include "scratch.h"

struct edit {
    const char *was, *is; /* was == NULL: `is` is the whole text */
    const char *findings;
};

/* `good` with the first `was` replaced; the caller frees it. */
static inline char *edited(const char *good, const struct edit *k)
{
    if (!k->was) return strdup(k->is);
    const char *at = strstr(good, k->was);
    if (!at) fail_msg("the text has no '%s'", k->was);
    char *text = malloc(strlen(good) + strlen(k->is) + 1);
    sprintf(text, "%.*s%s%s", (int)(at - good), good, k->is, at + strlen(k->was));
    return text;
}

/* Every row's findings, those and no others. findings_of reads a text that must be refused and prints what
 * was found into buf. */
static inline void assert_mistakes_are_named(const char *good, const struct edit *rows, size_t n,
                                             void (*findings_of)(const char *text, char *buf, size_t size))
{
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++) {
        char *text = edited(good, &rows[i]), found[2048];
        findings_of(text, found, sizeof found);
        if (strcmp(found, rows[i].findings) != 0) {
            print_error("'%s' for '%s' gives\n%s\ninstead of\n%s\n", rows[i].is,
                        rows[i].was ? rows[i].was : "all", found, rows[i].findings);
            wrong++;
        }
        free(text);
    }
    assert_int_equal(wrong, 0);
}
#endif
