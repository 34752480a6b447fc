/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/doc.h"
#include "base/text.h"
#include <libxml/parser.h>
#include <libxml/tree.h>
#include <libxslt/security.h>
#include <libxslt/transform.h>
#include <libxslt/xsltutils.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* XML 1.0 allows no control characters except tab and line ends: the others are replaced by spaces. */
static xmlNode *text_element(xmlNode *parent, const char *name, const char *text)
{
    char *copy = strdup(text);
    if (!copy) return NULL;
    for (char *c = copy; *c; c++)
        if ((unsigned char)*c < 0x20 && !strchr("\t\n\r", *c)) *c = ' ';
    xmlNode *node = xmlNewTextChild(parent, NULL, BAD_CAST name, BAD_CAST copy);
    free(copy);
    return node;
}

static xmlNode *scalar(xmlNode *parent, const char *name, const json_t *value)
{
    char digits[40];
    switch (json_typeof(value)) {
    case JSON_STRING:
        return text_element(parent, name, json_string_value(value));
    case JSON_TRUE:
        return text_element(parent, name, "true");
    case JSON_FALSE:
        return text_element(parent, name, "false");
    case JSON_INTEGER:
        snprintf(digits, sizeof digits, "%" JSON_INTEGER_FORMAT, json_integer_value(value));
        break;
    case JSON_REAL:
        snprintf(digits, sizeof digits, "%.17g", json_real_value(value));
        break;
    default: {
        xmlNode *node = xmlNewChild(parent, NULL, BAD_CAST name, NULL);
        if (node) xmlNewProp(node, BAD_CAST "null", BAD_CAST "yes");
        return node;
    }
    }
    return text_element(parent, name, digits);
}

xmlNode *wf_xml_from_json(xmlNode *parent, const char *name, const json_t *value)
{
    if (!json_is_object(value) && !json_is_array(value)) return scalar(parent, name, value);
    xmlNode *node = xmlNewChild(parent, NULL, BAD_CAST name, NULL);
    if (!node) return NULL;
    for (size_t i = 0; i < json_array_size(value); i++)
        if (!wf_xml_from_json(node, "item", json_array_get(value, i))) return NULL;
    if (!json_is_object(value)) return node;
    /* jansson's iterator needs an object that is not const, although it does not change it. */
    union {
        const json_t *given;
        json_t *wanted;
    } object = { .given = value };
    for (void *at = json_object_iter(object.wanted); at; at = json_object_iter_next(object.wanted, at)) {
        const char *key = json_object_iter_key(at);
        if (xmlValidateNCName(BAD_CAST key, 0)) continue;
        if (!wf_xml_from_json(node, key, json_object_iter_value(at))) return NULL;
    }
    return node;
}

/* Collects what libxml2 and libxslt would otherwise print. */
struct complaint {
    char text[400];
};

__attribute__((format(printf, 2, 3))) static void keep(void *context, const char *fmt, ...)
{
    struct complaint *c = context;
    size_t used = strlen(c->text);
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(c->text + used, sizeof c->text - used, fmt, args);
    va_end(args);
    for (char *p = c->text; *p; p++)
        if (*p == '\n') *p = ' ';
}

