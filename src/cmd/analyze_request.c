/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/analyze_request.h"
#include "base/num.h"
#include "study/brace.h"
#include "study/guy.h"
#include "wind/climate.h"
#include "wind/design.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The solver that is used: a preset's own comes first. NULL: a name is wrong. */
static const struct wf_solver *solver_used(const struct wf_analyze_options *o)
{
    const struct wf_preset *p = wf_preset_named(o->preset);
    return p ? wf_solver_named(p->solver ? p->solver : o->solver) : NULL;
}

static bool solver_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_analyze_options *o = options;
    const struct wf_preset *p = wf_preset_named(o->preset);
    (void)row;
    return wf_option_unused(p && p->solver, why, "with the preset '%s', which has its own", o->preset);
}

static bool guy_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_solver *s = solver_used(options);
    (void)row;
    return s && wf_option_unused(!s->ties, why, "with the solver '%s'", s->name);
}

static bool beside_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_analyze_options *o = options;
    const struct wf_preset *p = wf_preset_named(o->preset);
    const struct wf_solver *s = p && p->solver ? wf_solver_named(p->solver) : wf_solver_named(o->solver);
    (void)row;
    if (strcmp(o->preset, wf_presets[0].name) != 0)
        return wf_option_unused(true, why, "with the preset '%s', which repeats a publication", o->preset);
    if (s && !s->tracked)
        return wf_option_unused(true, why, "with the solver '%s': its solutions have no slopes", s->name);
    return wf_option_unused(o->shelter && strcmp(o->shelter, "none") != 0, why, "with --shelter");
}

static bool reduce_wrong(const void *options, const struct wf_option *row, char *why)
{
    const char *text = ((const struct wf_analyze_options *)options)->reduce;
    struct wf_reduced asked = { 0 };
    (void)row;
    return wf_option_unused(!wf_reduction_read(text, &asked), why,
                            "'%.60s' is no reduction: a share up to 90%%, 20%%, or a length up to 50 m, 3m",
                            text);
}

static bool roots_wrong(const void *options, const struct wf_option *row, char *why)
{
    const char *text = ((const struct wf_analyze_options *)options)->root_loss;
    struct wf_anchorage_request q;
    (void)row;
    return wf_option_unused(!wf_root_loss_read(text, &q), why,
                            "'%.60s' is no loss of roots: a share up to 95%% all around, 40%%, or a sector "
                            "clockwise from north with or without a share, 30deg:120deg:60%% (a whole circle "
                            "is all around)",
                            text);
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
    const struct wf_analyze_options *o = options;
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
    const struct wf_analyze_options *o = options;
    (void)row;
    return wf_option_unused(!o->directions && !o->averaging.climate && !o->profile.ground, why,
                            "without directions (--directions, --climate) or a map (--dem)");
}

static bool place_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_analyze_options *o = options;
    (void)row;
    return wf_option_unused(!o->profile.ground, why, "without the ground, --dem");
}

/* The temperature sets the viscosity of the air too, so it has an effect beside a density. */
static bool altitude_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_analyze_options *o = options;
    const struct wf_preset *p = wf_preset_named(o->preset);
    (void)row;
    if (p && !isnan(p->air_density)) return wf_option_unused(true, why, "with the preset '%s'", p->name);
    return wf_option_unused(!isnan(o->air_density), why, "beside --air-density");
}

static bool density_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_preset *p = wf_preset_named(((const struct wf_analyze_options *)options)->preset);
    (void)row;
    return wf_option_unused(p && !isnan(p->air_density), why, "with the preset '%s', which has its own",
                            p ? p->name : "");
}

static bool snow_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(isnan(((const struct wf_analyze_options *)options)->snow), why, "without --snow");
}

static bool winter_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_analyze_options *o = options;
    (void)row;
    return wf_option_unused(isnan(o->snow) && isnan(o->ice), why, "without --snow and --ice");
}

static bool corridor_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(isnan(((const struct wf_analyze_options *)options)->corridor), why,
                            "without --corridor");
}

