/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/extreme.h"
#include "base/num.h"
#include "base/random.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double euler = 0.57721566490153286;

const struct wf_extreme_row wf_extreme_rows[WF_EXTREME_METHODS] = {
    [WF_MOMENTS] = { "moments", "Gumbel, moments of so many years",
                     "Gumbel E.J. 1958, Statistics of Extremes; GB 50009-2012, annex E", false },
    [WF_LIKELIHOOD] = { "likelihood", "Gumbel, maximum likelihood",
                        "Gumbel E.J. 1958, Statistics of Extremes", false },
    [WF_L_MOMENTS] = { "l-moments", "Gumbel, L-moments", "Hosking J.R.M. 1990, J. R. Stat. Soc. B 52:105-124",
                       false },
    [WF_GEV] = { "gev", "generalised extreme value, L-moments",
                 "Hosking J.R.M., Wallis J.R., Wood E.F. 1985, Technometrics 27:251-261", true },
};

/* ---- Fits of ascending x ---- */

static double mean_of(const double *x, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += x[i];
    return sum / (double)n;
}

static void fit_moments(const double *x, size_t n, struct wf_extreme *out)
{
    double mean = mean_of(x, n), s = 0, c1 = 0, c2 = 0;
    for (size_t i = 0; i < n; i++) s += (x[i] - mean) * (x[i] - mean);
    for (size_t i = 1; i <= n; i++) c2 += -log(-log((double)i / (double)(n + 1))) / (double)n;
    for (size_t i = 1; i <= n; i++) {
        double y = -log(-log((double)i / (double)(n + 1))) - c2;
        c1 += y * y / (double)n;
    }
    out->scale = sqrt(s / (double)(n - 1)) / sqrt(c1);
    out->mode = mean - c2 * out->scale;
}

/* The first three L-moments. */
static void l_moments(const double *x, size_t n, double l[3])
{
    double b[3] = { 0 }, m = (double)n;
    for (size_t i = 0; i < n; i++) {
        double k = (double)i;
        b[0] += x[i] / m;
        b[1] += x[i] * k / (m * (m - 1));
        b[2] += x[i] * k * (k - 1) / (m * (m - 1) * (m - 2));
    }
    l[0] = b[0], l[1] = 2 * b[1] - b[0], l[2] = 6 * b[2] - 6 * b[1] + b[0];
}

static void fit_l_moments(const double *x, size_t n, struct wf_extreme *out)
{
    double l[3];
    l_moments(x, n, l);
    out->scale = l[1] / log(2);
    out->mode = l[0] - euler * out->scale;
}

/* Newton's method for scale - mean + sum(x e^(-x/scale)) / sum(e^(-x/scale)) = 0, which increases with the
 * scale; weights are relative to the least x. */
static void fit_likelihood(const double *x, size_t n, struct wf_extreme *out)
{
    double mean = mean_of(x, n), weights = 0;
    fit_l_moments(x, n, out);
    for (int pass = 0; pass < 100; pass++) {
        double w0 = 0, w1 = 0, w2 = 0, s = out->scale;
        for (size_t i = 0; i < n; i++) {
            double y = x[i] - x[0], w = exp(-y / s);
            w0 += w, w1 += w * y, w2 += w * y * y;
        }
        double first = w1 / w0, value = s - (mean - x[0]) + first;
        double slope = 1 + (w2 / w0 - first * first) / (s * s), next = s - value / slope;
        weights = w0;
        out->scale = next > 0.2 * s ? next : 0.2 * s;
        if (fabs(out->scale - s) <= 1e-13 * s) break;
    }
    out->mode = x[0] - out->scale * log(weights / (double)n);
}

/* Shape by the L-skewness: the rational approximation of the source is the start; Newton's method then solves
 * 2 (1 - 3^-k) / (1 - 2^-k) - 3 = skewness. */
static double shape_of(double skewness)
{
    double c = 2 / (3 + skewness) - log(2) / log(3), k = 7.8590 * c + 2.9554 * c * c;
    for (int pass = 0; pass < 20; pass++) {
        double h = 1e-6;
        double at[2];
        for (int i = 0; i < 2; i++) {
            double q = k + (i ? h : -h);
            at[i] = 2 * (1 - pow(3, -q)) / (1 - pow(2, -q)) - 3 - skewness;
        }
        double step = (at[0] + at[1]) / 2 / ((at[1] - at[0]) / (2 * h));
        k -= step;
        if (fabs(step) < 1e-9) break;
    }
    return k;
}

static void fit_gev(const double *x, size_t n, struct wf_extreme *out)
{
    double l[3];
    l_moments(x, n, l);
    double k = shape_of(l[2] / l[1]), gamma = tgamma(1 + k);
    out->shape = k;
    out->scale = l[1] * k / ((1 - pow(2, -k)) * gamma);
    out->mode = l[0] - out->scale * (1 - gamma) / k;
}