enum wf_status wf_xml_read(const char *path, xmlDoc **out, struct wf_err *e)
{
    *out = xmlReadFile(path, "UTF-8", XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
    if (*out) return WF_OK;
    const xmlError *why = xmlGetLastError();
    return wf_fail(e, WF_EINPUT, "%s:%d: %s", path, why ? why->line : 0,
                   why && why->message ? why->message : "cannot be read");
}

static enum wf_status apply(xsltStylesheet *style, xmlDoc *document, const char **parameters, FILE *f,
                            struct complaint *c, xmlDoc **out, const char *path, struct wf_err *e)
{
    xsltTransformContext *run = xsltNewTransformContext(style, document);
    xsltSecurityPrefs *rule = xsltNewSecurityPrefs();
    enum wf_status code = WF_OK;
    if (!run || !rule) {
        code = wf_fail(e, WF_ENOMEM, "%s: no memory to apply it", path);
    } else {
        xsltSetSecurityPrefs(rule, XSLT_SECPREF_WRITE_FILE, xsltSecurityForbid);
        xsltSetSecurityPrefs(rule, XSLT_SECPREF_CREATE_DIRECTORY, xsltSecurityForbid);
        xsltSetSecurityPrefs(rule, XSLT_SECPREF_READ_NETWORK, xsltSecurityForbid);
        xsltSetSecurityPrefs(rule, XSLT_SECPREF_WRITE_NETWORK, xsltSecurityForbid);
        xsltSetCtxtSecurityPrefs(rule, run);
        xsltSetTransformErrorFunc(run, c, keep);
        *out = xsltApplyStylesheetUser(style, document, parameters, NULL, NULL, run);
        if (!*out || run->state != XSLT_STATE_OK)
            code = wf_fail(e, WF_EOUTPUT, "%s: cannot be applied: %s", path, c->text);
        else if (f && xsltSaveResultToFile(f, *out, style) < 0 && !ferror(f))
            code = wf_fail(e, WF_ENOMEM, "%s: not enough memory to write its result", path);
    }
    if (run) xsltFreeTransformContext(run);
    if (rule) xsltFreeSecurityPrefs(rule);
    return code;
}

enum wf_status wf_xml_transform(const char *path, xmlDoc *document, const char **parameters, FILE *f,
                                xmlDoc **out, struct wf_err *e)
{
    struct complaint c = { "" };
    xmlDoc *source;
    *out = NULL;
    enum wf_status code = wf_xml_read(path, &source, e);
    if (code) return code;
    /* libxml2 and libxslt report a faulty stylesheet or a full disk to process-wide handlers; they are
     * replaced during this call only. */
    xmlGenericErrorFunc before = xsltGenericError, before_xml = xmlGenericError;
    void *context = xsltGenericErrorContext, *context_xml = xmlGenericErrorContext;
    xsltSetGenericErrorFunc(&c, keep);
    xmlSetGenericErrorFunc(&c, keep);
    xsltStylesheet *style = xsltParseStylesheetDoc(source);
    if (!style) {
        xmlFreeDoc(source);
        code = wf_fail(e, WF_EINPUT, "%s: is not a stylesheet: %s", path, c.text);
    } else if (style->errors) {
        code = wf_fail(e, WF_EINPUT, "%s: %s", path, c.text);
    } else {
        code = apply(style, document, parameters, f, &c, out, path, e);
    }
    xsltSetGenericErrorFunc(context, before);
    xmlSetGenericErrorFunc(context_xml, before_xml);
    if (style) xsltFreeStylesheet(style);
    if (code && *out) {
        xmlFreeDoc(*out);
        *out = NULL;
    }
    return code;
}

static json_t *made(struct wf_doc *d, json_t *value)
{
    if (!value) d->failed = true;
    return value;
}

json_t *wf_doc_object(struct wf_doc *d) { return made(d, json_object()); }
json_t *wf_doc_array(struct wf_doc *d) { return made(d, json_array()); }

json_t *wf_doc_put(struct wf_doc *d, json_t *object, const char *key, json_t *value)
{
    if (json_object_set_new(object, key, value)) d->failed = true;
    return value;
}

json_t *wf_doc_add(struct wf_doc *d, json_t *array, json_t *value)
{
    if (json_array_append_new(array, value)) d->failed = true;
    return value;
}

/* A path or a command line may hold any bytes; what is not UTF-8 is shown as '?'. */
static json_t *readable(const char *text)
{
    struct wf_utf8_fault fault;
    size_t n = strlen(text);
    if (wf_utf8_valid(text, n, &fault)) return json_string(text);
    char *copy = strdup(text);
    if (!copy) return NULL;
    for (char *c = copy; *c; c++)
        if ((unsigned char)*c >= 0x80) *c = '?';
    json_t *value = json_string(copy);
    free(copy);
    return value;
}

void wf_doc_text(struct wf_doc *d, json_t *object, const char *key, const char *text)
{
    wf_doc_put(d, object, key, text ? readable(text) : json_null());
}

void wf_doc_count(struct wf_doc *d, json_t *object, const char *key, size_t n)
{
    wf_doc_put(d, object, key, json_integer((json_int_t)n));
}

void wf_doc_flag(struct wf_doc *d, json_t *object, const char *key, bool flag)
{
    wf_doc_put(d, object, key, json_boolean(flag));
}

/* json_real refuses NaN and infinity, which JSON cannot represent. */
static json_t *number(double x) { return isfinite(x) ? json_real(x) : json_null(); }

void wf_doc_number(struct wf_doc *d, json_t *object, const char *key, double x)
{
    wf_doc_put(d, object, key, number(x));
}

json_t *wf_doc_quantity(struct wf_doc *d, json_t *object, const char *key, double x, const char *unit,
                        const char *reason)
{
    json_t *q = wf_doc_put(d, object, key, wf_doc_object(d));
    wf_doc_number(d, q, "value", x);
    wf_doc_text(d, q, "unit", unit);
    if (!isfinite(x)) wf_doc_text(d, q, "reason", reason ? reason : "not a finite number");
    return q;
}

void wf_doc_numbers(struct wf_doc *d, json_t *object, const char *key, const double *x, size_t n)
{
    json_t *list = wf_doc_put(d, object, key, wf_doc_array(d));
    for (size_t i = 0; i < n; i++) wf_doc_add(d, list, number(x[i]));
}

json_t *wf_doc_begin(struct wf_doc *d, const char *schema, const struct wf_doc_head *h)
{
    json_t *o = wf_doc_object(d), *s = wf_doc_put(d, o, "schema", wf_doc_object(d));
    wf_doc_text(d, s, "name", schema);
    wf_doc_count(d, s, "version", 1);
    wf_doc_text(d, o, "title", h->title);
    wf_doc_text(d, o, "note", h->note);
    json_t *p = wf_doc_put(d, o, "provenance", wf_doc_object(d));
    wf_doc_text(d, p, "program", "windfirm");
    wf_doc_text(d, p, "version", h->version);
    wf_doc_text(d, p, "date", h->date);
    wf_doc_text(d, p, "command", h->command);
    return o;
}

void wf_doc_figure(struct wf_doc *d, json_t *list, const char *name, const char *script, size_t run)
{
    json_t *o = wf_doc_add(d, list, wf_doc_object(d));
    wf_doc_text(d, o, "name", name);
    wf_doc_text(d, o, "script", script);
    wf_doc_count(d, o, "run", run);
}

static bool said(const json_t *list, const char *text)
{
    for (size_t i = 0; i < json_array_size(list); i++) {
        const char *t = json_string_value(json_object_get(json_array_get(list, i), "text"));
        if (t && !strcmp(t, text)) return true;
    }
    return false;
}

void wf_doc_warnings(struct wf_doc *d, json_t *list, const struct wf_diag *diag)
{
    for (const struct wf_finding *w = diag ? diag->first : NULL; w; w = w->next) {
        if (said(list, w->text)) continue;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "code", w->code);
        wf_doc_text(d, o, "text", w->text);
    }
}

