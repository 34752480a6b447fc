/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_RECORD_H
#define WF_FIT_RECORD_H
/* Measured records from spreadsheets: SI columns over time, and which part of them is used. */
#include "base/csv.h"
#include "base/units.h"

struct wf_record_column {
    const char *name, *unit; /* unit NULL: at the end of the name */
    enum wf_dimension dimension;
};
struct wf_fit_record {
    size_t n, columns;
    double *time;   /* [s] since the first row kept     */
    double *value;  /* n x columns [SI]                 */
    size_t *line;   /* of the file                      */
    bool *used;     /* the part that is fitted          */
    size_t missing; /* rows left out for an empty or NA cell */
};

/* Factor to SI of a column by the unit at the end of its name (force_kN, wind_m_s, strain_um_m) or as given.
 * Errors: WF_EINPUT with a sentence about the name and what would be right. */
enum wf_status wf_column_unit(struct wf_units *u, const struct wf_record_column *c, double *factor,
                              struct wf_err *e);

struct wf_yaml_pair;
/* Read rows of a CSV file. Given: columns, the time column (NULL: rows count seconds), texts that rows must
 * have. Rows with an empty or NA cell in a wanted column are left out and counted. Errors: WF_EINPUT with
 * every mistake in d: text in place of a number, time going backwards, a missing column, no rows. */
enum wf_status wf_fit_record_read(const char *path, const struct wf_record_column *column, size_t columns,
                                  const char *time, const struct wf_yaml_pair *only, size_t onlys,
                                  struct wf_arena *a, struct wf_fit_record *out, struct wf_diag *d,
                                  struct wf_err *e);

/* Mark the first loading: rows up to the largest force, at no less than what was reached before (but for 2 %
 * of the largest, which a winch gives back between strokes), from `from` to `to` of the largest. Errors:
 * WF_EINPUT when the force is zero throughout or fewer than three rows remain. */
enum wf_status wf_loading_branch(struct wf_fit_record *r, size_t column, double from, double to,
                                 const char *name, struct wf_err *e);
#endif
