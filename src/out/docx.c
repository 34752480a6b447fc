/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/docx.h"
#include "base/arena.h"
#include "base/text.h"
#include "out/folder.h"
#include "out/program.h"
#include <jansson.h>
#include <libxml/HTMLtree.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static enum wf_status find_pandoc(struct wf_program *p, struct wf_err *e)
{
    *p = (struct wf_program){ .name = "pandoc", .package = "pandoc" };
    return wf_program_found(p->name, p->path) ? WF_OK : wf_program_missing(p, e);
}

enum wf_status wf_docx_possible(struct wf_err *e)
{
    struct wf_program p;
    return find_pandoc(&p, e);
}

struct docx {
    const char *folder, *language;
    const struct wf_figure *figure;
    size_t figures;
    struct wf_arena arena;
    struct wf_err *e;
    enum wf_status s;
};

static bool is_named(const xmlNode *n, const char *name)
{
    return n && n->type == XML_ELEMENT_NODE && !strcmp((const char *)n->name, name);
}

static bool has(const xmlNode *n, const char *attribute, const char *value)
{
    xmlChar *text = xmlGetProp(n, BAD_CAST attribute);
    bool is = text && !strcmp((const char *)text, value);
    xmlFree(text);
    return is;
}

/* The figure as a picture of points: "data:image/png;base64,...". NULL: it cannot be drawn. */
static const char *picture_of(struct docx *x, const char *name)
{
    char part[64], path[WF_PATH_MAX];
    struct wf_bytes png;
    const char *text = NULL;
    struct wf_figure points = { "tree", NULL,
                                0 }; /* that is a picture of points already (out/tree_picture.h) */
    const struct wf_figure *g = !strcmp(name, "tree") ? &points : NULL;
    for (size_t i = 0; i < x->figures; i++)
        if (!strcmp(x->figure[i].name, name)) g = &x->figure[i];
    if (!g) return NULL;
    snprintf(part, sizeof part, g->script ? "plots/%.40s.large.png" : "plots/%.40s.png", name);
    if (wf_folder_path(x->folder, part, path, NULL)) return NULL;
    if (g->script && wf_figures_run(x->folder, g, part, x->language, NULL, NULL)) return NULL;
    if (!wf_file_read(path, &x->arena, &png, NULL)) text = wf_base64(png.data, png.size, &x->arena);
    if (g->script) (void)unlink(path);
    return text ? wf_arena_print(&x->arena, "data:image/png;base64,%s", text) : NULL;
}

/* In a figure the picture of points in place of the drawing, as wide as on the page of 640 points across. */
static void replace_drawing(struct docx *x, xmlNode *figure, xmlNode *svg)
{
    char style[40];
    double box[4] = { 0, 0, 640, 0 };
    xmlChar *name = xmlGetProp(figure, BAD_CAST "id"), *view = xmlGetProp(svg, BAD_CAST "viewBox");
    const char *address = name ? picture_of(x, (const char *)name) : NULL;
    if (view) (void)sscanf((const char *)view, "%lf %lf %lf %lf", box, box + 1, box + 2, box + 3);
    snprintf(style, sizeof style, "width: %.1fcm", 16 * (box[2] > 64 && box[2] < 640 ? box[2] : 640) / 640);
    xmlNode *img = address ? xmlNewDocNode(figure->doc, NULL, BAD_CAST "img", NULL) : NULL;
    if (img) {
        xmlNewProp(img, BAD_CAST "src", BAD_CAST address);
        xmlNewProp(img, BAD_CAST "style", BAD_CAST style);
        xmlAddPrevSibling(svg, img);
    }
    xmlUnlinkNode(svg);
    xmlFreeNode(svg);
    xmlFree(name), xmlFree(view);
}

static bool is_left_out(const xmlNode *n)
{
    if (n->type == XML_COMMENT_NODE || n->type == XML_PI_NODE) return true;
    return is_named(n, "script") || is_named(n, "style") || is_named(n, "title") || is_named(n, "meta") ||
           (is_named(n, "section") && has(n, "class", "live"));
}

/* ---- Widths of columns, which a page leaves to its reader and a document needs ---- */

enum { COLUMNS = 64, LINE = 30 }; /* letters of a cell that are kept in one line */

struct columns {
    size_t n, letters[COLUMNS], held[COLUMNS]; /* held: rows for which a cell above fills the column */
};

