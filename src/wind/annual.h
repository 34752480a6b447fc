/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_ANNUAL_H
#define WF_WIND_ANNUAL_H
/* The largest wind of each year: from a table of years, or from the record of a station hour after hour. */
#include "base/arena.h"
#include "base/clock.h"
#include "base/err.h"

struct wf_annual_request {
    const char *column;  /* of the speed; NULL: speed_ms                                                */
    const char *time;    /* of the record's dates; NULL: time                                           */
    enum wf_dates dates; /* which of day and month is first                                             */
    size_t begins;       /* month with which a year begins, 1 to 12                                     */
    double least;        /* share of the rows of the fullest year that a year must have, in 0..1        */
};

struct wf_annual_year {
    int year;       /* in which it begins; its number in the file where it has no dates */
    size_t rows;    /* with a speed                                                       */
    double largest; /* [m/s]                                                              */
    bool used;      /* false: too few rows                                                */
};
struct wf_annual {
    const char *file;
    size_t n;                    /* years of the file                  */
    struct wf_annual_year *year; /* n, ascending                       */
    size_t used;                 /* years that are used                */
    double *speed;               /* used: their largest winds [m/s], in the order of the years */
    double step;                 /* median distance of the rows of a record [s]; NAN: a table of years */
};

/* Read a table with one row a year: a column of speeds, whose unit is in its name, and a column `year` if
 * there is one. A year that occurs twice is a mistake. Errors: WF_EINPUT with all mistakes in `d`, WF_ENOMEM.
 */
enum wf_status wf_annual_read(const char *path, const struct wf_annual_request *q, struct wf_arena *a,
                              struct wf_diag *d, struct wf_annual *out, struct wf_err *e);
/* The same from a record with dates. Years with fewer rows than `least` are not used: warning `year-short`
 * names them, and `storm-left-out` when the largest wind of the record is in one. Missing marks are struck
 * out as in other records of wind. Errors: as above, also for a record without dates. */
enum wf_status wf_annual_from_record(const char *path, const struct wf_annual_request *q, struct wf_arena *a,
                                     struct wf_diag *d, struct wf_annual *out, struct wf_err *e);
#endif
