/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cables and rods between two points of a tree: closed forms, flexibilities, dense matrices of stiff masts on
 * hinges, the tangent, natural frequencies. */
#include "beam_cases.h"
#include "solve/beam_ends.h"
#include "solve/beam_rest.h"
#include "solve/beam_small.h"
#include "solve/modes.h"
#include <gsl/gsl_eigen.h>
#include <stdlib.h>

enum { MASTS = 3 };
static const double high = 8, hinge = 2e5; /* [m], [N m/rad] */

/* Masts too stiff to bend on soft hinges, their tops at given heights above the ground. */
static void masts(struct beam_case *c, size_t n, const double (*foot)[2], const double *height)
{
    beam_new(c, n);
    for (size_t i = 0; i < n; i++) {
        const double from[3] = { foot[i][0], foot[i][1], 0 }, to[3] = { foot[i][0], foot[i][1], height[i] };
        beam_row(c, i, -1, from, to, 0.1, 0.1);
        c->tree.youngs[i] = c->tree.shear[i] = 1e17;
        c->tree.density[i] = 0;
        c->tree.drag[i] = 0;
    }
    c->options.root_stiffness[0] = c->options.root_stiffness[1] = hinge;
    c->options.inextensible = true;
}

static void two_masts(struct beam_case *c, struct wf_link *link)
{
    static const double foot[2][2] = { { 0, 0 }, { 6, 0 } }, height[2] = { 8, 8 };
    masts(c, 2, foot, height);
    *link = (struct wf_link){ .segment = { 0, 1 }, .stiffness = 2e5, .length = 5.9 };
    c->loads.link = link, c->loads.links = 1;
}

static double pull_of(const struct beam_case *c, const struct wf_link *k, double force[3])
{
    double at[2][3];
    for (int i = 0; i < 2; i++) {
        size_t row = (size_t)k->segment[i];
        const double drawn[3] = { c->tree.x1[row], c->tree.y1[row], c->tree.z1[row] };
        for (size_t q = 0; q < 3; q++) at[i][q] = drawn[q] + c->out.end[3 * row + q];
    }
    return wf_link_pull(k, at[0], at[1], force);
}

/* Two masts pushed apart, each turned by t: P h cos t = c t + N h cos t, N = k (6 + 2 h sin t - l). */
static void two_bars(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_link link;
    double force[3];
    two_masts(&c, &link);
    for (int k = 0; k <= 5; k++) {
        double push = 3e4 * k, low = -1, top = 1;
        for (int i = 0; i < 100; i++) {
            double t = 0.5 * (low + top),
                   pull = fmax(0, link.stiffness * (6 + 2 * high * sin(t) - link.length));
            if ((push - pull) * high * cos(t) - hinge * t > 0)
                low = t;
            else
                top = t;
        }
        c.loads.points = 0;
        beam_push(&c, 0, WF_POINT_DEAD, -push, 0, 0);
        beam_push(&c, 1, WF_POINT_DEAD, push, 0, 0);
        beam_solve(&c);
        double pull = link.stiffness * (6 + 2 * high * sin(low) - link.length);
        assert_close(pull_of(&c, &link, force), pull, 1e-7);
        assert_close(force[0], pull, 1e-7);
        assert_close(c.out.link[0], pull, 1e-7);
        assert_close(c.out.end[3], high * sin(low), 1e-7);
        assert_close(c.out.end[0], -high * sin(low), 1e-7);
        assert_close(c.out.moment0[1], -hinge * low, 1e-6);
        assert_true(fabs(c.out.base_force[0]) <
                    1e-9 * (push + pull)); /* a cable's forces are inside the tree */
    }
    beam_free(&c);
}

/* Energy of the masts turned by v (2 each), their tops loaded by dead forces. */
struct dense {
    size_t masts, links;
    const double (*foot)[2], *height;
    double force[MASTS][3];
    const struct wf_link *link;
};

static void top_of(const struct dense *d, size_t i, const double *v, double at[3])
{
    double turn[3] = { v[2 * i], v[2 * i + 1], 0 }, R[9], up[3] = { 0, 0, d->height[i] };
    rotation_matrix(turn, R);
    m3_apply(R, up, at);
    at[0] += d->foot[i][0], at[1] += d->foot[i][1];
}

