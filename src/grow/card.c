/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/card.h"
#include "base/num.h"
#include "data/crown_mass.h"
#include "data/species.h"
#include "grow/silhouette.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- What is known of stems and crowns by genus ---- */

/* Half-way up the forest pines, spruces and birches have 0.63 to 0.70 of the diameter at breast height: 0.57
 * to 0.74 as powers of the distance from the top, or 0.88 to 1.14 of the power 0.65. Other laws vary as much.
 */
#define AS_FORESTS .low = 0.88, .high = 1.14

#define NORDIC                                                                                               \
    "Laasasenaho J. 1982. Commun. Inst. For. Fenn. 108, taper curves, as coded in dmela/Laasasenaho"

/* Ends at name == NULL; the last row is for all genera. */
static const struct wf_stem_form stem_forms[] = {
    { .name = "pine",
      .genus = "Pinus",
      AS_FORESTS,
      .c = { 2.1288, -0.63157, -1.6082, 2.4886, -2.4147, 2.3619, -1.7539, 1.0817 },
      .source = NORDIC,
      .validity = "Scots pine in forests of Finland, diameter over bark" },
    { .name = "spruce",
      .genus = "Picea",
      AS_FORESTS,
      .c = { 2.3366, -3.2684, 3.6513, -2.2608, 0, 2.1501, -2.7412, 1.8876 },
      .source = NORDIC,
      .validity = "Norway spruce in forests of Finland, diameter over bark" },
    { .name = "power",
      .power = 0.65,
      AS_FORESTS,
      .source =
          "assumed: half-way up a stem of 20 m 0.63 to 0.70 of the dbh, as in the taper curves of forest "
          "pine, spruce and birch (Laasasenaho 1982; Hansen et al. 2023)",
      .validity = "no law was found for open-grown trees" },
    { .name = NULL },
};

#define OPENBARD                                                                                             \
    "regression on street and park trees of the United Kingdom (OpenBARD, data of Fennell 2024, Zenodo "     \
    "15593688)"

/* dbh of trees of this height and crown width by regression: is the card credible? The last row is for all
 * genera. */
struct allometry {
    const char *genus; /* NULL: all others */
    double a, b, c;    /* dbh [cm] = a height^b width^c [m] */
    double sd;         /* of ln dbh */
    const char *source;
};
static const struct allometry allometries[] = {
    { "Quercus", 3.453, 0.4406, 0.6786, 0.367, OPENBARD },
    { "Fraxinus", 3.510, 0.3615, 0.6656, 0.371, OPENBARD },
    { "Acer", 2.644, 0.6005, 0.5278, 0.368, OPENBARD },
    { "Betula", 2.776, 0.5176, 0.5320, 0.285, OPENBARD },
    { "Platanus", 2.510, 0.5271, 0.5978, 0.305, OPENBARD },
    { "Aesculus", 4.024, 0.5680, 0.5155, 0.354, OPENBARD },
    { "Pinus", 5.099, 0.4977, 0.4522, 0.245, OPENBARD },
    { "Tilia", 6.271, 0.4868, 0.3422, 0.384, OPENBARD },
    { "Fagus", 2.703, 0.3218, 0.8909, 0.312, OPENBARD },
    { "Alnus", 3.849, 0.5269, 0.3988, 0.365, OPENBARD },
    { "Carpinus", 4.288, 0.2612, 0.6596, 0.319, OPENBARD },
    { NULL, 3.278, 0.4964, 0.5933, 0.405, OPENBARD },
};

static bool is_genus(const char *latin, const char *genus)
{
    size_t n = strlen(genus);
    return latin && !strncmp(latin, genus, n) && (latin[n] == ' ' || !latin[n]);
}

const struct wf_stem_form *wf_stem_form_of(const char *latin)
{
    const struct wf_stem_form *f = stem_forms;
    while (f->genus && !is_genus(latin, f->genus)) f++;
    return f;
}

