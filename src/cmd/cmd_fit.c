/* windfirm fit: calibrate a tree to what was measured on it. */
#include "cmd/fit_job.h"
#include "cmd/pages.h"
#include "out/fit_species.h"
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

static const struct wf_option options[] = {
    { .name = "--data",
      .letter = "-d",
      .kind = WF_OPTION_TEXTS,
      .value = "FILE[,FILE]",
      .help = "CSV files of the tests that name none, in their order" },
    { .name = "--free",
      .letter = "-f",
      .kind = WF_OPTION_TEXTS,
      .value = "NAME[,NAME]",
      .help = "parameters to fit, in place of the study's: level0.youngs_modulus, root.stiffness, "
              "each:root.stiffness, "
              "damping_ratio, ..." },
    { .name = "--loss",
      .kind = WF_OPTION_CHOICE,
      .value = "NAME",
      .initial = "none",
      .choices = "none|huber|cauchy|tukey",
      .help = "what outliers count: squares, or a robust loss" },
    { .name = "--loss-scale",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .dimension = WF_DIM_NONE,
      .low = 0.1,
      .high = 100,
      .help = "where the loss departs from squares, in standard deviations [1.345 huber, 2.385 cauchy, 4.685 "
              "tukey]" },
    { .name = "--priors",
      .kind = WF_OPTION_FLAG,
      .help = "the species table's ranges take part as normal distributions" },
    { .name = "--starts",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "1",
      .dimension = WF_DIM_NONE,
      .low = 1,
      .high = 1000,
      .help = "starting points tried, within a factor of 3 of the start" },
    { .name = "--bootstrap",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "0",
      .dimension = WF_DIM_NONE,
      .low = 0,
      .high = 10000,
      .help = "resampled data sets for intervals by the bootstrap" },
    { .name = "--seed",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "1",
      .dimension = WF_DIM_NONE,
      .low = 0,
      .high = 9007199254740992.0,
      .help = "of starts and bootstrap" },
    { .name = "--no-profile", .kind = WF_OPTION_FLAG, .help = "no intervals by profile likelihood" },
    { .name = "--no-rival", .kind = WF_OPTION_FLAG, .help = "no second fit with the root the other way" },
    { .name = "--write",
      .kind = WF_OPTION_TEXT,
      .value = "FILE",
      .help = "write the species table with the fitted values" },
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .initial = "out/fit",
      .help = "where results, tables, plots and pages go" },
    { .name = "--no-report", .kind = WF_OPTION_FLAG, .help = "results and tables only" },
    WF_LANG_OPTION,
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

static const char about[] =
    "STUDY names trees, tests on them and sensors ('windfirm schema fit' shows its keys); the engine's "
    "answer is fitted to the "
    "readings. Estimates come with 95 % intervals by covariance and by profile likelihood, with what the "
    "data leave open, and "
    "beside a fit with the root the other way (clamped or giving).\n"
    "\n"
    "  windfirm fit models/field/sample_pull.yaml --free level0.youngs_modulus,root.stiffness\n"
    "  windfirm fit models/field/sample_pull.yaml --loss cauchy --write mine.yaml";

static volatile sig_atomic_t interrupted;
static void interrupt(int number)
{
    (void)number;
    interrupted = 1;
}

static bool progress(void *ctx, size_t iteration, double cost)
{
    (void)ctx;
    wf_progress("iteration %zu, misfit %.6g ...", iteration, 2 * cost);
    return interrupted;
}

static struct wf_fit_options options_of(const struct wf_args *g)
{
    static const char *const words[] = { "none", "huber", "cauchy", "tukey" };
    struct wf_fit_options o;
    wf_fit_options_default(&o);
    for (int k = 0; k < 4; k++)
        if (!strcmp(wf_args_text(g, "--loss"), words[k])) o.loss = (enum wf_loss)k;
    o.loss_scale = wf_args_number(g, "--loss-scale");
    o.priors = wf_args_given(g, "--priors");
    o.profile = !wf_args_given(g, "--no-profile");
    o.starts = (size_t)wf_args_number(g, "--starts");
    o.resamples = (size_t)wf_args_number(g, "--bootstrap");
    o.seed = (uint64_t)wf_args_number(g, "--seed");
    o.progress = progress;
    return o;
}

