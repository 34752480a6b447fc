/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/wind.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include "wind/wind_kernel.h"
#include <math.h>
#include <string.h>

/* Properties of dry air. */

double wf_air_density(double temperature, double altitude)
{
    const double gas = 287.05287, p0 = 101325, t0 = 288.15, lapse = 0.0065, gravity = 9.80665;
    if (!(temperature > 0 && altitude <= 11000)) return NAN;
    return p0 * pow(1 - lapse * altitude / t0, gravity / (gas * lapse)) / (gas * temperature);
}

double wf_air_viscosity(double temperature, double density)
{
    if (!(temperature > 0 && density > 0)) return NAN;
    return 1.458e-6 * temperature * sqrt(temperature) / (temperature + 110.4) / density;
}

/* The canopy profile, the mean wind in and above a stand: exponential below the canopy top, logarithmic
 * above. Sources: Inoue E. 1963, On the turbulent structure of airflow within crop canopies, J. Meteorol.
 * Soc. Jpn 41:317-326; Cionco R.M. 1965, A mathematical model for air flow in a vegetative canopy, J. Appl.
 * Meteorol. 4:517-522; Thom A.S. 1971 for the log law above. */

void wf_canopy_shape(const struct wf_wind *w, double *top, double *attenuation)
{
    double d = w->displacement, h = w->canopy_height > 0.0 ? w->canopy_height : d / 0.7;
    *top = h;
    *attenuation = w->attenuation > 0.0 ? w->attenuation : h / ((h - d) * log((h - d) / w->roughness));
}

/* Speed over friction speed times kappa, and its slope, at height z above the ground. */
static double canopy_ratio(const struct wf_wind *w, double z, double *slope)
{
    double d = w->displacement, z0 = w->roughness, h, a;
    wf_canopy_shape(w, &h, &a);
    if (z > h) {
        if (z - d <= z0) return *slope = 0.0; /* the calm layer; only without a stand */
        *slope = 1.0 / (z - d);
        return log((z - d) / z0);
    }
    /* below the ground: the speed at the ground, without gradient */
    double inside = log((h - d) / z0) * exp(-a * (1.0 - fmax(z, 0.0) / h));
    *slope = z >= 0.0 ? inside * a / h : 0.0;
    return inside;
}

void wf_canopy_sample(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double unused, slope, scale = w->speed / canopy_ratio(w, w->reference_height, &unused),
                          here = scale * canopy_ratio(w, x[2], &slope);
    for (int i = 0; i < 3; i++) {
        u[i] = here * w->direction[i];
        du[3 * i] = du[3 * i + 1] = 0.0;
        du[3 * i + 2] = scale * slope * w->direction[i];
    }
}

/* Profiles given by a formula. The direction is the same everywhere; the speed depends on height only. */

/* Velocity and gradient from speed and d speed / dz at a height. */
static void blow_along(const struct wf_wind *w, double speed, double slope, double u[3], double du[9])
{
    for (int i = 0; i < 3; i++) {
        u[i] = speed * w->direction[i];
        du[3 * i] = du[3 * i + 1] = 0;
        du[3 * i + 2] = slope * w->direction[i];
    }
}

static void uniform(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    (void)x;
    blow_along(w, w->speed, 0, u, du);
}

static void logarithmic(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double slope, scale = log_profile_scale(w->speed, w->reference_height, w->displacement, w->roughness);
    double speed = log_profile(scale, w->displacement, w->roughness, x[2], &slope);
    blow_along(w, speed, slope, u, du);
}

static void power(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double slope, speed = power_profile(w->speed, w->reference_height, w->exponent, x[2], &slope);
    blow_along(w, speed, slope, u, du);
}

static void terrain(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double slope, scale = log_profile_scale(w->speed, fmax(w->reference_height, w->least), 0.0, w->roughness);
    double speed = terrain_profile(scale, w->roughness, w->least, x[2], &slope);
    blow_along(w, speed, slope, u, du);
}

