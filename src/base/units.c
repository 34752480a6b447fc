/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/num.h"
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <udunits2.h>

static const struct wf_dimension_row dimension_rows[WF_DIM_COUNT] = {
    [WF_DIM_NONE] = { "a plain number", "1", "%" },
    [WF_DIM_LENGTH] = { "a length", "m", "m, cm, mm" },
    [WF_DIM_AREA] = { "an area", "m2", "m2, cm2, ha" },
    [WF_DIM_SPEED] = { "a speed", "m/s", "m/s, km/h, knot" },
    [WF_DIM_TIME] = { "a time", "s", "s, min, h" },
    [WF_DIM_FREQUENCY] = { "a frequency", "s-1", "Hz, s-1" },
    [WF_DIM_MASS] = { "a mass", "kg", "kg, g, t" },
    [WF_DIM_FORCE] = { "a force", "N", "N, kN, kgf" },
    [WF_DIM_PRESSURE] = { "a pressure (stress, modulus)", "Pa", "GPa, MPa, Pa, N/mm2" },
    [WF_DIM_DENSITY] = { "a density", "kg/m3", "kg/m3, g/cm3" },
    [WF_DIM_MASS_PER_AREA] = { "a mass per area", "kg/m2", "kg/m2, g/m2" },
    [WF_DIM_ANGLE] = { "an angle", "radian", "deg, rad" },
    [WF_DIM_TEMPERATURE] = { "a temperature", "K", "degC, K" },
    [WF_DIM_ROTATIONAL_STIFFNESS] = { "a rotational stiffness", "N m/radian", "N m/rad, kN m/rad" },
    [WF_DIM_BENDING_STIFFNESS] = { "a bending stiffness", "N m2", "N m2, kN m2" },
    [WF_DIM_VISCOSITY] = { "a kinematic viscosity", "m2/s", "m2/s, mm2/s" },
    [WF_DIM_ACCELERATION] = { "an acceleration", "m/s2", "m/s2" },
    [WF_DIM_MOMENT] = { "a moment", "N m", "N m, kN m" },
    [WF_DIM_FORCE_PER_LENGTH] = { "a force per length", "N/m", "N/m, kN/m" },
    [WF_DIM_MASS_PER_LENGTH] = { "a mass per length", "kg/m", "kg/m, g/m" },
};

/* Customary spellings that the database lacks or interprets differently (mph: milliphot, ms: milliseconds, c:
 * the speed of light), each for one dimension. Those of speeds are read in either case. */
static const struct {
    enum wf_dimension dimension;
    const char *spelling, *meaning; /* meaning NULL: not a unit */
} aliases[] = {
    { WF_DIM_ANGLE, "deg", "degree" },
    { WF_DIM_SPEED, "mph", "mile/hour" },
    { WF_DIM_SPEED, "kph", "km/hour" },
    { WF_DIM_SPEED, "kmh", "km/hour" },
    { WF_DIM_SPEED, "kmph", "km/hour" },
    { WF_DIM_SPEED, "km/h", "km/hour" },
    { WF_DIM_SPEED, "ms", "m/s" },
    { WF_DIM_SPEED, "mps", "m/s" },
    { WF_DIM_SPEED, "m/s", "m/s" },
    { WF_DIM_SPEED, "ms-1", "m/s" },
    { WF_DIM_SPEED, "cms", "cm/s" },
    { WF_DIM_SPEED, "fps", "ft/s" },
    { WF_DIM_SPEED, "kn", "knot" },
    { WF_DIM_SPEED, "kt", "knot" },
    { WF_DIM_SPEED, "kts", "knot" },
    { WF_DIM_SPEED, "kns", "knot" },
    { WF_DIM_SPEED, "knot", "knot" },
    { WF_DIM_SPEED, "knots", "knot" },
    { WF_DIM_SPEED, "c", NULL },
    { WF_DIM_SPEED, "m/h", NULL }, /* written for mph; in metres per hour nobody gives a wind */
    { WF_DIM_FORCE, "kp", "kgf" },
    { WF_DIM_FREQUENCY, "hz", "Hz" },
    { WF_DIM_MOMENT, "Nm", "N m" },
    { WF_DIM_MOMENT, "kNm", "kN m" },
    { WF_DIM_MOMENT, "MNm", "MN m" },
    { WF_DIM_MOMENT, "Ncm", "N cm" },
    { WF_DIM_MOMENT, "Nmm", "N mm" },
    { WF_DIM_ROTATIONAL_STIFFNESS, "Nm/rad", "N m/radian" },
    { WF_DIM_ROTATIONAL_STIFFNESS, "kNm/rad", "kN m/radian" },
    { WF_DIM_ROTATIONAL_STIFFNESS, "MNm/rad", "MN m/radian" },
    { WF_DIM_ROTATIONAL_STIFFNESS, "Nm/deg", "N m/degree" },
    { WF_DIM_ROTATIONAL_STIFFNESS, "kNm/deg", "kN m/degree" },
    { WF_DIM_BENDING_STIFFNESS, "Nm2", "N m2" },
    { WF_DIM_BENDING_STIFFNESS, "kNm2", "kN m2" },
};

