/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/design.h"
#include "wind/climate.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double ten = 10.0; /* height of basic winds [m] */

/* Whether a list of words with blanks between holds a word. */
static bool lists(const char *list, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = list; *at; at += strcspn(at, " "), at += *at == ' ')
        if (strcspn(at, " ") == n && strncmp(at, word, n) == 0) return true;
    return false;
}

/* The first of a terrain's categories. */
static const struct wf_category *category_of(const struct wf_design_terrain *t)
{
    const struct wf_category *c = wf_categories;
    for (size_t n = strcspn(t->category, " "); c[1].name; c++)
        if (strlen(c->name) == n && strncmp(c->name, t->category, n) == 0) break;
    return c;
}

/* Gust over mean by EN 1991-1-4, for codes that give the gust alone. */
static double gust_en(const struct wf_design_terrain *t) { return wf_category_gust(category_of(t), ten); }

/* ---- EN 1991-1-4 ---- */

static const struct wf_design_terrain en_terrains[] = {
    { "0", "0", { 0 } },     { "I", "I", { 0 } },   { "II", "II", { 0 } },
    { "III", "III", { 0 } }, { "IV", "IV", { 0 } }, { 0 },
};

/* c_e: the peak velocity pressure over the basic one (4.5). */
static double pressure_en(const struct wf_design_terrain *t, double z)
{
    const struct wf_category *c = category_of(t);
    return pow(wf_category_factor(c, z) * wf_category_gust(c, z), 2.0);
}

static double mean_en(const struct wf_design_terrain *t) { return wf_category_factor(category_of(t), ten); }

static double squall_en(const struct wf_design_terrain *t) { return mean_en(t) * gust_en(t); }

/* c_prob, 4.2 (2), with the recommended K and n. */
static enum wf_status rare_en(const struct wf_design_words *w, double *basic, struct wf_err *e)
{
    const double k = 0.2, n = 0.5, p = 1.0 / w->years;
    (void)e;
    *basic = w->basic * pow((1.0 - k * log(-log1p(-p))) / (1.0 - k * log(-log(0.98))), n);
    return WF_OK;
}

/* ---- GB 50009-2012 ---- */

enum { GB_PRESSURE, GB_ALPHA, GB_LEAST, GB_TURBULENCE };
static const struct wf_design_terrain gb_terrains[] = {
    { "A", "I 0", { 1.284, 0.12, 5.0, 0.12 } },
    { "B", "II", { 1.000, 0.15, 10.0, 0.14 } },
    { "C", "III", { 0.544, 0.22, 15.0, 0.23 } },
    { "D", "IV", { 0.262, 0.30, 30.0, 0.39 } },
    { 0 },
};

/* mu_z, 8.2.1: of the mean. */
static double pressure_gb(const struct wf_design_terrain *t, double z)
{
    return t->value[GB_PRESSURE] * pow(fmax(z, t->value[GB_LEAST]) / ten, 2.0 * t->value[GB_ALPHA]);
}

static double mean_gb(const struct wf_design_terrain *t) { return sqrt(pressure_gb(t, ten)); }

/* By the gust factor of cladding, 8.6.1, with the peak factor 2.5. */
static double squall_gb(const struct wf_design_terrain *t)
{
    double z = fmax(ten, t->value[GB_LEAST]), peak = 2.5;
    double turbulence = t->value[GB_TURBULENCE] * pow(z / ten, -t->value[GB_ALPHA]);
    return mean_gb(t) * sqrt(1.0 + 2.0 * peak * turbulence);
}

static void shape_gb(const struct wf_design_terrain *t, double *exponent, double *least)
{
    *exponent = t->value[GB_ALPHA], *least = t->value[GB_LEAST];
}

/* ---- ASCE 7 ---- */

enum { ASCE_MEAN, ASCE_POWER, ASCE_LEAST, ASCE_ALPHA, ASCE_TOP };
static const struct wf_design_terrain asce_terrains[] = {
    { "B", "III IV", { 0.45, 1.0 / 4.0, 9.14, 7.0, 365.76 } },
    { "C", "II", { 0.65, 1.0 / 6.5, 4.57, 9.5, 274.32 } },
    { "D", "I 0", { 0.80, 1.0 / 9.0, 2.13, 11.5, 213.36 } },
    { 0 },
};

/* K_z, table 26.10-1: of the gust. */
static double pressure_asce(const struct wf_design_terrain *t, double z)
{
    return 2.01 * pow(fmax(z, 4.57) / t->value[ASCE_TOP], 2.0 / t->value[ASCE_ALPHA]);
}

/* The hourly mean of 26.11.4, as a 10-min mean by Durst's law. */
static double mean_asce(const struct wf_design_terrain *t)
{
    double hourly = t->value[ASCE_MEAN], mean = hourly;
    wf_wind_average("durst", NULL, hourly, 3600.0, WF_MEAN_TIME, &mean, NULL);
    return mean;
}

