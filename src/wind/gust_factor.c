/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/gust_factor.h"
#include "base/num.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

/* Size reduction of the resonance: mean of exp(-eta |s - t|) over the unit square. */
static double size_reduction(double eta)
{
    if (eta < 1e-3) return 1.0 - eta / 1.5 + eta * eta / 3.0; /* the formula cancels */
    return 1.0 / eta + expm1(-2.0 * eta) / (2.0 * eta * eta);
}

/* ---- EN 1991-1-4 ---- */

static double height_en(const struct wf_category *terrain, double height)
{
    return fmax(0.6 * height, terrain->least);
}

/* Annex B.2. The observation time is 600 s; the rate of upcrossings is at least 0.08 Hz. */
static void parts_en(const struct wf_gust_case *c, struct wf_gust_parts *out)
{
    const double time = 600.0, least_rate = 0.08, least_peak = 3.0;
    double zs = height_en(c->terrain, c->height), length = wf_category_length(c->terrain, zs);
    double decrement = WF_TURN * c->damping, f = c->frequency * length / c->mean;
    double spectrum = 6.8 * f / pow(1.0 + 10.2 * f, 5.0 / 3.0);
    double sizes =
        size_reduction(4.6 * c->height / length * f) * size_reduction(4.6 * c->breadth / length * f);
    double b2 = 1.0 / (1.0 + 0.9 * pow((c->breadth + c->height) / length, 0.63));
    if (c->small) b2 = sizes = 1.0;
    double r2 = WF_PI * WF_PI / (2.0 * decrement) * spectrum * sizes;
    double rate = fmax(least_rate, c->frequency * sqrt(r2 / (b2 + r2))), root = sqrt(2.0 * log(time * rate));
    double turbulence = wf_category_turbulence(c->terrain, zs), peak = fmax(least_peak, root + 0.6 / root);
    double factor = 1.0 + c->exponent * peak * turbulence * sqrt(b2 + r2);
    *out = (struct wf_gust_parts){ turbulence, b2, r2, peak, factor, factor / (1.0 + 7.0 * turbulence) };
}

static const char *terrain_en(const struct wf_category *terrain) { return terrain->name; }

/* ---- GB 50009-2012 ---- */

/* Categories: turbulence at 10 m, exponent of the mean wind, factor of the pressure at 10 m and its rounded
 * value k_w, lowest height [m], k and a1 of towers. */
struct gb_row {
    const char *name, *category; /* of EN 1991 with the same ground */
    double turbulence, alpha, pressure, k_w, least, k, a1;
};
static const struct gb_row gb_rows[] = {
    { "A", "0 I", 0.12, 0.12, 1.284, 1.28, 5.0, 1.276, 0.186 },
    { "B", "II", 0.14, 0.15, 1.0, 1.0, 10.0, 0.910, 0.218 },
    { "C", "III", 0.23, 0.22, 0.544, 0.54, 15.0, 0.404, 0.292 },
    { "D", "IV", 0.39, 0.30, 0.262, 0.26, 30.0, 0.155, 0.376 },
};

static const struct gb_row *gb_row_of(const struct wf_category *terrain)
{
    size_t i = 0, n = strlen(terrain->name);
    for (; i + 1 < WF_COUNT(gb_rows); i++)
        for (const char *at = gb_rows[i].category; *at; at += strcspn(at, " "), at += *at == ' ')
            if (strcspn(at, " ") == n && strncmp(at, terrain->name, n) == 0) return &gb_rows[i];
    return &gb_rows[i];
}

static double pressure_gb(const struct gb_row *r, double z)
{
    return r->pressure * pow(fmax(z, r->least) / 10.0, 2.0 * r->alpha);
}

static double mode_gb(double z, double h)
{
    return z * z * (6.0 * h * h - 4.0 * h * z + z * z) / (3.0 * pow(h, 4.0));
}

/* Background factor B_z of 8.4.6 at a height, for a tower of constant width (rho_x = 1). */
static double background_gb(const struct gb_row *r, const struct wf_gust_case *c, double z)
{
    double h = c->height, along = c->small ? 1.0 : 10.0 * sqrt(h + 60.0 * exp(-h / 60.0) - 60.0) / h;
    return r->k * pow(h, r->a1) * along * mode_gb(z, h) / pressure_gb(r, z);
}

/* Ratio of the base moments with and without the gust factor beta_z of the code, 8.4.3 to 8.4.6, of a body of
 * constant width; B^2 is that at the top. */
static void parts_gb(const struct wf_gust_case *c, struct wf_gust_parts *out)
{
    enum { STEPS = 200 };
    const struct gb_row *r = gb_row_of(c->terrain);
    const double g = 2.5, h = c->height;
    double w0 = c->open * c->open / 1600.0; /* kN/m2 at 1.25 kg/m3 */
    double x = 30.0 * c->frequency / sqrt(r->k_w * w0);
    double r2 = WF_PI / (6.0 * c->damping) * x * x / pow(1.0 + x * x, 4.0 / 3.0), with = 0.0, without = 0.0;
    for (int i = 0; i < STEPS; i++) {
        double z = h * (i + 0.5) / STEPS, load = pressure_gb(r, z) * z;
        double beta = 1.0 + c->exponent * g * r->turbulence * background_gb(r, c, z) * sqrt(1.0 + r2);
        with += beta * load, without += load;
    }
    double top = background_gb(r, c, h);
    *out = (struct wf_gust_parts){ r->turbulence, top * top, r2, g, with / without, NAN };
}