static double energy_of(const struct dense *d, const double *v)
{
    double sum = 0, at[2][3], force[3];
    for (size_t i = 0; i < d->masts; i++) {
        top_of(d, i, v, at[0]);
        sum += 0.5 * hinge * (v[2 * i] * v[2 * i] + v[2 * i + 1] * v[2 * i + 1]) - wf_dot(d->force[i], at[0]);
    }
    for (size_t k = 0; k < d->links; k++) {
        for (int i = 0; i < 2; i++) top_of(d, (size_t)d->link[k].segment[i], v, at[i]);
        double pull = wf_link_pull(&d->link[k], at[0], at[1], force);
        sum += 0.5 * pull * pull / d->link[k].stiffness;
    }
    return sum;
}

/* Its gradient and second derivatives, by differences. */
static double slope_of(const struct dense *d, double *v, size_t i)
{
    const double step = 1e-5, here = v[i];
    v[i] = here + step;
    double more = energy_of(d, v);
    v[i] = here - step;
    double less = energy_of(d, v);
    v[i] = here;
    return (more - less) / (2 * step);
}

static void second_of(const struct dense *d, double *v, double *H)
{
    const double step = 1e-4;
    size_t n = 2 * d->masts;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            double here = v[j];
            v[j] = here + step;
            double more = slope_of(d, v, i);
            v[j] = here - step;
            H[i * n + j] = (more - slope_of(d, v, i)) / (2 * step);
            v[j] = here;
        }
}

/* Newton's method on the dense matrix, from a place near the equilibrium. */
static void rest_of(const struct dense *d, double *v)
{
    size_t n = 2 * d->masts;
    double H[36], g[6];
    for (int round = 0; round < 30; round++) {
        second_of(d, v, H);
        for (size_t i = 0; i < n; i++) g[i] = slope_of(d, v, i);
        for (size_t c = 0; c < n; c++)
            for (size_t r = c + 1; r < n; r++) {
                double f = H[r * n + c] / H[c * n + c];
                for (size_t j = c; j < n; j++) H[r * n + j] -= f * H[c * n + j];
                g[r] -= f * g[c];
            }
        for (size_t c = n; c-- > 0;) {
            for (size_t j = c + 1; j < n; j++) g[c] -= H[c * n + j] * g[j];
            g[c] /= H[c * n + c];
        }
        for (size_t i = 0; i < n; i++) v[i] -= g[i];
    }
}

static const double three_feet[MASTS][2] = { { 0, 0 }, { 6, 0.5 }, { 2, 5 } },
                    three_heights[MASTS] = { 8, 7, 9 };

/* Three masts, two cables and a rod, pushed at random: places and forces of the dense solution. */
static void dense_solution(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int round = 0; round < 20; round++) {
        struct beam_case c;
        struct wf_link link[3];
        double v[6] = { 0 }, at[3], force[3], size = 0;
        masts(&c, MASTS, three_feet, three_heights);
        struct dense d = { MASTS, 3, three_feet, three_heights, { { 0 } }, link };
        for (int k = 0; k < 3; k++)
            link[k] = (struct wf_link){ .segment = { k, (k + 1) % 3 },
                                        .stiffness = 5e4 * (2 + beam_random(&seed)),
                                        .length = 5.3 + 0.3 * beam_random(&seed),
                                        .pushes = k == 2 };
        for (size_t i = 0; i < MASTS; i++) {
            for (int q = 0; q < 3; q++) d.force[i][q] = 8e3 * beam_random(&seed);
            beam_push(&c, i, WF_POINT_DEAD, d.force[i][0], d.force[i][1], d.force[i][2]);
        }
        c.loads.link = link, c.loads.links = 3;
        beam_solve(&c);
        for (size_t i = 0; i < 6; i++) v[i] = c.out.turn[i / 2 * 3 + i % 2] + 1e-3 * beam_random(&seed);
        rest_of(&d, v);
        for (size_t i = 0; i < MASTS; i++) {
            top_of(&d, i, v, at);
            const double drawn[3] = { c.tree.x1[i], c.tree.y1[i], c.tree.z1[i] };
            for (size_t q = 0; q < 3; q++) size = fmax(size, fabs(drawn[q] + c.out.end[3 * i + q] - at[q]));
        }
        if (!(size < 1e-6)) fail_msg("round %d: off by %g m", round, size);
        for (int k = 0; k < 3; k++) {
            double ends[2][3];
            for (int i = 0; i < 2; i++) top_of(&d, (size_t)link[k].segment[i], v, ends[i]);
            double want = wf_link_pull(&link[k], ends[0], ends[1], force);
            assert_true(fabs(pull_of(&c, &link[k], force) - want) < 0.2); /* of some 10 kN */
        }
        beam_free(&c);
    }
}

