/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_PAGES_H
#define WF_CMD_PAGES_H
/* Pages of a results folder, and what a document says about its command. */
#include "cmd/cmd.h"
#include "out/doc.h"

/* Draw figures and pages of a folder and print what is missing. A drawing program that is not installed is no
 * error. Errors: those of wf_report_make. */
enum wf_status wf_pages_make(const char *folder, const char *language, struct wf_arena *a, struct wf_err *e);
/* Command line, program and date of this run; title and note stay empty. Errors: WF_ENOMEM. */
enum wf_status wf_pages_head(int argc, char **argv, struct wf_arena *a, struct wf_doc_head *out,
                             struct wf_err *e);
#endif