/* Units that were read: UDUNITS takes some 10 us to read one, and few are used again and again. */
enum { UNITS_KEPT = 64, UNIT_KEPT_BYTES = 24 };
struct kept_unit {
    enum wf_dimension dimension;
    char text[UNIT_KEPT_BYTES];
    cv_converter *to_si;
};

struct wf_units {
    ut_system *system;
    ut_unit *si[WF_DIM_COUNT];
    size_t kept;
    struct kept_unit keep[UNITS_KEPT];
};

const struct wf_dimension_row *wf_dimension_row(enum wf_dimension d)
{
    return &dimension_rows[(unsigned)d < WF_DIM_COUNT ? d : WF_DIM_NONE];
}

/* One that was closed, for the next: UDUNITS takes some 4 ms to read its database, and every file of a table
 * of trees needs units. */
static struct {
    pthread_mutex_t lock;
    struct wf_units *one;
} spare = { .lock = PTHREAD_MUTEX_INITIALIZER };

/* Exchange the spare one for another; NULL: none. */
static struct wf_units *exchange(struct wf_units *u)
{
    pthread_mutex_lock(&spare.lock);
    struct wf_units *out = spare.one;
    spare.one = u;
    pthread_mutex_unlock(&spare.lock);
    return out;
}

static void drop(struct wf_units *u)
{
    if (!u) return;
    for (size_t i = 0; i < u->kept; i++) cv_free(u->keep[i].to_si);
    for (size_t i = 0; i < WF_DIM_COUNT; i++)
        if (u->si[i]) ut_free(u->si[i]);
    if (u->system) ut_free_system(u->system);
    free(u);
}

void wf_units_close(struct wf_units *u)
{
    if (u) drop(exchange(u));
}

/* What UDUNITS takes at most, with a margin, to read its database and to read a unit [bytes]. */
enum { DATABASE_BYTES = 8 << 20, UNIT_READING_BYTES = 256 << 10 };

/* Whether that much memory can be had. UDUNITS 2.2 crashes, or ends the program, when an allocation of its
 * own fails; it is therefore called only where there is room. */
static bool room(size_t bytes)
{
    void *volatile p = malloc(bytes); /* volatile: the compiler may otherwise leave out the pair of calls */
    bool any = p != NULL;
    free(p);
    return any;
}

/* Why UDUNITS could not read its database. */
static enum wf_status database_fails(ut_status why, struct wf_err *e)
{
    const char *named = getenv("UDUNITS2_XML_PATH");
    bool absent = why == UT_OPEN_ARG || why == UT_OPEN_ENV || why == UT_OPEN_DEFAULT;
    if (why == UT_OS) return wf_fail(e, WF_ENOMEM, "not enough memory for the units database of UDUNITS-2");
    if (absent && named)
        return wf_fail(e, WF_EMISSING,
                       "the units database of UDUNITS-2 cannot be opened: UDUNITS2_XML_PATH is '%.200s'",
                       named);
    if (absent)
        return wf_fail(e, WF_EMISSING,
                       "the units database of UDUNITS-2 cannot be opened (package libudunits2-data)");
    return wf_fail(e, WF_EMISSING,
                   "the units database of UDUNITS-2 is damaged or is that of another version%s%.200s",
                   named ? ": " : " (package libudunits2-data)", named ? named : "");
}

