/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/analyze_run.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "cmd/analyze_print.h"
#include "cmd/scan_models.h"
#include "data/species.h"
#include "load/drag.h"
#include "load/interception.h"
#include "study/verdict.h"
#include "study/wetted.h"
#include "wind/terrain.h"
#include <math.h>
#include <string.h>
#include <sys/stat.h>

/* The speeds named are solved: they are printed before the searches, which take most of the time. */
static void speeds_solved(const struct wf_analysis *an, void *work)
{
    struct wf_analyze_work *w = work;
    size_t before = w->solved++;
    if (w->options.args.quiet || w->hooks) return;
    wf_progress_clear();
    if (!before) wf_print_head(stdout, an);
    wf_print_speeds(stdout, an);
    fflush(stdout);
}

static void take_warnings(struct wf_diag *to, const struct wf_diag *from)
{
    for (const struct wf_finding *f = from->first; f; f = f->next)
        if (f->severity == WF_WARNING) wf_diag_pass(to, f);
}

/* The warnings of each species for its results: first those about the file of the tree, which have been
 * printed. */
static void put_tree_first(struct wf_analyze_work *w)
{
    for (size_t k = 0; k < w->options.args.n; k++) {
        struct wf_diag all = { .arena = &w->arena };
        take_warnings(&all, &w->tree);
        take_warnings(&all, &w->diag[k]);
        w->diag[k] = all;
    }
}

/* What is wrong with a climate that can be used also belongs to the results. */
static void keep_climate_warnings(struct wf_analyze_work *w, const struct wf_diag *d)
{
    w->tree.arena = &w->arena;
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->code && !strcmp(f->code, "frequency-sum")) wf_diag_pass(&w->tree, f);
}

/* Model and species files; every mistake of every file is printed before the run is refused. */
static enum wf_status read_inputs(struct wf_analyze_work *w, struct wf_err *e)
{
    struct wf_diag d = { .arena = &w->arena };
    w->tree.arena = &w->arena;
    const char *model = NULL;
    struct wf_err first = { 0 }, next = { 0 };
    enum wf_status worst =
        w->hooks ? w->hooks->tree(w, &d, &first)
                 : wf_tree_asked_read(&w->options.tree, NULL, &w->arena, &w->model, &model, &d, &first);
    take_warnings(&w->tree, &d);
    size_t found = d.errors;
    enum wf_status asked = wf_analyze_request_read(&w->options, &w->arena, &d, &w->request, &next);
    if (asked && d.errors == found) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
    if (asked && !worst) worst = asked;
    next = (struct wf_err){ 0 };
    found = d.errors;
    enum wf_status beside =
        w->hooks || worst ? WF_OK
                          : wf_analyze_list_read(&w->options, &w->model, &w->arena, &d, &w->scenarios, &next);
    if (beside && d.errors == found) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
    if (beside) worst = beside;
    next = (struct wf_err){ 0 };
    enum wf_status pictures = wf_job_read(&w->options.job, &w->arena, w->picture, &next);
    if (pictures) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
    if (pictures && !worst) worst = pictures;
    for (size_t k = 0; k < w->options.args.n; k++) {
        const char *path;
        size_t before = d.errors;
        next = (struct wf_err){ 0 };
        enum wf_status s = wf_shipped("species", w->options.args.operand[k], &w->arena, &path, &d, &next);
        if (!s) s = wf_species_read(path, &wf_laws, &w->arena, &w->species[k], &d, &next);
        if (!s) wf_show_name(w->species[k].name, w->species[k].name_zh);
        if (s && d.errors == before) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
        if (s && !worst) worst = s;
        if (!s && (s = wf_inputs_note(&w->inputs, "species", path, e))) return s;
    }
    if (worst && first.code && !d.errors) wf_diag_error(&d, NULL, 0, 0, "%s", first.text);
    wf_print_findings(&d, w->options.args.quiet);
    if (worst && wf_exit_code(worst) != 2) return wf_fail(e, worst, "nothing was computed");
    if (worst)
        return wf_fail(e, worst, "%zu mistake%s in the input; nothing was computed", d.errors,
                       d.errors == 1 ? "" : "s");
    keep_climate_warnings(w, &d);
    const char *const study = w->options.args.study;
    enum wf_status s = model ? wf_input_file_note("model", model, &w->arena, &w->inputs.item[0], e) : WF_OK;
    if (!s && study) s = wf_inputs_note(&w->inputs, w->hooks ? "card" : "study", study, e);
    return s ? s : wf_analyze_files_note(&w->options, &w->request, &w->model, &w->inputs, e);
}

