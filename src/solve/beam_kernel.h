/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_KERNEL_H
#define WF_SOLVE_BEAM_KERNEL_H
/* Inlined parts of the element, for one state or for many lanes (base/real.h): the section law, position,
 * balance, residual, and the derivatives within one element. */
#include "base/vec3.h"
#include "load/line_load.h"
#include "solve/beam_element.h"

/* The constants of an element: doubles, which all lanes share where these are states of one element; of each
 * lane its own where the lanes are elements of one state (WF_ELEMENTS_ABREAST). */
#ifdef WF_ELEMENTS_ABREAST
typedef real fixed;
struct fixed_point {
    real diameter, drag, lift, sail, mass;
};
typedef struct { /* struct wf_beam_part from h on */
    real h, t[2][3], ei[2], gj[2], ca[2], cs[2], spin[2];
    struct fixed_point line[2];
    real dead[2][3], k0[2][3], g0[2][3];
} element;
WF_INLINE int any_positive(fixed x) { return real_any(real_below(real_of(0), x)); }
WF_INLINE fixed larger(fixed a, fixed b) { return real_max(a, b); }
#else
typedef double fixed;
typedef struct wf_beam_part element;
WF_INLINE int any_positive(fixed x) { return x > 0; }
WF_INLINE fixed larger(fixed a, fixed b) { return a > b ? a : b; }
#endif

/* Section law in bending and torsion. flat NULL (a constant where these are inlined) means a round
 * section. */

/* y = G^-1 x: moment of a curvature */
WF_INLINE void law_hold(const element *p, const struct wf_beam_flat *flat,
                        const struct wf_beam_stage *s, int j, const real x[3], real y[3])
{
    real more = flat ? flat->more[j] * wf_dot(flat->across[j], x) : real_of(0);
    v3_section(real_of(p->ei[j]), real_of(p->gj[j]), s->t[j], x, y);
    if (flat) v3_add(y, more, flat->across[j]);
}

/* y = G x: curvature of a moment */
WF_INLINE void law_give(const element *p, const struct wf_beam_flat *flat,
                        const struct wf_beam_stage *s, int j, const real x[3], real y[3])
{
    real more = flat ? flat->give[j] * wf_dot(flat->across[j], x) : real_of(0);
    v3_section(real_of(1 / p->ei[j]), real_of(1 / p->gj[j]), s->t[j], x, y);
    if (flat) v3_add(y, more, flat->across[j]);
}

/* C += G^-1 B */
WF_INLINE void law_hold_mul(const element *p, const struct wf_beam_flat *flat,
                            const struct wf_beam_stage *s, int j, const real B[9], real C[9])
{
    m3_add_section_mul(C, real_of(p->ei[j]), real_of(p->gj[j]), s->t[j], B);
    if (!flat) return;
    real row[3];
    m3_apply_transposed(B, flat->across[j], row);
    m3_add_outer(C, flat->more[j], flat->across[j], row);
}

/* Coefficients of the element's three rotations: to its Gauss points and to its end. */
struct turns {
    real x[2], x_end; /* squares of the angles */
    real end[3];      /* rotation vector of the end */
    struct rotation at[2], to_end;
};

WF_INLINE void turns_of(const struct wf_beam_shape *u, struct turns *o)
{
    for (int j = 0; j < 2; j++) o->x[j] = wf_dot(u->v[j], u->v[j]), o->at[j] = rotation_of(o->x[j]);
    for (int i = 0; i < 3; i++) o->end[i] = gauss_end[0] * u->v[0][i] + gauss_end[1] * u->v[1][i];
    o->x_end = wf_dot(o->end, o->end);
    o->to_end = rotation_of(o->x_end);
}

/* R(v) x for the rotation of a vector v of square length x2 */
WF_INLINE void rotate(const struct rotation *o, const real v[3], real x2, const real x[3], real y[3])
{
    real across[3], s = 1 - x2 * o->b, d = 1 - x2 * o->a, along = o->a * wf_dot(v, x);
    wf_cross(v, x, across);
    for (int i = 0; i < 3; i++) y[i] = d * x[i] + s * across[i] + along * v[i];
}

/* A vector fixed to the section at Gauss point j, of an element whose base is rotated by L: `local` in the
 * axes of the base, `out` in global ones. */
