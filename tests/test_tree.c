/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tree's columns and their check. */
#include "close.h"
#include "data/tree.h"
#include <string.h>

/* Three sound rows: a stem of two and a branch. */
static void sound(struct wf_tree *t, struct wf_arena *a)
{
    struct wf_err e = { 0 };
    assert_int_equal(wf_tree_alloc(t, 3, a, &e), WF_OK);
    t->name = "test";
    for (size_t i = 0; i < 3; i++) {
        t->parent[i] = i == 2 ? 0 : (int32_t)i - 1;
        t->id[i] = 10 * (int64_t)i + 7;
        t->z0[i] = i ? 1 : 0;
        t->z1[i] = i ? 1 : 1;
        t->x1[i] = i ? (i == 1 ? 0.5 : -0.5) : 0;
        t->r0[i] = t->r1[i] = 0.02;
        t->youngs[i] = 1e10;
        t->shear[i] = 6e8;
        t->density[i] = 800;
    }
}

static void columns_start_empty(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_err e = { 0 };
    assert_int_equal(wf_tree_alloc(&t, 5, &a, &e), WF_OK);
    assert_int_equal(t.n, 5);
    assert_null(t.bend);
    assert_null(t.stiff);
    assert_null(t.mass1);
    for (size_t i = 0; i < 5; i++) {
        assert_int_equal(t.parent[i], -1);
        assert_int_equal(t.id[i], i + 1);
        assert_true(isnan(t.drag[i]));
        assert_close(t.burden1[i], 0, 0);
    }
    size_t need = a.used;
    wf_arena_free(&a);
    for (size_t limit = 1; limit < need; limit++) {
        struct wf_arena small = { .limit = limit };
        e = (struct wf_err){ 0 };
        assert_int_equal(wf_tree_alloc(&t, 5, &small, &e), WF_ENOMEM);
        wf_arena_free(&small);
    }
}

static void a_sound_tree_passes(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_tree t;
    sound(&t, &a);
    assert_int_equal(wf_tree_check(&t, &d, &e), WF_OK);
    assert_int_equal(d.errors, 0);
    assert_close(wf_tree_height(&t), 1, 0);
    assert_close(wf_tree_length(&t, 1), 0.5, 0);
    t.z0[0] = -2;
    assert_close(wf_tree_height(&t), 3, 0);
    t.z1[2] = 4;
    assert_close(wf_tree_height(&t), 6, 0);
    t.n = 0;
    assert_int_equal(wf_tree_check(&t, &d, &e), WF_EINPUT);
    assert_string_equal(e.text, "test: the tree has no segments");
    wf_arena_free(&a);
}

/* An arc: chord 2 R sin(angle / 2), length R angle. */
static void the_length_of_an_arc(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    sound(&t, &a);
    t.bend = WF_TAKE(&a, 9, double);
    assert_close(wf_tree_length(&t, 0), 1, 0);
    const double radius = 2, turns[] = { 1e-6, 0.1, 1, 3 };
    for (int k = 0; k < 4; k++) {
        t.z1[0] = 2 * radius * sin(turns[k] / 2);
        t.bend[1] = -1 / radius;
        assert_close(wf_tree_length(&t, 0), radius * turns[k], 1e-12);
    }
    wf_arena_free(&a);
}

enum column {
    PARENT,
    X1,
    Z1,
    R0,
    R1,
    I1,
    YOUNGS,
    SHEAR,
    DENSITY,
    STRENGTH,
    DRAG,
    LIFT,
    DAMPING,
    SAIL,
    LEAF,
    BURDEN,
    BEND,
    STIFF,
    MASS
};

static void spoil(struct wf_tree *t, struct wf_arena *a, enum column c, size_t row, double v)
{
    double *const column[] = { [X1] = t->x1,       [Z1] = t->z1,           [R0] = t->r0,
                               [R1] = t->r1,       [I1] = t->i1,           [YOUNGS] = t->youngs,
                               [SHEAR] = t->shear, [DENSITY] = t->density, [STRENGTH] = t->strength,
                               [DRAG] = t->drag,   [LIFT] = t->lift,       [DAMPING] = t->damping,
                               [SAIL] = t->sail0,  [LEAF] = t->leaf1,      [BURDEN] = t->burden0 };
    if (c == PARENT) {
        t->parent[row] = (int32_t)v;
    } else if (c == BEND) {
        t->bend = WF_TAKE(a, 9, double);
        t->bend[3 * row + 1] = v;
    } else if (c == STIFF) {
        t->stiff = WF_TAKE(a, 12, double);
        for (int k = 0; k < 12; k++) t->stiff[k] = 1;
        t->stiff[4 * row + 2] = v;
    } else if (c == MASS) {
        t->mass1 = WF_TAKE(a, 3, double);
        t->mass1[row] = v;
    } else {
        column[c][row] = v;
    }
}

