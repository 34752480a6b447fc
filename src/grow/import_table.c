/* Tables with a header row: normalised, SimpleForest, aRchi, rTwig, plain segments, hand-measured. */
#include "base/csv.h"
#include "grow/import_field.h"
#include "grow/import_readers.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

struct column {
    enum wf_field field;
    size_t index;
    double factor;
};

struct table {
    struct wf_csv csv;
    struct column column[WF_FIELD_COUNT];
    size_t columns;
    bool has[WF_FIELD_COUNT];
    bool placed; /* the file has coordinates */
};

/* A format is told by a column that only its program writes. */
static const struct {
    const char *column, *format;
} marks[] = {
    { "growthLength", "SimpleForest CSV" }, { "reverseBranchOrder", "SimpleForest CSV" },
    { "radius_cyl", "aRchi CSV" },          { "UnmodRadius", "rTwig CSV" },
    { "raw_radius", "rTwig CSV" },          { "radius0", "plain CSV of segments" },
    { "radius_m", "normalised CSV" },
};

static const char *title(const struct table *t)
{
    if (!t->placed) return "hand-measured table";
    for (size_t k = 0; k < sizeof marks / sizeof *marks; k++)
        if (wf_csv_column(&t->csv, marks[k].column) != WF_CSV_NONE) return marks[k].format;
    return "CSV of cylinders";
}

static void map_columns(struct table *t, const struct wf_import_options *o)
{
    double length_unit = isnan(o->length_unit) ? 1 : o->length_unit;
    double diameter_unit = isnan(o->diameter_unit) ? length_unit : o->diameter_unit;
    for (size_t k = 0; k < t->csv.columns; k++) {
        struct column c = { .index = k };
        c.field = wf_field_of(t->csv.name[k].text, length_unit, diameter_unit, &c.factor);
        if (c.field == WF_FIELD_NONE || t->has[c.field]) continue;
        t->has[c.field] = true;
        t->column[t->columns++] = c;
    }
}

static bool three(const struct table *t, enum wf_field first)
{
    return t->has[first] && t->has[first + 1] && t->has[first + 2];
}