static double squall_asce(const struct wf_design_terrain *t) { return sqrt(pressure_asce(t, ten)); }

static void shape_asce(const struct wf_design_terrain *t, double *exponent, double *least)
{
    *exponent = t->value[ASCE_POWER], *least = t->value[ASCE_LEAST];
}

/* ---- AS/NZS 1170.2 ---- */

enum { HEIGHTS = 8 };
static const double asnzs_height[HEIGHTS] = { 3, 5, 10, 15, 20, 30, 40, 50 };
static const struct wf_design_terrain asnzs_terrains[] = {
    /* M_z,cat at these heights, table 4.1 */
    { "TC1", "I 0", { .97, 1.01, 1.08, 1.12, 1.14, 1.18, 1.21, 1.23 } },
    { "TC2", "II", { .91, .91, 1.00, 1.05, 1.08, 1.12, 1.16, 1.18 } },
    { "TC2.5", "II", { .87, .87, .92, .97, 1.01, 1.06, 1.10, 1.13 } },
    { "TC3", "III", { .83, .83, .83, .89, .94, 1.00, 1.04, 1.07 } },
    { "TC4", "IV", { .75, .75, .75, .75, .75, .80, .85, .90 } },
    { 0 },
};

static const struct {
    const char *names;
    double high, fall; /* V_R = high - fall R^-0.1 [m/s] */
    double climate;    /* M_c */
} asnzs_regions[] = {
    { "A A0 A1 A2 A3 A4 A5", 67.0, 41.0, 1.0 },
    { "B1", 106.0, 92.0, 1.0 },
    { "B2", 106.0, 92.0, 1.05 },
    { "C", 122.0, 104.0, 1.05 },
    { "D", 156.0, 142.0, 1.05 },
    { "NZ1 NZ4", 61.0, 30.0, 1.0 },
    { "NZ2", 71.0, 34.0, 1.0 },
    { "NZ3", 63.0, 25.0, 1.0 },
};

static double pressure_asnzs(const struct wf_design_terrain *t, double z)
{
    size_t i = 1;
    while (i < HEIGHTS - 1 && z > asnzs_height[i]) i++;
    double low = asnzs_height[i - 1], s = (z - low) / (asnzs_height[i] - low);
    double factor = t->value[i - 1] + fmin(fmax(s, 0.0), 1.0) * (t->value[i] - t->value[i - 1]);
    return factor * factor;
}

static double squall_asnzs(const struct wf_design_terrain *t) { return sqrt(pressure_asnzs(t, ten)); }

static double mean_asnzs(const struct wf_design_terrain *t) { return squall_asnzs(t) / gust_en(t); }

static enum wf_status rare_asnzs(const struct wf_design_words *w, double *basic, struct wf_err *e)
{
    const double least = 5.0; /* years */
    if (!w->region)
        return wf_fail(e, WF_EUSAGE, "asnzs1170: the return period is for a wind region (--region)");
    if (!(w->years >= least))
        return wf_fail(
            e, WF_EUSAGE,
            "asnzs1170: a return period of %.6g years; the winds of the regions are for %g and more",
            w->years, least);
    for (size_t i = 0; i < sizeof asnzs_regions / sizeof *asnzs_regions; i++)
        if (lists(asnzs_regions[i].names, w->region)) {
            double rounded = round(asnzs_regions[i].high - asnzs_regions[i].fall * pow(w->years, -0.1));
            *basic = asnzs_regions[i].climate * rounded;
            return WF_OK;
        }
    return wf_fail(e, WF_EUSAGE,
                   "asnzs1170: unknown region '%.20s'; there are A0 to A5, B1, B2, C, D, NZ1 to NZ4",
                   w->region);
}

/* ---- SIA 261 ---- */

enum { SIA_ALPHA, SIA_TOP, SIA_LEAST };
static const struct wf_design_terrain sia_terrains[] = {
    { "II", "II I 0", { 0.16, 300.0, 5.0 } },
    { "IIa", "II", { 0.19, 380.0, 5.0 } },
    { "III", "III", { 0.23, 450.0, 5.0 } },
    { "IV", "IV", { 0.30, 526.0, 10.0 } },
    { 0 },
};

/* c_h, 6.2.1.2: of the gust. */
static double pressure_sia(const struct wf_design_terrain *t, double z)
{
    double rise = pow(fmax(z, t->value[SIA_LEAST]) / t->value[SIA_TOP], t->value[SIA_ALPHA]);
    return 1.6 * pow(rise + 0.375, 2.0);
}

static double squall_sia(const struct wf_design_terrain *t) { return sqrt(pressure_sia(t, ten)); }

