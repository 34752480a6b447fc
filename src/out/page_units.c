/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/page_units.h"
#include "base/arena.h"
#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is turned, by the unit that pages and texts are written in. */
static const struct wf_page_unit imperial[] = {
    { "m/s", "mph", 2.2369362920544 },
    { "m", "ft", 3.2808398950131 },
    { "cm", "in", 0.39370078740157 },
    { "mm", "in", 0.039370078740157 },
    { "km", "mi", 0.62137119223733 },
    { "m²", "ft²", 10.76391041671 },
    { "m²/s²", "mph²", 5.0038839747101 },
    { "m2", "ft2", 10.76391041671 },
    { "m³", "ft³", 35.314666721489 },
    { "m3", "ft3", 35.314666721489 },
    { "kg", "lb", 2.2046226218488 },
    { "t", "lb", 2204.6226218488 },
    { "kg/m³", "lb/ft³", 0.062427960576145 },
    { "kg/m3", "lb/ft3", 0.062427960576145 },
    { "kg/m²", "lb/ft²", 0.20481614362252 },
    { "kg/m2", "lb/ft2", 0.20481614362252 },
    { "N", "lbf", 0.22480894309971 },
    { "kN", "lbf", 224.80894309971 },
    { "N m", "lbf·ft", 0.73756214927727 },
    { "kN m", "kip·ft", 0.73756214927727 },
    { "MN m", "kip·ft", 737.56214927727 },
    { "N m/rad", "lbf·ft/rad", 0.73756214927727 },
    { "kN m/rad", "kip·ft/rad", 0.73756214927727 },
    { "MN m/rad", "kip·ft/rad", 737.56214927727 },
    { "kN m/m3", "kip/ft2", 0.02088543423315 },
    { "kN m/m³", "kip/ft²", 0.02088543423315 },
    { "Pa", "lbf/ft²", 0.02088543423315 },
    { "kPa", "psi", 0.14503773773021 },
    { "MPa", "psi", 145.03773773021 },
    { "GPa", "ksi", 145.03773773021 },
    { "mm/h", "in/h", 0.039370078740157 },
    { NULL, NULL, 0 },
};
static const struct wf_page_unit cn[] = {
    { "N m", "N·m", 1 },         { "kN m", "kN·m", 1 },         { "MN m", "MN·m", 1 },
    { "N m/rad", "N·m/rad", 1 }, { "kN m/rad", "kN·m/rad", 1 }, { "MN m/rad", "MN·m/rad", 1 },
    { "mm", "cm", 0.1 },         { "GPa", "MPa", 1000 },        { "h/a", "小时/年", 1 },
    { NULL, NULL, 0 },
};
static const struct wf_page_unit metric[] = { { NULL, NULL, 0 } };

static const struct {
    const char *name;
    const struct wf_page_unit *row;
} systems[] = { { "metric", metric }, { "imperial", imperial }, { "cn", cn } };
enum { SYSTEMS = sizeof systems / sizeof *systems };

const char *wf_page_units_word(size_t i) { return i < SYSTEMS ? systems[i].name : NULL; }

static const struct wf_page_unit *rows_of(const char *system)
{
    for (size_t i = 0; i < SYSTEMS; i++)
        if (!strcmp(systems[i].name, system)) return systems[i].row;
    return metric;
}

/* Passed over within a text. */
#define JOINER "\xe2\x81\xa0"
static size_t nothing_at(const char *p)
{
    return !strncmp(p, WF_MARK_NODE, 3) || !strncmp(p, JOINER, 3) ? 3 : 0;
}

/* A blank of any width: its bytes, 0 for none. */
static size_t blank_at(const char *p)
{
    if (*p == ' ' || *p == '\n') return 1;
    if (!strncmp(p, "\xc2\xa0", 2)) return 2;
    return !strncmp(p, "\xe2\x80\xaf", 3) ? 3 : 0;
}

