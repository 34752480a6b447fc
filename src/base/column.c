/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/column.h"
#include "base/num.h"
#include "base/text.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Units. */

/* Dimensionless units that UDUNITS does not convert to a plain number. */
static bool part_of_one(const char *unit, double *factor)
{
    static const struct {
        const char *name;
        double factor;
    } known[] = { { "um_m", 1e-6 },        { "um/m", 1e-6 },        { "\xC2\xB5m/m", 1e-6 },
                  { "\xCE\xBCm/m", 1e-6 }, { "microstrain", 1e-6 }, { "ustrain", 1e-6 },
                  { "ppm", 1e-6 },         { "mm_m", 1e-3 },        { "mm/m", 1e-3 },
                  { "permille", 1e-3 },    { "percent", 1e-2 },     { "%", 1e-2 } };
    for (size_t i = 0; i < WF_COUNT(known); i++)
        if (!strcmp(unit, known[i].name)) {
            *factor = known[i].factor;
            return true;
        }
    return false;
}

static bool unit_factor(struct wf_units *u, const char *unit, enum wf_dimension d, double *factor,
                        struct wf_err *e)
{
    char text[80];
    if (d == WF_DIM_NONE) return part_of_one(unit, factor);
    (void)snprintf(text, sizeof text, "1 %.60s", unit);
    return *unit && strlen(unit) <= 60 && !wf_quantity_read(u, text, d, factor, e);
}

/* The same for a text that need not be a unit: of the errors only a lack of memory is passed on. */
static bool maybe_unit(struct wf_units *u, const char *unit, enum wf_dimension d, double *factor,
                       struct wf_err *e)
{
    struct wf_err why = { 0 };
    bool found = unit_factor(u, unit, d, factor, &why);
    if (why.code == WF_ENOMEM) (void)wf_fail(e, WF_ENOMEM, "%s", why.text);
    return found;
}

/* What stands in brackets at the end of a name, "km/h" of "u (km/h)"; "" when nothing does. *stem: size of
 * what stands before them. */
static const char *in_brackets(const char *name, char *out, size_t size, size_t *stem)
{
    size_t n = strlen(name);
    const char *open = NULL;
    *out = '\0';
    if (n && name[n - 1] == ')') open = strrchr(name, '(');
    if (n && name[n - 1] == ']') open = strrchr(name, '[');
    if (!open || (size_t)(name + n - 1 - open) > size) return out;
    const char *from = open + 1 + strspn(open + 1, " "), *end = name + n - 1;
    while (end > from && end[-1] == ' ') end--;
    (void)snprintf(out, size, "%.*s", (int)(end - from), from);
    *stem = (size_t)(open - name);
    return out;
}

bool wf_name_unit(struct wf_units *u, const char *name, enum wf_dimension d, double *factor, size_t *stem,
                  struct wf_err *e)
{
    static const char joint[] = { '/', ' ' };
    char text[80], inner[64];
    *stem = strlen(name);
    if (maybe_unit(u, in_brackets(name, inner, sizeof inner, stem), d, factor, e)) return true;
    for (const char *tail = strpbrk(name, "_ "); tail; tail = strpbrk(tail + 1, "_ "))
        for (size_t k = 0; k < sizeof joint; k++) {
            bool plain = d == WF_DIM_NONE; /* "um_m" is a spelling of its own */
            (void)snprintf(text, sizeof text, "%.70s", tail + 1);
            for (char *p = text; *p && !plain; p++)
                if (*p == '_') *p = joint[k];
            if (!maybe_unit(u, text, d, factor, e)) continue;
            *stem = (size_t)(tail - name);
            return true;
        }
    *stem = strlen(name);
    return false;
}

