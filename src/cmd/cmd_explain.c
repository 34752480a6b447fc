/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/analyze_print.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "data/species.h"
#include "load/drag.h"
#include "load/scene.h"
#include "out/explain.h"
#include "out/results.h"
#include "solve/solve.h"
#include "study/limits.h"
#include "study/peak.h"
#include "study/preset.h"
#include "study/sway.h"
#include "study/verdict.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

struct explain_options {
    struct wf_args args;
    const char *model, *output;
    double wind; /* [m/s] */
    struct wf_averaging averaging;
    struct wf_profile_words profile;
    double azimuth; /* [rad] */
    bool peak;
    struct wf_pages pages;
};

#define OPTIONS struct explain_options
const struct wf_option wf_explain_options[] = {
    STUDY,
    PATH("--model", model, "MODEL", NULL, "tree model: a file, or the name of a shipped one", .letter = "-m"),
    WF_WIND_ROWS(wind, averaging, 0.01, 100, "mean wind at the reference height"),
    WF_PROFILE_ROWS(profile),
    WF_AZIMUTH_ROW(azimuth),
    FLAG("--peak", peak, "also compare the methods of the peak load (--peak of analyze) in this wind"),
    TEXT("--output", output, "FOLDER", "out/explain", "where table, plot and page go", .letter = "-o"),
    WF_PAGE_ROWS("--no-report", pages, "write the table only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "SPECIES is a species table. Every solver bends the same tree in the same wind; "
    "for each branch the table gives "
    "its own bending (less the movement of its foot) over that of the beam engine: where a "
    "published method, as printed "
    "or corrected, can be trusted, and where it cannot.\n"
    "\n"
    "  windfirm explain poplar --model zhao2013_ifs --wind 10";

/* Returned: whether there is none, and "-" was printed. */
static bool print_ratio(double ratio)
{
    if (isfinite(ratio))
        wf_show(stdout, "%10.4g", ratio);
    else
        wf_show(stdout, "%10s", "-");
    return !isfinite(ratio);
}

static void print_methods(const struct wf_explain *x, double speed, const struct wf_scenario *in)
{
    bool missing = false;
    wf_show(stdout, "Wind %.4g m/s (3-s gust %.4g m/s), wind profile %s\n", speed,
            wf_scenario_gust(in, speed), in->profile);
    wf_print_site(stdout, in);
    wf_show(stdout,
            "Own bending of the branches over that by beam theory, middle of each level\n\n%-18s%10s%10s",
            "method", "tip", "within 5%");
    for (int32_t l = 0; l <= wf_explain_top(x); l++) wf_show(stdout, "   level %d", (int)l);
    wf_show(stdout, "\n");
    for (size_t m = 0; m < x->methods; m++) {
        wf_show(stdout, "%-18s", x->method[m]->name);
        missing |= print_ratio(x->tip[m]);
        wf_show(stdout, "%9.0f%%", 100 * wf_explain_share(x, m, 0.05));
        for (int32_t l = 0; l <= wf_explain_top(x); l++) {
            struct wf_explain_spread s;
            wf_explain_spread(x, m, l, &s);
            missing |= print_ratio(s.middle);
        }
        wf_show(stdout, "\n");
    }
    if (missing) wf_show(stdout, "-: the method has no answer there, or no branch bends by beam theory\n");
    wf_show(stdout, "\n");
}

/* One method of the peak load on the tree in this wind. */
static enum wf_status print_peak(const struct wf_analysis *of, const struct wf_solve_options *o, double speed,
                                 const char *method, struct wf_arena *a, struct wf_err *e)
{
    struct wf_analysis an = *of;
    struct wf_at_speed at;
    struct wf_peak_parts p;
    an.scenario.peak.method = method;
    wf_search_default(&an.search);
    enum wf_status s = wf_sway_set_up(&an, o, &speed, 1, a, NULL, e);
    if (!s) s = wf_speed_totals(&an, o, speed, &at, e);
    if (s) return s;
    wf_peak_parts_at(an.peak, speed, WF_PART_STEM, &p);
    wf_show(stdout, "%-10s", method);
    const double cell[] = { p.factor,
                            p.gust.structural,
                            p.frequency,
                            p.damping,
                            p.gust.turbulence,
                            p.gust.background,
                            p.gust.resonance,
                            at.steady.base_moment / 1e3,
                            at.base_moment / 1e3,
                            fmin(at.worst[WF_BREAKAGE][WF_SCOPE_TREE].safety, wf_verdict_safety(&at, NULL)) };
    for (size_t k = 0; k < sizeof cell / sizeof *cell; k++) (void)print_ratio(cell[k]);
    wf_show(stdout, "\n");
    return WF_OK;
}

static enum wf_status print_peaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  double speed, struct wf_arena *a, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    wf_show(stdout,
            "Peak load of gusts by method; G multiplies the mean load, c_s c_d or G_f that of the gust\n\n"
            "%-10s%10s%10s%10s%10s%10s%10s%10s%10s%10s%10s\n%-10s%10s%10s%10s%10s%10s%10s%10s%10s%10s%10s\n",
            "method", "G", "cscd, Gf", "sway", "damping", "I_v", "B2, Q2", "R2", "mean", "peak", "safety", "",
            "-", "-", "Hz", "-", "-", "-", "-", "kN m", "kN m", "factor");
    for (const struct wf_peak_method *m = wf_peak_methods; m->name && !s; m++)
        if (strcmp(m->name, "table") != 0 && strcmp(m->name, "gales") != 0)
            s = print_peak(an, o, speed, m->name, a, e);
    wf_show(stdout, "gales and table need --spacing and --peak-table of analyze\n\n");
    return s;
}

/* What the printed methods leave out on this tree. */
static void warn_of_departures(const struct wf_analysis *an, struct wf_diag *d)
{
    for (const struct wf_preset *p = wf_presets; p->name; p++) {
        struct wf_analysis as = *an;
        if (p->solver) as.solver = wf_solver_named(p->solver);
        wf_preset_warn(p, &as, d);
    }
}

static enum wf_status explain(const struct explain_options *o, struct wf_doc_head *head, struct wf_arena *a,
                              struct wf_err *e)
{
    struct wf_diag d = { .arena = a }, leaves = { .arena = a };
    struct wf_species sp;
    struct wf_model m;
    struct wf_explain x;
    struct wf_solve_options solve;
    struct wf_analysis an = { .species = &sp, .model = &m, .solver = wf_solvers[0] };
    bool quiet = o->args.quiet;
    wf_scenario_default(&an.scenario);
    an.scenario.azimuth = o->azimuth;
    wf_solve_options_default(&solve);
    enum wf_status s = wf_species_named(o->args.operand[0], a, &sp, &d, e);
    if (!s) s = wf_model_named(o->model, a, &m, &d, e);
    if (!s) s = wf_scenario_profile(&an.scenario, &o->profile, a, &d, e);
    if (!s) s = wf_scenario_check(&an.scenario, e);
    /* every solver takes the same tree, and not all take one that stands */
    if (m.shape == WF_SHAPE_UNDER_WEIGHT) m.shape = WF_SHAPE_UNLOADED;
    if (!s) s = wf_analysis_set_up(&an, &solve, a, &d, e);
    if (!s) wf_limits_profile(&an.scenario, an.tallness, m.name, &d);
    struct wf_run_folder f = { 0 };
    if (!s) s = wf_results_begin(&f, o->output, o->pages.none ? NULL : "explain", e);
    if (!s) s = wf_explain_run(&an, &solve, o->wind, a, &d, &x, e);
    wf_progress_clear();
    if (!s && !quiet) print_methods(&x, o->wind, &an.scenario);
    if (!s && !quiet && o->peak) s = print_peaks(&an, &solve, o->wind, a, e);
    fflush(stdout);
    wf_print_findings(&d, quiet);
    if (s) {
        wf_run_abandon(&f);
        return s;
    }
    warn_of_departures(&an, &leaves);
    const struct wf_explained of = { .run = 1,
                                     .name = wf_arena_print(a, "%s, %s", sp.key, m.key),
                                     .model = m.name,
                                     .species = &sp,
                                     .of = &x,
                                     .tree = &an.tree,
                                     .speed = o->wind,
                                     .scenario = &an.scenario,
                                     .findings = &leaves };
    wf_doc_head_file(head, "model", m.file);
    wf_doc_head_file(head, "species", sp.file);
    s = of.name ? wf_explain_write(&of, head, f.stage, e) : wf_fail(e, WF_ENOMEM, "no memory");
    if (!s) s = wf_results_end(&f, &o->pages, a, NULL, e);
    wf_run_abandon(&f);
    if (!s && !quiet) wf_show(stdout, "\nTable%s: %s\n", o->pages.none ? "" : ", plot, page", o->output);
    return s;
}

int wf_cmd_explain(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct explain_options o = { 0 };
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, wf_explain_options, about, 1, 1, &arena, &o.args);
    if (code < 0 && !o.model) {
        wf_show(stderr, "windfirm explain: --model is needed, for example --model models/culm.yaml\n");
        code = 2;
    }
    if (code < 0) {
        struct wf_doc_head head;
        enum wf_status s = wf_pages_head(argc, argv, &arena, &head, &e);
        code = s || explain(&o, &head, &arena, &e) ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}
