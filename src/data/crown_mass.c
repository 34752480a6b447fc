/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/crown_mass.h"
#include "base/num.h"
#include "base/text.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- ForestGALES: mass per volume of the cone of crown width and depth ---- */

static const struct wf_crown_kind gales_kinds[] = {
    { "sitka_spruce", "sitka_spruce", { 2.5 }, 0 },
    { "norway_spruce", "norway_spruce", { 2.5 }, 0 },
    { "douglas_fir", "douglas_fir", { 2.5 }, 0 },
    { "scots_pine", "scots_pine", { 2.5 }, 0 },
    { "corsican_pine", "", { 2.5 }, 0 },
    { "lodgepole_pine", "", { 2.5 }, 0 },
    { "radiata_pine", "radiata_pine", { 2.5 }, 0 },
    { "maritime_pine", "maritime_pine", { 2.73 }, 0 },
    { "larch", "japanese_larch", { 2.5 }, 0 },
    { "larch_japan", "", { 3.3 }, 0 },
    { "hemlock", "", { 2.5 }, 0 },
    { "balsam_fir", "", { 3.45 }, 0 },
    { "birch", "birch", { 1.22 }, 0.8296 }, /* bare: Norwegian table of the model */
    { "beech", "beech", { 1.38 }, 0 },
    { "oak", "oak", { 1.38 }, 0 },
    { 0 },
};

static double cone_mass(const struct wf_crown_kind *k, const struct wf_crown_size *s)
{
    double density = !s->leaves && k->bare > 0 ? k->bare : k->number[0];
    return density * WF_PI / 12 * s->width * s->width * s->depth;
}

/* ---- Woodland Carbon Code: oven-dry mass by diameter ---- */

/* Tonnes from cm: a D^b up to 50 cm, c + d D above. */
static const struct wf_crown_kind code_kinds[] = {
    { "oak", "oak ash birch", { 1.68513e-5, 2.4767, -0.4115505, 0.013669801 }, 0 },
    { "beech", "beech", { 1.88154e-5, 2.4767, -0.4595186, 0.015263082 }, 0 },
    { "spruce", "sitka_spruce norway_spruce", { 1.4462e-5, 2.4767, -0.3531978, 0.011731597 }, 0 },
    { "douglas_fir", "douglas_fir", { 1.68602e-5, 2.4767, -0.4117678, 0.013677021 }, 0 },
    { "scots_pine", "scots_pine", { 1.61411e-5, 2.4767, -0.3942056, 0.013093685 }, 0 },
    { "corsican_pine", "", { 1.22645e-5, 2.4767, -0.2995295, 0.009948982 }, 0 },
    { "lodgepole_pine", "", { 1.76287e-5, 2.4767, -0.4305365, 0.014300429 }, 0 },
    { "larch", "japanese_larch", { 4.38717e-5, 2.0291, -0.129047, 0.005039011 }, 0 },
    { 0 },
};

static double code_mass(const struct wf_crown_kind *k, const struct wf_crown_size *s)
{
    const double line_from = 50; /* [cm] */
    const double dry = 0.45; /* dry over fresh mass: leaves 0.41 to 0.44, green wood 0.43 to 0.53; assumed */
    double d = 100 * s->diameter;
    const double *n = k->number;
    return 1000 * (d <= line_from ? n[0] * pow(d, n[1]) : n[2] + n[3] * d) / dry;
}

const struct wf_crown_rule wf_crown_rules[] = {
    { "forestgales", "mass per volume of the cone of crown width and depth",
      "species tables of ForestGALES (Locatelli et al., fgr 0.0.0.9009; birch without leaves: "
      "NorForestGALES)",
      "trees in stands; crowns of open-grown trees were not found", gales_kinds, true, cone_mass },
    { "wcc", "oven-dry mass of branches, stem tip and leaves by diameter, over a dry share of 0.45",
      "Jenkins et al. 2018, Woodland Carbon Code: Carbon Assessment Protocol 2.0, as tabulated in TreeCarbon",
      "British forest trees of 7 cm and more; the dry share is assumed, and leaves are included in winter "
      "too",
      code_kinds, false, code_mass },
    { 0 },
};

/* ---- By name ---- */

static const struct wf_crown_rule *rule_of(const char *words)
{
    size_t n = strcspn(words, ":");
    for (const struct wf_crown_rule *r = wf_crown_rules; r->name; r++)
        if (strlen(r->name) == n && !strncmp(r->name, words, n)) return r;
    return NULL;
}

/* Is `key` one of the words of a list? */
static bool listed(const char *list, const char *key)
{
    size_t n = strlen(key);
    for (const char *at = list; n && *at; at += strcspn(at, " "), at += strspn(at, " "))
        if (strcspn(at, " ") == n && !strncmp(at, key, n)) return true;
    return false;
}

static enum wf_status unknown(const struct wf_crown_rule *r, const char *what, const char *word,
                              struct wf_err *e)
{
    const char *known[32] = { NULL };
    size_t n = 0;
    for (const struct wf_crown_rule *k = wf_crown_rules; !r && k->name && n < WF_COUNT(known); k++)
        known[n++] = k->name;
    for (const struct wf_crown_kind *k = r ? r->kind : NULL; k && k->name && n < WF_COUNT(known); k++)
        known[n++] = k->name;
    return wf_fail(e, WF_EINPUT, "%s%s%s '%s'%s", r ? r->name : "", r ? " has no " : "there is no ", what,
                   word, wf_did_you_mean_or(word, known, n, "one of: ").text);
}

static enum wf_status find(const char *words, const struct wf_crown_rule **rule,
                           const struct wf_crown_kind **kind, struct wf_err *e)
{
    const char *colon = strchr(words, ':');
    *rule = rule_of(words);
    *kind = NULL;
    if (!*rule) return unknown(NULL, "rule of crown mass", words, e);
    for (const struct wf_crown_kind *k = (*rule)->kind; colon && k->name; k++)
        if (!strcmp(k->name, colon + 1)) *kind = k;
    return colon && !*kind ? unknown(*rule, "kind", colon + 1, e) : WF_OK;
}

enum wf_status wf_crown_rule_check(const char *words, struct wf_err *e)
{
    const struct wf_crown_rule *rule;
    const struct wf_crown_kind *kind;
    return find(words, &rule, &kind, e);
}

enum wf_status wf_crown_rule_mass(const char *words, const char *species, const struct wf_crown_size *size,
                                  double *mass, const struct wf_crown_rule **rule,
                                  const struct wf_crown_kind **of, struct wf_err *e)
{
    const struct wf_crown_rule *r;
    const struct wf_crown_kind *kind;
    if (find(words, &r, &kind, e)) return e ? e->code : WF_EINPUT;
    for (const struct wf_crown_kind *k = r->kind; !kind && k->name; k++)
        if (listed(k->species, species)) kind = k;
    if (!kind) return unknown(r, "kind for the species", species, e);
    if (r->by_cone && !(size->width > 0 && size->depth > 0))
        return wf_fail(e, WF_EINPUT, "%s needs the width and the depth of the crown, or its outline",
                       r->name);
    if (!r->by_cone && !(size->diameter > 0))
        return wf_fail(e, WF_EINPUT, "%s needs the diameter at 1.3 m; the stem ends below", r->name);
    *mass = r->mass(kind, size);
    *rule = r, *of = kind;
    return WF_OK;
}
