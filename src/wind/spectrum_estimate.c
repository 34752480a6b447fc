#include "wind/spectrum_estimate.h"
#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <string.h>

struct segments {
    size_t length, count, hop;
    double *taper, power; /* sum of taper^2 */
    gsl_fft_real_wavetable *table;
    gsl_fft_real_workspace *space;
};

static void drop(struct segments *s)
{
    if (s->table) gsl_fft_real_wavetable_free(s->table);
    if (s->space) gsl_fft_real_workspace_free(s->space);
}

static enum wf_status cut(struct segments *s, size_t n, size_t length, struct wf_arena *a, struct wf_err *e)
{
    memset(s, 0, sizeof *s);
    if (length < 8 || length % 2 || length > n)
        return wf_fail(e, WF_EUSAGE, "a segment of %zu steps of a series of %zu: even, 8..%zu", length, n, n);
    s->length = length;
    s->hop = length / 2;
    s->count = 1 + (n - length) / s->hop;
    s->taper = WF_TAKE(a, length, double);
    s->table = gsl_fft_real_wavetable_alloc(length);
    s->space = gsl_fft_real_workspace_alloc(length);
    if (!s->taper || !s->table || !s->space) {
        drop(s);
        return wf_fail(e, WF_ENOMEM, "no room for a spectrum of %zu steps", length);
    }
    for (size_t i = 0; i < length; i++) {
        s->taper[i] = 0.5 - 0.5 * cos(6.28318530717958647692 * ((double)i + 0.5) / (double)length);
        s->power += s->taper[i] * s->taper[i];
    }
    return WF_OK;
}

static void transform(const struct segments *s, const double *x, size_t at, double *h)
{
    double mean = 0.0;
    for (size_t i = 0; i < s->length; i++) mean += x[at * s->hop + i];
    mean /= (double)s->length;
    for (size_t i = 0; i < s->length; i++) h[i] = (x[at * s->hop + i] - mean) * s->taper[i];
    gsl_fft_real_transform(h, 1, s->length, s->table, s->space);
}

/* Real and imaginary part of frequency k of a halfcomplex spectrum. */
static double re(const double *h, size_t k) { return k ? h[2 * k - 1] : h[0]; }
static double im(const double *h, size_t k, size_t n) { return k && 2 * k < n ? h[2 * k] : 0.0; }

enum wf_status wf_spectrum_welch(const double *x, size_t n, double step, size_t segment, double *density,
                                 size_t *segments, struct wf_arena *a, struct wf_err *e)
{
    struct segments s;
    enum wf_status status = cut(&s, n, segment, a, e);
    if (status) return status;
    double *h = WF_TAKE(a, segment, double);
    if (!h) {
        drop(&s);
        return wf_fail(e, WF_ENOMEM, "no room for a spectrum of %zu steps", segment);
    }
    memset(density, 0, (segment / 2 + 1) * sizeof *density);
    for (size_t q = 0; q < s.count; q++) {
        transform(&s, x, q, h);
        for (size_t k = 0; k <= segment / 2; k++) {
            double two_sided = (k && 2 * k < segment ? 2.0 : 1.0) * step / (s.power * (double)s.count);
            density[k] += two_sided * (re(h, k) * re(h, k) + im(h, k, segment) * im(h, k, segment));
        }
    }
    if (segments) *segments = s.count;
    drop(&s);
    return WF_OK;
}

enum wf_status wf_coherence_welch(const double *x, const double *y, size_t n, double step, size_t segment,
                                  double *modulus, double *real, size_t *segments, struct wf_arena *a,
                                  struct wf_err *e)
{
    struct segments s;
    (void)step;
    enum wf_status status = cut(&s, n, segment, a, e);
    if (status) return status;
    size_t half = segment / 2 + 1;
    double *hx = WF_TAKE(a, segment, double), *hy = WF_TAKE(a, segment, double);
    double *sxx = WF_TAKE(a, half, double), *syy = WF_TAKE(a, half, double), *odd = WF_TAKE(a, half, double);
    if (!hx || !hy || !sxx || !syy || !odd) {
        drop(&s);
        return wf_fail(e, WF_ENOMEM, "no room for a spectrum of %zu steps", segment);
    }
    memset(real, 0, half * sizeof *real);
    for (size_t q = 0; q < s.count; q++) {
        transform(&s, x, q, hx);
        transform(&s, y, q, hy);
        for (size_t k = 0; k < half; k++) {
            double xr = re(hx, k), xi = im(hx, k, segment), yr = re(hy, k), yi = im(hy, k, segment);
            sxx[k] += xr * xr + xi * xi;
            syy[k] += yr * yr + yi * yi;
            real[k] += xr * yr + xi * yi;
            odd[k] += xi * yr - xr * yi;
        }
    }
    for (size_t k = 0; k < half; k++) {
        double norm = sqrt(sxx[k] * syy[k]);
        modulus[k] = norm > 0.0 ? hypot(real[k], odd[k]) / norm : 0.0;
        real[k] = norm > 0.0 ? real[k] / norm : 0.0;
    }
    if (segments) *segments = s.count;
    drop(&s);
    return WF_OK;
}

size_t wf_bands(size_t segment, double step, unsigned per_decade, struct wf_band *band, size_t room)
{
    double df = 1.0 / ((double)segment * step), ratio = pow(10.0, 1.0 / (double)per_decade), edge = 0.5;
    size_t n = 0, first = 1, end = segment / 2;
    while (first < end && n < room) {
        do edge *= ratio;
        while (edge < (double)first + 0.5);
        size_t last = (size_t)ceil(edge + 0.5);
        if (last > end) last = end;
        band[n].first = first, band[n].last = last;
        band[n].low = ((double)first - 0.5) * df, band[n].high = ((double)last - 0.5) * df;
        band[n].centre = sqrt(band[n].low * band[n].high);
        n++;
        first = last;
    }
    return n;
}

double wf_band_mean(const struct wf_band *b, const double *values)
{
    double sum = 0.0;
    for (size_t k = b->first; k < b->last; k++) sum += values[k];
    return sum / (double)(b->last - b->first);
}

double wf_spectrum_slope(const struct wf_band *band, size_t bands, const double *density, double from,
                         double to)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (size_t i = 0; i < bands; i++) {
        double mean = wf_band_mean(band + i, density);
        if (band[i].low < from || band[i].high > to || !(mean > 0.0)) continue;
        double x = log(band[i].centre), y = log(mean);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}
