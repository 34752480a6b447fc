/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm validate: cases compared with their sources. */
#include "base/progress.h"
#include "cases/measure.h"
#include "cases/read.h"
#include "cases/run.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/read_mat.h"
#include <fts.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

struct tally {
    size_t of_kind[WF_CASE_KIND_COUNT][WF_OUTCOME_COUNT], outcome[WF_OUTCOME_COUNT], checks;
};
enum { SHORT_LIST = 12, WORST = 3 };

static const char *const outcome_word[WF_OUTCOME_COUNT] = { "passed", "FAILED", "skipped" };

static void count_verdict(struct tally *t, const struct wf_verdict *v)
{
    if (v->of->kind >= 0) t->of_kind[v->of->kind][v->outcome]++;
    t->outcome[v->outcome]++;
    t->checks += v->n;
}

/* Heading of a file: its title and source, from its first case. */
static void print_file(const struct wf_case *first)
{
    wf_show(stdout, "\n%s\n", first->file);
    if (first->title) wf_show(stdout, "  %s\n", first->title);
    wf_show(stdout, "  source: %s\n", first->source);
}

static double used(const struct wf_check *c) { return isnan(c->error) ? HUGE_VAL : c->error / c->allowed; }

/* Whether a line is among the few closest to their tolerance. */
static bool among_worst(const struct wf_verdict *v, size_t i)
{
    size_t worse = 0;
    for (size_t k = 0; k < v->n && worse < WORST; k++)
        worse +=
            used(&v->check[k]) > used(&v->check[i]) || (k < i && used(&v->check[k]) == used(&v->check[i]));
    return worse < WORST;
}

static void print_check(const struct wf_check *c)
{
    char what[160], margin[32] = "exact", relative[32] = "-";
    double f = c->want->unit_factor;
    wf_want_print(c->want, c->component, what, sizeof what);
    if (c->error > 0.0) (void)snprintf(margin, sizeof margin, "%.2g", c->allowed / c->error);
    if (isnan(c->error)) (void)snprintf(margin, sizeof margin, "none");
    if (!isnan(c->relative)) (void)snprintf(relative, sizeof relative, "%.1e", c->relative);
    wf_show(stdout, "    %-30s %20.12g %20.12g %-6s %9s %9s%s\n", what, c->wanted / f, c->got / f,
            c->want->unit, relative, margin, c->passed ? "" : "  FAILED");
}

/* Outcome and one line per wanted value: wanted, got, error, margin (allowed error / error). Of a long list
 * only what failed and the three closest to their tolerance, unless `all`. */
static void print_case(const struct wf_verdict *v, bool all)
{
    const struct wf_case *c = v->of;
    size_t shown = 0;
    wf_show(stdout, "  %s [%s, %s]: %s", c->name, v->solver, wf_case_kind_name((enum wf_case_kind)c->kind),
            outcome_word[v->outcome]);
    if (v->n)
        wf_show(stdout, ", %zu value%s, the worst uses %.2g of its tolerance", v->n, v->n == 1 ? "" : "s",
                v->worst);
    wf_show(stdout, "\n");
    if (v->why) wf_show(stdout, "    %s\n", v->why);
    if (all && c->note) wf_show(stdout, "    %s\n", c->note);
    if (!v->n) return;
    wf_show(stdout, "    %-30s %20s %20s %-6s %9s %9s\n", "quantity", "wanted", "got", "unit", "rel.error",
            "margin");
    bool full = all || v->n <= SHORT_LIST;
    for (size_t i = 0; i < v->n; i++)
        if (full || !v->check[i].passed || among_worst(v, i)) print_check(&v->check[i]), shown++;
    if (shown < v->n)
        wf_show(stdout, "    and %zu more within tolerance (--verbose lists them)\n", v->n - shown);
}