static double mean_sia(const struct wf_design_terrain *t) { return squall_sia(t) / gust_en(t); }

/* ---- Arborists ---- */

static const struct wf_design_terrain tree_terrains[] = { { "at the tree", "II", { 0 } }, { 0 } };

static double as_basic(const struct wf_design_terrain *t)
{
    (void)t;
    return 1.0;
}

static double pressure_tree(const struct wf_design_terrain *t, double z)
{
    (void)t, (void)z;
    return 1.0;
}

static double mean_tree(const struct wf_design_terrain *t) { return 1.0 / gust_en(t); }

/* ---- The rows ---- */

const struct wf_design wf_designs[] = {
    { "en1991", "EN 1991-1-4", "EN 1991-1-4:2005 + A1:2010, 4.2 to 4.5", "flat ground, up to 200 m",
      "10-min mean at 10 m over terrain II, once in 50 years", "sqrt(1 + 7 I_v) times the mean", "en1991",
      "terrain", en_terrains, 1.25, NAN, 0.0, pressure_en, mean_en, squall_en, NULL, rare_en },
    { "gb50009", "GB 50009", "GB 50009-2012, 8.2 and 8.6",
      "flat ground; basic pressure of at least 0.3 kN/m2",
      "10-min mean at 10 m over terrain B, or its pressure w0",
      "sqrt(1 + 5 I_10 (z/10)^-alpha) times the mean, by the gust factor of cladding", "gb50009", "code",
      gb_terrains, 1.25, NAN, 300.0, pressure_gb, mean_gb, squall_gb, shape_gb, NULL },
    { "asce7", "ASCE 7", "ASCE/SEI 7-16, 26.10 and 26.11", "flat ground",
      "3-s gust at 10 m over exposure C; the hourly means of the code are raised to 10-min means (durst)",
      "sqrt(K_z) times the basic wind", "asce7", "code", asce_terrains, NAN, NAN, 0.0, pressure_asce,
      mean_asce, squall_asce, shape_asce, NULL },
    { "asnzs1170", "AS/NZS 1170.2", "AS/NZS 1170.2:2021, sections 3 and 4",
      "flat ground, any wind direction (M_d = 1), up to 50 m",
      "regional gust at 10 m over TC2, of --region and --return-period; the mean from it as of a 3-s gust",
      "M_z,cat times the regional gust", "en1991", "terrain", asnzs_terrains, NAN, NAN, 0.0, pressure_asnzs,
      mean_asnzs, squall_asnzs, NULL, rare_asnzs },
    { "sia261", "SIA 261", "SIA 261, 6.2.1", "flat ground",
      "gust as pressure q_p0, or the speed that has it; the mean from it as of a 3-s gust",
      "sqrt(c_h) times the basic gust", "en1991", "terrain", sia_terrains, 1.25, NAN, 0.0, pressure_sia,
      mean_sia, squall_sia, NULL, NULL },
    { "arborist", "arborist statics", "practice of tree assessment: lower end of Beaufort 12, as a gust",
      "a gust at the tree, the same at every height; no factor on top",
      "gust at the tree, 33 m/s unless given", "the basic wind itself", "gust", "uniform", tree_terrains, NAN,
      33.0, 0.0, pressure_tree, mean_tree, as_basic, NULL, NULL },
    { 0 },
};

const struct wf_design *wf_design_named(const char *name)
{
    for (const struct wf_design *d = wf_designs; name && d->name; d++)
        if (strcmp(d->name, name) == 0) return d;
    return NULL;
}

const struct wf_design_terrain *wf_design_terrain_named(const struct wf_design *d, const char *name)
{
    for (const struct wf_design_terrain *t = d->terrain; t->name; t++)
        if (strcmp(t->name, name) == 0) return t;
    for (const struct wf_design_terrain *t = d->terrain; t->name; t++)
        if (lists(t->category, name)) return t;
    return NULL;
}

static enum wf_status unknown_terrain(const struct wf_design *d, const char *word, struct wf_err *e)
{
    char known[64] = "";
    size_t n = 0;
    for (const struct wf_design_terrain *t = d->terrain; t->name && n < sizeof known; t++)
        n += (size_t)snprintf(known + n, sizeof known - n, "%s%s", n ? ", " : "", t->name);
    return wf_fail(e, WF_EUSAGE, "%s: unknown terrain '%.20s'; there are %s, and those of EN 1991-1-4",
                   d->name, word, known);
}