enum wf_status wf_column_unit(struct wf_units *u, const struct wf_column *c, double *factor, struct wf_err *e)
{
    struct wf_err why = { 0 };
    size_t stem;
    const struct wf_dimension_row *row = wf_dimension_row(c->dimension);
    *factor = 1;
    if (c->unit && unit_factor(u, c->unit, c->dimension, factor, &why)) return WF_OK;
    if (c->unit && c->dimension == WF_DIM_NONE)
        return wf_fail(e, WF_EINPUT,
                       "column '%s': the unit '%s' is not a part of one; known are um/m, mm/m, ppm, %%",
                       c->name, c->unit);
    if (c->unit)
        return wf_fail(e, why.code ? why.code : WF_EINPUT, "column '%s': the unit '%s': %s", c->name, c->unit,
                       why.text);
    if (wf_name_unit(u, c->name, c->dimension, factor, &stem, &why) || c->dimension == WF_DIM_NONE)
        return WF_OK;
    if (why.code) return wf_fail(e, why.code, "column '%s': %s", c->name, why.text);
    const char *tail = strrchr(c->name, '_');
    bool mass = c->dimension == WF_DIM_FORCE && tail && !strcasecmp(tail + 1, "kg");
    int size = mass ? (int)(tail - c->name) : (int)strlen(c->name);
    return wf_fail(
        e, WF_EINPUT,
        "column '%s' does not end in a unit of %s%s; name it for example '%.*s_%s', or give 'unit'", c->name,
        row->name + (!strncmp(row->name, "a ", 2)    ? 2
                     : !strncmp(row->name, "an ", 3) ? 3
                                                     : 0),
        mass ? " (kg is a mass; a force read off a scale in kg is kgf)" : "", size > 40 ? 40 : size, c->name,
        mass ? "kgf" : row->si);
}

static bool is_beaufort(const char *name)
{
    size_t n = strlen(name);
    return (n >= 3 && !strcasecmp(name + n - 3, "bft")) || (n >= 8 && !strcasecmp(name + n - 8, "beaufort"));
}

static void refuse_unit(struct wf_csv *c, size_t column, const char *unit, enum wf_dimension d)
{
    char text[256];
    const struct wf_cell *name = &c->name[column];
    (void)snprintf(text, sizeof text, "column '%.60s': '%.40s' is not a unit of %s; use one of: %s",
                   name->text, unit, wf_dimension_row(d)->name, wf_dimension_row(d)->units);
    wf_csv_report(c, name->line, name->column, text);
}

/* A required column whose name ends in no unit of the dimension. */
static void miss_unit(struct wf_csv *c, size_t column, enum wf_dimension d)
{
    char text[400];
    const struct wf_cell *name = &c->name[column];
    const char *units = wf_dimension_row(d)->units;
    (void)snprintf(
        text, sizeof text,
        "column '%.60s' does not say its unit, that of %s (%s); end its name in it, for example '%.60s_%.*s'",
        name->text, wf_dimension_row(d)->name, units, name->text, (int)strcspn(units, ","), units);
    wf_csv_report(c, name->line, name->column, text);
}

bool wf_column_factor(struct wf_csv *c, struct wf_units *u, size_t column, enum wf_dimension d,
                      const char *usual, double *factor, struct wf_err *e)
{
    char inner[64];
    size_t stem;
    const struct wf_cell *name = &c->name[column];
    const char *head = c->unit && *c->unit[column] ? c->unit[column] : NULL, *wrong = NULL;
    if (head) {
        if (maybe_unit(u, head, d, factor, e)) return true;
        wrong = head;
    } else if (wf_name_unit(u, name->text, d, factor, &stem, e)) {
        return true;
    } else if (wf_unit_known(u, in_brackets(name->text, inner, sizeof inner, &stem)) && *inner) {
        wrong = inner;
    } else if (d == WF_DIM_SPEED && is_beaufort(name->text)) {
        wrong = "Beaufort";
    }
    if (e && e->code) return false;
    if (wrong) {
        refuse_unit(c, column, wrong, d);
        return false;
    }
    if (!maybe_unit(u, usual, d, factor, e)) return false;
    wf_diag_warn(c->diag, "unit-assumed",
                 "%s: column '%s' names no unit and is taken to be in %s; name it for "
                 "example '%s_%s'",
                 c->file, name->text, usual, name->text, usual);
    return true;
}

/* Whether a name is `want` but for its unit. */
static bool same_but_unit(struct wf_units *u, const char *name, const char *want, size_t size,
                          enum wf_dimension d, double *factor, struct wf_err *e)
{
    size_t stem;
    if (!wf_name_unit(u, name, d, factor, &stem, e)) return false;
    while (stem && name[stem - 1] == ' ') stem--;
    bool same = stem == size;
    for (size_t i = 0; same && i < size; i++)
        same = tolower((unsigned char)name[i]) == want[i] || (want[i] == '_' && name[i] == ' ');
    return same;
}

