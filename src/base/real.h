/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_REAL_H
#define WF_BASE_REAL_H
/* `real`: the number that the numeric kernels compute with. It is a double, or, where a source is compiled
 * with WF_WIDTH above 1, as many doubles side by side, of independent states ("lanes"). Sums, products,
 * quotients and square roots of a lane are those of IEEE 754 whatever the width, and no operation combines
 * lanes, so that a lane has the same bytes at any width. Operators work on both; a double beside a real
 * counts for all lanes. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef WF_WIDTH
#define WF_WIDTH 1
#endif
#define WF_INLINE static inline __attribute__((always_inline))

/* real_truth: per lane all bits set, or none. real_of: a double in all lanes. real_lane: one lane, to read or
 * set. real_choose: a where m is set, else b. */
#if WF_WIDTH == 1

typedef double real;
typedef int64_t real_truth;
#define real_of(x) ((double)(x))
#define real_lane(x, k) (*((void)(k), &(x)))
#define real_below(a, b) (-(real_truth)((a) < (b)))
#define real_not_above(a, b) (-(real_truth)((a) <= (b)))

/* Shifted as if without a sign. */
WF_INLINE real_truth real_bits_up(real_truth x, int places) { return (real_truth)((uint64_t)x << places); }
WF_INLINE real_truth real_bits(real x)
{
    real_truth m;
    memcpy(&m, &x, sizeof m);
    return m;
}
WF_INLINE real real_from_bits(real_truth m)
{
    real x;
    memcpy(&x, &m, sizeof x);
    return x;
}
WF_INLINE real real_choose(real_truth m, real a, real b) { return m ? a : b; }
WF_INLINE int real_any(real_truth m) { return m != 0; }
WF_INLINE real real_sqrt(real x) { return sqrt(x); }
WF_INLINE real real_abs(real x) { return fabs(x); }

#else

#ifdef __AVX__
#include <immintrin.h>
#endif
typedef double real __attribute__((vector_size(8 * WF_WIDTH)));
typedef int64_t real_truth __attribute__((vector_size(8 * WF_WIDTH)));
#define real_of(x) ((x) - (real){ 0 })
#define real_lane(x, k) ((x)[k])
#define real_below(a, b) ((real_truth)((a) < (b)))
#define real_not_above(a, b) ((real_truth)((a) <= (b)))
typedef uint64_t real_unsigned __attribute__((vector_size(8 * WF_WIDTH)));
WF_INLINE real_truth real_bits_up(real_truth x, int places)
{
    return (real_truth)((real_unsigned)x << places);
}
WF_INLINE real_truth real_bits(real x) { return (real_truth)x; }
WF_INLINE real real_from_bits(real_truth m) { return (real)m; }
WF_INLINE real real_choose(real_truth m, real a, real b)
{
    return (real)(((real_truth)a & m) | ((real_truth)b & ~m));
}
WF_INLINE real real_abs(real x) { return (real)((real_truth)x & INT64_MAX); }
WF_INLINE int real_any(real_truth m)
{
#if WF_WIDTH == 8 && defined(__AVX512F__)
    return _mm512_test_epi64_mask((__m512i)m, (__m512i)m) != 0;
#elif WF_WIDTH == 4 && defined(__AVX__)
    return !_mm256_testz_si256((__m256i)m, (__m256i)m);
#else
    int64_t some = 0;
    for (int k = 0; k < WF_WIDTH; k++) some |= m[k];
    return some != 0;
#endif
}
WF_INLINE real real_sqrt(real x)
{
#if WF_WIDTH == 8 && defined(__AVX512F__)
    return (real)_mm512_sqrt_pd((__m512d)x);
#elif WF_WIDTH == 4 && defined(__AVX__)
    return (real)_mm256_sqrt_pd((__m256d)x);
#else
    real y;
    for (int k = 0; k < WF_WIDTH; k++) y[k] = sqrt(x[k]);
    return y;
#endif
}

#endif

/* The larger and the smaller; b where one is not a number. */
WF_INLINE real real_max(real a, real b) { return real_choose(real_below(b, a), a, b); }
WF_INLINE real real_min(real a, real b) { return real_choose(real_below(a, b), a, b); }

/* Rows to columns: number q of block[k] becomes number k of block[q]. */
WF_INLINE void real_transpose(real block[WF_WIDTH])
{
#if WF_WIDTH == 4
    for (int i = 0; i < 4; i += 2) {
        real a = block[i], b = block[i + 1];
        block[i] = __builtin_shufflevector(a, b, 0, 4, 2, 6);
        block[i + 1] = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    }
    for (int i = 0; i < 2; i++) {
        real a = block[i], b = block[i + 2];
        block[i] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
        block[i + 2] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
    }
#elif WF_WIDTH == 8
    for (int i = 0; i < 8; i += 2) {
        real a = block[i], b = block[i + 1];
        block[i] = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
        block[i + 1] = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int k = 0; k < 4; k++) {
        int i = k / 2 * 4 + k % 2;
        real a = block[i], b = block[i + 2];
        block[i] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
        block[i + 2] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (int i = 0; i < 4; i++) {
        real a = block[i], b = block[i + 4];
        block[i] = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
        block[i + 4] = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    }
#else
    (void)block;
#endif
}

/* The first n numbers at each lane's place, n at least WF_WIDTH. */
WF_INLINE void real_gather(const double *const at[WF_WIDTH], size_t n, real *to)
{
#pragma GCC unroll 8
    for (size_t q = 0; q < n; q += WF_WIDTH) {
        size_t from = q + WF_WIDTH <= n ? q : n - WF_WIDTH;
        real block[WF_WIDTH];
        for (int k = 0; k < WF_WIDTH; k++) memcpy(&block[k], at[k] + from, sizeof(real));
        real_transpose(block);
        for (int k = 0; k < WF_WIDTH; k++) to[from + (size_t)k] = block[k];
    }
}

/* n numbers, at least WF_WIDTH, to the places of the first `some` lanes. */
WF_INLINE void real_scatter(const real *from, size_t n, size_t some, double *const at[WF_WIDTH])
{
#pragma GCC unroll 8
    for (size_t q = 0; q < n; q += WF_WIDTH) {
        size_t to = q + WF_WIDTH <= n ? q : n - WF_WIDTH;
        real block[WF_WIDTH];
        for (int k = 0; k < WF_WIDTH; k++) block[k] = from[to + (size_t)k];
        real_transpose(block);
        for (size_t k = 0; k < some; k++) memcpy(at[k] + to, &block[k], sizeof(real));
    }
}

/* Add n numbers to those at the places of the first `some` lanes, one lane after another, for several may
 * have one place. */
WF_INLINE void real_scatter_add(const real *from, size_t n, size_t some, double *const at[WF_WIDTH])
{
    for (size_t q = 0; q < n; q += WF_WIDTH) {
        size_t count = n - q < WF_WIDTH ? n - q : WF_WIDTH;
        real block[WF_WIDTH];
        for (size_t k = 0; k < WF_WIDTH; k++) block[k] = k < count ? from[q + k] : real_of(0);
        real_transpose(block);
        for (size_t k = 0; k < some && count == WF_WIDTH; k++) {
            real sum;
            memcpy(&sum, at[k] + q, sizeof sum);
            sum += block[k];
            memcpy(at[k] + q, &sum, sizeof sum);
        }
        for (size_t k = 0; k < some && count < WF_WIDTH; k++)
            for (size_t c = 0; c < count; c++) at[k][q + c] += real_lane(block[k], c);
    }
}
#endif
