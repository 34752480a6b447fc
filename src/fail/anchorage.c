/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fail/anchorage.h"
#include "base/column.h"
#include "base/num.h"
#include "base/said.h"
#include "base/text.h"
#include "data/section.h"
#include "data/species.h"
#include "fail/fail.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* `held`: coefficients of ForestGALES' table after Nicoll et al. 2006 (Can. J. For. Res. 36:1871) for all
 * depths of roots together; the ratios are the same to 1 % for its eleven conifers. */
const struct wf_soil wf_soils[] = {
    { "mineral", "freely draining mineral soil", true, 1,
      "mineral mineral_soil sand sandy sandy_soil loam loamy sandy_loam gravel brown_earth mineralboden "
      "sandboden "
      "lehm lehmboden kies braunerde sol_mineral sable sableux gravier sol_brun 矿质土 矿质土壤 砂土 沙土 "
      "壤土 砾石土" },
    { "gleyed", "gleyed mineral soil", true, 0.887,
      "gleyed gley gleyic gleysol gleyed_mineral surface_water_gley ground_water_gley stagnogley gleyboden "
      "vergleyt pseudogley stagnogley sol_a_gley gleyifie 潜育土 潜育" },
    { "peaty", "peaty mineral soil", true, 0.968,
      "peaty peaty_mineral peaty_mineral_soil anmoor anmoorig anmoorboden tourbeux sol_tourbeux 泥炭质土" },
    { "peat", "deep peat", true, 1.10,
      "peat deep_peat bog torf torfboden moor hochmoor tourbe tourbiere 泥炭 泥炭土" },
    { "unknown", "not known", false, NAN, "unknown not_known unbekannt inconnu 未知 不明" },
    { 0 },
};

const char *wf_soil_meant(const char *word)
{
    for (const struct wf_soil *s = wf_soils; s->name; s++)
        if (wf_text_among(s->others, word)) return s->name;
    return NULL;
}

static const char *const rootings[] = { "shallow", "medium", "deep", NULL };

/* ---- What the methods take of a tree ---- */

static size_t stems(const struct wf_tree *t)
{
    size_t n = 0;
    for (size_t i = 0; i < t->n; i++) n += t->parent[i] < 0;
    return n;
}

/* Mass of the wood of rows of level 0, whose radii vary linearly [kg]. */
static double stem_mass(const struct wf_tree *t)
{
    double mass = 0;
    for (size_t i = 0; i < t->n; i++) {
        if (t->level[i] != 0) continue;
        double middle = wf_ring_area(0.5 * (t->r0[i] + t->r1[i]), 0.5 * (t->i0[i] + t->i1[i]));
        double area = (wf_ring_area(t->r0[i], t->i0[i]) + 4 * middle + wf_ring_area(t->r1[i], t->i1[i])) / 6;
        mass += area * wf_tree_length(t, i) * t->density[i];
    }
    return mass;
}

static bool is_culm(const struct wf_species *sp) { return sp->levels && sp->level[0].wall.n; }

static bool is_species(const struct wf_species *sp, const char *latin)
{
    return sp->latin && strstr(sp->latin, latin);
}

static enum wf_status say(struct wf_anchorage *out, struct wf_arena *a, struct wf_err *e, const char *fmt,
                          ...) __attribute__((format(printf, 4, 5)));
static enum wf_status say(struct wf_anchorage *out, struct wf_arena *a, struct wf_err *e, const char *fmt,
                          ...)
{
    va_list args;
    va_start(args, fmt);
    struct wf_said *said = WF_TAKE(a, 1, struct wf_said);
    bool whole = said && wf_said_take(a, fmt, args, said);
    va_end(args);
    out->said = said;
    out->text = whole ? wf_said_put(a, said->message, said->arg, said->n) : NULL;
    return out->text ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the anchorage");
}

/* ---- Tests on the tree itself ---- */

/* A quarter of a degree is reached at 40 % of the anchorage. */
static const double over_quarter_degree = 2.5;

