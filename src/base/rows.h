/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_ROWS_H
#define WF_BASE_ROWS_H
/* A table of any length, a row at a time: the bytes of each row as they are, and its cells as text. The same
 * tables as base/csv.h, but for heads of loggers; mistakes belong to the row and end nothing. Of a row that
 * is too long the beginning is kept, its first line or 1 MB. */
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum {
    WF_ROW_BYTES = 1 << 20, /* of a row, most */
    WF_ROW_LINES = 100,     /* lines of a row with quoted line ends, most */
    WF_ROW_CELLS = 1024
};

struct wf_rows {
    const char *file;
    FILE *stream;
    char separator; /* ',' ';' or tab */
    size_t columns; /* of the header */
    char **name;    /* columns: header cells */
    size_t line;    /* the current row begins on, 1-based */
    char *raw;      /* the current row without its line end, NUL-terminated */
    size_t size;
    bool blank;        /* it has no cells: a blank line or a comment */
    size_t cells;      /* of the current row */
    char **cell;       /* WF_ROW_CELLS: quotes resolved, blanks around removed; UTF-8 */
    const char *wrong; /* what is wrong with its quotes or bytes; NULL: nothing */
    char *held;        /* text that was read and is not used yet */
    size_t held_size, next_line;
    bool utf16;              /* the file is; all texts are UTF-8 */
    bool cp1252;             /* a row up to here is in Windows-1252 */
    bool marked;             /* it begins with a byte order mark, which is in none of the texts */
    size_t scanned, skipped; /* searches for the end of a long cell; lines left out behind the current row */
    char *split;             /* the cells' text */
    size_t room;             /* of raw, held and split */
};

/* Open a table and read its header, with the blank lines and comments before it as rows of their own:
 * `before(context, raw)` is called for each and for the header. Errors: WF_EINPUT (no such file, no header,
 * line ends that are CR alone, UTF-16 that is broken, more than WF_ROW_CELLS columns, two of one name),
 * WF_ENOMEM. */
enum wf_status wf_rows_open(struct wf_rows *r, const char *file,
                            void (*before)(void *context, const char *raw), void *context, struct wf_err *e);
/* The next row. Returned: false at the end of the file. */
bool wf_rows_next(struct wf_rows *r);
void wf_rows_close(struct wf_rows *r);
#endif
