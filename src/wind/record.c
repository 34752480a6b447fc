/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/record.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* No anemometer has measured more near the ground than 113 m/s (Barrow Island 1996, WMO); the fastest wind
 * that a user can vouch for, and the fastest one taken as a wind without being vouched for [m/s]. */
static const double VOUCHED_MAX = 120.0;

void wf_record_request_default(struct wf_record_request *q)
{
    *q = (struct wf_record_request){
        .time = "t_s", .part = { "u_ms", "v_ms", "w_ms" }, .step = NAN, .bad_share = 0.05, .gap = 5.0
    };
}

/* The rows of the file, read before the step is known. */
struct record_rows {
    size_t n, room;
    double *time;    /* NAN: unreadable */
    double *part[3]; /* NAN: unreadable */
    size_t *line;
    size_t first_line, first_column; /* first unreadable cell */
    char first_text[40];
    size_t column[3];
    double factor[3]; /* of the columns, to m/s */
};

static void free_rows(struct record_rows *r)
{
    free(r->time);
    free(r->line);
    for (int k = 0; k < 3; k++) free(r->part[k]);
}

static bool grow_rows(struct record_rows *r)
{
    size_t room = r->room ? 2 * r->room : 4096;
    double *t = realloc(r->time, room * sizeof *t);
    if (t) r->time = t;
    size_t *l = realloc(r->line, room * sizeof *l);
    if (l) r->line = l;
    bool good = t && l;
    for (int k = 0; k < 3; k++) {
        double *p = realloc(r->part[k], room * sizeof *p);
        if (p) r->part[k] = p;
        good = good && p;
    }
    if (good) r->room = room;
    return good;
}

/* Keep the place and text of the first unreadable cell for messages. */
static void note_unreadable(struct record_rows *r, const struct wf_cell *cell)
{
    if (r->first_line) return;
    r->first_line = cell->line, r->first_column = cell->column;
    strncpy(r->first_text, cell->size ? cell->text : "(empty)", sizeof r->first_text - 1);
}

/* A number with another decimal sign than those before it is a mistake of the file, not a gap. */
static void report_mixed(struct wf_csv *c, size_t column, enum wf_csv_kind kind)
{
    if (kind == WF_CSV_MIXED)
        wf_csv_mistake(c, column, "'%.40s': decimal comma and decimal point are mixed in this file",
                       wf_csv_text(c, column));
}

/* Read a wind in the column's own unit. Returned: NAN for an unreadable cell. */
static double read_reading(struct record_rows *r, struct wf_csv *c, size_t column)
{
    double value;
    enum wf_csv_kind kind = wf_csv_reading(c, column, &value);
    if (kind == WF_CSV_NUMBER) return value;
    report_mixed(c, column, kind);
    note_unreadable(r, &c->cell[column]);
    return NAN;
}

/* Find the columns and their units. */
static enum wf_status find_columns(const struct wf_record_request *q, struct wf_csv *c, struct record_rows *r,
                                   struct wf_clock *clock, size_t *time, struct wf_err *e)
{
    struct wf_units *u = NULL;
    enum wf_status s = wf_units_open(&u, e);
    if (s) return s;
    *time = q->time ? wf_csv_need(c, q->time) : WF_CSV_NONE;
    for (int k = 0; k < 3; k++) {
        r->column[k] = q->part[k] ? wf_csv_need(c, q->part[k]) : WF_CSV_NONE;
        r->factor[k] = 1.0;
        if (r->column[k] != WF_CSV_NONE)
            (void)wf_column_factor(c, u, r->column[k], WF_DIM_SPEED, "m/s", &r->factor[k], e);
    }
    size_t stem;
    if (*time != WF_CSV_NONE && !wf_name_unit(u, c->name[*time].text, WF_DIM_TIME, &clock->factor, &stem, e))
        clock->factor = 0.0; /* dates have none; of numbers it is said when they are read */
    wf_units_close(u);
    if (e && e->code) return e->code;
    return c->mistakes ? wf_fail(e, WF_EINPUT, "%s: a specified column cannot be used", c->file) : WF_OK;
}

/* Read a row's time. A cell that is no time is unreadable like any other; the mistakes that the clock reports
 * are kept out of the list until it is known whether the rows are too many. */
static double read_time(struct record_rows *r, struct wf_csv *c, struct wf_clock *clock, size_t column)
{
    double t;
    struct wf_diag *shown = c->diag, own = { .arena = shown->arena };
    size_t mistakes = c->mistakes;
    c->diag = &own;
    bool good = wf_clock_read(clock, c, column, &t);
    c->diag = shown;
    c->mistakes = mistakes;
    if (good) return t;
    report_mixed(c, column, wf_csv_value(c, column, &t));
    note_unreadable(r, &c->cell[column]);
    return NAN;
}

