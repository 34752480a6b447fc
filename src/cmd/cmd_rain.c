/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm rain, and windfirm papers yang2011: drops on a branch with leaves. */
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/grow.h"
#include "load/drop_shape.h"
#include "out/rain_results.h"
#include "study/rain_departures.h"
#include "wind/gust.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *form_word(size_t i) { return wf_leaf_forms[i].name; }
static const char *fall_word(size_t i) { return wf_fall_laws[i].name; }
static const char *gust_word(size_t i) { return i ? wf_gust_models[i - 1].name : "steady"; }

struct rain_options {
    struct wf_args args;
    const char *species, *form, *preset, *points, *model, *tree, *storm, *method, *fall_law, *gust;
    struct wf_import_asked import; /* of the tree */
    struct {
        const char *set, *file; /* NULL: not given */
        struct wf_record_words record;
    } run;
    size_t leaves, drops, grid, prisms, clusters, segment, seed, subdrops;
    double leaf_length, petiole, petiole_width, petiole_youngs, branch, base_radius, tip_radius, height, rise,
        droop, fold;                                                  /* [m], [rad] */
    double intensity, drop_size, fall, duration, step, frame, jitter; /* [m/s], [m], [s] */
    double angle, receding, advancing, friction, adhesion, hang, apex, beta, film, zeta, eta, omega, lambda;
    double loss, splash, lever, restoring, damping;
    double wind, azimuth;
    struct wf_averaging averaging;
    struct wf_profile_words profile;
    bool staged, shaking;
    struct wf_pages pages;
    const char *output;
};

static bool inside(const void *at, const void *part, size_t size)
{
    return (const char *)at >= (const char *)part && (const char *)at < (const char *)part + size;
}

/* Speed of a record, which has its own; parameters of a steady wind; a file of another model. */
static bool wind_unused(const struct rain_options *o, const void *at, char *why)
{
    const struct wf_gust_model *m = o->gust ? wf_gust_named(o->gust) : NULL; /* NULL: steady */
    if (at == &o->wind)
        return wf_option_unused(m && !wf_gust_takes_speed(m, o->run.set), why,
                                "with a record, whose speeds are its own unless --set rescale=1");
    if (at == &o->run.set) return wf_option_unused(!m, why, "in a steady wind");
    return wf_option_unused(!m || strcmp(m->name, "record") != 0, why, "without --gust record");
}

/* Options that one of the presets does not use; rain that a staged run does not have. */
static bool rain_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct rain_options *o = options;
    const void *at = (const char *)options + row->member;
    bool printed = o->preset && !strcmp(o->preset, "yang2011");
    bool of_printed = at == &o->adhesion || at == &o->hang || at == &o->loss || at == &o->lever;
    bool of_corrected = at == &o->receding || at == &o->advancing || at == &o->apex || at == &o->film ||
                        at == &o->splash || at == &o->fall_law || at == &o->shaking;
    if (of_printed) return wf_option_unused(!printed, why, "without the preset 'yang2011'");
    if (of_corrected) return wf_option_unused(printed, why, "with the preset 'yang2011'");
    if (at == &o->clusters) return wf_option_unused(!o->points, why, "without --points");
    if (inside(at, &o->import, sizeof o->import)) return wf_option_unused(!o->tree, why, "without --tree");
    if (at == &o->wind || inside(at, &o->run, sizeof o->run)) return wind_unused(o, at, why);
    bool axis = o->model || o->tree;
    if (at == &o->segment) return wf_option_unused(!axis, why, "without --model or --tree");
    if (at == &o->base_radius || at == &o->tip_radius || at == &o->height)
        return wf_option_unused(axis, why, "with --model or --tree, whose axis has its own");
    if (axis && (at == &o->prisms || at == &o->branch || at == &o->rise))
        return wf_option_unused(true, why, "with --model or --tree, whose axis has its own");
    if (at == &o->prisms || at == &o->branch || at == &o->rise)
        return wf_option_unused(o->points, why, "with --points, which give the branch its place");
    return wf_option_unused(o->staged, why, "with --staged, whose drops have their places and times");
}

