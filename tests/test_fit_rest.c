/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees of a calibration that stand in their shape: which do, what they carried, where readings count from,
 * and parts that would not stand. */
#include "close.h"
#include "data/model.h"
#include "data/species.h"
#include "fit/build.h"
#include "fit/fit.h"
#include "fit/predict.h"
#include "grow/grow.h"
#include "load/drag.h"
#include "scratch.h"
#include "shell.h"
#include "study/analysis.h"

struct job {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    char folder[64];
    struct wf_calibration calibration;
    struct wf_experiment x;
    struct wf_fit_input input[4];
    struct wf_fit_param *param;
    size_t params;
};

static void put(struct job *j, const char *name, const char *text)
{
    FILE *f = fopen(wf_arena_print(&j->arena, "%s/%s", j->folder, name), "w");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
}

/* A stem that leans and winds, with a side branch; radius of the branch [m]; `heavy`: a second leader that
 * stands beside the stem, slender, and heavier than a twentieth of the tree. */
static void put_scan(struct job *j, double branch, bool heavy)
{
    char text[6000];
    size_t n = (size_t)snprintf(text, sizeof text, "id,parent,x0,y0,z0,x1,y1,z1,radius0,radius1,level\n");
    double at[3] = { 0, 0, 0 }, fork[3] = { 0 };
    int id = 0, below = 0, crotch = 0;
    for (int i = 0; i < 30 + 20 * heavy; i++) {
        bool side = i >= 20;
        if (i == 20 || i == 30) memcpy(at, fork, sizeof at), below = crotch;
        double by[3] = { 0.05 + 0.06 * sin(0.9 * i), 0.06 * cos(1.3 * i), 0.5 }, r = 0.1 - 0.004 * i;
        if (side) by[0] = 0, by[1] = 0.4, by[2] = 0.12, r = branch;
        if (i >= 30) by[1] = -0.02, by[2] = 0.5, r = 0.03;
        n += (size_t)snprintf(text + n, sizeof text - n, "%d,%d,%g,%g,%g,%g,%g,%g,%g,%g,%d\n", ++id, below,
                              at[0], at[1], at[2], at[0] + by[0], at[1] + by[1], at[2] + by[2], r,
                              side ? r : r - 0.004, side);
        for (int k = 0; k < 3; k++) at[k] += by[k];
        below = id;
        if (i == 11) crotch = id, memcpy(fork, at, sizeof fork);
    }
    put(j, "scan.csv", text);
}

static void begin(struct job *j)
{
    memset(j, 0, sizeof *j);
    j->diag.arena = &j->arena;
    snprintf(j->folder, sizeof j->folder, "/tmp/windfirm-test-XXXXXX");
    assert_non_null(mkdtemp(j->folder));
    put(j, "wood.yaml",
        "species: wood\nname: Wood\nlevels:\n  - name: wood\n    youngs_modulus: 8 GPa\n    density: 800 "
        "kg/m3\n"
        "    radius: 100 mm\n    drag_coefficient: 1\n"
        "crown: {drag_coefficient: 0.5, frontal_share: 0.3, leaf_mass_per_area: 0.2 kg/m2}\n");
    put(j, "drawn.yaml",
        "model: drawn\nname: Drawn\nshape: under_weight\nscanned: leaf_off\nstem:\n  height: 9 m\n"
        "  base_radius: 60 mm\n  taper: {law: linear, tip_share: 0.3}\n  segments: 30\n"
        "  lean: 10 deg\ncrown: {base: 4 m, leaf_area: 20 m2}\n");
    put_scan(j, 0.03, false);
}

static void end(struct job *j)
{
    char command[128];
    snprintf(command, sizeof command, "rm -r %s", j->folder);
    assert_int_equal(system(command), 0);
    wf_arena_free(&j->arena);
}

static const char pulled[] = "name: pull, pull: {height: 4 m, azimuth: 20 deg, loads: [300 N, 900 N]}";