/* What the header lacks for a tree, NULL when nothing. */
static const char *lacking(struct table *t)
{
    bool start = three(t, WF_FIELD_X0), end = three(t, WF_FIELD_X1);
    bool axis = three(t, WF_FIELD_AX) && t->has[WF_FIELD_LENGTH];
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

static enum wf_status refuse_header(const struct table *t, const char *what, struct wf_err *e)
{
    char names[512] = "";
    size_t n = 0;
    for (size_t k = 0; k < t->csv.columns && n + 64 < sizeof names; k++)
        n += (size_t)snprintf(names + n, sizeof names - n, "%s%.40s", k ? ", " : "", t->csv.name[k].text);
    return wf_fail(e, WF_EINPUT, "%s:%zu: error: no known tree format: the header lacks %s; it has: %s",
                   t->csv.file, t->csv.columns ? t->csv.name[0].line : 1, what, names);
}

static bool blank(const char *s)
{
    return !*s || !strcmp(s, "NA") || !strcmp(s, "NaN") || !strcmp(s, "nan") || !strcmp(s, "NULL");
}

/* The row in hand in SI. false after a finding. */
static bool take_row(struct table *t, double *value)
{
    for (int f = 0; f < WF_FIELD_COUNT; f++) value[f] = (double)NAN;
    if (!t->has[WF_FIELD_ID]) value[WF_FIELD_ID] = (double)t->csv.row;
    for (size_t k = 0; k < t->columns; k++) {
        const struct column *c = &t->column[k];
        if (blank(wf_csv_text(&t->csv, c->index))) continue;
        double v;
        if (!wf_csv_number(&t->csv, c->index, -INFINITY, INFINITY, &v)) return false;
        value[c->field] = v * c->factor;
    }
    if (!t->placed || !isnan(value[WF_FIELD_X0])) return true;
    wf_csv_mistake(&t->csv, WF_CSV_NONE, "no start point");
    return false;
}

static size_t lines_left(const struct wf_csv *c)
{
    size_t n = 1;
    for (const char *p = c->at; p < c->end && (p = memchr(p, '\n', (size_t)(c->end - p))); p++) n++;
    if (n == 1) /* line ends of old systems */
        for (const char *p = c->at; p < c->end; p++) n += *p == '\r';
    return n;
}

/* What the CSV reader found goes to the caller's list, one line a row. */
static void hand_on(struct table *t, const struct wf_import_head *h, bool strict, struct wf_qsm *q,
                    struct wf_diag *d)
{
    size_t last = 0, listed = 0;
    for (const struct wf_finding *f = t->csv.diag->first; f && listed < WF_CSV_LISTED;
         f = f->next, listed++) {
        wf_import_bad_row(q, strict, f->line, f->column, f->text, d);
        last = f->line;
    }
    if (t->csv.mistakes > listed) wf_qsm_count(q, WF_REPAIR_BAD_ROW, t->csv.mistakes - listed, 0);
    if (last && h->ends_open && last == t->csv.row_line) {
        q->repairs.count[WF_REPAIR_BAD_ROW]--;
        wf_qsm_count(q, WF_REPAIR_TRUNCATED, 1, (int64_t)last);
    }
}

static enum wf_status hand_columns(struct wf_hand *hand, size_t n, struct wf_arena *a, struct wf_err *e)
{
    double **column[] = { &hand->angle, &hand->zenith, &hand->azimuth, &hand->distance, &hand->share };
    for (size_t k = 0; k < sizeof column / sizeof *column; k++)
        if (!(*column[k] = WF_TAKE(a, n, double))) return wf_fail(e, WF_ENOMEM, "no room for %zu rows", n);
    return WF_OK;
}

/* Without ids rows are counted from 1, unless a parent of -1 shows that this file counts from 0. */
static void count_from_zero(struct wf_qsm *q, const struct table *t)
{
    bool minus = false;
    for (size_t i = 0; i < q->n && !t->has[WF_FIELD_ID]; i++) minus = minus || q->parent_id[i] == -1;
    for (size_t i = 0; i < q->n && minus; i++) q->id[i]--;
}

static enum wf_status rows(struct table *t, const struct wf_import_head *h, const struct wf_import_options *o,
                           struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct wf_hand hand;
    size_t room = lines_left(&t->csv), n = 0;
    enum wf_status s = wf_qsm_alloc(q, room, a, e);
    if (!s && !t->placed) s = hand_columns(&hand, room, a, e);
    if (s) return s;
    double v[WF_FIELD_COUNT];
    while (wf_csv_next(&t->csv)) {
        if (!take_row(t, v)) continue;
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
    count_from_zero(q, t);
    if (t->csv.point == ',') wf_qsm_count(q, WF_NOTE_DECIMAL_COMMA, 1, -1);
    hand_on(t, h, o->strict, q, d);
    return t->placed || !n ? WF_OK : wf_import_place(q, &hand, a, e);
}

enum wf_status wf_import_table(const struct wf_import_head *h, const struct wf_import_options *o,
                               struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct wf_diag own = { .arena = a };
    struct table t = { 0 };
    enum wf_status s = wf_csv_open(&t.csv, h->path, a, &own, e);
    if (s) {
        for (const struct wf_finding *f = own.first; f; f = f->next)
            wf_diag_error(d, f->file, f->line, f->column, "%s", f->text);
        return s;
    }
    map_columns(&t, o);
    const char *what = lacking(&t);
    if (what) return refuse_header(&t, what, e);
    q->format = title(&t);
    size_t blanks = 0;
    for (const char *p = h->text; *p && *p != '\n'; p++)
        blanks += *p == ' ' && (p == h->text || p[-1] == ',');
    wf_qsm_count(q, WF_NOTE_HEADER, blanks, -1);
    return rows(&t, h, o, a, q, d, e);
}
