/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "grow/qsm_write.h"
#include "load/qsm_metrics.h"
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

struct import_options {
    struct wf_args args;
    const char *output; /* NULL: nothing is written                   */
    const char *to;     /* form to write; NULL: by the name of `output` */
    struct wf_import_asked import;
    const char *lang;
};

#define OPTIONS struct import_options
static const struct wf_option options[] = {
    TEXT("--output", output, "FILE", NULL,
         "write the tree: name.csv, name.txt (TreeQSM columns), name.mtg, name.mat (TreeQSM structure), "
         "name.vtk (ParaView); a folder for several",
         .letter = "-o"),
    CHOICE("--to", to, "FORM", "csv|txt|mtg|mat|vtk", NULL,
           "form to write, whatever the name's ending; in a folder it gives the ending [csv]"),
    WF_IMPORT_ROWS(import, NULL),
    WF_SPOKEN_ROW(lang),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "Read measured trees (TreeQSM text and .mat, SimpleForest, aRchi, rTwig, OpenAlea MTG, raycloudtools, "
    "PypeTree, SWC, treegraph, hand-measured and plain tables), repair and count what needs repair, and "
    "write them in one form. A file that cannot be read does not stop the others; the exit code is then 2.";

static bool is_folder(const char *path)
{
    struct stat s;
    size_t n = strlen(path);
    return (n && path[n - 1] == '/') || (stat(path, &s) == 0 && S_ISDIR(s.st_mode));
}

/* FOLDER/name.csv (or another ending) for a tree file. */
static const char *in_folder(const char *to, const char *path, const char *form, struct wf_arena *a)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    int n = dot && dot > name ? (int)(dot - name) : (int)strlen(name);
    bool slashed = to[strlen(to) - 1] == '/';
    return wf_arena_print(a, "%s%s%.*s.%s", to, slashed ? "" : "/", n, name, form ? form : "csv");
}

static size_t count_repairs(const struct wf_qsm *q)
{
    size_t n = 0;
    for (int k = 0; k < WF_REPAIR_COUNT; k++) n += wf_repair_rows[k].note ? 0 : q->repairs.count[k];
    return n;
}

static int import_file(const char *path, const struct import_options *import,
                       const struct wf_import_options *o)
{
    const char *to = import->output;
    bool quiet = import->args.quiet;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_qsm q;
    struct wf_qsm_metrics m;
    enum wf_status s = wf_import_read(path, o, &a, &q, &d, &e);
    wf_print_findings(&d, quiet);
    if (!s && to && is_folder(to)) {
        s = wf_mkdirs(to, &e);
        to = in_folder(to, path, import->to, &a);
        if (!s && !to) s = wf_fail(&e, WF_ENOMEM, "no memory for a file name");
    }
    if (!s && to) s = wf_qsm_write(&q, to, import->to, &e);
    if (!s && !quiet) {
        wf_qsm_measure(&q, &m);
        wf_show(stdout, "%s: %s, %zu cylinders, height %.2f m, dbh %.3f m, wood %.5g m3, %zu repairs%s%s\n",
                path, q.format, m.cylinders, m.height, m.dbh, m.volume, count_repairs(&q), to ? " -> " : "",
                to ? to : "");
    }
    int code = s ? wf_complain(&e) : 0;
    wf_arena_free(&a);
    return code;
}

/* Every file in turn; one that fails does not stop the rest. */
static int import_all(const struct import_options *import)
{
    const char *to = import->output;
    struct wf_import_options o = wf_import_asked_options(&import->import);
    int code = 0;
    if (!to && import->to) {
        wf_show(stderr, "windfirm import: --to: nothing is written without --output\n");
        return 2;
    }
    if (to && import->args.n > 1 && !is_folder(to)) {
        wf_show(stderr,
                "windfirm import: --output: '%s' is one file for %zu trees; name a folder, as in '%s/'\n", to,
                import->args.n, to);
        return 2;
    }
    for (size_t k = 0; k < import->args.n; k++) {
        int c = import_file(import->args.operand[k], import, &o);
        code = c > code ? c : code;
    }
    return code;
}

int wf_cmd_import(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct import_options o;
    int code = wf_args_read(argc, argv, options, about, 1, (size_t)argc, &arena, &o.args);
    if (code < 0) code = import_all(&o);
    wf_arena_free(&arena);
    return code;
}
