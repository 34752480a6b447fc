/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Counter-based random numbers: the published known answers, and the moments of what is made of them. */
#include "base/random.h"
#include "close.h"
#include <stdlib.h>
#include <string.h>

/* Known-answer vectors of the Random123 distribution (Salmon et al. 2011), philox4x32, 10 rounds. */
static void known_answers(void **state)
{
    (void)state;
    static const struct {
        uint32_t counter[4], key[2], want[4];
    } row[] = {
        { { 0, 0, 0, 0 }, { 0, 0 }, { 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8 } },
        { { 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff },
          { 0xffffffff, 0xffffffff },
          { 0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd } },
        { { 0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344 },
          { 0xa4093822, 0x299f31d0 },
          { 0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1 } },
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        uint32_t got[4];
        wf_philox4x32(row[i].counter, row[i].key, got);
        assert_memory_equal(got, row[i].want, sizeof got);
    }
}

/* The address is (seed, stream, index): index in the low words, stream in the high, seed the key. */
static void address(void **state)
{
    (void)state;
    uint32_t got[4];
    wf_random_words(0x299f31d0a4093822u, 0x0370734413198a2eu, 0x85a308d3243f6a88u, got);
    assert_int_equal(got[0], 0xd16cfe09);
    assert_int_equal(got[3], 0x24126ea1);
}

static void uniform_is_flat(void **state)
{
    (void)state;
    enum { N = 200000, BINS = 64 };
    size_t count[BINS] = { 0 };
    double sum = 0, square = 0, chain = 0, before = 0.5;
    for (uint64_t i = 0; i < N; i++) {
        double u = wf_random_uniform(7, 3, i);
        assert_true(u > 0 && u < 1);
        sum += u;
        square += u * u;
        chain += (u - 0.5) * (before - 0.5);
        before = u;
        count[(size_t)(u * BINS)]++;
    }
    double chi = 0, expected = (double)N / BINS;
    for (int b = 0; b < BINS; b++)
        chi += ((double)count[b] - expected) * ((double)count[b] - expected) / expected;
    assert_close(sum / N, 0.5, 3e-3); /* standard error 6.5e-4, i.e. 1.3e-3 relative */
    assert_close(square / N, 1.0 / 3.0, 6e-3);
    assert_true(fabs(chain / N) < 1e-3); /* standard error 1.9e-4 */
    assert_true(chi > 32 && chi < 106);  /* chi-square, 63 degrees of freedom: 0.1 % .. 99.95 % */
}

static void normal_moments(void **state)
{
    (void)state;
    enum { N = 400000 };
    double *z = malloc(N * sizeof *z);
    assert_non_null(z);
    wf_random_normals(11, 5, 0, N, z);
    double m1 = 0, m2 = 0, m3 = 0, m4 = 0, pair = 0;
    for (int i = 0; i < N; i++) {
        m1 += z[i];
        m2 += z[i] * z[i];
        m3 += z[i] * z[i] * z[i];
        m4 += z[i] * z[i] * z[i] * z[i];
        if (i & 1) pair += z[i] * z[i - 1];
    }
    assert_true(fabs(m1 / N) < 5 * 1.6e-3);
    assert_close(m2 / N, 1.0, 5 * 2.3e-3);
    assert_true(fabs(m3 / N) < 5 * 6.2e-3);
    assert_close(m4 / N, 3.0, 5 * 5.2e-3);
    assert_true(fabs(pair / (N / 2)) < 5 * 2.3e-3); /* the two of one counter are independent */
    free(z);
}

/* A draw does not depend on where a run of draws starts, so shards agree to the byte. */
static void runs_agree(void **state)
{
    (void)state;
    double whole[101], part[101];
    wf_random_normals(3, 9, 0, 101, whole);
    for (uint64_t first = 0; first < 7; first++) {
        wf_random_normals(3, 9, first, 101 - first, part);
        assert_memory_equal(part, whole + first, (101 - first) * sizeof(double));
        assert_true(wf_random_normal(3, 9, first) == whole[first]);
    }
    wf_random_normals(3, 9, UINT64_MAX - 1, 4, part); /* indices wrap: time may start before zero */
    assert_memory_equal(part + 2, whole, 2 * sizeof(double));
}

static void streams_differ(void **state)
{
    (void)state;
    double dot = 0;
    for (uint64_t i = 0; i < 20000; i++)
        dot += wf_random_normal(1, wf_random_stream(2, 5, 6), i) *
               wf_random_normal(1, wf_random_stream(2, 6, 5), i);
    assert_true(fabs(dot / 20000) < 5 * 7.1e-3);
    assert_true(wf_random_stream(1, 2, 3) != wf_random_stream(1, 3, 2));
    assert_true(wf_random_stream(1, 2, 3) != wf_random_stream(2, 2, 3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_answers),  cmocka_unit_test(address),    cmocka_unit_test(uniform_is_flat),
        cmocka_unit_test(normal_moments), cmocka_unit_test(runs_agree), cmocka_unit_test(streams_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
