/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_TEXT_H
#define WF_BASE_TEXT_H
/* Text: validation of UTF-8, conversion of other encodings to it, text of users on terminals, in XML and in
 * figures, suggestions for mistyped words. */
#include "base/arena.h"
#include <stdbool.h>
#include <stddef.h>

struct wf_utf8_fault {
    size_t line, column; /* 1-based; the column counts characters */
    unsigned byte;
};

/* Whether size bytes are UTF-8 text as in RFC 3629: no overlong forms, no surrogates, nothing beyond
 * U+10FFFF; NUL is refused too. Returned: true, or false and the first fault. */
bool wf_utf8_valid(const char *text, size_t size, struct wf_utf8_fault *fault);

/* Text that came from a user, made fit for where it goes. Given: any bytes up to a NUL. Returned: text in the
 * arena, NULL without memory. */

/* For a terminal: what could move the cursor, change colours or reorder what is read (C0 and C1 controls,
 * DEL, marks of writing direction, line and paragraph separators) and bytes that are not UTF-8 are shown as
 * escapes, \x1b or \u202e. A tab stays. `end`: the character that stands for the end of a line, '\n' where
 * the text has no names in it; every other line end is shown as \x0a. */
const char *wf_text_for_terminal(const char *text, char end, struct wf_arena *a);
/* For XML 1.0 and what is drawn into SVG: characters that are not allowed there, and bytes that are not
 * UTF-8, are replaced by U+FFFD. */
const char *wf_text_for_xml(const char *text, struct wf_arena *a);
/* For a page that is handed on: of files that are named from the root ("/home/me/oak.yaml") the name alone,
 * the folders are nobody's business. */
const char *wf_text_without_folders(const char *text, struct wf_arena *a);
/* For a place of `columns` columns (at least 2; wide East Asian characters take two): a longer text is cut
 * and ends in an ellipsis. */
const char *wf_text_shortened(const char *text, size_t columns, struct wf_arena *a);

/* Byte order of UTF-16 text, by its byte order mark or by the zero bytes of its first two characters. */
enum wf_utf16 { WF_UTF16_NOT, WF_UTF16_LITTLE, WF_UTF16_BIG };
enum wf_utf16 wf_utf16_order(const char *text, size_t size);
/* Convert UTF-16 to UTF-8; a byte order mark is left out. Given: `to`, room for 3 bytes for each 2 of the
 * text. Returned: bytes written; (size_t)-1 when the text has an odd number of bytes, a NUL or half a
 * surrogate pair. */
size_t wf_utf16_to_utf8(const char *text, size_t size, enum wf_utf16 order, char *to);
/* Convert Windows-1252, of which ISO 8859-1 (Latin-1) is the printable part, to UTF-8. Given: `to`, room for
 * 3 times the size. Returned: bytes written; (size_t)-1 when a byte is a control character other than a tab
 * or a line end, is not in the code page, or when the text also has characters in UTF-8. */
size_t wf_cp1252_to_utf8(const char *text, size_t size, char *to);

/* The other way: UTF-8 as Windows-1252, with '?' for what that does not have. NULL: no memory. */
char *wf_utf8_to_cp1252(const char *text, struct wf_arena *a);

/* For comparing names: letters of ASCII, Latin-1 and Latin Extended-A in lower case without their accents (ß
 * becomes ss), combining accents left out, '-', '_' and several blanks as one, × as x; the rest, such as
 * Chinese, as it is. Returned: text in the arena, NULL without memory. */
const char *wf_text_folded(const char *text, struct wf_arena *a);

/* Is a text one of the names, which have blanks between and are written as it folds, with '_' for a blank? */
bool wf_text_among(const char *names, const char *text);

/* Distance between two words, letter case of ASCII ignored: the number of changes, insertions, deletions and
 * swaps of neighbouring characters (Damerau 1964, Levenshtein 1966; optimal string alignment). Returned:
 * (size_t)-1 when a word is longer than 63 characters. */
size_t wf_word_distance(const char *a, const char *b);
/* Whether a word at this distance is similar enough to be suggested: 1 for up to 4 characters, 2 for up to 8,
 * 3 for longer words. */
int wf_word_is_near(const char *word, size_t distance);
/* The most similar of n known words; when none is similar enough, the first that begins with the word or that
 * the word begins with (at least three letters); otherwise NULL. */
const char *wf_nearest(const char *word, const char *const *known, size_t n);
/* Cut off the blanks (not tabs) around a text, which is written to. */
char *wf_text_trim(char *text);
/* Next item of a list with commas, blanks around it cut off; an item may be empty. Given: what is left of the
 * list, which is written to; at the start the whole list. Returned: NULL after the last item. */
char *wf_list_item(char **rest);
/* The end of a message about an unknown word: "; did you mean 'NEAREST'?", or "" when no known word is
 * similar. For use as an argument: wf_did_you_mean(word, known, n).text. */
struct wf_hint {
    char text[2048];
};
struct wf_hint wf_did_you_mean(const char *word, const char *const *known, size_t n);
/* The same; when no known word is similar, "; OTHERWISE a, b, c" with all of them. */
struct wf_hint wf_did_you_mean_or(const char *word, const char *const *known, size_t n,
                                  const char *otherwise);
/* Bytes as text of base 64 (RFC 4648, with padding). NULL: no memory. */
char *wf_base64(const void *bytes, size_t n, struct wf_arena *a);
#endif
