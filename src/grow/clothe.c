/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/clothe.h"
#include "base/random.h"
#include "base/vec3.h"
#include "data/species.h"
#include "grow/branches.h"
#include "grow/qsm_model.h"
#include <math.h>

#define GOLDEN_ANGLE 2.39996322972865332 /* 137.5 degrees */

enum { LEAF_STREAM = 0x4C /* purpose of the leaves' random streams */ };

enum wf_status wf_leaves_spread(const struct wf_model *m, const struct wf_species *sp, struct wf_tree *t,
                                struct wf_err *e)
{
    if (!(m->leaf_area > 0)) return WF_OK;
    if (!sp->crown.drag_coefficient.given)
        return wf_fail(e, WF_EINPUT, "%s: the model has leaves, but the species table %s has no 'crown'",
                       m->key, sp->key);
    double length = 0;
    for (size_t i = 0; i < t->n; i++) length += t->leaf0[i] * wf_tree_length(t, i);
    if (!(length > 0))
        return wf_fail(e, WF_EINPUT, "%s: the model has leaf area, but no axis of the tree has leaves",
                       m->key);
    double sail = sp->crown.frontal_share.value * sp->crown.drag_coefficient.value;
    for (size_t i = 0; i < t->n; i++) {
        double leaf = t->leaf0[i] * m->leaf_area / length;
        t->leaf0[i] = t->leaf1[i] = leaf;
        t->sail0[i] = t->sail1[i] = leaf * sail;
        t->burden0[i] = t->burden1[i] = leaf * sp->crown.leaf_mass_per_area.value;
    }
    return WF_OK;
}

static enum wf_status take_leaves(struct wf_leaves *out, size_t n, struct wf_arena *a, struct wf_err *e)
{
    *out = (struct wf_leaves){ .row = WF_TAKE(a, n, int32_t),
                               .place = WF_TAKE(a, n, double),
                               .area = WF_TAKE(a, n, double),
                               .size = WF_TAKE(a, n, double),
                               .direction = WF_TAKE(a, 3 * n, double),
                               .side = WF_TAKE(a, 3 * n, double) };
    if (out->row && out->place && out->area && out->size && out->direction && out->side) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for %zu leaves", n);
}

/* Directions and size of leaf j on row i: tilted from the axis, rotated about it by the golden angle from the
 * leaf before. */
static void turn_leaf(const struct wf_model *m, const struct wf_tree *t, size_t i, size_t j,
                      struct wf_leaves *out)
{
    double axis[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] }, across[3], third[3];
    double length = sqrt(wf_dot(axis, axis)), z[4] = { 0 };
    for (int k = 0; k < 3; k++) axis[k] /= length;
    wf_random_normals(m->seed, wf_random_stream(LEAF_STREAM, 0, 0), 4 * j, 4, z);
    double tilt = m->foliage.tilt + m->foliage.scatter * z[0];
    double round = GOLDEN_ANGLE * (double)j + m->foliage.scatter * z[1], roll = m->foliage.scatter * z[2];
    wf_side_of(axis, across);
    wf_cross(axis, across, third);
    double *d = out->direction + 3 * j, *s = out->side + 3 * j, flat[3], upright[3];
    for (int k = 0; k < 3; k++) {
        double outward = cos(round) * across[k] + sin(round) * third[k];
        d[k] = cos(tilt) * axis[k] + sin(tilt) * outward;
        flat[k] = cos(round) * third[k] - sin(round) * across[k];
    }
    wf_cross(d, flat, upright);
    for (int k = 0; k < 3; k++) s[k] = cos(roll) * flat[k] + sin(roll) * upright[k];
    out->size[j] = exp(m->foliage.size_spread * z[3]);
}

enum wf_status wf_leaves_place(const struct wf_model *m, const struct wf_tree *t, struct wf_arena *a,
                               struct wf_leaves *out, struct wf_err *e)
{
    const double reference_wind = 10; /* [m/s], of the model's swing and twist */
    size_t n = m->leaf_area > 0 ? m->foliage.count : 0, j = 0;
    double squares = 0, passed = 0, total = 0;
    enum wf_status s = take_leaves(out, n, a, e);
    if (s) return s;
    out->swing = m->foliage.swing / reference_wind;
    out->twist = m->foliage.twist / reference_wind;
    for (size_t i = 0; i < t->n; i++) total += t->leaf0[i] * wf_tree_length(t, i);
    for (size_t i = 0; i < t->n && j < n; i++) {
        double here = t->leaf0[i] * wf_tree_length(t, i), next;
        for (; j < n && (next = total * ((double)j + 0.5) / (double)n) < passed + here; j++) {
            out->row[j] = (int32_t)i;
            out->place[j] = (next - passed) / here;
            turn_leaf(m, t, i, j, out);
            squares += out->size[j] * out->size[j];
        }
        passed += here;
    }
    out->n = j;
    for (size_t k = 0; k < j; k++) {
        out->area[k] = m->leaf_area * out->size[k] * out->size[k] / squares;
        out->size[k] /= sqrt(squares / (double)j);
    }
    return WF_OK;
}