size_t wf_column_need(struct wf_csv *c, struct wf_units *u, const char *name, enum wf_dimension d,
                      double *factor, struct wf_err *e)
{
    size_t stem, column = wf_csv_column(c, name);
    *factor = 1;
    if (column != WF_CSV_NONE) {
        bool own = wf_name_unit(u, name, d, factor, &stem, e), headed = c->unit && *c->unit[column];
        if (headed || !own) own = wf_column_factor(c, u, column, d, "", factor, e);
        if (own) return column;
        if (!headed) miss_unit(c, column, d);
        return WF_CSV_NONE;
    }
    if (wf_name_unit(u, name, d, factor, &stem, e))
        for (size_t k = 0; k < c->columns; k++)
            if (same_but_unit(u, c->name[k].text, name, stem, d, factor, e)) return k;
    return wf_csv_need(c, name);
}

bool wf_column_number(struct wf_csv *c, size_t column, double factor, double low, double high, double *value)
{
    if (!wf_csv_number(c, column, low / factor, high / factor, value)) return false;
    *value *= factor;
    return true;
}

/* Missing marks. */

/* 9, 99, 99.9, 999, 7999, 8888 and the like: what programs write where there is no reading. */
static bool usual_mark(double v)
{
    static const double known[] = { 99, 99.9, 99.99, 999, 999.9, 999.99, 9999, 7999, 8888, 888 };
    for (size_t i = 0; i < WF_COUNT(known); i++)
        if (fabs(v) == known[i]) return true;
    return false;
}

static void strike(struct wf_marks *m, double *value, size_t n, double mark)
{
    for (size_t i = 0; i < n; i++)
        if (fabs(value[i]) == mark) value[i] = NAN, m->missing++;
    m->mark = mark;
}

bool wf_marks_find(struct wf_marks *m, double *value, size_t n)
{
    size_t left = 0;
    double *size = malloc((n ? n : 1) * sizeof *size);
    m->doubtful = n;
    m->missing = 0;
    if (!size) return false;
    for (size_t i = 0; i < n; i++) {
        if (m->unsigned_ && !m->none && value[i] < 0.0) m->mark = value[i], value[i] = NAN, m->missing++;
        if (!isnan(value[i])) size[left++] = fabs(value[i]);
    }
    if (left) qsort(size, left, sizeof *size, wf_ascending);
    while (left && !m->none) {
        double top = size[left - 1];
        size_t same = 0;
        while (left && size[left - 1] == top) left--, same++;
        m->next = left ? size[left - 1] : 0.0;
        bool impossible = top > m->impossible, apart = top > 2.0 * m->next;
        if (impossible && same > 1 && apart) {
            strike(m, value, n, top);
            continue;
        }
        if (impossible || (apart && left && usual_mark(top)))
            for (size_t i = n; i-- > 0;)
                if (fabs(value[i]) == top) m->doubtful = i;
        break;
    }
    free(size);
    return true;
}

static const double FASTEST = 90.0; /* no wind is above it [m/s] */

enum wf_status wf_marks_strike(struct wf_csv *c, size_t column, double factor, bool none, bool alone,
                               double *value, const size_t *line, size_t n, const char *const how[2],
                               size_t *struck, struct wf_err *e)
{
    const char *name = c->name[column].text;
    struct wf_marks m = { .impossible = FASTEST / factor, .unsigned_ = alone, .none = none };
    if (!wf_marks_find(&m, value, n))
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its rows", c->file);
    if (m.doubtful < n)
        return wf_fail(e, WF_EINPUT,
                       "%s:%zu: error: column '%s': %.10g (%.4g m/s) is a missing mark or a peak; the next "
                       "largest is %.10g. %s%.10g%s",
                       c->file, line[m.doubtful], name, value[m.doubtful], value[m.doubtful] * factor, m.next,
                       how[0], value[m.doubtful], how[1]);
    if (m.missing)
        wf_diag_warn(c->diag, "missing-marks",
                     "%s: column '%s': %zu numbers are taken as missing marks, such as %.10g", c->file, name,
                     m.missing, m.mark);
    *struck = m.missing;
    return WF_OK;
}

/* Readings. */

bool wf_readings_add(struct wf_readings *r, double value, double beside, size_t line)
{
    if (r->n == r->room) {
        size_t room = r->room ? 2 * r->room : 4096;
        double *v = realloc(r->value, room * sizeof *v);
        if (v) r->value = v;
        double *b = realloc(r->beside, room * sizeof *b);
        if (b) r->beside = b;
        size_t *l = realloc(r->line, room * sizeof *l);
        if (l) r->line = l;
        if (!v || !b || !l) return false;
        r->room = room;
    }
    r->line[r->n] = line;
    r->value[r->n] = value, r->beside[r->n++] = beside;
    return true;
}

void wf_readings_free(struct wf_readings *r) { free(r->value), free(r->beside), free(r->line); }
