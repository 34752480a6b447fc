/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_RANDOM_H
#define WF_BASE_RANDOM_H
/* Counter-based random numbers: a draw is a pure function of its address (seed, stream, index) and does not
 * depend on earlier draws. The same address gives the same bits in any thread and in any order.
 * Method: Philox4x32-10. Source: Salmon J.K., Moraes M.A., Dror R.O., Shaw D.E. (2011), Parallel random
 * numbers: as easy as 1, 2, 3, SC'11. */
#include <stddef.h>
#include <stdint.h>

/* The Philox bijection: ten rounds on a 128-bit counter with a 64-bit key. */
void wf_philox4x32(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4]);

/* Four random words at an address. Key = seed; counter = index (low 64 bits), stream (high 64 bits), so that
 * different addresses never share a counter. */
void wf_random_words(uint64_t seed, uint64_t stream, uint64_t index, uint32_t out[4]);

/* A draw from the uniform distribution on the open interval (0, 1), with 52 bits: never 0, never 1. */
double wf_random_uniform(uint64_t seed, uint64_t stream, uint64_t index);

/* A draw from the standard normal distribution, and n successive ones: `first`, first+1, ... of a stream.
 * Method: draws 2i and 2i+1 are computed from one counter (Box & Muller 1958, A note on the generation of
 * random normal deviates), so n successive draws cost half as much as n single ones; the value at an index
 * does not depend on `first`. */
double wf_random_normal(uint64_t seed, uint64_t stream, uint64_t index);
void wf_random_normals(uint64_t seed, uint64_t stream, uint64_t first, size_t n, double *out);

/* A stream number for a purpose and up to two indices; different purposes give different streams for
 * a < 2^28, b < 2^28. */
uint64_t wf_random_stream(uint8_t purpose, uint64_t a, uint64_t b);
#endif
