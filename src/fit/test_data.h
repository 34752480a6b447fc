/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_TEST_DATA_H
#define WF_FIT_TEST_DATA_H
/* Measured data of a test from a CSV file: columns in SI over time, and the rows that are used. */
#include "base/csv.h"
#include "base/units.h"

struct wf_test_column {
    const char *name, *unit; /* unit NULL: suffix of the name */
    enum wf_dimension dimension;
};
struct wf_test_data {
    size_t n, columns;
    double *time;   /* [s] since the first row kept     */
    double *value;  /* n x columns [SI]                 */
    size_t *line;   /* of the file                      */
    bool *used;     /* by the fit                       */
    size_t missing; /* rows left out for an empty or NA cell */
};

/* Factor to SI of a column, from its unit or from the suffix of its name (force_kN, wind_m_s, strain_um_m).
 * Errors: WF_EINPUT with the name and the allowed units. */
enum wf_status wf_column_unit(struct wf_units *u, const struct wf_test_column *c, double *factor,
                              struct wf_err *e);

struct wf_yaml_pair;
/* Read rows of a CSV file. Given: columns, the time column (NULL: rows are 1 s apart), texts that used
 * rows must have. Rows with an empty or NA cell in a needed column are left out and counted. Errors:
 * WF_EINPUT with every mistake in d: text in place of a number, time going backwards, a missing column, no
 * rows. */
enum wf_status wf_test_data_read(const char *path, const struct wf_test_column *column, size_t columns,
                                 const char *time, const struct wf_yaml_pair *only, size_t onlys,
                                 struct wf_arena *a, struct wf_test_data *out, struct wf_diag *d,
                                 struct wf_err *e);

/* Mark the first loading: rows up to the largest force, with a force no lower than before (except for 2 % of
 * the largest, the loss between strokes of a winch), from `from` to `to` of the largest. Errors:
 * WF_EINPUT when the force is zero throughout or fewer than three rows remain. */
enum wf_status wf_loading_branch(struct wf_test_data *r, size_t column, double from, double to,
                                 const char *name, struct wf_err *e);
#endif
