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
#endif
