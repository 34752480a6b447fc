/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TONGUE_H
#define WF_OUT_TONGUE_H
/* What the program says in English, in the language of a page or a terminal. The catalogue is
 * reports/messages.xml: an English text, with {1}, {2} ... for what is put in, and its translation. An
 * English text is looked up as a whole, never searched for words; one that was put together elsewhere, as an
 * error is, is taken apart by the English texts with arguments. What has none stays English. The pages' own
 * words are those of reports/strings.xml, by keys, of which the names <q> and <k>
 * are known here too. */
#include "base/err.h"
#include <libxml/tree.h>

struct wf_tongue;

/* Read the catalogue. Given: language "en" (names of quantities alone) or "zh". Returned: the catalogue in
 * *out, to be closed. Errors: WF_EINPUT, WF_EMISSING when it cannot be read. */
enum wf_status wf_tongue_open(const char *language, struct wf_tongue **out, struct wf_err *e);
void wf_tongue_close(struct wf_tongue *t);

/* A name of the user's or a species' that has another form in the language; NULL is passed over. */
void wf_tongue_name(struct wf_tongue *t, const char *name, const char *own);

/* A text without arguments. Returned: its translation, or `english`. */
const char *wf_tongue_text(const struct wf_tongue *t, const char *english);

/* A sentence by parts. Arguments that are texts of the catalogue, or lists of such, are translated too.
 * Returned: the sentence; NULL where the catalogue does not have it, or without memory. */
char *wf_tongue_say(const struct wf_tongue *t, const struct wf_said *said, struct wf_arena *a);

/* Every text of a results document: elements of which the catalogue has the text, and `text` beside `message`
 * and `args`. */
void wf_tongue_translate(struct wf_tongue *t, xmlNode *results);
#endif
