/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inputs of a run: species values with range, standing and source; model; scenario; method. */
#include "out/inputs.h"
#include "base/num.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/silhouette.h"
#include "load/drag.h"
#include "study/assessment.h"
#include "study/peak.h"
#include "study/wetted.h"
#include "wind/category.h"
#include "wind/climate.h"
#include "wind/design.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The full citation where the table has one, else its key. */
static void put_source(struct wf_doc *d, json_t *o, const struct wf_species *sp, const char *key)
{
    const char *citation = wf_species_source(sp, key);
    wf_doc_text(d, o, "source", citation ? citation : key);
}

static void put_standing(struct wf_doc *d, json_t *o, const struct wf_species *sp, const struct wf_value *v)
{
    wf_doc_text(d, o, "status", wf_standing_text(v->standing));
    put_source(d, o, sp, v->source);
    wf_doc_flag(d, o, "given", v->given);
    wf_doc_text(d, o, "note", v->note);
}

/* Does this value of a grown part affect the results, which are those of a steady wind? */
static bool acts(const struct wf_analysis *a, const struct wf_property *p)
{
    if (p->acts == WF_ACTS_MOTION) return false;
    return p->acts != WF_ACTS_SIZE || isnan(a->model->radius);
}

/* part: name of the level, or "crown"; table: where in the species table its keys are; grown: the tree has
 * such a part. */
static void add_value(struct wf_doc *d, json_t *list, const struct wf_analysis *a, const char *part,
                      const char *table, const struct wf_property *p, bool grown)
{
    char key[96];
    const struct wf_value *v = p->value;
    json_t *o = wf_doc_add(d, list, wf_doc_object(d));
    (void)snprintf(key, sizeof key, "%s%s", table, p->key);
    wf_doc_text(d, o, "level", part);
    wf_doc_text(d, o, "key", key);
    wf_doc_text(d, o, "quantity", p->was);
    wf_doc_number(d, o, "value", v->value);
    wf_doc_number(d, o, "low", v->low);
    wf_doc_number(d, o, "high", v->high);
    wf_doc_text(d, o, "unit", wf_dimension_row(p->dimension)->si);
    if (!isfinite(v->value)) wf_doc_text(d, o, "reason", "not given");
    wf_doc_flag(d, o, "used", grown && acts(a, p));
    put_standing(d, o, a->species, v);
}

/* The sourced values of a law. */
static void add_law_values(struct wf_doc *d, json_t *list, const struct wf_analysis *a, const char *part,
                           const char *table, struct wf_law_table laws, const struct wf_law_use *u,
                           bool grown)
{
    const struct wf_law *law = wf_law_named(laws, u->law);
    struct wf_property p;
    for (size_t k = 0; wf_law_property(law, u, k, &p); k++) add_value(d, list, a, part, table, &p, grown);
}

/* The plain numbers, or the lists, of all streamlining laws; empty for laws that the species does not use. */
static void put_law(struct wf_doc *d, json_t *o, const struct wf_law_use *u, enum wf_law_kind kind)
{
    const struct wf_law *chosen = wf_law_named(wf_laws.streamlining, u->law), *l;
    for (size_t i = 0; (l = wf_law_row(wf_laws.streamlining, i)); i++)
        for (size_t k = 0, n = wf_law_count(l); k < n; k++) {
            const struct wf_law_parameter *p = &l->parameter[k];
            int at = wf_law_find(chosen, p->name);
            if (p->kind != kind || wf_law_owner(wf_laws.streamlining, p->name) != l) continue;
            if (kind == WF_LAW_LIST)
                wf_doc_numbers(d, o, p->result, at < 0 ? NULL : u->list[at].v, at < 0 ? 0 : u->list[at].n);
            else
                wf_doc_quantity(d, o, p->result, at < 0 ? NAN : u->parameter[at].value,
                                wf_dimension_row(p->dimension)->si, "not given");
        }
}

