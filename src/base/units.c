/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/num.h"
#include <ctype.h>
#include <math.h>
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
    { WF_DIM_ANGLE, "deg", "degree" },   { WF_DIM_SPEED, "mph", "mile/hour" },
    { WF_DIM_SPEED, "kph", "km/hour" },  { WF_DIM_SPEED, "kmh", "km/hour" },
    { WF_DIM_SPEED, "kmph", "km/hour" }, { WF_DIM_SPEED, "km/h", "km/hour" },
    { WF_DIM_SPEED, "ms", "m/s" },       { WF_DIM_SPEED, "mps", "m/s" },
    { WF_DIM_SPEED, "m/s", "m/s" },      { WF_DIM_SPEED, "ms-1", "m/s" },
    { WF_DIM_SPEED, "cms", "cm/s" },     { WF_DIM_SPEED, "fps", "ft/s" },
    { WF_DIM_SPEED, "kn", "knot" },      { WF_DIM_SPEED, "kt", "knot" },
    { WF_DIM_SPEED, "kts", "knot" },     { WF_DIM_SPEED, "kns", "knot" },
    { WF_DIM_SPEED, "knot", "knot" },    { WF_DIM_SPEED, "knots", "knot" },
    { WF_DIM_SPEED, "c", NULL },         { WF_DIM_FORCE, "kp", "kgf" },
    { WF_DIM_FREQUENCY, "hz", "Hz" },
};

struct wf_units {
    ut_system *system;
    ut_unit *si[WF_DIM_COUNT];
};

const struct wf_dimension_row *wf_dimension_row(enum wf_dimension d)
{
    return &dimension_rows[(unsigned)d < WF_DIM_COUNT ? d : WF_DIM_NONE];
}

void wf_units_close(struct wf_units *u)
{
    if (!u) return;
    for (size_t i = 0; i < WF_DIM_COUNT; i++)
        if (u->si[i]) ut_free(u->si[i]);
    if (u->system) ut_free_system(u->system);
    free(u);
}

enum wf_status wf_units_open(struct wf_units **out, struct wf_err *e)
{
    (void)ut_set_error_message_handler(ut_ignore); /* by default UDUNITS writes to stderr */
    struct wf_units *u = calloc(1, sizeof *u);
    *out = u;
    if (!u) return wf_fail(e, WF_ENOMEM, "no memory for the units table");
    u->system = ut_read_xml(NULL);
    bool ok = u->system != NULL;
    for (size_t i = 0; ok && i < WF_DIM_COUNT; i++)
        ok = (u->si[i] = ut_parse(u->system, dimension_rows[i].si, UT_UTF8)) != NULL;
    if (ok) return WF_OK;
    wf_units_close(u);
    *out = NULL;
    return wf_fail(e, WF_EMISSING,
                   "the units database of UDUNITS-2 cannot be read (package libudunits2-data)");
}

/* Whether a text is a unit as it is normally written: letters, products, quotients and small powers. UDUNITS
 * also accepts factors, origins and logarithms ("2 GPa", "m @ 3", "lg(re 1 mW)"), which in a quantity are
 * mistakes. */
static bool plain_unit(const char *s)
{
    if (strlen(s) > 60) return false;
    for (size_t i = 0; s[i]; i++) {
        unsigned char c = (unsigned char)s[i];
        char before = i ? s[i - 1] : '\0';
        bool power = before == '^' || before == '-' || isalpha((unsigned char)before);
        if (isdigit(c) ? !power || isdigit((unsigned char)s[i + 1])
                       : !(isalpha(c) || c >= 0x80 || strchr(" ./*^-%", c)))
            return false;
    }
    return true;
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

/* The unit named by `text`; NULL when it is not a unit of dimension d. The caller frees it. */
static ut_unit *unit_of(const struct wf_units *u, const char *text, enum wf_dimension d)
{
    if (!plain_unit(text)) return NULL;
    if (d == WF_DIM_NONE && strcmp(text, "%") != 0 && strcmp(text, "percent") != 0) return NULL;
    if (d == WF_DIM_ANGLE && !angle_spelling(text)) return NULL;
    for (size_t i = 0; i < WF_COUNT(aliases); i++)
        if (aliases[i].dimension == d &&
            !(d == WF_DIM_SPEED ? strcasecmp : strcmp)(text, aliases[i].spelling)) {
            text = aliases[i].meaning;
            break;
        }
    if (!text) return NULL;
    ut_unit *unit = ut_parse(u->system, text, UT_UTF8);
    if (!unit) return NULL;
    /* UDUNITS also converts to reciprocals (m3/kg to kg/m3): therefore require a dimensionless quotient */
    ut_unit *ratio = ut_divide(unit, u->si[d]);
    bool fits = ratio && ut_is_dimensionless(ratio) && ut_are_convertible(unit, u->si[d]);
    if (ratio) ut_free(ratio);
    if (fits) return unit;
    ut_free(unit);
    return NULL;
}

static double converted(ut_unit *from, ut_unit *to, double v)
{
    cv_converter *c = ut_get_converter(from, to);
    if (!c) return NAN;
    v = cv_convert_double(c, v);
    cv_free(c);
    return v;
}

bool wf_unit_known(const struct wf_units *u, const char *text)
{
    ut_unit *unit = plain_unit(text) ? ut_parse(u->system, text, UT_UTF8) : NULL;
    if (unit) ut_free(unit);
    return unit != NULL;
}

static enum wf_status refuse_unit(const struct wf_units *u, const char *text, const char *unit,
                                  enum wf_dimension d, struct wf_err *e)
{
    if (d == WF_DIM_NONE)
        return wf_fail(e, WF_EINPUT, "'%s': a plain number is expected, without '%s'", text, unit);
    bool other = wf_unit_known(u, unit);
    return wf_fail(e, WF_EINPUT, "'%s': '%s' is not %s %s; use one of: %s", text, unit,
                   other ? "a unit of" : "a known unit for", dimension_rows[d].name, dimension_rows[d].units);
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
    if (*p) {
        ut_unit *unit = unit_of(u, p, d);
        if (!unit) return refuse_unit(u, t, p, d, e);
        v = converted(unit, u->si[d], v);
        ut_free(unit);
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

/* Value in a unit; *unit becomes the one it is in, "" for a plain number. */
static double in_unit(struct wf_units *u, double si, enum wf_dimension d, const char **unit)
{
    ut_unit *to = **unit ? unit_of(u, *unit, d) : NULL;
    double v = to ? converted(u->si[d], to, si) : si;
    if (!to) *unit = d == WF_DIM_NONE ? "" : dimension_rows[d].si;
    if (to) ut_free(to);
    return v;
}

double wf_quantity_in(struct wf_units *u, double si, enum wf_dimension d, const char *unit)
{
    return in_unit(u, si, d, &unit);
}

char *wf_quantity_print(struct wf_units *u, double si, enum wf_dimension d, const char *unit, char *buf,
                        size_t size)
{
    double v = in_unit(u, si, d, &unit);
    (void)snprintf(buf, size, "%.6g%s%s", v, *unit ? " " : "", unit);
    return buf;
}
