/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of a species as rows: every one has a name and words, reaches the tree, and is found by a fit.
 */
#include "base/file.h"
#include "close.h"
#include "base/yaml.h"
#include "data/species.h"
#include "data/tree.h"
#include "fit/param.h"
#include "load/drag.h"
#include "shell.h"

static struct wf_value is(double v) { return (struct wf_value){ v, v, v, .given = true }; }

/* A value is a key of the schema, and the report has words for it. */
static void known(const char *schema, const char *strings, const char *table, const struct wf_property *p)
{
    char row[96], id[128];
    snprintf(row, sizeof row, "%s: ", p->key);
    snprintf(id, sizeof id, "<q id=\"%s%s\"", table, p->key);
    if (!strstr(schema, row)) fail_msg("%s%s is not in the schema", table, p->key);
    if (!strstr(strings, id)) fail_msg("reports/strings.xml has no %s ...>", id);
    assert_non_null(p->was);
    assert_non_null(p->value);
    assert_non_null(p->unit);
}

static void every_value_has_words(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_bytes strings;
    const struct wf_level level = { .name = "stem" };
    const struct wf_species sp = { .key = "sp" };
    const char *schema = wf_yaml_schema(wf_species_table(&wf_laws, &a), &a, &e);
    const struct wf_law *law;
    struct wf_property p;
    size_t n = 0;
    assert_non_null(schema);
    assert_int_equal(wf_file_read_text("reports/strings.xml", &a, &strings, &e), WF_OK);
    for (size_t i = 0; wf_level_property(&level, i, &p); i++, n++) known(schema, strings.data, "", &p);
    assert_true(n >= 9);
    for (size_t i = 0; wf_crown_property(&sp, i, &p); i++, n++) known(schema, strings.data, "crown.", &p);
    assert_true(n >= 12);
    for (size_t k = 0; (law = wf_law_row(wf_laws.streamlining, k)); k++)
        for (size_t i = 0; wf_law_property(law, &sp.streamlining, i, &p); i++, n++)
            known(schema, strings.data, "crown.streamlining.", &p);
    assert_true(n >= 13);
    assert_false(wf_law_property(NULL, &sp.streamlining, 0, &p));
    wf_arena_free(&a);
}

static void values_reach_their_columns(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_tree t;
    struct wf_level l = { .youngs_modulus = is(9e9),
                          .shear_modulus = is(6e8),
                          .density = is(800),
                          .modulus_of_rupture = is(5e7),
                          .damping_ratio = is(0.03),
                          .knot_factor = is(0.8),
                          .drag_coefficient = is(1.1),
                          .lift_coefficient = is(0.2) };
    assert_int_equal(wf_tree_alloc(&t, 4, &a, &e), WF_OK);
    wf_level_onto(&l, &t, 1, false);
    wf_level_onto(&l, &t, 2, true);
    for (int i = 1; i <= 2; i++) {
        bool link = i == 2;
        assert_close(t.youngs[i], 9e9, 0);
        assert_close(t.shear[i], 6e8, 0);
        assert_close(t.damping[i], 0.03, 0);
        assert_close(t.density[i], link ? 0 : 800, 0);
        assert_close(t.strength[i], link ? 0 : 5e7 * 0.8, 0);
        assert_close(t.drag[i], link ? 0 : 1.1, 0);
        assert_close(t.lift[i], link ? 0 : 0.2, 0);
    }
    l.knot_factor = (struct wf_value){ 0 }; /* nobody set it */
    wf_level_onto(&l, &t, 3, false);
    assert_close(t.strength[3], 5e7, 0);
    l.modulus_of_rupture.given = l.drag_coefficient.given = false;
    wf_level_onto(&l, &t, 3, false);
    assert_close(t.strength[3], 0, 0);
    assert_true(isnan(t.drag[3]));
    assert_close(t.density[0], 0, 0);
    wf_arena_free(&a);
}

