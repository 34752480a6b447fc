/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_NUM_H
#define WF_BASE_NUM_H
/* Decimal text to double, the same in every locale. */
#include <stddef.h>

/* Given: text from `s` up to `end`, `point` the decimal sign ('.' or ',').
 * Returned: just behind the longest number [+-]digits[.digits][e[+-]digits] at `s` and the value, correctly
 * rounded; NULL when there is no number, or it is beyond the range of a double (1e999, 1e-999).
 * Not numbers: nan, inf, hexadecimal.
 * Method: up to 19 digits with a power of ten within 22 are exact in one operation (Clinger 1990); the rest
 * goes through strtod. */
const char *wf_number_read(const char *s, const char *end, char point, double *value);

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

/* GSL without its error handler, which ends the program: inside such a stretch its functions return their
 * codes. The handler is one for the whole process, so stretches of several threads are counted: the first
 * puts it away, the last puts it back. Every begin needs its end. */
void wf_quiet_begin(void);
void wf_quiet_end(void);
#endif
