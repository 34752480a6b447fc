/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_RECORD_H
#define WF_WIND_RECORD_H
/* A measured wind: the rows of a sonic or cup anemometer's CSV at an even step, in wind axes. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

struct wf_record_request {
    const char *time;    /* column of the time [s]; NULL: rows follow each other at `step`       */
    const char *part[3]; /* columns of the horizontal components and the vertical one [m/s]; the
                            second and third may be NULL; one alone is a speed (cup)             */
    double step;         /* [s], where there is no time column                                   */
    double bad_share;    /* largest share of rows that may be missing or unreadable [-]          */
    double gap;          /* longest gap that is bridged by a straight line [s]                   */
    double speed_max;    /* a component beyond this is an unreadable cell [m/s]                  */
};
void wf_record_request_default(struct wf_record_request *q); /* 5 %, 2 s, 100 m/s, t_s, u_ms, v_ms, w_ms */

struct wf_record {
    const char *file;
    size_t n;             /* steps, gaps bridged                                    */
    unsigned components;  /* 1, 2 or 3                                              */
    double step;          /* [s]                                                    */
    double *u, *v, *w;    /* along the mean wind, across to the left, up [m/s]; NULL where not recorded */
    double mean;          /* mean of u [m/s]                                        */
    double azimuth, tilt; /* direction the mean wind blows towards in the instrument's axes, from the first
                             component towards the second, and above the horizontal [rad] */
    size_t rows;          /* rows of the file                                       */
    size_t unreadable;    /* rows with an empty, NA, text or out-of-range cell      */
    size_t missing;       /* steps no row speaks for                                */
    size_t gaps, longest; /* bridged stretches, steps of the longest                */
};

/* Read a record. Cells that are empty, NA, text or beyond speed_max are counted and bridged; too many of
 * them, too long a gap, a time that runs backwards or a missing column is WF_EINPUT that names the first
 * place. The axes are turned so that the means of v and w vanish (double rotation: Kaimal J.C., Finnigan J.J.
 * 1994, Atmospheric Boundary Layer Flows, ch. 6). */
enum wf_status wf_record_read(const char *path, const struct wf_record_request *q, struct wf_arena *a,
                              struct wf_diag *d, struct wf_record *out, struct wf_err *e);
#endif
