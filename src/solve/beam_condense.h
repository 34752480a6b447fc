/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_CONDENSE_H
#define WF_SOLVE_BEAM_CONDENSE_H
/* Inlined parts of the elimination of an element, for one state or for many lanes (base/real.h). */
#include "solve/beam_kernel.h"
#include <stdbool.h>

/* Linearisation of one element and its elimination between its base and the part above.
 *
 * Spins at the Gauss points are q_j = q_0 + y_j (y: unknown, q_0: spin of the base). Exactly,
 *   dr'_j = Y_j q_j + H_j dn_end,                    Y = -[r'] + H [n]
 *   df_j  = sum_m F_jm q_m + A_j dr_0,               F_jm = B_j 1_jm + h up_jm A_j Y_m
 *   dn_j  = dn_end + sum_m N_jm q_m + A^n_j dr_0,    N = h down F,  A^n = h down A
 *   d(r' x n)_j = V_jm q_m + Vn_j dn_end + Vr_j dr_0,
 *   dm_j  = dm_end + h down (d(r' x n)),
 *   d(material law's moment)_j = G^-1 (Q_j y_j + sum_m slope_jm/h P_jm y_m + [G m - k0] y_j) - [m] q_j,
 * with A, B the load's derivatives by position and by rotation of the axis, T the tangent of the rotation
 * vector, Q = D T^-1, P_jm = T_j T_m^-1. The wrench of the end depends linearly on its motion through the
 * part above, dw = K p_end + k, so that six equations in the six y remain. */

/* A row per unknown, columns: the six of the base's change p, the constant of Newton's method, and that of
 * loads that grow (struct wf_beam_growth). */
enum { NOW = 6, TO_SIDE, BY_BASE };
typedef real by_base[6][BY_BASE];

/* The columns that count. Of a single state rows fill whole vector registers: the last columns may be spare.
 */
struct columns {
    int from, to;
    bool side; /* the last one counts */
};
WF_INLINE struct columns columns_of(int from, int to)
{
    return (struct columns){ from, WF_WIDTH == 1 ? BY_BASE : to, to > TO_SIDE };
}

/* Change of an element at its present shape where the loads grow. */
struct shift {
    real force[2][3]; /* given: of the load per length */
    real gap[2][3];   /* of the strain, by `force` and the part above */
    real turn[2][3];  /* of r' x n, by `force` */
};

WF_INLINE void shift_of(const element *p, const struct wf_beam_stage *s, const struct wf_beam_wrench at[2],
                        const struct wf_beam_reaction *above, struct shift *o)
{
    for (int j = 0; j < 2; j++) {
        const fixed d0 = p->h * gauss_down[j][0], d1 = p->h * gauss_down[j][1];
        real own[3], all[3], give[3], back[3];
        for (int i = 0; i < 3; i++)
            own[i] = d0 * o->force[0][i] + d1 * o->force[1][i], all[i] = own[i] + above->side[i];
        v3_section(real_of(p->cs[j]), real_of(p->ca[j]), s->t[j], own, give);
        v3_section(real_of(p->cs[j]), real_of(p->ca[j]), s->t[j], all, o->gap[j]);
        wf_cross(s->rp[j], own, o->turn[j]);
        wf_cross(at[j].n, give, back);
        for (int i = 0; i < 3; i++) o->turn[j][i] -= back[i];
    }
}

/* Where the loads vary with the height alone, a displacement along x or y changes nothing, and the columns of
 * these two are left out: `from` is the first column that counts, 0 or 2. */
WF_INLINE int first_column(enum variation kind) { return kind == VARIES ? 0 : 2; }

WF_INLINE void put6(real A[6][6], int row, int col, const real B[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) A[row + i][col + j] = B[3 * i + j];
}

