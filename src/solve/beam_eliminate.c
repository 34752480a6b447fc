/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_eliminate.h"
#include "solve/beam_kernel.h"
#include "solve/beam_mesh.h"

/* Linearisation of one element and its elimination between its base and the part above.
 *
 * Spins at the Gauss points are q_j = q_0 + y_j (y: unknown, q_0: spin of the base). Exactly,
 *   dr'_j = Y_j q_j + H_j dn_end,                    Y = -[r'] + H [n]
 *   df_j  = sum_m F_jm q_m + A_j dr_0,               F_jm = B_j 1_jm + h up_jm A_j Y_m
 *   dn_j  = dn_end + sum_m N_jm q_m + A^n_j dr_0,    N = h down F,  A^n = h down A
 *   d(r' x n)_j = V_jm q_m + Vn_j dn_end + Vr_j dr_0,
 *   dm_j  = dm_end + h down (d(r' x n)),
 *   d(material law's moment)_j = G^-1 (Q_j y_j + sum_m slope_jm/h P_jm y_m + [G m] y_j) - [m] q_j,
 * with A, B the load's derivatives by position and by rotation of the axis, T the tangent of the rotation
 * vector, Q = D T^-1, P_jm = T_j T_m^-1. The wrench of the end depends linearly on its motion through the
 * part above, dw = K p_end + k, so that six equations in the six y remain. */

/* A row per unknown, columns: the six of the base's change p, one constant, one spare column, so that rows
 * fill whole vector registers. */
typedef double by_base[6][8];

static inline void put6(double A[6][6], int row, int col, const double B[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) A[row + i][col + j] = B[3 * i + j];
}

static inline void put8(by_base A, int row, int col, const double B[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) A[row + i][col + j] = B[3 * i + j];
}

/* S y + A (p_base, 1) = 0 for the element without the part above, whose reaction enters through Mn: dn_end
 * -> dm_j. */
WF_INLINE void element_equations(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                                 const struct kinematics *k, const struct statics *q,
                                 const struct wf_beam_stage *s, const struct wf_beam_wrench at[2],
                                 double S[6][6], by_base A, double Mn[2][9])
{
    for (int j = 0; j < 2; j++) {
        double law[3], bent[3], M[2][9], G[9], C[9], R[9];
        const double d0 = p->h * gauss_down[j][0], d1 = p->h * gauss_down[j][1];
        law_hold(p, flat, s, j, k->k[j], law);
        for (int m = 0; m < 2; m++)
            for (int i = 0; i < 9; i++) M[m][i] = d0 * q->V[0][m][i] + d1 * q->V[1][m][i];
        /* rotation of the section: d(G^-1) k = -[m] q + G^-1 [G m] q, evaluated with the curvature G m of
         * the present moment */
        law_give(p, flat, s, j, at[j].m, bent);
        memset(C, 0, sizeof C);
        m3_add_cross(C, -1, at[j].m);
        for (int i = 0; i < 9; i++) R[i] = C[i] - M[0][i] - M[1][i];
        put8(A, 3 * j, 3, R);
        memset(G, 0, sizeof G);
        m3_add_cross(G, 1, bent);
        m3_add(G, 1, k->QP[j][j]);
        law_hold_mul(p, flat, s, j, G, C);
        m3_add(C, -1, M[j]);
        put6(S, 3 * j, 3 * j, C);
        for (int i = 0; i < 9; i++) C[i] = -M[1 - j][i];
        law_hold_mul(p, flat, s, j, k->QP[j][1 - j], C);
        put6(S, 3 * j, 3 - 3 * j, C);
        for (int i = 0; i < 9; i++) R[i] = -d0 * q->Vr[0][i] - d1 * q->Vr[1][i];
        put8(A, 3 * j, 0, R);
        for (int i = 0; i < 9; i++) Mn[j][i] = d0 * q->Vn[0][i] + d1 * q->Vn[1][i];
        for (int i = 0; i < 3; i++) {
            A[3 * j + i][6] = law[i] - at[j].m[i] - d0 * q->Vc[0][i] - d1 * q->Vc[1][i];
            A[3 * j + i][7] = 0;
        }
    }
}

