/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Large deflections against closed forms and against the answer's own symmetries. */
#include "beam_cases.h"
#include <gsl/gsl_sf_ellint.h>

/* Tip force across an upright inextensible stem, elliptic integrals (Barten 1944; Frisch-Fay 1962): with p^2
 * = (1 + sin angle)/2 and sin d = 1/(p sqrt 2): P L^2/EI = (K - F)^2, height = sqrt(2 sin angle)/(K - F),
 * deflection = 1 - 2 (E - E(d))/(K - F). */
static void elastica(void **state)
{
    (void)state;
    const gsl_mode_t mode = GSL_PREC_DOUBLE;
    for (double angle = 0.2; angle < 1.5; angle += 0.3) {
        double p = sqrt((1 + sin(angle)) / 2), d = asin(1 / (p * sqrt(2)));
        double a = gsl_sf_ellint_Kcomp(p, mode) - gsl_sf_ellint_F(d, p, mode);
        double x = 1 - 2 * (gsl_sf_ellint_Ecomp(p, mode) - gsl_sf_ellint_E(d, p, mode)) / a;
        struct beam_case c;
        beam_unit(&c, 1, 0);
        beam_push(&c, 0, WF_POINT_DEAD, a * a, 0, 0);
        beam_solve(&c);
        assert_close(c.out.end[0], x, 1e-6);
        assert_close(1 + c.out.end[2], sqrt(2 * sin(angle)) / a, 1e-6);
        assert_close(c.out.turn[1], angle, 1e-6);
        assert_close(c.out.base_moment[1], a * a * sqrt(2 * sin(angle)) / a, 1e-6);
        beam_free(&c);
    }
}

/* A pure moment bends to a circle, also beyond a full turn. */
static void circle(void **state)
{
    (void)state;
    for (double turn = 0.5; turn < 8; turn += 1.5) {
        struct beam_case c;
        beam_unit(&c, 1, 0);
        beam_push(&c, 0, WF_POINT_DEAD, 0, 0, 0)->moment[1] = turn;
        beam_solve(&c);
        assert_close(c.out.end[0], (1 - cos(turn)) / turn, 1e-6);
        assert_close(1 + c.out.end[2] + 1, 1 + sin(turn) / turn, 1e-6);
        beam_free(&c);
    }
}

/* Force that turns with the tip: P L^2/EI = 10 by Runge-Kutta shooting backwards from the tip, where in the
 * tip's axes the problem is an initial-value one: angle'' = -P cos(angle - tip angle). */
