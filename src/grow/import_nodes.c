/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import_nodes.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/num.h"
#include <ctype.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Nodes, and the rows they become ---- */

enum node_field { NODE_ID, NODE_PARENT, NODE_X, NODE_Y, NODE_Z, NODE_RADIUS, NODE_ORDER, NODE_FIELDS };

struct nodes {
    struct wf_qsm *q;
    size_t n, room;
    int64_t *id;
    double (*value)[NODE_FIELDS]; /* SI; NAN = not in the file */
    double (*lower)[3]; /* where the node's cylinder starts, as the file says; NULL: at the parent */
    size_t *line;
    bool strict;
    struct wf_diag *diag;
};

static enum wf_status nodes_begin(struct nodes *s, size_t room, struct wf_arena *a, struct wf_err *e)
{
    s->room = room;
    s->id = WF_TAKE(a, room, int64_t);
    s->value = wf_arena_take(a, room, sizeof *s->value);
    s->line = WF_TAKE(a, room, size_t);
    if (s->id && s->value && s->line) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu nodes", s->q->file, room);
}

static void node_bad(struct nodes *s, size_t line, const char *text)
{
    wf_import_bad_row(s->q, s->strict, line, 0, text, s->diag);
}

/* Keep a node. A node without a whole id, and one with the id of an earlier node, cannot be told from others.
 */
static void node_add(struct nodes *s, const double value[NODE_FIELDS], size_t line)
{
    double id = value[NODE_ID];
    if (!(id >= 0 && id <= 9e15 && id == floor(id))) {
        node_bad(s, line, "the id of the node is not a whole number from 0");
        return;
    }
    s->id[s->n] = (int64_t)id;
    memcpy(s->value[s->n], value, sizeof s->value[s->n]);
    s->line[s->n++] = line;
}

static bool is_root(const struct nodes *s, const struct wf_ids *ids, size_t i)
{
    double p = s->value[i][NODE_PARENT];
    return isnan(p) || p < 0 || (p == 0 && wf_ids_find(ids, 0) < 0);
}

/* Write the row of node i, whose parent is node p. Returned: NULL, or what is wrong. */
static const char *node_row(struct nodes *s, const struct wf_ids *ids, size_t i, size_t p, size_t row)
{
    double v[WF_FIELD_COUNT];
    const double *node = s->value[i], *low = s->lower ? s->lower[i] : s->value[p] + NODE_X;
    for (int f = 0; f < WF_FIELD_COUNT; f++) v[f] = (double)NAN;
    v[WF_FIELD_ID] = node[NODE_ID];
    v[WF_FIELD_RADIUS] = node[NODE_RADIUS];
    v[WF_FIELD_ORDER] = node[NODE_ORDER];
    for (int k = 0; k < 3; k++) {
        if (isnan(low[k]) || isnan(node[NODE_X + k]))
            return "a coordinate of the node or its parent is missing";
        v[WF_FIELD_X0 + k] = low[k];
        v[WF_FIELD_X1 + k] = node[NODE_X + k];
    }
    if (p != i && (!is_root(s, ids, p) || !s->id[p])) v[WF_FIELD_PARENT] = (double)s->id[p];
    s->q->line[row] = s->line[i];
    return wf_field_cylinder(s->q, row, v);
}

/* The root of a tree is its lowest point. A tree that lies below its root has another axis upwards. */
static void suspect_axis(const struct nodes *s, const struct wf_ids *ids)
{
    double root = (double)NAN, above = 0, below = 0;
    for (size_t i = 0; i < s->n; i++)
        if (isnan(root) && is_root(s, ids, i)) root = s->value[i][NODE_Z];
    for (size_t i = 0; i < s->n; i++) {
        double z = s->value[i][NODE_Z] - root;
        if (z > above) above = z;
        if (-z > below) below = -z;
    }
    if (below > 0.2 * (above + below))
        wf_diag_warn(s->diag, "root-not-lowest",
                     "%s: the tree reaches %.3g m above its first node and %.3g m below it; z must point up",
                     s->q->name, above, below);
}

