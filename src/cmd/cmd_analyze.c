/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm analyze and windfirm compare: what a steady wind does to one or several species on one tree. */
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "cmd/analyze_print.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/scan_models.h"
#include "cmd/wind_speed.h"
#include "data/species.h"
#include "load/drag.h"
#include "out/results.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include "study/directions.h"
#include "study/interval.h"
#include "study/preset.h"
#include "study/wetted.h"
#include "wind/climate.h"
#include "wind/design.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

struct analyze_options {
    struct wf_args args;
    struct wf_tree_asked tree;
    struct wf_speeds wind;
    struct wf_averaging averaging;   /* with the climate */
    struct wf_profile_words profile; /* with the map of the ground */
    struct wf_peak_asked peak;
    struct wf_anchorage_asked anchorage;
    const char *output, *solver, *preset, *shelter, *branch_strength;
    const char *directions, *at; /* NULL: not given                                */
    size_t threads;
    double azimuth, north;          /* [rad]                                     */
    double temperature, altitude;   /* [K], [m]                                  */
    double air_density;             /* [kg m-3]; NAN: from the two above         */
    double search_to, search_time;  /* [m/s], NAN: the library's default; [s]    */
    double mesh_tolerance;          /* [-]                                       */
    size_t samples, seed;           /* of the interval */
    const char *weight_stress;      /* "total" or "change"                        */
    double snow, snow_density, ice; /* [m], [kg m-3], [m]; NAN: not given        */
    double winter_wind;             /* share of the wind named [-] */
    struct wf_water_asked water;
    double root_stiffness, speed_up; /* [N m rad-1]; [-]; NAN: not given          */
    double branches_from;            /* [m]                                       */
    struct wf_pages pages;
};

/* The solver that is used: a preset's own comes first. NULL: a name is wrong. */
static const struct wf_solver *solver_used(const struct analyze_options *o)
{
    const struct wf_preset *p = wf_preset_named(o->preset);
    return p ? wf_solver_named(p->solver ? p->solver : o->solver) : NULL;
}

static bool solver_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct analyze_options *o = options;
    const struct wf_preset *p = wf_preset_named(o->preset);
    (void)row;
    return wf_option_unused(p && p->solver, why, "with the preset '%s', which has its own", o->preset);
}

static bool mesh_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_solver *s = solver_used(options);
    (void)row;
    return s && wf_option_unused(s->unmeshed, why,
                                 "with the solver '%s', which takes the segments as they are", s->name);
}

static bool samples_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct analyze_options *o = options;
    const struct wf_solver *s = solver_used(options);
    (void)row;
    if (strcmp(o->preset, wf_presets[0].name) != 0)
        return wf_option_unused(true, why, "with the preset '%s', which repeats a publication", o->preset);
    if (s && !s->tracked)
        return wf_option_unused(true, why, "with the solver '%s': its solutions have no slopes", s->name);
    return wf_option_unused(o->shelter && strcmp(o->shelter, "none") != 0, why, "with --shelter");
}

static bool root_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_solver *s = solver_used(options);
    (void)row;
    return s && wf_option_unused(s->clamped, why, "with the solver '%s', which clamps the base", s->name);
}

static bool north_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct analyze_options *o = options;
    (void)row;
    return wf_option_unused(!o->directions && !o->averaging.climate && !o->profile.ground, why,
                            "without directions (--directions, --climate) or a map (--dem)");
}

static bool place_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct analyze_options *o = options;
    (void)row;
    return wf_option_unused(!o->profile.ground, why, "without the ground, --dem");
}

/* The temperature sets the viscosity of the air too, so it has an effect beside a density. */
static bool altitude_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct analyze_options *o = options;
    const struct wf_preset *p = wf_preset_named(o->preset);
    (void)row;
    if (p && !isnan(p->air_density)) return wf_option_unused(true, why, "with the preset '%s'", p->name);
    return wf_option_unused(!isnan(o->air_density), why, "beside --air-density");
}

