/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The part that the harnesses of tree files share. */
#include "data/model.h"
#include "fuzz.h"
#include "grow/grow.h"
#include "grow/import.h"
#include "grow/import_file.h"
#include "grow/qsm_model.h"
#include <string.h>

static const char *format_asked;

static struct wf_import_options options(void)
{
    struct wf_import_options o = wf_import_default();
    o.format = format_asked;
    if (format_asked && !strcmp(format_asked, "nodes")) o.length_unit = 1; /* SWC needs one */
    return o;
}

static void must_be_table(const struct wf_qsm *q)
{
    const double *column[] = { q->x0, q->y0, q->z0, q->x1, q->y1, q->z1, q->r0, q->r1 };
    bool stem = false;
    must(q->n > 0, "a table has rows");
    must_be_finite(q->base, 3, "the base is finite");
    for (size_t k = 0; k < sizeof column / sizeof *column; k++)
        must_be_finite(column[k], q->n, "a table is finite");
    for (size_t i = 0; i < q->n; i++) {
        must(q->parent[i] >= -1 && q->parent[i] < (int32_t)i, "parents come before their children");
        must(q->r0[i] > 0 && q->r1[i] > 0, "radii are positive");
        must(wf_qsm_distance(q, i) > 0, "rows have a length");
        must(q->order[i] >= 0, "every row has an order");
        stem = stem || (q->parent[i] < 0 && q->order[i] == 0);
        must(q->next[i] == -1 || (q->next[i] < (int32_t)q->n && q->parent[q->next[i]] == (int32_t)i),
             "a branch goes on in a child");
    }
    must(stem, "orders count from 0 at a stem");
}

static void join(struct fuzz *f, const struct wf_qsm *q, enum wf_joint way)
{
    struct wf_qsm_model m;
    struct wf_err e = { 0 };
    if (!fuzz_done(wf_qsm_to_tree(q, way, &f->arena, &m, &e), &e)) return;
    const struct wf_tree *t = &m.tree;
    const double *column[] = { t->x0, t->y0, t->z0, t->x1, t->y1, t->z1, t->r0, t->r1 };
    must(t->n > 0, "a joined tree has segments");
    for (size_t i = 0; i < t->n; i++)
        must(t->parent[i] >= -1 && t->parent[i] < (int32_t)i, "joined parents come before their children");
    for (size_t k = 0; k < sizeof column / sizeof *column; k++)
        must_be_finite(column[k], t->n, "a joined tree is finite");
}

/* The whole way of `analyze --tree`, with leaves. */
static void grow(struct fuzz *f, const char *joint)
{
    struct wf_model *m;
    struct wf_tree t;
    struct wf_err e = { 0 }, none = { 0 };
    struct wf_diag d = { .arena = &f->arena };
    if (!fuzz_done(wf_model_scanned(f->path, joint, &f->arena, &m, &d, &e), &e)) return;
    if (!fuzz_done(wf_model_leaves(m, 20, &none), &none)) return;
    if (fuzz_done(wf_grow(m, fuzz_species("weeping_willow"), &f->arena, &t, &d, &e), &e)) must_be_tree(&t);
}

static enum wf_status read_strict(struct fuzz *f)
{
    struct wf_import_options o = options();
    struct wf_diag d = { .arena = &f->arena };
    struct wf_err e = { 0 };
    struct wf_qsm strict, q;
    o.strict = true;
    enum wf_status s = wf_import_read(f->path, &o, &f->arena, &strict, &f->diag, &f->err);
    if (s) return s;
    must_be_table(&strict);
    o.strict = false;
    s = wf_import_read(f->path, &o, &f->arena, &q, &d, &e);
    must(s == WF_ENOMEM || (!s && q.n == strict.n), "what a strict import accepts needs no repair");
    return WF_OK;
}

static enum wf_status read_tree(struct fuzz *f)
{
    struct wf_import_options o = options();
    struct wf_qsm q;
    enum wf_status s = wf_import_read(f->path, &o, &f->arena, &q, &f->diag, &f->err);
    if (s) return s;
    must_be_table(&q);
    join(f, &q, WF_JOINT_AXIS);
    join(f, &q, WF_JOINT_BRIDGE);
    if (!format_asked) grow(f, "axis"), grow(f, "bridge");
    return WF_OK;
}

int fuzz_import(const uint8_t *data, size_t size, const char *format)
{
    format_asked = format;
    fuzz_read(data, size, read_tree);
    return fuzz_read(data, size, read_strict);
}
