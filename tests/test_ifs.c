/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Iterated function systems: copies, contraction, dimension, forms, and what is refused. */
#include "base/arena.h"
#include "base/err.h"
#include "branched.h"
#include "close.h"
#include "data/model.h"
#include "edited.h"
#include "grow/clothe.h"

#define DEG (M_PI / 180)

static const char plain[] =
    "model: m\n"
    "name: M\n"
    "generator: ifs\n"
    "stem: {height: 10 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.2}, "
    "segments: 5}\n"
    "ifs:\n"
    "  levels: 4\n"
    "  maps:\n"
    "    - {position: 0.6, scale: 0.5, inclination: 60 deg, azimuth: 30 deg, radius: 0.4}\n"
    "    - {position: 0.8, scale: 0.4, inclination: 40 deg, azimuth: 200 deg, roll: 90 deg, radius: "
    "0.3}\n";

static struct grown g;
static int tear_down(void **state)
{
    (void)state;
    wf_arena_free(&g.arena);
    return 0;
}

static void every_map_copies_the_whole_onto_its_axis(void **state)
{
    (void)state;
    grown_make(&g, plain);
    size_t want = 1;
    for (int level = 0; level < 4; level++, want *= 2) assert_int_equal(grown_axes(&g.tree, level), want);
    assert_int_equal(g.tree.n, 15 * 5);
    grown_is_connected(&g.tree);
    for (size_t k = 0; k < 8; k++) { /* scale and radius are products of the maps' */
        size_t small = (k & 1) + (k >> 1 & 1) + (k >> 2 & 1);
        double scale = pow(0.4, (double)small) * pow(0.5, 3 - (double)small);
        size_t i = grown_axis(&g.tree, 3, k);
        assert_close(grown_length(&g.tree, i), 10 * scale, 1e-12);
        assert_close(g.tree.r0[i], 0.1 * pow(0.3, (double)small) * pow(0.4, 3 - (double)small), 1e-12);
    }
}

/* Apply a map of the model to a point of the whole tree's own frame. */
static void apply(const struct wf_ifs_map *w, const double x[3], double y[3])
{
    for (int i = 0; i < 3; i++)
        y[i] = w->a[3 * i] * x[0] + w->a[3 * i + 1] * x[1] + w->a[3 * i + 2] * x[2] + w->b[i];
}

/* The tips of level 3 are the images of the stem's tip under the products of three maps. */
static void tips_are_images_under_products_of_maps(void **state)
{
    (void)state;
    grown_make(&g, plain);
    const struct wf_ifs_map *w = g.model.ifs.map;
    for (size_t k = 0; k < 8; k++) {
        double x[3] = { 0, 0, 1 }, y[3];
        for (int step = 0; step < 3; step++) { /* the last map acts first */
            apply(&w[k >> step & 1], x, y);
            memcpy(x, y, sizeof x);
        }
        size_t tip = grown_axis(&g.tree, 3, k) + 4;
        assert_close(g.tree.x1[tip], 10 * x[0], 1e-12);
        assert_close(g.tree.y1[tip], 10 * x[1], 1e-12);
        assert_close(g.tree.z1[tip], 10 * x[2], 1e-12);
    }
}

static void a_lean_carries_the_whole_tree(void **state)
{
    (void)state;
    grown_make(&g, plain);
    char *text = edited(
        plain, &(struct edit){ "segments: 5}", "segments: 5, lean: 20 deg, lean_azimuth: 50 deg}", NULL });
    struct grown leaning;
    grown_make(&leaning, text);
    free(text);
    const double ca = cos(50 * DEG), sa = sin(50 * DEG), cl = cos(20 * DEG), sl = sin(20 * DEG);
    const double turn[3][3] = { { ca * cl, -sa, ca * sl }, { sa * cl, ca, sa * sl }, { -sl, 0, cl } };
    for (size_t i = 0; i < g.tree.n; i++) {
        const double x[3] = { g.tree.x1[i], g.tree.y1[i], g.tree.z1[i] },
                     y[3] = { leaning.tree.x1[i], leaning.tree.y1[i], leaning.tree.z1[i] };
        for (int k = 0; k < 3; k++)
            assert_close(turn[k][0] * x[0] + turn[k][1] * x[1] + turn[k][2] * x[2] - y[k], 0, 1e-12);
    }
    wf_arena_free(&leaning.arena);
}

