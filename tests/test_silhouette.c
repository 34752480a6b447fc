/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The crown measured from the side: outlines, their strips, and what a tree carries of them. */
#include "close.h"
#include "data/species.h"
#include "grow/grow.h"
#include "grow/silhouette.h"
#include "load/load.h"
#include "scratch.h"
#include "solve/solve.h"
#include "wind/wind.h"
#include <string.h>

#define PI 3.14159265358979324

static struct wf_value is(double v) { return (struct wf_value){ v, v, v, .given = true }; }

static struct wf_level level[2];
static struct wf_species species;
static struct wf_model model;

static int set_up(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++)
        level[k] = (struct wf_level){ .name = k ? "branch" : "stem",
                                      .youngs_modulus = is(1e16),
                                      .shear_modulus = is(1e15),
                                      .density = is(900),
                                      .modulus_of_rupture = is(60e6),
                                      .radius = is(0.1),
                                      .knot_factor = is(1),
                                      .damping_ratio = is(0.02),
                                      .drag_coefficient = is(0),
                                      .lift_coefficient = is(0) };
    species = (struct wf_species){ .key = "sp",
                                   .name = "Sp",
                                   .levels = 2,
                                   .level = level,
                                   .crown.drag_coefficient = is(0.5),
                                   .crown.leaf_mass_per_area = is(0.2),
                                   .crown.frontal_share = is(0.3) };
    model = (struct wf_model){ .key = "m",
                               .name = "M",
                               .height = 14,
                               .radius = 0.1,
                               .taper = WF_TAPER_LINEAR,
                               .tip_ratio = 0.2,
                               .segments = 40,
                               .crown_base = NAN,
                               .crown_top = NAN,
                               .silhouette.leafless = NAN };
    return 0;
}

static enum wf_status grow(struct wf_tree *t, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    *d = (struct wf_diag){ .arena = a };
    *e = (struct wf_err){ 0 };
    return wf_grow(&model, &species, a, t, d, e);
}

/* Sum of the sail [m2], with the height of its centre [m]. */
static double sail(const struct wf_tree *t, double *centre)
{
    double sum = 0, first = 0;
    for (size_t i = 0; i < t->n; i++) {
        double l = wf_tree_length(t, i);
        assert_true(t->sail0[i] >= 0 && t->sail1[i] >= 0);
        sum += 0.5 * l * (t->sail0[i] + t->sail1[i]);
        first += l * (t->sail0[i] * (2 * t->z0[i] + t->z1[i]) + t->sail1[i] * (t->z0[i] + 2 * t->z1[i])) / 6;
    }
    *centre = first / sum;
    return sum;
}

/* Base moment of the stiff stem in a uniform wind: 1/2 rho Cd A U^2 times the height of the centre. */
static void assert_moment(const struct wf_tree *t, struct wf_arena *a, double area, double centre)
{
    struct wf_wind wind = { .sample = wf_profile_named("uniform")->sample,
                            .speed = 20,
                            .direction = { 1, 0, 0 },
                            .reference_height = 10 };
    struct wf_loads loads;
    struct wf_response r;
    struct wf_err e = { 0 };
    struct wf_solve_options o;
    wf_solve_options_default(&o);
    wf_loads_default(&loads);
    loads.wind = &wind, loads.gravity = 0;
    assert_int_equal(wf_solver_named("beam")->solve(t, &loads, &o, a, &r, NULL, &e), WF_OK);
    assert_close(r.base_moment[1], 0.5 * 1.225 * 0.5 * area * 400 * centre, 1e-6);
}