static enum wf_status find_pull(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                struct wf_err *e)
{
    (void)t, (void)sp;
    out->moment = over_quarter_degree * q->pull_moment;
    return say(out, a, e, "2.5 x %.4g kN m at 0.25 deg", 1e-3 * q->pull_moment);
}

static enum wf_status find_secant(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                  const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                  struct wf_err *e)
{
    (void)t, (void)sp;
    out->moment = over_quarter_degree * 0.25 * (WF_PI / 180) * q->secant;
    return say(out, a, e, "0.0109 rad x %.4g kN m/rad, secant at 0.25 deg", 1e-3 * q->secant);
}

struct wf_tipping_curve {
    const char *file;
    size_t n;
    double *angle, *moment; /* [rad], ascending; [N m] */
};

static size_t curve_top(const struct wf_tipping_curve *c)
{
    size_t top = 0;
    for (size_t i = 1; i < c->n; i++)
        if (c->moment[i] > c->moment[top]) top = i;
    return top;
}

static enum wf_status find_curve(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                 const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                 struct wf_err *e)
{
    (void)t, (void)sp;
    const struct wf_tipping_curve *c = q->curve;
    size_t top = curve_top(c);
    out->moment = c->moment[top];
    return say(out, a, e, "largest of %zu moments of %s, at %.3g deg%s", c->n, c->file,
               c->angle[top] * 180 / WF_PI, top + 1 == c->n ? ", its end: a lower bound" : "");
}

/* ---- By size ---- */

/* Geometric means of M_a / (d^2 h) and standard deviations of their logarithm, of the trees of Detter, van
 * Wassenaer & Rust 2023. */
static const struct size_row {
    const char *latin; /* NULL: all together */
    double factor;     /* [N m-2] */
    double scatter;
    int trees;
} sizes[] = {
    { "Picea abies", 24.8e3, 0.32, 65 },    { "Pinus sylvestris", 32.6e3, 0.25, 42 },
    { "Betula pendula", 30.7e3, 0.34, 57 }, { "Fraxinus excelsior", 32.3e3, 0.47, 47 },
    { "Populus", 34.5e3, 0.55, 14 },        { "Fagus sylvatica", 50.7e3, 0.27, 18 },
    { "Platanus x", 51.7e3, 0.20, 11 },     { "Acer pseudoplatanus", 61.5e3, 0.62, 6 },
    { NULL, 32.9e3, 0.435, 267 },
};

/* Why neither size nor mass says anything of a tree; NULL: nothing is in the way. */
static const char *not_by_size(const struct wf_tree *t, const struct wf_species *sp)
{
    if (is_culm(sp)) return "no anchorage test of hollow culms is known, and trees say nothing of them";
    return stems(t) > 1 ? "it has several stems, and the measured trees had one" : NULL;
}

static enum wf_status find_size(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                struct wf_err *e)
{
    const struct wf_breast breast = wf_tree_breast(t);
    double d = breast.diameter, h = wf_tree_height(t);
    const char *why = isnan(d) ? "the stem is shorter than 1.3 m" : not_by_size(t, sp);
    const struct size_row *row = sizes;
    if (q->grown > 0) h = q->grown;
    if (why) return say(out, a, e, "%s", why);
    while (row->latin && !is_species(sp, row->latin)) row++;
    out->moment = row->factor * d * d * h;
    out->scatter = row->scatter;
    return say(out, a, e, "%.3g kN m/m3 x d^2 h (d %.3g m at 1.3 m%s, h %.4g m), %d trees %s%s",
               1e-3 * row->factor, d, breast.forked ? " of the thickest limb of a stem that forks below" : "",
               h, row->trees, row->latin ? "of " : "of 9 other species or groups together: none of ",
               row->latin  ? row->latin
               : sp->latin ? sp->latin
                           : sp->name);
}

/* Anchorage per mass of the stem where a paper states it; British Columbia, Byrne 2005. */
static const struct mass_row {
    const char *latin;
    double factor; /* [N m kg-1] */
} masses[] = {
    { "Pinus contorta", 145.6 },
    { "Picea glauca x engelmannii", 118.6 },
    { "Thuja plicata", 94.5 },
    { "Tsuga heterophylla", 77.4 },
};

