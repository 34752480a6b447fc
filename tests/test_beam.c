/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The beam and linear solvers against closed forms of small deflection, section by section. */
#include "beam_cases.h"

static const double r = 0.02, length = 3, E = 9e9;
static const double area = PI * 4e-4, inertia = PI / 4 * 16e-8;

static double tip(const struct beam_case *c, size_t axis) { return c->out.end[3 * (c->tree.n - 1) + axis]; }

static void run(struct beam_case *c, bool large)
{
    if (large)
        beam_solve(c);
    else
        assert_int_equal(beam_try(c, &wf_solver_linear), WF_OK);
    assert_true(c->out.imbalance < 1e-12 && c->out.load_factor == 1);
}

/* Both solvers, loads small enough that the square of the slope is below the tolerance. */
static void each(void (*check)(struct beam_case *c, bool large))
{
    for (int large = 0; large < 2; large++) {
        struct beam_case c;
        beam_stem(&c, 3, upright, length, r, r);
        check(&c, large);
        beam_free(&c);
    }
}

static void bends(struct beam_case *c, bool large)
{
    const double P = 1e-3, ei = E * inertia;
    beam_push(c, 2, WF_POINT_DEAD, P, 0, 0);
    run(c, large);
    assert_close(tip(c, 0), P * pow(length, 3) / (3 * ei), 1e-9);
    assert_close(c->out.turn[7], P * length * length / (2 * ei), 1e-9);
    assert_close(c->out.end[0], P * (length / 2 - length / 18) / ei, 1e-9); /* z = 1: P z^2 (L/2 - z/6) */
    assert_close(c->out.base_moment[1], P * length, 1e-9);
    assert_close(c->out.base_force[0], P, 1e-12);
    assert_close(c->out.moment1[1], P * 2, 1e-9);
    assert_close(c->out.moment0[7], P * 1, 1e-9);
    assert_true(fabs(c->out.moment1[7]) < 1e-14 && c->out.small_deflection == !large);
}

static void bends_under_line_load(struct beam_case *c, bool large)
{
    const double q = 1e-3, ei = E * inertia;
    beam_line(c, 0, q, 0);
    run(c, large);
    assert_close(tip(c, 1), q * pow(length, 4) / (8 * ei), 1e-8);
    assert_close(c->out.turn[6], -q * pow(length, 3) / (6 * ei), 1e-8);
    assert_close(c->out.load[1], q * length / 3, 1e-12);
}

static void bends_under_moment(struct beam_case *c, bool large)
{
    const double M = 1e-3;
    beam_push(c, 2, WF_POINT_DEAD, 0, 0, 0)->moment[1] = M;
    run(c, large);
    assert_close(tip(c, 0), M * length * length / (2 * E * inertia), 1e-8);
    assert_close(c->out.base_moment[1], M, 1e-12);
    assert_true(fabs(c->out.base_force[0]) < 1e-15);
}

static void twists(struct beam_case *c, bool large)
{
    const double M = 1e-2;
    beam_push(c, 2, WF_POINT_DEAD, 0, 0, 0)->moment[2] = M;
    run(c, large);
    assert_close(c->out.turn[8], M * length / (E / 2.6 * 2 * inertia), 1e-9);
    assert_true(fabs(tip(c, 0)) < 1e-12);
}

static void stretches(struct beam_case *c, bool large)
{
    const double P = 100;
    beam_push(c, 2, WF_POINT_DEAD, 0, 0, P);
    run(c, large);
    assert_close(tip(c, 2), P * length / (E * area), 1e-9);
    assert_close(c->out.force0[2], P, 1e-12);
}

static void stretches_under_weight(struct beam_case *c, bool large)
{
    c->loads.gravity = 9.81;
    run(c, large);
    assert_close(tip(c, 2), -800 * 9.81 * length * length / (2 * E), 1e-8);
    assert_close(c->out.base_force[2], -800 * 9.81 * area * length, 1e-12);
}

/* Timoshenko: P L^3/(3 EI) + P L/(k G A); k of a full circle by Cowper: 6(1+nu)/(7+6 nu). */
static void shears(struct beam_case *c, bool large)
{
    const double P = 1e-3, bend = P * pow(length, 3) / (3 * E * inertia);
    const double slide = P * length / (E / 2.6 * area), k = 6 * 1.3 / (7 + 6 * 0.3);
    beam_push(c, 2, WF_POINT_DEAD, P, 0, 0);
    c->options.shear_flexible = true;
    run(c, large);
    assert_close(tip(c, 0) - bend, slide / k, 1e-4);
    c->options.shear_factor = 0.5;
    run(c, large);
    assert_close(tip(c, 0) - bend, slide / 0.5, 1e-4);
    c->options.inextensible = true;
    run(c, large);
    assert_close(tip(c, 0), bend, 1e-9);
}

