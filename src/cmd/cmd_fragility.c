/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm fragility: how likely a tree is lost in which wind, by samples of what is not known exactly. */
#include "cmd/analyze_print.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "data/species.h"
#include "load/drag.h"
#include "load/scene.h"
#include "out/fragility.h"
#include "out/results.h"
#include "solve/solve.h"
#include "study/interval.h"
#include <math.h>

struct fragility_options {
    struct wf_args args;
    struct wf_tree_asked tree;
    struct wf_speeds wind;
    struct wf_averaging averaging;
    struct wf_profile_words profile;
    struct wf_peak_asked peak;
    struct wf_anchorage_asked anchorage;
    const char *output;
    size_t samples, seed, threads;
    double azimuth;                   /* [rad] */
    double node_spacing;              /* [m]; NAN: not given */
    double search_to, root_stiffness; /* [m/s], [N m rad-1]; NAN: not given */
    struct wf_pages pages;
};

#define OPTIONS struct fragility_options
static const struct wf_option options[] = {
    WF_TREE_ROWS(tree),
    SPEEDS("--wind", wind, averaging, 0, 200,
           "mean winds at the reference height, at which the interval of the safety is computed [10,20,30]",
           .letter = "-w"),
    WF_AVERAGING_ROWS(averaging),
    WF_SAMPLE_ROWS(NULL),
    WF_PROFILE_ROWS(profile),
    WF_PEAK_ROWS(peak),
    WF_ANCHORAGE_ROWS(anchorage),
    WF_NODE_SPACING_ROW(node_spacing),
    WF_AZIMUTH_ROW(azimuth),
    NUMBER("--search-to", search_to, "SPEED", SPEED, "m/s", 1, 200, NULL,
           "highest wind that is searched; the law takes samples that are not lost up to it into account [60 "
           "m/s, or 1.2 times the highest wind specified where that is more]"),
    NUMBER("--root-stiffness", root_stiffness, "STIFFNESS", ROTATIONAL_STIFFNESS, "N m/rad", 1, 1e15, NULL,
           "rotational stiffness of the root plate [clamped]"),
    WHOLE("--threads", threads, 0, 64, "0", "processors to use, 0: all; the results are the same"),
    TEXT("--output", output, "FOLDER", "out/fragility", "where tables, figure and page go", .letter = "-o"),
    WF_PAGE_ROWS("--no-report", pages, "write the tables only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "SPECIES is a species table. Everything that is not known exactly is sampled: the wood by the ranges of "
    "the "
    "table, the drag and streamlining of the crown, the peak of gusts, damping, measured sizes, the root. "
    "Each sample is solved; the share of them that is lost by a wind is drawn with its band, and a lognormal "
    "law beside it. 'docs/failure.md' lists what varies.\n"
    "\n"
    "  windfirm fragility moso_bamboo --model moso_culm --wind 10,20,30 -o out/fragility";

/* The given options for the library. */
static enum wf_status read_inputs(const struct fragility_options *o, struct wf_species *sp,
                                  struct wf_model *m, struct wf_scenario *scenario, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_err *e)
{
    const char *path;
    wf_scenario_default(scenario);
    scenario->azimuth = o->azimuth;
    if (o->node_spacing > 0) scenario->node_spacing = o->node_spacing;
    scenario->winds_said = o->args.winds_said;
    scenario->wind_notes = o->args.wind_notes;
    enum wf_status s = wf_species_named(o->args.operand[0], a, sp, d, e);
    enum wf_status t = wf_tree_asked_read(&o->tree, NULL, a, m, &path, d, e);
    if (!s) s = t;
    if (!s) s = wf_scenario_profile(scenario, &o->profile, a, d, e);
    if (!s) s = wf_peak_asked_read(&o->peak, false, a, d, scenario, e);
    if (!s) s = wf_anchorage_asked_read(&o->anchorage, o->root_stiffness, a, d, scenario, e);
    if (!(scenario->gust_factor > 0.0)) scenario->gust_factor = o->averaging.gust;
    return s ? s : wf_scenario_check(scenario, e);
}

static enum wf_status compute(const struct fragility_options *o, const struct wf_species *sp,
                              const struct wf_model *m, const struct wf_scenario *scenario,
                              struct wf_arena *a, struct wf_diag *d, struct wf_analysis *an,
                              struct wf_interval *out, struct wf_err *e)
{
    static const double usual[] = { 10.0, 20.0, 30.0 };
    const struct wf_interval_request request = { o->samples, o->seed, o->threads };
    struct wf_solve_options solve;
    struct wf_search search;
    wf_solve_options_default(&solve);
    wf_search_default(&search);
    solve.threads = o->threads;
    if (!isnan(o->root_stiffness)) solve.root_stiffness[0] = solve.root_stiffness[1] = o->root_stiffness;
    if (!isnan(o->search_to)) search.speed_max = o->search_to, search.beyond = 0.0;
    enum wf_status s =
        wf_analyze(sp, m, scenario, &search, wf_solvers[0], &solve, o->wind.n ? o->wind.speed : usual,
                   o->wind.n ? o->wind.n : WF_COUNT(usual), a, d, an, e);
    if (!s) s = wf_interval_run(an, &solve, &request, a, out, e);
    if (s) return s;
    an->interval = out;
    wf_interval_warn(an, out, d);
    return WF_OK;
}

static void print_curve(const struct wf_analysis *an)
{
    const struct wf_interval *i = an->interval;
    const size_t steps = 10, every = (WF_INTERVAL_POINTS - 1) / steps;
    wf_show(stdout, "\n%10s%10s%12s%18s%12s\n%10s%10s%12s%18s%12s\n", "mean wind", "gust", "lost",
            "90 % band", "lognormal", "m/s", "m/s", "%", "%", "%");
    for (size_t k = every; k < WF_INTERVAL_POINTS; k += every) {
        const struct wf_interval_point *p = &i->point[k];
        wf_show(stdout, "%10.1f%10.1f%12.0f%10.0f to %4.0f", p->speed,
                wf_scenario_gust(&an->scenario, p->speed), 100.0 * p->share, 100.0 * p->below,
                100.0 * p->above);
        if (isfinite(p->fit))
            wf_show(stdout, "%12.0f\n", 100.0 * p->fit);
        else
            wf_show(stdout, "%12s\n", "-");
    }
    if (isfinite(i->fit.median))
        wf_show(stdout,
                "Lognormal law: median %.3g m/s, beta %.2f; %zu of %zu samples are lost above %.4g m/s\n",
                i->fit.median, i->fit.beta, i->fit.above, i->n, i->searched_to);
    if (i->still) wf_show(stdout, "%zu samples are lost in still air\n", i->still);
}

static enum wf_status fragility(void *work, struct wf_doc_head *head, struct wf_run_folder *f,
                                struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const struct fragility_options *o = work;
    const struct wf_interval_request request = { o->samples, o->seed, o->threads };
    struct wf_species sp;
    struct wf_model m;
    struct wf_scenario scenario;
    struct wf_analysis an;
    struct wf_interval interval;
    enum wf_status s = wf_interval_check(&request, e);
    if (!s && !o->samples) s = wf_fail(e, WF_EUSAGE, "--samples 0: without samples there is no curve");
    if (!s) s = read_inputs(o, &sp, &m, &scenario, a, d, e);
    if (!s) s = wf_results_begin(f, o->output, o->pages.none ? NULL : "fragility", e);
    if (!s) s = compute(o, &sp, &m, &scenario, a, d, &an, &interval, e);
    wf_progress_clear();
    if (s) return s;
    if (!o->args.quiet) wf_print_head(stdout, &an), wf_print_interval(stdout, &an), print_curve(&an);
    const char *name = wf_arena_print(a, "%s, %s", sp.name, m.name);
    wf_doc_head_file(head, o->tree.file ? "tree" : "model", m.file);
    wf_doc_head_file(head, "species", sp.file);
    s = name ? wf_fragility_write(&an, name, sp.name_zh, d, head, f->stage, e)
             : wf_fail(e, WF_ENOMEM, "no memory");
    if (!s) s = wf_results_end(f, &o->pages, a, NULL, e);
    if (!s && !o->args.quiet)
        wf_show(stdout, "\nTables%s: %s\n", o->pages.none ? "" : ", figure, page", o->output);
    return s;
}

int wf_cmd_fragility(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct fragility_options o = { 0 };
    int code = wf_args_read(argc, argv, options, about, 1, 1, &arena, &o.args);
    if (code < 0) code = wf_tree_asked_check(&o.tree, "fragility", NULL);
    if (code < 0) code = wf_command_perform(argc, argv, fragility, &o, o.args.quiet, &arena);
    wf_arena_free(&arena);
    return code;
}