enum wf_status wf_units_open(struct wf_units **out, struct wf_err *e)
{
    if ((*out = exchange(NULL))) return WF_OK;
    (void)ut_set_error_message_handler(ut_ignore); /* by default UDUNITS writes to stderr */
    struct wf_units *u = calloc(1, sizeof *u);
    *out = u;
    if (!u) return wf_fail(e, WF_ENOMEM, "no memory for the units table");
    if (!room(DATABASE_BYTES)) {
        free(u);
        *out = NULL;
        return database_fails(UT_OS, e);
    }
    errno = 0;
    u->system = ut_read_xml(NULL);
    bool ok = u->system != NULL;
    for (size_t i = 0; ok && i < WF_DIM_COUNT; i++)
        ok = (u->si[i] = ut_parse(u->system, dimension_rows[i].si, UT_UTF8)) != NULL;
    if (ok) return WF_OK;
    enum wf_status s = database_fails(errno == ENOMEM ? UT_OS : ut_get_status(), e);
    drop(u);
    *out = NULL;
    return s;
}

/* ---- Units as they are normally written ----
 *
 * unit:   factor, then any number of: one of blank . * / or the raised dot, factor
 * factor: word or (unit), then perhaps an exponent
 * word:   letters, the degree sign, the micro sign, or one percent sign
 * exponent: perhaps ^ or **, perhaps a minus, one digit; or a raised digit 2 or 3
 *
 * UDUNITS also accepts factors, origins and logarithms ("2 GPa", "m @ 3", "lg(re 1 mW)"), which in a quantity
 * are mistakes; and it is handed nothing else, because its own reader is not made for hostile texts. */

enum { UNIT_BYTES = 60, UNIT_DEPTH = 4 };

/* Bytes of one of the texts at the start of s; 0 when it begins with none. */
static size_t begins_with(const char *s, const char *const *one)
{
    for (; *one; one++)
        if (!strncmp(s, *one, strlen(*one))) return strlen(*one);
    return 0;
}

static size_t word_bytes(const char *s)
{
    static const char *const sign[] = { "\xC2\xB0", "\xC2\xB5", "\xCE\xBC", NULL }; /* degree, micro, mu */
    size_t n = 0;
    if (*s == '%') return 1;
    for (size_t k; (k = isalpha((unsigned char)s[n]) ? 1 : begins_with(s + n, sign)) > 0;) n += k;
    return n;
}

static size_t exponent_bytes(const char *s)
{
    static const char *const raised[] = { "\xC2\xB2", "\xC2\xB3", NULL };
    size_t n = begins_with(s, raised);
    if (n) return n;
    n = !strncmp(s, "**", 2) ? 2 : *s == '^';
    n += s[n] == '-';
    return isdigit((unsigned char)s[n]) && !isdigit((unsigned char)s[n + 1]) ? n + 1 : 0;
}

static size_t between_bytes(const char *s)
{
    static const char *const raised_dot[] = { "\xC2\xB7", NULL };
    size_t blank = strspn(s, " "), n = begins_with(s + blank, raised_dot);
    if (!n) n = s[blank] && strchr(".*/", s[blank]);
    return blank + (n ? n + strspn(s + blank + n, " ") : 0);
}

/* The first place at which a text is not a unit by the grammar above; NULL when it is one. */
static const char *unit_fault(const char *s)
{
    int depth = 0;
    if (strlen(s) > UNIT_BYTES) return s + UNIT_BYTES;
    for (;;) {
        for (; *s == '('; s++)
            if (++depth > UNIT_DEPTH) return s;
        size_t n = word_bytes(s);
        if (!n) return s;
        s += n;
        s += exponent_bytes(s);
        for (; *s == ')'; s += 1 + exponent_bytes(s + 1))
            if (--depth < 0) return s;
        if (!*s) return depth ? s : NULL;
        if (!(n = between_bytes(s))) return s;
        s += n;
    }
}

/* Whether a text names an angle. UDUNITS gives angles and plain numbers the same dimension, so they are told
 * apart by the spelling. */
static bool angle_spelling(const char *s)
{
    static const char *const known[] = { "deg", "degree", "degrees", "\xC2\xB0", "rad", "radian", "radians" };
    for (size_t i = 0; i < WF_COUNT(known); i++)
        if (!strcmp(s, known[i])) return true;
    return false;
}

/* Read a text that passed the grammar. Returned: WF_OK and *out, NULL when UDUNITS does not know the unit;
 * WF_ENOMEM. */
static enum wf_status parse_unit(const struct wf_units *u, const char *text, ut_unit **out, struct wf_err *e)
{
    errno = 0;
    *out = room(UNIT_READING_BYTES) ? ut_parse(u->system, text, UT_UTF8) : NULL;
    if (*out || (errno != ENOMEM && ut_get_status() != UT_OS)) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for the unit '%s'", text);
}

/* Whether a unit is of dimension d. UDUNITS also converts to reciprocals (m3/kg to kg/m3): therefore a
 * dimensionless quotient is required. */
