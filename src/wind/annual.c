/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/annual.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include "wind/climate.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { YEARS_MAX = 10000, ROWS_MAX = 20000000 };
static const double highest = 200; /* no wind near the ground is above it [m/s] */

/* ---- A table of years ---- */

static int by_year(const void *a, const void *b)
{
    const struct wf_annual_year *x = a, *y = b;
    return (x->year > y->year) - (x->year < y->year);
}

static bool take_years(struct wf_annual *out, size_t n, struct wf_arena *a)
{
    out->year = WF_TAKE(a, n ? n : 1, struct wf_annual_year);
    out->speed = WF_TAKE(a, n ? n : 1, double);
    return out->year && out->speed;
}

static void use_years(struct wf_annual *out)
{
    for (size_t i = 0; i < out->n; i++)
        if (out->year[i].used) out->speed[out->used++] = out->year[i].largest;
}

static enum wf_status read_table(struct wf_csv *c, const struct wf_annual_request *q, struct wf_arena *a,
                                 struct wf_annual *out, struct wf_err *e)
{
    double factor, speed;
    size_t of_speed = wf_speed_column(c, q->column ? q->column : "speed_ms", &factor, e);
    size_t of_year = wf_csv_column(c, "year");
    if (e && e->code) return e->code;
    if (!take_years(out, YEARS_MAX, a)) return wf_fail(e, WF_ENOMEM, "not enough memory for the years");
    while (wf_csv_next(c)) {
        long long year = (long long)out->n + 1;
        bool good = wf_column_number(c, of_speed, factor, 1e-6, highest, &speed);
        if (of_year != WF_CSV_NONE) good = wf_csv_integer(c, of_year, 1, 9999, &year) && good;
        for (size_t i = 0; good && i < out->n; i++)
            if (out->year[i].year == year)
                wf_csv_mistake(c, of_year, "year %lld is there already", year), good = false;
        if (!good) continue;
        if (out->n == YEARS_MAX) return wf_fail(e, WF_EINPUT, "%s: more than %d years", c->file, YEARS_MAX);
        out->year[out->n++] = (struct wf_annual_year){ (int)year, 1, speed, true };
    }
    return WF_OK;
}

enum wf_status wf_annual_read(const char *path, const struct wf_annual_request *q, struct wf_arena *a,
                              struct wf_diag *d, struct wf_annual *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    struct wf_err found = { 0 };
    size_t errors = d->errors;
    *out = (struct wf_annual){ .file = path, .step = NAN };
    enum wf_status s = wf_csv_open(&csv, path, a, d, &found);
    if (!s) s = read_table(&csv, q, a, out, &found);
    if (s) return wf_fail(e, s, "%s", found.text);
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a table of annual winds", path);
    qsort(out->year, out->n, sizeof *out->year, by_year);
    use_years(out);
    return WF_OK;
}

/* ---- A record ---- */

static enum wf_status read_rows(struct wf_csv *c, const struct wf_annual_request *q, struct wf_clock *clock,
                                double *factor, struct wf_readings *r, struct wf_err *e)
{
    double t, speed;
    size_t of_speed = wf_speed_column(c, q->column ? q->column : "speed_ms", factor, e);
    size_t of_time = wf_csv_need(c, q->time ? q->time : "time"), struck;
    if (e && e->code) return e->code;
    if (of_speed == WF_CSV_NONE || of_time == WF_CSV_NONE) return WF_OK; /* mistakes of the table */
    while (wf_csv_next(c)) {
        bool timed = wf_clock_read(clock, c, of_time, &t);
        if (wf_csv_reading(c, of_speed, &speed) != WF_CSV_NUMBER || !timed) continue;
        if (r->n == ROWS_MAX || !wf_readings_add(r, speed, t, c->row_line))
            return wf_fail(e, r->n == ROWS_MAX ? WF_EINPUT : WF_ENOMEM, "%s: too many rows (%zu)", c->file,
                           r->n);
    }
    static const char *const how[] = { "If it means that there is no reading, write '# missing: ",
                                       "' above the header" };
    return wf_marks_strike(c, of_speed, *factor, false, true, r->value, r->line, r->n, how, &struck, e);
}

/* The year in which a time's year of 12 months begins. */
static int year_of(const struct wf_clock *clock, double t, size_t begins)
{
    int year = 0, month = 1;
    (void)wf_clock_date(clock, t, &year, &month);
    return (size_t)month < begins ? year - 1 : year;
}