/* Build a study of one tree, with the keys `tree`, and a test. */
static enum wf_status build(struct job *j, const char *tree, const char *test)
{
    const char *path = wf_arena_print(&j->arena, "%s/study.yaml", j->folder);
    put(j, "study.yaml",
        wf_arena_print(&j->arena,
                       "fit: study\nname: Study\ntrees:\n  - {name: T, species: wood.yaml, %s}\n"
                       "tests:\n  - {%s,\n     sensors: [\n"
                       "      {name: bend, kind: deflection, height: 5 m, azimuth: 0 deg, sigma: 1 mm},\n"
                       "      {name: tilt, kind: tilt, height: 3 m, azimuth: 0 deg, sigma: 0.01 deg},\n"
                       "      {name: bark, kind: strain, height: 1.3 m, azimuth: 0 deg, sigma: 1e-6}]}\n"
                       "free:\n  - {parameter: level0.youngs_modulus}\n",
                       tree, test));
    struct wf_fit_build b = { .calibration = &j->calibration, .share = ".", .plan = true };
    enum wf_status s = wf_calibration_read(path, &j->arena, &j->calibration, &j->diag, &j->err);
    if (!s) s = wf_fit_build(&b, &j->arena, &j->diag, &j->x, j->input, &j->err);
    return s ? s
             : wf_fit_params(&j->calibration, NULL, &j->x, true, &j->arena, &j->param, &j->params, &j->err);
}

static void readings_of(struct job *j, const char *tree, const char *test, double *reading)
{
    if (build(j, tree, test) ||
        wf_fit_expect(&j->x, j->param, j->params, &j->arena, reading, NULL, &j->diag, &j->err)) {
        char all[4000];
        findings_print(&j->diag, all, sizeof all);
        fail_msg("%s, %s: %s\n%s", tree, test, j->err.text, all);
    }
}

static double largest_difference(const double *a, const double *b, size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; i++) most = fmax(most, fabs(a[i] - b[i]) / fabs(b[i]));
    return most;
}

static void which_trees_stand(void **unused)
{
    (void)unused;
    static const struct {
        const char *tree;
        bool stands;
    } row[] = {
        { "qsm: scan.csv", true },
        { "qsm: scan.csv, rest: as-drawn", true },
        { "qsm: scan.csv, rest: stress-free", false },
        { "qsm: scan.csv, gravity: 0 m/s2", false },
        { "model: drawn.yaml", true },
        { "model: drawn.yaml, rest: stress-free", false },
        { "model: culm, rest: as-drawn", true },
        { "model: culm", false },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct job j;
        begin(&j);
        if (build(&j, row[i].tree, pulled)) fail_msg("%s: %s", row[i].tree, j.err.text);
        const struct wf_tree *t = &j.x.tree[0].tree;
        if ((t->standing != NULL) != row[i].stands) fail_msg("%s", row[i].tree);
        assert_true((j.x.tree[0].props != NULL) == row[i].stands);
        end(&j);
    }
}

/* Both zeros are the shape drawn; a tree free of stress sags, and its readings differ, all the more without
 * subtracting its rest. */
static void readings_count_from_the_shape(void **unused)
{
    (void)unused;
    struct job j;
    double rest[6], unloaded[6], free[6], sagged[6];
    const char *zero =
        "zero: unloaded, name: pull, pull: {height: 4 m, azimuth: 20 deg, loads: [300 N, 900 N]}";
    begin(&j);
    readings_of(&j, "qsm: scan.csv", pulled, rest);
    readings_of(&j, "qsm: scan.csv", zero, unloaded);
    assert_true(largest_difference(rest, unloaded, 6) < 1e-9);
    readings_of(&j, "qsm: scan.csv, rest: stress-free", pulled, free);
    readings_of(&j, "qsm: scan.csv, rest: stress-free", zero, sagged);
    assert_true(largest_difference(free, rest, 6) > 2e-4);
    assert_true(largest_difference(sagged, rest, 6) > 0.05);
    end(&j);
}

/* What the tree has gained since the scan bends it; models say it by `scanned`. */
static void leaves_of_the_day_of_the_shape(void **unused)
{
    (void)unused;
    struct job j;
    struct wf_arena a = { 0 };
    double sum[2] = { 0, 0 };
    begin(&j);
    for (int k = 0; k < 3; k++) {
        const char *tree = k == 0   ? "qsm: scan.csv, leaf_area: 30 m2"
                           : k == 1 ? "qsm: scan.csv, leaf_area: 30 m2, scanned_leaf_area: 10 m2"
                                    : "model: drawn.yaml";
        if (build(&j, tree, pulled)) fail_msg("%s", j.err.text);
        const struct wf_tree *t = &j.x.tree[0].tree;
        const double *then[] = { t->standing->burden0, t->standing->burden1 },
                     *now[] = { t->burden0, t->burden1 };
        sum[0] = sum[1] = 0;
        for (size_t i = 0; i < t->n; i++)
            for (int e = 0; e < 2; e++) {
                double half = 0.5 * wf_tree_length(t, i);
                sum[0] += half * then[e][i], sum[1] += half * now[e][i];
            }
        assert_close(sum[1], k == 2 ? 4 : 6, 1e-9); /* 0.2 kg/m2, on the rows as divided for the sensors */
        assert_close(sum[0], k == 0 ? 6 : k == 1 ? 2 : 0, 1e-9);
    }
    wf_arena_free(&a);
    end(&j);
}

