#include "out/html.h"
#include "out/figures.h"
#include "out/page.h"
#include <libxml/tree.h>
#include <math.h>
#include <string.h>

void wf_html_text(FILE *f, const char *text)
{
    for (; text && *text; text++) switch (*text) {
        case '<':
            fputs("&lt;", f);
            break;
        case '>':
            fputs("&gt;", f);
            break;
        case '&':
            fputs("&amp;", f);
            break;
        default:
            fputc(*text, f);
        }
}

void wf_html_number(FILE *f, const char *format, double x)
{
    fputs("<td class=\"r\">", f);
    if (isfinite(x))
        fprintf(f, format, x);
    else
        fputs("-", f);
    fputs("</td>", f);
}

void wf_html_findings(FILE *f, const struct wf_diag *const *d, size_t n)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag once = { .arena = &scratch };
    for (size_t r = 0; r < n; r++)
        for (const struct wf_finding *w = d[r]->first; w; w = w->next)
            wf_diag_warn(&once, w->code, "%s", w->text);
    if (once.first) fputs("<h2>Where these answers leave physics</h2>\n<ul class=\"findings\">", f);
    for (const struct wf_finding *w = once.first; w; w = w->next) {
        fputs("<li><b>", f), wf_html_text(f, w->code), fputs("</b> ", f), wf_html_text(f, w->text);
        fputs("</li>\n", f);
    }
    if (once.first) fputs("</ul>\n", f);
    wf_arena_free(&scratch);
}

static enum wf_status hang(FILE *f, xmlDoc *svg, struct wf_err *e)
{
    xmlBuffer *b = xmlBufferCreate();
    int size = b ? xmlNodeDump(b, svg, xmlDocGetRootElement(svg), 0, 0) : -1;
    if (size > 0) fwrite(xmlBufferContent(b), 1, (size_t)size, f);
    if (b) xmlBufferFree(b);
    return size > 0 ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory for a figure");
}

static enum wf_status figure(const char *folder, const struct wf_figure *g, const char *caption, FILE *f,
                             struct wf_err *e)
{
    xmlDoc *svg = NULL;
    enum wf_status status = wf_figures_draw(folder, g, "en", &svg, e);
    if (status) return status;
    fputs("<figure>", f);
    status = hang(f, svg, e);
    fputs("<figcaption>", f);
    wf_html_text(f, caption);
    fputs("</figcaption></figure>\n", f);
    xmlFreeDoc(svg);
    return status;
}

void wf_html_figure(const char *folder, const struct wf_figure *g, const char *caption, FILE *f,
                    struct wf_diag *d, enum wf_status *first)
{
    struct wf_err why = { 0 };
    enum wf_status status = figure(folder, g, caption, f, &why);
    if (!status) return;
    if (!*first) *first = status;
    wf_diag_warn(d, "no-figure", "%s", why.text);
    fputs("<p class=\"missing\">", f);
    wf_html_text(f, why.text);
    fputs("</p>\n", f);
}

enum wf_status wf_html_begin(struct wf_file *f, const char *path, const struct wf_html_head *h,
                             struct wf_err *e)
{
    char style[WF_PATH_MAX];
    struct wf_arena scratch = { 0 };
    struct wf_bytes css = { 0 };
    enum wf_status status = wf_report_asset("report.css", style, sizeof style, e);
    if (!status) status = wf_file_read_text(style, &scratch, &css, e);
    if (!status) status = wf_file_begin(f, path, e);
    if (!status) {
        FILE *to = f->stream;
        fputs("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>", to);
        wf_html_text(to, h->title);
        fprintf(to, "</title><style>%s</style></head><body>\n<h1>", css.data);
        wf_html_text(to, h->title);
        fputs("</h1>\n<p class=\"sub\"><span class=\"program\">windfirm ", to);
        wf_html_text(to, h->version), fputs("</span>, ", to), wf_html_text(to, h->date);
        fputs("</p>\n<p class=\"note\"><code>", to), wf_html_text(to, h->command);
        fputs("</code></p>\n", to);
        if (h->note)
            fputs("<div class=\"summary\"><p>", to), wf_html_text(to, h->note), fputs("</p></div>\n", to);
    }
    wf_arena_free(&scratch);
    return status;
}

enum wf_status wf_html_end(struct wf_file *f, struct wf_err *e)
{
    fputs("</body></html>\n", f->stream);
    return wf_file_commit(f, e);
}

enum wf_status wf_html_print(const char *html, const char *pdf, struct wf_diag *d)
{
    struct wf_err why = { 0 };
    enum wf_status status = wf_page_print(html, pdf, &why);
    if (status) wf_diag_warn(d, "no-pdf", "%s", why.text);
    return status;
}
