#include "cmd/tree_draw.h"
#include "cmd/study.h"
#include "grow/grow.h"
#include "load/drag.h"
#include "out/tree_picture.h"

static const struct wf_option options[] = {
    WF_TREE_OPTIONS,
    { .name = "--species",
      .letter = "-s",
      .kind = WF_OPTION_TEXT,
      .value = "SPECIES",
      .initial = "beech",
      .help = "radius of a stem whose model names none, names of the levels" },
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FILE",
      .initial = "tree.svg",
      .help = "the picture: .svg, .png or .pdf; many thousand segments are better as .png" },
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

static const char about[] =
    "  windfirm tree draw --model MODEL --species SPECIES -o FILE.svg\n"
    "  windfirm tree draw TREE -o FILE.png\n"
    "  A tree from the front and the side, coloured by branching level, with its parameters.";

static enum wf_status draw(const struct wf_args *g, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_model model;
    struct wf_species species;
    struct wf_tree tree;
    const char *path, *to = wf_args_text(g, "--output");
    enum wf_status s = wf_study_tree(g, g->n ? g->operand[0] : NULL, a, &model, &path, d, e);
    if (!s)
        s = wf_species_read(wf_shipped("species", wf_args_text(g, "--species"), a), &wf_laws, a, &species, d,
                            e);
    if (!s) s = wf_grow(&model, &species, a, &tree, d, e);
    if (!s) s = wf_tree_check(&tree, d, e);
    if (s) return s;
    const struct wf_tree_picture picture = { &tree, &model, &species };
    if ((s = wf_tree_picture_draw(&picture, to, e))) return s;
    if (!wf_args_given(g, "--quiet")) printf("%s: %zu segments -> %s\n", model.name, tree.n, to);
    return WF_OK;
}

int wf_tree_draw(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct wf_args args;
    struct wf_diag d = { .arena = &arena };
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, options, about, 0, 1, &arena, &args);
    if (code < 0) code = wf_study_tree_asked(&args, argv[0], args.n ? args.operand[0] : NULL);
    if (code < 0) {
        enum wf_status s = draw(&args, &arena, &d, &e);
        wf_print_findings(&d, wf_args_given(&args, "--quiet"));
        code = s ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}
