/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scanned trees of other people, when the folder named by WINDFIRM_REFERENCE holds them (trees/qsm, beams):
 * sizes, masses and drag against an independent calculation. They are not shipped, for their licences. */
#include "close.h"
#include "data/species.h"
#include "imported.h"
#include "solve/modes.h"
#include <time.h>

static const char *reference(const char *room, const char *file)
{
    static char path[4096];
    const char *folder = getenv("WINDFIRM_REFERENCE");
    snprintf(path, sizeof path, "%s/%s/%s", folder ? folder : "", room, file);
    if (folder && access(path, R_OK) == 0) return path;
    print_message("skipped: %s is not there; WINDFIRM_REFERENCE may name a folder with %s/%s\n", file, room,
                  file);
    skip();
    return NULL;
}

/* One beam a cylinder from its parent's end to its own; masses and drag with the lengths stated in the files.
 * `bridged` is the volume of such beams, from parent's end to own end. Figures printed to six or more digits.
 */
static const struct {
    const char *file;
    size_t n;
    double density, height, volume, mass, bridged, drag_x, moment_x, drag_y, moment_y;
} finite_elements[] = {
    { "wytham_T20_leafoff.csv", 263, 801, 16.1398, 0.31047, 248.686, 0.333391353355, 750.011, 6520.34,
      726.513, 6376.05 },
    { "wytham_T3_leafoff.csv", 590, 721, 17.8526, 0.61809, 445.646, 0.678162579407, 1707.157, 19799.07,
      1647.614, 19050.95 },
    { "wytham_T14.csv", 1364, 801, 24.4435, 1.47333, 1180.134, 1.573179082102, 3106.642, 50077.90, 3329.392,
      53999.74 },
    { "wytham_T13.csv", 3086, 801, 22.4851, 2.38420, 1909.744, 2.564185205744, 5264.562, 83345.38, 5214.420,
      82935.95 },
};

static void masses_and_drag_agree(void **state)
{
    (void)state;
    for (size_t k = 0; k < 4; k++) {
        struct imported t;
        struct wf_qsm_model m;
        double force, moment, pressure = 0.5 * 1.226 * 20 * 20;
        import_path(&t, reference("trees/qsm", finite_elements[k].file));
        assert_int_equal(t.status, WF_OK);
        assert_sound(&t.qsm);
        assert_int_equal(t.qsm.n, finite_elements[k].n);
        assert_close(t.metrics.volume * finite_elements[k].density, finite_elements[k].mass, 1e-6);
        assert_close(t.metrics.height, finite_elements[k].height, 3e-6); /* printed to 0.1 mm */
        wf_qsm_drag(&t.qsm, pressure, 0.82, 0, &force, &moment);
        assert_close(force, finite_elements[k].drag_x, 1e-6);
        assert_close(moment, finite_elements[k].moment_x, 1e-6);
        wf_qsm_drag(&t.qsm, pressure, 0.82, M_PI / 2, &force, &moment);
        assert_close(force, finite_elements[k].drag_y, 1e-6);
        assert_close(moment, finite_elements[k].moment_y, 1e-6);
        assert_joined(&t, WF_JOINT_BRIDGE, &m);
        assert_int_equal(m.tree.n, finite_elements[k].n);
        assert_close(m.volume, finite_elements[k].bridged, 1e-9);
        assert_joined(&t, WF_JOINT_AXIS, &m);
        assert_close(segment_volume(&m), m.volume, 1e-12);
        assert_close(m.volume, t.metrics.volume, 0.02); /* bridges add what was not seen */
        wf_arena_free(&t.arena);
    }
}

/* Lowest natural frequencies of the same beams: clamped, no gravity, no leaves, G = E / (2 (1 + 0.38)). The
 * calculation compared with is a 12-degree-of-freedom Euler-Bernoulli frame with consistent mass, printed to
 * 10 microhertz. */
