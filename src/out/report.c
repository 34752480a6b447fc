/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/report.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/text.h"
#include "out/doc.h"
#include "out/docx.h"
#include "out/figures.h"
#include "out/job.h"
#include "out/live.h"
#include "out/page_turn.h"
#include "out/page_units.h"
#include "out/printer.h"
#include "out/reader.h"
#include "out/results.h"
#include "out/template.h"
#include "out/tongue.h"
#include "out/tree_picture.h"
#include "out/xml.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* One kind of results document and its page. */
struct kind {
    const char *schema;
    int version;               /* of the schema that is read                                 */
    const char *page;          /* FOLDER/PAGE.html and PAGE.pdf, by reports/PAGE.xsl          */
    const char *const *figure; /* ends at NULL; NULL: the document lists them under "figures" */
    const char *script;        /* of a picture with a slider; NULL: none                       */
};
static const char *const report_figures[] = { "shapes", "tip", "safety", "stem", NULL };
static const char *const fit_figures[] = { "fit_readings", "fit_residuals", "fit_profiles", "fit_records",
                                           NULL };
static const struct kind kinds[] = {
    { WF_RESULTS_SCHEMA, WF_RESULTS_VERSION, "report", report_figures, "live.js" },
    { "windfirm-fit", 1, "calibration", fit_figures, NULL },
    { "windfirm-series", 1, "series", NULL, "frames.js" },
    { "windfirm-explain", 1, "explain", NULL, NULL },
    { "windfirm-wind", 1, "wind", NULL, NULL },
    { "windfirm-rose", 1, "rose", NULL, NULL },
    { "windfirm-shelter", 1, "shelter", NULL, NULL },
    { "windfirm-terrain", 1, "terrain", NULL, NULL },
    { "windfirm-rain", 1, "rain", NULL, "rain.js" },
    { "windfirm-modes", 1, "modes", NULL, NULL },
    { "windfirm-fragility", 1, "fragility", NULL, NULL },
    { "windfirm-extremes", 1, "extremes", NULL, NULL },
};

struct job {
    const char *folder, *language, *units, *templates;
    bool turned; /* units other than those the stylesheets are written in */
    const struct kind *kind;
    json_t *results;
    xmlDoc *document; /* <report lang="en"><results/><css/><figures/></report>, what every stylesheet reads */
    xmlNode *figures;
    struct wf_tongue *tongue;
    struct wf_printer *printer; /* NULL: no PDF */
    bool docx;
    struct wf_figure *drawn; /* figures of the page by gnuplot; kept for the document alone */
    size_t figures_drawn;
    struct wf_diag *d;
    struct wf_err *e;
    enum wf_status first; /* of the parts that could not be made */
    int interrupted;      /* before the drawing began: the pages of what is finished are drawn */
};

/* Was the drawing interrupted? */
static enum wf_status check_interrupt(struct job *j)
{
    if (wf_interrupted() == j->interrupted) return WF_OK;
    return wf_fail(j->e, WF_EINTERRUPTED,
                   "interrupted while figures and pages were drawn; they are not complete");
}

/* A part that cannot be made is a warning; the other parts are still made. */
static void miss(struct job *j, const char *part, const struct wf_err *why)
{
    wf_diag_warn(j->d, part, "%s", why->text);
    if (j->first) return;
    j->first = wf_fail(j->e, why->code, "%s", why->text);
}

/* Check that the document has trees and that the tables a report needs can be read. */
static enum wf_status check_report(struct job *j)
{
    char path[WF_PATH_MAX];
    enum wf_status code = WF_OK;
    if (!json_array_size(json_object_get(j->results, "trees")))
        return wf_fail(j->e, WF_EINPUT, "%s/results.json: trees: at least one is needed", j->folder);
    for (size_t i = 0; !code && wf_tables[i].name; i++) {
        if (wf_tables[i].made) continue; /* only some runs have it */
        code = wf_folder_path(j->folder, wf_tables[i].name, path, j->e);
        if (!code && access(path, R_OK)) code = wf_fail(j->e, WF_EINPUT, "%s: cannot be read", path);
    }
    return code;
}

