#include "wind/gust_stats.h"
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

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
    gsl_fft_real_wavetable *forward = gsl_fft_real_wavetable_alloc(length);
    gsl_fft_halfcomplex_wavetable *back = gsl_fft_halfcomplex_wavetable_alloc(length);
    gsl_fft_real_workspace *space = gsl_fft_real_workspace_alloc(length);
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
    return room ? WF_OK : wf_fail(e, WF_ENOMEM, "no room for the autocorrelation of %zu steps", n);
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

void wf_histogram(const double *x, size_t n, double low, double high, size_t bins, size_t *count)
{
    memset(count, 0, bins * sizeof *count);
    for (size_t i = 0; i < n; i++) {
        double place = (x[i] - low) / (high - low) * (double)bins;
        size_t at = place > 0.0 ? (size_t)place : 0;
        count[at < bins ? at : bins - 1]++;
    }
}