WF_INLINE void put_by_base(by_base A, int from, int row, int col, const real B[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (col + j >= from) A[row + i][col + j] = B[3 * i + j];
}

/* S y + A (p_base, 1) = 0 for the element without the part above, whose reaction enters through Mn: dn_end
 * -> dm_j. shift NULL: the loads do not grow. */
WF_INLINE void element_equations(const element *p, const struct wf_beam_flat *flat,
                                 const struct kinematics *k, const struct statics *q,
                                 const struct wf_beam_stage *s, const struct wf_beam_wrench at[2],
                                 const struct shift *shift, int from, real S[6][6], by_base A, real Mn[2][9])
{
    for (int j = 0; j < 2; j++) {
        real law[3], bent[3], M[2][9], G[9], C[9], R[9];
        const fixed d0 = p->h * gauss_down[j][0], d1 = p->h * gauss_down[j][1];
        law_hold(p, flat, s, j, k->k[j], law);
        for (int m = 0; m < 2; m++)
            for (int i = 0; i < 9; i++) M[m][i] = d0 * q->V[0][m][i] + d1 * q->V[1][m][i];
        /* rotation of the section: d(G^-1) k = -[m] q + G^-1 [k] q, evaluated with the curvature k = G m - k0
         * of the present moment */
        law_give(p, flat, s, j, at[j].m, bent);
        for (int i = 0; i < 3; i++) bent[i] -= s->k0[j][i];
        m3_zero(C);
        m3_add_cross(C, real_of(-1), at[j].m);
        for (int i = 0; i < 9; i++) R[i] = C[i] - M[0][i] - M[1][i];
        put_by_base(A, from, 3 * j, 3, R);
        m3_zero(G);
        m3_add_cross(G, real_of(1), bent);
        m3_add(G, real_of(1), k->QP[j][j]);
        law_hold_mul(p, flat, s, j, G, C);
        m3_add(C, real_of(-1), M[j]);
        put6(S, 3 * j, 3 * j, C);
        for (int i = 0; i < 9; i++) C[i] = -M[1 - j][i];
        law_hold_mul(p, flat, s, j, k->QP[j][1 - j], C);
        put6(S, 3 * j, 3 - 3 * j, C);
        for (int i = 0; i < 9; i++) R[i] = -d0 * q->Vr[0][i] - d1 * q->Vr[1][i];
        put_by_base(A, from, 3 * j, 0, R);
        for (int i = 0; i < 9; i++) Mn[j][i] = d0 * q->Vn[0][i] + d1 * q->Vn[1][i];
        for (int i = 0; i < 3; i++) {
            A[3 * j + i][NOW] = law[i] - at[j].m[i] - d0 * q->Vc[0][i] - d1 * q->Vc[1][i];
            A[3 * j + i][TO_SIDE] = shift ? -d0 * shift->turn[0][i] - d1 * shift->turn[1][i] : real_of(0);
        }
    }
}

/* Exchange row c with the row below it whose number in column c is `most`, in the lanes `here`. */
WF_INLINE void exchange_rows(real S[6][6], by_base B, struct columns b, int c, real_truth here, real most)
{
    for (int r = c + 1; r < 6; r++) {
        real_truth swap = here & real_not_above(most, real_abs(S[r][c]));
        here &= ~swap;
        for (int k = c; k < 6; k++) {
            real upper = S[c][k];
            S[c][k] = real_choose(swap, S[r][k], upper), S[r][k] = real_choose(swap, upper, S[r][k]);
        }
        for (int k = b.from; k < b.to; k++) {
            real upper = B[c][k];
            B[c][k] = real_choose(swap, B[r][k], upper), B[r][k] = real_choose(swap, upper, B[r][k]);
        }
    }
}

/* B := S^-1 B by elimination; S is used up. Rows are exchanged, in each lane by itself, where the pivot is
 * less than a tenth of a number below it. Returned: lanes whose S is singular. */
WF_INLINE real_truth solve6(real S[6][6], by_base B, struct columns b)
{
    real_truth singular = { 0 };
    for (int c = 0; c < 6; c++) {
        real most = { 0 }, pivot = real_abs(S[c][c]);
        for (int r = c + 1; r < 6; r++) most = real_max(real_abs(S[r][c]), most);
        real_truth small = real_below(pivot, 0.1 * most);
        if (__builtin_expect(real_any(small), 0)) exchange_rows(S, B, b, c, small, most);
        singular |= ~real_below(real_of(0), real_max(pivot, most));
        real inverse = 1 / S[c][c];
        S[c][c] = inverse;
        for (int r = c + 1; r < 6; r++) {
            real f = S[r][c] * inverse;
            for (int k = c + 1; k < 6; k++) S[r][k] -= f * S[c][k];
            for (int k = b.from; k < b.to; k++) B[r][k] -= f * B[c][k];
        }
    }
    for (int c = 6; c-- > 0;)
        for (int k = b.from; k < b.to; k++) {
            real sum = B[c][k];
            for (int r = c + 1; r < 6; r++) sum -= S[c][r] * B[r][k];
            B[c][k] = sum * S[c][c];
        }
    return singular;
}

/* Number of directions in which the element is unstable: S in terms of strains is S B^-1 with B =
 * d(curvature)/dy; its negative pivots are counted. For conservative loads S B^-1 is symmetric, to the order
 * of the mesh error, and they are its negative eigenvalues; for other loads their number changes where the
 * tree loses its static stability. (The symmetric part alone would also count shapes that are nearly free to
 * rotate.) Returned: the number, per lane. */
WF_INLINE real unstable_directions(const element *p, real S[6][6], const struct kinematics *k, real margin)
{
    real B[6][6], H[6][6], negative = { 0 }, limit = -margin * larger(p->ei[0], p->gj[0]);
    by_base X; /* B' X = S', so that X' = S B^-1 */
    for (int j = 0; j < 2; j++)
        for (int m = 0; m < 2; m++)
            for (int i = 0; i < 3; i++)
                for (int c = 0; c < 3; c++) B[3 * m + c][3 * j + i] = k->QP[j][m][3 * i + c];
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < BY_BASE; c++) X[i][c] = c < 6 ? S[c][i] : real_of(0);
    real_truth singular = solve6(B, X, columns_of(0, NOW));
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) H[i][c] = X[c][i];
    for (int c = 0; c < 6; c++) {
        negative += real_choose(real_below(H[c][c], limit), real_of(1), real_of(0));
        real inverse = 1 / H[c][c];
        for (int r = c + 1; r < 6; r++) {
            real f = H[r][c] * inverse;
            for (int i = c; i < 6; i++) H[r][i] -= f * H[c][i];
        }
    }
    return real_choose(singular, real_of(0), negative);
}

