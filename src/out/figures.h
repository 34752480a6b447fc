#ifndef WF_OUT_FIGURES_H
#define WF_OUT_FIGURES_H
/* The figures of a results folder, drawn by gnuplot from its tables. */
#include "base/err.h"
#include <libxml/tree.h>

/* Path of a file of the report: $WINDFIRM_SHARE/reports/NAME, else where it was installed. Returned: WF_OK
 * and `path`, or WF_EINPUT when there is no such file. */
enum wf_status wf_report_asset(const char *name, char *path, size_t size, struct wf_err *e);

extern const char *const wf_figures[]; /* "shapes", "tip", ...; ends at NULL */

/* Write FOLDER/plots/run.gp: names, wind speeds and words of this run, for the figure scripts.
 * Given: the report document (see report.xsl). */
enum wf_status wf_figures_prepare(const char *folder, xmlDoc *report, struct wf_err *e);

/* Draw FOLDER/plots/NAME.svg with reports/plots/NAME.gp. An earlier figure is replaced only by a complete new
 * one. Returned in *svg: the figure as a document to be put into a page. Errors: WF_EMISSING without
 * gnuplot, WF_EOUTPUT with gnuplot's own words, also where it ends with status 0 after a fault. */
enum wf_status wf_figures_draw(const char *folder, const char *name, xmlDoc **svg, struct wf_err *e);
#endif
