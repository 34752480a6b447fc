#include "base/csv.h"
#include "cases/keys.h"
#include "cases/measure.h"
#include <stdlib.h>

enum column { ID, PARENT, X0, Y0, Z0, X1, Y1, Z1, R0, R1, LEVEL, COLUMNS };
static const char *const names[COLUMNS] = { "id", "parent", "x0",      "y0",      "z0",   "x1",
                                            "y1", "z1",     "radius0", "radius1", "level" };

struct record {
    long long id, parent, level;
    double v[R1 + 1]; /* X0..R1 */
};

struct by_id {
    long long id;
    int32_t row;
};

static int order(const void *a, const void *b)
{
    const struct by_id *x = a, *y = b;
    return (x->id > y->id) - (x->id < y->id);
}

static bool record_read(struct wf_csv *f, const size_t at[COLUMNS], struct record *r)
{
    bool ok = wf_csv_integer(f, at[ID], 1, INT64_MAX, &r->id);
    ok &= wf_csv_integer(f, at[PARENT], 0, INT64_MAX, &r->parent);
    ok &= wf_csv_integer(f, at[LEVEL], 0, 1000, &r->level);
    for (size_t k = X0; k <= Z1; k++) ok &= wf_csv_number(f, at[k], -1e6, 1e6, &r->v[k]);
    for (size_t k = R0; k <= R1; k++) ok &= wf_csv_number(f, at[k], 1e-9, 1e3, &r->v[k]);
    return ok;
}

static enum wf_status fill(const struct record *r, size_t n, const char *path, struct wf_arena *a,
                           struct wf_tree *t, struct wf_err *e)
{
    struct by_id *index = WF_TAKE(a, n, struct by_id);
    if (!index) return wf_fail(e, WF_ENOMEM, "%s: no memory for %zu rows", path, n);
    for (size_t i = 0; i < n; i++) index[i] = (struct by_id){ r[i].id, (int32_t)i };
    qsort(index, n, sizeof *index, order);
    if (wf_tree_alloc(t, n, a, e)) return e->code;
    for (size_t i = 0; i < n; i++) {
        struct by_id key = { r[i].parent, 0 },
                     *found = r[i].parent ? bsearch(&key, index, n, sizeof key, order) : NULL;
        if (r[i].parent && (!found || found->row >= (int32_t)i))
            return wf_fail(e, WF_EINPUT, "%s: row with id %lld: its parent %lld is not a row above it", path,
                           r[i].id, r[i].parent);
        t->parent[i] = found ? found->row : -1;
        t->id[i] = r[i].id;
        t->level[i] = (int32_t)r[i].level;
        t->x0[i] = r[i].v[X0], t->y0[i] = r[i].v[Y0], t->z0[i] = r[i].v[Z0];
        t->x1[i] = r[i].v[X1], t->y1[i] = r[i].v[Y1], t->z1[i] = r[i].v[Z1];
        t->r0[i] = r[i].v[R0], t->r1[i] = r[i].v[R1];
    }
    return WF_OK;
}

enum wf_status wf_case_tree_read(const char *path, struct wf_arena *a, struct wf_tree *t, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    struct wf_csv f;
    size_t at[COLUMNS];
    struct wf_list rows = { 0 };
    if (wf_csv_open(&f, path, a, &d, e)) return e->code;
    for (size_t k = 0; k < COLUMNS; k++) at[k] = wf_csv_need(&f, names[k]);
    while (!d.errors && wf_csv_next(&f)) {
        struct record r;
        if (record_read(&f, at, &r) && !wf_list_add(&rows, &r, sizeof r, a))
            return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    }
    if (d.errors) {
        char text[900];
        return wf_fail(e, WF_EINPUT, "%s", wf_finding_print(d.first, text, sizeof text));
    }
    if (!rows.n) return wf_fail(e, WF_EINPUT, "%s: no rows", path);
    return fill(rows.data, rows.n, path, a, t, e);
}