static bool density_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_preset *p = wf_preset_named(((const struct analyze_options *)options)->preset);
    (void)row;
    return wf_option_unused(p && !isnan(p->air_density), why, "with the preset '%s', which has its own",
                            p ? p->name : "");
}

static bool snow_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(isnan(((const struct analyze_options *)options)->snow), why, "without --snow");
}

static bool winter_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct analyze_options *o = options;
    (void)row;
    return wf_option_unused(isnan(o->snow) && isnan(o->ice), why, "without --snow and --ice");
}

#define OPTIONS struct analyze_options
const struct wf_option wf_analyze_options[] = {
    STUDY,
    WF_TREE_ROWS(tree),
    SPEEDS("--wind", wind, averaging, 0, 200,
           "mean wind speeds at the reference height, a list 10,15,25 or from:to:step 5:40:1; a unit behind "
           "the last number holds for all: '36,54 km/h'",
           .letter = "-w"),
    WF_AVERAGING_ROWS(averaging),
    TEXT("--output", output, "FOLDER", NULL,
         "where results, tables, plots and pages go [out/analyze or out/compare]", .letter = "-o"),
    WORD("--solver", solver, "NAME", wf_solver_word, "beam", "how the bent shape is computed", .letter = "-s",
         .unused = solver_unused),
    WORD("--preset", preset, "NAME", wf_preset_word, "corrected",
         "a published method, its formula and constants as printed; warnings say where it is not physical"),
    WF_PROFILE_ROWS(profile),
    WF_PEAK_ROWS(peak),
    WF_BRANCH_STRENGTH_ROW(branch_strength),
    WF_ANCHORAGE_ROWS(anchorage),
    NUMBER("--branches-from", branches_from, "DIAMETER", LENGTH, "cm", 0, 200, "5",
           "branches from this thickness are listed by what fails first; thinner ones are twigs"),
    WF_AZIMUTH_ROW(azimuth),
    CHOICE("--directions", directions, "NUMBER", "8|12|16|36", NULL,
           "also compute winds from this many directions, evenly spaced"),
    PATH("--climate", averaging.climate, "FILE", NULL,
         "wind climate, for hours a year above the critical wind: frequency and strength by direction, a CSV "
         "as for 'windfirm wind rose', hourly means at the reference height; its directions are taken"),
    NUMBER("--north", north, "ANGLE", ANGLE, "deg", -360, 360, "0",
           "where north is in the model: clockwise from +y as seen from above; 0: north is +y, east +x",
           .unused = north_unused),
    WHOLE("--threads", threads, 0, 64, "0", "processors to use, 0: all; the results are the same"),
    WORD("--shelter", shelter, "LAW", wf_shelter_word, "none",
         "the wind inside the crown: none: as outside; wake: reduced by the drag of the windward parts; "
         "feng1999: potential flows as printed"),
    NUMBER("--speed-up", speed_up, "NUMBER", NONE, NULL, 0.1, 5, NULL,
           "exposure of the site: wind at the tree over the wind named [1]"),
    PATH("--dem", profile.ground, "FILE", NULL,
         "or found, for each direction, on heights of the ground, an ESRI ASCII grid, as 'windfirm terrain' "
         "finds it at the reference height"),
    TEXT("--at", at, "X,Y", NULL, "where the tree stands on it [m]", .unused = place_unused),
    NUMBER("--temperature", temperature, "TEMPERATURE", TEMPERATURE, "degC", -60, 60, "15",
           "of the air, for its density and viscosity"),
    NUMBER("--altitude", altitude, "LENGTH", LENGTH, "m", -500, 9000, "0",
           "of the site above the sea, for the density of the air", .unused = altitude_unused),
    NUMBER("--air-density", air_density, "DENSITY", DENSITY, "kg/m3", 0.1, 2, NULL,
           "in place of the one from temperature and altitude", .unused = density_unused),
    NUMBER("--search-to", search_to, "SPEED", SPEED, "m/s", 1, 200, NULL,
           "highest wind at which the critical speed is looked for [60 m/s, or 1.2 times the highest wind "
           "specified where that is more]"),
    NUMBER("--search-time", search_time, "TIME", TIME, "s", 1, 1e6, "120",
           "processor time for the search of a critical speed, and again for the curves; what it leaves out "
           "is said"),
    WF_SAMPLE_ROWS(samples_unused),
    NUMBER("--mesh-tolerance", mesh_tolerance, "NUMBER", NONE, NULL, 0, 0.1, "1e-6",
           "relative error accepted from the mesh; 0 takes one element a segment", .unused = mesh_unused),
    NUMBER("--root-stiffness", root_stiffness, "STIFFNESS", ROTATIONAL_STIFFNESS, "N m/rad", 1, 1e15, NULL,
           "rotational stiffness of the root plate; without it the stem is clamped", .unused = root_unused),
    CHOICE(
        "--weight-stress", weight_stress, "PART", "total|change", "total",
        "total: stresses of weight and wind together; change: without those that the weight makes at rest, "
        "which is unsafe for leaning trees and limbs"),
    NUMBER("--snow", snow, "DEPTH", LENGTH, "cm", 0, 500, NULL,
           "snow on the crown, on its area seen from above: added mass"),
    NUMBER("--snow-density", snow_density, "DENSITY", DENSITY, "kg/m3", 10, 917, "150",
           "of the snow; 150 kg/m3 as in ForestGALES", .unused = snow_unused),
    NUMBER("--winter-wind", winter_wind, "SHARE", NONE, NULL, 0.1, 1, "1",
           "share of the wind named that blows while snow or ice is on the tree", .unused = winter_unused),
    NUMBER("--ice", ice, "THICKNESS", LENGTH, "mm", 0, 200, NULL,
           "radial thickness of ice on all axes and leaves: added mass, and thicker axes in the wind"),
    WF_WATER_ROWS(water),
    WF_PAGE_ROWS("--no-report", pages, "write results and tables only"),
    WF_QUIET_ROW,
    { 0 },
};
_Static_assert(WF_COUNT(wf_analyze_options) <= WF_OPTIONS_MAX, "more options than a command can have");

