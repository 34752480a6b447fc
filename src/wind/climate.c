/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/climate.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include "base/text.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Scales of wind. */

static const struct wf_wind_grade beaufort[] = {
    { "0", 0.0, 0.3, "calm", "smoke rises straight" },
    { "1", 0.3, 1.6, "light air", "smoke drifts" },
    { "2", 1.6, 3.4, "light breeze", "leaves rustle" },
    { "3", 3.4, 5.5, "gentle breeze", "leaves and small twigs in constant motion" },
    { "4", 5.5, 8.0, "moderate breeze", "small branches move" },
    { "5", 8.0, 10.8, "fresh breeze", "small trees in leaf begin to sway" },
    { "6", 10.8, 13.9, "strong breeze", "large branches in motion" },
    { "7", 13.9, 17.2, "near gale", "whole trees in motion" },
    { "8", 17.2, 20.8, "gale", "twigs break off" },
    { "9", 20.8, 24.5, "strong gale", "branches break" },
    { "10", 24.5, 28.5, "storm", "trees uprooted" },
    { "11", 28.5, 32.7, "violent storm", "widespread damage" },
    { "12", 32.7, 37.0, "hurricane", "devastation" },
    { "13", 37.0, 41.5, "extended scale", NULL },
    { "14", 41.5, 46.2, "extended scale", NULL },
    { "15", 46.2, 51.0, "extended scale", NULL },
    { "16", 51.0, 56.1, "extended scale", NULL },
    { "17", 56.1, 61.3, "extended scale", NULL },
    { 0 }
};
static const struct wf_wind_grade cma[] = {
    { "tropical-depression", 10.8, 17.2, "tropical depression", NULL },
    { "tropical-storm", 17.2, 24.5, "tropical storm", NULL },
    { "severe-tropical-storm", 24.5, 32.7, "severe tropical storm", NULL },
    { "typhoon", 32.7, 41.5, "typhoon", NULL },
    { "severe-typhoon", 41.5, 51.0, "severe typhoon", NULL },
    { "super-typhoon", 51.0, INFINITY, "super typhoon", NULL },
    { 0 }
};
#define KMH(x) ((x) / 3.6)
static const struct wf_wind_grade hko[] = {
    { "tropical-depression", KMH(41), KMH(63), "tropical depression", NULL },
    { "tropical-storm", KMH(63), KMH(88), "tropical storm", NULL },
    { "severe-tropical-storm", KMH(88), KMH(118), "severe tropical storm", NULL },
    { "typhoon", KMH(118), KMH(150), "typhoon", NULL },
    { "severe-typhoon", KMH(150), KMH(185), "severe typhoon", NULL },
    { "super-typhoon", KMH(185), INFINITY, "super typhoon", NULL },
    { 0 }
};

const struct wf_wind_scale wf_wind_scales[] = {
    { "beaufort", "Beaufort scale (12 and below: WMO; 13 to 17: extension of GB/T 28591)",
      "WMO (1970), The Beaufort scale of wind force, Reports on Marine Science Affairs 3; GB/T 28591-2012",
      600.0, "durst", 10.0, beaufort },
    { "cma", "Chinese grades of tropical cyclones", "GB/T 19201-2006, Grade of tropical cyclones", 120.0,
      "in-land", 10.0, cma },
    { "hko", "Hong Kong Observatory grades of tropical cyclones",
      "Hong Kong Observatory (2009), Classification of tropical cyclones", 600.0, "in-land", 10.0, hko },
    { 0 }
};

bool wf_wind_scale_is(const char *text) { return strchr(text, ':') && text[strspn(text, " \t")] > '9'; }

static enum wf_status unknown_scale_word(const char *what, const char *word, const char *const *known,
                                         size_t n, struct wf_err *e)
{
    return wf_fail(e, WF_EUSAGE, "unknown %s '%s'%s", what, word,
                   wf_did_you_mean_or(word, known, n, "there are: ").text);
}

enum wf_status wf_wind_scale_parse(const char *text, struct wf_scale_wind *out, struct wf_err *e)
{
    char scale[40];
    const char *known[24], *colon = strchr(text, ':');
    size_t n = 0, size = colon ? (size_t)(colon - text) : strlen(text);
    if (!colon || size >= sizeof scale)
        return wf_fail(e, WF_EUSAGE, "'%s' is not a wind on a scale such as beaufort:8 or cma:typhoon", text);
    memcpy(scale, text, size);
    scale[size] = '\0';
    const struct wf_wind_scale *s = wf_wind_scales;
    for (; s->name && strcasecmp(s->name, scale) != 0; s++) known[n++] = s->name;
    if (!s->name) return unknown_scale_word("wind scale", scale, known, n, e);
    const struct wf_wind_grade *g = s->grade;
    for (n = 0; g->name && strcasecmp(g->name, colon + 1) != 0; g++) known[n++] = g->name;
    if (!g->name) return unknown_scale_word("grade", colon + 1, known, n, e);
    *out = (struct wf_scale_wind){ s, g, isfinite(g->high) ? 0.5 * (g->low + g->high) : g->low };
    return WF_OK;
}

