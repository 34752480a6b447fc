/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_SPECTRUM_H
#define WF_WIND_SPECTRUM_H
/* One-sided power spectra of the fluctuating wind, S(f) [m2/s] with f in [Hz] and the integral of S over
 * f = 0..infinity equal to the variance of the component. Rows with source and range. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>

enum wf_component { WF_ALONG, WF_ACROSS, WF_UP, WF_COMPONENTS };

struct wf_spectrum_par {
    double speed;      /* mean wind at the point [m/s]                                    */
    double height;     /* above the displaced ground [m]                                  */
    double deviation;  /* standard deviation of the along-wind component [m/s]            */
    double length;     /* along-wind integral length of u [m] (von-karman)                */
    double share[2];   /* standard deviation of v and of w over that of u (von-karman)    */
    double slope, low; /* S ~ f^-slope above `low` [Hz], flat below, none above `high`    */
    double high;       /* [Hz] (one-over-f)                                               */
};

struct wf_spectrum {
    const char *name, *title, *source, *validity;
    unsigned components; /* 1: along the wind only; 3 */
    /* S at frequency f >= 0 [m2/s]; finite at f = 0 */
    double (*density)(const struct wf_spectrum_par *p, enum wf_component c, double f);
    /* standard deviation of a component over that of u [-] */
    double (*ratio)(const struct wf_spectrum_par *p, enum wf_component c);
    /* co-spectrum of u and w [m2/s], one-sided, NULL: none given by the source */
    double (*shear)(const struct wf_spectrum_par *p, double f);
};
extern const struct wf_spectrum
    wf_spectra[]; /* kaimal, von-karman, davenport, one-over-f; ends at name == NULL */
const struct wf_spectrum *wf_spectrum_named(const char *name);

/* Variance between two frequencies [m2/s2], adaptive integration in log f (GSL qag); relative error 1e-8. */
double wf_spectrum_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p, enum wf_component c,
                            double from, double to);
/* Variance of the mean over `window` seconds [m2/s2]: each frequency weighted by sinc^2(f window). */
double wf_spectrum_averaged_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p,
                                     double window, double to);

/* Spectrum and coherence of series at an even step. Source: Welch P.D. (1967), IEEE Trans. Audio
 * Electroacoust. 15:70-73: half-overlapping segments, each freed of its mean, tapered with a Hann window. */

/* One-sided density [x2/Hz] at frequencies k/(segment step), k = 0..segment/2, so that its sum times the
 * frequency step is the variance. Given: series x[n], segment length (even, at most n). Returned: density of
 * segment/2 + 1 numbers, count of segments averaged in *segments (may be NULL). */
enum wf_status wf_spectrum_welch(const double *x, size_t n, double step, size_t segment, double *density,
                                 size_t *segments, struct wf_arena *a, struct wf_err *e);

/* Root-coherence |S_xy|/sqrt(S_xx S_yy), and its real part (co-coherence), at the same frequencies. With m
 * segments the modulus of two independent series is not 0 but about sqrt(pi/(4m)); the real part is unbiased.
 */
enum wf_status wf_coherence_welch(const double *x, const double *y, size_t n, double step, size_t segment,
                                  double *modulus, double *real, size_t *segments, struct wf_arena *a,
                                  struct wf_err *e);

/* Bands of equal ratio. A band holds whole bins first..last-1 of a spectrum of `segment`. */
struct wf_band {
    size_t first, last;
    double low, high, centre; /* [Hz]: edges of its bins, geometric middle */
};
/* Bands of `per_decade` from bin 1 to segment/2 - 1; narrow ones at the low end grow to hold at least one
 * bin. Returned: number of bands, at most `room`. */
size_t wf_bands(size_t segment, double step, unsigned per_decade, struct wf_band *band, size_t room);
/* Mean of values[] over a band's bins. */
double wf_band_mean(const struct wf_band *b, const double *values);
/* Slope of log mean density against log frequency between two frequencies: least squares over the bands. */
double wf_spectrum_slope(const struct wf_band *band, size_t bands, const double *density, double from,
                         double to);
#endif