static enum wf_status take_mass(double factor, const struct wf_tree *t, const char *of, const char *where,
                                struct wf_arena *a, struct wf_anchorage *out, struct wf_err *e)
{
    double mass = stem_mass(t);
    out->moment = factor * mass;
    return say(out, a, e, "%.4g N m/kg x %.4g kg of the stem's wood, %s, %s", factor, mass, of, where);
}

static enum wf_status find_mass(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                struct wf_err *e)
{
    const char *why = not_by_size(t, sp);
    (void)q;
    for (size_t i = 0; !why && i < WF_COUNT(masses); i++)
        if (is_species(sp, masses[i].latin))
            return take_mass(masses[i].factor, t, masses[i].latin, "British Columbia", a, out, e);
    return say(out, a, e, "%s",
               why ? why : "no paper that was read gives an anchorage per stem mass of this species");
}

/* ---- A table of the user ---- */

struct table_row {
    const char *species, *soil, *rooting; /* blank: any of these */
    double factor;                        /* [N m kg-1] */
};
struct wf_anchorage_table {
    const char *file;
    size_t n;
    struct table_row *row;
};

static bool names_species(const struct wf_species *sp, const char *text)
{
    const char *const own[] = { sp->key, sp->name, sp->latin };
    for (size_t i = 0; i < WF_COUNT(own); i++)
        if (own[i] && !strcasecmp(own[i], text)) return true;
    return false;
}

static bool fits(const char *cell, const char *said) { return !*cell || (said && !strcasecmp(cell, said)); }

static enum wf_status find_table(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                 const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                 struct wf_err *e)
{
    const struct wf_anchorage_table *all = q->table;
    const struct table_row *found = NULL;
    const char *why = not_by_size(t, sp);
    size_t same = 0, fitting = 0;
    if (why) return say(out, a, e, "%s", why);
    for (size_t i = 0; i < all->n; i++) {
        const struct table_row *r = &all->row[i];
        if (!names_species(sp, r->species)) continue;
        same++;
        if (fits(r->soil, q->soil) && fits(r->rooting, q->rooting)) fitting++, found = r;
    }
    if (fitting != 1)
        return wf_fail(
            e, WF_EINPUT,
            "%s: %zu of its %zu rows for %s fit%s soil '%s' and rooting '%s'; one must. --soil and "
            "--rooting say which",
            all->file, fitting, same, sp->name, fitting == 1 ? "s" : "", q->soil ? q->soil : "not given",
            q->rooting ? q->rooting : "not given");
    return take_mass(found->factor, t, sp->name, all->file, a, out, e);
}

/* ---- The methods ---- */

#define PULLED "Detter, van Wassenaer & Rust 2023, Forests 14:533"
#define BY_WEIGHT "the moment is taken as the applied one"

const struct wf_anchorage_method wf_anchorage_methods[] = {
    { "pull", "2.5 times the moment at 0.25 deg of a pulling test", PULLED,
      "more than 280 trees of 15 species, as tested; scatter is a rule of ours between 0.23 (with the "
      "species) "
      "and 0.33 (by size); " BY_WEIGHT,
      0.33, false, false, find_pull },
    { "secant", "0.0109 rad times the root's secant stiffness at 0.25 deg", PULLED,
      "stiffness fitted at 0.25 deg: one of smaller angles is too high, because the curve "
      "softens; " BY_WEIGHT,
      0.33, false, false, find_secant },
    { "curve", "largest moment of a tipping curve", "the file given",
      "the tree and the soil that were tested", NAN, false, false, find_curve },
    { "size", "a d^2 h by species", PULLED,
      "trees nobody pulled: geometric means of 9 species or groups in several soils; the denominator d^2 h "
      "was "
      "inferred from its data; sizes and soils of those trees were not read; " BY_WEIGHT,
      NAN, false, true, find_size },
    { "mass", "anchorage per stem mass", "Byrne 2005, by its abstract",
      "conifers of British Columbia; scatter is a rule of ours, that of all trees by size; whether weight "
      "counts "
      "was not read",
      0.44, false, true, find_mass },
    { "table", "anchorage per stem mass of a table", "the file given",
      "as the table; scatter is a rule of ours, that of all trees by size", 0.44, false, false, find_table },
    { 0 },
};

