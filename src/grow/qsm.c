/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/qsm.h"
#include "base/num.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Rows by id, and the children of a row. */

static size_t hash_slot(const struct wf_ids *x, int64_t id)
{
    /* multiplicative hashing, Knuth 1998 (TAOCP 3, 6.4): the golden ratio spreads consecutive ids */
    return (size_t)(((uint64_t)id * UINT64_C(0x9E3779B97F4A7C15)) >> 20) & (x->slots - 1);
}

enum wf_status wf_ids_begin(struct wf_ids *x, const int64_t *id, size_t n, struct wf_arena *a,
                            struct wf_err *e)
{
    x->id = id;
    for (x->slots = 16; x->slots < 2 * n; x->slots *= 2) {
    }
    x->row = WF_TAKE(a, x->slots, int32_t);
    if (!x->row) return wf_fail(e, WF_ENOMEM, "not enough memory for the index of %zu ids", n);
    for (size_t k = 0; k < x->slots; k++) x->row[k] = -1;
    return WF_OK;
}

int32_t wf_ids_enter(struct wf_ids *x, int32_t i)
{
    size_t k = hash_slot(x, x->id[i]);
    for (; x->row[k] >= 0; k = (k + 1) & (x->slots - 1))
        if (x->id[x->row[k]] == x->id[i]) return x->row[k];
    x->row[k] = i;
    return i;
}

int32_t wf_ids_find(const struct wf_ids *x, int64_t id)
{
    for (size_t k = hash_slot(x, id); x->row[k] >= 0; k = (k + 1) & (x->slots - 1))
        if (x->id[x->row[k]] == id) return x->row[k];
    return -1;
}

enum wf_status wf_children_of(const int32_t *parent, size_t n, struct wf_arena *a, struct wf_children *out,
                              struct wf_err *e)
{
    int32_t *begin = WF_TAKE(a, n + 2, int32_t), *child = WF_TAKE(a, n, int32_t);
    int32_t *at = WF_TAKE(a, n + 1, int32_t);
    if (!begin || !child || !at)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the branching of %zu rows", n);
    for (size_t i = 0; i < n; i++) begin[(parent[i] < 0 ? n : (size_t)parent[i]) + 1]++;
    for (size_t i = 0; i <= n; i++) {
        begin[i + 1] += begin[i];
        at[i] = begin[i];
    }
    for (size_t i = 0; i < n; i++) child[at[parent[i] < 0 ? n : (size_t)parent[i]]++] = (int32_t)i;
    *out = (struct wf_children){ begin, child };
    return WF_OK;
}

/* The table: its columns, and what is counted while it is read and repaired. */

const struct wf_repair_row wf_repair_rows[WF_REPAIR_COUNT] = {
    [WF_NOTE_BOM] = { "byte-order-mark", "byte order mark skipped", true, true },
    [WF_NOTE_CRLF] = { "windows-line-ends", "Windows line ends", true, true },
    [WF_NOTE_DECIMAL_COMMA] = { "decimal-comma", "decimal commas", true, true },
    [WF_NOTE_HEADER] = { "column-names", "column names with blanks around them", true, false },
    [WF_NOTE_ROOT_MARK] = { "root-mark", "roots marked by a parent of -1 or an empty cell", true, false },
    [WF_NOTE_FROM_ZERO] = { "ids-from-zero", "rows are numbered from 0", true, true },
    [WF_NOTE_ORDER_FROM] = { "order-shifted", "branch orders not counted from 0 at the stem: shifted", true,
                             true },
    [WF_NOTE_ORDER_MADE] = { "order-made", "branch orders that the file lacks: computed from the parents",
                             true, false },
    [WF_NOTE_SORTED] = { "rows-sorted", "rows before their parent: reordered", true, false },
    [WF_NOTE_OFFSET] = { "offset-removed", "coordinate offset: the base of the stem moved to the origin",
                         true, true },
    [WF_NOTE_STEMS] = { "several-stems", "further stems from the ground", true, false },
    [WF_NOTE_THICKENING] = { "thickening",
                             "rows thicker by more than a tenth than the row below in their branch", true,
                             false },
    [WF_NOTE_UNITS] = { "unit-inferred",
                        "the file does not state its unit of diameters: taken from the sizes", true, true },
    [WF_NOTE_MODELS] = { "further-models", "further tree models in the file ignored", true, false },
    [WF_NOTE_APART] = { "stems-apart", "further stems that stand metres from the main one", true, false },
    [WF_NOTE_THICK_CHILD] = { "thick-child", "branches thicker by more than a tenth than what they grow on",
                              true, false },
    [WF_REPAIR_BAD_ROW] = { "bad-row", "rows that cannot be read: left out", false, false },
    [WF_REPAIR_TRUNCATED] = { "truncated", "the last row is cut off: left out", false, true },
    [WF_REPAIR_AXIS] = { "axis-not-unit", "axis vectors not of unit length: normalised", false, false },
    [WF_REPAIR_LENGTH] = { "length-differs",
                           "stated lengths that are not the distance from start to end: distance used", false,
                           false },
    [WF_REPAIR_ZERO_LENGTH] = { "zero-length",
                                "rows without length: removed, their children joined to their parent", false,
                                false },
    [WF_REPAIR_RADIUS] = { "radius-filled", "radii missing or not positive: taken from the neighbouring row",
                           false, false },
    [WF_REPAIR_SAME_ROW] = { "same-row-twice", "rows that repeat an earlier row: removed", false, false },
    [WF_REPAIR_SAME_ID] = { "same-id-twice", "different rows with the id of an earlier row: given a new id",
                            false, false },
    [WF_REPAIR_NO_PARENT] = { "parent-missing", "rows whose parent is not in the file", false, false },
    [WF_REPAIR_CYCLE] = { "cycle", "cycles of parents: cut at the lowest row", false, false },
    [WF_REPAIR_LOOSE] = { "loose-part", "parts not connected to the ground: joined to the nearest axis",
                          false, false },
    [WF_REPAIR_ROOT_ORDER] = { "root-order", "stems with a branch's order in the file: order 0 taken", false,
                               false },
    [WF_REPAIR_CAPPED] = { "children-capped", "rows thinned to the thickness of what they grow on", false,
                           false },
    [WF_REPAIR_AZIMUTH] = { "azimuth-assumed",
                            "azimuths not measured: each 137.5 degrees after the one before", false, false },
};