static enum wf_status read_cells(const struct wf_record_request *q, struct wf_csv *c, struct record_rows *r,
                                 struct wf_err *e)
{
    struct wf_clock clock = { .dates = q->dates };
    size_t time;
    enum wf_status s = find_columns(q, c, r, &clock, &time, e);
    if (s) return s;
    while (wf_csv_next(c)) {
        if (r->n == r->room && !grow_rows(r))
            return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", c->file);
        r->time[r->n] = q->time ? read_time(r, c, &clock, time) : (double)r->n * q->step;
        for (int k = 0; k < 3; k++) r->part[k][r->n] = q->part[k] ? read_reading(r, c, r->column[k]) : 0.0;
        r->line[r->n++] = c->row_line;
    }
    if (c->mistakes) return wf_fail(e, WF_EINPUT, "%s: unusable rows", c->file);
    if (r->n < 2) return wf_fail(e, WF_EINPUT, "%s: %zu rows; a record needs at least 2", c->file, r->n);
    wf_clock_say_unit(&clock, c, time);
    return wf_clock_settle(&clock, c->file, "--dates day-first or --dates month-first (key dates)", r->time,
                           r->n, e);
}

/* Find the missing marks of component k and convert it to m/s. */
static enum wf_status strike_marks(const struct wf_record_request *q, struct wf_csv *c, struct record_rows *r,
                                   int k, bool alone, struct wf_err *e)
{
    const char *name = c->name[r->column[k]].text;
    static const char *const how[] = { "Say --missing ",
                                       " if it means that there is no reading, or --missing none if every "
                                       "number is a wind (in a study the key missing)" };
    size_t struck;
    enum wf_status s =
        wf_marks_strike(c, r->column[k], r->factor[k], q->missing && !strcmp(q->missing, "none"), alone,
                        r->part[k], r->line, r->n, how, &struck, e);
    if (s) return s;
    for (size_t i = 0; i < r->n; i++) {
        r->part[k][i] *= r->factor[k];
        if (fabs(r->part[k][i]) > VOUCHED_MAX)
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: column '%s': %.4g m/s is not a wind; the limit is %g m/s", c->file,
                           r->line[i], name, r->part[k][i], VOUCHED_MAX);
    }
    return WF_OK;
}

static enum wf_status read_rows(const char *path, const struct wf_record_request *q, struct wf_arena *a,
                                struct wf_diag *d, struct record_rows *r, struct wf_record *out,
                                struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    enum wf_status s = wf_csv_open(&csv, path, a, d, e);
    if (s) return s;
    if (q->missing && strcmp(q->missing, "none") != 0 && !wf_csv_declare(&csv, q->missing))
        return wf_fail(e, WF_EUSAGE, "missing marks '%s': 'none' or at most %d numbers, separated by commas",
                       q->missing, (int)WF_CSV_MARKS);
    if ((s = read_cells(q, &csv, r, e))) return s;
    for (int k = 0; k < 3 && !s; k++)
        if (q->part[k]) s = strike_marks(q, &csv, r, k, out->components == 1, e);
    if (s) return s;
    out->rows = r->n;
    for (size_t i = 0; i < r->n; i++) {
        bool bad = isnan(r->time[i]) || isnan(r->part[0][i]) || isnan(r->part[1][i]) || isnan(r->part[2][i]);
        if (bad && !r->first_line) r->first_line = r->line[i], strcpy(r->first_text, "missing mark");
        out->unreadable += bad;
    }
    if ((double)out->unreadable > q->bad_share * (double)r->n)
        return wf_fail(
            e, WF_EINPUT,
            "%s:%zu:%zu: error: %zu of %zu rows have a cell that is empty, not a number or a missing mark "
            "(first: '%s'); at most %g %% are interpolated",
            path, r->first_line, r->first_column, out->unreadable, r->n, r->first_text, 100.0 * q->bad_share);
    return WF_OK;
}

/* The even step: the median of the differences between readable times. */
static enum wf_status find_step(const char *path, struct record_rows *r, struct wf_record *out,
                                struct wf_err *e)
{
    double *gap = malloc(r->n * sizeof *gap), before = NAN;
    size_t n = 0;
    if (!gap) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", path);
    for (size_t i = 0; i < r->n; i++) {
        if (isnan(r->time[i])) continue;
        if (!isnan(before)) {
            gap[n] = r->time[i] - before;
            if (!(gap[n++] > 0.0)) {
                free(gap);
                return wf_fail(e, WF_EINPUT,
                               "%s:%zu: error: time %.10g s is not after the row before, %.10g s", path,
                               r->line[i], r->time[i], before);
            }
        }
        before = r->time[i];
    }
    if (n) qsort(gap, n, sizeof *gap, wf_ascending);
    out->step = n ? gap[n / 2] : NAN;
    free(gap);
    return n ? WF_OK : wf_fail(e, WF_EINPUT, "%s: no two readable times", path);
}

