/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_CSV_H
#define WF_BASE_CSV_H
/* Reader for tables from spreadsheets: text with a header row whose cells are separated by commas, semicolons
 * or tabs; the separator is detected from the header. The text is parsed in place. Accepted: quotes as in
 * RFC 4180 around at most WF_CSV_QUOTED bytes, any line end, a byte order mark, blank lines and lines that
 * start with '#'. Blanks around a cell are removed. Mistakes become errors in the list of findings, with line
 * and column; those beyond WF_CSV_LISTED of one file are only counted. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

enum { WF_CSV_LISTED = 100, WF_CSV_COLUMNS = 4096, WF_CSV_QUOTED = 65536 /* bytes of a quoted cell */ };

struct wf_cell {
    char *text; /* NUL-terminated, quotes resolved */
    size_t size;
    size_t
        column;  /* of its first byte in the line, 1-based; 0 = unknown (the row began on an earlier line) */
    size_t line; /* line of its first byte, 1-based */
};

struct wf_csv {
    const char *file;
    char *at, *end; /* the text not read yet         */
    size_t line;    /* line of `at`                  */
    char separator; /* ',' ';' or tab                */
    char point;     /* decimal sign, 0 = none seen yet */
    size_t columns;
    struct wf_cell *name; /* header cells                  */
    struct wf_cell *cell; /* cells of the current row      */
    size_t row;           /* rows read so far              */
    size_t row_line;      /* line the row starts on        */
    size_t mistakes;      /* of this file                  */
    struct wf_diag *diag;
};

/* The index of a column that does not exist. */
#define WF_CSV_NONE ((size_t)-1)

/* Read the file and parse its header; wf_csv_next then gives the rows. Given: path (must outlive the reader),
 * arena for text and cells, list for findings. Errors: WF_EINPUT (unreadable file, no header, more than
 * WF_CSV_COLUMNS columns, two columns of one name), WF_ENOMEM. */
enum wf_status wf_csv_open(struct wf_csv *c, const char *file, struct wf_arena *a, struct wf_diag *d,
                           struct wf_err *e);
/* Index of the column of that name, letter case ignored; WF_CSV_NONE when there is none. */
size_t wf_csv_column(const struct wf_csv *c, const char *name);
/* The same for a column that is required: if it is missing, an error is added that suggests a similar name or
 * lists the columns of the file. */
size_t wf_csv_need(struct wf_csv *c, const char *name);
/* Move to the next row. Rows with the wrong number of cells or unbalanced quotes are reported and skipped.
 * Returned: false at the end of the file. */
bool wf_csv_next(struct wf_csv *c);

/* Text of a cell of the current row; "" for WF_CSV_NONE. */
const char *wf_csv_text(const struct wf_csv *c, size_t column);
/* Read a cell of the current row as a number within low..high. Returned: true and *value; false after adding
 * an error when the cell is empty, not a number or out of range; false for WF_CSV_NONE. A decimal comma is
 * accepted where the separator is not a comma; a file that mixes decimal commas and points is refused. */
bool wf_csv_number(struct wf_csv *c, size_t column, double low, double high, double *value);
/* The same for a whole number. */
bool wf_csv_integer(struct wf_csv *c, size_t column, long long low, long long high, long long *value);
/* Add an error about a cell of the current row; the text is prefixed with the column's name. */
void wf_csv_mistake(struct wf_csv *c, size_t column, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* Add an error at a line and column of the file (column 0: unknown). All other functions report through this
 * one, so that the limit WF_CSV_LISTED holds for the file as a whole. */
void wf_csv_report(struct wf_csv *c, size_t line, size_t column, const char *text);
#endif
