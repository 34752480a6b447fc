/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/rain.h"
#include "base/num.h"
#include "base/random.h"
#include "load/drop_shape.h"
#include <math.h>
#include <string.h>

/* ---- Speed of fall ---- */

static double atlas(double d) { return fmax(0, 9.65 - 10.3 * exp(-600 * d)); }

static double brandes(double d)
{
    double x = 1000 * d;
    return fmax(0, -0.1021 + x * (4.932 + x * (-0.9551 + x * (0.07934 - 0.002362 * x))));
}

static double van_dijk(double d)
{
    double x = 1000 * d;
    return fmax(0, -0.254 + x * (5.03 + x * (-0.912 + 0.0561 * x)));
}

static double uplinger(double d) { return 4874 * d * exp(-195 * d); }

static double lhermitte(double d)
{
    double x = 1000 * d;
    return 9.25 * (1 - exp(-(0.068 * x + 0.488) * x));
}

const struct wf_fall_law wf_fall_laws[] = {
    { "atlas", "Atlas et al. 1973: 9.65 - 10.3 exp(-0.6 D)", 0.11e-3, 8e-3, atlas },
    { "brandes", "Brandes et al. 2002: -0.1021 + 4.932 D - 0.9551 D^2 + 0.07934 D^3 - 0.002362 D^4", 0.1e-3,
      8e-3, brandes },
    { "van-dijk", "van Dijk et al. 2002: -0.254 + 5.03 D - 0.912 D^2 + 0.0561 D^3", 0.1e-3, 7e-3, van_dijk },
    { "uplinger", "Uplinger 1981: 4.874 D exp(-0.195 D)", 0.1e-3, 7e-3, uplinger },
    { "lhermitte", "Lhermitte 1988: 9.25 (1 - exp(-(0.068 D^2 + 0.488 D)))", 0.1e-3, 8e-3, lhermitte },
    { 0 },
};

const struct wf_fall_law *wf_fall_law_named(const char *name)
{
    for (const struct wf_fall_law *l = wf_fall_laws; l->name; l++)
        if (!strcmp(l->name, name)) return l;
    return NULL;
}

/* ---- Sizes ---- */

static double slope_of(double intensity) { return 4.1e3 * pow(intensity * 3.6e6, -0.21); } /* [1/m] */

/* Drops per m3 and m of diameter. */
static double number_of(double slope, double d) { return 8e6 * exp(-slope * d); }

void wf_marshall_palmer(double intensity, double low, double high, const struct wf_fall_law *law,
                        struct wf_spectrum_sums *out)
{
    enum { PARTS = 4000 }; /* midpoint rule; its error is far below a millionth */
    double slope = slope_of(intensity), step = (high - low) / PARTS;
    *out = (struct wf_spectrum_sums){ 0 };
    for (int i = 0; i < PARTS; i++) {
        double d = low + (i + 0.5) * step, n = number_of(slope, d) * step, v = law->speed(d);
        double volume = WF_PI / 6 * d * d * d;
        out->flux += n * v * volume;
        out->content += n * volume * WF_WATER_DENSITY;
        out->number += n * v;
    }
}

/* Share of the arriving drops below each of the evenly spaced diameters. */
static void divide(struct wf_rain *r, double total)
{
    enum { PARTS = 16 }; /* of a class */
    double slope = slope_of(r->intensity), step = (r->largest - r->least) / (WF_RAIN_CLASSES * PARTS);
    for (int k = 0; k < WF_RAIN_CLASSES; k++) {
        r->below[k + 1] = r->below[k];
        for (int i = 0; i < PARTS; i++) {
            double d = r->least + (k * PARTS + i + 0.5) * step;
            r->below[k + 1] += number_of(slope, d) * r->law->speed(d) * step / total;
        }
    }
}

/* The diameter below which a share of the arriving drops is. */
static double diameter_of(const struct wf_rain *r, double share)
{
    size_t low = 0, high = WF_RAIN_CLASSES;
    share *= r->below[WF_RAIN_CLASSES];
    while (high - low > 1) {
        size_t mid = (low + high) / 2;
        if (r->below[mid] <= share)
            low = mid;
        else
            high = mid;
    }
    double part = (share - r->below[low]) / (r->below[high] - r->below[low]);
    return wf_between(r->least, r->largest, ((double)low + part) / WF_RAIN_CLASSES);
}

