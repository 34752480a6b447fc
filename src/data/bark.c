/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/bark.h"
#include "base/text.h"
#include "base/units.h"
#include "base/yaml.h"
#include "data/law_schema.h"
#include <math.h>
#include <string.h>

#define T struct wf_bark_law
static const struct wf_yaml_row bark_rows[] = {
    WF_KEY_NUMBERS(
        "double_mm", coefficient, terms, -100, 1000,
        "a, b, c of the thickness on both sides together, a + b d + c d^2 in mm, with d the diameter "
        "over bark in cm.",
        .required = true, .example = "[2.0, 0.28, 0]"),
    { .key = "share",
      WF_VALUE_ROW(struct wf_bark_law, share),
      .low = 0,
      .high = 3,
      .required = true,
      .doc = "Thickness over that of the law; its range is that between trees.",
      .example = "{value: 1, low: 0.7, high: 1.3, status: assumed}" },
    { .key = NULL },
};
#undef T

static void bark_finish(struct wf_yaml *y, void *bark)
{
    const struct wf_bark_law *b = bark;
    if (b->coefficient && b->terms != 3)
        wf_yaml_error(y, "double_mm",
                      "has %zu numbers; it needs three, a, b and c, for example [2.0, 0.28, 0]", b->terms);
    else if (b->coefficient && !(wf_bark_by_law(b, 0.3) > 0))
        wf_yaml_error(y, "double_mm", "gives no bark at a diameter of 30 cm");
}

const struct wf_yaml_table wf_bark_table = {
    .title = "bark", .row = bark_rows, .finish = bark_finish, .doc = ""
};

double wf_bark_by_law(const struct wf_bark_law *law, double diameter)
{
    const double least = 10; /* [cm] */
    const double *k = law->coefficient;
    double d = 100 * diameter, at = fmax(d, least);
    if (k[2] < 0) at = fmin(at, fmax(-k[1] / (2 * k[2]), least));
    double both = k[0] + k[1] * at + k[2] * at * at;
    if (d < least) both *= d / least;
    return fmin(fmax(0.5e-3 * both * law->share.value, 0), diameter / 6);
}

bool wf_bark_read(const char *text, struct wf_bark_said *out, struct wf_err *why)
{
    static const char *const words[] = { "species", "none" };
    *out = (struct wf_bark_said){ .kind = WF_BARK_SPECIES };
    if (!strcmp(text, "species")) return true;
    out->kind = WF_BARK_NONE;
    if (!strcmp(text, "none")) return true;
    out->kind = WF_BARK_MEASURED;
    struct wf_units *u = NULL;
    struct wf_err e = { 0 };
    enum wf_status s = wf_units_open(&u, &e);
    if (!s) s = wf_quantity_read_as(u, text, WF_DIM_LENGTH, "mm", &out->thickness, &e);
    wf_units_close(u);
    if (s)
        (void)wf_fail(why, s, "'%.60s' is none of species, none and a thickness such as '15 mm'%s", text,
                      wf_did_you_mean(text, words, 2).text);
    else if (!(out->thickness >= 1e-4 && out->thickness <= 0.2))
        s = wf_fail(why, WF_EINPUT, "'%.60s' is outside 0.1 mm to 200 mm", text);
    return s == WF_OK;
}