static enum wf_status note(struct wf_fit_job *j, const char *role, const char *path, struct wf_err *e)
{
    for (size_t i = 0; i < j->r.files; i++)
        if (!strcmp(j->r.file[i].path, path)) return WF_OK;
    return wf_input_file_note(role, path, &j->arena, &j->r.file[j->r.files++], e);
}

static enum wf_status build(struct wf_fit_job *j, struct wf_err *e)
{
    const char *names = wf_args_text(&j->args, "--data"), *list[64];
    char *rest = NULL, *copy = names ? wf_arena_text(&j->arena, names) : NULL;
    struct wf_fit_build b = { .study = &j->r.study, .share = wf_share(), .data = list };
    for (char *p = copy ? strtok_r(copy, ",", &rest) : NULL; p && b.datas < 64;
         p = strtok_r(NULL, ",", &rest))
        list[b.datas++] = p;
    enum wf_status s = wf_fit_study_read(j->args.operand[0], &j->arena, &j->r.study, &j->r.diag, e);
    if (s) return s;
    j->r.input = WF_TAKE(&j->arena, j->r.study.tests, struct wf_fit_input);
    j->r.file = WF_TAKE(&j->arena, 1 + 2 * j->r.study.trees + j->r.study.tests, struct wf_input_file);
    if (!j->r.input || !j->r.file) return wf_fail(e, WF_ENOMEM, "no room for the study");
    s = wf_fit_build(&b, &j->arena, &j->r.diag, &j->r.x, j->r.input, e);
    if (!s) s = note(j, "study", j->args.operand[0], e);
    for (size_t k = 0; k < j->r.x.trees && !s; k++) {
        s = note(j, "species", j->r.x.tree[k].species->file, e);
        if (!s && j->r.x.tree[k].file) s = note(j, "tree", j->r.x.tree[k].file, e);
    }
    for (size_t k = 0; k < j->r.x.tests && !s; k++)
        if (j->r.input[k].path) s = note(j, "data", j->r.input[k].path, e);
    return s ? s
             : wf_fit_params(&j->r.study, wf_args_text(&j->args, "--free"), &j->r.x, false, &j->arena,
                             &j->r.param, &j->r.params, e);
}

/* The same fit with the root clamped where it gives, or giving where it is clamped. A rival that cannot be
 * fitted is left out: it is no fault of the fit that was asked for. */
static void rival(struct wf_fit_job *j, struct wf_fit_options o)
{
    struct wf_fit_param *p = WF_TAKE(&j->arena, j->r.params + j->r.x.trees + 1, struct wf_fit_param);
    struct wf_diag d = { .arena = &j->arena };
    struct wf_err e = { 0 };
    size_t n = 0, nuisance = 0;
    bool had = false, tested = false;
    for (size_t k = 0; k < j->r.x.tests; k++)
        for (size_t s = 0; s < j->r.x.test[k].sensors; s++)
            tested |= j->r.x.test[k].sensor[s].kind != WF_SENSOR_DAMPING;
    if (!p || !tested) return;
    for (size_t k = 0; k < j->r.params; k++) had |= j->r.param[k].quantity == WF_FIT_ROOT;
    for (size_t k = 0; k < j->r.params; k++) {
        if (wf_param_nuisance(&j->r.param[k]))
            nuisance++;
        else if (j->r.param[k].quantity != WF_FIT_ROOT)
            p[n++] = j->r.param[k];
    }
    if (!had && wf_param_add(&j->r.x, j->r.x.trees > 1 ? "each:root.stiffness" : "root.stiffness", &j->arena,
                             p, &n, &e))
        return;
    if (!n) return;
    for (size_t k = j->r.params - nuisance; k < j->r.params; k++) p[n++] = j->r.param[k];
    o.profile = false, o.resamples = 0, o.starts = 1;
    struct wf_fit_rival *r = &j->r.rival;
    r->text = had ? "clamped root" : "root plate that gives";
    double *stiffness = WF_TAKE(&j->arena, j->r.x.trees, double);
    if (!stiffness) return;
    for (size_t k = 0; k < j->r.x.trees; k++) {
        double *of = j->r.x.tree[k].options.root_stiffness;
        stiffness[k] = of[0];
        if (had) of[0] = of[1] = 0; /* clamped, whatever the study gives */
    }
    enum wf_status s = wf_fit_run(&j->r.x, p, n, &o, &j->arena, &d, &r->fit, &e);
    for (size_t k = 0; k < j->r.x.trees; k++)
        j->r.x.tree[k].options.root_stiffness[0] = j->r.x.tree[k].options.root_stiffness[1] = stiffness[k];
    if (s || r->fit.stopped) return;
    const struct wf_fit *rich = had ? &j->r.fit : &r->fit;
    r->aicc = wf_fit_aicc(&r->fit, rich);
    r->own = wf_fit_aicc(&j->r.fit, rich);
    r->made = true;
}

