/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/prism_rest.h"
#include "base/num.h"
#include "solve/prism_blocks.h"
#include <math.h>
#include <string.h>

enum { NEWTON_MOST = 60, HALVED_MOST = 10, ROUNDS_MOST = 4000 };

/* ---- Equilibrium ---- */

struct settling {
    const struct wf_prism *p;
    const double *f;
    struct wf_prism_blocks *b;
    double *force, *step; /* 9 sections; 9 unknown */
    double size;          /* of the axes [m] */
};

/* What is out of balance under a share of the loads, into s->step [N]. */
static void imbalance(const struct settling *s, const double *x, double share)
{
    const struct wf_prism *p = s->p;
    for (size_t i = 0; i < 9 * p->sections; i++) s->force[i] = share * s->f[i];
    wf_prism_forces(p, x, s->force, NULL);
    for (size_t k = 0; k < p->unknown; k++)
        memcpy(s->step + 9 * k, s->force + 9 * (size_t)p->order[k], 9 * sizeof *s->step);
}

static void move(const struct wf_prism *p, const double *step, double share, double *x)
{
    for (size_t k = 0; k < p->unknown; k++)
        for (size_t i = 0; i < 9; i++) x[9 * (size_t)p->order[k] + i] += share * step[9 * k + i];
    wf_prism_follow(p, x);
}

/* Newton's method at a share of the loads. Returned: whether it converged. */
static bool converge(const struct settling *s, double share, double *x)
{
    double last = INFINITY;
    for (int i = 0; i < NEWTON_MOST; i++) {
        double longest = 0, arm = s->p->arm[0];
        imbalance(s, x, share);
        for (int whole = 1; whole >= 0; whole--) {
            wf_prism_blocks_fill(s->p, x, x, 0, 1, 0, whole, s->b);
            if (wf_prism_blocks_factor(s->b)) break;
            if (!whole) return false;
        }
        for (size_t k = 0; k < s->p->axes; k++) arm = fmax(arm, s->p->arm[k]);
        wf_prism_blocks_solve(s->b, s->step);
        for (size_t k = 0; k < 9 * s->p->unknown; k++) longest = fmax(longest, fabs(s->step[k]));
        if (!isfinite(longest)) return false;
        move(s->p, s->step, fmin(1, 2 * arm / longest), x);
        /* the last correction is what the answer is off by, or rounding: then it no longer shrinks */
        if (longest <= 1e-13 * s->size || (longest <= 1e-10 * s->size && longest >= 0.5 * last)) return true;
        last = longest;
    }
    return false;
}

enum wf_status wf_prism_settle(const struct wf_prism *p, const double *f, double *x, struct wf_arena *a,
                               struct wf_err *e)
{
    struct wf_prism_blocks b;
    struct settling s = { .p = p, .f = f, .b = &b };
    size_t n = 9 * p->sections;
    double *kept = WF_TAKE(a, n, double), done = 0, step = 1;
    s.force = WF_TAKE(a, n, double);
    s.step = WF_TAKE(a, 9 * p->unknown, double);
    if (!kept || !s.force || !s.step) return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    enum wf_status status = wf_prism_blocks_make(p, a, &b, e);
    if (status) return status;
    for (size_t i = 0; i < n; i++) s.size = fmax(s.size, fabs(p->rest[i] - p->rest[i % 3]));
    for (int halved = 0; done < 1;) {
        memcpy(kept, x, n * sizeof *x);
        double to = fmin(1, done + step);
        if (converge(&s, to, x)) {
            done = to;
            continue;
        }
        memcpy(x, kept, n * sizeof *x);
        step /= 2;
        if (++halved > HALVED_MOST)
            return wf_fail(e, WF_ENOCONV, "prisms: no equilibrium was found beyond %.3g of the loads", done);
    }
    return WF_OK;
}

/* ---- Frequencies ---- */

