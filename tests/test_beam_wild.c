/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees, wood, wind and options at random: every case ends in a balanced answer. */
#include "beam_cases.h"
#include "solve/modes.h"

static double between(uint64_t *s, double low, double high)
{
    return low + (high - low) * fabs(beam_random(s));
}

static void any(struct beam_case *c, uint64_t seed)
{
    uint64_t s = seed * 7919 + 13;
    size_t n = (size_t)(1 + between(&s, 0, 1) * pow(10, between(&s, 1, 2.5)));
    beam_wild(c, n, seed + 1);
    struct wf_tree *t = &c->tree;
    double soft = pow(10, -between(&s, 0, (double)(seed % 3))), U = between(&s, 0, 60);
    for (size_t i = 0; i < n; i++) {
        t->youngs[i] *= soft * pow(10, 0.5 * beam_random(&s));
        t->shear[i] = t->youngs[i] / between(&s, 2.2, seed % 5 ? 4 : 16);
        t->sail0[i] = t->sail1[i] = seed % 2 ? 3 * t->r0[i] : 0;
        t->lift[i] = seed % 4 ? 0 : 0.5 * beam_random(&s);
        if (seed % 7 == 0) t->i0[i] = 0.8 * t->r0[i], t->i1[i] = 0.8 * t->r1[i];
    }
    c->loads.gravity = seed % 6 == 5 ? 0 : 9.81;
    if (seed % 3) c->wind.sample = wf_profile_named("log")->sample;
    beam_blow(c, U * beam_random(&s), U * beam_random(&s), 0.2 * U * beam_random(&s));
    if (seed % 9 == 4)
        c->options.root_stiffness[0] = c->options.root_stiffness[1] = soft * pow(10, between(&s, 4, 7));
    c->options.shear_flexible = seed % 8 == 3;
    c->options.mesh_tolerance = seed % 2 ? 1e-4 : 0;
}

static void at_random(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 200; seed++) {
        struct beam_case c;
        double f[2];
        any(&c, seed);
        if (beam_try(&c, &wf_solver_beam))
            fail_msg("tree %llu of %zu rows: %s", (unsigned long long)seed, c.tree.n, c.err.text);
        assert_true(c.out.imbalance < 1e-9 && c.out.load_factor > 0 && c.out.load_factor <= 1);
        for (size_t i = 0; i < 3 * c.tree.n; i++)
            assert_true(isfinite(c.out.end[i]) && isfinite(c.out.moment0[i]));
        assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 2, &c.arena, f, NULL, &c.err), WF_OK);
        assert_true(f[0] <= f[1]);
        beam_free(&c);
    }
}

/* The same digits when asked again. */
static void repeatable(void **state)
{
    (void)state;
    double end[2][3];
    for (int k = 0; k < 2; k++) {
        struct beam_case c;
        any(&c, 34);
        beam_solve(&c);
        memcpy(end[k], c.out.end + 3 * (c.tree.n - 1), sizeof end[k]);
        beam_free(&c);
    }
    assert_memory_equal(end[0], end[1], sizeof end[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(at_random), cmocka_unit_test(repeatable) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