static enum wf_status fits(const struct wf_units *u, ut_unit *unit, enum wf_dimension d, bool *out,
                           struct wf_err *e)
{
    errno = 0;
    ut_unit *ratio = ut_divide(unit, u->si[d]);
    bool short_of_memory = !ratio && (errno == ENOMEM || ut_get_status() == UT_OS);
    *out = ratio && ut_is_dimensionless(ratio) && ut_are_convertible(unit, u->si[d]);
    if (ratio) ut_free(ratio);
    return short_of_memory ? wf_fail(e, WF_ENOMEM, "not enough memory for a unit") : WF_OK;
}

/* The unit named by `text`, which the caller frees. Returned: WF_OK and *out, NULL when it is not a unit of
 * dimension d; WF_ENOMEM. */
static enum wf_status unit_of(const struct wf_units *u, const char *text, enum wf_dimension d, ut_unit **out,
                              struct wf_err *e)
{
    bool right = false;
    *out = NULL;
    if (unit_fault(text)) return WF_OK;
    if (d == WF_DIM_NONE && strcmp(text, "%") != 0 && strcmp(text, "percent") != 0) return WF_OK;
    if (d == WF_DIM_ANGLE && !angle_spelling(text)) return WF_OK;
    for (size_t i = 0; i < WF_COUNT(aliases); i++)
        if (aliases[i].dimension == d &&
            !(d == WF_DIM_SPEED ? strcasecmp : strcmp)(text, aliases[i].spelling)) {
            text = aliases[i].meaning;
            break;
        }
    if (!text) return WF_OK;
    enum wf_status s = parse_unit(u, text, out, e);
    if (s || !*out) return s;
    s = fits(u, *out, d, &right, e);
    if (!s && right) return WF_OK;
    ut_free(*out);
    *out = NULL;
    return s;
}

/* Convert *v to SI where the unit was read before. */
static bool convert_kept(const struct wf_units *u, const char *text, enum wf_dimension d, double *v)
{
    for (size_t i = 0; i < u->kept; i++)
        if (u->keep[i].dimension == d && !strcmp(u->keep[i].text, text)) {
            *v = cv_convert_double(u->keep[i].to_si, *v);
            return true;
        }
    return false;
}

/* Convert *v to SI and keep the converter where there is room. */
static enum wf_status convert_new(struct wf_units *u, const char *text, ut_unit *unit, enum wf_dimension d,
                                  double *v, struct wf_err *e)
{
    cv_converter *c = ut_get_converter(unit, u->si[d]);
    if (!c) return wf_fail(e, WF_ENOMEM, "not enough memory to convert a unit");
    *v = cv_convert_double(c, *v);
    if (u->kept == UNITS_KEPT || strlen(text) >= UNIT_KEPT_BYTES) {
        cv_free(c);
        return WF_OK;
    }
    struct kept_unit *k = &u->keep[u->kept++];
    *k = (struct kept_unit){ .dimension = d, .to_si = c };
    strcpy(k->text, text);
    return WF_OK;
}

static enum wf_status convert(ut_unit *from, ut_unit *to, double *v, struct wf_err *e)
{
    cv_converter *c = ut_get_converter(from, to);
    if (!c) return wf_fail(e, WF_ENOMEM, "not enough memory to convert a unit");
    *v = cv_convert_double(c, *v);
    cv_free(c);
    return WF_OK;
}

bool wf_unit_known(const struct wf_units *u, const char *text)
{
    ut_unit *unit = NULL;
    if (unit_fault(text) || parse_unit(u, text, &unit, NULL)) return false;
    if (unit) ut_free(unit);
    return unit != NULL;
}

static enum wf_status refuse_unit(const struct wf_units *u, const char *text, const char *unit,
                                  enum wf_dimension d, struct wf_err *e)
{
    const struct wf_dimension_row *row = &dimension_rows[d];
    if (d == WF_DIM_NONE)
        return wf_fail(e, WF_EINPUT, "'%s': a plain number is expected, without '%s'", text, unit);
    const char *fault = unit_fault(unit);
    if (fault) {
        char why[48] = "it is not complete";
        size_t one = *fault ? 1 : 0;
        while (((unsigned char)fault[one] & 0xC0) == 0x80) one++;
        if (strlen(unit) > UNIT_BYTES)
            (void)snprintf(why, sizeof why, "it is longer than %d bytes", UNIT_BYTES);
        else if (one)
            (void)snprintf(why, sizeof why, "'%.*s' is not allowed there", (int)(one > 8 ? 8 : one), fault);
        return wf_fail(e, WF_EINPUT, "'%s': '%s' is not a known unit for %s (%s); use one of: %s", text, unit,
                       row->name, why, row->units);
    }
    ut_unit *other = NULL;
    enum wf_status s = parse_unit(u, unit, &other, e);
    if (s) return s;
    if (other) ut_free(other);
    return wf_fail(e, WF_EINPUT, "'%s': '%s' is not %s %s; use one of: %s", text, unit,
                   other ? "a unit of" : "a known unit for", row->name, row->units);
}

