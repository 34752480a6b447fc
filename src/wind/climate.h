/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_CLIMATE_H
#define WF_WIND_CLIMATE_H
/* Scales of wind (Beaufort, grades of tropical cyclones), conversion between averaging times, and wind roses.
 */
#include "base/arena.h"
#include "base/err.h"
#include "wind/wind.h"
#include <stdbool.h>
#include <stddef.h>

#define WF_MEAN_TIME 600.0 /* averaging time of all mean winds of this program [s] */

struct wf_wind_grade {
    const char *name; /* "8", "typhoon"                        */
    double low, high; /* [m/s]; high = INFINITY: no upper bound */
    const char *text; /* "gale"                                */
    const char *sign; /* visible effect on trees; NULL: the scale gives none */
};
struct wf_wind_scale {
    const char *name; /* "beaufort" */
    const char *title, *source;
    double averaging;                  /* averaging time of the scale's speeds [s] */
    const char *law;                   /* row of wf_averaging_laws for the winds that the scale describes */
    double height;                     /* of the scale's speeds [m], over open ground or sea */
    const struct wf_wind_grade *grade; /* ends at name == NULL */
};
extern const struct wf_wind_scale wf_wind_scales[]; /* beaufort, cma, hko; ends at name == NULL */

struct wf_scale_wind {
    const struct wf_wind_scale *scale;
    const struct wf_wind_grade *grade;
    double speed; /* middle of the grade; its lower bound if it has no upper one [m/s] */
};

/* Whether a text has the form "scale:grade" and is not a speed. */
bool wf_wind_scale_is(const char *text);
/* Read "beaufort:8", "cma:typhoon", "cma:severe-typhoon", "hko:typhoon". Returned: scale, grade and speed,
 * which has the scale's averaging time. Errors: WF_EUSAGE with the known scales or grades. */
enum wf_status wf_wind_scale_parse(const char *text, struct wf_scale_wind *out, struct wf_err *e);
/* The grade of a speed [m/s]; NULL below the first grade. */
const struct wf_wind_grade *wf_wind_scale_grade(const struct wf_wind_scale *s, double speed);

/* Laws for the conversion between averaging times. "durst": the largest mean over t seconds within an hour,
 * open country; Durst C.S. (1960), Meteorol. Mag. 89:181-186, in the fit of the Shore Protection Manual
 * (1984): U_t/U_3600 = 1.277 + 0.296 tanh(0.9 log10(45 s/t)), 1 s to 3600 s. "in-land", "off-land",
 * "off-sea", "at-sea": gust factors of Harper B.A., Kepert J.D., Ginger J.D. (2010), Guidelines for
 * converting between various wind averaging periods in tropical cyclone conditions, WMO/TD-1555, table 1.1;
 * between a mean over 600 s or 3600 s and gusts of 3, 60, 120, 180 or 600 s. "en1991": gusts of 3 s and
 * 10-min means by wf_category_gust, EN 1991-1-4, of the terrain and height where the wind was measured. */
struct wf_averaging_law {
    const char *name, *source, *validity;
};
extern const struct wf_averaging_law wf_averaging_laws[]; /* ends at name == NULL */

/* Convert a wind speed between averaging times. Given: law, speed [m/s], averaging times from and to [s].
 * Returned: for to < from the largest mean over `to` within a period `from` whose mean is `speed`; for to >
 * from the mean over `to` of a wind whose largest mean over `from` is `speed`; where it was measured, NULL:
 * at 10 m over open country. Errors: WF_EUSAGE for an unknown law or a time that it does not cover. */
enum wf_status wf_wind_average(const char *law, const struct wf_wind_place *at, double speed, double from,
                               double to, double *out, struct wf_err *e);
/* The law for gusts of 3 s and for other averaging times that are not named with one. */
const char *wf_averaging_usual(double time);
#define WF_GUST_TIME 3.0 /* averaging time of gusts [s] */

/* A wind rose: the share of hours in which the wind comes from each direction, and the Weibull distribution
 * of its speed in these hours. */
struct wf_rose {
    size_t sectors;    /* 8, 12 or 16                                           */
    double *from;      /* middle of the sector, clockwise from north [rad]      */
    double *frequency; /* share of all hours, sum 1; 0: an empty sector         */
    double *scale;     /* Weibull A of hourly mean winds [m/s]; NAN: empty sector */
    double *shape;     /* Weibull k [-]; NAN: empty sector                      */
    double typed_sum;  /* sum of the frequencies in the file                    */
    double *calm;      /* share of the sector's hours without wind; A and k are of the others; NULL: none */
};

/* A direction the wind comes from. Given: a number [deg], or a name N, NNE, ... NNW in either case or its
 * Chinese name. Returned: true and *degrees; *named (may be NULL): whether it is a name. */
bool wf_rose_direction(const char *text, double *degrees, bool *named);
/* Find a required column of speeds that is called, for example, "speed_ms": that one, or one that differs in
 * its unit alone (speed_kmh, speed_kn, "speed [km/h]"); the unit may also stand in a logger's head. Returned:
 * its index, and the factor to m/s; WF_CSV_NONE after a mistake of the table or an error in *e. */
struct wf_csv;
size_t wf_speed_column(struct wf_csv *c, const char *name, double *factor, struct wf_err *e);

/* Read a wind rose from a CSV with columns direction_deg (or from_deg, direction, sector; degrees or names),
 * frequency, weibull_scale_ms (or in another unit of speed), weibull_shape and, if wanted, calm: 8, 12 or 16
 * rows, one for each sector from north, in any order. Frequencies may be shares, per cent or counts; they are
 * divided by their sum, with a warning `frequency-sum` where it is not within 1 % of 1 or 100.
 * Shape 1.0..4.0, scale 0.1..40 m/s; both are ignored where the frequency is 0. Errors: WF_EINPUT with all
 * mistakes in `d`. */
enum wf_status wf_rose_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_rose *out,
                            struct wf_err *e);
/* Make an empty rose of 8, 12 or 16 sectors; *out has room for all columns. Given: path, for messages.
 * Errors: WF_EINPUT for another number of sectors, WF_ENOMEM. */
enum wf_status wf_rose_take(size_t sectors, const char *path, struct wf_arena *a, struct wf_rose *out,
                            struct wf_err *e);
/* Share of the hours of a sector in which the wind exceeds u [m/s]: (1 - calm) exp(-(u/A)^k); 0 for an empty
 * sector. */
double wf_rose_sector_above(const struct wf_rose *r, size_t sector, double u);
/* Share of all hours in which the wind exceeds u [m/s], from any direction. */
double wf_rose_above(const struct wf_rose *r, double u);
/* Mean wind speed of the hours of a sector [m/s]: (1 - calm) A Gamma(1 + 1/k); NAN for an empty sector. */
double wf_rose_sector_mean(const struct wf_rose *r, size_t sector);
/* Mean wind speed of all hours [m/s]. */
double wf_rose_mean(const struct wf_rose *r);
/* Wind speed that is exceeded in a share of all hours [m/s], 0 < share < 1; by bisection to 1e-9 m/s. */
double wf_rose_speed(const struct wf_rose *r, double share);
#endif
