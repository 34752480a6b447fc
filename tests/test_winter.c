/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Snow and ice: masses and drag by closed forms. */
#include "close.h"
#include "load/winter.h"

#define PI 3.14159265358979324

/* A stem and two shoots with leaves, 3 m apart along x and 2 m along y. */
static void plant(struct wf_tree *t, struct wf_arena *a)
{
    struct wf_err e;
    assert_int_equal(wf_tree_alloc(t, 3, a, &e), WF_OK);
    for (int i = 0; i < 3; i++) {
        t->parent[i] = i ? 0 : -1;
        t->z0[i] = i ? 4 : 0, t->z1[i] = i ? 4.5 : 4;
        t->x1[i] = i == 1 ? 2 : i == 2 ? -1 : 0;
        t->y1[i] = i == 1 ? 1.5 : i == 2 ? -0.5 : 0;
        t->r0[i] = i ? 0.01 : 0.1, t->r1[i] = i ? 0.006 : 0.07;
        t->density[i] = 900;
        t->level[i] = i > 0;
        t->leaf0[i] = t->leaf1[i] = i;
        t->sail0[i] = t->sail1[i] = 0.1 * i;
    }
}

static void ice(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    const double b = 0.01;
    plant(&t, &a);
    t.drag[0] = 1.1;
    double want = 0;
    for (size_t i = 0; i < 3; i++) {
        double d = t.r0[i] + t.r1[i];
        want += 917 * (PI * b * (d + b) + 2 * b * (double)i) * wf_tree_length(&t, i);
    }
    assert_close(wf_ice_onto(&t, b), want, 1e-13);
    assert_close(t.burden0[0], 917 * PI * b * (0.2 + b), 1e-14);
    assert_close(t.burden1[0], 917 * PI * b * (0.14 + b), 1e-14);
    assert_close(t.drag[0] * 0.17, 1.1 * (0.17 + 2 * b), 1e-14);
    assert_close(t.drag[1] * 0.016, 1.2 * (0.016 + 2 * b), 1e-14);
    wf_arena_free(&a);
}

static void snow(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_tree t;
    plant(&t, &a);
    /* three corners: 0 0, 2 1.5, -1 -0.5 */
    double around = 2.5 + sqrt(1.25) + sqrt(13);
    assert_close(wf_crown_projection(&t, 0), around * around / (4 * PI), 1e-14);
    assert_close(wf_crown_projection(&t, 4), PI / 4 * 16, 1e-14);
    wf_snow_onto(&t, 30);
    double sum = 0;
    for (size_t i = 0; i < 3; i++) sum += 0.5 * (t.burden0[i] + t.burden1[i]) * wf_tree_length(&t, i);
    assert_close(sum, 30, 1e-14);
    assert_close(t.burden0[0], 0, 0);
    assert_close(t.burden0[2] / t.burden0[1], 2, 1e-14);
    for (size_t i = 0; i < 3; i++) t.sail0[i] = t.sail1[i] = 0;
    assert_close(wf_crown_projection(&t, 4), 0, 0);
    wf_arena_free(&a);
}

/* A ring of shoots: its mean width is its diameter; turning the tree changes nothing. */
static void snow_of_a_turned_tree(void **state)
{
    (void)state;
    enum { SHOOTS = 400 };
    struct wf_arena a = { 0 };
    struct wf_tree t;
    struct wf_err e;
    double area[2][2];
    assert_int_equal(wf_tree_alloc(&t, SHOOTS, &a, &e), WF_OK);
    for (int turned = 0; turned < 2; turned++)
        for (int flat = 0; flat < 2; flat++) {
            for (int i = 0; i < SHOOTS; i++) {
                double angle = 2 * PI * i / SHOOTS, turn = 37 * PI / 180 * turned;
                double x = 3 * cos(angle), y = (flat ? 1.5 : 3) * sin(angle);
                t.x1[i] = x * cos(turn) - y * sin(turn), t.y1[i] = x * sin(turn) + y * cos(turn);
                t.level[i] = 1, t.sail0[i] = t.sail1[i] = 0.1;
            }
            area[turned][flat] = wf_crown_projection(&t, 0);
        }
    assert_close(area[0][0], PI * 9, 1e-4); /* a polygon */
    assert_close(area[1][0], area[0][0], 1e-12);
    assert_close(area[1][1], area[0][1], 1e-12);
    assert_true(area[0][1] > PI * 4.5 && area[0][1] < 1.2 * PI * 4.5);
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(ice), cmocka_unit_test(snow),
                                        cmocka_unit_test(snow_of_a_turned_tree) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
