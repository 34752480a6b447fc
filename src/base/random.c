/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/random.h"
#include "base/num.h"
#include <math.h>

static void multiply_wide(uint32_t a, uint32_t b, uint32_t *high, uint32_t *low)
{
    uint64_t p = (uint64_t)a * b;
    *high = (uint32_t)(p >> 32);
    *low = (uint32_t)p;
}

void wf_philox4x32(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
    uint32_t c0 = counter[0], c1 = counter[1], c2 = counter[2], c3 = counter[3];
    uint32_t k0 = key[0], k1 = key[1];
    for (int round = 0; round < 10; round++) {
        uint32_t h0, l0, h1, l1;
        multiply_wide(0xD2511F53u, c0, &h0, &l0);
        multiply_wide(0xCD9E8D57u, c2, &h1, &l1);
        c0 = h1 ^ c1 ^ k0;
        c1 = l1;
        c2 = h0 ^ c3 ^ k1;
        c3 = l0;
        k0 += 0x9E3779B9u; /* golden ratio       */
        k1 += 0xBB67AE85u; /* square root of 3-1 */
    }
    out[0] = c0, out[1] = c1, out[2] = c2, out[3] = c3;
}

void wf_random_words(uint64_t seed, uint64_t stream, uint64_t index, uint32_t out[4])
{
    const uint32_t counter[4] = { (uint32_t)index, (uint32_t)(index >> 32), (uint32_t)stream,
                                  (uint32_t)(stream >> 32) };
    const uint32_t key[2] = { (uint32_t)seed, (uint32_t)(seed >> 32) };
    wf_philox4x32(counter, key, out);
}

/* 52 bits plus half a step: symmetric about 1/2, exactly representable, never 0 or 1. */
static double open_unit_interval(uint32_t high, uint32_t low)
{
    uint64_t bits = ((uint64_t)high << 32 | low) >> 12;
    return ((double)bits + 0.5) * 0x1p-52;
}

double wf_random_uniform(uint64_t seed, uint64_t stream, uint64_t index)
{
    uint32_t w[4];
    wf_random_words(seed, stream, index, w);
    return open_unit_interval(w[0], w[1]);
}

static void normal_pair(uint64_t seed, uint64_t stream, uint64_t pair, double out[2])
{
    uint32_t w[4];
    wf_random_words(seed, stream, pair, w);
    double radius = sqrt(-2.0 * log(open_unit_interval(w[0], w[1])));
    double angle = WF_TURN * open_unit_interval(w[2], w[3]);
    out[0] = radius * cos(angle);
    out[1] = radius * sin(angle);
}

double wf_random_normal(uint64_t seed, uint64_t stream, uint64_t index)
{
    double z[2];
    normal_pair(seed, stream, index >> 1, z);
    return z[index & 1];
}

void wf_random_normals(uint64_t seed, uint64_t stream, uint64_t first, size_t n, double *out)
{
    size_t i = 0;
    if (n && (first & 1)) out[i++] = wf_random_normal(seed, stream, first);
    for (; i + 1 < n; i += 2) normal_pair(seed, stream, (first + i) >> 1, out + i);
    if (i < n) out[i] = wf_random_normal(seed, stream, first + i);
}

uint64_t wf_random_stream(uint8_t purpose, uint64_t a, uint64_t b)
{
    return (uint64_t)purpose << 56 | (a & 0xFFFFFFFu) << 28 | (b & 0xFFFFFFFu);
}