static double median_step(const struct wf_readings *r)
{
    double *step = malloc((r->n ? r->n : 1) * sizeof *step), middle = NAN;
    size_t n = 0;
    for (size_t i = 1; step && i < r->n; i++)
        if (r->beside[i] > r->beside[i - 1]) step[n++] = r->beside[i] - r->beside[i - 1];
    if (n) {
        qsort(step, n, sizeof *step, wf_ascending);
        middle = step[n / 2];
    }
    free(step);
    return middle;
}

static enum wf_status sort_into_years(const struct wf_readings *r, const struct wf_clock *clock,
                                      double factor, const struct wf_annual_request *q, struct wf_arena *a,
                                      struct wf_annual *out, struct wf_err *e)
{
    int first = INT32_MAX, last = INT32_MIN;
    for (size_t i = 0; i < r->n; i++) {
        int y = year_of(clock, r->beside[i], q->begins);
        first = y < first ? y : first, last = y > last ? y : last;
    }
    if (!r->n || last - first >= YEARS_MAX)
        return wf_fail(e, WF_EINPUT, "%s: no rows with a date and a speed, or more than %d years", out->file,
                       YEARS_MAX);
    out->n = (size_t)(last - first) + 1;
    if (!take_years(out, out->n, a)) return wf_fail(e, WF_ENOMEM, "not enough memory for the years");
    for (size_t i = 0; i < out->n; i++) out->year[i] = (struct wf_annual_year){ .year = first + (int)i };
    for (size_t i = 0; i < r->n; i++) {
        struct wf_annual_year *y = &out->year[year_of(clock, r->beside[i], q->begins) - first];
        if (isnan(r->value[i])) continue;
        y->rows++;
        y->largest = fmax(y->largest, factor * r->value[i]);
    }
    return WF_OK;
}

/* Leave out years with few rows, and say which; a storm in one of them is said apart. */
static void leave_short_years(const struct wf_annual_request *q, struct wf_annual *out, struct wf_diag *d)
{
    size_t most = 0, left = 0;
    double storm = 0, kept = 0;
    char list[200] = "";
    for (size_t i = 0; i < out->n; i++) most = out->year[i].rows > most ? out->year[i].rows : most;
    for (size_t i = 0; i < out->n; i++) {
        struct wf_annual_year *y = &out->year[i];
        size_t n = strlen(list);
        y->used = (double)y->rows >= q->least * (double)most && y->largest > 0;
        *(y->used ? &kept : &storm) = fmax(y->used ? kept : storm, y->largest);
        if (y->used) continue;
        left++;
        (void)snprintf(list + n, sizeof list - n, "%s%d", n ? ", " : "", y->year);
    }
    if (left)
        wf_diag_warn(d, "year-short",
                     "%s: %zu years have fewer than %g %% of the rows of the fullest and are left out: %s",
                     out->file, left, 100 * q->least, list);
    if (storm > kept)
        wf_diag_warn(d, "storm-left-out",
                     "%s: the largest wind of the record, %.1f m/s, is in a year that is left out; the "
                     "extremes are too low. "
                     "Give the largest wind of each year as a table in which it is included",
                     out->file, storm);
}

enum wf_status wf_annual_from_record(const char *path, const struct wf_annual_request *q, struct wf_arena *a,
                                     struct wf_diag *d, struct wf_annual *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    struct wf_readings r = { 0 };
    struct wf_clock clock = { .dates = q->dates };
    struct wf_err found = { 0 };
    size_t errors = d->errors;
    double factor = 1;
    int year, month;
    *out = (struct wf_annual){ .file = path, .step = NAN };
    enum wf_status s = wf_csv_open(&csv, path, a, d, &found);
    if (!s) s = read_rows(&csv, q, &clock, &factor, &r, &found);
    if (!s && d->errors > errors) s = wf_fail(&found, WF_EINPUT, "%s: the record cannot be used", path);
    if (!s)
        s = wf_clock_settle(&clock, path, "--dates day-first or --dates month-first", r.beside, r.n, &found);
    if (!s && r.n && !wf_clock_date(&clock, r.beside[0], &year, &month))
        s = wf_fail(&found, WF_EINPUT, "%s: its times are not dates; the year of a row is needed", path);
    if (!s) s = sort_into_years(&r, &clock, factor, q, a, out, &found);
    if (!s) out->step = median_step(&r), leave_short_years(q, out, d), use_years(out);
    wf_readings_free(&r);
    return s ? wf_fail(e, s, "%s", found.text) : WF_OK;
}
