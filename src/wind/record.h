/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_RECORD_H
#define WF_WIND_RECORD_H
/* A measured wind: the CSV file of a sonic or cup anemometer, resampled to an even step and rotated to wind
 * axes. */
#include "base/arena.h"
#include "base/clock.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

struct wf_record_request {
    const char *time;    /* column of the time; NULL: the rows are `step` apart                  */
    const char *part[3]; /* columns of the horizontal components and the vertical one; the
                            second and third may be NULL; one alone is a speed (cup)             */
    double step;         /* [s], where there is no time column; NAN: not known                   */
    double bad_share;    /* largest share of rows that may be missing or unreadable [-]          */
    double gap;          /* longest gap that is bridged by a straight line [s]                   */
    const char *missing; /* missing marks in the file's own numbers, "99,-99.9"; "none": every
                            number is a wind; NULL: found by wf_marks_find                       */
    enum wf_dates dates; /* which of day and month is first                                      */
};
void wf_record_request_default(struct wf_record_request *q); /* 5 %, 5 s, t_s, u_ms, v_ms, w_ms */

struct wf_record {
    const char *file;
    size_t n;             /* steps, gaps bridged                                    */
    unsigned components;  /* 1, 2 or 3                                              */
    double step;          /* [s]                                                    */
    double *u, *v, *w;    /* along the mean wind, across to the left, up [m/s]; NULL where not recorded */
    double mean;          /* mean of u [m/s]                                        */
    double azimuth, tilt; /* direction towards which the mean wind blows, in the instrument's axes: from the
                             first component towards the second, and above the horizontal [rad] */
    size_t rows;          /* rows of the file                                       */
    size_t unreadable;    /* rows with an empty, NA or text cell or a missing mark  */
    size_t missing;       /* steps for which no row has a reading                   */
    size_t gaps, longest; /* number of interpolated gaps, steps of the longest      */
};

/* Read a record. Rows with cells that are empty, NA, text or a missing mark are counted, and their steps are
 * interpolated linearly. Units are those of the columns' names or of the file's head; without one seconds and
 * m/s are assumed, with a warning `unit-assumed`. Method: the step is the median of the time differences; the
 * axes are rotated so that the means of v and w vanish (double rotation: Kaimal J.C., Finnigan J.J. 1994,
 * Atmospheric Boundary Layer Flows, ch. 6). Errors: WF_EINPUT, with the first place, for too many unreadable
 * rows, a number that may be a missing mark or a peak, a gap that is too long, times that do not increase or
 * a missing column; WF_EUSAGE without a time column and a step, and for `missing` that is no list; WF_ENOMEM.
 */
enum wf_status wf_record_read(const char *path, const struct wf_record_request *q, struct wf_arena *a,
                              struct wf_diag *d, struct wf_record *out, struct wf_err *e);
#endif