/* A fit's readings in wind are the displacements of an analysis of the same tree. */
static void as_an_analysis_has_it(void **unused)
{
    (void)unused;
    static const double speed[2] = { 9, 16 };
    for (int k = 0; k < 2; k++) {
        struct job j;
        struct wf_species sp;
        struct wf_model *m;
        struct wf_analysis an;
        struct wf_solve_options o;
        struct wf_scenario scene;
        struct wf_search search;
        double reading[6];
        begin(&j);
        readings_of(&j, k ? "qsm: scan.csv, leaf_area: 8 m2, scanned_leaf_area: 0 m2" : "qsm: scan.csv",
                    "name: wind, zero: unloaded, wind: {speeds: [9 m/s, 16 m/s]}", reading);
        wf_search_default(&search);
        search.speed_max = 60;
        wf_solve_options_default(&o);
        wf_scenario_default(&scene);
        scene.peak.method = "mean";
        const char *path = wf_arena_print(&j.arena, "%s/scan.csv", j.folder),
                   *wood = wf_arena_print(&j.arena, "%s/wood.yaml", j.folder);
        if (wf_species_read(wood, &wf_laws, &j.arena, &sp, &j.diag, &j.err) ||
            wf_model_scanned(path, NULL, &j.arena, &m, &j.diag, &j.err))
            fail_msg("%s", j.err.text);
        m->scanned = WF_SCANNED_LEAF_OFF;
        if (k) assert_int_equal(wf_model_leaves(m, 8, &j.err), WF_OK);
        if (wf_analyze(&sp, m, &scene, &search, wf_solvers[0], &o, speed, 2, &j.arena, &j.diag, &an, &j.err))
            fail_msg("%s", j.err.text);
        size_t row = 9; /* its end is at 5 m */
        assert_close(an.tree.z1[row], 5, 1e-9);
        for (size_t i = 0; i < 2; i++)
            assert_close(reading[3 * i], an.at[i].response.end[3 * row], 2e-5); /* meshes differ */
        end(&j);
    }
}

static bool found(struct job *j, const char *words)
{
    char all[8000];
    findings_print(&j->diag, all, sizeof all);
    return strstr(all, words) || strstr(j->err.text, words);
}

/* A thin branch would fall with the wood of the start; it is stiffened, said so, and the stem's modulus comes
 * back. Without weight, or with the shape free of stress, nothing is stiffened. */
static void small_parts_are_stiffened(void **unused)
{
    (void)unused;
    struct job j;
    struct wf_fit_options o;
    struct wf_fit f;
    double reading[6];
    begin(&j);
    put_scan(&j, 0.006, false);
    readings_of(&j, "qsm: scan.csv", pulled, reading);
    assert_int_equal(j.x.tree[0].props->all.n, 1);
    assert_true(found(&j, "tree T: 1 part under 5 %"));
    for (size_t i = 0; i < 6; i++)
        j.x.datum[i].value = reading[i], j.x.datum[i].sigma = 1e-3 * fabs(reading[i]);
    j.param[0].start *= 1.7; /* no part needs stiffening from here, but those that were keep it */
    wf_fit_options_default(&o);
    if (wf_fit_run(&j.x, j.param, j.params, &o, &j.arena, &j.diag, &f, &j.err)) fail_msg("%s", j.err.text);
    assert_close(f.estimate[0].value, 8e9, 1e-8);
    assert_true(f.lsq.converged);
    end(&j);
}

/* Expected frequency of the scan, with the keys `mode` of its sensor. */
static double frequency(struct job *j, const char *mode)
{
    double f;
    const char *path = wf_arena_print(&j->arena, "%s/study.yaml", j->folder);
    put(j, "study.yaml",
        wf_arena_print(&j->arena,
                       "fit: study\nname: Study\ntrees:\n  - {name: T, species: wood.yaml, qsm: scan.csv}\n"
                       "tests:\n  - {name: sway, sensors: [{name: f, kind: frequency, sigma: 0.001 Hz%s}]}\n"
                       "free:\n  - {parameter: level0.youngs_modulus}\n",
                       mode));
    struct wf_fit_build b = { .calibration = &j->calibration, .share = ".", .plan = true };
    if (wf_calibration_read(path, &j->arena, &j->calibration, &j->diag, &j->err) ||
        wf_fit_build(&b, &j->arena, &j->diag, &j->x, j->input, &j->err) ||
        wf_fit_params(&j->calibration, NULL, &j->x, true, &j->arena, &j->param, &j->params, &j->err) ||
        wf_fit_expect(&j->x, j->param, j->params, &j->arena, &f, NULL, &j->diag, &j->err))
        fail_msg("%s", j->err.text);
    return f;
}

