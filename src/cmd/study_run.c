#include "cmd/study.h"
#include "out/report.h"
#include "wind/terrain.h"
#include <string.h>
#include <sys/stat.h>

enum { OTHER_FILES = 5 }; /* model, study, profile, climate, ground */

/* Everything of one run, in one arena. */
struct work {
    struct wf_arena arena;
    struct wf_args args;
    struct wf_study study;
    const char *folder;
    struct wf_model model;
    struct wf_species *species;
    struct wf_analysis *analysis;
    size_t inputs;
    struct wf_input_file *input;
    struct wf_diag *diag; /* one per species */
    bool quiet;
};

static char *typed(struct wf_arena *a, int argc, char **argv)
{
    char *text = wf_arena_text(a, "windfirm");
    for (int i = 0; text && i < argc; i++) {
        bool plain = argv[i][0] && !strpbrk(argv[i], " \t'\"$&*;<>|");
        text = wf_arena_print(a, plain ? "%s %s" : "%s '%s'", text, argv[i]);
    }
    return text;
}

static enum wf_status note(struct work *w, const char *role, const char *path, struct wf_err *e)
{
    return wf_input_file_note(role, path, &w->arena, &w->input[w->inputs++], e);
}

/* Model and species files; every mistake of every file is printed before the run is refused. */
static enum wf_status read_inputs(struct work *w, struct wf_err *e)
{
    struct wf_diag d = { .arena = &w->arena };
    const char *model = NULL;
    struct wf_err first = { 0 }, next = { 0 };
    enum wf_status worst = wf_study_tree(&w->args, NULL, &w->arena, &w->model, &model, &d, &first);
    size_t found = d.errors;
    enum wf_status asked = wf_study_from_args(&w->args, &w->arena, &d, &w->study, &next);
    if (asked && d.errors == found) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
    if (asked && !worst) worst = asked;
    for (size_t k = 0; k < w->args.n; k++) {
        const char *path = wf_shipped("species", w->args.operand[k], &w->arena);
        size_t before = d.errors;
        next = (struct wf_err){ 0 };
        enum wf_status s = wf_species_read(path, &wf_laws, &w->arena, &w->species[k], &d, &next);
        if (s && d.errors == before) wf_diag_error(&d, NULL, 0, 0, "%s", next.text);
        if (s && !worst) worst = s;
        if (!s && (s = note(w, "species", path, e))) return s;
    }
    if (worst && first.code && !d.errors) wf_diag_error(&d, NULL, 0, 0, "%s", first.text);
    wf_print_findings(&d, w->quiet);
    if (worst)
        return wf_fail(e, worst, "%zu mistake%s in the input; nothing was computed", d.errors,
                       d.errors == 1 ? "" : "s");
    const char *const profile = w->study.scenario.profile_file,
                      *const study = wf_args_text(&w->args, "--study"),
                      *const climate = w->study.directions.climate_file;
    enum wf_status s = wf_input_file_note("model", model, &w->arena, &w->input[0], e);
    if (!s && study) s = note(w, "study", study, e);
    if (!s && profile) s = note(w, "profile", profile, e);
    if (!s && w->study.scenario.site) s = note(w, "ground", w->study.scenario.site->file, e);
    return !s && climate ? note(w, "climate", climate, e) : s;
}

/* The same from all directions, where asked for. */
static enum wf_status around(struct work *w, struct wf_analysis *an, struct wf_err *e)
{
    const struct wf_directions_request *q = &w->study.directions;
    if (!q->n) return WF_OK;
    struct wf_directions *out = WF_TAKE(&w->arena, 1, struct wf_directions);
    if (!out) return wf_fail(e, WF_ENOMEM, "no room for %zu directions", q->n);
    wf_progress("%s: %zu directions ...", an->species->name, q->n);
    an->directions = out;
    return wf_directions_run(an, &w->study.solve, q, &w->arena, out, e);
}

static enum wf_status analyse(struct work *w, struct wf_err *e)
{
    for (size_t k = 0; k < w->args.n; k++) {
        const struct wf_preset *preset = w->study.preset;
        w->diag[k].arena = &w->arena;
        if (wf_preset_apply(preset, &w->arena, &w->species[k], &w->study.scenario, &w->study.solver, e))
            return e->code;
        wf_progress("%s: %zu wind speeds, critical speed, curves ...", w->species[k].name, w->args.speeds);
        enum wf_status s =
            wf_analyze(&w->species[k], &w->model, &w->study.scenario, w->study.solver, &w->study.solve,
                       w->args.speed, w->args.speeds, &w->arena, &w->diag[k], &w->analysis[k], e);
        if (!s) s = around(w, &w->analysis[k], e);
        wf_progress(NULL);
        if (s) wf_print_findings(&w->diag[k], w->quiet);
        if (s) return s;
        wf_preset_warn(preset, &w->analysis[k], &w->diag[k]);
    }
    return WF_OK;
}

