/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/test_data.h"
#include "base/num.h"
#include "base/yaml.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Dimensionless units that UDUNITS does not convert to a plain number. */
static bool part_of_one(const char *unit, double *factor)
{
    static const struct {
        const char *name;
        double factor;
    } known[] = { { "um_m", 1e-6 },    { "um/m", 1e-6 }, { "microstrain", 1e-6 }, { "ustrain", 1e-6 },
                  { "ppm", 1e-6 },     { "mm_m", 1e-3 }, { "mm/m", 1e-3 },        { "permille", 1e-3 },
                  { "percent", 1e-2 }, { "%", 1e-2 } };
    for (size_t i = 0; i < WF_COUNT(known); i++)
        if (!strcmp(unit, known[i].name)) {
            *factor = known[i].factor;
            return true;
        }
    return false;
}

enum wf_status wf_column_unit(struct wf_units *u, const struct wf_test_column *c, double *factor,
                              struct wf_err *e)
{
    char text[80];
    struct wf_err why = { 0 };
    const struct wf_dimension_row *row = wf_dimension_row(c->dimension);
    if (c->dimension == WF_DIM_NONE) {
        *factor = 1;
        if (c->unit && !part_of_one(c->unit, factor))
            return wf_fail(e, WF_EINPUT,
                           "column '%s': the unit '%s' is not a part of one; known are um/m, mm/m, ppm, %%",
                           c->name, c->unit);
        for (const char *t = strchr(c->name, '_'); t && !c->unit; t = strchr(t + 1, '_'))
            if (part_of_one(t + 1, factor)) break;
        return WF_OK;
    }
    if (c->unit) {
        snprintf(text, sizeof text, "1 %.60s", c->unit);
        if (!wf_quantity_read(u, text, c->dimension, factor, &why)) return WF_OK;
        return wf_fail(e, why.code, "column '%s': the unit '%s': %s", c->name, c->unit, why.text);
    }
    /* the longest suffix that is a unit: m_s is m/s, kN_m is kN m */
    static const char joint[] = { '/', ' ' };
    const char *tail = strchr(c->name, '_');
    for (; tail; tail = strchr(tail + 1, '_'))
        for (int k = 0; k < 2; k++) {
            snprintf(text, sizeof text, "1 %.60s", tail + 1);
            for (char *p = text + 2; *p; p++)
                if (*p == '_') *p = joint[k];
            if (!tail[1]) continue;
            why = (struct wf_err){ 0 };
            if (!wf_quantity_read(u, text, c->dimension, factor, &why)) return WF_OK;
            if (why.code == WF_ENOMEM) return wf_fail(e, WF_ENOMEM, "column '%s': %s", c->name, why.text);
        }
    tail = strrchr(c->name, '_');
    bool mass = c->dimension == WF_DIM_FORCE && tail && !strcasecmp(tail + 1, "kg");
    int stem = mass ? (int)(tail - c->name) : (int)strlen(c->name);
    return wf_fail(
        e, WF_EINPUT,
        "column '%s' does not end in a unit of %s%s; name it for example '%.*s_%s', or give 'unit'", c->name,
        row->name + (!strncmp(row->name, "a ", 2)    ? 2
                     : !strncmp(row->name, "an ", 3) ? 3
                                                     : 0),
        mass ? " (kg is a mass; a force read off a scale in kg is kgf)" : "", stem > 40 ? 40 : stem, c->name,
        mass ? "kgf" : row->si);
}

static bool missing(const char *t)
{
    static const char *const words[] = { "", "NA", "NaN", "null", "-", "#N/A", "n/a" };
    for (size_t i = 0; i < WF_COUNT(words); i++)
        if (!strcasecmp(t, words[i])) return true;
    return false;
}

/* Days since 1970-01-01 of the Gregorian calendar (Fliegel and Van Flandern 1968). */
static double day(int y, int m, int d)
{
    int shift = (m - 14) / 12;
    long j = d - 32075L + 1461L * (y + 4800 + shift) / 4 + 367L * (m - 2 - shift * 12) / 12 -
             3L * ((y + 4900 + shift) / 100) / 4;
    return (double)(j - 2440588L);
}

static bool time_of(struct wf_csv *c, size_t column, double factor, double *t)
{
    int y, mo, d, h, mi, used = 0;
    double s;
    const char *text = wf_csv_text(c, column);
    if (sscanf(text, "%4d-%2d-%2d%*1[T ]%2d:%2d:%lf%n", &y, &mo, &d, &h, &mi, &s, &used) == 6 && used > 15) {
        *t = 86400 * day(y, mo, d) + 3600.0 * h + 60.0 * mi + s;
        return true;
    }
    if (!wf_csv_number(c, column, -1e12, 1e12, t)) return false;
    *t *= factor;
    return true;
}

