/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_RESULTS_H
#define WF_OUT_RESULTS_H
/* The results document and its tables: results.json and tables/ *.csv of a run. Keys, units and meanings are
 * described in docs/results.md. */
#include "base/arena.h"
#include "base/err.h"
#include "base/file.h"
#include "out/doc.h"
#include "study/analysis.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define WF_RESULTS_SCHEMA "windfirm-results"
enum { WF_RESULTS_VERSION = 1 };
/* Can a program of results version `own` read a document of version `found`? It reads its own version and the
 * one before; the first is 1. A new key does not change the version; a key that is removed or changes its
 * meaning raises it. */
static inline bool wf_results_readable(long long found, long long own)
{
    return found >= 1 && (found == own || found == own - 1);
}

struct wf_input_file {
    const char *role, *path;     /* "species", "model", ...; the path as the user wrote it */
    char sha256[WF_SHA256_TEXT]; /* of the file's bytes                                    */
};

/* All results of one run. The analyses share the list of wind speeds, in the same order. */
struct wf_run {
    const char *title;   /* given by the user; NULL: the report composes one    */
    const char *command; /* command line as given                               */
    const char *version; /* of the program                                      */
    const char *date;    /* ISO 8601, UTC: 2026-11-23T09:45:00Z                 */
    size_t n;
    const struct wf_analysis *analysis; /* one per species                      */
    size_t inputs;
    const struct wf_input_file *input;
    bool random; /* random numbers were drawn, from `seed` */
    uint64_t seed;
};

/* Fill *out for an input file: role and path are copied to the arena, the file is hashed.
 * Errors: WF_EINPUT when it cannot be read, WF_ENOMEM. */
enum wf_status wf_input_file_note(const char *role, const char *path, struct wf_arena *a,
                                  struct wf_input_file *out, struct wf_err *e);

/* The present time in the form of wf_run.date. The environment's SOURCE_DATE_EPOCH [s since 1970], when it is
 * a number, takes the place of the clock, so that a rerun can give the same bytes. Returned: text, or NULL
 * without memory. */
const char *wf_run_date(struct wf_arena *a);

/* Write FOLDER/results.json and FOLDER/tables/{summary,segments,shape,sweep}.csv, and directions.csv where
 * there are directions; the folder is made. All are complete or none is replaced. Numbers that are not finite
 * become null with a reason (JSON) or an empty cell (CSV). Errors: WF_EUSAGE for a run without analyses or
 * with differing wind lists, WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_results_write(const struct wf_run *run, const char *folder, struct wf_err *e);

/* Short stable word for the outcome of a solution ("ok", "unstable", ...), used in JSON and in tables. */
const char *wf_part_status(enum wf_status s);
/* The same for the outcome of the search for the critical wind speed ("found", "above", ...). */
const char *wf_part_outcome(enum wf_critical_outcome o);
/* Height above ground of position s (0 base, 1 end) of a row on the unbent tree [m]; NAN for row -1. */
double wf_part_height(const struct wf_tree *t, int32_t row, double s);
/* A place in the tree as an object: segment, level, part, id, diameter, position, height; null for row -1. */
json_t *wf_part_section(struct wf_doc *d, const struct wf_analysis *a, const struct wf_worst *w);

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
enum { WF_TABLES = 5 };
#endif
