/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/rose_record.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { FEW = 100, LEAST = 10 }; /* hours: uncertain below FEW, not fitted below LEAST */

/* ---- Weibull by maximum likelihood ---- */

/* sum(x^k ln x)/sum(x^k) - 1/k - mean(ln x), which grows with k; x is divided by its largest value, so that
 * no power overflows. */
static double likelihood_slope(const double *x, size_t n, double largest, double k)
{
    double power = 0.0, weighted = 0.0, logs = 0.0;
    for (size_t i = 0; i < n; i++) {
        double l = log(x[i] / largest), p = exp(k * l);
        power += p, weighted += p * l, logs += l;
    }
    return weighted / power - 1.0 / k - logs / (double)n;
}

/* Fit n speeds above 0. Where they are too few or all alike, the fit stays NAN. */
static void fit_weibull(const double *x, size_t n, struct wf_rose_fit *out)
{
    double largest = 0.0, least = INFINITY, low = 1e-3, high = 1.0, power = 0.0;
    *out = (struct wf_rose_fit){ n, NAN, NAN, NAN, NAN };
    for (size_t i = 0; i < n; i++) largest = fmax(largest, x[i]), least = fmin(least, x[i]);
    if (n < LEAST || !(least < largest)) return;
    while (high < 1e3 && likelihood_slope(x, n, largest, high) < 0.0) low = high, high *= 2.0;
    if (!(high < 1e3)) return;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        if (likelihood_slope(x, n, largest, middle) < 0.0)
            low = middle;
        else
            high = middle;
    }
    double k = 0.5 * (low + high), hours = (double)n;
    for (size_t i = 0; i < n; i++) power += exp(k * log(x[i] / largest));
    double scale = largest * pow(power / hours, 1.0 / k);
    *out = (struct wf_rose_fit){ n, scale, k, scale / k * sqrt(1.1087 / hours), k * sqrt(0.6079 / hours) };
}

/* ---- Rows ---- */

struct rows {
    struct wf_readings of; /* speeds in the column's unit, then [m/s], NAN: a missing mark; beside them
                              directions [deg], NAN: none */
    bool names;            /* directions are names of sixteen              */
    size_t first_line, first_column; /* first speed that is no number  */
    char first_text[40];
};

static bool one_of(const char *text, const char *const *words)
{
    for (; *words; words++)
        if (!strcasecmp(text, *words)) return true;
    return false;
}

/* A speed in the column's own unit. Returned: false where there is none; it is then counted. */
static bool read_speed(struct wf_csv *c, size_t column, struct rows *r, struct wf_rose_record *out,
                       double *speed)
{
    static const char *const calm[] = { "calm", "C", "静风", NULL };
    static const char *const silent[] = { "M", "/", "//", "///", NULL }; /* of weather services */
    const struct wf_cell *cell = &c->cell[column];
    enum wf_csv_kind kind = wf_csv_reading(c, column, speed);
    if (kind == WF_CSV_MISSING || one_of(cell->text, silent)) {
        out->missing++;
        return false;
    }
    if (kind == WF_CSV_NUMBER) return true;
    *speed = 0.0;
    if (one_of(cell->text, calm)) return true;
    if (!out->unreadable++) {
        r->first_line = cell->line, r->first_column = cell->column;
        (void)snprintf(r->first_text, sizeof r->first_text, "%s", cell->text);
    }
    return false;
}

/* Strike out the missing marks and convert to m/s. */
static enum wf_status strike_marks(struct wf_csv *c, size_t column, double factor, struct rows *r,
                                   struct wf_rose_record *out, struct wf_err *e)
{
    static const char *const how[] = { "If it means that there is no reading, write '# missing: ",
                                       "' above the header" };
    size_t kept = 0, struck;
    enum wf_status s =
        wf_marks_strike(c, column, factor, false, true, r->of.value, r->of.line, r->of.n, how, &struck, e);
    if (s) return s;
    out->missing += struck;
    for (size_t i = 0; i < r->of.n; i++)
        if (!isnan(r->of.value[i]))
            r->of.value[kept] = r->of.value[i] * factor, r->of.beside[kept++] = r->of.beside[i];
    r->of.n = kept;
    return WF_OK;
}

/* A direction [deg]; NAN for an empty cell, a variable wind, a word or a number that is no direction. */
static double read_direction(const struct wf_csv *c, size_t column, struct rows *r)
{
    double degrees;
    bool named;
    if (!wf_rose_direction(wf_csv_text(c, column), &degrees, &named)) return NAN;
    if (!(degrees >= 0.0 && degrees <= 360.0)) return NAN;
    r->names = r->names || named;
    return fmod(degrees, 360.0);
}

/* Names of the two columns; the defaults where none are given. */
static enum wf_status split_columns(const char *columns, struct wf_arena *a, const char *name[2],
                                    struct wf_err *e)
{
    const char *words = columns ? columns : "speed_ms,direction_deg", *comma = strchr(words, ',');
    size_t size = comma ? (size_t)(comma - words) : 0;
    if (!size || !comma[1] || strchr(comma + 1, ','))
        return wf_fail(e, WF_EUSAGE,
                       "columns '%.100s': a rose needs two, speed and direction, for example "
                       "speed_ms,direction_deg",
                       words);
    char *first = wf_arena_print(a, "%.*s", (int)size, words);
    name[0] = first, name[1] = comma + 1;
    return first ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the names of columns");
}