const struct wf_wind_grade *wf_wind_scale_grade(const struct wf_wind_scale *s, double speed)
{
    for (const struct wf_wind_grade *g = s->grade; g->name; g++)
        if (speed >= g->low && (speed < g->high || !g[1].name)) return g;
    return NULL;
}

/* Averaging times. */

const struct wf_averaging_law wf_averaging_laws[] = {
    { "durst",
      "Durst C.S. (1960), Meteorol. Mag. 89:181-186; fit: Shore Protection Manual (1984), U.S. Army Corps of "
      "Engineers",
      "open country, strong winds other than tropical cyclones and thunderstorms; 1 s to 3600 s" },
    { "in-land", "Harper B.A., Kepert J.D., Ginger J.D. (2010), WMO/TD-No. 1555, table 1.1",
      "tropical cyclones, roughly open terrain" },
    { "off-land", "Harper et al. (2010)", "tropical cyclones, offshore wind at a coast" },
    { "off-sea", "Harper et al. (2010)", "tropical cyclones, onshore wind at a coast" },
    { "at-sea", "Harper et al. (2010)", "tropical cyclones, open sea more than 20 km out" },
    { 0 }
};

enum { TIMES = 6, CLASSES = 4, PERIODS = 2 };
static const double harper_time[TIMES] = { 3, 60, 120, 180, 600, 3600 };
/* [class][period of the mean: 600 s, 3600 s][gust duration]: largest gust / mean */
static const double harper[CLASSES][PERIODS][TIMES] = {
    { { 1.66, 1.21, 1.12, 1.09, 1.00 }, { 1.75, 1.28, 1.19, 1.15, 1.08, 1.00 } },
    { { 1.52, 1.16, 1.09, 1.06, 1.00 }, { 1.60, 1.22, 1.15, 1.12, 1.06, 1.00 } },
    { { 1.38, 1.11, 1.05, 1.03, 1.00 }, { 1.45, 1.17, 1.11, 1.09, 1.05, 1.00 } },
    { { 1.23, 1.05, 1.02, 1.00, 1.00 }, { 1.30, 1.11, 1.07, 1.06, 1.03, 1.00 } },
};

/* Ratio of the largest gust of `gust` seconds to the mean over `period` seconds; 0 if it is not tabulated. */
static double harper_factor(size_t class, double period, double gust)
{
    size_t row = fabs(period - 600.0) < 0.01 ? 0 : fabs(period - 3600.0) < 0.01 ? 1 : PERIODS;
    for (size_t i = 0; i < TIMES && row < PERIODS; i++)
        if (fabs(gust - harper_time[i]) < 0.01) return harper[class][row][i];
    return 0.0;
}

static double durst(double t) { return 1.277 + 0.296 * tanh(0.9 * log10(45.0 / t)); }

enum wf_status wf_wind_average(const char *law, double speed, double from, double to, double *out,
                               struct wf_err *e)
{
    const char *known[8];
    size_t row = 0;
    for (; wf_averaging_laws[row].name && strcmp(wf_averaging_laws[row].name, law) != 0; row++)
        known[row] = wf_averaging_laws[row].name;
    if (!wf_averaging_laws[row].name)
        return wf_fail(e, WF_EUSAGE,
                       "unknown averaging law '%s'%s; known are durst, in-land, off-land, off-sea, at-sea",
                       law, wf_did_you_mean(law, known, row).text);
    if (row == 0) {
        if (!(from >= 1.0 && from <= 3600.0 && to >= 1.0 && to <= 3600.0))
            return wf_fail(e, WF_EUSAGE, "durst: averaging times of %g s and %g s; 1 s to 3600 s are covered",
                           from, to);
        *out = speed * durst(to) / durst(from);
        return WF_OK;
    }
    double factor = harper_factor(row - 1, fmax(from, to), fmin(from, to));
    if (!(factor > 0.0))
        return wf_fail(
            e, WF_EUSAGE,
            "%s: averaging times of %g s and %g s; a mean over 600 s or 3600 s and gusts of 3, 60, 120, 180 "
            "or 600 s are tabulated",
            law, from, to);
    *out = to < from ? speed * factor : speed / factor;
    return WF_OK;
}

