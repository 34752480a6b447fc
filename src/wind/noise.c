/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/noise.h"
#include "base/random.h"
#include <math.h>

enum { STREAM_SHIFT = 0x21, STREAM_OCTAVE = 0x22 };

static double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

/* The number at lattice point k. Negative k have addresses too: the index wraps (two's complement). */
static double lattice(uint64_t seed, uint64_t stream, double k)
{
    return wf_random_uniform(seed, stream, (uint64_t)(int64_t)k);
}

double wf_noise_gradient_cell(double g0, double g1, double t)
{
    double f = fade(t);
    return (1.0 - f) * g0 * t + f * g1 * (t - 1.0);
}

double wf_noise_gradient(uint64_t seed, uint64_t stream, double x)
{
    double k = floor(x);
    double g0 = 2.0 * lattice(seed, stream, k) - 1.0, g1 = 2.0 * lattice(seed, stream, k + 1.0) - 1.0;
    return wf_noise_gradient_cell(g0, g1, x - k);
}

double wf_noise_value(uint64_t seed, uint64_t stream, double x)
{
    double k = floor(x), f = fade(x - k);
    return (1.0 - f) * lattice(seed, stream, k) + f * lattice(seed, stream, k + 1.0);
}

/* The shift of octave i. */
static double noise_shift(uint64_t seed, uint64_t stream, const struct wf_octaves *o, unsigned i)
{
    return o->shifted ? wf_random_uniform(seed, wf_random_stream(STREAM_SHIFT, stream, i), 0) : 0.0;
}

double wf_noise_octaves(uint64_t seed, uint64_t stream, const struct wf_octaves *o, double x)
{
    double sum = 0.0, amplitude = 1.0, frequency = 1.0;
    for (unsigned i = 0; i < o->count; i++) {
        double at = frequency * x + noise_shift(seed, stream, o, i);
        sum += amplitude * wf_noise_gradient(seed, wf_random_stream(STREAM_OCTAVE, stream, i), at);
        amplitude *= o->persistence;
        frequency *= o->lacunarity;
    }
    return sum;
}

static double power_sum(const struct wf_octaves *o, double ratio)
{
    double sum = 0.0, term = 1.0;
    for (unsigned i = 0; i < o->count; i++, term *= ratio) sum += term;
    return sum;
}

double wf_noise_range(const struct wf_octaves *o) { return 0.5 * power_sum(o, o->persistence); }

double wf_noise_variance(const struct wf_octaves *o)
{
    return 535.0 / 27027.0 * power_sum(o, o->persistence * o->persistence);
}

void wf_noise_leaf(uint64_t seed, uint64_t leaf, const struct wf_leaf_flutter *f, double x, double angle[3])
{
    for (unsigned axis = 0; axis < 3; axis++)
        angle[axis] = f->amplitude[axis] * wf_noise_octaves(seed, 3 * leaf + axis, &f->octaves, x);
    angle[2] += f->follow * angle[0];
}