/* Analyse the wind from all directions, where specified. */
static enum wf_status run_directions(struct wf_analyze_work *w, struct wf_analysis *an, struct wf_err *e)
{
    const struct wf_directions_request *q = &w->request.directions;
    if (!q->n) return WF_OK;
    struct wf_directions *out = WF_TAKE(&w->arena, 1, struct wf_directions);
    if (!out) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu directions", q->n);
    struct wf_err why = { 0 };
    enum wf_status s = wf_directions_run(an, &w->request.solve, q, &w->arena, out, &why);
    if (s == WF_EINTERRUPTED) {
        wf_diag_warn(an->diag, "interrupted", "interrupted before all %zu directions were computed", q->n);
        return WF_OK;
    }
    an->directions = out;
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}

/* With rain on its leaves, or with snow or ice: the tree beside itself without. */
static enum wf_status run_dry(struct wf_analyze_work *w, struct wf_analysis *an, enum wf_burden burden,
                              bool there, const struct wf_wetted **to, struct wf_err *e)
{
    if (!there || wf_interrupted()) return WF_OK;
    struct wf_wetted *out = WF_TAKE(&w->arena, 1, struct wf_wetted);
    struct wf_err why = { 0 };
    if (!out) return wf_fail(e, WF_ENOMEM, "not enough memory for the dry tree");
    enum wf_status s = wf_wetted_compare(an, burden, &w->request.solve, &w->arena, out, &why);
    if (s == WF_EINTERRUPTED) {
        wf_diag_warn(an->diag, "interrupted", "interrupted before the dry tree was computed");
        return WF_OK;
    }
    if (!s) *to = out;
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}

static enum wf_status run_burdens(struct wf_analyze_work *w, struct wf_analysis *an, struct wf_err *e)
{
    const struct wf_scenario *s = &an->scenario;
    if (run_dry(w, an, WF_BURDEN_WINTER, s->snow > 0 || s->ice > 0, &an->winter, e)) return e->code;
    if (run_dry(w, an, WF_BURDEN_RAIN, s->water > 0, &an->wetted, e)) return e->code;
    if (an->wetted) wf_water_asked_warn(&w->options.water, an->diag);
    return WF_OK;
}

/* Was tree k interrupted? The first one is kept as far as it came; a later one has not what the first has and
 * is left out. Returned: the trees of the results, 0 to go on. */
static size_t end_early(struct wf_analyze_work *w, size_t k)
{
    bool cut = false;
    if (!wf_interrupted()) return 0;
    for (const struct wf_finding *f = w->diag[k].first; f; f = f->next)
        cut = cut || (f->code && !strcmp(f->code, "interrupted"));
    size_t whole = k && cut ? k : k + 1;
    if (whole < w->options.args.n)
        wf_diag_warn(&w->diag[0], "interrupted", "interrupted: %zu of %zu trees", whole, w->options.args.n);
    return whole;
}

/* Analyse every species. Returned: *done, those that have results; after an interrupt fewer. */
static enum wf_status analyse(struct wf_analyze_work *w, size_t *done, struct wf_err *e)
{
    for (size_t k = *done = 0; k < w->options.args.n; k++) {
        const struct wf_preset *preset = w->request.preset;
        w->diag[k].arena = &w->arena;
        if (wf_preset_apply(preset, &w->arena, &w->species[k], &w->request.scenario, &w->request.solver, e))
            return e->code;
        if (wf_analyze_list_check(&w->scenarios, &w->species[k], e)) return e->code;
        w->request.search.solved = speeds_solved, w->request.search.context = w;
        wf_stage_item(k + 1, w->options.args.n);
        enum wf_status s = wf_analyze(&w->species[k], &w->model, &w->request.scenario, &w->request.search,
                                      w->request.solver, &w->request.solve, w->options.wind.speed,
                                      w->options.wind.n, &w->arena, &w->diag[k], &w->analysis[k], e);
        if (!s) s = run_directions(w, &w->analysis[k], e);
        if (!s) s = run_burdens(w, &w->analysis[k], e);
        if (!s) s = wf_analyze_list_run(&w->scenarios, &w->arena, &w->analysis[k], e);
        if (!s && preset == wf_presets) /* others repeat a publication as printed */
            s = wf_interval_take(&w->analysis[k], &w->request.solve, &w->request.interval,
                                 WF_GIVEN(&w->options, samples), &w->arena, e);
        if (!s && w->solved == k) speeds_solved(&w->analysis[k], w); /* interrupted before */
        wf_progress_clear();
        if (s) wf_print_findings(&w->diag[k], w->options.args.quiet);
        if (s) return s;
        if (w->hooks && w->hooks->after(w, &w->analysis[k], e)) return e->code;
        if (!w->options.args.quiet && !w->hooks) wf_print_searched(stdout, &w->analysis[k]);
        wf_preset_warn(preset, &w->analysis[k], &w->diag[k]);
        if ((*done = end_early(w, k))) return WF_OK;
    }
    *done = w->options.args.n;
    return WF_OK;
}