static enum wf_status check(const struct wf_rain *r, struct wf_err *e)
{
    if (!(r->intensity >= 0) || r->intensity > 1e-3)
        return wf_fail(e, WF_EUSAGE, "an intensity of rain is 0 to 3600 mm/h, not %g mm/h",
                       r->intensity * 3.6e6);
    double most = r->intensity > 0 ? r->largest : r->diameter;
    if (most > WF_DROP_LARGEST)
        return wf_fail(e, WF_EUSAGE, "drops of %g mm break up in air; at most %g mm", most * 1e3,
                       WF_DROP_LARGEST * 1e3);
    if (!(most > 0) || (r->intensity > 0 && !(r->least >= 0 && r->least < r->largest)))
        return wf_fail(e, WF_EUSAGE, "drops need a diameter above 0, and the smallest one below the largest");
    if (!(r->rate >= 0) || !(r->jitter >= 0) || !(r->width >= 0) || !(r->slot > 0))
        return wf_fail(e, WF_EUSAGE, "number, variation and duration of the rain are 0 or more");
    if (!(r->high[0] > r->low[0]) || !(r->high[1] > r->low[1]))
        return wf_fail(e, WF_EUSAGE, "the rain falls on no area");
    return WF_OK;
}

enum wf_status wf_rain_make(struct wf_rain *r, struct wf_err *e)
{
    enum wf_status s = check(r, e);
    r->scale = 1, r->below[0] = 0;
    if (s || !(r->intensity > 0)) return s;
    struct wf_spectrum_sums sums;
    wf_marshall_palmer(r->intensity, r->least, r->largest, r->law, &sums);
    r->scale = r->intensity / sums.flux;
    r->rate = r->scale * sums.number * (r->high[0] - r->low[0]) * (r->high[1] - r->low[1]);
    divide(r, sums.number);
    return WF_OK;
}

/* ---- Number ---- */

/* Streams of random numbers. */
enum { PURPOSE_NUMBER = 71, PURPOSE_DROP = 72, PURPOSE_VARY = 73 };

double wf_rain_rate(const struct wf_rain *r, double time)
{
    double u = r->width > 0 ? (time - r->middle) / r->width : 0;
    return r->rate * exp(-0.5 * u * u);
}

double wf_rain_rate_varied(const struct wf_rain *r, double time)
{
    if (!(r->jitter > 0)) return wf_rain_rate(r, time);
    uint64_t slot = (uint64_t)fmax(0, floor(time / r->slot));
    double vary = wf_random_normal(r->seed, wf_random_stream(PURPOSE_VARY, 0, 0), slot);
    return wf_rain_rate(r, time) * fmax(0, 1 + r->jitter * vary);
}

size_t wf_rain_count(const struct wf_rain *r, uint64_t step, double time, double dt)
{
    double mean = wf_rain_rate_varied(r, time) * dt;
    uint64_t stream = wf_random_stream(PURPOSE_NUMBER, step & 0xfffffff, step >> 28);
    if (mean > 50) /* a normal number: the Poisson's is within 1 % of it */
        return (size_t)fmax(0, floor(mean + sqrt(mean) * wf_random_normal(r->seed, stream, 0) + 0.5));
    double left = exp(-mean), product = 1;
    size_t n = 0;
    while ((product *= wf_random_uniform(r->seed, stream, n)) > left && n < 1000) n++;
    return n;
}

void wf_rain_drop(const struct wf_rain *r, uint64_t step, size_t k, struct wf_raindrop *out)
{
    uint64_t stream = wf_random_stream(PURPOSE_DROP, step & 0xfffffff, step >> 28), at = 4 * (uint64_t)k;
    out->diameter = r->intensity > 0 ? diameter_of(r, wf_random_uniform(r->seed, stream, at)) : r->diameter;
    out->x = wf_between(r->low[0], r->high[0], wf_random_uniform(r->seed, stream, at + 1));
    out->y = wf_between(r->low[1], r->high[1], wf_random_uniform(r->seed, stream, at + 2));
    out->when = wf_random_uniform(r->seed, stream, at + 3);
}