/* Area, centre: closed forms. */
static void forms(void **state)
{
    (void)state;
    static const struct {
        enum wf_crown_form form;
        double factor, centre; /* centre over the crown's base, of its depth */
    } rows[] = { { WF_FORM_ELLIPSE, PI / 4, 0.5 },
                 { WF_FORM_TRIANGLE, 0.5, 1.0 / 3 },
                 { WF_FORM_DIAMOND, 0.5, 0.5 },
                 { WF_FORM_PARABOLOID, 2.0 / 3, 0.4 },
                 { WF_FORM_RECTANGLE, 1, 0.5 } };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct wf_arena a = { 0 };
        struct wf_tree t;
        struct wf_diag d;
        struct wf_err e;
        double centre;
        set_up(NULL);
        model.silhouette.width = 6, model.silhouette.depth = 8.3, model.silhouette.form = rows[k].form;
        assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
        double area = 6 * 8.3 * rows[k].factor;
        assert_close(wf_silhouette_area(&model.silhouette), area, 1e-14);
        assert_close(sail(&t, &centre), 0.5 * area, 1e-12);
        assert_close(centre, 14 - 8.3 + 8.3 * rows[k].centre, 2e-4);
        assert_moment(&t, &a, area, centre);
        wf_arena_free(&a);
    }
}

/* A trapezium between 4 and 10 m, bottom 2 m and top 1 m broad, whichever way round. */
static double trapezium_x[] = { -1, 1, 0.5, -0.5 }, trapezium_z[] = { 4, 4, 10, 10 };

static void outline_strips(void **state)
{
    (void)state;
    double x[4], z[4], moment;
    for (int round = 0; round < 2; round++) {
        for (int i = 0; i < 4; i++)
            x[i] = 7 + trapezium_x[round ? 3 - i : i], z[i] = trapezium_z[round ? 3 - i : i];
        const struct wf_outline o = { 4, x, z };
        assert_close(wf_outline_strip(&o, -INFINITY, INFINITY, &moment), 9, 1e-14);
        assert_close(moment / 9, 4 + 6 * (2 + 2 * 1) / (3.0 * (2 + 1)), 1e-14);
        assert_close(wf_outline_strip(&o, 4, 7, &moment), 5.25, 1e-14);
        assert_close(wf_outline_strip(&o, 0, 4, &moment), 0, 0);
    }
}

static void outline_on_a_stem(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_diag d;
    struct wf_err e;
    double centre;
    model.silhouette.points = 4, model.silhouette.x = trapezium_x, model.silhouette.z = trapezium_z;
    model.silhouette.mass = 100;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_int_equal(d.warnings, 0);
    assert_close(sail(&t, &centre), 4.5, 1e-12);
    assert_close(centre, 4 + 24.0 / 9, 1e-12);
    assert_moment(&t, &a, 9, centre);
    double mass = 0;
    for (size_t i = 0; i < t.n; i++) mass += 0.5 * (t.burden0[i] + t.burden1[i]) * wf_tree_length(&t, i);
    assert_close(mass, 100, 1e-12);
    wf_arena_free(&a);
}

static void density_is_of_the_cone(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_diag d;
    struct wf_err e;
    model.silhouette.width = 4, model.silhouette.depth = 6, model.silhouette.density = 2.5;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    double mass = 0;
    for (size_t i = 0; i < t.n; i++) mass += 0.5 * (t.burden0[i] + t.burden1[i]) * wf_tree_length(&t, i);
    assert_close(mass, 2.5 * PI * 4 * 6 / 3, 1e-12);
    wf_arena_free(&a);
}

static double burden(const struct wf_tree *t)
{
    double mass = 0;
    for (size_t i = 0; i < t->n; i++) mass += 0.5 * (t->burden0[i] + t->burden1[i]) * wf_tree_length(t, i);
    return mass;
}

/* A rule takes the outline's breadth and height, or the diameter at 1.3 m. */
static void mass_by_rule(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_diag d;
    struct wf_err e;
    species.key = "sitka_spruce";
    model.silhouette.points = 4, model.silhouette.x = trapezium_x, model.silhouette.z = trapezium_z;
    model.silhouette.by = "forestgales";
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_int_equal(d.warnings, 1);
    assert_string_equal(d.first->code, "crown-mass-by");
    assert_close(burden(&t), 2.5 * PI * 4 * 6 / 12, 1e-12);
    model.silhouette.by = NULL, model.silhouette.density = 2.5;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_close(burden(&t), 2.5 * PI * 4 * 6 / 12, 1e-12);
    model.silhouette.density = 0, model.silhouette.by = "wcc:oak";
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_close(burden(&t), 1.68513e-2 / 0.45 * pow(20 * (1 - 0.8 * 1.3 / 14), 2.4767), 1e-12);
    species.key = "sp", model.silhouette.by = "wcc";
    assert_int_equal(grow(&t, &a, &d, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "m: crown_mass_by: wcc has no kind for the species 'sp'"));
    species.key = "oak", model.silhouette.points = 0;
    assert_int_equal(grow(&t, &a, &d, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "no crown to carry it"));
    wf_arena_free(&a);
}