#define OPTIONS struct rain_options
#define UNUSED .unused = rain_unused
static const struct wf_option rain_options[] = {
    TEXT("--species", species, "SPECIES", "poplar",
         "wood and leaves: a species table, a file or the name of a shipped one", .letter = "-s"),
    CHOICE("--preset", preset, "NAME", "corrected|yang2011", "corrected",
           "yang2011: formulas and constants as printed"),
    WHOLE("--leaves", leaves, 1, 64, "5", "leaves on the branch"),
    WORD("--form", form, "NAME", form_word, "ovate", "outline of the leaves"),
    NUMBER("--leaf-length", leaf_length, "LENGTH", LENGTH, "m", 0.005, 1, NULL,
           "of the main vein [by the species' leaf area; else 8 cm]"),
    NUMBER("--petiole", petiole, "LENGTH", LENGTH, "m", 5e-4, 1, NULL,
           "of the petiole [the species'; else 3 cm]"),
    NUMBER("--petiole-diameter", petiole_width, "LENGTH", LENGTH, "mm", 1e-4, 0.05, NULL,
           "of the petiole [the species'; else 1.6 mm]"),
    NUMBER("--petiole-modulus", petiole_youngs, "PRESSURE", PRESSURE, "GPa", 1e6, 2e10, NULL,
           "Young's modulus of the petiole [the species'; else 0.5 GPa]"),
    NUMBER("--branch", branch, "LENGTH", LENGTH, "m", 0.02, 5, "0.4", "of the branch", UNUSED),
    NUMBER("--base-radius", base_radius, "LENGTH", LENGTH, "m", 2e-4, 0.2, "0.003", "of the branch", UNUSED),
    NUMBER("--tip-radius", tip_radius, "LENGTH", LENGTH, "m", 1e-4, 0.2, "0.0015", "of the branch", UNUSED),
    NUMBER("--height", height, "LENGTH", LENGTH, "m", 0.1, 150, "2", "of the branch's base above the ground",
           UNUSED),
    NUMBER("--rise", rise, "ANGLE", ANGLE, "deg", -80, 80, "11.5", "of the branch above the level", UNUSED),
    NUMBER("--droop", droop, "ANGLE", ANGLE, "deg", -60, 80, "28.6",
           "of the leaves below the level, before they sag"),
    NUMBER("--fold", fold, "ANGLE", ANGLE, "deg", 0, 45, "8.6",
           "of each half of a blade above the level of its vein"),
    WHOLE("--prisms", prisms, 2, 256, "16", "of the branch", UNUSED),
    PATH("--points", points, "FILE", NULL,
         "points on the branch's surface, lines of x y z in m: its nodes by k-means"),
    WHOLE("--clusters", clusters, 3, 256, "12", "nodes found from the points", UNUSED),
    PATH("--model", model, "MODEL", NULL,
         "tree model, a file or the name of a shipped one, of which an axis is the branch", .letter = "-m"),
    PATH("--tree", tree, "FILE", NULL,
         "measured tree of which an axis is the branch, any format of 'windfirm import'", .letter = "-t"),
    WF_IMPORT_ROWS(import, rain_unused),
    WHOLE("--segment", segment, 0, 1e9, "0",
          "id of a segment on that axis [0: the longest of the highest level]", UNUSED),
    WHOLE("--drops", drops, 1, 5000, "20", "drops in the air at the peak of the rain, all of one size",
          UNUSED),
    NUMBER("--intensity", intensity, "RATE", SPEED, "mm/h", 0, 3600, NULL,
           "rain at its peak by Marshall and Palmer's sizes, in place of --drops", UNUSED),
    NUMBER("--drop-size", drop_size, "LENGTH", LENGTH, "mm", 0.2, 20, "3", "diameter of the drops of --drops",
           UNUSED),
    WORD("--fall-law", fall_law, "NAME", fall_word, "atlas", "terminal speed of drops", UNUSED),
    NUMBER("--fall", fall, "LENGTH", LENGTH, "m", 0.05, 20, "2",
           "height above the branch from which drops are followed"),
    CHOICE("--storm", storm, "HOW", "normal|steady", "normal",
           "number of drops over time: a normal curve, or even", UNUSED),
    NUMBER("--variation", jitter, "NUMBER", NONE, NULL, 0, 2, "0.2",
           "standard deviation of the random factor on it", UNUSED),
    WHOLE("--seed", seed, 0, 1e9, "1", "of the random numbers", UNUSED),
    FLAG("--staged", staged, "five drops on the first leaf by a plan: hit, run, merge, hang, fall, rebound"),
    FLAG("--shaking", shaking,
         "drops on leaves feel their acceleration and are shaken off; more of them than from real leaves, "
         "which "
         "bend",
         UNUSED),
    SPEED("--wind", wind, averaging, 0, 60, "0",
          "mean wind at the reference height; it slants the fall and pushes the leaves", .letter = "-w",
          UNUSED),
    WF_AVERAGING_ROWS(averaging),
    WF_AZIMUTH_ROW(azimuth),
    WORD("--gust", gust, "NAME", gust_word, "steady", "how the wind changes"),
    WF_GUST_ROWS(run, rain_unused),
    WF_PROFILE_ROWS(profile),
    NUMBER("--duration", duration, "TIME", TIME, "s", 0.01, 3600, "3", "time that is run"),
    NUMBER("--step", step, "TIME", TIME, "s", 1e-7, 0.02, "0.001", "of time"),
    NUMBER("--frame", frame, "TIME", TIME, "s", 1e-4, 60, "0.01", "between rows of the series"),
    CHOICE("--method", method, "NAME", "midpoint|euler", "midpoint",
           "step in time: implicit, which keeps energy, or explicit Euler as printed, which is stable below "
           "a limit"),
    NUMBER("--damping-ratio", damping, "NUMBER", NONE, NULL, 0, 0.99, "0.05", "at the lowest frequency"),
    NUMBER("--restoring", restoring, "NUMBER", NONE, NULL, 0, 1e6, NULL,
           "of each vertex to its rest place, N/m [0; yang2011: 1]"),
    WHOLE("--grid", grid, 1, 4096, "256", "cells of a leaf, along and across"),
    NUMBER("--contact-angle", angle, "ANGLE", ANGLE, "deg", 0, 180, NULL,
           "of water on the leaf [the species'; else 60 deg, as yang2011]"),
    NUMBER("--receding", receding, "ANGLE", ANGLE, "deg", 0, 180, NULL,
           "contact angle at the back of a drop that runs [10 deg below the contact angle]", UNUSED),
    NUMBER("--advancing", advancing, "ANGLE", ANGLE, "deg", 0, 180, NULL,
           "contact angle at its front [10 deg above]", UNUSED),
    NUMBER("--friction", friction, "NUMBER", NONE, NULL, 0, 10, "0.1", "mu of a drop on the leaf"),
    NUMBER("--adhesion", adhesion, "FORCE", FORCE, "N", 0, 1, "5e-5", "H of a drop as printed", UNUSED),
    NUMBER("--hang", hang, "FORCE", FORCE, "N", 0, 1, "5e-4",
           "largest weight that hangs at an edge, as printed", UNUSED),
    NUMBER("--apex", apex, "LENGTH", LENGTH, "mm", 0.01, 50, "2", "contact of a drop that hangs at an edge",
           UNUSED),
    NUMBER("--beta", beta, "NUMBER", NONE, NULL, 0.01, 1, "0.8",
           "radius of a subdrop over that of the one before"),
    WHOLE("--subdrops", subdrops, 1, 32, "8", "most subdrops of a running drop"),
    NUMBER("--film", film, "LENGTH", LENGTH, "mm", 0, 1, "0.01", "depth of water that a trace keeps", UNUSED),
    NUMBER("--loss", loss, "SHARE", NONE, NULL, 0, 1, "0.1", "epsilon: energy lost on impact, as printed",
           UNUSED),
    NUMBER("--splash", splash, "SHARE", NONE, NULL, 0, 1, "0.2", "of a drop that splashes off", UNUSED),
    NUMBER("--lever", lever, "SHARE", NONE, NULL, 0, 1, "0.8", "phi_t: cap of the lever d/L, as printed",
           UNUSED),
    TEXT("--output", output, "FOLDER", "out/rain", "where tables, figures and the page go", .letter = "-o"),
    WF_PAGE_ROWS("--no-report", pages, "write tables only"),
    WF_QUIET_ROW,
    { 0 },
};

