/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every format a tree may come in, read from small files written by hand. */
#include "close.h"
#include "data/species.h"
#include "imported.h"

#define DATA "tests/data/qsm/"

/* Stem 1 m and 0.5 m, a branch of 0.5 m at 1 m: the tree in most of the files. */
static void assert_small_tree(struct imported *t)
{
    assert_int_equal(t->status, WF_OK);
    assert_sound(&t->qsm);
    assert_int_equal(t->qsm.n, 3);
    assert_int_equal(t->metrics.branches, 2);
    assert_int_equal(t->metrics.tips, 2);
    assert_int_equal(t->metrics.highest_order, 1);
    assert_close(t->metrics.height, 1.5, 1e-12);
    assert_close(t->metrics.volume, M_PI * (0.05 * 0.05 + 0.04 * 0.04 * 0.5 + 0.02 * 0.02 * 0.5), 1e-12);
    assert_close(t->metrics.dbh, 0.08, 1e-12);
    assert_close(t->qsm.x0[0], 0.0, 1e-15);
    assert_close(t->qsm.z1[2], 1.4, 1e-12);
    assert_close(t->qsm.x1[2], 0.3, 1e-12);
}

static void treeqsm_layouts_are_told_apart(void **state)
{
    (void)state;
    static const char *const files[] = { DATA "treeqsm_archi.txt", DATA "treeqsm_23.txt",
                                         DATA "treeqsm_24.txt", DATA "treeqsm_comma.txt" };
    for (size_t k = 0; k < 4; k++) {
        struct imported t;
        import_path(&t, files[k]);
        assert_small_tree(&t);
        assert_string_equal(t.qsm.format, "TreeQSM text");
        assert_int_equal(t.qsm.added[2], 1);
        assert_int_equal(t.qsm.repairs.count[WF_NOTE_OFFSET], 1);
        assert_close(t.qsm.base[1], 19.0, 1e-15);
        assert_int_equal(t.qsm.repairs.count[WF_NOTE_DECIMAL_COMMA], k == 3);
        assert_int_equal(t.qsm.repairs.count[WF_NOTE_CRLF], k == 0);
        wf_arena_free(&t.arena);
    }
}

static void simpleforest_counts_from_zero(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "simpleforest.csv");
    assert_small_tree(&t);
    assert_string_equal(t.qsm.format, "SimpleForest CSV");
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_HEADER], 17);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_ROOT_MARK], 1);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_FROM_ZERO], 3);
    assert_int_equal(t.qsm.parent[1], 0);
    assert_int_equal(t.qsm.id[0], 0);
    wf_arena_free(&t.arena);
}

static void archi_stem_is_order_one_and_extension_may_leave_it(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "archi.csv");
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    assert_string_equal(t.qsm.format, "aRchi CSV");
    assert_int_equal(t.qsm.order[0], 0);
    assert_int_equal(t.qsm.order[2], 1);
    assert_int_equal(t.qsm.next[0], 1);
    assert_int_equal(t.qsm.next[1], -1);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_ORDER_FROM], 3);
    wf_arena_free(&t.arena);
}

static void rtwig_and_plain(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "rtwig.csv");
    assert_int_equal(t.status, WF_OK);
    assert_string_equal(t.qsm.format, "rTwig CSV");
    assert_close(t.metrics.volume, M_PI * (0.05 * 0.05 + 0.02 * 0.02 * 0.5), 1e-12);
    wf_arena_free(&t.arena);
    import_path(&t, DATA "plain.csv");
    assert_int_equal(t.status, WF_OK);
    assert_string_equal(t.qsm.format, "plain CSV of segments");
    assert_close(t.qsm.r1[1], 0.03, 1e-15);
    assert_close(t.metrics.dbh, 2 * (0.04 - 0.3 * 0.01), 1e-12);
    for (int k = 0; k < WF_REPAIR_COUNT; k++) assert_int_equal(t.qsm.repairs.count[k], 0);
    wf_arena_free(&t.arena);
}

static void normalised_axis_and_offset(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "normalised.csv");
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    assert_string_equal(t.qsm.format, "normalised CSV");
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_AXIS], 1);
    assert_int_equal(t.qsm.repairs.first[WF_REPAIR_AXIS], 1);
    assert_close(t.qsm.z1[0], 1.0, 1e-12); /* the axis was twice too long, the length column is right */
    assert_close(t.metrics.height, 4.0, 1e-12);
    wf_arena_free(&t.arena);
}