static const struct allometry *allometry_of(const char *latin)
{
    const struct allometry *r = allometries;
    while (r->genus && !is_genus(latin, r->genus)) r++;
    return r;
}

static double polynomial(const struct wf_stem_form *f, double x)
{
    static const double exponent[8] = { 1, 2, 3, 5, 8, 13, 21, 34 };
    double sum = 0;
    for (int k = 0; k < 8; k++) sum += f->c[k] * pow(x, exponent[k]);
    return sum;
}

double wf_stem_form_share(const struct wf_stem_form *f, double height, double at)
{
    if (at <= WF_BREAST_HEIGHT) return 1;
    if (at >= height) return 0;
    if (f->power > 0) return pow((height - at) / (height - WF_BREAST_HEIGHT), f->power);
    return fmin(1, polynomial(f, 1 - at / height) / polynomial(f, 1 - WF_BREAST_HEIGHT / height));
}

/* ---- Is the card possible, is it usual? ---- */

/* What is over bark at breast height, from what the card gives [m]. */
static double card_dbh(const struct wf_card *c) { return c->dbh > 0 ? c->dbh : c->girth / WF_PI; }

/* Sizes of the largest trees known; in a message, what is wrong beyond them. */
static const struct limit {
    const char *name;
    double low, high; /* [m] */
    const char *why;
} limits[WF_CARD_VALUES] = {
    [WF_CARD_HEIGHT] = { "height", 2, 120, "the tallest tree known is 116 m high" },
    [WF_CARD_GIRTH] = { "girth", 0.05, 40, "the thickest trunk known is some 36 m around" },
    [WF_CARD_DBH] = { "dbh", 0.015, 12, "the thickest trunk known is some 11.6 m through" },
    [WF_CARD_WIDTH] = { "crown width", 0.2, 80, "the widest crowns known are some 60 m wide" },
    [WF_CARD_BASE] = { "crown base", 0, 120, "it is a height above the ground" },
};

static double value_of(const struct wf_card *c, enum wf_card_value v)
{
    const double value[] = { c->height, c->girth, c->dbh, c->crown_width, c->crown_base };
    return value[v];
}

__attribute__((format(printf, 3, 4))) static bool wrong(char *why, size_t size, const char *fmt, ...)
{
    va_list list;
    va_start(list, fmt);
    (void)vsnprintf(why, size, fmt, list);
    va_end(list);
    return true;
}

static bool contradicts(const struct wf_card *c, enum wf_card_value v, char *why, size_t size)
{
    const double most = 0.25; /* dbh over height */
    bool thick = card_dbh(c) > most * c->height, girth = c->girth > 0;
    if (v == WF_CARD_GIRTH && girth && thick)
        return wrong(why, size,
                     "%.4g m makes a stem %.3g m thick, more than a quarter of the height of %.4g m",
                     c->girth, card_dbh(c), c->height);
    if (v == WF_CARD_DBH && !girth && thick)
        return wrong(why, size, "%.4g m is more than a quarter of the height of %.4g m. Is it the girth?",
                     c->dbh, c->height);
    if (v == WF_CARD_DBH && girth && c->dbh > 0 && fabs(c->girth / WF_PI - c->dbh) > 0.02 * c->dbh)
        return wrong(why, size,
                     "%.4g m and the girth of %.4g m disagree: %.4g m around is %.4g m through. Give one",
                     c->dbh, c->girth, c->girth, c->girth / WF_PI);
    if (v == WF_CARD_BASE && c->crown_base >= c->height)
        return wrong(why, size, "%.4g m is not below the top of the tree at %.4g m", c->crown_base,
                     c->height);
    return false;
}