_Static_assert(WF_COUNT(rain_options) <= WF_OPTIONS_MAX, "more options than a command can have");

static const char rain_about[] = "Drops fall on a branch with leaves: they hit, run, merge, hang and fall, "
                                 "and the branch vibrates. By Yang and Wu "
                                 "2011, corrected to physics or as printed.\n"
                                 "\n"
                                 "  windfirm rain --intensity 50mm/h --duration 5\n"
                                 "  windfirm rain --preset yang2011 --drops 200 --grid 512\n"
                                 "  windfirm rain --staged -o out/staged";

/* ---- From options to a run ---- */

static double given_or(double given, double otherwise) { return isnan(given) ? otherwise : given; }

static void take_water(const struct rain_options *o, struct wf_rain_spec *s)
{
    struct wf_water_law *w = &s->water;
    bool printed = s->printed;
    wf_water_law_default(w, printed);
    const struct wf_value *usual = &s->scene.species->crown.leaf_contact_angle;
    if (usual->given && !printed) w->angle = usual->value;
    w->angle = given_or(o->angle, w->angle);
    w->friction = o->friction, w->beta = o->beta, w->tail = o->subdrops;
    const double apart = 10 * WF_PI / 180; /* assumed */
    w->receding = given_or(o->receding, fmax(w->angle - apart, 0.1 * w->angle));
    w->advancing = given_or(o->advancing, fmin(w->angle + apart, WF_PI - 0.1 * (WF_PI - w->angle)));
    w->apex = o->apex, w->film = o->film;
    w->adhesion = o->adhesion, w->hang = o->hang;
    s->loss = o->loss, s->lever = o->lever, s->splash = printed ? 0 : o->splash;
    s->grid = o->grid;
}

