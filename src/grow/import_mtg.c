/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import_mtg.h"
#include "base/file.h"
#include "base/num.h"
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The graph of a multi-scale tree graph file (Godin & Caraglio 1998, J. Theor. Biol. 191:1-46) has entities
 * at several scales. Edges: '/' decomposes an entity into finer ones; '<' follows and '+' branches from an
 * entity of the same scale. */

enum { MTG_CLASSES = 64, MTG_COLUMNS = 256 };

struct mtg_class {
    char symbol[16];
    int scale;
};

/* One entity. Links are indices, -1 = none. */
struct mtg_entity {
    int scale;
    char edge;       /* '<' or '+': to `below`; '/': a root. The first part of a complex has its complex's */
    int32_t complex; /* the entity of the next coarser scale that it is part of         */
    int32_t below;   /* the entity it follows or branches from, at the finest scale known */
    int32_t fine;    /* its last part at the finest scale                               */
    bool first;      /* first part of its complex                                       */
    size_t line;
    double point[3]; /* XX YY ZZ, NAN = not given */
    double diameter; /* NAN = not given           */
};

struct mtg_graph {
    struct mtg_class class[MTG_CLASSES];
    size_t classes;
    size_t entity_columns; /* tab columns that may hold an entity                     */
    size_t column[4];      /* of XX, YY, ZZ and the diameter                          */
    double diameter_share; /* 1 for diameters, 2 for a radius column                  */
    struct mtg_entity *entity;
    size_t n, room;
    int finest;
    int32_t last[MTG_COLUMNS]; /* the newest entity of each tab column */
};

/* The header: symbols with their scale, and which tab column holds which feature. */

/* The next line without its end; false at the end of the text. */
static bool next_mtg_line(const char **at, const char **stop, size_t *line)
{
    if (!**at) return false;
    *stop = *at + strcspn(*at, "\n");
    (*line)++;
    return true;
}

static void read_class(struct mtg_graph *g, const char *p)
{
    char symbol[16];
    size_t n = strcspn(p, " \t\r\n");
    if (!n || n >= sizeof symbol || g->classes == MTG_CLASSES) return;
    memcpy(symbol, p, n);
    symbol[n] = '\0';
    p += n + strspn(p + n, " \t");
    if (!isdigit((unsigned char)*p)) return;
    struct mtg_class *c = &g->class[g->classes++];
    memcpy(c->symbol, symbol, sizeof symbol);
    c->scale = (int)strtol(p, NULL, 10);
}

/* Which feature a cell of the ENTITY-CODE line names: 0..2 coordinates, 3 diameter, -1 a feature not used. */
static int feature_named(struct mtg_graph *g, const char *p, size_t n)
{
    static const struct {
        const char *name;
        int feature;
        double share;
    } names[] = {
        { "XX", 0, 1 },     { "X", 0, 1 },        { "YY", 1, 1 },       { "Y", 1, 1 },
        { "ZZ", 2, 1 },     { "Z", 2, 1 },        { "TopDia", 3, 1 },   { "Diam", 3, 1 },
        { "Dia", 3, 1 },    { "Diameter", 3, 1 }, { "diameter", 3, 1 }, { "TopDiameter", 3, 1 },
        { "radius", 3, 2 },
    };
    while (n && (p[n - 1] == ' ' || p[n - 1] == '\r')) n--;
    for (size_t k = 0; k < WF_COUNT(names); k++) {
        if (strlen(names[k].name) != n || strncasecmp(p, names[k].name, n)) continue;
        if (names[k].feature == 3) g->diameter_share = names[k].share;
        return names[k].feature;
    }
    return -1;
}

