/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees of levels: counts, places, angles, lengths, radii, curves, spread, and what is refused. */
#include "data/model.h"
#include "solve/solve.h"
#include "load/drag.h"
#include "branched.h"
#include "close.h"
#include "edited.h"

#define DEG (M_PI / 180)

static const char plain[] = "model: m\n"
                            "name: M\n"
                            "generator: levels\n"
                            "stem: {height: 10 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.2}, "
                            "segments: 10}\n"
                            "branches:\n"
                            "  - place: {from: 0.3, to: 0.9, count: 4, per_whorl: 3}\n"
                            "    azimuth: {rule: whorl}\n"
                            "    insertion: {at: [0.3, 0.9], angles: [80 deg, 50 deg]}\n"
                            "    length: {law: rest, factor: 0.5}\n"
                            "    radius: {law: parent, factor: 0.4}\n"
                            "    taper: {tip_share: 0.25}\n"
                            "    segments: 4\n"
                            "  - place: {at: [0.5, 0.75]}\n"
                            "    azimuth: {rule: planar}\n"
                            "    insertion: {angle: 45 deg}\n"
                            "    length: {law: parent, factor: 0.3}\n"
                            "    radius: {law: absolute, value: 4 mm}\n"
                            "    segments: 2\n";

static struct grown g;
static int tear_down(void **state)
{
    (void)state;
    wf_arena_free(&g.arena);
    return 0;
}

static void levels_have_the_counts_asked_for(void **state)
{
    (void)state;
    grown_make(&g, plain);
    assert_int_equal(grown_axes(&g.tree, 0), 1);
    assert_int_equal(grown_axes(&g.tree, 1), 4 * 3);
    assert_int_equal(grown_axes(&g.tree, 2), 4 * 3 * 2);
    assert_int_equal(g.tree.n, 10 + 12 * 4 + 24 * 2);
    assert_int_equal(wf_model_levels(&g.model), 3);
    grown_is_connected(&g.tree);
    assert_null(g.diag.first);
}

static void branches_stand_where_asked_at_the_angles_asked(void **state)
{
    (void)state;
    static const double place[] = { 0.3, 0.5, 0.7, 0.9 };
    grown_make(&g, plain);
    const struct wf_tree *t = &g.tree;
    for (size_t k = 0; k < 12; k++) {
        size_t i = grown_axis(t, 1, k);
        double s = place[k / 3], side = atan2(t->y1[i] - t->y0[i], t->x1[i] - t->x0[i]) / DEG;
        assert_close(t->z0[i], 10 * s, 1e-14);
        assert_close(grown_angle(t, i, 0), (80 - 30 * (s - 0.3) / 0.6) * DEG, 1e-12);
        assert_close(fmod(side + 720, 360), fmod((double)(k % 3) * 120 + (double)(k / 3) * 60, 360), 1e-9);
        assert_close(grown_length(t, i), 5 * (1 - s), 1e-12);
        assert_close(t->r0[i], 0.4 * 0.1 * (1 - 0.8 * s), 1e-12);
        assert_close(t->r1[i + 3], 0.25 * t->r0[i], 1e-12);
    }
    size_t i = grown_axis(t, 2, 0), parent = grown_axis(t, 1, 0);
    assert_close(grown_angle(t, i, parent), 45 * DEG, 1e-12);
    assert_close(grown_length(t, i), 0.3 * 3.5, 1e-12);
    assert_close(t->r0[i], 0.004, 1e-12);
    assert_int_equal(t->parent[i], parent + 1);
}

/* Twigs of a planar rule lie in the plane of their branch and the horizontal, one to each side. */
static void planar_branches_go_to_both_sides(void **state)
{
    (void)state;
    grown_make(&g, plain);
    const struct wf_tree *t = &g.tree;
    size_t b = grown_axis(t, 1, 0), one = grown_axis(t, 2, 0), two = grown_axis(t, 2, 1);
    double d[3] = { t->x1[b] - t->x0[b], t->y1[b] - t->y0[b], t->z1[b] - t->z0[b] };
    double across[2] = { -d[1], d[0] }, sum[3];
    double left = across[0] * (t->x1[one] - t->x0[one]) + across[1] * (t->y1[one] - t->y0[one]);
    double right = across[0] * (t->x1[two] - t->x0[two]) + across[1] * (t->y1[two] - t->y0[two]);
    assert_close(left, -right, 1e-9);
    assert_true(fabs(left) > 0.01);
    sum[0] = t->x1[one] - t->x0[one] + t->x1[two] - t->x0[two];
    sum[1] = t->y1[one] - t->y0[one] + t->y1[two] - t->y0[two];
    sum[2] = t->z1[one] - t->z0[one] + t->z1[two] - t->z0[two];
    assert_close(sum[0] * d[2] - sum[2] * d[0], 0, 1e-12);
    assert_close(sum[1] * d[2] - sum[2] * d[1], 0, 1e-12);
}