static void take_scene(const struct rain_options *o, const struct wf_species *sp, struct wf_scene_spec *s)
{
    s->species = sp, s->form = wf_leaf_form_named(o->form), s->leaves = o->leaves;
    wf_scene_spec_leaf(s);
    s->leaf_length = given_or(o->leaf_length, s->leaf_length), s->petiole = given_or(o->petiole, s->petiole);
    s->petiole_radius = given_or(o->petiole_width / 2, s->petiole_radius);
    s->petiole_youngs = given_or(o->petiole_youngs, s->petiole_youngs), s->branch = o->branch;
    s->radius[0] = o->base_radius, s->radius[1] = o->tip_radius;
    s->height = o->height, s->rise = o->rise, s->droop = o->droop, s->fold = o->fold, s->prisms = o->prisms;
    if (!isnan(o->restoring)) s->restoring = o->restoring;
}

static enum wf_status take_rain(const struct rain_options *o, struct wf_rain_spec *s, struct wf_err *e)
{
    if (!isnan(o->intensity) && WF_GIVEN(o, drops))
        return wf_fail(e, WF_EUSAGE, "give rain by either --drops or --intensity");
    s->drops = isnan(o->intensity) ? o->drops : 0;
    s->rain.intensity = isnan(o->intensity) ? 0 : o->intensity;
    s->rain.diameter = o->drop_size, s->rain.law = wf_fall_law_named(o->fall_law);
    s->rain.jitter = o->jitter, s->rain.seed = o->seed;
    if (!strcmp(o->storm, "normal")) s->rain.middle = o->duration / 2, s->rain.width = o->duration / 5;
    s->fall = o->fall, s->duration = o->duration, s->step = o->step, s->frame = fmax(o->frame, o->step);
    s->staged = o->staged, s->damping = o->damping, s->shaken = o->shaking;
    s->method = !strcmp(o->method, "euler") ? WF_PRISM_EULER : WF_PRISM_MIDPOINT;
    if (s->staged && s->duration < 1.5)
        return wf_fail(e, WF_EUSAGE, "the staged drops take 1.5 s; --duration is %g s", s->duration);
    return WF_OK;
}

/* How the wind of a gust model changes at the branch, step by step. */
static enum wf_status take_gust(const struct rain_options *o, const struct wf_rain_spec *s, double mean,
                                double *along, size_t steps, struct wf_arena *a, struct wf_diag *d,
                                struct wf_err *e)
{
    struct wf_gust_spec spec;
    struct wf_gust gust;
    wf_gust_spec_default(wf_gust_named(o->gust), &spec);
    spec.height = s->scene.height, spec.step = s->step, spec.steps = steps, spec.seed = o->seed;
    if (mean > 0) spec.speed = mean;
    enum wf_status status = wf_gust_set_words(&spec, o->run.set, a, e);
    if (!status && !strcmp(o->gust, "record"))
        status = wf_gust_record_words(&spec, o->run.file, &o->run.record, a, d, e);
    if (!status && spec.record && !wf_gust_takes_speed(spec.model, o->run.set))
        spec.speed = spec.record->mean;
    if (status || (status = wf_gust_open(&spec, a, d, &gust, e))) return status;
    double *block = WF_TAKE(a, spec.components * gust.block, double);
    status = block ? wf_gust_history(&gust, 0, 0, block, along, e) : wf_fail(e, WF_ENOMEM, "no memory");
    wf_gust_close(&gust);
    return status;
}

