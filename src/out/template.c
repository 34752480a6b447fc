/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/template.h"
#include "base/arena.h"
#include "out/picture.h"
#include "out/program.h"
#include "out/xml.h"
#include <dirent.h>
#include <errno.h>
#include <libxml/parserInternals.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static bool ends_in(const char *name, const char *tail)
{
    size_t n = strlen(name), k = strlen(tail);
    return n > k && !strcmp(name + n - k, tail);
}

/* Files of reports/ that are templates. figures.xsl and svg.xsl make data and pictures, not pages. */
static bool is_template(const char *name)
{
    if (!strcmp(name, "figures.xsl") || !strcmp(name, "svg.xsl")) return false;
    return ends_in(name, ".xsl") || !strcmp(name, "report.css") || !strcmp(name, "strings.xml");
}

enum wf_status wf_template_path(const char *folder, const char *name, char path[static WF_PATH_MAX],
                                struct wf_err *e)
{
    if (!folder) return wf_report_asset(name, path, WF_PATH_MAX, e);
    int n = snprintf(path, WF_PATH_MAX, "%s/%s", folder, name);
    return n > 0 && n < WF_PATH_MAX ? WF_OK : wf_fail(e, WF_EINPUT, "%s: the name is too long", folder);
}

/* Call what for every shipped template. */
typedef enum wf_status each(const char *folder, const char *name, const char *shipped, struct wf_err *e);

static enum wf_status for_each(const char *folder, each *what, struct wf_err *e)
{
    char path[WF_PATH_MAX], shipped[WF_PATH_MAX];
    enum wf_status s = wf_report_asset("strings.xml", path, sizeof path, e);
    if (s) return s;
    *strrchr(path, '/') = '\0';
    DIR *d = opendir(path);
    if (!d) return wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, strerror(errno));
    for (struct dirent *x; !s && (x = readdir(d));) {
        if (!is_template(x->d_name)) continue;
        s = wf_report_asset(x->d_name, shipped, sizeof shipped, e);
        if (!s) s = what(folder, x->d_name, shipped, e);
    }
    closedir(d);
    return s;
}

static enum wf_status check_one(const char *folder, const char *name, const char *shipped, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    struct stat is;
    struct wf_arena a = { 0 };
    struct wf_bytes text;
    xmlDoc *document = NULL;
    (void)shipped;
    enum wf_status s = wf_template_path(folder, name, path, e);
    if (!s && lstat(path, &is))
        s = wf_fail(e, WF_EINPUT, "%s: %s; 'windfirm init template NAME' writes a folder with all templates",
                    path, strerror(errno));
    else if (!s && !S_ISREG(is.st_mode))
        s = wf_fail(e, WF_EINPUT, "%s: must be a file, and no link", path);
    if (!s) s = wf_file_read_text(path, &a, &text, e);
    const char *at = s ? NULL : strstr(text.data, "<!DOCTYPE");
    if (at) {
        size_t line = 1;
        for (const char *p = text.data; p < at; p++) line += *p == '\n';
        s = wf_fail(e, WF_EINPUT, "%s:%zu: a template has no DOCTYPE", path, line);
    }
    if (!s && !ends_in(name, ".css")) s = wf_xml_read(path, &document, e);
    if (document) xmlFreeDoc(document);
    wf_arena_free(&a);
    return s;
}

/* Is results.json in the folder, or in one that it is in? */
static bool holds_results(const char *folder)
{
    char path[WF_PATH_MAX], at[WF_PATH_MAX + 16];
    if (!realpath(folder, path)) return false;
    for (char *slash; (slash = strrchr(path, '/')); *slash = '\0') {
        snprintf(at, sizeof at, "%s/results.json", path);
        if (!access(at, F_OK)) return true;
    }
    return false;
}

enum wf_status wf_template_check(const char *folder, struct wf_err *e)
{
    struct stat is;
    if (stat(folder, &is)) return wf_fail(e, WF_EINPUT, "%s: %s", folder, strerror(errno));
    if (!S_ISDIR(is.st_mode)) return wf_fail(e, WF_EINPUT, "%s: is no folder", folder);
    if (holds_results(folder))
        return wf_fail(e, WF_EINPUT,
                       "%s: is a results folder, or within one: templates are not taken from there", folder);
    return for_each(folder, check_one, e);
}