WF_INLINE void turn_with_section(const struct wf_beam_shape *u, const struct turns *o, const real L[9], int j,
                                 const fixed x[3], real local[3], real out[3])
{
    real given[3];
    for (int i = 0; i < 3; i++) given[i] = real_of(x[i]);
    rotate(&o->at[j], u->v[j], o->x[j], given, local);
    m3_apply(L, local, out);
}

/* Tangent, r' and state at rest at Gauss point j of an element whose base is rotated by L. */
WF_INLINE void axis_of(const element *p, const struct wf_beam_shape *u, const struct turns *o,
                       const real L[9], int j, struct wf_beam_stage *s)
{
    real local[3];
    turn_with_section(u, o, L, j, p->k0[j], local, s->k0[j]);
    turn_with_section(u, o, L, j, p->g0[j], local, s->g0[j]);
    turn_with_section(u, o, L, j, p->t[j], local, s->t[j]);
    for (int i = 0; i < 3; i++) local[i] += u->g[j][i];
    m3_apply(L, local, s->rp[j]);
}

/* State at the Gauss points, from the unknowns and the pose of the base. */
WF_INLINE void stage_of(const element *p, const struct wf_beam_shape *u, const struct turns *o,
                        const struct wf_beam_pose *base, struct wf_beam_stage *s)
{
    for (int j = 0; j < 2; j++) axis_of(p, u, o, base->L, j, s);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 2; j++)
            s->r[j][i] =
                base->r[i] + (p->h * gauss_up[j][0]) * s->rp[0][i] + (p->h * gauss_up[j][1]) * s->rp[1][i];
}

WF_INLINE void end_rotation(const struct turns *o, const real base_L[9], real L[9])
{
    real s = 1 - o->x_end * o->to_end.b, R[9];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) R[3 * i + j] = (o->to_end.a * o->end[i]) * o->end[j];
    for (int i = 0; i < 3; i++) R[4 * i] += 1 - o->x_end * o->to_end.a;
    m3_add_cross(R, s, o->end);
    m3_mul(base_L, R, L);
}

/* Pose of the end. */
WF_INLINE void end_of(const element *p, const struct wf_beam_shape *u, const struct turns *o,
                      const struct wf_beam_pose *base, struct wf_beam_pose *end)
{
    real sum[3], rise[3];
    for (int j = 0; j < 2; j++) {
        real unloaded[3], local[3];
        for (int i = 0; i < 3; i++) unloaded[i] = real_of(p->t[j][i]);
        rotate(&o->at[j], u->v[j], o->x[j], unloaded, local);
        for (int i = 0; i < 3; i++) local[i] += u->g[j][i], sum[i] = j ? sum[i] + local[i] : local[i];
    }
    m3_apply(base->L, sum, rise);
    for (int i = 0; i < 3; i++) end->r[i] = base->r[i] + 0.5 * p->h * rise[i];
    end_rotation(o, base->L, end->L);
}

/* Both, from the base up. */
WF_INLINE void place_element(const element *p, const struct wf_beam_shape *u,
                             const struct wf_beam_pose *base, struct wf_beam_stage *s,
                             struct wf_beam_pose *end)
{
    struct turns o;
    turns_of(u, &o);
    stage_of(p, u, &o, base, s);
    for (int i = 0; i < 3; i++) end->r[i] = base->r[i] + 0.5 * p->h * (s->rp[0][i] + s->rp[1][i]);
    end_rotation(&o, base->L, end->L);
}

/* Moment of the off-axis weight about the axis, per length [N m/m]: side across x (0, 0, -weight). */
WF_INLINE void side_couple(const struct wf_beam_flat *flat, real couple[2][3])
{
    for (int j = 0; j < 2; j++) {
        real moment = flat->side[j] * flat->weight;
        couple[j][0] = -moment * flat->across[j][1];
        couple[j][1] = moment * flat->across[j][0];
        couple[j][2] = real_of(0);
    }
}

/* Internal forces at the Gauss points and the base, from those at the end, by balance. h: length [m]; flat
 * NULL: round section. */
