/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figures and pages of a calibration, from its folder alone. */
#include "base/file.h"
#include "out/figures.h"
#include "out/fit_results.h"
#include "out/page.h"
#include "out/xml.h"
#include <string.h>

static const char *const figures[] = { "fit_readings", "fit_residuals", "fit_profiles", "fit_records", NULL };

static void miss(struct wf_diag *d, const char *part, const struct wf_err *why, struct wf_err *e)
{
    wf_diag_warn(d, part, "%s", why->text);
    if (!e->code) wf_fail(e, why->code, "%s", why->text);
}

static void draw(const char *folder, xmlNode *parent, struct wf_diag *d, struct wf_err *e)
{
    for (size_t i = 0; figures[i]; i++) {
        xmlDoc *svg = NULL;
        struct wf_err why = { 0 };
        xmlNode *node = xmlNewChild(parent, NULL, BAD_CAST "figure", NULL);
        if (!node) return;
        xmlNewProp(node, BAD_CAST "name", BAD_CAST figures[i]);
        if (wf_figures_draw(folder, &(struct wf_figure){ figures[i], figures[i], 0 }, "en", &svg, &why)) {
            xmlNewProp(node, BAD_CAST "missing", BAD_CAST why.text);
            miss(d, "no-figure", &why, e);
            continue;
        }
        xmlNode *picture = xmlDocCopyNode(xmlDocGetRootElement(svg), parent->doc, 1);
        if (picture) xmlAddChild(node, picture);
        xmlFreeDoc(svg);
    }
}

static enum wf_status page(const char *html, xmlDoc *document, struct wf_err *e)
{
    char style[WF_PATH_MAX];
    struct wf_file f = { 0 };
    xmlDoc *made;
    enum wf_status s = wf_report_asset("calibration.xsl", style, sizeof style, e);
    if (!s) s = wf_file_begin(&f, html, e);
    if (s) return s;
    s = wf_xml_transform(style, document, NULL, f.stream, &made, e);
    if (!s) {
        xmlFreeDoc(made);
        s = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    return s;
}

enum wf_status wf_fit_results_pages(const char *folder, struct wf_diag *d, struct wf_err *e)
{
    char path[WF_PATH_MAX], html[WF_PATH_MAX], pdf[WF_PATH_MAX];
    struct wf_arena a = { 0 };
    struct wf_bytes css = { 0 };
    json_error_t why;
    struct wf_err part = { 0 };
    snprintf(path, sizeof path, "%s/results.json", folder);
    snprintf(html, sizeof html, "%s/calibration.html", folder);
    snprintf(pdf, sizeof pdf, "%s/calibration.pdf", folder);
    json_t *results = json_load_file(path, 0, &why);
    if (!results) return wf_fail(e, WF_EINPUT, "%s:%d: %s", path, why.line, why.text);
    enum wf_status s = wf_report_asset("report.css", path, sizeof path, e);
    if (!s) s = wf_file_read_text(path, &a, &css, e);
    xmlDoc *document = s ? NULL : xmlNewDoc(BAD_CAST "1.0");
    xmlNode *root = document ? xmlNewDocNode(document, NULL, BAD_CAST "report", NULL) : NULL;
    if (root) xmlDocSetRootElement(document, root);
    if (!s && (!root || !wf_xml_from_json(root, "results", results) ||
               !xmlNewTextChild(root, NULL, BAD_CAST "css", BAD_CAST css.data)))
        s = wf_fail(e, WF_ENOMEM, "%s: no memory for the report", folder);
    xmlNode *drawn = s ? NULL : xmlNewChild(root, NULL, BAD_CAST "figures", NULL);
    if (drawn) draw(folder, drawn, d, e);
    if (!s) s = page(html, document, e);
    if (!s && wf_page_print(html, pdf, &part)) miss(d, "no-pdf", &part, e);
    if (document) xmlFreeDoc(document);
    json_decref(results);
    wf_arena_free(&a);
    return s ? s : e->code;
}
