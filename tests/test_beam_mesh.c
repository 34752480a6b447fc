/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How rows are cut into elements, and how well that integrates the load of a wind that grows from the ground.
 */
#include "beam_cases.h"
#include "solve/beam_newton.h"

static const double height = 10, speed = 12, exponent = 0.22, radius = 0.2;

/* A pole that does not bend, in a wind that grows with a power of height. */
static void pole(struct beam_case *c, size_t rows, double density)
{
    beam_stem(c, rows, upright, height, radius, radius);
    for (size_t i = 0; i < rows; i++) {
        c->tree.youngs[i] = c->tree.shear[i] = 1e18, c->tree.density[i] = density;
        c->tree.drag[i] = 1, c->tree.lift[i] = 0;
    }
    beam_blow(c, speed, 0, 0);
    c->wind.sample = wf_profile_named("power")->sample;
    c->wind.reference_height = height, c->wind.exponent = exponent;
    c->loads.gravity = 9.81;
}

/* Integral of U^2 z^arm / speed^2 up to z. Below 1e-4 of the reference height U is a parabola in place of the
 * power. */
static double flow_to(double z, int arm)
{
    const double low = 1e-4 * height, power = 1 + 2 * exponent + arm, b = 2 - exponent, c = 1 - exponent;
    const double top = pow(low / height, 2 * exponent) * pow(low, 1 + arm);
    if (!(z > 0)) return 0;
    return (pow(z / height, 2 * exponent) * pow(z, 1 + arm) - top) / power +
           top * (b * b / (3 + arm) - 2 * b * c / (4 + arm) + c * c / (5 + arm));
}

/* Drag of the pole up to z [N], or its moment about the ground [N m]. */
static double drag_to(double z, int arm)
{
    return 0.5 * 1.225 * 2 * radius * speed * speed * flow_to(z, arm);
}

static const struct wf_beam_mesh *mesh_of(struct beam_case *c, const int32_t *pieces, struct wf_beam_mesh *m)
{
    assert_int_equal(wf_beam_mesh_build(&c->tree, &c->loads, &c->options, pieces, &c->arena, m, &c->err),
                     WF_OK);
    return m;
}

/* Pieces follow one another without gaps, and each place is found in its own. */
static void cuts(void **state)
{
    (void)state;
    for (int graded = 0; graded < 2; graded++) {
        static const int32_t pieces[] = { 7, 5 };
        struct beam_case c;
        struct wf_beam_mesh m;
        pole(&c, 2, 800);
        if (!graded) c.options.mesh_tolerance = 0;
        mesh_of(&c, pieces, &m);
        for (size_t row = 0; row < 2; row++) {
            double sum = 0;
            for (int32_t k = 0; k < pieces[row]; k++) {
                const double from = wf_beam_cut(&m, row, k, pieces[row]),
                             to = wf_beam_cut(&m, row, k + 1, pieces[row]);
                const double h = m.part[m.first[row] + k].h;
                assert_close(h, (to - from) * height / 2, 1e-14);
                assert_true(graded && row == 0 ? k == 0 || h > m.part[k - 1].h * 0.5
                                               : fabs(h - height / 2 / pieces[row]) < 1e-14);
                sum += h;
                for (double x = 0; x < 1; x += 0.125) {
                    double at;
                    const double s = from + x * (to - from);
                    const int32_t found = wf_beam_piece_at(&m, row, s, &at);
                    const double begins = wf_beam_cut(&m, row, found, pieces[row]),
                                 ends = wf_beam_cut(&m, row, found + 1, pieces[row]);
                    assert_true(x == 0 || found == k);
                    assert_close(begins + at * (ends - begins) + 1, s + 1, 1e-15);
                }
            }
            assert_close(sum, height / 2, 1e-14);
            double end;
            assert_int_equal(wf_beam_piece_at(&m, row, 1, &end), pieces[row] - 1);
            assert_close(end, 1, 1e-14);
        }
        assert_true(!graded || m.part[0].h < 0.02 * m.part[5].h);
        beam_free(&c);
    }
}

/* A wind of the same speed at all heights needs no short pieces, nor do rows that are not refined; still air
 * has those of the wind that is to follow. */
static void equal_pieces(void **state)
{
    (void)state;
    static const int32_t pieces[] = { 4 };
    struct beam_case c;
    struct wf_beam_mesh m;
    pole(&c, 1, 800);
    const double first = mesh_of(&c, pieces, &m)->part[0].h;
    assert_true(first < height / 40);
    c.loads.sheared = wf_loads_sheared(&c.loads), c.loads.wind = NULL;
    assert_true(mesh_of(&c, pieces, &m)->part[0].h == first);
    c.options.mesh_tolerance = 0;
    assert_close(mesh_of(&c, pieces, &m)->part[0].h, height / 4, 1e-15);
    beam_free(&c);
    pole(&c, 1, 800);
    c.wind.sample = wf_profile_named("uniform")->sample;
    assert_close(mesh_of(&c, pieces, &m)->part[0].h, height / 4, 1e-15);
    beam_free(&c);
}

