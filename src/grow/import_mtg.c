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
 * entity of the same scale. Syntax of the file: manual of OpenAlea.mtg, "File syntax", coding files of
 * FORM-A: N2<<N9 stands for N2<N3<...<N9, where only the last has the features of the line, N2<.<N9 for the
 * same where all have them; ++ and +.+ likewise with '+'. */

enum { MTG_CLASSES = 64, MTG_COLUMNS = 256, MTG_RANGE = 10000, MTG_ENTITIES = 5000000 };
enum { MTG_NONE = -1, MTG_UNREAD = -2 }; /* in mtg_graph.last: no entity; one that could not be read */

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
    int32_t order;   /* how many '+' lead to it                                         */
    bool first;      /* first part of its complex                                       */
    bool implied;    /* within a range: has no features and no segment of its own       */
    size_t line;
    double point[3]; /* XX YY ZZ, NAN = not given */
    double diameter; /* NAN = not given           */
    double start[3]; /* of the segment, when the file gives it; NAN = not given */
    double bottom;   /* diameter at the start; NAN = not given                  */
    double length;   /* stated; NAN = not given                                 */
    double level;    /* branch order; NAN = not given                           */
};

/* Features that are read: a place in mtg_graph.column. The last six are those of windfirm's own files. */
enum mtg_feature {
    MTG_X,
    MTG_Y,
    MTG_Z,
    MTG_THICK,
    MTG_START_X,
    MTG_START_Y,
    MTG_START_Z,
    MTG_BOTTOM,
    MTG_LENGTH,
    MTG_ORDER,
    MTG_FEATURES
};

struct mtg_graph {
    struct mtg_class class[MTG_CLASSES];
    size_t classes;
    size_t entity_columns;       /* tab columns that may hold an entity                     */
    size_t column[MTG_FEATURES]; /* 0: the file does not have it                      */
    double diameter_share;       /* 1 for diameters, 2 for a radius column            */
    struct wf_arena *arena;
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

/* Which feature a cell of the line of column names means; -1: one that is not used. */
static int feature_named(struct mtg_graph *g, const char *p, size_t n)
{
    static const struct {
        const char *name;
        enum mtg_feature feature;
        double share; /* diameters per unit of a thickness */
    } names[] = {
        { "XX", MTG_X, 1 },
        { "X", MTG_X, 1 },
        { "YY", MTG_Y, 1 },
        { "Y", MTG_Y, 1 },
        { "ZZ", MTG_Z, 1 },
        { "Z", MTG_Z, 1 },
        { "TopDia", MTG_THICK, 1 },
        { "Diam", MTG_THICK, 1 },
        { "Dia", MTG_THICK, 1 },
        { "Diameter", MTG_THICK, 1 },
        { "TopDiameter", MTG_THICK, 1 },
        { "radius", MTG_THICK, 2 },
        { "StartX", MTG_START_X, 1 },
        { "StartY", MTG_START_Y, 1 },
        { "StartZ", MTG_START_Z, 1 },
        { "BottomRadius", MTG_BOTTOM, 2 },
        { "StatedLength", MTG_LENGTH, 1 },
        { "BranchOrder", MTG_ORDER, 1 },
    };
    while (n && (p[n - 1] == ' ' || p[n - 1] == '\r')) n--;
    for (size_t k = 0; k < WF_COUNT(names); k++) {
        if (strlen(names[k].name) != n || strncasecmp(p, names[k].name, n)) continue;
        if (names[k].feature == MTG_THICK) g->diameter_share = names[k].share;
        return (int)names[k].feature;
    }
    return -1;
}

static enum wf_status read_feature_columns(struct mtg_graph *g, const char *file, const char *p,
                                           const char *stop, size_t line, struct wf_err *e)
{
    bool found[MTG_FEATURES] = { false };
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
            "%s:%zu: error: the features XX, YY, ZZ and a diameter (TopDia, Diam, diameter) or radius are "
            "needed; %s is missing (a graph by lengths, widths and angles, as of AMAP, is not read)",
            file, line, !found[3] ? "a diameter" : "a coordinate");
    if (!found[MTG_START_X] || !found[MTG_START_Y] || !found[MTG_START_Z])
        memset(g->column + MTG_START_X, 0, (MTG_FEATURES - MTG_START_X) * sizeof *g->column);
    if (!g->entity_columns || g->entity_columns > MTG_COLUMNS)
        return wf_fail(e, WF_EINPUT, "%s:%zu: error: no column for entities before the features", file, line);
    return WF_OK;
}

