/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_WORDS_H
#define WF_CASES_WORDS_H
/* A line of a case file as words with their columns; the reader of a key takes them from left to right. A
 * wrong word is reported once, with line and column, and the reader returns false. */
#include "base/arena.h"
#include "base/err.h"
#include "base/units.h"
#include <stdbool.h>
#include <stddef.h>

enum { WF_WORDS_MAX = 40 };

struct wf_words {
    const char *file, *key; /* key = first word, for messages */
    size_t line, n, next;   /* number of the line, of its words; next word to take */
    const char *word[WF_WORDS_MAX];
    size_t column[WF_WORDS_MAX], end_column;
    const char *rest; /* text after the key, blanks trimmed, '#' kept */
    bool plain;       /* the file is non-dimensional: numbers carry no units */
    struct wf_units *units;
    struct wf_arena *arena;
    struct wf_diag *diag;
};

/* Split `text` (one line, copied to the arena) into words. A word that begins with '#' ends the line. Words
 * beyond WF_WORDS_MAX are only in `rest`. Returned: false when out of memory (reported). */
bool wf_words_split(struct wf_words *w, const char *text, size_t length);

/* Report a mistake at word k (k == n: the end of the line). Always false. */
bool wf_words_wrong(struct wf_words *w, size_t k, const char *fmt, ...) __attribute__((format(printf, 3, 4)));

/* Next word, without taking it; NULL at the end of the line. */
const char *wf_words_peek(const struct wf_words *w);
/* Take the next word if it is `text`. */
bool wf_words_skip(struct wf_words *w, const char *text);
/* Take one of n known words; otherwise report it, suggesting the nearest. `what` names it in messages.
 * Returned: *out, index of the word. */
bool wf_words_choice(struct wf_words *w, const char *what, const char *const *known, size_t n, size_t *out);
/* Take one number without unit. */
bool wf_words_number(struct wf_words *w, const char *what, double *out);
/* Take a whole number within low..high. */
bool wf_words_whole(struct wf_words *w, const char *what, long long low, long long high, long long *out);
/* Take low..high numbers and then their common unit. Returned: out in SI, *count; a lone "-" becomes NAN
 * where `gaps` is true; the unit as written in *unit_text (NULL: not wanted). The unit is every word up to
 * the end of the line or up to the word `stop` (NULL: none). */
bool wf_words_quantities(struct wf_words *w, enum wf_dimension d, size_t low, size_t high, bool gaps,
                         const char *stop, double *out, size_t *count, const char **unit_text);
/* Report any word left on the line; true when there is none. */
bool wf_words_end(struct wf_words *w);

/* A growing list in an arena. */
struct wf_list {
    void *data;
    size_t n, room;
};
/* Add one element to a list; false when there is no memory. */
bool wf_list_add(struct wf_list *l, const void *element, size_t size, struct wf_arena *a);
#endif
