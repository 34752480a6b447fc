/* Sweeps over all elements: a parent always stands before its children, so one loop up and one loop down. */
#include "solve/beam_newton.h"
#include "solve/vec.h"
#include <float.h>

const struct wf_beam_pose *wf_beam_base(const struct wf_beam *b, size_t i, struct wf_beam_pose *ground)
{
    const struct wf_tree *t = b->mesh.tree;
    const struct wf_beam_part *p = &b->mesh.part[i];
    if (p->parent >= 0) return &b->pose[p->parent];
    ground->r[0] = t->x0[p->row], ground->r[1] = t->y0[p->row], ground->r[2] = t->z0[p->row];
    rotation_matrix(b->tilt[p->row], ground->L);
    return ground;
}

void wf_beam_sweep_up(struct wf_beam *b)
{
    struct wf_beam_pose ground;
    for (size_t i = 0; i < b->mesh.n; i++)
        wf_beam_place(&b->mesh.part[i], &b->shape[i], wf_beam_base(b, i, &ground), &b->stage[i], &b->pose[i]);
    for (size_t i = 0; b->flat && i < b->mesh.n; i++) {
        b->flat[i] = b->mesh.flat[i];
        wf_beam_turn(&b->shape[i], wf_beam_base(b, i, &ground)->L, &b->flat[i]);
    }
}

/* The weight of what hangs to one side, as the loads are scaled now. */
static void weigh(struct wf_beam *b)
{
    for (size_t i = 0; b->flat && i < b->mesh.n; i++)
        b->flat[i].weight = b->loads.weight_scale * b->loads.gravity;
}

static bool eliminate(struct wf_beam *b, size_t i, const double L[9], const struct wf_beam_creep *creep,
                      const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                      struct wf_beam_reaction *below, bool guard, struct wf_beam_stability *count)
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    struct wf_beam_small *small = b->small ? &b->small[i] : NULL;
    if (b->flat)
        return wf_beam_eliminate_flat(p, &b->flat[i], &b->shape[i], L, creep, &b->stage[i], load, at,
                                      &b->node[i], &b->answer[i], below, guard, count, small);
    return wf_beam_eliminate(p, &b->shape[i], L, creep, &b->stage[i], load, at, &b->node[i], &b->answer[i],
                             below, guard, count, small);
}

/* Loads that act at element ends: point masses, dead and follower forces and moments. */
static void load_nodes(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    memset(b->wrench, 0, b->mesh.n * sizeof *b->wrench);
    if (b->mesh.mass1)
        for (size_t i = 0; i < b->mesh.n; i++)
            b->wrench[i].n[2] -= l->weight_scale * l->gravity * b->mesh.mass1[i];
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *q = &l->point[k];
        size_t i = (size_t)b->mesh.last[q->segment];
        double f[3], m[3];
        memcpy(f, q->force, sizeof f), memcpy(m, q->moment, sizeof m);
        if (q->kind == WF_POINT_FOLLOWER) m3_apply(b->pose[i].L, f, f), m3_apply(b->pose[i].L, m, m);
        v3_add(b->wrench[i].n, l->point_scale, f);
        v3_add(b->wrench[i].m, l->point_scale, m);
    }
}

/* Follower loads turn with their section: dn = spin x n. */
static void react_nodes(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    memset(b->node, 0, b->mesh.n * sizeof *b->node);
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *q = &l->point[k];
        if (q->kind != WF_POINT_FOLLOWER || b->frozen) continue;
        size_t i = (size_t)b->mesh.last[q->segment];
        double f[3], m[3], N[9] = { 0 }, M[9] = { 0 };
        m3_apply(b->pose[i].L, q->force, f), m3_apply(b->pose[i].L, q->moment, m);
        m3_add_cross(N, -l->point_scale, f), m3_add_cross(M, -l->point_scale, m);
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                b->node[i].K[r][3 + c] += N[3 * r + c];
                b->node[i].K[3 + r][3 + c] += M[3 * r + c];
            }
    }
}

/* The root plate: springs c about x and y hold the tilt v against the moment, c v = T' m (stiffness 0 =
 * clamped). Adds the plate's misfit; with the reaction r of the tree on it, works out its correction, how it
 * gives, and whether it is stable. */
