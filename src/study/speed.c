/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/speed.h"
#include "load/scene.h"
#include "study/figures.h"
#include "study/sheltered.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <string.h>

size_t wf_tip_row(const struct wf_tree *t)
{
    size_t tip = 0;
    double highest = -INFINITY;
    for (size_t i = 0; i < t->n; i++)
        if (t->level[i] == 0 && t->z1[i] > highest) {
            highest = t->z1[i];
            tip = i;
        }
    return tip;
}

static void totals_fill(const struct wf_analysis *an, const struct wf_totals *all, struct wf_at_speed *out)
{
    const double *to = an->wind.direction, *force = out->response.base_force,
                 *moment = out->response.base_moment;
    size_t tip = wf_tip_row(&an->tree);
    double across = 0.0;
    out->drag = all->air[0] * to[0] + all->air[1] * to[1] + all->air[2] * to[2];
    for (int k = 0; k < 3; k++) across += pow(all->air[k] - out->drag * to[k], 2.0);
    out->lift = sqrt(across);
    out->weight = all->weight;
    out->tip_deflection = out->figures.deflection[tip];
    out->tip_deflection_share = out->tip_deflection / an->tallness;
    out->tip_angle = out->figures.slope[tip];
    out->base_shear = hypot(force[0], force[1]);
    out->base_moment = hypot(moment[0], moment[1]);
}

static void totals_unknown(struct wf_at_speed *out)
{
    out->drag = out->lift = out->weight = out->tip_deflection = out->tip_deflection_share = NAN;
    out->tip_angle = out->base_shear = out->base_moment = NAN;
    out->breakage.largest_stress = NAN;
    out->breakage.largest_stress_row = -1;
    wf_criteria_check(NULL, NULL, NULL, out->worst);
}

/* The tree in the wind it leaves itself; a coarser grid than for maps, because it is made for every shape. */
static enum wf_status solve_sheltered(const struct wf_analysis *an, const struct wf_loads *l,
                                      const struct wf_solve_options *o, struct wf_arena *a,
                                      struct wf_sheltered *out, struct wf_response *r, struct wf_diag *d,
                                      struct wf_err *e)
{
    struct wf_shelter_request q;
    wf_shelter_request_default(&q);
    q.law = wf_shelter_law_named(an->scenario.shelter);
    q.slabs = 24;
    q.cells = 64;
    if (an->species->crown.drag_coefficient.given) q.crown_drag = an->species->crown.drag_coefficient.value;
    return wf_sheltered_solve(&an->tree, l, &q, an->solver, o, a, out, r, d, e);
}

/* What follows from the response. */
static enum wf_status figures(const struct wf_analysis *an, const struct wf_loads *l, struct wf_arena *a,
                              struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_totals totals;
    enum wf_status s = wf_breakage_check(&an->tree, &out->response, a, &out->breakage, e);
    if (s) return s;
    wf_criteria_check(&an->tree, &out->response, &out->breakage, out->worst);
    s = wf_figures_fill(&an->tree, l, &out->response, an->wind.direction,
                        an->species->crown.drag_coefficient.value, a, &out->figures, &totals, e);
    if (!s) totals_fill(an, &totals, out);
    return s;
}

enum wf_status wf_speed_solve(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                              struct wf_arena *a, struct wf_diag *d, struct wf_at_speed *out,
                              struct wf_err *e)
{
    struct wf_wind wind = an->wind;
    struct wf_loads loads = an->loads;
    struct wf_sheltered sheltered = { 0 };
    struct wf_err why = { 0 };
    enum wf_status s = WF_OK;
    memset(out, 0, sizeof *out);
    out->speed = speed;
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    loads.wind = speed > 0.0 ? &wind : NULL;
    if (an->scenario.shelter && loads.wind)
        out->status = solve_sheltered(an, &loads, o, a, &sheltered, &out->response, d, &why);
    else
        out->status = an->solver->solve(&an->tree, &loads, o, a, &out->response, d, &why);
    if (out->status == WF_EUNSTABLE || out->status == WF_ENOCONV)
        totals_unknown(out);
    else if (out->status)
        s = wf_fail(e, out->status, "%s", why.text);
    else
        s = figures(an, sheltered.passes ? &sheltered.loads : &loads, a, out, e);
    wf_sheltered_end(&sheltered);
    return s;
}

enum wf_status wf_speed_totals(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                               struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag quiet = { .arena = &scratch };
    enum wf_status s = wf_speed_solve(an, o, speed, &scratch, &quiet, out, e);
    wf_arena_free(&scratch);
    struct wf_at_speed kept = *out;
    /* the columns went with the scratch memory: keep the scalars, clear the pointers */
    kept.response = (struct wf_response){ .imbalance = out->response.imbalance,
                                          .load_factor = out->response.load_factor,
                                          .iterations = out->response.iterations,
                                          .steps = out->response.steps,
                                          .small_deflection = out->response.small_deflection };
    memcpy(kept.response.base_force, out->response.base_force, sizeof kept.response.base_force);
    memcpy(kept.response.base_moment, out->response.base_moment, sizeof kept.response.base_moment);
    kept.breakage = (struct wf_breakage){ .largest_stress = out->breakage.largest_stress,
                                          .largest_stress_row = out->breakage.largest_stress_row };
    kept.figures = (struct wf_figures){ 0 };
    *out = kept;
    return s;
}