bool wf_card_wrong(const struct wf_card *c, enum wf_card_value v, char *why, size_t size)
{
    const struct limit *x = &limits[v];
    double value = value_of(c, v);
    if (v == WF_CARD_HEIGHT && isnan(value)) return wrong(why, size, "is needed, from the ground to the top");
    if (v == WF_CARD_GIRTH && isnan(value) && isnan(c->dbh))
        return wrong(why, size, "is needed, or the dbh: of the stem at 1.3 m above the ground, over bark");
    if (v == WF_CARD_BASE && isnan(value))
        return wrong(why, size, "is needed: height of the lowest living branches of the crown");
    if (value < x->low || value > x->high)
        return wrong(why, size, "%.4g m is not between %g m and %g m; %s. Check the unit", value, x->low,
                     x->high, x->why);
    return contradicts(c, v, why, size);
}

bool wf_card_of_stand(const struct wf_card *c)
{
    return c->height > 60 * card_dbh(c) && c->crown_base > 0.35 * c->height;
}

static void compare_usual(const struct wf_card *c, const char *latin, struct wf_diag *d)
{
    const struct allometry *r = allometry_of(latin);
    if (!(c->crown_width > 0)) return;
    double usual = 0.01 * r->a * pow(c->height, r->b) * pow(c->crown_width, r->c), dbh = card_dbh(c);
    double spread = exp(2 * r->sd);
    if (dbh < usual * spread && dbh > usual / spread) return;
    wf_diag_warn(
        d, "card-unusual",
        "dbh %.3g m is %s than that of 19 of 20 %s %.3g m high and %.3g m wide (%.2g to %.2g m, %s): check "
        "height, girth and crown width",
        dbh, dbh > usual ? "more" : "less", r->genus ? r->genus : "trees", c->height, c->crown_width,
        usual / spread, usual * spread, r->source);
}

/* Live crown over height of street and park trees of the United States: medians of nine classes of trees 0.63
 * to 0.85, tenths 0.43 to 0.68 below and 0.82 to 0.97 above (USDA Urban Tree Database, RDS-2016-0005); the
 * smallest class ends at 0.3 two deviations below its median. That of stands is a rule. */
static void compare_depth(const struct wf_card *c, struct wf_diag *d)
{
    const double alone = 0.3, stand = 0.2;
    double depth = c->height - c->crown_base;
    if (!(c->crown_width > 0) || depth >= (wf_card_of_stand(c) ? stand : alone) * c->height) return;
    wf_diag_warn(
        d, "card-unusual",
        "the crown base of %.4g m leaves a crown %.3g m deep, %.2g %% of the height. Four of five street and "
        "park trees have 43 to 97 %% (USDA Urban Tree Database), trees of stands seldom less than 20 %%: "
        "check "
        "the height of the lowest living branches. A crown that is too small makes the tree too safe",
        c->crown_base, depth, 100 * depth / c->height);
}

enum wf_status wf_card_check(const struct wf_card *c, const char *latin, struct wf_diag *d, struct wf_err *e)
{
    size_t before = d->errors;
    char why[240];
    for (int v = 0; v < WF_CARD_VALUES; v++)
        if (wf_card_wrong(c, (enum wf_card_value)v, why, sizeof why))
            wf_diag_error(d, NULL, 0, 0, "%s: %s", limits[v].name, why);
    if (d->errors > before)
        return wf_fail(e, WF_EINPUT, "%zu mistake%s in the tree card", d->errors - before,
                       d->errors - before == 1 ? "" : "s");
    compare_usual(c, latin, d);
    compare_depth(c, d);
    return WF_OK;
}

/* ---- The card as a model ---- */

enum { PLACES = 24, SEGMENTS = 10 };

