/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_CLOCK_H
#define WF_BASE_CLOCK_H
/* The column of a table that says when: numbers with a unit, dates with a time of day, or times of day alone.
 * Read as one of these kinds, the first cell's:
 *   numbers           0.5; times the factor of the column's unit
 *   dates             2024-01-05T12:00:00.5Z, 2024/01/05 12:00, 05.01.2024 12:00:00,5, 05/01/2024 12:00:00
 * PM; fractions after a point or comma; after a date that begins with the year, Z or an offset (ISO 8601)
 *   times of day      12:00:00.5; a time more than 12 h earlier than the row before is of the next day
 * Dates with points have the day first. With other signs, day and month are told apart by a number above 12;
 * when the dates differ and none has one, the caller must say which is first. */
#include "base/csv.h"

enum wf_dates { WF_DATES_UNSAID, WF_DATES_DAY_FIRST, WF_DATES_MONTH_FIRST };

struct wf_clock {
    double factor;       /* [s] per unit of a number; 0: its column names no unit, taken as s */
    enum wf_dates dates; /* as the caller says                                         */
    int kind;            /* 0: no cell read yet                                        */
    bool day_seen, month_seen, differ,
        slashes;              /* dates whose order is settled, differing dates, any open date */
    long origin;              /* first day of the column [days since 1970-01-01] */
    double previous, wrapped; /* time of day before, days passed [s]             */
    size_t line, column;      /* of the first date whose order is open           */
};

/* What a word for the order of dates means. Given: "day-first", "month-first" or NULL. */
bool wf_dates_named(const char *word, enum wf_dates *out);
/* Read a cell of the current row. Returned: true and *t [s], of dates from the first day of the column. A
 * cell that is no time: false, and a mistake of the table unless it is missing (see wf_csv_value). */
bool wf_clock_read(struct wf_clock *k, struct wf_csv *c, size_t column, double *t);
/* Say that numbers were taken as seconds when the column's name has no unit: a warning `unit-assumed`. */
void wf_clock_say_unit(const struct wf_clock *k, struct wf_csv *c, size_t column);
/* Correct the n times read (NAN: none) once the order of day and month is known. Given: how the caller says
 * it, for the message. Errors: WF_EINPUT when it stays open and matters, or is contradicted. */
enum wf_status wf_clock_settle(const struct wf_clock *k, const char *file, const char *say, double *t,
                               size_t n, struct wf_err *e);
/* Year and month of a time of the column, after wf_clock_settle. Returned: false when the column has no
 * dates. */
bool wf_clock_date(const struct wf_clock *k, double t, int *year, int *month);
#endif
