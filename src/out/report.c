#include "out/report.h"
#include "base/file.h"
#include "out/figures.h"
#include "out/page.h"
#include "out/results.h"
#include "out/tables.h"
#include "out/tree_picture.h"
#include "out/xml.h"
#include <string.h>
#include <unistd.h>

struct job {
    const char *folder, *language;
    xmlDoc *document; /* <report lang="en"><results/><figures/><css/></report>, what report.xsl reads */
    xmlNode *figures;
    struct wf_diag *d;
    struct wf_err *e;
    bool around;          /* the results hold winds from all directions */
    enum wf_status first; /* of the parts that could not be made */
};

static enum wf_status path_of(const char *folder, const char *name, char path[static WF_PATH_MAX],
                              struct wf_err *e)
{
    int n = snprintf(path, WF_PATH_MAX, "%s/%s", folder, name);
    if (n >= 0 && n < WF_PATH_MAX) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%.200s...: the name is too long", folder);
}

/* A part that cannot be made is a warning, and the others are made all the same. */
static void miss(struct job *j, const char *part, const struct wf_err *why)
{
    wf_diag_warn(j->d, part, "%s", why->text);
    if (j->first) return;
    j->first = wf_fail(j->e, why->code, "%s", why->text);
}

static enum wf_status read_results(const char *folder, json_t **out, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    json_error_t why;
    *out = NULL;
    enum wf_status code = path_of(folder, "results.json", path, e);
    if (code) return code;
    if (access(path, R_OK))
        return wf_fail(e, WF_EINPUT, "%s: cannot be read; is '%s' a results folder?", path, folder);
    *out = json_load_file(path, JSON_REJECT_DUPLICATES, &why);
    if (!*out) return wf_fail(e, WF_EINPUT, "%s:%d:%d: error: %s", path, why.line, why.column, why.text);
    const json_t *schema = json_object_get(*out, "schema");
    const char *name = json_string_value(json_object_get(schema, "name"));
    json_int_t version = json_integer_value(json_object_get(schema, "version"));
    if (!name || strcmp(name, WF_RESULTS_SCHEMA) != 0)
        code = wf_fail(e, WF_EINPUT, "%s: is not a results document of windfirm", path);
    else if (!wf_results_readable(version, WF_RESULTS_VERSION))
        code = wf_fail(e, WF_EINPUT, "%s: results of version %lld; this program reads version %d%s", path,
                       (long long)version, WF_RESULTS_VERSION,
                       WF_RESULTS_VERSION > 1 ? " and the one before" : "");
    else if (!json_array_size(json_object_get(*out, "trees")))
        code = wf_fail(e, WF_EINPUT, "%s: trees: at least one is needed", path);
    for (size_t i = 0; !code && wf_tables[i].name; i++) {
        if (wf_tables[i].made) continue; /* not every run has it */
        code = path_of(folder, wf_tables[i].name, path, e);
        if (!code && access(path, R_OK)) code = wf_fail(e, WF_EINPUT, "%s: cannot be read", path);
    }
    return code;
}

static enum wf_status make_document(struct job *j)
{
    char path[WF_PATH_MAX];
    json_t *results;
    struct wf_arena scratch = { 0 };
    struct wf_bytes css = { 0 };
    enum wf_status code = read_results(j->folder, &results, j->e);
    if (!code) code = wf_report_asset("report.css", path, sizeof path, j->e);
    if (!code) code = wf_file_read_text(path, &scratch, &css, j->e);
    if (!code) {
        j->document = xmlNewDoc(BAD_CAST "1.0");
        xmlNode *root = j->document ? xmlNewDocNode(j->document, NULL, BAD_CAST "report", NULL) : NULL;
        if (root) xmlDocSetRootElement(j->document, root);
        if (!root || !xmlNewProp(root, BAD_CAST "lang", BAD_CAST j->language) ||
            !wf_xml_from_json(root, "results", results) ||
            !xmlNewTextChild(root, NULL, BAD_CAST "css", BAD_CAST css.data) ||
            !(j->figures = xmlNewChild(root, NULL, BAD_CAST "figures", NULL)))
            code = wf_fail(j->e, WF_ENOMEM, "%s: no memory for the report", j->folder);
    }
    j->around =
        json_is_object(json_object_get(json_array_get(json_object_get(results, "trees"), 0), "directions"));
    json_decref(results);
    wf_arena_free(&scratch);
    return code;
}