/* The options, converted to structs of the library. */
struct request {
    struct wf_scenario scenario;
    struct wf_search search;
    struct wf_interval_request interval; /* samples 0: none */
    struct wf_solve_options solve;
    const struct wf_solver *solver;
    const struct wf_preset *preset;
    struct wf_directions_request directions; /* n = 0: none */
};

/* ---- From options to a request ---- */

/* The wind directions of the options; a climate is read, its mistakes are in `d`. Returned: *out, n = 0 when
 * the options specify no directions. */
static enum wf_status read_directions(const struct analyze_options *o, struct wf_arena *a, struct wf_diag *d,
                                      struct wf_directions_request *out, struct wf_err *e)
{
    const char *n = o->directions, *climate = o->averaging.climate, *law = o->averaging.law;
    *out = (struct wf_directions_request){
        .n = n ? (size_t)atoi(n) : 0, .north = o->north, .climate_file = climate, .law = law ? law : "durst"
    };
    if (!climate) return WF_OK;
    struct wf_rose *rose = WF_TAKE(a, 1, struct wf_rose);
    if (!rose) return wf_fail(e, WF_ENOMEM, "not enough memory for a climate");
    enum wf_status s = wf_rose_read(climate, a, d, rose, e);
    if (s) return s;
    out->rose = rose;
    if (n && out->n != rose->sectors)
        return wf_fail(e, WF_EUSAGE, "--directions %s: %s has %zu; leave --directions out to take them", n,
                       climate, rose->sectors);
    out->n = rose->sectors;
    return WF_OK;
}

static enum wf_status read_place(const char *text, double *x, double *y, struct wf_err *e)
{
    if (wf_site_place(text, x, y)) return WF_OK;
    return wf_fail(e, WF_EUSAGE,
                   "--at: '%.100s': the tree's place on --dem is written x,y in m, for example 450,1200",
                   text ? text : "");
}

