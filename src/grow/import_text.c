/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import_text.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/num.h"
#include "base/vec3.h"
#include "grow/qsm.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Coordinates of a hand-measured table of lengths, diameters and angles. */

/* Measurements of each row: angle, zenith, azimuth [rad], distance [m], share [-]; NAN = not measured. */
struct hand_angles {
    double *angle, *zenith, *azimuth, *distance, *share;
};

static const double GOLDEN = 137.50776405003785 / 180 * WF_PI; /* divergence of spiral leaf positions [rad] */

/* Unit vector perpendicular to `t` whose direction is nearest to the azimuth `az` [rad]. */
static void unit_across(const double t[3], double az, double out[3])
{
    double h[3] = { cos(az), sin(az), 0 };
    double along = wf_dot(h, t);
    for (int k = 0; k < 3; k++) out[k] = h[k] - along * t[k];
    double norm = sqrt(wf_dot(out, out));
    if (norm < 1e-9) { /* the parent lies along the azimuth: tilt upwards */
        out[0] = out[1] = 0, out[2] = 1;
        norm = 1;
    }
    for (int k = 0; k < 3; k++) out[k] /= norm;
}

struct hand_placing {
    struct wf_qsm *q;
    const struct hand_angles *hand;
    double azimuth; /* of the last branch whose azimuth was not measured [rad] */
};

static double hand_azimuth(struct hand_placing *p, size_t i, bool leaning)
{
    double az = p->hand->azimuth[i];
    if (!isnan(az) || !leaning) return isnan(az) ? 0 : az;
    wf_qsm_count(p->q, WF_REPAIR_AZIMUTH, 1, p->q->id[i]);
    p->azimuth += GOLDEN;
    return p->azimuth;
}

static void place_row(struct hand_placing *p, size_t i, int32_t parent)
{
    struct wf_qsm *q = p->q;
    const struct hand_angles *h = p->hand;
    double start[3] = { 0, 0, 0 }, t[3] = { 0, 0, 1 }, d[3], u[3];
    if (parent >= 0) {
        size_t k = (size_t)parent;
        double length = wf_qsm_distance(q, k);
        double s = !isnan(h->distance[i]) ? h->distance[i] / length : isnan(h->share[i]) ? 1 : h->share[i];
        s = s < 0 ? 0 : s > 1 ? 1 : s;
        t[0] = (q->x1[k] - q->x0[k]) / length, t[1] = (q->y1[k] - q->y0[k]) / length;
        t[2] = (q->z1[k] - q->z0[k]) / length;
        start[0] = q->x0[k] + s * length * t[0], start[1] = q->y0[k] + s * length * t[1];
        start[2] = q->z0[k] + s * length * t[2];
    }
    double up[3] = { 0, 0, 1 };
    bool from_vertical = !isnan(h->zenith[i]);
    double angle = from_vertical ? h->zenith[i] : isnan(h->angle[i]) ? 0 : h->angle[i];
    const double *from = from_vertical ? up : t;
    unit_across(from, hand_azimuth(p, i, fabs(angle) > 1e-9), u);
    for (int k = 0; k < 3; k++) d[k] = q->length[i] * (cos(angle) * from[k] + sin(angle) * u[k]);
    q->x0[i] = start[0], q->y0[i] = start[1], q->z0[i] = start[2];
    q->x1[i] = start[0] + d[0], q->y1[i] = start[1] + d[1], q->z1[i] = start[2] + d[2];
}

/* Find the row of each parent. A parent of 0 or -1, an empty cell and an unknown id make the row a root, as
 * in wf_qsm_repair. */
static enum wf_status find_parent_rows(const struct wf_qsm *q, int32_t *parent, struct wf_arena *a,
                                       struct wf_err *e)
{
    struct wf_ids ids;
    enum wf_status s = wf_ids_begin(&ids, q->id, q->n, a, e);
    if (s) return s;
    for (size_t i = 0; i < q->n; i++) (void)wf_ids_enter(&ids, (int32_t)i);
    for (size_t i = 0; i < q->n; i++)
        parent[i] = q->parent_id[i] < 0 ? -1 : wf_ids_find(&ids, q->parent_id[i]);
    return WF_OK;
}

