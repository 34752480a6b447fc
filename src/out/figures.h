/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FIGURES_H
#define WF_OUT_FIGURES_H
/* External programs: found on PATH, run without a shell, with their output read. */
#include "base/err.h"
#include <libxml/tree.h>

enum { WF_SAID_MAX = 512 };

/* Given: argv, ending at NULL, argv[0] the program's name; the Debian package that contains it. Its input is
 * empty; what it prints is kept, the first WF_SAID_MAX - 1 bytes of it, in `said`. Returned: WF_OK when it
 * ended with status 0; WF_EMISSING naming the package when it is not installed; WF_EOUTPUT with its output
 * when it failed. */
enum wf_status wf_program_run(const char *const *argv, const char *package, char said[static WF_SAID_MAX],
                              struct wf_err *e);

/* The figures of a results folder, drawn by gnuplot from its tables. */

/* Path of a file of the report: $WINDFIRM_SHARE/reports/NAME, else where it was installed. Returned: WF_OK
 * and `path`, or WF_EINPUT when there is no such file. */
enum wf_status wf_report_asset(const char *name, char *path, size_t size, struct wf_err *e);

/* A picture of a results folder: FOLDER/plots/NAME.svg, drawn by reports/plots/SCRIPT.gp. */
struct wf_figure {
    const char *name, *script;
    size_t run; /* number of the run it shows, from 1; 0: all, or there is only one */
};

/* Draw a figure with gnuplot to the file `picture`, with labels in a language ("en", "zh"). Errors:
 * WF_EMISSING without gnuplot, WF_EOUTPUT with gnuplot's output, also when gnuplot ends with status 0 after
 * an error. */
enum wf_status wf_figures_run(const char *folder, const struct wf_figure *g, const char *picture,
                              const char *language, struct wf_err *e);
/* Draw FOLDER/plots/NAME.svg. An earlier figure is replaced only by a complete new one. Returned in *svg: the
 * figure as a document to be put into a page. Errors: as wf_figures_run. */
enum wf_status wf_figures_draw(const char *folder, const struct wf_figure *g, const char *language,
                               xmlDoc **svg, struct wf_err *e);
#endif
