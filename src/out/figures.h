/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FIGURES_H
#define WF_OUT_FIGURES_H
/* Figures and printed pages, made by external programs. A program is found on PATH and run without a shell,
 * in the results folder: it gets names inside that folder, which windfirm chose, and none that a user chose.
 * It dies with windfirm. */
#include "base/err.h"
#include <libxml/tree.h>

enum { WF_SAID_MAX = 2048 }; /* what is kept of what a program prints [bytes] */

/* Path of a file of the report: $WINDFIRM_SHARE/reports/NAME, else where it was installed. Returned: WF_OK
 * and `path`, or WF_EINPUT when there is no such file. */
enum wf_status wf_report_asset(const char *name, char *path, size_t size, struct wf_err *e);

/* A picture of a results folder: FOLDER/plots/NAME.svg, drawn by reports/plots/SCRIPT.gp. */
struct wf_figure {
    const char *name, *script;
    size_t run; /* number of the run it shows, from 1; 0: all, or there is only one */
};

/* Draw a figure with gnuplot to the file FOLDER/PICTURE, with labels in a language ("en", "zh"). The picture
 * is an SVG unless its name ends in .png or .pdf. Warnings of gnuplot become one warning `figure-warning` of
 * `d` (may be NULL), and the picture stands. Errors: WF_EMISSING without gnuplot, WF_EOUTPUT with gnuplot's
 * output, also when gnuplot ends with status 0 after an error. */
enum wf_status wf_figures_run(const char *folder, const struct wf_figure *g, const char *picture,
                              const char *language, struct wf_diag *d, struct wf_err *e);
/* Draw FOLDER/plots/NAME.svg. An earlier figure is replaced only by a complete new one. Returned in *svg: the
 * figure as a document to be put into a page. Warnings and errors: as wf_figures_run. */
enum wf_status wf_figures_draw(const char *folder, const struct wf_figure *g, const char *language,
                               xmlDoc **svg, struct wf_diag *d, struct wf_err *e);

/* Print FOLDER/PAGE.html to FOLDER/PAGE.pdf with WeasyPrint, which may fetch nothing that the page names
 * (reports/pdf.py). An earlier file is replaced only by a complete new one. Errors: WF_EMISSING without
 * WeasyPrint, WF_EOUTPUT with its output where it failed. */
enum wf_status wf_page_print(const char *folder, const char *page, struct wf_err *e);
#endif
