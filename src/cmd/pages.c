/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/pages.h"
#include "out/report.h"
#include "out/results.h"

enum wf_status wf_pages_make(const char *folder, const char *language, struct wf_arena *a, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    struct wf_err why = { 0 };
    wf_progress("drawing plots and pages ...");
    enum wf_status s = wf_report_make(folder, language, &d, &why);
    wf_progress(NULL);
    wf_print_findings(&d, false);
    return s == WF_OK || s == WF_EMISSING ? WF_OK : wf_fail(e, s, "%s", why.text);
}

enum wf_status wf_pages_head(int argc, char **argv, struct wf_arena *a, struct wf_doc_head *out,
                             struct wf_err *e)
{
    char *text = wf_arena_text(a, "windfirm");
    for (int i = 0; text && i < argc; i++) text = wf_arena_print(a, "%s %s", text, argv[i]);
    *out = (struct wf_doc_head){ .command = text, .version = WF_VERSION, .date = wf_run_date(a) };
    return text && out->date ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
}
