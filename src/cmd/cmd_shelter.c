/* windfirm shelter: what a tree leaves of the wind inside and behind itself. */
#include "cmd/import_options.h"
#include "cmd/pages.h"
#include "cmd/profile_options.h"
#include "cmd/shelter_print.h"
#include "cmd/wind_speed.h"
#include "grow/clothe.h"
#include "grow/grow.h"
#include "grow/qsm_model.h"
#include "study/limits.h"
#include "study/scenario.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *law_word(size_t i) { return wf_shelter_laws[i].name; }

#define WHOLE(option, start, least, most, text)                                                              \
    {                                                                                                        \
        .name = option, .kind = WF_OPTION_WHOLE, .value = "NUMBER", .initial = start,                        \
        .dimension = WF_DIM_NONE, .low = least, .high = most, .help = text                                   \
    }
#define NUMBER(option, word, start, dim, base, least, most, text)                                            \
    {                                                                                                        \
        .name = option, .kind = WF_OPTION_NUMBER, .value = word, .initial = start, .dimension = dim,         \
        .unit = base, .low = least, .high = most, .help = text                                               \
    }

const struct wf_option wf_shelter_options[] = {
    WF_STUDY_FILE_OPTION,
    { .name = "--model",
      .letter = "-m",
      .kind = WF_OPTION_TEXT,
      .value = "MODEL",
      .help = "tree model: a file, or the name of a shipped one" },
    { .name = "--tree",
      .kind = WF_OPTION_TEXT,
      .value = "FILE",
      .help = "or a measured tree, as for import" },
    { .name = "--species",
      .letter = "-s",
      .kind = WF_OPTION_TEXT,
      .value = "SPECIES",
      .help = "wood and leaves: a species table, a file or the name of a shipped one" },
    NUMBER("--leaf-area", "AREA", "0", WF_DIM_AREA, "m2", 0, 1e5, "one-sided leaf area of a measured tree"),
    WF_WIND_OPTIONS(0, 200, "mean wind at the reference height"),
    WF_PROFILE_OPTIONS,
    WF_AZIMUTH_OPTION,
    { .name = "--law",
      .kind = WF_OPTION_CHOICE,
      .value = "NAME",
      .initial = "wake",
      .word = law_word,
      .help = "wake: drag and recovering wakes; feng1999: potential flows as printed" },
    WHOLE("--slabs", "32", 1, 512, "along the wind"),
    WHOLE("--cells", "128", 8, 1024, "across and up"),
    NUMBER("--transmission", "SHARE", "0.2", WF_DIM_NONE, NULL, 0, 1, "of a fully covered cell"),
    { .name = "--as",
      .kind = WF_OPTION_CHOICE,
      .value = "WHAT",
      .initial = "energy",
      .choices = "energy|speed",
      .help = "what the transmission is a share of" },
    WHOLE("--gap", "1", 1, 64, "widest hole or slit, in cells"),
    NUMBER("--leaf-reach", "LENGTH", "0.25", WF_DIM_LENGTH, "m", 1e-3, 100,
           "how far leaves stand from their segment"),
    NUMBER("--wake-growth", "NUMBER", "0.08", WF_DIM_NONE, NULL, 0, 1,
           "standard deviation of a wake per distance (law wake)"),
    WF_IMPORT_OPTIONS,
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .initial = "out/shelter",
      .help = "where tables and plots go" },
    { .name = "--no-motion", .kind = WF_OPTION_FLAG, .help = "only the wind; the tree is not bent" },
    { .name = "--no-plots", .kind = WF_OPTION_FLAG, .help = "write the tables only" },
    WF_LANG_OPTION,
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

static const char about[] =
    "  Cut a tree across the wind into slabs, project each on a grid, and tell what its branches and leaves\n"
    "  leave of the wind inside and behind it; bend the tree in that wind and in the open, side by side.\n"
    "\n"
    "  windfirm shelter --model scots_pine --species scots_pine --wind 15\n"
    "  windfirm shelter --tree tree.csv --species oak --leaf-area 120 --azimuth 45 --law feng1999";

/* Everything of one run. */
struct work {
    struct wf_args args;
    struct wf_doc_head head;
    struct wf_species species;
    struct wf_model model;
    struct wf_tree tree;
    struct wf_scenario scenario;
    struct wf_wind wind;
    struct wf_loads loads;
    struct wf_shelter_request request;
    struct wf_shelter_run run;
    struct wf_sheltered sheltered;
};

static enum wf_status measured(struct work *w, const char *file, struct wf_arena *a, struct wf_diag *d,
                               struct wf_err *e)
{
    struct wf_import_options o = wf_import_typed(&w->args);
    struct wf_qsm q;
    struct wf_qsm_model m;
    enum wf_status s = wf_import_read(file, &o, a, &q, d, e);
    if (s || (s = wf_qsm_to_tree(&q, WF_JOINT_AXIS, a, &m, e))) return s;
    const struct wf_clothing wears = { .leaf_area = wf_args_number(&w->args, "--leaf-area"), .kind = m.kind };
    w->tree = m.tree;
    return wf_clothe(&w->tree, &w->species, &wears, a, e);
}