/* With --scan-model all: the other models of the scan. */
static enum wf_status analyse_models(struct wf_analyze_work *w, size_t species, struct wf_err *e)
{
    const struct wf_scan_models all = { .tree = &w->options.tree,
                                        .models = w->model.measured_models,
                                        .n = species,
                                        .species = w->species,
                                        .first = w->analysis,
                                        .diag = w->diag,
                                        .scenario = &w->request.scenario,
                                        .search = &w->request.search,
                                        .solver = w->request.solver,
                                        .solve = &w->request.solve,
                                        .wind = &w->options.wind };
    return w->all_models ? wf_scan_models_analyse(&all, &w->arena, e) : WF_OK;
}

/* Pages that no run listed, such as those of an earlier version, stay; they would be mistaken for pages of
 * the new results. */
static void warn_of_old_pages(struct wf_analyze_work *w)
{
    static const char *const page[] = { "report.html", "report.pdf" };
    struct stat old;
    for (size_t i = 0; i < WF_COUNT(page); i++) {
        const char *path = wf_arena_print(&w->arena, "%s/%s", w->folder, page[i]);
        if (!path || stat(path, &old)) continue;
        if (old.st_mtim.tv_sec < w->started.tv_sec ||
            (old.st_mtim.tv_sec == w->started.tv_sec && old.st_mtim.tv_nsec < w->started.tv_nsec))
            wf_show(stderr,
                    "warning: %s is the page of an earlier run; 'windfirm report %s' draws it again\n", path,
                    w->folder);
    }
}

enum wf_status wf_analyze_run(struct wf_analyze_work *w, int argc, char **argv, struct wf_err *e)
{
    size_t n = w->options.args.n;
    w->species = WF_TAKE(&w->arena, n, struct wf_species);
    w->analysis = WF_TAKE(&w->arena, n, struct wf_analysis);
    /* the first place is kept for the model */
    w->inputs =
        (struct wf_inputs){ &w->arena, 1, WF_TAKE(&w->arena, n + WF_OPTION_FILES, struct wf_input_file) };
    w->diag = WF_TAKE(&w->arena, n, struct wf_diag);
    struct wf_run run = { .command = wf_command_line(argc, argv, &w->arena),
                          .version = WF_VERSION,
                          .date = wf_run_date(&w->arena),
                          .title = w->options.job.title,
                          .job = &w->options.job,
                          .n = n,
                          .analysis = w->analysis,
                          .input = w->inputs.item };
    if (!w->species || !w->analysis || !w->inputs.item || !w->diag || !run.command || !run.date)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu species", n);
    enum wf_status s = read_inputs(w, e);
    size_t none = !w->inputs.item[0].path; /* the tree is of no file */
    run.input += none, run.inputs = w->inputs.n - none;
    bool pages = !w->options.pages.none, whole = false;
    if (!s && w->hooks) s = w->hooks->before(w, e);
    if (!s && w->folder) s = wf_results_begin(&w->results, w->folder, pages ? "report" : NULL, e);
    if (s || (s = analyse(w, &run.n, e)) || (s = analyse_models(w, run.n, e))) return s;
    fflush(stdout); /* so that warnings appear below the table where both streams go to one place */
    for (size_t k = 0; k < run.n; k++) wf_print_findings(&w->diag[k], w->options.args.quiet);
    if (!w->folder) return WF_OK;
    put_tree_first(w);
    if (wf_results_write(&run, w->results.stage, e)) return e->code;
    if ((s = wf_job_write(w->picture, w->results.stage, e))) return s;
    s = wf_results_end(&w->results, &w->options.pages, &w->arena, &whole, e);
    if (!w->options.args.quiet)
        wf_show(stdout, "\nResults%s: %s\n",
                whole   ? ", tables, plots and pages"
                : pages ? " and tables (plots and pages not complete)"
                        : " and tables",
                w->folder);
    fflush(stdout);
    if (!whole) warn_of_old_pages(w);
    return s;
}
