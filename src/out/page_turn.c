/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/page_turn.h"
#include "out/page_units.h"
#include <libxml/HTMLtree.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* A run is the text nodes that stand in one line of text: those of a block, without other blocks.
 */

struct turning {
    const char *system;
    struct wf_arena arena;
    bool failed;
};

static bool is_named(const xmlNode *n, const char *name)
{
    return n->type == XML_ELEMENT_NODE && !strcmp((const char *)n->name, name);
}

static bool has_class(const xmlNode *n, const char *class)
{
    xmlChar *text = xmlGetProp(n, BAD_CAST "class");
    bool is = text && !strcmp((const char *)text, class);
    xmlFree(text);
    return is;
}

/* Does its text go on within the line around it? */
static bool is_inline(const xmlNode *n)
{
    static const char *const name[] = { "b", "i", "em", "strong", "span", "a", "sub", "sup" };
    if (n->type != XML_ELEMENT_NODE || has_class(n, "u") || has_class(n, "why")) return false;
    for (size_t i = 0; i < sizeof name / sizeof *name; i++)
        if (is_named(n, name[i])) return true;
    return false;
}

static bool is_text(const xmlNode *n)
{
    return n->type == XML_TEXT_NODE || n->type == XML_CDATA_SECTION_NODE;
}

struct run {
    xmlNode **node;
    size_t n, room;
};

static void add_node(struct turning *t, struct run *r, xmlNode *node)
{
    if (r->n == r->room) {
        xmlNode **more = WF_TAKE(&t->arena, 2 * r->room + 8, xmlNode *);
        if (!more) {
            t->failed = true;
            return;
        }
        if (r->n) memcpy(more, r->node, r->n * sizeof *more);
        r->node = more, r->room = 2 * r->room + 8;
    }
    r->node[r->n++] = node;
}

/* Turn the nodes of a run as one text, and empty it. */
static void turn_run(struct turning *t, struct run *r, const struct wf_page_unit *column)
{
    struct wf_arena a = { 0 };
    char *text = wf_arena_text(&a, "");
    for (size_t i = 0; i < r->n && text; i++)
        text = wf_arena_print(&a, "%s%s%s", text, i ? WF_MARK_NODE : "", (const char *)r->node[i]->content);
    char *rest = text ? wf_page_units_turned(t->system, text, column, &a) : NULL;
    t->failed |= !rest;
    for (size_t i = 0; i < r->n && rest; i++) {
        char *end = i + 1 < r->n ? strstr(rest, WF_MARK_NODE) : NULL;
        if (end) *end = '\0';
        if (strcmp(rest, (const char *)r->node[i]->content) != 0) {
            xmlNodeSetContent(r->node[i], BAD_CAST "");
            xmlNodeAddContent(r->node[i], BAD_CAST rest);
        }
        rest = end ? end + 3 : rest + strlen(rest);
    }
    r->n = 0;
    wf_arena_free(&a);
}

static void turn_element(struct turning *t, xmlNode *e);

static void walk(struct turning *t, xmlNode *e, struct run *r)
{
    for (xmlNode *n = e->children; n; n = n->next) {
        if (is_text(n)) {
            add_node(t, r, n);
        } else if (is_inline(n)) {
            walk(t, n, r);
        } else if (n->type == XML_ELEMENT_NODE) {
            turn_run(t, r, NULL);
            turn_element(t, n);
        }
    }
}

/* A cell of a table, or its place in the grid. */
struct cell {
    xmlNode *node;
    const struct wf_page_unit *unit; /* of the column, from its head */
};
enum { COLUMNS = 64 };

static size_t span_of(const xmlNode *n, const char *name)
{
    xmlChar *text = xmlGetProp(n, BAD_CAST name);
    unsigned long k = text ? strtoul((const char *)text, NULL, 10) : 1;
    xmlFree(text);
    return k > 0 && k <= COLUMNS ? k : 1;
}

