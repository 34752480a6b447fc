/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_WORKBOOK_H
#define WF_OUT_WORKBOOK_H
/* Tables as one workbook of a spreadsheet program (Office Open XML), a sheet a table. Texts are cells of
 * text, whatever they begin with: none is a formula. */
#include "base/err.h"

/* The file that wf_workbook_make writes, in the folder. */
#define WF_WORKBOOK "tables/tables.xlsx"

/* Write FOLDER/tables/tables.xlsx from every FOLDER/tables/ *.csv, in the order of their names. Errors:
 * WF_EMISSING when the program was built without libxlsxwriter; WF_EOUTPUT; WF_ENOMEM. A table of more rows
 * than a sheet holds (1048575) is cut there, with a warning `workbook-cut`. */
enum wf_status wf_workbook_make(const char *folder, struct wf_diag *d, struct wf_err *e);

/* A workbook of one sheet that is filled row by row. Memory does not grow with the rows. */
struct wf_workbook;
enum wf_status wf_workbook_open(struct wf_workbook **out, const char *path, const char *sheet,
                                struct wf_err *e);
/* A cell; rows and columns from 0; row 0 is bold and stays in sight. Rows must not descend. A text that is a
 * whole number or a decimal one, without more, is a number where `numbers` is true. */
void wf_workbook_cell(struct wf_workbook *w, size_t row, size_t column, const char *text, bool numbers);
/* Give it up, with its file, and free it. */
void wf_workbook_abandon(struct wf_workbook *w);
/* Finish and free; NULL is allowed. Errors: WF_EOUTPUT. */
enum wf_status wf_workbook_close(struct wf_workbook *w, struct wf_err *e);
#endif