/* All columns with their element sizes, used for allocation and reordering. */
#define COLUMN(name)                                                                                         \
    {                                                                                                        \
        offsetof(struct wf_qsm, name), sizeof *((struct wf_qsm *)0)->name                                    \
    }
static const struct {
    size_t offset, size;
} columns[] = {
    COLUMN(id),    COLUMN(parent_id), COLUMN(parent), COLUMN(order), COLUMN(branch),
    COLUMN(place), COLUMN(next_id),   COLUMN(next),   COLUMN(x0),    COLUMN(y0),
    COLUMN(z0),    COLUMN(x1),        COLUMN(y1),     COLUMN(z1),    COLUMN(r0),
    COLUMN(r1),    COLUMN(length),    COLUMN(added),  COLUMN(line),
};
#undef COLUMN
enum { COLUMNS = WF_COUNT(columns) };

static void *column_get(const struct wf_qsm *q, size_t c)
{
    void *p;
    memcpy(&p, (const char *)q + columns[c].offset, sizeof p);
    return p;
}

static void column_set(struct wf_qsm *q, size_t c, void *p)
{
    memcpy((char *)q + columns[c].offset, &p, sizeof p);
}

enum wf_status wf_qsm_alloc(struct wf_qsm *q, size_t n, struct wf_arena *a, struct wf_err *e)
{
    if (n > INT32_MAX) return wf_fail(e, WF_EINPUT, "%zu cylinders; at most %d are handled", n, INT32_MAX);
    q->n = n;
    for (size_t c = 0; c < COLUMNS; c++) {
        void *p = wf_arena_take(a, n, columns[c].size);
        if (!p) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", n);
        column_set(q, c, p);
    }
    for (size_t i = 0; i < n; i++) {
        q->parent[i] = q->next[i] = q->order[i] = -1;
        q->r0[i] = q->r1[i] = q->length[i] = (double)NAN;
    }
    return WF_OK;
}

void wf_qsm_count(struct wf_qsm *q, enum wf_repair what, size_t how_many, int64_t where)
{
    if (how_many && !q->repairs.count[what]) q->repairs.first[what] = where;
    q->repairs.count[what] += how_many;
}

enum wf_status wf_qsm_pick(struct wf_qsm *q, const int32_t *pick, size_t n, struct wf_arena *a,
                           struct wf_err *e)
{
    struct wf_qsm out = *q;
    int32_t *where = WF_TAKE(a, q->n, int32_t);
    if (!where) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu cylinders", n);
    for (size_t i = 0; i < q->n; i++) where[i] = -1;
    for (size_t i = 0; i < n; i++) where[pick[i]] = (int32_t)i;
    enum wf_status s = wf_qsm_alloc(&out, n, a, e);
    if (s) return s;
    for (size_t c = 0; c < COLUMNS; c++) {
        const char *from = column_get(q, c);
        char *to = column_get(&out, c);
        size_t size = columns[c].size;
        for (size_t i = 0; i < n; i++) memcpy(to + i * size, from + (size_t)pick[i] * size, size);
    }
    for (size_t i = 0; i < n; i++) {
        if (out.parent[i] >= 0) out.parent[i] = where[out.parent[i]];
        if (out.next[i] >= 0) out.next[i] = where[out.next[i]];
    }
    *q = out;
    return WF_OK;
}

void wf_qsm_report(const struct wf_qsm *q, struct wf_diag *d)
{
    for (int k = 0; k < WF_REPAIR_COUNT; k++) {
        const struct wf_repair_row *row = &wf_repair_rows[k];
        if (!q->repairs.count[k]) continue;
        bool by_line = k == WF_REPAIR_BAD_ROW || k == WF_REPAIR_TRUNCATED;
        char count[32] = "", first[48] = "";
        if (!row->once) (void)snprintf(count, sizeof count, "%zu ", q->repairs.count[k]);
        if (q->repairs.first[k] >= 0 && (!row->once || by_line))
            (void)snprintf(first, sizeof first, " (%s%s %lld)",
                           row->once ? "" : "first: ", by_line ? "line" : "id",
                           (long long)q->repairs.first[k]);
        const char *detail = q->detail[k];
        wf_diag_warn(d, row->code, "%s: %s%s%s%s%s", q->name, count, row->text, first, detail ? "; " : "",
                     detail ? detail : "");
    }
}

double wf_qsm_distance(const struct wf_qsm *q, size_t i)
{
    double dx = q->x1[i] - q->x0[i], dy = q->y1[i] - q->y0[i], dz = q->z1[i] - q->z0[i];
    return sqrt(dx * dx + dy * dy + dz * dz);
}

double wf_qsm_volume(const struct wf_qsm *q, size_t i)
{
    double r0 = q->r0[i], r1 = q->r1[i];
    return acos(-1.0) / 3.0 * q->length[i] * (r0 * r0 + r0 * r1 + r1 * r1);
}
