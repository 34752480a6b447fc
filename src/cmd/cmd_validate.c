/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/args.h"
#include "cmd/cmd.h"
#include "cmd/validate_fit.h"
#include "cmd/validate_print.h"
#include "study/validate.h"
#include <fts.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

struct run {
    bool order, verbose;
    struct wf_validate_tally tally;
    int code; /* worst exit code so far */
};

static void worse(struct run *r, int code)
{
    if (code > r->code) r->code = code;
}

/* One solver of one case. Returned: exit code of what kept it from running at all. */
static int run_solver(struct run *r, const struct wf_case *c, size_t k, struct wf_arena *work)
{
    struct wf_err e = { WF_OK, "" };
    struct wf_verdict v, mesh[WF_CASE_PIECES_MAX];
    wf_progress("%s: %s", c->file, c->name);
    enum wf_status status =
        c->shape == WF_SHAPE_FIT ? wf_validate_fit(c, work, &v, &e) : wf_case_run(c, k, 1, work, &v, &e);
    wf_progress(NULL);
    if (status) return wf_complain(&e);
    wf_validate_count(&r->tally, &v);
    wf_validate_print_case(&v, r->verbose);
    if (!r->order || !c->pieces || v.outcome == WF_SKIPPED) return 0;
    if (wf_case_order(c, k, work, mesh, &e)) return wf_complain(&e);
    wf_validate_print_order(c, mesh, r->verbose);
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
        wf_validate_print_file(&cases[0]);
        for (size_t i = 0; i < n; i++) run_case(r, &cases[i]);
    }
    wf_arena_free(&arena);
}

static int by_name(const FTSENT **a, const FTSENT **b) { return strcmp((*a)->fts_name, (*b)->fts_name); }

/* Every *.case below a folder, in order of name; a file as it is. Returned: how many were met. */
static size_t run_path(struct run *r, const char *path)
{
    char *const roots[] = { (char *)(void *)path, NULL }; /* fts does not write to it */
    size_t files = 0;
    FTS *walk = fts_open(roots, FTS_LOGICAL | FTS_NOCHDIR, by_name);
    if (!walk) return 0;
    for (FTSENT *f; (f = fts_read(walk));) {
        size_t n = f->fts_namelen;
        bool named = f->fts_level == FTS_ROOTLEVEL || (n > 5 && !strcmp(f->fts_name + n - 5, ".case"));
        if (f->fts_info != FTS_F || !named) continue;
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
        fprintf(stderr, "windfirm validate: %s: %s\n", path,
                stat(path, &s) ? "no such file or folder" : "no *.case file in it");
        worse(&r, 2);
    }
    wf_validate_print_tally(&r.tally);
    if (r.tally.outcome[WF_FAILED]) worse(&r, 1);
    wf_arena_free(&arena);
    return r.code;
}
