/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/test_data.h"
#include "base/yaml.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Indices of the columns, and their factors. */
struct plan {
    size_t time, *at, *only;
    struct wf_clock clock;
    double *factor;
};

static enum wf_status prepare(struct wf_csv *c, const struct wf_column *column, size_t n,
                              const struct wf_test_rows *how, struct plan *p, struct wf_arena *a,
                              struct wf_err *e)
{
    struct wf_units *u;
    struct wf_err timeless = { 0 };
    size_t stem;
    p->at = WF_TAKE(a, n, size_t), p->only = WF_TAKE(a, how->onlys, size_t),
    p->factor = WF_TAKE(a, n, double);
    if (!p->at || !p->only || !p->factor)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu columns", n);
    enum wf_status status = wf_units_open(&u, e);
    if (status) return status;
    p->time = how->time ? wf_csv_need(c, how->time) : WF_CSV_NONE;
    p->clock = (struct wf_clock){ .dates = how->dates };
    if (how->time && !wf_name_unit(u, how->time, WF_DIM_TIME, &p->clock.factor, &stem, &timeless))
        p->clock.factor = 0.0;
    if (timeless.code) status = wf_fail(e, timeless.code, "%s", timeless.text);
    for (size_t k = 0; k < n && !status; k++) {
        struct wf_err why = { 0 };
        struct wf_column own = column[k];
        p->at[k] = wf_csv_need(c, column[k].name);
        if (p->at[k] == WF_CSV_NONE) continue;
        if (!own.unit && c->unit && *c->unit[p->at[k]]) own.unit = c->unit[p->at[k]];
        if (wf_column_unit(u, &own, &p->factor[k], &why) == WF_ENOMEM)
            status = wf_fail(e, WF_ENOMEM, "%s", why.text);
        else if (why.code)
            wf_csv_report(c, c->name[p->at[k]].line, c->name[p->at[k]].column, why.text);
    }
    for (size_t k = 0; k < how->onlys; k++) p->only[k] = wf_csv_need(c, how->only[k].key);
    wf_units_close(u);
    if (status) return status;
    return c->mistakes ? wf_fail(e, WF_EINPUT, "%s: its columns do not fit the study", c->file) : WF_OK;
}

static bool wanted_row(const struct wf_csv *c, const struct wf_test_rows *how, const struct plan *p)
{
    for (size_t k = 0; k < how->onlys; k++)
        if (strcmp(wf_csv_text(c, p->only[k]), how->only[k].text) != 0) return false;
    return true;
}

/* Read the numbers of the current row in the file's units. Returned: false when one is missing or a mistake
 * was reported. */
static bool read_numbers(struct wf_csv *c, const struct wf_test_rows *how, struct plan *p, size_t columns,
                         double *t, double *v, size_t *missing)
{
    double spare;
    bool empty = how->time && wf_csv_value(c, p->time, &spare) == WF_CSV_MISSING, good = true;
    for (size_t k = 0; k < columns; k++) empty |= wf_csv_reading(c, p->at[k], &v[k]) == WF_CSV_MISSING;
    *missing += empty;
    if (empty) return false;
    if (how->time) good = wf_clock_read(&p->clock, c, p->time, t);
    for (size_t k = 0; k < columns; k++) good &= wf_csv_number(c, p->at[k], -1e15, 1e15, &v[k]);
    return good;
}

/* Strike out the missing marks of a wind, column k. */
static enum wf_status strike_marks(struct wf_csv *c, const struct plan *p, size_t k,
                                   const struct wf_test_rows *how, struct wf_test_data *r, struct wf_arena *a,
                                   struct wf_err *e)
{
    static const char *const say[] = { "Give the test 'missing: \"",
                                       "\"' if it means that there is no reading, or 'missing: none'" };
    size_t struck;
    double *value = WF_TAKE(a, r->n, double);
    if (!value) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", c->file);
    for (size_t i = 0; i < r->n; i++) value[i] = r->value[i * r->columns + k];
    enum wf_status s =
        wf_marks_strike(c, p->at[k], p->factor[k], how->missing && !strcmp(how->missing, "none"), true, value,
                        r->line, r->n, say, &struck, e);
    if (s) return s;
    size_t kept = 0;
    for (size_t i = 0; i < r->n; i++) {
        if (isnan(value[i])) continue;
        r->time[kept] = r->time[i], r->line[kept] = r->line[i];
        memmove(r->value + kept++ * r->columns, r->value + i * r->columns, r->columns * sizeof *r->value);
    }
    r->missing += r->n - kept;
    r->n = kept;
    return WF_OK;
}