static json_t *streamlining(struct wf_doc *d, const struct wf_species *sp)
{
    const struct wf_law_use *s = &sp->streamlining;
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "law", s->law);
    put_law(d, o, s, WF_LAW_NUMBER);
    wf_doc_quantity(d, o, "speed_low", s->low, "m/s", "not given");
    wf_doc_quantity(d, o, "speed_high", s->high, "m/s", "not given");
    wf_doc_text(d, o, "beyond", s->law ? wf_beyond_words[s->beyond] : NULL);
    put_law(d, o, s, WF_LAW_LIST);
    put_source(d, o, sp, s->source);
    return o;
}

json_t *wf_part_species(struct wf_doc *d, const struct wf_analysis *a)
{
    const struct wf_species *sp = a->species;
    struct wf_property p;
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "key", sp->key);
    wf_doc_text(d, o, "name", sp->name);
    wf_doc_text(d, o, "name_zh", sp->name_zh);
    wf_doc_text(d, o, "latin", sp->latin);
    wf_doc_text(d, o, "preset", sp->preset);
    wf_doc_text(d, o, "note", sp->note);
    wf_doc_text(d, o, "file", sp->file);
    json_t *values = wf_doc_put(d, o, "values", wf_doc_array(d));
    json_t *walls = wf_doc_put(d, o, "walls", wf_doc_array(d));
    for (size_t i = 0; i < sp->levels; i++) {
        const struct wf_level *level = &sp->level[i];
        const bool grown = wf_analysis_grown(a, i);
        for (size_t k = 0; wf_level_property(level, k, &p); k++)
            add_value(d, values, a, level->name, "", &p, grown);
        if (!level->wall.n) continue;
        json_t *wall = wf_doc_add(d, walls, wf_doc_object(d));
        wf_doc_text(d, wall, "level", level->name);
        wf_doc_numbers(d, wall, "at", level->wall.s, level->wall.n);
        wf_doc_numbers(d, wall, "share", level->wall.v, level->wall.n);
        wf_doc_flag(d, wall, "used", grown);
        put_standing(d, wall, sp, &level->wall_note);
    }
    const bool leaves = a->model->leaf_area > 0 || !isnan(wf_silhouette_area(&a->model->silhouette));
    for (size_t k = 0; wf_crown_property(sp, k, &p); k++)
        if (p.acts != WF_ACTS_DROPS) add_value(d, values, a, "crown", "crown.", &p, leaves);
    add_law_values(d, values, a, "crown", "crown.streamlining.", wf_laws.streamlining, &sp->streamlining,
                   leaves);
    add_law_values(d, values, a, "axes", "axis_drag.", wf_laws.axis_drag, &sp->axis_drag, true);
    wf_doc_put(d, o, "streamlining", streamlining(d, sp));
    return o;
}

static void put_taper(struct wf_doc *d, json_t *o, const struct wf_model *m)
{
    static const char *const tapers[] = {
        [WF_TAPER_TABLE] = "table", [WF_TAPER_LINEAR] = "linear", [WF_TAPER_POWER] = "power"
    };
    if (m->generator == WF_GENERATOR_MEASURED) return;
    wf_doc_text(d, o, "taper", tapers[m->taper]);
    if (m->taper != WF_TAPER_TABLE) wf_doc_quantity(d, o, "tip_share", m->tip_ratio, "1", NULL);
    if (m->taper == WF_TAPER_POWER) wf_doc_quantity(d, o, "taper_power", m->power, "1", NULL);
    if (m->taper == WF_TAPER_TABLE) {
        wf_doc_numbers(d, o, "taper_at", m->profile.s, m->profile.n);
        wf_doc_numbers(d, o, "taper_share", m->profile.v, m->profile.n);
    }
}

