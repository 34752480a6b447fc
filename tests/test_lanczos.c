/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Block Lanczos on small dense matrices whose eigenvalues are known. */
#include "close.h"
#include "solve/lanczos.h"
#include <stdlib.h>
#include <string.h>

enum { MOST = 400 };
struct matrix {
    size_t n, products;
    const double *value;  /* eigenvalues                                                     */
    double skew;          /* times a skew part that is added                                 */
    double axis[2][MOST]; /* A = R diag(value) R with R a product of two reflections and back */
};

static void reflect(const double *u, size_t n, double *x)
{
    double part = 0;
    for (size_t i = 0; i < n; i++) part += u[i] * x[i];
    for (size_t i = 0; i < n; i++) x[i] -= 2 * part * u[i];
}

static void apply(struct matrix *m, const double *in, double *out)
{
    memcpy(out, in, m->n * sizeof *out);
    reflect(m->axis[0], m->n, out), reflect(m->axis[1], m->n, out);
    for (size_t i = 0; i < m->n; i++) out[i] *= m->value[i];
    reflect(m->axis[1], m->n, out), reflect(m->axis[0], m->n, out);
    for (size_t i = 0; i < m->n && m->skew != 0; i++)
        out[i] += m->skew * ((i ? in[i - 1] : 0) - (i + 1 < m->n ? in[i + 1] : 0));
    m->products++;
}

static void apply_block(void *ctx, const wf_four *in, wf_four *out)
{
    struct matrix *m = ctx;
    double x[MOST], y[MOST];
    for (int b = 0; b < WF_LANCZOS_BLOCK; b++) {
        for (size_t i = 0; i < m->n; i++) x[i] = in[i][b];
        apply(m, x, y);
        for (size_t i = 0; i < m->n; i++) out[i][b] = y[i];
    }
}

static void make(struct matrix *m, size_t n, const double *value)
{
    *m = (struct matrix){ .n = n, .value = value };
    for (int k = 0; k < 2; k++) {
        double size = 0;
        for (size_t i = 0; i < n; i++)
            m->axis[k][i] = sin((double)(i + 1) * (k + 1.3)), size += pow(m->axis[k][i], 2);
        for (size_t i = 0; i < n; i++) m->axis[k][i] /= sqrt(size);
    }
}

/* Solve; every pair must satisfy A x = value x, the vectors be orthonormal. */
static enum wf_status run(struct matrix *m, size_t wanted, double tolerance, double *value)
{
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_lanczos l = {
        .size = m->n, .apply = apply_block, .ctx = m, .wanted = wanted, .tolerance = tolerance
    };
    double *x = WF_TAKE(&a, wanted * m->n, double), *y = WF_TAKE(&a, m->n, double);
    enum wf_status s = wf_lanczos(&l, value, x, &a, &e);
    size_t have = wanted < m->n ? wanted : m->n;
    for (size_t i = 0; i < have && s == WF_OK && !isnan(value[i]); i++) {
        double off = 0;
        apply(m, x + i * m->n, y);
        for (size_t k = 0; k < m->n; k++) off += pow(y[k] - value[i] * x[i * m->n + k], 2);
        if (!(sqrt(off) <= 2 * tolerance * fabs(value[i]) + 2e-12))
            fail_msg("pair %zu of value %g is off by %g", i, value[i], sqrt(off));
        for (size_t j = 0; j <= i; j++) {
            double dot = 0;
            for (size_t k = 0; k < m->n; k++) dot += x[i * m->n + k] * x[j * m->n + k];
            assert_close(dot + 1, i == j ? 2 : 1, 1e-11);
        }
    }
    wf_arena_free(&a);
    return s;
}

/* As a caller that wants no vectors. */
static void values_alone(struct matrix *m, size_t wanted, double tolerance, double *value)
{
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_lanczos l = {
        .size = m->n, .apply = apply_block, .ctx = m, .wanted = wanted, .tolerance = tolerance
    };
    assert_int_equal(wf_lanczos(&l, value, NULL, &a, &e), WF_OK);
    wf_arena_free(&a);
}

static void spread(void **state)
{
    (void)state;
    static double value[MOST];
    struct matrix m;
    double got[8];
    for (size_t i = 0; i < MOST; i++) value[i] = 1 / pow((double)i + 1, 2);
    make(&m, MOST, value);
    assert_int_equal(run(&m, 8, 1e-8, got), WF_OK);
    for (size_t i = 0; i < 8; i++) assert_close(got[i], value[i], 1e-13);
    assert_true(m.products < 120);
}

/* Equal eigenvalues up to the block's size, also where all the rest follows closely; with and without
 * vectors, whose space is kept orthogonal to another bound. */
static void multiple(void **state)
{
    (void)state;
    static double value[MOST];
    struct matrix m;
    double got[7];
    const double first[7] = { 5, 5, 5, 5, 3, 3, 2.9999999 };
    for (size_t i = 0; i < MOST; i++) value[i] = i < 7 ? first[i] : 0.9 * pow(0.97, (double)i);
    make(&m, MOST, value);
    assert_int_equal(run(&m, 7, 1e-8, got), WF_OK);
    for (size_t i = 0; i < 7; i++) assert_close(got[i], first[i], 1e-12);
    values_alone(&m, 7, 1e-8, got);
    for (size_t i = 0; i < 7; i++) assert_close(got[i], first[i], 1e-12);
}

