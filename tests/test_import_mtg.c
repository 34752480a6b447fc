/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tree graphs (MTG): column names, ranges, units, lines that cannot be read. */
#include "close.h"
#include "data/species.h"
#include "imported.h"
#include "shell.h"

#define PUBLIC "tests/data/public/"
static const struct wf_import_options none = { .length_unit = NAN, .diameter_unit = NAN };

/* The tree of the public samples, as frustums: a stem of three pieces and a branch. */
static const double WOOD = 0.154805;

static void assert_tree(struct imported *t)
{
    if (t->status) fail_msg("%s", t->err.text);
    assert_sound(&t->qsm);
    assert_int_equal(t->qsm.n, 4);
    assert_int_equal(t->metrics.branches, 2);
    assert_close(t->metrics.height, 6, 1e-9);
    assert_close(t->metrics.volume, WOOD, 5e-6);
    assert_int_equal(t->qsm.repairs.count[WF_REPAIR_BAD_ROW], 0);
    wf_arena_free(&t->arena);
}

static size_t said(const struct imported *t, const char *code)
{
    size_t n = 0;
    for (const struct wf_finding *f = t->diag.first; f; f = f->next) n += f->code && !strcmp(f->code, code);
    return n;
}

/* A graph with these features and lines. */
static void import_graph(struct imported *t, const char *names, const char *lines, struct wf_import_options o)
{
    char text[4096];
    struct scratch s;
    int n = snprintf(
        text, sizeof text,
        "CODE:\tFORM-A\nCLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
        "$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\tFREE\tFREE\tIMPLICIT\nA\t2\tFREE\tFREE\tIMPLICIT\n"
        "N\t3\tFREE\tFREE\tIMPLICIT\nDESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\nFEATURES:\nNAME\tTYPE\n"
        "MTG:\n%s\n%s",
        names, lines);
    scratch_write(&s, text, (size_t)n);
    import_with(t, s.path, o);
    scratch_remove(&s);
}

static void graph_is_tree(const char *names, const char *lines, struct wf_import_options o)
{
    struct imported t;
    import_graph(&t, names, lines, o);
    assert_tree(&t);
}

static void public_graphs(void **state)
{
    (void)state;
    static const char *const files[] = { "mtg_range.mtg", "mtg_topo.mtg", "mtg_metres.mtg" };
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        struct imported t;
        char path[128];
        snprintf(path, sizeof path, PUBLIC "%s", files[k]);
        import_path(&t, path);
        assert_int_equal(said(&t, "unit-assumed"), k == 2);
        assert_tree(&t);
    }
}

#define NAMES "TOPO\t\tXX\tYY\tZZ\tDiameter"
#define BASE "/P1\n^/A1/N1\t\t0\t0\t0\t24\n"
#define TOP "\t+N40\t90\t10\t380\t6\n^<N50\t\t3\t2\t600\t8\n"

static void ranges_are_written_in_several_ways(void **state)
{
    (void)state;
    graph_is_tree(NAMES, BASE "^<N2<<N9\t\t0\t0\t150\t22\n^<N10\t\t2\t0\t300\t18\n" TOP, none);
    graph_is_tree(NAMES, BASE "^<N2<<N4<<N9\t\t0\t0\t150\t22\n^<N10<<N12\t\t2\t0\t300\t18\n" TOP, none);
    graph_is_tree(NAMES, BASE "^<N2\t\t0\t0\t150\t22\n^<N3<<N9\t\t2\t0\t300\t18\n" TOP, none);
    graph_is_tree(NAMES,
                  "/P1\n^/A1/N1\t\t0\t0\t0\t24\n^<N2\t\t0\t0\t150\t22\n^<N3\t\t2\t0\t300\t18\n"
                  "\t+N4<<N6\t90\t10\t380\t6\n^<N50\t\t3\t2\t600\t8\n",
                  none);
    /* other unit, order of columns, blanks and Windows line ends */
    struct wf_import_options m = none;
    m.length_unit = 1, m.diameter_unit = 0.001;
    graph_is_tree("TOPO\t\tDiameter\tZZ\tYY\tXX",
                  "/P1\r\n^/A1/N1\t\t240\t0\t0\t0\r\n^<N2<<N9\t\t220\t1.5\t0\t0\r\n"
                  "^<N10 \t\t180\t3 \t0\t0.02\r\n\t+N40\t60\t3.8\t0.1\t0.9\r\n^<N50\t\t80\t6\t0.02\t0.03\r\n",
                  m);
    graph_is_tree(
        "ENTITY-CODE\t\t\tXX\tYY\tZZ\tDiameter",
        "/P1\n^/A1/N1\t\t\t0\t0\t0\t24\n^<N2<<N9# a note\t\t\t0\t0\t150\t22\n^<N10\t\t\t2\t0\t300\t18\n"
        "\t+N40\t\t90\t10\t380\t6\n^<N50\t\t\t3\t2\t600\t8\n",
        none);
}