/* Is the text of a cell nothing but numbers? */
static bool only_numbers(const char *text)
{
    static const char *const wide[] = { "–", "−", "≥", "≤", "…", "\xc2\xa0", "\xe2\x80\xaf", "至", "*" };
    for (const char *p = text; *p;) {
        if (!strncmp(p, WF_MARK, 3)) {
            const char *end = strstr(p, WF_MARK_END);
            if (!end) return false;
            p = end + 3;
            continue;
        }
        size_t n = *p && strchr("0123456789.,<> \n", *p) ? 1 : 0;
        for (size_t i = 0; i < sizeof wide / sizeof *wide && !n; i++)
            if (!strncmp(p, wide[i], strlen(wide[i]))) n = strlen(wide[i]);
        if (!strncmp(p, " to ", 4)) n = 4;
        if (!n) return false;
        p += n;
    }
    return true;
}

/* The unit line of a head. */
static xmlNode *unit_line(xmlNode *head)
{
    for (xmlNode *n = head->children; n; n = n->next)
        if (is_named(n, "span") && has_class(n, "u")) return n;
    return NULL;
}

static const struct wf_page_unit *unit_of_head(struct turning *t, xmlNode *head)
{
    xmlNode *line = unit_line(head);
    xmlChar *text = line ? xmlNodeGetContent(line) : NULL;
    const struct wf_page_unit *unit = NULL;
    if (text) {
        size_t n = strlen((const char *)text);
        while (n >= 2 && !strncmp((const char *)text + n - 2, "\xc2\xa0", 2)) n -= 2;
        unit = wf_page_unit_find(t->system, (const char *)text, n);
    }
    xmlFree(text);
    return unit;
}

/* What is done with a column: its head's unit is learnt; its cells are looked at; they are turned. */
struct grid {
    xmlNode *head[COLUMNS];
    const struct wf_page_unit *unit[COLUMNS];
    bool named[COLUMNS];            /* its head has a unit, turned or not */
    const struct wf_page_unit *row; /* of the numbers of the present row that are in columns without a unit */
    size_t held[COLUMNS];           /* rows for which a cell above still fills the column */
};

typedef void visit(struct turning *t, struct grid *g, xmlNode *cell, size_t column, size_t wide);

static void learn(struct turning *t, struct grid *g, xmlNode *cell, size_t column, size_t wide)
{
    const struct wf_page_unit *unit = is_named(cell, "th") && wide == 1 ? unit_of_head(t, cell) : NULL;
    xmlNode *line = is_named(cell, "th") ? unit_line(cell) : NULL;
    /* "kg", "%", a dash for a number without a unit; a blank line says nothing */
    const char *said = line && line->children ? (const char *)line->children->content : NULL;
    if (said && *said && strncmp(said, "\xc2\xa0", 2) != 0) g->named[column] = true;
    if (unit) g->head[column] = cell, g->unit[column] = unit;
}

static void look(struct turning *t, struct grid *g, xmlNode *cell, size_t column, size_t wide)
{
    (void)t;
    if (!is_named(cell, "td") || wide != 1) return;
    xmlChar *text = xmlNodeGetContent(cell);
    if (!text || !only_numbers((const char *)text)) g->unit[column] = NULL;
    xmlFree(text);
}

/* The unit that a row names for its numbers: in a cell of the class "unit", which is returned in *named, or
 * behind the last comma of its first cell. NULL: none, or not all of them are numbers. */
static const struct wf_page_unit *unit_of_row(struct turning *t, xmlNode *row, xmlNode **named)
{
    xmlNode *first = NULL;
    for (xmlNode *n = row->children; n; n = n->next) {
        if (!first && is_named(n, "td")) first = n;
        if (is_named(n, "td") && has_class(n, "unit")) *named = n;
    }
    xmlNode *from = *named ? *named : first;
    xmlChar *text = from ? xmlNodeGetContent(from) : NULL;
    const char *unit = (const char *)text;
    if (unit && !*named) {
        for (const char *p = unit; (p = strstr(p, ", ")); p += 2) unit = p + 2;
        if (unit == (const char *)text) unit = NULL;
    }
    const struct wf_page_unit *u = unit ? wf_page_unit_find(t->system, unit, strlen(unit)) : NULL;
    xmlFree(text);
    return u;
}

