/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/gust_report.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "wind/gust_spectral.h"
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Moments, gust factor and integral scale of a series. */

static void moments(const double *x, size_t n, struct wf_gust_stats *o)
{
    double m2 = 0, m3 = 0, m4 = 0, sum = 0;
    o->low = o->high = x[0];
    for (size_t i = 0; i < n; i++) {
        sum += x[i];
        o->low = fmin(o->low, x[i]);
        o->high = fmax(o->high, x[i]);
    }
    o->mean = sum / (double)n;
    for (size_t i = 0; i < n; i++) {
        double d = x[i] - o->mean;
        m2 += d * d, m3 += d * d * d, m4 += d * d * d * d;
    }
    m2 /= (double)n;
    o->deviation = sqrt(m2);
    o->intensity = o->deviation / o->mean;
    o->skewness = m2 > 0 ? m3 / (double)n / pow(m2, 1.5) : 0.0;
    o->kurtosis = m2 > 0 ? m4 / (double)n / (m2 * m2) : 0.0;
}

static enum wf_status time_scale(const double *x, size_t n, double step, struct wf_arena *a,
                                 struct wf_gust_stats *o, struct wf_err *e)
{
    size_t length = 2;
    while (length < 2 * n) length *= 2;
    double *h = WF_TAKE(a, length, double);
    wf_quiet_begin();
    gsl_fft_real_wavetable *forward = gsl_fft_real_wavetable_alloc(length);
    gsl_fft_halfcomplex_wavetable *back = gsl_fft_halfcomplex_wavetable_alloc(length);
    gsl_fft_real_workspace *space = gsl_fft_real_workspace_alloc(length);
    wf_quiet_end();
    bool room = h && forward && back && space;
    if (room) {
        for (size_t i = 0; i < n; i++) h[i] = x[i] - o->mean;
        gsl_fft_real_transform(h, 1, length, forward, space);
        h[0] *= h[0];
        for (size_t k = 1; k < length / 2; k++) {
            h[2 * k - 1] = h[2 * k - 1] * h[2 * k - 1] + h[2 * k] * h[2 * k];
            h[2 * k] = 0.0;
        }
        h[length - 1] *= h[length - 1];
        gsl_fft_halfcomplex_inverse(h, 1, length, back, space);
        /* trapezoids of the autocorrelation up to its first zero */
        double sum = 0.0;
        for (size_t i = 0; h[0] > 0.0 && i + 1 < n && h[i] > 0.0; i++) {
            double next = fmax(h[i + 1], 0.0), width = h[i + 1] > 0.0 ? 1.0 : h[i] / (h[i] - h[i + 1]);
            sum += 0.5 * (h[i] + next) * width / h[0];
        }
        o->time_scale = sum * step;
        o->length_scale = o->time_scale * o->mean;
    }
    if (forward) gsl_fft_real_wavetable_free(forward);
    if (back) gsl_fft_halfcomplex_wavetable_free(back);
    if (space) gsl_fft_real_workspace_free(space);
    return room ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the autocorrelation of %zu steps", n);
}

static void gust_factor(const double *x, size_t n, double step, struct wf_gust_stats *o)
{
    size_t window = (size_t)fmax(1.0, round(o->gust_window / step)), period = (size_t)round(o->period / step);
    if (period > n || period < 1) period = n;
    o->gust_window = (double)window * step;
    o->period = (double)period * step;
    o->gust_factor = o->peak_factor = NAN;
    if (window > period) return;
    double factor = 0.0, peak = 0.0;
    for (o->periods = 0; (o->periods + 1) * period <= n; o->periods++) {
        const double *y = x + o->periods * period;
        double mean = 0.0, square = 0.0, sum = 0.0, best = -INFINITY;
        for (size_t i = 0; i < period; i++) mean += y[i] / (double)period;
        for (size_t i = 0; i < period; i++) {
            square += (y[i] - mean) * (y[i] - mean) / (double)period;
            sum += y[i] - mean;
            if (i >= window) sum -= y[i - window] - mean;
            if (i + 1 >= window) best = fmax(best, sum / (double)window);
        }
        factor += (mean + best) / mean;
        peak += square > 0.0 ? best / sqrt(square) : 0.0;
    }
    o->gust_factor = factor / (double)o->periods;
    o->peak_factor = peak / (double)o->periods;
}

enum wf_status wf_gust_stats(const double *x, size_t n, double step, double gust_window, double period,
                             struct wf_arena *a, struct wf_gust_stats *out, struct wf_err *e)
{
    memset(out, 0, sizeof *out);
    if (n < 2 || !(step > 0.0)) return wf_fail(e, WF_EUSAGE, "a series of %zu steps of %g s", n, step);
    out->gust_window = gust_window;
    out->period = period;
    moments(x, n, out);
    gust_factor(x, n, step, out);
    return time_scale(x, n, step, a, out, e);
}

