/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_small.h"
#include "base/vec3.h"
#include "solve/beam_element.h"
#include "solve/beam_kernel.h"
#include "solve/beam_mesh.h"

enum wf_status wf_beam_linearise(struct wf_beam *b, bool frozen, struct wf_arena *a, struct wf_err *e)
{
    b->small = WF_TAKE(a, b->mesh.n, struct wf_beam_small);
    b->push = wf_arena_take(a, b->mesh.n, sizeof *b->push);
    if (!b->small || !b->push)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the small motions of %zu elements", b->mesh.n);
    b->frozen = frozen;
    b->misfit = (struct wf_beam_misfit){ 0 };
    wf_beam_sweep_up(b);
    if (!wf_beam_sweep_down(b, true, NULL))
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

WF_INLINE void apply6(double A[6][6], const double x[6], double y[6])
{
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) y[i] += A[i][c] * x[c];
}

/* One element under a disturbance and the wrench k from above. Returned: y at a fixed base, stretch, wrench
 * on the base. */
WF_INLINE void answer_down(const struct wf_beam_part *p, const struct wf_beam_stage *s,
                           struct wf_beam_small *q, const struct wf_beam_disturbance *x, const double k[6],
                           double y[6], double stretch[2][3], double down[6])
{
    double turn[2][3], d[6];
    for (int j = 0; j < 2; j++) {
        double own[3], n[3], give[3], lever[3];
        for (int i = 0; i < 3; i++) {
            own[i] = p->h * (gauss_down[j][0] * x->force[0][i] + gauss_down[j][1] * x->force[1][i]);
            n[i] = k[i] + own[i];
        }
        v3_section(p->cs[j], p->ca[j], s->t[j], n, stretch[j]);
        v3_section(p->cs[j], p->ca[j], s->t[j], own, give);
        m3_apply(q->Vn[j], k, turn[j]);
        wf_cross(s->rp[j], own, lever);
        v3_add(turn[j], 1, lever);
        wf_cross(q->n[j], give, lever);
        v3_add(turn[j], -1, lever);
        v3_add(turn[j], 1, x->couple[j]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 2; j++)
            d[3 * j + i] = k[3 + i] - x->law[j][i] +
                           p->h * (gauss_down[j][0] * turn[0][i] + gauss_down[j][1] * turn[1][i]);
        down[i] = k[i] + 0.5 * p->h * (x->force[0][i] + x->force[1][i]);
        down[3 + i] = k[3 + i] + 0.5 * p->h * (turn[0][i] + turn[1][i]);
    }
    memset(y, 0, 6 * sizeof *y);
    apply6(q->R, d, y);
    apply6(q->T, y, down);
}

/* Motion of one element for the change `base` of its base. Returned: displacement and twist at the Gauss
 * points, change of the end. */
WF_INLINE void answer_up(const struct wf_beam_part *p, const struct wf_beam_stage *s,
                         struct wf_beam_answer *x, struct wf_beam_small *q, const double base[6], double y[6],
                         double stretch[2][3], double *motion, double end[6])
{
    double dr[2][3], spin[2][3];
    apply6(x->X, base, y);
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 3; i++) spin[j][i] = base[3 + i] + y[3 * j + i];
        m3_apply(q->Y[j], spin[j], dr[j]);
        v3_add(dr[j], 1, stretch[j]);
    }
    for (int j = 0; j < 2 && motion; j++) {
        for (int i = 0; i < 3; i++)
            motion[4 * j + i] = base[i] + p->h * (gauss_up[j][0] * dr[0][i] + gauss_up[j][1] * dr[1][i]);
        motion[4 * j + 3] = wf_dot(s->t[j], spin[j]);
    }
    for (int i = 0; i < 3; i++) {
        end[i] = base[i] + 0.5 * p->h * (dr[0][i] + dr[1][i]);
        end[3 + i] = base[3 + i];
        for (int c = 0; c < 6; c++) end[3 + i] += q->P[3 + i][c] * y[c];
    }
}

/* Rotation of a root plate, and the root's wrench on the ground: that for a fixed plate plus the effect of
 * its spin. */