/* Whether a line is that of the column names: its first cell is TOPO, formerly ENTITY-CODE. */
static bool names_columns(const char *line)
{
    static const char *const words[] = { "ENTITY-CODE", "TOPO" };
    for (size_t k = 0; k < WF_COUNT(words); k++) {
        size_t n = strlen(words[k]);
        if (!strncmp(line, words[k], n) && strchr("\t\r\n ", line[n])) return true;
    }
    return false;
}

/* Read classes and features, up to and including the line of column names. *at is moved to the line after it.
 * Errors: WF_EINPUT with what is missing. */
static enum wf_status read_mtg_head(struct mtg_graph *g, const char *file, const char **at, size_t *line,
                                    struct wf_err *e)
{
    enum { BEFORE, CLASSES, BEHIND } part = BEFORE;
    const char *stop;
    for (; next_mtg_line(at, &stop, line); *at = *stop ? stop + 1 : stop) {
        if (!strncmp(*at, "CODE", 4) && memmem(*at, (size_t)(stop - *at), "FORM-B", 6))
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: FORM-B, in which axes may be written from the top down, is not "
                           "read; FORM-A is",
                           file, *line);
        if (names_columns(*at)) {
            if (!g->classes)
                return wf_fail(e, WF_EINPUT, "%s: error: no classes before TOPO (or ENTITY-CODE)", file);
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
    return wf_fail(e, WF_EINPUT,
                   "%s: error: no line of column names (TOPO or ENTITY-CODE) in this tree graph", file);
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
    v.order = v.below < 0 ? 0 : g->entity[v.below].order + (v.edge == '+');
    for (int k = 0; k < 3; k++) v.point[k] = v.start[k] = (double)NAN;
    v.diameter = v.bottom = v.length = v.level = (double)NAN;
    g->entity[me] = v;
    for (int32_t c = v.complex; c >= 0; c = g->entity[c].complex) g->entity[c].fine = me;
    if (scale > g->finest) g->finest = scale;
    return me;
}

/* Make room for n more entities. */
static bool room_for(struct mtg_graph *g, size_t n)
{
    if (n <= g->room - g->n) return true;
    size_t room = 2 * g->room > g->n + n ? 2 * g->room : g->n + n;
    struct mtg_entity *more = g->n + n <= MTG_ENTITIES ? WF_TAKE(g->arena, room, struct mtg_entity) : NULL;
    if (!more) return false;
    if (g->n) memcpy(more, g->entity, g->n * sizeof *more);
    g->entity = more, g->room = room;
    return true;
}

/* A label such as N2: a class and a number. */
struct mtg_label {
    int scale;   /* -1: no class that the file declares */
    long number; /* -1: none                            */
};

static struct mtg_label read_label(const struct mtg_graph *g, const char **p, const char *stop)
{
    const char *symbol = *p;
    while (*p < stop && isalpha((unsigned char)**p)) (*p)++;
    if (*p == symbol && *p < stop && **p == '$') (*p)++;
    struct mtg_label l = { scale_of_class(g, symbol, (size_t)(*p - symbol)), -1 };
    for (; *p < stop && isdigit((unsigned char)**p); (*p)++)
        if (l.number < 100000000) l.number = 10 * (l.number < 0 ? 0 : l.number) + (**p - '0');
    return l;
}

/* The relation at *p: one sign, or that of a range, which repeats the sign. Returned: the sign; 0 for
 * something else. */
static char read_relation(const char **p, const char *stop, bool *range, bool *shared)
{
    char sign = **p;
    size_t left = (size_t)(stop - *p);
    if (sign != '/' && sign != '<' && sign != '+') return 0;
    bool twice = sign != '/' && left > 1 && (*p)[1] == sign;
    *shared = sign != '/' && left > 2 && (*p)[1] == '.' && (*p)[2] == sign;
    *range = twice || *shared;
    *p += *shared ? 3 : twice ? 2 : 1;
    return sign;
}

/* The entities of one code, and from which on the features of the line are theirs. */
struct mtg_code {
    int32_t from;
    struct mtg_label last;
    size_t shared; /* first entity that has the features of the line */
};

/* Add the entities between the last label and `to`, which have the same class. */
static const char *add_range(struct mtg_graph *g, struct mtg_code *c, char edge, struct mtg_label to,
                             bool shared, size_t line)
{
    if (c->from < 0 || c->last.number < 0 || to.number < 0)
        return "a range (<< or ++) needs a number on both sides";
    if (to.scale != c->last.scale) return "the two ends of a range are not of one scale";
    if (to.number <= c->last.number) return "a range counts upwards";
    if (to.number - c->last.number > MTG_RANGE) return "a range of more than 10000 entities";
    if (!room_for(g, (size_t)(to.number - c->last.number))) return "more entities than are handled";
    c->shared = shared ? (size_t)c->from : c->shared;
    g->entity[c->from].implied = !shared;
    for (long k = c->last.number + 1; k < to.number; k++) {
        c->from = add_entity(g, c->from, edge, to.scale, line);
        if (c->from < 0) return "the edge does not fit the scales of the two entities";
        g->entity[c->from].implied = !shared;
    }
    return NULL;
}

/* Add all entities of p..stop, such as "<S2" or "/P1/A1", behind c->from. */
static const char *read_entities(struct mtg_graph *g, struct mtg_code *c, const char *p, const char *stop,
                                 size_t line)
{
    while (p < stop) {
        bool range, shared;
        char edge = read_relation(&p, stop, &range, &shared);
        if (!edge) return "an entity starts with '/', '<' or '+'";
        struct mtg_label label = read_label(g, &p, stop);
        if (label.scale < 0) return "the entity is not of a class this file declares";
        const char *wrong = range ? add_range(g, c, edge, label, shared, line) : NULL;
        if (wrong) return wrong;
        if (!room_for(g, 1)) return "more entities than are handled";
        c->from = add_entity(g, c->from, edge, label.scale, line);
        if (c->from < 0) return "the edge does not fit the scales of the two entities";
        if (!(range && shared)) c->shared = (size_t)c->from;
        c->last = label;
    }
    return NULL;
}

/* Add all entities of a code in a tab column. A code that cannot be read makes its column unknown, so that
 * what continues it is not joined to something else. Returned: NULL, or what is wrong; *shared: the first of
 * the entities that have the features of the line. */
static const char *read_code(struct mtg_graph *g, size_t column, const char *p, const char *stop, size_t line,
                             size_t *shared)
{
    struct mtg_code c = { .from = MTG_NONE, .last.number = -1 };
    const char *wrong = NULL;
    if (*p == '^') {
        c.from = g->last[column];
        if (c.from == MTG_NONE) wrong = "'^' without an entity above it in this column";
        p++;
    } else {
        for (size_t k = column; k-- > 0 && c.from == MTG_NONE;) c.from = g->last[k];
        if (column && c.from == MTG_NONE) wrong = "no entity in a column to the left to start from";
    }
    if (c.from == MTG_UNREAD) wrong = "the entity it continues could not be read";
    if (!wrong && p == stop) wrong = "an entity is expected behind '^'";
    if (!wrong) wrong = read_entities(g, &c, p, stop, line);
    g->last[column] = wrong ? MTG_UNREAD : c.from;
    for (size_t k = column + 1; k < g->entity_columns; k++) g->last[k] = MTG_NONE;
    *shared = c.shared;
    return wrong;
}

static void set_features(struct mtg_entity *v, const double value[MTG_FEATURES], double share)
{
    memcpy(v->point, value, sizeof v->point);
    memcpy(v->start, value + MTG_START_X, sizeof v->start);
    v->diameter = value[MTG_THICK] * share;
    v->bottom = value[MTG_BOTTOM] * 2;
    v->length = value[MTG_LENGTH];
    v->level = value[MTG_ORDER];
}

/* Read the features of a line for the entities from number `shared` on. */
static const char *read_features(struct mtg_graph *g, const char *p, const char *stop, size_t shared)
{
    double value[MTG_FEATURES];
    for (int f = 0; f < MTG_FEATURES; f++) value[f] = (double)NAN;
    for (size_t column = 0;; column++) {
        const char *tab = memchr(p, '\t', (size_t)(stop - p)), *end = tab ? tab : stop;
        while (end > p && end[-1] == ' ') end--;
        for (int f = 0; column && f < MTG_FEATURES; f++)
            if (g->column[f] == column && end > p && wf_number_read(p, end, '.', &value[f]) != end)
                return "a coordinate or diameter is not a number";
        if (!tab) break;
        p = tab + 1;
    }
    for (size_t k = shared; k < g->n; k++) set_features(&g->entity[k], value, g->diameter_share);
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
    const char *note = memchr(p, '#', (size_t)(end - p)), *trimmed = note ? note : end;
    while (trimmed > p && trimmed[-1] == ' ') trimmed--;
    size_t shared = 0;
    const char *wrong = read_code(g, column, p, trimmed, line, &shared);
    return wrong ? wrong : read_features(g, start, stop, shared);
}

/* From the graph to rows. */

struct mtg_size {
    double high, thick; /* height and largest diameter, in the file's numbers */
};

static struct mtg_size size_in_file(const struct mtg_graph *g)
{
    double low = INFINITY, high = -INFINITY, thick = 0;
    for (size_t i = 0; i < g->n; i++) {
        const struct mtg_entity *v = &g->entity[i];
        if (v->point[2] < low) low = v->point[2];
        if (v->point[2] > high) high = v->point[2];
        if (v->diameter > thick) thick = v->diameter;
    }
    return (struct mtg_size){ high > low ? high - low : 0, thick };
}

static const double TALLEST = 130, LOWEST = 0.5; /* of a tree [m]: none is higher, few scans are lower */

/* Metres per unit of lengths and of diameters. An MTG does not state them; windfirm's own are in metres. Its
 * coordinates are taken as centimetres, as of digitised trees; with a feature `radius` as metres, as
 * PlantScan3D writes them, unless the tree would be higher than any. Diameters are centimetres when the tree
 * then is more slender than 5, else millimetres; a radius has the unit of the coordinates when the tree then
 * is. */
static void units_of_graph(struct wf_qsm *q, const struct mtg_graph *g, const struct wf_import_options *o,
                           double *unit, double *thick, struct wf_diag *d)
{
    struct mtg_size z = size_in_file(g);
    bool radius = g->diameter_share > 1;
    bool own = g->column[MTG_START_X] != 0, metres = own || (radius && z.high <= TALLEST);
    *unit = !isnan(o->length_unit) ? o->length_unit : metres ? 1 : 0.01;
    *thick = own && isnan(o->diameter_unit) ? *unit : o->diameter_unit;
    if (isnan(*thick)) {
        wf_qsm_count(q, WF_NOTE_UNITS, 1, -1);
        *thick = radius ? *unit : 0.01;
        if (z.high * *unit <= 5 * *thick * z.thick) *thick = 0.01;
        if (z.high * *unit <= 5 * *thick * z.thick) *thick = 0.001;
    }
    double high = z.high * *unit;
    if (!isnan(o->length_unit) || own) return;
    if (metres)
        wf_diag_warn(
            d, "unit-assumed",
            "%s: the file states no unit; coordinates with a feature radius are taken as metres, and "
            "the tree is %.3g m high; if that is wrong, name the unit by --length-unit",
            q->name, high);
    else if (high < LOWEST)
        wf_diag_warn(d, "unit-assumed",
                     "%s: the file states no unit; taken as centimetres the tree is only %.3g m high; with "
                     "--length-unit m it is %.3g m",
                     q->name, high, z.high);
}

/* How an entity is joined when the implied ones between are passed over. */
struct mtg_link {
    int32_t below;                /* the next entity with a segment; -1: none */
    bool along;                   /* it follows, and does not branch          */
    const struct mtg_entity *top; /* the complex that it begins; NULL: none   */
};

static struct mtg_link link_of(const struct mtg_graph *g, size_t v)
{
    struct mtg_link l = { .along = true };
    for (int32_t u = (int32_t)v;; u = l.below) {
        const struct mtg_entity *s = &g->entity[u];
        l.along = l.along && s->edge == '<';
        if (s->first && s->complex >= 0) l.top = &g->entity[s->complex];
        l.below = s->below;
        if (l.below < 0) l.along = false;
        if (l.below < 0 || !g->entity[l.below].implied) return l;
    }
}

/* Start, end and radii of row i of entity s, from those of the row below (-1: none). */
static void place_mtg_row(struct wf_qsm *q, const struct mtg_entity *s, const struct mtg_link *l, size_t i,
                          int32_t below, double unit, double thick)
{
    double end[3] = { (double)NAN, (double)NAN, (double)NAN }, start[3];
    if (below >= 0) end[0] = q->x1[below], end[1] = q->y1[below], end[2] = q->z1[below];
    memcpy(start, end, sizeof start);
    if (l->top && !isnan(l->top->point[0]))
        for (int k = 0; k < 3; k++) start[k] = l->top->point[k] * unit;
    for (int k = 0; k < 3; k++) {
        if (!isnan(s->start[k])) start[k] = s->start[k] * unit;
        end[k] = isnan(s->point[0]) ? start[k] : s->point[k] * unit;
    }
    if (isnan(start[0])) memcpy(start, end, sizeof start);
    q->x0[i] = start[0], q->y0[i] = start[1], q->z0[i] = start[2];
    q->x1[i] = end[0], q->y1[i] = end[1], q->z1[i] = end[2];
    q->r1[i] = s->diameter > 0 ? 0.5 * s->diameter * thick : (double)NAN;
    q->r0[i] = l->along                         ? q->r1[below]
               : l->top && l->top->diameter > 0 ? 0.5 * l->top->diameter * thick
                                                : q->r1[i];
    if (s->bottom > 0) q->r0[i] = 0.5 * s->bottom * thick;
    if (s->length > 0) q->length[i] = s->length * unit;
}

/* Write row i, that of entity v. row[]: row of each entity, -1: it has none. */
static void write_mtg_row(struct wf_qsm *q, const struct mtg_graph *g, const int32_t *row, size_t v,
                          double unit, double thick)
{
    const struct mtg_entity *s = &g->entity[v];
    struct mtg_link l = link_of(g, v);
    size_t i = (size_t)row[v];
    int32_t below = l.below >= 0 ? row[l.below] : -1;
    q->id[i] = (int64_t)i + 1;
    q->parent_id[i] = below >= 0 ? q->id[below] : 0;
    q->line[i] = s->line;
    q->order[i] = s->level >= 0 && s->level < 1000 ? (int32_t)s->level : s->order;
    l.along = l.along && below >= 0;
    if (l.along) q->next_id[below] = q->id[i];
    place_mtg_row(q, s, &l, i, below, unit, thick);
}

/* Number the rows: one for each entity of the finest scale that is not implied. Returned: how many. */
static size_t number_rows(const struct mtg_graph *g, int32_t *row)
{
    size_t n = 0;
    for (size_t v = 0; v < g->n; v++)
        row[v] = g->entity[v].scale == g->finest && !g->entity[v].implied ? (int32_t)n++ : -1;
    return n;
}

static enum wf_status write_mtg_rows(struct wf_qsm *q, const struct mtg_graph *g,
                                     const struct wf_import_options *o, struct wf_arena *a, struct wf_diag *d,
                                     struct wf_err *e)
{
    int32_t *row = WF_TAKE(a, g->n, int32_t);
    if (!row) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu entities", g->n);
    enum wf_status s = wf_qsm_alloc(q, number_rows(g, row), a, e);
    if (s) return s;
    double unit, thick;
    units_of_graph(q, g, o, &unit, &thick, d);
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
    for (int k = 0; k < MTG_COLUMNS; k++) g->last[k] = MTG_NONE;
    g->arena = a;
    const char *at = b.data, *end = b.data + b.size;
    size_t line = 0, bad = 0;
    if ((s = read_mtg_head(g, h->path, &at, &line, e))) return s;
    for (const char *p = at; p < end && bad < MTG_ENTITIES; p++) bad += *p == '/' || *p == '<' || *p == '+';
    if (!room_for(g, bad))
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu entities", h->path, bad);
    bad = 0;
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
    return write_mtg_rows(q, g, o, a, d, e);
}