static bool place_stem(const struct wf_stem_form *f, const struct wf_card *c, struct wf_arena *a,
                       struct wf_along *out)
{
    const double thinnest = 0.03;
    double foot = WF_BREAST_HEIGHT / c->height;
    *out = (struct wf_along){ PLACES + 1, WF_TAKE(a, PLACES + 1, double), WF_TAKE(a, PLACES + 1, double) };
    if (!out->s || !out->v) return false;
    out->s[0] = 0, out->v[0] = 1;
    for (size_t k = 1; k <= PLACES; k++) {
        out->s[k] = foot + (1 - foot) * (double)(k - 1) / (PLACES - 1);
        out->v[k] = fmax(thinnest, wf_stem_form_share(f, c->height, out->s[k] * c->height));
    }
    out->s[PLACES] = 1;
    return true;
}

/* The rule for the mass of the crown: that of the species, else that of an oak or a spruce. */
static const char *mass_rule(const struct wf_card *c, const struct wf_species *sp)
{
    bool cone = c->crown_width > 0;
    const struct wf_crown_size any = { .diameter = 0.4, .width = 4, .depth = 8, .leaves = true };
    const char *rule = cone ? "forestgales" : "wcc";
    const struct wf_crown_rule *r;
    const struct wf_crown_kind *kind;
    double mass;
    struct wf_err unsaid = { WF_OK, "" };
    if (!wf_crown_rule_mass(rule, sp->key, &any, &mass, &r, &kind, &unsaid)) return rule;
    if (wf_species_is_conifer(sp->latin)) return cone ? "forestgales:norway_spruce" : "wcc:spruce";
    return cone ? "forestgales:oak" : "wcc:oak";
}

enum wf_status wf_card_model(const struct wf_card *c, const struct wf_species *sp, struct wf_arena *a,
                             struct wf_model *out, struct wf_err *e)
{
    if (sp->levels && sp->level[0].wall.n)
        return wf_fail(e, WF_EINPUT,
                       "%s: its stems are hollow culms, whose form and crown a card of a tree does not "
                       "describe: no measured "
                       "law gives a culm's diameter and wall by height, nor its crown's mass "
                       "(docs/assess.md). 'windfirm "
                       "analyze', and the column 'scan' of a table, take a model of a culm",
                       sp->name);
    /* Of 14 European species (BDAT) at 40 cm, wood has 0.60 to 0.90 of the section modulus over bark; 0.80.
     */
    const double usual_bark = 0.07;
    const struct wf_stem_form *form = wf_stem_form_of(sp->latin);
    *out = (struct wf_model){
        .key = "card",
        .name = wf_arena_print(a, "%.4g m high, dbh %.3g cm", c->height, 100 * card_dbh(c)),
        .source = "measured on the tree card",
        .generator = WF_GENERATOR_STEM,
        .seed = 1,
        .height = c->height / cos(c->lean),
        .lean = c->lean,
        .lean_azimuth = c->lean_azimuth,
        .radius = card_dbh(c) / 2,
        .taper = WF_TAPER_TABLE,
        .form_low = form->low,
        .form_high = form->high,
        .segments = SEGMENTS,
        .crown_base = c->crown_base / cos(c->lean),
        .crown_top = c->height / cos(c->lean),
        .bark = { sp->bark.given ? WF_BARK_SPECIES : WF_BARK_ASSUMED, usual_bark * card_dbh(c) / 2 },
        .silhouette = { .area = NAN,
                        .width = c->crown_width,
                        .form = c->form,
                        .mass = NAN,
                        .density = NAN,
                        .by = mass_rule(c, sp),
                        .leafless = NAN },
    };
    out->judged_to = 0.5 * (out->crown_base + out->crown_top);
    if (c->crown_width > 0) out->silhouette.depth = c->height - c->crown_base;
    if (out->name && place_stem(form, c, a, &out->profile)) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for a tree card");
}

/* ---- What is done to a tree ---- */

/* The stem's profile up to a share of its height. */
static bool cut_profile(struct wf_along *p, double share, struct wf_arena *a)
{
    double *s = WF_TAKE(a, p->n + 1, double), *v = WF_TAKE(a, p->n + 1, double);
    size_t n = 0;
    if (!s || !v) return false;
    for (; n < p->n && p->s[n] < share; n++) s[n] = p->s[n] / share, v[n] = p->v[n];
    s[n] = 1, v[n] = wf_along_at(p, share, 1);
    *p = (struct wf_along){ n + 1, s, v };
    return true;
}

