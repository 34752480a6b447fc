#ifndef WF_BASE_NEAR_H
#define WF_BASE_NEAR_H
/* "Did you mean": the nearest known word to a mistyped one. */
#include <stddef.h>

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
#endif