/* C += A B from that row of C and that column of A on */
WF_INLINE void add_product(real A[6][6], by_base B, struct columns b, int row, int column, by_base C)
{
    for (int i = row; i < 6; i++) {
        real sum[BY_BASE];
        for (int c = b.from; c < b.to; c++) sum[c] = C[i][c];
        for (int m = column; m < 6; m++)
            for (int c = b.from; c < b.to; c++) sum[c] += A[i][m] * B[m][c];
        for (int c = b.from; c < b.to; c++) C[i][c] = sum[c];
    }
}

/* end = P y + Z (p_base, 1):  dr = dr_0 + h/2 sum (Y q + gap), spin = q_0 + sum W y */
WF_INLINE void end_motion_of(fixed half, const struct kinematics *k, const struct statics *q,
                             const struct shift *shift, struct columns b, real P[6][6], by_base Z)
{
    for (int i = 0; i < 6; i++)
        for (int c = b.from; c < b.to; c++) Z[i][c] = real_of(i == c);
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            for (int m = 0; m < 2; m++) {
                P[i][3 * m + c] = half * q->Y[m][3 * i + c];
                P[3 + i][3 * m + c] = k->W[m][3 * i + c];
            }
            Z[i][3 + c] = P[i][c] + P[i][3 + c];
        }
        Z[i][NOW] = half * (q->gap[0][i] + q->gap[1][i]);
        if (shift) Z[i][TO_SIDE] = half * (shift->gap[0][i] + shift->gap[1][i]);
    }
}