WF_INLINE void balance_element(fixed h, const struct wf_beam_stage *s, const struct wf_beam_flat *flat,
                               const struct real_load load[2], const struct wf_beam_wrench *end,
                               struct wf_beam_wrench at[2], struct wf_beam_wrench *base)
{
    real turn[2][3], couple[2][3];
    if (flat) side_couple(flat, couple);
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 3; i++)
            at[j].n[i] =
                end->n[i] + h * (gauss_down[j][0] * load[0].force[i] + gauss_down[j][1] * load[1].force[i]);
        wf_cross(s->rp[j], at[j].n, turn[j]);
        if (flat) v3_add(turn[j], real_of(1), couple[j]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 2; j++)
            at[j].m[i] = end->m[i] + h * (gauss_down[j][0] * turn[0][i] + gauss_down[j][1] * turn[1][i]);
        base->n[i] = end->n[i] + 0.5 * h * (load[0].force[i] + load[1].force[i]);
        base->m[i] = end->m[i] + 0.5 * h * (turn[0][i] + turn[1][i]);
    }
}

/* Curvature change k at the Gauss points in base axes [1/m]. */
WF_INLINE void curvature_of(const element *p, const struct wf_beam_shape *u, real k[2][3])
{
    for (int j = 0; j < 2; j++) {
        real slope[3], once[3], twice[3], x = wf_dot(u->v[j], u->v[j]);
        struct rotation o = rotation_of(x);
        const fixed by[2] = { gauss_slope[j][0] / p->h, gauss_slope[j][1] / p->h };
        for (int i = 0; i < 3; i++) slope[i] = by[0] * u->v[0][i] + by[1] * u->v[1][i];
        wf_cross(u->v[j], slope, once);
        wf_cross(u->v[j], once, twice);
        for (int i = 0; i < 3; i++) k[j][i] = slope[i] + o.a * once[i] + o.b * twice[i];
    }
}

/* k += rate (k - k0), with the k0 of the creep */
WF_INLINE void add_creep(const real L[9], const struct wf_beam_creep *creep, int j, real k[3])
{
    real old[3];
    m3_apply(L, creep->k0[j], old);
    for (int i = 0; i < 3; i++) k[i] = (1 + creep->rate) * k[i] - creep->rate * old[i];
}

/* Residual of the material law, summed over the elements, with the scales it is compared with (struct
 * wf_beam_misfit). */
struct beam_misfit {
    real bending, energy, strain, turn; /* strain and turn squared */
};

/* Given: curvature k of the material law and strain residual `gap` of the element, global axes. */
WF_INLINE void misfit_add(const element *p, const struct wf_beam_flat *flat,
                          const struct wf_beam_stage *s, const struct wf_beam_wrench at[2], real k[2][3],
                          real gap[2][3], struct beam_misfit *sum)
{
    const double slight = 1e-3; /* times n h: lower bound of the moment the error is measured against */
    for (int j = 0; j < 2; j++) {
        real miss[3], work[3], strain[3];
        const fixed least = slight * slight * p->h * p->h * (1 / p->ei[j]);
        law_give(p, flat, s, j, at[j].m, work);
        for (int i = 0; i < 3; i++)
            miss[i] = k[j][i] - work[i], strain[i] = gap[j][i] + s->rp[j][i] - s->t[j][i] + s->g0[j][i];
        sum->energy += 0.25 * p->h * (wf_dot(work, at[j].m) + least * wf_dot(at[j].n, at[j].n));
        sum->turn = real_max(sum->turn, p->h * p->h * wf_dot(work, work));
        law_hold(p, flat, s, j, miss, work);
        sum->bending += 0.25 * p->h * wf_dot(work, miss);
        sum->turn = real_max(sum->turn, wf_dot(strain, strain));
        sum->strain = real_max(sum->strain, wf_dot(gap[j], gap[j]));
    }
}

/* Strain H n - g0 at a Gauss point, in the axes that rotate with the base. */
WF_INLINE void strain_of(const element *p, const real L[9], const struct wf_beam_stage *s,
                         const struct wf_beam_wrench at[2], int j, real g[3])
{
    real strain[3];
    v3_section(real_of(p->cs[j]), real_of(p->ca[j]), s->t[j], at[j].n, strain);
    for (int i = 0; i < 3; i++) strain[i] -= s->g0[j][i];
    m3_apply_transposed(L, strain, g);
}

/* Strain residual H n - g0 - g at the Gauss points. */
WF_INLINE void gap_of(const element *p, const struct wf_beam_stage *s,
                      const struct wf_beam_wrench at[2], real gap[2][3])
{
    for (int j = 0; j < 2; j++) {
        v3_section(real_of(p->cs[j]), real_of(p->ca[j]), s->t[j], at[j].n, gap[j]);
        for (int i = 0; i < 3; i++) gap[j][i] += (s->t[j][i] - s->rp[j][i]) - s->g0[j][i];
    }
}

