/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/yaml.h"
#include "base/file.h"
#include "base/num.h"
#include "base/text.h"
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

struct wf_yaml {
    const char *file;
    yaml_document_t document;
    struct wf_units *units;
    struct wf_arena *arena;
    struct wf_diag *diag;
    bool no_memory;
    size_t mistakes;
    char path[512];           /* of the current place, e.g. "levels[1].density"       */
    const yaml_node_t *node;  /* current table; NULL when its key is absent           */
    const yaml_node_t *place; /* `node`, or the innermost enclosing node that is in the file */
};

/* Limits of a file: nesting, bytes, mistakes listed, entries of a free mapping. */
enum { WF_YAML_DEPTH = 16, WF_YAML_SIZE = 1 << 20, WF_YAML_LISTED = 100, WF_YAML_ENTRIES = 1000 };

static void yaml_fill(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_table *t,
                      const struct wf_yaml_row *outer, unsigned char *out);

/* Nodes of the document. */

static const yaml_node_t *yaml_node(struct wf_yaml *y, int id)
{
    return yaml_document_get_node(&y->document, id);
}

static const char *yaml_scalar(const yaml_node_t *n)
{
    return n->type == YAML_SCALAR_NODE ? (const char *)n->data.scalar.value : NULL;
}

static const char *yaml_type(const yaml_node_t *n)
{
    if (n->type == YAML_MAPPING_NODE) return "a mapping (keys with values)";
    if (n->type == YAML_SEQUENCE_NODE) return "a list";
    return n->data.scalar.length ? "a single value" : "nothing";
}

/* Value of a key of a mapping; NULL when there is none. */
static const yaml_node_t *yaml_find(struct wf_yaml *y, const yaml_node_t *map, const char *key, size_t length)
{
    if (!map || map->type != YAML_MAPPING_NODE) return NULL;
    for (yaml_node_pair_t *q = map->data.mapping.pairs.start; q < map->data.mapping.pairs.top; q++) {
        const char *k = yaml_scalar(yaml_node(y, q->key));
        if (k && strlen(k) == length && !memcmp(k, key, length)) return yaml_node(y, q->value);
    }
    return NULL;
}

/* Where a mistake is: marks and paths. */

static void add_mistake(struct wf_yaml *y, yaml_mark_t m, const char *key, const char *fmt, va_list args)
{
    char text[1536];
    if (++y->mistakes > WF_YAML_LISTED) {
        if (y->mistakes == WF_YAML_LISTED + 1)
            wf_diag_error(y->diag, y->file, 0, 0, "more than %d mistakes; the rest is counted but not listed",
                          (int)WF_YAML_LISTED);
        else
            y->diag->errors++;
        return;
    }
    int n = snprintf(text, sizeof text, "%s%s%s%s", y->path, *y->path && *key && *key != '[' ? "." : "", key,
                     *y->path || *key ? ": " : "");
    if (n >= 0 && (size_t)n < sizeof text) (void)vsnprintf(text + n, sizeof text - (size_t)n, fmt, args);
    wf_diag_error(y->diag, y->file, m.line + 1, m.column + 1, "%s", text);
}

/* Add a mistake at a mark of the parser. */
static void yaml_mark(struct wf_yaml *y, yaml_mark_t m, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    add_mistake(y, m, "", fmt, args);
    va_end(args);
}

/* Add a mistake at a node, prefixed with the current path. */
static void yaml_at(struct wf_yaml *y, const yaml_node_t *n, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    add_mistake(y, n->start_mark, "", fmt, args);
    va_end(args);
}

/* The node at a path such as "levels[1].density.low" below the current table, or the last node on that path
 * that is in the file. */
static const yaml_node_t *follow_path(struct wf_yaml *y, const char *key)
{
    const yaml_node_t *n = y->node, *next = n;
    while (next && *key) {
        n = next;
        if (*key == '[') {
            char *end;
            size_t i = strtoul(key + 1, &end, 10);
            size_t have = n->type == YAML_SEQUENCE_NODE
                              ? (size_t)(n->data.sequence.items.top - n->data.sequence.items.start)
                              : 0;
            next = i < have ? yaml_node(y, n->data.sequence.items.start[i]) : NULL;
            key = *end == ']' ? end + 1 : end;
        } else {
            size_t length = strcspn(key, ".[");
            next = yaml_find(y, n, key, length);
            key += length;
        }
        if (*key == '.') key++;
    }
    return next ? next : n;
}

