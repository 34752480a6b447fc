/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A stem grown from a model and a species: shape, walls, leaves, masses. */
#include "close.h"
#include "data/species.h"
#include "grow/stem.h"
#include <string.h>

static struct wf_value is(double v) { return (struct wf_value){ v, v, v, .given = true }; }

static double wall_at[] = { 0, 0.33, 1 }, wall_share[] = { 0.2, 0.1, 0.3 };
static double shape_at[] = { 0, 0.4, 1 }, shape_share[] = { 0.4, 1, 0.3 };
static double taper_at[] = { 0, 0.1, 0.55, 1 }, taper_share[] = { 1, 0.8, 0.7, 0.1 };

static struct wf_level level;
static struct wf_species species;
static struct wf_model model;

static int set_up(void **state)
{
    (void)state;
    level = (struct wf_level){ .name = "culm",
                               .youngs_modulus = is(10e9),
                               .shear_modulus = is(0.6e9),
                               .density = is(900),
                               .modulus_of_rupture = is(60e6),
                               .radius = is(0.04),
                               .damping_ratio = is(0.02),
                               .knot_factor = is(0.8),
                               .drag_coefficient = { .value = NAN },
                               .lift_coefficient = is(0.1),
                               .wall = { 3, wall_at, wall_share } };
    species = (struct wf_species){ .key = "sp",
                                   .levels = 1,
                                   .level = &level,
                                   .crown.drag_coefficient = is(0.5),
                                   .crown.leaf_mass_per_area = is(0.2),
                                   .crown.frontal_share = is(0.3) };
    model = (struct wf_model){ .key = "m",
                               .name = "M",
                               .height = 14,
                               .radius = 0.05,
                               .taper = WF_TAPER_LINEAR,
                               .tip_ratio = 0.2,
                               .segments = 40,
                               .crown_base = 5.5,
                               .crown_top = 13.2,
                               .leaf_area = 17,
                               .crown_shape = { 3, shape_at, shape_share } };
    return 0;
}

static void grow(struct wf_tree *t, struct wf_arena *a)
{
    struct wf_err e = { 0 };
    struct wf_diag d = { .arena = a };
    if (wf_grow_stem(&model, &species, a, t, &e)) fail_msg("%s", e.text);
    if (wf_tree_check(t, &d, &e)) fail_msg("%s: %s", e.text, d.first->text);
}

static void rows_are_a_chain_from_ground_to_tip(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    grow(&t, &a);
    assert_close(t.z0[0], 0, 0);
    assert_close(t.z1[t.n - 1], 14, 0);
    for (size_t i = 0; i < t.n; i++) {
        assert_int_equal(t.parent[i], (int)i - 1);
        assert_int_equal(t.level[i], 0);
        assert_true(t.z1[i] > t.z0[i] && t.z1[i] - t.z0[i] < 1.2 * 14 / 40);
        if (i) assert_memory_equal(&t.z0[i], &t.z1[i - 1], sizeof(double));
        if (i) assert_memory_equal(&t.r0[i], &t.r1[i - 1], sizeof(double));
        assert_close(t.youngs[i], 10e9, 0);
        assert_close(t.shear[i], 0.6e9, 0);
        assert_close(t.density[i], 900, 0);
        assert_close(t.strength[i], 48e6, 1e-15);
        assert_close(t.damping[i], 0.02, 0);
        assert_close(t.lift[i], 0.1, 0);
        assert_true(isnan(t.drag[i]));
    }
    assert_string_equal(t.name, "M");
    wf_arena_free(&a);
}

static void without_kinks_the_rows_are_equal(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    level.wall.n = 0;
    model.leaf_area = 0;
    model.segments = 7;
    grow(&t, &a);
    assert_int_equal(t.n, 7);
    for (size_t i = 0; i < 7; i++) {
        assert_close(wf_tree_length(&t, i), 2, 1e-14);
        assert_close(t.i0[i], 0, 0);
        assert_close(t.leaf0[i] + t.leaf1[i] + t.sail0[i] + t.burden1[i], 0, 0);
    }
    model.segments = 1;
    grow(&t, &a);
    assert_int_equal(t.n, 1);
    assert_close(t.r1[0], 0.01, 1e-14);
    wf_arena_free(&a);
}

static void radii_follow_the_taper_at_every_row_end(void **state)
{
    (void)state;
    for (int law = WF_TAPER_TABLE; law <= WF_TAPER_POWER; law++) {
        struct wf_arena a = { 0 };
        struct wf_tree t;
        model.taper = (enum wf_taper)law;
        model.power = 0.6;
        model.profile = (struct wf_along){ 4, taper_at, taper_share };
        grow(&t, &a);
        for (size_t i = 0; i < t.n; i++) {
            assert_close(t.r0[i], 0.05 * wf_model_taper(&model, t.z0[i] / 14), 1e-14);
            assert_close(t.r1[i], 0.05 * wf_model_taper(&model, t.z1[i] / 14), 1e-13);
            assert_close(t.r0[i] - t.i0[i], t.r0[i] * wf_along_at(&level.wall, t.z0[i] / 14, 1), 1e-13);
        }
        wf_arena_free(&a);
    }
}