#define OPTIONS struct wf_analyze_options
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
    TEXTS(
        "--guy", guys, "HEIGHT:DISTANCE:TOWARDS:STIFFNESS[:PRETENSION]",
        "a cable from the stem to an anchor in the ground, TOWARDS clockwise from north, a spring that only "
        "pulls: 9m:8m:225deg:400kN/m:2kN; its force is printed, its strength and the anchor's are not "
        "assessed",
        .unused = guy_unused),
    TEXTS("--cable", cables, "FROM:TO:STIFFNESS[:PRETENSION][:slack LENGTH][:breaks FORCE]",
          "a cable between two points of the tree, each a height on the stem (9m), the end of a segment "
          "(id:14) or a place in it (id:14@40%), a spring that only pulls: id:14:id:27:200kN/m:1kN:breaks "
          "40kN; its force is printed, and beside a breaking load its safety",
          .unused = guy_unused),
    TEXTS("--rod", rods, "FROM:TO:STIFFNESS[:PRETENSION][:breaks FORCE]",
          "a rod, which also pushes; whether it buckles is not assessed", .unused = guy_unused),
    TEXTS("--scenarios", scenarios, "KEY=VALUE[+KEY=VALUE],...",
          "beside the tree as it stands: such trees, each by keys of a tree, its wind and its site: "
          "cable=id:99:id:58:200kN/m, remove=level:1+cable=..., season=leaf_off, snow=20cm, "
          "root_loss=40%, terrain=II (the neighbours felled)",
          .unused = beside_unused),
    TEXTS("--remove", remove, "PART[+PART],...",
          "short for scenarios remove=PART+PART: without a level of branches (level:2, or its name) or the "
          "segment with an id and all that it carries (id:14)",
          .unused = beside_unused),
    TEXT("--reduce", reduce, "SHARE|LENGTH", NULL,
         "beside the tree as it stands: its crown reduced all round, by a share of its height and width "
         "(20%) or by "
         "a length (3m)",
         .wrong = reduce_wrong, .unused = beside_unused),
    NUMBER("--thin", thin, "SHARE", NONE, NULL, 0, 0.9, NULL,
           "the same with a share of the crown's load taken out (15%); the branches of a drawn tree stay",
           .unused = beside_unused),
    FLAG("--leaf-off", leaf_off, "the same when the leaves have fallen", .unused = beside_unused),
    NUMBER("--cavity-growth", cavity_growth, "LENGTH", LENGTH, "mm", 0, 1000, NULL,
           "the same with so much off the walls of the cavities", .unused = beside_unused),
    TEXT("--root-loss", root_loss, "SHARE|FROM:TO[:SHARE]", NULL,
         "the same with a share of the roots lost, all around (40%) or in a sector clockwise from north "
         "(30deg:120deg or 30deg:120deg:60%): a rule of ours",
         .wrong = roots_wrong, .unused = beside_unused),
    NUMBER("--branches-from", branches_from, "DIAMETER", LENGTH, "cm", 0, 200, "5",
           "branches from this thickness are listed by what fails first; thinner ones are twigs"),
    FLAG("--unions", unions,
         "also list the unions of branches from that thickness and forks by aspect ratio, the branch's "
         "diameter "
         "over that of the parent; their strength is not assessed"),
    WF_NODE_SPACING_ROW(node_spacing),
    NUMBER("--corridor", corridor, "DISTANCE", LENGTH, "m", 0.01, 200, NULL,
           "distance of a corridor, as of a power line, from the base of the stem: also the wind in which a "
           "part of the tree reaches it"),
    NUMBER("--corridor-towards", corridor_towards, "ANGLE", ANGLE, "deg", -360, 360, NULL,
           "direction that it lies in, from +x towards +y [where the wind blows]", .unused = corridor_unused),
    NUMBER("--tip-angle-limit", tip_angle, "ANGLE", ANGLE, "deg", 0.1, 179, NULL,
           "also the wind in which the tip of the stem turns by this angle"),
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
    WF_JOB_ROWS(job),
    WF_PAGE_ROWS("--no-report", pages, "write results and tables only"),
    WF_QUIET_ROW,
    { 0 },
};
_Static_assert(WF_COUNT(wf_analyze_options) <= WF_OPTIONS_MAX, "more options than a command can have");
/* ---- From options to a request ---- */

