#include "base/near.h"
#include "cmd/import_options.h"
#include "cmd/tree_draw.h"
#include "cmd/tree_print.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct wf_option options[] = {
    WF_IMPORT_OPTIONS,
    { .name = "--joint",
      .kind = WF_OPTION_CHOICE,
      .value = "HOW",
      .initial = "axis",
      .choices = "axis|bridge",
      .help = "how branches are held in the analysis: where they leave the parent's axis, or at its end" },
    { .name = "--species",
      .letter = "-s",
      .kind = WF_OPTION_TEXT,
      .value = "SPECIES",
      .help = "take density and leaves from this species table" },
    { .name = "--density",
      .kind = WF_OPTION_NUMBER,
      .value = "DENSITY",
      .dimension = WF_DIM_DENSITY,
      .unit = "kg/m3",
      .low = 1,
      .high = 3000,
      .help = "of the wood as it stands, for the mass" },
    { .name = "--leaf-area",
      .kind = WF_OPTION_NUMBER,
      .value = "AREA",
      .dimension = WF_DIM_AREA,
      .unit = "m2",
      .low = 0,
      .high = 1e5,
      .help = "one-sided leaf area of the whole tree" },
    { .name = "--csv", .kind = WF_OPTION_FLAG, .help = "one line a tree, with a header, for many trees" },
    { .name = "--quiet",
      .letter = "-q",
      .kind = WF_OPTION_FLAG,
      .help = "no repairs and notes, only the figures" },
    { 0 },
};

static const char about[] =
    "  windfirm tree info FILE...\n"
    "  Size of measured trees: height, dbh, wood, surface, sail, branches, and what had to be repaired.\n"
    "  A file that cannot be read does not stop the others; the exit code is then 2.";

struct ask {
    const struct wf_args *args;
    struct wf_import_options import;
    enum wf_joint joint;
    struct wf_tree_wear wear;
};

/* Repairs stand on the page by kind; only single rows need a line of their own. */
static void rows_left_out(const struct wf_diag *d, bool quiet)
{
    char line[2048];
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->severity == WF_ERROR ||
            (!quiet && f->code && (!strcmp(f->code, "row-left-out") || !strcmp(f->code, "thick-stem"))))
            fprintf(stderr, "%s\n", wf_finding_print(f, line, sizeof line));
}

static enum wf_status one(const char *path, const struct ask *k, struct wf_arena *a, struct wf_err *e)
{
    bool quiet = wf_args_given(k->args, "--quiet");
    struct wf_diag d = { .arena = a };
    struct wf_qsm q;
    struct wf_qsm_model m;
    enum wf_status s = wf_import_read(path, &k->import, a, &q, &d, e);
    if (!s) s = wf_qsm_to_tree(&q, k->joint, a, &m, e);
    if (!s && wf_args_given(k->args, "--csv"))
        wf_tree_table_line(stdout, path, &q, &m, &k->wear);
    else if (!s)
        wf_tree_print_page(stdout, path, &q, &m, &k->wear);
    rows_left_out(&d, quiet);
    return s;
}

static int info(struct ask *k, struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    struct wf_err e = { 0 };
    struct wf_species species;
    const char *name = wf_args_text(k->args, "--species");
    int worst = 0;
    k->wear.density = wf_args_number(k->args, "--density");
    k->wear.leaf_area = wf_args_number(k->args, "--leaf-area");
    if (name) {
        enum wf_status s = wf_species_read(wf_shipped("species", name, a), a, &species, &d, &e);
        wf_print_findings(&d, false);
        if (s) return wf_complain(&e);
        k->wear.species = &species;
    }
    if (wf_args_given(k->args, "--csv")) wf_tree_table_head(stdout);
    for (size_t i = 1; i < k->args->n; i++) {
        struct wf_arena tree = { 0 };
        e = (struct wf_err){ 0 };
        int code = one(k->args->operand[i], k, &tree, &e) ? wf_complain(&e) : 0;
        worst = code > worst ? code : worst;
        fflush(stdout);
        wf_arena_free(&tree);
    }
    return worst;
}

int wf_cmd_tree(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct wf_args args;
    if (argc > 1 && !strcmp(argv[1], "draw")) {
        static char name[] = "tree draw";
        argv[1] = name;
        return wf_tree_draw(argc - 1, argv + 1);
    }
    int code = wf_args_read(argc, argv, options, about, 2, (size_t)argc, &arena, &args);
    if (code < 0 && strcmp(args.operand[0], "info")) {
        static const char *const words[] = { "info", "draw" };
        const char *near = wf_nearest(args.operand[0], words, 2);
        fprintf(stderr,
                "windfirm tree: '%s' is not known%s%s%s; it is: windfirm tree info FILE..., windfirm tree "
                "draw\n",
                args.operand[0], near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
        code = 2;
    }
    if (code < 0) {
        struct ask k = { .args = &args, .import = wf_import_typed(&args) };
        k.joint = strcmp(wf_args_text(&args, "--joint"), "axis") ? WF_JOINT_BRIDGE : WF_JOINT_AXIS;
        code = info(&k, &arena);
    }
    wf_arena_free(&arena);
    return code;
}