/* The exposure on a map of the ground: for the wind from one direction and from all specified directions. */
static enum wf_status expose_site(struct wf_site *site, const char *at, struct wf_arena *a,
                                  struct wf_scenario *s, struct wf_directions_request *q, struct wf_err *e)
{
    double *factor = WF_TAKE(a, q->n + 1, double);
    enum wf_status status = read_place(at, &site->x, &site->y, e);
    if (!factor) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu directions", q->n);
    if (!status) status = wf_scenario_site(s, site, q->north, a, e);
    for (size_t k = 0; k < q->n && !status; k++)
        status = wf_site_speed_up(site, 2.0 * M_PI * (double)k / (double)q->n, s->reference_height,
                                  s->roughness, &factor[k], e);
    q->speed_up = factor;
    return status;
}

/* Put the specified exposure into the scenario and, by direction, into the request. */
static enum wf_status read_exposure(const struct analyze_options *o, struct wf_arena *a,
                                    struct wf_scenario *s, struct wf_directions_request *q, struct wf_err *e)
{
    bool given = !isnan(o->speed_up);
    if (given) s->speed_up = o->speed_up;
    const char *dem = o->profile.ground;
    if (dem && given) return wf_fail(e, WF_EUSAGE, "give one of --speed-up and --dem, not both");
    if (!dem) return WF_OK;
    struct wf_site *site = WF_TAKE(a, 1, struct wf_site);
    if (!site) return wf_fail(e, WF_ENOMEM, "not enough memory for a map");
    site->file = dem;
    return expose_site(site, o->at, a, s, q, e);
}

/* Convert the options to a request. A measured profile and a climate are read; their mistakes are in `d`. */
static enum wf_status read_request(const struct analyze_options *o, struct wf_arena *a, struct wf_diag *d,
                                   struct request *out, struct wf_err *e)
{
    struct wf_scenario *s = &out->scenario;
    wf_scenario_default(s);
    enum wf_status status = wf_scenario_profile(s, &o->profile, a, d, e);
    if (status) return status;
    out->preset = wf_preset_named(o->preset);
    status = wf_peak_asked_read(&o->peak, out->preset != wf_presets, a, d, s, e);
    if (!status) status = wf_anchorage_asked_read(&o->anchorage, o->root_stiffness, a, d, s, e);
    if (status) return status;
    s->winds_said = o->args.winds_said;
    s->azimuth = o->azimuth;
    s->weight_unstressed = !strcmp(o->weight_stress, "change");
    if (o->snow > 0) s->snow = o->snow * o->snow_density;
    if (o->ice > 0) s->ice = o->ice;
    s->water = wf_water_asked_film(&o->water);
    s->temperature = o->temperature;
    s->altitude = o->altitude;
    s->air_density = o->air_density;
    if (s->design && isnan(s->air_density) && !WF_GIVEN(o, temperature) && !WF_GIVEN(o, altitude))
        s->air_density = s->design->air; /* the code's pressure at its wind */
    if (!(s->gust_factor > 0.0)) s->gust_factor = o->averaging.gust;
    s->shelter = strcmp(o->shelter, "none") == 0 ? NULL : o->shelter;
    s->branch_strength = o->branch_strength;
    wf_search_default(&out->search);
    if (!isnan(o->search_to)) out->search.speed_max = o->search_to, out->search.beyond = 0.0;
    out->search.seconds = o->search_time;
    out->search.branches_from = o->branches_from;
    out->interval = (struct wf_interval_request){ o->samples, o->seed, o->threads };
    if ((status = wf_interval_check(&out->interval, e))) return status;
    wf_solve_options_default(&out->solve);
    out->solve.threads = o->threads;
    out->solve.mesh_tolerance = o->mesh_tolerance;
    if (!isnan(o->root_stiffness))
        out->solve.root_stiffness[0] = out->solve.root_stiffness[1] = o->root_stiffness;
    out->solver = wf_solver_named(o->solver);
    status = read_directions(o, a, d, &out->directions, e);
    if (!status) status = read_exposure(o, a, s, &out->directions, e);
    s->carried *= o->winter_wind;
    return status;
}

/* ---- The run ---- */