/* Two cantilevers that lean from one foot by 25 deg to either side, a cable between their tips: for small
 * pushes by the flexibilities across, L^3 / 3 E I, and along, L / E A. */
static void v_of_cantilevers(void **state)
{
    (void)state;
    struct beam_case c;
    const double lean = 25 * PI / 180, length = 6, r = 0.06, E = 9e9, area = PI * r * r;
    const double inertia = PI * r * r * r * r / 4, foot[3] = { 0, 0, 0 };
    struct wf_link link = {
        .segment = { 0, 1 }, .stiffness = 4e4, .length = 2 * length * sin(lean), .pushes = true
    };
    beam_new(&c, 2);
    for (size_t i = 0; i < 2; i++)
        beam_row(&c, i, -1, foot, (double[]){ (i ? 1 : -1) * length * sin(lean), 0, length * cos(lean) }, r,
                 r);
    c.loads.link = &link, c.loads.links = 1;
    double give = cos(lean) * cos(lean) * length * length * length / (3 * E * inertia) +
                  sin(lean) * sin(lean) * length / (E * area);
    double found[3] = { 0, 0, 0 }, force[3];
    struct wf_point_load *push = beam_push(&c, 1, WF_POINT_DEAD, 0, 0, 0);
    for (int sign = -1; sign <= 1; sign += 2) { /* terms of second order cancel */
        push->force[0] = 0.5 * sign;
        beam_solve(&c);
        found[0] += sign * pull_of(&c, &link, force);
        found[1] += sign * c.out.end[0], found[2] += sign * c.out.end[3];
    }
    double pull = give / (1 / link.stiffness + 2 * give);
    assert_close(found[0], pull, 1e-6);
    assert_close(found[1], pull * give, 1e-6);
    assert_close(found[2], (1 - pull) * give, 1e-6);
    beam_free(&c);
}

/* The same at the tips of two branches on a stem that bends: the flexibilities are those of the tree without
 * the cable, solved with unit forces. */
static void superposition(void **state)
{
    (void)state;
    struct beam_case c;
    double apart[2], force[3], pull = 0;
    beam_tree3(&c);
    double u[3] = { c.tree.x1[2] - c.tree.x1[1], c.tree.y1[2] - c.tree.y1[1], c.tree.z1[2] - c.tree.z1[1] };
    double length = sqrt(wf_dot(u, u));
    struct wf_link link = { .segment = { 1, 2 }, .stiffness = 3e3, .length = length, .pushes = true };
    for (int k = 0; k < 3; k++) u[k] /= length;
    for (int k = 0; k < 3; k++) { /* pushed; pulled apart by a unit; pushed, with the rod */
        apart[k % 2] = k == 2 ? apart[0] : 0;
        c.loads.link = &link, c.loads.links = k == 2;
        for (int sign = -1; sign <= 1; sign += 2) { /* terms of second order cancel */
            double f = 0.1 * sign;
            c.loads.points = 0;
            if (k == 1) beam_push(&c, 1, WF_POINT_DEAD, -f * u[0], -f * u[1], -f * u[2]);
            if (k == 1) beam_push(&c, 2, WF_POINT_DEAD, f * u[0], f * u[1], f * u[2]);
            if (k != 1) beam_push(&c, 2, WF_POINT_DEAD, -f, -f, 2 * f);
            assert_int_equal(beam_try(&c, &wf_solver_beam), WF_OK);
            if (k == 2) pull += sign * pull_of(&c, &link, force) / 0.2;
            for (int q = 0; q < 3 && k < 2; q++)
                apart[k] += sign * u[q] * (c.out.end[6 + q] - c.out.end[3 + q]) / 0.2;
        }
    }
    assert_true(apart[0] < 0 && apart[1] > 0); /* the rod pushes */
    assert_close(pull, apart[0] / (1 / link.stiffness + apart[1]), 1e-6);
    beam_free(&c);
}

