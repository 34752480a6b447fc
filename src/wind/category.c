/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/category.h"
#include <math.h>
#include <string.h>

const struct wf_category wf_categories[] = {
    { "0", 0.003, 1.0, "sea, or coast exposed to the open sea" },
    { "I", 0.01, 1.0, "lakes, or flat ground with little vegetation and without obstacles" },
    { "II", 0.05, 2.0, "low vegetation and single obstacles (trees, buildings) at least 20 heights apart" },
    { "III", 0.3, 5.0, "obstacles at most 20 heights apart: villages, suburbs, permanent forest" },
    { "IV", 1.0, 10.0, "at least 15 % of the ground covered with buildings higher than 15 m on average" },
    { 0 }
};

const struct wf_category *wf_category_named(const char *name)
{
    for (const struct wf_category *c = wf_categories; c->name; c++)
        if (strcmp(c->name, name) == 0) return c;
    return NULL;
}

const struct wf_category *wf_category_open(void) { return &wf_categories[2]; }

static double height_in_roughness(const struct wf_category *c, double z)
{
    return fmax(z, c->least) / c->roughness;
}

double wf_category_factor(const struct wf_category *c, double z)
{
    double terrain = 0.19 * pow(c->roughness / wf_category_open()->roughness, 0.07);
    return terrain * log(height_in_roughness(c, z));
}

double wf_category_turbulence(const struct wf_category *c, double z)
{
    return 1.0 / log(height_in_roughness(c, z));
}

double wf_category_length(const struct wf_category *c, double z)
{
    return 300.0 * pow(fmax(z, c->least) / 200.0, 0.67 + 0.05 * log(c->roughness));
}

double wf_category_gust(const struct wf_category *c, double z)
{
    return sqrt(1.0 + 7.0 * wf_category_turbulence(c, z));
}

const struct wf_site_kind wf_site_kinds[] = {
    { "open", "II", "open country", false, false },
    { "suburb", "III", "among houses and gardens, or in a village", false, false },
    { "town", "IV", "in a town of high buildings", false, false },
    { "forest-edge", "II", "at the edge of a forest, with open country upwind", true, true },
    { "in-stand", "III", "inside a forest", true, false },
    { 0 }
};

const struct wf_site_kind *wf_site_kind_named(const char *name)
{
    for (const struct wf_site_kind *k = wf_site_kinds; name && k->name; k++)
        if (strcmp(k->name, name) == 0) return k;
    return NULL;
}
