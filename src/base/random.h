/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_RANDOM_H
#define WF_BASE_RANDOM_H
/* Random numbers that have an address instead of a history: a draw is a pure function of (seed, stream,
 * index). Any thread, shard or rank that asks for the same address gets the same bits, in any order.
 * Method: Philox4x32-10. Source: Salmon J.K., Moraes M.A., Dror R.O., Shaw D.E. (2011), Parallel random
 * numbers: as easy as 1, 2, 3, SC'11. */
#include <stddef.h>
#include <stdint.h>

/* The bijection itself: ten rounds on a 128-bit counter under a 64-bit key. */
void wf_philox4x32(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4]);

/* Key = seed; counter = index (low 64 bits), stream (high 64 bits). All addresses are distinct. */
void wf_random_words(uint64_t seed, uint64_t stream, uint64_t index, uint32_t out[4]);

/* Uniform on the open interval (0, 1), 52 bits: never 0, never 1. */
double wf_random_uniform(uint64_t seed, uint64_t stream, uint64_t index);

/* Standard normal draws `first`, first+1, ... of a stream. Draws 2i and 2i+1 come from one counter
 * (Box & Muller 1958, A note on the generation of random normal deviates), so a run of them costs half of
 * single draws; the value at an index does not depend on where a run starts. */
double wf_random_normal(uint64_t seed, uint64_t stream, uint64_t index);
void wf_random_normals(uint64_t seed, uint64_t stream, uint64_t first, size_t n, double *out);

/* A stream number for a purpose and up to two indices: purposes cannot collide for a < 2^28, b < 2^28. */
uint64_t wf_random_stream(uint8_t purpose, uint64_t a, uint64_t b);
#endif
