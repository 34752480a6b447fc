/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_BRANCHED_H
#define WF_TESTS_BRANCHED_H
/* Branched trees from a model as text and a species of two levels. */
#include "close.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/grow.h"
#include "scratch.h"

static inline struct wf_value is(double v) { return (struct wf_value){ v, v, v, .given = true }; }

static inline struct wf_species plain_species(struct wf_level level[2])
{
    for (int k = 0; k < 2; k++)
        level[k] = (struct wf_level){ .name = k ? "branch" : "stem",
                                      .youngs_modulus = is(8e9 - 2e9 * k),
                                      .shear_modulus = is(0.5e9),
                                      .density = is(900),
                                      .modulus_of_rupture = is(40e6),
                                      .radius = is(0.1 - 0.08 * k),
                                      .damping_ratio = is(0.02),
                                      .knot_factor = is(1),
                                      .drag_coefficient = { .value = NAN },
                                      .lift_coefficient = is(0) };
    return (struct wf_species){ .key = "sp",
                                .levels = 2,
                                .level = level,
                                .crown.drag_coefficient = is(0.5),
                                .crown.leaf_mass_per_area = is(0.2),
                                .crown.frontal_share = is(0.3) };
}

/* A model and what it grows; the arena holds both. */
struct grown {
    struct wf_arena arena;
    struct wf_level level[2];
    struct wf_species species;
    struct wf_model model;
    struct wf_tree tree;
    struct wf_diag diag;
};

static inline enum wf_status grown_read(struct grown *g, const char *text, struct wf_err *e)
{
    struct scratch s;
    *g = (struct grown){ 0 };
    g->diag.arena = &g->arena;
    g->species = plain_species(g->level);
    scratch_write(&s, text, strlen(text));
    enum wf_status status = wf_model_read(s.path, &g->arena, &g->model, &g->diag, e);
    scratch_remove(&s);
    return status;
}

static inline void grown_make(struct grown *g, const char *text)
{
    struct wf_err e = { 0 };
    if (grown_read(g, text, &e)) fail_msg("%s: %s", e.text, g->diag.first ? g->diag.first->text : "");
    if (wf_grow(&g->model, &g->species, &g->arena, &g->tree, &g->diag, &e)) fail_msg("%s", e.text);
    if (wf_tree_check(&g->tree, &g->diag, &e)) fail_msg("%s: %s", e.text, g->diag.last->text);
}

/* Every row starts exactly where its parent ends, parents stand before children, levels rise by one. */
static inline void grown_is_connected(const struct wf_tree *t)
{
    for (size_t i = 0; i < t->n; i++) {
        int32_t p = t->parent[i];
        assert_true(p < (int32_t)i);
        assert_true((p < 0) == (i == 0));
        if (p < 0) continue;
        assert_memory_equal(&t->x0[i], &t->x1[p], sizeof(double));
        assert_memory_equal(&t->y0[i], &t->y1[p], sizeof(double));
        assert_memory_equal(&t->z0[i], &t->z1[p], sizeof(double));
        assert_true(t->level[i] == t->level[p] || t->level[i] == t->level[p] + 1);
    }
}

/* Axes of a level: rows that do not continue a row of it. */
static inline size_t grown_axes(const struct wf_tree *t, int level)
{
    size_t n = 0;
    for (size_t i = 0; i < t->n; i++)
        n += t->level[i] == level && (t->parent[i] < 0 || t->level[t->parent[i]] != level);
    return n;
}

/* First row of axis k of a level. */
static inline size_t grown_axis(const struct wf_tree *t, int level, size_t k)
{
    for (size_t i = 0; i < t->n; i++)
        if (t->level[i] == level && (t->parent[i] < 0 || t->level[t->parent[i]] != level) && k-- == 0)
            return i;
    fail_msg("level %d has no such axis", level);
    return 0;
}

/* Length of the axis that begins with row i. */
static inline double grown_length(const struct wf_tree *t, size_t i)
{
    double sum = wf_tree_length(t, i);
    for (size_t k = i + 1; k < t->n && t->parent[k] == (int32_t)k - 1 && t->level[k] == t->level[i]; k++)
        sum += wf_tree_length(t, k);
    return sum;
}

/* Angle between two directions given as rows [rad]. */
static inline double grown_angle(const struct wf_tree *t, size_t i, size_t k)
{
    double u[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
    double v[3] = { t->x1[k] - t->x0[k], t->y1[k] - t->y0[k], t->z1[k] - t->z0[k] };
    double c[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
    return atan2(hypot(hypot(c[0], c[1]), c[2]), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
}
#endif
