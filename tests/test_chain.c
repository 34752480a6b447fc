/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The chain of cantilevers on a stem: exact where it should be, wrong as printed where it is as printed. */
#include "chain.h"

static const double up[3] = { 0, 0, 1 };

static void exact_for_a_uniform_stem(void **state)
{
    (void)state;
    static const size_t counts[] = { 1, 2, 3, 10, 100 };
    const double L = HEIGHT, P = 12, M = 30, q = 7;
    for (size_t c = 0; c < 5; c++) {
        struct fixture f;
        stem(&f, counts[c], up, 1);
        size_t tip = 3 * (counts[c] - 1);
        struct wf_point_load p = { .segment = (int32_t)counts[c] - 1,
                                   .force = { P, 0, 0 },
                                   .moment = { 0, M, 0 } };
        f.l.point = &p, f.l.points = 1;
        line_x(&f, q, q);
        solve(&f, &wf_chain_corrected);
        assert_close(f.r.end[tip], (P * L * L * L / 3 + M * L * L / 2 + q * L * L * L * L / 8) / ei, 1e-12);
        assert_close(f.r.turn[tip + 1], (P * L * L / 2 + M * L + q * L * L * L / 6) / ei, 1e-12);
        assert_close(f.r.base_force[0], P + q * L, 1e-13);
        assert_close(f.r.base_moment[1], P * L + M + q * L * L / 2, 1e-13);
        for (size_t i = 0; i < counts[c]; i++) { /* shear and moment along the stem */
            double rest = L - f.t.z0[i];
            assert_close(f.r.force0[3 * i], P + q * rest, 1e-12);
            assert_close(f.r.moment0[3 * i + 1], P * rest + M + q * rest * rest / 2, 1e-12);
            if (i) assert_close(f.r.moment1[3 * i - 2], f.r.moment0[3 * i + 1], 1e-13);
        }
        double slope = f.r.turn[tip + 1], size = sqrt(1 + slope * slope);
        assert_close(f.r.tangent1[tip], slope / size, 1e-12);
        assert_close(f.r.tangent0[2], 1, 0);
        wf_arena_free(&f.arena);
    }
}

/* The twelve columns of the comparison: force handed on spread (S1) or at the end (S2), with moments too (S3,
 * S4); rotation handed on or not. Worked out row by row with the textbook formulas of a cantilever; the
 * digits at N = 2 and 10, by rational arithmetic, guard the formulas. */
static void every_scheme_against_textbook_rows(void **state)
{
    (void)state;
    static const size_t counts[] = { 1, 2, 5, 10, 20, 50, 100 };
    static const double digits[2][12] = {
        { 0.1875, 0.35416667, 0.375, 0.29166667, 0.625, 0.625, 0.3125, 0.72916667, 0.75, 0.41666667, 1, 1 },
        { 0.0055, 0.0495, 0.055, 0.013, 0.133, 0.145, 0.0625, 0.9165, 0.91, 0.07, 1, 1 }
    };
    const double q = 3;
    for (int scheme = 0; scheme < 4; scheme++)
        for (size_t c = 0; c < 7; c++) {
            size_t n = counts[c];
            double smear = scheme % 2 == 0, moment = scheme >= 2, l = HEIGHT / (double)n, y = 0, lifted = 0,
                   turn = 0;
            for (size_t i = 0; i < n; i++) {
                double above = (double)(n - 1 - i) * l, F = q * above, M = moment * q * above * above / 2;
                double own_y =
                    q * pow(l, 4) / 8 + F * pow(l, 3) * (smear > 0 ? 1. / 8 : 1. / 3) + M * l * l / 2;
                y += own_y / ei;
                lifted += own_y / ei + turn * l;
                turn += (q * pow(l, 3) / 6 + F * l * l * (smear > 0 ? 1. / 6 : 1. / 2) + M * l) / ei;
            }
            double exact_y = q * pow(HEIGHT, 4) / (8 * ei), exact_turn = q * pow(HEIGHT, 3) / (6 * ei);
            if (n == 2 || n == 10) {
                const double *want = digits[n == 10] + 3 * scheme;
                assert_close(y / exact_y, want[0], 1e-7);
                assert_close(lifted / exact_y, want[1], 1e-7);
                assert_close(turn / exact_turn, want[2], 1e-7);
            }
            struct wf_chain_scheme s = { .smear = smear, .moment = moment, .taper = 1 };
            struct fixture f;
            stem(&f, n, up, 1);
            line_x(&f, q, q);
            solve(&f, &s);
            assert_close(f.r.end[3 * n - 3], y, 1e-12);
            s.carry = 1;
            solve(&f, &s);
            assert_close(f.r.end[3 * n - 3], lifted, 1e-12);
            assert_close(f.r.turn[3 * n - 2], turn, 1e-12);
            wf_arena_free(&f.arena);
        }
}

