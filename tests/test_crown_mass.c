/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Crown mass by rules: values by hand, names, species, what is missing. */
#include "close.h"
#include "data/crown_mass.h"
#include <string.h>
#include <unistd.h>

#define PI 3.14159265358979324

static struct wf_arena arena;
static struct wf_err err;

static enum wf_status ask(const char *words, const char *species, struct wf_crown_size size, double *mass)
{
    const struct wf_crown_rule *rule = NULL;
    const struct wf_crown_kind *kind = NULL;
    err = (struct wf_err){ WF_OK, "" };
    enum wf_status s = wf_crown_rule_mass(words, species, &size, mass, &rule, &kind, &err);
    if (!s) assert_true(rule && kind && !strncmp(words, rule->name, strlen(rule->name)));
    return s;
}

static int empty(void **state)
{
    (void)state;
    wf_arena_free(&arena);
    return 0;
}

static void by_cone(void **state)
{
    (void)state;
    static const struct {
        const char *words, *species;
        bool leaves;
        double density;
    } row[] = {
        { "forestgales", "sitka_spruce", true, 2.5 },    { "forestgales", "birch", true, 1.22 },
        { "forestgales", "birch", false, 0.8296 },       { "forestgales", "oak", false, 1.38 },
        { "forestgales:balsam_fir", "oak", true, 3.45 }, { "forestgales:larch_japan", "poplar", true, 3.3 },
        { "forestgales", "maritime_pine", true, 2.73 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        double mass;
        assert_int_equal(
            ask(row[i].words, row[i].species, (struct wf_crown_size){ NAN, 4, 9, row[i].leaves }, &mass),
            WF_OK);
        assert_close(mass, row[i].density * PI * 16 * 9 / 12, 1e-14);
    }
}

/* Dry masses of Jenkins et al. in kg at 40 and 60 cm, over 0.45; the curve goes on at 50 cm. */
static void by_diameter(void **state)
{
    (void)state;
    static const struct {
        const char *species;
        double at_40, at_60;
    } row[] = { { "oak", 156.5, 408.6 },
                { "beech", 174.8, 456.3 },
                { "sitka_spruce", 134.4, 350.7 },
                { "japanese_larch", 78.2, 173.3 } };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        double mass, other;
        assert_int_equal(ask("wcc", row[i].species, (struct wf_crown_size){ .diameter = 0.4 }, &mass), WF_OK);
        assert_close(mass, row[i].at_40 / 0.45, 1e-3);
        assert_int_equal(ask("wcc", row[i].species, (struct wf_crown_size){ .diameter = 0.6 }, &mass), WF_OK);
        assert_close(mass, row[i].at_60 / 0.45, 1e-3);
        assert_int_equal(ask("wcc", row[i].species, (struct wf_crown_size){ .diameter = 0.5 }, &mass), WF_OK);
        assert_int_equal(ask("wcc", row[i].species, (struct wf_crown_size){ .diameter = 0.5000001 }, &other),
                         WF_OK);
        assert_close(mass, other, 1e-4);
    }
}

static void refused(void **state)
{
    (void)state;
    static const struct {
        const char *words, *species, *text;
    } row[] = {
        { "forestgale", "oak", "there is no rule of crown mass 'forestgale'; did you mean 'forestgales'?" },
        { "", "oak", "one of: forestgales, wcc" },
        { "wcc:aok", "oak", "wcc has no kind 'aok'; did you mean 'oak'?" },
        { "wcc:", "oak", "wcc has no kind ''" },
        { "wcc", "poplar", "wcc has no kind for the species 'poplar'" },
        { "wcc", "", "wcc has no kind for the species ''" },
        { "wcc", "oak ash", "wcc has no kind for the species" },
        { "forestgales", "oak", "needs the width and the depth" },
        { "wcc", "oak", "needs the diameter at 1.3 m" },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        double mass;
        assert_int_equal(
            ask(row[i].words, row[i].species, (struct wf_crown_size){ NAN, NAN, NAN, true }, &mass),
            WF_EINPUT);
        if (!strstr(err.text, row[i].text)) fail_msg("%s", err.text);
    }
    err = (struct wf_err){ WF_OK, "" };
    assert_int_equal(wf_crown_rule_check("wcc:oak", &err), WF_OK);
    assert_int_equal(wf_crown_rule_check("wcc:x", &err), WF_EINPUT);
}

/* Species that a rule names are shipped, each once. */
static void species_are_shipped(void **state)
{
    (void)state;
    for (const struct wf_crown_rule *r = wf_crown_rules; r->name; r++) {
        char seen[2000] = " ";
        for (const struct wf_crown_kind *k = r->kind; k->name; k++) {
            char list[200], word[80], path[120], *rest = list;
            snprintf(list, sizeof list, "%s", k->species);
            for (char *key; (key = strtok_r(rest, " ", &rest));) {
                snprintf(path, sizeof path, "species/%s.yaml", key);
                if (access(path, R_OK)) fail_msg("%s: %s", r->name, path);
                snprintf(word, sizeof word, " %s ", key);
                assert_null(strstr(seen, word));
                strncat(seen, word, sizeof seen - strlen(seen) - 1);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(by_cone, empty),
        cmocka_unit_test_teardown(by_diameter, empty),
        cmocka_unit_test_teardown(refused, empty),
        cmocka_unit_test(species_are_shipped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