static void tilt_root(struct wf_beam *b, size_t row, const struct wf_beam_wrench *w,
                      const struct wf_beam_reaction *r, struct wf_beam_stability *count)
{
    const double *c = b->options->root_stiffness, *v = b->tilt[row], still[3] = { 0 };
    const double rate = b->creep, *v0 = rate > 0 ? b->tilt0[row] : still;
    double x = wf_dot(v, v), T[9], m[3], inverse[9] = { 0 }, *p = b->root_change[row];
    memset(p, 0, 6 * sizeof *p);
    if (!(c[0] > 0) && !(c[1] > 0)) return;
    struct rotation o = rotation_of(x);
    rotation_tangent(&o, v, x, T);
    m3_apply_transposed(T, w->m, m);
    for (int j = 0; j < 2; j++)
        if (c[j] > 0) {
            double miss = c[j] * ((1 + rate) * v[j] - rate * v0[j]) - m[j];
            b->misfit.bending += 0.5 * miss * miss / c[j];
            b->misfit.energy += 0.5 * m[j] * m[j] / c[j];
        }
    if (!r) return;
    double K[9], KT[9], Tt[9], TKT[9], D[9], step[9], k[3], push[3];
    const double back[3] = { -v[0], -v[1], -v[2] };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) K[3 * i + j] = r->K[3 + i][3 + j], Tt[3 * i + j] = T[3 * j + i];
    m3_mul(K, T, KT);
    m3_mul(Tt, KT, TKT);
    rotation_tangent_slope(&o, back, w->m, D); /* T(v)' = T(-v): d(T' m)/dv = -D */
    double S[2][2] = { { (1 + rate) * c[0] - TKT[0] + D[0], D[1] - TKT[1] },
                       { D[3] - TKT[3], (1 + rate) * c[1] - TKT[4] + D[4] } };
    for (int j = 0; j < 2; j++) /* no spring: clamped about that axis */
        if (!(c[j] > 0)) S[j][j] = INFINITY, S[0][1] = S[1][0] = 0;
    double rest = S[1][1] - S[1][0] * (S[0][1] / S[0][0]), across = S[0][1] / S[0][0] / rest;
    if (count)
        count->negative += (size_t)(S[0][0] < -count->margin * c[0]) + (size_t)(rest < -count->margin * c[1]);
    inverse[0] = (1 + across * S[1][0]) / S[0][0], inverse[1] = -across;
    inverse[3] = -S[1][0] / S[0][0] / rest, inverse[4] = 1 / rest;
    m3_apply_transposed(T, r->k + 3, k);
    for (int j = 0; j < 3; j++) push[j] = j < 2 ? k[j] + m[j] - c[j] * ((1 + rate) * v[j] - rate * v0[j]) : 0;
    m3_apply(inverse, push, b->root_step[row]);
    m3_apply(T, b->root_step[row], p + 3);
    m3_mul(T, inverse, step);
    m3_mul(step, Tt, b->root_give[row]);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 3; j++) b->root_hold[row][i][j] = r->K[i][3 + j];
}

bool wf_beam_sweep_down(struct wf_beam *b, bool tangent, struct wf_beam_stability *count)
{
    static const double still[2][3];
    struct wf_beam_pose ground;
    double first[3] = { 0, 0, 0 };
    /* far from equilibrium the tangent is guarded; nearer it is exact */
    bool guard = !count && b->misfit.bending > 1e-3 * b->misfit.energy;
    b->misfit = (struct wf_beam_misfit){ 0 };
    if (count) count->negative = 0, count->bears = 0;
    b->base = (struct wf_beam_wrench){ { 0 }, { 0 } };
    load_nodes(b);
    weigh(b);
    if (tangent) react_nodes(b);
    memcpy(first, wf_beam_base(b, 0, &ground)->r, sizeof first);
    for (size_t i = b->mesh.n; i-- > 0;) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
        const struct wf_beam_flat *flat = wf_beam_flat_of(b, i);
        struct wf_beam_creep creep = { b->creep, b->creep > 0 ? (const double(*)[3])b->k0[i] : still };
        struct wf_line_load load[2];
        struct wf_beam_wrench at[2], down;
        struct wf_beam_reaction root = { { { 0 } }, { 0 } };
        bool grounded = p->parent < 0;
        wf_beam_load(p, &b->loads, &b->stage[i], load);
        for (int j = 0; j < 2 && b->frozen; j++)
            memset(load[j].by_place, 0, sizeof load[j].by_place),
                memset(load[j].by_turn, 0, sizeof load[j].by_turn);
        wf_beam_balance(p->h, &b->stage[i], flat, load, &b->wrench[i], at, &down);
        wf_beam_misfit_add(p, &b->shape[i], base->L, &creep, &b->stage[i], flat, at, &b->misfit);
        size_t unstable = count ? count->negative : 0;
        if (tangent &&
            !eliminate(b, i, base->L, &creep, load, at, grounded ? &root : &b->node[p->parent], guard, count))
            return false;
        if (count && count->negative > unstable)
            count->bears = fmax(count->bears, sqrt(wf_dot(down.n, down.n)));
        if (!grounded) {
            v3_add(b->wrench[p->parent].n, 1, down.n);
            v3_add(b->wrench[p->parent].m, 1, down.m);
            continue;
        }
        double arm[3] = { base->r[0] - first[0], base->r[1] - first[1], base->r[2] - first[2] }, lever[3];
        wf_cross(arm, down.n, lever);
        v3_add(b->base.n, 1, down.n);
        v3_add(b->base.m, 1, down.m);
        v3_add(b->base.m, 1, lever);
        unstable = count ? count->negative : 0;
        tilt_root(b, (size_t)p->row, &down, tangent ? &root : NULL, count);
        if (count && count->negative > unstable) count->bears = INFINITY;
    }
    return isfinite(b->misfit.bending);
}