/* Settle the order of day and month, strike missing marks, convert to SI. */
static enum wf_status finish_rows(struct wf_csv *c, const struct wf_column *column,
                                  const struct wf_test_rows *how, struct plan *p, struct wf_test_data *r,
                                  struct wf_arena *a, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    if (how->time) {
        wf_clock_say_unit(&p->clock, c, p->time);
        s = wf_clock_settle(&p->clock, c->file, "'dates: day-first' or 'dates: month-first' in the test",
                            r->time, r->n, e);
    }
    for (size_t k = 0; k < r->columns && !s; k++)
        if (column[k].dimension == WF_DIM_SPEED) s = strike_marks(c, p, k, how, r, a, e);
    double first = r->n ? r->time[0] : 0;
    for (size_t i = 0; i < r->n && !s; i++) {
        r->time[i] -= first;
        r->used[i] = true;
        if (i && r->time[i] < r->time[i - 1]) {
            char text[128];
            (void)snprintf(text, sizeof text, "%.60s: time goes backwards: %.6g s after %.6g s", how->time,
                           r->time[i], r->time[i - 1]);
            wf_csv_report(c, r->line[i], 0, text);
        }
        for (size_t k = 0; k < r->columns; k++) r->value[i * r->columns + k] *= p->factor[k];
    }
    return s;
}

enum wf_status wf_test_data_read(const char *path, const struct wf_column *column, size_t columns,
                                 const struct wf_test_rows *how, struct wf_arena *a, struct wf_test_data *out,
                                 struct wf_diag *d, struct wf_err *e)
{
    struct wf_csv c;
    struct plan p;
    enum wf_status status = wf_csv_open(&c, path, a, d, e);
    if (status) return status;
    if (how->missing && strcmp(how->missing, "none") != 0 && !wf_csv_declare(&c, how->missing))
        return wf_fail(e, WF_EINPUT, "%s: missing: '%s': 'none' or at most %d numbers, separated by commas",
                       path, how->missing, (int)WF_CSV_MARKS);
    if ((status = prepare(&c, column, columns, how, &p, a, e))) return status;
    size_t most = 1;
    for (const char *q = c.at; q < c.end; q++) most += *q == '\n' || *q == '\r';
    *out = (struct wf_test_data){ .columns = columns,
                                  .time = WF_TAKE(a, most, double),
                                  .line = WF_TAKE(a, most, size_t),
                                  .value = WF_TAKE(a, most * columns, double),
                                  .used = WF_TAKE(a, most, bool) };
    if (!out->time || !out->line || !out->value || !out->used)
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", path);
    for (size_t row = 0; wf_csv_next(&c);) {
        double t = (double)row / (how->rate > 0 ? how->rate : 1.0);
        if (!wanted_row(&c, how, &p)) continue;
        row++;
        if (!read_numbers(&c, how, &p, columns, &t, out->value + out->n * columns, &out->missing)) continue;
        out->time[out->n] = t;
        out->line[out->n++] = c.row_line;
    }
    if (!c.mistakes && (status = finish_rows(&c, column, how, &p, out, a, e))) return status;
    if (c.mistakes)
        return wf_fail(e, WF_EINPUT, "%s: %zu mistake%s", path, c.mistakes, c.mistakes == 1 ? "" : "s");
    if (!out->n && !out->missing)
        return wf_fail(e, WF_EINPUT, "%s: no row %s", path,
                       how->onlys ? "matches 'rows'" : "follows the header");
    if (!out->n)
        return wf_fail(e, WF_EINPUT,
                       "%s: no row%s has numbers in every column; %zu rows had an empty or NA cell", path,
                       how->onlys ? " that matches 'rows'" : "", out->missing);
    return WF_OK;
}

enum wf_status wf_loading_branch(struct wf_test_data *r, size_t column, double from, double to,
                                 const char *name, struct wf_err *e)
{
    const double slack = 0.02;
    size_t peak = 0, left = 0, m = r->columns;
    double reached = 0;
    for (size_t i = 0; i < r->n; i++)
        if (r->used[i] && (!r->used[peak] || r->value[i * m + column] > r->value[peak * m + column]))
            peak = i;
    double top = r->value[peak * m + column];
    if (!(top > 0)) return wf_fail(e, WF_EINPUT, "test %s: the force is zero or negative throughout", name);
    for (size_t i = 0; i < r->n; i++) {
        double f = r->value[i * m + column];
        bool rising = r->used[i] && i <= peak && f >= reached - slack * top;
        if (r->used[i]) reached = fmax(reached, f);
        r->used[i] = rising && f >= from * top && f <= to * top;
        left += r->used[i];
    }
    if (left < 3)
        return wf_fail(
            e, WF_EINPUT,
            "test %s: only %zu row%s of the first loading between %g and %g of the largest force; a "
            "fit needs 3",
            name, left, left == 1 ? "" : "s", from, to);
    return WF_OK;
}
