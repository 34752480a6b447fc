/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourier transforms of four series against GSL, for every length from the shortest. */
#include "base/random.h"
#include "close.h"
#include "wind/fourier.h"
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <string.h>

enum { LONGEST = 1 << 14 };

static void like_gsl(void **state)
{
    (void)state;
    for (size_t n = 4; n <= LONGEST; n *= 2) {
        struct wf_arena a = { 0 };
        struct wf_err e = { 0 };
        struct wf_fourier *f;
        double *y[4], *want = WF_TAKE(&a, n, double), *first = WF_TAKE(&a, 4 * n, double);
        gsl_fft_real_wavetable *table = gsl_fft_real_wavetable_alloc(n);
        gsl_fft_real_workspace *space = gsl_fft_real_workspace_alloc(n);
        assert_int_equal(wf_fourier_open(n, &a, &f, &e), WF_OK);
        for (size_t k = 0; k < 4; k++) {
            y[k] = WF_TAKE(&a, n, double);
            wf_random_normals(3, k, 0, n, y[k]);
            memcpy(first + k * n, y[k], n * sizeof *first);
        }
        wf_fourier_forward(f, y);
        for (size_t k = 0; k < 4; k++) {
            memcpy(want, first + k * n, n * sizeof *want);
            gsl_fft_real_transform(want, 1, n, table, space);
            for (size_t i = 0; i < n; i++)
                assert_true(fabs(y[k][i] - want[i]) < 1e-14 * sqrt((double)n) * 20);
        }
        wf_fourier_inverse(f, y);
        for (size_t k = 0; k < 4; k++)
            for (size_t i = 0; i < n; i++) assert_true(fabs(y[k][i] - first[k * n + i]) < 2e-14);
        gsl_fft_real_wavetable_free(table);
        gsl_fft_real_workspace_free(space);
        wf_arena_free(&a);
    }
}

/* One series in all four places; lengths that are not a power of two. */
static void same_and_refused(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_fourier *f;
    double y[8] = { 1, 2, 3, 4, 5, 6, 7, 8 }, *all[4] = { y, y, y, y };
    assert_int_equal(wf_fourier_open(8, &a, &f, &e), WF_OK);
    wf_fourier_forward(f, all);
    assert_close(y[0], 36, 1e-15);
    assert_close(y[7], -4, 1e-15);
    wf_fourier_inverse(f, all);
    for (int i = 0; i < 8; i++) assert_close(y[i], i + 1, 1e-15);
    assert_int_equal(wf_fourier_open(12, &a, &f, &e), WF_EUSAGE);
    assert_int_equal(wf_fourier_open(2, &a, &f, &e), WF_EUSAGE);
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(like_gsl), cmocka_unit_test(same_and_refused) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
