/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/clothe.h"
#include "data/species.h"
#include "grow/qsm_model.h"
#include <math.h>

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
    if (!tips) return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    double length = 0;
    for (size_t i = t->n; i-- > 0;) {
        if (!tips[i]) tips[i] = 1;
        if (t->parent[i] >= 0) tips[t->parent[i]] += tips[i];
        if (tips[i] == 1 && !is_link(c, i)) length += wf_tree_length(t, i);
    }
    for (size_t i = 0; i < t->n; i++) {
        t->leaf0[i] = t->leaf1[i] = t->sail0[i] = t->sail1[i] = t->burden0[i] = t->burden1[i] = 0;
        double leaf = tips[i] == 1 && !is_link(c, i) ? c->leaf_area / length : 0;
        if (!(leaf > 0)) continue; /* a species without a crown has no values to multiply by 0 */
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
        return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
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