/* B := S^-1 B by elimination with row exchanges; S is used up. false when S is singular. */
WF_INLINE bool solve6(double S[6][6], by_base B)
{
    for (int c = 0; c < 6; c++) {
        int best = c;
        for (int r = c + 1; r < 6; r++)
            if (fabs(S[r][c]) > fabs(S[best][c])) best = r;
        if (!(fabs(S[best][c]) > 0)) return false;
        if (best != c) {
            double row[8];
            memcpy(row, S[c], sizeof S[c]), memcpy(S[c], S[best], sizeof S[c]),
                memcpy(S[best], row, sizeof S[c]);
            memcpy(row, B[c], sizeof B[c]), memcpy(B[c], B[best], sizeof B[c]),
                memcpy(B[best], row, sizeof B[c]);
        }
        double inverse = 1 / S[c][c];
        S[c][c] = inverse;
        for (int r = c + 1; r < 6; r++) {
            double f = S[r][c] * inverse;
            for (int k = c + 1; k < 6; k++) S[r][k] -= f * S[c][k];
            for (int k = 0; k < 8; k++) B[r][k] -= f * B[c][k];
        }
    }
    for (int c = 6; c-- > 0;) {
        double sum[8];
        for (int k = 0; k < 8; k++) sum[k] = B[c][k];
        for (int r = c + 1; r < 6; r++)
            for (int k = 0; k < 8; k++) sum[k] -= S[c][r] * B[r][k];
        for (int k = 0; k < 8; k++) B[c][k] = sum[k] * S[c][c];
    }
    return true;
}

/* Number of directions in which the element is unstable: S in terms of strains is S B^-1 with B =
 * d(curvature)/dy; its negative pivots are counted. For conservative loads S B^-1 is symmetric, to the order
 * of the mesh error, and they are its negative eigenvalues; for other loads their number changes where the
 * tree loses its static stability. (The symmetric part alone would also count shapes that are nearly free to
 * rotate.) */
static size_t unstable_directions(const struct wf_beam_part *p, double S[6][6], const struct kinematics *k,
                                  double margin)
{
    double B[6][6], H[6][6];
    by_base X; /* B' X = S', so that X' = S B^-1 */
    size_t negative = 0;
    for (int j = 0; j < 2; j++)
        for (int m = 0; m < 2; m++)
            for (int i = 0; i < 3; i++)
                for (int c = 0; c < 3; c++) B[3 * m + c][3 * j + i] = k->QP[j][m][3 * i + c];
    for (int i = 0; i < 6; i++) {
        for (int c = 0; c < 6; c++) X[i][c] = S[c][i];
        X[i][6] = X[i][7] = 0;
    }
    if (!solve6(B, X)) return 0;
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) H[i][c] = X[c][i];
    for (int c = 0; c < 6; c++) {
        if (H[c][c] < -margin * fmax(p->ei[0], p->gj[0])) negative++;
        for (int r = c + 1; r < 6; r++) {
            double f = H[r][c] / H[c][c];
            for (int i = c; i < 6; i++) H[r][i] -= f * H[c][i];
        }
    }
    return negative;
}

/* C += A B */
WF_INLINE void add_product(double A[6][6], by_base B, by_base C)
{
    for (int i = 0; i < 6; i++) {
        double sum[8];
        for (int c = 0; c < 8; c++) sum[c] = C[i][c];
        for (int m = 0; m < 6; m++)
            for (int c = 0; c < 8; c++) sum[c] += A[i][m] * B[m][c];
        for (int c = 0; c < 8; c++) C[i][c] = sum[c];
    }
}

/* end = P y + Z (p_base, 1):  dr = dr_0 + h/2 sum (Y q + gap), spin = q_0 + sum W y */
WF_INLINE void end_motion_of(double half, const struct kinematics *k, const struct statics *q, double P[6][6],
                             by_base Z)
{
    memset(Z, 0, sizeof(by_base));
    for (int i = 0; i < 6; i++) Z[i][i] = 1;
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            for (int m = 0; m < 2; m++) {
                P[i][3 * m + c] = half * q->Y[m][3 * i + c];
                P[3 + i][3 * m + c] = k->W[m][3 * i + c];
            }
            Z[i][3 + c] = P[i][c] + P[i][3 + c];
        }
        Z[i][6] = half * (q->gap[0][i] + q->gap[1][i]);
    }
}

/* dw_base = dw_end + (0, Vn dn_end) + S y + B (p_base, 1): dn = h/2 sum df, dm = h/2 sum d(r' x n) */
WF_INLINE void base_wrench_of(double half, const struct statics *q, const struct wf_line_load load[2],
                              double S[6][6], by_base B)
{
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            for (int m = 0; m < 2; m++) {
                S[i][3 * m + c] = half * (q->F[0][m][3 * i + c] + q->F[1][m][3 * i + c]);
                S[3 + i][3 * m + c] = half * (q->V[0][m][3 * i + c] + q->V[1][m][3 * i + c]);
            }
            B[i][c] = half * (load[0].by_place[3 * i + c] + load[1].by_place[3 * i + c]);
            B[3 + i][c] = half * (q->Vr[0][3 * i + c] + q->Vr[1][3 * i + c]);
            B[i][3 + c] = S[i][c] + S[i][3 + c];
            B[3 + i][3 + c] = S[3 + i][c] + S[3 + i][3 + c];
        }
        B[i][6] = B[i][7] = B[3 + i][7] = 0;
        B[3 + i][6] = half * (q->Vc[0][i] + q->Vc[1][i]);
    }
}

