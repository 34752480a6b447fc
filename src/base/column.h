/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_COLUMN_H
#define WF_BASE_COLUMN_H
/* What the columns of a table are measured in, and which of their numbers mean "missing". */
#include "base/csv.h"
#include "base/units.h"

struct wf_column {
    const char *name, *unit; /* unit NULL: from the name */
    enum wf_dimension dimension;
};

/* Factor to SI of a column, from its unit or from its name: its last part after "_" or a blank, the longest
 * that is a unit of the dimension (force_kN, wind_m_s, strain_um_m), or what stands in brackets at its end
 * ("u (km/h)", "u [kn]"). Errors: WF_EINPUT with the name and the allowed units; a plain number needs no
 * unit. */
enum wf_status wf_column_unit(struct wf_units *u, const struct wf_column *c, double *factor,
                              struct wf_err *e);
/* The same for a name alone. Returned: whether it has a unit of the dimension; *factor; *stem, the size of
 * the name without it. */
bool wf_name_unit(struct wf_units *u, const char *name, enum wf_dimension d, double *factor, size_t *stem,
                  struct wf_err *e);
/* Factor to SI of a column of a table: from the units in its head, else from its name, else `usual`, with a
 * warning `unit-assumed`. Errors: a mistake of the table, for units in the head or in brackets that are of
 * another kind. */
bool wf_column_factor(struct wf_csv *c, struct wf_units *u, size_t column, enum wf_dimension d,
                      const char *usual, double *factor, struct wf_err *e);
/* Find a required column that is called, for example, "speed_ms": that one, or one that differs in its unit
 * alone
 * ("speed_kmh", "Speed [kn]"). Returned: its index and factor to SI; WF_CSV_NONE after a mistake of the
 * table. */
size_t wf_column_need(struct wf_csv *c, struct wf_units *u, const char *name, enum wf_dimension d,
                      double *factor, struct wf_err *e);
/* Read a cell of the current row as a number within low..high [SI]. Returned: as wf_csv_number, *value in SI.
 */
bool wf_column_number(struct wf_csv *c, size_t column, double factor, double low, double high, double *value);

/* Missing marks of measured speeds. */
struct wf_marks {
    double impossible; /* no speed is above it, in the column's unit                                  */
    bool unsigned_;    /* a speed without direction: a negative number is a mark                      */
    bool none;         /* the user says that there are no marks                                       */
    size_t missing;    /* numbers found to be marks                                                   */
    double mark;       /* the last of them                                                            */
    size_t doubtful;   /* index of a number that may be a mark or a peak; n: there is none            */
    double next;       /* largest size of the others                                                  */
};
/* Find the missing marks among n speeds of one column in its own unit (NAN: no reading) and set them to NAN.
 * A mark is a negative speed, or the largest number when it is impossible, occurs at least twice and is above
 * twice the largest other. Doubtful is any other impossible number, and a single 99, 99.9, 999 or the like
 * above twice the largest other. Components are compared by size. Returned: false without memory. */
bool wf_marks_find(struct wf_marks *m, double *value, size_t n);
/* Strike out the missing marks of a column of speeds, and say so by the warning `missing-marks`. Given: the
 * column and its factor to m/s; whether the user says that there are none; `alone` as unsigned_ above; n
 * numbers in the column's unit, set to NAN where they are marks, and their lines; how a user says what a
 * doubtful number is, the text before and behind it. Returned: WF_OK and *struck. Errors: WF_EINPUT with the
 * line for a doubtful number, WF_ENOMEM. */
enum wf_status wf_marks_strike(struct wf_csv *c, size_t column, double factor, bool none, bool alone,
                               double *value, const size_t *line, size_t n, const char *const how[2],
                               size_t *struck, struct wf_err *e);

/* Readings of a record that grow row by row: a value, another beside it (a time, a direction), the line. */
struct wf_readings {
    size_t n, room;
    double *value, *beside;
    size_t *line;
};
/* Add a row. Returned: false without memory; the rows before stay. */
bool wf_readings_add(struct wf_readings *r, double value, double beside, size_t line);
void wf_readings_free(struct wf_readings *r);
#endif
