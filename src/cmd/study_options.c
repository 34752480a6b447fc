#include "cmd/profile_options.h"
#include "cmd/study_directions.h"
#include "cmd/wind_speed.h"
#include "solve/solvers.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <string.h>

static const char *solver_word(size_t i) { return wf_solvers[i] ? wf_solvers[i]->name : NULL; }
static const char *preset_word(size_t i) { return wf_presets[i].name; }
static const char *shelter_word(size_t i) { return i ? wf_shelter_laws[i - 1].name : "none"; }

const struct wf_option wf_study_options[] = {
    WF_STUDY_FILE_OPTION,
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
    WF_AZIMUTH_OPTION,
    WF_DIRECTION_OPTIONS,
    { .name = "--shelter",
      .kind = WF_OPTION_CHOICE,
      .value = "LAW",
      .initial = "none",
      .word = shelter_word,
      .help = "the wind inside the crown: none: as outside; wake: what drag of the windward parts leaves; "
              "feng1999: "
              "potential flows as printed" },
    WF_EXPOSURE_OPTIONS,
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

enum wf_status wf_study_from_args(const struct wf_args *g, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_study *out, struct wf_err *e)
{
    struct wf_scenario *s = &out->scenario;
    wf_scenario_default(s);
    const struct wf_profile_words profile = wf_profile_asked(g);
    enum wf_status status = wf_scenario_profile(s, &profile, a, d, e);
    if (status) return status;
    s->winds_said = g->winds_said;
    s->azimuth = wf_args_number(g, "--azimuth");
    s->temperature = wf_args_number(g, "--temperature");
    s->altitude = wf_args_number(g, "--altitude");
    s->air_density = wf_args_number(g, "--air-density");
    s->speed_max = wf_args_number(g, "--search-to");
    s->shelter = strcmp(wf_args_text(g, "--shelter"), "none") == 0 ? NULL : wf_args_text(g, "--shelter");
    wf_solve_options_default(&out->solve);
    out->solve.threads = (size_t)llround(wf_args_number(g, "--threads"));
    out->solve.mesh_tolerance = wf_args_number(g, "--mesh-tolerance");
    if (wf_args_given(g, "--root-stiffness"))
        out->solve.root_stiffness[0] = out->solve.root_stiffness[1] = wf_args_number(g, "--root-stiffness");
    out->solver = wf_solver_named(wf_args_text(g, "--solver"));
    out->preset = wf_preset_named(wf_args_text(g, "--preset"));
    status = wf_directions_asked(g, a, d, &out->directions, e);
    return status ? status : wf_exposure_asked(g, a, s, &out->directions, e);
}