const struct wf_anchorage_method *wf_anchorage_method_named(const char *name)
{
    for (const struct wf_anchorage_method *m = wf_anchorage_methods; m->name; m++)
        if (strcmp(m->name, name) == 0) return m;
    return NULL;
}

/* The row of that name; that of the soil that is not known where there is none. */
static const struct wf_soil *soil_named(const char *name)
{
    const struct wf_soil *s = wf_soils;
    while (s->known && !(name && !strcmp(s->name, name))) s++;
    return s;
}

static bool soil_known(const char *name) { return soil_named(name)->known; }

/* The method of a request; NULL: none. Errors: several. */
static enum wf_status choose(const struct wf_anchorage_request *q, const struct wf_anchorage_method **out,
                             struct wf_err *e)
{
    const struct {
        const char *name;
        bool given;
    } own[] = { { "pull", q->pull_moment > 0 },
                { "secant", q->secant > 0 },
                { "curve", q->curve != NULL },
                { "table", q->table != NULL } };
    const char *name = q->method;
    for (size_t i = 0; i < WF_COUNT(own); i++) {
        if (!own[i].given) continue;
        if (name)
            return wf_fail(e, WF_EUSAGE,
                           "the anchorage is given twice, by the methods '%s' and '%s'; give one of them",
                           name, own[i].name);
        name = own[i].name;
    }
    if (!name && soil_known(q->soil)) name = "size";
    *out = name ? wf_anchorage_method_named(name) : NULL;
    return name && !*out ? wf_fail(e, WF_EUSAGE, "there is no method of anchorage '%s'", name) : WF_OK;
}

enum wf_status wf_anchorage_find(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                 const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                 struct wf_err *e)
{
    *out = (struct wf_anchorage){ .moment = NAN, .scatter = NAN, .text = WF_ANCHORAGE_UNSAID };
    const struct wf_anchorage_method *m = NULL;
    enum wf_status s = q ? choose(q, &m, e) : WF_OK;
    if (s || !m) return s;
    out->scatter = m->scatter;
    s = m->find(q, t, sp, a, out, e);
    if (!s && q->lost > 0 && out->moment > 0)
        s = say(out, a, e, "%s; %.3g %% of the roots lost over %.3g deg", out->text, 100 * q->lost,
                2 * q->lost_half * 180 / WF_PI);
    if (s || !(out->moment > 0)) return s;
    out->method = m;
    out->by_method = out->moment, out->carried = q->carried;
    out->moment = wf_anchorage_varied(out, 1);
    if (m->any_soil) out->soil = soil_named(q->soil);
    if (m->any_soil && out->soil->known) out->scatter = hypot(out->scatter, log(out->soil->held));
    return WF_OK;
}

double wf_anchorage_varied(const struct wf_anchorage *q, double factor)
{
    return fmax(q->carried, factor * q->by_method);
}

/* A rule of ours. Pulled to 1 deg, red maples lost force in nearly direct proportion to the roots that were
 * severed, up to half the circumference (Smiley et al. 2014, Arboric. Urban For. 40:230); willow oaks lost
 * 12 % with one root, 30 % with half of them, 35 % by a tangential cut at the stem (Smiley 2008, 34:123).
 * None says how it depends on the direction. The larger of two shares is taken: that of the circumference,
 * and that with roots weighted by 1 + cos of their direction from the wind, 82 % for all roots to windward.
 */
double wf_anchorage_left(const struct wf_anchorage_request *q, double azimuth)
{
    const double least = 1e-3; /* an anchorage of 0 would be one that is not known */
    if (!(q->lost > 0)) return 1;
    double windward = -sin(q->lost_half) * cos(q->lost_middle - azimuth);
    return fmax(least, 1 - q->lost * (q->lost_half + fmax(0, windward)) / WF_PI);
}

/* ---- Files ---- */

enum { ROWS_MAX = 10000 };

