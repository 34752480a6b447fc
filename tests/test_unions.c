/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Unions of branches and forks: aspect ratios of trees whose diameters are known, and what the program
 * prints. */
#include "close.h"
#include "shell.h"
#include "study/unions.h"

/* A row on its parent's end, straight up. */
static void grow(struct wf_tree *t, int32_t i, int32_t parent, double length, double d0, double d1)
{
    t->parent[i] = parent;
    t->z0[i] = parent < 0 ? 0 : t->z1[parent], t->z1[i] = t->z0[i] + length;
    t->r0[i] = 0.5 * d0, t->r1[i] = 0.5 * d1, t->density[i] = 900;
}

/* A stem that forks at 2 m, a limb thicker than the rest of the limb it leaves, a whorl of three, a twig. */
static void plant(struct wf_tree *t, struct wf_arena *a)
{
    struct wf_err e;
    assert_int_equal(wf_tree_alloc(t, 9, a, &e), WF_OK);
    grow(t, 0, -1, 2, 0.50, 0.40);
    grow(t, 1, 0, 3, 0.30, 0.20); /* thicker of the fork, though drawn as a branch */
    grow(t, 2, 0, 3, 0.25, 0.20);
    t->level[1] = 1;
    grow(t, 3, 1, 1, 0.18, 0.10); /* continues */
    grow(t, 4, 1, 1, 0.09, 0.05); /* of a whorl: 0.50 */
    grow(t, 5, 1, 1, 0.12, 0.05); /* 0.667 */
    grow(t, 6, 2, 1, 0.20, 0.10); /* alone: no union */
    grow(t, 7, 6, 1, 0.09, 0.05); /* of equals the lower level continues */
    grow(t, 8, 6, 1, 0.09, 0.05);
    t->level[4] = t->level[5] = 2, t->level[7] = 1;
}

static void fork_of_known_diameters(void **state)
{
    static const struct {
        int32_t branch, above, below;
        double height, d, beside, under, ratio;
        const char *kind;
    } want[] = {
        { 7, 8, 6, 6, 0.09, 0.09, 0.10, 1, "codominant" },
        { 2, 1, 0, 2, 0.25, 0.30, 0.40, 0.25 / 0.30, "codominant" },
        { 5, 3, 1, 5, 0.12, 0.18, 0.20, 0.12 / 0.18, "above-wanted" },
        { 4, 3, 1, 5, 0.09, 0.18, 0.20, 0.5, "subordinate" },
    };
    enum { N = sizeof want / sizeof *want };
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_unions u;
    struct wf_err e;
    (void)state;
    plant(&t, &a);
    assert_int_equal(wf_unions_list(&t, 0.05, &a, &u, &e), WF_OK);
    assert_int_equal(u.n, N);
    for (size_t k = 0; k < N; k++) {
        const struct wf_union *x = &u.item[k];
        assert_int_equal(x->branch, want[k].branch);
        assert_int_equal(x->above, want[k].above);
        assert_int_equal(x->below, want[k].below);
        assert_close(x->height, want[k].height, 1e-14);
        assert_close(x->branch_diameter, want[k].d, 1e-14);
        assert_close(x->above_diameter, want[k].beside, 1e-14);
        assert_close(x->below_diameter, want[k].under, 1e-14);
        assert_close(x->ratio, want[k].ratio, 1e-14);
        assert_string_equal(x->in->name, want[k].kind);
    }
    assert_int_equal(wf_unions_of(&u, &wf_union_classes[0]), 1);
    assert_int_equal(wf_unions_of(&u, &wf_union_classes[2]), 0);
    assert_int_equal(wf_unions_of(&u, &wf_union_classes[3]), 2);
    assert_int_equal(wf_unions_list(&t, 0.1, &a, &u, &e), WF_OK); /* by the branch's own diameter */
    assert_int_equal(u.n, 2);
    wf_arena_free(&a);
}

/* A link has the radius of the parent, in whose wood it lies: the wood beyond it counts, and that before it.
 */
static void wood_beyond_links(void **state)
{
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_unions u;
    struct wf_err e;
    (void)state;
    assert_int_equal(wf_tree_alloc(&t, 7, &a, &e), WF_OK);
    grow(&t, 0, -1, 4, 0.50, 0.40);
    grow(&t, 1, 0, 0.2, 0.40, 0.40); /* a link, as thick as the stem, before the stem's own row */
    grow(&t, 2, 0, 3, 0.38, 0.20);
    grow(&t, 3, 1, 2, 0.19, 0.10);   /* the limb */
    grow(&t, 4, 1, 0.2, 0.19, 0.19); /* a second link at the end of the first */
    grow(&t, 5, 4, 1, 0.095, 0.05);
    grow(&t, 6, 0, 0.1, 0.40, 0.40); /* a link to nothing */
    t.level[1] = t.level[3] = 1, t.level[4] = t.level[5] = t.level[6] = 2;
    t.density[1] = t.density[4] = t.density[6] = 0;
    assert_int_equal(wf_unions_list(&t, 0.05, &a, &u, &e), WF_OK);
    assert_int_equal(u.n, 2);
    for (size_t k = 0; k < u.n; k++) assert_close(u.item[k].ratio, 0.5, 1e-14);
    assert_int_equal(u.item[0].branch, 3);
    assert_int_equal(u.item[0].above, 2);
    assert_int_equal(u.item[1].branch, 5);
    assert_int_equal(u.item[1].above, 3);
    assert_int_equal(u.item[1].below, 0);
    assert_close(u.item[1].below_diameter, 0.40, 1e-14);
    assert_close(u.item[1].height, 4.2, 1e-14);
    wf_arena_free(&a);
}