/* Do the numbers of a row that its unit is for stand in this cell? */
static bool is_of_row(const struct grid *g, const xmlNode *cell, size_t column)
{
    return is_named(cell, "td") && has_class(cell, "r") && !g->unit[column] && !g->named[column];
}

static void find_row_unit(struct turning *t, struct grid *g, xmlNode *row)
{
    xmlNode *named = NULL;
    size_t column = 0;
    g->row = unit_of_row(t, row, &named);
    for (xmlNode *n = row->children; n && n != named && g->row; n = n->next) {
        if (!is_named(n, "td") && !is_named(n, "th")) continue;
        xmlChar *text = is_of_row(g, n, column) ? xmlNodeGetContent(n) : NULL;
        if (span_of(n, "colspan") != 1 || (text && !only_numbers((const char *)text))) g->row = NULL;
        xmlFree(text);
        if (++column == COLUMNS) g->row = NULL;
    }
}

/* The row's unit, in its own cell or at the end of its first, is replaced; the cells behind its own are not
 * its numbers. */
static void turn_row_unit(struct grid *g, xmlNode *cell)
{
    xmlNode *last = cell->last;
    if (has_class(cell, "unit")) {
        xmlNodeSetContent(cell, BAD_CAST g->row->to);
        g->row = NULL;
    } else if (last && is_text(last)) {
        char *comma = NULL;
        for (char *p = (char *)last->content; (p = strstr(p, ", ")); p += 2) comma = p + 2;
        if (!comma) return;
        *comma = '\0';
        xmlNodeAddContent(last, BAD_CAST g->row->to);
    }
}

static void turn_cell(struct turning *t, struct grid *g, xmlNode *cell, size_t column, size_t wide)
{
    struct run r = { 0 };
    const struct wf_page_unit *unit = is_of_row(g, cell, column) ? g->row : g->unit[column];
    if (cell == g->head[column] && g->unit[column]) {
        xmlNode *line = unit_line(cell);
        xmlNodeSetContent(line, BAD_CAST g->unit[column]->to);
        xmlNodeAddContent(line, BAD_CAST "\xc2\xa0");
    } else if (is_named(cell, "td") && wide == 1 && unit) {
        for (xmlNode *n = cell->children; n; n = n->next)
            if (is_text(n))
                add_node(t, &r, n);
            else if (is_inline(n))
                walk(t, n, &r);
        turn_run(t, &r, unit);
    }
    turn_element(t, cell);
    if (g->row && (has_class(cell, "unit") || !cell->prev)) turn_row_unit(g, cell);
}

static void visit_row(struct turning *t, struct grid *g, xmlNode *row, visit *what)
{
    size_t column = 0;
    g->row = NULL;
    if (what == turn_cell) find_row_unit(t, g, row);
    for (xmlNode *n = row->children; n; n = n->next) {
        if (!is_named(n, "td") && !is_named(n, "th")) continue;
        while (column < COLUMNS && g->held[column]) column++;
        size_t wide = span_of(n, "colspan"), deep = span_of(n, "rowspan");
        if (column + wide > COLUMNS) break;
        what(t, g, n, column, wide);
        for (size_t i = 0; i < wide; i++) g->held[column + i] = deep;
        column += wide;
    }
    for (size_t i = 0; i < COLUMNS; i++)
        if (g->held[i]) g->held[i]--;
}

