/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/xml.h"
#include <libxml/parser.h>
#include <libxml/tree.h>
#include <libxslt/security.h>
#include <libxslt/transform.h>
#include <libxslt/xsltutils.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* XML 1.0 has no control characters but tab and the line ends: the others become spaces. */
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
    /* jansson walks an object by an iterator that is not const, and leaves the object as it was. */
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

/* What libxml2 and libxslt would print is kept here instead. */
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
        else if (f && xsltSaveResultToFile(f, *out, style) < 0)
            code = wf_fail(e, WF_EOUTPUT, "%s: its result cannot be written", path);
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
    /* A faulty stylesheet and a full disk are reported to process-wide handlers; they are ours for this call
     * only. */
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
