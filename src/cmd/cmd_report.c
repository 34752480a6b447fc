/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/interrupt.h"
#include "base/progress.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option_groups.h"
#include "out/printer.h"
#include "out/run_folder.h"
#include "out/workbook.h"
#include <stdio.h>
#include <string.h>

struct report_options {
    struct wf_args args;
    struct wf_pages pages;
};

#define OPTIONS struct report_options
static const struct wf_option options[] = {
    WF_NO_PDF_ROW(pages),
    WF_XLSX_ROW(pages),
    WF_LANGUAGE_ROW(pages.lang),
    WF_UNITS_ROW(pages.units),
    WF_TEMPLATE_ROW(pages),
    WF_DOCX_ROW(pages),
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

/* Draw into the stage and put all that could be drawn into the folder; nothing is changed there when
 * results.json is wrong or after an interrupt. */
static enum wf_status draw_again(struct wf_run_folder *r, const struct wf_pages *pages,
                                 struct wf_printer *printer, struct wf_diag *d, struct wf_err *e)
{
    struct wf_err other = { 0 };
    enum wf_status w = pages->xlsx ? wf_workbook_make(r->stage, d, e) : WF_OK;
    if (w) return wf_run_abandon(r), w;
    enum wf_status s = wf_results_draw(r, pages, printer, d, e);
    bool made = s == WF_OK || s == WF_EMISSING || s == WF_EOUTPUT, drawn = false;
    for (const struct wf_finding *f = d->first; f; f = f->next) drawn |= f->text && !strcmp(f->text, e->text);
    enum wf_status put = made && (!s || drawn) ? wf_run_commit(r, s ? &other : e) : WF_OK;
    wf_run_abandon(r);
    return s ? s : put;
}

/* Draw the pages of a folder again. Returned: exit code. */
static int redraw(const struct report_options *o, const char *folder, struct wf_printer *printer)
{
    struct wf_arena arena = { 0 };
    struct wf_diag d = { .arena = &arena };
    struct wf_run_folder r;
    struct wf_err e = { 0 };
    bool quiet = o->args.quiet;
    enum wf_status s = wf_run_reopen(&r, folder, o->pages.no_pdf, &d, &e);
    if (!s) s = draw_again(&r, &o->pages, printer, &d, &e);
    wf_print_findings(&d, quiet);
    if (!s && !quiet) wf_show(stdout, "Plots and pages: %s\n", folder);
    int code = !s ? 0 : is_printed(&d, &e, quiet) ? wf_exit_code(s) : wf_complain(&e);
    wf_arena_free(&arena);
    return code;
}

int wf_cmd_report(int argc, char **argv)
{
    static const char about[] = "Nothing is computed again: change a script in reports/, or the language, "
                                "and redraw. One WeasyPrint prints "
                                "the PDFs of all folders. A folder that cannot be drawn is reported, and the "
                                "next one is taken; the exit code "
                                "is then the highest of any folder.\n"
                                "\n"
                                "  windfirm report out/compare --lang zh\n"
                                "  windfirm report out/oak out/ash out/beech";
    struct wf_arena arena = { 0 };
    struct report_options o;
    struct wf_printer printer = { 0 };
    int code = wf_args_read(argc, argv, options, about, 1, (size_t)argc, &arena, &o.args);
    if (code < 0) {
        code = 0;
        wf_interrupt_catch();
        for (size_t i = 0; i < o.args.n && !wf_interrupted(); i++) {
            wf_stage_item(i + 1, o.args.n);
            int one = redraw(&o, o.args.operand[i], &printer);
            if (one > code) code = one;
            fflush(stdout);
        }
    }
    wf_printer_close(&printer);
    wf_arena_free(&arena);
    return code;
}
