/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm shelter: the wind that remains inside and behind a tree. */
#include "base/progress.h"
#include "cmd/analyze_print.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "data/species.h"
#include "grow/clothe.h"
#include "grow/grow.h"
#include "grow/qsm_model.h"
#include "load/drag.h"
#include "load/scene.h"
#include "out/shelter_results.h"
#include "out/wind_results.h"
#include "solve/solve.h"
#include "study/limits.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *shelter_law_word(size_t i) { return wf_shelter_laws[i].name; }

struct shelter_options {
    struct wf_args args;
    const char *model, *tree, *species; /* NULL: not given */
    double leaf_area;                   /* [m2]            */
    double wind;                        /* [m/s]           */
    struct wf_averaging averaging;
    struct wf_profile_words profile;
    double azimuth; /* [rad] */
    const char *law, *as;
    size_t slabs, cells, gap;
    double transmission, leaf_reach, wake_growth; /* [-], [m], [-] */
    struct wf_import_asked import;
    const char *output;
    bool no_motion;
    struct wf_pages pages;
};

/* Options of a measured tree. */
static bool tree_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(!((const struct shelter_options *)options)->tree, why,
                            "without a measured tree, --tree");
}

static bool growth_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct shelter_options *o = options;
    const struct wf_shelter_law *law = wf_shelter_law_named(o->law);
    (void)row;
    return wf_option_unused(law && !law->wakes, why, "with the law '%s'", o->law);
}

