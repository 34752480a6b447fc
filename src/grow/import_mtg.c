/* OpenAlea multi-scale tree graphs: each entity of the finest scale is a segment that ends at its
 * coordinates. It starts at the end of the entity it follows or branches from; the first of an axis starts at
 * the coordinates of the axis, when the file gives these. Lengths are centimetres unless told otherwise. */
#include "grow/import_mtg.h"
#include "base/file.h"
#include <math.h>
#include <string.h>

/* Diameters have no stated unit: centimetres if the trunk then is slenderer than 5, else millimetres. */
static double diameter_unit(struct wf_qsm *q, const struct wf_mtg *g, double length_unit)
{
    double low = INFINITY, high = -INFINITY, thick = 0;
    for (size_t i = 0; i < g->n; i++) {
        const struct wf_mtg_entity *v = &g->entity[i];
        if (v->point[2] < low) low = v->point[2];
        if (v->point[2] > high) high = v->point[2];
        if (v->diameter > thick) thick = v->diameter;
    }
    wf_qsm_count(q, WF_NOTE_UNITS, 1, -1);
    return (high - low) * length_unit > 5 * 0.01 * thick ? 0.01 : 0.001;
}

/* Row of the finest entities: ends, radii, links. row[] gives the row of each entity, -1 for a coarser one.
 */
static void segment(struct wf_qsm *q, const struct wf_mtg *g, const int32_t *row, size_t v, double unit,
                    double thick)
{
    const struct wf_mtg_entity *s = &g->entity[v], *c = s->complex >= 0 ? &g->entity[s->complex] : NULL;
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

static enum wf_status to_rows(struct wf_qsm *q, const struct wf_mtg *g, const struct wf_import_options *o,
                              struct wf_arena *a, struct wf_err *e)
{
    size_t n = 0;
    int32_t *row = WF_TAKE(a, g->n, int32_t);
    if (!row) return wf_fail(e, WF_ENOMEM, "no room for %zu entities", g->n);
    for (size_t v = 0; v < g->n; v++) row[v] = g->entity[v].scale == g->finest ? (int32_t)n++ : -1;
    enum wf_status s = wf_qsm_alloc(q, n, a, e);
    if (s) return s;
    double unit = isnan(o->length_unit) ? 0.01 : o->length_unit;
    double thick = isnan(o->diameter_unit) ? diameter_unit(q, g, unit) : o->diameter_unit;
    size_t missing = 0;
    for (size_t v = 0; v < g->n; v++) {
        if (row[v] < 0) continue;
        segment(q, g, row, v, unit, thick);
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
    enum wf_status s = wf_file_read_text(h->path, a, &b, e);
    if (s) return s;
    struct wf_mtg *g = WF_TAKE(a, 1, struct wf_mtg);
    if (!g) return wf_fail(e, WF_ENOMEM, "%s: no memory", h->path);
    for (int k = 0; k < WF_MTG_COLUMNS; k++) g->last[k] = -1;
    const char *at = b.data, *end = b.data + b.size;
    size_t line = 0, bad = 0;
    if ((s = wf_mtg_head(g, h->path, &at, &line, e))) return s;
    for (const char *p = at; p < end; p++) g->room += *p == '/' || *p == '<' || *p == '+';
    g->entity = WF_TAKE(a, g->room, struct wf_mtg_entity);
    if (!g->entity) return wf_fail(e, WF_ENOMEM, "%s: no room for %zu entities", h->path, g->room);
    while (at < end) {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        if (!stop) stop = end;
        const char *wrong = wf_mtg_line(g, at, stop, ++line);
        if (wrong) wf_import_bad_row(q, o->strict, bad = line, 0, wrong, d);
        at = stop < end ? stop + 1 : stop;
    }
    if (bad && bad == line && h->ends_open) {
        q->repairs.count[WF_REPAIR_BAD_ROW]--;
        wf_qsm_count(q, WF_REPAIR_TRUNCATED, 1, (int64_t)bad);
    }
    q->format = "OpenAlea MTG";
    return to_rows(q, g, o, a, e);
}