/* out = M v over the unknown sections. */
static void apply_mass(const struct wf_prism *p, const double *matrix, const double *v, double *out)
{
    for (size_t k = 0; k < p->unknown; k++) {
        const double *m = matrix + 9 * p->order[k], *in = v + 9 * k;
        for (size_t i = 0; i < 3; i++)
            for (size_t c = 0; c < 3; c++)
                out[9 * k + 3 * i + c] =
                    m[3 * i] * in[c] + m[3 * i + 1] * in[3 + c] + m[3 * i + 2] * in[6 + c];
    }
}

static double dot(const double *u, const double *v, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += u[i] * v[i];
    return sum;
}

enum wf_status wf_prism_frequency(const struct wf_prism *p, const double *x, const double *start,
                                  struct wf_arena *a, double *frequency, struct wf_err *e)
{
    struct wf_prism_blocks b;
    size_t n = 9 * p->unknown;
    double *v = WF_TAKE(a, n, double), *mv = WF_TAKE(a, n, double), last = 0;
    enum wf_status s = v && mv ? wf_prism_blocks_make(p, a, &b, e) : wf_fail(e, WF_ENOMEM, "no memory");
    if (s) return s;
    for (size_t k = 0; k < p->unknown; k++)
        for (size_t i = 0; i < 9; i++)
            v[9 * k + i] = start ? start[9 * (size_t)p->order[k] + i] : 1 + 0.1 * (double)(i % 3);
    wf_prism_blocks_fill(p, x, x, 0, 1, 0, false, &b);
    if (!wf_prism_blocks_factor(&b)) return wf_fail(e, WF_ENOCONV, "prisms: the springs hold no shape");
    for (int i = 0; i < ROUNDS_MOST; i++) {
        apply_mass(p, p->mass, v, mv);
        double size = sqrt(dot(v, mv, n));
        for (size_t k = 0; k < n; k++) v[k] = mv[k] / size;
        wf_prism_blocks_solve(&b, v);
        double square = 1 / dot(v, mv, n) * size; /* 1/(u' M K^-1 M u) with u' M u = 1 */
        if (fabs(square - last) <= 1e-9 * square) {
            *frequency = sqrt(square) / WF_TURN;
            return WF_OK;
        }
        last = square;
    }
    return wf_fail(e, WF_ENOCONV, "prisms: the lowest frequency was not found");
}

enum wf_status wf_prism_fastest(const struct wf_prism *p, const double *x, struct wf_arena *a, double *omega,
                                struct wf_err *e)
{
    size_t n = 9 * p->sections, m = 9 * p->unknown;
    double *v = WF_TAKE(a, m, double), *out = WF_TAKE(a, m, double), *f = WF_TAKE(a, n, double);
    double *y = WF_TAKE(a, n, double), square = 0;
    if (!v || !out || !f || !y) return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    for (size_t i = 0; i < m; i++) v[i] = sin(1 + 2.3 * (double)i) + 0.1;
    for (int round = 0; round < 300; round++) { /* K v by a difference of forces */
        double size = sqrt(dot(v, v, m)), step = 1e-6 * p->arm[0];
        for (size_t i = 0; i < m; i++) v[i] /= size;
        for (int side = 0; side < 2; side++) {
            double share = side ? -step : step;
            memcpy(y, x, n * sizeof *y);
            move(p, v, share, y);
            memset(f, 0, n * sizeof *f);
            wf_prism_forces(p, y, f, NULL);
            for (size_t k = 0; k < p->unknown; k++)
                for (size_t i = 0; i < 9; i++)
                    out[9 * k + i] =
                        (side ? out[9 * k + i] : 0) - f[9 * (size_t)p->order[k] + i] / (2 * share);
        }
        apply_mass(p, p->inverse, out, v);
        square = sqrt(dot(v, v, m));
    }
    *omega = 1.02 * sqrt(square);
    return WF_OK;
}
