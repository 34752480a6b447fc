/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_eliminate.h"
#include "solve/beam_condense.h"
#include "solve/beam_mesh.h"

/* One element: its position, its loads, its internal forces and its curvature. */

void wf_beam_place(const struct wf_beam_part *p, const struct wf_beam_shape *u,
                   const struct wf_beam_pose *base, struct wf_beam_stage *s, struct wf_beam_pose *end)
{
    place_element(p, u, base, s, end);
}

void wf_beam_turn(const struct wf_beam_shape *u, const double L[9], struct wf_beam_flat *flat)
{
    double R[9];
    for (int j = 0; j < 2; j++) {
        rotation_matrix(u->v[j], R);
        m3_apply(R, flat->across[j], flat->across[j]);
        m3_apply(L, flat->across[j], flat->across[j]);
    }
}

void wf_beam_couple(const struct wf_beam_flat *flat, double couple[2][3])
{
    memset(couple, 0, 2 * sizeof *couple);
    if (flat) side_couple(flat, couple);
}

void wf_beam_load(const struct wf_beam_part *p, const struct wf_loads *l, const struct wf_beam_stage *s,
                  struct wf_line_load load[2])
{
    for (int j = 0; j < 2; j++) {
        wf_load_on_line(l, &p->line[j], s->r[j], s->t[j], &load[j]);
        v3_add(load[j].force, l->point_scale, p->dead[j]);
    }
}

void wf_beam_balance(double h, const struct wf_beam_stage *s, const struct wf_beam_flat *flat,
                     const struct wf_line_load load[2], const struct wf_beam_wrench *end,
                     struct wf_beam_wrench at[2], struct wf_beam_wrench *base)
{
    balance_element(h, s, flat, load, end, at, base);
}

void wf_beam_curvature(const struct wf_beam_part *p, const struct wf_beam_shape *u, double k[2][3])
{
    curvature_of(p, u, k);
}

/* Its elimination. */

/* Solve for y = -A (p_base, 1). With `guard`, an element whose step is too large is taken by itself, with no
 * reaction on the part below (*apart). */
WF_INLINE bool solve_element(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                             const struct kinematics *k, const struct statics *q,
                             const struct wf_beam_stage *s, const struct wf_beam_wrench at[2],
                             const struct wf_beam_reaction *above, double P[6][6], by_base Z, by_base A,
                             bool guard, bool *apart, struct wf_beam_stability *count,
                             struct wf_beam_small *small)
{
    double S[6][6], Mn[2][9];
    *apart = false;
    element_equations(p, flat, k, q, s, at, 0, S, A, Mn);
    attach_part_above(Mn, above, P, Z, 0, S, A);
    if (small) invert6(S, small->R);
    if (count) count->negative += (size_t)unstable_directions(p, S, k, count->margin);
    bool solved = !solve6(S, A, 0);
    if (!guard || (solved && !leaps(A, P))) return solved;
    *apart = true;
    return !bend_apart(p, flat, k, s, at, 0, A);
}

WF_INLINE bool eliminate_either(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                                struct wf_beam_shape *u, const double L[9], const struct wf_beam_creep *creep,
                                const struct wf_beam_stage *s, const struct wf_line_load load[2],
                                const struct wf_beam_wrench at[2], struct wf_beam_reaction *node,
                                struct wf_beam_answer *o, struct wf_beam_reaction *below, bool guard,
                                struct wf_beam_stability *count, struct wf_beam_small *small)
{
    struct turns turns;
    struct kinematics k;
    struct statics q;
    double P[6][6], S[6][6];
    by_base y, Z, B;
    const double half = 0.5 * p->h;
    bool apart;
    turns_of(u, &turns);
    kinematics_of(p, u, &turns, L, s, creep, &k);
    stiffen_kinematics(&k, 1 + (creep ? creep->rate : 0) + element_damping(p, flat, &k, s, at));
    statics_of(p, flat, s, load, VARIES, at, &q);
    for (int j = 0; j < 2; j++) strain_of(p, L, s, at, j, u->g[j]);
    end_motion_of(half, &k, &q, 0, P, Z);
    base_wrench_of(half, &q, load, 0, S, B);
    if (!solve_element(p, flat, &k, &q, s, at, node, P, Z, y, guard, &apart, count, small)) return false;
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 8; c++) y[i][c] = -y[i][c];

    if (small) small_of(half, &q, at, node, P, S, small);
    follow_answer(half, &q, node, P, S, y, 0, Z, B);
    for (int i = 0; i < 6; i++) {
        for (int c = 0; c < 6; c++) o->X[i][c] = y[i][c], node->K[i][c] = Z[i][c];
        o->x[i] = y[i][6];
        node->k[i] = Z[i][6];
    }
    for (int i = 0; i < 6 && !apart; i++) {
        for (int c = 0; c < 6; c++) below->K[i][c] += B[i][c];
        below->k[i] += B[i][6];
    }
    return true;
}