static enum wf_status read_tree(struct work *w, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const char *model = wf_args_text(&w->args, "--model"), *file = wf_args_text(&w->args, "--tree");
    const char *species = wf_args_text(&w->args, "--species");
    if (!model == !file) return wf_fail(e, WF_EUSAGE, "give a tree by --model or --tree, one of them");
    if (!species) return wf_fail(e, WF_EUSAGE, "--species is needed, for example --species oak");
    struct wf_err other = { 0 };
    enum wf_status s = wf_species_read(wf_shipped("species", species, a), a, &w->species, d, e), t = WF_OK;
    if (model) t = wf_model_read(wf_shipped("models", model, a), a, &w->model, d, &other);
    if (s || t) return s ? s : wf_fail(e, t, "%s", other.text);
    s = model ? wf_grow(&w->model, &w->species, a, &w->tree, d, e) : measured(w, file, a, d, e);
    return s ? s : wf_tree_check(&w->tree, d, e);
}

static enum wf_status specify(struct work *w, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const struct wf_args *g = &w->args;
    struct wf_shelter_request *q = &w->request;
    const struct wf_profile_words profile = wf_profile_asked(g);
    wf_scenario_default(&w->scenario);
    w->run.speed = wf_args_number(g, "--wind");
    w->scenario.azimuth = wf_args_number(g, "--azimuth");
    wf_shelter_request_default(q);
    q->law = wf_shelter_law_named(wf_args_text(g, "--law"));
    q->slabs = (size_t)llround(wf_args_number(g, "--slabs"));
    q->cells = (size_t)llround(wf_args_number(g, "--cells"));
    q->transmission = wf_args_number(g, "--transmission");
    q->energy = strcmp(wf_args_text(g, "--as"), "energy") == 0;
    q->gap = (size_t)llround(wf_args_number(g, "--gap"));
    q->leaf_reach = wf_args_number(g, "--leaf-reach");
    q->wake_growth = wf_args_number(g, "--wake-growth");
    enum wf_status s = wf_shelter_request_check(q, e);
    if (s) return s;
    s = wf_scenario_profile(&w->scenario, &profile, a, d, e);
    return s ? s : wf_scenario_check(&w->scenario, e);
}

/* The tree in the open and in its own shelter. */
static enum wf_status move(struct work *w, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_solve_options o;
    const struct wf_solver *solver = wf_solvers[0];
    wf_solve_options_default(&o);
    o.mesh_tolerance = 1e-4; /* drawn lines and means of many tips */
    enum wf_status s = solver->solve(&w->tree, &w->loads, &o, a, &w->run.open, d, e);
    if (!s)
        s = wf_sheltered_solve(&w->tree, &w->loads, &w->request, solver, &o, a, &w->sheltered, &w->run.own, d,
                               e);
    w->run.sheltered = &w->sheltered;
    w->run.moved = !s;
    return s ? s : wf_shelter_tips(&w->run, &w->loads, a, e);
}

static enum wf_status run(struct work *w, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const struct wf_args *g = &w->args;
    bool motion = !wf_args_given(g, "--no-motion"), quiet = wf_args_given(g, "--quiet"),
         plots = !wf_args_given(g, "--no-plots");
    enum wf_status s = specify(w, a, d, e);
    if (s || (s = read_tree(w, a, d, e))) return s;
    if (w->species.crown_drag.given) w->request.crown_drag = w->species.crown_drag.value;
    if ((s = wf_scenario_loads(&w->scenario, &w->species, &w->wind, &w->loads, e))) return s;
    w->wind.speed = w->run.speed;
    wf_limits_profile(&w->scenario, wf_tree_height(&w->tree),
                      wf_args_text(g, w->model.key ? "--model" : "--tree"), d);
    w->run.folder = wf_args_text(g, "--output");
    w->run.tree = &w->tree;
    w->run.species = w->species.name;
    w->run.tree_name = w->model.key ? w->model.name : wf_args_text(g, "--tree");
    wf_progress("%zu segments: coverage, wind%s ...", w->tree.n, motion ? ", bending" : "");
    s = wf_shelter_make(&w->tree, &w->wind, &w->request, a, &w->run.still, e);
    if (!s && motion && w->run.speed > 0.0) s = move(w, a, d, e);
    wf_progress(NULL);
    if (s) return s;
    if (!quiet) wf_shelter_print(stdout, &w->run);
    s = wf_shelter_results_write(&w->run, &w->head, d, e);
    if (!s && plots) s = wf_pages_make(w->run.folder, wf_args_text(g, "--lang"), a, e);
    if (!s && !quiet) printf("\nTables%s: %s\n", plots ? ", plots and page" : "", w->run.folder);
    return s;
}

int wf_cmd_shelter(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct work w = { 0 };
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, wf_shelter_options, about, 0, 0, &arena, &w.args);
    if (code < 0) {
        struct wf_diag d = { .arena = &arena };
        enum wf_status s = wf_pages_head(argc, argv, &arena, &w.head, &e);
        if (!s) s = run(&w, &arena, &d, &e);
        fflush(stdout);
        wf_print_findings(&d, wf_args_given(&w.args, "--quiet"));
        code = s ? wf_complain(&e) : 0;
    }
    wf_sheltered_end(&w.sheltered);
    wf_arena_free(&arena);
    return code;
}