static const struct {
    enum column c;
    size_t row;
    double v;
    const char *text; /* NULL: allowed */
} rows[] = {
    { PARENT, 1, 1, "test: segment 17: the parent is not an earlier row" },
    { PARENT, 1, 2, "test: segment 17: the parent is not an earlier row" },
    { PARENT, 2, -2, "test: segment 27: the parent is not an earlier row" },
    { PARENT, 2, -1, NULL },
    { X1, 1, 0, "test: segment 17: the segment has no length" },
    { X1, 1, NAN, "test: segment 17: a value is not a finite number" },
    { Z1, 0, INFINITY, "test: segment 7: a value is not a finite number" },
    { R0, 2, 0, "test: segment 27: the outer radius is not positive" },
    { R1, 2, -0.1, "test: segment 27: the outer radius is not positive" },
    { I1, 0, 0.02, "test: segment 7: the inner radius is not below the outer" },
    { I1, 0, -0.01, "test: segment 7: the inner radius is negative" },
    { I1, 0, 0.019, NULL },
    { YOUNGS, 0, 0, "test: segment 7: a modulus is not positive" },
    { SHEAR, 0, -1, "test: segment 7: a modulus is not positive" },
    { DENSITY, 0, -1, "test: segment 7: a mass is negative" },
    { DENSITY, 0, 0, NULL },
    { BURDEN, 0, -1, "test: segment 7: a mass is negative" },
    { STRENGTH, 0, -1, "test: segment 7: the strength or damping ratio is negative" },
    { DAMPING, 0, -1, "test: segment 7: the strength or damping ratio is negative" },
    { DRAG, 0, -1, "test: segment 7: the drag coefficient is negative or infinite" },
    { DRAG, 0, INFINITY, "test: segment 7: the drag coefficient is negative or infinite" },
    { DRAG, 0, 1.2, NULL },
    { LIFT, 0, NAN, "test: segment 7: a value is not a finite number" },
    { LIFT, 0, -1, NULL },
    { SAIL, 1, -1, "test: segment 17: an area is negative" },
    { LEAF, 1, -1, "test: segment 17: an area is negative" },
    { BEND, 0, 1.9, NULL },
    { BEND, 0, 2.1, "test: segment 7: the initial curvature is too strong for the distance of its ends" },
    { BEND, 0, NAN, "test: segment 7: the initial curvature is not finite" },
    { STIFF, 1, 0, "test: segment 17: a given stiffness is not positive" },
    { STIFF, 1, NAN, "test: segment 17: a given stiffness is not positive" },
    { STIFF, 1, 5, NULL },
    { MASS, 1, -1, "test: segment 17: the point mass is negative or not finite" },
    { MASS, 1, 3, NULL },
};

static void every_unsound_row_is_named(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct wf_arena a = { 0 };
        struct wf_diag d = { .arena = &a };
        struct wf_err e = { 0 };
        struct wf_tree t;
        sound(&t, &a);
        spoil(&t, &a, rows[i].c, rows[i].row, rows[i].v);
        enum wf_status got = wf_tree_check(&t, &d, &e);
        assert_int_equal(got, rows[i].text ? WF_EINPUT : WF_OK);
        if (rows[i].text) assert_string_equal(d.first->text, rows[i].text);
        assert_int_equal(d.errors, rows[i].text != NULL);
        wf_arena_free(&a);
    }
}

static void many_unsound_rows_are_summed_up(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_tree t;
    assert_int_equal(wf_tree_alloc(&t, 250, &a, &e), WF_OK);
    assert_int_equal(wf_tree_check(&t, &d, &e), WF_EINPUT);
    assert_string_equal(e.text, "tree: 250 of 250 segments are wrong");
    assert_int_equal(d.errors, 101);
    assert_string_equal(d.last->text, "tree: 150 more segments are wrong");
    wf_arena_free(&a);
}

static void stem_row(struct wf_tree *t, size_t i, int32_t parent, double x0, double z0, double x1, double z1,
                     double r0, double r1)
{
    t->parent[i] = parent;
    t->x0[i] = x0, t->z0[i] = z0, t->x1[i] = x1, t->z1[i] = z1, t->r0[i] = r0, t->r1[i] = r1;
}

/* The diameter at 1.3 m is along the stem: of an upright, a leaning, a forked one and one that begins above
 * the ground. */
static void breast_height(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_tree t;
    assert_int_equal(wf_tree_alloc(&t, 3, &a, &e), WF_OK);
    stem_row(&t, 0, -1, 0, 0, 0, 1, 0.2, 0.18);
    stem_row(&t, 1, 0, 0, 1, 0, 2, 0.18, 0.16);
    stem_row(&t, 2, 1, 0, 2, 0, 3, 0.16, 0.1);
    struct wf_breast b = wf_tree_breast(&t);
    assert_true(b.row == 1 && !b.forked);
    assert_close(b.place, 0.3, 1e-12);
    assert_close(b.diameter, 2 * (0.18 - 0.3 * 0.02), 1e-12);
    stem_row(&t, 1, 0, 0, 1, 0.8, 1.6, 0.18, 0.16); /* leans: 1 m long */
    b = wf_tree_breast(&t);
    assert_close(b.diameter, 2 * (0.18 - 0.3 * 0.02), 1e-12);
    stem_row(&t, 2, 0, 0, 1, 0, 2, 0.19, 0.17); /* a second limb, thicker */
    b = wf_tree_breast(&t);
    assert_true(b.row == 2 && b.forked);
    assert_close(b.diameter, 2 * (0.19 - 0.3 * 0.02), 1e-12);
    t.level[2] = 1; /* a branch is no limb */
    b = wf_tree_breast(&t);
    assert_true(b.row == 1 && !b.forked);
    stem_row(&t, 0, -1, 0, 0.4, 0, 1.4, 0.2, 0.1);
    b = wf_tree_breast(&t);
    assert_true(b.row == 0);
    assert_close(b.place, 0.9, 1e-12);
    t.z1[0] = 1, t.z0[1] = 1, t.z1[1] = 1.1, t.x1[1] = 0, t.level[2] = 1; /* ends below */
    b = wf_tree_breast(&t);
    assert_true(b.row < 0 && isnan(b.diameter));
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(breast_height),
        cmocka_unit_test(columns_start_empty),
        cmocka_unit_test(a_sound_tree_passes),
        cmocka_unit_test(the_length_of_an_arc),
        cmocka_unit_test(every_unsound_row_is_named),
        cmocka_unit_test(many_unsound_rows_are_summed_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
