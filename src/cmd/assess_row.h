/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_ROW_H
#define WF_CMD_ASSESS_ROW_H
/* One row of a table of trees: from its cells to an assessment, and to the cells that are added. */
#include "base/rows.h"
#include "cmd/assess_card.h"
#include <stdio.h>

struct wf_tree_columns; /* which column is which option, and the species that were read */

enum wf_row_state {
    WF_ROW_BLANK, /* no tree: a comment or a blank line */
    WF_ROW_READ,  /* to be computed */
    WF_ROW_DONE,
    WF_ROW_MISTAKE, /* its cells cannot be assessed */
    WF_ROW_FAILED   /* the computation failed */
};

struct wf_tree_row {
    struct wf_arena arena; /* of all below */
    enum wf_row_state state;
    const char *text;   /* the row as it is to be written, in the columns of the table */
    const char *reason; /* in UTF-8; NULL: none */
    const char *note;   /* what is to be said of a row that is assessed; NULL: nothing */
    bool cp1252;        /* it is written in Windows-1252, as the row is */
    size_t line;        /* of the table, 1-based */
    const char *number; /* of the tree, as its cell has it; NULL: there is none */
    struct wf_diag diag;
    struct wf_assess_case single, stand; /* as given; as a tree of a stand, where its spacing is a cell */
    bool in_stand;
};

/* Recognise the columns of a table (cmd/assess_columns.h). Returned: *out, to be closed. Errors: as
 * wf_heads_read; WF_EUSAGE, WF_EINPUT of the folder of --scans; of the units. */
enum wf_status wf_tree_columns_open(struct wf_tree_columns **out, const struct wf_rows *r,
                                    const struct wf_assess_options *line, struct wf_err *e);
void wf_tree_columns_close(struct wf_tree_columns *c);
/* Say which columns were recognised. */
void wf_tree_columns_say(const struct wf_tree_columns *c, struct wf_arena *a);
/* Can any row be assessed? Errors: WF_EINPUT where no column was recognised, or neither a column nor an
 * option says something that every tree needs; mistakes of options that are said of every row. */
enum wf_status wf_tree_columns_check(const struct wf_tree_columns *c, struct wf_err *e);

/* Read the current row of the table. Not from two threads at once. Returned: *out with state and reason; its
 * arena is empty before and is to be freed. Errors: WF_ENOMEM. */
enum wf_status wf_tree_row_read(struct wf_tree_columns *c, const struct wf_rows *r, struct wf_tree_row *out,
                                struct wf_err *e);
/* Assess it; in any thread. After an interrupt (base/interrupt.h) before its end its state stays WF_ROW_READ.
 */
void wf_tree_row_assess(struct wf_tree_row *row);
/* Write header and row with the added columns, each with a line end. */
void wf_tree_header_write(const struct wf_tree_columns *c, const char *header, FILE *to);
void wf_tree_row_write(const struct wf_tree_columns *c, const struct wf_tree_row *row, FILE *to);
#endif
