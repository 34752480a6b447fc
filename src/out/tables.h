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
};
extern const struct wf_table wf_tables[]; /* ends at name == NULL */
enum { WF_TABLES = 4 };
#endif