static enum wf_status read_feature_columns(struct mtg_graph *g, const char *file, const char *p,
                                           const char *stop, size_t line, struct wf_err *e)
{
    bool found[4] = { false };
    g->entity_columns = 0;
    for (size_t column = 0;; column++) {
        size_t n = strcspn(p, "\t\n");
        if (column && n && *p != '\r' && !g->entity_columns) g->entity_columns = column;
        int f = column ? feature_named(g, p, n) : -1;
        if (f >= 0) g->column[f] = column, found[f] = true;
        p += n;
        if (p >= stop || *p != '\t') break;
        p++;
    }
    if (!found[0] || !found[1] || !found[2] || !found[3])
        return wf_fail(
            e, WF_EINPUT,
            "%s:%zu: error: the features XX, YY, ZZ and a diameter (TopDia, Diam, diameter) are needed; "
            "%s is missing",
            file, line, !found[3] ? "a diameter" : "a coordinate");
    if (!g->entity_columns || g->entity_columns > MTG_COLUMNS)
        return wf_fail(e, WF_EINPUT, "%s:%zu: error: no column for entities before the features", file, line);
    return WF_OK;
}

/* Read classes and features, up to and including the ENTITY-CODE line. *at is moved to the line after it.
 * Errors: WF_EINPUT with what is missing. */
static enum wf_status read_mtg_head(struct mtg_graph *g, const char *file, const char **at, size_t *line,
                                    struct wf_err *e)
{
    enum { BEFORE, CLASSES, BEHIND } part = BEFORE;
    const char *stop;
    for (; next_mtg_line(at, &stop, line); *at = *stop ? stop + 1 : stop) {
        if (!strncmp(*at, "ENTITY-CODE", 11)) {
            if (!g->classes) return wf_fail(e, WF_EINPUT, "%s: error: no classes before ENTITY-CODE", file);
            enum wf_status s = read_feature_columns(g, file, *at, stop, *line, e);
            *at = *stop ? stop + 1 : stop;
            return s;
        }
        if (!strncmp(*at, "CLASSES", 7))
            part = CLASSES;
        else if (!strncmp(*at, "DESCRIPTION", 11) || !strncmp(*at, "FEATURES", 8))
            part = BEHIND;
        else if (part == CLASSES && strncmp(*at, "SYMBOL", 6))
            read_class(g, *at);
    }
    return wf_fail(e, WF_EINPUT, "%s: error: no ENTITY-CODE line in this tree graph", file);
}

/* The lines: the place of an entity in the graph follows from its tab column and its edges. */

static int scale_of_class(const struct mtg_graph *g, const char *p, size_t n)
{
    for (size_t k = 0; k < g->classes; k++)
        if (strlen(g->class[k].symbol) == n && !strncmp(g->class[k].symbol, p, n)) return g->class[k].scale;
    return -1;
}

/* The entity of scale `scale` (or the next coarser one there is) that contains `v`; -1: none. */
static int32_t at_scale(const struct mtg_graph *g, int32_t v, int scale)
{
    while (v >= 0 && g->entity[v].scale > scale) v = g->entity[v].complex;
    return v;
}

/* Add an entity that `edge` connects to `from`. Returned: its index; -1 when the scales do not fit the edge.
 */
static int32_t add_entity(struct mtg_graph *g, int32_t from, char edge, int scale, size_t line)
{
    struct mtg_entity v = { .scale = scale, .edge = edge, .complex = -1, .below = -1, .line = line };
    if (from >= 0 && edge == '/') {
        v.complex = at_scale(g, from, scale - 1);
        if (v.complex < 0 || g->entity[v.complex].scale >= scale) return -1;
        const struct mtg_entity *c = &g->entity[v.complex];
        v.first = c->fine == v.complex; /* no finer part yet */
        v.below = v.first ? c->below : c->fine;
        v.edge = v.first ? c->edge : '<';
    } else if (from >= 0) {
        int32_t p = at_scale(g, from, scale);
        if (p < 0 || g->entity[p].scale != scale) return -1;
        v.complex = g->entity[p].complex;
        v.below = g->entity[from].fine;
    }
    int32_t me = (int32_t)g->n++;
    v.fine = me;
    for (int k = 0; k < 3; k++) v.point[k] = (double)NAN;
    v.diameter = (double)NAN;
    g->entity[me] = v;
    for (int32_t c = v.complex; c >= 0; c = g->entity[c].complex) g->entity[c].fine = me;
    if (scale > g->finest) g->finest = scale;
    return me;
}