const struct wf_page_unit *wf_page_unit_find(const char *system, const char *from, size_t n)
{
    char plain[24];
    size_t used = 0;
    for (size_t i = 0, step; i < n; i += step) {
        if (used + 3 >= sizeof plain) return NULL;
        if ((step = nothing_at(from + i))) continue;
        step = blank_at(from + i);
        plain[used++] = step ? ' ' : from[i];
        step = step ? step : 1;
    }
    plain[used] = '\0';
    for (const struct wf_page_unit *u = rows_of(system); u->from; u++)
        if (!strcmp(u->from, plain)) return u;
    return NULL;
}

const struct wf_page_unit *wf_page_unit_row(const char *system, size_t i) { return rows_of(system) + i; }

/* Bytes of a character of a unit. */
static size_t unit_char(const char *p, bool begun)
{
    static const char *const wide[] = { "µ", "²", "³", "·", "°" };
    if (isalpha((unsigned char)*p)) return 1;
    if (begun && (*p == '/' || isdigit((unsigned char)*p))) return 1;
    for (size_t i = 0; i < sizeof wide / sizeof *wide; i++)
        if (!strncmp(p, wide[i], strlen(wide[i]))) return strlen(wide[i]);
    return begun && !strncmp(p, JOINER, 3) ? 3 : 0;
}

static const char *token_end(const char *p)
{
    for (size_t n, begun = 0; (n = unit_char(p, begun)); begun = 1) p += n;
    return p;
}

/* Does a factor of a compound unit stand here ("kg m2", "m s⁻¹")? */
static bool goes_on(const char *p)
{
    static const char *const symbol[] = { "m",  "m2", "m3", "m²", "m³", "s",  "s2",
                                          "s²", "kg", "N",  "Pa", "K",  "rad" };
    size_t gap = blank_at(p);
    if (!gap) return *p && (strchr("^*-", *p) || !strncmp(p, "\xe2\x81", 2) || !strncmp(p, "\xc2\xb9", 2));
    size_t n = (size_t)(token_end(p + gap) - p) - gap;
    for (size_t i = 0; i < sizeof symbol / sizeof *symbol; i++)
        if (n == strlen(symbol[i]) && !strncmp(p + gap, symbol[i], n)) return true;
    return false;
}

/* The unit that stands here, and where it ends. NULL: none that is turned. */
static const struct wf_page_unit *unit_at(const char *system, const char *p, const char **end)
{
    const char *last = token_end(p);
    size_t n = (size_t)(last - p), gap = blank_at(last);
    bool force = (n == 1 || (n == 2 && strchr("kMm", *p))) && p[n - 1] == 'N';
    if (force && gap && last[gap] == 'm') last = token_end(last + gap);
    *end = last;
    return n && !goes_on(last) ? wf_page_unit_find(system, p, (size_t)(last - p)) : NULL;
}

/* A number in a text. */
struct found {
    const char *from, *to, *shown; /* where it stands, its marks included; as it is shown: `wide` bytes */
    size_t wide;
    double value;
    bool marked, typed;              /* typed: stays as it is */
    const struct wf_page_unit *unit; /* that it is turned to; NULL: none */
    const char *unit_from, *unit_to; /* the unit's text behind it; NULL: it is behind a later number */
};

/* Bytes of a plain number: digits, groups, decimals, exponent; its value. */
static size_t plain_number(const char *p, double *value)
{
    char digits[40];
    size_t n = 0, used = 0;
    bool minus = !strncmp(p, "−", 3);
    if (minus || *p == '-') n += minus ? 3 : 1, digits[used++] = '-';
    if (!isdigit((unsigned char)p[n])) return 0;
    for (; used < sizeof digits - 1; n++) {
        bool group = p[n] == ',' && isdigit((unsigned char)p[n + 1]) && isdigit((unsigned char)p[n + 2]) &&
                     isdigit((unsigned char)p[n + 3]) && !isdigit((unsigned char)p[n + 4]);
        bool point = p[n] == '.' && isdigit((unsigned char)p[n + 1]);
        if (group) continue;
        if (!point && !isdigit((unsigned char)p[n])) break;
        digits[used++] = p[n];
    }
    bool power = p[n] == 'e' && p[n + 1] && strchr("+-", p[n + 1]) && isdigit((unsigned char)p[n + 2]);
    if (power && used + 5 < sizeof digits) {
        memcpy(digits + used, p + n, 3), used += 3, n += 3;
        while (used < sizeof digits - 1 && isdigit((unsigned char)p[n])) digits[used++] = p[n++];
    }
    digits[used] = '\0';
    char *end;
    *value = strtod(digits, &end);
    return *end ? 0 : n;
}

