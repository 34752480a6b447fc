#include "out/explain.h"
#include "out/folder.h"
#include <math.h>

static void row(FILE *f, const struct wf_explained *x, size_t b)
{
    const struct wf_explain_axis *o = &x->of->axis[b];
    fprintf(f, "%zu,%zu,%d,%lld,%.6g,%.6g,%.6g,%.6g", x->run, b + 1, (int)o->level,
            (long long)x->tree->id[o->first], o->height, o->length, o->radius, o->beam);
    for (size_t m = 0; m < x->of->methods; m++)
        isfinite(o->ratio[m]) ? fprintf(f, ",%.6g", o->ratio[m]) : fputc(',', f);
    fputc('\n', f);
}

static void table(FILE *f, const struct wf_explained *x, size_t n)
{
    fputs("run,branch,level,segment,base_height_m,length_m,base_radius_m,beam_m", f);
    for (size_t m = 0; n && m < x->of->methods; m++) fprintf(f, ",%s", x->of->method[m]->name);
    fputc('\n', f);
    for (size_t i = 0; i < n; i++)
        for (size_t b = 0; b < x[i].of->axes; b++) row(f, &x[i], b);
}

/* Has a method an answer that a logarithmic scale can show? */
static bool answers(const struct wf_explain *x, size_t method)
{
    for (size_t b = 0; b < x->axes; b++)
        if (x->axis[b].ratio[method] > 0 && isfinite(x->axis[b].ratio[method])) return true;
    return false;
}

void wf_explain_plot_data(const struct wf_explained *x, size_t n, struct wf_plot_data *p)
{
    double low = 0.5, high = 2;
    int32_t top = 0;
    char key[32];
    for (size_t i = 0; i < n; i++)
        for (size_t b = 0; b < x[i].of->axes; b++)
            for (size_t m = 0; m < x[i].of->methods; m++) {
                const struct wf_explain_axis *o = &x[i].of->axis[b];
                top = o->level > top ? o->level : top;
                if (o->ratio[m] > 0 && isfinite(o->ratio[m]))
                    low = fmin(low, o->ratio[m]), high = fmax(high, o->ratio[m]);
            }
    wf_plot_data_count(p, "METHODS", 0, x->of->methods);
    wf_plot_data_count(p, "FIRST", 0, 8); /* columns before those of the methods */
    wf_plot_data_count(p, "EXPLAIN_LEVELS", 0, (size_t)top + 1);
    wf_plot_data_number(p, "LOW", 0, pow(10, floor(log10(low))));
    wf_plot_data_number(p, "HIGH", 0, pow(10, ceil(log10(high))));
    for (size_t m = 0; m < x->of->methods; m++) wf_plot_data_text(p, "METHOD", m + 1, x->of->method[m]->name);
    for (size_t i = 0; i < n; i++) {
        size_t k = 0;
        snprintf(key, sizeof key, "ANSWERS_%zu", x[i].run);
        for (size_t m = 0; m < x[i].of->methods; m++)
            if (answers(x[i].of, m)) wf_plot_data_count(p, key, ++k, m + 1);
    }
}

enum wf_status wf_explain_tables(const struct wf_explained *x, size_t n, const char *folder, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_folder_make(folder, e);
    if (!s) s = wf_folder_begin(&f, folder, "tables/explain.csv", e);
    if (!s) table(f.stream, x, n), s = wf_file_commit(&f, e);
    return s;
}

enum wf_status wf_explain_write(const struct wf_explained *x, const char *folder, struct wf_err *e)
{
    struct wf_plot_data p;
    enum wf_status s = wf_explain_tables(x, 1, folder, e);
    if (!s) s = wf_plot_data_begin(&p, folder, "run", e);
    if (s) return s;
    wf_explain_plot_data(x, 1, &p);
    return wf_plot_data_end(&p, e);
}

static void heads(FILE *f, const struct wf_explain *x)
{
    for (size_t m = 0; m < x->methods; m++)
        fputs("<th class=\"r\">", f), wf_html_text(f, x->method[m]->name), fputs("</th>", f);
    fputs("</tr></thead>\n", f);
}

