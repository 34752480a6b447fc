/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/yaml.h"
#include <jansson.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 96, INDENT = 6 };

/* ---- The schema as text for people ---- */

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
    if (!table) return (void)wf_fail(e, WF_ENOMEM, "no memory for the schema"), NULL;
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

/* ---- The schema for editors ----
 * The rows of a table as a JSON Schema, so that an editor can complete and check a file while it is written.
 * It allows what the reader allows key by key; checks between keys, and of units beyond their presence, are
 * the reader's alone. */

/* The row whose quantity a table is: that of the holder where the row's own says so. */
static const struct wf_yaml_row *quantity_of(const struct wf_yaml_row *r, const struct wf_yaml_row *holder)
{
    return r->dimension == WF_DIM_COUNT && holder ? holder : r;
}

/* A quantity: plain numbers have a range where they need no unit; with a unit it is a text, whose range is in
 * the description. */
static json_t *quantity(const struct wf_yaml_row *r)
{
    json_t *number = json_pack("{s:s}", "type", "number"), *text = json_pack("{s:s}", "type", "string");
    if (r->dimension == WF_DIM_NONE && r->low < r->high) {
        json_object_set_new(number, "minimum", json_real(r->low));
        json_object_set_new(number, "maximum", json_real(r->high));
    }
    if (r->dimension != WF_DIM_NONE) { /* a plain number is right for zero alone */
        json_object_set_new(number, "const", json_integer(0));
        json_object_set_new(text, "pattern", json_string("^\\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?\\s*[^0-9\\s]"));
    }
    return json_pack("{s:[o,o]}", "anyOf", number, text);
}

static json_t *object_of(struct wf_units *u, const struct wf_yaml_table *t, const struct wf_yaml_row *holder);

static json_t *words_of(const struct wf_yaml_row *r)
{
    json_t *word = json_array();
    for (size_t i = 0; r->choices && r->choices[i]; i++) {
        const char *w = r->choices[i];
        json_array_append_new(word, json_string(w));
        if (!strcmp(w, "yes") || !strcmp(w, "no")) /* an editor of YAML 1.1 takes them for logical values */
            json_array_append_new(word, json_boolean(*w == 'y'));
    }
    return json_pack("{s:o}", "enum", word);
}

/* What the value of a row may be. */
static json_t *kind_of(struct wf_units *u, const struct wf_yaml_row *r, const struct wf_yaml_row *holder)
{
    switch (r->kind) {
    case WF_YAML_TEXT:
        return json_pack("{s:[s,s,s]}", "type", "string", "number", "boolean");
    case WF_YAML_NAME:
        return json_pack("{s:s,s:s}", "type", "string", "pattern", "^[A-Za-z0-9_][A-Za-z0-9_-]*$");
    case WF_YAML_CHOICE:
    case WF_YAML_ENUM:
        return words_of(r);
    case WF_YAML_QUANTITY:
        return quantity(quantity_of(r, holder));
    case WF_YAML_INTEGER:
        return json_pack("{s:s,s:f,s:f}", "type", "integer", "minimum", r->low, "maximum", r->high);
    case WF_YAML_QUANTITIES:
        return json_pack("{s:s,s:o}", "type", "array", "items", quantity(quantity_of(r, holder)));
    case WF_YAML_TEXTS:
        return json_pack("{s:s,s:{s:s}}", "type", "object", "additionalProperties", "type", "string");
    case WF_YAML_WORDS:
        return json_pack("{s:s,s:i,s:{s:[s,s]}}", "type", "array", "minItems", 1, "items", "type", "string",
                         "number");
    case WF_YAML_LIST:
        return json_pack("{s:s,s:o}", "type", "array", "items", object_of(u, r->table, r));
    case WF_YAML_TABLE:
        if (!r->table->bare) return object_of(u, r->table, r);
        return json_pack("{s:[o,o]}", "anyOf", quantity(r), object_of(u, r->table, r));
    case WF_YAML_JOINED: /* its doc says what */
        break;
    }
    return json_object();
}

/* A default as the type that it has in the file. */
static json_t *initial_of(const char *text)
{
    char *end;
    double number = strtod(text, &end);
    return end != text && !*end ? json_real(number) : json_string(text);
}

static json_t *member_of(struct wf_units *u, const struct wf_yaml_row *r, const struct wf_yaml_row *holder)
{
    json_t *out = kind_of(u, r, holder);
    char text[2048], low[64], high[64];
    const struct wf_yaml_row *q = quantity_of(r, holder);
    int n = snprintf(text, sizeof text, "%s", r->doc ? r->doc : "");
    bool measured = r->kind == WF_YAML_QUANTITY || r->kind == WF_YAML_QUANTITIES ||
                    (r->kind == WF_YAML_TABLE && r->table->bare);
    if (measured && q->dimension != WF_DIM_NONE && q->dimension != WF_DIM_COUNT && n > 0 &&
        (size_t)n < sizeof text) {
        (void)wf_quantity_print(u, q->low, q->dimension, q->unit ? q->unit : "", low, sizeof low);
        (void)wf_quantity_print(u, q->high, q->dimension, q->unit ? q->unit : "", high, sizeof high);
        (void)snprintf(text + n, sizeof text - (size_t)n, " From %s to %s.", low, high);
    }
    json_object_set_new(out, "description", json_string(text));
    if (r->initial && !r->required) json_object_set_new(out, "default", initial_of(r->initial));
    if (r->example) json_object_set_new(out, "examples", json_pack("[o]", initial_of(r->example)));
    return out;
}

static json_t *object_of(struct wf_units *u, const struct wf_yaml_table *t, const struct wf_yaml_row *holder)
{
    json_t *key = json_object(), *needed = json_array();
    for (const struct wf_yaml_row *r = t->row; r->key; r++) {
        json_object_set_new(key, r->key, member_of(u, r, holder));
        if (r->required) json_array_append_new(needed, json_string(r->key));
    }
    json_t *out = json_pack("{s:s,s:o,s:b}", "type", "object", "properties", key, "additionalProperties", 0);
    if (json_array_size(needed))
        json_object_set_new(out, "required", needed);
    else
        json_decref(needed);
    return out;
}

char *wf_yaml_json_schema(const struct wf_yaml_table *table, struct wf_arena *a, struct wf_err *e)
{
    struct wf_units *u;
    if (!table) return (void)wf_fail(e, WF_ENOMEM, "no memory for the schema"), NULL;
    if (wf_units_open(&u, e)) return NULL;
    json_t *root = object_of(u, table, NULL);
    wf_units_close(u);
    json_object_set_new(root, "$schema", json_string("http://json-schema.org/draft-07/schema#"));
    json_object_set_new(root, "title", json_string(table->title));
    json_object_set_new(root, "description", json_string(table->doc));
    char *made = json_dumps(root, JSON_INDENT(1) | JSON_SORT_KEYS);
    char *text = made ? wf_arena_print(a, "%s\n", made) : NULL;
    free(made);
    json_decref(root);
    if (!text) (void)wf_fail(e, WF_ENOMEM, "no memory for the schema");
    return text;
}