static void visit_rows(struct turning *t, struct grid *g, xmlNode *table, visit *what)
{
    for (xmlNode *n = table->children; n; n = n->next) {
        if (is_named(n, "tr"))
            visit_row(t, g, n, what);
        else if (is_named(n, "thead") || is_named(n, "tbody") || is_named(n, "tfoot"))
            visit_rows(t, g, n, what);
        else if (what == turn_cell && n->type == XML_ELEMENT_NODE)
            turn_element(t, n);
    }
}

static void turn_table(struct turning *t, xmlNode *table)
{
    struct grid g = { 0 };
    visit_rows(t, &g, table, learn);
    memset(g.held, 0, sizeof g.held);
    visit_rows(t, &g, table, look);
    memset(g.held, 0, sizeof g.held);
    visit_rows(t, &g, table, turn_cell);
}

/* Take the marks out of attributes. */
static void clean_attributes(struct turning *t, xmlNode *e)
{
    for (xmlAttr *x = e->properties; x; x = x->next) {
        xmlChar *text = xmlNodeListGetString(e->doc, x->children, 1);
        if (text && strstr((const char *)text, "\xee\x80")) {
            char *plain = wf_page_units_turned("metric", (const char *)text, NULL, &t->arena);
            if (plain) xmlSetProp(e, x->name, BAD_CAST plain);
            t->failed |= !plain;
        }
        xmlFree(text);
    }
}

static void turn_element(struct turning *t, xmlNode *e)
{
    struct run r = { 0 };
    if (is_named(e, "svg") || is_named(e, "style") || is_named(e, "script")) return;
    clean_attributes(t, e);
    if (is_named(e, "table")) {
        turn_table(t, e);
        return;
    }
    walk(t, e, &r);
    turn_run(t, &r, NULL);
}

static enum wf_status write_html(xmlDoc *page, FILE *f, struct wf_err *e)
{
    xmlOutputBuffer *out = xmlOutputBufferCreateFile(f, NULL);
    if (!out) return wf_fail(e, WF_ENOMEM, "no memory for the page");
    htmlDocContentDumpFormatOutput(out, page, "UTF-8", 0);
    return xmlOutputBufferClose(out) < 0 ? wf_fail(e, WF_EOUTPUT, "the page cannot be written") : WF_OK;
}

enum wf_status wf_page_turn(const char *system, xmlDoc *page, FILE *f, struct wf_err *e)
{
    struct turning t = { .system = system };
    xmlNode *root = xmlDocGetRootElement(page);
    if (root) turn_element(&t, root);
    wf_arena_free(&t.arena);
    return t.failed ? wf_fail(e, WF_ENOMEM, "no memory for the units of the page") : write_html(page, f, e);
}

/* Texts of the job stay as typed; private characters of others must not look like marks. */
static void guard(struct turning *t, xmlNode *e, bool typed)
{
    for (xmlNode *n = e->children; n; n = n->next) {
        bool title = is_named(e, "results") && (is_named(n, "title") || is_named(n, "note"));
        if (n->type == XML_ELEMENT_NODE) guard(t, n, typed || title || is_named(n, "job"));
        if (!is_text(n)) continue;
        char *text = wf_arena_text(&t->arena, (const char *)n->content);
        for (char *p = text ? strstr(text, "\xee\x80") : NULL; p; p = strstr(p + 3, "\xee\x80"))
            memcpy(p, "\xef\xbf\xbd", 3);
        if (text && typed) text = wf_arena_print(&t->arena, WF_AS_TYPED "%s" WF_AS_TYPED_END, text);
        t->failed |= !text;
        if (!text || !strcmp(text, (const char *)n->content)) continue;
        xmlNodeSetContent(n, BAD_CAST "");
        xmlNodeAddContent(n, BAD_CAST text);
    }
}

enum wf_status wf_page_guard(xmlNode *results, struct wf_err *e)
{
    struct turning t = { 0 };
    guard(&t, results, false);
    wf_arena_free(&t.arena);
    return t.failed ? wf_fail(e, WF_ENOMEM, "no memory for the units of the page") : WF_OK;
}