static void by_level(FILE *f, const struct wf_explained *x)
{
    const struct wf_explain *o = x->of;
    fputs(
        "<table class=\"data\"><caption>By level: middle ratio of the branches, below it the lowest and "
        "the highest. "
        "1.00 is agreement with beam theory.</caption><thead><tr><th>level</th><th class=\"r\">branches</th>",
        f);
    heads(f, o);
    for (int32_t l = 0; l <= wf_explain_top(o); l++) {
        fprintf(f, "<tbody><tr><td>%d</td>", (int)l);
        for (size_t m = 0; m < o->methods; m++) {
            struct wf_explain_spread s;
            wf_explain_spread(o, m, l, &s);
            if (!m) fprintf(f, "<td class=\"r\">%zu</td>", s.branches);
            if (s.answers)
                fprintf(f,
                        s.answers > 1 ? "<td class=\"r\">%.3g<span class=\"why\">%.2g to %.2g</span></td>"
                                      : "<td class=\"r\">%.3g</td>",
                        s.middle, s.low, s.high);
            else
                fputs("<td class=\"r\">-</td>", f);
        }
        fputs("</tr></tbody>\n", f);
    }
    fputs("<tbody><tr><td>stem's tip</td><td></td>", f);
    for (size_t m = 0; m < o->methods; m++) wf_html_number(f, "%.3g", o->tip[m]);
    fputs("</tr></tbody><tbody><tr><td>branches within 5 %</td><td></td>", f);
    for (size_t m = 0; m < o->methods; m++)
        fprintf(f, "<td class=\"r\">%.0f %%</td>", 100 * wf_explain_share(o, m, 0.05));
    fputs("</tr></tbody></table>\n", f);
}

static void by_branch(FILE *f, const struct wf_explained *x)
{
    enum { SHOWN = 24 };
    const struct wf_explain *o = x->of;
    size_t n = o->axes < SHOWN ? o->axes : SHOWN;
    fprintf(
        f,
        "<table class=\"data\"><caption>Branch by branch: %s%zu of %zu; all are in tables/explain.csv. Beam: "
        "how far "
        "the end bends away from where a stiff branch on the same foot would have it.</caption><thead><tr>"
        "<th>branch</th><th>level</th><th class=\"r\">foot at<span class=\"u\">m</span></th><th "
        "class=\"r\">length<span class=\"u\">m"
        "</span></th><th class=\"r\">beam<span class=\"u\">m</span></th>",
        n < o->axes ? "the first " : "", n, o->axes);
    heads(f, o);
    fputs("<tbody class=\"long\">", f);
    for (size_t b = 0; b < n; b++) {
        const struct wf_explain_axis *a = &o->axis[b];
        fprintf(f, "<tr><td>%zu</td><td>%d</td>", b + 1, (int)a->level);
        wf_html_number(f, "%.2f", a->height), wf_html_number(f, "%.2f", a->length),
            wf_html_number(f, "%.3g", a->beam);
        for (size_t m = 0; m < o->methods; m++) wf_html_number(f, "%.3g", a->ratio[m]);
        fputs("</tr>\n", f);
    }
    fputs("</tbody></table>\n", f);
}

void wf_explain_section(const struct wf_explained *x, const char *folder, FILE *f, struct wf_diag *d,
                        enum wf_status *first)
{
    char name[32], caption[400];
    fputs("<h2>Where each method can be trusted: ", f), wf_html_text(f, x->name);
    fprintf(
        f,
        "</h2>\n<p>Every method bends the same tree under the same air, drag and steady wind of %.3g m/s. A "
        "ratio is the branch's own bending by the method over that by beam theory, less what its foot does, "
        "so "
        "an error of the parent is not counted again.</p>\n",
        x->speed);
    by_level(f, x);
    snprintf(name, sizeof name, "explain_%zu", x->run);
    snprintf(
        caption, sizeof caption,
        "Own bending of every branch over that by beam theory, by level (0: the stem), methods side by side. "
        "The line at 1 is agreement.");
    wf_html_figure(folder, &(struct wf_figure){ name, "explain", x->run }, caption, f, d, first);
    if (x->of->axes > 1) by_branch(f, x);
}

enum wf_status wf_explain_page(const struct wf_explained *x, const struct wf_html_head *head,
                               const char *folder, struct wf_diag *d, struct wf_err *e)
{
    char html[WF_PATH_MAX], pdf[WF_PATH_MAX];
    enum wf_status drawn = WF_OK;
    struct wf_file f = { 0 };
    snprintf(html, sizeof html, "%.4000s/explain.html", folder);
    snprintf(pdf, sizeof pdf, "%.4000s/explain.pdf", folder);
    enum wf_status status = wf_html_begin(&f, html, head, e);
    if (!status) {
        wf_explain_section(x, folder, f.stream, d, &drawn);
        if (x->findings) wf_html_findings(f.stream, &x->findings, 1);
        status = wf_html_end(&f, e);
    }
    wf_file_abandon(&f);
    if (status) return status;
    status = wf_html_print(html, pdf, d);
    return drawn ? drawn : status;
}
