/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees as nodes with their parents: tables, raycloudtools, SWC, treegraph. */
#include "close.h"
#include "data/species.h"
#include "imported.h"
#include "shell.h"

#define PUBLIC "tests/data/public/"
static const struct wf_import_options none = { .length_unit = NAN, .diameter_unit = NAN };

/* The tree of the public samples: a stem of three pieces, and a branch at 3 m. */
static const double WOOD = M_PI * (0.11 * 0.11 * 1.5 + 0.09 * 0.09 * 1.5001333274 +
                                   0.03 * 0.03 * 1.1934822998 + 0.04 * 0.04 * 3.0000833322);

static void assert_tree(struct imported *t, const char *format)
{
    if (t->status) fail_msg("%s", t->err.text);
    assert_sound(&t->qsm);
    assert_string_equal(t->qsm.format, format);
    assert_int_equal(t->qsm.n, 4);
    assert_close(t->metrics.height, 6, 1e-9);
    assert_close(t->metrics.volume, WOOD, 1e-9);
    assert_close(t->metrics.base_diameter, 0.22, 1e-9); /* of node 1: the root's radius is not used */
    assert_int_equal(t->metrics.branches, 2);
    for (int k = WF_REPAIR_BAD_ROW; k < WF_REPAIR_COUNT; k++) assert_int_equal(t->qsm.repairs.count[k], 0);
    wf_arena_free(&t->arena);
}

static void text_is_tree(const char *text, struct wf_import_options o, const char *format)
{
    struct imported t;
    struct scratch s;
    scratch_write(&s, text, strlen(text));
    import_with(&t, s.path, o);
    scratch_remove(&s);
    assert_tree(&t, format);
}

static void text_is_refused(const char *text, struct wf_import_options o, const char *words)
{
    struct imported t;
    struct scratch s;
    scratch_write(&s, text, strlen(text));
    import_with(&t, s.path, o);
    scratch_remove(&s);
    assert_int_equal(t.status, WF_EINPUT);
    if (!strstr(t.err.text, words)) fail_msg("'%s' is not in: %s", words, t.err.text);
    wf_arena_free(&t.arena);
}

static void a_row_is_a_node(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, PUBLIC "nodes_parent.csv");
    assert_tree(&t, "table of nodes");
    /* another unit, by the names */
    text_is_tree("node_id,parent_node_id,x_cm,y_cm,z_cm,diameter (mm)\n0,,0,0,0,240\n1,0,0,0,150,220\n"
                 "2,1,2,0,300,180\n3,2,90,10,380,60\n4,2,3,2,600,80\n",
                 none, "table of nodes");
    /* semicolons and decimal commas */
    text_is_tree("node_id;parent_node_id;x;y;z;radius\n0;;0;0;0;0,12\n1;0;0;0;1,5;0,11\n2;1;0,02;0;3;0,09\n"
                 "3;2;0,9;0,1;3,8;0,03\n4;2;0,03;0,02;6;0,04\n",
                 none, "table of nodes");
    /* columns and rows in another order, ids from 1 */
    text_is_tree("radius,z,y,x,parent,id\n0.04,6,0.02,0.03,3,5\n0.03,3.8,0.1,0.9,3,4\n0.09,3,0,0.02,2,3\n"
                 "0.11,1.5,0,0,1,2\n0.12,0,0,0,0,1\n",
                 none, "table of nodes");
    /* without ids rows count from 0 when the root's parent is -1 */
    text_is_tree("x,y,z,radius,parent\n0,0,0,0.12,-1\n0,0,1.5,0.11,0\n0.02,0,3,0.09,1\n0.9,0.1,3.8,0.03,2\n"
                 "0.03,0.02,6,0.04,2\n",
                 none, "table of nodes");
}