/* A fit leaves the data's sigmas as it found them best; those of the main fit are kept for its figures. */
static enum wf_status fit(struct wf_fit_job *j, struct wf_err *e)
{
    struct wf_fit_options o = options_of(&j->args);
    struct sigaction act = { .sa_handler = interrupt }, before;
    sigaction(SIGINT, &act, &before);
    enum wf_status s = wf_fit_run(&j->r.x, j->r.param, j->r.params, &o, &j->arena, &j->r.diag, &j->r.fit, e);
    if (!s && !interrupted && !wf_args_given(&j->args, "--no-rival")) rival(j, o);
    sigaction(SIGINT, &before, NULL);
    wf_progress(NULL);
    return s;
}

static enum wf_status run(struct wf_fit_job *j, bool quiet, struct wf_err *e)
{
    const char *write = wf_args_text(&j->args, "--write");
    enum wf_status s = build(j, e);
    if (!s) s = fit(j, e);
    if (!s && interrupted && !j->r.fit.stopped)
        wf_diag_warn(&j->r.diag, "stopped", "interrupted before the comparison with the root the other way");
    if (!s && interrupted && write)
        wf_diag_warn(&j->r.diag, "stopped", "interrupted: %s is not written", write);
    if (!s && !quiet) wf_fit_print(stdout, &j->r);
    fflush(stdout);
    wf_print_findings(&j->r.diag, quiet);
    if (!s) s = wf_fit_results_write(&j->r, j->folder, e);
    if (interrupted) write = NULL; /* what others would take for the answer */
    if (!s && write) s = wf_fit_species_write(&j->r, write, e);
    bool report = !wf_args_given(&j->args, "--no-report");
    if (!s && report) s = wf_pages_make(j->folder, wf_args_text(&j->args, "--lang"), &j->arena, e);
    if (!s && !quiet) printf("\nResults, tables%s: %s\n", report ? ", plots and pages" : "", j->folder);
    if (!s && !quiet && write) printf("Species table: %s\n", write);
    return s;
}

int wf_cmd_fit(int argc, char **argv)
{
    struct wf_fit_job j = { 0 };
    struct wf_err e = { 0 };
    j.r.diag.arena = &j.arena;
    int code = wf_args_read(argc, argv, options, about, 1, 1, &j.arena, &j.args);
    if (code < 0) {
        j.folder = wf_args_text(&j.args, "--output");
        j.r.loss = wf_args_text(&j.args, "--loss");
        j.r.priors = wf_args_given(&j.args, "--priors");
        j.r.command = wf_arena_text(&j.arena, "windfirm");
        for (int i = 0; j.r.command && i < argc; i++)
            j.r.command = wf_arena_print(&j.arena, "%s %s", j.r.command, argv[i]);
        j.r.date = wf_run_date(&j.arena);
        enum wf_status s = j.r.command && j.r.date ? run(&j, wf_args_given(&j.args, "--quiet"), &e)
                                                   : wf_fail(&e, WF_ENOMEM, "no room for the command line");
        code = s ? wf_complain(&e) : interrupted ? 1 : 0;
    }
    wf_arena_free(&j.arena);
    return code;
}
