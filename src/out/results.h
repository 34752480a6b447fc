/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_RESULTS_H
#define WF_OUT_RESULTS_H
/* The results document and its tables: results.json and tables/ *.csv of a run. Keys, units and meanings are
 * described in docs/results.md. */
#include "base/arena.h"
#include "base/err.h"
#include "base/file.h"
#include "out/tables.h"
#include <stdbool.h>

#define WF_RESULTS_SCHEMA "windfirm-results"
enum { WF_RESULTS_VERSION = 1 };
/* Can a program of results version `own` read a document of version `found`? It reads its own version and the
 * one before; the first is 1. A new key does not change the version; a key that is removed or changes its
 * meaning raises it. */
static inline bool wf_results_readable(long long found, long long own)
{
    return found >= 1 && (found == own || found == own - 1);
}

/* Fill *out for an input file: role and path are copied to the arena, the file is hashed.
 * Errors: WF_EINPUT when it cannot be read, WF_ENOMEM. */
enum wf_status wf_input_file_note(const char *role, const char *path, struct wf_arena *a,
                                  struct wf_input_file *out, struct wf_err *e);

/* The present time in the form of wf_run.date. The environment's SOURCE_DATE_EPOCH [s since 1970], when it is
 * a number, takes the place of the clock, so that a rerun can give the same bytes. Returned: text, or NULL
 * without memory. */
const char *wf_run_date(struct wf_arena *a);

/* Write FOLDER/results.json and FOLDER/tables/{summary,segments,shape,sweep}.csv, directions.csv where
 * there are directions, and unions.csv where unions are listed; the folder is made. All are complete or none
 * is replaced. Numbers that are not finite become null with a reason (JSON) or an empty cell (CSV). Errors:
 * WF_EUSAGE for a run without analyses or with differing wind lists, WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_results_write(const struct wf_run *run, const char *folder, struct wf_err *e);
#endif