/* Make the rows. A node whose parent is not in the file has no start and is left out. */
static enum wf_status nodes_to_rows(struct nodes *s, struct wf_arena *a, struct wf_err *e)
{
    struct wf_ids ids;
    enum wf_status status = wf_ids_begin(&ids, s->id, s->n, a, e);
    if (!status) status = wf_qsm_alloc(s->q, s->n, a, e);
    if (status) return status;
    size_t rows = 0;
    int32_t *first = WF_TAKE(a, s->n, int32_t);
    if (!first) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu nodes", s->q->file, s->n);
    for (size_t i = 0; i < s->n; i++) first[i] = wf_ids_enter(&ids, (int32_t)i);
    for (size_t i = 0; i < s->n; i++) {
        const char *wrong = NULL;
        double parent = s->value[i][NODE_PARENT];
        if (first[i] != (int32_t)i) {
            node_bad(s, s->line[i], "another node has the same id");
            continue;
        }
        if (is_root(s, &ids, i) && !s->lower) continue;
        int32_t p = parent >= 0 && parent <= 9e15 ? wf_ids_find(&ids, (int64_t)parent) : -1;
        if (p < 0 && s->lower) p = (int32_t)i;
        if (p < 0 || (p == (int32_t)i && !s->lower))
            wrong = "the parent of the node is not another node of the file";
        if (!wrong) wrong = node_row(s, &ids, i, (size_t)p, rows);
        if (wrong)
            node_bad(s, s->line[i], wrong);
        else
            rows++;
    }
    s->q->n = rows;
    suspect_axis(s, &ids);
    return WF_OK;
}

/* ---- What the columns are ---- */

struct node_columns {
    struct wf_units *units; /* while the names are read */
    struct wf_err *e;
    size_t at[NODE_FIELDS]; /* column of a field, WF_CSV_NONE: there is none */
    double factor[NODE_FIELDS];
};

/* The field of a column name; NODE_FIELDS: none that is used. A coordinate is the letter alone, with or
 * without a unit: "x", "y_cm", "z (m)". */
static int node_field_of(const struct node_columns *c, const char *name, const struct wf_import_options *o,
                         double *factor)
{
    double length = isnan(o->length_unit) ? 1 : o->length_unit;
    double thick = isnan(o->diameter_unit) ? length : o->diameter_unit;
    char letter = (char)tolower((unsigned char)name[0]), spelt[64];
    bool alone = letter >= 'x' && letter <= 'z' && !isalnum((unsigned char)name[1]);
    if (alone) (void)snprintf(spelt, sizeof spelt, "%c1%s", letter, name + 1); /* as the end of a cylinder */
    switch (wf_field_of(c->units, alone ? spelt : name, length, thick, factor, c->e)) {
    case WF_FIELD_ID:
        return NODE_ID;
    case WF_FIELD_PARENT:
        return NODE_PARENT;
    case WF_FIELD_RADIUS:
        return NODE_RADIUS;
    case WF_FIELD_X1:
    case WF_FIELD_Y1:
    case WF_FIELD_Z1:
        return alone ? NODE_X + letter - 'x' : NODE_FIELDS;
    default:
        return NODE_FIELDS;
    }
}

static void columns_begin(struct node_columns *c)
{
    for (int f = 0; f < NODE_FIELDS; f++) c->at[f] = WF_CSV_NONE;
}

static void columns_note(struct node_columns *c, size_t column, const char *name,
                         const struct wf_import_options *o)
{
    double factor = 1;
    int f = node_field_of(c, name, o, &factor);
    if (f == NODE_FIELDS || c->at[f] != WF_CSV_NONE) return;
    c->at[f] = column;
    c->factor[f] = factor;
}

static bool columns_placed(const struct node_columns *c)
{
    return c->at[NODE_X] != WF_CSV_NONE && c->at[NODE_Y] != WF_CSV_NONE && c->at[NODE_Z] != WF_CSV_NONE &&
           c->at[NODE_RADIUS] != WF_CSV_NONE;
}

/* ---- A row a node ---- */

static bool read_cells(struct wf_csv *csv, const struct node_columns *c, double value[NODE_FIELDS])
{
    for (int f = 0; f < NODE_FIELDS; f++) {
        value[f] = (double)NAN;
        const char *text = wf_csv_text(csv, c->at[f]);
        if (c->at[f] == WF_CSV_NONE || wf_field_missing(text, strlen(text))) continue;
        if (!wf_csv_number(csv, c->at[f], -INFINITY, INFINITY, &value[f])) return false;
        value[f] *= c->factor[f];
    }
    return true;
}

