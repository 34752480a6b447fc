/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_VEC3_H
#define WF_BASE_VEC3_H
/* 3-vectors, 3x3 matrices (row-major) and finite rotations, inlined into the solvers: of reals, or in the
 * kernels of many lanes at once (base/real.h). */
#include "base/real.h"

WF_INLINE real wf_dot(const real a[3], const real b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* out = a x b; out must not be a or b. */
WF_INLINE void wf_cross(const real a[3], const real b[3], real out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* y += s x */
WF_INLINE void v3_add(real y[3], real s, const real x[3])
{
    for (int i = 0; i < 3; i++) y[i] += s * x[i];
}

WF_INLINE void m3_zero(real A[9])
{
    for (int i = 0; i < 9; i++) A[i] = real_of(0);
}

/* y = A x */
WF_INLINE void m3_apply(const real A[9], const real x[3], real y[3])
{
    real a = A[0] * x[0] + A[1] * x[1] + A[2] * x[2], b = A[3] * x[0] + A[4] * x[1] + A[5] * x[2],
         c = A[6] * x[0] + A[7] * x[1] + A[8] * x[2];
    y[0] = a;
    y[1] = b;
    y[2] = c;
}

/* y = A' x */
WF_INLINE void m3_apply_transposed(const real A[9], const real x[3], real y[3])
{
    real a = A[0] * x[0] + A[3] * x[1] + A[6] * x[2], b = A[1] * x[0] + A[4] * x[1] + A[7] * x[2],
         c = A[2] * x[0] + A[5] * x[1] + A[8] * x[2];
    y[0] = a;
    y[1] = b;
    y[2] = c;
}

/* C = A B; C must not be A or B */
WF_INLINE void m3_mul(const real A[9], const real B[9], real C[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            C[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
}

/* C = A' B; C must not be A or B */
WF_INLINE void m3_mul_transposed(const real A[9], const real B[9], real C[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) C[3 * i + j] = A[i] * B[j] + A[3 + i] * B[3 + j] + A[6 + i] * B[6 + j];
}

/* A += s B */
WF_INLINE void m3_add(real A[9], real s, const real B[9])
{
    for (int i = 0; i < 9; i++) A[i] += s * B[i];
}

/* A += s [a]x, where [a]x b = a x b */
WF_INLINE void m3_add_cross(real A[9], real s, const real a[3])
{
    A[1] -= s * a[2];
    A[2] += s * a[1];
    A[3] += s * a[2];
    A[5] -= s * a[0];
    A[6] -= s * a[1];
    A[7] += s * a[0];
}

/* A += s a b' */
WF_INLINE void m3_add_outer(real A[9], real s, const real a[3], const real b[3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) A[3 * i + j] += s * a[i] * b[j];
}

/* C += s [a]x B */
WF_INLINE void m3_add_cross_mul(real C[9], real s, const real a[3], const real B[9])
{
    for (int j = 0; j < 3; j++) {
        C[j] += s * (a[1] * B[6 + j] - a[2] * B[3 + j]);
        C[3 + j] += s * (a[2] * B[j] - a[0] * B[6 + j]);
        C[6 + j] += s * (a[0] * B[3 + j] - a[1] * B[j]);
    }
}

/* C = [a]x B */
WF_INLINE void m3_cross_mul(const real a[3], const real B[9], real C[9])
{
    for (int j = 0; j < 3; j++) {
        C[j] = a[1] * B[6 + j] - a[2] * B[3 + j];
        C[3 + j] = a[2] * B[j] - a[0] * B[6 + j];
        C[6 + j] = a[0] * B[3 + j] - a[1] * B[j];
    }
}

/* C += p B + (q - p) t (t' B): the stiffness or compliance of an isotropic section, p across t and q along t,
 * applied to B */
WF_INLINE void m3_add_section_mul(real C[9], real p, real q, const real t[3], const real B[9])
{
    real tb[3];
    for (int j = 0; j < 3; j++) tb[j] = (q - p) * (t[0] * B[j] + t[1] * B[3 + j] + t[2] * B[6 + j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) C[3 * i + j] += p * B[3 * i + j] + t[i] * tb[j];
}

/* y = p x + (q - p) t (t.x) */
WF_INLINE void v3_section(real p, real q, const real t[3], const real x[3], real y[3])
{
    real s = (q - p) * wf_dot(t, x);
    for (int i = 0; i < 3; i++) y[i] = p * x[i] + s * t[i];
}

/* Coefficients of a rotation vector of square length x = angle^2:
 * a = (1 - cos)/angle^2, b = (angle - sin)/angle^3, da = 2 da/dx, db = 2 db/dx, c = 1/x - (1 + cos)/(2 angle
 * sin). */
struct rotation {
    real a, b, da, db, c;
};

/* The same of a large rotation, lane by lane. */
static __attribute__((noinline, unused, cold)) void rotation_of_large(real x, struct rotation *o)
{
    for (int i = 0; i < WF_WIDTH; i++) {
        double y = real_lane(x, i), t = sqrt(y), s = sin(t), k = cos(t);
        if (!(y >= 0.25)) continue;
        real_lane(o->a, i) = (1 - k) / y;
        real_lane(o->b, i) = (t - s) / (y * t);
        real_lane(o->da, i) = (t * s - 2 * (1 - k)) / (y * y);
        real_lane(o->db, i) = (3 * s - 2 * t - t * k) / (y * y * t);
        real_lane(o->c, i) = 1 / y - (1 + k) / (2 * t * s);
    }
}

WF_INLINE struct rotation rotation_of(real x)
{
    struct rotation o; /* series to rounding below 0.25 */
    o.a = 1. / 2 -
          x * (1. / 24 -
               x * (1. / 720 -
                    x * (1. / 40320 - x * (1. / 3628800 - x * (1. / 479001600 - x * (1 / 87178291200.))))));
    o.b = 1. / 6 -
          x * (1. / 120 -
               x * (1. / 5040 - x * (1. / 362880 - x * (1. / 39916800 -
                                                        x * (1. / 6227020800. - x * (1 / 1307674368000.))))));
    o.da = -1. / 12 + x * (1. / 180 - x * (1. / 6720 - x * (1. / 453600 - x * (1 / 47900160.))));
    o.db = -1. / 60 + x * (1. / 1260 - x * (1. / 60480 - x * (1. / 4989600 - x * (1 / 622702080.))));
    o.c = 1. / 12 +
          x * (1. / 720 +
               x * (1. / 30240 + x * (1. / 1209600 + x * (1. / 47900160 + x * (691. / 1307674368000. +
                                                                               x * (1 / 74724249600.))))));
    if (__builtin_expect(real_any(real_not_above(real_of(0.25), x)), 0)) {
        struct rotation large = o; /* o itself stays in registers */
        rotation_of_large(x, &large);
        o = large;
    }
    return o;
}

/* R = exp([v]x) */
WF_INLINE void rotation_matrix(const real v[3], real R[9])
{
    real x = wf_dot(v, v);
    struct rotation o = rotation_of(x);
    real s = 1 - x * o.b, d = 1 - x * o.a; /* sin/angle, cos */
    m3_zero(R);
    R[0] = R[4] = R[8] = d;
    m3_add_cross(R, s, v);
    m3_add_outer(R, o.a, v, v);
}

/* T(v) with spin = T(v) v': T = I + a [v] + b [v][v] */
WF_INLINE void rotation_tangent(const struct rotation *o, const real v[3], real x, real T[9])
{
    m3_zero(T);
    T[0] = T[4] = T[8] = 1 - o->b * x;
    m3_add_cross(T, o->a, v);
    m3_add_outer(T, o->b, v, v);
}

/* D w = d(T(v) slope)/dv w */
WF_INLINE void rotation_tangent_slope(const struct rotation *o, const real v[3], const real slope[3],
                                      real D[9])
{
    real once[3], twice[3], grow[3], dot = wf_dot(v, slope);
    wf_cross(v, slope, once);
    wf_cross(v, once, twice);
    for (int i = 0; i < 3; i++) grow[i] = o->da * once[i] + o->db * twice[i];
    m3_zero(D);
    m3_add_cross(D, -o->a, slope); /* a w x slope */
    m3_add_outer(D, real_of(1), grow, v);
    /* b (w x (v x slope) + v x (w x slope)) = b (-[once] - [v][slope]) w;  [v][s] = s v' - (v.s) 1 */
    m3_add_cross(D, -o->b, once);
    m3_add_outer(D, -o->b, slope, v);
    for (int i = 0; i < 3; i++) D[4 * i] += o->b * dot;
}

/* inverse of T(v): I - [v]/2 + c [v][v] */
WF_INLINE void rotation_tangent_inverse(const struct rotation *o, const real v[3], real x, real Ti[9])
{
    m3_zero(Ti);
    Ti[0] = Ti[4] = Ti[8] = 1 - o->c * x;
    m3_add_cross(Ti, real_of(-0.5), v);
    m3_add_outer(Ti, o->c, v, v);
}

#if WF_WIDTH == 1

/* rotation vector of a rotation matrix, angle in 0..pi (via the quaternion of its largest component) */
static inline void rotation_vector(const double R[9], double v[3])
{
    double q[4], t = R[0] + R[4] + R[8];
    int big = 0;
    double best = t;
    for (int i = 0; i < 3; i++)
        if (R[4 * i] > best) {
            best = R[4 * i];
            big = i + 1;
        }
    if (big == 0) {
        q[0] = 1 + t;
        q[1] = R[7] - R[5];
        q[2] = R[2] - R[6];
        q[3] = R[3] - R[1];
    } else {
        int i = big - 1, j = (i + 1) % 3, k = (i + 2) % 3;
        q[0] = R[3 * k + j] - R[3 * j + k];
        q[1 + i] = 1 + R[4 * i] - R[4 * j] - R[4 * k];
        q[1 + j] = R[3 * j + i] + R[3 * i + j];
        q[1 + k] = R[3 * k + i] + R[3 * i + k];
    }
    double vec = sqrt(wf_dot(q + 1, q + 1)), sign = q[0] < 0 ? -1 : 1;
    double angle = 2 * atan2(vec, fabs(q[0]));
    double f = vec > 0 ? sign * angle / vec : 0;
    for (int i = 0; i < 3; i++) v[i] = f * q[1 + i];
}

#endif

/* Four numbers in a vector register, each a lane of its own; may be stored wherever four doubles are. */
typedef double wf_four __attribute__((vector_size(32), aligned(8), may_alias));

/* WF_WIDE: compile a function twice, for AVX2 and for any x86-64 processor, and choose at run time. Because
 * fused multiply-add is not used, both give the same digits. */
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define WF_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WF_WIDE
#endif
#endif