json_t *wf_part_model(struct wf_doc *d, const struct wf_model *m)
{
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "key", m->key);
    wf_doc_text(d, o, "name", m->name);
    wf_doc_text(d, o, "note", m->note);
    wf_doc_text(d, o, "source", m->source);
    wf_doc_text(d, o, "file", m->file);
    bool measured = m->generator == WF_GENERATOR_MEASURED;
    wf_doc_text(d, o, "generator", measured ? "measured" : wf_generator_words[m->generator]);
    wf_doc_count(d, o, "levels", wf_model_levels(m));
    if (m->generator == WF_GENERATOR_LEVELS) wf_doc_count(d, o, "seed", m->seed);
    wf_doc_text(d, o, "season", m->season == WF_LEAF_ON ? "leaf_on" : "leaf_off");
    wf_doc_quantity(d, o, "height", m->height, "m", NULL);
    wf_doc_quantity(d, o, "base_radius", m->radius, "m", "the species' level 0 radius is used");
    put_taper(d, o, m);
    wf_doc_quantity(d, o, "lean", m->lean, "rad", NULL);
    wf_doc_quantity(d, o, "lean_azimuth", m->lean_azimuth, "rad", NULL);
    wf_doc_count(d, o, "segments", m->segments);
    wf_doc_quantity(d, o, "crown_base", m->crown_base, "m", "no crown");
    wf_doc_quantity(d, o, "crown_top", m->crown_top, "m", "no crown");
    wf_doc_quantity(d, o, "judged_to", m->judged_to > 0 ? m->judged_to : (double)NAN, "m",
                    "the whole stem is judged");
    wf_doc_quantity(d, o, "leaf_area", m->leaf_area, "m2", "no crown");
    const struct wf_outline_size seen = wf_silhouette_size(m, wf_model_rise(m));
    static const char no_outline[] = "no outline";
    wf_doc_quantity(d, o, "frontal_area", seen.area, "m2", "by the leaf area");
    wf_doc_quantity(d, o, "outline_centre", seen.centre, "m", no_outline);
    wf_doc_quantity(d, o, "outline_breadth", seen.breadth, "m", no_outline);
    wf_doc_quantity(d, o, "outline_height", seen.height, "m", no_outline);
    wf_doc_text(d, o, "crown_mass_by", m->silhouette.by);
    return o;
}

/* The ground, where the named winds are measured, and how they are carried to the site. */
static void put_site(struct wf_doc *d, json_t *o, const struct wf_scenario *s)
{
    const struct wf_wind_place at = wf_scenario_place(s);
    wf_doc_text(d, o, "terrain", s->category->name);
    wf_doc_text(d, o, "terrain_text", s->category->text);
    wf_doc_text(d, o, "terrain_from", s->category_said ? "given" : "assumed");
    wf_doc_text(d, o, "site_kind", s->site_kind);
    wf_doc_text(d, o, "design", s->design ? s->design->title : NULL);
    wf_doc_text(d, o, "wind_terrain", at.terrain->name);
    wf_doc_quantity(d, o, "wind_height", at.height, "m", NULL);
    wf_doc_quantity(d, o, "gust_over_mean", wf_scenario_gust(s, 1.0), "1", NULL);
    wf_doc_quantity(d, o, "carried", s->carried, "1", NULL);
}

json_t *wf_part_site(struct wf_doc *d, const struct wf_scenario *s)
{
    json_t *o = wf_doc_object(d);
    put_site(d, o, s);
    wf_doc_quantity(d, o, "speed_up", s->speed_up, "1", NULL);
    return o;
}

static void put_notes(struct wf_doc *d, json_t *o, const struct wf_wind_note *note)
{
    json_t *list = wf_doc_put(d, o, "wind_notes", wf_doc_array(d));
    for (; note; note = note->next) {
        json_t *item = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, item, "kind", note->kind);
        json_t *parts = wf_doc_put(d, item, "parts", wf_doc_array(d));
        for (size_t k = 0; k < WF_WIND_PARTS && note->part[k]; k++)
            wf_doc_text(d, wf_doc_add(d, parts, wf_doc_object(d)), "text", note->part[k]);
    }
}