/* Nodes without ids are numbered from 0 when a root's parent is -1, else from 1. */
static void number_nodes(struct nodes *s)
{
    bool minus = false;
    for (size_t i = 0; i < s->n; i++) minus = minus || s->value[i][NODE_PARENT] == -1;
    for (size_t i = 0; i < s->n && minus; i++) s->id[i]--, s->value[i][NODE_ID]--;
}

static size_t count_lines(const char *p, const char *end)
{
    size_t n = 1;
    for (; p < end; p++) n += *p == '\n' || *p == '\r';
    return n;
}

static enum wf_status read_table(struct nodes *s, const struct wf_import_head *h,
                                 const struct wf_import_options *o, struct wf_arena *a, struct wf_err *e)
{
    struct wf_diag own = { .arena = a };
    struct wf_csv csv;
    struct node_columns c;
    double value[NODE_FIELDS];
    enum wf_status status = wf_csv_open(&csv, h->path, a, &own, e);
    if (status) return status;
    if ((status = wf_units_open(&c.units, e))) return status;
    c.e = e;
    columns_begin(&c);
    for (size_t k = 0; k < csv.columns; k++) columns_note(&c, k, csv.name[k].text, o);
    wf_units_close(c.units);
    if (e && e->code) return e->code;
    if (!columns_placed(&c) || c.at[NODE_PARENT] == WF_CSV_NONE)
        return wf_fail(
            e, WF_EINPUT,
            "%s: error: a table of nodes needs the columns x, y, z, a radius or diameter, and parent",
            h->path);
    if ((status = nodes_begin(s, count_lines(csv.at, csv.end), a, e))) return status;
    while (wf_csv_next(&csv)) {
        if (!read_cells(&csv, &c, value)) continue;
        if (c.at[NODE_ID] == WF_CSV_NONE) value[NODE_ID] = (double)csv.row;
        node_add(s, value, csv.row_line);
    }
    if (c.at[NODE_ID] == WF_CSV_NONE) number_nodes(s);
    if (csv.point == ',') wf_qsm_count(s->q, WF_NOTE_DECIMAL_COMMA, 1, -1);
    size_t last = 0;
    for (const struct wf_finding *f = own.first; f; f = f->next) node_bad(s, last = f->line, f->text);
    if (csv.mistakes > own.errors) wf_qsm_count(s->q, WF_REPAIR_BAD_ROW, csv.mistakes - own.errors, 0);
    if (last && h->ends_open && last == csv.row_line) wf_import_last_row_cut(s->q, last);
    return nodes_to_rows(s, a, e);
}

/* ---- Lines of text: raycloudtools and SWC ---- */

struct node_text {
    const char *at, *end;
    size_t line;
    char point; /* decimal sign */
};

/* The next line that is neither blank nor a comment; *stop: its end. NULL: the text ends. */
static const char *next_line(struct node_text *t, const char **stop)
{
    while (t->at < t->end) {
        const char *p = t->at, *line_end = memchr(p, '\n', (size_t)(t->end - p));
        *stop = line_end ? line_end : t->end;
        t->at = line_end ? line_end + 1 : t->end;
        t->line++;
        while (p < *stop && isspace((unsigned char)*p)) p++;
        if (p < *stop && *p != '#') return p;
    }
    return NULL;
}

static bool parts_numbers(char c, char point)
{
    return c == ' ' || c == '\t' || c == '\r' || c == ';' || (c == ',' && point != ',');
}

/* The next number before `stop`. Returned: where it ends; NULL: there is none. */
static const char *next_number(const char *p, const char *stop, char point, double *value)
{
    while (p < stop && parts_numbers(*p, point)) p++;
    if (p == stop) return NULL;
    const char *after = wf_number_read(p, stop, point, value);
    if (!after) { /* "nan" and others: a number that is missing */
        for (after = p; after < stop && !parts_numbers(*after, point);) after++;
        if (!wf_field_missing(p, (size_t)(after - p))) return NULL;
        *value = (double)NAN;
    }
    return after == stop || parts_numbers(*after, point) ? after : NULL;
}

/* How many numbers a line has; -1: something is no number. */
static long count_numbers(const char *p, const char *stop, char point)
{
    double v;
    long n = 0;
    for (const char *after; (after = next_number(p, stop, point, &v)); p = after) n++;
    while (p < stop && parts_numbers(*p, point)) p++;
    return p == stop ? n : -1;
}