static void materials_follow_the_level_and_the_last_is_repeated(void **state)
{
    (void)state;
    grown_make(&g, plain);
    for (size_t i = 0; i < g.tree.n; i++) assert_close(g.tree.youngs[i], g.tree.level[i] ? 6e9 : 8e9, 0);
}

/* A branch between two joints divides the row there, and the radius stays the taper's. */
static void a_branch_inside_a_segment_divides_it(void **state)
{
    (void)state;
    char *text = edited(plain, &(struct edit){ "from: 0.3, to: 0.9, count: 4", "at: [0.34, 0.9]", NULL });
    grown_make(&g, text);
    free(text);
    const struct wf_tree *t = &g.tree;
    size_t i = grown_axis(t, 1, 0), p = (size_t)t->parent[i];
    assert_close(t->z1[p], 3.4, 1e-14);
    assert_close(t->z0[p], 3, 1e-14);
    assert_close(t->z1[p + 1], 4, 1e-14);
    assert_close(t->r1[p], 0.1 * (1 - 0.8 * 0.34), 1e-14);
    grown_is_connected(t);
}

static void a_turn_is_shared_by_the_joints_and_ends_upright(void **state)
{
    (void)state;
    char *text = edited(
        plain, &(struct edit){ "    segments: 4\n", "    segments: 4\n    curve: {turn: 30 deg}\n", NULL });
    grown_make(&g, text);
    size_t i = grown_axis(&g.tree, 1, 0);
    for (size_t k = i; k < i + 3; k++) assert_close(grown_angle(&g.tree, k, k + 1), 10 * DEG, 1e-10);
    assert_close(grown_angle(&g.tree, i + 3, 0), 50 * DEG, 1e-10);
    tear_down(NULL);
    free(text);
    text = edited(plain, &(struct edit){ "    segments: 4\n",
                                         "    segments: 4\n    curve: {turn: -180 deg, to: 0.5}\n", NULL });
    grown_make(&g, text);
    free(text);
    i = grown_axis(&g.tree, 1, 0);
    assert_close(grown_angle(&g.tree, i + 1, 0), 170 * DEG, 1e-10);
    assert_close(grown_angle(&g.tree, i + 2, 0), M_PI, 1e-10);
    assert_close(grown_angle(&g.tree, i + 3, 0), M_PI, 1e-10);
}

static void an_upright_stem_nods_towards_its_azimuth(void **state)
{
    (void)state;
    char *text =
        edited(plain, &(struct edit){ "segments: 10}",
                                      "segments: 10, lean_azimuth: 90 deg, curve: {turn: -40 deg, from: "
                                      "0.8}}",
                                      NULL });
    grown_make(&g, text);
    free(text);
    const struct wf_tree *t = &g.tree;
    assert_close(t->y1[7], 0, 1e-12);
    assert_true(t->y1[9] > 0.3);
    assert_close(t->x1[9], 0, 1e-12);
    assert_close(grown_angle(t, 9, 0), 40 * DEG, 1e-12);
}

