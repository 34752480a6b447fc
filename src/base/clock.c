/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/clock.h"
#include "base/num.h"
#include <math.h>
#include <string.h>
#include <strings.h>

enum { NUMBERS = 1, DATES, TIMES_OF_DAY };

bool wf_dates_named(const char *word, enum wf_dates *out)
{
    *out = !word ? WF_DATES_UNSAID : !strcmp(word, "day-first") ? WF_DATES_DAY_FIRST : WF_DATES_MONTH_FIRST;
    return !word || *out == WF_DATES_DAY_FIRST || !strcmp(word, "month-first");
}

/* Calendar. */

/* Days since 1970-01-01 of the Gregorian calendar (Fliegel and Van Flandern 1968). */
static long day_number(int y, int m, int d)
{
    int shift = (m - 14) / 12;
    return d - 32075L + 1461L * (y + 4800 + shift) / 4 + 367L * (m - 2 - shift * 12) / 12 -
           3L * ((y + 4900 + shift) / 100) / 4 - 2440588L;
}

/* The inverse, from the same source. */
static void date_of(long day, int *y, int *m, int *d)
{
    long l = day + 2440588L + 68569, n = 4 * l / 146097;
    l -= (146097 * n + 3) / 4;
    long i = 4000 * (l + 1) / 1461001;
    l = l - 1461 * i / 4 + 31;
    long j = 80 * l / 2447;
    *d = (int)(l - 2447 * j / 80);
    l = j / 11;
    *m = (int)(j + 2 - 12 * l);
    *y = (int)(100 * (n - 49) + i + l);
}

static bool is_date(int y, int m, int d)
{
    int back[3];
    if (y < 1000 || y > 9999 || m < 1 || m > 12 || d < 1 || d > 31) return false;
    date_of(day_number(y, m, d), &back[0], &back[1], &back[2]);
    return back[0] == y && back[1] == m && back[2] == d;
}

/* Pieces of a text. */

/* Read 1 to `most` digits; the end, or NULL. */
static const char *digits(const char *p, int most, int *value)
{
    int n = 0;
    for (*value = 0; n < most && p[n] >= '0' && p[n] <= '9'; n++) *value = *value * 10 + (p[n] - '0');
    return n && !(p[n] >= '0' && p[n] <= '9') ? p + n : NULL;
}

/* Read h:mm, h:mm:ss, h:mm:ss.fff, with AM or PM; the end, or NULL. */
static const char *time_of_day(const char *p, double *seconds)
{
    int h, m, s = 0;
    double part = 0.0, scale = 0.1;
    if (!(p = digits(p, 2, &h)) || *p != ':' || !(p = digits(p + 1, 2, &m)) || h > 23 || m > 59) return NULL;
    if (*p == ':' && (!(p = digits(p + 1, 2, &s)) || s > 59)) return NULL;
    if ((*p == '.' || *p == ',') && p[1] >= '0' && p[1] <= '9')
        for (p++; *p >= '0' && *p <= '9'; p++, scale /= 10.0) part += (*p - '0') * scale;
    const char *word = p + strspn(p, " ");
    if (!strncasecmp(word, "AM", 2) || !strncasecmp(word, "PM", 2)) {
        if (h < 1 || h > 12) return NULL;
        h = h % 12 + (*word == 'P' || *word == 'p' ? 12 : 0);
        p = word + 2;
    }
    *seconds = 3600.0 * h + 60.0 * m + s + part;
    return p;
}

/* Read Z, +hh, +hhmm or +hh:mm; the end. */
static const char *zone(const char *p, double *seconds)
{
    int h = 0, m = 0;
    const char *from = p, *q;
    *seconds = 0.0;
    if (*p == 'Z' || *p == 'z') return p + 1;
    if (*p != '+' && *p != '-') return p;
    double sign = *p == '-' ? -1.0 : 1.0;
    if ((q = digits(p + 1, 4, &h)) && q - p == 5)
        m = h % 100, h /= 100;
    else if (!(q = digits(p + 1, 2, &h)) || (*q == ':' && !(q = digits(q + 1, 2, &m))))
        return from;
    if (h > 18 || m > 59) return from;
    *seconds = sign * (3600.0 * h + 60.0 * m);
    return q;
}

/* Three numbers with the same sign between them; the end, or NULL. */
static const char *three_numbers(const char *p, int v[3], char *sign)
{
    if (!(p = digits(p, 4, &v[0])) || !strchr("-/.", *p) || !*p) return NULL;
    *sign = *p;
    if (!(p = digits(p + 1, 2, &v[1])) || *p != *sign) return NULL;
    return digits(p + 1, 4, &v[2]);
}

/* Day and month of a date that begins with one of them. A date that can be read both ways gets the day first;
 * wf_clock_settle corrects it. */