static enum wf_status place_hand_rows(struct wf_qsm *q, const struct hand_angles *hand, struct wf_arena *a,
                                      struct wf_err *e)
{
    struct hand_placing p = { .q = q, .hand = hand };
    struct wf_children c;
    int32_t *parent = WF_TAKE(a, q->n, int32_t), *queue = WF_TAKE(a, q->n, int32_t);
    if (!parent || !queue) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu rows", q->n);
    enum wf_status s = find_parent_rows(q, parent, a, e);
    if (!s) s = wf_children_of(parent, q->n, a, &c, e);
    if (s) return s;
    for (size_t i = 0; i < q->n; i++)
        if (!(q->length[i] > 0))
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: length: row %lld has no length, and no coordinates either",
                           q->file, q->line[i], (long long)q->id[i]);
    size_t n = 0;
    for (int32_t k = c.begin[q->n]; k < c.begin[q->n + 1]; k++) queue[n++] = c.child[k];
    for (size_t k = 0; k < n; k++) {
        int32_t i = queue[k];
        place_row(&p, (size_t)i, parent[i]);
        for (int32_t m = c.begin[i]; m < c.begin[i + 1]; m++) queue[n++] = c.child[m];
    }
    for (size_t i = 0; i < q->n && n < q->n; i++)
        if (isnan(q->x0[i]))
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: parent: row %lld is its own ancestor; without coordinates its "
                           "position is unknown",
                           q->file, q->line[i], (long long)q->id[i]);
    return WF_OK;
}

/* Tables with a header row: normalised, SimpleForest, aRchi, rTwig, plain segments, hand-measured. */

struct csv_field {
    enum wf_field field;
    size_t index;
    double factor;
};

struct csv_tree {
    struct wf_csv csv;
    struct csv_field column[WF_FIELD_COUNT];
    size_t columns;
    bool has[WF_FIELD_COUNT];
    bool placed; /* the file has coordinates */
    size_t tree; /* index of the column of trees; WF_CSV_NONE: there is none */
};

/* Formats are recognised by a column that only one program writes. */
static const struct {
    const char *column, *format;
} marks[] = {
    { "growthLength", "SimpleForest CSV" }, { "reverseBranchOrder", "SimpleForest CSV" },
    { "radius_cyl", "aRchi CSV" },          { "UnmodRadius", "rTwig CSV" },
    { "raw_radius", "rTwig CSV" },          { "radius0", "plain CSV of segments" },
    { "radius_m", "normalised CSV" },
};

static const char *table_format(const struct csv_tree *t)
{
    if (!t->placed) return "hand-measured table";
    for (size_t k = 0; k < WF_COUNT(marks); k++)
        if (wf_csv_column(&t->csv, marks[k].column) != WF_CSV_NONE) return marks[k].format;
    return "CSV of cylinders";
}

static enum wf_status map_columns(struct csv_tree *t, const struct wf_import_options *o, struct wf_err *e)
{
    struct wf_units *u;
    enum wf_status s = wf_units_open(&u, e);
    if (s) return s;
    double length_unit = isnan(o->length_unit) ? 1 : o->length_unit;
    double diameter_unit = isnan(o->diameter_unit) ? length_unit : o->diameter_unit;
    for (size_t k = 0; k < t->csv.columns; k++) {
        struct csv_field c = { .index = k };
        c.field = wf_field_of(u, t->csv.name[k].text, length_unit, diameter_unit, &c.factor, e);
        if (c.field == WF_FIELD_NONE || t->has[c.field]) continue;
        t->has[c.field] = true;
        if (c.field == WF_FIELD_TREE) {
            t->tree = k;
            continue;
        }
        t->column[t->columns++] = c;
    }
    wf_units_close(u);
    return e && e->code ? e->code : WF_OK;
}

static bool has_three(const struct csv_tree *t, enum wf_field first)
{
    return t->has[first] && t->has[first + 1] && t->has[first + 2];
}