/* The wind directions of the options; a climate is read, its mistakes are in `d`. Returned: *out, n = 0 when
 * the options specify no directions. */
static enum wf_status read_directions(const struct wf_analyze_options *o, struct wf_arena *a,
                                      struct wf_diag *d, struct wf_directions_request *out, struct wf_err *e)
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
static enum wf_status read_exposure(const struct wf_analyze_options *o, struct wf_arena *a,
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

/* Cables, then rods. */
static enum wf_status read_braces(const struct wf_analyze_options *o, struct wf_arena *a,
                                  struct wf_scenario *s, struct wf_err *e)
{
    struct wf_brace *list = WF_TAKE(a, WF_LINKS_MAX, struct wf_brace);
    enum wf_status status = list ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for cables");
    s->braces = 0;
    if (!status && o->cables) status = wf_braces_read(o->cables, false, a, list, &s->braces, e);
    if (!status && o->rods) status = wf_braces_read(o->rods, true, a, list, &s->braces, e);
    s->brace = list;
    return status;
}

enum wf_status wf_analyze_request_read(const struct wf_analyze_options *o, struct wf_arena *a,
                                       struct wf_diag *d, struct wf_analyze_request *out, struct wf_err *e)
{
    struct wf_scenario *s = &out->scenario;
    wf_scenario_default(s);
    enum wf_status status = wf_scenario_profile(s, &o->profile, a, d, e);
    if (status) return status;
    out->preset = wf_preset_named(o->preset);
    status = wf_peak_asked_read(&o->peak, out->preset != wf_presets, a, d, s, e);
    if (!status) status = wf_anchorage_asked_read(&o->anchorage, o->root_stiffness, a, d, s, e);
    if (status) return status;
    if (o->guys && (status = wf_guys_read(o->guys, o->north, a, &s->guy, &s->guys, e))) return status;
    if ((status = read_braces(o, a, s, e))) return status;
    s->winds_said = o->args.winds_said;
    s->wind_notes = o->args.wind_notes;
    s->azimuth = o->azimuth;
    if (o->corridor > 0) s->corridor = o->corridor, s->corridor_towards = o->corridor_towards;
    if (o->tip_angle > 0) s->tip_angle = o->tip_angle;
    if (o->node_spacing > 0) s->node_spacing = o->node_spacing;
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
    out->search.unions = o->unions;
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
    s->winter = o->winter_wind, s->carried *= s->winter;
    return status;
}

/* ---- Files ---- */

enum wf_status wf_inputs_note(struct wf_inputs *in, const char *role, const char *path, struct wf_err *e)
{
    return wf_input_file_note(role, path, in->arena, &in->item[in->n++], e);
}

/* Files that say where cavities are, and their rays. */
static enum wf_status note_cavities(const struct wf_model *m, struct wf_inputs *in, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    const struct wf_cavity *c = m->cavity;
    for (size_t k = 0; k < m->cavities && !s; k++) {
        bool known =
            !c[k].line || (m->file && !strcmp(c[k].file, m->file)) || (k && c[k].file == c[k - 1].file);
        if (!known) s = wf_inputs_note(in, "cavities", c[k].file, e);
        if (!s && c[k].rays_file) s = wf_inputs_note(in, "rays", c[k].rays_file, e);
    }
    return s;
}

enum wf_status wf_analyze_files_note(const struct wf_analyze_options *o, const struct wf_analyze_request *q,
                                     const struct wf_model *m, struct wf_inputs *in, struct wf_err *e)
{
    const struct wf_anchorage_asked *roots = &o->anchorage;
    const struct {
        const char *role, *path; /* NULL: not given */
    } file[] = { { "outline", o->tree.outline },
                 { "profile", q->scenario.profile_file },
                 { "peak", o->peak.table },
                 { "anchorage", roots->curve ? roots->curve : roots->table },
                 { "ground", q->scenario.site ? q->scenario.site->file : NULL },
                 { "climate", q->directions.climate_file } };
    enum wf_status s = note_cavities(m, in, e);
    for (size_t k = 0; k < WF_COUNT(file) && !s; k++)
        if (file[k].path) s = wf_inputs_note(in, file[k].role, file[k].path, e);
    return s;
}