/* May a plain number begin behind this character? Not within names, dates and fractions. */
static bool may_begin(const char *text, const char *p)
{
    if (p == text) return true;
    char c = p[-1];
    if (c == '-' && p - text >= 2 && isdigit((unsigned char)p[-2])) return true; /* "4-20 m" */
    return !isalnum((unsigned char)c) && !strchr("_.-+/^*,", c) &&
           strncmp(p - 2 < text ? p : p - 2, "×", 2) != 0;
}

/* The number at p, plain or marked. */
static bool number_at(const char *text, const char *p, struct found *f)
{
    *f = (struct found){ .from = p, .shown = p };
    if (!strncmp(p, WF_MARK, 3)) {
        const char *shown = strstr(p, WF_MARK_SHOWN), *end = shown ? strstr(shown, WF_MARK_END) : NULL;
        if (!end) return false;
        f->marked = true, f->value = strtod(p + 3, NULL);
        f->shown = shown + 3, f->wide = (size_t)(end - f->shown), f->to = end + 3;
        return true;
    }
    if (!may_begin(text, p) || !(f->wide = plain_number(p, &f->value))) return false;
    f->to = p + f->wide;
    return true;
}

static size_t count_numbers(const char *text, struct found *f)
{
    size_t n = 0;
    bool typed = false;
    struct found one;
    for (const char *p = text; *p;) {
        if (!strncmp(p, WF_AS_TYPED, 3)) typed = true;
        if (!strncmp(p, WF_AS_TYPED_END, 3)) typed = false;
        if (!number_at(text, p, &one)) {
            p++;
            continue;
        }
        one.typed = typed;
        if (f) f[n] = one;
        n++, p = one.to;
    }
    return n;
}

/* What stands between two numbers. */
enum between { APART, JOINED, UNSURE };

static enum between what_is_between(const char *text, const struct found *a, const struct found *b)
{
    static const char *const joins[] = { " to ", " to above ", "–", "-", "…", " … ", "至", " 至 ", " bis " };
    static const char *const unsure[] = {
        ", ", " and ", " or ", "、", " 和 ", "和", " x ", " × ", " / ", "/"
    };
    char is[40];
    size_t used = 0;
    for (const char *p = a->to; p < b->from; p++) {
        if (nothing_at(p)) {
            p += 2;
            continue;
        }
        if (used + 1 >= sizeof is) return APART;
        is[used++] = *p;
    }
    is[used] = '\0';
    if (!strncmp(is, WF_MARK_LIST, 3)) return JOINED;
    for (size_t i = 0; i < sizeof joins / sizeof *joins; i++)
        if (!strcmp(is, joins[i])) return JOINED;
    bool between = a->from - text >= 8 && !strncmp(a->from - 8, "between ", 8);
    if (between && !strcmp(is, " and ")) return JOINED;
    for (size_t i = 0; i < sizeof unsure / sizeof *unsure; i++)
        if (!strcmp(is, unsure[i])) return UNSURE;
    return APART;
}

/* The unit behind number i holds for the numbers that are joined to it; for none where that is not sure. */
static void spread_unit(const char *text, struct found *f, size_t i)
{
    const struct wf_page_unit *unit = f[i].unit;
    size_t first = i;
    enum between is = APART;
    for (; first > 0 && !f[first - 1].unit; first--)
        if ((is = what_is_between(text, &f[first - 1], &f[first])) != JOINED) break;
    /* the end of a name or a date ("EN 1991-1-4, 25 m/s"), a branch's order: no numbers of a list */
    const char *before = first > 0 ? f[first - 1].from : text;
    bool named =
        (before > text && before[-1] == '-') || (before - text >= 6 && !strncmp(before - 6, "order ", 6));
    bool drop = is == UNSURE && first > 0 && !f[first - 1].unit && !named;
    for (size_t k = first; k <= i; k++) drop |= f[k].typed || f[k].marked != f[i].marked;
    for (size_t k = first; k <= i; k++) f[k].unit = drop ? NULL : unit;
}

