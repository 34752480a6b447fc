/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TABLES_H
#define WF_OUT_TABLES_H
/* The tables of a run, as CSV: comma, a point for decimals, one header row with the unit in the column name.
 */
#include "out/results.h"
#include <stdio.h>

struct wf_table {
    const char *name;    /* "tables/summary.csv" */
    const char *meaning; /* one line for results.json */
    /* Write header and rows to f. Returned: rows written, without the header. */
    size_t (*write)(const struct wf_run *run, FILE *f);
    bool (*made)(const struct wf_run *run); /* does the run have it; NULL: always */
};
extern const struct wf_table wf_tables[]; /* ends at name == NULL */
enum { WF_TABLES = 5 };
#endif