/* A gust model run once and measured. */

/* Count the values of x in `bins` equal bins from low to high; values outside count in the first or last bin.
 */
static void count_bins(const double *x, size_t n, double low, double high, size_t bins, size_t *count)
{
    memset(count, 0, bins * sizeof *count);
    for (size_t i = 0; i < n; i++) {
        double place = (x[i] - low) / (high - low) * (double)bins;
        size_t at = place > 0.0 ? (size_t)place : 0;
        count[at < bins ? at : bins - 1]++;
    }
}

static const double WIDE = 1.0 / 3.0; /* margin at either end of the band in which the slope is fitted [-] */

static enum wf_status run_model(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                                struct wf_gust_report *o, struct wf_err *e)
{
    struct wf_gust g;
    size_t rows = s->points * s->components;
    enum wf_status status = wf_gust_open(s, a, d, &g, e);
    if (status) return status;
    double *block = WF_TAKE(a, rows * g.block, double);
    o->x = WF_TAKE(a, rows * s->steps, double);
    if (!block || !o->x)
        status = wf_fail(e, WF_ENOMEM, "not enough memory for %zu series of %zu steps", rows, s->steps);
    wf_stage_begin(g.blocks, false, "blocks of wind");
    for (size_t b = 0; b < g.blocks && !status; b++) {
        wf_stage_step(b > 0);
        if (wf_interrupted()) status = wf_fail(e, WF_EINTERRUPTED, "interrupted before the wind was made");
        if (!status) status = wf_gust_block(&g, b, block, e);
        size_t first = b * g.block, steps = s->steps - first < g.block ? s->steps - first : g.block;
        for (size_t row = 0; row < rows; row++)
            memcpy(o->x + row * s->steps + first, block + row * g.block, steps * sizeof *block);
    }
    o->joint = s->model->spectrum ? g.joint : NAN;
    o->coherence_error = s->points > 1 ? wf_gust_coherence_error(&g, a) : NAN;
    wf_gust_close(&g);
    return status;
}

/* The largest even number up to n with no prime factor above 5: a length that transforms fast. */
static size_t transform_length(size_t n)
{
    for (n -= n % 2;; n -= 2) {
        size_t rest = n;
        while (rest % 2 == 0) rest /= 2;
        while (rest % 3 == 0) rest /= 3;
        while (rest % 5 == 0) rest /= 5;
        if (rest == 1) return n;
    }
}

static enum wf_status measure_spectra(struct wf_gust_report *o, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_gust_spec *s = &o->spec;
    size_t length = transform_length(s->steps);
    double *density = WF_TAKE(a, length / 2 + 1, double), df = 1.0 / ((double)length * s->step);
    if (!density) return wf_fail(e, WF_ENOMEM, "not enough memory for a spectrum of %zu steps", length);
    o->bands = wf_bands(length, s->step, 10, o->band, WF_REPORT_BANDS);
    for (unsigned c = 0; c < s->components; c++) {
        enum wf_status status =
            wf_spectrum_welch(o->x + c * s->points * s->steps, length, s->step, length, density, NULL, a, e);
        if (status) return status;
        for (size_t b = 0; b < o->bands; b++) {
            const struct wf_band *band = &o->band[b];
            double bins = (double)(band->last - band->first), sum = 0.0;
            for (size_t k = band->first; k < band->last; k++)
                sum += wf_gust_target(s, 0, (enum wf_component)c, (double)k * df);
            o->density[c][b] = wf_band_mean(band, density);
            o->target[c][b] = sum / bins;
            o->scatter[b] = sqrt(1.94 / bins);
        }
    }
    return WF_OK;
}

