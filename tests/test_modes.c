/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Natural frequencies and self-buckling against closed forms and independent computations. */
#include "beam_cases.h"
#include "solve/modes.h"

enum { MOST = 12 };
static double f[MOST];

static void modes(struct beam_case *c, size_t count)
{
    c->err = (struct wf_err){ 0 };
    if (wf_modes(&c->tree, &c->loads, &c->options, count, &c->arena, f, NULL, &c->err))
        fail_msg("%s", c->err.text);
    for (size_t i = 0; i < count; i++) f[i] *= 2 * PI; /* rad/s */
}

static double buckling(struct beam_case *c)
{
    double factor = 0;
    if (wf_buckling(&c->tree, &c->loads, &c->options, &c->arena, &factor, &c->err))
        fail_msg("%s", c->err.text);
    return factor;
}

/* cos b cosh b = -1; a round stem sways alike in both directions. */
static void uniform(void **state)
{
    (void)state;
    const double b[3] = { 1.8751040687119611665, 4.6940911329741745764, 7.8547574382376125649 };
    struct beam_case c;
    beam_unit(&c, 1, 1);
    modes(&c, 6);
    for (size_t i = 0; i < 6; i++) assert_close(f[i], b[i / 2] * b[i / 2], 1e-6);
    for (size_t i = 0; i < 6; i += 2) assert_close(f[i], f[i + 1], 1e-9);
    beam_free(&c);
}

/* Two uniform stems side by side sway alike in both directions each: every frequency four times. */
static void four_alike(void **state)
{
    (void)state;
    const double b[3] = { 1.8751040687119611665, 4.6940911329741745764, 7.8547574382376125649 };
    struct beam_case c;
    beam_unit(&c, 2, 1);
    for (size_t i = 0; i < 2; i++) {
        double x = 3 * (double)i, from[3] = { x, 0, 0 }, to[3] = { x, 0, 1 };
        beam_row(&c, i, -1, from, to, 1e-3, 1e-3);
    }
    modes(&c, 12);
    for (size_t i = 0; i < 12; i++) assert_close(f[i], b[i / 4] * b[i / 4], 1e-6);
    for (size_t i = 0; i < 12; i++) assert_close(f[i], f[4 * (i / 4)], 1e-9);
    beam_free(&c);
}

/* A stem with four equal branches crosswise, turned about the vertical by `angle`, each with two twigs in its
 * upright plane. */
static void cross(struct beam_case *c, double angle)
{
    const double fork[3] = { 0, 0, 2 }, ground[3] = { 0, 0, 0 };
    beam_new(c, 13);
    beam_row(c, 0, -1, ground, fork, 0.1, 0.08);
    for (size_t k = 0; k < 4; k++) {
        double a = angle + 0.5 * PI * (double)k, x = cos(a), y = sin(a);
        double end[3] = { x, y, 3 }, low[3] = { 1.8 * x, 1.8 * y, 3.1 }, high[3] = { 1.2 * x, 1.2 * y, 3.9 };
        int32_t branch = 1 + 3 * (int32_t)k;
        beam_row(c, 1 + 3 * k, 0, fork, end, 0.05, 0.04);
        beam_row(c, 2 + 3 * k, branch, end, low, 0.02, 0.01);
        beam_row(c, 3 + 3 * k, branch, end, high, 0.02, 0.01);
    }
}

/* Of the motions of a tree with fourfold symmetry those that sway to a side come in pairs. All are found: the
 * frequencies do not depend on how the tree stands to the axes. */
static void pairs_of_a_cross(void **state)
{
    (void)state;
    double straight[MOST];
    size_t pairs = 0;
    for (int turned = 0; turned < 2; turned++) {
        struct beam_case c;
        cross(&c, turned ? 0.7 : 0);
        c.options.mesh_tolerance = 0;
        modes(&c, MOST);
        for (size_t i = 0; turned && i < MOST; i++) assert_close(f[i], straight[i], 1e-9);
        memcpy(straight, f, sizeof f);
        beam_free(&c);
    }
    for (size_t i = 0; i + 1 < MOST; i++) pairs += fabs(f[i + 1] / f[i] - 1) < 1e-9;
    assert_true(pairs >= 3);
}

