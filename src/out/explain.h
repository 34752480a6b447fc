/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_EXPLAIN_H
#define WF_OUT_EXPLAIN_H
/* Methods against beam theory: table, plot data, part of a document. */
#include "out/doc.h"
#include "study/explain.h"

struct wf_explained {
    size_t run;       /* number of the run it belongs to */
    const char *name;  /* of the tree and its wind, for the heading */
    const char *model; /* its name, where the heading is species and model; else NULL */
    const struct wf_species *species;
    const struct wf_explain *of;
    const struct wf_tree *tree;
    double speed;                       /* [m/s] */
    const struct wf_scenario *scenario; /* of a document of its own */
    const struct wf_diag *findings; /* where printed methods depart from physics; NULL: reported elsewhere */
};

/* Write FOLDER/tables/explain.csv, one row per branch. Errors: WF_EOUTPUT. */
enum wf_status wf_explain_tables(const struct wf_explained *x, size_t n, const char *folder,
                                 struct wf_err *e);
/* Values that the figure script needs about n trees, at least one: methods, levels, range of the ratios. */
void wf_explain_plot_data(const struct wf_explained *x, size_t n, struct wf_plot_data *p);
/* The ratios by level and, of the first branches, by branch, as a part of a document. Returned: a new object.
 */
json_t *wf_explain_part(struct wf_doc *d, const struct wf_explained *x);
/* Append the figure of one of them to a document's list. */
void wf_explain_figure(struct wf_doc *d, json_t *list, const struct wf_explained *x);
/* All files for a single tree: tables/explain.csv, plots/run.csv and results.json of a folder of its own.
 * Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_explain_write(const struct wf_explained *x, const struct wf_doc_head *head,
                                const char *folder, struct wf_err *e);
#endif
