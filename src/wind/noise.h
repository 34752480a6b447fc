/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_NOISE_H
#define WF_WIND_NOISE_H
/* Coherent noise in one dimension: smooth and repeatable; the address of each lattice number is (seed,
 * stream, lattice point). */
#include <stdint.h>

/* Gradient noise. Given: position x [-]. Returned: (1-f) g0 t + f g1 (t-1), with t the place between the
 * lattice points around x, g the slopes there, uniform in -1..1, and f = 6t^5 - 15t^4 + 10t^3.
 * Exactly zero at every lattice point; continuous to the second derivative; symmetric about zero; within
 * -1/2..1/2. Source: Perlin K. (2002), Improving noise, ACM Trans. Graph. 21(3):681-682. */
double wf_noise_gradient(uint64_t seed, uint64_t stream, double x);
/* The same for slopes of -1..1 given by the caller, t in 0..1. */
double wf_noise_gradient_cell(double g0, double g1, double t);

/* Value noise: numbers uniform in 0..1 at the lattice points, interpolated by the same f. Mean 1/2, within
 * 0..1. Zhao & Zhang (2013) call this Perlin noise in their wind model. */
double wf_noise_value(uint64_t seed, uint64_t stream, double x);

/* Sum of octaves: N(x) = sum_i persistence^i n(lacunarity^i x + shift_i), i < octaves. */
struct wf_octaves {
    unsigned count;     /* 1..16                                             */
    double persistence; /* amplitude ratio of neighbouring octaves, 0..1 [-] */
    double lacunarity;  /* frequency ratio, above 1 [-]                      */
    int shifted;        /* 0: shift_i = 0, so that N vanishes at lattice points that all octaves share;
                           1: shift_i drawn once from 0..1, so that N is stationary */
};
double wf_noise_octaves(uint64_t seed, uint64_t stream, const struct wf_octaves *o, double x);
/* Upper bound of |N|: 1/2 sum persistence^i. */
double wf_noise_range(const struct wf_octaves *o);
/* Variance of N over all slopes and places: 535/27027 sum persistence^2i (exact integral of the quintic). */
double wf_noise_variance(const struct wf_octaves *o);

/* Angles of a fluttering leaf: three octave sums; a share `follow` of the first is added to the third. Given:
 * number of the leaf, time over the noise's period [-], amplitudes [rad]. Returned: angle[3] [rad]. They
 * affect the picture only, not the loads. Source: Zhao P., Zhang Z. (2013), Comput. Eng. Appl.
 * 49(14):160-163. */
struct wf_leaf_flutter {
    struct wf_octaves octaves;
    double amplitude[3], follow;
};
void wf_noise_leaf(uint64_t seed, uint64_t leaf, const struct wf_leaf_flutter *f, double x, double angle[3]);
#endif