/* Without an address a draw would move when another branch is added; with one it does not. */
static void a_seed_gives_one_tree_whatever_else_grows(void **state)
{
    (void)state;
    static const char wild[] =
        "model: m\nname: M\ngenerator: levels\nseed: %d\n"
        "stem: {height: 10 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.2}}\n"
        "branches:\n"
        "  - place: {from: 0.3, count: 6, spread: 0.3}\n"
        "    azimuth: {rule: random}\n"
        "    insertion: {angle: 60 deg, spread: 8 deg}\n"
        "    length: {law: absolute, value: 2 m, spread: 0.3}\n"
        "    radius: {law: species, spread: 0.1}\n"
        "    curve: {wander: 20 deg}\n%s";
    static const char more[] = "  - place: {count: 3}\n"
                               "    insertion: {angle: 60 deg}\n"
                               "    length: {law: absolute, value: 0.3 m}\n"
                               "    radius: {law: absolute, value: 1 mm}\n";
    struct grown again, other, larger;
    char text[2048];
    snprintf(text, sizeof text, wild, 7, "");
    grown_make(&g, text);
    grown_make(&again, text);
    snprintf(text, sizeof text, wild, 8, "");
    grown_make(&other, text);
    snprintf(text, sizeof text, wild, 7, more);
    grown_make(&larger, text);
    assert_int_equal(g.tree.n, again.tree.n);
    assert_memory_equal(g.tree.x1, again.tree.x1, g.tree.n * sizeof(double));
    assert_memory_equal(g.tree.r0, again.tree.r0, g.tree.n * sizeof(double));
    for (size_t k = 0; k < 6; k++) {
        size_t i = grown_axis(&g.tree, 1, k), o = grown_axis(&other.tree, 1, k),
               l = grown_axis(&larger.tree, 1, k);
        assert_memory_equal(&g.tree.z0[i], &larger.tree.z0[l], sizeof(double));
        assert_close(grown_length(&g.tree, i), grown_length(&larger.tree, l), 1e-12);
        assert_true(fabs(grown_length(&g.tree, i) - grown_length(&other.tree, o)) > 1e-6);
    }
    grown_is_connected(&g.tree);
    grown_is_connected(&larger.tree);
    wf_arena_free(&again.arena);
    wf_arena_free(&other.arena);
    wf_arena_free(&larger.arena);
}

/* The spread of many branches is that asked for. */
static void spread_has_the_size_asked_for(void **state)
{
    (void)state;
    grown_make(
        &g, "model: m\nname: M\ngenerator: levels\n"
            "stem: {height: 100 m, base_radius: 1 m, taper: {law: linear, tip_share: 0.9}, segments: 400}\n"
            "branches:\n"
            "  - place: {count: 4000}\n"
            "    insertion: {angle: 60 deg, spread: 8 deg}\n"
            "    length: {law: absolute, value: 2 m, spread: 0.2}\n"
            "    radius: {law: absolute, value: 1 mm}\n"
            "    segments: 1\n");
    double sum[2] = { 0 }, squares[2] = { 0 };
    size_t n = 0;
    for (size_t i = 0; i < g.tree.n; i++) {
        if (g.tree.level[i] != 1) continue;
        double v[2] = { grown_angle(&g.tree, i, 0) / DEG, log(wf_tree_length(&g.tree, i) / 2) };
        for (int k = 0; k < 2; k++) sum[k] += v[k], squares[k] += v[k] * v[k];
        n++;
    }
    assert_int_equal(n, 4000);
    for (int k = 0; k < 2; k++) sum[k] /= 4000, squares[k] = sqrt(squares[k] / 4000 - sum[k] * sum[k]);
    assert_close(sum[0], 60, 0.01);
    assert_close(squares[0], 8, 0.06);
    assert_close(sum[1], 0, 0.015);
    assert_close(squares[1], 0.2, 0.06);
}

/* Four opposite branches hang in balance: the base bears weight without a moment. */
static void symmetric_whorls_balance(void **state)
{
    (void)state;
    char *text = edited(plain, &(struct edit){ "per_whorl: 3", "per_whorl: 4", NULL });
    struct wf_err e = { 0 };
    struct wf_loads l;
    struct wf_solve_options o;
    struct wf_response r;
    grown_make(&g, text);
    free(text);
    wf_loads_default(&l);
    wf_solve_options_default(&o);
    if (wf_solver_named("beam")->solve(&g.tree, &l, &o, &g.arena, &r, &g.diag, &e)) fail_msg("%s", e.text);
    assert_true(r.base_force[2] < -100);
    assert_close(hypot(r.base_moment[0], r.base_moment[1]) / -r.base_force[2], 0, 1e-9);
    assert_true(fabs(r.end[3 * (g.tree.n - 1) + 2]) > 1e-6);
}