static void follower(void **state)
{
    (void)state;
    enum { STEPS = 20000 };
    const double P = 10, h = 1.0 / STEPS;
    double y[4] = { 0, 0, 0,
                    0 }; /* angle behind the tip's, its slope, place along and across the tip's axis */
    for (int i = 0; i < STEPS; i++) {
        double k[4][4], z[4];
        for (int s = 0; s < 4; s++) {
            for (int j = 0; j < 4; j++) z[j] = y[j] + (s ? (s < 3 ? 0.5 : 1) * h * k[s - 1][j] : 0);
            k[s][0] = z[1], k[s][1] = P * cos(z[0]), k[s][2] = cos(z[0]), k[s][3] = sin(z[0]);
        }
        for (int j = 0; j < 4; j++) y[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
    }
    struct beam_case c;
    beam_unit(&c, 1, 0);
    beam_push(&c, 0, WF_POINT_FOLLOWER, P, 0, 0);
    beam_solve(&c);
    assert_close(c.out.turn[1], y[0], 1e-6);
    assert_close(1 + c.out.end[2], y[2] * cos(y[0]) + y[3] * sin(y[0]), 1e-6);
    assert_close(c.out.end[0], y[2] * sin(y[0]) - y[3] * cos(y[0]), 1e-6);
    beam_free(&c);
    /* a follower moment about the axis it turns about is a dead one */
    beam_unit(&c, 1, 0);
    beam_push(&c, 0, WF_POINT_FOLLOWER, 0, 0, 0)->moment[1] = 2;
    beam_solve(&c);
    assert_close(c.out.turn[1], 2, 1e-6);
    beam_free(&c);
}

/* Halving the elements of a tapered stem in the wind divides the error by sixteen. */
static void fourth_order(void **state)
{
    (void)state;
    double tip[4];
    for (size_t i = 0; i < 4; i++) {
        struct beam_case c;
        size_t n = i == 3 ? 256 : (size_t)8 << i;
        beam_stem(&c, n, upright, 8, 0.06, 0.02);
        c.options.mesh_tolerance = 0, c.options.tolerance = 1e-12;
        c.loads.gravity = 9.81;
        c.wind.sample = wf_profile_named("log")->sample;
        beam_blow(&c, 60, 0, 0);
        beam_solve(&c);
        tip[i] = c.out.end[3 * (n - 1)];
        beam_free(&c);
    }
    assert_true(fabs(tip[3]) > 1);
    for (int i = 0; i < 2; i++) assert_close(log2((tip[i] - tip[3]) / (tip[i + 1] - tip[3])), 4, 0.1);
}

/* Turn tree, loads and wind together: the answer turns with them. */
static void objective(void **state)
{
    (void)state;
    const double R[9] = { 2. / 3, -1. / 3, 2. / 3, 2. / 3, 2. / 3, -1. / 3, -1. / 3, 2. / 3, 2. / 3 };
    struct beam_case c[2];
    for (int k = 0; k < 2; k++) {
        beam_wild(&c[k], 40, 7);
        struct wf_tree *t = &c[k].tree;
        double u[3] = { 30, 5, -3 }, f[3] = { 5, -30, 60 }, m[3] = { 3, 6, 9 }, q[3] = { 8, -4, -12 };
        for (size_t i = 0; i < 40 && k; i++) {
            double a[3] = { t->x0[i], t->y0[i], t->z0[i] }, b[3] = { t->x1[i], t->y1[i], t->z1[i] }, A[3],
                   B[3];
            for (int j = 0; j < 3; j++)
                A[j] = R[3 * j] * a[0] + R[3 * j + 1] * a[1] + R[3 * j + 2] * a[2],
                B[j] = R[3 * j] * b[0] + R[3 * j + 1] * b[1] + R[3 * j + 2] * b[2];
            beam_row(&c[k], i, t->parent[i], A, B, t->r0[i], t->r1[i]);
        }
        double *vector[] = { u, f, m, q };
        for (int v = 0; v < 4 && k; v++) {
            double x[3];
            memcpy(x, vector[v], sizeof x);
            for (int j = 0; j < 3; j++)
                vector[v][j] = R[3 * j] * x[0] + R[3 * j + 1] * x[1] + R[3 * j + 2] * x[2];
        }
        for (size_t i = 0; i < 40; i++) t->lift[i] = 0.3, t->sail0[i] = t->sail1[i] = 0.02;
        beam_blow(&c[k], u[0], u[1], u[2]);
        beam_line(&c[k], q[0], q[1], q[2]);
        beam_push(&c[k], 39, WF_POINT_DEAD, f[0], f[1], f[2]);
        memcpy(beam_push(&c[k], 5, WF_POINT_FOLLOWER, m[0], m[1], m[2])->moment, m, sizeof m);
        c[k].options.shear_flexible = true, c[k].options.mesh_tolerance = 0, c[k].options.tolerance = 1e-12;
        beam_solve(&c[k]);
    }
    double most = 0;
    for (size_t i = 0; i < 40; i++)
        for (size_t j = 0; j < 3; j++) {
            const double *e = c[0].out.end + 3 * i, *m = c[0].out.moment0 + 3 * i;
            most = fmax(most, fabs(e[j]));
            assert_close(c[1].out.end[3 * i + j] + 10,
                         R[3 * j] * e[0] + R[3 * j + 1] * e[1] + R[3 * j + 2] * e[2] + 10, 1e-10);
            assert_close(c[1].out.moment0[3 * i + j] + 1e3,
                         R[3 * j] * m[0] + R[3 * j + 1] * m[1] + R[3 * j + 2] * m[2] + 1e3, 1e-9);
        }
    assert_true(most > 0.15);
    beam_free(&c[0]), beam_free(&c[1]);
}

/* A tree that is its own mirror image in the plane of the wind bends into one that is. */
static void symmetric(void **state)
{
    (void)state;
    static const double node[6][3] = { { 0, 0, 0 },    { 0, 0, 3 },   { 0.3, 1, 5 },
                                       { 0.3, -1, 5 }, { 0.5, 2, 6 }, { 0.5, -2, 6 } };
    static const struct beam_branch b[5] = {
        { 0, 1, .05, .04 }, { 1, 2, .02, .01 }, { 1, 3, .02, .01 }, { 2, 4, .01, .005 }, { 3, 5, .01, .005 }
    };
    struct beam_case c;
    beam_tree(&c, 5, node, b);
    c.loads.gravity = 9.81;
    beam_blow(&c, 35, 0, 0);
    beam_solve(&c);
    const double *e = c.out.end;
    assert_true(e[9] > 0.5);
    for (size_t i = 1; i < 5; i += 2) {
        assert_close(e[3 * i], e[3 * i + 3], 1e-9);
        assert_close(e[3 * i + 1], -e[3 * i + 4], 1e-9);
        assert_close(e[3 * i + 2], e[3 * i + 5], 1e-9);
    }
    assert_true(fabs(e[1]) < 1e-9 && fabs(c.out.base_moment[0]) < 1e-8 && fabs(c.out.base_moment[2]) < 1e-8);
    beam_free(&c);
}

/* A quarter circle, bent straight by the moment of its own curvature; and left alone. */
static void initial_curvature(void **state)
{
    (void)state;
    struct beam_case c;
    beam_unit(&c, 1, 0);
    const double k = PI / 2; /* radius 2/pi: arc length 1 */
    c.tree.bend = WF_TAKE(&c.arena, 3, double);
    c.tree.bend[1] = k;
    c.tree.x1[0] = c.tree.z1[0] = 1 / k;
    assert_close(wf_tree_length(&c.tree, 0), 1, 1e-12);
    beam_solve(&c);
    assert_true(fabs(c.out.end[0]) < 1e-11 && fabs(c.out.end[2]) < 1e-11);
    assert_close(c.out.tangent0[2], 1, 1e-12);
    assert_close(c.out.tangent1[0], 1, 1e-12);
    beam_push(&c, 0, WF_POINT_DEAD, 0, 0, 0)->moment[1] = -k;
    beam_solve(&c);
    assert_close(1 + 1 / k + c.out.end[0], 1, 1e-6);
    assert_close(1 / k + c.out.end[2], 1, 1e-6);
    beam_free(&c);
}

/* A 45-degree bend out of its plane (Bathe & Bolourchi 1979), torsion as large as bending, with stretch and
 * shear; numbers of an 8th-order Runge-Kutta shooting of the same Simo-Reissner rod. */
static void bend_45(void **state)
{
    (void)state;
    struct beam_case c;
    beam_new(&c, 1);
    const double R = 100, a = PI / 4, tip[3] = { R * (1 - cos(a)), R * sin(a), 0 };
    beam_row(&c, 0, -1, (double[3]){ 0 }, tip, 0.5, 0.5);
    c.tree.bend = WF_TAKE(&c.arena, 3, double);
    c.tree.bend[2] = -1 / R;
    c.tree.stiff = WF_TAKE(&c.arena, 4, double);
    const double stiff[4] = { 1e7, 5e6, 1e7 / 12, 833333.3333 };
    memcpy(c.tree.stiff, stiff, sizeof stiff);
    c.options.shear_flexible = true;
    beam_push(&c, 0, WF_POINT_DEAD, 0, 0, 600);
    beam_solve(&c);
    assert_close(tip[0] + c.out.end[0], 15.6848005340388, 1e-6);
    assert_close(tip[1] + c.out.end[1], 47.150438573629, 1e-6);
    assert_close(c.out.end[2], 53.4748587918252, 1e-6);
    beam_free(&c);
}

/* However coarse the mesh: forces and moments balance, each row with its neighbours too. */
static void balanced(void **state)
{
    (void)state;
    struct beam_case c;
    beam_wild(&c, 200, 3);
    beam_masses(&c);
    c.tree.mass1[150] = 0.5;
    c.loads.gravity = 9.81;
    beam_blow(&c, 15, 10, 0);
    beam_push(&c, 199, WF_POINT_FOLLOWER, 0, 1, 0);
    beam_push(&c, 60, WF_POINT_DEAD, 0, 10, -20);
    c.options.mesh_tolerance = 0;
    beam_solve(&c);
    struct wf_response *o = &c.out;
    double scale = fabs(o->base_force[2]);
    for (size_t i = 0; i < 200; i++)
        for (size_t k = 0; k < 3; k++) {
            double above = 0;
            assert_true(fabs(o->force0[3 * i + k] - o->force1[3 * i + k] - o->load[3 * i + k]) <
                        1e-12 * scale);
            for (size_t j = i + 1; j < 200; j++)
                if (c.tree.parent[j] == (int32_t)i) above += o->force0[3 * j + k];
            double own = k == 2 ? -9.81 * c.tree.mass1[i] : 0;
            if (i == 60) own += k == 1 ? 10 : k == 2 ? -20 : 0;
            if (i != 199) assert_true(fabs(o->force1[3 * i + k] - above - own) < 1e-12 * scale);
        }
    beam_free(&c);
}

/* Three orders of magnitude in stiffness, twigs of a tenth of a millimetre, a radius that grows outwards. */
static void hard_but_sound(void **state)
{
    (void)state;
    struct beam_case c;
    static const double node[6][3] = { { 0, 0, 0 },  { 0, 0, 4 },       { 0, 0, 4.0001 },
                                       { 0, .5, 5 }, { 0, .5, 5.0001 }, { .3, 1, 5.5 } };
    static const struct beam_branch b[5] = {
        { 0, 1, .03, .05 }, { 1, 2, .05, .05 }, { 2, 3, .02, .03 }, { 3, 4, .003, .003 }, { 4, 5, .004, .002 }
    };
    double answer[2][3];
    for (int k = 0; k < 2; k++) {
        beam_tree(&c, 5, node, b);
        c.tree.youngs[2] = 1e9, c.tree.youngs[3] = c.tree.youngs[4] = 2e7, c.tree.youngs[0] = 2e10;
        for (size_t i = 0; i < 5; i++) c.tree.shear[i] = c.tree.youngs[i] / 2.6;
        c.loads.gravity = 9.81;
        c.options.mesh_tolerance = k ? 1e-9 : 1e-6;
        beam_blow(&c, 12, 0, 0);
        beam_solve(&c);
        memcpy(answer[k], c.out.end + 12, sizeof answer[k]);
        beam_free(&c);
    }
    assert_true(fabs(answer[0][0]) > 0.1);
    for (int k = 0; k < 3; k++) assert_close(answer[0][k], answer[1][k], 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elastica),          cmocka_unit_test(circle),    cmocka_unit_test(follower),
        cmocka_unit_test(fourth_order),      cmocka_unit_test(objective), cmocka_unit_test(symmetric),
        cmocka_unit_test(initial_curvature), cmocka_unit_test(bend_45),   cmocka_unit_test(balanced),
        cmocka_unit_test(hard_but_sound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