enum {
    OTHER_FILES = 6 + 2 * WF_CAVITIES_MAX
}; /* model, study, profile, climate, ground, anchorage; of cavities */

/* Everything of one run, in one arena. */
struct work {
    struct wf_arena arena;
    struct analyze_options options;
    struct request request;
    const char *folder;
    struct wf_run_folder results;
    struct wf_model model;
    struct wf_species *species;
    struct wf_analysis *analysis;
    size_t inputs;
    struct wf_input_file *input;
    struct wf_diag *diag; /* one per species */
    size_t solved;        /* trees whose given speeds were printed */
    bool all_models;      /* of the scan: say how far they differ */
    struct wf_diag tree;  /* warnings about the file of the tree */
    struct timespec started;
};

/* The speeds named are solved: they are printed before the searches, which take most of the time. */
static void speeds_solved(const struct wf_analysis *an, void *work)
{
    struct work *w = work;
    size_t before = w->solved++;
    if (w->options.args.quiet) return;
    wf_progress_clear();
    if (!before) wf_print_head(stdout, an);
    wf_print_speeds(stdout, an);
    fflush(stdout);
}

static enum wf_status note_input(struct work *w, const char *role, const char *path, struct wf_err *e)
{
    return wf_input_file_note(role, path, &w->arena, &w->input[w->inputs++], e);
}

static void take_warnings(struct wf_diag *to, const struct wf_diag *from)
{
    for (const struct wf_finding *f = from->first; f; f = f->next)
        if (f->severity == WF_WARNING) wf_diag_warn(to, f->code, "%s", f->text);
}

/* The warnings of each species for its results: first those about the file of the tree, which have been
 * printed. */
static void put_tree_first(struct work *w)
{
    for (size_t k = 0; k < w->options.args.n; k++) {
        struct wf_diag all = { .arena = &w->arena };
        take_warnings(&all, &w->tree);
        take_warnings(&all, &w->diag[k]);
        w->diag[k] = all;
    }
}

/* What is wrong with a climate that can be used also belongs to the results. */
static void keep_climate_warnings(struct work *w, const struct wf_diag *d)
{
    w->tree.arena = &w->arena;
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->code && !strcmp(f->code, "frequency-sum")) wf_diag_warn(&w->tree, f->code, "%s", f->text);
}

static const char *anchorage_file(const struct wf_anchorage_asked *q)
{
    return q->curve ? q->curve : q->table;
}

/* Files that say where cavities are, and their rays. */
static enum wf_status note_cavities(struct work *w, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    const struct wf_cavity *c = w->model.cavity;
    for (size_t k = 0; k < w->model.cavities && !s; k++) {
        bool known = !c[k].line || !strcmp(c[k].file, w->model.file) || (k && c[k].file == c[k - 1].file);
        if (!known) s = note_input(w, "cavities", c[k].file, e);
        if (!s && c[k].rays_file) s = note_input(w, "rays", c[k].rays_file, e);
    }
    return s;
}