static const struct {
    const char *file;
    double youngs, density, frequency[6];
} vibrations[] = {
    { "wytham_T20_leafoff.csv", 8.5e9, 801, { 0.35518, 0.35600, 0.89550, 0.92449, 1.01459, 1.07944 } },
    { "wytham_T3_leafoff.csv", 8.4e9, 721, { 0.22538, 0.22703, 0.39692, 0.39858, 0.50867, 0.51921 } },
    { "wytham_T14.csv", 9.5e9, 801, { 0.17782, 0.17789, 0.38148, 0.39607, 0.40018, 0.40237 } },
    { "wytham_T13.csv", 9.5e9, 801, { 0.21028, 0.21269, 0.31963, 0.32369, 0.40032, 0.41650 } },
};

static void frequencies_agree(void **state)
{
    (void)state;
    for (size_t k = 0; k < 4; k++) {
        struct imported t;
        struct wf_qsm_model m;
        struct wf_solve_options o;
        struct wf_loads l;
        double f[6];
        import_path(&t, reference("trees/qsm", vibrations[k].file));
        assert_joined(&t, WF_JOINT_BRIDGE, &m);
        struct wf_level level = { .youngs_modulus.value = vibrations[k].youngs,
                                  .shear_modulus.value = vibrations[k].youngs / (2 * 1.38),
                                  .density.value = vibrations[k].density,
                                  .knot_factor.value = 1 };
        struct wf_species sp = { .key = "test", .levels = 1, .level = &level };
        assert_int_equal(wf_clothe(&m.tree, &sp, &(struct wf_clothing){ .kind = m.kind }, &t.arena, &t.err),
                         WF_OK);
        wf_loads_default(&l);
        l.gravity = 0;
        wf_solve_options_default(&o);
        o.mesh_tolerance = 0; /* one element a cylinder, as there */
        assert_int_equal(wf_modes(&m.tree, &l, &o, 6, &t.arena, f, NULL, &t.err), WF_OK);
        for (size_t i = 0; i < 6; i++) assert_close(f[i], vibrations[k].frequency[i], 5e-5);
        wf_arena_free(&t.arena);
    }
}

/* Every file of the folder is read and joined; counts as its own description states them. */
static void every_file_is_read(void **state)
{
    (void)state;
    static const struct {
        const char *file, *format;
        size_t n;
        double height;
    } want[] = {
        { "archi_Tree_1_TreeQSM.txt", "TreeQSM text", 2271, 22.04 },
        { "rtwig_simpleforest_QSM.csv", "SimpleForest CSV", 1149, 3.70 },
        { "rtwig_archi_QSM2.csv", "aRchi CSV", 1231, 3.65 },
        { "openalea_walnut_noylum2.mtg", "OpenAlea MTG", 6150, 7.96 },
#ifdef WF_MATIO
        { "wytham_T14.mat", "MATLAB file", 1364, 24.44 },
#endif
    };
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        struct imported t;
        struct wf_qsm_model m;
        import_path(&t, reference("trees/qsm", want[k].file));
        assert_int_equal(t.status, WF_OK);
        assert_sound(&t.qsm);
        assert_string_equal(t.qsm.format, want[k].format);
        assert_int_equal(t.qsm.n, want[k].n);
        assert_close(t.metrics.height, want[k].height, 1.5e-3);
        assert_int_equal(t.metrics.stems, 1);
        assert_joined(&t, WF_JOINT_AXIS, &m);
        assert_joined(&t, WF_JOINT_BRIDGE, &m);
        wf_arena_free(&t.arena);
    }
}

/* Two programs, one sapling: each file's volume is that of its own rows; they differ by the radii, not the
 * lengths. */
static void two_models_of_one_sapling(void **state)
{
    (void)state;
    struct imported a, b;
    import_path(&a, reference("trees/qsm", "rtwig_simpleforest_QSM.csv"));
    import_path(&b, reference("trees/qsm", "rtwig_archi_QSM2.csv"));
    assert_close(b.metrics.volume, 0.021786424695682448, 1e-9); /* sum of its volume column */
    assert_close(a.metrics.length, 31.42635, 1e-6);             /* its growthLength at the base */
    double radius2_a = a.metrics.volume / M_PI / a.metrics.length,
           radius2_b = b.metrics.volume / M_PI / b.metrics.length;
    double volumes = a.metrics.volume / b.metrics.volume;
    assert_close(volumes, radius2_a / radius2_b * a.metrics.length / b.metrics.length, 1e-12);
    assert_close(volumes, 1.376, 1e-3);
    assert_close(radius2_a / radius2_b, 1.499, 1e-3);
    assert_close(a.metrics.length / b.metrics.length, 0.918, 1e-3);
    assert_close(a.metrics.width_x, b.metrics.width_x, 1e-3);
    wf_arena_free(&a.arena);
    wf_arena_free(&b.arena);
}