static bool falls_first(const struct wf_tipping_curve *c)
{
    for (size_t i = 1; i < c->n; i++)
        if (c->moment[i] != c->moment[i - 1]) return c->moment[i] < c->moment[i - 1];
    return true;
}

static void read_point(struct wf_csv *csv, const size_t column[2], const double unit[2],
                       struct wf_tipping_curve *c)
{
    const double upright = 0.5 * WF_PI, most = 1e9;
    size_t k = c->n;
    if (!wf_column_number(csv, column[0], unit[0], 0, upright, &c->angle[k]) ||
        !wf_column_number(csv, column[1], unit[1], 0, most, &c->moment[k]))
        return;
    c->n++;
    if (k && c->angle[k] <= c->angle[k - 1])
        wf_csv_mistake(csv, column[0], "angles must ascend; %.4g deg follows %.4g deg",
                       c->angle[k] * 180 / WF_PI, c->angle[k - 1] * 180 / WF_PI);
    else if (k && c->moment[k] != c->moment[k - 1] && falls_first(c) && c->moment[0] == c->moment[k - 1])
        wf_csv_mistake(csv, column[1], "the curve falls before it rises: %.4g kN m follows %.4g kN m",
                       1e-3 * c->moment[k], 1e-3 * c->moment[k - 1]);
}

/* What is doubtful about the largest moment of a curve. */
static void doubt_top(const struct wf_tipping_curve *c, const char *path, struct wf_diag *d)
{
    const double dip = 0.9; /* rule of ours: less is scatter of the test */
    size_t top = curve_top(c), first = 0;
    if (top + 1 == c->n)
        wf_diag_warn(d, "tipping-curve-end",
                     "%s: the curve still rises at its end; its last moment, %.4g kN m, is taken as the "
                     "anchorage, which is a lower bound",
                     path, 1e-3 * c->moment[c->n - 1]);
    for (size_t i = 1; i < top; i++) {
        if (c->moment[i] > c->moment[first]) first = i;
        if (!(c->moment[i] < dip * c->moment[first])) continue;
        wf_diag_warn(
            d, "tipping-curve-dip",
            "%s: the curve falls from %.4g to %.4g kN m before its largest moment, %.4g kN m, which is "
            "taken as the anchorage: a load that lasts drives the tree on from the first of these",
            path, 1e-3 * c->moment[first], 1e-3 * c->moment[i], 1e-3 * c->moment[top]);
        return;
    }
}

enum wf_status wf_tipping_curve_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                     const struct wf_tipping_curve **out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    struct wf_units *units;
    struct wf_tipping_curve *c = WF_TAKE(a, 1, struct wf_tipping_curve);
    double unit[2];
    size_t errors = d->errors, column[2];
    if (!c || !(c->angle = WF_TAKE(a, ROWS_MAX, double)) || !(c->moment = WF_TAKE(a, ROWS_MAX, double)))
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a curve", path);
    enum wf_status s = wf_csv_open(&csv, path, a, d, e);
    if (!s) s = wf_units_open(&units, e);
    if (s) return s;
    column[0] = wf_column_need(&csv, units, "phi_deg", WF_DIM_ANGLE, &unit[0], e);
    column[1] = wf_column_need(&csv, units, "moment_kNm", WF_DIM_MOMENT, &unit[1], e);
    wf_units_close(units);
    while (d->errors == errors && c->n < ROWS_MAX && wf_csv_next(&csv)) read_point(&csv, column, unit, c);
    if (d->errors == errors && c->n == ROWS_MAX)
        wf_diag_error(d, path, 0, 0, "the curve has %d points or more", (int)ROWS_MAX);
    if (d->errors == errors && falls_first(c))
        wf_diag_error(d, path, 0, 0,
                      "the curve does not rise: its moments must grow with the angle before "
                      "they may fall");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a tipping curve", path);
    doubt_top(c, path, d);
    c->file = path;
    *out = c;
    return WF_OK;
}

/* A cell that is blank or one of the words. */
static bool blank_or(const char *cell, bool (*word)(const char *text)) { return !*cell || word(cell); }

static bool is_soil(const char *text)
{
    const char *meant = wf_soil_meant(text);
    return meant && soil_known(meant);
}

