/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_CSV_H
#define WF_BASE_CSV_H
/* Reader for tables from spreadsheets and loggers: text with a header row whose cells are separated by
 * commas, semicolons or tabs; the separator is detected from the header. The text is parsed in place.
 * Accepted: quotes as in RFC 4180 around at most WF_CSV_QUOTED bytes, any line end, UTF-8 with and without a
 * byte order mark, UTF-16, Windows-1252 (with a warning), blank lines, lines that start with '#', and the
 * heads of loggers (wf_csv_heads). Blanks around a cell are removed. A line "# missing: -99.9, 99" before the
 * header declares missing marks. Mistakes become errors in the list of findings, with line and column; those
 * beyond WF_CSV_LISTED of one file are only counted. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

enum {
    WF_CSV_LISTED = 100,
    WF_CSV_COLUMNS = 4096,
    WF_CSV_QUOTED = 65536, /* bytes of a quoted cell */
    WF_CSV_MARKS = 8
};

/* Lines that a logger's program writes before the table. */
struct wf_csv;
struct wf_csv_head {
    const char *name, *source;
    bool (*is)(const struct wf_csv *c); /* whether the text at the start of the file is this head */
    size_t before, after; /* lines before the header row; lines between it and the data        */
    size_t units;         /* which of the lines after is the one with units; 0: none           */
    const char *section;  /* in place of `before`: the header follows the line "[section]"     */
    const char *refused;  /* why such a file is not read; NULL: it is                          */
};
extern const struct wf_csv_head wf_csv_heads[]; /* ends at name == NULL */

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
    struct wf_cell *name;           /* header cells                  */
    struct wf_cell *cell;           /* cells of the current row      */
    const char **unit;              /* of the columns, from the head of a logger; NULL: there is none */
    const struct wf_csv_head *head; /* NULL: none              */
    double mark[WF_CSV_MARKS];      /* numbers that mean "missing", as in the file */
    size_t marks;
    size_t row;      /* rows read so far              */
    size_t row_line; /* line the row starts on        */
    size_t mistakes; /* of this file                  */
    struct wf_diag *diag;
};

/* The index of a column that does not exist. */
#define WF_CSV_NONE ((size_t)-1)

/* Read the file and parse its header; wf_csv_next then gives the rows. Given: path (must outlive the reader),
 * arena for text and cells, list for findings. Errors: WF_EINPUT (unreadable file, no header, more than
 * WF_CSV_COLUMNS columns, two columns of one name, a logger's file that is not read), WF_ENOMEM. */
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
/* Is text[0..n) an error of a spreadsheet: #N/A, #NV, #DIV/0!, #WERT!, #NAME?...? */
bool wf_csv_sheet_error(const char *text, size_t n);
/* Does text[0..n) say that there is no value: nothing, an error of a spreadsheet, NA, NaN, null, none, nil,
 * -, inf, missing and the like, in either case? */
bool wf_csv_missing(const char *text, size_t n);
/* What a cell is. */
enum wf_csv_kind {
    WF_CSV_NUMBER,
    WF_CSV_MISSING, /* see wf_csv_missing                              */
    WF_CSV_WORD,    /* any other text */
    WF_CSV_MIXED,   /* a number with another decimal sign than the numbers before it */
};
/* Read a cell of the current row without reporting anything; *value is set for a number. A decimal comma is
 * accepted where the separator is not a comma; the first number with decimals decides for the file. */
enum wf_csv_kind wf_csv_value(struct wf_csv *c, size_t column, double *value);
/* The same for a measured value: a missing mark that the file or the caller declared is WF_CSV_MISSING. */
enum wf_csv_kind wf_csv_reading(struct wf_csv *c, size_t column, double *value);
/* Add missing marks from a list "99, -99.9". Returned: false when it is not a list of numbers or too long. */
bool wf_csv_declare(struct wf_csv *c, const char *list);
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
