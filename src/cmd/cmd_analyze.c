/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm analyze and windfirm compare: what a steady wind does to one or several species on one tree. */
#include "cmd/analyze_run.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include <string.h>

/* With --scan-model all, model 1 is analysed first; then the others. */
static int take_all_models(struct wf_analyze_work *w, const char *command)
{
    const char **asked = &w->options.tree.scan.scan_model;
    w->all_models = *asked && !strcmp(*asked, "all");
    if (!w->all_models) return -1;
    *asked = "1";
    if (!strcmp(w->options.preset, "corrected")) return -1;
    wf_show(stderr, "windfirm %s: --scan-model all: not with --preset\n", command);
    return 2;
}
/* A whole run: read, analyse, print, write, draw. Given: the command line as typed, between low and high
 * species. Returned: exit code. */
static int analyze_or_compare(int argc, char **argv, const char *about, size_t low, size_t high)
{
    struct wf_analyze_work w = { 0 };
    struct wf_err e = { 0 };
    (void)clock_gettime(CLOCK_REALTIME, &w.started);
    int code = wf_args_read(argc, argv, wf_analyze_options, about, low, high, &w.arena, &w.options.args);
    if (code < 0) code = wf_tree_asked_check(&w.options.tree, argv[0], NULL);
    if (code < 0) code = take_all_models(&w, argv[0]);
    if (code < 0 && !w.options.wind.n) {
        wf_show(stderr, "windfirm %s: --wind is needed, for example --wind 10,15,25\n", argv[0]);
        code = 2;
    }
    if (code < 0) {
        const char *asked = w.options.output;
        w.folder = asked ? asked : wf_arena_print(&w.arena, "out/%s", argv[0]);
        code = w.folder && wf_analyze_run(&w, argc, argv, &e) == WF_OK ? 0 : wf_complain(&e);
        wf_run_abandon(&w.results);
    }
    wf_arena_free(&w.arena);
    return code;
}

int wf_cmd_analyze(int argc, char **argv)
{
    static const char about[] =
        "SPECIES is a species table, a file or the name of a shipped one ('windfirm species list'). The tree "
        "bends until its stiffness balances wind and weight, and the wind is taken on the bent shape: once "
        "in "
        "the mean wind, once at the peak of the load of gusts (--peak), which decides what breaks.\n"
        "\n"
        "  windfirm analyze species/moso_bamboo.yaml --model models/moso_culm.yaml --wind 5:40:1";
    return analyze_or_compare(argc, argv, about, 1, 1);
}

int wf_cmd_compare(int argc, char **argv)
{
    static const char about[] = "Every species is grown on the same model, so that a comparison shows "
                                "material and section alone (a model "
                                "may leave the base radius to the species).\n"
                                "\n"
                                "  windfirm compare species/moso_bamboo.yaml species/weeping_willow.yaml \\\n"
                                "      --model models/culm.yaml --wind 10,15,25 -o out/mine";
    return analyze_or_compare(argc, argv, about, 2, 32);
}