/* Add the reaction of the part above, dw_end = K end + k, end = P y + Z (p_base, 1), to the element's own
 * equations: dm_j gains Mn_j dn_end + dm_end. */
WF_INLINE void attach_part_above(double Mn[2][9], const struct wf_beam_reaction *above, double P[6][6],
                                 by_base Z, double S[6][6], by_base A)
{
    double answer[6][8], EK[6][8];
    for (int i = 0; i < 6; i++) {
        memcpy(answer[i], above->K[i], sizeof above->K[i]);
        answer[i][6] = above->k[i], answer[i][7] = 0;
    }
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++)
            for (int c = 0; c < 8; c++)
                EK[3 * j + i][c] = -answer[3 + i][c] - Mn[j][3 * i] * answer[0][c] -
                                   Mn[j][3 * i + 1] * answer[1][c] - Mn[j][3 * i + 2] * answer[2][c];
    for (int i = 0; i < 6; i++) {
        for (int m = 0; m < 6; m++)
            for (int c = 0; c < 6; c++) S[i][c] += EK[i][m] * P[m][c];
        A[i][6] += EK[i][6];
    }
    for (int i = 0; i < 6; i++) { /* Z = (1 X g; 0 1 0), X and g in columns 3 to 6 */
        for (int c = 0; c < 6; c++) A[i][c] += EK[i][c];
        for (int m = 0; m < 3; m++)
            for (int c = 3; c < 7; c++) A[i][c] += EK[i][m] * Z[m][c];
    }
}

static void invert6(double S[6][6], double R[6][6])
{
    double copy[6][6];
    memcpy(copy, S, sizeof copy);
    by_base B = { { 0 } };
    for (int i = 0; i < 6; i++) B[i][i] = 1;
    if (!solve6(copy, B)) memset(B, 0, sizeof B);
    for (int i = 0; i < 6; i++) memcpy(R[i], B[i], sizeof R[i]);
}

/* Keep the factors of struct wf_beam_small. S: base wrench by y, without the part above. */
static void keep_small_loads(const struct statics *q, const struct wf_beam_wrench at[2],
                             const struct wf_beam_reaction *above, double half, double P[6][6],
                             double S[6][6], struct wf_beam_small *o)
{
    memcpy(o->P, P, sizeof o->P);
    memcpy(o->Vn, q->Vn, sizeof o->Vn);
    memcpy(o->Y, q->Y, sizeof o->Y);
    for (int j = 0; j < 2; j++) memcpy(o->n[j], at[j].n, sizeof o->n[j]);
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) {
            o->T[i][c] = S[i][c];
            for (int m = 0; m < 6; m++) o->T[i][c] += above->K[i][m] * P[m][c];
        }
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 6; c++)
            for (int m = 0; m < 3; m++) {
                double dn = 0;
                for (int l = 0; l < 6; l++) dn += above->K[m][l] * P[l][c];
                o->T[3 + i][c] += half * (q->Vn[0][3 * i + m] + q->Vn[1][3 * i + m]) * dn;
            }
}

/* Would the linear step throw this element (and all above it) far beyond where linearisation holds? Either
 * its own correction at a fixed base is large, or its end rotates against its base (below -1: it is beyond
 * its buckling load) or many times as far as its base (it is near its buckling load). Such a step would also
 * throw the parts below. P: spin of the end by y; A: solved. */
WF_INLINE bool leaps(by_base A, double P[6][6])
{
    const double turn = 0.7, against = -1.1, along = 8; /* rad, -, - */
    for (int i = 0; i < 6; i++)
        if (!(fabs(A[i][6]) <= turn)) return true;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double follows = 0;
            for (int m = 0; m < 6; m++) follows -= P[3 + i][m] * A[m][3 + j];
            if (!(follows > (i == j ? against : -along) && follows < along)) return true;
        }
    return false;
}

/* Solve for y = -A (p_base, 1). With `guard`, an element whose step is too large is taken by itself: damped
 * elastic bending towards its present moments, rigidly following its base, with no reaction on the part
 * below (*apart). Twigs beyond their buckling load thus fall over in a few iterations without disturbing
 * what carries them. */