/* Wind at the branch in every step, along the azimuth; a record is taken as measured there. */
static enum wf_status take_wind(const struct rain_options *o, struct wf_rain_spec *s, struct wf_arena *a,
                                struct wf_diag *d, struct wf_err *e)
{
    struct wf_scenario sc;
    struct wf_wind wind;
    size_t steps = (size_t)(s->duration / s->step) + 2;
    bool steady = !strcmp(o->gust, "steady");
    if (!(o->wind > 0) && (steady || wf_gust_takes_speed(wf_gust_named(o->gust), o->run.set)))
        return steady ? WF_OK : wf_fail(e, WF_EUSAGE, "--gust %s needs a mean wind above 0, --wind", o->gust);
    wf_scenario_default(&sc);
    sc.azimuth = o->azimuth;
    enum wf_status status = wf_scenario_profile(&sc, &o->profile, a, d, e);
    if (status || (status = wf_scenario_check(&sc, e))) return status;
    wf_scenario_wind(&sc, &wind);
    wind.speed = wf_scenario_speed(&sc, o->wind);
    double at[3] = { 0, 0, s->scene.height }, u[3], du[9], *out = WF_TAKE(a, 2 * steps, double);
    double *along = WF_TAKE(a, steps, double);
    if (!out || !along) return wf_fail(e, WF_ENOMEM, "not enough memory for the wind");
    wind.sample(&wind, at, u, du);
    double mean = hypot(u[0], u[1]);
    for (size_t i = 0; i < steps; i++) along[i] = mean;
    if (!steady) status = take_gust(o, s, mean, along, steps, a, d, e);
    for (size_t i = 0; i < steps; i++)
        out[2 * i] = along[i] * cos(o->azimuth), out[2 * i + 1] = along[i] * sin(o->azimuth);
    s->wind = out;
    return status;
}

/* Nodes of the branch from points on its surface, moved to where the branch stands. */
static enum wf_status take_points(const struct rain_options *o, struct wf_rain_spec *s, struct wf_arena *a,
                                  struct wf_rain_page *page, struct wf_diag *d, struct wf_err *e)
{
    if (!o->points) return WF_OK;
    struct wf_cloud *p = WF_TAKE(a, 1, struct wf_cloud);
    struct wf_clusters *c = WF_TAKE(a, 1, struct wf_clusters);
    if (!p || !c) return wf_fail(e, WF_ENOMEM, "no memory");
    enum wf_status status = wf_cloud_read(o->points, a, p, d, e);
    if (status) return status;
    double base[3] = { INFINITY, 0, 0 };
    for (size_t i = 0; i < p->n; i++)
        if (p->at[3 * i] < base[0]) memcpy(base, p->at + 3 * i, sizeof base);
    if ((status = wf_kmeans(p, o->clusters, o->seed, base, a, c, e))) return status;
    if (c->moving)
        wf_diag_warn(d, "clusters-unsettled",
                     "%s: %zu of %zu points still changed their cluster in the last round; the nodes are not "
                     "final: fewer "
                     "clusters, or another --seed",
                     o->points, c->moving, p->n);
    double *nodes = WF_TAKE(a, 3 * c->n, double);
    if (!nodes) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < 3 * c->n; i++)
        nodes[i] = c->centre[i] - c->centre[i % 3] + (i % 3 == 2 ? o->height : 0);
    s->scene.nodes = nodes, s->scene.node_count = c->n;
    page->points = p, page->clusters = c;
    return WF_OK;
}