/* Shapes: the displacement of the rows' ends, largest component 1; the first mode of a uniform stem. */
static void shape(void **state)
{
    (void)state;
    struct beam_case c;
    double w[2 * 12];
    beam_unit(&c, 4, 1);
    assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 2, &c.arena, f, w, &c.err), WF_OK);
    const double b = 1.8751040687119611665, s = (sinh(b) - sin(b)) / (cosh(b) + cos(b));
    const double top = cosh(b) - cos(b) - s * (sinh(b) - sin(b));
    double dot = 0, norm[2] = { 0, 0 };
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++) {
            const double *u = w + 12 * i + 3 * k, *tip = w + 12 * i + 9;
            double x = b * (k + 1) / 4, want = (cosh(x) - cos(x) - s * (sinh(x) - sin(x))) / top;
            assert_close(hypot(u[0], u[1]) / hypot(tip[0], tip[1]), want, 1e-5);
            assert_true(fabs(u[2]) < 1e-9);
            for (int j = 0; j < 2; j++) norm[i] = fmax(norm[i], fabs(u[j]));
        }
    for (int k = 0; k < 2; k++) dot += w[9 + k] * w[12 + 9 + k]; /* the two directions of one mode */
    assert_true(fabs(dot) < 1e-6);
    assert_close(norm[0], 1, 1e-12);
    assert_close(norm[1], 1, 1e-12);
    beam_free(&c);
}

/* Upright under its weight, with and without a tip mass; Rayleigh-Ritz with polynomials, 40 digits. A buckled
 * state (clamped upright past its limit) gives its growing motion as a negative figure. */
static void heavy(void **state)
{
    (void)state;
    static const struct {
        double W, mass, first, second;
    } row[] = {
        { 2, 0, 3.0360365998383297, 21.638302994399129 },
        { 5, 0, 2.1184859438565489, 21.029280625000922 },
        { 0, 0.5, 2.0162989818067806, 16.90141772097364 },
        { 2, 0.5, 1.1928564058423376, 16.141855442821321 },
        { 0, 2, 1.1581971073829628, 15.860889992394663 },
        { 5, 0.5, -1.6099487527280486, 14.929819985534781 },
        { 2, 2, -1.0895798953455064, 13.868225594439861 },
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        struct beam_case c;
        beam_unit(&c, 1, 1);
        beam_masses(&c);
        c.tree.mass1[0] = row[k].mass;
        c.loads.gravity = row[k].W;
        modes(&c, 4);
        assert_close(f[0], row[k].first, 1e-6);
        assert_close(f[2], row[k].second, 1e-6);
        beam_free(&c);
    }
}

/* Rods that cannot bend: axial (2i-1)/4 sqrt(E/rho)/L, torsional (2i-1)/4 sqrt(G/rho)/L. */
static void stiff_ways(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 1, upright, 3, 20, 20); /* thick, so that bending is the highest */
    modes(&c, 1);
    assert_close(f[0], PI / 2 * sqrt(9e9 / 2.6 / 800) / 3, 1e-6);
    c.tree.shear[0] = 4e10;
    modes(&c, 1);
    assert_close(f[0], PI / 2 * sqrt(9e9 / 800) / 3, 1e-6);
    beam_free(&c);
}

/* Branching trees, no gravity: Hermite frame elements, Richardson-extrapolated (good to about 1e-8). */
static void trees(void **state)
{
    (void)state;
    const double three[6] = { 5.30579804398863, 5.36305245294615, 13.5379272824553,
                              15.5352323874581, 18.5849730962125, 19.2874672561178 };
    const double seven[6] = { 2.51499182923894, 2.54835491765159, 4.7078698282035,
                              5.02515644081103, 7.5730487711103,  7.59933270348677 };
    struct beam_case c;
    beam_tree3(&c);
    modes(&c, 6);
    for (int i = 0; i < 6; i++) assert_close(f[i] / (2 * PI), three[i], 1e-6);
    beam_free(&c);
    beam_tree7(&c);
    modes(&c, 6);
    for (int i = 0; i < 6; i++) assert_close(f[i] / (2 * PI), seven[i], 1e-6);
    beam_free(&c);
}

/* Error of the first frequency of a tapered stem: a sixteenth when the elements are halved. */
static void fourth_order(void **state)
{
    (void)state;
    double first[3];
    for (size_t i = 0; i < 3; i++) {
        struct beam_case c;
        beam_stem(&c, i == 2 ? 160 : (size_t)5 << i, upright, 8, 0.06, 0.02);
        c.options.mesh_tolerance = 0;
        c.loads.gravity = 9.81;
        modes(&c, 1);
        first[i] = f[0];
        beam_free(&c);
    }
    assert_close(log2((first[0] - first[2]) / (first[1] - first[2])), 4, 0.1);
}

/* About the bent state: a stem blown over by a storm sways otherwise than at rest; wind and follower forces
 * count as the dead loads they are at that moment. */
static void prestressed(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 8, upright, 10, 0.05, 0.02);
    modes(&c, 2);
    double rest = f[0];
    beam_blow(&c, 60, 0, 0);
    modes(&c, 2);
    assert_true(f[0] > 0 && fabs(f[0] / rest - 1) > 0.05 && fabs(f[1] / f[0] - 1) > 0.01);
    beam_free(&c);
    double dead[2];
    for (int k = 0; k < 2; k++) {
        beam_unit(&c, 1, 1);
        beam_push(&c, 0, k ? WF_POINT_DEAD : WF_POINT_FOLLOWER, 0, 0, -1);
        modes(&c, 2);
        dead[k] = f[0];
        beam_free(&c);
    }
    assert_close(dead[0], dead[1], 1e-9);
    assert_true(dead[1] < 3.5);
}