/* Plots and pages. A drawing program that is not installed leaves the results complete; *whole tells whether
 * everything was drawn. */
static enum wf_status draw(struct work *w, bool *whole, struct wf_err *e)
{
    struct wf_diag d = { .arena = &w->arena };
    struct wf_err why = { 0 };
    wf_progress("drawing plots and pages ...");
    enum wf_status s = wf_report_make(w->folder, wf_args_text(&w->args, "--lang"), &d, &why);
    wf_progress(NULL);
    wf_print_findings(&d, false);
    *whole = s == WF_OK;
    if (s == WF_OK || s == WF_EMISSING) return WF_OK;
    return wf_fail(e, s, "%s", why.text);
}

/* Pages of an earlier run beside new results would be taken for theirs. */
static void warn_of_old_pages(struct work *w)
{
    static const char *const page[] = { "report.html", "report.pdf" };
    struct stat results, old;
    const char *path = wf_arena_print(&w->arena, "%s/results.json", w->folder);
    if (!path || stat(path, &results)) return;
    for (size_t i = 0; i < sizeof page / sizeof *page; i++) {
        path = wf_arena_print(&w->arena, "%s/%s", w->folder, page[i]);
        if (!path || stat(path, &old)) continue;
        if (old.st_mtim.tv_sec < results.st_mtim.tv_sec ||
            (old.st_mtim.tv_sec == results.st_mtim.tv_sec && old.st_mtim.tv_nsec < results.st_mtim.tv_nsec))
            fprintf(stderr,
                    "warning: %s is the page of an earlier run; 'windfirm report %s' draws it again\n", path,
                    w->folder);
    }
}

static enum wf_status run(struct work *w, int argc, char **argv, struct wf_err *e)
{
    size_t n = w->args.n;
    w->species = WF_TAKE(&w->arena, n, struct wf_species);
    w->analysis = WF_TAKE(&w->arena, n, struct wf_analysis);
    w->input = WF_TAKE(&w->arena, n + OTHER_FILES, struct wf_input_file);
    w->inputs = 1; /* the model's place */
    w->diag = WF_TAKE(&w->arena, n, struct wf_diag);
    struct wf_run run = { .command = typed(&w->arena, argc, argv),
                          .version = WF_VERSION,
                          .date = wf_run_date(&w->arena),
                          .n = n,
                          .analysis = w->analysis,
                          .input = w->input };
    if (!w->species || !w->analysis || !w->input || !w->diag || !run.command || !run.date)
        return wf_fail(e, WF_ENOMEM, "no room for %zu species", n);
    enum wf_status s = read_inputs(w, e);
    run.inputs = w->inputs;
    if (s || (s = analyse(w, e))) return s;
    if (!w->quiet) wf_study_print(stdout, &run);
    fflush(stdout); /* so that warnings stand below the table where both go to the same place */
    for (size_t k = 0; k < n; k++) wf_print_findings(&w->diag[k], w->quiet);
    if ((s = wf_results_write(&run, w->folder, e))) return s;
    bool pages = !wf_args_given(&w->args, "--no-report"), whole = false;
    if (pages) s = draw(w, &whole, e);
    if (!w->quiet)
        printf("\nResults%s: %s\n",
               whole   ? ", tables, plots and pages"
               : pages ? " and tables (plots and pages not complete)"
                       : " and tables",
               w->folder);
    fflush(stdout);
    if (!whole) warn_of_old_pages(w);
    return s;
}

int wf_study_run(int argc, char **argv, const char *about, size_t low, size_t high)
{
    struct work w = { 0 };
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, wf_study_options, about, low, high, &w.arena, &w.args);
    if (code < 0) code = wf_study_tree_asked(&w.args, argv[0], NULL);
    if (code < 0 && !w.args.speeds) {
        fprintf(stderr, "windfirm %s: --wind is needed, for example --wind 10,15,25\n", argv[0]);
        code = 2;
    }
    if (code < 0) {
        const char *asked = wf_args_text(&w.args, "--output");
        w.quiet = wf_args_given(&w.args, "--quiet");
        w.folder = asked ? asked : wf_arena_print(&w.arena, "out/%s", argv[0]);
        code = w.folder && run(&w, argc, argv, &e) == WF_OK ? 0 : wf_complain(&e);
    }
    wf_arena_free(&w.arena);
    return code;
}
