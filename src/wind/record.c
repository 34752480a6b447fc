/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/record.h"
#include "base/csv.h"
#include "base/num.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void wf_record_request_default(struct wf_record_request *q)
{
    *q = (struct wf_record_request){
        .time = "t_s", .part = { "u_ms", "v_ms", "w_ms" }, .bad_share = 0.05, .gap = 2.0, .speed_max = 100.0
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

/* Read a number. Returned: NAN for an unreadable cell; the place of the first one is kept for messages. */
static double read_reading(struct record_rows *r, struct wf_csv *c, size_t column, double limit)
{
    double value = NAN;
    const struct wf_cell *cell = &c->cell[column];
    const char *end = wf_number_read(cell->text, cell->text + cell->size,
                                     c->separator == ',' ? '.'
                                     : c->point          ? c->point
                                                         : '.',
                                     &value);
    if (end && end == cell->text + cell->size && cell->size && fabs(value) <= limit) return value;
    if (!r->first_line) {
        r->first_line = cell->line, r->first_column = cell->column;
        strncpy(r->first_text, cell->size ? cell->text : "(empty)", sizeof r->first_text - 1);
    }
    return NAN;
}

static enum wf_status read_rows(const char *path, const struct wf_record_request *q, struct wf_arena *a,
                                struct wf_diag *d, struct record_rows *r, struct wf_record *out,
                                struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    size_t errors = d->errors, column[3], time = WF_CSV_NONE;
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    if (q->time) time = wf_csv_need(&csv, q->time);
    for (int k = 0; k < 3; k++) column[k] = q->part[k] ? wf_csv_need(&csv, q->part[k]) : WF_CSV_NONE;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: a specified column is missing", path);
    while (wf_csv_next(&csv)) {
        if (r->n == r->room && !grow_rows(r))
            return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", path);
        bool bad = false;
        r->time[r->n] = q->time ? read_reading(r, &csv, time, 1e15) : (double)r->n * q->step;
        bad = isnan(r->time[r->n]);
        for (int k = 0; k < 3; k++) {
            r->part[k][r->n] = q->part[k] ? read_reading(r, &csv, column[k], q->speed_max) : 0.0;
            bad = bad || isnan(r->part[k][r->n]);
        }
        r->line[r->n++] = csv.row_line;
        out->unreadable += bad;
    }
    out->rows = r->n;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: unusable rows", path);
    if (r->n < 2) return wf_fail(e, WF_EINPUT, "%s: %zu rows; a record needs at least 2", path, r->n);
    if ((double)out->unreadable > q->bad_share * (double)r->n)
        return wf_fail(
            e, WF_EINPUT,
            "%s:%zu:%zu: error: %zu of %zu rows have a cell that is empty, not a number or beyond %g "
            "m/s (first: '%s'); at most %g %% are interpolated",
            path, r->first_line, r->first_column, out->unreadable, r->n, q->speed_max, r->first_text,
            100.0 * q->bad_share);
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
        return wf_fail(e, WF_EUSAGE, "%s: a record without a time column needs its step", path);
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
