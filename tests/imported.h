/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_IMPORTED_H
#define WF_TESTS_IMPORTED_H
/* A tree file read for a test, and what must hold of every tree that was read and joined. */
#include "grow/clothe.h"
#include "grow/import.h"
#include "load/qsm_metrics.h"
#include "grow/qsm_model.h"
#include "scratch.h"

struct imported {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    struct wf_qsm qsm;
    struct wf_qsm_metrics metrics;
    enum wf_status status;
};

static inline void import_with(struct imported *t, const char *path, struct wf_import_options o)
{
    memset(t, 0, sizeof *t);
    t->diag.arena = &t->arena;
    t->status = wf_import_read(path, &o, &t->arena, &t->qsm, &t->diag, &t->err);
    if (!t->status) wf_qsm_measure(&t->qsm, &t->metrics);
}

static inline void import_path(struct imported *t, const char *path)
{
    import_with(t, path, wf_import_default());
}

static inline void import_text(struct imported *t, const char *text, size_t size)
{
    struct scratch s;
    scratch_write(&s, text, size);
    import_path(t, s.path);
    scratch_remove(&s);
}

/* Rows sorted, radii and lengths sound, one branch number along continuations. */
static inline void assert_sound(const struct wf_qsm *q)
{
    assert_true(q->n > 0);
    for (size_t i = 0; i < q->n; i++) {
        assert_true(q->parent[i] >= -1 && q->parent[i] < (int32_t)i);
        assert_true(q->r0[i] > 0 && q->r1[i] > 0 && q->length[i] > 0 && wf_qsm_distance(q, i) > 0);
        assert_true(q->order[i] >= 0 && q->branch[i] > 0 && q->place[i] > 0);
        if (q->next[i] >= 0) assert_int_equal(q->branch[q->next[i]], q->branch[i]);
        if (q->next[i] >= 0) assert_int_equal(q->parent[q->next[i]], i);
    }
}

/* Segments joined end to end, every parent before its children, nothing without length; a solver takes it. */
static inline void assert_joined(struct imported *t, enum wf_joint joint, struct wf_qsm_model *m)
{
    assert_int_equal(wf_qsm_to_tree(&t->qsm, joint, &t->arena, m, &t->err), WF_OK);
    struct wf_tree *w = &m->tree;
    struct wf_level level = { .youngs_modulus.value = 1e10,
                              .shear_modulus.value = 6e8,
                              .density.value = 800,
                              .drag_coefficient.given = true,
                              .drag_coefficient.value = 1,
                              .knot_factor.value = 1 };
    struct wf_species sp = { .key = "test", .levels = 1, .level = &level };
    assert_int_equal(wf_clothe(w, &sp, &(struct wf_clothing){ .kind = m->kind }, &t->arena, &t->err), WF_OK);
    assert_int_equal(wf_tree_check(w, &t->diag, &t->err), WF_OK);
    for (size_t i = 0; i < w->n; i++) {
        int32_t p = w->parent[i];
        if (p < 0) continue;
        assert_true(p < (int32_t)i);
        assert_true(w->x0[i] == w->x1[p] && w->y0[i] == w->y1[p] && w->z0[i] == w->z1[p]);
    }
}

/* Wood of the segments, links left out [m3]. */
static inline double segment_volume(const struct wf_qsm_model *m)
{
    double v = 0;
    for (size_t i = 0; i < m->tree.n; i++) {
        double r0 = m->tree.r0[i], r1 = m->tree.r1[i];
        if (m->kind[i] != WF_SEGMENT_LINK)
            v += M_PI / 3 * wf_tree_length(&m->tree, i) * (r0 * r0 + r0 * r1 + r1 * r1);
    }
    return v;
}
#endif
