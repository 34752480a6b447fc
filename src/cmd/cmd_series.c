/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm series and windfirm papers: trees in winds that change. */
#include "base/file.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "base/text.h"
#include "cmd/analyze_print.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "data/species.h"
#include "load/drag.h"
#include "out/results.h"
#include "out/series.h"
#include "study/explain.h"
#include "study/series_plan.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Rows of both commands; into any struct with struct wf_pages pages and no_vtk. */
#define SERIES_PAGE_ROWS                                                                                     \
    WF_PAGE_ROWS("--no-report", pages, "write tables only"),                                                 \
        FLAG("--no-vtk", no_vtk, "leave out the frames for ParaView"), WF_QUIET_ROW

/* ---- From a plan of runs to tables, frames and a page ---- */

struct series_job {
    const struct wf_series_plan *plan;
    const char *folder, *command;
    struct wf_pages pages;
    bool quiet, vtk;
};

/* Species and model of a run. */
static enum wf_status read_run(const struct wf_series_plan_run *r, const char *file, struct wf_arena *a,
                               struct wf_series_spec *out, struct wf_diag *d, struct wf_err *e)
{
    struct wf_species *sp = WF_TAKE(a, 1, struct wf_species);
    struct wf_model *m = WF_TAKE(a, 1, struct wf_model);
    struct wf_err why[2] = { { 0 }, { 0 } };
    if (!sp || !m) return wf_fail(e, WF_ENOMEM, "no memory");
    /* file: that of the runs; NULL: they were typed */
    enum wf_status s =
        wf_species_named(file ? wf_beside(file, r->species, a) : r->species, a, sp, d, &why[0]);
    enum wf_status t = wf_model_named(file ? wf_beside(file, r->model, a) : r->model, a, m, d, &why[1]);
    if (s && t) return wf_fail(e, s, "run '%s': %s; %s", r->name, why[0].text, why[1].text);
    if (s || t) return wf_fail(e, s ? s : t, "run '%s': %s", r->name, s ? why[0].text : why[1].text);
    return wf_series_plan_spec(r, sp, m, a, out, e);
}

/* The profile and site of every run, unless it is that of the run before. */
static void print_sites(const struct wf_series_page *p)
{
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_scenario *s = &p->run[r].series->an.scenario,
                                 *last = r ? &p->run[r - 1].series->an.scenario : NULL;
        if (last && !strcmp(s->profile, last->profile) && s->category == last->category &&
            s->carried == last->carried && s->reference_height == last->reference_height)
            continue;
        wf_show(stdout, "From run %zu: wind profile %s. ", r + 1, s->profile);
        wf_print_site(stdout, s);
    }
    wf_show(stdout, "\n");
}

static void print_runs(const struct wf_series_page *p)
{
    wf_show(stdout, "%s\n", p->title);
    print_sites(p);
    wf_show(stdout, "%4s  %-34s%10s%12s%12s%12s%10s\n", "run", "", "frames", "wind m/s", "tip mean m",
            "largest m", "safety");
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        double sum = 0, most = 0, wind = 0, n = 0, safety = NAN;
        for (size_t k = 0; k < s->frames; k++) {
            wind += s->wind[k] / (double)s->frames;
            safety = fmin(safety, s->safety[k]);
            if (isfinite(s->deflection[k])) sum += s->deflection[k], most = fmax(most, s->deflection[k]), n++;
        }
        if (n > 0)
            wf_show(stdout, "%4zu  %-34s%10zu%12.2f%12.4g%12.4g", r + 1, s->spec.name, s->frames, wind,
                    sum / n, most);
        else
            wf_show(stdout, "%4zu  %-34s%10zu%12.2f%12s%12s  no frame has a result", r + 1, s->spec.name,
                    s->frames, wind, "-", "-");
        if (isfinite(safety))
            wf_show(stdout, "%10.2f\n", safety);
        else
            wf_show(stdout, "%10s\n", n > 0 ? "-" : "");
    }
    wf_show(stdout, "\n");
}