static bool all_ran(const struct wf_case *c, const struct wf_verdict *mesh)
{
    for (size_t i = 0; i < c->pieces; i++) {
        if (!mesh[i].why) continue;
        wf_show(stdout, "    order of convergence: %zu parts a row: %s\n", c->piece[i], mesh[i].why);
        return false;
    }
    return true;
}

/* Errors on each mesh and the observed order of convergence between neighbouring meshes. */
static void print_order(const struct wf_case *c, const struct wf_verdict *mesh, bool all)
{
    if (!all_ran(c, mesh)) return;
    size_t lines = all || mesh[0].n <= SHORT_LIST ? mesh[0].n : SHORT_LIST;
    wf_show(
        stdout,
        "    order of convergence: error with every row in so many elements; in brackets the order observed\n"
        "    %-30s",
        "parts");
    for (size_t i = 0; i < c->pieces; i++) wf_show(stdout, " %15zu", c->piece[i]);
    wf_show(stdout, "\n");
    for (size_t k = 0; k < lines; k++) {
        char what[160];
        wf_want_print(mesh[0].check[k].want, mesh[0].check[k].component, what, sizeof what);
        wf_show(stdout, "    %-30s", what);
        for (size_t i = 0; i < c->pieces; i++) {
            double now = mesh[i].check[k].error / mesh[i].check[k].want->unit_factor;
            double before = i ? mesh[i - 1].check[k].error / mesh[i - 1].check[k].want->unit_factor : 0.0;
            char order[24] = "";
            if (now > 0.0 && before > 0.0)
                (void)snprintf(order, sizeof order, "(%.2f)",
                               log(before / now) / log((double)c->piece[i] / (double)c->piece[i - 1]));
            wf_show(stdout, " %8.1e%7s", now, order);
        }
        wf_show(stdout, "\n");
    }
}

/* Counts by kind, and the last line "N passed, N failed, N skipped". */
static void print_tally(const struct tally *t)
{
    wf_show(stdout, "\n%-34s %8s %8s %8s\n", "kind", "passed", "failed", "skipped");
    for (int k = 0; k < WF_CASE_KIND_COUNT; k++) {
        const size_t *n = t->of_kind[k];
        if (n[WF_PASSED] + n[WF_FAILED] + n[WF_SKIPPED] == 0) continue;
        char kind[64];
        (void)snprintf(kind, sizeof kind, "%s%s", wf_case_kind_name((enum wf_case_kind)k),
                       k == WF_CASE_REGRESSION ? " (no evidence)" : "");
        wf_show(stdout, "%-34s %8zu %8zu %8zu\n", kind, n[WF_PASSED], n[WF_FAILED], n[WF_SKIPPED]);
    }
    wf_show(stdout, "%zu values compared\n%zu passed, %zu failed, %zu skipped\n", t->checks,
            t->outcome[WF_PASSED], t->outcome[WF_FAILED], t->outcome[WF_SKIPPED]);
}

struct run {
    bool order, verbose;
    struct tally tally;
    int code; /* worst exit code so far */
};

static void worse(struct run *r, int code)
{
    if (code > r->code) r->code = code;
}

/* One solver of one case. Returned: 0, or the exit code of the error that prevented the run. */
static int run_solver(struct run *r, const struct wf_case *c, size_t k, struct wf_arena *work)
{
    struct wf_err e = { WF_OK, "" };
    struct wf_verdict v, mesh[WF_CASE_PIECES_MAX];
    wf_stage_begin(0, false, "%s: %s", c->file, c->name);
    enum wf_status status = c->shape == WF_SHAPE_FIT ? wf_case_fit(c, wf_share(), wf_read_mat, work, &v, &e)
                                                     : wf_case_run(c, k, 1, work, &v, &e);
    wf_progress_clear();
    if (status) return wf_complain(&e);
    count_verdict(&r->tally, &v);
    print_case(&v, r->verbose);
    if (!r->order || !c->pieces || v.outcome == WF_SKIPPED) return 0;
    if (wf_case_order(c, k, work, mesh, &e)) return wf_complain(&e);
    print_order(c, mesh, r->verbose);
    return 0;
}