static void code(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double slope, reference = fmax(w->reference_height, w->least);
    double speed = floor_profile(w->speed, reference, w->exponent, w->least, x[2], &slope);
    blow_along(w, speed, slope, u, du);
}

/* A measured profile. */

enum { HEIGHTS_MAX = 1000 };

enum wf_status wf_measured_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                struct wf_measured_profile *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    size_t errors = d->errors;
    *out = (struct wf_measured_profile){ .z = WF_TAKE(a, HEIGHTS_MAX + 1, double),
                                         .u = WF_TAKE(a, HEIGHTS_MAX + 1, double),
                                         .slope = WF_TAKE(a, HEIGHTS_MAX + 1, double) };
    if (!out->z || !out->u || !out->slope)
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a profile", path);
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    struct wf_units *units;
    double metres, speeds;
    if (wf_units_open(&units, e)) return e ? e->code : WF_EMISSING;
    size_t height = wf_column_need(&csv, units, "height_m", WF_DIM_LENGTH, &metres, e);
    size_t speed = wf_column_need(&csv, units, "speed_ms", WF_DIM_SPEED, &speeds, e);
    wf_units_close(units);
    if (e && e->code) return e->code;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a wind profile", path);
    out->n = 1; /* the ground */
    while (wf_csv_next(&csv)) {
        double z, u;
        if (!wf_column_number(&csv, height, metres, 0.0, 1000.0, &z) ||
            !wf_column_number(&csv, speed, speeds, 0.0, 120.0, &u))
            continue;
        if (out->n > HEIGHTS_MAX) return wf_fail(e, WF_EINPUT, "%s: more than %d heights", path, HEIGHTS_MAX);
        if (!(z > out->z[out->n - 1]))
            wf_csv_mistake(&csv, height, "%g m is not above %g m, the height before", z, out->z[out->n - 1]);
        out->z[out->n] = z;
        out->u[out->n++] = u;
    }
    if (d->errors == errors && out->n < 3)
        wf_diag_error(d, path, 0, 0, "a profile needs at least two heights above the ground, %zu given",
                      out->n - 1);
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the profile cannot be used", path);
    wf_curve_slopes(out->n, out->z, out->u, out->slope);
    return WF_OK;
}

/* Speed and slope of a measured profile at height z. */
static void measured_at(const struct wf_measured_profile *p, double z, double *u, double *slope)
{
    size_t low = 0, high = p->n - 1;
    *u = z > 0.0 ? p->u[high] : 0.0;
    *slope = 0.0;
    if (!(z > 0.0 && z < p->z[high])) return;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        *(p->z[middle] > z ? &high : &low) = middle;
    }
    double width = p->z[high] - p->z[low], s = p->slope[low], t = z - p->z[low];
    double line = (p->u[high] - p->u[low]) / width;
    double square = (3.0 * line - 2.0 * s - p->slope[high]) / width,
           cube = (s + p->slope[high] - 2.0 * line) / (width * width);
    *u = p->u[low] + t * (s + t * (square + t * cube));
    *slope = s + t * (2.0 * square + 3.0 * t * cube);
}

void wf_measured_sample(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    const struct wf_measured_profile *p = w->field;
    double reference, unused, here, slope;
    measured_at(p, w->reference_height, &reference, &unused);
    measured_at(p, x[2], &here, &slope);
    for (int i = 0; i < 3; i++) {
        u[i] = w->speed * here / reference * w->direction[i];
        du[3 * i] = du[3 * i + 1] = 0.0;
        du[3 * i + 2] = w->speed * slope / reference * w->direction[i];
    }
}

enum wf_status wf_measured_blow(const struct wf_measured_profile *p, struct wf_wind *w, struct wf_err *e)
{
    double reference, slope;
    measured_at(p, w->reference_height, &reference, &slope);
    if (!(reference > 0.0))
        return wf_fail(e, WF_EINPUT, "the measured profile has speed 0 at the reference height of %g m",
                       w->reference_height);
    w->sample = wf_measured_sample;
    w->field = p;
    return WF_OK;
}