/* The basic wind as given: a speed, or the speed that has a pressure. */
static enum wf_status typed_basic(const struct wf_design *d, const struct wf_design_words *w, double *basic,
                                  struct wf_err *e)
{
    if (!isnan(w->basic) && !isnan(w->pressure))
        return wf_fail(e, WF_EUSAGE, "give one of --basic-wind and --basic-pressure, not both");
    if (!isnan(w->pressure) && isnan(d->air))
        return wf_fail(e, WF_EUSAGE, "%s takes a speed, --basic-wind, not a pressure", d->name);
    *basic = isnan(w->pressure) ? w->basic : sqrt(2.0 * w->pressure / d->air);
    if (isnan(*basic)) *basic = d->fallback;
    if (d->least > 0.0 && 0.5 * d->air * *basic * *basic < d->least * (1.0 - 1e-9))
        return wf_fail(e, WF_EUSAGE,
                       "%s: a basic wind of %.4g m/s has %.3g kN/m2; the least of the code is %.3g kN/m2",
                       d->name, *basic, 0.5e-3 * d->air * *basic * *basic, 1e-3 * d->least);
    return WF_OK;
}

/* The basic wind of the return period, where one is given. */
static enum wf_status find_basic(const struct wf_design *d, const struct wf_design_words *w, double *basic,
                                 struct wf_err *e)
{
    struct wf_design_words known = *w;
    enum wf_status s = typed_basic(d, w, &known.basic, e);
    bool of_region = w->region && d->rare == rare_asnzs;
    *basic = known.basic;
    if (s) return s;
    if (w->region && !of_region)
        return wf_fail(e, WF_EUSAGE, "%s has no regions; --region is of asnzs1170", d->name);
    if (of_region && (!isnan(known.basic) || isnan(w->years)))
        return wf_fail(e, WF_EUSAGE,
                       "%s needs --region and --return-period, or the regional gust itself, --basic-wind",
                       d->name);
    if (!of_region && isnan(known.basic))
        return wf_fail(e, WF_EUSAGE, "%s needs its basic wind: --basic-wind%s (%s)", d->name,
                       isnan(d->air) ? "" : " or --basic-pressure", d->basic);
    if (isnan(w->years)) return WF_OK;
    if (!(w->years > 1.0))
        return wf_fail(e, WF_EUSAGE, "a return period of %.6g years; it must be longer than 1 year",
                       w->years);
    if (!d->rare)
        return wf_fail(e, WF_EUSAGE,
                       "%s has no rule for a return period; give the basic wind of its maps for it", d->name);
    return d->rare(&known, basic, e);
}

enum wf_status wf_design_find(const struct wf_design_words *w, struct wf_design_wind *out, struct wf_err *e)
{
    const char *open = wf_category_open()->name;
    const struct wf_design *d = wf_design_named(w->code);
    if (!d) return wf_fail(e, WF_EUSAGE, "unknown design wind '%.40s'", w->code ? w->code : "");
    if (w->terrain && d->terrain == tree_terrains)
        return wf_fail(e, WF_EUSAGE, "%s: the wind is at the tree; it takes no terrain and no site", d->name);
    *out = (struct wf_design_wind){ .code = d,
                                    .terrain = wf_design_terrain_named(d, w->terrain ? w->terrain : open) };
    if (!out->terrain) return unknown_terrain(d, w->terrain, e);
    enum wf_status s = find_basic(d, w, &out->basic, e);
    if (s) return s;
    out->category = category_of(out->terrain);
    out->open = out->basic * d->mean(wf_design_terrain_named(d, open));
    out->mean = out->basic * d->mean(out->terrain);
    out->gust = out->basic * d->squall(out->terrain);
    if (d->shape) d->shape(out->terrain, &out->exponent, &out->least);
    return WF_OK;
}

/* Basic wind of a return period; NAN: the code has none of that. */
static double rare_wind(const struct wf_design *d, const struct wf_design_words *w, double years)
{
    struct wf_design_words of = *w;
    struct wf_err unsaid = { WF_OK, "" };
    double basic = NAN;
    of.years = years;
    return d->rare && !d->rare(&of, &basic, &unsaid) ? basic : (double)NAN;
}

double wf_design_years(const struct wf_design_words *w, double ratio, int *end)
{
    const struct wf_design *d = wf_design_named(w->code);
    double low = 1.05, high = 1e4; /* years; the longest that a code gives, AS/NZS 1170.2 */
    *end = 0;
    if (!d || !d->rare) return NAN;
    if (isnan(rare_wind(d, w, low))) low = 5; /* the least of AS/NZS 1170.2 */
    double now = isnan(w->years) ? w->basic : rare_wind(d, w, w->years), wanted = ratio * now;
    if (isnan(now) || isnan(rare_wind(d, w, low))) return NAN;
    if (wanted <= rare_wind(d, w, low)) return *end = -1, low;
    if (wanted >= rare_wind(d, w, high)) return *end = 1, high;
    while (high > 1.001 * low) {
        double middle = sqrt(low * high);
        if (rare_wind(d, w, middle) < wanted)
            low = middle;
        else
            high = middle;
    }
    return sqrt(low * high);
}