static void fitted_quantities_are_named_by_keys(void **state)
{
    (void)state;
    assert_int_equal(wf_fit_quantity_of("levelN.", "youngs_modulus"), WF_FIT_YOUNGS);
    assert_int_equal(wf_fit_quantity_of("levelN.", "drag_coefficient"), WF_FIT_AXIS_DRAG);
    assert_int_equal(wf_fit_quantity_of("crown.", "drag_coefficient"), WF_FIT_CROWN_DRAG);
    assert_int_equal(wf_fit_quantity_of("crown.streamlining.", "exponent"), WF_FIT_VOGEL);
    assert_int_equal(wf_fit_quantity_of("", "damping_ratio"), WF_FIT_DAMPING);
    assert_int_equal(wf_fit_quantity_of("levelN.", "knot_factor"), WF_FIT_QUANTITIES);
    assert_int_equal(wf_fit_quantity_of("levelN.", "youngs"), WF_FIT_QUANTITIES);
    assert_int_equal(wf_fit_quantity_of("crown.", "streamlining"), WF_FIT_QUANTITIES);
}

/* The key is the name; the old one stands beside it, and results without keys are still read. */
static void results_have_keys_and_old_names(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak -q $RUN && grep -A 1 '\"key\": \"crown' $T/out/results.json",
          CODE_OK,
          { "\"key\": \"crown.drag_coefficient\",\n      \"quantity\": \"crown_drag_coefficient\"",
            "\"key\": \"crown.leaf_mass_per_area\",\n      \"quantity\": \"leaf_mass_per_area\"",
            "\"key\": \"crown.frontal_share\",\n      \"quantity\": \"leaf_frontal_share\"",
            "\"key\": \"crown.streamlining.exponent\",\n      \"quantity\": \"vogel_exponent\"" } },
        { "$W species show oak", CODE_OK, { "frontal_share", "streamlining.exponent" } },
        { "$W analyze oak -q $RUN && $W report -q $T/out; cp $T/out/report.html $T/new.html\n"
          "sed -i '/\"key\": /{N;/\"quantity\"/s/.*\\n//}' $T/out/results.json\n"
          "grep -c '\"key\": \"crown' $T/out/results.json; $W report -q $T/out; "
          "cmp $T/out/report.html $T/new.html && grep -c 'Vogel exponent' $T/new.html",
          CODE_OK,
          { "0\n" } },
    };
    CHECK(rows);
}

/* Each table bends the same stem with a crown: it is analysed, and all but the printed one, which has no
 * strength, break in a wind. */
static void every_table_is_analysed(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "n=0; for f in species/*.yaml; do $W analyze $f $M --wind 10,20 --samples 0 --no-report -o $T/out "
          ">$T/log "
          "2>&1 || { echo $f fails; tail -3 $T/log; }\n"
          "grep -q 'critical wind speed [0-9]' $T/log || echo no critical wind of $f; n=$((n + 1)); done; "
          "echo $n tables",
          CODE_OK,
          { "36 tables\n" } },
    };
    CHECK(rows);
    const char *first = strstr(output, "species/");
    if (strstr(output, "fails") || !first || strcmp(first, "species/willow_feng1999.yaml\n36 tables\n") != 0)
        fail_msg("%s", output);
}

/* What a British program of foresters has without a measurement is marked as such; values of woods are not
 * its. */
static void values_of_models_are_marked(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "grep -hE 'source: (gales|mayhead1973)' species/*.yaml | grep -cv 'status: borrowed'",
          CODE_RUN,
          { "0\n" } },
        { "grep -lE '(density|youngs_modulus|modulus_of_rupture|[a-z]*_strength): .*source: gales' "
          "species/*.yaml | wc -l",
          CODE_OK,
          { "0\n" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_has_words),
        cmocka_unit_test(values_reach_their_columns),
        cmocka_unit_test(fitted_quantities_are_named_by_keys),
        cmocka_unit_test(results_have_keys_and_old_names),
        cmocka_unit_test(every_table_is_analysed),
        cmocka_unit_test(values_of_models_are_marked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