enum wf_status wf_doc_end(struct wf_doc *d, json_t *document, const char *folder, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_folder_begin(&f, folder, "results.json", e);
    if (!s && (d->failed || json_dumpf(document, f.stream, JSON_INDENT(1) | JSON_REAL_PRECISION(12))) &&
        !ferror(f.stream))
        s = wf_fail(e, WF_ENOMEM, "%s: no memory for the document", folder);
    if (!s) {
        putc('\n', f.stream);
        s = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    json_decref(document);
    return s;
}

enum { TEXT_MAX = 1024 }; /* a title or a label; longer ones are cut [bytes] */

enum wf_status wf_plot_data_begin(struct wf_plot_data *p, const char *folder, const char *name,
                                  struct wf_err *e)
{
    char file[64];
    snprintf(file, sizeof file, "plots/%.40s.csv", name);
    *p = (struct wf_plot_data){ 0 };
    enum wf_status s = wf_folder_begin(&p->f, folder, file, e);
    if (!s) fputs("key,index,value\n", p->f.stream);
    return s;
}

void wf_plot_data_number(struct wf_plot_data *p, const char *key, size_t index, double x)
{
    char text[40];
    snprintf(text, sizeof text, "%.15g", x);
    char *e = strchr(text, 'e');
    if (!isfinite(x))
        fprintf(p->f.stream, "%s,%zu,NaN\n", key, index);
    else if (e && !strchr(text, '.')) /* in a text, gnuplot reads 1e-5 as the whole number 1 */
        fprintf(p->f.stream, "%s,%zu,%.*s.0%s\n", key, index, (int)(e - text), text, e);
    else
        fprintf(p->f.stream, "%s,%zu,%s\n", key, index, text);
}

void wf_plot_data_count(struct wf_plot_data *p, const char *key, size_t index, size_t n)
{
    fprintf(p->f.stream, "%s,%zu,%zu\n", key, index, n);
}

void wf_plot_data_text(struct wf_plot_data *p, const char *key, size_t index, const char *text)
{
    FILE *f = p->f.stream;
    fprintf(f, "%s,%zu,\"", key, index);
    for (const char *c = text ? text : ""; *c; c++)
        if (*c == '"' || *c == ',' || *c == '\\')
            fprintf(f, "\\%03o", (unsigned)*c);
        else
            fputc((unsigned char)*c < 0x20 ? ' ' : *c, f);
    fputs("\"\n", f);
}

/* Shorten a text that fills its buffer to end with a complete UTF-8 character. */
static void cut(char *text)
{
    size_t n = strlen(text);
    if (n < TEXT_MAX - 1) return;
    while (n > 0 && ((unsigned char)text[n - 1] & 0xc0) == 0x80) n--;
    if (n > 0 && (unsigned char)text[n - 1] >= 0xc0) n--;
    text[n] = '\0';
}

void wf_plot_data_print(struct wf_plot_data *p, const char *key, size_t index, const char *fmt, ...)
{
    char text[TEXT_MAX];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    cut(text);
    wf_plot_data_text(p, key, index, text);
}

enum wf_status wf_plot_data_parse(struct wf_plot_data *p, const char *key, size_t index, const char *text,
                                  struct wf_err *e)
{
    char *end;
    double x = strtod(text, &end);
    if (end == text || *end) return wf_fail(e, WF_EINPUT, "%s: '%.100s' is not a number", key, text);
    wf_plot_data_number(p, key, index, x);
    return WF_OK;
}

enum wf_status wf_plot_data_end(struct wf_plot_data *p, struct wf_err *e) { return wf_file_commit(&p->f, e); }