static void a_line_is_a_tree(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, PUBLIC "ray_trees.txt");
    assert_tree(&t, "raycloudtools trees");
    text_is_tree(
        "x_cm,y_cm,z_cm,radius_mm,parent_id\n0,0,0,120,-1, 0,0,150,110,0, 2,0,300,90,1, 90,10,380,30,2, "
        "3,2,600,40,2\n",
        none, "raycloudtools trees");
    text_is_tree(
        "x;y;z;radius;parent_id\n0;0;0;0,12;-1; 0;0;1,5;0,11;0; 0,02;0;3;0,09;1; 0,9;0,1;3,8;0,03;2; "
        "0,03;0,02;6;0,04;2\n",
        none, "raycloudtools trees");
    text_is_tree(
        "parent_id,radius,z,y,x\n-1,0.12,0,0,0, 0,0.11,1.5,0,0, 1,0.09,3,0,0.02, 2,0.03,3.8,0.1,0.9, "
        "2,0.04,6,0.02,0.03\n",
        none, "raycloudtools trees");
    /* attributes of the tree before those of the nodes */
    text_is_tree("# Tree file\nheight,crown_radius, x,y,z,radius,parent_id,red\n6,1, 0,0,0,0.12,-1,9, "
                 "0,0,1.5,0.11,0,9, 0.02,0,3,0.09,1,9, 0.9,0.1,3.8,0.03,2,9, 0.03,0.02,6,0.04,2,9\n",
                 none, "raycloudtools trees");
}

#define SECOND "10,0,0,0.12,-1, 10,0,2,0.1,0\n"
#define TREE "0,0,0,0.12,-1, 0,0,1.5,0.11,0, 0.02,0,3,0.09,1, 0.9,0.1,3.8,0.03,2, 0.03,0.02,6,0.04,2\n"

static void one_tree_of_several_is_chosen(void **state)
{
    (void)state;
    struct wf_import_options o = none;
    const char *const two = "x,y,z,radius,parent_id\n" SECOND TREE;
    text_is_refused(two, o, "2 trees in one file");
    o.tree_id = "3";
    text_is_refused(two, o, "--tree-id: '3'");
    o.tree_id = "2x";
    text_is_refused(two, o, "--tree-id: '2x'");
    o.tree_id = "2";
    text_is_tree(two, o, "raycloudtools trees");
    text_is_refused("x0,y0,z0,x1,y1,z1,radius0,radius1,parent\n0,0,0,0,0,1,0.1,0.1,0\n", o, "no column treeID");
    text_is_refused("x,y,z,radius\n0,0,0,0.2\n1,0,0,0.4\n", none, "no tree structure");
    text_is_refused("x,y,z,radius,parent_id\n0,0,0,0.12,-1, 0,0,1.5,0.11\n", none, "9 numbers");
    text_is_refused("x,y,z,radius,parent_id\n0,0,0,0.12,-1, 0,0,a?,0.11,0\n", none, "not a number");
}

/* SWC after the specification of INCF: id, kind, x, y, z, radius, parent. */
static void swc_needs_its_unit(void **state)
{
    (void)state;
    struct wf_import_options o = none;
    const char *const metres = "# a comment\n1 1 0 0 0 0.12 -1\n2 3 0 0 1.5 0.11 1\n3 3 0.02 0 3 0.09 2\n"
                               "4 3 0.9 0.1 3.8 0.03 3\n5 3 0.03 0.02 6 0.04 3\n";
    text_is_refused(metres, o, "--length-unit");
    o.length_unit = 1;
    text_is_tree(metres, o, "SWC nodes");
    o.length_unit = 0.01;
    text_is_tree("1 1 0 0 0 12 -1\n2 3 0 0 150 11 1\n3 3 2 0 300 9 2\n4 3 90 10 380 3 3\n5 3 3 2 600 4 3\n",
                 o, "SWC nodes");
    o.length_unit = 1, o.diameter_unit = 0.01;
    text_is_tree("7\t1\t0\t0\t0\t12\t-1\n5\t3\t0.9\t0.1\t3.8\t3\t4\n6\t3\t0.03\t0.02\t6\t4\t4\n4\t3\t0."
                 "02\t0\t3\t9\t3\n"
                 "3\t3\t0\t0\t1.5\t11\t7\n",
                 o, "SWC nodes");
}