static enum wf_status read_results(struct job *j)
{
    char path[WF_PATH_MAX];
    enum wf_status code = wf_folder_path(j->folder, "results.json", path, j->e);
    if (code) return code;
    if (access(path, R_OK))
        return wf_fail(j->e, WF_EINPUT, "%s: cannot be read; is '%s' a results folder?", path, j->folder);
    if ((code = wf_document_read(path, &j->results, j->d, j->e))) return code;
    const json_t *schema = json_object_get(j->results, "schema");
    const char *name = json_string_value(json_object_get(schema, "name"));
    json_int_t version = json_integer_value(json_object_get(schema, "version"));
    for (size_t i = 0; name && i < sizeof kinds / sizeof *kinds; i++)
        if (!strcmp(name, kinds[i].schema)) j->kind = &kinds[i];
    if (!j->kind) return wf_fail(j->e, WF_EINPUT, "%s: is not a results document of windfirm", path);
    if (!wf_results_readable(version, j->kind->version))
        return wf_fail(j->e, WF_EINPUT, "%s: results of version %lld; this program reads version %d%s", path,
                       (long long)version, j->kind->version,
                       j->kind->version > 1 ? " and the one before" : "");
    if (j->kind->figure == report_figures) code = check_report(j);
    return code ? code : wf_tables_check(j->folder, j->e);
}

/* The texts that the results say themselves. */
static enum wf_status translate(struct job *j)
{
    enum wf_status code = wf_tongue_open(j->language, &j->tongue, j->e);
    if (!code) wf_tongue_translate(j->tongue, xmlDocGetRootElement(j->document)->children);
    return code;
}

static enum wf_status make_document(struct job *j)
{
    char path[WF_PATH_MAX];
    struct wf_arena scratch = { 0 };
    struct wf_bytes css = { 0 };
    enum wf_status code = wf_template_path(j->templates, "report.css", path, j->e);
    if (!code) code = wf_file_read_text(path, &scratch, &css, j->e);
    if (!code) {
        j->document = xmlNewDoc(BAD_CAST "1.0");
        xmlNode *root = j->document ? xmlNewDocNode(j->document, NULL, BAD_CAST "report", NULL) : NULL;
        if (root) xmlDocSetRootElement(j->document, root);
        if (!root || !xmlNewProp(root, BAD_CAST "lang", BAD_CAST j->language) ||
            (j->turned && !xmlNewProp(root, BAD_CAST "units", BAD_CAST j->units)) ||
            !wf_xml_from_json(root, "results", j->results) ||
            !xmlNewTextChild(root, NULL, BAD_CAST "css", BAD_CAST css.data) ||
            !(j->figures = xmlNewChild(root, NULL, BAD_CAST "figures", NULL)))
            code = wf_fail(j->e, WF_ENOMEM, "%s: no memory for the page", j->folder);
    }
    wf_arena_free(&scratch);
    if (!code) code = translate(j);
    return !code && j->turned ? wf_page_guard(xmlDocGetRootElement(j->document), j->e) : code;
}

/* Add photograph and logo to the document: <picture name="photo">data:...</picture>. The folder may be a
 * stranger's: they are decoded and encoded again. */
static enum wf_status add_pictures(struct job *j)
{
    const json_t *job = json_object_get(j->results, "job");
    struct wf_arena scratch = { 0 };
    enum wf_status code = WF_OK;
    for (size_t i = 0; i < WF_JOB_PICTURES && !code; i++) {
        char path[WF_PATH_MAX], name[32];
        struct wf_bytes jpeg;
        struct wf_err why = { 0 };
        snprintf(name, sizeof name, "plots/%s.jpg", wf_job_pictures[i]);
        if (!json_is_string(json_object_get(job, wf_job_pictures[i]))) continue;
        if ((code = wf_folder_path(j->folder, name, path, j->e))) break;
        if (wf_picture_take(path, &scratch, &jpeg, &why)) {
            miss(j, "no-picture", &why);
            continue;
        }
        const char *address = wf_picture_address(&jpeg, &scratch);
        xmlNode *node = address ? xmlNewTextChild(xmlDocGetRootElement(j->document), NULL, BAD_CAST "picture",
                                                  BAD_CAST address)
                                : NULL;
        if (!node || !xmlNewProp(node, BAD_CAST "name", BAD_CAST wf_job_pictures[i]))
            code = wf_fail(j->e, WF_ENOMEM, "%s: no memory for the page", j->folder);
    }
    wf_arena_free(&scratch);
    return code;
}