/* dw_base = dw_end + (0, Vn dn_end) + S y + B (p_base, 1): dn = h/2 sum df, dm = h/2 sum d(r' x n) */
WF_INLINE void base_wrench_of(fixed half, const struct statics *q, const struct real_load load[2],
                              const struct shift *shift, struct columns b, real S[6][6], by_base B)
{
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            for (int m = 0; m < 2; m++) {
                S[i][3 * m + c] = half * (q->F[0][m][3 * i + c] + q->F[1][m][3 * i + c]);
                S[3 + i][3 * m + c] = half * (q->V[0][m][3 * i + c] + q->V[1][m][3 * i + c]);
            }
            if (c >= b.from) {
                B[i][c] = half * (load[0].by_place[3 * i + c] + load[1].by_place[3 * i + c]);
                B[3 + i][c] = half * (q->Vr[0][3 * i + c] + q->Vr[1][3 * i + c]);
            }
            B[i][3 + c] = S[i][c] + S[i][3 + c];
            B[3 + i][3 + c] = S[3 + i][c] + S[3 + i][3 + c];
        }
        for (int c = NOW; c < b.to; c++) B[i][c] = B[3 + i][c] = real_of(0);
        B[3 + i][NOW] = half * (q->Vc[0][i] + q->Vc[1][i]);
        if (!shift) continue;
        B[i][TO_SIDE] = half * (shift->force[0][i] + shift->force[1][i]);
        B[3 + i][TO_SIDE] = half * (shift->turn[0][i] + shift->turn[1][i]);
    }
}

/* Row i of K and of the constants. */
WF_INLINE real above_of(const struct wf_beam_reaction *above, int i, int c)
{
    return c < NOW ? above->K[i][c] : c == NOW ? above->k[i] : above->side[i];
}

/* Add the reaction of the part above, dw_end = K end + k, end = P y + Z (p_base, 1), to the element's own
 * equations: dm_j gains Mn_j dn_end + dm_end. */
WF_INLINE void attach_part_above(real Mn[2][9], const struct wf_beam_reaction *above, real P[6][6], by_base Z,
                                 struct columns b, real S[6][6], by_base A)
{
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++) {
            real EK[BY_BASE], *row = S[3 * j + i], *a = A[3 * j + i];
            for (int c = b.from; c < b.to; c++)
                EK[c] = -above_of(above, 3 + i, c) - Mn[j][3 * i] * above_of(above, 0, c) -
                        Mn[j][3 * i + 1] * above_of(above, 1, c) - Mn[j][3 * i + 2] * above_of(above, 2, c);
            for (int m = b.from; m < 6; m++)
                for (int c = 0; c < 6; c++) row[c] += EK[m] * P[m][c];
            for (int c = b.from; c < b.to; c++) a[c] += EK[c]; /* Z = (1 X g; 0 1 0), X, g from column 3 on */
            for (int m = b.from; m < 3; m++)
                for (int c = 3; c < b.to; c++) a[c] += EK[m] * Z[m][c];
        }
}

/* Would the linear step throw this element (and all above it) far beyond where linearisation holds? Either
 * its own correction at a fixed base is large, or its end rotates against its base (below -1: it is beyond
 * its buckling load) or many times as far as its base (it is near its buckling load). Such a step would also
 * throw the parts below. P: spin of the end by y; A: solved. Returned: lanes in which it would. */