static enum wf_status read_rows(const char *path, const struct wf_rose_request *q, struct wf_arena *a,
                                struct wf_diag *d, struct rows *r, struct wf_rose_record *out,
                                struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    const char *name[2] = { NULL, NULL };
    size_t errors = d->errors;
    double factor, speed;
    enum wf_status status = split_columns(q->columns, a, name, e);
    if (!status) status = wf_csv_open(&csv, path, a, d, e);
    if (status) return status;
    size_t of_speed = wf_speed_column(&csv, name[0], &factor, e), of_direction = wf_csv_need(&csv, name[1]);
    if (e && e->code) return e->code;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a record of wind", path);
    while (wf_csv_next(&csv)) {
        out->rows++;
        if (!read_speed(&csv, of_speed, r, out, &speed)) continue;
        if (!wf_readings_add(&r->of, speed, read_direction(&csv, of_direction, r), csv.row_line))
            return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu rows", path, out->rows);
    }
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the record cannot be used", path);
    if (20 * out->unreadable > out->rows)
        return wf_fail(e, WF_EINPUT,
                       "%s: %zu of %zu speeds are not numbers, first at line %zu, column %zu: "
                       "'%s'",
                       path, out->unreadable, out->rows, r->first_line, r->first_column, r->first_text);
    return strike_marks(&csv, of_speed, factor, r, out, e);
}

/* The coarsest step of which all directions are multiples [deg]; 0: none. */
static double direction_step(const struct rows *r)
{
    static const double steps[] = { 45.0, 30.0, 22.5, 20.0, 15.0, 10.0, 5.0 };
    for (size_t k = 0; k < WF_COUNT(steps); k++) {
        bool all = true;
        for (size_t i = 0; i < r->of.n && all; i++) {
            double place = r->of.beside[i] / steps[k];
            all = isnan(place) || fabs(place - round(place)) < 1e-3;
        }
        if (all) return steps[k];
    }
    return 0.0;
}

/* ---- From rows to a rose ---- */

/* The sector of a direction; one on the border belongs to the next clockwise. */
static size_t sector_of_wind(double degrees, size_t sectors)
{
    return (size_t)floor(degrees / 360.0 * (double)sectors + 0.5) % sectors;
}

static void count_rows(const struct rows *r, struct wf_rose_record *out)
{
    for (size_t i = 0; i < r->of.n; i++) {
        bool wind = r->of.value[i] > 0.0, directed = !isnan(r->of.beside[i]);
        out->calm += !wind;
        out->directed += wind && directed;
        out->undirected += wind && !directed;
        if (wind && !directed) out->undirected_most = fmax(out->undirected_most, r->of.value[i]);
        if (wind) out->speed[out->n++] = r->of.value[i];
    }
}

/* Fit every sector; x: room for all speeds of one. A sector that cannot be fitted has A and k of all
 * directions. */
static void fit_sectors(const struct rows *r, double *x, struct wf_rose_record *out)
{
    struct wf_rose *rose = &out->rose;
    struct wf_rose_fit *all = &out->fit[rose->sectors];
    fit_weibull(out->speed, out->n, all);
    for (size_t s = 0; s < rose->sectors; s++) {
        size_t n = 0;
        for (size_t i = 0; i < r->of.n; i++)
            if (r->of.value[i] > 0.0 && !isnan(r->of.beside[i]) &&
                sector_of_wind(r->of.beside[i], rose->sectors) == s)
                x[n++] = r->of.value[i];
        struct wf_rose_fit *f = &out->fit[s];
        fit_weibull(x, n, f);
        if (!n) continue;
        rose->frequency[s] = (double)n / (double)out->directed;
        rose->scale[s] = isnan(f->scale) ? all->scale : f->scale;
        rose->shape[s] = isnan(f->shape) ? all->shape : f->shape;
        rose->calm[s] = (double)out->calm / (double)(out->calm + out->n);
    }
    rose->typed_sum = 1.0;
}

/* ---- What the reader of a rose must know ---- */

static double per_cent(size_t part, size_t whole) { return 100.0 * (double)part / (double)whole; }

static void say_calms(const struct wf_rose_record *r, struct wf_diag *d)
{
    size_t valid = r->n + r->calm;
    wf_diag_warn(
        d, "rose-record",
        "%s: %zu of %zu rows have a speed: %zu with wind and direction, %zu calm (%.2f %%), %zu with wind "
        "but no direction (%.2f %%, up to %.4g m/s); calms and winds without direction are given to "
        "the sectors in proportion to their frequency. Every row counts as an hourly mean at the "
        "reference height",
        r->file, valid, r->rows, r->directed, r->calm, per_cent(r->calm, valid), r->undirected,
        per_cent(r->undirected, valid), r->undirected_most);
    size_t lost = r->missing + r->unreadable;
    if (10 * lost > r->rows)
        wf_diag_warn(
            d, "rose-missing",
            "%s: %zu of %zu rows (%.1f %%) have no speed; if strong winds are missing more often, the "
            "rose is too calm",
            r->file, lost, r->rows, per_cent(lost, r->rows));
}

