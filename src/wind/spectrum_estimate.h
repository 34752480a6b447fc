#ifndef WF_WIND_SPECTRUM_ESTIMATE_H
#define WF_WIND_SPECTRUM_ESTIMATE_H
/* Spectrum and coherence of series at an even step. Source: Welch P.D. (1967), IEEE Trans. Audio
 * Electroacoust. 15:70-73: half-overlapping segments, each freed of its mean, tapered with a Hann window. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>

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
