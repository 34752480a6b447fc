/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_CHAIN_H
#define WF_TESTS_CHAIN_H
/* Trees for the tests of the chain solver. */
#include "close.h"
#include "solve/chain.h"
#include "solve/solve.h"
#include <string.h>

#define PI 3.14159265358979323846
static const double E = 9e9, G = 0.6e9, RADIUS = 0.05, HEIGHT = 7;
static const double ei = 9e9 * PI / 4 * 6.25e-6; /* RADIUS^4 */

struct fixture {
    struct wf_arena arena;
    struct wf_tree t;
    struct wf_loads l;
    struct wf_solve_options o;
    struct wf_response r;
    struct wf_diag d;
    struct wf_err e;
};

static inline void setup(struct fixture *f, size_t n)
{
    *f = (struct fixture){ 0 };
    f->d.arena = &f->arena;
    wf_loads_default(&f->l);
    wf_solve_options_default(&f->o);
    f->l.gravity = 0;
    assert_int_equal(wf_tree_alloc(&f->t, n, &f->arena, &f->e), WF_OK);
    for (size_t i = 0; i < n; i++) f->t.youngs[i] = E, f->t.shear[i] = G, f->t.density[i] = 900;
}

static inline void row(struct fixture *f, size_t i, int32_t parent, const double a[3], const double b[3],
                       double r0, double r1)
{
    struct wf_tree *t = &f->t;
    t->parent[i] = parent;
    t->x0[i] = a[0], t->y0[i] = a[1], t->z0[i] = a[2], t->x1[i] = b[0], t->y1[i] = b[1], t->z1[i] = b[2];
    t->r0[i] = r0, t->r1[i] = r1;
}

/* A straight stem of n equal rows towards `axis`, radius linear from RADIUS to tip*RADIUS. */
static inline void stem(struct fixture *f, size_t n, const double axis[3], double tip)
{
    setup(f, n);
    for (size_t i = 0; i < n; i++) {
        double s0 = (double)i / (double)n, s1 = (double)(i + 1) / (double)n, a[3], b[3];
        for (int k = 0; k < 3; k++) a[k] = s0 * HEIGHT * axis[k], b[k] = s1 * HEIGHT * axis[k];
        row(f, i, (int32_t)i - 1, a, b, RADIUS * (1 - (1 - tip) * s0), RADIUS * (1 - (1 - tip) * s1));
    }
}

/* Dead line load along x, from q0 at the base to q1 at the tip. */
static inline void line_x(struct fixture *f, double q0, double q1)
{
    size_t n = f->t.n;
    double *line = WF_TAKE(&f->arena, 6 * n, double);
    for (size_t i = 0; i < n; i++) {
        line[6 * i] = q0 + (q1 - q0) * (double)i / (double)n;
        line[6 * i + 3] = q0 + (q1 - q0) * (double)(i + 1) / (double)n;
    }
    f->l.line = line;
}

static inline void solve(struct fixture *f, const struct wf_chain_scheme *c)
{
    assert_int_equal(wf_chain_solve(c, &f->t, &f->l, &f->o, &f->arena, &f->r, &f->d, &f->e), WF_OK);
    assert_true(f->r.small_deflection && f->r.load_factor == 1 && f->r.imbalance < 1e-12);
}
#endif
