/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_CSV_H
#define WF_BASE_CSV_H
/* Tables from spreadsheets: comma, semicolon or tab separated text with a header row, read in place.
 * RFC 4180 quotes, any line end, a byte order mark, blank lines and lines starting with '#' are understood;
 * the separator is detected from the header. Cells are trimmed of blanks. Mistakes go to the findings list
 * with line and column; beyond WF_CSV_LISTED of one file they are only counted. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

enum { WF_CSV_LISTED = 100, WF_CSV_COLUMNS = 4096 };

struct wf_cell {
    char *text; /* NUL-terminated, quotes resolved */
    size_t size;
    size_t column; /* where it starts in its line, 1-based, in bytes */
    size_t line;   /* where it starts */
};

struct wf_csv {
    const char *file;
    char *at, *end; /* what is not read yet          */
    size_t line;    /* line of `at`                  */
    char separator; /* ',' ';' or tab                */
    char point;     /* decimal sign, 0 = none met yet */
    size_t columns;
    struct wf_cell *name; /* header cells                  */
    struct wf_cell *cell; /* the row in hand               */
    size_t row;           /* rows read so far              */
    size_t row_line;      /* line the row starts on        */
    size_t mistakes;      /* of this file                  */
    struct wf_diag *diag;
};

/* No such column. */
#define WF_CSV_NONE ((size_t)-1)

/* Read the file and its header. `file` must outlive the reader. Errors: WF_EINPUT (unreadable, no header, a
 * column named twice), WF_ENOMEM. Rows are then taken with wf_csv_next. */
enum wf_status wf_csv_open(struct wf_csv *c, const char *file, struct wf_arena *a, struct wf_diag *d,
                           struct wf_err *e);
/* Index of a column, letter case ignored; WF_CSV_NONE when there is none. */
size_t wf_csv_column(const struct wf_csv *c, const char *name);
/* The same; a missing column is a finding that names a near spelling or lists the columns there are. */
size_t wf_csv_need(struct wf_csv *c, const char *name);
/* Take the next row. Rows with the wrong number of cells or broken quotes are found and skipped. Returned:
 * false at the end of the file. */
bool wf_csv_next(struct wf_csv *c);

/* The text of a cell of the row in hand; "" for WF_CSV_NONE. */
const char *wf_csv_text(const struct wf_csv *c, size_t column);
/* A cell as a number within low..high. Returned: false with a finding when it is empty, not a number, out of
 * range. A decimal comma is understood where the separator is not a comma; both signs in one file are
 * refused. */
bool wf_csv_number(struct wf_csv *c, size_t column, double low, double high, double *value);
/* A cell as a whole number within low..high. */
bool wf_csv_integer(struct wf_csv *c, size_t column, long long low, long long high, long long *value);
/* A finding about a cell of the row in hand, prefixed with the column's name. */
void wf_csv_mistake(struct wf_csv *c, size_t column, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* A finding at a place of the file; the other functions go through it. */
void wf_csv_report(struct wf_csv *c, size_t line, size_t column, const char *text);
#endif
