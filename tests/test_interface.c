/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Models as a program sees them that uses the library: opened, made of a scan, with leaves, standing. */
#include "close.h"
#include "data/model.h"
#include "data/species.h"
#include "windfirm.h"

static struct wf_arena memory;
static struct wf_err why;
static struct wf_diag findings;

static int begin(void **state)
{
    (void)state;
    why = (struct wf_err){ 0 };
    findings = (struct wf_diag){ .arena = &memory };
    return 0;
}

static int end(void **state)
{
    (void)state;
    wf_arena_free(&memory);
    return 0;
}

static struct wf_tree grown(const struct wf_model *m)
{
    struct wf_species species;
    struct wf_tree t;
    assert_int_equal(wf_species_read("species/poplar.yaml", &wf_laws, &memory, &species, &findings, &why),
                     WF_OK);
    assert_int_equal(wf_grow(m, &species, &memory, &t, &findings, &why), WF_OK);
    return t;
}

static double leaves_of(const struct wf_tree *t)
{
    double sum = 0;
    for (size_t i = 0; i < t->n; i++) sum += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
    return sum;
}

static void a_model_is_opened(void **state)
{
    (void)state;
    struct wf_model *m;
    struct wf_model read;
    assert_int_equal(wf_model_open("models/culm.yaml", &memory, &m, &findings, &why), WF_OK);
    assert_int_equal(wf_model_read("models/culm.yaml", &memory, &read, &findings, &why), WF_OK);
    assert_string_equal(m->key, read.key);
    assert_close(m->height, read.height, 0);
    assert_int_equal(wf_model_open("models/none.yaml", &memory, &m, &findings, &why), WF_EINPUT);
}

static void a_scan_becomes_a_model(void **state)
{
    (void)state;
    struct wf_model *m;
    const char *scan = "tests/data/qsm/normalised.csv";
    assert_int_equal(wf_model_scanned(scan, NULL, &memory, &m, &findings, &why), WF_OK);
    struct wf_tree bare = grown(m);
    assert_close(leaves_of(&bare), 0, 0);
    assert_int_equal(wf_model_leaves(m, 12.5, &why), WF_OK);
    struct wf_tree leafy = grown(m);
    assert_close(leaves_of(&leafy), 12.5, 1e-9);
    assert_int_equal(wf_model_scanned(scan, "nailed", &memory, &m, &findings, &why), WF_EUSAGE);
    assert_non_null(strstr(why.text, "nailed"));
}

static void leaves_need_a_place(void **state)
{
    (void)state;
    struct wf_model bare = { .key = "pole" };
    assert_int_equal(wf_model_leaves(&bare, 1, &why), WF_EUSAGE);
    assert_int_equal(wf_model_leaves(&bare, NAN, NULL), WF_EUSAGE);
    assert_int_equal(wf_model_leaves(&bare, 0, NULL), WF_OK);
}

static void a_standing_tree_is_unloaded_first(void **state)
{
    (void)state;
    struct wf_model m = { 0 };
    wf_model_stands(&m, true);
    assert_int_equal(m.shape, WF_SHAPE_UNDER_WEIGHT);
    wf_model_stands(&m, false);
    assert_int_equal(m.shape, WF_SHAPE_STRESS_FREE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_model_is_opened, begin, end),
        cmocka_unit_test_setup_teardown(a_scan_becomes_a_model, begin, end),
        cmocka_unit_test_setup_teardown(leaves_need_a_place, begin, end),
        cmocka_unit_test_setup_teardown(a_standing_tree_is_unloaded_first, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