static void ground_root(struct wf_beam *b, size_t row, const double down[6], const double *root,
                        double ground[6])
{
    const struct wf_tree *t = b->mesh.tree;
    const double arm[3] = { t->x0[row] - t->x0[0], t->y0[row] - t->y0[0], t->z0[row] - t->z0[0] };
    double lever[3], m[3] = { down[3], down[4], down[5] }, all[6], *p = b->root_change[row];
    for (int i = 0; root && i < 3; i++) m[i] += root[i];
    memset(p, 0, sizeof b->root_change[row]);
    m3_apply(b->root_give[row], m, p + 3);
    for (int i = 0; i < 6; i++) {
        const double *by = b->root_hold[row][i];
        all[i] = down[i] + by[0] * p[3] + by[1] * p[4] + by[2] * p[5];
    }
    wf_cross(arm, all, lever);
    for (int i = 0; i < 3; i++) ground[i] += all[i], ground[3 + i] += all[3 + i] + lever[i];
}

WF_WIDE void wf_beam_answer_small(struct wf_beam *b,
                                  void (*source)(const void *ctx, const struct wf_beam *b, size_t i,
                                                 struct wf_beam_disturbance *out),
                                  const void *ctx, const double (*node)[6], const double (*root)[3],
                                  struct wf_beam_small_answer *out)
{
    size_t n = b->mesh.n;
    double(*y)[6] = b->change; /* not in use between Newton solutions */
    double(*stretch)[2][3] = b->dv;
    memset(out->ground, 0, sizeof out->ground);
    if (node)
        memcpy(b->push, node, n * sizeof *b->push);
    else
        memset(b->push, 0, n * sizeof *b->push);
    for (size_t i = n; i-- > 0;) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_disturbance x = { 0 };
        double down[6];
        if (source) source(ctx, b, i, &x);
        answer_down(p, &b->stage[i], &b->small[i], &x, b->push[i], y[i], stretch[i], down);
        if (p->parent >= 0)
            for (int c = 0; c < 6; c++) b->push[p->parent][c] += down[c];
        else
            ground_root(b, (size_t)p->row, down, root ? root[p->row] : NULL, out->ground);
    }
    for (size_t i = 0; i < n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        double end[6];
        const double *base = p->parent >= 0 ? y[p->parent] : b->root_change[p->row];
        answer_up(p, &b->stage[i], &b->answer[i], &b->small[i], base, y[i], stretch[i],
                  out->motion ? out->motion + 8 * i : NULL, end);
        memcpy(y[i], end, sizeof end); /* change of the element's end, the base of those above */
        if (out->ends) memcpy(out->ends[i], end, sizeof end);
    }
}

size_t wf_beam_motion_size(const struct wf_beam *b) { return b->mesh.n * (b->mesh.mass1 ? 11 : 8); }

/* Inertia of the motion `ctx` at the Gauss points. */
static void inertia_disturbance(const void *ctx, const struct wf_beam *b, size_t i,
                                struct wf_beam_disturbance *out)
{
    const double *motion = (const double *)ctx + 8 * i;
    const struct wf_beam_part *p = &b->mesh.part[i];
    for (int j = 0; j < 2; j++)
        for (int c = 0; c < 3; c++) {
            out->force[j][c] = p->line[j].mass * motion[4 * j + c];
            out->couple[j][c] = p->spin[j] * motion[4 * j + 3] * b->stage[i].t[j][c];
        }
}

void wf_beam_inertia_answer(struct wf_beam *b, const double *in, double *out, double (*node)[6],
                            double (*ends)[6])
{
    size_t n = b->mesh.n;
    struct wf_beam_small_answer x = { .motion = out, .ends = ends };
    for (size_t i = 0; b->mesh.mass1 && i < n; i++)
        for (size_t c = 0; c < 3; c++) {
            node[i][c] = b->mesh.mass1[i] * in[8 * n + 3 * i + c];
            node[i][3 + c] = 0;
        }
    wf_beam_answer_small(b, inertia_disturbance, in, b->mesh.mass1 ? (const double(*)[6])node : NULL, NULL,
                         &x);
    for (size_t i = 0; b->mesh.mass1 && i < n; i++) memcpy(out + 8 * n + 3 * i, ends[i], 3 * sizeof *out);
}

void wf_beam_motion_mass(const struct wf_beam *b, double *mass)
{
    size_t n = b->mesh.n;
    for (size_t i = 0; i < n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        for (size_t j = 0; j < 2; j++) {
            for (size_t c = 0; c < 3; c++) mass[8 * i + 4 * j + c] = 0.5 * p->h * p->line[j].mass;
            mass[8 * i + 4 * j + 3] = 0.5 * p->h * p->spin[j];
        }
        for (size_t c = 0; b->mesh.mass1 && c < 3; c++) mass[8 * n + 3 * i + c] = b->mesh.mass1[i];
    }
}
