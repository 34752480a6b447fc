/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/xml.h"
#include "base/arena.h"
#include "base/file.h"
#include "base/text.h"
#include <libxml/parser.h>
#include <libxslt/security.h>
#include <libxslt/transform.h>
#include <libxslt/xsltutils.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static xmlNode *text_element(xmlNode *parent, const char *name, const char *text)
{
    struct wf_arena a = { 0 };
    /* what stands on the head of a page stays as it was typed */
    bool typed = !strcmp(name, "title") || !strcmp((const char *)parent->name, "job");
    const char *bare = typed ? text : wf_text_without_folders(text, &a),
               *allowed = bare ? wf_text_for_xml(bare, &a) : NULL;
    xmlNode *node = allowed ? xmlNewTextChild(parent, NULL, BAD_CAST name, BAD_CAST allowed) : NULL;
    wf_arena_free(&a);
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
enum { WF_PLACED = WF_PATH_MAX + 500 };

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

/* libxml2 takes names for addresses, in which '%', '#' and '?' mean something. So the library is given names
 * of a room of its own, "/reports/NAME"; the file is read from this folder. */
static const char room[] = "/reports/";
static _Thread_local char shelf[WF_PATH_MAX]; /* the folder during a transform, ending in '/'; else empty */

/* NAME of "/reports/NAME" when it is a plain one. */
static const char *plain_name(const char *address)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyz0123456789_-.";
    if (!address || strncmp(address, room, strlen(room)) != 0) return NULL;
    const char *name = address + strlen(room);
    return *name && *name != '.' && !name[strspn(name, allowed)] ? name : NULL;
}

static int only_reports(xsltSecurityPrefs *rule, xsltTransformContext *run, const char *value)
{
    (void)rule, (void)run;
    return plain_name(value) != NULL;
}

/* The loader of everything a document refers to, its stylesheets' parts included. */
static xmlParserInput *load(const char *address, const char *id, xmlParserCtxt *parser)
{
    (void)id;
    char path[WF_PATH_MAX];
    struct wf_arena a = { 0 };
    struct wf_bytes text;
    const char *name = plain_name(address);
    xmlParserInput *input = NULL;
    int n = name && *shelf ? snprintf(path, sizeof path, "%s%s", shelf, name) : -1;
    if (n > 0 && n < WF_PATH_MAX && !wf_file_read(path, &a, &text, NULL)) {
        xmlParserInputBuffer *buffer =
            xmlParserInputBufferCreateMem(text.data, (int)text.size, XML_CHAR_ENCODING_NONE);
        input = buffer ? xmlNewIOInputStream(parser, buffer, XML_CHAR_ENCODING_NONE) : NULL;
        if (input)
            input->filename = (char *)xmlStrdup(BAD_CAST address);
        else
            xmlFreeParserInputBuffer(buffer);
    }
    wf_arena_free(&a);
    return input;
}