/* "sha256-..." of a script, by which a page says that it runs this one alone. NULL: no memory. */
static const char *script_name(const struct wf_bytes *script, struct wf_arena *a)
{
    char hex[WF_SHA256_TEXT];
    unsigned char digest[32];
    wf_sha256(script->data, script->size, hex);
    for (size_t i = 0; i < sizeof digest; i++) {
        const char pair[3] = { hex[2 * i], hex[2 * i + 1], '\0' };
        digest[i] = (unsigned char)strtoul(pair, NULL, 16);
    }
    const char *text = wf_base64(digest, sizeof digest, a);
    return text ? wf_arena_print(a, "sha256-%s", text) : NULL;
}

/* The script of the page: what pictures with a slider share, and its own. */
static enum wf_status read_script(const struct kind *kind, struct wf_arena *a, struct wf_bytes *out,
                                  struct wf_err *e)
{
    const char *const name[] = { "picture.js", kind->script };
    struct wf_bytes part[2] = { 0 };
    enum wf_status code = WF_OK;
    for (int i = 0; i < 2 && !code; i++) {
        char path[WF_PATH_MAX];
        code = wf_report_asset(name[i], path, sizeof path, e);
        if (!code) code = wf_file_read_text(path, a, &part[i], e);
    }
    if (code) return code;
    char *text = wf_arena_print(a, "%s%s", part[0].data, part[1].data);
    if (!text) return wf_fail(e, WF_ENOMEM, "no memory for a script");
    *out = (struct wf_bytes){ text, strlen(text) };
    return WF_OK;
}

/* Add the picture with a slider: <live>data</live> and <script name="sha256-...">. Without it the page is
 * whole. */
static enum wf_status put_live(struct job *j, const char *data, struct wf_arena *scratch)
{
    struct wf_bytes script = { 0 };
    const char *name = NULL;
    xmlNode *root = xmlDocGetRootElement(j->document), *node = NULL;
    enum wf_status code = read_script(j->kind, scratch, &script, j->e);
    if (!code && (name = script_name(&script, scratch)))
        node = xmlNewTextChild(root, NULL, BAD_CAST "script", BAD_CAST script.data);
    if (!code && (!node || !xmlNewProp(node, BAD_CAST "name", BAD_CAST name) ||
                  !xmlNewTextChild(root, NULL, BAD_CAST "live", BAD_CAST data)))
        code = wf_fail(j->e, WF_ENOMEM, "%s: no memory for the page", j->folder);
    return code;
}

static enum wf_status add_live(struct job *j)
{
    struct wf_arena scratch = { 0 };
    const char *data = NULL;
    enum wf_status code = wf_live_data(j->folder, j->results, j->units, &scratch, &data, j->e);
    if (!code && data) code = put_live(j, data, &scratch);
    wf_arena_free(&scratch);
    return code;
}

/* Add a figure to the document: <figure name="tip"><svg/></figure>, or the attribute missing="why". Takes the
 * drawing. */
static enum wf_status add_figure(struct job *j, const char *name, xmlDoc *svg, const struct wf_err *why)
{
    xmlNode *picture = svg ? xmlDocCopyNode(xmlDocGetRootElement(svg), j->document, 1) : NULL;
    bool drawn = svg != NULL;
    xmlFreeDoc(svg);
    xmlNode *node = xmlNewChild(j->figures, NULL, BAD_CAST "figure", NULL);
    if (!node || !xmlNewProp(node, BAD_CAST "name", BAD_CAST name) || (drawn && !picture)) {
        xmlFreeNode(picture);
        return wf_fail(j->e, WF_ENOMEM, "%s: no memory for the page", j->folder);
    }
    if (picture)
        xmlAddChild(node, picture);
    else
        xmlNewProp(node, BAD_CAST "missing", BAD_CAST why->text);
    return WF_OK;
}

