/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/card.h"
#include "base/num.h"
#include <math.h>
#include <string.h>

/* ---- What is known of stems and crowns by genus ---- */

#define NORDIC                                                                                               \
    "Laasasenaho J. 1982. Commun. Inst. For. Fenn. 108, taper curves, as coded in dmela/Laasasenaho"

/* Ends at name == NULL; the last row is for all genera. */
static const struct wf_stem_form stem_forms[] = {
    { .name = "pine",
      .genus = "Pinus",
      .c = { 2.1288, -0.63157, -1.6082, 2.4886, -2.4147, 2.3619, -1.7539, 1.0817 },
      .source = NORDIC,
      .validity = "Scots pine in forests of Finland, diameter over bark" },
    { .name = "spruce",
      .genus = "Picea",
      .c = { 2.3366, -3.2684, 3.6513, -2.2608, 0, 2.1501, -2.7412, 1.8876 },
      .source = NORDIC,
      .validity = "Norway spruce in forests of Finland, diameter over bark" },
    { .name = "power",
      .power = 0.65,
      .power_low = 0.57,
      .power_high = 0.74,
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

static double card_dbh(const struct wf_card *c) { return c->dbh > 0 ? c->dbh : c->girth / WF_PI; }

struct limit {
    const char *name;
    double value, low, high; /* [m] */
    const char *why;
};

static void check_sizes(const struct wf_card *c, struct wf_diag *d)
{
    const struct limit size[] = {
        { "height", c->height, 2, 120, "the tallest tree known is 116 m high" },
        { "girth", c->girth, 0.05, 40, "the thickest trunk known is some 36 m around" },
        { "dbh", c->dbh, 0.015, 12, "the thickest trunk known is some 11.6 m through" },
        { "crown width", c->crown_width, 0.2, 80, "the widest crowns known are some 60 m wide" },
    };
    if (!(c->girth > 0) && !(c->dbh > 0))
        wf_diag_error(d, NULL, 0, 0,
                      "neither girth nor dbh is given; one is needed, at 1.3 m above the ground");
    if (isnan(c->height)) wf_diag_error(d, NULL, 0, 0, "height: is not given");
    for (size_t k = 0; k < WF_COUNT(size); k++)
        if (!isnan(size[k].value) && !(size[k].value >= size[k].low && size[k].value <= size[k].high))
            wf_diag_error(d, NULL, 0, 0, "%s: %.4g m is not between %g m and %g m; %s. Check the unit",
                          size[k].name, size[k].value, size[k].low, size[k].high, size[k].why);
}

static void check_relations(const struct wf_card *c, struct wf_diag *d)
{
    if (c->girth > 0 && c->dbh > 0 && fabs(c->girth / WF_PI - c->dbh) > 0.02 * c->dbh)
        wf_diag_error(
            d, NULL, 0, 0,
            "girth %.4g m and dbh %.4g m disagree: the girth is %.4g times the dbh, not 3.14; give one",
            c->girth, c->dbh, c->girth / c->dbh);
    if (c->crown_base >= c->height)
        wf_diag_error(d, NULL, 0, 0, "crown base: %.4g m is not below the top of the tree at %.4g m",
                      c->crown_base, c->height);
    if (c->crown_base < 0)
        wf_diag_error(d, NULL, 0, 0, "crown base: %.4g m is below the ground", c->crown_base);
    if (card_dbh(c) > 0.25 * c->height)
        wf_diag_error(
            d, NULL, 0, 0,
            "the stem is %.4g m thick and the tree %.4g m high: no stem is thicker than a quarter of the "
            "height. Is the girth given as dbh?",
            card_dbh(c), c->height);
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

enum wf_status wf_card_check(const struct wf_card *c, const char *latin, struct wf_diag *d, struct wf_err *e)
{
    size_t before = d->errors;
    check_sizes(c, d);
    if (d->errors == before) check_relations(c, d);
    if (d->errors > before)
        return wf_fail(e, WF_EINPUT, "%zu mistake%s in the tree card", d->errors - before,
                       d->errors - before == 1 ? "" : "s");
    compare_usual(c, latin, d);
    return WF_OK;
}

/* ---- The card as a model ---- */

enum { PLACES = 24, SEGMENTS = 16 };

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

enum wf_status wf_card_model(const struct wf_card *c, const char *latin, struct wf_arena *a,
                             struct wf_model *out, struct wf_err *e)
{
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
        .segments = SEGMENTS,
        .crown_base = c->crown_base / cos(c->lean),
        .crown_top = c->height / cos(c->lean),
        .silhouette = { .area = NAN,
                        .width = c->crown_width,
                        .form = c->form,
                        .mass = NAN,
                        .density = NAN,
                        .leafless = NAN },
    };
    if (c->crown_width > 0) out->silhouette.depth = out->crown_top - out->crown_base;
    if (out->name && place_stem(wf_stem_form_of(latin), c, a, &out->profile)) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for a tree card");
}