/* Draw one figure, by a way of its own or as all others, and hang it into the document. `unready`: why none
 * can be drawn, NULL when they can. */
static enum wf_status add_figure(struct job *j, const char *name,
                                 enum wf_status (*own)(const char *, xmlDoc **, struct wf_err *),
                                 const struct wf_err *unready)
{
    struct wf_err why = { 0 };
    xmlDoc *svg = NULL;
    xmlNode *node = xmlNewChild(j->figures, NULL, BAD_CAST "figure", NULL);
    if (!node || !xmlNewProp(node, BAD_CAST "name", BAD_CAST name))
        return wf_fail(j->e, WF_ENOMEM, "%s: no memory for the report", j->folder);
    if (unready) {
        xmlNewProp(node, BAD_CAST "missing", BAD_CAST unready->text);
        return WF_OK;
    }
    if (own ? own(j->folder, &svg, &why) : wf_figures_draw(j->folder, name, &svg, &why)) {
        xmlNewProp(node, BAD_CAST "missing", BAD_CAST why.text);
        miss(j, "no-figure", &why);
        return WF_OK;
    }
    xmlNode *picture = xmlDocCopyNode(xmlDocGetRootElement(svg), j->document, 1);
    xmlFreeDoc(svg);
    if (!picture) return wf_fail(j->e, WF_ENOMEM, "%s: no memory for the report", j->folder);
    xmlAddChild(node, picture);
    return WF_OK;
}

/* Draw every figure and hang it into the document: <figure name="tip"><svg/></figure>, or the attribute
 * missing="why". */
static enum wf_status draw_figures(struct job *j)
{
    struct wf_err why = { 0 };
    bool ready = !wf_figures_prepare(j->folder, j->document, &why);
    if (!ready) miss(j, "no-figures", &why);
    bool branched = wf_tree_picture_there(j->folder);
    enum wf_status code =
        branched ? add_figure(j, "tree", wf_tree_picture_report, ready ? NULL : &why) : WF_OK;
    for (size_t i = 0; !code && wf_figures[i]; i++)
        code = add_figure(j, wf_figures[i], NULL, ready ? NULL : &why);
    if (!code && j->around) code = add_figure(j, "directions", NULL, ready ? NULL : &why);
    return code;
}

static enum wf_status write_page(struct job *j, const char *html)
{
    char style[WF_PATH_MAX];
    struct wf_file f = { 0 };
    xmlDoc *page;
    enum wf_status code = wf_report_asset("report.xsl", style, sizeof style, j->e);
    if (!code) code = wf_file_begin(&f, html, j->e);
    if (code) return code;
    code = wf_xml_transform(style, j->document, NULL, f.stream, &page, j->e);
    if (!code) {
        xmlFreeDoc(page);
        code = wf_file_commit(&f, j->e);
    }
    wf_file_abandon(&f);
    return code;
}

static enum wf_status print_page(struct job *j, const char *html, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    enum wf_status code = path_of(j->folder, "report.pdf", path, e);
    return code ? code : wf_page_print(html, path, e);
}

enum wf_status wf_report_make(const char *folder, const char *language, struct wf_diag *d, struct wf_err *e)
{
    char html[WF_PATH_MAX];
    struct job j = { .folder = folder, .language = language ? language : "en", .d = d, .e = e };
    if (strcmp(j.language, "en") != 0 && strcmp(j.language, "zh") != 0)
        return wf_fail(e, WF_EUSAGE, "'%s' is not a language of the report; allowed: en, zh", language);
    enum wf_status code = path_of(folder, "report.html", html, e);
    if (!code) code = make_document(&j);
    if (!code) code = draw_figures(&j);
    if (!code) code = write_page(&j, html);
    struct wf_err why = { 0 };
    if (!code && print_page(&j, html, &why)) miss(&j, "no-pdf", &why);
    if (j.document) xmlFreeDoc(j.document);
    return code ? code : j.first;
}