static bool is_rooting(const char *text)
{
    for (const char *const *r = rootings; *r; r++)
        if (!strcasecmp(*r, text)) return true;
    return false;
}

static void read_factor(struct wf_csv *csv, const size_t column[4], struct wf_arena *a, struct table_row *r)
{
    const double least = 1, most = 2000; /* [N m kg-1]; 77 to 207 are known */
    r->species = wf_arena_text(a, wf_csv_text(csv, column[0]));
    const char *soil = wf_csv_text(csv, column[1]), *meant = *soil ? wf_soil_meant(soil) : NULL;
    r->soil = meant ? meant : wf_arena_text(a, soil);
    r->rooting = wf_arena_text(a, wf_csv_text(csv, column[2]));
    if (!*wf_csv_text(csv, column[0])) wf_csv_mistake(csv, column[0], "a species is needed");
    if (!blank_or(wf_csv_text(csv, column[1]), is_soil))
        wf_csv_mistake(csv, column[1], "'%.40s' is not mineral, gleyed, peaty, peat or blank (any)",
                       wf_csv_text(csv, column[1]));
    if (!blank_or(wf_csv_text(csv, column[2]), is_rooting))
        wf_csv_mistake(csv, column[2], "'%.40s' is not shallow, medium, deep or blank (any)",
                       wf_csv_text(csv, column[2]));
    (void)wf_csv_number(csv, column[3], least, most, &r->factor);
}

enum wf_status wf_anchorage_table_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                       const struct wf_anchorage_table **out, struct wf_err *e)
{
    static const char *const names[] = { "species", "soil", "rooting", "Nm_per_kg" };
    struct wf_csv csv = { 0 };
    struct wf_anchorage_table *t = WF_TAKE(a, 1, struct wf_anchorage_table);
    size_t errors = d->errors, column[WF_COUNT(names)];
    if (!t || !(t->row = WF_TAKE(a, ROWS_MAX, struct table_row)))
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a table", path);
    enum wf_status s = wf_csv_open(&csv, path, a, d, e);
    if (s) return s;
    for (size_t i = 0; i < WF_COUNT(names); i++) column[i] = wf_csv_need(&csv, names[i]);
    bool complete = d->errors == errors;
    while (complete && t->n < ROWS_MAX && wf_csv_next(&csv)) read_factor(&csv, column, a, &t->row[t->n++]);
    if (d->errors == errors && (!t->n || t->n == ROWS_MAX))
        wf_diag_error(d, path, 0, 0, "the table has %s rows", t->n ? "too many" : "no");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a table of anchorage", path);
    for (size_t i = 0; i < t->n; i++)
        if (!t->row[i].species || !t->row[i].soil || !t->row[i].rooting)
            return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a table", path);
    t->file = path;
    *out = t;
    return WF_OK;
}

/* ---- The criterion: it belongs to the first row, which stands on the ground ---- */

bool wf_overturning_known(const struct wf_tree *t, size_t row) { return row == 0 && t->anchorage > 0; }

/* The moment on the ground is that of the bent tree, with its weight. */
static double overturning(const struct wf_tree *t, const struct wf_response *r, size_t row, double left,
                          double *place)
{
    *place = 0;
    if (!wf_overturning_known(t, row)) return NAN;
    double demand = hypot(r->base_moment[0], r->base_moment[1]);
    return demand > 0 ? left * t->anchorage / demand : INFINITY;
}

double wf_overturning_safety(const struct wf_tree *t, const struct wf_response *r,
                             const struct wf_breakage *b, size_t row, double *place)
{
    (void)b;
    return overturning(t, r, row, 1, place);
}

double wf_overturning_safety_wet(const struct wf_tree *t, const struct wf_response *r,
                                 const struct wf_breakage *b, size_t row, double *place)
{
    (void)b;
    return overturning(t, r, row, WF_SATURATED_HIGH, place);
}

double wf_overturning_safety_wettest(const struct wf_tree *t, const struct wf_response *r,
                                     const struct wf_breakage *b, size_t row, double *place)
{
    (void)b;
    return overturning(t, r, row, WF_SATURATED_LOW, place);
}