/* A file of treegraph: texts of JSON in JSON, tables by columns; a cylinder leads from p1 down to p2. */
#define JSON(s)                                                                                              \
    "{\"name\": \"tree\", \"tree\": \"{}\", \"cyls\": \"{"                                                   \
    "\\\"p1\\\":{\\\"0\\\":11,\\\"1\\\":12,\\\"2\\\":13,\\\"4\\\":14},"                                      \
    "\\\"p2\\\":{\\\"0\\\":10.0,\\\"1\\\":11.0,\\\"2\\\":12.0,\\\"4\\\":12.0},"                              \
    "\\\"sx\\\":{\\\"0\\\":0,\\\"1\\\":0.02,\\\"2\\\":0.9,\\\"4\\\":0.03},"                                  \
    "\\\"sy\\\":{\\\"0\\\":0,\\\"1\\\":0,\\\"2\\\":0.1,\\\"4\\\":0.02},"                                     \
    "\\\"sz\\\":{\\\"0\\\":1.5,\\\"1\\\":3,\\\"2\\\":3.8,\\\"4\\\":6},"                                      \
    "\\\"ax\\\":{\\\"0\\\":0,\\\"1\\\":" s                                                                   \
    "0.01333214834,\\\"2\\\":-0.737338167,\\\"4\\\":-0.003333240744},"                                       \
    "\\\"ay\\\":{\\\"0\\\":0,\\\"1\\\":0,\\\"2\\\":-0.083788428,\\\"4\\\":-0.006666481488},"                 \
    "\\\"az\\\":{\\\"0\\\":-1,\\\"1\\\":-0.9999111235,\\\"2\\\":-0.6703074244,\\\"4\\\":-0.9999722231},"     \
    "\\\"radius\\\":{\\\"0\\\":0.11,\\\"1\\\":0.09,\\\"2\\\":0.03,\\\"4\\\":0.04},"                          \
    "\\\"length\\\":{\\\"0\\\":1.5,\\\"1\\\":1.5001333274,\\\"2\\\":1.1934822998,\\\"4\\\":3.0000833322},"   \
    "\\\"branch_order\\\":{\\\"0\\\":1,\\\"1\\\":1,\\\"2\\\":2,\\\"4\\\":1}}\"}"

static void treegraph_cylinders_lead_down(void **state)
{
    (void)state;
    struct imported t;
    import_text(&t, JSON("-"), strlen(JSON("-")));
    if (t.status) fail_msg("%s", t.err.text);
    assert_string_equal(t.qsm.format, "treegraph JSON");
    assert_int_equal(t.qsm.n, 4);
    assert_close(t.metrics.height, 6, 1e-8);
    assert_close(t.metrics.volume, WOOD, 1e-8);
    assert_int_equal(t.qsm.order[2], 1);
    assert_int_equal(t.qsm.order[3], 0);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_LENGTH], 0);
    wf_arena_free(&t.arena);
    text_is_refused("{\"name\": \"tree\"}", none, "without a table cyls");
    text_is_refused("{\"name\": ", none, "not JSON");
    text_is_refused("{\"cyls\": \"{\\\"p1\\\":{\\\"0\\\":1}}\"}", none, "no column p2");
    text_is_refused(
        "{\"cyls\": {\"p1\":{\"0\":1,\"1\":2},\"p2\":{\"0\":0,\"1\":1},\"sx\":{\"0\":0,\"1\":0},"
        "\"sy\":{\"0\":0,\"1\":0},\"sz\":{\"0\":0,\"1\":1},\"ax\":{\"0\":0,\"1\":0},\"ay\":{\"0\":0,"
        "\"1\":0},\"az\":{\"0\":1,\"1\":1},\"length\":{\"0\":1,\"1\":1},\"radius\":{\"0\":0.1,\"1\":0.1}}}",
        none, "do not lead");
}

