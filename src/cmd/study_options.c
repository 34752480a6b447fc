#include "cmd/profile_options.h"
#include "cmd/study_directions.h"
#include "cmd/wind_speed.h"
#include "study/scenario.h"
#include "wind/shelter.h"
#include <string.h>

static const char *solver_word(size_t i) { return wf_solvers[i] ? wf_solvers[i]->name : NULL; }
static const char *preset_word(size_t i) { return wf_presets[i].name; }
const char *wf_profile_word(size_t i) { return wf_profiles[i].name; }
static const char *shelter_word(size_t i) { return i ? wf_shelter_laws[i - 1].name : "none"; }

const struct wf_option wf_study_options[] = {
    WF_TREE_OPTIONS,
    { .name = "--wind",
      .letter = "-w",
      .kind = WF_OPTION_SPEEDS,
      .value = "SPEEDS",
      .dimension = WF_DIM_SPEED,
      .unit = "m/s",
      .low = 0,
      .high = 200,
      .help =
          "mean wind speeds at the reference height, a list 10,15,25 or from:to:step 5:40:1; a unit behind "
          "the last number holds for all: '36,54 km/h'" },
    WF_AVERAGING_OPTIONS,
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .help = "where results, tables, plots and pages go [out/analyze or out/compare]" },
    { .name = "--solver",
      .letter = "-s",
      .kind = WF_OPTION_CHOICE,
      .value = "NAME",
      .initial = "beam",
      .word = solver_word,
      .help = "how the bent shape is computed" },
    { .name = "--preset",
      .kind = WF_OPTION_CHOICE,
      .value = "NAME",
      .initial = "corrected",
      .word = preset_word,
      .help = "a published method, its formula and constants as printed; warnings tell where it leaves "
              "physics" },
    WF_PROFILE_OPTIONS,
    { .name = "--reference-height",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "10",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0.01,
      .high = 1000,
      .help = "height at which the wind has the speed named" },
    { .name = "--exponent",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "0.16",
      .dimension = WF_DIM_NONE,
      .low = 0,
      .high = 1,
      .help = "of the power profile" },
    { .name = "--roughness",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "0.03",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 1e-6,
      .high = 10,
      .help = "roughness length of the log and canopy profiles; left out with canopy: 0.1 of its height" },
    { .name = "--displacement",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "0",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0,
      .high = 100,
      .help = "zero-plane displacement: height the log profile is lifted by, above and in a stand; left out "
              "with canopy: 0.7 of "
              "its height" },
    { .name = "--canopy-height",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "0",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0,
      .high = 100,
      .help = "of the stand around the tree, for the canopy profile; 0: displacement / 0.7" },
    { .name = "--attenuation",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "0",
      .dimension = WF_DIM_NONE,
      .low = 0,
      .high = 10,
      .help = "of the wind inside the canopy; 0: joins the log law smoothly" },
    { .name = "--azimuth",
      .kind = WF_OPTION_NUMBER,
      .value = "ANGLE",
      .initial = "0",
      .dimension = WF_DIM_ANGLE,
      .unit = "deg",
      .low = -360,
      .high = 360,
      .help = "direction the wind blows towards, from +x towards +y" },
    WF_DIRECTION_OPTIONS,
    { .name = "--shelter",
      .kind = WF_OPTION_CHOICE,
      .value = "LAW",
      .initial = "none",
      .word = shelter_word,
      .help = "the wind inside the crown: none: as outside; wake: what drag of the windward parts leaves; "
              "feng1999: "
              "potential flows as printed" },
    { .name = "--speed-up",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "1",
      .dimension = WF_DIM_NONE,
      .low = 0.1,
      .high = 5,
      .help =
          "exposure of the site: wind at the tree over the wind named, as 'windfirm terrain' tells it for a "
          "place" },
    { .name = "--temperature",
      .kind = WF_OPTION_NUMBER,
      .value = "TEMPERATURE",
      .initial = "15",
      .dimension = WF_DIM_TEMPERATURE,
      .unit = "degC",
      .low = -60,
      .high = 60,
      .help = "of the air" },
    { .name = "--altitude",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "0",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = -500,
      .high = 9000,
      .help = "of the site above the sea, for the density of the air" },
    { .name = "--air-density",
      .kind = WF_OPTION_NUMBER,
      .value = "DENSITY",
      .dimension = WF_DIM_DENSITY,
      .unit = "kg/m3",
      .low = 0.1,
      .high = 2,
      .help = "in place of the one from temperature and altitude" },
    { .name = "--search-to",
      .kind = WF_OPTION_NUMBER,
      .value = "SPEED",
      .initial = "100",
      .dimension = WF_DIM_SPEED,
      .unit = "m/s",
      .low = 1,
      .high = 200,
      .help = "highest wind at which the critical speed is looked for" },
    { .name = "--mesh-tolerance",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "1e-6",
      .dimension = WF_DIM_NONE,
      .low = 0,
      .high = 0.1,
      .help = "relative error accepted from the mesh; 0 takes one element a segment" },
    { .name = "--root-stiffness",
      .kind = WF_OPTION_NUMBER,
      .value = "STIFFNESS",
      .dimension = WF_DIM_ROTATIONAL_STIFFNESS,
      .unit = "N m/rad",
      .low = 1,
      .high = 1e15,
      .help = "rotational stiffness of the root plate; left out, the stem is clamped" },
    { .name = "--no-report", .kind = WF_OPTION_FLAG, .help = "write results and tables only" },
    { .name = "--lang",
      .kind = WF_OPTION_CHOICE,
      .value = "NAME",
      .initial = "en",
      .choices = "en|zh",
      .help = "language of the report" },
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