/* Which columns needed for a tree the header lacks; NULL: none. Sets t->placed. */
static const char *header_lacks(struct csv_tree *t)
{
    bool start = has_three(t, WF_FIELD_X0), end = has_three(t, WF_FIELD_X1);
    bool axis = has_three(t, WF_FIELD_AX) && t->has[WF_FIELD_LENGTH];
    bool any = t->has[WF_FIELD_X0] || t->has[WF_FIELD_X1] || t->has[WF_FIELD_AX];
    bool radius = t->has[WF_FIELD_RADIUS] || t->has[WF_FIELD_R0] || t->has[WF_FIELD_R1];
    t->placed = start && (end || axis);
    if (!t->has[WF_FIELD_PARENT]) return "a parent column (parent, parentID, parent_ID)";
    if (!radius) return "a radius or diameter column (radius, radius_m, diameter_cm)";
    if (any && !start) return "the start point (start_x, start_y, start_z or x0, y0, z0)";
    if (any && !t->placed) return "the end point (end_x.. or x1..), or axis_x, axis_y, axis_z and length";
    if (!any && !t->has[WF_FIELD_LENGTH]) return "a length column, or start and end points";
    return NULL;
}

static enum wf_status refuse_header(const struct csv_tree *t, const char *what, struct wf_err *e)
{
    char names[512] = "";
    size_t n = 0;
    for (size_t k = 0; k < t->csv.columns && n + 64 < sizeof names; k++)
        n += (size_t)snprintf(names + n, sizeof names - n, "%s%.40s", k ? ", " : "", t->csv.name[k].text);
    return wf_fail(e, WF_EINPUT, "%s:%zu: error: no known tree format: the header lacks %s; it has: %s",
                   t->csv.file, t->csv.columns ? t->csv.name[0].line : 1, what, names);
}

/* Convert the current row to SI. Returned: false after a mistake was reported. */
static bool row_in_si(struct csv_tree *t, double *value)
{
    for (int f = 0; f < WF_FIELD_COUNT; f++) value[f] = (double)NAN;
    if (!t->has[WF_FIELD_ID]) value[WF_FIELD_ID] = (double)t->csv.row;
    for (size_t k = 0; k < t->columns; k++) {
        const struct csv_field *c = &t->column[k];
        double v;
        enum wf_csv_kind kind = wf_csv_value(&t->csv, c->index, &v);
        if (kind != WF_CSV_NUMBER) {
            const char *text = wf_csv_text(&t->csv, c->index);
            if (kind == WF_CSV_MISSING || wf_field_missing(text, strlen(text))) continue;
            if (!wf_csv_number(&t->csv, c->index, -INFINITY, INFINITY, &v)) return false;
        }
        value[c->field] = v * c->factor;
    }
    if (!t->placed || !isnan(value[WF_FIELD_X0])) return true;
    wf_csv_mistake(&t->csv, WF_CSV_NONE, "no start point");
    return false;
}

/* The trees of a table, by the text in its column of trees. */

enum { TREES_LISTED = 1000 }; /* more are not told apart */
struct table_trees {
    size_t n, last;
    struct table_tree {
        const char *id;
        size_t rows;
        double low[3]; /* lowest start in the units of the file; z NAN: the table has no coordinates */
    } tree[TREES_LISTED];
};

static double plain_number(const struct csv_tree *t, enum wf_field field)
{
    double v = (double)NAN;
    for (size_t k = 0; k < t->columns; k++) {
        const char *text = wf_csv_text(&t->csv, t->column[k].index);
        char point = t->csv.separator != ',' && strchr(text, ',') ? ',' : '.';
        if (t->column[k].field == field) (void)wf_number_read(text, text + strlen(text), point, &v);
    }
    return v;
}