/* Model and species files; every mistake of every file is printed before the run is refused. */
static enum wf_status read_inputs(struct work *w, struct wf_err *e)
{
    struct wf_diag d = { .arena = &w->arena };
    w->tree.arena = &w->arena;
    const char *model = NULL;
    struct wf_err first = { 0 }, next = { 0 };
    enum wf_status worst =
        wf_tree_asked_read(&w->options.tree, NULL, &w->arena, &w->model, &model, &d, &first);
    take_warnings(&w->tree, &d);
    size_t found = d.errors;
    enum wf_status asked = read_request(&w->options, &w->arena, &d, &w->request, &next);
    if (asked && d.errors == found) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
    if (asked && !worst) worst = asked;
    for (size_t k = 0; k < w->options.args.n; k++) {
        const char *path;
        size_t before = d.errors;
        next = (struct wf_err){ 0 };
        enum wf_status s = wf_shipped("species", w->options.args.operand[k], &w->arena, &path, &d, &next);
        if (!s) s = wf_species_read(path, &wf_laws, &w->arena, &w->species[k], &d, &next);
        if (s && d.errors == before) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
        if (s && !worst) worst = s;
        if (!s && (s = note_input(w, "species", path, e))) return s;
    }
    if (worst && first.code && !d.errors) wf_diag_error(&d, NULL, 0, 0, "%s", first.text);
    wf_print_findings(&d, w->options.args.quiet);
    if (worst && wf_exit_code(worst) != 2) return wf_fail(e, worst, "nothing was computed");
    if (worst)
        return wf_fail(e, worst, "%zu mistake%s in the input; nothing was computed", d.errors,
                       d.errors == 1 ? "" : "s");
    keep_climate_warnings(w, &d);
    const char *const profile = w->request.scenario.profile_file,
                      *const roots = anchorage_file(&w->options.anchorage),
                      *const study = w->options.args.study,
                      *const climate = w->request.directions.climate_file;
    enum wf_status s = wf_input_file_note("model", model, &w->arena, &w->input[0], e);
    if (!s && study) s = note_input(w, "study", study, e);
    if (!s) s = note_cavities(w, e);
    if (!s && profile) s = note_input(w, "profile", profile, e);
    if (!s && roots) s = note_input(w, "anchorage", roots, e);
    if (!s && w->request.scenario.site) s = note_input(w, "ground", w->request.scenario.site->file, e);
    return !s && climate ? note_input(w, "climate", climate, e) : s;
}

/* Analyse the wind from all directions, where specified. */
static enum wf_status run_directions(struct work *w, struct wf_analysis *an, struct wf_err *e)
{
    const struct wf_directions_request *q = &w->request.directions;
    if (!q->n) return WF_OK;
    struct wf_directions *out = WF_TAKE(&w->arena, 1, struct wf_directions);
    if (!out) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu directions", q->n);
    struct wf_err why = { 0 };
    enum wf_status s = wf_directions_run(an, &w->request.solve, q, &w->arena, out, &why);
    if (s == WF_EINTERRUPTED) {
        wf_diag_warn(an->diag, "interrupted", "interrupted before all %zu directions were computed", q->n);
        return WF_OK;
    }
    an->directions = out;
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}

/* With rain on its leaves, or with snow or ice: the tree beside itself without. */
static enum wf_status run_dry(struct work *w, struct wf_analysis *an, enum wf_burden burden, bool there,
                              const struct wf_wetted **to, struct wf_err *e)
{
    if (!there || wf_interrupted()) return WF_OK;
    struct wf_wetted *out = WF_TAKE(&w->arena, 1, struct wf_wetted);
    struct wf_err why = { 0 };
    if (!out) return wf_fail(e, WF_ENOMEM, "not enough memory for the dry tree");
    enum wf_status s = wf_wetted_compare(an, burden, &w->request.solve, &w->arena, out, &why);
    if (s == WF_EINTERRUPTED) {
        wf_diag_warn(an->diag, "interrupted", "interrupted before the dry tree was computed");
        return WF_OK;
    }
    if (!s) *to = out;
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}

static enum wf_status run_burdens(struct work *w, struct wf_analysis *an, struct wf_err *e)
{
    const struct wf_scenario *s = &an->scenario;
    if (run_dry(w, an, WF_BURDEN_WINTER, s->snow > 0 || s->ice > 0, &an->winter, e)) return e->code;
    if (run_dry(w, an, WF_BURDEN_RAIN, s->water > 0, &an->wetted, e)) return e->code;
    if (an->wetted) wf_water_asked_warn(&w->options.water, an->diag);
    return WF_OK;
}

/* Was tree k interrupted? The first one is kept as far as it came; a later one has not what the first has and
 * is left out. Returned: the trees of the results, 0 to go on. */
static size_t end_early(struct work *w, size_t k)
{
    bool cut = false;
    if (!wf_interrupted()) return 0;
    for (const struct wf_finding *f = w->diag[k].first; f; f = f->next)
        cut = cut || (f->code && !strcmp(f->code, "interrupted"));
    size_t whole = k && cut ? k : k + 1;
    if (whole < w->options.args.n)
        wf_diag_warn(&w->diag[0], "interrupted", "interrupted: %zu of %zu trees", whole, w->options.args.n);
    return whole;
}