static void laws_of_radius(void **state)
{
    (void)state;
    static const char *const laws[] = { "{law: species}", "{law: length, value: 10 mm}",
                                        "{law: parent, factor: 3}" };
    static const double want[] = { 0.02, 0.0, 0.076 };
    for (int k = 0; k < 3; k++) {
        char *text = edited(plain, &(struct edit){ "{law: parent, factor: 0.4}", laws[k], NULL });
        grown_make(&g, text);
        free(text);
        size_t i = grown_axis(&g.tree, 1, 0);
        assert_close(g.tree.r0[i], k == 1 ? 0.01 * pow(3.5, 1.5) : want[k], 1e-12);
        if (k == 2)
            assert_string_equal(g.diag.first->code, "thick-branch"); /* held at the stem's own radius */
        if (k == 0) assert_null(g.diag.first);
        tear_down(NULL);
    }
}

/* Pipe model: the square of a radius is the sum of the squares above it. */
static void pipes_add_up(void **state)
{
    (void)state;
    grown_make(&g, "model: m\nname: M\ngenerator: levels\n"
                   "stem: {height: 10 m, base_radius: 100 mm, taper: {law: linear, tip_share: 0.2}}\n"
                   "branches:\n"
                   "  - place: {count: 3, from: 0.5, to: 0.8}\n"
                   "    insertion: {angle: 60 deg}\n"
                   "    length: {law: absolute, value: 2 m}\n"
                   "    radius: {law: pipe, value: 3 mm}\n"
                   "  - place: {at: [0.4, 0.8], per_whorl: 4}\n"
                   "    insertion: {angle: 60 deg}\n"
                   "    length: {law: absolute, value: 0.3 m}\n"
                   "    radius: {law: pipe, value: 2 mm}\n");
    size_t i = grown_axis(&g.tree, 1, 1);
    assert_close(g.tree.r0[i], sqrt(9e-6 + 8 * 4e-6), 1e-12);
    assert_close(g.tree.r0[i + 2], sqrt(9e-6 + 4 * 4e-6), 1e-12);
    assert_close(g.tree.r1[i + 4], 3e-3, 1e-12);
}

static void short_branches_do_not_grow(void **state)
{
    (void)state;
    char *text = edited(plain, &(struct edit){ "factor: 0.5}", "factor: 0.5, shortest: 2 m}", NULL });
    grown_make(&g, text);
    free(text);
    assert_int_equal(grown_axes(&g.tree, 1), 2 * 3);
    grown_is_connected(&g.tree);
}

static void whorls_keep_their_interval(void **state)
{
    (void)state;
    char *text = edited(plain, &(struct edit){ "count: 4", "spacing: 0.7 m", NULL });
    grown_make(&g, text);
    free(text);
    assert_int_equal(grown_axes(&g.tree, 1), 9 * 3);
    assert_close(g.tree.z0[grown_axis(&g.tree, 1, 24)], 3 + 8 * 0.7, 1e-12);
}

