/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/fourier.h"
#include "base/num.h"
#include "base/vec3.h"
#include <math.h>
#include <string.h>

enum { SERIES = WF_FOURIER_SERIES };

struct point {
    wf_four re, im;
};

struct wf_fourier {
    size_t n, half;
    double *c, *s;        /* n each: cos and sin of 2 pi k/n */
    struct point *x, *to; /* half each */
};

enum wf_status wf_fourier_open(size_t n, struct wf_arena *a, struct wf_fourier **out, struct wf_err *e)
{
    if (n < 4 || (n & (n - 1)))
        return wf_fail(e, WF_EUSAGE, "a transform of %zu steps: a power of two is wanted", n);
    struct wf_fourier *f = WF_TAKE(a, 1, struct wf_fourier);
    if (!f) return wf_fail(e, WF_ENOMEM, "not enough memory for a Fourier transform of %zu steps", n);
    *f = (struct wf_fourier){ .n = n,
                              .half = n / 2,
                              .c = WF_TAKE(a, n, double),
                              .s = WF_TAKE(a, n, double),
                              .x = WF_TAKE(a, n / 2, struct point),
                              .to = WF_TAKE(a, n / 2, struct point) };
    if (!f->c || !f->s || !f->x || !f->to)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a Fourier transform of %zu steps", n);
    for (size_t k = 0; k < n; k++) {
        double angle = WF_TURN * (double)k / (double)n;
        f->c[k] = cos(angle), f->s[k] = sin(angle);
    }
    *out = f;
    return WF_OK;
}

/* to = x exp(-2 pi i k/n). By pointers: vectors as arguments depend on the processor that is compiled for. */
WF_INLINE void turn(const struct wf_fourier *f, size_t k, const struct point *x, struct point *to)
{
    to->re = x->re * f->c[k] + x->im * f->s[k];
    to->im = x->im * f->c[k] - x->re * f->s[k];
}

/* One pass: `count` transforms of length 4 `quarter`, interleaved, become four times as many of length
 * `quarter`. */
WF_INLINE void radix_four(const struct wf_fourier *f, size_t quarter, size_t count, const struct point *x,
                          struct point *to)
{
    const size_t step = f->n / (4 * quarter);
    for (size_t p = 0; p < quarter; p++)
        for (size_t q = 0; q < count; q++) {
            const struct point *a = x + q + count * p, *b = a + count * quarter, *c = b + count * quarter,
                               *d = c + count * quarter;
            struct point *y = to + q + 4 * count * p;
            wf_four sum_re = a->re + c->re, sum_im = a->im + c->im, off_re = a->re - c->re,
                    off_im = a->im - c->im;
            wf_four odd_re = b->re + d->re, odd_im = b->im + d->im;
            wf_four across_re = d->im - b->im, across_im = b->re - d->re; /* i (b - d) */
            y[0].re = sum_re + odd_re, y[0].im = sum_im + odd_im;
            const struct point one = { off_re - across_re, off_im - across_im },
                               two = { sum_re - odd_re, sum_im - odd_im },
                               three = { off_re + across_re, off_im + across_im };
            turn(f, step * p, &one, &y[count]);
            turn(f, 2 * step * p, &two, &y[2 * count]);
            turn(f, 3 * step * p, &three, &y[3 * count]);
        }
}

WF_INLINE void radix_two(size_t count, const struct point *x, struct point *to)
{
    for (size_t q = 0; q < count; q++) {
        const struct point *a = x + q, *b = a + count;
        to[q].re = a->re + b->re, to[q].im = a->im + b->im;
        to[q + count].re = a->re - b->re, to[q + count].im = a->im - b->im;
    }
}

/* The complex transform of f->x, forward. Returned: its place, f->x or f->to. */
WF_WIDE static struct point *transform(struct wf_fourier *f)
{
    struct point *x = f->x, *to = f->to;
    size_t length = f->half, count = 1;
    for (; length >= 4; length /= 4, count *= 4) {
        radix_four(f, length / 4, count, x, to);
        struct point *swap = x;
        x = to, to = swap;
    }
    if (length < 2) return x;
    radix_two(count, x, to);
    return to;
}

/* A real series x(2j) + i x(2j+1), transformed to Z, has the spectrum X(k) = E + exp(-2 pi i k/n) O with
 * 2 E = Z(k) + conj Z(half - k), 2 i O = Z(k) - conj Z(half - k). */
WF_WIDE static void part(struct wf_fourier *f, const struct point *z, wf_four *out)
{
    const size_t half = f->half;
    out[0] = z[0].re + z[0].im, out[f->n - 1] = z[0].re - z[0].im;
    for (size_t k = 1; k < half; k++) {
        const struct point *a = &z[k], *b = &z[half - k];
        wf_four even_re = 0.5 * (a->re + b->re), even_im = 0.5 * (a->im - b->im);
        wf_four odd_re = 0.5 * (a->im + b->im), odd_im = 0.5 * (b->re - a->re);
        out[2 * k - 1] = even_re + f->c[k] * odd_re + f->s[k] * odd_im;
        out[2 * k] = even_im + f->c[k] * odd_im - f->s[k] * odd_re;
    }
}

/* The reverse of `part`, with real and imaginary parts exchanged, which makes a forward transform an inverse
 * one, and divided by n/2. */
WF_WIDE static void join(struct wf_fourier *f, const wf_four *in, struct point *z)
{
    const size_t half = f->half;
    const double share = 0.5 / (double)half;
    z[0].im = share * (in[0] + in[f->n - 1]), z[0].re = share * (in[0] - in[f->n - 1]);
    for (size_t k = 1; k < half; k++) {
        const size_t m = half - k;
        wf_four even_re = share * (in[2 * k - 1] + in[2 * m - 1]), even_im = share * (in[2 * k] - in[2 * m]);
        wf_four far_re = share * (in[2 * k - 1] - in[2 * m - 1]), far_im = share * (in[2 * k] + in[2 * m]);
        wf_four odd_re = f->c[k] * far_re - f->s[k] * far_im, odd_im = f->c[k] * far_im + f->s[k] * far_re;
        z[k].im = even_re - odd_im, z[k].re = even_im + odd_re;
    }
}

/* Rows of four numbers, one of each series. */
static void gather(const struct wf_fourier *f, double *const series[SERIES], wf_four *rows)
{
    for (size_t i = 0; i < f->n; i++)
        rows[i] = (wf_four){ series[0][i], series[1][i], series[2][i], series[3][i] };
}

/* exchange 1: the second of each pair of rows comes first. */
static void scatter(const struct wf_fourier *f, const wf_four *rows, size_t exchange,
                    double *const series[SERIES])
{
    for (int lane = 0; lane < SERIES; lane++)
        for (size_t i = 0; i < f->n; i++) series[lane][i] = rows[i ^ exchange][lane];
}

void wf_fourier_forward(struct wf_fourier *f, double *const series[SERIES])
{
    gather(f, series, &f->x->re);
    struct point *z = transform(f);
    struct point *out = z == f->x ? f->to : f->x;
    part(f, z, &out->re);
    scatter(f, &out->re, 0, series);
}

void wf_fourier_inverse(struct wf_fourier *f, double *const series[SERIES])
{
    gather(f, series, &f->to->re);
    join(f, &f->to->re, f->x);
    struct point *z = transform(f);
    scatter(f, &z->re, 1, series);
}
