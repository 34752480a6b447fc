#include "cmd/pages.h"
#include "cmd/series_perform.h"
#include <stdio.h>
#include <string.h>

static const struct wf_option options[] = {
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .help = "where tables, frames and the page go [out/NAME]" },
    { .name = "--no-report", .kind = WF_OPTION_FLAG, .help = "write tables only" },
    WF_LANG_OPTION,
    { .name = "--no-vtk", .kind = WF_OPTION_FLAG, .help = "leave out the frames for ParaView" },
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

static const char about[] =
    "NAME is tang2012, feng1999, zhao2013 or a file of runs like models/papers/tang2012.yaml: species, "
    "model, "
    "wind, method of every run, in as many runs as wanted. 'windfirm papers schema' lists the keys.\n"
    "\n"
    "  windfirm papers tang2012 -o out/tang";

int wf_cmd_papers(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct wf_args g;
    struct wf_err e = { 0 };
    struct wf_series_plan plan;
    int code = wf_args_read(argc, argv, options, about, 1, 1, &arena, &g);
    if (code < 0 && !strcmp(g.operand[0], "schema")) {
        char *text = wf_series_plan_schema(&arena, &e);
        if (text) fputs(text, stdout);
        code = text ? 0 : wf_complain(&e);
    }
    if (code < 0) {
        struct wf_diag d = { .arena = &arena };
        const char *path = wf_shipped("models/papers", g.operand[0], &arena);
        enum wf_status s = wf_series_plan_read(path, &arena, &plan, &d, &e);
        wf_print_findings(&d, false);
        if (s) code = wf_complain(&e);
    }
    if (code < 0) {
        const char *asked = wf_args_text(&g, "--output");
        struct wf_series_job job = { .plan = &plan,
                                     .folder = asked ? asked : wf_arena_print(&arena, "out/%s", plan.key),
                                     .command = wf_series_typed(argc, argv, &arena),
                                     .language = wf_args_text(&g, "--lang"),
                                     .quiet = wf_args_given(&g, "--quiet"),
                                     .page = !wf_args_given(&g, "--no-report"),
                                     .vtk = !wf_args_given(&g, "--no-vtk") };
        code = wf_series_perform(&job, &arena);
    }
    wf_arena_free(&arena);
    return code;
}