/* An axis of a tree as the branch. */
static enum wf_status take_axis(const struct rain_options *o, const struct wf_species *sp,
                                struct wf_scene_spec *s, struct wf_arena *a, struct wf_diag *d,
                                struct wf_err *e)
{
    if ((o->model != NULL) + (o->tree != NULL) + (o->points != NULL) > 1)
        return wf_fail(e, WF_EUSAGE, "give the branch by one of --model, --tree and --points");
    if (!o->model && !o->tree) return WF_OK;
    struct wf_model *m = WF_TAKE(a, 1, struct wf_model);
    struct wf_tree t;
    if (!m) return wf_fail(e, WF_ENOMEM, "no memory");
    const struct wf_import_options how = wf_import_asked_options(&o->import);
    enum wf_status status = o->tree ? wf_model_imported(o->tree, "axis", &how, a, &m, d, e)
                                    : wf_model_named(o->model, a, m, d, e);
    if (!status) status = wf_grow(m, sp, a, &t, d, e);
    return status ? status : wf_scene_axis(&t, (int64_t)o->segment, s, a, e);
}

/* ---- Printing ---- */

static void print_run(const char *name, const struct wf_rain_result *r)
{
    size_t count[WF_WATER_EVENTS] = { 0 };
    for (size_t l = 0; l < r->spec->scene.leaves; l++)
        for (int k = 0; k < WF_WATER_EVENTS; k++) count[k] += r->leaf[l].count[k];
    const struct wf_water_budget *w = &r->water;
    const struct wf_energy_budget *b = &r->energy;
    wf_show(stdout, "%s\n", name);
    wf_show(stdout, "  %zu leaves, %zu vertices, %zu facets, grid %zu; lowest frequency %.3g Hz\n",
            r->spec->scene.leaves, r->scene.vertices, r->scene.facets, r->spec->grid, r->frequency);
    wf_show(stdout,
            "  drops: %zu hit leaves, %zu wood, %zu passed by; %zu began to run, %zu merged, %zu hung, %zu "
            "fell\n",
            r->hits, r->wood_hits, r->missed, count[WF_WATER_RAN], count[WF_WATER_MERGED],
            count[WF_WATER_HUNG], count[WF_WATER_FELL]);
    wf_show(stdout,
            "  water mg: rain %.4g = air %.4g + ground %.4g + splash %.4g + wood %.4g + on leaves %.4g + "
            "film %.4g; off by "
            "%.1e\n",
            1e6 * w->rain, 1e6 * w->air, 1e6 * w->ground, 1e6 * w->splash, 1e6 * w->wood, 1e6 * w->held,
            1e6 * w->film, w->off);
    wf_show(stdout,
            "  energy uJ: drops arrived with %.4g, gave %.4g; weight %.4g, water's weight %.4g, wind %.4g, "
            "damping "
            "-%.4g, change %.4g; "
            "off by %.1e\n",
            1e6 * b->drops, 1e6 * b->push, 1e6 * b->weight, 1e6 * b->load, 1e6 * b->wind, 1e6 * b->damping,
            1e6 * (b->end - b->start), b->off);
    if (isfinite(r->ring_frequency))
        wf_show(stdout, "  rings down at %.3g Hz with a decrement of %.3g (set: %.3g at %.3g Hz)\n",
                r->ring_frequency, r->ring_decrement,
                WF_TURN * r->spec->damping / sqrt(1 - r->spec->damping * r->spec->damping), r->frequency);
    wf_show(stdout, "  %zu steps, %.0f a second without drawing\n\n", r->steps,
            (double)r->steps / fmax(r->seconds, 1e-9));
}

/* The rod for the comparison with beam theory: the branch, as thick as at its base. */
static enum wf_status compare_prisms(const struct wf_scene_spec *s, struct wf_arena *a,
                                     struct wf_rain_page *page, struct wf_err *e)
{
    const struct wf_level *wood = s->wood;
    page->rod = (struct wf_prism_rod){ s->branch,
                                       s->radius[0],
                                       wood->youngs_modulus.value,
                                       wood->shear_modulus.value,
                                       wood->density.value,
                                       s->restoring > 0 ? s->restoring : 1 };
    return wf_prism_compare(&page->rod, a, page->check, e);
}