#define OPTIONS struct shelter_options
const struct wf_option wf_shelter_options[] = {
    STUDY,
    PATH("--model", model, "MODEL", NULL, "tree model: a file, or the name of a shipped one", .letter = "-m"),
    PATH("--tree", tree, "FILE", NULL, "or a measured tree, as for import"),
    PATH("--species", species, "SPECIES", NULL,
         "wood and leaves: a species table, a file or the name of a shipped one", .letter = "-s"),
    NUMBER("--leaf-area", leaf_area, "AREA", AREA, "m2", 0, 1e5, "0",
           "one-sided leaf area of a measured tree", .unused = tree_unused),
    WF_WIND_ROWS(wind, averaging, 0, 200, "mean wind at the reference height"),
    WF_PROFILE_ROWS(profile),
    WF_AZIMUTH_ROW(azimuth),
    WORD("--law", law, "NAME", shelter_law_word, "wake",
         "wake: drag and recovering wakes; feng1999: potential flows as printed"),
    WHOLE("--slabs", slabs, 1, 512, "32", "along the wind"),
    WHOLE("--cells", cells, 8, 1024, "128", "across and up"),
    NUMBER("--transmission", transmission, "SHARE", NONE, NULL, 0, 1, "0.2", "of a fully covered cell"),
    CHOICE("--as", as, "WHAT", "energy|speed", "energy", "what the transmission is a share of"),
    WHOLE("--gap", gap, 1, 64, "1", "widest hole or slit, in cells"),
    NUMBER("--leaf-reach", leaf_reach, "LENGTH", LENGTH, "m", 1e-3, 100, "0.25",
           "greatest distance of leaves from their segment"),
    NUMBER("--wake-growth", wake_growth, "NUMBER", NONE, NULL, 0, 1, "0.08",
           "standard deviation of a wake per distance (law wake)", .unused = growth_unused),
    WF_IMPORT_ROWS(import, tree_unused),
    TEXT("--output", output, "FOLDER", "out/shelter", "where tables and plots go", .letter = "-o"),
    FLAG("--no-motion", no_motion, "only the wind; the tree is not bent"),
    WF_PAGE_ROWS("--no-plots", pages, "write the tables only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "Cut a tree across the wind into slabs, project each on a grid, and compute the wind that its "
    "branches and leaves leave inside and behind it; bend the tree in that wind and in the open, side by "
    "side.\n"
    "\n"
    "  windfirm shelter --model scots_pine --species scots_pine --wind 15\n"
    "  windfirm shelter --tree tree.csv --species oak --leaf-area 120 --azimuth 45 --law feng1999";

/* Everything of one run. */
struct work {
    struct shelter_options options;
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

static enum wf_status read_measured(struct work *w, const char *file, struct wf_arena *a, struct wf_diag *d,
                                    struct wf_err *e)
{
    struct wf_import_options o = wf_import_asked_options(&w->options.import);
    struct wf_qsm q;
    struct wf_qsm_model m;
    enum wf_status s = wf_import_read(file, &o, a, &q, d, e);
    if (s || (s = wf_qsm_to_tree(&q, WF_JOINT_AXIS, a, &m, e))) return s;
    const struct wf_clothing wears = { .leaf_area = w->options.leaf_area, .kind = m.kind };
    w->tree = m.tree;
    return wf_clothe(&w->tree, &w->species, &wears, a, e);
}

static enum wf_status read_tree(struct work *w, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const char *model = w->options.model, *file = w->options.tree, *species = w->options.species;
    if (!model == !file) return wf_fail(e, WF_EUSAGE, "give a tree by either --model or --tree");
    if (!species) return wf_fail(e, WF_EUSAGE, "--species is needed, for example --species oak");
    struct wf_err other = { 0 };
    enum wf_status s = wf_species_named(species, a, &w->species, d, e), t = WF_OK;
    if (model) t = wf_model_named(model, a, &w->model, d, &other);
    if (s || t) return s ? s : wf_fail(e, t, "%s", other.text);
    s = model ? wf_grow(&w->model, &w->species, a, &w->tree, d, e) : read_measured(w, file, a, d, e);
    return s ? s : wf_tree_check(&w->tree, d, e);
}

static enum wf_status make_request(struct work *w, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const struct shelter_options *o = &w->options;
    struct wf_shelter_request *q = &w->request;
    wf_scenario_default(&w->scenario);
    w->run.speed = o->wind;
    w->scenario.azimuth = o->azimuth;
    wf_shelter_request_default(q);
    q->law = wf_shelter_law_named(o->law);
    q->slabs = o->slabs;
    q->cells = o->cells;
    q->transmission = o->transmission;
    q->energy = strcmp(o->as, "energy") == 0;
    q->gap = o->gap;
    q->leaf_reach = o->leaf_reach;
    q->wake_growth = o->wake_growth;
    enum wf_status s = wf_shelter_request_check(q, e);
    if (s) return s;
    s = wf_scenario_profile(&w->scenario, &o->profile, a, d, e);
    return s ? s : wf_scenario_check(&w->scenario, e);
}

static void print_slabs(FILE *to, const struct wf_shelter *s)
{
    wf_show(to,
            "slab  from the front   wood     leaves   covered  cells: cylinder hole slit transmitting (full)"
            "   arriving wind  volume flux  passes beside\n");
    wf_show(to, "                 m      m2         m2        m2\n");
    for (size_t k = 0; k <= s->slabs; k++) {
        const struct wf_shelter_slab *b = &s->slab[k];
        if (k == s->slabs)
            wf_show(to, "behind      %6.2f  %72s", (double)k * s->step[0], "");
        else
            wf_show(to, "%4zu        %6.2f  %8.4f  %8.4f  %8.4f         %8zu %4zu %4zu %12zu %6zu", k + 1,
                    (double)k * s->step[0], b->wood, b->leaf, b->covered, b->cells[WF_CELL_CYLINDER],
                    b->cells[WF_CELL_HOLE], b->cells[WF_CELL_SLIT], b->cells[WF_CELL_TRANSMITTING], b->full);
        wf_show(to, "   %12.4f %12.4f %13.4f\n", b->speed, b->flux, 1.0 - b->flux);
    }
}

static void print_thirds(FILE *to, const struct wf_shelter_run *r)
{
    static const char *const name[] = { "windward", "middle", "leeward" };
    struct wf_shelter_third third[3];
    wf_shelter_thirds(r, third);
    wf_show(to, "\n%-10s %6s   %-22s %-24s %s\n", "branch", "", "wind at tips m/s", "tips move m",
            "relative to the branch's base m");
    wf_show(to, "%-10s %6s   %-10s %-11s %-11s %-12s %-10s %s\n", "ends", "number", "open", "sheltered",
            "open", "sheltered", "open", "sheltered");
    for (int k = 0; k < 3; k++)
        if (third[k].n > 0)
            wf_show(to, "%-10s %6zu   %-10.3f %-11.3f %-11.4f %-12.4f %-10.4f %.4f\n", name[k], third[k].n,
                    third[k].wind[0], third[k].wind[1], third[k].move[0], third[k].move[1], third[k].swing[0],
                    third[k].swing[1]);
    wf_show(
        to,
        "base moment %.6g N m in the open, %.6g N m sheltered; shape and shelter agree after %zu passes\n",
        hypot(r->open.base_moment[0], r->open.base_moment[1]),
        hypot(r->own.base_moment[0], r->own.base_moment[1]), r->sheltered->passes);
}

/* Slabs and the windward and leeward thirds. */
static void print_shelter(FILE *to, const struct wf_shelter_run *r)
{
    const struct wf_shelter *s = &r->still;
    const struct wf_shelter_request *q = &s->request;
    wf_show(to, "wind %.4g m/s, a 10-min mean at %.6g m\n", r->speed, s->base.reference_height);
    wf_show(to, "law %s: %s\n", q->law->name, q->law->title);
    wf_show(to, "a covered cell lets %.0f %% of the %s through: %.3f of the speed\n", 100.0 * q->transmission,
            q->energy ? "energy" : "speed", wf_shelter_speed_share(q));
    wf_show(to, "%zu slabs of %.3f m, %zu x %zu cells of %.3f x %.3f m\n\n", s->slabs, s->step[0], s->across,
            s->up, s->step[1], s->step[2]);
    print_slabs(to, s);
    wf_show(
        to,
        "The air that no longer passes the grid's cross-section (%.1f x %.1f m) must pass beside or above "
        "it.\n",
        (double)s->across * s->step[1], (double)s->up * s->step[2]);
    if (r->moved) print_thirds(to, r);
}

/* The tree in the open and in its own shelter. */
static enum wf_status bend_tree(struct work *w, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_solve_options o;
    const struct wf_solver *solver = wf_solvers[0];
    wf_solve_options_default(&o);
    o.mesh_tolerance = 1e-4; /* accurate enough for drawn lines and means over many tips */
    enum wf_status s = solver->solve(&w->tree, &w->loads, &o, a, &w->run.open, d, e);
    if (!s)
        s = wf_sheltered_solve(&w->tree, &w->loads, &w->request, solver, &o, a, &w->sheltered, &w->run.own, d,
                               e);
    w->run.sheltered = &w->sheltered;
    w->run.moved = !s;
    return s ? s : wf_shelter_tips(&w->run, &w->loads, a, e);
}

/* The wind inside the tree and, unless left out or interrupted, the bent tree in it. */
static enum wf_status compute(struct work *w, bool motion, struct wf_arena *a, struct wf_diag *d,
                              struct wf_err *e)
{
    struct wf_err why = { 0 };
    wf_stage_begin(0, false, "wind inside the tree");
    enum wf_status s = wf_shelter_make(&w->tree, &w->wind, &w->request, a, &w->run.still, e);
    if (!s && motion && w->run.speed > 0.0 && (s = bend_tree(w, a, d, &why)) && s != WF_EINTERRUPTED)
        wf_fail(e, s, "%s", why.text);
    wf_progress_clear();
    if (s == WF_EINTERRUPTED)
        wf_diag_warn(d, "interrupted", "interrupted before the tree was bent in this wind");
    return s == WF_EINTERRUPTED ? WF_OK : s;
}

static enum wf_status shelter(void *work, struct wf_doc_head *head, struct wf_run_folder *f,
                              struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct work *w = work;
    const struct shelter_options *o = &w->options;
    bool motion = !o->no_motion, quiet = o->args.quiet;
    enum wf_status s = make_request(w, a, d, e);
    if (s || (s = read_tree(w, a, d, e))) return s;
    if (w->species.crown.drag_coefficient.given)
        w->request.crown_drag = w->species.crown.drag_coefficient.value;
    if ((s = wf_scenario_loads(&w->scenario, &w->species, &w->wind, &w->loads, e))) return s;
    w->wind.speed = wf_scenario_speed(&w->scenario, w->run.speed);
    wf_limits_profile(&w->scenario, wf_tree_height(&w->tree), w->model.key ? o->model : o->tree, d);
    if ((s = wf_results_begin(f, o->output, o->pages.none ? NULL : "shelter", e))) return s;
    w->run.folder = f->stage;
    w->run.tree = &w->tree;
    w->run.species = w->species.name;
    w->run.scenario = &w->scenario;
    w->run.tree_name = w->model.key ? w->model.name : o->tree;
    if ((s = compute(w, motion, a, d, e))) return s;
    if (!quiet) {
        wf_show(stdout, "Wind %.4g m/s (3-s gust %.4g m/s), wind profile %s\n", w->run.speed,
                wf_scenario_gust(&w->scenario, w->run.speed), w->scenario.profile);
        wf_print_site(stdout, &w->scenario);
        print_shelter(stdout, &w->run);
    }
    wf_doc_head_file(head, w->model.key ? "model" : "tree", w->model.key ? w->model.file : o->tree);
    wf_doc_head_file(head, "species", w->species.file);
    s = wf_shelter_results_write(&w->run, head, d, e);
    if (!s) s = wf_results_end(f, &o->pages, a, NULL, e);
    if (!s && !quiet) wf_show(stdout, "\nTables%s: %s\n", o->pages.none ? "" : ", plots and page", o->output);
    return s;
}

int wf_cmd_shelter(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct work w = { 0 };
    int code = wf_args_read(argc, argv, wf_shelter_options, about, 0, 0, &arena, &w.options.args);
    if (code < 0) code = wf_command_perform(argc, argv, shelter, &w, w.options.args.quiet, &arena);
    wf_sheltered_end(&w.sheltered);
    wf_arena_free(&arena);
    return code;
}