/* A figure that was drawn, for PAGE.docx. */
static enum wf_status keep_figure(struct job *j, const struct wf_figure *g)
{
    if (!j->docx) return WF_OK;
    struct wf_figure *more = realloc(j->drawn, (j->figures_drawn + 1) * sizeof *more);
    if (!more) return wf_fail(j->e, WF_ENOMEM, "%s: no memory for the page", j->folder);
    j->drawn = more;
    j->drawn[j->figures_drawn++] = *g;
    return WF_OK;
}

/* Draw figures and add them to the document, WF_FIGURES_MAX at once. */
static enum wf_status draw_figures(struct job *j, const struct wf_figure *g, size_t n)
{
    enum wf_status code = WF_OK;
    for (size_t first = 0, some; first < n && !code; first += some) {
        xmlDoc *svg[WF_FIGURES_MAX];
        struct wf_err why[WF_FIGURES_MAX];
        if (check_interrupt(j)) return WF_EINTERRUPTED;
        some = n - first < WF_FIGURES_MAX ? n - first : WF_FIGURES_MAX;
        wf_figures_draw(j->folder, g + first, some, j->language, svg, j->d, why);
        code = check_interrupt(j);
        for (size_t k = 0; k < some; k++) {
            if (why[k].code && !code) miss(j, "no-figure", &why[k]);
            if (!code && !why[k].code) code = keep_figure(j, &g[first + k]);
            if (!code)
                code = add_figure(j, g[first + k].name, svg[k], &why[k]);
            else
                xmlFreeDoc(svg[k]);
        }
    }
    return code;
}

/* <row key index [text="yes"|"words"]>value</row> to the plot data. */
static enum wf_status plot_row(struct wf_plot_data *p, xmlNode *row, struct wf_err *e)
{
    xmlChar *key = xmlGetProp(row, BAD_CAST "key"), *index = xmlGetProp(row, BAD_CAST "index"),
            *text = xmlGetProp(row, BAD_CAST "text"), *value = xmlNodeGetContent(row);
    enum wf_status s = WF_OK;
    if (!key || !index || !value)
        s = wf_fail(e, WF_EINPUT, "figures.xsl: a row without key, index or value");
    else if (text && !strcmp((char *)text, "words"))
        wf_plot_data_words(p, (char *)key, strtoul((char *)index, NULL, 10), (char *)value);
    else if (text)
        wf_plot_data_text(p, (char *)key, strtoul((char *)index, NULL, 10), (char *)value);
    else
        s = wf_plot_data_parse(p, (char *)key, strtoul((char *)index, NULL, 10), (char *)value, e);
    xmlFree(key), xmlFree(index), xmlFree(text), xmlFree(value);
    return s;
}

/* FOLDER/plots/run.csv of a report, from its document: names, wind speeds, range of this run. */
static enum wf_status write_plot_data(const char *folder, xmlDoc *report, const char *units, struct wf_err *e)
{
    char style[WF_PATH_MAX];
    struct wf_plot_data p;
    xmlDoc *rows = NULL;
    enum wf_status code = wf_folder_make(folder, e);
    if (!code) code = wf_report_asset("figures.xsl", style, sizeof style, e);
    if (!code) code = wf_xml_transform(style, report, NULL, &rows, e);
    if (!code) code = wf_plot_data_begin(&p, folder, "run", e);
    if (!code) {
        for (xmlNode *n = xmlDocGetRootElement(rows)->children; n && !code; n = n->next)
            if (n->type == XML_ELEMENT_NODE) code = plot_row(&p, n, e);
        wf_figures_units(&p, units);
        if (!code) code = wf_plot_data_end(&p, e);
        wf_file_abandon(&p.f);
    }
    if (rows) xmlFreeDoc(rows);
    return code;
}