/* The same map as position, scale and angles, and as a matrix. */
static void a_matrix_says_the_same(void **state)
{
    (void)state;
    struct grown by_matrix;
    char matrix[512], *text;
    double a[9];
    grown_make(&g, plain);
    memcpy(a, g.model.ifs.map[0].a, sizeof a);
    snprintf(
        matrix, sizeof matrix,
        "{matrix: [%.17g, %.17g, %.17g, 0, %.17g, %.17g, %.17g, 0, %.17g, %.17g, %.17g, 0.6], radius: 0.4}",
        a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]);
    text = edited(plain, &(struct edit){
                             "{position: 0.6, scale: 0.5, inclination: 60 deg, azimuth: 30 deg, radius: 0.4}",
                             matrix, NULL });
    grown_make(&by_matrix, text);
    free(text);
    assert_int_equal(by_matrix.tree.n, g.tree.n);
    for (size_t i = 0; i < g.tree.n; i++) {
        assert_close(by_matrix.tree.x1[i] - g.tree.x1[i], 0, 1e-12);
        assert_close(by_matrix.tree.z1[i] - g.tree.z1[i], 0, 1e-12);
    }
    assert_close(by_matrix.model.ifs.map[0].factor, 0.5, 1e-12);
    wf_arena_free(&by_matrix.arena);
}

static void factors_are_spectral_norms(void **state)
{
    (void)state;
    const double shear[9] = { 1, 1, 0, 0, 1, 0, 0, 0, 0.5 }, flat[9] = { 0 };
    const double turned[9] = { 0, -0.7, 0, 0.7, 0, 0, 0, 0, -0.7 };
    assert_close(wf_stretch(shear), 0.5 * (1 + sqrt(5)), 1e-12); /* golden ratio */
    assert_close(wf_stretch(turned), 0.7, 1e-12);
    assert_close(wf_stretch(flat), 0, 1e-300);
    grown_make(&g, plain);
    assert_close(g.model.ifs.map[0].factor, 0.5, 1e-12);
    assert_close(g.model.ifs.map[1].factor, 0.4, 1e-12);
}

static void dimension_is_that_of_known_sets(void **state)
{
    (void)state;
    struct wf_ifs_map map[8];
    struct wf_ifs f = { .levels = 3, .map = map };
    for (int k = 0; k < 8; k++) map[k] = (struct wf_ifs_map){ .factor = 1.0 / 3, .until = 8 };
    f.maps = 2;
    assert_close(wf_ifs_dimension(&f), log(2) / log(3), 1e-12); /* Cantor set */
    f.maps = 8;
    assert_close(wf_ifs_dimension(&f), log(8) / log(3), 1e-12); /* Sierpinski carpet */
    f.maps = 1;
    assert_close(wf_ifs_dimension(&f), 0, 0);
    f.maps = 8;
    for (int k = 2; k < 8; k++) map[k].until = 1; /* acting once, they leave the limit alone */
    assert_close(wf_ifs_dimension(&f), log(2) / log(3), 1e-12);
}

static void a_map_may_stop_acting(void **state)
{
    (void)state;
    char *text = edited(plain, &(struct edit){ "roll: 90 deg", "roll: 90 deg, until: 1", NULL });
    grown_make(&g, text);
    free(text);
    for (int level = 1; level < 4; level++) assert_int_equal(grown_axes(&g.tree, level), 2);
    grown_is_connected(&g.tree);
}

/* The leader of a sympodium stands on the tip; turned by 180 degrees each time it goes zigzag, so every
 * second axis is parallel to the stem. */
static void a_sympodium_goes_on_from_its_tips(void **state)
{
    (void)state;
    grown_make(&g,
               "model: m\nname: M\ngenerator: ifs\n"
               "stem: {height: 4 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.8}, segments: 5}\n"
               "ifs:\n  form: sympodial\n  levels: 5\n  maps:\n"
               "    - {position: 1, scale: 0.8, inclination: 30 deg, azimuth: 180 deg}\n");
    size_t row[5];
    assert_int_equal(g.tree.n, 25);
    grown_is_connected(&g.tree);
    for (int l = 0; l < 5; l++) row[l] = grown_axis(&g.tree, l, 0);
    for (int l = 1; l < 5; l++) {
        assert_int_equal(g.tree.parent[row[l]], row[l] - 1);
        assert_close(grown_angle(&g.tree, row[l], row[l - 1]), 30 * DEG, 1e-12);
    }
    assert_close(grown_angle(&g.tree, row[2], row[0]), 0, 1e-7);
    assert_close(grown_angle(&g.tree, row[3], row[1]), 0, 1e-7);
}

/* Each map of a false dichotomy stands for two, mirror images about the axis. */
static void a_false_dichotomy_forks_at_its_tips(void **state)
{
    (void)state;
    grown_make(&g,
               "model: m\nname: M\ngenerator: ifs\n"
               "stem: {height: 4 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.8}, segments: 5}\n"
               "ifs:\n  form: false_dichotomous\n  levels: 6\n  maps:\n"
               "    - {position: 1, scale: 0.7, inclination: 35 deg, roll: 90 deg}\n");
    size_t want = 1;
    for (int l = 0; l < 6; l++, want *= 2) assert_int_equal(grown_axes(&g.tree, l), want);
    grown_is_connected(&g.tree);
    double sum[3] = { 0 };
    for (size_t i = 0; i < g.tree.n; i++) sum[0] += g.tree.x1[i], sum[1] += g.tree.y1[i];
    assert_close(sum[0], 0, 1e-9);
    assert_close(sum[1], 0, 1e-9);
    size_t one = grown_axis(&g.tree, 1, 0), two = grown_axis(&g.tree, 1, 1);
    assert_int_equal(g.tree.parent[one], g.tree.parent[two]);
    assert_close(grown_angle(&g.tree, one, two), 70 * DEG, 1e-12);
}