/* The lowest mode of the tree with a long thin branch is the branch's. A heavy branch sways as much as the
 * tree, which is said; and so is a fit that ends where another mode takes over. */
static void frequency_is_of_the_sway(void **unused)
{
    (void)unused;
    struct job j;
    begin(&j);
    put_scan(&j, 0.012, false);
    double sway = frequency(&j, ""), lowest = frequency(&j, ", mode: lowest");
    assert_true(lowest < 0.5 * sway);
    assert_false(found(&j, "a heavy branch sways by itself"));
    end(&j);
    begin(&j);
    put_scan(&j, 0.03, true);
    double heavy = frequency(&j, "");
    assert_close(frequency(&j, ", mode: lowest"), heavy, 1e-9);
    assert_true(found(&j, "a heavy branch sways by itself"));
    end(&j);
}

/* Readings that ask for wood with which a heavy part would fall: the fit ends before, and says so. */
static void fit_that_meets_a_fall(void **unused)
{
    (void)unused;
    struct job j;
    struct wf_fit_options o;
    struct wf_fit f;
    double reading[6];
    begin(&j);
    put_scan(&j, 0.03, true);
    readings_of(&j, "qsm: scan.csv", pulled, reading);
    wf_fit_options_default(&o);
    o.profile = false;
    for (int k = 0; k < 2; k++) {
        double softer = k ? 3 : 1.2;
        for (size_t i = 0; i < 6; i++)
            j.x.datum[i].value = softer * reading[i], j.x.datum[i].sigma = 0.01 * fabs(reading[i]);
        j.diag = (struct wf_diag){ .arena = &j.arena };
        if (wf_fit_run(&j.x, j.param, j.params, &o, &j.arena, &j.diag, &f, &j.err))
            fail_msg("%s", j.err.text);
        assert_int_equal(found(&j, "where it is not the best"), k);
        if (!k) assert_true(f.estimate[0].value < 7e9 && f.lsq.converged);
    }
    end(&j);
}

/* A part that is stiffened on the way makes another tree: the fit ends at the least squares of that one. */
static void stiffened_on_the_way(void **unused)
{
    (void)unused;
    struct job j;
    struct wf_fit_options o;
    struct wf_fit f;
    double reading[6];
    begin(&j);
    put_scan(&j, 0.006, false);
    readings_of(&j, "qsm: scan.csv", pulled, reading);
    double raise = j.x.tree[0].props->raise[j.x.tree[0].tree.n - 1];
    assert_true(raise > 1.5);
    if (build(&j, "qsm: scan.csv", pulled)) fail_msg("%s", j.err.text);
    for (size_t i = 0; i < 6; i++)
        j.x.datum[i].value = reading[i], j.x.datum[i].sigma = 1e-3 * fabs(reading[i]);
    j.param[0].start *= 4; /* stiff enough for all */
    wf_fit_options_default(&o);
    o.profile = false;
    struct wf_diag d = { .arena = &j.arena };
    if (wf_fit_run(&j.x, j.param, j.params, &o, &j.arena, &d, &f, &j.err)) fail_msg("%s", j.err.text);
    assert_true(j.x.tree[0].props->times >= 1);
    assert_close(f.estimate[0].value, 8e9, 1e-4); /* the twig, now of other stiffness, hardly takes part */
    j.diag = d;
    assert_true(found(&j, "tree T: 1 part under 5 %"));
    assert_false(found(&j, "where it is not the best"));
    end(&j);
}

static void large_parts_and_roots_are_refused(void **unused)
{
    (void)unused;
    static const struct {
        const char *tree, *words;
        bool heavy;
    } row[] = {
        { "qsm: scan.csv", "'rest: stress-free' takes the shape as free of stress", true },
        { "qsm: scan.csv, root_stiffness: 1 kN m/rad", "the root plate is too soft for its weight", false },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct job j;
        double reading[6];
        begin(&j);
        put_scan(&j, 0.03, row[i].heavy);
        j.err = (struct wf_err){ 0 };
        if (build(&j, row[i].tree, pulled)) fail_msg("%s", j.err.text);
        j.param[0].start = row[i].heavy ? 4e7 : 8e9;
        assert_int_equal(wf_fit_expect(&j.x, j.param, j.params, &j.arena, reading, NULL, &j.diag, &j.err),
                         WF_EUNSTABLE);
        if (!found(&j, row[i].words) || !found(&j, "tree T: does not stand")) fail_msg("%s", j.err.text);
        end(&j);
    }
}