/* A comma is the decimal sign when semicolons or tabs part the numbers of a line and it has no point. */
static char decimal_sign(const char *p, const char *stop)
{
    size_t n = (size_t)(stop - p);
    bool parted = memchr(p, ';', n) || memchr(p, '\t', n);
    return parted && memchr(p, ',', n) && !memchr(p, '.', n) ? ',' : '.';
}

static enum wf_status open_text(struct node_text *t, const char *path, struct wf_arena *a, struct wf_err *e)
{
    struct wf_bytes b;
    enum wf_status status = wf_file_read_text(path, a, &b, e);
    if (!status) *t = (struct node_text){ .at = b.data, .end = b.data + b.size, .point = '.' };
    return status;
}

/* raycloudtools: a line a tree. The header names the attributes of a tree, if there are any, then those of a
 * node; behind the attributes of a tree stands ", ". The numbers of a line are the attributes of the tree and
 * then those of each node; a parent is the number of a node of the line, from 0, or -1. */

struct ray_header {
    struct node_columns columns; /* within the fields of a node */
    size_t tree, node;           /* fields of a tree and of a node */
};

static bool read_ray_header(const char *p, const char *stop, const struct wf_import_options *o,
                            struct ray_header *h)
{
    char name[64];
    h->tree = h->node = 0;
    columns_begin(&h->columns);
    for (bool more = true; more;) {
        bool gap = p < stop && *p == ' ';
        while (p < stop && isspace((unsigned char)*p)) p++;
        const char *cut = p;
        while (cut < stop && *cut != ',' && *cut != ';' && *cut != '\t') cut++;
        size_t n = (size_t)(cut - p);
        while (n && isspace((unsigned char)p[n - 1])) n--;
        if (n >= sizeof name || (!n && cut < stop)) return false;
        more = cut < stop;
        if (!n) break;
        (void)snprintf(name, sizeof name, "%.*s", (int)n, p);
        if (gap && h->node && h->columns.at[NODE_X] == WF_CSV_NONE) { /* what came before is of the tree */
            h->tree += h->node;
            h->node = 0;
            columns_begin(&h->columns);
        }
        columns_note(&h->columns, h->node++, name, o);
        p = cut + (more ? 1 : 0);
    }
    return columns_placed(&h->columns);
}

static void read_ray_tree(struct nodes *s, const struct ray_header *h, const char *p, const char *stop,
                          const struct node_text *t)
{
    double v, value[NODE_FIELDS];
    for (size_t k = 0; k < h->tree; k++) p = next_number(p, stop, t->point, &v);
    for (size_t i = 0; i < s->room; i++) {
        for (int f = 0; f < NODE_FIELDS; f++) value[f] = (double)NAN;
        for (size_t k = 0; k < h->node; k++) {
            p = next_number(p, stop, t->point, &v);
            for (int f = 0; f < NODE_FIELDS; f++)
                if (h->columns.at[f] == k) value[f] = v * h->columns.factor[f];
        }
        value[NODE_ID] = (double)i;
        node_add(s, value, t->line);
    }
}

/* The number of the chosen tree, from 1; 0: none is chosen. */
static enum wf_status chosen_tree(const struct wf_import_options *o, const char *path, size_t trees,
                                  size_t *out, struct wf_err *e)
{
    char *end = NULL;
    *out = trees == 1 ? 1 : 0;
    if (!o->tree_id) return WF_OK;
    unsigned long n = isdigit((unsigned char)o->tree_id[0]) ? strtoul(o->tree_id, &end, 10) : 0;
    *out = n;
    if (end && !*end && n >= 1 && n <= trees) return WF_OK;
    return wf_fail(e, WF_EINPUT,
                   "%s: error: --tree-id: '%.40s': the file has %zu trees, 1 to %zu, a line a tree", path,
                   o->tree_id, trees, trees);
}

