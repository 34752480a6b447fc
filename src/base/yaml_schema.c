/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/yaml.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 96, INDENT = 6 };

/* The schema as text for people. */

struct schema_page {
    char *text;
    size_t used, room; /* counted only while text == NULL */
    struct wf_units *units;
};

__attribute__((format(printf, 2, 3))) static void page_print(struct schema_page *p, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    int n = vsnprintf(p->text ? p->text + p->used : NULL, p->text ? p->room - p->used : 0, fmt, args);
    va_end(args);
    if (n > 0) p->used += (size_t)n;
}

/* Append a paragraph, wrapped at WIDTH. */
static void page_paragraph(struct schema_page *p, const char *text, size_t indent)
{
    size_t column = 0;
    for (const char *s = text; *s;) {
        size_t n = strcspn(s, " ");
        if (column && column + 1 + n > WIDTH - indent) {
            page_print(p, "\n");
            column = 0;
        }
        page_print(p, "%*s%.*s", column ? 1 : (int)indent, "", (int)n, s);
        column += n + (column ? 1 : 0);
        s += n + (s[n] == ' ');
    }
    page_print(p, "\n");
}

static void row_range(const struct schema_page *p, const struct wf_yaml_row *r, char *buf, size_t size)
{
    char low[64], high[64];
    const char *unit = r->unit ? r->unit : "";
    if (r->kind == WF_YAML_INTEGER) {
        (void)snprintf(buf, size, "a whole number, %.15g to %.15g", r->low, r->high);
        return;
    }
    if (r->dimension == WF_DIM_COUNT) {
        (void)snprintf(buf, size, "as the value it belongs to");
        return;
    }
    (void)wf_quantity_print(p->units, r->low, r->dimension, unit, low, sizeof low);
    (void)wf_quantity_print(p->units, r->high, r->dimension, unit, high, sizeof high);
    (void)snprintf(buf, size, "%s, %s to %s", wf_dimension_row(r->dimension)->name, low, high);
}

/* The kind and range of a row, in words. */
static void row_kind(const struct schema_page *p, const struct wf_yaml_row *r, char *buf, size_t size)
{
    char within[160];
    size_t n = 0;
    row_range(p, r, within, sizeof within);
    switch (r->kind) {
    case WF_YAML_TEXT:
        (void)snprintf(buf, size, "text");
        break;
    case WF_YAML_NAME:
        (void)snprintf(buf, size, "a name (letters, digits, _ and -)");
        break;
    case WF_YAML_CHOICE:
    case WF_YAML_ENUM:
        for (size_t i = 0; r->choices[i] && n < size; i++)
            n += (size_t)snprintf(buf + n, size - n, "%s%s", i ? " | " : "", r->choices[i]);
        break;
    case WF_YAML_QUANTITIES:
        (void)snprintf(buf, size, "a list [..], each %s", within);
        break;
    case WF_YAML_JOINED:
        *buf = '\0'; /* any value: its doc says which */
        break;
    case WF_YAML_TEXTS:
        (void)snprintf(buf, size, "a mapping of names to texts");
        break;
    case WF_YAML_WORDS:
        (void)snprintf(buf, size, "a list [..] of texts");
        break;
    case WF_YAML_LIST:
        (void)snprintf(buf, size, "a list, each item with the keys below");
        break;
    case WF_YAML_TABLE:
        if (r->table->bare)
            (void)snprintf(buf, size, "%s; or a mapping with range and source, see '%s' below", within,
                           r->table->title);
        else
            (void)snprintf(buf, size, "a mapping with the keys below");
        break;
    default:
        (void)snprintf(buf, size, "%s", within);
    }
}

static void page_rows(struct schema_page *p, const struct wf_yaml_table *t, const char *path)
{
    for (const struct wf_yaml_row *r = t->row; r->key; r++) {
        char full[256], what[512];
        row_kind(p, r, what, sizeof what);
        (void)snprintf(full, sizeof full, "%s%s%s%s", path, *path ? "." : "", r->key,
                       r->kind == WF_YAML_LIST ? "[]" : "");
        page_print(p, "  %s%s\n", full, r->required ? "  (required)" : "");
        page_paragraph(p, r->doc, INDENT);
        if (*what) page_paragraph(p, what, INDENT);
        if (r->absent && !r->required)
            page_print(p, "%*sif absent: %s\n", INDENT, "", r->absent);
        else if (r->initial && !r->required)
            page_print(p, "%*sdefault: %s\n", INDENT, "", r->initial);
        if (r->example) page_print(p, "%*sexample: %s: %s\n", INDENT, "", r->key, r->example);
        if ((r->kind == WF_YAML_TABLE && !r->table->bare) || r->kind == WF_YAML_LIST)
            page_rows(p, r->table, full);
    }
}

/* A table that may be given as a bare value; it is explained once, after the keys. */
static const struct wf_yaml_table *bare_table(const struct wf_yaml_table *t)
{
    for (const struct wf_yaml_row *r = t->row; r->key; r++) {
        if (!r->table) continue;
        const struct wf_yaml_table *found = r->table->bare ? r->table : bare_table(r->table);
        if (found) return found;
    }
    return NULL;
}

static void page_write(struct schema_page *p, const struct wf_yaml_table *t)
{
    const struct wf_yaml_table *value = bare_table(t);
    p->used = 0;
    page_paragraph(p, t->doc, 0);
    page_print(p, "\nKeys:\n");
    page_rows(p, t, "");
    if (!value) return;
    page_print(p, "\n%s:\n", value->title);
    page_paragraph(p, value->doc, 2);
    page_rows(p, value, "");
}

char *wf_yaml_schema(const struct wf_yaml_table *table, struct wf_arena *a, struct wf_err *e)
{
    struct schema_page p = { 0 };
    if (wf_units_open(&p.units, e)) return NULL;
    page_write(&p, table);
    p.room = p.used + 1;
    p.text = wf_arena_take(a, p.room, 1);
    if (p.text)
        page_write(&p, table);
    else
        (void)wf_fail(e, WF_ENOMEM, "no memory for the text of the schema");
    wf_units_close(p.units);
    return p.text;
}
