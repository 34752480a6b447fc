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
    bool late;    /* wf_page_print only gives the order; wf_page_take waits for the page */
    /* the page that is being printed, and its order of so many bytes; 0: none */
    struct wf_file file;
    char order[2 * WF_PATH_MAX];
    size_t ordered;
};

/* Print FOLDER/PAGE.html to FOLDER/PAGE.pdf. WeasyPrint may fetch nothing that the page names
 * (reports/pdf.py). An earlier file is replaced only by a complete new one. Errors: WF_EMISSING without
 * WeasyPrint, WF_EOUTPUT with its output where it failed. */
enum wf_status wf_page_print(struct wf_printer *p, const char *folder, const char *page, struct wf_err *e);
/* Wait for the page that a late printer was given, and put it in its place; WF_OK where there is none.
 * Errors: as above. */
enum wf_status wf_page_take(struct wf_printer *p, struct wf_err *e);
/* End the process, where one runs, and give up a page that was not taken. */
void wf_printer_close(struct wf_printer *p);
#endif