/* Findings of all runs, those that several have in common once. */
static void print_findings_once(const struct wf_diag *diag, size_t runs, bool quiet, struct wf_arena *a)
{
    struct wf_diag once = { .arena = a };
    for (size_t r = 0; r < runs; r++)
        for (const struct wf_finding *w = diag[r].first; w; w = w->next) wf_diag_pass(&once, w);
    wf_print_findings(&once, quiet);
}

/* Returned: *done, the runs that were made; after an interrupt fewer than planned. */
static enum wf_status run_all(const struct series_job *j, struct wf_series *series, struct wf_diag *diag,
                              size_t *done, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_series_plan *plan = j->plan;
    struct wf_diag inputs = { .arena = a };
    struct wf_series_spec *spec = WF_TAKE(a, plan->runs, struct wf_series_spec);
    enum wf_status s = spec ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for %zu runs", plan->runs);
    for (size_t r = *done = 0; r < plan->runs && !s; r++)
        s = read_run(&plan->run[r], plan->file, a, &spec[r], &inputs, e);
    wf_print_findings(&inputs, j->quiet);
    for (size_t r = 0; r < plan->runs && !s; r++) {
        if (r && wf_interrupted()) {
            wf_diag_warn(&diag[r - 1], "interrupted", "interrupted: %zu of %zu runs", r, plan->runs);
            return WF_OK;
        }
        diag[r].arena = a;
        wf_stage_item(r + 1, plan->runs);
        s = wf_series_run(&spec[r], a, &diag[r], &series[r], e);
        wf_progress_clear();
        if (s)
            wf_print_findings(&diag[r], j->quiet);
        else
            ++*done;
    }
    return s;
}

/* Apply every method to the trees of the runs that request it. Its warnings are added to those of the run. */
static enum wf_status explain_runs(const struct wf_series_plan *plan, const struct wf_series *series,
                                   struct wf_diag *diag, struct wf_arena *a, struct wf_series_page *page,
                                   struct wf_err *e)
{
    struct wf_explained *of = WF_TAKE(a, plan->runs, struct wf_explained);
    struct wf_explain *made = WF_TAKE(a, plan->runs, struct wf_explain);
    enum wf_status s = of && made ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
    page->explain = of;
    for (size_t r = 0; r < page->n && !s && !wf_interrupted(); r++) {
        const struct wf_series *x = &series[r];
        if (!plan->run[r].explain || strcmp(plan->run[r].explain, "yes") != 0) continue;
        wf_stage_item(r + 1, page->n);
        s = wf_explain_run(&x->an, &x->spec.solve, x->spec.speed, a, &diag[r], &made[r], e);
        wf_progress_clear();
        of[page->explained++] = (struct wf_explained){ .run = r + 1,
                                                       .name = x->spec.name,
                                                       .species = x->spec.species,
                                                       .of = &made[r],
                                                       .tree = &x->an.tree,
                                                       .speed = x->spec.speed };
    }
    return s;
}

/* Run a plan, write its files into the stage and draw its page. */
static enum wf_status perform_runs(const struct series_job *j, struct wf_run_folder *f,
                                   struct wf_series_page *page, struct wf_series *series,
                                   struct wf_diag *diag, struct wf_arena *a, struct wf_err *e)
{
    struct wf_err why = { 0 };
    enum wf_status s = run_all(j, series, diag, &page->n, a, e);
    if (!s && (s = explain_runs(j->plan, series, diag, a, page, &why)) == WF_EINTERRUPTED)
        page->explained--, s = WF_OK; /* the last one is not finished */
    else if (s)
        wf_fail(e, s, "%s", why.text);
    if (s) return s;
    if (!j->quiet) print_runs(page);
    fflush(stdout);
    print_findings_once(diag, page->n, j->quiet, a);
    s = wf_series_tables(page, f->stage, e);
    if (!s && j->vtk) s = wf_series_vtk(page, f->stage, e);
    return s ? s : wf_results_end(f, &j->pages, a, NULL, e);
}