/* Every kink is a row end, so linear rows carry the whole shape: sampled anywhere, not only at the ends. */
static void linear_rows_carry_tables_exactly(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    model.taper = WF_TAPER_TABLE;
    model.profile = (struct wf_along){ 4, taper_at, taper_share };
    model.segments = 3;
    grow(&t, &a);
    double scale = 0;
    for (int k = 0; k < 999; k++) {
        double z = 14 * (k + 0.5) / 999, s = z / 14, in = (z - 5.5) / (13.2 - 5.5);
        size_t i = 0;
        while (t.z1[i] < z) i++;
        double w = (z - t.z0[i]) / (t.z1[i] - t.z0[i]);
        assert_close(t.r0[i] + w * (t.r1[i] - t.r0[i]), 0.05 * wf_model_taper(&model, s), 1e-12);
        double leaf = t.leaf0[i] + w * (t.leaf1[i] - t.leaf0[i]);
        double want = in < 0 || in > 1 ? 0 : wf_along_at(&model.crown_shape, in, 1);
        if (want > 0 && scale == 0) scale = leaf / want;
        assert_close(leaf, scale * want, 1e-11);
    }
    /* the shape's integral is 0.4 * 0.7 + 0.6 * 0.65 = 0.67 of the crown's length */
    assert_close(scale, 17 / (0.67 * 7.7), 1e-12);
    wf_arena_free(&a);
}

static double total(const struct wf_tree *t, const double *at0, const double *at1)
{
    double sum = 0;
    for (size_t i = 0; i < t->n; i++) sum += 0.5 * (at0[i] + at1[i]) * wf_tree_length(t, i);
    return sum;
}

static void leaves_add_up(void **state)
{
    (void)state;
    static const size_t segments[] = { 1, 2, 3, 10, 40, 1000 };
    for (size_t k = 0; k < sizeof segments / sizeof *segments; k++) {
        for (int lean = 0; lean < 2; lean++) {
            struct wf_arena a = { 0 };
            struct wf_tree t;
            model.segments = segments[k];
            model.lean = lean;
            grow(&t, &a);
            assert_close(total(&t, t.leaf0, t.leaf1), 17, 1e-12);
            assert_close(total(&t, t.sail0, t.sail1), 17 * 0.3 * 0.5, 1e-12);
            assert_close(total(&t, t.burden0, t.burden1), 17 * 0.2, 1e-12);
            wf_arena_free(&a);
        }
    }
}

static void leaves_stay_in_the_crown(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    model.crown_shape.n = 0;
    grow(&t, &a);
    for (size_t i = 0; i < t.n; i++) {
        bool inside = t.z0[i] >= 5.5 - 1e-9 && t.z1[i] <= 13.2 + 1e-9;
        assert_true(inside || t.z1[i] <= 5.5 + 1e-9 || t.z0[i] >= 13.2 - 1e-9);
        assert_close(t.leaf0[i], inside ? 17 / 7.7 : 0, 1e-12);
        assert_close(t.leaf1[i], inside ? 17 / 7.7 : 0, 1e-12);
    }
    wf_arena_free(&a);
}

static void a_stem_leans(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    model.lean = 0.3;
    model.lean_azimuth = 2;
    grow(&t, &a);
    assert_close(t.x1[t.n - 1], 14 * sin(0.3) * cos(2), 1e-14);
    assert_close(t.y1[t.n - 1], 14 * sin(0.3) * sin(2), 1e-14);
    assert_close(t.z1[t.n - 1], 14 * cos(0.3), 1e-14);
    wf_arena_free(&a);
}

static void the_species_fills_what_the_model_leaves_open(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    model.radius = NAN;
    level.modulus_of_rupture = (struct wf_value){ .value = NAN };
    level.drag_coefficient = is(1.2);
    grow(&t, &a);
    assert_close(t.r0[0], 0.04, 0);
    assert_close(t.strength[3], 0, 0);
    assert_close(t.drag[3], 1.2, 0);
    wf_arena_free(&a);
}

static void leaves_need_a_crown_in_the_species(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_err e = { 0 };
    species.crown.drag_coefficient.given = false;
    assert_int_equal(wf_grow_stem(&model, &species, &a, &t, &e), WF_EINPUT);
    assert_string_equal(e.text, "m: the model has leaves, but the species table sp has no 'crown'");
    model.leaf_area = 0;
    grow(&t, &a);
    e = (struct wf_err){ 0 };
    species.levels = 0;
    assert_int_equal(wf_grow_stem(&model, &species, &a, &t, &e), WF_EINPUT);
    wf_arena_free(&a);
}

static void memory_is_refused_at_every_smaller_capacity(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    model.segments = 3;
    grow(&t, &a);
    size_t need = a.used;
    wf_arena_free(&a);
    for (size_t limit = 1; limit < need; limit++) {
        struct wf_arena small = { .limit = limit };
        struct wf_err e = { 0 };
        assert_int_equal(wf_grow_stem(&model, &species, &small, &t, &e), WF_ENOMEM);
        wf_arena_free(&small);
    }
}

#define TEST(f) cmocka_unit_test_setup(f, set_up)
int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(rows_are_a_chain_from_ground_to_tip),
        TEST(without_kinks_the_rows_are_equal),
        TEST(radii_follow_the_taper_at_every_row_end),
        TEST(linear_rows_carry_tables_exactly),
        TEST(leaves_add_up),
        TEST(leaves_stay_in_the_crown),
        TEST(a_stem_leans),
        TEST(the_species_fills_what_the_model_leaves_open),
        TEST(leaves_need_a_crown_in_the_species),
        TEST(memory_is_refused_at_every_smaller_capacity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