json_t *wf_part_scenario(struct wf_doc *d, const struct wf_analysis *a)
{
    const struct wf_scenario *s = &a->scenario;
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "profile", s->profile);
    wf_doc_text(d, o, "profile_file", s->profile_file);
    bool measured = s->measured && a->wind.sample == wf_measured_sample;
    wf_doc_quantity(d, o, "profile_low", measured ? s->measured->z[1] : NAN, "m", "not a measured profile");
    wf_doc_quantity(d, o, "profile_high", measured ? s->measured->z[s->measured->n - 1] : NAN, "m",
                    "not a measured profile");
    wf_doc_quantity(d, o, "reference_height", s->reference_height, "m", NULL);
    wf_doc_quantity(d, o, "averaging_time", WF_MEAN_TIME, "s", NULL);
    wf_doc_text(d, o, "winds_said", s->winds_said);
    put_notes(d, o, s->wind_notes);
    put_site(d, o, s);
    wf_doc_quantity(d, o, "speed_up", s->speed_up, "1", NULL);
    static const char given[] = "no map of the ground";
    wf_doc_text(d, o, "ground_file", s->site ? s->site->file : NULL);
    wf_doc_quantity(d, o, "site_x", s->site ? s->site->x : NAN, "m", given);
    wf_doc_quantity(d, o, "site_y", s->site ? s->site->y : NAN, "m", given);
    wf_doc_quantity(d, o, "roughness", s->roughness, "m", "not used by this profile");
    wf_doc_quantity(d, o, "displacement", s->displacement, "m", "not used by this profile");
    wf_doc_quantity(d, o, "exponent", s->exponent, "1", "not used by this profile");
    double top = NAN, attenuation = NAN;
    if (a->wind.sample == wf_canopy_sample) wf_canopy_shape(&a->wind, &top, &attenuation);
    wf_doc_quantity(d, o, "canopy_height", top, "m", "not used by this profile");
    wf_doc_quantity(d, o, "attenuation", attenuation, "1", "not used by this profile");
    wf_doc_quantity(d, o, "azimuth", s->azimuth, "rad", NULL);
    const double limit[] = { s->corridor > 0 ? s->corridor : NAN, s->corridor > 0 ? s->corridor_towards : NAN,
                             s->tip_angle > 0 ? s->tip_angle : NAN };
    wf_doc_quantity(d, o, "corridor", limit[0], "m", "none is given");
    wf_doc_quantity(d, o, "corridor_towards", limit[1], "rad", "none is given, or where the wind blows");
    wf_doc_quantity(d, o, "tip_angle_limit", limit[2], "rad", "none is given");
    wf_doc_quantity(d, o, "node_spacing", s->node_spacing > 0 ? s->node_spacing : NAN, "m",
                    "no diaphragms are counted");
    wf_doc_quantity(d, o, "temperature", s->temperature, "K", NULL);
    wf_doc_quantity(d, o, "altitude", s->altitude, "m", NULL);
    wf_doc_quantity(d, o, "air_density", a->loads.air_density, "kg/m3", NULL);
    wf_doc_text(d, o, "air_density_from", isnan(s->air_density) ? "temperature and altitude" : "given");
    wf_doc_quantity(d, o, "snow", s->snow, "kg/m2", NULL);
    wf_doc_quantity(d, o, "ice", s->ice, "m", NULL);
    wf_doc_quantity(d, o, "winter_wind", s->winter, "1", NULL);
    wf_doc_quantity(d, o, "gravity", s->gravity, "m/s2", NULL);
    wf_doc_text(d, o, "shelter", s->shelter ? s->shelter : "none");
    return o;
}

/* Only for a species that chooses its axes' drag law. */
static void put_axis_drag(struct wf_doc *d, json_t *method, const struct wf_law *law)
{
    json_t *o = wf_doc_put(d, method, "axis_drag", wf_doc_object(d));
    wf_doc_text(d, o, "name", law->name);
    wf_doc_text(d, o, "source", law->source);
    wf_doc_text(d, o, "validity", law->validity);
    wf_doc_quantity(d, o, "reynolds_low", law->low, "1", "no limit is known");
    wf_doc_quantity(d, o, "reynolds_high", law->high, "1", "no limit is known");
}

