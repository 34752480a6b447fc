/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/mode_list.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "data/species.h"
#include "load/interception.h"
#include "study/analysis.h"
#include <math.h>
#include <string.h>

const char wf_sway_lines_source[] = "regressions of windfirm on the data of Jackson et al. 2021 (631 "
                                    "conifers in forests, R2 0.75 for all); linear "
                                    "in D/H2 as Moore & Maguire 2004, Trees 18:195-203";
/* The last, of all conifers, has no `latin`. */
static const struct wf_sway_line lines[] = {
    { "Sitka spruce", "Picea sitchensis", 0.0969, 342.1 },
    { "Norway spruce", "Picea abies", 0.1522, 263.6 },
    { "Scots pine", "Pinus sylvestris", 0.1679, 188.6 },
    { "Douglas fir", "Pseudotsuga", 0.0092, 435.7 },
    { "all conifers", NULL, 0.0681, 319.3 },
};

static bool begins(const char *text, const char *with) { return text && !strncmp(text, with, strlen(with)); }

static void compare(const struct wf_species *sp, const struct wf_mode_block *b, struct wf_mode_list *out)
{
    out->conifer = wf_species_is_conifer(sp->latin);
    out->line = lines;
    while (out->line->latin && !begins(sp->latin, out->line->latin)) out->line++;
    out->diameter = wf_tree_breast(&b->tree).diameter;
    out->height = b->height;
    out->measured = out->line->first + out->line->slope * out->diameter / (out->height * out->height);
}

static enum wf_status run_block(const struct wf_analysis *an, const struct wf_solve_options *o, size_t count,
                                struct wf_arena *a, struct wf_diag *d, struct wf_mode_block *b,
                                struct wf_err *e)
{
    const double least = 0.3; /* a rule of ours, as of the peak load */
    const char *leaves = b->water > 0 ? "leaf-on, wet" : b->season == WF_LEAF_ON ? "leaf-on" : "leaf-off";
    struct wf_err why = { 0 };
    b->tree = an->tree, b->height = an->tallness;
    b->direction[0] = an->wind.direction[0], b->direction[1] = an->wind.direction[1];
    b->status = wf_sway_modes(an, o, b->speed, 0, count, a, &b->modes, &why);
    if (b->status == WF_EUNSTABLE || b->status == WF_ENOCONV) {
        wf_diag_warn(d, "no-equilibrium", "%s, mean wind %.4g m/s: no modes: %s", leaves, b->speed, why.text);
        b->modes.count = 0;
        return WF_OK;
    }
    if (b->status) return wf_fail(e, b->status, "%s", why.text);
    double share = b->modes.sway.participation;
    if (share < least)
        wf_diag_warn(
            d, "peak-sway",
            "%s, mean wind %.4g m/s: the sway of the whole tree about %.3g Hz carries %.0f %% of the "
            "overturning by inertia; branches divide the rest among many frequencies",
            leaves, b->speed, b->modes.sway.frequency, 100.0 * share);
    for (size_t k = 0; k < b->modes.count; k++)
        if (b->modes.mode[k].frequency < 0.0) {
            wf_diag_warn(d, "unstable-state",
                         "%s, mean wind %.4g m/s: the equilibrium is unstable, mode %zu grows", leaves,
                         b->speed, k + 1);
            break;
        }
    return WF_OK;
}

static enum wf_status run_season(const struct wf_analysis *as, const struct wf_solve_options *o,
                                 const struct wf_mode_request *r, enum wf_season season, double water,
                                 struct wf_arena *a, struct wf_diag *d, struct wf_mode_list *out,
                                 struct wf_err *e)
{
    struct wf_diag again = { .arena = a };
    struct wf_analysis *an = WF_TAKE(a, 1, struct wf_analysis);
    if (!an) return wf_fail(e, WF_ENOMEM, "not enough memory for a tree");
    *an = *as;
    an->scenario.water = water;
    enum wf_status s = wf_analysis_set_up(an, o, a, out->blocks ? &again : d, e);
    if (!s && water > 0 && !(wf_tree_leaf_area(&an->tree) > 0))
        s = wf_fail(e, WF_EINPUT,
                    "the tree has no leaves that could hold rain; give --leaf-area or a season with leaves");
    for (size_t i = 0; i < r->winds && !s; i++) {
        struct wf_mode_block *b = &out->block[out->blocks];
        *b = (struct wf_mode_block){ .season = season, .water = water, .speed = r->wind[i] };
        wf_stage_step(1);
        s = wf_interrupted() ? wf_fail(e, WF_EINTERRUPTED, "interrupted before all modes were computed")
                             : run_block(an, o, r->count, a, d, b, e);
        if (!s) out->blocks++;
    }
    return s;
}

enum wf_status wf_mode_list_run(const struct wf_analysis *as, struct wf_model *m,
                                const struct wf_solve_options *o, const struct wf_mode_request *r,
                                struct wf_arena *a, struct wf_diag *d, struct wf_mode_list *out,
                                struct wf_err *e)
{
    const enum wf_season given = m->season;
    enum wf_season season[3];
    double water[3] = { 0 };
    size_t n = 0;
    bool both = r->seasons && m->leaf_area_on > 0.0 && !wf_species_is_evergreen(as->species);
    season[n++] = both ? WF_LEAF_ON : given;
    if (as->scenario.water > 0) water[n] = as->scenario.water, season[n] = season[0], n++;
    if (both) season[n++] = WF_LEAF_OFF;
    *out = (struct wf_mode_list){ .scenario = &as->scenario,
                                  .block = WF_TAKE(a, n * r->winds, struct wf_mode_block) };
    if (!out->block) return wf_fail(e, WF_ENOMEM, "not enough memory for the modes");
    enum wf_status s = WF_OK;
    wf_stage_begin(n * r->winds, false, "modes");
    for (size_t i = 0; i < n && !s; i++) {
        wf_model_set_season(m, season[i]);
        s = run_season(as, o, r, season[i], water[i], a, d, out, e);
    }
    wf_model_set_season(m, given);
    if (!s) compare(as->species, &out->block[0], out);
    return s;
}

const char *wf_mode_direction(const struct wf_sway_mode *m)
{
    const double none = 0.005, clear = 4.0; /* of the mass; ratio of the larger share to the other */
    double along = m->share[0], across = m->share[1], up = m->share[2];
    if (fmax(fmax(along, across), up) < none) return "inside";
    if (up > along + across) return "up";
    if (along > clear * across) return "along";
    return across > clear * along ? "across" : "oblique";
}
