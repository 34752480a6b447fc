/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option_groups.h"
#include "out/report.h"
#include <stdio.h>
#include <string.h>

struct report_options {
    struct wf_args args;
    const char *lang;
};

#define OPTIONS struct report_options
static const struct wf_option options[] = {
    WF_LANGUAGE_ROW(lang),
    WF_QUIET_ROW,
    { 0 },
};

/* Was the error printed among the findings? */
static bool is_printed(const struct wf_diag *d, const struct wf_err *e, bool quiet)
{
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if ((f->severity == WF_ERROR || !quiet) && strcmp(f->text, e->text) == 0) return true;
    return false;
}

int wf_cmd_report(int argc, char **argv)
{
    static const char about[] =
        "Nothing is computed again: change a script in reports/, or the language, and redraw.\n"
        "\n"
        "  windfirm report out/compare --lang zh";
    struct wf_arena arena = { 0 };
    struct report_options o;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, options, about, 1, 1, &arena, &o.args);
    if (code < 0) {
        struct wf_diag d = { .arena = &arena };
        bool quiet = o.args.quiet;
        wf_progress("drawing plots and pages ...");
        enum wf_status s = wf_report_make(o.args.operand[0], o.lang, &d, &e);
        wf_progress(NULL);
        wf_print_findings(&d, quiet);
        if (!s && !quiet) wf_show(stdout, "Plots and pages: %s\n", o.args.operand[0]);
        code = !s ? 0 : is_printed(&d, &e, quiet) ? wf_exit_code(s) : wf_complain(&e);
    }
    wf_arena_free(&arena);
    return code;
}