/* A point mass on a massless stem: one motion a direction, sqrt(3 EI/(m L^3)); the mesh has no more. */
static void few_motions(void **state)
{
    (void)state;
    struct beam_case c;
    beam_unit(&c, 1, 0);
    beam_masses(&c);
    c.tree.mass1[0] = 5;
    modes(&c, 4);
    assert_close(f[0], sqrt(3. / 5), 1e-6);
    assert_close(f[1], sqrt(3. / 5), 1e-6);
    assert_true(isnan(f[2]) && isnan(f[3]));
    c.tree.mass1[0] = 0;
    modes(&c, 1); /* nothing to move */
    assert_true(isnan(f[0]));
    beam_free(&c);
}

/* Greenhill's factors: Rayleigh-Ritz with polynomials, 40 digits; the cylinder is 9/4 j_{-1/3,1}^2. */
static void greenhill(void **state)
{
    (void)state;
    static const double row[][2] = { { 1, 7.8373474389434839 },   { 0.75, 9.4707747227470975 },
                                     { 0.5, 12.053559019577987 }, { 0.25, 16.936989943702751 },
                                     { 0.1, 23.028534080801203 }, { 1e-4, 30.52984936365024 } };
    for (size_t k = 0; k < 6; k++) {
        struct beam_case c;
        beam_stem(&c, 1, upright, 10, 0.1, 0.1 * row[k][0]);
        c.loads.gravity = 9.81;
        double W = 800 * 9.81 * 1000 / (9e9 / 4 * 1e-2);
        assert_close(W * buckling(&c), row[k][1], k == 5 ? 1e-3 : 1e-6);
        beam_blow(&c, 40, 0, 0); /* wind and other loads are left out */
        beam_push(&c, 0, WF_POINT_DEAD, 0, 0, -1e5);
        assert_close(W * buckling(&c), row[k][1], k == 5 ? 1e-3 : 1e-6);
        beam_free(&c);
    }
    struct beam_case c;
    beam_unit(&c, 1, 1);
    beam_masses(&c);
    c.tree.mass1[0] = 0.5, c.loads.gravity = 1;
    assert_close(buckling(&c), 3.0691084330764516, 1e-6);
    c.options.mesh_tolerance = 0;
    assert_true(fabs(buckling(&c) / 3.0691084330764516 - 1) > 1e-6); /* one element is too few */
    beam_free(&c);
}

/* A mass on a massless stem: Euler's pi^2/4 EI/L^2. */
static void euler(void **state)
{
    (void)state;
    struct beam_case c;
    beam_unit(&c, 1, 0);
    beam_masses(&c);
    c.tree.mass1[0] = 2, c.loads.gravity = 9.81;
    assert_close(buckling(&c), PI * PI / 4 / (2 * 9.81), 1e-6);
    beam_free(&c);
}

/* Hanging, or weightless: stands at any multiple. */
static void never(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 3, (double[]){ 0, 0, -1 }, 10, 0.05, 0.02);
    c.loads.gravity = 9.81;
    assert_true(isinf(buckling(&c)));
    beam_free(&c);
    beam_stem(&c, 3, upright, 10, 0.05, 0.02);
    assert_true(isinf(buckling(&c)));
    beam_free(&c);
}

/* At the buckling load the first frequency is zero: omega^2 falls through it there. */
static void both_agree(void **state)
{
    (void)state;
    struct beam_case c;
    beam_tree7(&c);
    c.loads.gravity = 9.81;
    for (size_t i = 0; i < 7; i++) /* upright, so that the unbent shape is the balanced one */
        c.tree.x0[i] = c.tree.y0[i] = c.tree.x1[i] = c.tree.y1[i] = 0;
    c.options.inextensible = true; /* the unbent shape is also unshortened */
    double factor = buckling(&c);
    assert_true(isfinite(factor) && factor > 1);
    c.loads.weight_scale = factor * 0.9999;
    modes(&c, 1);
    assert_true(f[0] > 0 && f[0] < 0.5);
    c.loads.weight_scale = factor * 1.0001;
    modes(&c, 1);
    assert_true(f[0] < 0 && f[0] > -0.5);
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_alike),  cmocka_unit_test(pairs_of_a_cross),
        cmocka_unit_test(uniform),     cmocka_unit_test(shape),
        cmocka_unit_test(heavy),       cmocka_unit_test(stiff_ways),
        cmocka_unit_test(trees),       cmocka_unit_test(fourth_order),
        cmocka_unit_test(prestressed), cmocka_unit_test(few_motions),
        cmocka_unit_test(greenhill),   cmocka_unit_test(euler),
        cmocka_unit_test(never),       cmocka_unit_test(both_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
