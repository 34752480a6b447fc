/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees at and beyond what they can bear: every case ends in an answer or in a statement. */
#include "beam_cases.h"
#include "solve/modes.h"

/* Heavy inextensible column clamped upright, weight parameter w L^3/EI = W, leaning at `angle` at the tip: W
 * and the tip's place by integrating angle'' = -W s sin(angle) (s from the tip) to the clamp, Runge-Kutta. */
static double clamp_angle(double W, double tip, double *x, double *z)
{
    enum { STEPS = 4000 };
    const double h = 1.0 / STEPS;
    double y[4] = { tip, 0, 0, 0 };
    for (int i = 0; i < STEPS; i++) {
        double k[4][4], q[4];
        for (int s = 0; s < 4; s++) {
            double part = s ? (s < 3 ? 0.5 : 1) : 0;
            for (int j = 0; j < 4; j++) q[j] = y[j] + (s ? part * h * k[s - 1][j] : 0);
            k[s][0] = q[1], k[s][1] = -W * (i + part) * h * sin(q[0]);
            k[s][2] = sin(q[0]), k[s][3] = cos(q[0]);
        }
        for (int j = 0; j < 4; j++) y[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
    }
    *x = y[2], *z = y[3];
    return y[0];
}

static const double greenhill = 7.8373474389434839; /* 9/4 j^2, j the first zero of J_-1/3 (Greenhill 1881) */

/* Stands just below; gives way above, at the right share of the load, to the leaning shape. */
static void own_weight(void **state)
{
    (void)state;
    struct beam_case c;
    beam_unit(&c, 1, 1);
    c.loads.gravity = greenhill * 0.999;
    beam_solve(&c);
    assert_true(c.out.load_factor == 1 && fabs(c.out.end[0]) < 1e-9 && !c.diag.warnings);
    beam_free(&c);
    for (double tip = 0.8; tip < 2.5; tip += 0.7) {
        double low = greenhill, high = 60, x, z; /* the first W with a clamped root */
        for (int i = 0; i < 100; i++) {
            double W = 0.5 * (low + high);
            if (clamp_angle(W, tip, &x, &z) > 0)
                low = W;
            else
                high = W;
            if (clamp_angle(W, tip, &x, &z) < -0.5) high = W;
        }
        beam_unit(&c, 1, 1);
        c.loads.gravity = low;
        beam_solve(&c);
        assert_close(c.out.load_factor, greenhill / low, 1e-3);
        assert_int_equal(c.diag.warnings, 1);
        assert_string_equal(c.diag.first->code, "limit-point");
        assert_close(hypot(c.out.end[0], c.out.end[1]), x, 1e-6);
        assert_close(1 + c.out.end[2], z, 1e-6);
        /* the upright shape, which is not stable, is left with a loose tolerance too */
        c.options.tolerance = 3e-4;
        c.options.mesh_tolerance = 1e-3;
        beam_solve(&c);
        assert_close(hypot(c.out.end[0], c.out.end[1]), x, 2e-3);
        beam_free(&c);
    }
}

/* A stem that leans a little has no bifurcation: it bends more and more, never gives way. */
static void leaning(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 1, (double[]){ sin(0.05), 0, cos(0.05) }, 30, 0.1, 0.1);
    c.loads.gravity = 9.81;
    beam_solve(&c);
    assert_true(c.out.load_factor == 1 && c.out.end[0] > 5 && !c.diag.warnings);
    beam_free(&c);
}

/* Far too tall: it falls over and hangs. */
static void far_beyond(void **state)
{
    (void)state;
    for (double height = 60; height < 200; height *= 2.5) {
        struct beam_case c;
        beam_stem(&c, 10, upright, height, 0.1, 0.1);
        c.loads.gravity = 9.81;
        beam_solve(&c);
        assert_true(c.out.load_factor < 0.5 && c.out.end[29] < -height && c.diag.warnings == 1);
        assert_close(c.out.load_factor, pow(28.21830183639738 / height, 3), 3e-2);
        beam_free(&c);
    }
}

static void upside_down(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 4, (double[]){ 0, 0, -1 }, 200, 0.05, 0.05);
    c.loads.gravity = 9.81;
    beam_solve(&c);
    assert_true(c.out.load_factor == 1 && hypot(c.out.end[9], c.out.end[10]) < 1e-9);
    beam_blow(&c, 20, 0, 0);
    beam_solve(&c);
    assert_true(c.out.load_factor == 1 && c.out.end[9] > 5);
    beam_free(&c);
}

