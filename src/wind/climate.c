/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/climate.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include "base/text.h"
#include "wind/category.h"
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
    { "en1991", "EN 1991-1-4:2005, 4.4 and 4.5: sqrt(1 + 7 I_v) of the terrain where the wind was measured",
      "strong winds other than thunderstorms; 3-s gusts and 10-min means" },
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

const char *wf_averaging_usual(double time) { return time == WF_GUST_TIME ? "en1991" : "durst"; }

static enum wf_status average_en(const struct wf_wind_place *at, double speed, double from, double to,
                                 double *out, struct wf_err *e)
{
    bool up = from == WF_MEAN_TIME && to == WF_GUST_TIME, down = from == WF_GUST_TIME && to == WF_MEAN_TIME;
    double gust = at ? wf_category_gust(at->terrain, at->height) : wf_category_gust(wf_category_open(), 10.0);
    if (!up && !down && from != to)
        return wf_fail(
            e, WF_EUSAGE,
            "en1991: averaging times of %g s and %g s; gusts of 3 s and means of 600 s are covered", from,
            to);
    *out = up ? speed * gust : down ? speed / gust : speed;
    return WF_OK;
}

enum wf_status wf_wind_average(const char *law, const struct wf_wind_place *at, double speed, double from,
                               double to, double *out, struct wf_err *e)
{
    const char *known[8];
    size_t row = 0;
    for (; wf_averaging_laws[row].name && strcmp(wf_averaging_laws[row].name, law) != 0; row++)
        known[row] = wf_averaging_laws[row].name;
    if (!wf_averaging_laws[row].name)
        return wf_fail(
            e, WF_EUSAGE,
            "unknown averaging law '%s'%s; known are durst, in-land, off-land, off-sea, at-sea, en1991", law,
            wf_did_you_mean(law, known, row).text);
    if (strcmp(law, "en1991") == 0) return average_en(at, speed, from, to, out, e);
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

/* Sixteen names from north clockwise, and what they are called in Chinese. */
static const char *const direction_names[16][5] = {
    { "N", "北" },
    { "NNE", "北东北", "北北东", "东北偏北" },
    { "NE", "东北", "北东" },
    { "ENE", "东东北", "东北东", "东北偏东" },
    { "E", "东" },
    { "ESE", "东东南", "东南东", "东南偏东" },
    { "SE", "东南", "南东" },
    { "SSE", "南东南", "南南东", "东南偏南" },
    { "S", "南" },
    { "SSW", "南西南", "南南西", "西南偏南" },
    { "SW", "西南", "南西" },
    { "WSW", "西西南", "西南西", "西南偏西" },
    { "W", "西" },
    { "WNW", "西西北", "西北西", "西北偏西" },
    { "NW", "西北", "北西" },
    { "NNW", "北西北", "北北西", "西北偏北" },
};

/* With or without the Chinese word for wind behind it. */
static bool is_direction_name(const char *text, const char *name)
{
    size_t n = strlen(name);
    return !strcasecmp(text, name) || (!strncmp(text, name, n) && !strcmp(text + n, "风"));
}

bool wf_rose_direction(const char *text, double *degrees, bool *named)
{
    double value;
    const char *end = text + strlen(text);
    if (named) *named = false;
    if (*text && wf_number_read(text, end, strchr(text, ',') ? ',' : '.', &value) == end) {
        *degrees = value;
        return true;
    }
    for (int i = 0; i < 16; i++)
        for (int k = 0; k < 5 && direction_names[i][k]; k++) {
            if (!is_direction_name(text, direction_names[i][k])) continue;
            *degrees = 22.5 * i;
            if (named) *named = true;
            return true;
        }
    return false;
}

size_t wf_speed_column(struct wf_csv *c, const char *name, double *factor, struct wf_err *e)
{
    struct wf_units *u;
    size_t stem;
    if (wf_units_open(&u, e)) return WF_CSV_NONE;
    size_t at = wf_column_need(c, u, name, WF_DIM_SPEED, factor, e);
    bool head = at != WF_CSV_NONE && c->unit && *c->unit[at], known = false;
    if (head)
        known = wf_column_factor(c, u, at, WF_DIM_SPEED, "m/s", factor, e);
    else if (at != WF_CSV_NONE)
        known = wf_name_unit(u, c->name[at].text, WF_DIM_SPEED, factor, &stem, e);
    wf_units_close(u);
    return known ? at : WF_CSV_NONE;
}

/* The sector whose middle a direction is; SECTORS_MAX: none. */
static size_t sector_of(double degrees, size_t sectors)
{
    double place = degrees / 360.0 * (double)sectors;
    return fabs(place - round(place)) < 0.05 ? (size_t)llround(place) % sectors : SECTORS_MAX;
}

/* Columns of a rose. */
struct rose_columns {
    size_t from, frequency, scale, shape, calm;
    double factor; /* of the scale, to m/s */
};
struct rose_line {
    double from, frequency, scale, shape, calm;
    size_t line;
};

static void find_rose_columns(struct wf_csv *c, struct rose_columns *k, struct wf_err *e)
{
    static const char *const from[] = { "direction_deg", "from_deg", "direction", "sector" };
    k->from = WF_CSV_NONE;
    for (size_t i = 0; i < WF_COUNT(from) && k->from == WF_CSV_NONE; i++) k->from = wf_csv_column(c, from[i]);
    if (k->from == WF_CSV_NONE) k->from = wf_csv_need(c, from[0]);
    k->frequency = wf_csv_need(c, "frequency");
    k->scale = wf_speed_column(c, "weibull_scale_ms", &k->factor, e);
    k->shape = wf_csv_need(c, "weibull_shape");
    k->calm = wf_csv_column(c, "calm");
}

static void read_rose_line(struct wf_csv *c, const struct rose_columns *k, struct rose_line *r)
{
    *r = (struct rose_line){ .scale = NAN, .shape = NAN, .line = c->row_line };
    if (!wf_rose_direction(wf_csv_text(c, k->from), &r->from, NULL))
        wf_csv_mistake(c, k->from, "'%.40s' is neither a number of degrees nor a name N, NNE, NE, ... NNW",
                       wf_csv_text(c, k->from));
    else if (!(r->from >= 0.0 && r->from <= 360.0))
        wf_csv_mistake(c, k->from, "%.40s is outside 0 to 360", wf_csv_text(c, k->from));
    if (!wf_csv_number(c, k->frequency, 0.0, 1e9, &r->frequency) || r->frequency == 0.0) return;
    if (wf_csv_number(c, k->scale, 0.1 / k->factor, 40.0 / k->factor, &r->scale)) r->scale *= k->factor;
    wf_csv_number(c, k->shape, 1.0, 4.0, &r->shape);
    if (k->calm != WF_CSV_NONE) wf_csv_number(c, k->calm, 0.0, 1.0, &r->calm);
}

/* Put the lines of a file into the sectors; mistakes become findings. */
static void place_rose_lines(const struct rose_line *row, const char *path, struct wf_diag *d,
                             struct wf_rose *out)
{
    bool seen[SECTORS_MAX] = { false };
    for (size_t i = 0; i < out->sectors; i++) {
        size_t s = sector_of(row[i].from, out->sectors);
        if (s == SECTORS_MAX) {
            wf_diag_error(d, path, row[i].line, 0, "direction_deg: %g is not a multiple of %g", row[i].from,
                          360.0 / (double)out->sectors);
            continue;
        }
        if (seen[s]) wf_diag_error(d, path, row[i].line, 0, "direction_deg: %g is given twice", row[i].from);
        seen[s] = true;
        out->from[s] = 2.0 * WF_PI * (double)s / (double)out->sectors;
        out->frequency[s] = row[i].frequency, out->scale[s] = row[i].scale, out->shape[s] = row[i].shape;
        out->calm[s] = row[i].calm, out->typed_sum += row[i].frequency;
    }
}

/* Frequencies that are neither shares nor per cent: counts, or a sector is wrong or missing. */
static void check_frequency_sum(const struct wf_rose *r, const char *path, struct wf_diag *d)
{
    double sum = r->typed_sum;
    if (fabs(sum - 1.0) <= 0.01 || fabs(sum - 100.0) <= 1.0) return;
    wf_diag_warn(d, "frequency-sum",
                 "%s: the frequencies sum to %.6g, neither 1 nor 100; they are taken as counts of hours and "
                 "divided by their sum. If they are shares or per cent, a sector is wrong",
                 path, sum);
}

enum wf_status wf_rose_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_rose *out,
                            struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    struct rose_columns column;
    struct rose_line row[SECTORS_MAX];
    size_t errors = d->errors, n = 0;
    *out = (struct wf_rose){ 0 };
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    find_rose_columns(&csv, &column, e);
    if (e && e->code) return e->code;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a wind rose", path);
    for (; wf_csv_next(&csv); n++) {
        if (n == SECTORS_MAX) return wf_fail(e, WF_EINPUT, "%s: more than %d directions", path, SECTORS_MAX);
        read_rose_line(&csv, &column, &row[n]);
    }
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the wind rose cannot be used", path);
    enum wf_status status = wf_rose_take(n, path, a, out, e);
    if (status) return status;
    place_rose_lines(row, path, d, out);
    if (d->errors == errors && !(out->typed_sum > 0.0))
        wf_diag_error(d, path, 0, 0, "frequency: all are zero");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the wind rose cannot be used", path);
    for (size_t s = 0; s < n; s++) out->frequency[s] /= out->typed_sum;
    check_frequency_sum(out, path, d);
    return WF_OK;
}