static enum wf_status read_ray(struct nodes *s, const struct wf_import_head *h,
                               const struct wf_import_options *o, struct wf_arena *a, struct wf_err *e)
{
    struct node_text t;
    struct ray_header header = { .columns.e = e };
    const char *stop, *p;
    size_t chosen;
    enum wf_status status = open_text(&t, h->path, a, e);
    if (status || (status = wf_units_open(&header.columns.units, e))) return status;
    p = next_line(&t, &stop);
    bool read = p && read_ray_header(p, stop, o, &header);
    wf_units_close(header.columns.units);
    if (e && e->code) return e->code;
    if (!read || header.columns.at[NODE_PARENT] == WF_CSV_NONE)
        return wf_fail(e, WF_EINPUT,
                       "%s:%zu: error: no tree structure: the header needs x, y, z, radius and parent_id; a "
                       "file of trunks alone has no branches",
                       h->path, t.line);
    struct node_text first = t;
    while (next_line(&t, &stop)) s->q->trees++;
    if ((status = chosen_tree(o, h->path, s->q->trees, &chosen, e))) return status;
    if (!chosen)
        return wf_fail(e, WF_EINPUT,
                       "%s: error: %zu trees in one file, a line a tree; choose one by --tree-id 1 to %zu",
                       h->path, s->q->trees, s->q->trees);
    for (t = first; chosen && (p = next_line(&t, &stop));) chosen--;
    if (!p) return wf_fail(e, WF_EINPUT, "%s: error: no tree below the header", h->path);
    t.point = decimal_sign(p, stop);
    long numbers = count_numbers(p, stop, t.point), of_nodes = numbers - (long)header.tree;
    if (numbers < 0)
        return wf_fail(e, WF_EINPUT, "%s:%zu: error: the line has something that is not a number", h->path,
                       t.line);
    if (of_nodes <= 0 || of_nodes % (long)header.node)
        return wf_fail(
            e, WF_EINPUT,
            "%s:%zu: error: the line has %ld numbers, which is not %zu for the tree and %zu for each "
            "node",
            h->path, t.line, numbers, header.tree, header.node);
    if ((status = nodes_begin(s, (size_t)of_nodes / header.node, a, e))) return status;
    read_ray_tree(s, &header, p, stop, &t);
    return nodes_to_rows(s, a, e);
}

/* SWC: a line a node: id, kind of structure, x, y, z, radius, parent (-1: the root). */

enum { SWC_COLUMNS = 7 };

static bool read_swc_line(const char *p, const char *stop, double v[SWC_COLUMNS])
{
    for (int k = 0; k < SWC_COLUMNS; k++)
        if (!(p = next_number(p, stop, '.', &v[k]))) return false;
    return count_numbers(p, stop, '.') == 0;
}

static enum wf_status read_swc(struct nodes *s, const struct wf_import_head *h,
                               const struct wf_import_options *o, struct wf_arena *a, struct wf_err *e)
{
    struct node_text t;
    const char *stop;
    double v[SWC_COLUMNS];
    if (isnan(o->length_unit))
        return wf_fail(
            e, WF_EINPUT,
            "%s: error: SWC counts in micrometres, which no tree is measured in, and the file does "
            "not name another unit; name it by --length-unit m, cm or mm",
            h->path);
    double length = o->length_unit, thick = isnan(o->diameter_unit) ? length : o->diameter_unit;
    enum wf_status status = open_text(&t, h->path, a, e);
    if (!status) status = nodes_begin(s, count_lines(t.at, t.end), a, e);
    if (status) return status;
    size_t bad = 0;
    for (const char *p; (p = next_line(&t, &stop));) {
        if (!read_swc_line(p, stop, v)) {
            node_bad(s, bad = t.line, "not the seven numbers id, kind, x, y, z, radius, parent");
            continue;
        }
        const double value[NODE_FIELDS] = { v[0],          v[6],         v[2] * length, v[3] * length,
                                            v[4] * length, v[5] * thick, (double)NAN };
        node_add(s, value, t.line);
    }
    if (bad && bad == t.line && h->ends_open) wf_import_last_row_cut(s->q, bad);
    return nodes_to_rows(s, a, e);
}

/* ---- treegraph's JSON ----
 *
 * The member `cyls` is a text that is JSON again: a table by columns, each an object from the row's label to
 * its value. A row is a cylinder that hangs from its node p1 at (sx, sy, sz) along the unit vector (ax, ay,
 * az) to the node p2 below. */

static double json_cell(const json_t *columns, const char *column, const char *label)
{
    const json_t *v = json_object_get(json_object_get(columns, column), label);
    return json_is_number(v) ? json_number_value(v) : (double)NAN;
}

