/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_DOC_H
#define WF_OUT_DOC_H
/* Building a JSON document without a check after every line: a failure (no memory) is noted in the
 * builder, later calls do nothing harmful, and the writer asks once at the end. */
#include "base/diag.h"
#include "base/err.h"
#include <jansson.h>
#include <stdbool.h>

struct wf_doc {
    bool failed;
};

/* A new object or array; NULL, and failed, without memory. */
json_t *wf_doc_object(struct wf_doc *d);
json_t *wf_doc_array(struct wf_doc *d);
/* Put `value` (its reference is taken over) under a key, or at an array's end. Returned: value. */
json_t *wf_doc_put(struct wf_doc *d, json_t *object, const char *key, json_t *value);
json_t *wf_doc_add(struct wf_doc *d, json_t *array, json_t *value);

/* Text; NULL becomes null. Bytes that are not UTF-8 become '?'. */
void wf_doc_text(struct wf_doc *d, json_t *object, const char *key, const char *text);
void wf_doc_count(struct wf_doc *d, json_t *object, const char *key, size_t n);
void wf_doc_flag(struct wf_doc *d, json_t *object, const char *key, bool flag);
/* {"value": x, "unit": "..."}; a number that is not finite becomes null with "reason". */
json_t *wf_doc_quantity(struct wf_doc *d, json_t *object, const char *key, double x, const char *unit,
                        const char *reason);
/* A bare number, null when not finite. */
void wf_doc_number(struct wf_doc *d, json_t *object, const char *key, double x);
/* An array of n bare numbers. */
void wf_doc_numbers(struct wf_doc *d, json_t *object, const char *key, const double *x, size_t n);

/* Where a document comes from. */
struct wf_doc_head {
    const char *title, *note;             /* the user's own; NULL: the page composes one */
    const char *command, *version, *date; /* as typed; of the program; ISO 8601, UTC     */
};
/* A document {schema {name, version 1}, title, note, provenance {program, version, date, command}}. */
json_t *wf_doc_begin(struct wf_doc *d, const char *schema, const struct wf_doc_head *h);
/* Append a figure to a list that tells the page maker what to draw: {name, script, run}, see out/figures.h.
 */
void wf_doc_figure(struct wf_doc *d, json_t *list, const char *name, const char *script, size_t run);
/* Append warnings {code, text} to a list, but those it has already. */
void wf_doc_warnings(struct wf_doc *d, json_t *list, const struct wf_diag *diag);
/* Write FOLDER/results.json and free the document. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_doc_end(struct wf_doc *d, json_t *document, const char *folder, struct wf_err *e);
#endif
