/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tree cards: form of the stem, what is refused, what is unusual, the model. */
#include "close.h"
#include "data/species.h"
#include "grow/card.h"
#include <string.h>

#define PI 3.14159265358979324

static struct wf_arena arena;
static struct wf_err err;

static int empty(void **state)
{
    (void)state;
    wf_arena_free(&arena);
    return 0;
}

static struct wf_card oak(void)
{
    return (struct wf_card){ .height = 20, .girth = 2.5, .dbh = NAN, .crown_width = 14, .crown_base = 4 };
}

/* Half-way up, Laasasenaho's own polynomials give these shares of the diameter at breast height. */
static void forms(void **state)
{
    (void)state;
    const struct wf_stem_form *power = wf_stem_form_of("Quercus robur"),
                              *pine = wf_stem_form_of("Pinus nigra"),
                              *spruce = wf_stem_form_of("Picea abies");
    assert_string_equal(power->name, "power");
    assert_string_equal(pine->name, "pine");
    assert_string_equal(spruce->name, "spruce");
    assert_string_equal(wf_stem_form_of("Pinusia x")->name, "power");
    assert_string_equal(wf_stem_form_of(NULL)->name, "power");
    assert_close(wf_stem_form_share(power, 20, 10), pow(10 / 18.7, 0.65), 1e-12);
    /* by hand: sum of c x^e at x = 0.5 is 0.77411, at x = 0.935 is 1.15996 */
    assert_close(wf_stem_form_share(pine, 20, 10), 0.77411 / 1.15996, 1e-4);
    for (const struct wf_stem_form *const *f =
             (const struct wf_stem_form *const[]){ power, pine, spruce, NULL };
         *f; f++) {
        double before = 1;
        assert_close(wf_stem_form_share(*f, 20, 0.3), 1, 0);
        assert_close(wf_stem_form_share(*f, 20, 20), 0, 0);
        for (double z = 1.3; z <= 20; z += 0.1) {
            double share = wf_stem_form_share(*f, 20, z);
            assert_true(share <= before + 1e-12 && share >= 0);
            before = share;
        }
        assert_true(wf_stem_form_share(*f, 20, 10) > 0.57 && wf_stem_form_share(*f, 20, 10) < 0.76);
    }
}

/* Warnings and mistakes of a card; the first must hold the words. */
static void expect(struct wf_card c, enum wf_status want, size_t mistakes, const char *words)
{
    struct wf_diag d = { .arena = &arena };
    err = (struct wf_err){ 0 };
    assert_int_equal(wf_card_check(&c, "Quercus robur", &d, &err), want);
    assert_int_equal(d.errors, mistakes);
    if (!words) {
        assert_null(d.first);
        return;
    }
    assert_non_null(d.first);
    if (!strstr(d.first->text, words)) fail_msg("'%s' is not in: %s", words, d.first->text);
}

static void checked(void **state)
{
    (void)state;
    struct wf_card c = oak();
    expect(c, WF_OK, 0, NULL);
    c.dbh = 2.5 / PI;
    expect(c, WF_OK, 0, NULL);
    c.dbh = 0.7;
    expect(c, WF_EINPUT, 1, "disagree");
    c = oak(), c.girth = 250;
    expect(c, WF_EINPUT, 1, "Check the unit");
    c = oak(), c.girth = 250, c.height = 2000;
    expect(c, WF_EINPUT, 2, "height");
    c = oak(), c.girth = NAN;
    expect(c, WF_EINPUT, 1, "girth: is needed, or the dbh");
    c = oak(), c.crown_base = 20;
    expect(c, WF_EINPUT, 1, "not below the top");
    c = oak(), c.girth = 18;
    expect(c, WF_EINPUT, 1, "quarter of the height");
    /* 3.453 20^0.4406 14^0.6786 = 77.5 cm; 2 sd: a factor 2.08, 37 to 161 cm */
    c = oak(), c.girth = 1.65 * PI;
    expect(c, WF_OK, 0, "more than that of 19 of 20 Quercus");
    c.girth = 1.58 * PI;
    expect(c, WF_OK, 0, NULL);
    c.girth = 0.36 * PI;
    expect(c, WF_OK, 0, "less than");
    c = oak(), c.crown_base = 19.9;
    expect(c, WF_OK, 0, "a crown 0.1 m deep, 0.5 % of the height");
    c.crown_base = 14.2;
    expect(c, WF_OK, 0, "29 % of the height");
    c.crown_base = 13.9;
    expect(c, WF_OK, 0, NULL);
    /* grown in a stand: 66 times as high as thick */
    c = (struct wf_card){ .height = 20, .dbh = 0.3, .girth = NAN, .crown_width = 3.5, .crown_base = 15.9 };
    expect(c, WF_OK, 0, NULL);
    c.crown_base = 16.1;
    expect(c, WF_OK, 0, "a crown 3.9 m deep");
}

static void model(void **state)
{
    (void)state;
    struct wf_card c = oak();
    struct wf_model m;
    const struct wf_species sp = { .key = "oak", .name = "Oak", .latin = "Quercus robur" };
    c.lean = 0.2;
    assert_int_equal(wf_card_model(&c, &sp, &arena, &m, &err), WF_OK);
    assert_close(m.radius, 2.5 / PI / 2, 1e-12);
    assert_close(m.height * cos(0.2), 20, 1e-12);
    assert_close(m.crown_base * cos(0.2), 4, 1e-12);
    assert_close(m.judged_to * cos(0.2), 12, 1e-12);
    assert_close(m.silhouette.depth, 16, 1e-12); /* heights are vertical, however it leans */
    assert_close(wf_model_taper(&m, 1.3 / 20), 1, 1e-12);
    /* between two places of the table a straight line: within 1 % of the law below nine tenths */
    for (double z = 1.3; z < 18; z += 0.25)
        assert_close(wf_model_taper(&m, z / 20), pow((20 - z) / 18.7, 0.65), 0.01);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(forms), cmocka_unit_test(checked),
                                        cmocka_unit_test(model) };
    return cmocka_run_group_tests(tests, NULL, empty);
}
