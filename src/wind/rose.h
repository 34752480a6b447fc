#ifndef WF_WIND_ROSE_H
#define WF_WIND_ROSE_H
/* A wind climate: how often the wind comes from each direction and how strong it then is. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stddef.h>

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
