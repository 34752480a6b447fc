/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_KERNEL_H
#define WF_SOLVE_BEAM_KERNEL_H
/* Inlined parts of the element: the section law, and the derivatives within one element. */
#include "base/vec3.h"
#include "solve/beam_element.h"

/* Section law in bending and torsion. flat NULL (a constant where these are inlined) means a round
 * section. */

/* y = G^-1 x: moment of a curvature */
WF_INLINE void law_hold(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                        const struct wf_beam_stage *s, int j, const double x[3], double y[3])
{
    double more = flat ? flat->more[j] * wf_dot(flat->across[j], x) : 0;
    v3_section(p->ei[j], p->gj[j], s->t[j], x, y);
    if (flat) v3_add(y, more, flat->across[j]);
}

/* y = G x: curvature of a moment */
WF_INLINE void law_give(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                        const struct wf_beam_stage *s, int j, const double x[3], double y[3])
{
    double more = flat ? flat->give[j] * wf_dot(flat->across[j], x) : 0;
    v3_section(1 / p->ei[j], 1 / p->gj[j], s->t[j], x, y);
    if (flat) v3_add(y, more, flat->across[j]);
}

/* C += G^-1 B */
WF_INLINE void law_hold_mul(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                            const struct wf_beam_stage *s, int j, const double B[9], double C[9])
{
    m3_add_section_mul(C, p->ei[j], p->gj[j], s->t[j], B);
    if (!flat) return;
    double row[3];
    m3_apply_transposed(B, flat->across[j], row);
    m3_add_outer(C, flat->more[j], flat->across[j], row);
}

/* Derivatives within one element, inlined into its elimination (beam_eliminate.c states the equations):
 * curvature and end by the spins at the Gauss points; loads and r' x n by spins, end force and base. */

struct kinematics {
    double k[2][3];     /* curvature of the material law, creep included */
    double QP[2][2][9]; /* y -> change of curvature */
    double W[2][9];     /* y -> spin of the end, relative to the base */
};

/* Damping of one element, whose tangent is stiffened in proportion to the rotation its material law residual
 * asks for. Twigs that bend double then do not shorten the Newton step of the whole tree. The damping goes
 * to zero with the residual, at the same rate, so that convergence remains quadratic. */
WF_INLINE double element_damping(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                                 const struct kinematics *c, const struct wf_beam_stage *s,
                                 const struct wf_beam_wrench at[2])
{
    const double free_turn = 0.05,
                 full_turn =
                     0.25; /* [rad]: rotation without damping; further rotation that halves the step */
    double most = 0;
    for (int j = 0; j < 2; j++) {
        double miss[3];
        law_give(p, flat, s, j, at[j].m, miss);
        v3_add(miss, -1, c->k[j]);
        most = fmax(most, wf_dot(miss, miss));
    }
    return fmax(0, (p->h * sqrt(most) - free_turn) / full_turn);
}

WF_INLINE void stiffen_kinematics(struct kinematics *c, double factor)
{
    for (int j = 0; j < 2; j++)
        for (int m = 0; m < 2; m++)
            for (int i = 0; i < 9; i++) c->QP[j][m][i] *= factor;
}

WF_INLINE void kinematics_of(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                             const struct wf_beam_shape *u, const double L[9],
                             const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                             const struct wf_beam_wrench at[2], struct kinematics *c)
{
    double v[2][3], T[2][9], Ti[2][9], D[9], end[3], Te[9], x;
    for (int j = 0; j < 2; j++) m3_apply(L, u->v[j], v[j]);
    for (int i = 0; i < 3; i++) end[i] = gauss_end[0] * v[0][i] + gauss_end[1] * v[1][i];
    for (int j = 0; j < 2; j++) {
        double slope[3], Tslope[3], old[3];
        x = wf_dot(v[j], v[j]);
        struct rotation o = rotation_of(x);
        for (int i = 0; i < 3; i++)
            slope[i] = (gauss_slope[j][0] * v[0][i] + gauss_slope[j][1] * v[1][i]) / p->h;
        rotation_tangent(&o, v[j], x, T[j]);
        rotation_tangent_inverse(&o, v[j], x, Ti[j]);
        rotation_tangent_slope(&o, v[j], slope, D);
        m3_mul(D, Ti[j], c->QP[j][j]);
        for (int i = 0; i < 3; i++) c->QP[j][j][4 * i] += gauss_slope[j][j] / p->h;
        m3_apply(T[j], slope, Tslope);
        m3_apply(L, creep->k0[j], old);
        for (int i = 0; i < 3; i++) c->k[j][i] = (1 + creep->rate) * Tslope[i] - creep->rate * old[i];
    }
    x = wf_dot(end, end);
    struct rotation o = rotation_of(x);
    rotation_tangent(&o, end, x, Te);
    for (int j = 0; j < 2; j++) {
        m3_mul(T[j], Ti[1 - j], c->QP[j][1 - j]);
        for (int i = 0; i < 9; i++) c->QP[j][1 - j][i] *= gauss_slope[j][1 - j] / p->h;
        m3_mul(Te, Ti[j], c->W[j]);
        for (int i = 0; i < 9; i++) c->W[j][i] *= gauss_end[j];
    }
    stiffen_kinematics(c, 1 + creep->rate + element_damping(p, flat, c, s, at));
}