static void as_printed(void **state)
{
    (void)state;
    const double q = 3, N = 20, L = HEIGHT;
    struct fixture f;
    stem(&f, 20, up, 1);
    line_x(&f, q, q);
    assert_int_equal(wf_solver_chain_as_printed.solve(&f.t, &f.l, &f.o, &f.arena, &f.r, &f.d, &f.e), WF_OK);
    assert_close(f.r.end[57], q * pow(L, 4) / (8 * ei) * (N + 1) / (2 * N * N * N), 1e-12);
    assert_close(f.r.turn[58], q * pow(L / N, 3) / (6 * ei), 1e-12); /* the last row alone */
    assert_close(f.r.tangent0[57], 0, 0);
    assert_close(f.r.base_moment[1], q * L * L / 2, 1e-13); /* statics all the same */
    wf_arena_free(&f.arena);

    stem(&f, 1, up, 0.4); /* a frustum bends with its mean radius, and weighs nothing */
    f.l.gravity = 9.81;
    line_x(&f, q, q);
    solve(&f, &wf_chain_printed);
    assert_close(f.r.end[0], q * pow(L, 4) / (8 * ei * pow(0.7, 4)), 1e-12);
    assert_close(f.r.base_force[2], 0, 0);
    wf_arena_free(&f.arena);
}

/* Linear taper under a tip load, a uniform line load, a line load that goes with the radius: tip deflection
 * and rotation as coefficients, by multiprecision quadrature. */
static void exact_for_a_tapered_stem(void **state)
{
    (void)state;
    static const struct {
        double tip, load_y, load_turn, line_y, line_turn, pressure_y, pressure_turn;
    } want[] = {
        { 0.75, 0.44444444444444444, 0.74074074074074074, 0.15663860716129205, 0.22222222222222222,
          0.12750701487634366, 0.17971988393010767 },
        { 0.5, 0.66666666666666667, 1.3333333333333333, 0.21184411114622914, 0.33333333333333333,
          0.13135931480896181, 0.20197401852437152 },
        { 0.25, 1.3333333333333333, 4, 0.33883553362155555, 0.66666666666666667, 0.1384303721982037,
          0.25137555007205555 },
        { 0.1, 3.3333333333333333, 20, 0.57505341639540137, 1.6666666666666667, 0.14749821945348662,
          0.33918269158528708 },
    };
    const double L = HEIGHT, q = 2, P = 5;
    for (int k = 0; k < 4; k++)
        for (size_t n = 1; n <= 7; n += 3) {
            struct fixture f;
            size_t tip = 3 * (n - 1);
            stem(&f, n, up, want[k].tip);
            struct wf_point_load p = { .segment = (int32_t)n - 1, .force = { P, 0, 0 } };
            f.l.point = &p, f.l.points = 1;
            solve(&f, &wf_chain_corrected);
            assert_close(f.r.end[tip], want[k].load_y * P * pow(L, 3) / ei, 1e-12);
            assert_close(f.r.turn[tip + 1], want[k].load_turn * P * pow(L, 2) / ei, 1e-12);
            f.l.points = 0;
            line_x(&f, q, q);
            solve(&f, &wf_chain_corrected);
            assert_close(f.r.end[tip], want[k].line_y * q * pow(L, 4) / ei, 1e-12);
            assert_close(f.r.turn[tip + 1], want[k].line_turn * q * pow(L, 3) / ei, 1e-12);
            line_x(&f, q, q * want[k].tip);
            solve(&f, &wf_chain_corrected);
            assert_close(f.r.end[tip], want[k].pressure_y * q * pow(L, 4) / ei, 1e-12);
            assert_close(f.r.turn[tip + 1], want[k].pressure_turn * q * pow(L, 3) / ei, 1e-12);
            wf_arena_free(&f.arena);
        }
}

