/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_PRINTER_H
#define WF_OUT_PRINTER_H
/* Pages as PDF, printed by WeasyPrint. Its start takes as long as two pages, so one WeasyPrint prints all
 * pages of a run of windfirm; it is started at the first. */
#include "out/program.h"

/* A WeasyPrint that may run; { 0 } before the first page. */
struct wf_printer {
    struct wf_program program;
    struct wf_running running;
    size_t pages; /* that this process was given; 0: none runs */
};

/* Print FOLDER/PAGE.html to FOLDER/PAGE.pdf. WeasyPrint may fetch nothing that the page names
 * (reports/pdf.py). An earlier file is replaced only by a complete new one. Errors: WF_EMISSING without
 * WeasyPrint, WF_EOUTPUT with its output where it failed. */
enum wf_status wf_page_print(struct wf_printer *p, const char *folder, const char *page, struct wf_err *e);
/* End the process, where one runs. */
void wf_printer_close(struct wf_printer *p);
#endif
