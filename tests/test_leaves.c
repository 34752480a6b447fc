/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Leaves of branched trees: area, mass, sail, single leaves, seasons. */
#include "base/arena.h"
#include "base/err.h"
#include "branched.h"
#include "close.h"
#include "data/model.h"
#include "edited.h"
#include "grow/clothe.h"
#include <string.h>

static const char plain[] =
    "model: m\n"
    "name: M\n"
    "generator: levels\n"
    "stem: {height: 10 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.2}, "
    "segments: 10}\n"
    "branches:\n"
    "  - place: {from: 0.3, count: 8, spread: 0.2}\n"
    "    insertion: {angle: 60 deg, spread: 5 deg}\n"
    "    length: {law: absolute, value: 2 m, spread: 0.2}\n"
    "    radius: {law: species}\n"
    "  - place: {from: 0.3, count: 5}\n"
    "    insertion: {angle: 45 deg}\n"
    "    length: {law: parent, factor: 0.3}\n"
    "    radius: {law: absolute, value: 2 mm}\n"
    "    segments: 3\n"
    "leaves: {area: 17 m2, from: 0.25, to: 0.9, count: 500, scatter: 10 deg, size_spread: 0.3, "
    "swing: 30 deg, twist: 10 deg}\n";

static struct grown g;
static int tear_down(void **state)
{
    (void)state;
    wf_arena_free(&g.arena);
    return 0;
}

/* Integrals over the tree of two columns that are linear along each row. */
static double total(const struct wf_tree *t, const double *v0, const double *v1)
{
    double sum = 0;
    for (size_t i = 0; i < t->n; i++) sum += 0.5 * (v0[i] + v1[i]) * wf_tree_length(t, i);
    return sum;
}

static void area_mass_and_sail_are_the_models(void **state)
{
    (void)state;
    grown_make(&g, plain);
    assert_close(total(&g.tree, g.tree.leaf0, g.tree.leaf1), 17, 1e-12);
    assert_close(total(&g.tree, g.tree.burden0, g.tree.burden1), 17 * 0.2, 1e-12);
    assert_close(total(&g.tree, g.tree.sail0, g.tree.sail1), 17 * 0.3 * 0.5, 1e-12);
}

static void leaves_are_on_the_last_level_between_from_and_to(void **state)
{
    (void)state;
    grown_make(&g, plain);
    double density = 0;
    for (size_t i = 0; i < g.tree.n; i++) {
        if (g.tree.level[i] < 2) {
            assert_close(g.tree.leaf0[i], 0, 0);
            continue;
        }
        if (g.tree.level[g.tree.parent[i]] < 2) continue; /* first third: partly bare */
        if (g.tree.parent[i + 1 < g.tree.n ? i + 1 : i] != (int32_t)i) continue; /* last third likewise */
        if (density > 0) assert_close(g.tree.leaf0[i], density, 1e-12);
        density = g.tree.leaf0[i];
        assert_close(g.tree.leaf0[i - 1], density * (1.0 / 3 - 0.25) * 3, 1e-12);
        assert_close(g.tree.leaf0[i + 1], density * (0.9 - 2.0 / 3) * 3, 1e-12);
    }
    assert_true(density > 0);
}

static void more_levels_may_bear_leaves(void **state)
{
    (void)state;
    char *text = edited(plain, &(struct edit){ "area: 17 m2,", "area: 17 m2, levels: 2,", NULL });
    grown_make(&g, text);
    free(text);
    double below = 0;
    for (size_t i = 0; i < g.tree.n; i++) below += g.tree.level[i] == 1 ? g.tree.leaf0[i] : 0;
    assert_true(below > 0);
    assert_close(total(&g.tree, g.tree.leaf0, g.tree.leaf1), 17, 1e-12);
}

/* One leaf model scaled and turned: sizes share the area, directions are unit vectors, all hang on the tree.
 */