static void hand_measured_table_is_placed(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "hand.csv");
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    assert_string_equal(t.qsm.format, "hand-measured table");
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_BOM], 1);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_DECIMAL_COMMA], 1);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_AZIMUTH], 1);
    assert_close(t.metrics.height, 3.0, 1e-12);
    assert_close(t.qsm.r0[0], 0.05, 1e-12);
    /* branch 3: at 1.5 m of the stem, 60 degrees from it, towards +y */
    assert_close(t.qsm.z0[2], 1.5, 1e-12);
    assert_close(t.qsm.y1[2], sin(M_PI / 3), 1e-12);
    assert_close(t.qsm.z1[2], 2.0, 1e-12);
    assert_close(t.qsm.x1[2], 0.0, 1e-12);
    /* branch 4: 30 degrees from branch 3 */
    double dot = (t.qsm.y1[3] - t.qsm.y0[3]) * sin(M_PI / 3) + (t.qsm.z1[3] - t.qsm.z0[3]) * cos(M_PI / 3);
    assert_close(dot, 0.5 * cos(M_PI / 6), 1e-12);
    assert_int_equal(t.qsm.order[2], 1);
    wf_arena_free(&t.arena);
}

static void mtg_scales_edges_and_units(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "walnut.mtg");
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    const struct wf_qsm *q = &t.qsm;
    assert_string_equal(q->format, "OpenAlea MTG");
    assert_int_equal(q->n, 4);
    assert_int_equal(q->repairs.count[WF_REPAIR_ZERO_LENGTH], 1);
    assert_int_equal(q->repairs.count[WF_NOTE_UNITS], 1);
    /* S1: from the axis' own point to S1's, 30 to 25 mm radius */
    assert_close(q->z1[0], 1.0, 1e-12);
    assert_close(q->r0[0], 0.03, 1e-12);
    assert_close(q->r1[0], 0.025, 1e-12);
    /* the branch: its first part has no length, so S2 hangs on the stem's S1 and starts where the axis does
     */
    assert_int_equal(q->parent[1], 0);
    assert_int_equal(q->order[1], 1);
    assert_close(q->x0[1], 0.05, 1e-12);
    assert_close(q->z0[1], 0.9, 1e-12);
    assert_close(q->z1[1], 1.3, 1e-12);
    /* the stem goes on */
    assert_int_equal(q->next[0], 2);
    assert_int_equal(q->order[2], 0);
    assert_close(q->r0[2], 0.025, 1e-12);
    /* and carries the third axis, written one column further right */
    assert_int_equal(q->parent[3], 2);
    assert_int_equal(q->order[3], 1);
    assert_close(t.metrics.height, 2.8, 1e-12);
    wf_arena_free(&t.arena);
}

static void a_format_may_be_named(void **state)
{
    (void)state;
    struct imported t;
    struct wf_import_options o = wf_import_default();
    o.format = "simplforest";
    import_with(&t, DATA "simpleforest.csv", o);
    assert_int_equal(t.status, WF_EUSAGE);
    assert_non_null(strstr(t.err.text, "did you mean 'simpleforest'?"));
    wf_arena_free(&t.arena);
    o.format = "treeqsm";
    import_with(&t, DATA "treeqsm_23.txt", o);
    assert_small_tree(&t);
    wf_arena_free(&t.arena);
}

static void units_may_be_named(void **state)
{
    (void)state;
    struct imported t;
    struct wf_import_options o = wf_import_default();
    o.length_unit = 0.01, o.diameter_unit = 0.001;
    import_with(&t, DATA "plain.csv", o);
    assert_int_equal(t.status, WF_OK);
    assert_close(t.metrics.height, 0.02, 1e-12);
    assert_close(t.metrics.base_diameter, 1e-4, 1e-12);
    wf_arena_free(&t.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(treeqsm_layouts_are_told_apart),
        cmocka_unit_test(simpleforest_counts_from_zero),
        cmocka_unit_test(archi_stem_is_order_one_and_extension_may_leave_it),
        cmocka_unit_test(rtwig_and_plain),
        cmocka_unit_test(normalised_axis_and_offset),
        cmocka_unit_test(hand_measured_table_is_placed),
        cmocka_unit_test(mtg_scales_edges_and_units),
        cmocka_unit_test(a_format_may_be_named),
        cmocka_unit_test(units_may_be_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
