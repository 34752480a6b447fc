/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_COLUMNS_H
#define WF_CMD_ASSESS_COLUMNS_H
/* What the columns of a table of trees are, by their heads in English, German, French and Chinese, with units
 * in or behind the name. */
#include "base/rows.h"
#include "cmd/assess_card.h"

enum wf_head_use {
    WF_HEAD_KEPT,   /* none of the command's options: kept as it is */
    WF_HEAD_NEAR,   /* kept too, though its name is near to that of an option */
    WF_HEAD_READ,   /* an option of each row */
    WF_HEAD_WORDS,  /* the same where the cell is one of the option's words: the head is an everyday word */
    WF_HEAD_REFUSED /* an option that no row can have: a cell with a value is a mistake */
};
struct wf_head {
    enum wf_head_use use;
    size_t option; /* row of the command's options; of WF_HEAD_KEPT: none */
    double factor; /* to SI; NAN: the option's own unit */
    bool stand;    /* of a tree in a stand */
    bool own;      /* read by the option's own name, which has no others */
    bool number;   /* says which tree a row is; only kept, it stands on the page of the tree */
};
/* Column of the files of trees, or of the spacing; none. */
#define WF_HEAD_NONE ((size_t)-1)

struct wf_heads {
    const struct wf_rows *rows;
    const struct wf_option *option; /* of the command */
    struct wf_head *head;           /* by column */
    size_t scan, spacing;           /* columns; WF_HEAD_NONE */
};

/* Row of the command's options with that name. */
size_t wf_head_option(const struct wf_option *rows, const char *name);
/* Recognise the columns. Given: the header; the options of the command line; units (wf_units_open). Errors:
 * WF_EINPUT where two columns are the same option, one may be several options, or one has the name of an
 * added column; WF_ENOMEM. */
enum wf_status wf_heads_read(const struct wf_rows *r, const struct wf_assess_options *line,
                             struct wf_units *units, struct wf_arena *a, struct wf_heads *out,
                             struct wf_err *e);
/* Can any row be assessed? Given: the options of the command line. Errors: WF_EINPUT where no column is read,
 * or neither a column nor an option says something that every tree needs. */
enum wf_status wf_heads_check(const struct wf_heads *h, const struct wf_args *line, struct wf_err *e);
/* Say on stderr which columns are read, and as what, which only kept, and of which rows are refused. */
void wf_heads_say(const struct wf_heads *h, struct wf_arena *a);
#endif
