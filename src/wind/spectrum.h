/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_SPECTRUM_H
#define WF_WIND_SPECTRUM_H
/* One-sided power spectra of the fluctuating wind, S(f) [m2/s], f in [Hz]: the integral of S over f =
 * 0..infinity is the variance of the component. Target spectra are rows with source and range. Also:
 * estimates of spectrum and coherence of a series. */
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
    /* one-sided co-spectrum of u and w [m2/s]; NULL: the source gives none */
    double (*shear)(const struct wf_spectrum_par *p, double f);
};
extern const struct wf_spectrum
    wf_spectra[]; /* kaimal, von-karman, davenport, one-over-f; ends at name == NULL */
/* The spectrum of that name; NULL: none. */
const struct wf_spectrum *wf_spectrum_named(const char *name);

/* Variance between two frequencies [Hz] -> [m2/s2]. Method: adaptive integration in log f (GSL qag), relative
 * error 1e-8. NAN when it fails. */
double wf_spectrum_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p, enum wf_component c,
                            double from, double to);
/* Variance of the along-wind component averaged over `window` [s], up to frequency `to` [Hz] -> [m2/s2]: each
 * frequency is weighted by sinc^2(f window). */
double wf_spectrum_averaged_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p,
                                     double window, double to);

/* Estimates of spectrum and coherence of series at an even step. Source: Welch P.D. (1967), IEEE Trans. Audio
 * Electroacoust. 15:70-73: segments that overlap by half, each with its mean removed, tapered with a Hann
 * window. */

/* One-sided density [x2/Hz] at frequencies k/(segment step), k = 0..segment/2; its sum times the frequency
 * step is the variance. Given: series x[n], step [s], segment length [steps] (even, 8..n). Returned: density
 * of segment/2 + 1 numbers; in *segments (may be NULL) the number of segments averaged. Errors: WF_EUSAGE,
 * WF_ENOMEM. */
enum wf_status wf_spectrum_welch(const double *x, size_t n, double step, size_t segment, double *density,
                                 size_t *segments, struct wf_arena *a, struct wf_err *e);

/* Root-coherence |S_xy|/sqrt(S_xx S_yy) of two series, and its real part (co-coherence), at the same
 * frequencies. With m segments the modulus for independent series is not 0 but about sqrt(pi/(4m)); the real
 * part is unbiased. */
enum wf_status wf_coherence_welch(const double *x, const double *y, size_t n, double step, size_t segment,
                                  double *modulus, double *real, size_t *segments, struct wf_arena *a,
                                  struct wf_err *e);

/* A band of frequencies: the bins first..last-1 of a spectrum. */
struct wf_band {
    size_t first, last;
    double low, high, centre; /* [Hz]: edges of its bins, geometric middle */
};
/* Divide the bins 1..segment/2 - 1 into bands of equal frequency ratio, `per_decade` a decade; at the low end
 * a band has at least one bin. Returned: number of bands, at most `room`. */
size_t wf_bands(size_t segment, double step, unsigned per_decade, struct wf_band *band, size_t room);
/* Mean of values[] over the bins of a band. */
double wf_band_mean(const struct wf_band *b, const double *values);
/* Slope of log density against log frequency between two frequencies [Hz]: least squares over the bands. */
double wf_spectrum_slope(const struct wf_band *band, size_t bands, const double *density, double from,
                         double to);
#endif