/* Sectors with few hours, as "90 (0), 120 (12)". */
static void say_few(const struct wf_rose_record *r, struct wf_diag *d)
{
    char few[400] = "", none[400] = "";
    size_t used = 0, borrowed = 0;
    for (size_t s = 0; s < r->rose.sectors; s++) {
        const struct wf_rose_fit *f = &r->fit[s];
        double from = 360.0 * (double)s / (double)r->rose.sectors;
        if (f->hours < FEW && used < sizeof few)
            used += (size_t)snprintf(few + used, sizeof few - used, "%s%g (%zu)", used ? ", " : "", from,
                                     f->hours);
        if (f->hours && isnan(f->scale) && borrowed < sizeof none)
            borrowed +=
                (size_t)snprintf(none + borrowed, sizeof none - borrowed, "%s%g", borrowed ? ", " : "", from);
    }
    if (used)
        wf_diag_warn(d, "rose-few",
                     "%s: sectors with fewer than %d hours (their number): %s; their A and k are "
                     "uncertain%s%s",
                     r->file, FEW, few,
                     borrowed ? "; with A and k of all directions, for want of data: " : "", none);
}

static void say_steps(const struct wf_rose_record *r, struct wf_diag *d)
{
    double width = 360.0 / (double)r->rose.sectors, parts = r->step > 0.0 ? width / r->step : 1.0;
    bool whole = fabs(parts - round(parts)) < 1e-6, odd = whole && llround(parts) % 2 == 1;
    if (!(r->step > 0.0) || odd) return;
    wf_diag_warn(
        d, "rose-steps", "%s: directions are given in steps of %g degrees, sectors are %g degrees wide: %s",
        r->file, r->step, width,
        whole ? "directions on a border go to the next sector clockwise, which turns the rose by half a step"
              : "some sectors hold more steps than others and look more frequent");
}

/* A and k outside what is usual for winds. */
static void say_range(const struct wf_rose_record *r, struct wf_diag *d)
{
    for (size_t s = 0; s < r->rose.sectors; s++) {
        double scale = r->rose.scale[s], shape = r->rose.shape[s];
        if (isnan(scale) || (scale >= 0.1 && scale <= 40.0 && shape >= 1.0 && shape <= 4.0)) continue;
        wf_diag_warn(
            d, "rose-range",
            "%s: from %g degrees: Weibull A %.4g m/s, k %.4g are outside 0.1 to 40 m/s and 1 to 4, which "
            "hourly winds have; look at the record",
            r->file, 360.0 * (double)s / (double)r->rose.sectors, scale, shape);
    }
}

static enum wf_status make_rose(struct rows *r, size_t sectors, struct wf_arena *a,
                                struct wf_rose_record *out, struct wf_err *e)
{
    out->step = direction_step(r);
    bool sixteen = r->names || out->step == 22.5 || out->step == 45.0;
    enum wf_status status = wf_rose_take(sectors ? sectors : sixteen ? 16 : 12, out->file, a, &out->rose, e);
    if (status) return status;
    out->speed = WF_TAKE(a, r->of.n, double);
    out->fit = WF_TAKE(a, out->rose.sectors + 1, struct wf_rose_fit);
    double *x = WF_TAKE(a, r->of.n, double);
    if (!out->speed || !out->fit || !x)
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu rows", out->file, r->of.n);
    count_rows(r, out);
    qsort(out->speed, out->n, sizeof *out->speed, wf_ascending);
    fit_sectors(r, x, out);
    if (!isnan(out->fit[out->rose.sectors].scale) && out->directed) return WF_OK;
    return wf_fail(
        e, WF_EINPUT,
        "%s: %zu rows with wind, %zu of them with a direction: too few, or all of one speed, for a "
        "rose",
        out->file, out->n, out->directed);
}

enum wf_status wf_rose_from_record(const char *path, const struct wf_rose_request *q, struct wf_arena *a,
                                   struct wf_diag *d, struct wf_rose_record *out, struct wf_err *e)
{
    struct rows r = { 0 };
    *out = (struct wf_rose_record){ .file = path };
    enum wf_status status = read_rows(path, q, a, d, &r, out, e);
    if (!status) status = make_rose(&r, q->sectors, a, out, e);
    wf_readings_free(&r.of);
    if (status) return status;
    say_calms(out, d);
    say_few(out, d);
    say_steps(out, d);
    say_range(out, d);
    return WF_OK;
}

double wf_rose_record_above(const struct wf_rose_record *r, double u)
{
    size_t low = 0, high = r->n; /* the first speed above u */
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (r->speed[middle] > u)
            high = middle;
        else
            low = middle + 1;
    }
    return (double)(r->n - low) / (double)(r->n + r->calm);
}