/* What is not said of a stand follows from its height: d = 0.7 h, z0 = 0.1 h (Garratt 1992, The Atmospheric
 * Boundary Layer, Cambridge University Press, sec. 4.3). */
static void complete_canopy(const struct wf_args *g, struct wf_scenario *s)
{
    if (strcmp(s->profile, "canopy") != 0) return;
    double height = s->canopy_height > 0.0 ? s->canopy_height : s->displacement / 0.7;
    if (!wf_args_given(g, "--displacement")) s->displacement = 0.7 * height;
    if (!wf_args_given(g, "--roughness") && height > 0.0) s->roughness = 0.1 * height;
}

enum wf_status wf_study_from_args(const struct wf_args *g, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_study *out, struct wf_err *e)
{
    struct wf_scenario *s = &out->scenario;
    wf_scenario_default(s);
    enum wf_status status =
        wf_scenario_profile(s, wf_args_text(g, "--profile"), wf_args_text(g, "--profile-file"), a, d, e);
    if (status) return status;
    s->winds_said = g->winds_said;
    s->reference_height = wf_args_number(g, "--reference-height");
    s->exponent = wf_args_number(g, "--exponent");
    s->roughness = wf_args_number(g, "--roughness");
    s->displacement = wf_args_number(g, "--displacement");
    s->canopy_height = wf_args_number(g, "--canopy-height");
    s->attenuation = wf_args_number(g, "--attenuation");
    s->azimuth = wf_args_number(g, "--azimuth");
    s->speed_up = wf_args_number(g, "--speed-up");
    s->temperature = wf_args_number(g, "--temperature");
    s->altitude = wf_args_number(g, "--altitude");
    s->air_density = wf_args_number(g, "--air-density");
    s->speed_max = wf_args_number(g, "--search-to");
    complete_canopy(g, s);
    s->shelter = strcmp(wf_args_text(g, "--shelter"), "none") == 0 ? NULL : wf_args_text(g, "--shelter");
    wf_solve_options_default(&out->solve);
    out->solve.mesh_tolerance = wf_args_number(g, "--mesh-tolerance");
    if (wf_args_given(g, "--root-stiffness"))
        out->solve.root_stiffness[0] = out->solve.root_stiffness[1] = wf_args_number(g, "--root-stiffness");
    out->solver = wf_solver_named(wf_args_text(g, "--solver"));
    out->preset = wf_preset_named(wf_args_text(g, "--preset"));
    return wf_directions_asked(g, a, d, &out->directions, e);
}
