/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases/gusts.h"
#include "base/num.h"
#include "data/species.h"
#include "solve/beam.h"
#include "study/analysis.h"
#include "study/node.h"
#include "study/sway.h"
#include "wind/gust_factor.h"
#include <math.h>
#include <string.h>

/* Code's gust factor. */

/* What can be wanted of a code's gust factor: a member of struct wf_gust_parts. */
static const struct part {
    const char *quantity;
    size_t offset;
} parts[] = {
    { "gust_background", offsetof(struct wf_gust_parts, background) },
    { "gust_resonance", offsetof(struct wf_gust_parts, resonance) },
    { "gust_peak_factor", offsetof(struct wf_gust_parts, peak) },
    { "gust_load_factor", offsetof(struct wf_gust_parts, factor) },
    { "structural_factor", offsetof(struct wf_gust_parts, structural) },
};

static const struct part *part_of(const char *quantity)
{
    for (size_t i = 0; i < WF_COUNT(parts); i++)
        if (!strcmp(parts[i].quantity, quantity)) return &parts[i];
    return NULL;
}

struct need {
    const char *key;
    bool there;
};

static const char *first_missing(const struct need *need, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!need[i].there) return need[i].key;
    return NULL;
}

const char *wf_gust_missing(const struct wf_case *c, const char *quantity)
{
    const struct wf_case_gust *g = &c->gust;
    if (c->shape != WF_SHAPE_GUST) {
        const struct need need[] = {
            { "bending_strength", !isnan(g->strength) },
            { "crown_depth", !isnan(g->crown_depth) },
            { "displacement", !isnan(g->displacement) },
            { "roughness", !isnan(g->roughness) },
            { "spacing", !isnan(g->spacing) },
            { "edge_distance", !isnan(g->edge_distance) },
            { "gap", !isnan(g->gap) },
        };
        return first_missing(need, WF_COUNT(need));
    }
    const struct need need[] = {
        { "terrain", g->terrain != NULL },
        { "height", !isnan(g->height) },
        { "breadth", !isnan(g->breadth) },
        { "sway_frequency", !isnan(g->frequency) },
        { "damping", !isnan(g->damping) },
        { "basic_wind or mean_wind", !isnan(g->basic_wind) || !isnan(g->mean_wind) },
    };
    return first_missing(need, part_of(quantity) ? WF_COUNT(need) : 2);
}

void wf_gust_answer(const struct wf_case *c, const char *quantity, double *out)
{
    const struct wf_case_gust *g = &c->gust;
    const struct part *part = part_of(quantity);
    struct wf_gust_parts all;
    if (!part) {
        double gust = wf_category_gust(g->terrain, g->height);
        *out = gust * gust;
        return;
    }
    double factor = wf_category_factor(g->terrain, g->rule->at(g->terrain, g->height));
    struct wf_gust_case of = { .terrain = g->terrain,
                               .height = g->height,
                               .breadth = g->breadth,
                               .frequency = g->frequency,
                               .damping = g->damping,
                               .mean = isnan(g->mean_wind) ? factor * g->basic_wind : g->mean_wind,
                               .open = isnan(g->basic_wind) ? g->mean_wind / factor : g->basic_wind,
                               .exponent = 2.0 };
    g->rule->parts(&of, &all);
    memcpy(out, (const char *)&all + part->offset, sizeof *out);
}

/* Stem in a stand. */

/* The case's tree as a stand's stem in the wind of the canopy top. */
static void stand_analysis(const struct wf_case *c, const struct wf_setup *s, struct wf_analysis *an)
{
    static struct wf_level level[1] = { { .name = "stem" } };
    static const struct wf_species wood = { .name = "wood", .level = level, .levels = 1 };
    const struct wf_case_gust *g = &c->gust;
    const double height = c->length, highest = 100.0; /* [m], [m/s] */
    *an = (struct wf_analysis){
        .species = &wood, .solver = &wf_solver_beam, .tree = s->tree, .loads = s->loads, .tallness = height
    };
    wf_scenario_default(&an->scenario);
    an->scenario.profile = "canopy";
    an->scenario.reference_height = an->scenario.canopy_height = height;
    an->scenario.displacement = g->displacement, an->scenario.roughness = g->roughness;
    an->scenario.peak = (struct wf_peak_request){
        .method = "gales",
        .damping = NAN,
        .stand = { .height = height, .spacing = g->spacing, .edge = g->edge_distance, .gap = g->gap }
    };
    wf_search_default(&an->search);
    an->search.speed_max = highest;
    wf_scenario_wind(&an->scenario, &an->wind);
    an->loads.wind = &an->wind;
}

static enum wf_status critical_wind(const struct wf_analysis *an, const struct wf_solve_options *o,
                                    double *out, struct wf_err *e)
{
    struct wf_break found[WF_CRITERIA][WF_SCOPES];
    struct wf_nodes *nodes = wf_nodes_open(an, NULL);
    if (!nodes) return wf_fail(e, WF_ENOMEM, "no memory");
    enum wf_status s = wf_analysis_breaks(an, o, nodes, found, e);
    wf_nodes_close(nodes);
    *out = found[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed;
    return s;
}

enum wf_status wf_stand_answer(const struct wf_case *c, const struct wf_setup *s, const char *quantity,
                               struct wf_arena *a, double *out, struct wf_err *e)
{
    const double speed = s->loads.wind ? s->wind.speed : 0.0;
    struct wf_analysis an;
    struct wf_at_speed at;
    if (!(speed > 0.0)) return wf_fail(e, WF_EINPUT, "%s:%zu: '%s' needs a wind", c->file, c->line, quantity);
    stand_analysis(c, s, &an);
    if (wf_sway_set_up(&an, &s->options, &speed, 1, a, NULL, e)) return e->code;
    if (!strcmp(quantity, "critical_wind")) return critical_wind(&an, &s->options, out, e);
    if (!strcmp(quantity, "stand_gust_factor")) {
        *out = wf_peak_gusts(an.peak, speed);
        return WF_OK;
    }
    if (wf_speed_totals(&an, &s->options, speed, &at, e)) return e->code;
    *out = at.base_moment;
    return at.status ? wf_fail(e, at.status, "no equilibrium at %.4g m/s", speed) : WF_OK;
}