static enum wf_status measure_pairs(struct wf_gust_report *o, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_gust_spec *s = &o->spec;
    size_t segment = 64, n = s->steps;
    o->pairs = s->points - 1;
    if (!o->pairs || n < 16 * segment) return WF_OK;
    while (2 * segment * 32 <= n && segment < 4096) segment *= 2;
    double *modulus = WF_TAKE(a, segment / 2 + 1, double), *real = WF_TAKE(a, segment / 2 + 1, double);
    o->pair_bands = wf_bands(segment, s->step, 10, o->pair_band, WF_REPORT_BANDS);
    o->coherence = WF_TAKE(a, o->pairs * o->pair_bands, double);
    o->coherence_target = WF_TAKE(a, o->pairs * o->pair_bands, double);
    o->apart = WF_TAKE(a, o->pairs, double);
    if (!modulus || !real || !o->coherence || !o->coherence_target || !o->apart)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the coherence of %zu pairs", o->pairs);
    for (size_t p = 0; p < o->pairs; p++) {
        for (int axis = 0; axis < 3; axis++)
            o->apart[p] = hypot(o->apart[p], wf_gust_place(s, p + 1, axis) - wf_gust_place(s, 0, axis));
        enum wf_status status =
            wf_coherence_welch(o->x, o->x + (p + 1) * n, n, s->step, segment, modulus, real, NULL, a, e);
        if (status) return status;
        for (size_t b = 0; b < o->pair_bands; b++) {
            o->coherence[p * o->pair_bands + b] = wf_band_mean(&o->pair_band[b], real);
            o->coherence_target[p * o->pair_bands + b] =
                wf_gust_coherence_target(s, 0, p + 1, o->pair_band[b].centre);
        }
    }
    return WF_OK;
}

static void add_property(struct wf_gust_report *o, const char *name, const char *unit, double asked,
                         double got, double scatter, double slack)
{
    if (o->findings == WF_GUST_FINDINGS || isnan(asked) || isnan(got)) return;
    bool within = fabs(got - asked) <= slack + (isnan(scatter) ? 0.0 : 4.0 * scatter);
    o->finding[o->findings++] = (struct wf_gust_finding){ name, unit, asked, got, scatter, within };
}

/* Standard error of the variance in a series of duration D: sqrt(integral of S^2 df / D). That of the mean,
 * used below, is sigma sqrt(2T/D) with T the integral scale (Bendat & Piersol 2010, Random Data, ch. 8). */
static double variance_scatter(const struct wf_gust_report *o, unsigned c)
{
    double sum = 0.0;
    for (size_t b = 0; b < o->bands; b++)
        sum += o->density[c][b] * o->density[c][b] * (o->band[b].high - o->band[b].low);
    return sqrt(sum / ((double)o->spec.steps * o->spec.step));
}

static void check_moments(struct wf_gust_report *o)
{
    const struct wf_gust_spec *s = &o->spec;
    static const char *const name[WF_COMPONENTS] = { "standard deviation along the wind",
                                                     "standard deviation across", "standard deviation up" };
    double length = (double)s->steps * s->step;
    for (unsigned c = 0; c < s->components; c++) {
        const struct wf_gust_stats *got = &o->stats[c];
        double share = sqrt(2.0 * got->time_scale / length),
               wanted = sqrt(wf_gust_variance(s, 0, (enum wf_component)c));
        if (c == 0 && !isnan(wanted))
            add_property(o, "mean", "m/s",
                         wf_gust_mean(s, 0) + (strcmp(s->model->name, "sine-perlin-as-printed")
                                                   ? 0.0
                                                   : 0.5 * wf_gust_get(s, "epsilon")),
                         got->mean, wanted * share, 0.0);
        add_property(o, name[c], "m/s", wanted, got->deviation, 0.5 * variance_scatter(o, c) / got->deviation,
                     1e-9);
    }
}

/* Compare the spectrum of the series with the target in bands, at the first point. The scatter of a single
 * series is removed: a series of the same seed with a flat spectrum has the same noise, and its spectrum is
 * divided out. */
static enum wf_status check_synthesis(struct wf_gust_report *o, struct wf_arena *a, struct wf_err *e)
{
    struct wf_gust_spec s = o->spec, flat;
    struct wf_diag quiet = { .arena = a };
    struct wf_gust g;
    size_t length = transform_length(s.steps);
    double *x = WF_TAKE(a, s.steps, double), *density[2], worst = 1.0;
    if (!s.model->spectrum) return WF_OK;
    s.points = s.components = 1;
    wf_gust_spec_default(wf_gust_named("one-over-f"), &flat);
    flat.step = s.step, flat.steps = s.steps, flat.seed = s.seed;
    enum wf_status status = wf_gust_set(&flat, "slope", 0.0, e);
    if (!status && wf_gust_get(&flat, "low") >= 0.5 / s.step)
        status = wf_gust_set(&flat, "low", 0.1 / s.step, e);
    for (int i = 0; i < 2 && !status; i++) {
        density[i] = WF_TAKE(a, length / 2 + 1, double);
        status = wf_gust_open(i ? &flat : &s, a, &quiet, &g, e);
        if (status) break;
        double *block = WF_TAKE(a, g.block, double);
        status = x && block && density[i] ? wf_gust_history(&g, 0, 0, block, x, e)
                                          : wf_fail(e, WF_ENOMEM, "not enough memory for a check");
        wf_gust_close(&g);
        if (!status) status = wf_spectrum_welch(x, length, s.step, length, density[i], NULL, a, e);
    }
    if (status) return status;
    double level = wf_gust_target(&flat, 0, WF_ALONG, 0.5 / s.step);
    for (size_t b = 0; b < o->bands; b++) {
        double want = 0.0, made = 0.0;
        if (o->band[b].last - o->band[b].first < 4) continue;
        for (size_t k = o->band[b].first; k < o->band[b].last; k++) {
            want += wf_gust_target(&s, 0, WF_ALONG, (double)k / ((double)length * s.step)) * density[1][k] /
                    level;
            made += density[0][k];
        }
        if (fabs(made / want - 1.0) > fabs(worst - 1.0)) worst = made / want;
    }
    add_property(o, "spectrum, worst band, noise taken out", "-", 1.0, worst, NAN, 0.05);
    return WF_OK;
}

