#include "cmd/gust_options.h"
#include "cmd/pages.h"
#include "cmd/profile_options.h"
#include "cmd/series_perform.h"
#include "cmd/wind_speed.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char *solver_word(size_t i) { return wf_solvers[i] ? wf_solvers[i]->name : NULL; }
static const char *preset_word(size_t i) { return wf_presets[i].name; }
static const char *gust_word(size_t i) { return i ? wf_gust_models[i - 1].name : "steady"; }
static const char *leaf_word(size_t i) { return wf_leaf_motions[i].name; }
static const char *shelter_word(size_t i) { return i ? wf_shelter_laws[i - 1].name : "none"; }

#define CHOICE(n, start, list, text)                                                                         \
    {                                                                                                        \
        .name = n, .kind = WF_OPTION_CHOICE, .value = "NAME", .initial = start, .word = list, .help = text   \
    }
#define NUMBER(n, v, start, dim, u, l, h, text)                                                              \
    {                                                                                                        \
        .name = n, .kind = WF_OPTION_NUMBER, .value = v, .initial = start, .dimension = dim, .unit = u,      \
        .low = l, .high = h, .help = text                                                                    \
    }

#define WHOLE(n, start, l, h, text)                                                                          \
    {                                                                                                        \
        .name = n, .kind = WF_OPTION_WHOLE, .value = "NUMBER", .initial = start, .dimension = WF_DIM_NONE,   \
        .low = l, .high = h, .help = text                                                                    \
    }

const struct wf_option wf_series_options[] = {
    WF_STUDY_FILE_OPTION,
    { .name = "--model",
      .letter = "-m",
      .kind = WF_OPTION_TEXT,
      .value = "MODEL",
      .help = "tree model: a file, or the name of a shipped one" },
    WF_WIND_OPTIONS(0, 100, "mean wind at the reference height"),
    CHOICE("--gust", "steady", gust_word, "how the wind changes"),
    CHOICE("--preset", "corrected", preset_word, "a published method, as printed"),
    CHOICE("--solver", NULL, solver_word, "how the bent shape is computed [the preset's, else beam]"),
    WF_PROFILE_OPTIONS,
    CHOICE("--shelter", "none", shelter_word, "wind inside the crown"),
    NUMBER("--intensity", "NUMBER", NULL, WF_DIM_NONE, NULL, 0, 1, "turbulence intensity of the gust model"),
    NUMBER("--period", "TIME", NULL, WF_DIM_TIME, "s", 0.1, 3600, "of the gust model"),
    WF_GUST_OPTIONS,
    { .name = "--components",
      .kind = WF_OPTION_CHOICE,
      .value = "1|3",
      .choices = "1|3",
      .help = "of the gust: along the wind only, or along, across and up [3 where the model has them]" },
    NUMBER("--duration", "TIME", "60", WF_DIM_TIME, "s", 1e-3, 86400, "time that is run"),
    NUMBER("--step", "TIME", "0.1", WF_DIM_TIME, "s", 1e-4, 3600, "between frames"),
    WHOLE("--keys", "8", 1, 64, "key frames drawn as panels"),
    WHOLE("--seed", "1", 0, 1e9, "of the random numbers"),
    NUMBER("--restoring", "NUMBER", "0", WF_DIM_NONE, NULL, 0, 100, "k of the deflect scheme, below 1"),
    NUMBER("--damping", "NUMBER", "0", WF_DIM_NONE, NULL, 0, 1e9, "c of the deflect scheme, N s2"),
    CHOICE("--leaf-motion", NULL, leaf_word,
           "how leaves turn, a look that enters no load [the preset's, else eq13]"),
    NUMBER("--leaf-amplitude", "ANGLE", "30", WF_DIM_ANGLE, "deg", 0, 180,
           "largest turn by one of the three noises"),
    NUMBER("--leaf-follow", "NUMBER", "0.5", WF_DIM_NONE, NULL, -10, 10,
           "lambda: share of theta_x added to theta_z"),
    NUMBER("--leaf-period", "TIME", "1", WF_DIM_TIME, "s", 1e-3, 3600, "of the noise's first octave"),
    NUMBER("--youngs-modulus", "MODULUS", NULL, WF_DIM_PRESSURE, "Pa", 1e5, 1e12, "in place of the species'"),
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .initial = "out/series",
      .help = "where tables, frames and the page go" },
    { .name = "--explain",
      .kind = WF_OPTION_FLAG,
      .help = "every method against beam theory, branch by branch, too" },
    { .name = "--no-report", .kind = WF_OPTION_FLAG, .help = "write tables only" },
    WF_LANG_OPTION,
    { .name = "--no-vtk", .kind = WF_OPTION_FLAG, .help = "leave out the frames for ParaView" },
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

