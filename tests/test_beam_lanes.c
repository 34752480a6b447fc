/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Many states side by side: the same answers as one after the other, the same bytes at any width. */
#include "beam_cases.h"
#include "solve/beam_many.h"
#include <stdlib.h>

enum { N = 8 };

/* A tree and N winds around it, with laws by the seed. */
struct many {
    struct beam_case c;
    struct wf_wind wind[2 * N];
    struct wf_loads loads[2 * N];
    struct wf_beam_state state[2 * N];
};

static void blow(struct many *m, uint64_t seed, double speed)
{
    for (size_t k = 0; k < 2 * N; k++) {
        double angle = 2 * PI * (double)k / N + 0.1;
        m->wind[k] = m->c.wind;
        beam_profile(&m->wind[k], seed);
        m->wind[k].least = 0.5 + 0.1 * (double)k;
        m->wind[k].speed = speed * (0.6 + 0.05 * (double)k);
        m->wind[k].direction[0] = cos(angle), m->wind[k].direction[1] = sin(angle);
        m->loads[k] = m->c.loads;
        m->loads[k].wind = seed % 6 == 5 && k == 2 ? NULL : &m->wind[k];
        m->loads[k].air_density = 1.225 - 0.01 * (double)k;
        if (seed % 2) m->loads[k].streamline_par.held = k % 3 ? 6 + (double)k : 0;
        m->state[k] = (struct wf_beam_state){ .loads = &m->loads[k] };
    }
}

static void wild(struct many *m, uint64_t seed, size_t rows, double speed)
{
    beam_wild(&m->c, rows, seed + 1);
    beam_laws(&m->c, seed);
    blow(m, seed, speed);
    m->c.options.tolerance = 1e-12;
    m->c.options.mesh_tolerance = 0;
}

static void solve(struct many *m, size_t n)
{
    m->c.err = (struct wf_err){ 0 };
    if (wf_beam_many(&m->c.tree, m->state, n, &m->c.options, NULL, &m->c.arena, NULL, &m->c.err))
        fail_msg("%s", m->c.err.text);
}

static void solve_one(struct many *m, size_t k, struct wf_response *r)
{
    struct wf_err e = { 0 };
    if (wf_solver_beam.solve(&m->c.tree, &m->loads[k], &m->c.options, &m->c.arena, r, &m->c.diag, &e))
        fail_msg("%s", e.text);
}

/* Largest difference of two columns, relative to the largest number of the second. */
static double off(const double *a, const double *b, size_t n)
{
    double most = 0, size = 1e-300;
    for (size_t i = 0; i < n; i++) most = fmax(most, fabs(a[i] - b[i])), size = fmax(size, fabs(b[i]));
    return most / size;
}

static double difference(const struct wf_response *a, const struct wf_response *b)
{
    const double *const x[] = { a->end,     a->turn,     a->force0,   a->moment0, a->force1,
                                a->moment1, a->tangent0, a->tangent1, a->load },
                        *const y[] = { b->end,     b->turn,     b->force0,   b->moment0, b->force1,
                                       b->moment1, b->tangent0, b->tangent1, b->load };
    double most = fmax(off(a->base_force, b->base_force, 3), off(a->base_moment, b->base_moment, 3));
    for (size_t i = 0; i < sizeof x / sizeof *x; i++) most = fmax(most, off(x[i], y[i], 3 * a->n));
    return most;
}

static bool same_bytes(const struct wf_response *a, const struct wf_response *b)
{
    const double *const x[] = { a->end,     a->turn,     a->force0,   a->moment0, a->force1,
                                a->moment1, a->tangent0, a->tangent1, a->load },
                        *const y[] = { b->end,     b->turn,     b->force0,   b->moment0, b->force1,
                                       b->moment1, b->tangent0, b->tangent1, b->load };
    for (size_t i = 0; i < sizeof x / sizeof *x; i++)
        if (memcmp(x[i], y[i], 3 * a->n * sizeof(double))) return false;
    return !memcmp(a->base_force, b->base_force, sizeof a->base_force) &&
           !memcmp(a->base_moment, b->base_moment, sizeof a->base_moment) && a->imbalance == b->imbalance &&
           a->iterations == b->iterations;
}