static void read_cyl(struct nodes *s, const json_t *columns, const char *label, size_t number)
{
    static const char *const starts[] = { "sx", "sy", "sz" }, *const axes[] = { "ax", "ay", "az" };
    double length = json_cell(columns, "length", label);
    double value[NODE_FIELDS] = { json_cell(columns, "p1", label), json_cell(columns, "p2", label) };
    size_t before = s->n;
    for (int k = 0; k < 3; k++) value[NODE_X + k] = json_cell(columns, starts[k], label);
    value[NODE_RADIUS] = json_cell(columns, "radius", label);
    value[NODE_ORDER] = json_cell(columns, "branch_order", label);
    node_add(s, value, number);
    if (s->n == before) return;
    for (int k = 0; k < 3; k++)
        s->lower[before][k] = value[NODE_X + k] + length * json_cell(columns, axes[k], label);
}

/* Do the cylinders lead to the nodes that they name? Otherwise the file has another layout than the one
 * above. */
static bool cyls_lead_down(const struct nodes *s, struct wf_arena *a, struct wf_err *e)
{
    struct wf_ids ids;
    size_t known = 0, met = 0;
    if (wf_ids_begin(&ids, s->id, s->n, a, e)) return false;
    for (size_t i = 0; i < s->n; i++) (void)wf_ids_enter(&ids, (int32_t)i);
    for (size_t i = 0; i < s->n; i++) {
        double parent = s->value[i][NODE_PARENT], gap = 0, length = 0;
        int32_t p = parent >= 0 && parent <= 9e15 ? wf_ids_find(&ids, (int64_t)parent) : -1;
        if (p < 0) continue;
        for (int k = 0; k < 3; k++) {
            gap += pow(s->lower[i][k] - s->value[p][NODE_X + k], 2);
            length += pow(s->lower[i][k] - s->value[i][NODE_X + k], 2);
        }
        known++;
        met += sqrt(gap) <= 1e-3 + 0.05 * sqrt(length);
    }
    return 2 * met >= known;
}

static enum wf_status read_columns(struct nodes *s, json_t *columns, struct wf_arena *a, struct wf_err *e)
{
    static const char *const needed[] = {
        "p1", "p2", "sx", "sy", "sz", "ax", "ay", "az", "length", "radius"
    };
    json_t *ids = json_object_get(columns, "p1"), *cell;
    const char *label;
    size_t number = 0;
    for (size_t k = 0; k < WF_COUNT(needed); k++)
        if (!json_is_object(json_object_get(columns, needed[k])))
            return wf_fail(e, WF_EINPUT, "%s: error: the table cyls has no column %s", s->q->file, needed[k]);
    enum wf_status status = nodes_begin(s, json_object_size(ids), a, e);
    if (status) return status;
    if (!(s->lower = wf_arena_take(a, s->room, sizeof *s->lower)))
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu nodes", s->q->file, s->room);
    json_object_foreach(ids, label, cell) read_cyl(s, columns, label, ++number);
    if (!cyls_lead_down(s, a, e))
        return wf_fail(e, WF_EINPUT,
                       "%s: error: the cylinders of cyls do not lead from node p1 down to node p2",
                       s->q->file);
    return nodes_to_rows(s, a, e);
}

static enum wf_status read_treegraph(struct nodes *s, const struct wf_import_head *h,
                                     const struct wf_import_options *o, struct wf_arena *a, struct wf_err *e)
{
    struct wf_bytes b;
    json_error_t where;
    (void)o;
    enum wf_status status = wf_file_read_text(h->path, a, &b, e);
    if (status) return status;
    json_t *file = json_loadb(b.data, b.size, 0, &where), *cyls = json_object_get(file, "cyls");
    if (!file)
        return wf_fail(e, WF_EINPUT, "%s:%d:%d: error: not JSON: %s", h->path, where.line, where.column,
                       where.text);
    json_t *columns = json_is_string(cyls)
                          ? json_loadb(json_string_value(cyls), json_string_length(cyls), 0, &where)
                          : json_incref(cyls);
    if (json_is_object(columns))
        status = read_columns(s, columns, a, e);
    else
        status =
            wf_fail(e, WF_EINPUT, "%s: error: JSON without a table cyls: not a tree of treegraph", h->path);
    json_decref(columns);
    json_decref(file);
    return status;
}

/* ---- The forms ---- */

/* First line of the text that is no comment. */
static const char *first_data(const struct wf_import_head *h, struct node_text *t, const char **stop)
{
    const char *text = h->text;
    if (!strncmp(text, "\xEF\xBB\xBF", 3)) text += 3;
    *t = (struct node_text){ .at = text, .end = h->text + h->size, .point = '.' };
    const char *p = next_line(t, stop);
    return p ? p : (*stop = t->end);
}