/* Returned: exit code. */
static int perform_plan(const struct series_job *j, struct wf_arena *a)
{
    const struct wf_series_plan *plan = j->plan;
    struct wf_err e = { 0 };
    struct wf_series *series = WF_TAKE(a, plan->runs, struct wf_series);
    struct wf_diag *diag = WF_TAKE(a, plan->runs, struct wf_diag);
    struct wf_series_page_run *run = WF_TAKE(a, plan->runs, struct wf_series_page_run);
    struct wf_series_page page = { .title = plan->title,
                                   .note = plan->note,
                                   .command = j->command,
                                   .version = WF_VERSION,
                                   .date = wf_run_date(a),
                                   .n = plan->runs,
                                   .run = run };
    if (!series || !diag || !run || !page.date || !j->command) {
        wf_fail(&e, WF_ENOMEM, "no memory");
        return wf_complain(&e);
    }
    for (size_t r = 0; r < plan->runs; r++) run[r] = (struct wf_series_page_run){ &series[r], &diag[r] };
    struct wf_run_folder f;
    enum wf_status s = wf_results_begin(&f, j->folder, j->pages.none ? NULL : "series", &e);
    if (!s) s = perform_runs(j, &f, &page, series, diag, a, &e);
    wf_run_abandon(&f);
    if (s) return wf_complain(&e);
    if (!j->quiet)
        wf_show(stdout, "\nTables%s%s: %s\n", j->vtk ? ", frames" : "", j->pages.none ? "" : ", page",
                j->folder);
    return 0;
}

/* ---- windfirm series ---- */

static const char *gust_word(size_t i) { return i ? wf_gust_models[i - 1].name : "steady"; }
static const char *leaf_word(size_t i) { return wf_leaf_motions[i].name; }

struct series_options {
    struct wf_args args;
    struct wf_series_plan_run run; /* its words and numbers as typed */
    struct wf_averaging averaging;
    const char *components; /* "1" or "3"; NULL: not given */
    const char *output;
    bool explain, no_vtk;
    struct wf_pages pages;
};

static bool run_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct series_options *o = options;
    if (row->member == offsetof(struct series_options, components))
        return wf_series_plan_unused(&o->run, offsetof(struct wf_series_plan_run, components), why, WF_WHY);
    return wf_series_plan_unused(&o->run, row->member - offsetof(struct series_options, run), why, WF_WHY);
}

#define OPTIONS struct series_options
const struct wf_option wf_series_options[] = {
    STUDY,
    PATH("--model", run.model, "MODEL", NULL, "tree model: a file, or the name of a shipped one",
         .letter = "-m"),
    WF_WIND_ROWS(run.wind, averaging, 0, 100, "mean wind at the reference height", .unused = run_unused),
    WORD("--gust", run.gust, "NAME", gust_word, "steady",
         "how the wind changes; steady: it does not, and all frames of a balance are equal"),
    WORD("--preset", run.preset, "NAME", wf_preset_word, "corrected", "a published method, as printed"),
    WORD("--solver", run.solver, "NAME", wf_solver_word, NULL,
         "how the bent shape is computed [the preset's, else beam]"),
    WF_PROFILE_ROWS(run.profile),
    WORD("--shelter", run.shelter, "NAME", wf_shelter_word, "none", "wind inside the crown"),
    NUMBER("--intensity", run.intensity, "NUMBER", NONE, NULL, 0, 1, NULL,
           "turbulence intensity of the gust model", .unused = run_unused),
    NUMBER("--period", run.period, "TIME", TIME, "s", 0.1, 3600, NULL, "of the gust model",
           .unused = run_unused),
    WF_GUST_ROWS(run, run_unused),
    CHOICE("--components", components, "1|3", "1|3", NULL,
           "of the gust: along the wind only, or along, across and up [3 where the model has them]",
           .unused = run_unused),
    NUMBER("--duration", run.duration, "TIME", TIME, "s", 1e-3, 86400, "60", "time that is run"),
    NUMBER("--step", run.step, "TIME", TIME, "s", 1e-4, 3600, "0.1", "between frames"),
    WHOLE("--keys", run.keys, 1, 64, "8", "key frames drawn as panels"),
    WHOLE("--seed", run.seed, 0, 1e9, "1", "of the random numbers", .unused = run_unused),
    NUMBER("--restoring", run.restoring, "NUMBER", NONE, NULL, 0, 100, "0",
           "k of the deflect scheme, below 1", .unused = run_unused),
    NUMBER("--damping", run.damping, "NUMBER", NONE, NULL, 0, 1e9, "0", "c of the deflect scheme, N s2",
           .unused = run_unused),
    WORD("--leaf-motion", run.leaf_motion, "NAME", leaf_word, NULL,
         "how leaves turn; affects the picture only, not the loads [the preset's, else eq13]"),
    NUMBER("--leaf-amplitude", run.leaf_amplitude, "ANGLE", ANGLE, "deg", 0, 180, "30",
           "largest turn by one of the three noises", .unused = run_unused),
    NUMBER("--leaf-follow", run.leaf_follow, "NUMBER", NONE, NULL, -10, 10, "0.5",
           "lambda: share of theta_x added to theta_z", .unused = run_unused),
    NUMBER("--leaf-period", run.leaf_period, "TIME", TIME, "s", 1e-3, 3600, "1",
           "of the noise's first octave", .unused = run_unused),
    NUMBER("--youngs-modulus", run.youngs, "MODULUS", PRESSURE, "Pa", 1e5, 1e12, NULL,
           "in place of the species'"),
    TEXT("--output", output, "FOLDER", "out/series", "where tables, frames and the page go", .letter = "-o"),
    FLAG("--explain", explain, "every method against beam theory, branch by branch, too"),
    SERIES_PAGE_ROWS,
    { 0 },
};

