/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_BEAM_CASES_H
#define WF_TESTS_BEAM_CASES_H
/* Trees and loads for the tests and measurements of the structural engine. */
#include "close.h"
#include "load/drag.h"
#include "solve/beam.h"
#include "solve/solve.h"
#include <string.h>

#define PI 3.14159265358979323846

struct beam_case {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    struct wf_tree tree;
    struct wf_loads loads;
    struct wf_wind wind;
    struct wf_solve_options options;
    struct wf_point_load point[4];
    struct wf_response out;
};

/* n rows of wood (E 9 GPa, nu 0.3, 800 kg/m3, drag 1), weightless, in still air. */
static inline void beam_new(struct beam_case *c, size_t n)
{
    *c = (struct beam_case){ .wind = { .sample = wf_profile_named("uniform")->sample,
                                       .direction = { 1, 0, 0 },
                                       .reference_height = 10,
                                       .roughness = 0.01 } };
    c->diag.arena = &c->arena;
    wf_loads_default(&c->loads);
    wf_solve_options_default(&c->options);
    c->loads.gravity = 0;
    c->loads.point = c->point;
    assert_int_equal(wf_tree_alloc(&c->tree, n, &c->arena, &c->err), WF_OK);
    for (size_t i = 0; i < n; i++)
        c->tree.youngs[i] = 9e9, c->tree.shear[i] = 9e9 / 2.6, c->tree.density[i] = 800, c->tree.drag[i] = 1;
}

static inline void beam_free(struct beam_case *c) { wf_arena_free(&c->arena); }

static inline void beam_row(struct beam_case *c, size_t i, int32_t parent, const double a[3],
                            const double b[3], double r0, double r1)
{
    struct wf_tree *t = &c->tree;
    t->parent[i] = parent;
    t->x0[i] = a[0], t->y0[i] = a[1], t->z0[i] = a[2];
    t->x1[i] = b[0], t->y1[i] = b[1], t->z1[i] = b[2];
    t->r0[i] = r0, t->r1[i] = r1;
}

/* A straight stem of n equal rows from the origin towards `axis`, radius linear from r0 to r1. */
static inline void beam_stem(struct beam_case *c, size_t n, const double axis[3], double length, double r0,
                             double r1)
{
    beam_new(c, n);
    for (size_t i = 0; i < n; i++) {
        double s0 = (double)i / (double)n, s1 = (double)(i + 1) / (double)n, a[3], b[3];
        for (int k = 0; k < 3; k++) a[k] = s0 * length * axis[k], b[k] = s1 * length * axis[k];
        beam_row(c, i, (int32_t)i - 1, a, b, r0 + (r1 - r0) * s0, r0 + (r1 - r0) * s1);
    }
}

static const double upright[3] = { 0, 0, 1 };

/* Upright, of n rows, length and bending stiffness 1, inextensible; `mass` per length. */
static inline void beam_unit(struct beam_case *c, size_t n, double mass)
{
    beam_stem(c, n, upright, 1, 1e-3, 1e-3);
    c->options.inextensible = true;
    c->tree.stiff = WF_TAKE(&c->arena, 4 * n, double);
    for (size_t i = 0; i < n; i++) {
        c->tree.density[i] = 0;
        c->tree.burden0[i] = c->tree.burden1[i] = mass;
        for (size_t k = 0; k < 4; k++) c->tree.stiff[4 * i + k] = 1;
    }
}

static inline struct wf_point_load *beam_push(struct beam_case *c, size_t row, enum wf_point_kind kind,
                                              double x, double y, double z)
{
    struct wf_point_load *p = &c->point[c->loads.points++];
    *p = (struct wf_point_load){ .segment = (int32_t)row, .kind = kind, .force = { x, y, z } };
    return p;
}

/* The same dead load [N/m] everywhere. */
static inline void beam_line(struct beam_case *c, double x, double y, double z)
{
    double *line = WF_TAKE(&c->arena, 6 * c->tree.n, double);
    for (size_t i = 0; i < 2 * c->tree.n; i++) line[3 * i] = x, line[3 * i + 1] = y, line[3 * i + 2] = z;
    c->loads.line = line;
}

static inline void beam_blow(struct beam_case *c, double x, double y, double z)
{
    const double u[3] = { x, y, z };
    c->wind.speed = sqrt(x * x + y * y + z * z);
    for (int k = 0; k < 3 && c->wind.speed > 0; k++) c->wind.direction[k] = u[k] / c->wind.speed;
    c->loads.wind = &c->wind;
}

static inline void beam_masses(struct beam_case *c) { c->tree.mass1 = WF_TAKE(&c->arena, c->tree.n, double); }

static inline enum wf_status beam_try(struct beam_case *c, const struct wf_solver *solver)
{
    c->err = (struct wf_err){ 0 };
    return solver->solve(&c->tree, &c->loads, &c->options, &c->arena, &c->out, &c->diag, &c->err);
}

/* Solve; the loads must be balanced to rounding. */
static inline void beam_solve(struct beam_case *c)
{
    if (beam_try(c, &wf_solver_beam)) fail_msg("%s", c->err.text);
    if (!(c->out.imbalance < 1e-12)) fail_msg("imbalance %g", c->out.imbalance);
}