static void (*const fits[WF_EXTREME_METHODS])(const double *x, size_t n,
                                              struct wf_extreme *out) = { [WF_MOMENTS] = fit_moments,
                                                                          [WF_LIKELIHOOD] = fit_likelihood,
                                                                          [WF_L_MOMENTS] = fit_l_moments,
                                                                          [WF_GEV] = fit_gev };

static bool fit_sorted(enum wf_extreme_method method, const double *x, size_t n, struct wf_extreme *out)
{
    bool squared = out->squared;
    *out = (struct wf_extreme){ .squared = squared };
    fits[method](x, n, out);
    return isfinite(out->mode) && isfinite(out->shape) && out->scale > 0 && isfinite(out->scale);
}

enum wf_status wf_extreme_fit(enum wf_extreme_method method, bool squared, const double *speed, size_t n,
                              struct wf_extreme *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    *out = (struct wf_extreme){ .squared = squared };
    if (n < WF_EXTREME_YEARS_MIN || n > WF_EXTREME_YEARS_MAX)
        return wf_fail(e, WF_EINPUT, "%zu annual maxima; %d to %d are needed", n, WF_EXTREME_YEARS_MIN,
                       WF_EXTREME_YEARS_MAX);
    double *x = WF_TAKE(&scratch, n, double);
    if (!x) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu years", n);
    enum wf_status s = WF_OK;
    for (size_t i = 0; i < n && !s; i++) {
        if (!(speed[i] > 0) || speed[i] > 200)
            s = wf_fail(e, WF_EINPUT,
                        "the largest wind of year %zu is %g m/s; it must be between 0 and 200 m/s", i + 1,
                        speed[i]);
        x[i] = squared ? speed[i] * speed[i] : speed[i];
    }
    if (!s) {
        qsort(x, n, sizeof *x, wf_ascending);
        if (!(x[n - 1] > x[0]) || !fit_sorted(method, x, n, out))
            s = wf_fail(e, WF_EINPUT, "the annual maxima are too much alike for a fit (%g to %g m/s)",
                        speed[0], speed[n - 1]);
    }
    wf_arena_free(&scratch);
    return s;
}

/* ---- From the distribution of all hours ---- */

enum wf_status wf_extreme_of_weibull(double scale, double shape, struct wf_extreme *out, struct wf_err *e)
{
    if (!(scale > 0.1 && scale < 40) || !(shape >= 1.2 && shape <= 3.5))
        return wf_fail(
            e, WF_EUSAGE,
            "Weibull scale %g m/s and shape %g: the scale must be between 0.1 and 40 m/s, the shape between "
            "1.2 and 3.5",
            scale, shape);
    double u = ((-0.5903 * shape + 4.4345) * shape - 11.8633) * shape + 13.569, mode = u * scale * u * scale;
    *out = (struct wf_extreme){ .mode = mode, .scale = mode / 5, .squared = true };
    return WF_OK;
}

double wf_extreme_dams_scale(double dams) { return -0.9626 + 0.4279 * dams; }

/* ---- What a distribution says ---- */

/* -ln F at a speed. */
static double hazard(const struct wf_extreme *x, double speed)
{
    double y = ((x->squared ? speed * speed : speed) - x->mode) / x->scale;
    if (x->shape == 0) return exp(-y);
    double base = 1 - x->shape * y;
    if (base <= 0) return x->shape > 0 ? 0 : INFINITY;
    return pow(base, 1 / x->shape);
}

double wf_extreme_exceedance(const struct wf_extreme *x, double speed) { return -expm1(-hazard(x, speed)); }

double wf_extreme_over_years(double a_year, double years) { return -expm1(years * log1p(-a_year)); }

double wf_extreme_return_period(const struct wf_extreme *x, double speed)
{
    return 1 / wf_extreme_exceedance(x, speed);
}

/* x at which -ln F is h. */
static double quantile(const struct wf_extreme *x, double h)
{
    double y = x->shape == 0 ? -log(h) : -expm1(x->shape * log(h)) / x->shape;
    return x->mode + x->scale * y;
}

static double speed_of(const struct wf_extreme *x, double value)
{
    return x->squared ? sqrt(fmax(0, value)) : fmax(0, value);
}

/* -ln F of the value that is exceeded once in so many years. */
static double rarity(double years) { return -log1p(-1 / years); }

double wf_extreme_speed(const struct wf_extreme *x, double years)
{
    return speed_of(x, quantile(x, rarity(years)));
}

/* ---- Bootstrap ---- */

