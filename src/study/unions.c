/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/unions.h"
#include <math.h>
#include <stdlib.h>

const struct wf_union_class wf_union_classes[WF_UNION_CLASSES] = {
    { "subordinate", "below 0.60, as is wanted", 0 },
    { "above-wanted", "above the 0.60 that is wanted", 0.60 },
    { "codominant-with-included-bark", "codominant where bark is included", 0.70 },
    { "codominant", "codominant, with or without included bark", 0.83 },
};

static const struct wf_union_class *class_of(double ratio)
{
    int k = WF_UNION_CLASSES - 1;
    while (k > 0 && ratio < wf_union_classes[k].from) k--;
    return &wf_union_classes[k];
}

/* A link lies in the wood it joins and has no wood of its own (grow/qsm_model.h). */
static bool is_link(const struct wf_tree *t, int32_t i) { return i >= 0 && !(t->density[i] > 0); }

/* Rows by the node at which they begin: the end of a row, or, last, the ground. */
struct fork_search {
    const struct wf_tree *t;
    int32_t *wood;     /* by row: itself, of a link the first row of wood beyond; -1 none */
    int32_t *thickest; /* by node: the row whose wood is thickest; -1 none                */
};

static size_t node_of(const struct wf_tree *t, size_t i)
{
    return t->parent[i] < 0 ? t->n : (size_t)t->parent[i];
}

/* Does row i, or a later one, continue what is below? */
static bool continues(const struct fork_search *f, int32_t i, int32_t later)
{
    const struct wf_tree *t = f->t;
    if (later < 0) return true;
    int32_t x = f->wood[i], y = f->wood[later];
    if (t->r0[x] != t->r0[y]) return t->r0[x] > t->r0[y];
    return t->level[x] <= t->level[y];
}

/* From the last row down: what is beyond a row is known before it. */
static void find_thickest(struct fork_search *f)
{
    for (size_t k = 0; k <= f->t->n; k++) f->thickest[k] = -1;
    for (size_t k = f->t->n; k-- > 0;) {
        int32_t i = (int32_t)k, beyond = f->thickest[k], *at = &f->thickest[node_of(f->t, k)];
        f->wood[k] = !is_link(f->t, i) ? i : beyond < 0 ? -1 : f->wood[beyond];
        if (f->wood[k] >= 0 && continues(f, i, *at)) *at = i;
    }
}

/* Rows of different trees on one ground do not touch. */
static bool touches(const struct wf_tree *t, size_t i, int32_t j)
{
    double away = hypot(hypot(t->x0[i] - t->x0[j], t->y0[i] - t->y0[j]), t->z0[i] - t->z0[j]);
    return t->parent[i] >= 0 || away <= t->r0[i] + t->r0[j];
}

/* Row i beside the row that continues. */
static struct wf_union union_of(const struct fork_search *f, size_t i, int32_t beside)
{
    const struct wf_tree *t = f->t;
    int32_t branch = f->wood[i], above = f->wood[beside], at = t->parent[i], below = at;
    while (is_link(t, below)) below = t->parent[below];
    double ratio = t->r0[branch] / t->r0[above];
    return (struct wf_union){ .branch = branch,
                              .above = above,
                              .below = below,
                              .height = at < 0 ? t->z0[i] : t->z1[at],
                              .branch_diameter = 2 * t->r0[branch],
                              .above_diameter = 2 * t->r0[above],
                              .below_diameter = below < 0 ? (double)NAN : 2 * t->r1[below],
                              .ratio = ratio,
                              .in = class_of(ratio) };
}

static int by_ratio(const void *a, const void *b)
{
    const struct wf_union *x = a, *y = b;
    if (x->ratio != y->ratio) return x->ratio > y->ratio ? -1 : 1;
    return x->branch < y->branch ? -1 : 1;
}

enum wf_status wf_unions_list(const struct wf_tree *t, double from, struct wf_arena *a, struct wf_unions *out,
                              struct wf_err *e)
{
    struct fork_search f = { t, WF_TAKE(a, t->n, int32_t), WF_TAKE(a, t->n + 1, int32_t) };
    *out = (struct wf_unions){ 0, WF_TAKE(a, t->n, struct wf_union) };
    if (!f.wood || !f.thickest || !out->item)
        return wf_fail(e, WF_ENOMEM, "no memory for the unions of %zu segments", t->n);
    find_thickest(&f);
    for (size_t i = 0; i < t->n; i++) {
        int32_t beside = f.thickest[node_of(t, i)];
        if (beside == (int32_t)i || f.wood[i] < 0 || 2 * t->r0[f.wood[i]] < from) continue;
        if (touches(t, i, beside)) out->item[out->n++] = union_of(&f, i, beside);
    }
    qsort(out->item, out->n, sizeof *out->item, by_ratio);
    return WF_OK;
}

size_t wf_unions_of(const struct wf_unions *u, const struct wf_union_class *in)
{
    size_t n = 0;
    for (size_t k = 0; k < u->n; k++) n += u->item[k].in == in;
    return n;
}