static yaml_mark_t mark_of(struct wf_yaml *y, const char *key)
{
    const yaml_node_t *found = follow_path(y, key), *n = found ? found : y->place;
    return n ? n->start_mark : (yaml_mark_t){ 0 };
}

void wf_yaml_error(struct wf_yaml *y, const char *key, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    add_mistake(y, mark_of(y, key), key, fmt, args);
    va_end(args);
}

struct wf_yaml_mark wf_yaml_where(struct wf_yaml *y, const char *key)
{
    yaml_mark_t m = mark_of(y, key);
    return (struct wf_yaml_mark){ m.line + 1, m.column + 1 };
}

void *wf_yaml_take(struct wf_yaml *y, size_t n, size_t size)
{
    void *p = wf_arena_take(y->arena, n, size);
    if (!p) y->no_memory = true;
    return p;
}

/* Extend the current path by a key or an index. Returned: the length before, for yaml_pop. */
static size_t yaml_push(struct wf_yaml *y, const char *key)
{
    size_t n = strlen(y->path);
    (void)snprintf(y->path + n, sizeof y->path - n, "%s%s", n ? "." : "", key);
    return n;
}

static size_t yaml_push_index(struct wf_yaml *y, size_t index)
{
    size_t n = strlen(y->path);
    (void)snprintf(y->path + n, sizeof y->path - n, "[%zu]", index);
    return n;
}

static void yaml_pop(struct wf_yaml *y, size_t length) { y->path[length] = '\0'; }

/* What the `finish` functions of tables may ask. */

const char *wf_yaml_raw(struct wf_yaml *y, const char *key)
{
    const yaml_node_t *n = yaml_find(y, y->node, key, strlen(key));
    return n ? yaml_scalar(n) : NULL;
}

bool wf_yaml_has(struct wf_yaml *y, const char *key)
{
    const yaml_node_t *n = y->node;
    while (n && *key) {
        size_t length = strcspn(key, ".");
        n = yaml_find(y, n, key, length);
        key += length + (key[length] == '.');
    }
    return n != NULL;
}

/* Single values: numbers with units, texts, choices. */

/* Read a quantity. Returned: its value [SI]; NAN after a mistake was reported. */
static double yaml_quantity(struct wf_yaml *y, const yaml_node_t *n, const char *text,
                            const struct wf_yaml_row *r)
{
    struct wf_err why = { 0 };
    double v;
    const char *unit = r->unit ? r->unit : "";
    if (wf_quantity_read_as(y->units, text, r->dimension, unit, &v, &why)) {
        if (why.code == WF_ENOMEM)
            y->no_memory = true;
        else
            yaml_at(y, n, "%s", why.text);
        return NAN;
    }
    /* a bound converted from its own unit may differ from the SI value in the last digit */
    double slack = 1e-12 * fmax(fabs(r->low), fabs(r->high));
    if (v >= r->low - slack && v <= r->high + slack) return v;
    char low[64], high[64];
    (void)wf_quantity_print(y->units, r->low, r->dimension, unit, low, sizeof low);
    (void)wf_quantity_print(y->units, r->high, r->dimension, unit, high, sizeof high);
    yaml_at(y, n, "%s is outside %s to %s", text, low, high);
    return NAN;
}