static void put_stand(struct wf_doc *d, json_t *peak, const struct wf_stand *s)
{
    wf_doc_quantity(d, peak, "stand_spacing", s->spacing, "m", NULL);
    wf_doc_quantity(d, peak, "stand_height", s->height, "m", NULL);
    wf_doc_quantity(d, peak, "edge_distance", s->edge, "m", "well inside the stand");
    wf_doc_quantity(d, peak, "gap", s->gap, "m", "10 heights of the stand or more");
}

static void put_peak_method(struct wf_doc *d, json_t *o, const struct wf_analysis *a)
{
    const struct wf_peak *p = a->peak;
    const struct wf_peak_method *m = p ? p->method : wf_peak_method_named("mean");
    const struct wf_gust_rule *rule = p ? p->rule : NULL;
    json_t *peak = wf_doc_put(d, o, "peak_method", wf_doc_object(d));
    wf_doc_text(d, peak, "name", m->name);
    wf_doc_text(d, peak, "title", m->title);
    wf_doc_text(d, peak, "source", m->source);
    wf_doc_text(d, peak, "validity", m->validity);
    wf_doc_text(d, peak, "terrain", rule ? rule->called(a->scenario.category) : NULL);
    wf_doc_quantity(d, peak, "structural_damping", rule ? p->damping : NAN, "1", "the method has none");
    wf_doc_flag(d, peak, "damping_known", p && p->damping_known);
    wf_doc_quantity(d, peak, "load_breadth", rule ? p->tree.breadth : NAN, "m", "the method has none");
    if (p && m->mean) put_stand(d, peak, &p->request.stand);
}

json_t *wf_part_peak(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at)
{
    static const char *const none = "the method has none";
    struct wf_peak_parts stem, branches;
    wf_peak_parts_at(a->peak, at->speed, WF_PART_STEM, &stem);
    wf_peak_parts_at(a->peak, at->speed, WF_PART_BRANCHES, &branches);
    const struct {
        const char *key;
        double value;
        const char *unit;
    } row[] = {
        { "load_factor_gusts", stem.factor, "1" },
        { "load_factor_branches", wf_peak_branches(a->peak) ? branches.factor : (double)NAN, "1" },
        { "sway_frequency", stem.frequency, "Hz" },
        { "participation", stem.participation, "1" },
        { "modal_mass", stem.mass, "kg" },
        { "damping_total", stem.damping, "1" },
        { "damping_air", stem.air, "1" },
        { "turbulence", stem.gust.turbulence, "1" },
        { "background", stem.gust.background, "1" },
        { "resonance", stem.gust.resonance, "1" },
        { "peak_of_gusts", stem.gust.peak, "1" },
    };
    json_t *o = wf_doc_object(d);
    for (size_t i = 0; i < WF_COUNT(row); i++)
        wf_doc_quantity(d, o, row[i].key, row[i].value, row[i].unit, none);
    return o;
}

json_t *wf_part_steady(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at)
{
    static const char *const none = "no equilibrium was found in the mean wind, or it was not computed";
    const struct wf_steady *m = &at->steady;
    json_t *o = wf_doc_object(d);
    wf_doc_quantity(d, o, "drag", m->drag, "N", none);
    wf_doc_quantity(d, o, "tip_deflection", m->tip_deflection, "m", none);
    wf_doc_quantity(d, o, "tip_deflection_share", m->tip_deflection / a->tallness, "1", none);
    wf_doc_quantity(d, o, "top_deflection", m->top_deflection, "m", none);
    wf_doc_quantity(d, o, "tip_angle", m->tip_angle, "rad", none);
    wf_doc_quantity(d, o, "base_shear", m->base_shear, "N", none);
    wf_doc_quantity(d, o, "base_moment", m->base_moment, "N m", none);
    return o;
}

