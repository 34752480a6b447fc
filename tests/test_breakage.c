/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress and safety of sections, against closed forms of a cantilever. */
#include "close.h"
#include "data/section.h"
#include "fail/fail.h"
#include "solve/chain.h"

#define PI 3.14159265358979323846
static const double L = 6, R = 0.04, P = 20, STRENGTH = 60e6;

struct fixture {
    struct wf_arena arena;
    struct wf_tree t;
    struct wf_response r;
    struct wf_breakage b;
    struct wf_worst worst[WF_CRITERIA][WF_SCOPES];
    struct wf_err e;
};

/* A stem of n rows, radius linear to tip*R, pushed along x at its tip, solved by the exact chain. */
static void cantilever(struct fixture *f, size_t n, double tip, double inner, struct wf_point_load p,
                       double gravity)
{
    struct wf_loads l;
    struct wf_solve_options o;
    *f = (struct fixture){ 0 };
    wf_loads_default(&l);
    wf_solve_options_default(&o);
    assert_int_equal(wf_tree_alloc(&f->t, n, &f->arena, &f->e), WF_OK);
    for (size_t i = 0; i < n; i++) {
        double s0 = (double)i / (double)n, s1 = (double)(i + 1) / (double)n;
        f->t.parent[i] = (int32_t)i - 1;
        f->t.z0[i] = s0 * L, f->t.z1[i] = s1 * L;
        f->t.r0[i] = R * (1 - (1 - tip) * s0), f->t.r1[i] = R * (1 - (1 - tip) * s1);
        f->t.i0[i] = inner * f->t.r0[i], f->t.i1[i] = inner * f->t.r1[i];
        f->t.youngs[i] = 1e20, f->t.shear[i] = 1e19; /* stiff: the axis stays upright, statics are exact */
        f->t.density[i] = 800, f->t.strength[i] = STRENGTH;
    }
    p.segment = (int32_t)n - 1;
    l.gravity = gravity, l.point = &p, l.points = 1;
    assert_int_equal(wf_solver_chain.solve(&f->t, &l, &o, &f->arena, &f->r, NULL, &f->e), WF_OK);
    assert_int_equal(wf_breakage_check(&f->t, &f->r, NULL, &f->arena, &f->b, &f->e), WF_OK);
    wf_criteria_check(&f->t, &f->r, &f->b, f->worst);
}

static const struct wf_point_load push = { .force = { 20, 0, 0 } };

static void sections(void **state)
{
    (void)state;
    assert_close(wf_ring_area(2, 0), 4 * PI, 1e-15);
    assert_close(wf_ring_area(2, 1), 3 * PI, 1e-15);
    assert_close(wf_ring_inertia(2, 0), 4 * PI, 1e-15);
    assert_close(wf_ring_inertia(2, 1), 15 * PI / 4, 1e-15);
}

static void uniform_stem_breaks_at_its_base(void **state)
{
    (void)state;
    struct fixture f;
    cantilever(&f, 4, 1, 0, push, 0);
    double stress = 4 * P * L / (PI * R * R * R);
    assert_close(f.b.bending0[0], P * L, 1e-9);
    assert_close(f.b.shear0[2], P, 1e-9);
    assert_close(f.b.stress0[0], stress, 1e-9);
    assert_close(f.b.stress1[0], 0.75 * stress, 1e-9);
    assert_close(f.b.safety0[0], STRENGTH / stress, 1e-9);
    assert_close(f.worst[0][0].safety, STRENGTH / stress, 1e-9);
    assert_int_equal(f.worst[0][0].row, 0);
    assert_close(f.worst[0][0].place, 0, 0);
    assert_close(f.b.largest_stress, stress, 1e-9);
    assert_true(isinf(f.b.safety1[3]) || f.b.safety1[3] > 1e6); /* the free end bears nothing but its shear */
    wf_arena_free(&f.arena);
}

static void ring_axial_force_and_torsion(void **state)
{
    (void)state;
    struct fixture f;
    struct wf_point_load p = { .force = { 20, 0, -500 }, .moment = { 0, 0, 7 } };
    cantilever(&f, 3, 1, 0.8, p, 9.81);
    double area = PI * R * R * 0.36, inertia = PI / 4 * pow(R, 4) * (1 - 0.4096),
           weight = 800 * area * L * 9.81;
    assert_close(f.b.axial0[0], -500 - weight, 1e-9);
    assert_close(f.b.axial1[2], -500, 1e-9);
    assert_close(f.b.torsion0[1], 7, 1e-9);
    assert_close(f.b.stress0[0], P * L * R / inertia + (500 + weight) / area, 1e-9);
    wf_arena_free(&f.arena);
}