/* The tree of a report; one of very many segments is a picture of points. */
static enum wf_status draw_tree(struct job *j)
{
    struct wf_err why = { 0 };
    xmlDoc *svg = NULL;
    if (check_interrupt(j)) return WF_EINTERRUPTED;
    enum wf_status code = wf_tree_picture_report(j->folder, j->language, &svg, j->d, &why);
    if (check_interrupt(j)) return xmlFreeDoc(svg), WF_EINTERRUPTED;
    if (code) miss(j, "no-figure", &why);
    return add_figure(j, "tree", svg, &why);
}

/* The figures of a report: its plot data are made from the document, in its language. */
static enum wf_status draw_report(struct job *j)
{
    const json_t *first = json_array_get(json_object_get(j->results, "trees"), 0);
    struct wf_figure g[WF_FIGURES_MAX];
    struct wf_err why = { 0 };
    enum wf_status code = WF_OK;
    size_t n = 0;
    bool tree = wf_tree_picture_there(j->folder), lines = tree && wf_tree_picture_lines(j->folder);
    if (json_array_size(json_object_get(j->results, "trees")) == 1)
        g[n++] = (struct wf_figure){ "front", "front", 0 };
    if (lines) g[n++] = (struct wf_figure){ "tree", "tree", 0 };
    for (size_t i = 0; j->kind->figure[i]; i++)
        g[n++] = (struct wf_figure){ j->kind->figure[i], j->kind->figure[i], 0 };
    if (json_is_object(json_object_get(first, "directions")))
        g[n++] = (struct wf_figure){ "directions", "directions", 0 };
    if (json_array_size(json_object_get(first, "scenarios")))
        g[n++] = (struct wf_figure){ "scenarios", "scenarios", 0 };
    if (tree && wf_figures_say(j->folder, "tree", j->units, j->tongue, j->e)) return j->e->code;
    if (!write_plot_data(j->folder, j->document, j->units, &why)) {
        if (tree && !lines) code = draw_tree(j);
        return code ? code : draw_figures(j, g, n);
    }
    miss(j, "no-figures", &why);
    if (tree && !lines) code = add_figure(j, "tree", NULL, &why);
    for (size_t k = 0; k < n && !code; k++) code = add_figure(j, g[k].name, NULL, &why);
    return code;
}

/* Names in a document become parts of file names: only letters, digits and _ are allowed. */
static bool plain(const char *name)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    return name && *name && strlen(name) < 40 && name[strspn(name, allowed)] == '\0';
}

/* The figures that a document lists. */
static enum wf_status draw_listed(struct job *j)
{
    const json_t *list = json_object_get(j->results, "figures");
    size_t n = json_array_size(list);
    struct wf_figure *g = calloc(n + 1, sizeof *g);
    enum wf_status code = g ? WF_OK : wf_fail(j->e, WF_ENOMEM, "%s: no memory for the page", j->folder);
    for (size_t i = 0; i < n && !code; i++) {
        const json_t *f = json_array_get(list, i);
        json_int_t run = json_integer_value(json_object_get(f, "run"));
        g[i] =
            (struct wf_figure){ json_string_value(json_object_get(f, "name")),
                                json_string_value(json_object_get(f, "script")), run > 0 ? (size_t)run : 0 };
        if (!plain(g[i].name) || !plain(g[i].script))
            code = wf_fail(j->e, WF_EINPUT, "%s/results.json: figures: not a name of a figure", j->folder);
    }
    if (!code) code = draw_figures(j, g, n);
    free(g);
    return code;
}

/* The figures of a kind of document. */
static enum wf_status draw_kind(struct job *j)
{
    struct wf_figure g[WF_FIGURES_MAX];
    size_t n = 0;
    if (j->kind->figure == report_figures) return draw_report(j);
    enum wf_status code = wf_figures_say(j->folder, "run", j->units, j->tongue, j->e);
    if (code) return code;
    if (!j->kind->figure) return draw_listed(j);
    for (; j->kind->figure[n]; n++) g[n] = (struct wf_figure){ j->kind->figure[n], j->kind->figure[n], 0 };
    return draw_figures(j, g, n);
}