static size_t span_of(const xmlNode *cell, const char *name)
{
    xmlChar *text = xmlGetProp(cell, BAD_CAST name);
    unsigned long k = text ? strtoul((const char *)text, NULL, 10) : 1;
    xmlFree(text);
    return k > 0 && k <= COLUMNS ? k : 1;
}

/* Room of a text: its longest word, or a line of it; a Chinese character takes that of two letters, and may
 * be the last of its line. */
static size_t letters_of(const char *text, bool head)
{
    size_t all = 0, word = 0, longest = 0;
    for (const unsigned char *p = (const unsigned char *)text; *p; p++) {
        size_t wide = (*p & 0xC0) == 0x80 ? 0 : *p >= 0xE3 ? 2 : 1;
        word = *p == ' ' || *p == '\n' || wide == 2 ? wide / 2 * 2 : word + wide;
        all += wide;
        if (word > longest) longest = word;
    }
    size_t line = all < LINE ? all : LINE;
    return head || longest > line ? longest : line;
}

static void measure_row(struct columns *c, const xmlNode *row)
{
    size_t column = 0;
    for (xmlNode *n = row->children; n; n = n->next) {
        if (!is_named(n, "td") && !is_named(n, "th")) continue;
        while (column < COLUMNS && c->held[column]) column++;
        size_t wide = span_of(n, "colspan"), deep = span_of(n, "rowspan");
        if (column + wide > COLUMNS) break;
        xmlChar *text = wide == 1 ? xmlNodeGetContent(n) : NULL;
        size_t letters = text ? letters_of((const char *)text, is_named(n, "th")) : 0;
        if (letters > c->letters[column]) c->letters[column] = letters;
        xmlFree(text);
        for (size_t i = 0; i < wide; i++) c->held[column + i] = deep;
        column += wide;
        if (column > c->n) c->n = column;
    }
    for (size_t i = 0; i < COLUMNS; i++)
        if (c->held[i]) c->held[i]--;
}

static void measure(struct columns *c, const xmlNode *parent)
{
    for (xmlNode *n = parent->children; n; n = n->next) {
        if (is_named(n, "tr")) measure_row(c, n);
        if (is_named(n, "thead") || is_named(n, "tbody") || is_named(n, "tfoot")) measure(c, n);
    }
}

/* <colgroup> with a share of the width for each column, by its longest cells. */
static void give_widths(xmlNode *table)
{
    struct columns c = { 0 };
    size_t sum = 0;
    measure(&c, table);
    for (size_t i = 0; i < c.n; i++) sum += c.letters[i] += 3;
    xmlNode *group = c.n > 1 ? xmlNewDocNode(table->doc, NULL, BAD_CAST "colgroup", NULL) : NULL,
            *first = xmlFirstElementChild(table);
    if (!group || !first) return;
    for (size_t i = 0; i < c.n; i++) {
        char style[40];
        xmlNode *col = xmlNewChild(group, NULL, BAD_CAST "col", NULL);
        snprintf(style, sizeof style, "width: %.1f%%", 100.0 * (double)c.letters[i] / (double)sum);
        if (col) xmlNewProp(col, BAD_CAST "style", BAD_CAST style);
    }
    if (is_named(first, "caption"))
        xmlAddNextSibling(first, group);
    else
        xmlAddPrevSibling(first, group);
}

/* What a document has in other ways than a page: numbers to the right, units in a line of their own, widths
 * of columns. */
static void adapt(struct docx *x, xmlNode *parent)
{
    for (xmlNode *n = parent->children, *next; n; n = next) {
        next = n->next;
        if (is_left_out(n)) {
            xmlUnlinkNode(n);
            xmlFreeNode(n);
        } else if (is_named(n, "svg")) {
            replace_drawing(x, parent, n);
        } else if (n->type == XML_ELEMENT_NODE) {
            bool cell = is_named(n, "td") || is_named(n, "th"),
                 line = has(n, "class", "u") || has(n, "class", "why");
            if (cell && has(n, "class", "r")) xmlNewProp(n, BAD_CAST "style", BAD_CAST "text-align: right");
            if (line && n->children) xmlAddPrevSibling(n, xmlNewDocNode(n->doc, NULL, BAD_CAST "br", NULL));
            if (has(n, "class", "n")) xmlAddNextSibling(n, xmlNewDocText(n->doc, BAD_CAST " "));
            if (is_named(n, "table")) give_widths(n);
            adapt(x, n);
        }
    }
}