/* Under a tip force the stress of a cone is largest where its radius is 1.5 times that of the tip, if it is
 * so thick anywhere: coefficients of P L r0/I0 by golden section at high precision. */
static void tapered_stem_breaks_higher_up(void **state)
{
    (void)state;
    static const struct {
        double tip, place, coefficient;
    } want[] = { { 0.75, 0, 1 },
                 { 0.5, 0.5, 1.1851851851851852 },
                 { 0.25, 0.83333333333333333, 3.1604938271604938 },
                 { 0.1, 0.94444444444444444, 16.460905349794239 } };
    const double stress0 = 4 * P * L / (PI * R * R * R);
    for (int k = 0; k < 4; k++)
        for (size_t n = 1; n <= 7; n++) {
            struct fixture f;
            cantilever(&f, n, want[k].tip, 0, push, 0);
            double place = ((double)f.worst[0][0].row + f.worst[0][0].place) / (double)n;
            assert_close(f.b.largest_stress, want[k].coefficient * stress0, 1e-6);
            assert_close(f.worst[0][0].safety, STRENGTH / (want[k].coefficient * stress0), 1e-6);
            assert_true(fabs(place - want[k].place) < 1e-3);
            assert_int_equal(f.b.largest_stress_row, f.worst[0][0].row);
            wf_arena_free(&f.arena);
        }
}

/* The weakest section governs, not the most stressed; rows without a strength are passed over. */
static void strength_of_each_row_counts(void **state)
{
    (void)state;
    struct fixture f;
    cantilever(&f, 4, 1, 0, push, 0);
    double stress = 4 * P * L / (PI * R * R * R);
    f.t.strength[0] = 0, f.t.strength[2] = STRENGTH / 10;
    assert_int_equal(wf_breakage_check(&f.t, &f.r, NULL, &f.arena, &f.b, &f.e), WF_OK);
    wf_criteria_check(&f.t, &f.r, &f.b, f.worst);
    assert_true(isnan(f.b.safety0[0]) && isnan(f.b.safety1[0]));
    assert_int_equal(f.worst[0][0].row, 2);
    assert_close(f.worst[0][0].safety, STRENGTH / 10 / (0.5 * stress), 1e-9);
    assert_int_equal(f.b.largest_stress_row, 0);
    for (size_t i = 0; i < 4; i++) f.t.strength[i] = 0;
    assert_int_equal(wf_breakage_check(&f.t, &f.r, NULL, &f.arena, &f.b, &f.e), WF_OK);
    wf_criteria_check(&f.t, &f.r, &f.b, f.worst);
    assert_true(isnan(f.worst[0][0].safety) && f.worst[0][0].row == -1);
    wf_arena_free(&f.arena);
}

static void unstressed_and_refused(void **state)
{
    (void)state;
    struct fixture f;
    cantilever(&f, 3, 1, 0, (struct wf_point_load){ .force = { 0 } }, 0);
    assert_true(isinf(f.worst[0][0].safety) && isinf(f.b.safety0[0]) && f.b.largest_stress == 0);
    for (size_t limit = 1; limit < 200; limit += 16) {
        struct wf_arena small = { .limit = limit };
        assert_int_equal(wf_breakage_check(&f.t, &f.r, NULL, &small, &f.b, NULL), WF_ENOMEM);
        wf_arena_free(&small);
    }
    f.r.n = 2;
    assert_int_equal(wf_breakage_check(&f.t, &f.r, NULL, &f.arena, &f.b, &f.e), WF_EINTERNAL);
    wf_arena_free(&f.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sections),
        cmocka_unit_test(uniform_stem_breaks_at_its_base),
        cmocka_unit_test(ring_axial_force_and_torsion),
        cmocka_unit_test(tapered_stem_breaks_higher_up),
        cmocka_unit_test(strength_of_each_row_counts),
        cmocka_unit_test(unstressed_and_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
