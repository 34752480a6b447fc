/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_REPORT_H
#define WF_WIND_GUST_REPORT_H
/* Statistics of a wind series (moments, intensity, integral scale, gust factor), and a report that compares
 * the wind of a gust model with its specification. */
#include "base/arena.h"
#include "base/err.h"
#include "wind/gust.h"
#include "wind/spectrum.h"
#include <stddef.h>

struct wf_gust_stats {
    double mean, deviation;     /* [m/s]                                                              */
    double intensity;           /* deviation / mean [-]                                               */
    double skewness, kurtosis;  /* [-]; 0 and 3 for a normal distribution                             */
    double low, high;           /* least and largest value [m/s]                                      */
    double time_scale;          /* integral of the autocorrelation to its first zero [s]              */
    double length_scale;        /* time_scale * mean [m]                                              */
    double gust_window, period; /* averaging times of the gust factor as used: whole steps [s]        */
    double gust_factor;         /* largest mean over gust_window / mean over the period, averaged over the
                                   whole periods in the series [-]; NAN when there is none             */
    double peak_factor;         /* (largest windowed mean - mean) / deviation, averaged the same way [-] */
    size_t periods;
};
/* Compute the statistics of a series. Given: x[n] [m/s], step [s], averaging time of gusts (usually 3 s),
 * period of the mean (usually 600 s; if longer than the series, the whole series). Method: autocorrelation by
 * zero-padded FFT (Wiener-Khinchin). Errors: WF_EUSAGE for fewer than 2 steps, WF_ENOMEM. */
enum wf_status wf_gust_stats(const double *x, size_t n, double step, double gust_window, double period,
                             struct wf_arena *a, struct wf_gust_stats *out, struct wf_err *e);

enum { WF_REPORT_BANDS = 96, WF_REPORT_BINS = 40 };

/* A specified property of the wind and its measured value. */
struct wf_gust_finding {
    const char *name, *unit;
    double asked, got; /* specified, measured                                                       */
    double scatter;    /* standard error of `got` in a series of this length; NAN: unknown          */
    bool within;       /* |got - asked| <= 4 scatter plus a tolerance                               */
};
enum { WF_GUST_FINDINGS = 12 };

struct wf_gust_report {
    struct wf_gust_spec spec;
    double *x; /* [(c * points + p) * steps + i] velocity [m/s]               */
    struct wf_gust_stats stats[WF_COMPONENTS];
    double joint, coherence_error; /* errors of the synthesis; NAN where they do not apply       */
    size_t bands;
    struct wf_band band[WF_REPORT_BANDS];
    /* first point, by component and band [m2/s]; target NAN without one */
    double density[WF_COMPONENTS][WF_REPORT_BANDS], target[WF_COMPONENTS][WF_REPORT_BANDS];
    double scatter[WF_REPORT_BANDS]; /* relative standard error of a band's density: sqrt(1.94 / bins), Hann
                                        taper */
    double bin_low, bin_width;       /* histogram of the first point's along-wind speed [m/s]     */
    size_t bin[WF_REPORT_BINS];
    size_t pairs; /* points but the first, against the first                      */
    size_t pair_bands;
    struct wf_band pair_band[WF_REPORT_BANDS];
    double *coherence;        /* pairs * pair_bands: real root-coherence [-]                  */
    double *coherence_target; /* exp(-r g(f)), NAN for models without one                     */
    double *apart;            /* pairs: distance from the first point [m]                     */
    size_t findings;
    struct wf_gust_finding finding[WF_GUST_FINDINGS];
};

/* Run the model over all its steps, keep the series in memory (points * components * steps numbers) and
 * measure it. Errors: those of wf_gust_open, WF_EUSAGE for fewer than 64 steps, WF_ENOMEM. */
enum wf_status wf_gust_report_make(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_gust_report *out, struct wf_err *e);
#endif
