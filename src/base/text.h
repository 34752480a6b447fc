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

/* "Did you mean": the nearest known word to a mistyped one. */

/* Number of single-letter changes, insertions, deletions and swaps of neighbours between two words, letter
 * case ignored (Damerau 1964, Levenshtein 1966; optimal string alignment). Words beyond 63 bytes are never
 * near. */
size_t wf_word_distance(const char *a, const char *b);
/* Whether `distance` is near enough to suggest a word of this length: 1 up to 4 letters, 2 up to 8, then 3.
 */
int wf_word_is_near(const char *word, size_t distance);
/* The nearest of n known words; when none is near, the first that is a short form of the word or the other
 * way round (three letters at least); else NULL. */
const char *wf_nearest(const char *word, const char *const *known, size_t n);
/* The end of a message about a word that is not known: "; did you mean 'NEAREST'?", or "" where none is near.
 * For use as an argument: wf_did_you_mean(word, known, n).text. */
struct wf_hint {
    char text[2048];
};
struct wf_hint wf_did_you_mean(const char *word, const char *const *known, size_t n);
/* The same; where no word is near "; OTHERWISE a, b, c" with all known words. */
struct wf_hint wf_did_you_mean_or(const char *word, const char *const *known, size_t n,
                                  const char *otherwise);
#endif