/* Add all entities of a code such as "^<S2" or "/P1/A1". Returned: NULL, or what is wrong. */
static const char *read_code(struct mtg_graph *g, size_t column, const char *p, const char *stop, size_t line)
{
    int32_t from = -1;
    if (*p == '^') {
        from = g->last[column];
        if (from < 0) return "'^' without an entity above it in this column";
        p++;
    } else {
        for (size_t k = column; k-- > 0 && from < 0;) from = g->last[k];
        if (column && from < 0) return "no entity in a column to the left to start from";
    }
    if (p == stop) return "an entity is expected behind '^'";
    while (p < stop) {
        char edge = *p++;
        if (edge != '/' && edge != '<' && edge != '+') return "an entity starts with '/', '<' or '+'";
        const char *symbol = p;
        while (p < stop && isalpha((unsigned char)*p)) p++;
        int scale = scale_of_class(g, symbol, (size_t)(p - symbol));
        if (scale < 0) return "the entity is not of a class this file declares";
        while (p < stop && isdigit((unsigned char)*p)) p++;
        if (g->n == g->room) return "more entities than there are places for";
        from = add_entity(g, from, edge, scale, line);
        if (from < 0) return "the edge does not fit the scales of the two entities";
    }
    g->last[column] = from;
    for (size_t k = column + 1; k < g->entity_columns; k++) g->last[k] = -1;
    return NULL;
}

static const char *read_features(struct mtg_graph *g, const char *p, const char *stop)
{
    struct mtg_entity *v = &g->entity[g->n - 1];
    double value[4] = { (double)NAN, (double)NAN, (double)NAN, (double)NAN };
    for (size_t column = 0;; column++) {
        const char *tab = memchr(p, '\t', (size_t)(stop - p)), *end = tab ? tab : stop;
        for (int f = 0; f < 4; f++)
            if (g->column[f] == column && end > p && wf_number_read(p, end, '.', &value[f]) != end)
                return "a coordinate or diameter is not a number";
        if (!tab) break;
        p = tab + 1;
    }
    memcpy(v->point, value, sizeof v->point);
    v->diameter = value[3] * g->diameter_share;
    return NULL;
}

/* Read one line, `start`..`stop` without the line end. Returned: NULL, or what is wrong. */
static const char *read_mtg_line(struct mtg_graph *g, const char *start, const char *stop, size_t line)
{
    const char *p = start;
    size_t column = 0;
    while (stop > start && (stop[-1] == '\r' || stop[-1] == ' ')) stop--;
    while (p < stop && *p == '\t') p++, column++;
    if (p == stop || *p == '#') return NULL;
    if (column >= g->entity_columns) return "features without an entity";
    const char *end = memchr(p, '\t', (size_t)(stop - p));
    if (!end) end = stop;
    const char *trimmed = end;
    while (trimmed > p && trimmed[-1] == ' ') trimmed--;
    const char *wrong = read_code(g, column, p, trimmed, line);
    return wrong ? wrong : read_features(g, start, stop);
}

/* From the graph to rows. */

/* The unit of diameters [m], which a file does not state: centimetres if the tree is then more than five
 * times as high as its largest diameter, otherwise millimetres. */
static double infer_diameter_unit(struct wf_qsm *q, const struct mtg_graph *g, double length_unit)
{
    double low = INFINITY, high = -INFINITY, thick = 0;
    for (size_t i = 0; i < g->n; i++) {
        const struct mtg_entity *v = &g->entity[i];
        if (v->point[2] < low) low = v->point[2];
        if (v->point[2] > high) high = v->point[2];
        if (v->diameter > thick) thick = v->diameter;
    }
    wf_qsm_count(q, WF_NOTE_UNITS, 1, -1);
    return (high - low) * length_unit > 5 * 0.01 * thick ? 0.01 : 0.001;
}

/* Write the row of entity v, one of the finest scale. row[]: row of each entity, -1 for coarser ones; metres
 * per unit of lengths and of diameters. */
