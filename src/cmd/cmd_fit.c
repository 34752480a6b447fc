/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm fit: calibrate a tree to what was measured on it. */
#include "base/interrupt.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option_groups.h"
#include "cmd/read_mat.h"
#include "data/species.h"
#include "out/fit_results.h"
#include "out/fitted_species.h"
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

struct fit_options {
    struct wf_args args;
    const char *data, *free; /* lists with commas; NULL: the calibration's */
    const char *loss;
    double loss_scale; /* [standard deviations]; NAN: the loss's own */
    size_t starts, bootstrap, seed;
    bool priors, no_profile, no_rival;
    struct wf_pages pages;
    const char *write, *output; /* NULL: nothing is written; folder */
};

static bool scale_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(!strcmp(((const struct fit_options *)options)->loss, "none"), why,
                            "with the loss 'none'");
}

static bool seed_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct fit_options *o = options;
    (void)row;
    return wf_option_unused(o->starts < 2 && !o->bootstrap, why, "without --starts above 1 or --bootstrap");
}

#define OPTIONS struct fit_options
static const struct wf_option options[] = {
    TEXTS("--data", data, "FILE[,FILE]", "CSV files of the tests that name none, in their order",
          .letter = "-d"),
    TEXTS("--free", free, "NAME[,NAME]",
          "parameters to fit, in place of the study's: level0.youngs_modulus, root.stiffness, "
          "each:root.stiffness, damping_ratio, ...",
          .letter = "-f"),
    CHOICE("--loss", loss, "NAME", "none|huber|cauchy|tukey", "none",
           "weight of outliers: none = plain least squares, or a robust loss"),
    NUMBER("--loss-scale", loss_scale, "NUMBER", NONE, NULL, 0.1, 100, NULL,
           "where the loss departs from squares, in standard deviations [1.345 huber, 2.385 cauchy, 4.685 "
           "tukey]",
           .unused = scale_unused),
    FLAG("--priors", priors, "the species table's ranges take part as normal distributions"),
    WHOLE("--starts", starts, 1, 1000, "1", "starting points tried, within a factor of 3 of the start"),
    WHOLE("--bootstrap", bootstrap, 0, 10000, "0", "resampled data sets for intervals by the bootstrap"),
    WHOLE("--seed", seed, 0, 9007199254740992.0, "1", "of starts and bootstrap", .unused = seed_unused),
    FLAG("--no-profile", no_profile, "no intervals by profile likelihood"),
    FLAG("--no-rival", no_rival, "no second fit with the root the other way"),
    TEXT("--write", write, "FILE", NULL, "write the species table with the fitted values"),
    TEXT("--output", output, "FOLDER", "out/fit", "where results, tables, plots and pages go",
         .letter = "-o"),
    WF_PAGE_ROWS("--no-report", pages, "results and tables only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "STUDY names trees, tests on them and sensors ('windfirm schema fit' shows its keys); the engine's "
    "answer is fitted to the "
    "readings. Estimates come with 95 % intervals by covariance and by profile likelihood, with what the "
    "data do not determine, and beside a fit with the root the other way (clamped or flexible).\n"
    "\n"
    "  windfirm fit models/field/sample_pull.yaml --free level0.youngs_modulus,root.stiffness\n"
    "  windfirm fit models/field/sample_pull.yaml --loss cauchy --write mine.yaml";

/* ---- What is printed on a terminal ---- */

static void print_range(FILE *to, double low, double high, double factor, const char *none)
{
    if (isnan(low) && isnan(high))
        wf_show(to, "  %-21s", none);
    else if (isnan(low))
        wf_show(to, "  below %-15.4g", high * factor);
    else if (isnan(high))
        wf_show(to, "  above %-15.4g", low * factor);
    else {
        char text[48];
        snprintf(text, sizeof text, "%.4g to %.4g", low * factor, high * factor);
        wf_show(to, "  %-21s", text);
    }
}

static void print_parameters(FILE *to, const struct wf_fit *f)
{
    bool resampled = f->resampled >= 20;
    wf_show(to, "%-34s %12s %-9s  %-21s  %-21s%s\n", "parameter", "estimate", "", "95 % by covariance",
            "95 % by profile", resampled ? "  95 % by bootstrap" : "");
    for (size_t k = 0; k < f->params; k++) {
        const struct wf_estimate *q = &f->estimate[k];
        double factor;
        const char *unit = wf_param_unit(f->x, &f->param[k], &factor);
        wf_show(to, "%-34s %12.5g %-9s", f->param[k].name, q->value * factor, unit);
        print_range(to, q->low, q->high, factor, "-");
        print_range(to, q->profile_low, q->profile_high, factor, q->profiled ? "no limit" : "-");
        if (resampled) print_range(to, q->resampled_low, q->resampled_high, factor, "-");
        wf_show(to, "%s\n", q->at_low ? "  AT LOWER BOUND" : q->at_high ? "  AT UPPER BOUND" : "");
    }
}

static void print_correlations(FILE *to, const struct wf_fit *f)
{
    if (f->free < 2) return;
    wf_show(to, "\ncorrelation of the estimates\n");
    for (size_t i = 0; i < f->free; i++) {
        wf_show(to, "%-34s", f->param[i].name);
        for (size_t k = 0; k <= i; k++) wf_show(to, " %6.3f", f->correlation[i * f->params + k]);
        wf_show(to, "\n");
    }
}

static void print_sensors(FILE *to, const struct wf_fit *f)
{
    wf_show(to, "\n%-30s %8s %12s %12s  neighbours\n", "sensor", "readings", "sigma", "rms residual");
    for (size_t i = 0; i < f->groups; i++) {
        const struct wf_fit_group *g = &f->group[i];
        const struct wf_fit_test *t = &f->x->test[g->test];
        const struct wf_sensor_row *r = &wf_sensor_rows[t->sensor[g->sensor].kind];
        char name[64];
        snprintf(name, sizeof name, "%.30s %.30s", t->name, t->sensor[g->sensor].name);
        wf_show(to, "%-30s %8zu %12.4g %12.4g  %5.2f  [%s]%s\n", name, g->n, g->sigma * r->factor,
                g->rms * r->factor, g->correlation, r->unit,
                t->sensor[g->sensor].estimated ? ", sigma from the scatter" : "");
    }
}

static void print_fit(FILE *to, const struct wf_fit_results *of)
{
    const struct wf_fit *f = &of->fit;
    bool bound = false;
    wf_show(to, "%s\n%zu reading%s in %zu test%s, %zu parameter%s%s\n\n", of->calibration.name, f->x->data,
            f->x->data == 1 ? "" : "s", f->x->tests, f->x->tests == 1 ? "" : "s", f->params,
            f->params == 1 ? "" : "s", f->params > f->free ? " (offsets and drifts included)" : "");
    for (size_t k = 0; k < of->x.trees; k++)
        if (of->x.tree[k].tree.standing)
            wf_show(to, "%s stands in its shape under its weight: readings count from there\n\n",
                    of->x.tree[k].name);
    print_parameters(to, f);
    for (size_t k = 0; k < of->x.tests; k++)
        if (of->input[k].swung) {
            const struct wf_ring_down *s = &of->input[k].sway;
            wf_show(to, "\n%s: %.4f +- %.4f Hz, damping %.2f +- %.2f %%, %.1f %% of the variance explained",
                    of->x.test[k].name, s->frequency, 1.96 * s->frequency_sd, 100 * s->damping,
                    196 * s->damping_sd, 100 * s->explained);
        }
    if (of->x.tests && of->input[0].swung) wf_show(to, "\n");
    print_correlations(to, f);
    print_sensors(to, f);
    for (size_t k = 0; k < f->free; k++) bound |= f->estimate[k].at_low || f->estimate[k].at_high;
    if (f->freedom)
        wf_show(to, "\nreduced chi-square %.4g with %zu degree%s of freedom%s\n", f->reduced, f->freedom,
                f->freedom == 1 ? "" : "s",
                f->sigma_estimated ? " (1 by construction where sigmas are estimated)" : "");
    else
        wf_show(
            to,
            "\nreduced chi-square - with 0 degrees of freedom: as many parameters as readings, so nothing "
            "tests the fit\n");
    if (f->loose_n == 0 && f->freedom)
        wf_show(to, "the data determine every parameter%s\n", bound ? " that did not end on a bound" : "");
    for (size_t i = 0; i < f->loose_n; i++) wf_show(to, "NOT DETERMINED: %s\n", f->loose[i].text);
    if (of->rival.made) {
        const struct wf_fit *r = &of->rival.fit;
        wf_show(to, "\nthe same with a %s:", of->rival.text);
        for (size_t k = 0; k < r->free; k++) {
            double factor;
            const char *unit = wf_param_unit(r->x, &r->param[k], &factor);
            wf_show(to, "%s %s %.5g%s%s%s", k ? "," : "", r->param[k].name, r->estimate[k].value * factor,
                    *unit ? " " : "", unit,
                    r->estimate[k].at_high || r->estimate[k].at_low ? " (at its bound)"
                    : isnan(r->estimate[k].low)                     ? " (not determined)"
                                                                    : "");
        }
        if (!isnan(of->rival.aicc) && !isnan(of->rival.own))
            wf_show(to, "\nAICc %.2f here, %.2f there: the data %s\n", of->rival.own, of->rival.aicc,
                    fabs(of->rival.own - of->rival.aicc) < 2 ? "do not decide between them"
                    : of->rival.own < of->rival.aicc         ? "prefer this fit"
                                                             : "prefer the other");
        else
            wf_show(to, "\ntoo few readings to compare the two\n");
    }
    if (of->calibration.reference) wf_show(to, "\nfor comparison: %s\n", of->calibration.reference);
}

/* ---- The fit ---- */

struct fit_job {
    struct wf_arena arena;
    const struct fit_options *options;
    const char *folder;
    struct wf_fit_results r;
};

static bool look_at_interrupt(void *ctx, size_t iteration, double cost)
{
    (void)ctx, (void)iteration, (void)cost;
    return wf_interrupted() != 0;
}

static struct wf_fit_options library_options(const struct fit_options *asked)
{
    static const char *const words[] = { "none", "huber", "cauchy", "tukey" };
    struct wf_fit_options o;
    wf_fit_options_default(&o);
    for (int k = 0; k < 4; k++)
        if (!strcmp(asked->loss, words[k])) o.loss = (enum wf_loss)k;
    o.loss_scale = asked->loss_scale;
    o.priors = asked->priors;
    o.profile = !asked->no_profile;
    o.starts = asked->starts;
    o.resamples = asked->bootstrap;
    o.seed = asked->seed;
    o.progress = look_at_interrupt;
    return o;
}

static enum wf_status note_input(struct fit_job *j, const char *role, const char *path, struct wf_err *e)
{
    for (size_t i = 0; i < j->r.files; i++)
        if (!strcmp(j->r.file[i].path, path)) return WF_OK;
    return wf_input_file_note(role, path, &j->arena, &j->r.file[j->r.files++], e);
}

static enum wf_status build_experiment(struct fit_job *j, struct wf_err *e)
{
    const char *names = j->options->data, *list[64];
    char *rest = NULL, *copy = names ? wf_arena_text(&j->arena, names) : NULL;
    struct wf_fit_build b = {
        .calibration = &j->r.calibration, .share = wf_share(), .data = list, .mat = wf_read_mat
    };
    for (char *p = copy ? strtok_r(copy, ",", &rest) : NULL; p && b.datas < 64;
         p = strtok_r(NULL, ",", &rest))
        list[b.datas++] = p;
    enum wf_status s =
        wf_calibration_read(j->options->args.operand[0], &j->arena, &j->r.calibration, &j->r.diag, e);
    if (s) return s;
    j->r.input = WF_TAKE(&j->arena, j->r.calibration.tests, struct wf_fit_input);
    j->r.file =
        WF_TAKE(&j->arena, 1 + 2 * j->r.calibration.trees + 3 * j->r.calibration.tests, struct wf_input_file);
    if (!j->r.input || !j->r.file) return wf_fail(e, WF_ENOMEM, "not enough memory for the study");
    s = wf_fit_build(&b, &j->arena, &j->r.diag, &j->r.x, j->r.input, e);
    if (!s) s = note_input(j, "study", j->options->args.operand[0], e);
    for (size_t k = 0; k < j->r.x.trees && !s; k++) {
        s = note_input(j, "species", j->r.x.tree[k].species->file, e);
        if (!s && j->r.x.tree[k].file) s = note_input(j, "tree", j->r.x.tree[k].file, e);
    }
    for (size_t k = 0; k < j->r.x.tests && !s; k++) {
        const struct wf_fit_input *in = &j->r.input[k];
        if (in->path) s = note_input(j, "data", in->path, e);
        if (!s && in->profile) s = note_input(j, "profile", in->profile, e);
        if (!s && in->ground) s = note_input(j, "ground", in->ground, e);
    }
    return s ? s
             : wf_fit_params(&j->r.calibration, j->options->free, &j->r.x, false, &j->arena, &j->r.param,
                             &j->r.params, e);
}

/* Second fit with the opposite root: clamped if the first was elastic, and vice versa. If the data do not
 * allow it, it is omitted; the requested fit is unaffected. Errors: WF_ENOMEM. */
static enum wf_status fit_rival(struct fit_job *j, struct wf_fit_options o, struct wf_err *why)
{
    struct wf_fit_param *p = WF_TAKE(&j->arena, j->r.params + j->r.x.trees + 1, struct wf_fit_param);
    struct wf_diag d = { .arena = &j->arena };
    struct wf_err e = { 0 };
    size_t n = 0, nuisance = 0;
    bool had = false, tested = false;
    for (size_t k = 0; k < j->r.x.tests; k++)
        for (size_t s = 0; s < j->r.x.test[k].sensors; s++)
            tested |= j->r.x.test[k].sensor[s].kind != WF_SENSOR_DAMPING;
    if (!p) return wf_fail(why, WF_ENOMEM, "not enough memory for the second fit");
    if (!tested) return WF_OK;
    for (size_t k = 0; k < j->r.params; k++) had |= j->r.param[k].quantity == WF_FIT_ROOT;
    for (size_t k = 0; k < j->r.params; k++) {
        if (wf_param_nuisance(&j->r.param[k]))
            nuisance++;
        else if (j->r.param[k].quantity != WF_FIT_ROOT)
            p[n++] = j->r.param[k];
    }
    if (!had && wf_param_add(&j->r.x, j->r.x.trees > 1 ? "each:root.stiffness" : "root.stiffness", &j->arena,
                             p, &n, &e))
        return e.code == WF_ENOMEM ? wf_fail(why, e.code, "%s", e.text) : WF_OK;
    if (!n) return WF_OK;
    for (size_t k = j->r.params - nuisance; k < j->r.params; k++) p[n++] = j->r.param[k];
    o.profile = false, o.resamples = 0, o.starts = 1;
    struct wf_fit_rival *r = &j->r.rival;
    r->text = had ? "clamped root" : "flexible root plate";
    double *stiffness = WF_TAKE(&j->arena, j->r.x.trees, double);
    if (!stiffness) return wf_fail(why, WF_ENOMEM, "not enough memory for the second fit");
    for (size_t k = 0; k < j->r.x.trees; k++) {
        double *of = j->r.x.tree[k].options.root_stiffness;
        stiffness[k] = of[0];
        if (had) of[0] = of[1] = 0; /* clamped, also where the calibration gives a stiffness */
    }
    enum wf_status s = wf_fit_run(&j->r.x, p, n, &o, &j->arena, &d, &r->fit, &e);
    for (size_t k = 0; k < j->r.x.trees; k++)
        j->r.x.tree[k].options.root_stiffness[0] = j->r.x.tree[k].options.root_stiffness[1] = stiffness[k];
    if (s == WF_ENOMEM) return wf_fail(why, s, "%s", e.text);
    if (s || r->fit.stopped) return WF_OK;
    const struct wf_fit *rich = had ? &j->r.fit : &r->fit;
    r->aicc = wf_fit_aicc(&r->fit, rich);
    r->own = wf_fit_aicc(&j->r.fit, rich);
    r->made = true;
    return WF_OK;
}

/* Fit the tree, and unless --no-rival the second model too. */
static enum wf_status fit_tree(struct fit_job *j, struct wf_err *e)
{
    struct wf_fit_options o = library_options(j->options);
    enum wf_status s = wf_fit_run(&j->r.x, j->r.param, j->r.params, &o, &j->arena, &j->r.diag, &j->r.fit, e);
    if (!s && !wf_interrupted() && !j->options->no_rival) s = fit_rival(j, o, e);
    wf_progress_clear();
    return s;
}

/* Results, figures and pages; unless interrupted also the fitted species table. */
static enum wf_status write_results(struct fit_job *j, struct wf_run_folder *f, bool quiet, struct wf_err *e)
{
    /* the species table of an interrupted fit would be mistaken for a completed one's */
    const char *write = wf_interrupted() ? NULL : j->options->write;
    bool report = !j->options->pages.none;
    enum wf_status s = wf_fit_results_write(&j->r, f->stage, e);
    if (!s && write) s = wf_fit_species_write(&j->r, write, e);
    if (!s) s = wf_results_end(f, &j->options->pages, &j->arena, NULL, e);
    if (!s && !quiet)
        wf_show(stdout, "\nResults, tables%s: %s\n", report ? ", plots and pages" : "", j->folder);
    if (!s && !quiet && write) wf_show(stdout, "Species table: %s\n", write);
    return s;
}

static enum wf_status calibrate(struct fit_job *j, bool quiet, struct wf_err *e)
{
    const char *write = j->options->write;
    struct wf_run_folder f = { 0 };
    enum wf_status s = build_experiment(j, e);
    if (!s) s = wf_results_begin(&f, j->folder, j->options->pages.none ? NULL : "calibration", e);
    if (!s) s = fit_tree(j, e);
    if (!s && wf_interrupted() && !j->r.fit.stopped)
        wf_diag_warn(&j->r.diag, "stopped", "interrupted before the comparison with the root the other way");
    if (!s && wf_interrupted() && write)
        wf_diag_warn(&j->r.diag, "stopped", "interrupted: %s is not written", write);
    if (!s && !quiet) print_fit(stdout, &j->r);
    fflush(stdout);
    wf_print_findings(&j->r.diag, quiet);
    if (!s) s = write_results(j, &f, quiet, e);
    wf_run_abandon(&f);
    return s;
}

int wf_cmd_fit(int argc, char **argv)
{
    struct fit_options o;
    struct fit_job j = { .options = &o };
    struct wf_err e = { 0 };
    j.r.diag.arena = &j.arena;
    int code = wf_args_read(argc, argv, options, about, 1, 1, &j.arena, &o.args);
    if (code < 0) {
        j.folder = o.output;
        j.r.command = wf_command_line(argc, argv, &j.arena);
        j.r.loss = o.loss, j.r.priors = o.priors;
        j.r.date = wf_run_date(&j.arena);
        enum wf_status s = j.r.command && j.r.date
                               ? calibrate(&j, o.args.quiet, &e)
                               : wf_fail(&e, WF_ENOMEM, "not enough memory for the command line");
        code = s ? wf_complain(&e) : 0;
    }
    wf_arena_free(&j.arena);
    return code;
}