/* Storms no tree has met; still air; wind from above and from below; wood like jelly. */
static void ridiculous(void **state)
{
    (void)state;
    const double wind[][3] = { { 500, 0, 0 },   { 0, 0, -60 }, { 0, 0, 60 }, { 1e-6, 0, 0 },
                               { 300, 300, 9 }, { 0, 0, 0 },   { 5, 0, -80 } };
    for (size_t k = 0; k < 7; k++)
        for (int soft = 0; soft < 3; soft++)
            for (int tree = 0; tree < 3; tree++) {
                struct beam_case c;
                if (tree == 0) beam_stem(&c, 5, upright, 10, 0.1, 0.02);
                if (tree == 1) beam_tree7(&c);
                if (tree == 2) beam_wild(&c, 60, 5 + k);
                for (size_t i = 0; i < c.tree.n; i++)
                    c.tree.youngs[i] *= pow(1e-2, soft), c.tree.shear[i] *= pow(1e-2, soft);
                c.loads.gravity = 9.81;
                c.options.mesh_tolerance = tree ? 0 : 1e-4;
                beam_blow(&c, wind[k][0], wind[k][1], wind[k][2]);
                enum wf_status s = beam_try(&c, &wf_solver_beam);
                if (s == WF_OK) {
                    assert_true(c.out.imbalance < 1e-10 && c.out.load_factor > 0 && c.out.load_factor <= 1);
                    for (size_t i = 0; i < 3 * c.tree.n; i++) assert_true(isfinite(c.out.end[i]));
                } else {
                    assert_int_equal(s, WF_EUNSTABLE);
                    assert_non_null(strstr(c.err.text, "the last one is at"));
                    assert_true(c.out.load_factor < 1);
                    print_message("wind %g %g %g, stiffness 1e-%d, tree %d: %s\n", wind[k][0], wind[k][1],
                                  wind[k][2], 2 * soft, tree, c.err.text);
                }
                beam_free(&c);
            }
}

/* The line of thrust passes the tip at most 1e3 rows below: a long chain of rows is solved like a short one.
 */
static void deep_chain(void **state)
{
    (void)state;
    double tip[2];
    for (int k = 0; k < 2; k++) {
        struct beam_case c;
        size_t n = k ? 5000 : 50;
        beam_stem(&c, n, upright, 10, 0.06, 0.06);
        c.loads.gravity = 9.81;
        c.options.mesh_tolerance = k ? 0 : 1e-9;
        beam_blow(&c, 45, 0, 0);
        assert_int_equal(beam_try(&c, &wf_solver_beam), WF_OK);
        assert_true(c.out.imbalance < 1e-11);
        tip[k] = c.out.end[3 * n - 3];
        beam_free(&c);
    }
    assert_true(tip[0] > 1);
    assert_close(tip[1], tip[0], 1e-8);
}

/* Load steps are asked for few iterations each and still arrive. */
static void few_iterations(void **state)
{
    (void)state;
    struct beam_case c;
    double want[3];
    beam_unit(&c, 1, 0);
    beam_push(&c, 0, WF_POINT_DEAD, 30, 0, 0);
    beam_solve(&c);
    memcpy(want, c.out.end, sizeof want);
    c.options.iterations_max = 5;
    beam_solve(&c);
    assert_true(c.out.steps > 0);
    assert_close(c.out.end[0], want[0], 1e-6);
    c.options.iterations_max = 0;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EUNSTABLE);
    beam_free(&c);
}

/* Too tall for its weight, in a breath of wind: it bends over downwind at once, into a shape that the wind
 * alone keeps from turning aside. */
static void wind_and_weight(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 1, upright, 32, 0.1, 0.1);
    c.loads.gravity = 9.81;
    beam_blow(&c, 1, 0, 0);
    beam_solve(&c);
    assert_true(c.out.load_factor == 1 && c.out.end[0] > 3); /* no bifurcation: it bends that way at once */
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(own_weight),     cmocka_unit_test(leaning),         cmocka_unit_test(far_beyond),
        cmocka_unit_test(upside_down),    cmocka_unit_test(ridiculous),      cmocka_unit_test(deep_chain),
        cmocka_unit_test(few_iterations), cmocka_unit_test(wind_and_weight),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