/* Copy the rows to the steps of their times; steps without a row are NAN. */
static enum wf_status rows_to_steps(const char *path, struct record_rows *r, struct wf_record *out,
                                    double *to[3], struct wf_err *e)
{
    size_t first = 0, before = (size_t)-1;
    while (isnan(r->time[first])) first++;
    for (size_t i = 0; i < 3 * out->n; i++) to[i / out->n][i % out->n] = NAN;
    for (size_t i = first; i < r->n; i++) {
        if (isnan(r->time[i])) continue;
        size_t at = (size_t)llround((r->time[i] - r->time[first]) / out->step);
        if (at == before)
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: time %.10g s lies within the %g s step of the row before", path,
                           r->line[i], r->time[i], out->step);
        before = at;
        if (isnan(r->part[0][i]) || isnan(r->part[1][i]) || isnan(r->part[2][i])) continue;
        for (int k = 0; k < 3; k++) to[k][at] = r->part[k][i];
    }
    return WF_OK;
}

/* Fill gaps by linear interpolation; a gap at an end of the record by the nearest value. */
static enum wf_status bridge_gaps(const char *path, const struct wf_record_request *q, struct wf_record *out,
                                  double *to[3], struct wf_err *e)
{
    size_t n = out->n, empty = 0;
    for (size_t i = 0; i < n; i++) empty += isnan(to[0][i]) ? 1 : 0;
    if ((double)empty > q->bad_share * (double)n)
        return wf_fail(e, WF_EINPUT,
                       "%s: %zu of %zu steps of %g s have no reading; at most %g %% are interpolated", path,
                       empty, n, out->step, 100.0 * q->bad_share);
    for (size_t i = 0; i < n;) {
        if (!isnan(to[0][i])) {
            i++;
            continue;
        }
        size_t end = i;
        while (end < n && isnan(to[0][end])) end++;
        if ((double)(end - i) * out->step > q->gap)
            return wf_fail(
                e, WF_EINPUT,
                "%s: no reading from %.10g s to %.10g s after the start; gaps up to %g s are interpolated",
                path, (double)i * out->step, (double)end * out->step, q->gap);
        for (int k = 0; k < 3; k++)
            for (size_t j = i; j < end; j++) {
                double left = i ? to[k][i - 1] : to[k][end], right = end < n ? to[k][end] : left;
                to[k][j] = left + (right - left) * (double)(j - i + 1) / (double)(end - i + 1);
            }
        out->gaps++;
        out->missing += end - i;
        if (end - i > out->longest) out->longest = end - i;
        i = end;
    }
    return WF_OK;
}

static void rotate_components(double *a, double *b, size_t n, double angle)
{
    double c = cos(angle), s = sin(angle);
    for (size_t i = 0; i < n; i++) {
        double x = a[i] * c + b[i] * s;
        b[i] = b[i] * c - a[i] * s;
        a[i] = x;
    }
}

static double mean_of(const double *x, size_t n)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += x[i];
    return sum / (double)n;
}

enum wf_status wf_record_read(const char *path, const struct wf_record_request *q, struct wf_arena *a,
                              struct wf_diag *d, struct wf_record *out, struct wf_err *e)
{
    struct record_rows r = { 0 };
    double *to[3] = { NULL, NULL, NULL };
    memset(out, 0, sizeof *out);
    out->file = path;
    out->components = q->part[2] ? 3 : q->part[1] ? 2 : 1;
    if (!q->time && !(q->step > 0.0))
        return wf_fail(e, WF_EUSAGE,
                       "%s: a record without a time column needs its rate: --rate (key rate), for "
                       "example 20 Hz",
                       path);
    enum wf_status s = read_rows(path, q, a, d, &r, out, e);
    if (!s) s = find_step(path, &r, out, e);
    if (!s) {
        size_t first = 0, last = r.n - 1;
        while (isnan(r.time[first])) first++;
        while (isnan(r.time[last])) last--;
        double steps = (r.time[last] - r.time[first]) / out->step;
        if (steps > 1.0 / fmax(1.0 - q->bad_share, 1e-3) * (double)r.n + 2.0 * q->gap / out->step + 2.0)
            s = wf_fail(e, WF_EINPUT, "%s: %zu rows cover %.0f steps of %g s; at most %g %% may be missing",
                        path, r.n, steps + 1.0, out->step, 100.0 * q->bad_share);
        else
            out->n = (size_t)llround(steps) + 1;
    }
    for (int k = 0; k < 3 && !s; k++)
        if (!(to[k] = WF_TAKE(a, out->n, double)))
            s = wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", path);
    if (!s) s = rows_to_steps(path, &r, out, to, e);
    free_rows(&r);
    if (!s) s = bridge_gaps(path, q, out, to, e);
    if (s) return s;
    out->azimuth = atan2(mean_of(to[1], out->n), mean_of(to[0], out->n));
    rotate_components(to[0], to[1], out->n, out->azimuth);
    out->tilt = atan2(mean_of(to[2], out->n), mean_of(to[0], out->n));
    rotate_components(to[0], to[2], out->n, out->tilt);
    out->u = to[0];
    out->v = q->part[1] ? to[1] : NULL;
    out->w = q->part[2] ? to[2] : NULL;
    out->mean = mean_of(to[0], out->n);
    return WF_OK;
}