/* Parse a file under the address of its own, with nothing else read. */
static enum wf_status parse(const char *path, const char *address, xmlDoc **out, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_bytes text;
    *out = NULL;
    enum wf_status code = wf_file_read(path, &a, &text, e);
    xmlExternalEntityLoader before = xmlGetExternalEntityLoader();
    xmlSetExternalEntityLoader(load);
    xmlResetLastError();
    if (!code)
        *out = xmlReadMemory(text.data, (int)text.size, address, "UTF-8",
                             XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
    xmlSetExternalEntityLoader(before);
    if (!code && !*out) {
        const xmlError *why = xmlGetLastError();
        code = wf_fail(e, WF_EINPUT, "%s:%d: %s", path, why ? why->line : 0,
                       why && why->message ? why->message : "cannot be read");
    }
    wf_arena_free(&a);
    return code;
}

enum wf_status wf_xml_read(const char *path, xmlDoc **out, struct wf_err *e)
{
    return parse(path, "picture.svg", out, e);
}

/* What libxslt says of a stylesheet, with the file and line where it says so first: "FOLDER/NAME:LINE: ...".
 */
static const char *placed(const struct complaint *c, const char *path, char text[static WF_PLACED])
{
    int folder = strrchr(path, '/') ? (int)(strrchr(path, '/') - path) + 1 : 0, wide = 0;
    unsigned line = 0;
    const char *at = strstr(c->text, room), *rest = c->text, *name = at ? at + strlen(room) : NULL;
    size_t n = name ? strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_-.") : 0;
    if (n &&
        (sscanf(name + n, " line %u%n", &line, &wide) == 1 || sscanf(name + n, ":%u:%n", &line, &wide) == 1))
        rest = name + n + wide;
    while (*rest == ' ') rest++;
    if (line)
        (void)snprintf(text, WF_PLACED, "%.*s%.*s:%u: %s", folder, path, (int)n, name, line, rest);
    else
        (void)snprintf(text, WF_PLACED, "%s: %s", path, c->text);
    size_t end = strlen(text);
    while (end && text[end - 1] == ' ') text[--end] = '\0';
    return text;
}

/* What a stylesheet may do: read the files of its own folder. */
static xsltSecurityPrefs *restrictions(void)
{
    static const xsltSecurityOption forbidden[] = { XSLT_SECPREF_WRITE_FILE, XSLT_SECPREF_CREATE_DIRECTORY,
                                                    XSLT_SECPREF_READ_NETWORK, XSLT_SECPREF_WRITE_NETWORK };
    xsltSecurityPrefs *rule = xsltNewSecurityPrefs();
    for (size_t i = 0; rule && i < sizeof forbidden / sizeof *forbidden; i++)
        xsltSetSecurityPrefs(rule, forbidden[i], xsltSecurityForbid);
    if (rule) xsltSetSecurityPrefs(rule, XSLT_SECPREF_READ_FILE, only_reports);
    return rule;
}

/* Of one transform, against a stylesheet that does not end; a report of 30 trees takes 11 millions of them.
 */
enum { OPERATIONS = 100 * 1000 * 1000 };

static enum wf_status apply(xsltStylesheet *style, xmlDoc *document, FILE *f, struct complaint *c,
                            xsltSecurityPrefs *rule, xmlDoc **out, const char *path, struct wf_err *e)
{
    xsltTransformContext *run = xsltNewTransformContext(style, document);
    enum wf_status code = WF_OK;
    if (!run || xsltSetCtxtSecurityPrefs(rule, run))
        code = wf_fail(e, WF_ENOMEM, "%s: no memory to apply it", path);
    if (!code) {
        char text[WF_PLACED];
        xsltSetTransformErrorFunc(run, c, keep);
        run->opLimit = OPERATIONS;
        run->xpathCtxt->opLimit = OPERATIONS;
        *out = xsltApplyStylesheetUser(style, document, NULL, NULL, NULL, run);
        if (!*out || run->state != XSLT_STATE_OK || c->text[0])
            code = wf_fail(e, WF_EOUTPUT, "%s", placed(c, path, text));
        else if (f && xsltSaveResultToFile(f, *out, style) < 0 && !ferror(f))
            code = wf_fail(e, WF_ENOMEM, "%s: not enough memory to write its result", path);
    }
    if (run) xsltFreeTransformContext(run);
    return code;
}

static enum wf_status compile_and_apply(xmlDoc *source, xmlDoc *document, FILE *f, struct complaint *c,
                                        xmlDoc **out, const char *path, struct wf_err *e)
{
    enum wf_status code;
    char text[WF_PLACED];
    xsltSecurityPrefs *rule = restrictions(), *usual = xsltGetDefaultSecurityPrefs();
    xsltSetDefaultSecurityPrefs(rule); /* imports are checked by the default ones */
    xsltStylesheet *style = rule ? xsltParseStylesheetDoc(source) : NULL;
    if (!style) {
        xmlFreeDoc(source);
        code = rule ? wf_fail(e, WF_EINPUT, "%s", placed(c, path, text))
                    : wf_fail(e, WF_ENOMEM, "%s: no memory to apply it", path);
    } else if (style->errors) {
        code = wf_fail(e, WF_EINPUT, "%s", placed(c, path, text));
    } else {
        code = apply(style, document, f, c, rule, out, path, e);
    }
    xsltSetDefaultSecurityPrefs(usual);
    if (style) xsltFreeStylesheet(style);
    if (rule) xsltFreeSecurityPrefs(rule);
    return code;
}

enum wf_status wf_xml_transform(const char *path, xmlDoc *document, FILE *f, xmlDoc **out, struct wf_err *e)
{
    struct complaint c = { "" };
    char address[300];
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash - path) + 1 : 0;
    xmlDoc *source;
    *out = NULL;
    snprintf(address, sizeof address, "%s%.255s", room, path + folder);
    enum wf_status code = parse(path, address, &source, e);
    if (code) return code;
    snprintf(shelf, sizeof shelf, "%.*s", folder, path);
    if (!folder) snprintf(shelf, sizeof shelf, "./");
    /* libxml2 and libxslt report a faulty stylesheet or a full disk to process-wide handlers; they and the
     * loader are replaced during this call only. */
    xmlExternalEntityLoader before_load = xmlGetExternalEntityLoader();
    xmlGenericErrorFunc before = xsltGenericError, before_xml = xmlGenericError;
    void *context = xsltGenericErrorContext, *context_xml = xmlGenericErrorContext;
    xmlSetExternalEntityLoader(load);
    xsltSetGenericErrorFunc(&c, keep);
    xmlSetGenericErrorFunc(&c, keep);
    code = compile_and_apply(source, document, f, &c, out, path, e);
    xsltSetGenericErrorFunc(context, before);
    xmlSetGenericErrorFunc(context_xml, before_xml);
    xmlSetExternalEntityLoader(before_load);
    shelf[0] = '\0';
    if (code && *out) {
        xmlFreeDoc(*out);
        *out = NULL;
    }
    return code;
}
