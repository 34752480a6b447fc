/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_RAIN_H
#define WF_LOAD_RAIN_H
/* Rain over an area: sizes of drops, how fast they fall, how many arrive when. Every drop is a pure function
 * of seed, step and number (base/random.h), so that any number of threads sees the same rain. */
#include "base/err.h"
#include <stddef.h>
#include <stdint.h>

/* Terminal speed of drops in air [m/s] by diameter [m]; 0 below the law's range. */
struct wf_fall_law {
    const char *name, *source;
    double low, high; /* diameters of its evidence [m] */
    double (*speed)(double diameter);
};
extern const struct wf_fall_law wf_fall_laws[]; /* atlas first; ends at name == NULL */
const struct wf_fall_law *wf_fall_law_named(const char *name);

/* Drops of Marshall and Palmer (1948): 8000 exp(-4.1 R^-0.21 D) per m3 and mm of diameter D [mm] in rain of R
 * mm/h, between two diameters. */
struct wf_spectrum_sums {
    double flux;    /* water that falls by them and the law of speed [m/s]            */
    double content; /* water in the air [kg m-3]                                      */
    double number;  /* drops that arrive [m-2 s-1]                                    */
};
void wf_marshall_palmer(double intensity, double low, double high, const struct wf_fall_law *law,
                        struct wf_spectrum_sums *out);

enum { WF_RAIN_CLASSES = 512 };
struct wf_rain {
    /* given */
    const struct wf_fall_law *law;
    double intensity;       /* at the peak [m/s]; 0: `rate` and `diameter` are given          */
    double rate, diameter;  /* arrivals a second at the peak; diameter of all drops [m]       */
    double least, largest;  /* of the spectrum [m]                                            */
    double low[2], high[2]; /* area that drops start over [m]                                */
    double middle, width;   /* of the normal curve of their number [s]; width 0: steady        */
    double jitter;          /* standard deviation of the random factor on it [-]               */
    double slot;            /* time for which a random factor holds [s]                        */
    uint64_t seed;
    /* made by wf_rain_make */
    double scale;                      /* on the spectrum's number, so that its flux is the intensity     */
    double below[WF_RAIN_CLASSES + 1]; /* share of the drops below evenly spaced diameters [-] */
};
struct wf_raindrop {
    double diameter, x, y; /* [m] */
    double when;           /* share of the step */
};
/* Check what is given and make the rest. Errors: WF_EUSAGE with the value and its range. */
enum wf_status wf_rain_make(struct wf_rain *r, struct wf_err *e);
/* Expected arrivals a second at a time; without the random factor, and with it. */
double wf_rain_rate(const struct wf_rain *r, double time);
double wf_rain_rate_varied(const struct wf_rain *r, double time);
/* Drops that start in a step of `dt` from `time`: a Poisson number. */
size_t wf_rain_count(const struct wf_rain *r, uint64_t step, double time, double dt);
/* Drop k of a step. */
void wf_rain_drop(const struct wf_rain *r, uint64_t step, size_t k, struct wf_raindrop *out);
#endif