/* The profiles as rows. */

const struct wf_profile wf_profiles[] = {
    { "uniform", "the same speed at every height", "wind tunnels, comparisons; not the wind over ground",
      uniform, "", WF_PROFILE_UNIFORM },
    { "log",
      "Tennekes H. 1973. The logarithmic wind profile. J. Atmos. Sci. 30:234-238; zero-plane displacement: "
      "Thom A.S. "
      "1971. Momentum absorption by vegetation. Q. J. R. Meteorol. Soc. 97:414-428",
      "neutral or strong wind over level ground, from about d + 20 z0 up to 100 m; calm below d + z0",
      logarithmic, "roughness displacement", WF_PROFILE_LOG },
    { "power",
      "Davenport A.G. 1960. Rationale for determining design wind velocities. J. Struct. Div. ASCE "
      "86(5):39-68",
      "strong wind over level ground, 1 m to 300 m; exponent 0.10 (water) to 0.40 (town), 0.16 open country",
      power, "exponent", WF_PROFILE_POWER },
    { "terrain",
      "EN 1991-1-4:2005 + A1:2010, 4.3.2: the log law of the terrain category, constant below z_min",
      "strong wind over flat ground of one roughness for some kilometres upwind, up to 200 m; the wind "
      "between the "
      "trees of a stand is lower",
      terrain, "", WF_PROFILE_TERRAIN },
    { "code", "the power law of the design code, constant below its lowest height (--design)",
      "as the terrain of the code", code, "", WF_PROFILE_FLOOR },
    { "canopy",
      "Cionco R.M. 1965. A mathematical model for air flow in a vegetative canopy. J. Appl. Meteorol. "
      "4:517-522; above: "
      "Thom A.S. 1971. Q. J. R. Meteorol. Soc. 97:414-428",
      "closed level stands of even height, neutral or strong wind; attenuation 0.3 (open) to 4 (dense); not "
      "the "
      "second maximum among bare trunks below about 0.3 of the height",
      wf_canopy_sample, "roughness displacement canopy_height attenuation", WF_PROFILE_BY_CALL },
    { "measured",
      "the heights and speeds of the file named; between them a monotone cubic: Steffen M. 1990. Astron. "
      "Astrophys. "
      "239:443-450",
      "between the lowest and the highest height measured; below them the speed falls to 0 at the ground, "
      "above them it is constant",
      wf_measured_sample, "", WF_PROFILE_BY_CALL },
    { 0 }
};

const char *const wf_profile_names[] = { "uniform", "log",    "power",    "terrain",
                                         "code",    "canopy", "measured", NULL };

double wf_wind_from(double azimuth, double north)
{
    double from = fmod(-0.5 * WF_PI - azimuth - north, WF_TURN);
    if (from < 0.0) from += WF_TURN;
    return WF_TURN - from < 1e-9 ? 0.0 : from;
}

double wf_wind_azimuth(double from, double north) { return -0.5 * WF_PI - (from + north); }

enum wf_profile_form wf_wind_form(const struct wf_wind *w)
{
    for (const struct wf_profile *p = wf_profiles; p->name; p++)
        if (p->sample == w->sample) return p->form;
    return WF_PROFILE_OTHER;
}

const struct wf_profile *wf_profile_named(const char *name)
{
    for (const struct wf_profile *p = wf_profiles; name && p->name; p++)
        if (strcmp(p->name, name) == 0) return p;
    return NULL;
}