/* The work of the pushes is the energy of hinges and cable. */
static void energy(void **state)
{
    (void)state;
    enum { STEPS = 200 };
    struct beam_case c;
    struct wf_link link;
    double work = 0, before[3] = { 0 }, force[3], pull = 0;
    two_masts(&c, &link);
    link.length = 6;
    beam_push(&c, 0, WF_POINT_DEAD, 0, 0, 0), beam_push(&c, 1, WF_POINT_DEAD, 0, 0, 0);
    for (int k = 1; k <= STEPS; k++) {
        double push = 1e5 * k / STEPS;
        c.point[0].force[0] = -push, c.point[1].force[0] = 0.4 * push, c.point[1].force[1] = 0.2 * push;
        beam_solve(&c);
        pull = pull_of(&c, &link, force);
        const double way[3] = { -c.out.end[0], c.out.end[3], c.out.end[4] }, part[3] = { 1, 0.4, 0.2 };
        for (int q = 0; q < 3; q++)
            work += part[q] * (push - 0.5e5 / STEPS) * (way[q] - before[q]), before[q] = way[q];
    }
    double turns = 0;
    for (size_t i = 0; i < 2; i++) turns += wf_dot(c.out.turn + 3 * i, c.out.turn + 3 * i);
    assert_close(work, 0.5 * pull * pull / link.stiffness + 0.5 * hinge * turns, 2e-5);
    beam_free(&c);
}

/* A wild tree in a wind with links between random rows. */
static void tangle(struct beam_case *c, uint64_t seed, size_t rows, struct wf_link link[3])
{
    uint64_t s = seed + 77;
    beam_wild(c, rows, seed + 1);
    beam_laws(c, seed);
    beam_profile(&c->wind, seed);
    c->wind.least = 0.5, c->wind.speed = 12;
    c->loads.wind = &c->wind;
    c->options.tolerance = 1e-12, c->options.mesh_tolerance = 0;
    c->options.inextensible = true;
    if (seed % 5 == 2) c->options.root_stiffness[0] = c->options.root_stiffness[1] = 1e5;
    for (int k = 0; k < 3; k++) {
        size_t from = (size_t)((double)rows * 0.4 * fabs(beam_random(&s))) + rows / 10;
        size_t to = rows - 1 - (size_t)((double)rows * 0.2 * fabs(beam_random(&s)));
        const struct wf_tree *t = &c->tree;
        double d[3] = { t->x1[to] - t->x1[from], t->y1[to] - t->y1[from], t->z1[to] - t->z1[from] };
        link[k] = (struct wf_link){ .segment = { (int32_t)from, (int32_t)to },
                                    .stiffness = 300,
                                    .length = sqrt(wf_dot(d, d)) * (k == 1 ? 1.01 : 0.98),
                                    .pushes = k == 1 };
    }
    c->loads.link = link, c->loads.links = 3;
}

/* The tangent is exact: from an equilibrium, one Newton step at loads that differ by d errs by d^2. */
static void tangent(void **state)
{
    (void)state;
    size_t tried = 0;
    for (uint64_t seed = 0; seed < 24; seed++) {
        struct beam_case c;
        struct wf_link link[3];
        struct wf_beam b, step;
        double off[3] = { 0 };
        tangle(&c, seed, 20 + 4 * seed, link);
        if (wf_beam_init(&b, &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err) ||
            wf_beam_init(&step, &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err))
            fail_msg("%s", c.err.text);
        bool rests = wf_beam_rests(&b);
        for (int k = 0; k < 3 && rests; k++) {
            double more = 0.1 * pow(0.5, k);
            wf_beam_carry(&b, &step);
            step.loads.weight_scale = 1 + more;
            wf_beam_rest(&step.mesh, step.loads.gravity * (1 + more));
            wf_beam_sweep_up(&step);
            step.misfit = b.misfit;
            assert_true(wf_beam_step(&step, NULL));
            struct wf_beam_pose *now = WF_TAKE(&c.arena, b.mesh.n, struct wf_beam_pose);
            memcpy(now, step.pose, b.mesh.n * sizeof *now);
            rests = wf_beam_rests(&step);
            off[k] = 0;
            for (size_t i = 0; i < b.mesh.n; i++)
                for (int q = 0; q < 3; q++) off[k] = fmax(off[k], fabs(now[i].r[q] - step.pose[i].r[q]));
        }
        if (rests && off[0] > 1e-9) {
            tried++;
            if (!(off[1] < 0.3 * off[0] && off[2] < 0.3 * off[1]))
                fail_msg("tree %d: %g %g %g", (int)seed, off[0], off[1], off[2]);
        }
        beam_free(&c);
    }
    assert_true(tried > 12);
}