static void put_choice(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                       unsigned char *out)
{
    unsigned i = 0;
    while (r->choices[i] && strcmp(r->choices[i], text) != 0) i++;
    if (r->choices[i]) {
        if (r->kind == WF_YAML_ENUM)
            memcpy(out + r->offset, &i, sizeof i);
        else
            memcpy(out + r->offset, &r->choices[i], sizeof r->choices[i]);
        return;
    }
    char all[256] = "";
    size_t used = 0;
    for (size_t k = 0; k < i && used < sizeof all; k++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", k ? ", " : "", r->choices[k]);
    yaml_at(y, n, "'%.60s' is not one of: %s%s", text, all, wf_did_you_mean(text, r->choices, i).text);
}

static void put_integer(struct wf_yaml *y, const yaml_node_t *n, const char *text,
                        const struct wf_yaml_row *r, unsigned char *out)
{
    size_t digits = strspn(text, "0123456789");
    size_t v = digits && digits <= 15 && !text[digits] ? (size_t)strtoull(text, NULL, 10) : (size_t)-1;
    if (!digits || text[digits])
        yaml_at(y, n, "'%.60s' is not a whole number; write for example '%s'", text, r->example);
    else if ((double)v < r->low || (double)v > r->high)
        yaml_at(y, n, "%.60s is outside %.15g to %.15g", text, r->low, r->high);
    else
        memcpy(out + r->offset, &v, sizeof v);
}

static void put_text(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                     unsigned char *out)
{
    if (!text[strspn(text, " \t\n")]) {
        yaml_at(y, n, "a text is expected, not %s", yaml_type(n));
        return;
    }
    for (const char *p = text; r->kind == WF_YAML_NAME && *p; p++)
        if (!isalnum((unsigned char)*p) && *p != '_' && *p != '-') {
            yaml_at(y, n, "'%.60s': a name has only letters a-z, digits, '_' and '-'", text);
            return;
        }
    /* names stand in tables, where a spreadsheet takes one that begins so for a formula */
    if (r->kind == WF_YAML_NAME && *text == '-') {
        yaml_at(y, n, "'%.60s': a name does not begin with '-'", text);
        return;
    }
    if (r->offset == WF_YAML_DROP) return;
    const char *copy = wf_arena_text(y->arena, text);
    if (!copy) y->no_memory = true;
    memcpy(out + r->offset, &copy, sizeof copy);
}

/* Read a scalar into the row's member. `outer`: the row that holds the table, for rows that take its
 * dimension and range. */
static void yaml_put(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                     const struct wf_yaml_row *outer, unsigned char *out)
{
    struct wf_yaml_row own = *r;
    if (r->dimension == WF_DIM_COUNT && outer) {
        own.dimension = outer->dimension;
        own.unit = outer->unit;
        own.low = outer->low;
        own.high = outer->high;
    }
    if (r->kind == WF_YAML_QUANTITY) {
        double v = yaml_quantity(y, n, text, &own);
        memcpy(out + r->offset, &v, sizeof v);
    } else if (r->kind == WF_YAML_INTEGER) {
        put_integer(y, n, text, r, out);
    } else if (r->kind == WF_YAML_CHOICE || r->kind == WF_YAML_ENUM) {
        put_choice(y, n, text, r, out);
    } else {
        put_text(y, n, text, r, out);
    }
}

/* Lists and free mappings. */

static void put_items(const struct wf_yaml_row *r, unsigned char *out, const void *items, size_t n)
{
    memcpy(out + r->offset, &items, sizeof items);
    memcpy(out + r->count, &n, sizeof n);
}

/* Number of items of a list; 0 after reporting that the node is not a list or is empty. */
static size_t list_length(struct wf_yaml *y, const yaml_node_t *n, const char *of)
{
    if (n->type != YAML_SEQUENCE_NODE) {
        yaml_at(y, n, "a list of %s is expected, not %s", of, yaml_type(n));
        return 0;
    }
    size_t count = (size_t)(n->data.sequence.items.top - n->data.sequence.items.start);
    if (!count) yaml_at(y, n, "the list is empty; %s are expected", of);
    return count;
}

/* Check a list against the sibling list that must be as long (row member same_length_as). Returned: false
 * after a mistake was reported. */
static bool has_same_length(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                            size_t count)
{
    const yaml_node_t *other =
        r->same_length_as ? yaml_find(y, y->node, r->same_length_as, strlen(r->same_length_as)) : NULL;
    if (!other || other->type != YAML_SEQUENCE_NODE) return true;
    size_t want = (size_t)(other->data.sequence.items.top - other->data.sequence.items.start);
    if (want == count) return true;
    yaml_at(y, n, "%zu value%s, but '%s' has %zu", count, count == 1 ? "" : "s", r->same_length_as, want);
    return false;
}

/* Read the values of a WF_YAML_QUANTITIES row. */
static void yaml_quantities(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                            unsigned char *out)
{
    size_t count = list_length(y, n, "values");
    if (!count) return;
    double *v = wf_yaml_take(y, count, sizeof *v);
    if (!v) return;
    for (size_t i = 0; i < count; i++) {
        const yaml_node_t *item = yaml_node(y, n->data.sequence.items.start[i]);
        size_t length = yaml_push_index(y, i);
        const char *text = yaml_scalar(item);
        if (text)
            v[i] = yaml_quantity(y, item, text, r);
        else
            yaml_at(y, item, "a single value is expected, not %s", yaml_type(item));
        yaml_pop(y, length);
    }
    if (has_same_length(y, n, r, count)) put_items(r, out, v, count);
}

/* Read the texts of a WF_YAML_WORDS row. */
static void yaml_words(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                       unsigned char *out)
{
    static const struct wf_yaml_row one = { .kind = WF_YAML_TEXT };
    size_t count = list_length(y, n, "texts");
    const char **v = count ? wf_yaml_take(y, count, sizeof *v) : NULL;
    for (size_t i = 0; v && i < count; i++) {
        const yaml_node_t *item = yaml_node(y, n->data.sequence.items.start[i]);
        size_t length = yaml_push_index(y, i);
        const char *text = yaml_scalar(item);
        if (text)
            put_text(y, item, text, &one, (unsigned char *)&v[i]);
        else
            yaml_at(y, item, "a text is expected, not %s", yaml_type(item));
        yaml_pop(y, length);
    }
    if (v) put_items(r, out, v, count);
}

static void yaml_texts(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                       unsigned char *out)
{
    if (n->type != YAML_MAPPING_NODE) {
        yaml_at(y, n, "a mapping of names to texts is expected, not %s", yaml_type(n));
        return;
    }
    const yaml_node_pair_t *first = n->data.mapping.pairs.start;
    size_t count = (size_t)(n->data.mapping.pairs.top - first), kept = 0;
    if (count > WF_YAML_ENTRIES) {
        yaml_at(y, n, "%zu entries; at most %d are read", count, (int)WF_YAML_ENTRIES);
        return;
    }
    struct wf_yaml_pair *pair = wf_yaml_take(y, count, sizeof *pair);
    struct wf_yaml_row key = { .kind = WF_YAML_NAME, .offset = offsetof(struct wf_yaml_pair, key) };
    struct wf_yaml_row text = { .kind = WF_YAML_TEXT, .offset = offsetof(struct wf_yaml_pair, text) };
    for (size_t i = 0; pair && i < count; i++) {
        const yaml_node_t *k = yaml_node(y, first[i].key), *v = yaml_node(y, first[i].value);
        const char *name = yaml_scalar(k), *words = yaml_scalar(v);
        if (!name) {
            yaml_at(y, k, "a name is expected, not %s", yaml_type(k));
            continue;
        }
        yaml_put(y, k, name, &key, NULL, (unsigned char *)&pair[kept]);
        size_t length = yaml_push(y, name);
        bool twice = false;
        for (size_t j = 0; j < kept; j++) twice |= !strcmp(pair[j].key, name);
        if (twice)
            yaml_at(y, k, "is given twice");
        else if (words)
            yaml_put(y, v, words, &text, NULL, (unsigned char *)&pair[kept]);
        else
            yaml_at(y, v, "a text is expected, not %s", yaml_type(v));
        yaml_pop(y, length);
        kept += !twice && pair[kept].key != NULL;
    }
    put_items(r, out, pair, pair ? kept : 0);
}

/* Append one value to a joined text, after a comma unless it is the first. */
static const char *append_joined(struct wf_yaml *y, const char *all, const char *key, const yaml_node_t *v)
{
    const char *text = yaml_scalar(v);
    if (!text) yaml_at(y, v, "a single value is expected, not %s", yaml_type(v));
    if (!text || !all) return all;
    all = wf_arena_print(y->arena, "%s%s%s%s%s", all, *all ? "," : "", key, *key ? "=" : "", text);
    if (!all) y->no_memory = true;
    return all;
}

static void yaml_joined(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                        unsigned char *out)
{
    const char *all = "";
    if (n->type == YAML_SEQUENCE_NODE)
        for (yaml_node_item_t *i = n->data.sequence.items.start; i < n->data.sequence.items.top; i++)
            all = append_joined(y, all, "", yaml_node(y, *i));
    else if (n->type == YAML_MAPPING_NODE)
        for (yaml_node_pair_t *q = n->data.mapping.pairs.start; q < n->data.mapping.pairs.top; q++) {
            const char *key = yaml_scalar(yaml_node(y, q->key));
            all = append_joined(y, all, key ? key : "", yaml_node(y, q->value));
        }
    else
        all = append_joined(y, all, "", n);
    if (all && !*all) yaml_at(y, n, "a value is expected, not %s", yaml_type(n));
    memcpy(out + r->offset, &all, sizeof all);
}

static void yaml_list(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                      unsigned char *out)
{
    size_t count = list_length(y, n, "mappings");
    if (!count) return;
    unsigned char *items = wf_yaml_take(y, count, r->table->size);
    if (!items) return;
    for (size_t i = 0; i < count; i++) {
        size_t length = yaml_push_index(y, i);
        yaml_fill(y, yaml_node(y, n->data.sequence.items.start[i]), r->table, r, items + i * r->table->size);
        yaml_pop(y, length);
    }
    put_items(r, out, items, count);
}

/* Mappings under their schema rows. */

static size_t rows_of(const struct wf_yaml_table *t)
{
    size_t n = 0;
    while (t->row[n].key) n++;
    return n;
}

static const struct wf_yaml_row *row_with_key(const struct wf_yaml_table *t, const char *key)
{
    for (const struct wf_yaml_row *r = t->row; r->key; r++)
        if (!strcmp(r->key, key)) return r;
    return NULL;
}

static void yaml_unknown_key(struct wf_yaml *y, const yaml_node_t *k, const struct wf_yaml_table *t)
{
    const char *word = yaml_scalar(k);
    const size_t n = rows_of(t);
    const char **known = wf_yaml_take(y, n, sizeof *known);
    if (!known) return;
    for (size_t i = 0; i < n; i++) known[i] = t->row[i].key;
    yaml_at(y, k, "unknown key '%.60s'%s", word, wf_did_you_mean_or(word, known, n, "keys here are: ").text);
}

static void read_key(struct wf_yaml *y, const yaml_node_t *v, const struct wf_yaml_row *r,
                     const struct wf_yaml_row *outer, unsigned char *out)
{
    size_t length = yaml_push(y, r->key);
    if (r->given) out[r->given - 1] = true;
    const char *text = yaml_scalar(v);
    if (r->kind == WF_YAML_TABLE)
        yaml_fill(y, v, r->table, r, out + r->offset);
    else if (r->kind == WF_YAML_LIST)
        yaml_list(y, v, r, out);
    else if (r->kind == WF_YAML_TEXTS)
        yaml_texts(y, v, r, out);
    else if (r->kind == WF_YAML_WORDS)
        yaml_words(y, v, r, out);
    else if (r->kind == WF_YAML_QUANTITIES)
        yaml_quantities(y, v, r, out);
    else if (r->kind == WF_YAML_JOINED)
        yaml_joined(y, v, r, out);
    else if (text)
        yaml_put(y, v, text, r, outer, out);
    else
        yaml_at(y, v, "a single value is expected, not %s", yaml_type(v));
    yaml_pop(y, length);
}

/* Set a row's member to its default. */
static void put_initial(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                        const struct wf_yaml_row *outer, unsigned char *out)
{
    const double none = NAN;
    if (r->kind == WF_YAML_QUANTITY) memcpy(out + r->offset, &none, sizeof none);
    if (r->initial && r->kind != WF_YAML_TABLE) yaml_put(y, n, r->initial, r, outer, out);
}

static void missing_key(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r)
{
    if (r->example)
        yaml_at(y, n, "missing key '%s' (%s); for example '%s: %s'", r->key, r->doc, r->key, r->example);
    else
        yaml_at(y, n, "missing key '%s' (%s)", r->key, r->doc);
}

static void read_keys(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_table *t,
                      const struct wf_yaml_row *outer, unsigned char *out, bool *seen)
{
    for (yaml_node_pair_t *q = n->data.mapping.pairs.start; q < n->data.mapping.pairs.top; q++) {
        const yaml_node_t *k = yaml_node(y, q->key);
        const char *key = yaml_scalar(k);
        const struct wf_yaml_row *r = key ? row_with_key(t, key) : NULL;
        if (!key)
            yaml_at(y, k, "a key is expected, not %s", yaml_type(k));
        else if (!r)
            yaml_unknown_key(y, k, t);
        else if (seen[r - t->row])
            yaml_at(y, k, "key '%s' is given twice", key);
        else
            read_key(y, yaml_node(y, q->value), r, outer, out);
        if (r) seen[r - t->row] = true;
    }
}

/* Read a table from a mapping or a bare value; n == NULL: the key is absent, only defaults are set. */
static void yaml_fill(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_table *t,
                      const struct wf_yaml_row *outer, unsigned char *out)
{
    bool *seen = wf_yaml_take(y, rows_of(t), sizeof *seen);
    if (!seen) return;
    const yaml_node_t *above = y->node, *above_place = y->place, *place = n ? n : above_place;
    bool mapping = n && n->type == YAML_MAPPING_NODE;
    const char *bare = n ? yaml_scalar(n) : outer ? outer->initial : NULL;
    y->node = n;
    y->place = place;
    for (const struct wf_yaml_row *r = t->row; r->key; r++) put_initial(y, place, r, outer, out);
    if (mapping)
        read_keys(y, n, t, outer, out, seen);
    else if (t->bare && bare)
        yaml_put(y, place, bare, row_with_key(t, t->bare), outer, out);
    else if (n)
        yaml_at(y, n, "a mapping (keys with values) is expected, not %s", yaml_type(n));
    for (const struct wf_yaml_row *r = t->row; r->key; r++) {
        if (seen[r - t->row]) continue;
        if (mapping && r->required) missing_key(y, n, r);
        if (r->kind == WF_YAML_TABLE) yaml_fill(y, NULL, r->table, r, out + r->offset);
    }
    if (t->finish) t->finish(y, out);
    y->node = above;
    y->place = above_place;
}

/* The document as a whole. */

static void syntax_error(struct wf_yaml *y, const yaml_parser_t *p, const char *text, size_t size)
{
    bool tab = p->problem_mark.index < size && text[p->problem_mark.index] == '\t';
    bool open = p->context && p->context_mark.line != p->problem_mark.line;
    if (p->error == YAML_MEMORY_ERROR)
        y->no_memory = true;
    else if (tab)
        yaml_mark(y, p->problem_mark, "a tab cannot indent; use spaces");
    else if (open)
        yaml_mark(y, p->problem_mark, "not YAML: %s (%s that starts on line %zu)", p->problem, p->context,
                  p->context_mark.line + 1);
    else
        yaml_mark(y, p->problem_mark, "not YAML: %s", p->problem ? p->problem : "unreadable");
}

static void screen_event(struct wf_yaml *y, const yaml_event_t *v, size_t *depth, size_t *documents)
{
    const yaml_char_t *anchor = NULL, *tag = NULL;
    switch (v->type) {
    case YAML_DOCUMENT_START_EVENT:
        if (++*documents == 2)
            yaml_mark(y, v->start_mark, "a second document starts here; a file must have exactly one");
        break;
    case YAML_ALIAS_EVENT:
        yaml_mark(y, v->start_mark, "the alias '*%s' is not understood here; write the value out",
                  (const char *)v->data.alias.anchor);
        break;
    case YAML_SCALAR_EVENT:
        anchor = v->data.scalar.anchor;
        tag = v->data.scalar.tag;
        break;
    case YAML_SEQUENCE_START_EVENT:
        anchor = v->data.sequence_start.anchor;
        tag = v->data.sequence_start.tag;
        ++*depth;
        break;
    case YAML_MAPPING_START_EVENT:
        anchor = v->data.mapping_start.anchor;
        tag = v->data.mapping_start.tag;
        ++*depth;
        break;
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        --*depth;
        break;
    default:
        break;
    }
    if (anchor)
        yaml_mark(y, v->start_mark, "the anchor '&%s' is not understood here; write the value out",
                  (const char *)anchor);
    if (tag) yaml_mark(y, v->start_mark, "the tag '%s' is not understood here", (const char *)tag);
    if (*depth > WF_YAML_DEPTH)
        yaml_mark(y, v->start_mark, "nesting deeper than %d levels", (int)WF_YAML_DEPTH);
}

/* Check that the file is one plain document: no syntax errors, anchors, aliases, tags, further documents or
 * nesting beyond WF_YAML_DEPTH. Returned: false after mistakes were reported. */
static bool yaml_screen(struct wf_yaml *y, const char *text, size_t size)
{
    yaml_parser_t p;
    if (!yaml_parser_initialize(&p)) return y->no_memory = true, false;
    yaml_parser_set_encoding(&p, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&p, (const unsigned char *)text, size);
    size_t depth = 0, documents = 0;
    for (bool end = false; !end && depth <= WF_YAML_DEPTH && documents < 2;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&p, &event)) {
            syntax_error(y, &p, text, size);
            break;
        }
        screen_event(y, &event, &depth, &documents);
        end = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&p);
    return !y->mistakes && !y->no_memory;
}

