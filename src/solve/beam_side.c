/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_side.h"
#include "base/vec3.h"
#include "solve/beam_eliminate.h"

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