/* Links however stiff: their forces come to those of links that do not stretch. */
static void stiff(void **state)
{
    (void)state;
    size_t found = 0, most = 0;
    for (uint64_t seed = 0; seed < 40; seed++) {
        double pull[3][3] = { { 0 } };
        bool all = true;
        for (int q = 0; q < 3; q++) {
            struct beam_case c;
            struct wf_link link[3];
            tangle(&c, seed, 20 + 4 * seed, link);
            c.options.inextensible = false;
            c.options.tolerance = 1e-9, c.options.mesh_tolerance = 1e-5;
            for (int k = 0; k < 3; k++) {
                link[k].length /= k == 1 ? 1.01 : 0.98; /* as drawn */
                link[k].stiffness = 1e5 * pow(100, q);
            }
            if (beam_try(&c, &wf_solver_beam))
                all = false;
            else
                memcpy(pull[q], c.out.link, sizeof pull[q]);
            most = c.out.iterations > most ? c.out.iterations : most;
            beam_free(&c);
        }
        found += all;
        for (int k = 0; k < 3 && all; k++) {
            double size = fmax(fabs(pull[2][0]), fmax(fabs(pull[2][1]), fabs(pull[2][2])));
            if (!(fabs(pull[2][k] - pull[1][k]) < 0.02 * size + 0.02))
                fail_msg("tree %d, link %d: %g %g %g N", (int)seed, k, pull[0][k], pull[1][k], pull[2][k]);
        }
    }
    printf("%zu of 40 trees, at most %zu iterations\n", found, most);
    assert_true(found >= 36);
}

/* A cable that is slack changes no byte. */
static void slack(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_link link[3];
    tangle(&c, 4, 60, link);
    c.loads.links = 0;
    beam_solve(&c);
    struct wf_response before = c.out;
    for (int k = 0; k < 3; k++) link[k].length *= 2, link[k].pushes = false;
    c.loads.links = 3;
    beam_solve(&c);
    assert_memory_equal(before.end, c.out.end, 3 * c.tree.n * sizeof(double));
    assert_memory_equal(before.moment0, c.out.moment0, 3 * c.tree.n * sizeof(double));
    assert_int_equal(before.iterations, c.out.iterations);
    beam_free(&c);
}

/* A link's ends exchanged, and a tree and its mirror image. */
static void symmetry(void **state)
{
    (void)state;
    struct beam_case c[3];
    struct wf_link link[3][3];
    for (int k = 0; k < 3; k++) {
        tangle(&c[k], 6, 50, link[k]);
        c[k].wind.direction[0] = 0.6, c[k].wind.direction[1] = k == 2 ? -0.8 : 0.8;
        for (int i = 0; i < 3 && k == 1; i++) {
            int32_t from = link[k][i].segment[0];
            link[k][i].segment[0] = link[k][i].segment[1], link[k][i].segment[1] = from;
        }
        for (size_t i = 0; i < c[k].tree.n && k == 2; i++) {
            c[k].tree.y0[i] *= -1, c[k].tree.y1[i] *= -1;
            c[k].tree.lift[i] *= -1;
        }
        c[k].options.tolerance = 1e-12;
        beam_solve(&c[k]);
    }
    for (size_t i = 0; i < 3 * c[0].tree.n; i++) {
        assert_true(fabs(c[1].out.end[i] - c[0].out.end[i]) < 1e-9);
        assert_true(fabs(c[2].out.end[i] - (i % 3 == 1 ? -1 : 1) * c[0].out.end[i]) < 1e-9);
    }
    for (int k = 0; k < 3; k++) beam_free(&c[k]);
}