/* Trees at random, every profile and law: as one after the other. */
static void as_one_by_one(void **state)
{
    (void)state;
    size_t beside = 0, all = 0;
    double worst = 0;
    for (uint64_t seed = 0; seed < 48; seed++) {
        struct many m;
        wild(&m, seed, 10 + 5 * seed, seed % 2 ? 10 : 25);
        if (seed % 7 == 3) beam_masses(&m.c), m.c.tree.mass1[m.c.tree.n - 1] = 0.2;
        if (seed % 8 == 1) m.c.options.shear_flexible = true;
        solve(&m, N);
        for (size_t k = 0; k < N; k++) {
            struct wf_response r;
            assert_int_equal(m.state[k].status, WF_OK);
            all++;
            if (m.state[k].alone) continue;
            beside++;
            solve_one(&m, k, &r);
            assert_true(m.state[k].response.imbalance < 1e-12);
            if (r.steps) continue; /* several equilibria */
            double now = difference(&m.state[k].response, &r);
            if (!(now < 1e-9)) fail_msg("tree %d, wind %zu: off by %g", (int)seed, k, now);
            worst = fmax(worst, now);
        }
        beam_free(&m.c);
    }
    printf("%zu of %zu states side by side, off by %.2g\n", beside, all, worst);
    assert_true(10 * beside > 9 * all);
}

/* A thick bare trunk in the range of the drag crisis. */
static void drag_crisis(void **state)
{
    (void)state;
    struct many m;
    beam_stem(&m.c, 20, upright, 20, 0.4, 0.1);
    beam_laws(&m.c, 1), blow(&m, 0, 30);
    m.c.options.tolerance = 1e-12;
    m.c.options.mesh_tolerance = 0;
    solve(&m, N);
    for (size_t k = 0; k < N; k++) {
        struct wf_response r;
        solve_one(&m, k, &r);
        assert_false(m.state[k].alone);
        assert_true(difference(&m.state[k].response, &r) < 1e-9);
    }
    beam_free(&m.c);
}

static double worse(const struct wf_response *a, const struct wf_response *b)
{
    return fmax(off(a->end, b->end, 3 * a->n), off(a->base_moment, b->base_moment, 3));
}

/* On refined meshes: as near to the answer on a much finer mesh as the solver alone. */
static void within_the_mesh(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 12; seed++) {
        struct many m;
        wild(&m, seed, 40, 10);
        m.c.options.mesh_tolerance = 1e-6;
        solve(&m, N);
        for (size_t k = 0; k < N; k++) {
            struct wf_response alone, exact;
            solve_one(&m, k, &alone);
            m.c.options.mesh_tolerance = 1e-9;
            solve_one(&m, k, &exact);
            m.c.options.mesh_tolerance = 1e-6;
            double beside = worse(&m.state[k].response, &exact), one = worse(&alone, &exact);
            if (!(beside <= fmax(1e-6, one)))
                fail_msg("tree %d, wind %zu: off by %g, alone by %g", (int)seed, k, beside, one);
        }
        beam_free(&m.c);
    }
}

/* The same bytes for 1, 4 and 8 lanes and for 1 and 2 threads; 13 states make a block that is not full. */
static void same_at_any_width(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 12; seed++) {
        static struct many m[4];
        static const char *const width[] = { "1", "4", "8", "8" };
        for (size_t k = 0; k < 4; k++) {
            setenv("WINDFIRM_LANES", width[k], 1);
            wild(&m[k], seed, 60, 25);
            m[k].c.options.mesh_tolerance = seed % 2 ? 1e-5 : 0;
            m[k].c.options.threads = k == 3 ? 2 : 1;
            solve(&m[k], 13);
            for (size_t s = 0; s < 13; s++) {
                assert_int_equal(m[k].state[s].alone, m[0].state[s].alone);
                assert_int_equal(m[k].state[s].loose, m[0].state[s].loose);
                if (!same_bytes(&m[k].state[s].response, &m[0].state[s].response))
                    fail_msg("tree %d, wind %zu: not the same with %s lanes", (int)seed, s, width[k]);
            }
        }
        for (size_t k = 0; k < 4; k++) beam_free(&m[k].c);
    }
    unsetenv("WINDFIRM_LANES");
}