/* Inlined twice; with flat == NULL the compiler drops the terms of non-round sections. */
WF_WIDE bool wf_beam_eliminate(const struct wf_beam_part *p, struct wf_beam_shape *u, const double L[9],
                               const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                               const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                               struct wf_beam_reaction *node, struct wf_beam_answer *o,
                               struct wf_beam_reaction *below, bool guard, struct wf_beam_stability *count,
                               struct wf_beam_small *small)
{
    return eliminate_either(p, NULL, u, L, creep, s, load, at, node, o, below, guard, count, small);
}

WF_WIDE bool wf_beam_eliminate_flat(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                                    struct wf_beam_shape *u, const double L[9],
                                    const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                                    const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                                    struct wf_beam_reaction *node, struct wf_beam_answer *o,
                                    struct wf_beam_reaction *below, bool guard,
                                    struct wf_beam_stability *count, struct wf_beam_small *small)
{
    return eliminate_either(p, flat, u, L, creep, s, load, at, node, o, below, guard, count, small);
}

void wf_beam_correct(const struct wf_beam_shape *u, const double L[9], const struct wf_beam_answer *o,
                     const struct wf_beam_reaction *node, const double p[6], double dv[2][3], double end[6])
{
    double y[6];
    for (int i = 0; i < 6; i++) {
        y[i] = o->x[i], end[i] = node->k[i];
        for (int c = 0; c < 6; c++) y[i] += o->X[i][c] * p[c], end[i] += node->K[i][c] * p[c];
    }
    for (int j = 0; j < 2; j++) {
        double local[3], Ti[9], x = wf_dot(u->v[j], u->v[j]);
        struct rotation r = rotation_of(x);
        m3_apply_transposed(L, y + 3 * j, local);
        rotation_tangent_inverse(&r, u->v[j], x, Ti);
        m3_apply(Ti, local, dv[j]);
    }
}

WF_INLINE void misfit_of(const struct wf_beam_part *p, const struct wf_beam_shape *u, const double L[9],
                         const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                         const struct wf_beam_flat *flat, const struct wf_beam_wrench at[2],
                         struct wf_beam_misfit *sum)
{
    double k[2][3], gap[2][3];
    struct beam_misfit here = { 0 };
    curvature_of(p, u, k);
    for (int j = 0; j < 2; j++) {
        m3_apply(L, k[j], k[j]);
        if (creep) add_creep(L, creep, j, k[j]);
        v3_add(k[j], 1, s->k0[j]);
    }
    gap_of(p, s, at, gap);
    misfit_add(p, flat, s, at, k, gap, &here);
    sum->bending += here.bending, sum->energy += here.energy;
    sum->turn = fmax(sum->turn, sqrt(here.turn)), sum->strain = fmax(sum->strain, sqrt(here.strain));
}

void wf_beam_misfit_add(const struct wf_beam_part *p, const struct wf_beam_shape *u, const double base_L[9],
                        const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                        const struct wf_beam_flat *flat, const struct wf_beam_wrench at[2],
                        struct wf_beam_misfit *sum)
{
    if (flat)
        misfit_of(p, u, base_L, creep, s, flat, at, sum);
    else
        misfit_of(p, u, base_L, creep, s, NULL, at, sum);
}