static void put_branch_strength(struct wf_doc *d, json_t *method, const struct wf_branch_strength *b)
{
    json_t *o = wf_doc_put(d, method, "branch_strength", wf_doc_object(d));
    wf_doc_text(d, o, "name", b->name);
    wf_doc_quantity(d, o, "factor", b->factor, "1", NULL);
    wf_doc_text(d, o, "source", b->source);
    wf_doc_text(d, o, "validity", b->text);
}

json_t *wf_part_method(struct wf_doc *d, const struct wf_analysis *a)
{
    const struct wf_profile *profile = wf_profile_named(a->scenario.profile);
    const struct wf_law *law = a->loads.streamline ? &a->loads.streamline->law : NULL;
    json_t *o = wf_doc_object(d);
    json_t *solver = wf_doc_put(d, o, "solver", wf_doc_object(d));
    wf_doc_text(d, solver, "name", a->solver->name);
    wf_doc_text(d, solver, "title", a->solver->title);
    wf_doc_text(d, solver, "source", a->solver->source);
    wf_doc_text(d, solver, "validity", a->solver->validity);
    wf_doc_flag(d, solver, "small_deflection", a->solver->small_deflection);
    wf_doc_flag(d, solver, "as_printed", a->solver->as_printed);
    json_t *wind = wf_doc_put(d, o, "wind_profile", wf_doc_object(d));
    wf_doc_text(d, wind, "name", a->scenario.profile);
    wf_doc_text(d, wind, "source", profile ? profile->source : NULL);
    wf_doc_text(d, wind, "validity", profile ? profile->validity : NULL);
    const struct wf_shelter_law *own = wf_shelter_law_named(a->scenario.shelter);
    put_peak_method(d, o, a);
    if (a->branch_strength) put_branch_strength(d, o, a->branch_strength);
    json_t *shelter = wf_doc_put(d, o, "shelter", wf_doc_object(d));
    wf_doc_text(d, shelter, "name", own ? own->name : "none");
    wf_doc_text(d, shelter, "source", own ? own->source : NULL);
    wf_doc_text(d, shelter, "validity", own ? own->validity : NULL);
    json_t *crown = wf_doc_put(d, o, "streamlining", wf_doc_object(d));
    wf_doc_text(d, crown, "name", law ? law->name : "none");
    wf_doc_text(d, crown, "source", law ? law->source : NULL);
    wf_doc_text(d, crown, "validity", law ? law->validity : NULL);
    wf_doc_quantity(d, crown, "speed_low", law ? law->low : NAN, "m/s", "no limit is known");
    wf_doc_quantity(d, crown, "speed_high", law ? law->high : NAN, "m/s", "no limit is known");
    if (a->species->axis_drag.law) put_axis_drag(d, o, &a->loads.axis_drag->law);
    return o;
}

json_t *wf_part_wetted(struct wf_doc *d, const struct wf_wetted *w)
{
    json_t *o = wf_doc_object(d);
    double critical[2];
    for (int k = 0; k < 2; k++)
        critical[k] = w->critical[k].outcome == WF_CRITICAL_SELF_WEIGHT ? 0 : w->critical[k].speed;
    if (w->film > 0) wf_doc_number(d, o, "film_mm", w->film);
    if (w->film > 0) wf_doc_number(d, o, "leaf_area_m2", w->leaf_area);
    wf_doc_number(d, o, "mass_kg", w->mass);
    wf_doc_number(d, o, "speed_m_s", w->speed);
    wf_doc_numbers(d, o, "frequencies_Hz", w->frequency, 2);
    wf_doc_numbers(d, o, "drags_N", w->drag, 2);
    wf_doc_numbers(d, o, "moments_N_m", w->moment, 2);
    wf_doc_numbers(d, o, "deflections_m", w->deflection, 2);
    wf_doc_numbers(d, o, "criticals_m_s", critical, 2);
    return o;
}
