/* TreeQSM text: columns of numbers between tabs or blanks, one cylinder a line, ids by line.
 * Layouts. 14: the CylData matrix of early TreeQSM. 15: two orders are in use, told apart by which column
 * holds the unmodified radius (the only one of the last four that is not whole): the text TreeQSM 2.3 writes
 * (branch, order, position, added, unmodified radius) and that of aRchi's samples (added, unmodified radius,
 * branch, order, position). 17 with a header: TreeQSM 2.4 (Raumonen et al. 2013, Remote Sens. 5:491-520;
 * save_model_text 1.1.0). */
#include "base/file.h"
#include "base/number.h"
#include "grow/import_field.h"
#include "grow/import_readers.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

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
enum { LAYOUTS = sizeof layouts / sizeof *layouts, ARCHI = 2, UNMODIFIED = 11 };

struct lines {
    const char *at, *end;
    size_t line;
    char point;
};

static bool between(char c, char point)
{
    return c == ' ' || c == '\t' || c == '\r' || c == ';' || (c == ',' && point != ',');
}

/* Numbers of the next line that holds any. Returned: how many, 0 at the end of the file; *whole is false when
 * the line holds something else. */
static size_t next_line(struct lines *t, double *value, bool *whole)
{
    while (t->at < t->end) {
        const char *stop = memchr(t->at, '\n', (size_t)(t->end - t->at)), *p = t->at;
        if (!stop) stop = t->end;
        t->at = stop < t->end ? stop + 1 : stop;
        t->line++;
        size_t n = 0;
        *whole = true;
        while (p < stop && between(*p, t->point)) p++;
        if (p == stop || *p == '#') continue;
        while (p < stop && n < WIDEST) {
            const char *after = wf_number_read(p, stop, t->point, &value[n]);
            if (!after && stop - p >= 3 && !strncmp(p, "NaN", 3)) value[n] = (double)NAN, after = p + 3;
            if (!after || (after < stop && !between(*after, t->point))) {
                *whole = false;
                return n ? n : 1;
            }
            n++;
            for (p = after; p < stop && between(*p, t->point);) p++;
        }
        return n;
    }
    return 0;
}

/* A comma is a decimal sign where blanks or tabs part the numbers and no point is met. */
static char decimal_sign(const char *text, size_t size)
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

/* The layout of the file by the width of its first row; of the two with 15 columns, by where fractions stand.
 */
static const struct layout *layout_of(struct lines t)
{
    double v[WIDEST];
    bool whole, last_is_radius = false;
    size_t columns = next_line(&t, v, &whole);
    while (columns == 15 && !last_is_radius) {
        if (whole && v[UNMODIFIED] != floor(v[UNMODIFIED])) break;
        last_is_radius = whole && v[14] != floor(v[14]);
        if (!next_line(&t, v, &whole)) break;
    }
    for (size_t k = 0; k < LAYOUTS; k++)
        if (layouts[k].columns == columns)
            return columns == 15 && !last_is_radius ? &layouts[ARCHI] : &layouts[k];
    return NULL;
}

static enum wf_status rows(struct lines *t, const struct layout *layout, bool ends_open, bool strict,
                           struct wf_qsm *q, struct wf_diag *d)
{
    double number[WIDEST], value[WF_FIELD_COUNT + 1];
    bool whole;
    size_t n = 0, row = 0, bad = 0;
    for (size_t m; (m = next_line(t, number, &whole));) {
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
    if (bad && bad == t->line && ends_open) {
        q->repairs.count[WF_REPAIR_BAD_ROW]--;
        wf_qsm_count(q, WF_REPAIR_TRUNCATED, 1, (int64_t)bad);
    }
    return WF_OK;
}

enum wf_status wf_import_bare(const struct wf_import_head *h, const struct wf_import_options *o,
                              struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct wf_bytes b;
    enum wf_status s = wf_file_read_text(h->path, a, &b, e);
    if (s) return s;
    struct lines t = { .at = b.data, .end = b.data + b.size };
    if (has_header(first_line(h))) {
        const char *after = memchr(t.at, '\n', b.size);
        t.at = after ? after + 1 : t.end;
        t.line = 1;
    }
    t.point = decimal_sign(t.at, (size_t)(t.end - t.at));
    if (t.point == ',') wf_qsm_count(q, WF_NOTE_DECIMAL_COMMA, 1, -1);
    const struct layout *layout = layout_of(t);
    if (!layout)
        return wf_fail(e, WF_EINPUT, "%s: error: no header and not TreeQSM's 14, 15 or 17 columns of numbers",
                       h->path);
    size_t room = 1;
    for (const char *p = t.at; p < t.end; p++) room += *p == '\n';
    q->format = "TreeQSM text";
    if ((s = wf_qsm_alloc(q, room, a, e))) return s;
    return rows(&t, layout, h->ends_open, o->strict, q, d);
}