/* A page that a user's templates made: no program but the report's own. */
static enum wf_status clean_page(struct job *j, xmlDoc *page)
{
    xmlNode *script = xmlDocGetRootElement(j->document)->children;
    while (script && strcmp((const char *)script->name, "script") != 0) script = script->next;
    xmlChar *text = script ? xmlNodeGetContent(script) : NULL,
            *name = script ? xmlGetProp(script, BAD_CAST "name") : NULL;
    enum wf_status code = wf_template_clean(j->templates, page, (char *)text, (char *)name, j->e);
    xmlFree(text), xmlFree(name);
    return code;
}

static enum wf_status write_html(struct job *j, const char *html)
{
    bool whole = j->turned || j->templates; /* the page is looked at when it is whole, before it is written */
    char style[WF_PATH_MAX], name[64];
    struct wf_file f = { 0 };
    struct wf_err why = { 0 };
    xmlDoc *page;
    snprintf(name, sizeof name, "%s.xsl", j->kind->page);
    enum wf_status code = wf_template_path(j->templates, name, style, j->e);
    if (!code) code = wf_file_begin(&f, html, j->e);
    if (code) return code;
    code = wf_xml_transform(style, j->document, whole ? NULL : f.stream, &page, j->e);
    if (!code && j->templates) code = clean_page(j, page);
    if (!code && whole) code = wf_page_turn(j->units, page, f.stream, j->e);
    if (!code) code = wf_file_commit(&f, j->e);
    if (!code && j->docx &&
        wf_docx_make(j->folder, j->kind->page, page, j->drawn, j->figures_drawn, j->language, &why))
        miss(j, "no-docx", &why);
    if (page) xmlFreeDoc(page);
    wf_file_abandon(&f);
    return code;
}

/* FOLDER/PAGE.html, and from it, with a printer, PAGE.pdf. */
static enum wf_status write_page(struct job *j)
{
    char html[WF_PATH_MAX], name[64];
    struct wf_err why = { 0 };
    snprintf(name, sizeof name, "%s.html", j->kind->page);
    enum wf_status code = wf_folder_path(j->folder, name, html, j->e);
    if (!code) code = write_html(j, html);
    if (code || (code = check_interrupt(j)) || !j->printer) return code;
    if (wf_page_print(j->printer, j->folder, j->kind->page, &why)) {
        if (check_interrupt(j)) return WF_EINTERRUPTED;
        miss(j, "no-pdf", &why);
    }
    return WF_OK;
}

static bool is_system(const char *units)
{
    size_t i = 0;
    while (wf_page_units_word(i) && strcmp(wf_page_units_word(i), units) != 0) i++;
    return wf_page_units_word(i) != NULL;
}

enum wf_status wf_report_make(const char *folder, const struct wf_page_style *style,
                              struct wf_printer *printer, struct wf_diag *d, struct wf_err *e)
{
    struct job j = { .folder = folder,
                     .language = style && style->language ? style->language : "en",
                     .units = style && style->units ? style->units : "metric",
                     .templates = style ? style->templates : NULL,
                     .docx = style && style->docx,
                     .printer = printer,
                     .d = d,
                     .e = e,
                     .interrupted = wf_interrupted() };
    if (strcmp(j.language, "en") != 0 && strcmp(j.language, "zh") != 0)
        return wf_fail(e, WF_EUSAGE, "'%s' is not a language of the report; allowed: en, zh", j.language);
    if (!is_system(j.units))
        return wf_fail(e, WF_EUSAGE,
                       "'%s' is not a system of units of the report; allowed: metric, imperial, cn", j.units);
    j.turned = strcmp(j.units, "metric") != 0;
    enum wf_status code = j.templates ? wf_template_check(j.templates, e) : WF_OK;
    if (!code) code = read_results(&j);
    if (!code) code = make_document(&j);
    if (!code) code = add_pictures(&j);
    if (!code && j.kind->script) code = add_live(&j);
    if (!code) code = draw_kind(&j);
    if (!code) code = write_page(&j);
    if (j.document) xmlFreeDoc(j.document);
    wf_tongue_close(j.tongue);
    json_decref(j.results);
    free(j.drawn);
    return code ? code : j.first;
}