static void mistakes_are_named_with_their_place(void **state)
{
    (void)state;
    static const struct edit cases[] = {
        { "count: 4", "cout: 4",
          "6:12: branches[0].place: none of count, spacing and at; give exactly one of them\n"
          "6:33: branches[0].place: unknown key 'cout'; did you mean 'count'?" },
        { "count: 4", "count: 4, spacing: 1 m",
          "6:12: branches[0].place: more than one of count, spacing and at; give exactly one of them" },
        { "from: 0.3, to: 0.9", "from: 0.9, to: 0.3",
          "6:19: branches[0].place.from: 0.9 is not below 'to', 0.3" },
        { "{rule: planar}", "{rule: planar, divergence: 90 deg}",
          "14:41: branches[1].azimuth.divergence: is not used by rule 'planar'" },
        { "angle: 45 deg", "angle: 45",
          "15:24: branches[1].insertion.angle: '45' has no unit; write for "
          "example '45 deg'" },
        { "angle: 45 deg", "spread: 4 deg",
          "15:16: branches[1].insertion: either 'angle', or 'at' with 'angles' is needed" },
        { "[80 deg, 50 deg]", "[80 deg]", "8:41: branches[0].insertion.angles: 1 value, but 'at' has 2" },
        { "law: parent, factor: 0.3", "law: absolute",
          "16:13: branches[1].length: law 'absolute' needs the key 'value'" },
        { "law: rest,", "law: rest, value: 2 m,",
          "9:32: branches[0].length.value: is not used by law 'rest'" },
        { "law: absolute, value: 4 mm", "law: parent, exponent: 2",
          "17:37: branches[1].radius.exponent: is not used by law 'parent'" },
        { "law: parent, factor: 0.4", "law: pipe, value: 3 mm",
          "11:12: branches[0].taper: is not used by radius law 'pipe'\n"
          "17:19: branches[1].radius.law: is 'absolute' on a level that follows the pipe model; it must be "
          "'pipe' "
          "too" },
        { "generator: levels\n", "", "5:3: branches: needs 'generator: levels'" },
        { "generator: levels", "generator: ifs",
          "1:1: generator 'ifs' needs the key 'ifs'\n"
          "6:3: branches: is not used by generator 'ifs'" },
        { "branches:", "crown: {base: 5 m, leaf_area: 3 m2}\nbranches:",
          "5:8: crown: is not used by generator 'levels'" },
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

static void a_tree_too_large_is_refused(void **state)
{
    (void)state;
    char *text = edited(plain, &(struct edit){ "at: [0.5, 0.75]", "count: 100000, per_whorl: 100", NULL });
    struct wf_err e = { 0 };
    assert_int_equal(grown_read(&g, text, &e), WF_OK);
    assert_int_equal(wf_grow(&g.model, &g.species, &g.arena, &g.tree, &g.diag, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "more than 20000000 branches"));
    free(text);
}

/* The shipped models grow without a finding, and the willow's twigs end hanging straight down. */
static void shipped_models_grow(void **state)
{
    (void)state;
    static const char *const rows[][2] = { { "scots_pine", "scots_pine" },
                                           { "broadleaf", "beech" },
                                           { "moso_branched", "moso_bamboo" },
                                           { "weeping_willow_tree", "weeping_willow" } };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct wf_err e = { 0 };
        char model[128], species[128];
        snprintf(model, sizeof model, "models/%s.yaml", rows[k][0]);
        snprintf(species, sizeof species, "species/%s.yaml", rows[k][1]);
        g = (struct grown){ 0 };
        g.diag.arena = &g.arena;
        if (wf_model_read(model, &g.arena, &g.model, &g.diag, &e) ||
            wf_species_read(species, &wf_laws, &g.arena, &g.species, &g.diag, &e) ||
            wf_grow(&g.model, &g.species, &g.arena, &g.tree, &g.diag, &e) ||
            wf_tree_check(&g.tree, &g.diag, &e))
            fail_msg("%s", e.text);
        if (g.diag.first) fail_msg("%s: %s", model, g.diag.first->text);
        grown_is_connected(&g.tree);
        assert_true(g.tree.n > 500 && g.tree.n < 5000);
        const struct wf_tree *t = &g.tree;
        for (size_t i = 0; k == 3 && i < t->n; i++) {
            bool tip = i + 1 == t->n || t->parent[i + 1] != (int32_t)i;
            if (t->level[i] != 3 || !tip) continue;
            assert_close((t->z0[i] - t->z1[i]) / wf_tree_length(t, i), 1, 1e-9);
        }
        tear_down(NULL);
    }
}

int main(void)
{
#define T(name) cmocka_unit_test_teardown(name, tear_down)
    const struct CMUnitTest tests[] = {
        T(levels_have_the_counts_asked_for),
        T(branches_stand_where_asked_at_the_angles_asked),
        T(planar_branches_go_to_both_sides),
        T(materials_follow_the_level_and_the_last_is_repeated),
        T(a_branch_inside_a_segment_divides_it),
        T(a_turn_is_shared_by_the_joints_and_ends_upright),
        T(an_upright_stem_nods_towards_its_azimuth),
        T(a_seed_gives_one_tree_whatever_else_grows),
        T(spread_has_the_size_asked_for),
        T(symmetric_whorls_balance),
        T(laws_of_radius),
        T(pipes_add_up),
        T(short_branches_do_not_grow),
        T(whorls_keep_their_interval),
        T(mistakes_are_named_with_their_place),
        T(a_tree_too_large_is_refused),
        T(shipped_models_grow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
