/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_REPORT_H
#define WF_WIND_GUST_REPORT_H
/* What a wind series looks like: moments, intensity, integral scale, gust factor. */
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
    double gust_window, period; /* averaging times of the gust factor [s], as used                    */
    double gust_factor;         /* largest mean over gust_window / mean over the period, averaged over the
                                   whole periods in the series [-]; NAN when there is none             */
    double peak_factor;         /* (largest windowed mean - mean) / deviation, averaged the same way [-] */
    size_t periods;
};
/* Given: x[n], step [s], gust averaging time (3 s is usual), period of the mean (600 s; longer than the
 * series: the whole series). Autocorrelation by FFT (Wiener-Khinchin), zero-padded. */
enum wf_status wf_gust_stats(const double *x, size_t n, double step, double gust_window, double period,
                             struct wf_arena *a, struct wf_gust_stats *out, struct wf_err *e);

/* A gust model run once and looked at: does it do what it was asked to? */

enum { WF_REPORT_BANDS = 96, WF_REPORT_BINS = 40 };

/* One property that was asked for and what came out. */
struct wf_gust_finding {
    const char *name, *unit;
    double asked, got;
    double scatter; /* one standard error of `got` in a series of this length; NAN: none given */
    bool within;    /* |got - asked| <= 4 scatter plus a slack for spectra                       */
};
enum { WF_GUST_FINDINGS = 12 };

struct wf_gust_report {
    struct wf_gust_spec spec;
    double *x; /* [(c * points + p) * steps + i] velocity [m/s]               */
    struct wf_gust_stats stats[WF_COMPONENTS];
    double joint, coherence_error; /* of the synthesis; NAN where they do not apply              */
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

/* Run the model over all its steps, holding the series (points * components * steps numbers), and measure it.
 */
enum wf_status wf_gust_report_make(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_gust_report *out, struct wf_err *e);
#endif
