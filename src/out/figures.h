/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FIGURES_H
#define WF_OUT_FIGURES_H
/* Figures, drawn by gnuplot in the results folder (out/program.h). It gets names inside that folder, which
 * windfirm chose, and none that a user chose. */
#include "base/err.h"
#include <libxml/tree.h>

struct wf_plot_data;
struct wf_tongue;

enum { WF_FIGURES_MAX = 12 }; /* that are drawn by one gnuplot */

/* A picture of a results folder: FOLDER/plots/NAME.svg, drawn by reports/plots/SCRIPT.gp. */
struct wf_figure {
    const char *name, *script;
    size_t run; /* number of the run it shows, from 1; 0: all, or there is only one */
};

/* Add the rows UNIT.M and FACTOR.M, for each metric unit M that a system calls otherwise, to plot data. */
void wf_figures_units(struct wf_plot_data *p, const char *units);
/* Add to FOLDER/plots/NAME.csv, for reports/plots/facts.gp, what the figures of a page say: its units, and as
 * SAID.KEY each name in the page's language and each quantity in its units. Those of an earlier page are
 * replaced; without the file nothing is done. Errors: WF_EINPUT, WF_EOUTPUT, WF_ENOMEM; the file is then as
 * before. */
enum wf_status wf_figures_say(const char *folder, const char *name, const char *units,
                              const struct wf_tongue *t, struct wf_err *e);

/* Draw a figure with gnuplot to the file FOLDER/PICTURE, with labels in a language ("en", "zh"). The picture
 * is an SVG unless its name ends in .png or .pdf. Warnings of gnuplot become one warning `figure-warning` of
 * `d` (may be NULL), and the picture stands. Errors: WF_EMISSING without gnuplot, WF_EOUTPUT with gnuplot's
 * output, also when gnuplot ends with status 0 after an error. */
enum wf_status wf_figures_run(const char *folder, const struct wf_figure *g, const char *picture,
                              const char *language, struct wf_diag *d, struct wf_err *e);
/* Draw n <= WF_FIGURES_MAX figures, FOLDER/plots/NAME.svg of each. An earlier figure is replaced only by a
 * complete new one. Returned, for each: in svg[k] the figure as a document to be put into a page, or NULL and
 * in why[k] the error. Warnings and errors: as wf_figures_run. */
void wf_figures_draw(const char *folder, const struct wf_figure *g, size_t n, const char *language,
                     xmlDoc **svg, struct wf_diag *d, struct wf_err *why);
#endif
