/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_CELL_H
#define WF_CMD_ASSESS_CELL_H
/* Cells of a table of trees as options of their columns: units, decimal commas, words, winds. */
#include "cmd/assess_columns.h"

/* A cell of column k as its option takes it: a plain number in SI where the column has a unit, with a decimal
 * point; empty where the cell says that there is nothing. NULL: no memory. */
const char *wf_cell_value(const struct wf_heads *h, size_t k, const char *cell, struct wf_arena *a);
/* What is wrong with cell k of the current row by its column alone: a value that no row can have, a file, a
 * wind that may be a list. NULL: nothing. */
const char *wf_cell_fault(const struct wf_heads *h, const struct wf_rows *r, size_t k, struct wf_arena *a);
#endif