/* Drag of the pole as a mesh of that many pieces integrates it. */
static double drag_on(int32_t pieces)
{
    struct beam_case c;
    struct wf_arena work = { 0 };
    struct wf_beam b;
    pole(&c, 1, 0);
    assert_int_equal(wf_beam_init(&b, &c.tree, &c.loads, &c.options, &pieces, &work, &work, &c.err), WF_OK);
    assert_true(wf_beam_rests(&b));
    const double drag = b.base.n[0];
    wf_arena_free(&work);
    beam_free(&c);
    return drag;
}

/* Pieces of equal length would give the order 1 + 2 x exponent, 1.44. */
static void order_at_the_ground(void **state)
{
    (void)state;
    const double exact = drag_to(height, 0);
    for (int32_t n = 4; n <= 8; n *= 2) {
        const double coarse = fabs(drag_on(n) / exact - 1), fine = fabs(drag_on(2 * n) / exact - 1);
        if (!(coarse > pow(2, 3.3) * fine)) fail_msg("%d pieces: %g, twice as many: %g", n, coarse, fine);
    }
}

/* Of a pole that weighs from nothing to 25 times the load of the wind, drag and moment are those of
 * the integrals within the tolerance: weight does not hide errors of the wind's load. */
static void error_of_the_wind(void **state)
{
    (void)state;
    const double tolerance[] = { 1e-4, 1e-6, 1e-8 }, density[] = { 0, 80, 800 };
    for (size_t rows = 1; rows <= 40; rows = 3 * rows + 1)
        for (size_t t = 0; t < 3; t++)
            for (size_t d = 0; d < 3; d++) {
                struct beam_case c;
                pole(&c, rows, density[d]);
                c.options.mesh_tolerance = tolerance[t];
                beam_solve(&c);
                double sum = 0;
                for (size_t i = 0; i < rows; i++) {
                    const double low = height * (double)i / (double)rows,
                                 top = height * (double)(i + 1) / (double)rows;
                    sum += fabs(c.out.load[3 * i] - drag_to(top, 0) + drag_to(low, 0));
                }
                if (!(sum <= tolerance[t] * drag_to(height, 0)))
                    fail_msg("%zu rows, %g kg/m3, %g: off by %g", rows, density[d], tolerance[t],
                             sum / drag_to(height, 0));
                assert_close(c.out.base_force[0], drag_to(height, 0), tolerance[t]);
                assert_close(c.out.base_moment[1], drag_to(height, 1), tolerance[t]);
                beam_free(&c);
            }
}

/* Places of a stem on a soft root plate, the top of which is thin, are within the tolerance of its largest
 * displacement, as solved by a thousandth of the tolerance. */
static void thin_top(void **state)
{
    (void)state;
    const double tolerance = 1e-6;
    for (size_t rows = 10; rows <= 40; rows *= 2)
        for (double thin = 0.6; thin > 0.04; thin /= 1.5) {
            struct beam_case c;
            struct wf_response got;
            double most = 0, off = 0;
            beam_stem(&c, rows, upright, 20, 0.41, 0.12);
            beam_blow(&c, 25, 0, 0);
            c.wind.sample = wf_profile_named("power")->sample;
            c.wind.reference_height = height, c.wind.exponent = exponent;
            c.loads.gravity = 9.81;
            c.tree.r1[rows - 1] = thin * c.tree.r0[rows - 1];
            for (size_t i = rows / 4; i < rows; i++) c.tree.sail0[i] = c.tree.sail1[i] = 4;
            c.options.root_stiffness[0] = c.options.root_stiffness[1] = 5e6;
            c.options.mesh_tolerance = tolerance;
            beam_solve(&c);
            got = c.out;
            c.options.mesh_tolerance = 1e-3 * tolerance;
            beam_solve(&c);
            for (size_t i = 0; i < 3 * rows; i++)
                most = fmax(most, fabs(c.out.end[i])), off = fmax(off, fabs(c.out.end[i] - got.end[i]));
            if (!(off <= tolerance * most)) fail_msg("%zu rows, thin %g: off by %g", rows, thin, off / most);
            beam_free(&c);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(cuts), cmocka_unit_test(equal_pieces),
                                        cmocka_unit_test(order_at_the_ground),
                                        cmocka_unit_test(error_of_the_wind), cmocka_unit_test(thin_top) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