static enum wf_status refuse_number(const char *text, enum wf_dimension d, const char *unit, struct wf_err *e)
{
    if (isdigit((unsigned char)text[strspn(text, "+-.")]))
        return wf_fail(e, WF_EINPUT, "'%s' is beyond the range of numbers", text);
    if (d == WF_DIM_NONE) return wf_fail(e, WF_EINPUT, "'%s' is not a number; write for example '0.5'", text);
    return wf_fail(e, WF_EINPUT, "'%s' is not %s; write for example '1.5 %s'", text, dimension_rows[d].name,
                   unit);
}

enum wf_status wf_quantity_read_as(struct wf_units *u, const char *text, enum wf_dimension d,
                                   const char *usual, double *si, struct wf_err *e)
{
    char t[96];
    const char *from = text + strspn(text, " \t\n");
    size_t n = strlen(from);
    while (n && strchr(" \t\n", from[n - 1])) n--;
    if (!n) return wf_fail(e, WF_EINPUT, "the value is empty; %s is expected", dimension_rows[d].name);
    if (n >= sizeof t) return wf_fail(e, WF_EINPUT, "'%.40s...' is too long for a quantity", from);
    memcpy(t, from, n);
    t[n] = '\0';

    double v;
    const char *p = wf_number_read(t, t + n, '.', &v);
    if (!p) return refuse_number(t, d, usual, e);
    if (*p == ',' && isdigit((unsigned char)p[1]))
        return wf_fail(e, WF_EINPUT, "'%s' has a comma; write the decimals after a point", t);
    p += strspn(p, " \t");
    if (!*p && d != WF_DIM_NONE)
        return wf_fail(e, WF_EINPUT, "'%s' has no unit; write for example '%s %s'", t, t, usual);
    if (*p && !convert_kept(u, p, d, &v)) {
        ut_unit *unit;
        enum wf_status s = unit_of(u, p, d, &unit, e);
        if (s) return s;
        if (!unit) return refuse_unit(u, t, p, d, e);
        s = convert_new(u, p, unit, d, &v, e);
        ut_free(unit);
        if (s) return s;
    }
    if (!isfinite(v)) return wf_fail(e, WF_EINPUT, "'%s' is beyond the range of numbers", t);
    *si = v;
    return WF_OK;
}

enum wf_status wf_quantity_read(struct wf_units *u, const char *text, enum wf_dimension d, double *si,
                                struct wf_err *e)
{
    char first[32];
    (void)snprintf(first, sizeof first, "%.*s", (int)strcspn(dimension_rows[d].units, ","),
                   dimension_rows[d].units);
    return wf_quantity_read_as(u, text, d, first, si, e);
}

/* Convert *v from SI to a unit. Returned: WF_OK and *unit, the unit it is in ("" for a plain number);
 * WF_ENOMEM, and *v is unchanged. */
static enum wf_status in_unit(struct wf_units *u, double *v, enum wf_dimension d, const char **unit)
{
    ut_unit *to = NULL;
    struct wf_err why = { 0 };
    enum wf_status s = **unit ? unit_of(u, *unit, d, &to, &why) : WF_OK;
    if (to) {
        s = convert(u->si[d], to, v, &why);
        ut_free(to);
        if (!s) return WF_OK;
    }
    *unit = d == WF_DIM_NONE ? "" : dimension_rows[d].si;
    return s;
}

double wf_quantity_in(struct wf_units *u, double si, enum wf_dimension d, const char *unit)
{
    return in_unit(u, &si, d, &unit) ? (double)NAN : si;
}

char *wf_quantity_print(struct wf_units *u, double si, enum wf_dimension d, const char *unit, char *buf,
                        size_t size)
{
    (void)in_unit(u, &si, d, &unit);
    (void)snprintf(buf, size, "%.6g%s%s", si, *unit ? " " : "", unit);
    return buf;
}