static void check_spectrum(struct wf_gust_report *o)
{
    const struct wf_gust_spec *s = &o->spec;
    double square = 0.0, count = 0.0, low = NAN, high = NAN, slope = NAN;
    for (size_t b = 0; b < o->bands && s->model->spectrum; b++) {
        double off = (o->density[0][b] / o->target[0][b] - 1.0) / o->scatter[b];
        if (o->band[b].last - o->band[b].first < 4) continue;
        square += off * off, count += 1.0;
    }
    if (count > 4.0)
        add_property(o, "spectrum, rms of bands / scatter", "-", 1.0, sqrt(square / count), sqrt(0.5 / count),
                     0.05);
    if (strcmp(s->model->name, "one-over-f") == 0)
        slope = -wf_gust_get(s, "slope"), low = wf_gust_get(s, "low"), high = 0.5 / s->step;
    if (strcmp(s->model->name, "perlin") == 0) {
        double l = wf_gust_get(s, "lacunarity");
        slope = -1.0 + 2.0 * log(wf_gust_get(s, "persistence")) / log(l);
        low = 1.0 / wf_gust_get(s, "period");
        high = 0.5 * fmin(low * pow(l, wf_gust_get(s, "octaves") - 1.0), 1.0 / s->step);
    }
    if (isnan(slope) || !(high > 4.0 * low)) return;
    low *= 1.0 + WIDE, high /= 1.0 + WIDE;
    double n = 0, x1 = 0, y1 = 0, xx = 0, xy = 0, weight, noise = 0;
    for (size_t b = 0; b < o->bands; b++) {
        if (o->band[b].low < low || o->band[b].high > high || !(o->density[0][b] > 0.0)) continue;
        double x = log(o->band[b].centre), y = log(o->density[0][b]);
        weight = 1.0 / (o->scatter[b] * o->scatter[b]);
        n += weight, x1 += weight * x, y1 += weight * y, xx += weight * x * x, xy += weight * x * y;
        noise += 1.0;
    }
    double spread = xx - x1 * x1 / n;
    if (noise > 3.0)
        add_property(o, "slope of the spectrum", "-", slope, (xy - x1 * y1 / n) / spread, 1.0 / sqrt(spread),
                     0.1);
}

enum {
    STEPS_MIN = 32
}; /* half a minute at 1 Hz; below it the lowest bands of the spectrum hold one line each */

enum wf_status wf_gust_report_make(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_gust_report *o, struct wf_err *e)
{
    memset(o, 0, sizeof *o);
    o->spec = *s;
    enum wf_status status = run_model(s, a, d, o, e);
    if (!status && s->steps < STEPS_MIN)
        status =
            wf_fail(e, WF_EUSAGE, "%zu steps: at least %d are needed to look at", s->steps, (int)STEPS_MIN);
    for (unsigned c = 0; c < s->components && !status; c++)
        status =
            wf_gust_stats(o->x + c * s->points * s->steps, s->steps, s->step, 3.0, 600.0, a, &o->stats[c], e);
    if (!status) status = measure_spectra(o, a, e);
    if (!status) status = measure_pairs(o, a, e);
    if (status) return status;
    o->bin_low = o->stats[0].low;
    o->bin_width = fmax((o->stats[0].high - o->stats[0].low) / WF_REPORT_BINS, 1e-9);
    count_bins(o->x, s->steps, o->bin_low, o->bin_low + o->bin_width * WF_REPORT_BINS, WF_REPORT_BINS,
               o->bin);
    check_moments(o);
    status = check_synthesis(o, a, e);
    if (!status) check_spectrum(o);
    return status;
}