static bool one_set(const struct wf_extreme *x, enum wf_extreme_method method, size_t n, uint64_t seed,
                    uint64_t stream, double *v, struct wf_extreme *out)
{
    for (size_t i = 0; i < n; i++) v[i] = quantile(x, -log(wf_random_uniform(seed, stream, i)));
    qsort(v, n, sizeof *v, wf_ascending);
    out->squared = x->squared;
    return v[n - 1] > v[0] && fit_sorted(method, v, n, out);
}

static void take_points(double *value, size_t sets, double share, double *low, double *high)
{
    double edge = 0.5 * (1 - share) * (double)(sets - 1);
    size_t i = (size_t)edge;
    double part = edge - (double)i;
    qsort(value, sets, sizeof *value, wf_ascending);
    *low = value[i] + part * (value[i + 1] - value[i]);
    *high = value[sets - 1 - i] + part * (value[sets - 2 - i] - value[sets - 1 - i]);
}

/* Gumbel's distribution with the first two L-moments of another one. */
static struct wf_extreme gumbel_of(const struct wf_extreme *x)
{
    struct wf_extreme out = { .mode = x->mode, .scale = x->scale, .squared = x->squared };
    double k = x->shape, gamma = tgamma(1 + k);
    if (k == 0) return out;
    double mean = x->mode + x->scale * (1 - gamma) / k;
    out.scale = x->scale * (1 - pow(2, -k)) * gamma / (k * log(2));
    out.mode = mean - euler * out.scale;
    return out;
}

/* Ends of the bands from what was drawn of each return period. */
static void read_band(const struct wf_extreme *x, bool shaped, const double *years, size_t count,
                      double share, size_t sets, double *value, double *low, double *high)
{
    const double outer = 1 - (1 - share) / 5; /* the upper end of a fitted shape lies further out */
    for (size_t i = 0; i < count; i++) {
        double below, above, middle = quantile(x, rarity(years[i]));
        take_points(value + i * sets, sets, share, &below, &above);
        if (shaped) {
            double beyond, unused;
            take_points(value + i * sets, sets, outer, &unused, &beyond);
            low[i] = speed_of(x, below), high[i] = fmax(high[i], speed_of(x, beyond));
        } else {
            low[i] = speed_of(x, middle - above * x->scale);
            high[i] = speed_of(x, middle - below * x->scale);
        }
    }
}

enum wf_status wf_extreme_band(const struct wf_extreme *x, enum wf_extreme_method method, size_t n,
                               const double *years, size_t count, double share, size_t sets, uint64_t seed,
                               double *low, double *high, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    const bool shaped = wf_extreme_rows[method].shaped;
    if (sets < 40 || sets > 100000 || n < WF_EXTREME_YEARS_MIN || n > WF_EXTREME_YEARS_MAX ||
        !(share > 0 && share < 1))
        return wf_fail(e, WF_EUSAGE, "a band by %zu sets of %zu years: 40 to 100000 sets of %d to %d years",
                       sets, n, WF_EXTREME_YEARS_MIN, WF_EXTREME_YEARS_MAX);
    double *v = WF_TAKE(&scratch, n, double), *value = WF_TAKE(&scratch, sets * count, double);
    enum wf_status s = v && value ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for %zu sets", sets);
    uint64_t draw = 0;
    if (!s && shaped) {
        const struct wf_extreme beside = gumbel_of(x);
        s = wf_extreme_band(&beside, WF_L_MOMENTS, n, years, count, share, sets, seed, low, high, e);
    }
    for (size_t k = 0; k < sets && !s; k++) {
        struct wf_extreme fit;
        while (!one_set(x, method, n, seed, wf_random_stream(23, 0, 0) + draw++, v, &fit)) {
        }
        for (size_t i = 0; i < count; i++) {
            double h = rarity(years[i]), drawn = quantile(&fit, h);
            value[i * sets + k] = shaped ? drawn : (drawn - quantile(x, h)) / fit.scale;
        }
    }
    if (!s) read_band(x, shaped, years, count, share, sets, value, low, high);
    wf_arena_free(&scratch);
    return s;
}

enum wf_status wf_extreme_levels_make(struct wf_extreme_levels *l, struct wf_arena *a, struct wf_err *e)
{
    l->speed = WF_TAKE(a, l->count, double);
    l->low = WF_TAKE(a, l->count, double);
    l->high = WF_TAKE(a, l->count, double);
    if (!l->speed || !l->low || !l->high)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the return periods");
    for (size_t i = 0; i < l->count; i++) {
        if (!(l->years[i] > 1))
            return wf_fail(e, WF_EUSAGE, "return period %g: it must be above 1 year", l->years[i]);
        l->speed[i] = wf_extreme_speed(&l->x, l->years[i]);
        l->low[i] = l->high[i] = NAN;
    }
    if (!l->n) return WF_OK;
    return wf_extreme_band(&l->x, l->method, l->n, l->years, l->count, 0.9, WF_EXTREME_SETS, WF_EXTREME_SEED,
                           l->low, l->high, e);
}