/* The class changes at its limit, not below. */
static void limits_of_classes(void **state)
{
    static const struct {
        double ratio;
        const char *kind;
    } want[] = {
        { 0.599, "subordinate" },
        { 0.6001, "above-wanted" },
        { 0.699, "above-wanted" },
        { 0.7001, "codominant-with-included-bark" },
        { 0.829, "codominant-with-included-bark" },
        { 0.8301, "codominant" },
        { 1, "codominant" },
    };
    (void)state;
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        struct wf_arena a = { 0 };
        struct wf_tree t;
        struct wf_unions u;
        struct wf_err e;
        assert_int_equal(wf_tree_alloc(&t, 3, &a, &e), WF_OK);
        grow(&t, 0, -1, 1, 1, 1);
        grow(&t, 1, 0, 1, 1, 1);
        grow(&t, 2, 0, 1, want[k].ratio, 0.1);
        t.level[2] = 1;
        assert_int_equal(wf_unions_list(&t, 0.05, &a, &u, &e), WF_OK);
        assert_int_equal(u.n, 1);
        assert_string_equal(u.item[0].in->name, want[k].kind);
        wf_arena_free(&a);
    }
}

/* Stems that part at the ground: a union where they touch. */
static void stems_on_the_ground(void **state)
{
    (void)state;
    for (int apart = 0; apart < 2; apart++) {
        struct wf_arena a = { 0 };
        struct wf_tree t;
        struct wf_unions u;
        struct wf_err e;
        assert_int_equal(wf_tree_alloc(&t, 2, &a, &e), WF_OK);
        grow(&t, 0, -1, 5, 0.3, 0.1);
        grow(&t, 1, -1, 5, 0.2, 0.1);
        t.x0[1] = t.x1[1] = apart ? 0.26 : 0.24;
        assert_int_equal(wf_unions_list(&t, 0.05, &a, &u, &e), WF_OK);
        assert_int_equal(u.n, apart ? 0 : 1);
        if (!apart) {
            assert_int_equal(u.item[0].below, -1);
            assert_true(isnan(u.item[0].below_diameter));
            assert_close(u.item[0].ratio, 2.0 / 3, 1e-14);
        }
        wf_arena_free(&a);
    }
}

#define LIMBS                                                                                                \
    "$W analyze species/norway_spruce.yaml --model tests/data/limbs.yaml --wind 5 --samples 0 --no-report "  \
    "-o $T/out "
#define FORK                                                                                                 \
    "printf 'id,parent,x0,y0,z0,x1,y1,z1,radius0,radius1,level\\n1,0,0,0,0,0,0,3,0.2,0.18,0\\n"              \
    "2,1,0,0,3,1,0,7,0.15,0.1,0\\n3,1,0,0,3,-1,0,7,0.12,0.08,1\\n' >$T/fork.csv; "

static void printed(void **state)
{
    static const struct row rows[] = {
        /* 24 cm beside 30 cm */
        { FORK "$W analyze ash --tree $T/fork.csv --leaf-area 20 --wind 5 --samples 0 "
               "--no-report --unions -o "
               "$T/out; cut -d, -f3- $T/out/tables/unions.csv",
          CODE_OK,
          { "forks: 1: 0 codominant, with or without included bark, 1 codominant where bark is included",
            "3.00      24.0      30.0      36.0      0.80   codominant where bark is included (id 3 beside "
            "2)",
            "strength of unions not assessed: no sourced factor by aspect ratio",
            "\n3,2,1,1,3,240,300,360,0.8,codominant-with-included-bark\n" } },
        /* held at the stem's surface, so that a link of 37.3 cm joins it to the axis */
        { "printf 'id,parent,x0,y0,z0,x1,y1,z1,radius0,radius1,level\\n1,0,0,0,0,0,0,3,0.2,0.18,0\\n"
          "2,1,0,0,3,0,0,7,0.18,0.1,0\\n3,1,0.18667,0,2,2,0,4,0.08,0.06,1\\n' >$T/limb.csv; $W analyze ash "
          "--tree "
          "$T/limb.csv --leaf-area 20 --wind 5 --samples 0 --no-report --unions -o $T/out",
          CODE_OK,
          { "forks: 1: ",
            "2.00      16.0      37.3      37.3      0.43   below 0.60, as is wanted (id 3 beside 1)" } },
        { "$W analyze ash $RUN --unions --samples 0; cat $T/out/tables/unions.csv",
          CODE_OK,
          { "Unions of branches from 5 cm and forks: 0; none is drawn", "strength of unions not assessed",
            "aspect_ratio,class\n" } },
        { LIMBS
          "--unions --branches-from 1cm; cat $T/out/tables/unions.csv", /* radius 12 mm on a linear taper */
          CODE_OK,
          { "forks: 3:", "14,7,6,1,4.5,24,33.3,33.3,0.7207207207,codominant-with-included-bark" } },
        { "printf 'study: forks\\nunions: yes\\n' >$T/s.yaml; " LIMBS "--study $T/s.yaml",
          CODE_OK,
          { "Unions of branches from 5 cm" } },
        { LIMBS "--unions --branches-from 1cm -q; " LIMBS
                "-q; ls $T/out/tables; grep -c unions $T/out/results.json",
          CODE_RUN, /* grep finds none: the table of the run before is gone */
          { "sweep.csv", "\n0\n" } },
    };
    (void)state;
    check(rows, sizeof rows / sizeof *rows);
    assert_null(strstr(output, "unions.csv"));
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(fork_of_known_diameters),
                                        cmocka_unit_test(wood_beyond_links),
                                        cmocka_unit_test(limits_of_classes),
                                        cmocka_unit_test(stems_on_the_ground), cmocka_unit_test(printed) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