static enum wf_status copy_one(const char *folder, const char *name, const char *shipped, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    struct wf_arena a = { 0 };
    struct wf_bytes text;
    struct wf_file f = { 0 };
    enum wf_status s = wf_template_path(folder, name, path, e);
    if (!s) s = wf_file_read(shipped, &a, &text, e);
    if (!s) s = wf_file_begin(&f, path, e);
    if (!s) {
        (void)fwrite(text.data, 1, text.size, f.stream);
        s = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    wf_arena_free(&a);
    return s;
}

enum wf_status wf_template_copy(const char *folder, struct wf_err *e)
{
    if (mkdir(folder, 0777))
        return wf_fail(e, errno == EEXIST ? WF_EINPUT : WF_EOUTPUT, "%s: %s", folder,
                       errno == EEXIST ? "is there already; it is not overwritten: another name, or -o FOLDER"
                                       : strerror(errno));
    return for_each(folder, copy_one, e);
}

/* What the templates made, while it is cleaned. */
struct cleaning {
    const char *folder, *script;
    struct wf_arena arena;
    struct wf_err *e;
    enum wf_status s;
};

static bool is_any(const char *name, const char *const *list)
{
    for (; *list; list++)
        if (!strcasecmp(name, *list)) return true;
    return false;
}

/* Is this script one of the page: data, or the program's own? */
static bool may_stay(const struct cleaning *c, xmlNode *script)
{
    xmlChar *type = xmlGetProp(script, BAD_CAST "type"), *text = xmlNodeGetContent(script);
    bool data = type && !strcmp((char *)type, "application/json") && text && !strstr((char *)text, "</");
    bool own = !type && c->script && text && !strcmp((char *)text, c->script) && !script->properties;
    xmlFree(type), xmlFree(text);
    return data || own;
}

static bool is_removed(const struct cleaning *c, xmlNode *n)
{
    static const char *const never[] = { "iframe",
                                         "frame",
                                         "frameset",
                                         "object",
                                         "embed",
                                         "applet",
                                         "base",
                                         "link",
                                         "form",
                                         "portal",
                                         "set",
                                         "animate",
                                         "animatetransform",
                                         "animatemotion",
                                         "handler",
                                         "foreignobject",
                                         "noscript",
                                         "template",
                                         "audio",
                                         "video",
                                         "source",
                                         "track",
                                         NULL };
    if (n->type == XML_COMMENT_NODE || n->type == XML_PI_NODE) return true;
    if (n->type != XML_ELEMENT_NODE) return false;
    const char *name = (const char *)n->name;
    if (!strcasecmp(name, "meta")) return xmlHasProp(n, BAD_CAST "http-equiv") != NULL;
    if (!strcasecmp(name, "script")) return strcmp(name, "script") != 0 || !may_stay(c, n);
    return is_any(name, never);
}

/* May a link go there? */
static bool is_link(const char *to)
{
    return *to == '#' || !strncmp(to, "https://", 8) || !strncmp(to, "http://", 7) ||
           !strncmp(to, "mailto:", 7);
}

/* A picture of the folder, by its name, becomes part of the page. */
static void embed(struct cleaning *c, xmlNode *img, const char *name)
{
    char path[WF_PATH_MAX];
    struct wf_bytes jpeg;
    struct stat is;
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
    if (*name == '.' || name[strspn(name, allowed)] || wf_template_path(c->folder, name, path, NULL)) {
        c->s = wf_fail(c->e, WF_EINPUT,
                       "%s: a template names the picture '%s'; it must be a file of that folder", c->folder,
                       name);
        return;
    }
    if (!lstat(path, &is) && !S_ISREG(is.st_mode))
        c->s = wf_fail(c->e, WF_EINPUT, "%s: must be a file, and no link", path);
    if (!c->s) c->s = wf_picture_take(path, &c->arena, &jpeg, c->e);
    const char *address = c->s ? NULL : wf_picture_address(&jpeg, &c->arena);
    if (!c->s && (!address || !xmlSetProp(img, BAD_CAST "src", BAD_CAST address)))
        c->s = wf_fail(c->e, WF_ENOMEM, "no memory for the page");
}

static void clean_attributes(struct cleaning *c, xmlNode *n)
{
    static const char *const addresses[] = { "href",     "src",    "srcset",     "action", "formaction",
                                             "data",     "poster", "background", "ping",   "manifest",
                                             "codebase", "cite",   "longdesc",   NULL };
    for (xmlAttr *x = n->properties, *next; x; x = next) {
        const char *name = (const char *)x->name;
        next = x->next;
        bool handler = !strncasecmp(name, "on", 2), address = is_any(name, addresses);
        if (!handler && !address) continue;
        xmlChar *text = xmlNodeListGetString(n->doc, x->children, 1);
        const char *to = text ? (const char *)text : "";
        bool image = !strcasecmp((const char *)n->name, "img") && !strcmp(name, "src");
        bool inside =
            !strncmp(to, "data:image/jpeg;base64,", 23) || !strncmp(to, "data:image/png;base64,", 22);
        bool link = !strcmp((const char *)n->name, "a") && !strcmp(name, "href") && is_link(to);
        if (image && !inside)
            embed(c, n, to);
        else if (handler || !(image || link || *to == '#'))
            xmlRemoveProp(x);
        xmlFree(text);
    }
}

/* Styles stand in the page as they are. */
static void check_style(struct cleaning *c, xmlNode *n)
{
    xmlChar *text = xmlNodeGetContent(n);
    if (text && (strstr((char *)text, "</") || strstr((char *)text, "<!--")))
        c->s =
            wf_fail(c->e, WF_EINPUT, "%s/report.css: '</' and '<!--' are not allowed in a style", c->folder);
    xmlFree(text);
}

static void clean(struct cleaning *c, xmlNode *parent)
{
    for (xmlNode *n = parent->children, *next; n && !c->s; n = next) {
        next = n->next;
        if (is_removed(c, n)) {
            xmlUnlinkNode(n);
            xmlFreeNode(n);
        } else if (n->type == XML_TEXT_NODE || n->type == XML_CDATA_SECTION_NODE) {
            /* text that was to be written as it is, without escapes, is text */
            bool style = parent->name && !strcmp((const char *)parent->name, "style");
            if (n->type == XML_TEXT_NODE && !style) n->name = xmlStringText;
        } else if (n->type == XML_ELEMENT_NODE) {
            if (!strcasecmp((const char *)n->name, "style")) check_style(c, n);
            clean_attributes(c, n);
            clean(c, n);
        }
    }
}

/* The policy of the page, as its first element; the document type of every page. */
static void add_policy(struct cleaning *c, xmlDoc *page, const char *script_name)
{
    char policy[300];
    xmlNode *root = xmlDocGetRootElement(page), *head = root ? root->children : NULL;
    while (head && (head->type != XML_ELEMENT_NODE || strcmp((const char *)head->name, "head") != 0))
        head = head->next;
    if (!head || strcmp((const char *)root->name, "html") != 0) {
        c->s = wf_fail(c->e, WF_EINPUT, "%s: the templates make no page: <html> with <head> is needed",
                       c->folder);
        return;
    }
    snprintf(policy, sizeof policy, "default-src 'none'; style-src 'unsafe-inline'; img-src data:%s%s%s",
             script_name ? "; script-src '" : "", script_name ? script_name : "", script_name ? "'" : "");
    xmlNode *meta = xmlNewDocNode(page, NULL, BAD_CAST "meta", NULL), *first = head->children;
    if (meta) {
        xmlNewProp(meta, BAD_CAST "http-equiv", BAD_CAST "Content-Security-Policy");
        xmlNewProp(meta, BAD_CAST "content", BAD_CAST policy);
    }
    if (meta && first)
        xmlAddPrevSibling(first, meta);
    else if (meta)
        xmlAddChild(head, meta);
    xmlDtd *type = xmlGetIntSubset(page);
    if (type) xmlUnlinkNode((xmlNode *)type), xmlFreeDtd(type);
    if (!meta || !xmlCreateIntSubset(page, BAD_CAST "html", NULL, BAD_CAST "about:legacy-compat"))
        c->s = wf_fail(c->e, WF_ENOMEM, "no memory for the page");
}

enum wf_status wf_template_clean(const char *folder, xmlDoc *page, const char *script,
                                 const char *script_name, struct wf_err *e)
{
    struct cleaning c = { .folder = folder, .script = script, .e = e };
    clean(&c, (xmlNode *)page);
    if (!c.s) add_policy(&c, page, script_name);
    wf_arena_free(&c.arena);
    return c.s;
}
