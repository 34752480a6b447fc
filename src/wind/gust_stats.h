#ifndef WF_WIND_GUST_STATS_H
#define WF_WIND_GUST_STATS_H
/* What a wind series looks like: moments, intensity, integral scale, gust factor. */
#include "base/arena.h"
#include "base/err.h"
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

/* Counts of x in `bins` equal bins from low to high; outside goes to the end bins. */
void wf_histogram(const double *x, size_t n, double low, double high, size_t bins, size_t *count);
#endif