enum wf_status wf_wind_check(const struct wf_wind *w, struct wf_err *e)
{
    const double *n = w->direction, size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(w->speed >= 0 && isfinite(w->speed)))
        return wf_fail(e, WF_EINPUT, "wind speed %g m/s: must be finite and not negative", w->speed);
    if (!(fabs(size - 1) <= 1e-9))
        return wf_fail(e, WF_EINPUT, "wind direction of length %.12g: must be a unit vector", size);
    if (w->sample == logarithmic) {
        if (!(w->roughness > 0))
            return wf_fail(e, WF_EINPUT, "roughness length %g m: must be positive", w->roughness);
        if (!(w->displacement >= 0))
            return wf_fail(e, WF_EINPUT, "zero-plane displacement %g m: must not be negative",
                           w->displacement);
        if (!(w->reference_height > w->displacement + w->roughness))
            return wf_fail(
                e, WF_EINPUT,
                "reference height %g m lies within the calm layer of the log profile: must be above "
                "displacement + roughness = %g m",
                w->reference_height, w->displacement + w->roughness);
    }
    if (w->sample == terrain && !(w->roughness > 0 && fmax(w->least, w->reference_height) > w->roughness))
        return wf_fail(e, WF_EINPUT, "terrain of roughness length %g m: must be positive and below %g m",
                       w->roughness, fmax(w->least, w->reference_height));
    if (w->sample == wf_canopy_sample) {
        double h = w->canopy_height > 0 ? w->canopy_height : w->displacement / 0.7;
        if (!(w->roughness > 0 && w->displacement >= 0 && (h == 0 || h > w->displacement + w->roughness)))
            return wf_fail(
                e, WF_EINPUT,
                "canopy of %g m with displacement %g m and roughness length %g m: the roughness must be "
                "positive and displacement + roughness lie below the canopy top",
                h, w->displacement, w->roughness);
        if (!(w->attenuation >= 0 && w->attenuation <= 10 && w->reference_height > 0))
            return wf_fail(e, WF_EINPUT, "canopy attenuation %g, reference height %g m: 0..10, above 0 m",
                           w->attenuation, w->reference_height);
    }
    if (w->sample == wf_measured_sample && !w->field)
        return wf_fail(e, WF_EINPUT, "the measured profile needs a file of heights and speeds");
    if (w->sample == power || w->sample == code) {
        if (!(w->reference_height > 0))
            return wf_fail(e, WF_EINPUT, "reference height %g m: must be positive", w->reference_height);
        if (!(w->exponent >= 0 && w->exponent <= 1))
            return wf_fail(e, WF_EINPUT, "power-law exponent %g: must be within 0..1", w->exponent);
    }
    return WF_OK;
}

/* Points. */

enum wf_status wf_points_read(const char *path, size_t most, struct wf_arena *a, struct wf_diag *d,
                              struct wf_points *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    size_t errors = d->errors, n = 0;
    *out = (struct wf_points){ .place = WF_TAKE(a, 3 * most, double), .mean = WF_TAKE(a, most, double) };
    if (!out->place || !out->mean) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for points", path);
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    static const char *const name[3] = { "x_m", "y_m", "z_m" };
    size_t column[3], mean = wf_csv_column(&csv, "mean_ms");
    struct wf_units *units;
    double metres[3];
    if (wf_units_open(&units, e)) return e ? e->code : WF_EMISSING;
    for (size_t k = 0; k < 3; k++)
        column[k] = wf_column_need(&csv, units, name[k], WF_DIM_LENGTH, &metres[k], e);
    wf_units_close(units);
    if (e && e->code) return e->code;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a list of points", path);
    for (; wf_csv_next(&csv); n++) {
        if (n == most) return wf_fail(e, WF_EINPUT, "%s: more than %zu points", path, most);
        for (size_t k = 0; k < 3; k++)
            wf_column_number(&csv, column[k], metres[k], k == 2 ? 0.0 : -1e5, k == 2 ? 1000.0 : 1e5,
                             &out->place[3 * n + k]);
        if (mean != WF_CSV_NONE) wf_csv_number(&csv, mean, 0.01, 120.0, &out->mean[n]);
    }
    if (d->errors == errors && !n) wf_diag_error(d, path, 0, 0, "no points");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the points cannot be used", path);
    out->n = n;
    if (mean == WF_CSV_NONE) out->mean = NULL;
    return WF_OK;
}