static void write_mtg_row(struct wf_qsm *q, const struct mtg_graph *g, const int32_t *row, size_t v,
                          double unit, double thick)
{
    const struct mtg_entity *s = &g->entity[v], *c = s->complex >= 0 ? &g->entity[s->complex] : NULL;
    size_t i = (size_t)row[v];
    int32_t below = s->below >= 0 ? row[s->below] : -1;
    double end[3] = { (double)NAN, (double)NAN, (double)NAN }, start[3];
    if (below >= 0) end[0] = q->x1[below], end[1] = q->y1[below], end[2] = q->z1[below];
    memcpy(start, end, sizeof start);
    if (s->first && c && !isnan(c->point[0]))
        for (int k = 0; k < 3; k++) start[k] = c->point[k] * unit;
    for (int k = 0; k < 3; k++) end[k] = isnan(s->point[0]) ? start[k] : s->point[k] * unit;
    if (isnan(start[0])) memcpy(start, end, sizeof start);
    q->x0[i] = start[0], q->y0[i] = start[1], q->z0[i] = start[2];
    q->x1[i] = end[0], q->y1[i] = end[1], q->z1[i] = end[2];
    q->id[i] = (int64_t)i + 1;
    q->parent_id[i] = below >= 0 ? q->id[below] : 0;
    q->line[i] = s->line;
    q->r1[i] = s->diameter > 0 ? 0.5 * s->diameter * thick : (double)NAN;
    bool along = s->edge == '<' && below >= 0;
    q->r0[i] = along ? q->r1[below] : s->first && c && c->diameter > 0 ? 0.5 * c->diameter * thick : q->r1[i];
    q->order[i] = below < 0 ? 0 : q->order[below] + (s->edge == '+');
    if (along) q->next_id[below] = q->id[i];
}

static enum wf_status write_mtg_rows(struct wf_qsm *q, const struct mtg_graph *g,
                                     const struct wf_import_options *o, struct wf_arena *a, struct wf_err *e)
{
    size_t n = 0;
    int32_t *row = WF_TAKE(a, g->n, int32_t);
    if (!row) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu entities", g->n);
    for (size_t v = 0; v < g->n; v++) row[v] = g->entity[v].scale == g->finest ? (int32_t)n++ : -1;
    enum wf_status s = wf_qsm_alloc(q, n, a, e);
    if (s) return s;
    double unit = isnan(o->length_unit) ? 0.01 : o->length_unit;
    double thick = isnan(o->diameter_unit) ? infer_diameter_unit(q, g, unit) : o->diameter_unit;
    size_t missing = 0;
    for (size_t v = 0; v < g->n; v++) {
        if (row[v] < 0) continue;
        write_mtg_row(q, g, row, v, unit, thick);
        missing += isnan(q->x1[row[v]]) ? 1 : 0;
    }
    if (!missing) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s: error: %zu entities have no coordinates and none below them either",
                   q->file, missing);
}

enum wf_status wf_import_mtg(const struct wf_import_head *h, const struct wf_import_options *o,
                             struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct wf_bytes b;
    enum wf_status s = wf_file_read_table(h->path, a, &b, d, e);
    if (s) return s;
    struct mtg_graph *g = WF_TAKE(a, 1, struct mtg_graph);
    if (!g) return wf_fail(e, WF_ENOMEM, "%s: no memory", h->path);
    for (int k = 0; k < MTG_COLUMNS; k++) g->last[k] = -1;
    const char *at = b.data, *end = b.data + b.size;
    size_t line = 0, bad = 0;
    if ((s = read_mtg_head(g, h->path, &at, &line, e))) return s;
    for (const char *p = at; p < end; p++) g->room += *p == '/' || *p == '<' || *p == '+';
    g->entity = WF_TAKE(a, g->room, struct mtg_entity);
    if (!g->entity) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu entities", h->path, g->room);
    while (at < end) {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        if (!stop) stop = end;
        const char *wrong = read_mtg_line(g, at, stop, ++line);
        if (wrong) wf_import_bad_row(q, o->strict, bad = line, 0, wrong, d);
        at = stop < end ? stop + 1 : stop;
    }
    if (bad && bad == line && h->ends_open) {
        wf_import_last_row_cut(q, bad);
    }
    q->format = "OpenAlea MTG";
    return write_mtg_rows(q, g, o, a, e);
}
