/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_CLIMATE_H
#define WF_WIND_CLIMATE_H
/* Wind named by a scale, and the same wind under another averaging time. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

#define WF_MEAN_TIME 600.0 /* time mean winds are averaged over throughout [s] */

struct wf_wind_grade {
    const char *name; /* "8", "typhoon"                        */
    double low, high; /* [m/s]; high = INFINITY for the last   */
    const char *text; /* "gale"                                */
    const char *sign; /* what trees do; NULL: the scale does not say */
};
struct wf_wind_scale {
    const char *name; /* "beaufort" */
    const char *title, *source;
    double averaging;                  /* time the scale's speeds are averaged over [s] */
    const char *law;                   /* row of wf_averaging_laws that suits what it grades */
    double height;                     /* they are meant at [m], over open ground or sea */
    const struct wf_wind_grade *grade; /* ends at name == NULL */
};
extern const struct wf_wind_scale wf_wind_scales[]; /* beaufort, cma, hko; ends at name == NULL */

struct wf_scale_wind {
    const struct wf_wind_scale *scale;
    const struct wf_wind_grade *grade;
    double speed; /* middle of the grade; its lower bound where it has no upper one [m/s] */
};

/* Whether text is of the form "scale:grade" and not a plain speed. */
bool wf_wind_scale_is(const char *text);
/* Read "beaufort:8", "cma:typhoon", "cma:severe-typhoon", "hko:typhoon". WF_EUSAGE names the scales or grades
 * there are. The speed is that of the scale's own averaging time. */
enum wf_status wf_wind_scale_parse(const char *text, struct wf_scale_wind *out, struct wf_err *e);
/* The grade a speed has; NULL below the first. */
const struct wf_wind_grade *wf_wind_scale_grade(const struct wf_wind_scale *s, double speed);

/* Laws for other averaging times. "durst": the largest mean over t seconds within an hour, open country;
 * Durst C.S. (1960), Meteorol. Mag. 89:181-186, in the fit of the Shore Protection Manual (1984):
 * U_t/U_3600 = 1.277 + 0.296 tanh(0.9 log10(45 s/t)), 1 s to 3600 s.
 * "in-land", "off-land", "off-sea", "at-sea": gust factors of Harper B.A., Kepert J.D., Ginger J.D. (2010),
 * Guidelines for converting between various wind averaging periods in tropical cyclone conditions,
 * WMO/TD-1555, table 1.1; between a mean over 600 s or 3600 s and gusts of 3, 60, 120, 180 or 600 s. */
struct wf_averaging_law {
    const char *name, *source, *validity;
};
extern const struct wf_averaging_law wf_averaging_laws[]; /* ends at name == NULL */

/* Largest wind averaged over `to` seconds within a period of `from` seconds whose mean is `speed`, or, for
 * to > from, the mean of the longer period whose largest `from` wind is `speed`. Times in [s]. WF_EUSAGE for
 * a time or law that is not covered. */
enum wf_status wf_wind_average(const char *law, double speed, double from, double to, double *out,
                               struct wf_err *e);

/* A wind climate: how often the wind comes from each direction and how strong it then is. */

struct wf_rose {
    size_t sectors;    /* 8, 12 or 16                                           */
    double *from;      /* middle of the sector, clockwise from north [rad]      */
    double *frequency; /* share of all hours, sum 1                             */
    double *scale;     /* Weibull A of hourly mean winds [m/s]                  */
    double *shape;     /* Weibull k [-]                                         */
    double typed_sum;  /* what the frequencies of the file summed to            */
};

/* Read columns direction_deg, frequency, weibull_scale_ms, weibull_shape: 8, 12 or 16 rows, one for each
 * sector from north, in any order. Frequencies may be shares, per cent or counts and are divided by their
 * sum. Shape 1.0..4.0, scale 0.1..40 m/s. Every mistake is a finding. */
enum wf_status wf_rose_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_rose *out,
                            struct wf_err *e);
/* Share of the hours of a sector with a wind above u: exp(-(u/A)^k). */
double wf_rose_sector_above(const struct wf_rose *r, size_t sector, double u);
/* Share of all hours with a wind above u, from any direction. */
double wf_rose_above(const struct wf_rose *r, double u);
/* Mean wind of all hours [m/s]: sum f A Gamma(1 + 1/k). */
double wf_rose_mean(const struct wf_rose *r);
/* Wind that is exceeded `share` of the time [m/s], 0 < share < 1; bisection to 1e-9 m/s. */
double wf_rose_speed(const struct wf_rose *r, double share);
#endif