/* Analyse every species. Returned: *done, those that have results; after an interrupt fewer. */
static enum wf_status analyse(struct work *w, size_t *done, struct wf_err *e)
{
    for (size_t k = *done = 0; k < w->options.args.n; k++) {
        const struct wf_preset *preset = w->request.preset;
        w->diag[k].arena = &w->arena;
        if (wf_preset_apply(preset, &w->arena, &w->species[k], &w->request.scenario, &w->request.solver, e))
            return e->code;
        w->request.search.solved = speeds_solved, w->request.search.context = w;
        wf_stage_item(k + 1, w->options.args.n);
        enum wf_status s = wf_analyze(&w->species[k], &w->model, &w->request.scenario, &w->request.search,
                                      w->request.solver, &w->request.solve, w->options.wind.speed,
                                      w->options.wind.n, &w->arena, &w->diag[k], &w->analysis[k], e);
        if (!s) s = run_directions(w, &w->analysis[k], e);
        if (!s) s = run_burdens(w, &w->analysis[k], e);
        if (!s && preset == wf_presets) /* others repeat a publication as printed */
            s = wf_interval_take(&w->analysis[k], &w->request.solve, &w->request.interval,
                                 WF_GIVEN(&w->options, samples), &w->arena, e);
        if (!s && w->solved == k) speeds_solved(&w->analysis[k], w); /* interrupted before */
        wf_progress_clear();
        if (s) wf_print_findings(&w->diag[k], w->options.args.quiet);
        if (s) return s;
        if (!w->options.args.quiet) wf_print_searched(stdout, &w->analysis[k]);
        wf_preset_warn(preset, &w->analysis[k], &w->diag[k]);
        if ((*done = end_early(w, k))) return WF_OK;
    }
    *done = w->options.args.n;
    return WF_OK;
}

/* With --scan-model all: the other models of the scan. */
static enum wf_status analyse_models(struct work *w, size_t species, struct wf_err *e)
{
    const struct wf_scan_models all = { .tree = &w->options.tree,
                                        .models = w->model.measured_models,
                                        .n = species,
                                        .species = w->species,
                                        .first = w->analysis,
                                        .diag = w->diag,
                                        .scenario = &w->request.scenario,
                                        .search = &w->request.search,
                                        .solver = w->request.solver,
                                        .solve = &w->request.solve,
                                        .wind = &w->options.wind };
    return w->all_models ? wf_scan_models_analyse(&all, &w->arena, e) : WF_OK;
}

/* With --scan-model all, model 1 is analysed first; then the others. */
static int take_all_models(struct work *w, const char *command)
{
    const char **asked = &w->options.tree.scan.scan_model;
    w->all_models = *asked && !strcmp(*asked, "all");
    if (!w->all_models) return -1;
    *asked = "1";
    if (!strcmp(w->options.preset, "corrected")) return -1;
    wf_show(stderr, "windfirm %s: --scan-model all: not with --preset\n", command);
    return 2;
}

/* Pages that no run listed, such as those of an earlier version, stay; they would be mistaken for pages of
 * the new results. */
static void warn_of_old_pages(struct work *w)
{
    static const char *const page[] = { "report.html", "report.pdf" };
    struct stat old;
    for (size_t i = 0; i < WF_COUNT(page); i++) {
        const char *path = wf_arena_print(&w->arena, "%s/%s", w->folder, page[i]);
        if (!path || stat(path, &old)) continue;
        if (old.st_mtim.tv_sec < w->started.tv_sec ||
            (old.st_mtim.tv_sec == w->started.tv_sec && old.st_mtim.tv_nsec < w->started.tv_nsec))
            wf_show(stderr,
                    "warning: %s is the page of an earlier run; 'windfirm report %s' draws it again\n", path,
                    w->folder);
    }
}