static bool is_treegraph(const struct wf_import_head *h)
{
    struct node_text t;
    const char *stop;
    return *first_data(h, &t, &stop) == '{';
}

/* An SWC line: whole id, kind and parent; the first parent is -1. */
static bool is_swc(const struct wf_import_head *h)
{
    struct node_text t;
    const char *stop, *p = first_data(h, &t, &stop);
    double v[SWC_COLUMNS];
    return read_swc_line(p, stop, v) && v[0] == floor(v[0]) && v[1] == floor(v[1]) && v[6] == -1;
}

/* Is there a column x? Most tables of cylinders have none, and reading the units of names takes milliseconds.
 */
static bool names_a_point(const char *p, const char *stop)
{
    for (bool begins = true; p < stop; p++) {
        if (begins && tolower((unsigned char)*p) == 'x' && (p + 1 == stop || !isalnum((unsigned char)p[1])))
            return true;
        begins = *p == ',' || *p == ';' || (begins && isspace((unsigned char)*p)) || *p == '\t';
    }
    return false;
}

static bool read_head_line(const struct wf_import_head *h, struct node_text *t, struct ray_header *header)
{
    const struct wf_import_options plain = { .length_unit = (double)NAN, .diameter_unit = (double)NAN };
    const char *stop, *p = first_data(h, t, &stop);
    header->columns.e =
        NULL; /* a file whose units cannot be read is refused by its reader, with the reason */
    if (!names_a_point(p, stop) || wf_units_open(&header->columns.units, NULL)) return false;
    bool read = read_ray_header(p, stop, &plain, header);
    wf_units_close(header->columns.units);
    return read;
}

/* Cells of a line, whatever is in them. */
static size_t count_cells(const char *p, const char *stop)
{
    size_t n = (size_t)(stop - p), cells = 1;
    char separator = memchr(p, ';', n) ? ';' : memchr(p, '\t', n) ? '\t' : ',';
    for (; p < stop; p++) cells += *p == separator;
    return cells;
}

/* The header names a node without an id, and a line has more cells than the header has names. */
static bool is_ray(const struct wf_import_head *h)
{
    struct node_text t;
    struct ray_header header;
    const char *stop, *p;
    if (!read_head_line(h, &t, &header) || header.columns.at[NODE_ID] != WF_CSV_NONE) return false;
    if (header.columns.at[NODE_PARENT] == WF_CSV_NONE) return true; /* trunks: refused by its reader */
    while ((p = next_line(&t, &stop)))
        if (count_cells(p, stop) > header.tree + header.node) return true;
    return false;
}

static bool is_table(const struct wf_import_head *h)
{
    struct node_text t;
    struct ray_header header;
    return read_head_line(h, &t, &header) && header.columns.at[NODE_PARENT] != WF_CSV_NONE;
}

/* Sources: treegraph's module that writes its JSON, and Yang et al. 2024 (Remote Sens. Ecol.
 * Conserv., 10.1002/ rse2.399); SWC specification of INCF, after Cannon et al. 1998 (J. Neurosci. Methods
 * 84:49-54); README of treetools, which describes the files of raycloudtools; PypeTree's own model files
 * (Delagrange et al. 2014, Remote Sens. 6:4271-4300). Units: metres, except that SWC's are not those of a
 * tree. */
static const struct {
    const char *name; /* of the format, for people */
    bool (*is)(const struct wf_import_head *h);
    enum wf_status (*read)(struct nodes *s, const struct wf_import_head *h, const struct wf_import_options *o,
                           struct wf_arena *a, struct wf_err *e);
} forms[] = {
    { "treegraph JSON", is_treegraph, read_treegraph },
    { "SWC nodes", is_swc, read_swc },
    { "raycloudtools trees", is_ray, read_ray },
    { "table of nodes", is_table, read_table },
};

bool wf_import_is_nodes(const struct wf_import_head *h)
{
    for (size_t k = 0; k < WF_COUNT(forms); k++)
        if (forms[k].is(h)) return true;
    return false;
}

enum wf_status wf_import_nodes(const struct wf_import_head *h, const struct wf_import_options *o,
                               struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct nodes s = { .q = q, .strict = o->strict, .diag = d };
    size_t k = 0;
    while (k + 1 < WF_COUNT(forms) && !forms[k].is(h)) k++;
    q->format = forms[k].name;
    return forms[k].read(&s, h, o, a, e);
}