/* Note the tree of the current row. Errors: WF_ENOMEM. */
static enum wf_status note_tree(const struct csv_tree *t, struct table_trees *list, struct wf_arena *a,
                                struct wf_err *e)
{
    const char *id = wf_csv_text(&t->csv, t->tree);
    size_t k = list->last;
    if (k >= list->n || strcmp(list->tree[k].id, id) != 0)
        for (k = 0; k < list->n && strcmp(list->tree[k].id, id) != 0; k++) {
        }
    if (k == TREES_LISTED) return WF_OK;
    struct table_tree *tree = &list->tree[list->last = k];
    if (k == list->n) {
        *tree = (struct table_tree){ .id = wf_arena_text(a, id), .low = { 0, 0, (double)NAN } };
        if (!tree->id) return wf_fail(e, WF_ENOMEM, "%s: no memory for a name", t->csv.file);
        list->n++;
    }
    double z = plain_number(t, WF_FIELD_Z0);
    tree->rows++;
    if (!isnan(z) && !(tree->low[2] <= z)) {
        tree->low[0] = plain_number(t, WF_FIELD_X0), tree->low[1] = plain_number(t, WF_FIELD_Y0);
        tree->low[2] = z;
    }
    return WF_OK;
}

/* Refuse a table of several trees of which none is chosen, and one without the tree that is chosen. */
static enum wf_status one_tree(const struct csv_tree *t, const struct table_trees *list, const char *chosen,
                               size_t taken, struct wf_err *e)
{
    char text[640] = "";
    if (chosen ? taken > 0 : list->n < 2) return WF_OK;
    for (size_t k = 0; k < list->n && k < 6; k++) {
        const struct table_tree *v = &list->tree[k];
        size_t n = strlen(text);
        (void)snprintf(text + n, sizeof text - n, "%s'%.24s' (%zu rows", k ? ", " : "", v->id, v->rows);
        n = strlen(text);
        if (isnan(v->low[2]))
            (void)snprintf(text + n, sizeof text - n, ")");
        else
            (void)snprintf(text + n, sizeof text - n, ", base at %.8g, %.8g, %.8g)", v->low[0], v->low[1],
                           v->low[2]);
    }
    const char *column = t->csv.name[t->tree].text, *more = list->n > 6 ? " and others" : "";
    if (chosen)
        return wf_fail(e, WF_EINPUT, "%s: error: --tree-id: no row has '%.40s' in column %.40s; it has %s%s",
                       t->csv.file, chosen, column, text, more);
    return wf_fail(e, WF_EINPUT,
                   "%s: error: column %.40s: %s%zu trees in one table: %s%s; choose one by --tree-id ID",
                   t->csv.file, column, list->n == TREES_LISTED ? "at least " : "", list->n, text, more);
}

static size_t lines_left(const struct wf_csv *c)
{
    size_t n = 1;
    for (const char *p = c->at; p < c->end && (p = memchr(p, '\n', (size_t)(c->end - p))); p++) n++;
    if (n == 1) /* line ends of old systems */
        for (const char *p = c->at; p < c->end; p++) n += *p == '\r';
    return n;
}

/* Pass the findings of the CSV reader on to the caller's list, one for each row, and count them. */
static void pass_findings_on(struct csv_tree *t, const struct wf_import_head *h, bool strict,
                             struct wf_qsm *q, struct wf_diag *d)
{
    size_t last = 0, listed = 0;
    for (const struct wf_finding *f = t->csv.diag->first; f && listed < WF_CSV_LISTED;
         f = f->next, listed++) {
        wf_import_bad_row(q, strict, f->line, f->column, f->text, d);
        last = f->line;
    }
    if (t->csv.mistakes > listed) wf_qsm_count(q, WF_REPAIR_BAD_ROW, t->csv.mistakes - listed, 0);
    if (last && h->ends_open && last == t->csv.row_line) wf_import_last_row_cut(q, last);
}