static enum wf_status rain(void *work, struct wf_doc_head *head, struct wf_run_folder *f, struct wf_arena *a,
                           struct wf_diag *d, struct wf_err *e)
{
    const struct rain_options *o = work;
    struct wf_species sp;
    struct wf_rain_spec spec;
    struct wf_rain_result result;
    struct wf_rain_page_run run = { .name = o->staged ? "staged drops" : "rain", .of = &result, .diag = d };
    struct wf_rain_page page = { .n = 1, .run = &run };
    enum wf_status s = wf_species_named(o->species, a, &sp, d, e);
    if (s) return s;
    wf_rain_spec_default(&spec, !strcmp(o->preset, "yang2011"));
    take_scene(o, &sp, &spec.scene);
    take_water(o, &spec);
    if ((s = take_axis(o, &sp, &spec.scene, a, d, e)) || (s = take_rain(o, &spec, e)) ||
        (s = take_wind(o, &spec, a, d, e)) || (s = take_points(o, &spec, a, &page, d, e)))
        return s;
    if ((s = wf_results_begin(f, o->output, o->pages.none ? NULL : "rain", e))) return s;
    s = wf_rain_run(&spec, a, d, &result, e);
    if (!s) wf_rain_departures(&result, d);
    if (!s) s = compare_prisms(&result.scene.spec, a, &page, e);
    wf_progress_clear();
    if (s) return s;
    if (!o->args.quiet) print_run(run.name, &result);
    wf_doc_head_file(head, "species", sp.file);
    s = wf_rain_results_write(&page, head, f->stage, e);
    if (!s) s = wf_results_end(f, &o->pages, a, NULL, e);
    if (!s && !o->args.quiet)
        wf_show(stdout, "Tables%s: %s\n", o->pages.none ? "" : ", figures and page", o->output);
    return s;
}

int wf_cmd_rain(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct rain_options o = { 0 };
    int code = wf_args_read(argc, argv, rain_options, rain_about, 0, 0, &arena, &o.args);
    if (code < 0) code = wf_command_perform(argc, argv, rain, &o, o.args.quiet, &arena);
    wf_arena_free(&arena);
    return code;
}

/* ---- windfirm papers yang2011 ---- */

/* Table 1 of the paper: leaves, mesh of a leaf for no fewer vertices and facets, grid, drops, frames a
 * second. */
static const struct {
    size_t scene, leaves, vertices, facets, mesh[2];
    double frames[3][2]; /* grids 128, 256, 512; 20 and 200 drops */
} paper_scenes[] = {
    { 1, 5, 3409, 4500, { 18, 18 }, { { 10.72, 4.16 }, { 5.49, 1.03 }, { 1.43, 0.18 } } },
    { 2, 5, 2046, 3046, { 13, 14 }, { { 13.57, 5.28 }, { 5.91, 1.89 }, { 1.52, 0.19 } } },
    { 3, 6, 2626, 3533, { 14, 14 }, { { 10.33, 3.59 }, { 4.15, 0.58 }, { 1.07, 0.13 } } },
};
enum { PAPER_RUNS = 3, PAPER_SPEEDS = 18 };

/* One cell of the table, in an arena of its own. */
static enum wf_status time_scene(const struct wf_species *sp, size_t i, size_t g, size_t dense,
                                 struct wf_rain_speed *out, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_rain_spec spec;
    struct wf_rain_result r;
    wf_rain_spec_default(&spec, false);
    spec.scene.species = sp, spec.scene.leaves = paper_scenes[i].leaves;
    memcpy(spec.scene.mesh, paper_scenes[i].mesh, sizeof spec.scene.mesh);
    spec.grid = (size_t)128 << g, spec.drops = dense ? 200 : 20, spec.duration = 0.6;
    enum wf_status s = wf_rain_run(&spec, &a, &d, &r, e);
    if (!s)
        *out = (struct wf_rain_speed){ paper_scenes[i].scene,
                                       spec.scene.leaves,
                                       r.scene.vertices,
                                       r.scene.facets,
                                       spec.grid,
                                       spec.drops,
                                       paper_scenes[i].vertices,
                                       paper_scenes[i].facets,
                                       paper_scenes[i].frames[g][dense],
                                       (double)r.steps / fmax(r.seconds, 1e-9) };
    wf_arena_free(&a);
    return s;
}

static enum wf_status time_scenes(const struct wf_species *sp, struct wf_rain_speed *out, size_t *n,
                                  struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t i = 0; i < WF_COUNT(paper_scenes); i++)
        for (size_t g = 0; g < 3; g++)
            for (size_t dense = 0; dense < 2 && !s && !wf_interrupted(); dense++) {
                s = time_scene(sp, i, g, dense, &out[*n], e);
                *n += !s;
            }
    wf_progress_clear();
    return s;
}