struct beam_branch {
    int from, to;
    double r0, r1;
};
/* A tree drawn as nodes and branches (one row a branch, in the order given; node 0 on the ground). */
static inline void beam_tree(struct beam_case *c, size_t n, const double (*node)[3],
                             const struct beam_branch *b)
{
    beam_new(c, n);
    for (size_t i = 0; i < n; i++) {
        int32_t parent = -1;
        for (size_t k = 0; k < i; k++)
            if (b[k].to == b[i].from) parent = (int32_t)k;
        beam_row(c, i, parent, node[b[i].from], node[b[i].to], b[i].r0, b[i].r1);
    }
}

/* A tree of seven nodes on three levels, E 9 GPa, 850 kg/m3. */
static inline void beam_tree7(struct beam_case *c)
{
    static const double node[8][3] = { { 0, 0, 0 },        { 0.1, 0, 3 },     { 0.9, 0.4, 4.8 },
                                       { -0.6, 0.2, 5 },   { 1.9, 0.3, 5.6 }, { 1, 1.3, 6 },
                                       { -1.2, -.7, 6.1 }, { -0.5, 0.9, 6.6 } };
    static const struct beam_branch b[7] = { { 0, 1, .08, .06 },  { 1, 2, .045, .03 },  { 1, 3, .05, .03 },
                                             { 2, 4, .02, .01 },  { 2, 5, .022, .012 }, { 3, 6, .025, .01 },
                                             { 3, 7, .024, .012 } };
    beam_tree(c, 7, node, b);
    for (size_t i = 0; i < 7; i++) c->tree.density[i] = 850;
}

/* A tree of three branches, E 8 GPa, nu 0.35, 900 kg/m3. */
static inline void beam_tree3(struct beam_case *c)
{
    static const double node[4][3] = { { 0, 0, 0 }, { 0, 0, 2 }, { 0.6, 0.2, 3.4 }, { -0.7, -0.3, 3 } };
    static const struct beam_branch b[3] = { { 0, 1, .05, .04 }, { 1, 2, .03, .015 }, { 1, 3, .025, .012 } };
    beam_tree(c, 3, node, b);
    for (size_t i = 0; i < 3; i++)
        c->tree.youngs[i] = 8e9, c->tree.shear[i] = 8e9 / 2.7, c->tree.density[i] = 900;
}

/* Numbers from -1 to 1, the same on every machine. */
static inline double beam_random(uint64_t *s)
{
    *s = *s * 6364136223846793005u + 1442695040888963407u;
    return (double)(*s >> 11) * 0x1p-52 - 1;
}

/* A tree of n rows that branches at random, thinner and shorter outwards. */
static inline void beam_wild(struct beam_case *c, size_t n, uint64_t seed)
{
    uint64_t s = seed;
    beam_new(c, n);
    struct wf_tree *t = &c->tree;
    for (size_t i = 0; i < n; i++) {
        size_t below = i ? (size_t)((double)i * fmin(0.999, fabs(beam_random(&s)))) : 0;
        if (i && beam_random(&s) > 0) below = i - 1;
        double r0 = i ? t->r1[below] * (0.75 + 0.2 * beam_random(&s)) : 0.08;
        double a[3] = { 0, 0, 0 }, d[3] = { 0, 0, 1 }, b[3], size = 0;
        if (i) {
            a[0] = t->x1[below], a[1] = t->y1[below], a[2] = t->z1[below];
            d[0] = a[0] - t->x0[below], d[1] = a[1] - t->y0[below], d[2] = a[2] - t->z0[below];
            for (int k = 0; k < 3; k++) size += d[k] * d[k];
            for (int k = 0; k < 3; k++) d[k] = d[k] / sqrt(size) + 0.6 * beam_random(&s);
        }
        double length = 25 * r0 * (1 + 0.7 * beam_random(&s));
        for (int k = 0; k < 3; k++) b[k] = a[k] + length * d[k];
        beam_row(c, i, i ? (int32_t)below : -1, a, b, r0, r0 * (0.85 + 0.1 * beam_random(&s)));
    }
}

/* Weight, and laws of drag, lift and crown by the seed. */
static inline void beam_laws(struct beam_case *c, uint64_t seed)
{
    static const char *const crown[] = { "none", "vogel", "table" };
    static const double table_speed[] = { 3, 9, 20 }, table_part[] = { 1, 0.6, 0.3 };
    struct wf_loads *l = &c->loads;
    l->gravity = 9.81;
    l->streamline = wf_streamline_named(crown[seed % 3]);
    if (seed % 3 == 1) l->streamline_par.number[0] = -0.7, l->streamline_par.number[1] = 5;
    if (seed % 3 == 2)
        l->streamline_par.list[0] = table_speed, l->streamline_par.list[1] = table_part,
        l->streamline_par.n = 3;
    for (size_t i = 0; i < c->tree.n; i++) {
        c->tree.drag[i] = seed % 4 ? NAN : 1;
        c->tree.lift[i] = seed % 5 ? 0 : 0.2;
        c->tree.sail0[i] = c->tree.sail1[i] = 3 * c->tree.r0[i];
    }
}

/* A wind profile by the seed. */
static inline void beam_profile(struct wf_wind *w, uint64_t seed)
{
    static const char *const profile[] = { "power", "log", "uniform", "canopy", "terrain", "code" };
    enum { PROFILES = 6 };
    w->sample = wf_profile_named(profile[seed % PROFILES])->sample;
    w->exponent = 0.16, w->roughness = 0.03;
    w->canopy_height = 3, w->displacement = seed % PROFILES == 3 ? 2 : 0, w->attenuation = 2;
}
#endif