static enum wf_status run_all(struct work *w, int argc, char **argv, struct wf_err *e)
{
    size_t n = w->options.args.n;
    w->species = WF_TAKE(&w->arena, n, struct wf_species);
    w->analysis = WF_TAKE(&w->arena, n, struct wf_analysis);
    w->input = WF_TAKE(&w->arena, n + OTHER_FILES, struct wf_input_file);
    w->inputs = 1; /* the first place is kept for the model */
    w->diag = WF_TAKE(&w->arena, n, struct wf_diag);
    struct wf_run run = { .command = wf_command_line(argc, argv, &w->arena),
                          .version = WF_VERSION,
                          .date = wf_run_date(&w->arena),
                          .n = n,
                          .analysis = w->analysis,
                          .input = w->input };
    if (!w->species || !w->analysis || !w->input || !w->diag || !run.command || !run.date)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu species", n);
    enum wf_status s = read_inputs(w, e);
    run.inputs = w->inputs;
    bool pages = !w->options.pages.none, whole = false;
    if (!s) s = wf_results_begin(&w->results, w->folder, pages ? "report" : NULL, e);
    if (s || (s = analyse(w, &run.n, e)) || (s = analyse_models(w, run.n, e))) return s;
    fflush(stdout); /* so that warnings appear below the table where both streams go to one place */
    for (size_t k = 0; k < run.n; k++) wf_print_findings(&w->diag[k], w->options.args.quiet);
    put_tree_first(w);
    if ((s = wf_results_write(&run, w->results.stage, e))) return s;
    s = wf_results_end(&w->results, &w->options.pages, &w->arena, &whole, e);
    if (!w->options.args.quiet)
        wf_show(stdout, "\nResults%s: %s\n",
                whole   ? ", tables, plots and pages"
                : pages ? " and tables (plots and pages not complete)"
                        : " and tables",
                w->folder);
    fflush(stdout);
    if (!whole) warn_of_old_pages(w);
    return s;
}

/* A whole run: read, analyse, print, write, draw. Given: the command line as typed, between low and high
 * species. Returned: exit code. */
static int analyze_or_compare(int argc, char **argv, const char *about, size_t low, size_t high)
{
    struct work w = { 0 };
    struct wf_err e = { 0 };
    (void)clock_gettime(CLOCK_REALTIME, &w.started);
    int code = wf_args_read(argc, argv, wf_analyze_options, about, low, high, &w.arena, &w.options.args);
    if (code < 0) code = wf_tree_asked_check(&w.options.tree, argv[0], NULL);
    if (code < 0) code = take_all_models(&w, argv[0]);
    if (code < 0 && !w.options.wind.n) {
        wf_show(stderr, "windfirm %s: --wind is needed, for example --wind 10,15,25\n", argv[0]);
        code = 2;
    }
    if (code < 0) {
        const char *asked = w.options.output;
        w.folder = asked ? asked : wf_arena_print(&w.arena, "out/%s", argv[0]);
        code = w.folder && run_all(&w, argc, argv, &e) == WF_OK ? 0 : wf_complain(&e);
        wf_run_abandon(&w.results);
    }
    wf_arena_free(&w.arena);
    return code;
}

int wf_cmd_analyze(int argc, char **argv)
{
    static const char about[] =
        "SPECIES is a species table, a file or the name of a shipped one ('windfirm species list'). The tree "
        "bends until its stiffness balances wind and weight, and the wind is taken on the bent shape: once "
        "in "
        "the mean wind, once at the peak of the load of gusts (--peak), which decides what breaks.\n"
        "\n"
        "  windfirm analyze species/moso_bamboo.yaml --model models/moso_culm.yaml --wind 5:40:1";
    return analyze_or_compare(argc, argv, about, 1, 1);
}

int wf_cmd_compare(int argc, char **argv)
{
    static const char about[] = "Every species is grown on the same model, so that a comparison shows "
                                "material and section alone (a model "
                                "may leave the base radius to the species).\n"
                                "\n"
                                "  windfirm compare species/moso_bamboo.yaml species/weeping_willow.yaml \\\n"
                                "      --model models/culm.yaml --wind 10,15,25 -o out/mine";
    return analyze_or_compare(argc, argv, about, 2, 32);
}
