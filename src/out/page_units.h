/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_PAGE_UNITS_H
#define WF_OUT_PAGE_UNITS_H
/* Units of what is printed. Stylesheets and texts are written in metric units. A text is turned into other
 * units where a number stands before its unit, number and unit together, or neither: what is not recognised
 * keeps the number and the unit that it was written with. results.json and tables stay in SI. */
#include "base/arena.h"
#include <stddef.h>

/* Systems of units, "metric", "imperial", "cn"; NULL after the last. */
const char *wf_page_units_word(size_t i);

/* A unit in another system: `factor` times the number, and how the new one is written. */
struct wf_page_unit {
    const char *from, *to;
    double factor;
};
/* The row of a system for a unit, in n bytes; word joiners are passed over. NULL: the unit stays. */
const struct wf_page_unit *wf_page_unit_find(const char *system, const char *from, size_t n);
/* The i-th row of a system; from == NULL after the last. */
const struct wf_page_unit *wf_page_unit_row(const char *system, size_t i);

/* What stylesheets put around numbers where the system is not metric (reports/words.xsl), so that they are
 * turned with all their digits; characters of the private use area, removed when a text is turned:
 *     MARK full MARK_SHOWN shown MARK_END   a number, with all its digits and as it is shown in metric units
 *     AS_TYPED ... AS_TYPED_END             a text that stays as somebody typed it
 *     MARK_LIST                             before the comma or the word between two numbers of a list
 *     MARK_NODE                             between texts that are turned as one */
#define WF_MARK "\xee\x80\x80"         /* U+E000 */
#define WF_MARK_SHOWN "\xee\x80\x81"   /* U+E001 */
#define WF_MARK_END "\xee\x80\x82"     /* U+E002 */
#define WF_AS_TYPED "\xee\x80\x83"     /* U+E003 */
#define WF_AS_TYPED_END "\xee\x80\x84" /* U+E004 */
#define WF_MARK_LIST "\xee\x80\x85"    /* U+E005 */
#define WF_MARK_NODE "\xee\x80\x86"    /* U+E006: stays in the text */

/* Turn the numbers of a text, in UTF-8. Given: `column`, the unit of all of its numbers; NULL: the one behind
 * each. Returned: text in the arena, NULL without memory. */
char *wf_page_units_turned(const char *system, const char *text, const struct wf_page_unit *column,
                           struct wf_arena *a);
#endif
