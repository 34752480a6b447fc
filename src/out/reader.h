/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_READER_H
#define WF_OUT_READER_H
/* Results folders read back. A folder may come from a stranger: it is data, and every file is checked for its
 * form before a stylesheet or gnuplot sees it. */
#include "base/err.h"
#include <jansson.h>

/* Read a results document. Each key that windfirm writes has a row with its type (a number, a count, text,
 * yes or no, a list, an object; null is a value that is not there); other keys are let through, but the
 * bounds hold for them too: size of the file (WF_READ_MAX), of texts, numbers and lists, depth of nesting.
 * Returned: *out, free with json_decref. Errors: WF_EINPUT, with line and column where it is not JSON,
 * otherwise with every wrong value as an error in `d`. */
enum wf_status wf_document_read(const char *path, json_t **out, struct wf_diag *d, struct wf_err *e);

/* Check the tables that the figures of FOLDER read, tables/ *.csv, plots/run.csv, plots/tree.csv and
 * plots/tree.dat: text in UTF-8 without control characters, a head of plain names, rows of as many cells, in
 * tree.dat nothing but numbers. Errors: WF_EINPUT with file, line and reason. */
enum wf_status wf_tables_check(const char *folder, struct wf_err *e);
#endif