WF_INLINE bool solve_element(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                             const struct kinematics *k, const struct statics *q,
                             const struct wf_beam_stage *s, const struct wf_beam_wrench at[2],
                             const struct wf_beam_reaction *above, double P[6][6], by_base Z, by_base A,
                             bool guard, bool *apart, struct wf_beam_stability *count,
                             struct wf_beam_small *small)
{
    static const struct statics none;
    double S[6][6], Mn[2][9];
    *apart = false;
    element_equations(p, flat, k, q, s, at, S, A, Mn);
    attach_part_above(Mn, above, P, Z, S, A);
    if (small) invert6(S, small->R);
    if (count) count->negative += unstable_directions(p, S, k, count->margin);
    bool solved = solve6(S, A);
    if (!guard || (solved && !leaps(A, P))) return solved;
    *apart = true;
    element_equations(p, flat, k, &none, s, at, S, A, Mn);
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) A[i][c] = 0;
    return solve6(S, A);
}

WF_INLINE bool eliminate_either(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                                struct wf_beam_shape *u, const double L[9], const struct wf_beam_creep *creep,
                                const struct wf_beam_stage *s, const struct wf_line_load load[2],
                                const struct wf_beam_wrench at[2], struct wf_beam_reaction *node,
                                struct wf_beam_answer *o, struct wf_beam_reaction *below, bool guard,
                                struct wf_beam_stability *count, struct wf_beam_small *small)
{
    struct kinematics k;
    struct statics q;
    double P[6][6], S[6][6];
    by_base y, Z, B, W = { { 0 } };
    const double half = 0.5 * p->h;
    bool apart;
    kinematics_of(p, flat, u, L, creep, s, at, &k);
    statics_of(p, flat, u, L, s, load, at, &q);
    end_motion_of(half, &k, &q, P, Z);
    base_wrench_of(half, &q, load, S, B);
    if (!solve_element(p, flat, &k, &q, s, at, node, P, Z, y, guard, &apart, count, small)) return false;
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 8; c++) y[i][c] = -y[i][c];

    if (small) keep_small_loads(&q, at, node, half, P, S, small);
    add_product(P, y, Z);       /* end = Z (p, 1) */
    add_product(node->K, Z, W); /* dw_end = W (p, 1) */
    for (int i = 0; i < 6; i++) W[i][6] += node->k[i];
    add_product(S, y, B);
    for (int i = 0; i < 3; i++)
        for (int m = 0; m < 3; m++) {
            double f = half * (q.Vn[0][3 * i + m] + q.Vn[1][3 * i + m]);
            for (int c = 0; c < 8; c++) B[3 + i][c] += f * W[m][c];
        }
    for (int i = 0; i < 6; i++) {
        for (int c = 0; c < 6; c++) o->X[i][c] = y[i][c], node->K[i][c] = Z[i][c];
        o->x[i] = y[i][6];
        node->k[i] = Z[i][6];
    }
    for (int i = 0; i < 6 && !apart; i++) {
        for (int c = 0; c < 6; c++) below->K[i][c] += W[i][c] + B[i][c];
        below->k[i] += W[i][6] + B[i][6];
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

WF_INLINE void misfit_add(const struct wf_beam_part *p, const struct wf_beam_shape *u, const double base_L[9],
                          const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                          const struct wf_beam_flat *flat, const struct wf_beam_wrench at[2],
                          struct wf_beam_misfit *sum)
{
    const double slight = 1e-3; /* times n h: lower bound of the moment the error is measured against */
    double k[2][3];
    wf_beam_curvature(p, u, k);
    for (int j = 0; j < 2; j++) {
        double law[3], miss[3], work[3], strain[3];
        for (int i = 0; i < 3; i++) law[i] = (1 + creep->rate) * k[j][i] - creep->rate * creep->k0[j][i];
        m3_apply(base_L, law, miss);
        law_give(p, flat, s, j, at[j].m, work);
        sum->energy +=
            0.25 * p->h *
            (wf_dot(work, at[j].m) + slight * slight * p->h * p->h * wf_dot(at[j].n, at[j].n) / p->ei[j]);
        sum->turn = fmax(sum->turn, p->h * sqrt(wf_dot(work, work)));
        v3_add(miss, -1, work);
        law_hold(p, flat, s, j, miss, work);
        sum->bending += 0.25 * p->h * wf_dot(work, miss);
        v3_section(p->cs[j], p->ca[j], s->t[j], at[j].n, strain);
        sum->turn = fmax(sum->turn, sqrt(wf_dot(strain, strain)));
        for (int i = 0; i < 3; i++) strain[i] += s->t[j][i] - s->rp[j][i];
        sum->strain = fmax(sum->strain, sqrt(wf_dot(strain, strain)));
    }
}

void wf_beam_misfit_add(const struct wf_beam_part *p, const struct wf_beam_shape *u, const double base_L[9],
                        const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                        const struct wf_beam_flat *flat, const struct wf_beam_wrench at[2],
                        struct wf_beam_misfit *sum)
{
    if (flat)
        misfit_add(p, u, base_L, creep, s, flat, at, sum);
    else
        misfit_add(p, u, base_L, creep, s, NULL, at, sum);
}