/* Derivatives within one element, inlined into its elimination (beam_eliminate.c states the equations):
 * curvature and end by the spins at the Gauss points; loads and r' x n by spins, end force and base. */

struct kinematics {
    real k[2][3];     /* curvature of the material law, creep and state at rest included */
    real QP[2][2][9]; /* y -> change of curvature */
    real W[2][9];     /* y -> spin of the end, relative to the base */
};

/* Damping of one element, whose tangent is stiffened in proportion to the rotation its material law residual
 * asks for. Twigs that bend double then do not shorten the Newton step of the whole tree. The damping goes
 * to zero with the residual, at the same rate, so that convergence remains quadratic. */
WF_INLINE real element_damping(const element *p, const struct wf_beam_flat *flat,
                               const struct kinematics *c, const struct wf_beam_stage *s,
                               const struct wf_beam_wrench at[2])
{
    const double free_turn = 0.05,
                 full_turn =
                     0.25; /* [rad]: rotation without damping; further rotation that halves the step */
    real most = { 0 };
    for (int j = 0; j < 2; j++) {
        real miss[3];
        law_give(p, flat, s, j, at[j].m, miss);
        v3_add(miss, real_of(-1), c->k[j]);
        most = real_max(most, wf_dot(miss, miss));
    }
    return real_max(real_of(0), (p->h * real_sqrt(most) - free_turn) * (1 / full_turn));
}

WF_INLINE void stiffen_kinematics(struct kinematics *c, real factor)
{
    for (int j = 0; j < 2; j++)
        for (int m = 0; m < 2; m++)
            for (int i = 0; i < 9; i++) c->QP[j][m][i] *= factor;
}

WF_INLINE void kinematics_of(const element *p, const struct wf_beam_shape *u,
                             const struct turns *o, const real L[9], const struct wf_beam_stage *s,
                             const struct wf_beam_creep *creep, struct kinematics *c)
{
    const fixed per = 1 / p->h;
    real v[2][3], T[2][9], Ti[2][9], D[9], end[3], Te[9];
    for (int j = 0; j < 2; j++) m3_apply(L, u->v[j], v[j]);
    m3_apply(L, o->end, end);
    for (int j = 0; j < 2; j++) {
        real slope[3];
        for (int i = 0; i < 3; i++)
            slope[i] = (gauss_slope[j][0] * per) * v[0][i] + (gauss_slope[j][1] * per) * v[1][i];
        rotation_tangent(&o->at[j], v[j], o->x[j], T[j]);
        rotation_tangent_inverse(&o->at[j], v[j], o->x[j], Ti[j]);
        rotation_tangent_slope(&o->at[j], v[j], slope, D);
        m3_mul(D, Ti[j], c->QP[j][j]);
        for (int i = 0; i < 3; i++) c->QP[j][j][4 * i] += gauss_slope[j][j] * per;
        m3_apply(T[j], slope, c->k[j]);
        if (creep) add_creep(L, creep, j, c->k[j]);
        for (int i = 0; i < 3; i++) c->k[j][i] += s->k0[j][i];
    }
    rotation_tangent(&o->to_end, end, o->x_end, Te);
    for (int j = 0; j < 2; j++) {
        m3_mul(T[j], Ti[1 - j], c->QP[j][1 - j]);
        for (int i = 0; i < 9; i++) c->QP[j][1 - j][i] *= gauss_slope[j][1 - j] * per;
        m3_mul(Te, Ti[j], c->W[j]);
        for (int i = 0; i < 9; i++) c->W[j][i] *= gauss_end[j];
    }
}

/* Derivatives of the loads and of r' x n inside the element. */
struct statics {
    real Y[2][9];                /* spin -> dr' */
    real F[2][2][9], V[2][2][9]; /* spin at m -> df_j, d(r' x n)_j */
    real Vn[2][9], Vr[2][9];     /* dn_end, dr_0 -> d(r' x n)_j */
    real gap[2][3];              /* strain residual H n - g0 - g */
    real Vc[2][3];               /* its part of d(r' x n)_j */
};