struct paper_options {
    struct wf_args args;
    const char *output;
    struct wf_pages pages;
};
#undef OPTIONS
#define OPTIONS struct paper_options
static const struct wf_option paper_options[] = {
    TEXT("--output", output, "FOLDER", "out/yang2011", "where tables, figures and the page go",
         .letter = "-o"),
    WF_PAGE_ROWS("--no-report", pages, "write tables only"),
    WF_QUIET_ROW,
    { 0 },
};

/* The staged drops, corrected and as printed, and rain of 200 drops. */
static enum wf_status paper_runs(const struct wf_species *sp, struct wf_rain_spec spec[PAPER_RUNS],
                                 struct wf_rain_result result[PAPER_RUNS], struct wf_diag diag[PAPER_RUNS],
                                 struct wf_rain_page *page, struct wf_arena *a, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t r = 0; r < PAPER_RUNS && !s; r++) {
        if (r && wf_interrupted()) return WF_OK;
        diag[r].arena = a;
        wf_rain_spec_default(&spec[r], r == 1);
        spec[r].scene.species = sp, spec[r].staged = r < 2;
        if (r == 2)
            spec[r].drops = 200, spec[r].duration = 2, spec[r].rain.middle = 1, spec[r].rain.width = 0.4;
        wf_stage_item(r + 1, PAPER_RUNS);
        s = wf_rain_run(&spec[r], a, &diag[r], &result[r], e);
        if (!s) wf_rain_departures(&result[r], &diag[r]);
        wf_progress_clear();
        page->n += !s;
    }
    return s;
}

static enum wf_status paper(void *work, struct wf_doc_head *head, struct wf_run_folder *f, struct wf_arena *a,
                            struct wf_diag *d, struct wf_err *e)
{
    const struct paper_options *o = work;
    struct wf_species sp;
    struct wf_rain_spec spec[PAPER_RUNS];
    struct wf_rain_result result[PAPER_RUNS];
    struct wf_diag diag[PAPER_RUNS] = { { 0 } };
    struct wf_rain_speed speed[PAPER_SPEEDS];
    struct wf_prism_order order[WF_PRISM_ORDERS];
    const struct wf_rain_page_run run[PAPER_RUNS] = { { "staged drops, corrected", &result[0], &diag[0] },
                                                      { "staged drops, as printed", &result[1], &diag[1] },
                                                      { "200 drops in the air, corrected", &result[2],
                                                        &diag[2] } };
    struct wf_rain_page page = { .run = run, .speed = speed };
    enum wf_status s = wf_species_named("poplar", a, &sp, d, e);
    if (s || (s = wf_results_begin(f, o->output, o->pages.none ? NULL : "rain", e))) return s;
    if ((s = paper_runs(&sp, spec, result, diag, &page, a, e)) ||
        (s = compare_prisms(&result[0].scene.spec, a, &page, e)))
        return s;
    if ((s = wf_prism_disorder(&page.rod, a, order, e)) == WF_OK) page.order = order;
    if ((s && s != WF_EINTERRUPTED) || (s = time_scenes(&sp, speed, &page.speeds, e))) return s;
    for (size_t r = 0; r < page.n && !o->args.quiet; r++) print_run(run[r].name, &result[r]);
    for (size_t r = 0; r < page.n; r++)
        for (const struct wf_finding *w = diag[r].first; w; w = w->next) wf_diag_pass(d, w);
    s = wf_rain_results_write(&page, head, f->stage, e);
    if (!s) s = wf_results_end(f, &o->pages, a, NULL, e);
    if (!s && !o->args.quiet)
        wf_show(stdout, "Tables%s: %s\n", o->pages.none ? "" : ", figures and page", o->output);
    return s;
}

int wf_paper_yang2011(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct paper_options o = { 0 };
    int code = wf_args_read(
        argc, argv, paper_options,
        "The runs of Yang and Wu 2011: rain on a branch, staged and random, corrected and as printed, and "
        "the speed beside its Table 1.",
        1, 1, &arena, &o.args);
    if (code < 0) code = wf_command_perform(argc, argv, paper, &o, o.args.quiet, &arena);
    wf_arena_free(&arena);
    return code;
}