/* A wind in which the tree falls over to another equilibrium, among eight: the others keep their bytes. */
static void one_that_snaps(void **state)
{
    (void)state;
    static struct many m[2];
    for (int k = 0; k < 2; k++) {
        beam_stem(&m[k].c, 30, upright, 8, 0.02, 0.01);
        beam_laws(&m[k].c, 0), blow(&m[k], 0, 12);
        m[k].c.options.mesh_tolerance = 0;
        m[k].c.loads.gravity = 9.81;
        if (k) m[k].loads[3].gravity = 120; /* it buckles */
        solve(&m[k], N);
    }
    assert_false(m[0].state[3].alone);
    assert_true(m[1].state[3].alone);
    for (size_t s = 0; s < N; s++)
        if (s != 3) assert_true(same_bytes(&m[0].state[s].response, &m[1].state[s].response));
    struct wf_response r;
    solve_one(&m[1], 3, &r);
    assert_true(same_bytes(&m[1].state[3].response, &r));
    beam_free(&m[0].c), beam_free(&m[1].c);
}

/* Newton's method converges quadratically: three more digits of six cost one iteration. */
static void quadratic(void **state)
{
    (void)state;
    static const double tolerance[] = { 1e-3, 1e-6, 1e-12 };
    size_t iterations[3][N];
    for (int k = 0; k < 3; k++) {
        struct many m;
        wild(&m, 4, 150, 12);
        m.c.options.tolerance = tolerance[k];
        solve(&m, N);
        for (size_t s = 0; s < N; s++) {
            assert_false(m.state[s].alone);
            iterations[k][s] = m.state[s].response.iterations;
        }
        beam_free(&m.c);
    }
    for (size_t s = 0; s < N; s++) {
        assert_true(iterations[1][s] <= iterations[0][s] + 1);
        assert_true(iterations[2][s] <= iterations[1][s] + 1);
    }
}

/* What lanes do not cover is solved one by one. */
static void not_covered(void **state)
{
    (void)state;
    for (int what = 0; what < 4; what++) {
        struct many m;
        wild(&m, 2, 30, 10);
        if (what == 0) m.c.options.root_stiffness[0] = m.c.options.root_stiffness[1] = 1e5;
        struct wf_point_load push = { .segment = 5, .kind = WF_POINT_FOLLOWER, .force = { 20, 0, 0 } };
        double line[2][6 * 30] = { { 0 } };
        for (size_t k = 0; k < N; k++) {
            if (what == 1 && k == 6) m.loads[k].point = &push, m.loads[k].points = 1;
            if (what == 2) m.loads[k].line = line[k % 2];
        }
        solve(&m, what == 3 ? 1 : N);
        for (size_t k = 0; k < (what == 3 ? 1 : N); k++) {
            struct wf_response r;
            solve_one(&m, k, &r);
            assert_true(m.state[k].alone);
            assert_true(same_bytes(&m.state[k].response, &r));
        }
        beam_free(&m.c);
    }
}

/* A bad load is refused as by the solver. */
static void refused(void **state)
{
    (void)state;
    struct many m;
    wild(&m, 2, 30, 10);
    m.loads[4].gravity = NAN;
    assert_int_equal(wf_beam_many(&m.c.tree, m.state, N, &m.c.options, NULL, &m.c.arena, NULL, &m.c.err),
                     WF_EINPUT);
    beam_free(&m.c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_one_by_one),   cmocka_unit_test(drag_crisis),
        cmocka_unit_test(within_the_mesh), cmocka_unit_test(same_at_any_width),
        cmocka_unit_test(one_that_snaps),  cmocka_unit_test(quadratic),
        cmocka_unit_test(not_covered),     cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