static enum wf_status take_hand_angles(struct hand_angles *hand, size_t n, struct wf_arena *a,
                                       struct wf_err *e)
{
    double **column[] = { &hand->angle, &hand->zenith, &hand->azimuth, &hand->distance, &hand->share };
    for (size_t k = 0; k < WF_COUNT(column); k++)
        if (!(*column[k] = WF_TAKE(a, n, double)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for %zu rows", n);
    return WF_OK;
}

/* Files without ids number their rows from 1; from 0 if a root's parent is written as -1. */
static void count_from_zero(struct wf_qsm *q, const struct csv_tree *t)
{
    bool minus = false;
    for (size_t i = 0; i < q->n && !t->has[WF_FIELD_ID]; i++) minus = minus || q->parent_id[i] == -1;
    for (size_t i = 0; i < q->n && minus; i++) q->id[i]--;
}

static enum wf_status read_table_rows(struct csv_tree *t, const struct wf_import_head *h,
                                      const struct wf_import_options *o, struct wf_arena *a, struct wf_qsm *q,
                                      struct wf_diag *d, struct wf_err *e)
{
    struct hand_angles hand;
    size_t room = lines_left(&t->csv), n = 0;
    enum wf_status s = wf_qsm_alloc(q, room, a, e);
    if (!s && !t->placed) s = take_hand_angles(&hand, room, a, e);
    if (s) return s;
    double v[WF_FIELD_COUNT];
    bool several = t->tree != WF_CSV_NONE;
    size_t taken = 0;
    struct table_trees *list = several ? WF_TAKE(a, 1, struct table_trees) : NULL;
    if (several && !list) return wf_fail(e, WF_ENOMEM, "%s: not enough memory", t->csv.file);
    while (wf_csv_next(&t->csv)) {
        if (several && (s = note_tree(t, list, a, e))) return s;
        if (several && o->tree_id && strcmp(wf_csv_text(&t->csv, t->tree), o->tree_id) != 0) continue;
        taken++;
        if (!row_in_si(t, v)) continue;
        const char *wrong = wf_field_cylinder(q, n, v);
        if (wrong) {
            wf_csv_mistake(&t->csv, WF_CSV_NONE, "%s", wrong);
            continue;
        }
        q->line[n] = t->csv.row_line;
        if (!t->placed) {
            hand.angle[n] = v[WF_FIELD_ANGLE], hand.zenith[n] = v[WF_FIELD_ZENITH];
            hand.azimuth[n] = v[WF_FIELD_AZIMUTH], hand.distance[n] = v[WF_FIELD_DISTANCE];
            hand.share[n] = v[WF_FIELD_SHARE];
        }
        n++;
    }
    q->n = n;
    if (several && (s = one_tree(t, list, o->tree_id, taken, e))) return s;
    if (several && o->tree_id) q->trees = list->n;
    count_from_zero(q, t);
    if (t->csv.point == ',') wf_qsm_count(q, WF_NOTE_DECIMAL_COMMA, 1, -1);
    pass_findings_on(t, h, o->strict, q, d);
    return t->placed || !n ? WF_OK : place_hand_rows(q, &hand, a, e);
}

enum wf_status wf_import_table(const struct wf_import_head *h, const struct wf_import_options *o,
                               struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct wf_diag own = { .arena = a };
    struct csv_tree t = { .tree = WF_CSV_NONE };
    enum wf_status s = wf_csv_open(&t.csv, h->path, a, &own, e);
    if (s) {
        for (const struct wf_finding *f = own.first; f; f = f->next)
            if (f->severity == WF_ERROR) wf_diag_error(d, f->file, f->line, f->column, "%s", f->text);
        return s;
    }
    own = (struct wf_diag){ .arena = a }; /* warnings about the encoding are given by wf_import_read */
    if ((s = map_columns(&t, o, e))) return s;
    const char *what = header_lacks(&t);
    if (what) return refuse_header(&t, what, e);
    if (o->tree_id && t.tree == WF_CSV_NONE)
        return wf_fail(e, WF_EINPUT, "%s: error: --tree-id: the table has no column treeID", h->path);
    q->format = table_format(&t);
    size_t blanks = 0;
    for (const char *p = h->text; *p && *p != '\n'; p++)
        blanks += *p == ' ' && (p == h->text || p[-1] == ',');
    wf_qsm_count(q, WF_NOTE_HEADER, blanks, -1);
    return read_table_rows(&t, h, o, a, q, d, e);
}

/* TreeQSM text: columns of numbers separated by tabs or blanks; each line is a cylinder, its id the line's
 * number. Layouts. 14: the CylData matrix of early TreeQSM. 15: two orders are in use, told apart by which
 * column holds the unmodified radius (the only one of the last four that is not whole): the text TreeQSM 2.3
 * writes (branch, order, position, added, unmodified radius) and that of aRchi's samples (added, unmodified
 * radius, branch, order, position). 17 with a header: TreeQSM 2.4 (Raumonen et al. 2013, Remote Sens.
 * 5:491-520; save_model_text 1.1.0). */

enum { WIDEST = 64 };

#define GEOMETRY                                                                                             \
    WF_FIELD_RADIUS, WF_FIELD_LENGTH, WF_FIELD_X0, WF_FIELD_Y0, WF_FIELD_Z0, WF_FIELD_AX, WF_FIELD_AY,       \
        WF_FIELD_AZ, WF_FIELD_PARENT, WF_FIELD_NEXT
#define NONE WF_FIELD_NONE
static const struct layout {
    size_t columns;
    enum wf_field field[17];
} layouts[] = {
    { 14, { GEOMETRY, NONE, WF_FIELD_ORDER, NONE, WF_FIELD_ADDED } },
    { 15, { GEOMETRY, NONE, WF_FIELD_ORDER, NONE, WF_FIELD_ADDED, NONE } },
    { 15, { GEOMETRY, WF_FIELD_ADDED, NONE, NONE, WF_FIELD_ORDER, NONE } },
    { 17, { GEOMETRY, NONE, WF_FIELD_ORDER, NONE, NONE, NONE, WF_FIELD_ADDED, NONE } },
};
#undef GEOMETRY
#undef NONE
enum { LAYOUTS = WF_COUNT(layouts), ARCHI = 2, UNMODIFIED = 11 };

struct lines {
    const char *at, *end;
    size_t line;
    char point;
};

static bool is_gap(char c, char point)
{
    return c == ' ' || c == '\t' || c == '\r' || c == ';' || (c == ',' && point != ',');
}

/* Does a line start with '#' that is not the mark of a missing value, as in #N/A, #NV, #DIV/0!, #NAME? */
static bool is_comment(const char *p, const char *stop, char point)
{
    const char *end = p;
    if (*p != '#') return false;
    while (end < stop && !is_gap(*end, point)) end++;
    return !wf_csv_sheet_error(p, (size_t)(end - p));
}

/* Read the numbers of the next line that is not blank or a comment. Returned: how many; 0 at the end of the
 * file. *whole is false when the line contains something that is not a number. */
static size_t next_numbers(struct lines *t, double *value, bool *whole)
{
    while (t->at < t->end) {
        const char *stop = memchr(t->at, '\n', (size_t)(t->end - t->at)), *p = t->at;
        if (!stop) stop = t->end;
        t->at = stop < t->end ? stop + 1 : stop;
        t->line++;
        size_t n = 0;
        *whole = true;
        while (p < stop && is_gap(*p, t->point)) p++;
        if (p == stop || is_comment(p, stop, t->point)) continue;
        while (p < stop && n < WIDEST) {
            const char *after = wf_number_read(p, stop, t->point, &value[n]);
            size_t word = 0;
            while (!after && p + word < stop && !is_gap(p[word], t->point)) word++;
            if (word && wf_field_missing(p, word)) value[n] = (double)NAN, after = p + word;
            if (!after || (after < stop && !is_gap(*after, t->point))) {
                *whole = false;
                return n ? n : 1;
            }
            n++;
            for (p = after; p < stop && is_gap(*p, t->point);) p++;
        }
        return n;
    }
    return 0;
}

/* A comma is the decimal sign if the first line separates its numbers by tabs or semicolons and has no point.
 */
static char decimal_sign_of(const char *text, size_t size)
{
    const char *stop = memchr(text, '\n', size);
    size_t n = stop ? (size_t)(stop - text) : size;
    bool blanks = memchr(text, '\t', n) || memchr(text, ';', n);
    return blanks && memchr(text, ',', n) && !memchr(text, '.', n) ? ',' : '.';
}

static const char *first_line(const struct wf_import_head *h)
{
    const char *p = h->text;
    if (!strncmp(p, "\xEF\xBB\xBF", 3)) p += 3;
    while (*p == '\n' || *p == '\r' || *p == ' ' || *p == '\t' || *p == '#') {
        if (*p == '#') p += strcspn(p, "\n");
        if (*p) p++;
    }
    return p;
}

static bool has_header(const char *line)
{
    return !strncmp(line, "radius", 6) && strstr(line, "start_point");
}

bool wf_import_is_bare(const struct wf_import_head *h)
{
    const char *p = first_line(h);
    double v;
    return has_header(p) || wf_number_read(p, p + strlen(p), '.', &v);
}

/* The layout of a file: by the number of columns of its first row; for the two layouts of 15 columns, by
 * which column has numbers that are not whole. NULL: none. */
static const struct layout *layout_of(struct lines t)
{
    double v[WIDEST];
    bool whole, last_is_radius = false;
    size_t columns = next_numbers(&t, v, &whole);
    while (columns == 15 && !last_is_radius) {
        if (whole && v[UNMODIFIED] != floor(v[UNMODIFIED])) break;
        last_is_radius = whole && v[14] != floor(v[14]);
        if (!next_numbers(&t, v, &whole)) break;
    }
    for (size_t k = 0; k < LAYOUTS; k++)
        if (layouts[k].columns == columns)
            return columns == 15 && !last_is_radius ? &layouts[ARCHI] : &layouts[k];
    return NULL;
}

static enum wf_status read_bare_rows(struct lines *t, const struct layout *layout, bool ends_open,
                                     bool strict, struct wf_qsm *q, struct wf_diag *d)
{
    double number[WIDEST], value[WF_FIELD_COUNT + 1];
    bool whole;
    size_t n = 0, row = 0, bad = 0;
    for (size_t m; (m = next_numbers(t, number, &whole));) {
        char text[128];
        const char *wrong = NULL;
        for (int f = 0; f <= WF_FIELD_COUNT; f++) value[f] = (double)NAN;
        for (size_t k = 0; k < layout->columns && k < m; k++) value[layout->field[k]] = number[k];
        value[WF_FIELD_ID] = (double)++row;
        if (!whole || m != layout->columns) {
            (void)snprintf(text, sizeof text,
                           whole ? "%zu numbers, the first row has %zu" : "cell %zu is not a number",
                           whole ? m : m + 1, layout->columns);
            wrong = text;
        } else if (isnan(value[WF_FIELD_X0])) {
            wrong = "no start point";
        } else {
            wrong = wf_field_cylinder(q, n, value);
        }
        q->line[n] = t->line;
        if (wrong)
            wf_import_bad_row(q, strict, bad = t->line, 0, wrong, d);
        else
            n++;
    }
    q->n = n;
    if (bad && bad == t->line && ends_open) wf_import_last_row_cut(q, bad);
    return WF_OK;
}

enum wf_status wf_import_bare(const struct wf_import_head *h, const struct wf_import_options *o,
                              struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct wf_bytes b;
    enum wf_status s = wf_file_read_table(h->path, a, &b, d, e);
    if (s) return s;
    struct lines t = { .at = b.data, .end = b.data + b.size };
    if (has_header(first_line(h))) {
        const char *after = memchr(t.at, '\n', b.size);
        t.at = after ? after + 1 : t.end;
        t.line = 1;
    }
    t.point = decimal_sign_of(t.at, (size_t)(t.end - t.at));
    if (t.point == ',') wf_qsm_count(q, WF_NOTE_DECIMAL_COMMA, 1, -1);
    const struct layout *layout = layout_of(t);
    if (!layout)
        return wf_fail(e, WF_EINPUT, "%s: error: no header and not TreeQSM's 14, 15 or 17 columns of numbers",
                       h->path);
    size_t room = 1;
    for (const char *p = t.at; p < t.end; p++) room += *p == '\n';
    q->format = "TreeQSM text";
    if ((s = wf_qsm_alloc(q, room, a, e))) return s;
    return read_bare_rows(&t, layout, h->ends_open, o->strict, q, d);
}