/* The moment of off-axis weight rotates with the section: d(o x f) = f x (o x q) = (o f' - f.o) q. */
WF_INLINE void add_side_weight(const struct wf_beam_flat *flat, int j, real V[9])
{
    real offset[3] = { real_of(0), real_of(0), real_of(0) },
         force[3] = { real_of(0), real_of(0), -flat->weight };
    v3_add(offset, flat->side[j], flat->across[j]);
    m3_add_outer(V, real_of(1), offset, force);
    for (int i = 0; i < 3; i++) V[4 * i] -= wf_dot(force, offset);
}

/* How the load varies with position. */
enum variation {
    VARIES_NOT,
    VARIES_UPWARDS, /* with the height alone: the third column of by_place */
    VARIES
};

/* C = B Y for a load's derivative B by position. */
WF_INLINE void by_place_mul(enum variation kind, const real B[9], const real Y[9], real C[9])
{
    if (kind == VARIES) m3_mul(B, Y, C);
    for (int i = 0; i < 9 && kind != VARIES; i++)
        C[i] = kind == VARIES_UPWARDS ? B[3 * (i / 3) + 2] * Y[6 + i % 3] : real_of(0);
}

/* dr' and d(r' x n) by spins and by the force of the end. */
WF_INLINE void stretch_statics(const element *p, const struct wf_beam_stage *s,
                               const struct wf_beam_wrench at[2], struct statics *c)
{
    for (int j = 0; j < 2; j++) {
        const fixed more = p->ca[j] - p->cs[j];
        real tn[3], turn[3];
        wf_cross(s->t[j], at[j].n, tn);
        for (int i = 0; i < 3; i++)
            for (int m = 0; m < 3; m++) {
                c->Y[j][3 * i + m] = more * s->t[j][i] * tn[m]; /* H [n] = cs [n] + (ca - cs) t (t x n)' */
                c->Vn[j][3 * m + i] = more * s->t[j][i] * tn[m];
            }
        m3_add_cross(c->Y[j], real_of(-1), s->rp[j]);
        m3_add_cross(c->Vn[j], real_of(1),
                     s->rp[j]); /* [r'] - [n] H,  [n] H = cs [n] - (ca - cs) (t x n) t' */
        if (any_positive(p->cs[j])) {
            m3_add_cross(c->Y[j], real_of(p->cs[j]), at[j].n);
            m3_add_cross(c->Vn[j], real_of(-p->cs[j]), at[j].n);
        }
        wf_cross(at[j].n, c->gap[j], turn);
        for (int i = 0; i < 3; i++) c->Vc[j][i] = -turn[i];
    }
}

WF_INLINE void statics_of(const element *p, const struct wf_beam_flat *flat,
                          const struct wf_beam_stage *s, const struct real_load load[2], enum variation kind,
                          const struct wf_beam_wrench at[2], struct statics *c)
{
    gap_of(p, s, at, c->gap);
    stretch_statics(p, s, at, c);
    for (int j = 0; j < 2; j++)
        for (int m = 0; m < 2; m++) {
            const fixed up = p->h * gauss_up[j][m];
            by_place_mul(kind, load[j].by_place, c->Y[m], c->F[j][m]);
            for (int i = 0; i < 9; i++) {
                if (kind != VARIES_NOT) c->F[j][m][i] *= up;
                if (j == m) c->F[j][m][i] += load[j].by_turn[i];
            }
        }
    for (int j = 0; j < 2; j++) {
        const fixed d0 = p->h * gauss_down[j][0], d1 = p->h * gauss_down[j][1];
        real N[9];
        for (int m = 0; m < 2; m++) {
            for (int i = 0; i < 9; i++) N[i] = d0 * c->F[0][m][i] + d1 * c->F[1][m][i];
            m3_cross_mul(s->rp[j], N, c->V[j][m]);
        }
        m3_add_cross_mul(c->V[j][j], real_of(-1), at[j].n, c->Y[j]);
        if (flat) add_side_weight(flat, j, c->V[j][j]);
        for (int i = 0; i < 9; i++) {
            int none = kind == VARIES_NOT || (kind == VARIES_UPWARDS && i % 3 < 2);
            N[i] = none ? real_of(0) : d0 * load[0].by_place[i] + d1 * load[1].by_place[i];
        }
        m3_cross_mul(s->rp[j], N, c->Vr[j]);
    }
}
#endif