static void run_case(struct run *r, const struct wf_case *c)
{
    for (size_t k = 0; k < (c->solvers ? c->solvers : 1); k++) {
        struct wf_arena work = { 0 };
        worse(r, run_solver(r, c, k, &work));
        wf_arena_free(&work);
    }
}

static void run_file(struct run *r, const char *path)
{
    struct wf_arena arena = { 0 };
    struct wf_diag d = { .arena = &arena };
    struct wf_err e = { WF_OK, "" };
    struct wf_case *cases;
    size_t n;
    enum wf_status status = wf_case_read(path, &arena, &d, &cases, &n, &e);
    if (status) {
        if (d.errors)
            wf_print_findings(&d, false);
        else
            (void)wf_complain(&e);
        worse(r, wf_exit_code(status));
    } else {
        print_file(&cases[0]);
        for (size_t i = 0; i < n; i++) run_case(r, &cases[i]);
    }
    wf_arena_free(&arena);
}

static int by_name(const FTSENT **a, const FTSENT **b) { return strcmp((*a)->fts_name, (*b)->fts_name); }

/* Every *.case below a folder, in order of name; a file as it is. Returned: number of files found. */
static size_t run_path(struct run *r, const char *path)
{
    char *const roots[] = { (char *)(void *)path, NULL }; /* fts does not write to it */
    size_t files = 0;
    FTS *walk = fts_open(roots, FTS_LOGICAL | FTS_NOCHDIR, by_name);
    if (!walk) return 0;
    for (FTSENT *f; (f = fts_read(walk));) {
        size_t n = f->fts_namelen;
        bool named = f->fts_level == FTS_ROOTLEVEL || (n > 5 && !strcmp(f->fts_name + n - 5, ".case"));
        bool piped = f->fts_info == FTS_DEFAULT && f->fts_level == FTS_ROOTLEVEL;
        if ((f->fts_info != FTS_F && !piped) || !named) continue;
        run_file(r, f->fts_path);
        files++;
    }
    fts_close(walk);
    return files;
}

struct validate_options {
    struct wf_args args;
    bool order, verbose;
};

#define OPTIONS struct validate_options
static const struct wf_option options[] = {
    FLAG("--order", order,
         "also refine the mesh where a case asks for it, and print the observed order of convergence"),
    FLAG("--verbose", verbose, "every wanted value, not only the worst of long lists", .letter = "-v"),
    { 0 },
};

int wf_cmd_validate(int argc, char **argv)
{
    static const char about[] =
        "Without a path: every case that is shipped. A path is a case file or a folder of them. The format "
        "is described in docs/validation-cases.md. A case whose large tree file is not there is skipped; "
        "WINDFIRM_REFERENCE can name the folder that holds it.";
    struct wf_arena arena = { 0 };
    struct validate_options o;
    int code = wf_args_read(argc, argv, options, about, 0, 1000, &arena, &o.args);
    if (code >= 0) {
        wf_arena_free(&arena);
        return code;
    }
    struct run r = { .order = o.order, .verbose = o.verbose };
    const char *shipped = wf_arena_print(&arena, "%s/validation", wf_share());
    size_t paths = o.args.n ? o.args.n : 1;
    for (size_t i = 0; i < paths && shipped; i++) {
        const char *path = o.args.n ? o.args.operand[i] : shipped;
        if (run_path(&r, path)) continue;
        struct stat s;
        wf_show(stderr, "windfirm validate: %s: %s\n", path,
                stat(path, &s) ? "no such file or folder" : "no *.case file in it");
        worse(&r, 2);
    }
    print_tally(&r.tally);
    if (r.tally.outcome[WF_FAILED]) worse(&r, 1);
    wf_arena_free(&arena);
    return r.code;
}