/* A file in the folder that pandoc reads or writes: its name, and in `bare` that within the folder. */
static enum wf_status begin(struct docx *x, struct wf_file *f, const char *name, const char **bare)
{
    enum wf_status s = wf_folder_begin(f, x->folder, name, x->e);
    if (!s) *bare = f->temporary + strlen(x->folder) + 1;
    return s;
}

static enum wf_status pandoc(struct docx *x, const char *const *words)
{
    char said[WF_SAID_MAX];
    struct wf_program p;
    enum wf_status s = find_pandoc(&p, x->e);
    p.folder = x->folder, p.argv = words;
    if (!s) s = wf_program_run(&p, said, x->e);
    return !s && *said ? wf_fail(x->e, WF_EOUTPUT, "pandoc says: %s", said) : s;
}

/* Does pandoc's reading of the page name nothing but pictures of the page, and nothing that would be written
 * into the document as it is? */
static bool is_plain(const json_t *x)
{
    static const char png[] = "data:image/png;base64,", jpeg[] = "data:image/jpeg;base64,";
    const char *type = json_string_value(json_object_get(x, "t"));
    const json_t *y;
    size_t i;
    if (type && (!strcmp(type, "RawBlock") || !strcmp(type, "RawInline"))) return false;
    if (type && !strcmp(type, "Image")) {
        const char *to = json_string_value(json_array_get(json_array_get(json_object_get(x, "c"), 2), 0));
        if (!to || (strncmp(to, png, strlen(png)) != 0 && strncmp(to, jpeg, strlen(jpeg)) != 0)) return false;
    }
    json_array_foreach(x, i, y) if (!is_plain(y)) return false;
    union {
        const json_t *given;
        json_t *wanted;
    } object = { .given = x };
    for (void *at = json_object_iter(object.wanted); at; at = json_object_iter_next(object.wanted, at))
        if (!is_plain(json_object_iter_value(at))) return false;
    return true;
}

static enum wf_status check_reading(struct docx *x, const char *path)
{
    json_t *read = json_load_file(path, 0, NULL);
    bool plain = read && is_plain(read);
    json_decref(read);
    return plain ? WF_OK
                 : wf_fail(x->e, WF_EOUTPUT,
                           "pandoc's reading of the page is not one of words, tables and pictures");
}

static enum wf_status convert(struct docx *x, struct wf_file f[static 3], const char *page, xmlDoc *html)
{
    char name[64];
    const char *from, *between, *to;
    enum wf_status s = begin(x, &f[0], "plots/page.html", &from);
    if (!s) s = begin(x, &f[1], "plots/page.json", &between);
    snprintf(name, sizeof name, "%.40s.docx", page);
    if (!s) s = begin(x, &f[2], name, &to);
    if (s) return s;
    xmlOutputBuffer *out = xmlOutputBufferCreateFile(f[0].stream, NULL);
    if (out) htmlDocContentDumpFormatOutput(out, html, "UTF-8", 0);
    if (!out || xmlOutputBufferClose(out) < 0 || fflush(f[0].stream))
        return wf_fail(x->e, WF_EOUTPUT, "%s: cannot be written", f[0].path);
    const char *const read[] = {
        "pandoc", "--sandbox", "-f", "html", "-t", "json", "-o", between, from, NULL
    };
    const char *const write[] = { "pandoc", "-f", "json", "-t", "docx", "-o", to, between, NULL };
    s = pandoc(x, read);
    if (!s) s = check_reading(x, f[1].temporary);
    if (!s) s = pandoc(x, write);
    return s ? s : wf_file_commit(&f[2], x->e);
}

enum wf_status wf_docx_make(const char *folder, const char *page, const xmlDoc *html,
                            const struct wf_figure *g, size_t n, const char *language, struct wf_err *e)
{
    struct docx x = { .folder = folder, .language = language, .figure = g, .figures = n, .e = e };
    struct wf_file f[3] = { 0 };
    union {
        const xmlDoc *given;
        xmlDoc *wanted; /* libxml2 does not change what it copies */
    } original = { .given = html };
    xmlDoc *copy = xmlCopyDoc(original.wanted, 1);
    enum wf_status s = copy ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory for the document");
    if (!s) adapt(&x, (xmlNode *)copy);
    if (!s) s = convert(&x, f, page, copy);
    for (size_t i = 0; i < 3; i++) wf_file_abandon(&f[i]);
    if (copy) xmlFreeDoc(copy);
    wf_arena_free(&x.arena);
    return s;
}