static const char about[] =
    "SPECIES is a species table, a file or the name of a shipped one. Every frame is a balance of its own: "
    "wind, "
    "loads and shape without inertia, so it holds for winds that change slowly against the tree's own sway. "
    "The "
    "deflect solvers go from frame to frame with their restoring and damping terms.\n"
    "\n"
    "  windfirm series moso_bamboo --model moso_culm --wind 10 --gust cosine --period 20 --duration 60";

int wf_cmd_series(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct wf_args g;
    int code = wf_args_read(argc, argv, wf_series_options, about, 1, 1, &arena, &g);
    if (code < 0 && !wf_args_text(&g, "--model")) {
        fprintf(stderr, "windfirm series: --model is needed, for example --model models/culm.yaml\n");
        code = 2;
    }
    if (code < 0) {
        const char *components = wf_args_text(&g, "--components");
        struct wf_series_plan_run run = { .name = g.operand[0],
                                          .species = g.operand[0],
                                          .model = wf_args_text(&g, "--model"),
                                          .preset = wf_args_text(&g, "--preset"),
                                          .solver = wf_args_text(&g, "--solver"),
                                          .gust = wf_args_text(&g, "--gust"),
                                          .shelter = wf_args_text(&g, "--shelter"),
                                          .profile = wf_profile_asked(&g),
                                          .set = wf_args_text(&g, "--set"),
                                          .file = wf_args_text(&g, "--file"),
                                          .columns = wf_args_text(&g, "--columns"),
                                          .components = components ? (size_t)atoi(components) : 0,
                                          .wind = wf_args_number(&g, "--wind"),
                                          .intensity = wf_args_number(&g, "--intensity"),
                                          .period = wf_args_number(&g, "--period"),
                                          .duration = wf_args_number(&g, "--duration"),
                                          .step = wf_args_number(&g, "--step"),
                                          .youngs = wf_args_number(&g, "--youngs-modulus"),
                                          .restoring = wf_args_number(&g, "--restoring"),
                                          .damping = wf_args_number(&g, "--damping"),
                                          .transmission = NAN,
                                          .leaf_motion = wf_args_text(&g, "--leaf-motion"),
                                          .explain = wf_args_given(&g, "--explain") ? "yes" : "no",
                                          .leaf_amplitude = wf_args_number(&g, "--leaf-amplitude"),
                                          .leaf_follow = wf_args_number(&g, "--leaf-follow"),
                                          .leaf_period = wf_args_number(&g, "--leaf-period"),
                                          .keys = (size_t)wf_args_number(&g, "--keys"),
                                          .seed = (size_t)wf_args_number(&g, "--seed") };
        struct wf_series_plan plan = {
            .key = "series", .title = "A tree in changing wind", .note = g.winds_said, .runs = 1, .run = &run
        };
        struct wf_series_job job = { .plan = &plan,
                                     .folder = wf_args_text(&g, "--output"),
                                     .command = wf_series_typed(argc, argv, &arena),
                                     .language = wf_args_text(&g, "--lang"),
                                     .quiet = wf_args_given(&g, "--quiet"),
                                     .page = !wf_args_given(&g, "--no-report"),
                                     .vtk = !wf_args_given(&g, "--no-vtk") };
        code = wf_series_perform(&job, &arena);
    }
    wf_arena_free(&arena);
    return code;
}