/* The same bytes for 1, 4 and 8 lanes, and for any number of threads. */
static void same_bytes(void **state)
{
    (void)state;
    static const char *const width[] = { "1", "4", "8" };
    for (uint64_t seed = 0; seed < 8; seed++) {
        struct beam_case c[3];
        struct wf_link link[3][3];
        for (int k = 0; k < 3; k++) {
            setenv("WINDFIRM_LANES", width[k], 1);
            tangle(&c[k], seed, 80, link[k]);
            c[k].options.mesh_tolerance = 1e-5;
            c[k].options.threads = (size_t)k + 1;
            (void)beam_try(&c[k], &wf_solver_beam);
        }
        for (int k = 1; k < 3; k++)
            assert_memory_equal(c[k].out.end, c[0].out.end, 3 * c[0].tree.n * sizeof(double));
        for (int k = 0; k < 3; k++) beam_free(&c[k]);
    }
    unsetenv("WINDFIRM_LANES");
}

/* Negative eigenvalues of the dense matrix. *least: the smallest in size. */
static size_t negative_of(const double *H, size_t n, double *least)
{
    double copy[36], value[6];
    memcpy(copy, H, n * n * sizeof *copy);
    gsl_matrix_view m = gsl_matrix_view_array(copy, n, n);
    gsl_vector_view v = gsl_vector_view_array(value, n);
    gsl_eigen_symm_workspace *w = gsl_eigen_symm_alloc(n);
    assert_int_equal(gsl_eigen_symm(&m.matrix, &v.vector, w), 0);
    gsl_eigen_symm_free(w);
    size_t count = 0;
    *least = INFINITY;
    for (size_t i = 0; i < n; i++) count += value[i] < 0, *least = fmin(*least, fabs(value[i]));
    return count;
}

/* Unstable directions of upright masts under weights, with links that are stretched or pressed, whose forces
 * are balanced by others: as many as negative eigenvalues of the dense matrix. */
static void inertia(void **state)
{
    (void)state;
    uint64_t seed = 9;
    size_t seen[7] = { 0 }, helped = 0, harmed = 0;
    for (int round = 0; round < 400; round++) {
        struct beam_case c;
        struct wf_link link[3];
        struct wf_beam b;
        double v[6] = { 0 }, H[36], least, at[2][3], force[3];
        masts(&c, MASTS, three_feet, three_heights);
        struct dense d = { MASTS, 3, three_feet, three_heights, { { 0 } }, link };
        for (size_t i = 0; i < MASTS; i++) d.force[i][2] = -2.2e4 * (1 + beam_random(&seed));
        for (int k = 0; k < 3; k++) {
            double size = 0;
            for (int i = 0; i < 2; i++) top_of(&d, (size_t)((k + i) % 3), v, at[i]);
            for (int q = 0; q < 3; q++) size += (at[1][q] - at[0][q]) * (at[1][q] - at[0][q]);
            link[k] = (struct wf_link){ .segment = { k, (k + 1) % 3 },
                                        .stiffness = 3e4 * (1.2 + beam_random(&seed)),
                                        .length = sqrt(size) * (1 + 0.3 * beam_random(&seed)),
                                        .pushes = beam_random(&seed) > 0 };
            (void)wf_link_pull(&link[k], at[0], at[1], force);
            v3_add(d.force[k], -1, force), v3_add(d.force[(k + 1) % 3], 1, force);
        }
        for (size_t i = 0; i < MASTS; i++)
            beam_push(&c, i, WF_POINT_DEAD, d.force[i][0], d.force[i][1], d.force[i][2]);
        second_of(&d, v, H);
        size_t want = negative_of(H, 6, &least), count[2];
        for (int with = 0; with < 2; with++) {
            struct wf_beam_stability found = { .margin = 0 };
            c.loads.link = link, c.loads.links = 3;
            if (wf_beam_init(&b, &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err))
                fail_msg("%s", c.err.text);
            if (!with) b.links = NULL; /* the forces alone */
            wf_beam_sweep_up(&b);
            assert_true(wf_beam_sweep_down(&b, true, &found));
            count[with] = found.negative;
            if (with) assert_int_equal(found.bears > 0, found.negative > 0);
        }
        if (least > 1e-3 * hinge) {
            if (count[1] != want) fail_msg("round %d: %zu, not %zu", round, count[1], want);
            seen[want]++;
            helped += count[1]<count[0], harmed += count[1]> count[0];
        }
        beam_free(&c);
    }
    assert_true(seen[0] > 20 && seen[1] > 20 && seen[2] > 20 && seen[3] > 5);
    assert_true(helped > 50 && harmed > 5);
}