static bool warned(const struct wf_diag *d, const char *code)
{
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->code && !strcmp(f->code, code)) return true;
    return false;
}

/* An area alone is on the leaves as they are spread; where it contradicts their area, both are said. */
static void area_with_leaves(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t, plain;
    struct wf_diag d;
    struct wf_err e;
    double centre, before;
    model.crown_base = 5, model.crown_top = 13, model.leaf_area = model.leaf_area_on = 50; /* shows 15 m2 */
    assert_int_equal(grow(&plain, &a, &d, &e), WF_OK);
    (void)sail(&plain, &before);
    model.silhouette.area = 40;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_false(warned(&d, "crown-areas"));
    assert_close(sail(&t, &centre), 20, 1e-12);
    assert_close(centre, before, 1e-12);
    assert_close(t.burden0[t.n / 2], plain.burden0[t.n / 2], 0);
    model.silhouette.area = 46;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_true(warned(&d, "crown-areas"));
    model.silhouette.area = 4.9;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_true(warned(&d, "crown-areas"));
    wf_arena_free(&a);
}

/* Without leaves a share of the load stays where no branches are drawn. */
static void leafless(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_diag d;
    struct wf_err e;
    double centre;
    model.silhouette.width = 6, model.silhouette.depth = 8;
    model.season = WF_LEAF_OFF;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_true(warned(&d, "leaf-off-share"));
    assert_close(sail(&t, &centre), 0.25 * 48 * PI / 4, 1e-12);
    model.silhouette.leafless = 0.4;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_false(warned(&d, "leaf-off-share"));
    assert_close(sail(&t, &centre), 0.2 * 48 * PI / 4, 1e-12);
    wf_arena_free(&a);
}

/* A stem with shoots at 5, 8 and 11 m: total and centre are the outline's. */
static void on_branches(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t, shape;
    struct wf_diag d;
    struct wf_err e;
    double centre;
    uint8_t kind[7] = { 0 };
    assert_int_equal(wf_tree_alloc(&shape, 7, &a, &e), WF_OK);
    static const double top[] = { 5, 8, 11, 12 };
    for (int i = 0; i < 7; i++) {
        bool stem = i < 4;
        int on = i - 4;
        shape.parent[i] = stem ? i - 1 : on;
        shape.level[i] = !stem;
        shape.z0[i] = stem ? (i ? top[i - 1] : 0) : top[on];
        shape.z1[i] = stem ? top[i] : top[on] + 0.5;
        shape.x1[i] = stem ? 0 : 1;
        shape.r0[i] = shape.r1[i] = stem ? 0.1 : 0.02;
    }
    model.generator = WF_GENERATOR_MEASURED, model.measured = &shape, model.measured_kind = kind;
    model.silhouette.points = 4, model.silhouette.x = trapezium_x, model.silhouette.z = trapezium_z;
    trapezium_z[2] = trapezium_z[3] = 11.4;
    assert_int_equal(grow(&t, &a, &d, &e), WF_OK);
    assert_close(sail(&t, &centre), 0.5 * 1.5 * 7.4, 1e-12);
    assert_close(centre, 4 + 7.4 * 4 / 9, 0.02);
    for (int i = 0; i < 3; i++) assert_close(t.sail0[i], 0, 0);
    trapezium_z[2] = trapezium_z[3] = 10;
    model.silhouette.mass = 5;
    assert_int_equal(grow(&t, &a, &d, &e), WF_EINPUT);
    wf_arena_free(&a);
}

static void assert_refused(struct wf_silhouette s, const char *words)
{
    struct wf_err e = { 0 };
    assert_int_equal(wf_silhouette_check(&s, &e), WF_EINPUT);
    if (!strstr(e.text, words)) fail_msg("%s\ninstead of\n%s", e.text, words);
}