#ifdef WF_MATIO
static void matlab_and_csv_of_one_tree(void **state)
{
    (void)state;
    struct imported a, b;
    import_path(&a, reference("trees/qsm", "wytham_T14.mat"));
    import_path(&b, reference("trees/qsm", "wytham_T14.csv"));
    assert_int_equal(a.qsm.n, b.qsm.n);
    assert_close(a.metrics.volume, b.metrics.volume, 2e-6); /* single precision against six decimals */
    assert_close(a.metrics.dbh, b.metrics.dbh, 5e-6);
    for (size_t i = 0; i < a.qsm.n; i++) assert_int_equal(a.qsm.parent[i], b.qsm.parent[i]);
    for (size_t i = 0; i < a.qsm.n; i++) assert_int_equal(a.qsm.branch[i], b.qsm.branch[i]);
    wf_arena_free(&a.arena);
    wf_arena_free(&b.arena);
}
#endif

static void a_large_tree_is_read(void **state)
{
    (void)state;
    const char *path = reference("beams", "bench_tree_100k.csv");
    struct imported t;
    struct wf_qsm_model m;
    clock_t start = clock();
    import_path(&t, path);
    double read = (double)(clock() - start) / CLOCKS_PER_SEC;
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, 100000);
    start = clock();
    assert_int_equal(wf_qsm_to_tree(&t.qsm, WF_JOINT_AXIS, &t.arena, &m, &t.err), WF_OK);
    double joined = (double)(clock() - start) / CLOCKS_PER_SEC;
    print_message("100k cylinders: read %.3f s, joined %.3f s\n", read, joined);
    assert_int_equal(m.tree.n, 100000);
    assert_int_equal(m.links + m.bridges + m.gaps, 0);
    assert_close(m.volume, t.metrics.volume, 1e-12);
    wf_arena_free(&t.arena);
}

/* A scan stands as it is, so that every one has an answer: a critical wind for the tree and its stem. */
static void every_scan_has_an_answer(void **state)
{
    static const char *const files[] = { "wytham_T20_leafoff.csv",
                                         "wytham_T3_leafoff.csv",
                                         "wytham_T14.csv",
                                         "wytham_T13.csv",
                                         "rtwig_archi_QSM2.csv",
                                         "rtwig_simpleforest_QSM.csv",
                                         "openalea_walnut_noylum2.mtg",
                                         "archi_Tree_1_TreeQSM.txt" };
    (void)state;
    const char *program = getenv("WINDFIRM");
    if (!program) skip();
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        char command[9000], line[4096], folder[] = "/tmp/wf-scan-XXXXXX";
        bool found = false, fell = false;
        const char *path = reference("trees/qsm", files[k]);
        assert_non_null(mkdtemp(folder));
        snprintf(command, sizeof command,
                 "'%s' analyze ash --tree '%s' --wind 10 --peak mean --no-report -o %s/o 2>&1; echo exit $?; "
                 "rm -r %s",
                 program, path, folder, folder);
        FILE *f = popen(command, "r");
        assert_non_null(f);
        while (fgets(line, sizeof line, f)) {
            if (strstr(line, "  critical wind speed ")) found = strstr(line, "m/s") && !strstr(line, "none;");
            if (strstr(line, "exit ") == line) fell = strcmp(line, "exit 0\n") != 0;
        }
        pclose(f);
        if (!found || fell) fail_msg("%s: no critical wind speed", files[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(masses_and_drag_agree),      cmocka_unit_test(frequencies_agree),
        cmocka_unit_test(every_file_is_read),         cmocka_unit_test(two_models_of_one_sapling),
#ifdef WF_MATIO
        cmocka_unit_test(matlab_and_csv_of_one_tree),
#endif
        cmocka_unit_test(a_large_tree_is_read),       cmocka_unit_test(every_scan_has_an_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