static const char series_about[] =
    "SPECIES is a species table, a file or the name of a shipped one. Every frame is a balance of its own: "
    "wind, "
    "loads and shape without inertia, so it is valid for winds that change slowly against the tree's own "
    "sway. "
    "The "
    "deflect solvers go from frame to frame with their restoring and damping terms.\n"
    "\n"
    "  windfirm series moso_bamboo --model moso_culm --wind 10 --gust cosine --period 20 --duration 60";

int wf_cmd_series(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct series_options o = { 0 };
    int code = wf_args_read(argc, argv, wf_series_options, series_about, 1, 1, &arena, &o.args);
    if (code < 0 && !o.run.model) {
        wf_show(stderr, "windfirm series: --model is needed, for example --model models/culm.yaml\n");
        code = 2;
    }
    if (code < 0) {
        o.run.name = o.run.species = o.args.operand[0];
        o.run.components = o.components ? (size_t)atoi(o.components) : 0;
        o.run.transmission = NAN;
        o.run.explain = o.explain ? "yes" : "no";
        struct wf_series_plan plan = { .key = "series",
                                       .title = "A tree in changing wind",
                                       .note = o.args.winds_said,
                                       .runs = 1,
                                       .run = &o.run };
        struct series_job job = { .plan = &plan,
                                  .folder = o.output,
                                  .command = wf_command_line(argc, argv, &arena),
                                  .quiet = o.args.quiet,
                                  .pages = o.pages,
                                  .vtk = !o.no_vtk };
        code = perform_plan(&job, &arena);
    }
    wf_arena_free(&arena);
    return code;
}

/* ---- windfirm papers ---- */

struct papers_options {
    struct wf_args args;
    const char *output; /* NULL: out/NAME */
    struct wf_pages pages;
    bool no_vtk;
};

#undef OPTIONS
#define OPTIONS struct papers_options
static const struct wf_option papers_options[] = {
    TEXT("--output", output, "FOLDER", NULL, "where tables, frames and the page go [out/NAME]",
         .letter = "-o"),
    SERIES_PAGE_ROWS,
    { 0 },
};

static const char papers_about[] =
    "NAME is tang2012, feng1999, zhao2013, yang2011 or a file of runs like models/papers/tang2012.yaml: "
    "species, "
    "model, "
    "wind, method of every run, in as many runs as wanted. 'windfirm papers list' lists the shipped ones, "
    "'windfirm papers schema' the keys.\n"
    "\n"
    "  windfirm papers tang2012 -o out/tang";

