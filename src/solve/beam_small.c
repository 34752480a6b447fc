/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_small.h"
#include "base/vec3.h"
#include "solve/beam_eliminate.h"
#include "solve/beam_ends.h"
#include "solve/beam_kernel.h"
#include "solve/beam_mesh.h"

enum wf_status wf_beam_linearise(struct wf_beam *b, bool frozen, struct wf_arena *a, struct wf_err *e)
{
    enum wf_status s = wf_beam_small_take(b, a, e);
    if (s) return s;
    b->frozen = frozen;
    b->misfit = (struct wf_beam_misfit){ 0 };
    wf_beam_sweep_up(b);
    if (!wf_beam_sweep_down(b, true, NULL) || (b->links && !wf_beam_links_linearise(b)))
        return wf_fail(
            e, WF_EUNSTABLE,
            "the stiffness matrix of the equilibrium is singular: no small motions exist about it");
    return WF_OK;
}

void wf_beam_law_moment(const struct wf_beam *b, size_t i, double moment[2][3])
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
    double k[2][3], bent[3];
    wf_beam_curvature(p, &b->shape[i], k);
    for (int j = 0; j < 2; j++) {
        m3_apply(base->L, k[j], bent);
        law_hold(p, wf_beam_flat_of(b, i), &b->stage[i], j, bent, moment[j]);
    }
}

void wf_beam_turn_along(const struct wf_beam *b, size_t i, const double given[2][3], double turned[2][3])
{
    struct wf_beam_pose ground;
    struct turns o;
    double local[3];
    turns_of(&b->shape[i], &o);
    for (int j = 0; j < 2; j++)
        turn_with_section(&b->shape[i], &o, wf_beam_base(b, i, &ground)->L, j, given[j], local, turned[j]);
}

typedef void disturbance_source(const void *ctx, const struct wf_beam *b, size_t i,
                                struct wf_beam_disturbance *out);

/* Tips to base: wrenches. Inlined for each source. */
WF_INLINE void answer_all_down(struct wf_beam *b, disturbance_source *source, const void *ctx,
                               const wf_four (*root)[3], wf_four ground[6])
{
    for (size_t i = b->mesh.n; i-- > 0;) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_disturbance x;
        wf_four down[6];
        memset(&x, 0, sizeof x);
        if (source) source(ctx, b, i, &x);
        answer_down(p, &b->stage[i], &b->small[i], &x, &b->sides[i], down);
        if (p->parent >= 0)
            for (int c = 0; c < 6; c++) b->sides[p->parent].push[c] += down[c];
        else
            ground_root(b, (size_t)p->row, down, root ? root[p->row] : NULL, ground);
    }
}

/* Base to tips: motions. */
WF_INLINE void answer_all_up(struct wf_beam *b, wf_four *motion)
{
    for (size_t i = 0; i < b->mesh.n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_sides *v = &b->sides[i];
        answer_up(p, &b->stage[i], &b->answer[i], &b->small[i],
                  p->parent >= 0 ? b->sides[p->parent].y : b->root_moved[p->row], v,
                  motion ? motion + 8 * i : NULL);
    }
}

/* The wrenches on the ends that a solution starts from. */
WF_INLINE void push_ends(struct wf_beam *b, const wf_four (*node)[6])
{
    for (size_t i = 0; i < b->mesh.n; i++)
        if (node)
            memcpy(b->sides[i].push, node[i], sizeof b->sides[i].push);
        else
            memset(b->sides[i].push, 0, sizeof b->sides[i].push);
}

WF_WIDE void wf_beam_answer_small(struct wf_beam *b, disturbance_source *source, const void *ctx,
                                  const wf_four (*node)[6], const wf_four (*root)[3],
                                  struct wf_beam_small_answer *out)
{
    memset(out->ground, 0, sizeof out->ground);
    push_ends(b, node);
    answer_all_down(b, source, ctx, root, out->ground);
    if (b->links) {
        answer_all_up(b, NULL);
        memset(out->ground, 0, sizeof out->ground);
        push_ends(b, node);
        wf_beam_links_answer(b);
        answer_all_down(b, source, ctx, root, out->ground);
    }
    answer_all_up(b, out->motion);
    for (size_t i = 0; out->ends && i < b->mesh.n; i++)
        memcpy(out->ends[i], b->sides[i].y, sizeof *out->ends);
}

/* ---- The change to other loads ---- */

/* Of a root plate: in place of the wrench on it, the changes of its tilt and of its pose. */
static void turn_root(struct wf_beam *b, size_t row)
{
    const double *v = b->tilt[row], x = wf_dot(v, v);
    double *change = b->root_side[row], moment[3], inverse[9];
    const struct rotation o = rotation_of(x);
    memcpy(moment, change + 3, sizeof moment);
    m3_apply(b->root_give[row], moment, change + 3);
    rotation_tangent_inverse(&o, v, x, inverse);
    m3_apply(inverse, change + 3, change);
}

bool wf_beam_side_find(struct wf_beam *b, bool *stable)
{
    struct wf_beam_pose ground;
    if (!wf_beam_has_side(b)) return false;
    if (!b->sided || b->finished) {
        b->counted = b->sided = false;
        (void)wf_beam_stable(b);
    }
    if (!b->sided) return false;
    if (stable) *stable = wf_beam_stable(b);
    for (size_t i = 0; i < b->mesh.n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        double root[6] = { 0 }, *base = root;
        if (p->parent < 0) {
            turn_root(b, (size_t)p->row);
            memcpy(root + 3, b->root_side[p->row] + 3, 3 * sizeof *root);
        } else
            base = b->change[p->parent];
        wf_beam_correct_side(&b->shape[i], wf_beam_base(b, i, &ground)->L, &b->answer[i], &b->node[i], base,
                             b->side[i].v, b->change[i]);
    }
    return true;
}

bool wf_beam_side_take(struct wf_beam *b)
{
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2; j++) {
            v3_add(b->shape[i].v[j], 1, b->side[i].v[j]);
            v3_add(b->shape[i].g[j], 1, b->side[i].g[j]);
        }
    for (size_t i = 0; i < b->mesh.tree->n; i++)
        if (b->mesh.tree->parent[i] < 0) v3_add(b->tilt[i], 1, b->root_side[i]);
    b->loads = *b->other;
    wf_beam_sweep_up(b);
    return wf_beam_sweep_down(b, false, NULL);
}

bool wf_beam_side_step(struct wf_beam *b, bool *stable)
{
    wf_beam_sweep_up(b);
    b->loads = *b->other;
    return wf_beam_step(b, stable);
}
