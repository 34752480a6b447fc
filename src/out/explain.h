#ifndef WF_OUT_EXPLAIN_H
#define WF_OUT_EXPLAIN_H
/* Methods against beam theory as a table, a plot, a section of a page and a page of its own. */
#include "out/html.h"
#include "out/plot_data.h"
#include "study/explain.h"

struct wf_explained {
    size_t run;       /* number of the run it belongs to */
    const char *name; /* of the tree and its wind, for the heading */
    const struct wf_explain *of;
    const struct wf_tree *tree;
    double speed;                   /* [m/s] */
    const struct wf_diag *findings; /* where printed methods leave physics; NULL: told elsewhere */
};

/* Write FOLDER/tables/explain.csv, a row a branch. Errors: WF_EOUTPUT. */
enum wf_status wf_explain_tables(const struct wf_explained *x, size_t n, const char *folder,
                                 struct wf_err *e);
/* What the figure script needs to know about n of them, at least one: methods, levels, range of the ratios.
 */
void wf_explain_plot_data(const struct wf_explained *x, size_t n, struct wf_plot_data *p);

/* Both for a single tree: tables/explain.csv and plots/run.csv of a folder of its own. */
enum wf_status wf_explain_write(const struct wf_explained *x, const char *folder, struct wf_err *e);

/* A heading, the ratios by level and by branch, the plot. *first: first status of a figure that was not made.
 */
void wf_explain_section(const struct wf_explained *x, const char *folder, FILE *f, struct wf_diag *d,
                        enum wf_status *first);

/* Write FOLDER/explain.html and explain.pdf. What cannot be made is a warning in `d`; returned: its status.
 */
enum wf_status wf_explain_page(const struct wf_explained *x, const struct wf_html_head *head,
                               const char *folder, struct wf_diag *d, struct wf_err *e);
#endif
