/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm modes: natural frequencies of a tree, how it moves in each, how it is damped. */
#include "cmd/analyze_print.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "data/species.h"
#include "load/drag.h"
#include "load/scene.h"
#include "out/modes.h"
#include "out/results.h"
#include "solve/solve.h"
#include "study/limits.h"
#include <math.h>

struct modes_options {
    struct wf_args args;
    struct wf_tree_asked tree;
    struct wf_speeds wind;
    struct wf_averaging averaging;
    struct wf_profile_words profile;
    struct wf_water_asked water;
    size_t count;
    const char *output;
    double azimuth;                 /* [rad] */
    double damping, root_stiffness; /* of critical, [N m rad-1]; NAN: not given */
    struct wf_pages pages;
};

#define OPTIONS struct modes_options
const struct wf_option wf_modes_options[] = {
    STUDY,
    WF_TREE_ROWS(tree),
    SPEEDS("--wind", wind, averaging, 0, 100,
           "mean winds at the reference height, in whose states the tree is; 0 is still air [0,10,20]",
           .letter = "-w"),
    WF_AVERAGING_ROWS(averaging),
    WHOLE("--count", count, 1, 60, "6", "modes, from the lowest", .letter = "-n"),
    NUMBER("--damping", damping, "NUMBER", NONE, NULL, 0.001, 0.5, NULL,
           "structural damping of every mode, of critical [the species' by mass; else 0.05, assumed]"),
    NUMBER("--root-stiffness", root_stiffness, "STIFFNESS", ROTATIONAL_STIFFNESS, "N m/rad", 1, 1e15, NULL,
           "rotational stiffness of the root plate [clamped]"),
    WF_WATER_ROWS(water),
    WF_PROFILE_ROWS(profile),
    WF_AZIMUTH_ROW(azimuth),
    TEXT("--output", output, "FOLDER", "out/modes", "where tables, figures and page go", .letter = "-o"),
    WF_PAGE_ROWS("--no-report", pages, "write the tables only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "SPECIES is a species table. The lowest natural frequencies of small motions about the tree's state in "
    "each "
    "mean wind, with leaves and without; how much of the tree's mass and of its overturning each one moves, "
    "along "
    "the wind and across it; its damping by the wood and the air. Beside them the sway frequency measured on "
    "conifers of that size in forests.\n"
    "\n"
    "  windfirm modes oak --model culm --wind 0,10,20 -o out/modes";

static void print_number(double x, const char *format, int width)
{
    if (isfinite(x))
        wf_show(stdout, format, x);
    else
        wf_show(stdout, "%*s", width, "-");
}

static const char *leaves_said(const struct wf_mode_block *b)
{
    return b->water > 0 ? "with wet leaves" : b->season == WF_LEAF_ON ? "with leaves" : "without leaves";
}

static void print_block(const struct wf_mode_block *b)
{
    const char *leaves = leaves_said(b);
    char whose[32];
    (void)snprintf(whose, sizeof whose, "W%s", leaves + 1); /* at the beginning of a line */
    wf_show(stdout, "\n%s, ", whose);
    if (b->water > 0) wf_show(stdout, "%.3g mm of rain on them, ", b->water);
    if (b->speed > 0.0)
        wf_show(stdout, "mean wind %.4g m/s\n", b->speed);
    else
        wf_show(stdout, "still air\n");
    if (!b->modes.count) {
        wf_show(stdout, "  no modes (the warning says why)\n");
        return;
    }
    const struct wf_sway *sway = &b->modes.sway;
    wf_show(
        stdout,
        "Whole tree along the wind: %.4g Hz with %.0f %% of the overturning, modal mass %.4g kg, damping of "
        "the air %.3f, total %.3f\n",
        sway->frequency, 100 * sway->participation, sway->mass, sway->air, b->modes.damping);
    wf_show(stdout, "%4s %9s  %-9s %6s %6s %6s  %6s %6s  %9s  %6s %6s %6s\n", "mode", "Hz", "moves", "along",
            "across", "up", "along", "across", "kg", "wood", "air", "total");
    for (size_t k = 0; k < b->modes.count; k++) {
        const struct wf_sway_mode *m = &b->modes.mode[k];
        wf_show(stdout, "%4zu %9.4g  %-9s %5.1f%% %5.1f%% %5.1f%%  %5.1f%% %5.1f%%  ", k + 1, m->frequency,
                wf_mode_direction(m), 100 * m->share[0], 100 * m->share[1], 100 * m->share[2],
                100 * m->turn[0], 100 * m->turn[1]);
        print_number(m->mass, "%9.4g", 9);
        wf_show(stdout, "  %6.3f ", m->structural);
        print_number(m->air, "%6.3f ", 6);
        print_number(m->damping, "%6.3f", 6);
        wf_show(stdout, "\n");
    }
}

static void print_measured(const struct wf_mode_list *l)
{
    if (isnan(l->measured)) {
        wf_show(stdout, "\nMeasured frequencies: the tree is lower than 1.3 m, there is no line for it\n");
        return;
    }
    wf_show(stdout,
            "\nMeasured in forests, %s of %.1f m and %.0f mm at 1.3 m: %.3g Hz (f = %.4g + %.4g D/H2)\n",
            l->line->name, l->height, 1000 * l->diameter, l->measured, l->line->first, l->line->slope);
    if (!l->conifer)
        wf_show(stdout, "  no line of this species or of broadleaves is at hand: for orientation only\n");
    for (size_t i = 0; i < l->blocks; i++) {
        const struct wf_mode_block *b = &l->block[i];
        if (b->speed > 0.0 || !b->modes.count) continue;
        double f = b->modes.sway.frequency;
        wf_show(stdout, "  %s, whole tree: %.3g Hz, %.2f times that\n", leaves_said(b), f, f / l->measured);
    }
    wf_show(stdout, "  source: %s\n", wf_sway_lines_source);
}

static void print_list(const struct wf_mode_list *l)
{
    wf_show(stdout,
            "Modes about the state in the mean wind. Shares of the tree's mass (along, across, up), of its "
            "overturning by inertia (along, across); mass where the stem's tip moves by 1; damping of "
            "critical, the total limited\n");
    wf_print_site(stdout, l->scenario);
    for (size_t i = 0; i < l->blocks; i++) print_block(&l->block[i]);
    print_measured(l);
}

static enum wf_status read_inputs(const struct modes_options *o, struct wf_species *sp, struct wf_model *m,
                                  struct wf_scenario *scenario, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e)
{
    const char *path;
    wf_scenario_default(scenario);
    scenario->azimuth = o->azimuth;
    scenario->winds_said = o->args.winds_said;
    scenario->wind_notes = o->args.wind_notes;
    scenario->water = wf_water_asked_film(&o->water);
    scenario->peak.damping = o->damping;
    enum wf_status s = wf_species_named(o->args.operand[0], a, sp, d, e);
    enum wf_status t = wf_tree_asked_read(&o->tree, NULL, a, m, &path, d, e);
    if (!s) s = t;
    if (!s) s = wf_scenario_profile(scenario, &o->profile, a, d, e);
    return s ? s : wf_scenario_check(scenario, e);
}

static enum wf_status modes(void *work, struct wf_doc_head *head, struct wf_run_folder *f, struct wf_arena *a,
                            struct wf_diag *d, struct wf_err *e)
{
    static const double usual[] = { 0.0, 10.0, 20.0 };
    const struct modes_options *o = work;
    struct wf_species sp;
    struct wf_model m;
    struct wf_mode_list list;
    struct wf_solve_options solve;
    struct wf_analysis an = { .species = &sp, .model = &m, .solver = wf_solvers[0] };
    const struct wf_mode_request request = { .count = o->count,
                                             .seasons = !o->tree.season,
                                             .winds = o->wind.n ? o->wind.n : WF_COUNT(usual),
                                             .wind = o->wind.n ? o->wind.speed : usual };
    wf_solve_options_default(&solve);
    if (!isnan(o->root_stiffness)) solve.root_stiffness[0] = solve.root_stiffness[1] = o->root_stiffness;
    enum wf_status s = read_inputs(o, &sp, &m, &an.scenario, a, d, e);
    if (!s) s = wf_results_begin(f, o->output, o->pages.none ? NULL : "modes", e);
    if (!s) s = wf_mode_list_run(&an, &m, &solve, &request, a, d, &list, e);
    wf_progress_clear();
    if (s) return s;
    wf_water_asked_warn(&o->water, d);
    wf_limits_profile(&an.scenario, list.height, m.name, d);
    if (!o->args.quiet) print_list(&list);
    const char *name = wf_arena_print(a, "%s, %s", sp.name, m.name);
    list.name_zh = sp.name_zh;
    wf_doc_head_file(head, o->tree.file ? "tree" : "model", m.file);
    wf_doc_head_file(head, "species", sp.file);
    s = name ? wf_modes_write(&list, name, d, head, f->stage, e) : wf_fail(e, WF_ENOMEM, "no memory");
    if (!s) s = wf_results_end(f, &o->pages, a, NULL, e);
    if (!s && !o->args.quiet)
        wf_show(stdout, "\nTables%s: %s\n", o->pages.none ? "" : ", figures, page", o->output);
    return s;
}

int wf_cmd_modes(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct modes_options o = { 0 };
    int code = wf_args_read(argc, argv, wf_modes_options, about, 1, 1, &arena, &o.args);
    if (code < 0) code = wf_tree_asked_check(&o.tree, "modes", NULL);
    if (code < 0) code = wf_command_perform(argc, argv, modes, &o, o.args.quiet, &arena);
    wf_arena_free(&arena);
    return code;
}