static void what_is_refused(void **state)
{
    (void)state;
    double x[] = { 0, 4, 0, 4 }, z[] = { 2, 6, 6, 2 }, low[] = { 2, -1, 6, 4 }, flat[] = { 3, 3, 3, 3 };
    assert_refused((struct wf_silhouette){ .width = 4 }, "crown_width needs crown_depth");
    assert_refused((struct wf_silhouette){ .depth = 4 }, "crown_depth needs crown_width");
    assert_refused((struct wf_silhouette){ .area = 4, .width = 4, .depth = 1 }, "beside frontal_area");
    assert_refused((struct wf_silhouette){ .mass = 4, .density = 1, .width = 1, .depth = 1 },
                   "beside crown_mass");
    assert_refused((struct wf_silhouette){ .density = 1, .area = 3 }, "needs crown_width and crown_depth");
    assert_refused((struct wf_silhouette){ .mass = 4, .by = "wcc", .area = 3 }, "beside crown_mass");
    assert_refused((struct wf_silhouette){ .points = 4, .x = x, .z = z },
                   "crosses itself: the side from point 1 to 2 and the side from point 3 to 4");
    assert_refused((struct wf_silhouette){ .points = 4, .x = x, .z = low },
                   "point 2 of the crown's outline is 1 m below the ground");
    assert_refused((struct wf_silhouette){ .points = 4, .x = x, .z = flat }, "crosses itself");
    assert_refused((struct wf_silhouette){ .points = 2, .x = x, .z = z }, "has 2 points");
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_diag d;
    struct wf_err e;
    model.silhouette.width = 4, model.silhouette.depth = 15;
    assert_int_equal(grow(&t, &a, &d, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "below the ground"));
    set_up(NULL);
    model.silhouette.area = 10;
    assert_int_equal(grow(&t, &a, &d, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "does not say where"));
    set_up(NULL);
    double high_x[] = { -1, 1, 0 }, high_z[] = { 30, 30, 45 };
    model.silhouette.points = 3, model.silhouette.x = high_x, model.silhouette.z = high_z;
    e = (struct wf_err){ 0 };
    assert_int_equal(grow(&t, &a, &d, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "outline ends 45 m above the ground"));
    wf_arena_free(&a);
}

static void outline_of_a_file(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_silhouette s = { 0 };
    struct scratch f;
    const char *good = "x_m,z_m\n-1,4\n1,4\n0,12\n", *bad = "x_m,z_m\n-1,4\n1,four\n0,12\n";
    scratch_write(&f, good, strlen(good));
    assert_int_equal(wf_outline_read(f.path, &s, &a, &d, &e), WF_OK);
    assert_int_equal(s.points, 3);
    assert_close(wf_silhouette_area(&s), 8, 1e-14);
    scratch_remove(&f);
    /* in another unit, with a point twice and closed */
    const char *closed = "x_cm,z (cm)\n-100,400\n100,400\n100,400\n0,1200\n-100,400\n";
    scratch_write(&f, closed, strlen(closed));
    assert_int_equal(wf_outline_read(f.path, &s, &a, &d, &e), WF_OK);
    assert_int_equal(s.points, 3);
    assert_close(wf_silhouette_area(&s), 8, 1e-14);
    scratch_remove(&f);
    scratch_write(&f, bad, strlen(bad));
    assert_int_equal(wf_outline_read(f.path, &s, &a, &d, &e), WF_EINPUT);
    assert_int_equal(d.errors, 1);
    scratch_remove(&f);
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(forms, set_up),
        cmocka_unit_test_setup(outline_strips, set_up),
        cmocka_unit_test_setup(outline_on_a_stem, set_up),
        cmocka_unit_test_setup(density_is_of_the_cone, set_up),
        cmocka_unit_test_setup(mass_by_rule, set_up),
        cmocka_unit_test_setup(area_with_leaves, set_up),
        cmocka_unit_test_setup(leafless, set_up),
        cmocka_unit_test_setup(on_branches, set_up),
        cmocka_unit_test_setup(what_is_refused, set_up),
        cmocka_unit_test(outline_of_a_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