static void order_of(struct wf_clock *k, const int v[3], char sign, int *m, int *d)
{
    bool day = v[0] > 12 || sign == '.', month = v[1] > 12 && sign != '.';
    *d = month ? v[1] : v[0], *m = month ? v[0] : v[1];
    k->day_seen = k->day_seen || (day && sign != '.');
    k->month_seen = k->month_seen || month;
    k->slashes = k->slashes || sign != '.';
}

/* Read a date and time; the seconds from the start of the column's first day. */
static bool date_and_time(struct wf_clock *k, const char *p, double *t)
{
    int v[3], y, m, d;
    char sign;
    double seconds = 0.0, offset = 0.0;
    const char *start = p;
    if (!(p = three_numbers(p, v, &sign))) return false;
    bool year_first = v[0] > 31;
    y = year_first ? v[0] : v[2], m = v[1], d = v[2];
    if (!year_first) order_of(k, v, sign, &m, &d);
    if (!year_first && y < 100 && sign == '.') y += 2000;
    if (!is_date(y, m, d)) return false;
    if (*p == 'T' || *p == ' ') {
        if (!(p = time_of_day(p + 1 + strspn(p + 1, " "), &seconds))) return false;
        if (year_first) p = zone(p, &offset);
    }
    if (*p || p == start) return false;
    long day = day_number(y, m, d);
    if (k->kind != DATES) k->origin = day;
    k->differ = k->differ || day != k->origin;
    k->kind = DATES;
    *t = 86400.0 * (double)(day - k->origin) + seconds - offset;
    return true;
}

static bool clock_time(struct wf_clock *k, const char *text, double *t)
{
    const char *end = time_of_day(text, t);
    if (!end || *end) return false;
    if (k->kind == TIMES_OF_DAY && *t < k->previous - 43200.0) k->wrapped += 86400.0;
    k->previous = *t;
    k->kind = TIMES_OF_DAY;
    *t += k->wrapped;
    return true;
}

bool wf_clock_read(struct wf_clock *k, struct wf_csv *c, size_t column, double *t)
{
    static const char *const words[] = { "", "a number", "a date and time", "a time of day" };
    const char *text = wf_csv_text(c, column);
    bool open = k->slashes;
    enum wf_csv_kind kind = wf_csv_value(c, column, t);
    if (kind == WF_CSV_MISSING) return false;
    if (kind == WF_CSV_NUMBER && k->kind <= NUMBERS) {
        k->kind = NUMBERS;
        *t *= k->factor > 0.0 ? k->factor : 1.0;
        return true;
    }
    if (k->kind != NUMBERS && k->kind != TIMES_OF_DAY && date_and_time(k, text, t)) {
        if (k->slashes && !open) k->line = c->cell[column].line, k->column = c->cell[column].column;
        return true;
    }
    if (k->kind != NUMBERS && k->kind != DATES && clock_time(k, text, t)) return true;
    if (kind == WF_CSV_MIXED)
        wf_csv_mistake(c, column, "'%.40s': decimal comma and decimal point are mixed in this file", text);
    else
        wf_csv_mistake(c, column, "'%.40s' is not %s%s", text,
                       k->kind ? words[k->kind] : "a number or a time",
                       k->kind ? ", as the rows before it are" : "; times are written 2024-01-05T12:00:00.5");
    return false;
}

void wf_clock_say_unit(const struct wf_clock *k, struct wf_csv *c, size_t column)
{
    if (k->kind == NUMBERS && !(k->factor > 0.0))
        wf_diag_warn(c->diag, "unit-assumed",
                     "%s: column '%s' names no unit and is taken to be in s; name it for "
                     "example '%s_s'",
                     c->file, c->name[column].text, c->name[column].text);
}

enum wf_status wf_clock_settle(const struct wf_clock *k, const char *file, const char *say, double *t,
                               size_t n, struct wf_err *e)
{
    bool day = k->day_seen || k->dates == WF_DATES_DAY_FIRST;
    bool month = k->month_seen || k->dates == WF_DATES_MONTH_FIRST;
    if (!k->slashes) return WF_OK;
    if (day && month)
        return wf_fail(e, WF_EINPUT,
                       "%s:%zu:%zu: error: dates have the day first in some rows and the month first in "
                       "others%s",
                       file, k->line, k->column, k->dates ? ", or not as is said" : "");
    if (!day && !month && k->differ)
        return wf_fail(e, WF_EINPUT,
                       "%s:%zu:%zu: error: no date shows whether the day or the month is first; say %s", file,
                       k->line, k->column, say);
    for (size_t i = 0; month && i < n; i++) {
        int y, m, d;
        if (isnan(t[i])) continue;
        double days = floor(t[i] / 86400.0);
        date_of(k->origin + (long)days, &y, &m, &d);
        if (d <= 12) t[i] += 86400.0 * ((double)(day_number(y, d, m) - k->origin) - days);
    }
    return WF_OK;
}

bool wf_clock_date(const struct wf_clock *k, double t, int *year, int *month)
{
    int day;
    if (k->kind != DATES || isnan(t)) return false;
    date_of(k->origin + (long)floor(t / 86400.0), year, month, &day);
    return true;
}