/* The outline about its base, by factors on width and height. */
static bool shrink_outline(struct wf_silhouette *c, double wide, double deep, struct wf_arena *a)
{
    double *x = WF_TAKE(a, c->points, double), *z = WF_TAKE(a, c->points, double), base = INFINITY;
    if (!x || !z) return false;
    for (size_t k = 0; k < c->points; k++) base = fmin(base, c->z[k]);
    for (size_t k = 0; k < c->points; k++) x[k] = wide * c->x[k], z[k] = base + deep * (c->z[k] - base);
    c->x = x, c->z = z;
    return true;
}

static enum wf_status shrink(struct wf_model *m, double length, double share, struct wf_arena *a,
                             struct wf_err *e)
{
    struct wf_silhouette *c = &m->silhouette;
    struct wf_outline_size seen = wf_silhouette_size(m, wf_model_rise(m));
    double base, top, rise = wf_model_rise(m), along = m->height / rise;
    if (!wf_silhouette_ends(c, rise, &base, &top)) base = m->crown_base / along, top = m->crown_top / along;
    double depth = top - base, off = length > 0 ? length : share * depth;
    double deep = 1 - off / depth, wide = length > 0 ? 1 - 2 * length / seen.breadth : 1 - share;
    if (!(deep > 0.05 && wide > 0.05))
        return wf_fail(e, WF_EINPUT,
                       "a reduction of %.3g m leaves nothing of a crown %.3g m high and %.3g m wide", off,
                       depth, seen.breadth);
    double height = along * (rise - off);
    if (!cut_profile(&m->profile, height / m->height, a) || (c->points && !shrink_outline(c, wide, deep, a)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    m->height = m->crown_top = height;
    if (c->width > 0) c->width *= wide, c->depth *= deep;
    m->judged_to = fmin(m->judged_to, 0.5 * (m->crown_base + m->crown_top));
    return WF_OK;
}

static enum wf_status grow_cavities(double growth, struct wf_arena *a, struct wf_model *m, struct wf_err *e)
{
    struct wf_cavity *c = WF_TAKE(a, m->cavities, struct wf_cavity);
    if (!m->cavities) return wf_fail(e, WF_EINPUT, "no cavity is given that could grow");
    if (!c) return wf_fail(e, WF_ENOMEM, "not enough memory for a cavity");
    for (size_t k = 0; k < m->cavities; k++) {
        c[k] = m->cavity[k];
        if (isnan(c[k].wall))
            return wf_fail(e, WF_EINPUT,
                           "a cavity that is given by rays has no one wall that could be thinner");
        if (!((c[k].wall -= growth) > 0))
            return wf_fail(e, WF_EINPUT, "the cavity at %.3g m: nothing of its wall of %.3g mm is left",
                           c[k].at, 1e3 * m->cavity[k].wall);
    }
    m->cavity = c;
    return WF_OK;
}

enum wf_status wf_card_change(const struct wf_card_change *x, struct wf_arena *a, struct wf_model *m,
                              double *cut, struct wf_err *e)
{
    double before = wf_silhouette_area(&m->silhouette);
    enum wf_status s = WF_OK;
    if (x->reduce_share > 0 || x->reduce_length > 0) s = shrink(m, x->reduce_length, x->reduce_share, a, e);
    if (!s && x->cavity_growth > 0) s = grow_cavities(x->cavity_growth, a, m, e);
    if (x->thin > 0) m->silhouette.thinned = x->thin;
    *cut = 1 - (1 - fmax(x->thin, 0)) * wf_silhouette_area(&m->silhouette) / before;
    return s;
}