static void the_papers_tree_has_three_levels(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    struct wf_leaves leaves;
    g = (struct grown){ 0 };
    g.diag.arena = &g.arena;
    g.species = plain_species(g.level);
    if (wf_model_read("models/zhao2013_ifs.yaml", &g.arena, &g.model, &g.diag, &e)) fail_msg("%s", e.text);
    if (wf_grow(&g.model, &g.species, &g.arena, &g.tree, &g.diag, &e)) fail_msg("%s", e.text);
    assert_int_equal(grown_axes(&g.tree, 0), 1);
    assert_int_equal(grown_axes(&g.tree, 1), 12);
    assert_int_equal(grown_axes(&g.tree, 2), 12 * 8);
    assert_int_equal(g.tree.n, 109 * 5);
    if (wf_leaves_place(&g.model, &g.tree, &g.arena, &leaves, &e)) fail_msg("%s", e.text);
    assert_int_equal(leaves.n, 800);
    assert_null(g.diag.first);
}

static void mistakes_are_named_with_their_place(void **state)
{
    (void)state;
    static const struct edit cases[] = {
        { "scale: 0.5", "scale: 1.25",
          "8:30: ifs.maps[0].scale: this map does not contract: its factor (largest stretch) is 1.25; it "
          "must be "
          "below 1" },
        { "- {position: 0.6, scale: 0.5", "- {name: low, position: 0.6, scale: 1",
          "8:41: ifs.maps[0].scale: low does not contract: its factor (largest stretch) is 1; it must be "
          "below 1" },
        { "{position: 0.6, scale: 0.5, inclination: 60 deg, azimuth: 30 deg, radius: 0.4}",
          "{matrix: [0.9, 0.9, 0, 0, 0, 0.9, 0, 0, 0, 0, 0.9, 0.5]}",
          "8:16: ifs.maps[0].matrix: this map does not contract: its factor (largest stretch) is 1.45623; it "
          "must "
          "be below 1" },
        { "{position: 0.6, scale: 0.5, inclination: 60 deg, azimuth: 30 deg, radius: 0.4}",
          "{matrix: [0.5, 0, 0, 0.1, 0, 0.5, 0, 0, 0, 0, 0.5, 0.5]}",
          "8:16: ifs.maps[0].matrix: the copy starts at (0.1, 0, 0.5), not on the axis: the last column is "
          "0, 0 and "
          "a position above 0, at most 1" },
        { "{position: 0.6, scale: 0.5, inclination: 60 deg, azimuth: 30 deg, radius: 0.4}",
          "{matrix: [0.5, 0, 0, 0.1], scale: 0.5}",
          "8:16: ifs.maps[0].matrix: 4 numbers; three rows of four are 12\n"
          "8:41: ifs.maps[0].scale: is not used beside 'matrix'" },
        { "{position: 0.6, scale: 0.5, inclination: 60 deg, azimuth: 30 deg, radius: 0.4}",
          "{matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0, 0.5]}",
          "8:16: ifs.maps[0].matrix: this map leaves nothing of the axis: its length is 0 of the parent's" },
        { "position: 0.6, ", "", "8:7: ifs.maps[0]: missing key 'position'" },
        { "position: 0.6", "position: 1",
          "8:7: ifs.maps[0]: stands at the tip; in form 'monopodial' the axis continues above every copy" },
        { "  levels: 4", "  levels: 4\n  form: sympodial",
          "9:5: ifs.maps: 0 stand at the tip (position 1); form 'sympodial' needs exactly one" },
        { "  levels: 4", "  levels: 9", "6:11: ifs.levels: 9 is outside 1 to 8" },
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct wf_err e = { 0 };
        char found[4096], *text = edited(plain, &cases[k]);
        assert_int_equal(grown_read(&g, text, &e), WF_EINPUT);
        findings_print(&g.diag, found, sizeof found);
        assert_string_equal(found, cases[k].findings);
        free(text);
        tear_down(NULL);
    }
}

int main(void)
{
#define T(name) cmocka_unit_test_teardown(name, tear_down)
    const struct CMUnitTest tests[] = {
        T(every_map_copies_the_whole_onto_its_axis),
        T(tips_are_images_under_products_of_maps),
        T(a_lean_carries_the_whole_tree),
        T(a_matrix_says_the_same),
        T(factors_are_spectral_norms),
        T(dimension_is_that_of_known_sets),
        T(a_map_may_stop_acting),
        T(a_sympodium_goes_on_from_its_tips),
        T(a_false_dichotomy_forks_at_its_tips),
        T(the_papers_tree_has_three_levels),
        T(mistakes_are_named_with_their_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
