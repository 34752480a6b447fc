/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_TEST_DATA_H
#define WF_FIT_TEST_DATA_H
/* Measured data of a test from a CSV file: columns in SI over time, and the rows that are used. */
#include "base/clock.h"
#include "base/column.h"

/* How the rows of a file are read. */
struct wf_test_rows {
    const char *time;    /* column of the time; NULL: rows are 1 / rate apart                         */
    double rate;         /* [1/s], without a time column; NAN: not known, time is the row's number    */
    const char *missing; /* missing marks in the file's own numbers, "99,-99.9"; "none": every number
                            of a wind is one; NULL: found by wf_marks_find                            */
    enum wf_dates dates;
    const struct wf_yaml_pair *only; /* texts that used rows must have */
    size_t onlys;
};
struct wf_test_data {
    size_t n, columns;
    double *time;   /* [s] since the first row kept; rows without rate: their number */
    double *value;  /* n x columns [SI]                 */
    size_t *line;   /* of the file                      */
    bool *used;     /* by the fit                       */
    size_t missing; /* rows left out for an empty or NA cell */
};

struct wf_yaml_pair;
/* Read rows of a CSV file. Given: columns, how rows are read. Rows with an empty, NA or missing cell in a
 * needed column are left out and counted. Units are those of `unit`, the file's head or the name. Errors:
 * WF_EINPUT with every mistake in d: text in place of a number, time going backwards, a missing column, no
 * rows, a wind that may be a missing mark or a peak. */
enum wf_status wf_test_data_read(const char *path, const struct wf_column *column, size_t columns,
                                 const struct wf_test_rows *how, struct wf_arena *a, struct wf_test_data *out,
                                 struct wf_diag *d, struct wf_err *e);

/* Mark the first loading: rows up to the largest force, with a force no lower than before (except for 2 % of
 * the largest, the loss between strokes of a winch), from `from` to `to` of the largest. Errors:
 * WF_EINPUT when the force is zero throughout or fewer than three rows remain. */
enum wf_status wf_loading_branch(struct wf_test_data *r, size_t column, double from, double to,
                                 const char *name, struct wf_err *e);
#endif
