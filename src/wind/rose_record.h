/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_ROSE_RECORD_H
#define WF_WIND_ROSE_RECORD_H
/* A wind rose from the record of a station: mean speeds and directions, hour after hour.
 *
 * Every row with a speed counts as the same length of time. Rows without wind (speed 0) are calms. Rows with
 * wind but without a direction (empty, NA, variable) are taken to blow from the sectors in proportion to
 * those with one; so are calms. The Weibull distribution of a sector is fitted to its speeds above 0 by
 * maximum likelihood: k solves sum(u^k ln u)/sum(u^k) - 1/k = mean(ln u), A = mean(u^k)^(1/k) (Cohen A.C.
 * 1965, Technometrics 7:579-588; for wind Stevens M.J.M., Smulders P.T. 1979, Wind Engineering 3:132-145).
 * Standard errors are those of the expected information, for independent hours: k sqrt(0.6079/n), A/k
 * sqrt(1.1087/n). Winds of neighbouring hours are alike, so the true errors are larger. */
#include "wind/climate.h"

struct wf_rose_request {
    const char *columns; /* "speed,direction": names of columns; NULL: speed_ms,direction_deg */
    size_t sectors;      /* 8, 12, 16; 0: 16 where directions are names or steps of 22.5 deg, else 12 */
};

struct wf_rose_fit {
    size_t hours;                    /* rows of the sector with wind and direction       */
    double scale, shape;             /* [m/s], [-]; NAN: not fitted                      */
    double scale_error, shape_error; /* standard errors [m/s], [-]; NAN: not fitted      */
};

struct wf_rose_record {
    const char *file;
    size_t rows;            /* of the file                                                  */
    size_t directed;        /* with wind and direction                                      */
    size_t calm;            /* speed 0                                                      */
    size_t undirected;      /* with wind, without direction                                 */
    size_t missing;         /* without a speed; left out                                    */
    size_t unreadable;      /* with a speed that is no number; left out                     */
    double undirected_most; /* highest speed without direction; 0: none [m/s]          */
    double step;            /* directions are multiples of it; 0: of none [deg]             */
    struct wf_rose rose;
    struct wf_rose_fit *fit; /* of each sector; the last one of all directions together */
    size_t n;                /* directed + undirected                                */
    double *speed;           /* n: of all rows with wind, ascending [m/s]            */
};

/* Read a record and make a rose of it. Given: a table (base/csv.h) with a column of speeds, whose unit is in
 * its name (speed_ms, wind_kmh, ff_kn), and one of directions the wind comes from, degrees or names.
 * Returned: *out; warnings `rose-record` (calms and hours without direction), `rose-few` (sectors with fewer
 * than 100 hours; one that cannot be fitted has A and k of all directions), `rose-steps` (sectors that do not
 * fit the steps in which directions are given), `rose-range` (A or k that a rose read from a file may not
 * have), `rose-missing` (more than 10 % of the rows without a speed). Errors: WF_EINPUT, WF_EUSAGE (columns),
 * WF_ENOMEM. */
enum wf_status wf_rose_from_record(const char *path, const struct wf_rose_request *q, struct wf_arena *a,
                                   struct wf_diag *d, struct wf_rose_record *out, struct wf_err *e);
/* Share of all hours with a speed above u [m/s], counted in the record. */
double wf_rose_record_above(const struct wf_rose_record *r, double u);
#endif