/* Two masts with a mass at their tops and a rod: in step m h^2 w^2 = c, against each other c + 2 k h^2. */
static void frequencies(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_link link;
    double f[4];
    two_masts(&c, &link);
    beam_masses(&c);
    for (size_t i = 0; i < 2; i++) c.tree.mass1[i] = 500, c.tree.density[i] = 1e-6;
    link.length = 6, link.pushes = true;
    if (wf_modes(&c.tree, &c.loads, &c.options, 4, &c.arena, f, NULL, &c.err)) fail_msg("%s", c.err.text);
    const double slow = sqrt(hinge / (500 * high * high)) / (2 * PI);
    for (int k = 0; k < 3; k++) assert_close(f[k], slow, 1e-5);
    assert_close(f[3], sqrt((hinge + 2 * link.stiffness * high * high) / (500 * high * high)) / (2 * PI),
                 1e-5);
    link.pushes = false; /* a cable at rest is slack */
    if (wf_modes(&c.tree, &c.loads, &c.options, 4, &c.arena, f, NULL, &c.err)) fail_msg("%s", c.err.text);
    assert_close(f[3], slow, 1e-5);
    beam_free(&c);
}

/* Small motions about a solved state are those of solutions at loads that differ little. */
static void small_motions(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_link link[3];
    struct wf_beam b[2];
    tangle(&c, 3, 60, link);
    for (int k = 0; k < 2; k++)
        if (wf_beam_init(&b[k], &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err))
            fail_msg("%s", c.err.text);
    assert_true(wf_beam_rests(&b[0]));
    if (wf_beam_linearise(&b[0], false, &c.arena, &c.err)) fail_msg("%s", c.err.text);
    wf_four(*push)[6] = wf_arena_take(&c.arena, b[0].mesh.n, sizeof *push);
    wf_four(*ends)[6] = wf_arena_take(&c.arena, b[0].mesh.n, sizeof *ends);
    struct wf_beam_small_answer out = { .ends = ends };
    size_t at = b[0].mesh.n - 1;
    push[at][0][0] = 1, push[at][1][2] = -3;
    wf_beam_answer_small(&b[0], NULL, NULL, (const wf_four(*)[6])push, NULL, &out);
    for (int lane = 0; lane < 3; lane += 2) {
        const double small = 2e-5;
        double place[2][3];
        for (int k = 0; k < 2; k++) {
            c.loads.points = 0;
            beam_push(&c, c.tree.n - 1, WF_POINT_DEAD, (k ? -1 : 1) * small * push[at][0][lane],
                      (k ? -1 : 1) * small * push[at][1][lane], 0);
            b[1].loads = c.loads;
            assert_true(wf_beam_rests(&b[1]));
            memcpy(place[k], b[1].pose[at].r, sizeof place[k]);
        }
        for (int q = 0; q < 3; q++)
            assert_true(fabs((place[0][q] - place[1][q]) / (2 * small) - ends[at][q][lane]) <
                        1e-5 * fabs(ends[at][lane ? 1 : 0][lane]));
    }
    beam_free(&c);
}

/* What no solver takes. */
static void refusals(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_link link;
    two_masts(&c, &link);
    link.segment[1] = 0;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    link.segment[1] = 2;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    link.segment[1] = 1, link.stiffness = NAN;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_bars),      cmocka_unit_test(dense_solution), cmocka_unit_test(v_of_cantilevers),
        cmocka_unit_test(superposition), cmocka_unit_test(energy),         cmocka_unit_test(tangent),
        cmocka_unit_test(stiff),         cmocka_unit_test(slack),          cmocka_unit_test(symmetry),
        cmocka_unit_test(same_bytes),    cmocka_unit_test(inertia),        cmocka_unit_test(frequencies),
        cmocka_unit_test(small_motions), cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
