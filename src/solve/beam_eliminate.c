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

/* Change of the element where the loads grow; none where they do not. */
WF_INLINE void take_shift(const struct wf_beam_part *p, const double L[9], const struct wf_beam_stage *s,
                          const struct wf_beam_wrench at[2], const struct wf_beam_reaction *above,
                          const struct wf_beam_also *also, struct shift *o)
{
    *o = (struct shift){ 0 };
    if (!also->change) return;
    memcpy(o->force, also->change, sizeof o->force);
    shift_of(p, s, at, above, o);
    for (int j = 0; j < 2; j++) m3_apply_transposed(L, o->gap[j], also->side->g[j]);
}

/* Solve for y = -A (p_base, 1). Where guarded, an element whose step is too large is taken by itself, with no
 * reaction on the part below (*apart). */
WF_INLINE bool solve_element(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                             const struct kinematics *k, const struct statics *q,
                             const struct wf_beam_stage *s, const struct wf_beam_wrench at[2],
                             const struct wf_beam_reaction *above, const struct shift *shift, double P[6][6],
                             by_base Z, by_base A, struct wf_beam_also *also, bool *apart)
{
    const struct columns b = columns_of(0, BY_BASE);
    double S[6][6], Mn[2][9];
    *apart = false;
    element_equations(p, flat, k, q, s, at, shift, 0, S, A, Mn);
    attach_part_above(Mn, above, P, Z, b, S, A);
    if (also->small) invert6(S, also->small->R);
    if (also->count) also->count->negative += (size_t)unstable_directions(p, S, k, also->count->margin);
    bool solved = !solve6(S, A, b);
    if (!also->guard || (solved && !leaps(A, P))) return solved;
    *apart = also->apart = true;
    return !bend_apart(p, flat, k, s, at, b, A);
}

WF_INLINE bool eliminate_either(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                                struct wf_beam_shape *u, const double L[9], const struct wf_beam_creep *creep,
                                const struct wf_beam_stage *s, const struct wf_line_load load[2],
                                const struct wf_beam_wrench at[2], struct wf_beam_reaction *node,
                                struct wf_beam_answer *o, struct wf_beam_reaction *below,
                                struct wf_beam_also *also)
{
    const struct columns b = columns_of(0, BY_BASE);
    struct turns turns;
    struct kinematics k;
    struct statics q;
    struct shift shift;
    double P[6][6], S[6][6];
    by_base y, Z, B;
    const double half = 0.5 * p->h;
    bool apart;
    turns_of(u, &turns);
    kinematics_of(p, u, &turns, L, s, creep, &k);
    stiffen_kinematics(&k, 1 + (creep ? creep->rate : 0) + element_damping(p, flat, &k, s, at));
    statics_of(p, flat, s, load, VARIES, at, &q);
    take_shift(p, L, s, at, node, also, &shift);
    for (int j = 0; j < 2; j++) strain_of(p, L, s, at, j, u->g[j]);
    end_motion_of(half, &k, &q, &shift, b, P, Z);
    base_wrench_of(half, &q, load, &shift, b, S, B);
    if (!solve_element(p, flat, &k, &q, s, at, node, &shift, P, Z, y, also, &apart)) return false;
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < BY_BASE; c++) y[i][c] = -y[i][c];

    if (also->small) small_of(half, &q, at, node, P, S, also->small);
    follow_answer(half, &q, node, P, S, y, b, Z, B);
    for (int i = 0; i < 6; i++) {
        for (int c = 0; c < 6; c++) o->X[i][c] = y[i][c], node->K[i][c] = Z[i][c];
        o->x[i] = y[i][NOW], o->side[i] = y[i][TO_SIDE];
        node->k[i] = Z[i][NOW], node->side[i] = Z[i][TO_SIDE];
    }
    for (int i = 0; i < 6 && !apart; i++) {
        for (int c = 0; c < 6; c++) below->K[i][c] += B[i][c];
        below->k[i] += B[i][NOW], below->side[i] += B[i][TO_SIDE];
    }
    return true;
}

/* Inlined twice; with flat == NULL the compiler drops the terms of non-round sections. */
WF_WIDE bool wf_beam_eliminate(const struct wf_beam_part *p, struct wf_beam_shape *u, const double L[9],
                               const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                               const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                               struct wf_beam_reaction *node, struct wf_beam_answer *o,
                               struct wf_beam_reaction *below, struct wf_beam_also *also)
{
    return eliminate_either(p, NULL, u, L, creep, s, load, at, node, o, below, also);
}

WF_WIDE bool wf_beam_eliminate_flat(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                                    struct wf_beam_shape *u, const double L[9],
                                    const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                                    const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                                    struct wf_beam_reaction *node, struct wf_beam_answer *o,
                                    struct wf_beam_reaction *below, struct wf_beam_also *also)
{
    return eliminate_either(p, flat, u, L, creep, s, load, at, node, o, below, also);
}

/* Changes of the unknowns and of the end, by that of the base and constants x, k. */
static void correct(const struct wf_beam_shape *u, const double L[9], const double X[6][6], const double x[6],
                    const double K[6][6], const double k[6], const double p[6], double dv[2][3],
                    double end[6])
{
    double y[6];
    for (int i = 0; i < 6; i++) {
        y[i] = x[i], end[i] = k[i];
        for (int c = 0; c < 6; c++) y[i] += X[i][c] * p[c], end[i] += K[i][c] * p[c];
    }
    for (int j = 0; j < 2; j++) {
        double local[3], Ti[9], square = wf_dot(u->v[j], u->v[j]);
        struct rotation r = rotation_of(square);
        m3_apply_transposed(L, y + 3 * j, local);
        rotation_tangent_inverse(&r, u->v[j], square, Ti);
        m3_apply(Ti, local, dv[j]);
    }
}

void wf_beam_correct(const struct wf_beam_shape *u, const double L[9], const struct wf_beam_answer *o,
                     const struct wf_beam_reaction *node, const double p[6], double dv[2][3], double end[6])
{
    correct(u, L, o->X, o->x, node->K, node->k, p, dv, end);
}

void wf_beam_correct_side(const struct wf_beam_shape *u, const double L[9], const struct wf_beam_answer *o,
                          const struct wf_beam_reaction *node, const double p[6], double dv[2][3],
                          double end[6])
{
    correct(u, L, o->X, o->side, node->K, node->side, p, dv, end);
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