static void single_leaves_share_the_area(void **state)
{
    (void)state;
    struct wf_leaves l, again;
    struct wf_err e = { 0 };
    grown_make(&g, plain);
    assert_int_equal(wf_leaves_place(&g.model, &g.tree, &g.arena, &l, &e), WF_OK);
    assert_int_equal(wf_leaves_place(&g.model, &g.tree, &g.arena, &again, &e), WF_OK);
    assert_int_equal(l.n, 500);
    assert_memory_equal(l.direction, again.direction, 3 * l.n * sizeof(double));
    assert_close(l.swing, 30 * M_PI / 180 / 10, 1e-12);
    assert_close(l.twist, 10 * M_PI / 180 / 10, 1e-12);
    double area = 0, tilt = 0, squares = 0;
    for (size_t k = 0; k < l.n; k++) {
        const double *d = l.direction + 3 * k, *s = l.side + 3 * k;
        size_t i = (size_t)l.row[k];
        double axis[3] = { g.tree.x1[i] - g.tree.x0[i], g.tree.y1[i] - g.tree.y0[i],
                           g.tree.z1[i] - g.tree.z0[i] };
        double cosine = (d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2]) / wf_tree_length(&g.tree, i);
        assert_true(g.tree.leaf0[i] > 0 && l.place[k] >= 0 && l.place[k] <= 1);
        assert_close(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1, 1e-12);
        assert_close(s[0] * s[0] + s[1] * s[1] + s[2] * s[2], 1, 1e-12);
        assert_close(d[0] * s[0] + d[1] * s[1] + d[2] * s[2], 0, 1e-12);
        assert_close(l.area[k] / l.area[0], pow(l.size[k] / l.size[0], 2), 1e-12);
        area += l.area[k];
        tilt += acos(cosine);
        squares += l.size[k] * l.size[k];
    }
    assert_close(area, 17, 1e-12);
    assert_close(squares / (double)l.n, 1, 1e-12);
    assert_close(tilt / (double)l.n, M_PI / 4, 0.03);
}

/* Leaves stand at equal steps of leaf area: every twig gets its share, give or take one. */
static void leaves_are_spread_as_the_area_is(void **state)
{
    (void)state;
    struct wf_leaves l;
    struct wf_err e = { 0 };
    grown_make(&g, plain);
    assert_int_equal(wf_leaves_place(&g.model, &g.tree, &g.arena, &l, &e), WF_OK);
    for (size_t i = 0; i < g.tree.n; i++) {
        double share = 500 * g.tree.leaf0[i] * wf_tree_length(&g.tree, i) / 17;
        size_t here = 0;
        for (size_t k = 0; k < l.n; k++) here += l.row[k] == (int32_t)i;
        assert_true(fabs((double)here - share) < 1);
    }
}

static void seasons(void **state)
{
    (void)state;
    struct wf_leaves l;
    struct wf_err e = { 0 };
    char *text = edited(plain, &(struct edit){ "name: M\n", "name: M\nseason: leaf_off\n", NULL });
    grown_make(&g, text);
    free(text);
    assert_close(g.model.leaf_area, 0, 0);
    assert_close(g.model.leaf_area_on, 17, 0);
    assert_close(total(&g.tree, g.tree.sail0, g.tree.sail1), 0, 0);
    assert_close(total(&g.tree, g.tree.burden0, g.tree.burden1), 0, 0);
    assert_int_equal(wf_leaves_place(&g.model, &g.tree, &g.arena, &l, &e), WF_OK);
    assert_int_equal(l.n, 0);
    wf_model_set_season(&g.model, WF_LEAF_ON);
    assert_int_equal(wf_grow(&g.model, &g.species, &g.arena, &g.tree, &g.diag, &e), WF_OK);
    assert_close(total(&g.tree, g.tree.leaf0, g.tree.leaf1), 17, 1e-12);
}

static void a_stem_loses_its_crown_in_winter(void **state)
{
    (void)state;
    grown_make(&g, "model: m\nname: M\nseason: leaf_off\n"
                   "stem: {height: 10 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.2}}\n"
                   "crown: {base: 5 m, leaf_area: 9 m2}\n");
    assert_close(total(&g.tree, g.tree.sail0, g.tree.sail1), 0, 0);
    assert_close(g.model.leaf_area_on, 9, 0);
}

static void leaves_need_a_crown_and_an_axis(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    assert_int_equal(grown_read(&g, plain, &e), WF_OK);
    g.species.crown.drag_coefficient.given = false;
    assert_int_equal(wf_grow(&g.model, &g.species, &g.arena, &g.tree, &g.diag, &e), WF_EINPUT);
    assert_string_equal(e.text, "m: the model has leaves, but the species table sp has no 'crown'");
    tear_down(NULL);
    e = (struct wf_err){ 0 };
    char *text = edited(plain, &(struct edit){ "factor: 0.3", "factor: 0.3, shortest: 3 m", NULL });
    assert_int_equal(grown_read(&g, text, &e), WF_OK);
    free(text);
    assert_int_equal(wf_grow(&g.model, &g.species, &g.arena, &g.tree, &g.diag, &e), WF_EINPUT);
    assert_string_equal(e.text, "m: the model has leaf area, but no axis of the tree has leaves");
}

int main(void)
{
#define T(name) cmocka_unit_test_teardown(name, tear_down)
    const struct CMUnitTest tests[] = {
        T(area_mass_and_sail_are_the_models), T(leaves_are_on_the_last_level_between_from_and_to),
        T(more_levels_may_bear_leaves),       T(single_leaves_share_the_area),
        T(leaves_are_spread_as_the_area_is),  T(seasons),
        T(a_stem_loses_its_crown_in_winter),  T(leaves_need_a_crown_and_an_axis),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
