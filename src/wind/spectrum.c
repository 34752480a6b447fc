/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/spectrum.h"
#include "base/num.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <string.h>

/* The target spectra. Each is scaled by its integral over all frequencies, so that its variance is the one
 * specified. */

/* Integrals of the printed forms over n = 0..infinity, in u*^2:
 *   u: 105 f/(1+33 f)^(5/3) / n      -> 105/33 * 3/2
 *   v: 17 f/(1+9.5 f)^(5/3) / n      -> 17/9.5 * 3/2
 *   w: 2.1 f/(1+5.3 f^(5/3)) / n     -> 2.1 * 5.3^-0.6 * 0.6 pi / sin(0.6 pi)                            */
#define KAIMAL_U (105.0 / 33.0 * 1.5)
#define KAIMAL_V (17.0 / 9.5 * 1.5)

static double kaimal_w(void) { return 2.1 * pow(5.3, -0.6) * 0.6 * WF_PI / sin(0.6 * WF_PI); }

static double kaimal_friction2(const struct wf_spectrum_par *p)
{
    return p->deviation * p->deviation / KAIMAL_U;
}

static double kaimal(const struct wf_spectrum_par *p, enum wf_component c, double n)
{
    double scale = p->height / p->speed, f = n * scale, u2 = kaimal_friction2(p);
    switch (c) {
    case WF_ALONG:
        return u2 * scale * 105.0 * pow(1.0 + 33.0 * f, -5.0 / 3.0);
    case WF_ACROSS:
        return u2 * scale * 17.0 * pow(1.0 + 9.5 * f, -5.0 / 3.0);
    default:
        return u2 * scale * 2.1 / (1.0 + 5.3 * pow(f, 5.0 / 3.0));
    }
}

static double kaimal_ratio(const struct wf_spectrum_par *p, enum wf_component c)
{
    (void)p;
    if (c == WF_ALONG) return 1.0;
    return sqrt((c == WF_ACROSS ? KAIMAL_V : kaimal_w()) / KAIMAL_U);
}

/* Kaimal et al. 1972: -n C_uw / u*^2 = 14 f / (1 + 9.6 f)^2.4. */
static double kaimal_shear(const struct wf_spectrum_par *p, double n)
{
    double scale = p->height / p->speed;
    return -kaimal_friction2(p) * scale * 14.0 * pow(1.0 + 9.6 * n * scale, -2.4);
}

/* Along: 4 x/(1 + a x^2)^(5/6). Across and up: 4 x (1 + 8/3 b x^2)/(1 + b x^2)^(11/6), b = 4 a, with their
 * own length, in isotropic turbulence half of the along-wind one. a = 4 pi (Gamma(1/3)/Gamma(5/6))^2 makes
 * the integral 1; it is printed rounded as 70.8 (and 283.2, 755.2). */
static const double KARMAN = 70.78012763381727;

static double karman_ratio(const struct wf_spectrum_par *p, enum wf_component c)
{
    return c == WF_ALONG ? 1.0 : p->share[c - 1];
}

static double karman(const struct wf_spectrum_par *p, enum wf_component c, double n)
{
    double deviation = p->deviation * karman_ratio(p, c),
           length = c == WF_ALONG ? p->length : 0.5 * p->length;
    double scale = length / p->speed, x2 = n * scale * n * scale;
    double form = c == WF_ALONG
                      ? pow(1.0 + KARMAN * x2, -5.0 / 6.0)
                      : (1.0 + 32.0 / 3.0 * KARMAN * x2) * pow(1.0 + 4.0 * KARMAN * x2, -11.0 / 6.0);
    return deviation * deviation * 4.0 * scale * form;
}

/* n S/u*^2 = 4 x^2/(1+x^2)^(4/3), x = 1200 n/U10; integral 6 u*^2. */
static double davenport(const struct wf_spectrum_par *p, enum wf_component c, double n)
{
    double scale = 1200.0 / p->speed, x = n * scale;
    (void)c;
    return p->deviation * p->deviation / 6.0 * 4.0 * scale * x * pow(1.0 + x * x, -4.0 / 3.0);
}