static void what_cannot_be_placed_is_left_out(void **state)
{
    (void)state;
    struct imported t;
    static const char text[] =
        "id,parent,x,y,z,radius\n1,,0,0,0,0.1\n2,1,0,0,1,0.1\n3,9,0,0,2,0.1\n2,1,0,0,1.2,0.1\n"
        "4,4,0,0,2,0.1\n5,2,0,0,NA,0.1\n6,2,0,0,2,NA\n7,2,0,1,2,0.05\n8,7,0,1,3,0.05\n";
    import_text(&t, text, sizeof text - 1);
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    assert_int_equal(t.qsm.n, 4);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_BAD_ROW], 4);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_RADIUS], 1);
    wf_arena_free(&t.arena);
}

/* PypeTree's own sample has y upwards: the tree lies on its side, which is said. */
static void an_axis_that_is_not_up_is_said(void **state)
{
    (void)state;
    struct imported t;
    static const char text[] = "node_id,parent_node_id,x,y,z,radius\n0,,0,0,0,0.1\n1,0,0,1.25,0,0.07\n"
                               "2,1,0,2,-0.45,0.05\n3,2,0,2.4,-1,0.04\n4,1,0,2,0.4,0.04\n";
    import_text(&t, text, sizeof text - 1);
    assert_int_equal(t.status, WF_OK);
    size_t said = 0;
    for (const struct wf_finding *f = t.diag.first; f; f = f->next)
        said += !strcmp(f->code, "root-not-lowest");
    assert_int_equal(said, 1);
    wf_arena_free(&t.arena);
}

static void the_program_lists_several_trees(void **state)
{
    (void)state;
#define FILE_OF_TWO "printf 'x,y,z,radius,parent_id\\n" SECOND_ "" TREE_ "' > $T/f.txt; "
#define SECOND_ "10,0,0,0.12,-1, 10,0,2,0.1,0\\n"
#define TREE_ "0,0,0,0.12,-1, 0,0,1.5,0.11,0, 0.02,0,6,0.09,1\\n"
    static const struct row rows[] = {
        { FILE_OF_TWO "$W tree info $T/f.txt",
          0,
          { "f.txt: 2 trees", "2.000     0.2000    0.0628319", "10, 0, 0" } },
        { FILE_OF_TWO "$W tree info --csv $T/f.txt | cut -d, -f1,2,3,8",
          0,
          { "f.txt#1\",raycloudtools trees,1,2" } },
        { FILE_OF_TWO "$W tree info $T/f.txt --tree-id 2", 0, { "height              6.000 m" } },
        { FILE_OF_TWO "$W import $T/f.txt", 2, { "choose one by --tree-id 1 to 2" } },
        { FILE_OF_TWO "$W import $T/f.txt --tree-id 1", 0, { "1 cylinders" } },
        { FILE_OF_TWO "$W analyze oak --tree $T/f.txt --tree-id 9 --wind 10", 2, { "the file has 2 trees" } },
        { "$W analyze oak --model models/culm.yaml --tree-id 1 --wind 10", 2, { "--tree" } },
        { "printf 'x,y,z,radius,parent_id\\n1,2\\n" TREE_ "' > $T/f.txt; $W tree info $T/f.txt",
          2,
          { "tree 1: ", "2 numbers", "1 of 2 could not be read", "6.000" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_row_is_a_node),
        cmocka_unit_test(a_line_is_a_tree),
        cmocka_unit_test(one_tree_of_several_is_chosen),
        cmocka_unit_test(swc_needs_its_unit),
        cmocka_unit_test(treegraph_cylinders_lead_down),
        cmocka_unit_test(what_cannot_be_placed_is_left_out),
        cmocka_unit_test(an_axis_that_is_not_up_is_said),
        cmocka_unit_test(the_program_lists_several_trees),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
