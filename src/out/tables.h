/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TABLES_H
#define WF_OUT_TABLES_H
/* A run of analyses, and its tables. */
#include "base/file.h"
#include "study/analysis.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct wf_input_file {
    const char *role, *path;     /* "species", "model", ...; the path as the user wrote it */
    char sha256[WF_SHA256_TEXT]; /* of the file's bytes                                    */
};

/* All results of one run. The analyses share the list of wind speeds, in the same order. */
struct wf_job; /* out/job.h */
struct wf_run {
    const char *title;   /* given by the user; NULL: the report composes one    */
    const char *command; /* command line as given                               */
    const char *version; /* of the program                                      */
    const char *date;    /* ISO 8601, UTC: 2026-11-23T09:45:00Z                 */
    size_t n;
    const struct wf_analysis *analysis; /* one per species                      */
    size_t inputs;
    const struct wf_input_file *input;
    const struct wf_job *job; /* NULL: none */
    bool random;              /* random numbers were drawn, from `seed` */
    uint64_t seed;
};

/* Short stable word for the outcome of a solution ("ok", "unstable", ...), used in JSON and in tables. */
const char *wf_part_status(enum wf_status s);
/* The same for the outcome of the search for the critical wind speed ("found", "above", ...). */
const char *wf_part_outcome(enum wf_critical_outcome o);
/* Height above ground of position s (0 base, 1 end) of a row on the unbent tree [m]; NAN for row -1. */
double wf_part_height(const struct wf_tree *t, int32_t row, double s);

/* The tables of a run, as CSV: comma, a point for decimals, one header row with the unit in the column name.
 */

struct wf_table {
    const char *name;    /* "tables/summary.csv" */
    const char *meaning; /* one line for results.json */
    /* Write header and rows to f. Returned: rows written, without the header. */
    size_t (*write)(const struct wf_run *run, FILE *f);
    bool (*made)(const struct wf_run *run); /* does the run have it; NULL: always */
};
extern const struct wf_table wf_tables[]; /* ends at name == NULL */
enum { WF_TABLES = 8 };
#endif