enum wf_status wf_rose_take(size_t sectors, const char *path, struct wf_arena *a, struct wf_rose *out,
                            struct wf_err *e)
{
    if (sectors != 8 && sectors != 12 && sectors != 16)
        return wf_fail(e, WF_EINPUT, "%s: %zu directions; a rose has 8, 12 or 16", path, sectors);
    double *all = WF_TAKE(a, 5 * sectors, double);
    if (!all) return wf_fail(e, WF_ENOMEM, "%s: not enough memory", path);
    *out = (struct wf_rose){ .sectors = sectors,
                             .from = all,
                             .frequency = all + sectors,
                             .scale = all + 2 * sectors,
                             .shape = all + 3 * sectors,
                             .calm = all + 4 * sectors };
    for (size_t s = 0; s < sectors; s++) {
        out->from[s] = 2.0 * WF_PI * (double)s / (double)sectors;
        out->scale[s] = out->shape[s] = NAN;
    }
    return WF_OK;
}

static double windy(const struct wf_rose *r, size_t sector) { return r->calm ? 1.0 - r->calm[sector] : 1.0; }

double wf_rose_sector_above(const struct wf_rose *r, size_t sector, double u)
{
    if (!(r->frequency[sector] > 0.0)) return 0.0;
    return u > 0.0 ? windy(r, sector) * exp(-pow(u / r->scale[sector], r->shape[sector])) : 1.0;
}

double wf_rose_sector_mean(const struct wf_rose *r, size_t sector)
{
    if (!(r->frequency[sector] > 0.0)) return NAN;
    return windy(r, sector) * r->scale[sector] * tgamma(1.0 + 1.0 / r->shape[sector]);
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
        if (r->frequency[s] > 0.0) sum += r->frequency[s] * wf_rose_sector_mean(r, s);
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