/* Parse the document, read it under the schema and delete it. */
static void read_document(struct wf_yaml *y, const struct wf_bytes *b, const struct wf_yaml_table *t,
                          void *out)
{
    yaml_parser_t p;
    if (!yaml_screen(y, b->data, b->size)) return;
    if (!yaml_parser_initialize(&p)) {
        y->no_memory = true;
        return;
    }
    yaml_parser_set_encoding(&p, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&p, (const unsigned char *)b->data, b->size);
    if (yaml_parser_load(&p, &y->document)) {
        const yaml_node_t *root = yaml_document_get_root_node(&y->document);
        const char *text = root ? yaml_scalar(root) : "";
        if (text && !*text)
            yaml_mark(y, (yaml_mark_t){ 0 }, "the file is empty; %s is expected", t->title);
        else
            yaml_fill(y, root, t, NULL, out);
        yaml_document_delete(&y->document);
    } else {
        syntax_error(y, &p, b->data, b->size);
    }
    yaml_parser_delete(&p);
}

enum wf_status wf_yaml_read(const char *path, const struct wf_yaml_table *table, void *out,
                            struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_yaml y = { .file = path, .arena = a, .diag = d };
    struct wf_finding *before = d->last;
    struct wf_bytes b;
    enum wf_status code = wf_file_read_text(path, a, &b, e);
    if (code) return code;
    if (b.size > WF_YAML_SIZE)
        return wf_fail(e, WF_EINPUT, "%s: is larger than 1 MB; %s is smaller", path, table->title);
    code = wf_units_open(&y.units, e);
    if (code) return code;
    read_document(&y, &b, table, out);
    wf_units_close(y.units);
    wf_diag_sort(d, before);
    if (y.no_memory) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    if (!y.mistakes) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s: %zu mistake%s", path, y.mistakes, y.mistakes == 1 ? "" : "s");
}

void wf_yaml_ascending(struct wf_yaml *y, const char *key, size_t n, const double *s)
{
    for (size_t i = 1; i < n; i++)
        if (s[i] <= s[i - 1]) {
            wf_yaml_error(y, key, "%g follows %g; the values must ascend", s[i], s[i - 1]);
            return;
        }
}