/* Derivatives of the loads and of r' x n inside the element. */
struct statics {
    double Y[2][9];                /* spin -> dr' */
    double F[2][2][9], V[2][2][9]; /* spin at m -> df_j, d(r' x n)_j */
    double Vn[2][9], Vr[2][9];     /* dn_end, dr_0 -> d(r' x n)_j */
    double gap[2][3];              /* strain residual H n - g */
    double Vc[2][3];               /* its part of d(r' x n)_j */
};

/* The moment of off-axis weight rotates with the section: d(o x f) = f x (o x q) = (o f' - f.o) q. */
WF_INLINE void add_side_weight(const struct wf_beam_flat *flat, int j, double V[9])
{
    double offset[3] = { 0, 0, 0 }, force[3] = { 0, 0, -flat->weight };
    v3_add(offset, flat->side[j], flat->across[j]);
    m3_add_outer(V, 1, offset, force);
    for (int i = 0; i < 3; i++) V[4 * i] -= wf_dot(force, offset);
}

WF_INLINE void statics_of(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                          struct wf_beam_shape *u, const double L[9], const struct wf_beam_stage *s,
                          const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                          struct statics *c)
{
    memset(c, 0, sizeof *c);
    for (int j = 0; j < 2; j++) {
        double strain[3], tn[3];
        v3_section(p->cs[j], p->ca[j], s->t[j], at[j].n, strain);
        for (int i = 0; i < 3; i++) c->gap[j][i] = strain[i] + s->t[j][i] - s->rp[j][i];
        m3_apply_transposed(L, strain, u->g[j]);
        wf_cross(s->t[j], at[j].n, tn);
        m3_add_cross(c->Y[j], -1, s->rp[j]);
        m3_add_cross(c->Y[j], p->cs[j], at[j].n); /* H [n] = cs [n] + (ca - cs) t (t x n)' */
        m3_add_outer(c->Y[j], p->ca[j] - p->cs[j], s->t[j], tn);
        m3_add_cross(c->Vn[j], 1, s->rp[j]); /* [r'] - [n] H,  [n] H = cs [n] - (ca - cs) (t x n) t' */
        m3_add_cross(c->Vn[j], -p->cs[j], at[j].n);
        m3_add_outer(c->Vn[j], p->ca[j] - p->cs[j], tn, s->t[j]);
        double turn[3];
        wf_cross(at[j].n, c->gap[j], turn);
        for (int i = 0; i < 3; i++) c->Vc[j][i] = -turn[i];
    }
    for (int j = 0; j < 2; j++)
        for (int m = 0; m < 2; m++) {
            m3_mul(load[j].by_place, c->Y[m], c->F[j][m]);
            for (int i = 0; i < 9; i++)
                c->F[j][m][i] = p->h * gauss_up[j][m] * c->F[j][m][i] + (j == m ? load[j].by_turn[i] : 0);
        }
    for (int j = 0; j < 2; j++) {
        double N[9];
        for (int m = 0; m < 2; m++) {
            for (int i = 0; i < 9; i++)
                N[i] = p->h * (gauss_down[j][0] * c->F[0][m][i] + gauss_down[j][1] * c->F[1][m][i]);
            m3_add_cross_mul(c->V[j][m], 1, s->rp[j], N);
        }
        m3_add_cross_mul(c->V[j][j], -1, at[j].n, c->Y[j]);
        if (flat) add_side_weight(flat, j, c->V[j][j]);
        for (int i = 0; i < 9; i++)
            N[i] = p->h * (gauss_down[j][0] * load[0].by_place[i] + gauss_down[j][1] * load[1].by_place[i]);
        m3_add_cross_mul(c->Vr[j], 1, s->rp[j], N);
    }
}
#endif