static void find_units(const char *system, const char *text, struct found *f, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const char *p = f[i].to, *end;
        for (size_t k, blanks = 0; (k = nothing_at(p)) || (!blanks++ && (k = blank_at(p)));) p += k;
        f[i].unit = unit_at(system, p, &end);
        if (!f[i].unit) continue;
        f[i].unit_from = p, f[i].unit_to = end;
        spread_unit(text, f, i);
    }
}

/* Decimals of a number as it is shown. */
static int decimals_of(const struct found *f)
{
    const char *point = memchr(f->shown, '.', f->wide), *power = memchr(f->shown, 'e', f->wide),
               *end = power ? power : f->shown + f->wide;
    return (point ? (int)(end - point - 1) : 0) - (power ? (int)strtol(power + 1, NULL, 10) : 0);
}

/* A number that is not negative, with a fixed number of decimals and its thousands in groups. */
static void put_grouped(FILE *out, double value, int decimals)
{
    char digits[48];
    (void)snprintf(digits, sizeof digits, "%.*f", decimals, value);
    size_t whole = strcspn(digits, ".");
    for (size_t i = 0; digits[i]; i++) {
        if (i && i < whole && (whole - i) % 3 == 0) fputc(',', out);
        fputc(digits[i], out);
    }
}

/* Digits of a number as it is shown, without zeros before the first. */
static int digits_of(const struct found *f)
{
    int n = 0;
    for (size_t i = 0; i < f->wide && f->shown[i] != 'e'; i++)
        if (isdigit((unsigned char)f->shown[i]) && (n || f->shown[i] != '0')) n++;
    return n;
}

/* A number in its new unit, to about the same part of itself as it was shown to: three digits at most, or
 * four where four were shown. */
static void put_number(FILE *out, const struct found *f)
{
    if (!f->unit || f->unit->factor == 1) {
        (void)fwrite(f->shown, 1, f->wide, out);
        return;
    }
    double value = fabs(f->value * f->unit->factor);
    int places = decimals_of(f) - (int)floor(log10(f->unit->factor) + 0.3),
        most = value > 0 ? (digits_of(f) > 3 ? 3 : 2) - (int)floor(log10(value)) : 9;
    if (most < 0) most = 0;
    if (places > most) places = most;
    if (places < 0) value = round(value * pow(10, places)) / pow(10, places);
    if (f->value < 0 && value >= 0.5 * pow(10, -places)) fputs("−", out);
    put_grouped(out, value, places < 0 ? 0 : places < 9 ? places : 9);
}

/* A text between numbers, without marks. */
static void put_text(FILE *out, const char *p, const char *end)
{
    while (p < end) {
        bool mark = !strncmp(p, WF_MARK, 2) && (unsigned char)p[2] >= 0x80 && (unsigned char)p[2] <= 0x85;
        if (!mark) fputc(*p, out);
        p += mark ? 3 : 1;
    }
}

static void put_all(FILE *out, const char *text, const struct found *f, size_t n)
{
    const char *p = text;
    for (size_t i = 0; i < n; i++) {
        put_text(out, p, f[i].from);
        put_number(out, &f[i]);
        p = f[i].to;
        if (!f[i].unit || !f[i].unit_from) continue;
        put_text(out, p, f[i].unit_from);
        fputs(f[i].unit->to, out);
        p = f[i].unit_to;
    }
    put_text(out, p, p + strlen(p));
}

char *wf_page_units_turned(const char *system, const char *text, const struct wf_page_unit *column,
                           struct wf_arena *a)
{
    size_t n = count_numbers(text, NULL), size = 0;
    struct found *f = WF_TAKE(a, n + 1, struct found);
    char *bytes = NULL;
    FILE *out = f ? open_memstream(&bytes, &size) : NULL;
    if (!out) return NULL;
    count_numbers(text, f);
    if (!column) find_units(system, text, f, n);
    for (size_t i = 0; i < n && column; i++) f[i].unit = column;
    put_all(out, text, f, n);
    char *kept = fclose(out) ? NULL : wf_arena_text(a, bytes);
    free(bytes);
    return kept;
}