static void hollow(struct beam_case *c, bool large)
{
    const double P = 1e-3, m = 0.6, share = 1 - pow(m, 4);
    for (size_t i = 0; i < 3; i++) c->tree.i0[i] = c->tree.i1[i] = m * r;
    beam_push(c, 2, WF_POINT_DEAD, P, 0, 0);
    run(c, large);
    assert_close(tip(c, 0), P * pow(length, 3) / (3 * E * inertia * share), 1e-9);
    double bend = tip(c, 0), nu = 0.3, q = pow(1 + m * m, 2);
    c->options.shear_flexible = true;
    run(c, large);
    double k = 6 * (1 + nu) * q / ((7 + 6 * nu) * q + (20 + 12 * nu) * m * m); /* Cowper 1966, thick tube */
    assert_close(tip(c, 0) - bend, P * length / (k * E / 2.6 * area * (1 - m * m)), 1e-4);
    c->loads.gravity = 9.81;
    run(c, large);
    assert_close(c->out.base_force[2], -800 * 9.81 * area * (1 - m * m) * length, 1e-12);
}

static void given_stiffness(struct beam_case *c, bool large)
{
    const double P = 1e-4;
    c->tree.stiff = WF_TAKE(&c->arena, 12, double);
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 4; k++) c->tree.stiff[4 * i + k] = (const double[]){ 50, 20, 300, 7 }[k];
    c->options.shear_flexible = true;
    beam_push(c, 2, WF_POINT_DEAD, P, 0, 0)->moment[2] = P;
    run(c, large);
    assert_close(tip(c, 0), P * pow(length, 3) / (3 * 300) + P * length / 20, 1e-5);
    assert_close(c->out.turn[8], P * length / 7, 1e-5);
}

static void point_mass(struct beam_case *c, bool large)
{
    /* a mass at the end of a level arm: moment m g x arm */
    for (size_t i = 0; i < 3; i++)
        c->tree.x0[i] = c->tree.z0[i], c->tree.x1[i] = c->tree.z1[i], c->tree.z0[i] = c->tree.z1[i] = 0;
    beam_masses(c);
    c->tree.mass1[2] = 1e-4;
    for (size_t i = 0; i < 3; i++) c->tree.density[i] = 0;
    c->loads.gravity = 10;
    run(c, large);
    assert_close(tip(c, 2), -1e-3 * pow(length, 3) / (3 * E * inertia), 1e-8);
    assert_close(c->out.base_moment[1], 1e-3 * length, 1e-9);
}

/* Linear taper, tip force: P L^3/(3 E I0 t), t = tip over base radius; one row. */
static void tapered(struct beam_case *c, bool large)
{
    struct beam_case one;
    (void)c;
    beam_stem(&one, 1, upright, length, r, 0.1 * r);
    beam_push(&one, 0, WF_POINT_DEAD, 1e-4, 0, 0);
    run(&one, large);
    assert_close(tip(&one, 0), 1e-4 * pow(length, 3) / (3 * E * inertia * 0.1), 1e-6);
    beam_free(&one);
}

/* The linear solver loads the unbent tree: drag grows with the square of the speed exactly. */
static void linear_drag(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 4, upright, length, r, r);
    beam_blow(&c, 10, 0, 0);
    run(&c, false);
    assert_close(tip(&c, 0), 0.5 * 1.225 * 100 * 2 * r * pow(length, 4) / (8 * E * inertia), 1e-9);
    double once = tip(&c, 0);
    beam_blow(&c, 40, 0, 0);
    run(&c, false);
    assert_close(tip(&c, 0), 16 * once, 1e-12);
    assert_close(c.out.tangent1[9], sin(atan(c.out.turn[10])) / cos(atan(c.out.turn[10])), 1e-12);
    c.options.mesh_tolerance = 0;
    run(&c, false);
    assert_close(tip(&c, 0), 16 * once, 1e-12); /* a uniform load: one element is as good as many */
    beam_free(&c);
}

static void test_bends(void **s) { (void)s, each(bends); }
static void test_line(void **s) { (void)s, each(bends_under_line_load); }
static void test_moment(void **s) { (void)s, each(bends_under_moment); }
static void test_twists(void **s) { (void)s, each(twists); }
static void test_stretches(void **s) { (void)s, each(stretches); }
static void test_weight(void **s) { (void)s, each(stretches_under_weight); }
static void test_shears(void **s) { (void)s, each(shears); }
static void test_hollow(void **s) { (void)s, each(hollow); }
static void test_given(void **s) { (void)s, each(given_stiffness); }
static void test_point_mass(void **s) { (void)s, each(point_mass); }
static void test_tapered(void **s) { (void)s, each(tapered); }

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bends),      cmocka_unit_test(test_line),      cmocka_unit_test(test_moment),
        cmocka_unit_test(test_twists),     cmocka_unit_test(test_stretches), cmocka_unit_test(test_weight),
        cmocka_unit_test(test_shears),     cmocka_unit_test(test_hollow),    cmocka_unit_test(test_given),
        cmocka_unit_test(test_point_mass), cmocka_unit_test(test_tapered),   cmocka_unit_test(linear_drag),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