static void places_of_mistakes(void **unused)
{
    (void)unused;
    static const struct {
        const char *tree, *test, *words;
    } bad[] = {
        { "qsm: scan.csv, rest: as-drwn", pulled, "4:56: trees[0].rest: 'as-drwn' is not one of" },
        { "qsm: scan.csv, rest: yes", pulled, "4:56: trees[0].rest: 'yes' is not one of" },
        { "qsm: scan.csv, rest: as-drawn, gravity: 0 m/s2", pulled,
          "4:56: trees[0].rest: has no effect beside" },
        { "qsm: scan.csv, scanned_leaf_area: 5", pulled, "trees[0].scanned_leaf_area: '5' has no unit" },
        { "qsm: scan.csv, scanned_leaf_area: -5 m2", pulled, "trees[0].scanned_leaf_area: -5 m2 is outside" },
        { "qsm: scan.csv, scanned_leaf_area: 5 m2, rest: stress-free", pulled,
          "trees[0].scanned_leaf_area: has no effect beside 'rest: stress-free'" },
        { "qsm: scan.csv, scanned_leaf_area: 5 m2, gravity: 0 m/s2", pulled,
          "trees[0].scanned_leaf_area: has no effect beside 'gravity: 0'" },
        { "model: drawn.yaml, scanned_leaf_area: 5 m2", pulled,
          "trees[0].scanned_leaf_area: applies only with 'qsm'" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct job j;
        char all[4000];
        begin(&j);
        assert_int_equal(build(&j, bad[i].tree, bad[i].test), WF_EINPUT);
        findings_print(&j.diag, all, sizeof all);
        if (!strstr(all, bad[i].words)) fail_msg("'%s' is told as\n%s\n%s", bad[i].tree, all, j.err.text);
        end(&j);
    }
}

/* Weight alone does not bend a tree that stands in its shape; 'mode' is of frequencies. */
#define SAG                                                                                                  \
    "printf 'species: wood\nname: Wood\nlevels:\n  - {name: w, youngs_modulus: 8 GPa, density: 800 "         \
    "kg/m3, radius: 100 mm, drag_coefficient: 1}\n' > $T/wood.yaml\n"                                        \
    "printf 'id,parent,x0,y0,z0,x1,y1,z1,radius0,radius1,level\n1,0,0,0,0,1,0,5,0.1,0.05,0\n' > "            \
    "$T/scan.csv\n"                                                                                          \
    "printf 'fit: s\nname: s\ntrees: [{name: T, species: wood.yaml, qsm: scan.csv}]\ntests:\n  - {name: "    \
    "sag, "                                                                                                  \
    "zero: unloaded, sensors: [{name: a, kind: vertical, height: 4 m, value: -2 mm, sigma: 1 mm}]}\nfree: "  \
    "[{parameter: level0.youngs_modulus}]\n' > $T/sag.yaml\n"
static void studies_that_tell_nothing(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { SAG "$W fit $T/sag.yaml --no-report -o $T/o",
          CODE_INPUT,
          { "test sag: tree T stands in its shape", "'rest: stress-free' takes the shape as unloaded" } },
        { SAG "sed 's/scan.csv}/scan.csv, rest: stress-free}/' $T/sag.yaml > $T/f.yaml; $W fit $T/f.yaml "
              "--no-report "
              "--no-rival -o $T/o",
          CODE_OK,
          { "level0.youngs_modulus" } },
        { SAG "sed 's/height: 4 m/height: 4 m, mode: lowest/' $T/sag.yaml > $T/m.yaml; $W fit $T/m.yaml "
              "--no-report -o $T/o",
          CODE_INPUT,
          { "'mode' applies to a frequency, not to a vertical" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(which_trees_stand),
        cmocka_unit_test(readings_count_from_the_shape),
        cmocka_unit_test(leaves_of_the_day_of_the_shape),
        cmocka_unit_test(as_an_analysis_has_it),
        cmocka_unit_test(small_parts_are_stiffened),
        cmocka_unit_test(frequency_is_of_the_sway),
        cmocka_unit_test(fit_that_meets_a_fall),
        cmocka_unit_test(stiffened_on_the_way),
        cmocka_unit_test(large_parts_and_roots_are_refused),
        cmocka_unit_test(places_of_mistakes),
        cmocka_unit_test(studies_that_tell_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