static double height_gb(const struct wf_category *terrain, double height)
{
    (void)terrain;
    return height;
}

static const char *terrain_gb(const struct wf_category *terrain) { return gb_row_of(terrain)->name; }

/* ---- ASCE 7 ---- */

struct asce_row {
    const char *name;
    double c, length, eps, least; /* turbulence at 10 m [-], scale at 10 m [m], its exponent [-], z_min [m] */
};
static const struct asce_row asce_rows[] = {
    { "D", 0.15, 198.12, 1.0 / 8.0, 2.13 },
    { "C", 0.20, 152.4, 1.0 / 5.0, 4.57 },
    { "B", 0.30, 97.54, 1.0 / 3.0, 9.14 },
};

/* B: suburbs and woods; C: open country; D: water. */
static const struct asce_row *asce_row_of(const struct wf_category *terrain)
{
    const double open = wf_category_open()->roughness;
    return &asce_rows[terrain->roughness < 0.5 * open ? 0 : terrain->roughness < 2.0 * open ? 1 : 2];
}

static double height_asce(const struct wf_category *terrain, double height)
{
    return fmax(0.6 * height, asce_row_of(terrain)->least);
}

/* 26.11.5. The factor is that of the load in the hourly mean; a 10-min mean is not below it. The depth along
 * the wind is taken as the breadth. */
static void parts_asce(const struct wf_gust_case *c, struct wf_gust_parts *out)
{
    const struct asce_row *r = asce_row_of(c->terrain);
    const double g = 3.4, time = 3600.0;
    double z = height_asce(c->terrain, c->height), length = r->length * pow(z / 10.0, r->eps);
    double turbulence = r->c * pow(10.0 / z, 1.0 / 6.0), n = c->frequency / c->mean, f = n * length;
    double q2 = 1.0 / (1.0 + 0.63 * pow((c->breadth + c->height) / length, 0.63));
    double spectrum = 7.47 * f / pow(1.0 + 10.3 * f, 5.0 / 3.0);
    double deep = size_reduction(15.4 * n * c->breadth);
    double sizes = size_reduction(4.6 * n * c->height) * size_reduction(4.6 * n * c->breadth);
    if (c->small) q2 = sizes = deep = 1.0;
    double r2 = spectrum * sizes * (0.53 + 0.47 * deep) / c->damping;
    double root = sqrt(2.0 * log(time * c->frequency)), peak = root + 0.577 / root;
    double gust = 0.85 * c->exponent * turbulence; /* 1.7 I for the square of the speed */
    double factor = 1.0 + gust * sqrt(g * g * q2 + peak * peak * r2);
    *out = (struct wf_gust_parts){ turbulence, q2, r2, peak, factor, 0.925 * factor / (1.0 + gust * g) };
}

static const char *terrain_asce(const struct wf_category *terrain) { return asce_row_of(terrain)->name; }

const struct wf_gust_rule wf_gust_rules[] = {
    { "en1991", "gust response factor of EN 1991-1-4, Annex B", "EN 1991-1-4:2005 + A1:2010, Annex B",
      "linear response of one mode, turbulence intensity up to 0.35, height up to 200 m", height_en, parts_en,
      terrain_en },
    { "gb50009", "wind vibration factor of GB 50009-2012", "GB 50009-2012, 8.4.3 to 8.4.6",
      "upright structure of constant width, linear response of the first mode, x_1 > 5", height_gb, parts_gb,
      terrain_gb },
    { "asce7", "gust effect of flexible structures, ASCE 7-16", "ASCE/SEI 7-16, 26.11.5",
      "linear response of one mode; factor of the hourly mean load", height_asce, parts_asce, terrain_asce },
    { 0 },
};

const struct wf_gust_rule *wf_gust_rule_named(const char *name)
{
    for (const struct wf_gust_rule *r = wf_gust_rules; r->name; r++)
        if (strcmp(r->name, name) == 0) return r;
    return NULL;
}

/* ---- Stands ---- */

double wf_stand_gust(double height, double spacing, double edge, double gap)
{
    const double deep = 9.0; /* heights behind the edge where its effect ends */
    double ratio = fmin(fmax(spacing / height, 0.075), 0.45);
    double in = fmin(edge / height, deep), open = pow(fmin(gap / height, 10.0) / 10.0, 0.3467);
    double inside = 2.7193 * ratio - 0.061, step = 0.9701 - 1.273 * ratio, decay = 1.1127 * ratio + 0.0311;
    double mean = 0.68 * ratio - 0.0385 + (0.4785 - 0.68 * ratio) * pow(1.7239 * ratio + 0.0316, deep);
    double well_in = inside + step * pow(decay, deep), here = inside + step * pow(decay, in);
    return (well_in + open * (here - well_in)) / mean;
}

double wf_stand_moment(double density, double speed, double height, double spacing, double drag_area)
{
    const double ground = 0.003, tree = 0.3, most = 0.6, displaced = 7.5;
    double ground_area = spacing * spacing, index = 2.0 * drag_area / ground_area;
    double stress = density * speed * speed * (ground + tree * fmin(index, most) / 2.0);
    double root = sqrt(displaced * index), d = root > 0.0 ? height * (1.0 + expm1(-root) / root) : 0.0;
    return stress * ground_area * d;
}