/* Constant below `low`, f^-slope above, zero beyond `high`; scaled to the variance in closed form. */
static double power_law(const struct wf_spectrum_par *p, enum wf_component c, double n)
{
    double b = p->slope, r = p->high / p->low;
    double tail = fabs(b - 1.0) < 1e-9 ? log(r) : (1.0 - pow(r, 1.0 - b)) / (b - 1.0);
    double level = p->deviation * p->deviation / (p->low * (1.0 + tail));
    (void)c;
    if (n > p->high) return 0.0;
    return n <= p->low ? level : level * pow(n / p->low, -b);
}

static double along_only(const struct wf_spectrum_par *p, enum wf_component c)
{
    (void)p;
    return c == WF_ALONG ? 1.0 : 0.0;
}

const struct wf_spectrum wf_spectra[] = {
    { "kaimal", "Kaimal surface-layer spectra",
      "Kaimal J.C., Wyngaard J.C., Izumi Y., Cote O.R. (1972), Q. J. R. Meteorol. Soc. 98:563-589",
      "neutral surface layer over flat open ground; height 5.66 m to about 100 m, outside canopies", 3,
      kaimal, kaimal_ratio, kaimal_shear },
    { "von-karman", "von Karman spectra",
      "von Karman T. (1948), Proc. Natl. Acad. Sci. 34:530-539; across and up as in ESDU 85020 (1985)",
      "isotropic inertial range; height above about 30 m fits best, length given by the user", 3, karman,
      karman_ratio, NULL },
    { "davenport", "Davenport gust spectrum", "Davenport A.G. (1961), Q. J. R. Meteorol. Soc. 87:194-211",
      "strong winds, near neutral, along the wind; one curve for all heights, speed meant at 10 m", 1,
      davenport, along_only, NULL },
    { "one-over-f", "power-law spectrum 1/f^beta",
      "Voss R.F. (1985), Random fractal forgeries, in Fundamental Algorithms for Computer Graphics",
      "a slope and a band, no wind physics; beta = 5/3 gives the inertial range", 1, power_law, along_only,
      NULL },
    { 0 }
};

const struct wf_spectrum *wf_spectrum_named(const char *name)
{
    for (const struct wf_spectrum *s = wf_spectra; s->name; s++)
        if (strcmp(s->name, name) == 0) return s;
    return NULL;
}

/* Variances. */

struct integrand {
    const struct wf_spectrum *s;
    const struct wf_spectrum_par *p;
    enum wf_component c;
    double window; /* [s]; 0: no averaging */
};

static double weighted_density(double log_f, void *ctx)
{
    const struct integrand *g = ctx;
    double f = exp(log_f), arg = WF_PI * f * g->window;
    double sinc = arg > 1e-8 ? sin(arg) / arg : 1.0;
    return f * g->s->density(g->p, g->c, f) * sinc * sinc;
}

static double integrate_density(struct integrand *g, double from, double to)
{
    enum { ROOM = 2000 };
    double sum = 0.0, error = 0.0, low = fmax(from, 1e-9), head = 0.0;
    if (!(to > low)) return 0.0;
    double piece[4][ROOM]; /* bounds, results, errors of the intervals */
    size_t place[2][ROOM];
    gsl_integration_workspace w = { .limit = ROOM,
                                    .alist = piece[0],
                                    .blist = piece[1],
                                    .rlist = piece[2],
                                    .elist = piece[3],
                                    .order = place[0],
                                    .level = place[1] };
    gsl_function f = { weighted_density, g };
    wf_quiet_begin();
    int bad =
        gsl_integration_qag(&f, log(low), log(to), 0.0, 1e-8, ROOM, GSL_INTEG_GAUSS61, &w, &sum, &error);
    wf_quiet_end();
    /* below 1 nHz the density is treated as constant */
    if (from < low) head = (low - from) * g->s->density(g->p, g->c, from);
    return bad ? NAN : sum + head;
}

double wf_spectrum_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p, enum wf_component c,
                            double from, double to)
{
    struct integrand g = { s, p, c, 0.0 };
    return integrate_density(&g, from, to);
}

double wf_spectrum_averaged_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p,
                                     double window, double to)
{
    struct integrand g = { s, p, WF_ALONG, window };
    return integrate_density(&g, 0.0, to);
}

/* Spectrum and coherence of series. */

struct welch_segments {
    size_t length, count, hop;
    double *taper, power; /* sum of taper^2 */
    gsl_fft_real_wavetable *table;
    gsl_fft_real_workspace *space;
};

static void free_segments(struct welch_segments *s)
{
    if (s->table) gsl_fft_real_wavetable_free(s->table);
    if (s->space) gsl_fft_real_workspace_free(s->space);
}