WF_INLINE real_truth leaps(by_base A, real P[6][6])
{
    const double turn = 0.7, against = -1.1, along = 8; /* rad, -, - */
    real_truth holds = ~(real_truth){ 0 };
    for (int i = 0; i < 6; i++) holds &= real_not_above(real_abs(A[i][NOW]), real_of(turn));
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            real follows = { 0 };
            for (int m = 0; m < 6; m++) follows -= P[3 + i][m] * A[m][3 + j];
            holds &=
                real_below(real_of(i == j ? against : -along), follows) & real_below(follows, real_of(along));
        }
    return ~holds;
}

/* An element whose step is too large is taken by itself: damped elastic bending towards its present moments,
 * rigidly following its base. Twigs beyond their buckling load thus fall over in a few iterations without
 * disturbing what carries them. */
WF_INLINE real_truth bend_apart(const element *p, const struct wf_beam_flat *flat, const struct kinematics *k,
                                const struct wf_beam_stage *s, const struct wf_beam_wrench at[2],
                                struct columns b, by_base A)
{
    static const struct statics none;
    real S[6][6], Mn[2][9];
    element_equations(p, flat, k, &none, s, at, NULL, b.from, S, A, Mn);
    for (int i = 0; i < 6; i++)
        for (int c = b.from; c < NOW; c++) A[i][c] = real_of(0);
    return solve6(S, A, b);
}

/* Motion of the end, end = Z (p_base, 1), and wrench on the base, B (p_base, 1), of an element that moves by
 * y. Given: Z, B at y = 0. */
WF_INLINE void follow_answer(fixed half, const struct statics *q, struct wf_beam_reaction *above,
                             real P[6][6], real S[6][6], by_base y, struct columns b, by_base Z, by_base B)
{
    by_base W;
    add_product(P, y, b, b.from, 0, Z); /* rows left out of Z are columns left out of K */
    for (int i = 0; i < 6; i++)
        for (int c = b.from; c < b.to; c++) W[i][c] = c < NOW ? real_of(0) : above_of(above, i, c);
    add_product(above->K, Z, b, 0, b.from, W); /* dw_end = W (p, 1) */
    add_product(S, y, b, 0, 0, B);
    for (int i = 0; i < 3; i++)
        for (int m = 0; m < 3; m++) {
            real f = half * (q->Vn[0][3 * i + m] + q->Vn[1][3 * i + m]);
            for (int c = b.from; c < b.to; c++) B[3 + i][c] += f * W[m][c];
        }
    for (int i = 0; i < 6; i++)
        for (int c = b.from; c < b.to; c++) B[i][c] += W[i][c];
}
/* R = S^-1; 0 in lanes whose S is singular. */
WF_INLINE void invert6(real S[6][6], real R[6][6])
{
    real copy[6][6];
    by_base B;
    memcpy(copy, S, sizeof copy);
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < BY_BASE; c++) B[i][c] = real_of(i == c);
    real_truth singular = solve6(copy, B, columns_of(0, NOW));
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) R[i][c] = real_choose(singular, real_of(0), B[i][c]);
}

/* Factors of struct wf_beam_small but R. S: base wrench by y, without the part above. */
WF_INLINE void small_of(fixed half, const struct statics *q, const struct wf_beam_wrench at[2],
                        const struct wf_beam_reaction *above, real P[6][6], real S[6][6],
                        struct wf_beam_small *o)
{
    real KP[6][6];
    memcpy(o->P, P, sizeof o->P);
    memcpy(o->Vn, q->Vn, sizeof o->Vn);
    memcpy(o->Y, q->Y, sizeof o->Y);
    for (int j = 0; j < 2; j++) memcpy(o->n[j], at[j].n, sizeof o->n[j]);
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) {
            KP[i][c] = real_of(0);
            for (int m = 0; m < 6; m++) KP[i][c] += above->K[i][m] * P[m][c];
            o->T[i][c] = S[i][c] + KP[i][c];
        }
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 6; c++)
            for (int m = 0; m < 3; m++)
                o->T[3 + i][c] += half * (q->Vn[0][3 * i + m] + q->Vn[1][3 * i + m]) * KP[m][c];
}
#endif
