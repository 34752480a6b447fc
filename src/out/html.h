#ifndef WF_OUT_HTML_H
#define WF_OUT_HTML_H
/* Pages that are written part by part: heads, cells, figures drawn on the way. */
#include "base/diag.h"
#include "base/file.h"
#include "out/figures.h"
#include <stdio.h>

struct wf_html_head {
    const char *title, *note, *command, *version, *date; /* note may be NULL */
};
/* Begin a page at `path` with the report's style, its title and what was typed. Errors as wf_file_begin. */
enum wf_status wf_html_begin(struct wf_file *f, const char *path, const struct wf_html_head *h,
                             struct wf_err *e);
/* End and commit it. */
enum wf_status wf_html_end(struct wf_file *f, struct wf_err *e);

/* Print it as PDF; what hinders that is a warning in `d` and is returned. */
enum wf_status wf_html_print(const char *html, const char *pdf, struct wf_diag *d);

/* Words with what HTML reserves written out. */
void wf_html_text(FILE *f, const char *text);
/* A cell of a table; '-' for a number that is not finite. */
void wf_html_number(FILE *f, const char *format, double x);

/* "Where these answers leave physics": the findings of n runs, each said once; nothing when there are none.
 */
void wf_html_findings(FILE *f, const struct wf_diag *const *d, size_t n);

/* Draw a figure and hang it into the page. A figure that cannot be made is a warning, the page says so in its
 * place, and *first keeps the first such status. */
void wf_html_figure(const char *folder, const struct wf_figure *g, const char *caption, FILE *f,
                    struct wf_diag *d, enum wf_status *first);
#endif