static enum wf_status cut_segments(struct welch_segments *s, size_t n, size_t length, struct wf_arena *a,
                                   struct wf_err *e)
{
    memset(s, 0, sizeof *s);
    if (length < 8 || length % 2 || length > n)
        return wf_fail(e, WF_EUSAGE, "a segment of %zu steps of a series of %zu: even, 8..%zu", length, n, n);
    s->length = length;
    s->hop = length / 2;
    s->count = 1 + (n - length) / s->hop;
    s->taper = WF_TAKE(a, length, double);
    wf_quiet_begin();
    s->table = gsl_fft_real_wavetable_alloc(length);
    s->space = gsl_fft_real_workspace_alloc(length);
    wf_quiet_end();
    if (!s->taper || !s->table || !s->space) {
        free_segments(s);
        return wf_fail(e, WF_ENOMEM, "not enough memory for a spectrum of %zu steps", length);
    }
    for (size_t i = 0; i < length; i++) {
        s->taper[i] = 0.5 - 0.5 * cos(WF_TURN * ((double)i + 0.5) / (double)length);
        s->power += s->taper[i] * s->taper[i];
    }
    return WF_OK;
}

static void transform_segment(const struct welch_segments *s, const double *x, size_t at, double *h)
{
    double mean = 0.0;
    for (size_t i = 0; i < s->length; i++) mean += x[at * s->hop + i];
    mean /= (double)s->length;
    for (size_t i = 0; i < s->length; i++) h[i] = (x[at * s->hop + i] - mean) * s->taper[i];
    gsl_fft_real_transform(h, 1, s->length, s->table, s->space);
}

/* Real and imaginary part of frequency k of a halfcomplex spectrum. */
static double real_part(const double *h, size_t k) { return k ? h[2 * k - 1] : h[0]; }
static double imaginary_part(const double *h, size_t k, size_t n) { return k && 2 * k < n ? h[2 * k] : 0.0; }

enum wf_status wf_spectrum_welch(const double *x, size_t n, double step, size_t segment, double *density,
                                 size_t *segments, struct wf_arena *a, struct wf_err *e)
{
    struct welch_segments s;
    enum wf_status status = cut_segments(&s, n, segment, a, e);
    if (status) return status;
    double *h = WF_TAKE(a, segment, double);
    if (!h) {
        free_segments(&s);
        return wf_fail(e, WF_ENOMEM, "not enough memory for a spectrum of %zu steps", segment);
    }
    memset(density, 0, (segment / 2 + 1) * sizeof *density);
    for (size_t q = 0; q < s.count; q++) {
        transform_segment(&s, x, q, h);
        for (size_t k = 0; k <= segment / 2; k++) {
            double two_sided = (k && 2 * k < segment ? 2.0 : 1.0) * step / (s.power * (double)s.count);
            density[k] += two_sided * (real_part(h, k) * real_part(h, k) +
                                       imaginary_part(h, k, segment) * imaginary_part(h, k, segment));
        }
    }
    if (segments) *segments = s.count;
    free_segments(&s);
    return WF_OK;
}

enum wf_status wf_coherence_welch(const double *x, const double *y, size_t n, double step, size_t segment,
                                  double *modulus, double *real, size_t *segments, struct wf_arena *a,
                                  struct wf_err *e)
{
    struct welch_segments s;
    (void)step;
    enum wf_status status = cut_segments(&s, n, segment, a, e);
    if (status) return status;
    size_t half = segment / 2 + 1;
    double *hx = WF_TAKE(a, segment, double), *hy = WF_TAKE(a, segment, double);
    double *sxx = WF_TAKE(a, half, double), *syy = WF_TAKE(a, half, double), *odd = WF_TAKE(a, half, double);
    if (!hx || !hy || !sxx || !syy || !odd) {
        free_segments(&s);
        return wf_fail(e, WF_ENOMEM, "not enough memory for a spectrum of %zu steps", segment);
    }
    memset(real, 0, half * sizeof *real);
    for (size_t q = 0; q < s.count; q++) {
        transform_segment(&s, x, q, hx);
        transform_segment(&s, y, q, hy);
        for (size_t k = 0; k < half; k++) {
            double xr = real_part(hx, k), xi = imaginary_part(hx, k, segment), yr = real_part(hy, k),
                   yi = imaginary_part(hy, k, segment);
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
    free_segments(&s);
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