/* Pairs over twelve powers of ten, as the bending of a slender round stem has them: components along the
 * converged vectors grow a thousandfold from block to block. */
static void pairs(void **state)
{
    (void)state;
    static double value[MOST];
    struct matrix m;
    double got[12];
    for (size_t i = 0; i < MOST; i++) value[i] = pow((double)(i / 2) + 0.5, -4);
    make(&m, MOST, value);
    assert_int_equal(run(&m, 12, 1e-8, got), WF_OK);
    for (size_t i = 0; i < 12; i++) assert_close(got[i], value[i], 1e-11);
    values_alone(&m, 12, 1e-8, got);
    for (size_t i = 0; i < 12; i++) assert_close(got[i], value[i], 1e-11);
}

/* Many eigenvalues close together need many blocks: no pair may be found twice when the space is
 * orthogonalised to all only now and then. */
static void crowded(void **state)
{
    (void)state;
    static double value[MOST];
    struct matrix m;
    double got[30];
    for (size_t i = 0; i < MOST; i++) value[i] = 1 / (1 + 0.05 * (double)(i / 2));
    make(&m, MOST, value);
    values_alone(&m, 30, 1e-8, got);
    for (size_t i = 0; i < 30; i++) assert_close(got[i], value[i], 1e-12);
}

/* By magnitude, whatever the sign. */
static void signs(void **state)
{
    (void)state;
    const double value[6] = { 0.5, -7, 3, -3, 1e-3, 0 };
    struct matrix m;
    double got[5];
    make(&m, 6, value);
    assert_int_equal(run(&m, 5, 1e-10, got), WF_OK);
    assert_close(got[0], -7, 1e-13);
    assert_close(got[1] * got[2], -9, 1e-12);
    assert_close(got[3], 0.5, 1e-12);
    assert_close(got[4], 1e-3, 1e-9);
}

/* Fewer motions than asked for: the rest is NAN; a matrix of zeros has none. */
static void few(void **state)
{
    (void)state;
    for (size_t n = 1; n < 8; n++) {
        const double value[7] = { 4, 3, 2, 1, 0.5, 0.25, 0.125 };
        struct matrix m;
        double got[9];
        make(&m, n, value);
        assert_int_equal(run(&m, 9, 1e-10, got), WF_OK);
        for (size_t i = 0; i < 9; i++)
            if (i < n)
                assert_close(got[i], value[i], 1e-12);
            else
                assert_true(isnan(got[i]));
    }
    const double zero[5] = { 0 };
    struct matrix m;
    double got[2] = { 1, 1 };
    make(&m, 5, zero);
    assert_int_equal(run(&m, 2, 1e-10, got), WF_OK);
    assert_true(isnan(got[0]) && isnan(got[1]));
}

/* A rank of two, four wanted: two are zero. */
static void deficient(void **state)
{
    (void)state;
    static double value[50] = { 2, -1 };
    struct matrix m;
    double got[4];
    make(&m, 50, value);
    assert_int_equal(run(&m, 4, 1e-9, got), WF_OK);
    assert_close(got[0], 2, 1e-13);
    assert_close(got[1], -1, 1e-13);
    for (int i = 2; i < 4; i++) assert_true(isnan(got[i]) || fabs(got[i]) < 1e-13);
}

/* The tangent of a loaded tree is not quite symmetric: a skew part of 1e-5 changes eigenvalues by its square,
 * and the search converges as without it. */
static void nearly_symmetric(void **state)
{
    (void)state;
    static double value[MOST];
    struct matrix m;
    double got[8];
    for (size_t i = 0; i < MOST; i++) value[i] = 1 / (1 + 0.05 * (double)(i / 2));
    make(&m, MOST, value);
    m.skew = 1e-5;
    values_alone(&m, 8, 1e-5, got);
    for (size_t i = 0; i < 8; i++) assert_close(got[i], value[i], 1e-7);
}

static void no_memory(void **state)
{
    (void)state;
    const double value[6] = { 6, 5, 4, 3, 2, 1 };
    struct matrix m;
    double got[2];
    make(&m, 6, value);
    struct wf_lanczos l = { .size = 6, .apply = apply_block, .ctx = &m, .wanted = 2, .tolerance = 1e-9 };
    size_t refused = 0;
    for (size_t limit = 1;; limit += 8) {
        struct wf_arena a = { .limit = limit };
        struct wf_err e = { 0 };
        enum wf_status s = wf_lanczos(&l, got, NULL, &a, &e);
        wf_arena_free(&a);
        if (s == WF_OK) break;
        assert_int_equal(s, WF_ENOMEM);
        refused++;
    }
    assert_true(refused > 20);
    assert_close(got[0], 6, 1e-12);
}

/* A space too small for the answer: says so, and gives the best it has. */
static void unsettled(void **state)
{
    (void)state;
    static double value[MOST];
    struct matrix m;
    double got[1];
    for (size_t i = 0; i < MOST; i++) value[i] = 1 - 1e-9 * (double)i;
    make(&m, MOST, value);
    assert_int_equal(run(&m, 1, 1e-14, got), WF_ENOCONV);
    assert_close(got[0], 1, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spread),    cmocka_unit_test(multiple),  cmocka_unit_test(signs),
        cmocka_unit_test(pairs),     cmocka_unit_test(crowded),   cmocka_unit_test(few),
        cmocka_unit_test(deficient), cmocka_unit_test(no_memory), cmocka_unit_test(nearly_symmetric),
        cmocka_unit_test(unsettled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