/* Wind roses. */

enum { SECTORS_MAX = 16 };

/* The sector whose middle a direction is; SECTORS_MAX: none. */
static size_t sector_of(double degrees, size_t sectors)
{
    double place = degrees / 360.0 * (double)sectors;
    return fabs(place - round(place)) < 0.05 ? (size_t)llround(place) % sectors : SECTORS_MAX;
}

enum wf_status wf_rose_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_rose *out,
                            struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    double row[SECTORS_MAX][4];
    size_t errors = d->errors, n = 0, line[SECTORS_MAX];
    *out = (struct wf_rose){ 0 };
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    static const char *const name[4] = { "direction_deg", "frequency", "weibull_scale_ms", "weibull_shape" };
    static const double low[4] = { 0.0, 0.0, 0.1, 1.0 }, high[4] = { 360.0, 1e9, 40.0, 4.0 };
    static const enum wf_dimension dimension[4] = { WF_DIM_NONE, WF_DIM_NONE, WF_DIM_SPEED, WF_DIM_NONE };
    size_t column[4];
    double factor[4];
    struct wf_units *units;
    if (wf_units_open(&units, e)) return e ? e->code : WF_EMISSING;
    for (int k = 0; k < 4; k++) column[k] = wf_column_need(&csv, units, name[k], dimension[k], &factor[k], e);
    wf_units_close(units);
    if (e && e->code) return e->code;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a wind rose", path);
    for (; wf_csv_next(&csv); n++) {
        if (n == SECTORS_MAX) return wf_fail(e, WF_EINPUT, "%s: more than %d directions", path, SECTORS_MAX);
        for (int k = 0; k < 4; k++) wf_column_number(&csv, column[k], factor[k], low[k], high[k], &row[n][k]);
        line[n] = csv.row_line;
    }
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the wind rose cannot be used", path);
    if (n != 8 && n != 12 && n != 16)
        return wf_fail(e, WF_EINPUT, "%s: %zu directions; a rose has 8, 12 or 16", path, n);
    double *all = WF_TAKE(a, 4 * n, double);
    if (!all) return wf_fail(e, WF_ENOMEM, "%s: not enough memory", path);
    *out = (struct wf_rose){ n, all, all + n, all + 2 * n, all + 3 * n, 0.0 };
    for (size_t i = 0; i < n; i++) {
        size_t s = sector_of(row[i][0], n);
        if (s == SECTORS_MAX)
            wf_diag_error(d, path, line[i], 0, "direction_deg: %g is not a multiple of %g", row[i][0],
                          360.0 / (double)n);
        else if (out->scale[s] > 0.0)
            wf_diag_error(d, path, line[i], 0, "direction_deg: %g is given twice", row[i][0]);
        else
            out->from[s] = 2.0 * WF_PI * (double)s / (double)n, out->frequency[s] = row[i][1],
            out->scale[s] = row[i][2], out->shape[s] = row[i][3], out->typed_sum += row[i][1];
    }
    if (d->errors == errors && !(out->typed_sum > 0.0))
        wf_diag_error(d, path, 0, 0, "frequency: all are zero");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the wind rose cannot be used", path);
    for (size_t s = 0; s < n; s++) out->frequency[s] /= out->typed_sum;
    return WF_OK;
}

double wf_rose_sector_above(const struct wf_rose *r, size_t sector, double u)
{
    return u > 0.0 ? exp(-pow(u / r->scale[sector], r->shape[sector])) : 1.0;
}

double wf_rose_above(const struct wf_rose *r, double u)
{
    double sum = 0.0;
    for (size_t s = 0; s < r->sectors; s++) sum += r->frequency[s] * wf_rose_sector_above(r, s, u);
    return sum;
}

double wf_rose_mean(const struct wf_rose *r)
{
    double sum = 0.0;
    for (size_t s = 0; s < r->sectors; s++)
        sum += r->frequency[s] * r->scale[s] * tgamma(1.0 + 1.0 / r->shape[s]);
    return sum;
}

double wf_rose_speed(const struct wf_rose *r, double share)
{
    double low = 0.0, high = 1.0;
    while (wf_rose_above(r, high) > share) high *= 2.0;
    while (high - low > 1e-9) {
        double middle = 0.5 * (low + high);
        if (wf_rose_above(r, middle) > share)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}