static bool is_link(const struct wf_clothing *c, size_t i)
{
    return c->kind && c->kind[i] == WF_SEGMENT_LINK;
}

/* Distance of each row's base along its branch and the branch's length, for rows of one level joined end to
 * end. */
static void along_branch(const struct wf_tree *t, double *from, double *total)
{
    for (size_t i = 0; i < t->n; i++) {
        int32_t p = t->parent[i];
        bool same = p >= 0 && t->level[p] == t->level[i];
        from[i] = same ? from[p] + wf_tree_length(t, (size_t)p) : 0;
        total[i] = from[i] + wf_tree_length(t, i);
    }
    for (size_t i = t->n; i-- > 0;) {
        int32_t p = t->parent[i];
        if (p >= 0 && t->level[p] == t->level[i]) total[p] = fmax(total[p], total[i]);
    }
}

/* Leaf area per length on rows with one tip above them. */
static enum wf_status leaves(struct wf_tree *t, const struct wf_species *sp, const struct wf_clothing *c,
                             struct wf_arena *a, struct wf_err *e)
{
    uint32_t *tips = WF_TAKE(a, t->n, uint32_t);
    if (!tips) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    double length = 0;
    for (size_t i = t->n; i-- > 0;) {
        if (!tips[i]) tips[i] = 1;
        if (t->parent[i] >= 0) tips[t->parent[i]] += tips[i];
        if (tips[i] == 1 && !is_link(c, i)) length += wf_tree_length(t, i);
    }
    for (size_t i = 0; i < t->n; i++) {
        t->leaf0[i] = t->leaf1[i] = t->sail0[i] = t->sail1[i] = t->burden0[i] = t->burden1[i] = 0;
        double leaf = tips[i] == 1 && !is_link(c, i) ? c->leaf_area / length : 0;
        if (!(leaf > 0)) continue; /* a species without a crown has no values, and 0 times NAN is NAN */
        t->leaf0[i] = t->leaf1[i] = leaf;
        t->sail0[i] = t->sail1[i] = leaf * sp->crown.frontal_share.value * sp->crown.drag_coefficient.value;
        t->burden0[i] = t->burden1[i] = leaf * sp->crown.leaf_mass_per_area.value;
    }
    return WF_OK;
}

enum wf_status wf_clothe_wood(struct wf_tree *t, const struct wf_species *sp, const struct wf_clothing *c,
                              struct wf_err *e)
{
    static const struct wf_clothing plain = { 0 };
    struct wf_arena scratch = { 0 };
    if (!c) c = &plain;
    if (!sp->levels) return wf_fail(e, WF_EINPUT, "species %s has no level to take materials from", sp->key);
    double *from = WF_TAKE(&scratch, t->n, double), *total = WF_TAKE(&scratch, t->n, double);
    if (!from || !total) {
        wf_arena_free(&scratch);
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    }
    along_branch(t, from, total);
    for (size_t i = 0; i < t->n; i++) {
        const struct wf_level *v = c->kind ? wf_species_wood(sp, t->level[i], 0.5 * (t->r0[i] + t->r1[i]))
                                           : wf_species_level(sp, t->level[i]);
        bool link = is_link(c, i);
        wf_level_onto(v, t, i, link);
        t->i0[i] = t->i1[i] = 0;
        if (v->wall.n == 0 || link) continue;
        double s0 = from[i] / total[i], s1 = (from[i] + wf_tree_length(t, i)) / total[i];
        t->i0[i] = t->r0[i] * (1 - wf_along_at(&v->wall, s0, 1));
        t->i1[i] = t->r1[i] * (1 - wf_along_at(&v->wall, s1, 1));
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

enum wf_status wf_clothe(struct wf_tree *t, const struct wf_species *sp, const struct wf_clothing *c,
                         struct wf_arena *a, struct wf_err *e)
{
    if (!(c->leaf_area >= 0 && c->leaf_area < INFINITY))
        return wf_fail(e, WF_EINPUT, "leaf area %g m2; it must not be negative", c->leaf_area);
    enum wf_status s = wf_clothe_wood(t, sp, c, e);
    return s ? s : leaves(t, sp, c, a, e);
}