static void hollow_and_given_stiffness(void **state)
{
    (void)state;
    const double q = 2, line = q * pow(HEIGHT, 4) / 8;
    struct fixture f;
    stem(&f, 3, up, 1);
    line_x(&f, q, q);
    for (int i = 0; i < 3; i++) f.t.i0[i] = f.t.i1[i] = 0.8 * RADIUS;
    solve(&f, &wf_chain_corrected);
    assert_close(f.r.end[6], line / (ei * (1 - pow(0.8, 4))), 1e-12);
    double stiff[12];
    for (int i = 0; i < 3; i++) memcpy(stiff + 4 * i, (double[4]){ 1, 1, 5000, 4000 }, 4 * sizeof *stiff);
    f.t.stiff = stiff;
    solve(&f, &wf_chain_corrected);
    assert_close(f.r.end[6], line / 5000, 1e-12);
    wf_arena_free(&f.arena);
}

/* Of the weight of a leaning stem only the part across its axis bends it; that of a point mass alike. */
static void weight_bends_what_leans(void **state)
{
    (void)state;
    const double lean = 0.3, axis[3] = { sin(lean), 0, cos(lean) }, L = HEIGHT;
    double q = 900 * PI * RADIUS * RADIUS * 9.81 * sin(lean), mass[4] = { 0, 0, 0, 6 },
           P = 6 * 9.81 * sin(lean);
    struct fixture f;
    stem(&f, 4, axis, 1);
    f.l.gravity = 9.81;
    f.t.mass1 = mass;
    solve(&f, &wf_chain_corrected);
    double y = (q * pow(L, 4) / 8 + P * pow(L, 3) / 3) / ei;
    assert_close(f.r.end[9], y * cos(lean), 1e-12);
    assert_close(f.r.end[11], -y * sin(lean), 1e-12);
    wf_arena_free(&f.arena);

    stem(&f, 4, up, 1);
    f.l.gravity = 9.81;
    solve(&f, &wf_chain_corrected); /* upright, no wind: weight only */
    for (size_t i = 0; i < 12; i++) assert_close(f.r.end[i], 0, 0);
    assert_close(f.r.base_force[2], -900 * PI * RADIUS * RADIUS * 9.81 * L, 1e-12);
    wf_arena_free(&f.arena);
}

static void root_plate_tilts(void **state)
{
    (void)state;
    struct fixture f;
    stem(&f, 5, up, 1);
    line_x(&f, 2, 2);
    f.o.root_stiffness[0] = f.o.root_stiffness[1] = 1e4;
    solve(&f, &wf_chain_corrected);
    double tilt = 2 * HEIGHT * HEIGHT / 2 / 1e4;
    assert_close(f.r.end[12], 2 * pow(HEIGHT, 4) / (8 * ei) + tilt * HEIGHT, 1e-12);
    assert_close(f.r.tangent0[0], tilt / sqrt(1 + tilt * tilt), 1e-12);
    wf_arena_free(&f.arena);
}

static void refusals(void **state)
{
    (void)state;
    struct fixture f;
    stem(&f, 3, up, 1);
    struct wf_point_load p = { .segment = 3 };
    f.l.point = &p, f.l.points = 1;
    assert_int_equal(wf_chain_solve(&wf_chain_corrected, &f.t, &f.l, &f.o, &f.arena, &f.r, NULL, &f.e),
                     WF_EUSAGE);
    assert_non_null(strstr(f.e.text, "no segment 3"));
    f.l.points = 0;
    struct wf_arena small = { .limit = 64 };
    assert_int_equal(wf_chain_solve(&wf_chain_corrected, &f.t, &f.l, &f.o, &small, &f.r, NULL, NULL),
                     WF_ENOMEM);
    wf_arena_free(&small);
    f.t.bend = WF_TAKE(&f.arena, 9, double);
    solve(&f, &wf_chain_corrected);
    assert_int_equal(f.d.warnings, 1);
    f.t.r1[1] = 0;
    assert_int_equal(wf_chain_solve(&wf_chain_corrected, &f.t, &f.l, &f.o, &f.arena, &f.r, &f.d, NULL),
                     WF_EINPUT);
    assert_int_equal(f.d.errors, 1);
    wf_arena_free(&f.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_for_a_uniform_stem),
        cmocka_unit_test(every_scheme_against_textbook_rows),
        cmocka_unit_test(as_printed),
        cmocka_unit_test(exact_for_a_tapered_stem),
        cmocka_unit_test(hollow_and_given_stiffness),
        cmocka_unit_test(weight_bends_what_leans),
        cmocka_unit_test(root_plate_tilts),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