static void branching_and_shared_ranges(void **state)
{
    (void)state;
    struct imported t;
    /* ++: each entity branches from the one before, so the last is three orders above the first */
    import_graph(&t, NAMES, BASE "^<N2\t\t0\t0\t150\t22\n\t+N3++N5\t90\t0\t200\t6\n^<N9\t\t0\t0\t300\t18\n",
                 none);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, 3);
    assert_int_equal(t.qsm.order[1], 3);
    assert_int_equal(t.qsm.parent[1], 0);
    assert_close(t.qsm.r0[1], 0.03, 1e-12);
    wf_arena_free(&t.arena);
    /* <.<: all have the features of the line, here the same point, so only the first has a length */
    import_graph(&t, NAMES, BASE "^<N2<.<N5\t\t0\t0\t150\t22\n^<N9\t\t0\t0\t300\t18\n", none);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, 2);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_ZERO_LENGTH], 4);
    assert_close(t.qsm.r1[0], 0.11, 1e-12);
    wf_arena_free(&t.arena);
}

static void impossible_ranges_are_left_out(void **state)
{
    (void)state;
    static const char *const codes[][2] = {
        { "^<N9<<N2", "a range counts upwards" },    { "^<N<<N2", "needs a number on both sides" },
        { "^<<N9", "needs a number on both sides" }, { "^<N2<<N999999999", "more than 10000 entities" },
        { "^<N2<<A9", "not of one scale" },          { "^<N2<<Q9", "not of a class" },
        { "^*N2", "starts with '/', '<' or '+'" },
    };
    for (size_t k = 0; k < sizeof codes / sizeof *codes; k++) {
        struct imported t;
        char lines[512];
        bool found = false;
        snprintf(lines, sizeof lines,
                 "/P1\n^/A1/"
                 "N1\t\t0\t0\t0\t24\n^<N2\t\t0\t0\t100\t23\n^<N3\t\t0\t0\t150\t22\n\t+N7\t50\t0\t200\t5\n"
                 "%s\t\t0\t0\t200\t22\n^<N8\t\t0\t0\t300\t20\n",
                 codes[k][0]);
        import_graph(&t, NAMES, lines, none);
        for (const struct wf_finding *f = t.diag.first; f; f = f->next)
            found = found || strstr(f->text, codes[k][1]);
        if (!found) fail_msg("%s: not '%s'", codes[k][0], codes[k][1]);
        /* what continues it is not joined to something else */
        assert_int_equal(t.qsm.repairs.count[WF_REPAIR_BAD_ROW], 2);
        assert_int_equal(t.status, WF_OK);
        assert_int_equal(t.qsm.n, 3);
        wf_arena_free(&t.arena);
    }
}

static void units_are_said(void **state)
{
    (void)state;
    struct imported t;
    struct wf_import_options cm = none;
    cm.length_unit = 0.01;
    /* diameters and coordinates in metres: taken as centimetres, which is said */
    import_graph(&t, NAMES, "/P1\n^/A1/N1\t\t0\t0\t0\t0.24\n^<N2\t\t0\t0\t6\t0.22\n", none);
    assert_int_equal(t.status, WF_OK);
    assert_close(t.metrics.height, 0.06, 1e-12);
    assert_int_equal(said(&t, "unit-assumed"), 1);
    wf_arena_free(&t.arena);
    /* a radius: PlantScan3D's metres, unless the unit is named or no tree is so high */
    import_graph(&t, "TOPO\t\tXX\tYY\tZZ\tradius", "/P1\n^/A1/N1\t\t0\t0\t0\t12\n^<N2\t\t0\t0\t600\t11\n",
                 none);
    assert_close(t.metrics.height, 6, 1e-12);
    assert_close(t.metrics.base_diameter, 0.24, 1e-12);
    assert_int_equal(said(&t, "unit-assumed"), 0);
    wf_arena_free(&t.arena);
    import_graph(&t, "TOPO\t\tXX\tYY\tZZ\tradius", "/P1\n^/A1/N1\t\t0\t0\t0\t1.2\n^<N2\t\t0\t0\t60\t1.1\n",
                 cm);
    assert_close(t.metrics.height, 0.6, 1e-12);
    assert_close(t.metrics.base_diameter, 0.024, 1e-12);
    assert_int_equal(said(&t, "unit-assumed"), 0);
    wf_arena_free(&t.arena);
    static const struct row rows[] = {
        { "$W tree info " PUBLIC "mtg_metres.mtg",
          0,
          { "unit-assumed", "taken as metres", "height              6.000 m" } },
        { "$W tree info " PUBLIC "mtg_topo.mtg --length-unit mm", 0, { "height              0.600 m" } },
        { "sed s/FORM-A/FORM-B/ " PUBLIC "mtg_topo.mtg > $T/b.mtg; $W tree info $T/b.mtg",
          2,
          { "b.mtg:1: error: FORM-B" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(public_graphs),
        cmocka_unit_test(ranges_are_written_in_several_ways),
        cmocka_unit_test(branching_and_shared_ranges),
        cmocka_unit_test(impossible_ranges_are_left_out),
        cmocka_unit_test(units_are_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
