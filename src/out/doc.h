/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_DOC_H
#define WF_OUT_DOC_H
/* Building a JSON document without a check after every line: a failure (no memory) is recorded in the
 * builder, later calls are harmless, and the writer checks once at the end. */
#include "base/err.h"
#include "base/file.h"
#include "out/folder.h"
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

struct wf_doc {
    bool failed;
};

/* A new object or array; without memory NULL, and the builder is marked as failed. */
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
enum { WF_DOC_FILES = 32 };
struct wf_doc_head {
    const char *title, *note;             /* given by the user; NULL: the page composes one    */
    const char *command, *version, *date; /* as typed; of the program; ISO 8601, UTC          */
    size_t files;                         /* that were read                                    */
    struct wf_doc_file {
        const char *role, *path;
    } file[WF_DOC_FILES];
};
/* A file that was read, which provenance names with its digest. NULL, one that is there and what is beyond
 * WF_DOC_FILES are passed over. */
void wf_doc_head_file(struct wf_doc_head *h, const char *role, const char *path);
/* A document {schema {name, version 1}, title, note, provenance {program, version, date, command, files}}. */
json_t *wf_doc_begin(struct wf_doc *d, const char *schema, const struct wf_doc_head *h);
/* Append a figure to a list that tells the page maker what to draw: {name, script, run}, see out/figures.h.
 */
void wf_doc_figure(struct wf_doc *d, json_t *list, const char *name, const char *script, size_t run);
/* Put a sentence by parts into an object, unless it is NULL: `message`, the English with {1} for each
 * argument, and `args` [{text}]. */
void wf_doc_said(struct wf_doc *d, json_t *o, const struct wf_said *said);
/* Append warnings {code, text, message, args} to a list, except those it already has. */
void wf_doc_warnings(struct wf_doc *d, json_t *list, const struct wf_diag *diag);
/* Write FOLDER/results.json and free the document. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_doc_end(struct wf_doc *d, json_t *document, const char *folder, struct wf_err *e);

/* Values that the figure scripts need in addition to the tables: FOLDER/plots/run.csv, rows
 * "key,index,value". It is data, never a script: reports/plots/facts.gp reads it with gnuplot's column
 * functions. */
struct wf_plot_data {
    struct wf_file f;
    bool failed; /* no memory for a text */
};

/* Begin FOLDER/plots/NAME.csv; the folder must exist. Errors: WF_EOUTPUT. */
enum wf_status wf_plot_data_begin(struct wf_plot_data *p, const char *folder, const char *name,
                                  struct wf_err *e);
/* A row with a number; what is not finite is written as NaN. index: from 1 in a list, 0 for a single value.
 */
void wf_plot_data_number(struct wf_plot_data *p, const char *key, size_t index, double x);
void wf_plot_data_count(struct wf_plot_data *p, const char *key, size_t index, size_t n);
/* A row with a text of a user, NULL as an empty one: quoted, with what gnuplot or its SVG would take for more
 * than text escaped, control characters as spaces, without the folders of files,
 * and cut with an ellipsis at 160 columns. */
void wf_plot_data_text(struct wf_plot_data *p, const char *key, size_t index, const char *text);
/* A row with a list of words or numbers of windfirm's own, which is not cut. */
void wf_plot_data_words(struct wf_plot_data *p, const char *key, size_t index, const char *words);
void wf_plot_data_print(struct wf_plot_data *p, const char *key, size_t index, const char *fmt, ...)
    __attribute__((format(printf, 4, 5)));
/* A row with a number given as text, as a document holds it. Errors: WF_EINPUT when it is not one number and
 * nothing else. */
enum wf_status wf_plot_data_parse(struct wf_plot_data *p, const char *key, size_t index, const char *text,
                                  struct wf_err *e);
/* Finish the file and give it its final name. Errors: as wf_file_commit; WF_ENOMEM. */
enum wf_status wf_plot_data_end(struct wf_plot_data *p, struct wf_err *e);
#endif