/* The paper whose runs are no file: rain on a branch. */
static const char rain_paper[] = "yang2011";

/* The file of runs that a user means. Errors: as wf_shipped, with the words of the command among the names.
 */
static enum wf_status find_runs(const char *name, struct wf_arena *a, const char **path, struct wf_diag *d,
                                struct wf_err *e)
{
    static const char *const words[] = { "list", "schema" };
    struct wf_err why = { 0 };
    enum wf_status s = wf_shipped("models/papers", name, a, path, d, &why);
    if (!s) return WF_OK;
    const char **names, *word = wf_nearest(name, words, WF_COUNT(words));
    size_t n = wf_shipped_names(wf_share(), "models/papers", a, &names);
    const char **all = WF_TAKE(a, n + 1, const char *);
    if (!word && all) { /* the paper that is no file, where no file's name is nearer */
        for (size_t i = 0; i < n; i++) all[i] = names[i];
        all[n] = rain_paper;
        word = wf_nearest(name, all, n + 1);
        if (word != rain_paper) word = NULL;
    }
    return word ? wf_fail(e, s, "papers: no paper is called '%s'; did you mean '%s'?", name, word)
                : wf_fail(e, s, "%s", why.text);
}

/* Names and titles of the runs that are shipped. Returned: exit code. */
static int list_papers(struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    const char **names, *path;
    size_t n = wf_shipped_names(wf_share(), "models/papers", a, &names);
    if (!n) return wf_complain(&(struct wf_err){ WF_EINPUT, "no runs of papers are installed" });
    wf_show(stdout, "%-20s %5s  %s\n", "name", "runs", "title");
    for (size_t i = 0; i < n; i++) {
        struct wf_series_plan plan;
        if (wf_shipped_path(wf_share(), "models/papers", names[i], a, &path, NULL) ||
            !wf_begins_with_key(path, "runs_of:", a) || /* a model that the runs use */
            wf_series_plan_read(path, a, &plan, &d, NULL))
            continue;
        wf_show(stdout, "%-20s %5zu  %s\n", names[i], plan.runs, plan.title);
        if (plan.source) wf_show(stdout, "%-20s %5s  source: %s\n", "", "", plan.source);
    }
    wf_show(stdout, "%-20s %5d  %s\n%-20s %5s  source: %s\n", rain_paper, 3,
            "Yang and Wu 2011: rain on branches and leaves", "", "",
            "Yang M., Wu E. 2011. J. Software 22(8):1934-1947");
    wf_print_findings(&d, false);
    return d.errors ? 2 : 0;
}

int wf_cmd_papers(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct papers_options o;
    struct wf_err e = { 0 };
    struct wf_series_plan plan;
    for (int i = 1; i < argc; i++)
        if (!strcmp(argv[i], rain_paper)) return wf_paper_yang2011(argc, argv);
    int code = wf_args_read(argc, argv, papers_options, papers_about, 1, 1, &arena, &o.args);
    if (code < 0 && !strcmp(o.args.operand[0], "list")) code = list_papers(&arena);
    if (code < 0 && !strcmp(o.args.operand[0], "schema")) {
        char *text = wf_series_plan_schema(&arena, &e);
        if (text) wf_show_text(stdout, text);
        code = text ? 0 : wf_complain(&e);
    }
    if (code < 0) {
        struct wf_diag d = { .arena = &arena };
        const char *path;
        enum wf_status s = find_runs(o.args.operand[0], &arena, &path, &d, &e);
        if (!s) s = wf_series_plan_read(path, &arena, &plan, &d, &e);
        wf_print_findings(&d, false);
        if (s) code = wf_complain(&e);
    }
    if (code < 0) {
        struct series_job job = { .plan = &plan,
                                  .folder = o.output ? o.output : wf_arena_print(&arena, "out/%s", plan.key),
                                  .command = wf_command_line(argc, argv, &arena),
                                  .quiet = o.args.quiet,
                                  .pages = o.pages,
                                  .vtk = !o.no_vtk };
        code = perform_plan(&job, &arena);
    }
    wf_arena_free(&arena);
    return code;
}