/* Indices of the columns, and their factors. */
struct plan {
    size_t time, *at, *only;
    double time_factor, *factor;
};

static enum wf_status prepare(struct wf_csv *c, const struct wf_test_column *column, size_t n,
                              const char *time, const struct wf_yaml_pair *only, size_t onlys, struct plan *p,
                              struct wf_arena *a, struct wf_err *e)
{
    struct wf_units *u;
    p->at = WF_TAKE(a, n, size_t), p->only = WF_TAKE(a, onlys, size_t), p->factor = WF_TAKE(a, n, double);
    if (!p->at || !p->only || !p->factor)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu columns", n);
    enum wf_status status = wf_units_open(&u, e);
    if (status) return status;
    p->time = time ? wf_csv_need(c, time) : WF_CSV_NONE;
    p->time_factor = 1;
    struct wf_test_column clock = { time, NULL, WF_DIM_TIME };
    struct wf_err clockless = { 0 };
    if (time && wf_column_unit(u, &clock, &p->time_factor, &clockless) == WF_ENOMEM)
        status = wf_fail(e, WF_ENOMEM, "%s", clockless.text);
    for (size_t k = 0; k < n && !status; k++) {
        struct wf_err why = { 0 };
        p->at[k] = wf_csv_need(c, column[k].name);
        if (p->at[k] == WF_CSV_NONE) continue;
        if (wf_column_unit(u, &column[k], &p->factor[k], &why) == WF_ENOMEM)
            status = wf_fail(e, WF_ENOMEM, "%s", why.text);
        else if (why.code)
            wf_csv_report(c, c->name[p->at[k]].line, c->name[p->at[k]].column, why.text);
    }
    for (size_t k = 0; k < onlys; k++) p->only[k] = wf_csv_need(c, only[k].key);
    wf_units_close(u);
    if (status) return status;
    return c->mistakes ? wf_fail(e, WF_EINPUT, "%s: its columns do not fit the study", c->file) : WF_OK;
}

enum wf_status wf_test_data_read(const char *path, const struct wf_test_column *column, size_t columns,
                                 const char *time, const struct wf_yaml_pair *only, size_t onlys,
                                 struct wf_arena *a, struct wf_test_data *out, struct wf_diag *d,
                                 struct wf_err *e)
{
    struct wf_csv c;
    struct plan p;
    enum wf_status status = wf_csv_open(&c, path, a, d, e);
    if (status || (status = prepare(&c, column, columns, time, only, onlys, &p, a, e))) return status;
    size_t most = 1;
    for (const char *q = c.at; q < c.end; q++) most += *q == '\n' || *q == '\r';
    *out = (struct wf_test_data){ .columns = columns,
                                  .time = WF_TAKE(a, most, double),
                                  .line = WF_TAKE(a, most, size_t),
                                  .value = WF_TAKE(a, most * columns, double),
                                  .used = WF_TAKE(a, most, bool) };
    if (!out->time || !out->line || !out->value || !out->used)
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", path);
    double first = NAN;
    while (wf_csv_next(&c)) {
        bool wanted = true, empty = time && missing(wf_csv_text(&c, p.time)), good = true;
        for (size_t k = 0; k < onlys; k++) wanted &= !strcmp(wf_csv_text(&c, p.only[k]), only[k].text);
        for (size_t k = 0; k < columns; k++) empty |= missing(wf_csv_text(&c, p.at[k]));
        if (wanted && empty) out->missing++;
        if (!wanted || empty) continue;
        double *v = out->value + out->n * columns, t = (double)out->n;
        if (time) good = time_of(&c, p.time, p.time_factor, &t);
        for (size_t k = 0; k < columns; k++) {
            good &= wf_csv_number(&c, p.at[k], -1e15, 1e15, &v[k]);
            v[k] *= p.factor[k];
        }
        if (!good) continue;
        if (isnan(first)) first = t;
        t -= first;
        if (out->n && t < out->time[out->n - 1])
            wf_csv_mistake(&c, p.time, "time goes backwards: %.6g s after %.6g s", t, out->time[out->n - 1]);
        out->time[out->n] = t;
        out->line[out->n] = c.row_line;
        out->used[out->n++] = true;
    }
    if (c.mistakes)
        return wf_fail(e, WF_EINPUT, "%s: %zu mistake%s", path, c.mistakes, c.mistakes == 1 ? "" : "s");
    if (!out->n && !out->missing)
        return wf_fail(e, WF_EINPUT, "%s: no row %s", path, onlys ? "matches 'rows'" : "follows the header");
    if (!out->n)
        return wf_fail(e, WF_EINPUT,
                       "%s: no row%s has numbers in every column; %zu rows had an empty or NA cell", path,
                       onlys ? " that matches 'rows'" : "", out->missing);
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
