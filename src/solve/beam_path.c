/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_path.h"
#include "base/vec3.h"

enum wf_status wf_beam_small_take(struct wf_beam *b, struct wf_arena *a, struct wf_err *e)
{
    b->small = WF_TAKE(a, b->mesh.n, struct wf_beam_small);
    b->sides = WF_TAKE(a, b->mesh.n, struct wf_beam_sides);
    b->root_moved = wf_arena_take(a, b->mesh.tree->n, sizeof *b->root_moved);
    if (b->small && b->sides && b->root_moved) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for the small motions of %zu elements", b->mesh.n);
}

static bool is_held(const struct wf_beam *b, int32_t i) { return i >= 0 && wf_beam_held(b, (size_t)i); }

/* Of an element of a path: its answer at a fixed base, and its wrench on the element below. */
WF_INLINE void path_down(struct wf_beam *b, size_t i, wf_four ground[6])
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    struct wf_beam_disturbance none;
    wf_four down[6];
    memset(&none, 0, sizeof none);
    if (is_held(b, (int32_t)i)) {
        memset(b->sides[i].y, 0, sizeof b->sides[i].y);
        return;
    }
    answer_down(p, &b->stage[i], &b->small[i], &none, &b->sides[i], down);
    if (p->parent < 0) ground_root(b, (size_t)p->row, down, NULL, ground);
    for (int c = 0; c < 6 && p->parent >= 0 && !is_held(b, p->parent); c++)
        b->sides[p->parent].push[c] += down[c];
}

static void base_turn(const struct wf_beam *b, size_t i, double L[9])
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    if (p->parent < 0)
        rotation_matrix(b->tilt[p->row], L);
    else
        memcpy(L, b->pose[p->parent].L, sizeof b->pose[p->parent].L);
}

/* The correction of a root plate by the change of its pose in lane 0. */
static void correct_root(struct wf_beam *b, size_t row)
{
    const double *v = b->tilt[row], x = wf_dot(v, v);
    const struct rotation o = rotation_of(x);
    double spin[3], step[3], inverse[9];
    for (int c = 0; c < 3; c++) spin[c] = b->root_moved[row][3 + c][0];
    rotation_tangent_inverse(&o, v, x, inverse);
    m3_apply(inverse, spin, step);
    v3_add(b->root_step[row], 1, step);
    v3_add(b->root_change[row] + 3, 1, spin);
}

WF_WIDE void wf_beam_answer_path(struct wf_beam *b, const int32_t *path, size_t n)
{
    static const wf_four still[6];
    wf_four ground[6] = { 0 };
    for (size_t k = 0; k < n; k++) path_down(b, (size_t)path[k], ground);
    for (size_t k = n; k-- > 0;) {
        size_t i = (size_t)path[k];
        int32_t below = b->mesh.part[i].parent;
        const wf_four *base = below < 0 ? b->root_moved[b->mesh.part[i].row] : b->sides[below].y;
        if (is_held(b, (int32_t)i)) continue;
        answer_up(&b->mesh.part[i], &b->stage[i], &b->answer[i], &b->small[i],
                  is_held(b, below) ? still : base, &b->sides[i], NULL);
    }
}

WF_WIDE void wf_beam_correct_path(struct wf_beam *b, const int32_t *path, size_t n, double (*strain)[2][3])
{
    double L[9];
    static const wf_four still[6];
    wf_four ground[6] = { 0 };
    for (size_t k = 0; k < n; k++) {
        size_t i = (size_t)path[k];
        struct wf_beam_sides *v = &b->sides[i];
        memset(strain[k], 0, sizeof strain[k]);
        path_down(b, i, ground);
        if (is_held(b, (int32_t)i)) continue;
        base_turn(b, i, L);
        for (int j = 0; j < 2; j++) {
            const double stretch[3] = { v->stretch[j][0][0], v->stretch[j][1][0], v->stretch[j][2][0] };
            m3_apply_transposed(L, stretch, strain[k][j]);
        }
        for (int c = 0; c < 6; c++) b->answer[i].x[c] += v->y[c][0];
        answer_up(&b->mesh.part[i], &b->stage[i], &b->answer[i], &b->small[i], still, v, NULL);
        for (int c = 0; c < 6; c++) b->node[i].k[c] += v->y[c][0];
        if (b->mesh.part[i].parent < 0) correct_root(b, (size_t)b->mesh.part[i].row);
    }
}
