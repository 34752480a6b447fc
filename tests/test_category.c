/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Terrain categories: ratios of pressure of EN 1991-1-4, and what holds at and below z_min. */
#include "close.h"
#include "wind/category.h"

/* Peak over mean velocity pressure at 12 m, categories 0 to IV. */
static void peak_pressures(void **state)
{
    (void)state;
    const double ratio[] = { 1.8440, 1.9873, 2.2772, 2.8976, 3.8170 };
    for (size_t i = 0; i < 5; i++) {
        double gust = wf_category_gust(&wf_categories[i], 12.0);
        assert_close(gust * gust, ratio[i], 3e-5);
    }
    assert_null(wf_categories[5].name);
}

/* The basic wind is that of category II at 10 m, to the code's own rounding of its constants. */
static void basic_wind(void **state)
{
    (void)state;
    const struct wf_category *open = wf_category_open();
    assert_string_equal(open->name, "II");
    assert_close(wf_category_factor(open, 10.0), 1.0, 0.01);
    assert_close(wf_category_factor(open, 10.0), 0.19 * log(200.0), 1e-12);
}

/* Rougher ground has less wind, more turbulence, shorter eddies; below z_min nothing changes. */
static void order_and_floor(void **state)
{
    (void)state;
    for (const struct wf_category *c = wf_categories; c->name; c++) {
        assert_ptr_equal(wf_category_named(c->name), c);
        assert_close(wf_category_factor(c, 0.0), wf_category_factor(c, c->least), 1e-15);
        assert_close(wf_category_turbulence(c, 0.1 * c->least), wf_category_turbulence(c, c->least), 1e-15);
        assert_close(wf_category_length(c, 200.0), 300.0, 1e-12);
        if (!c[1].name) continue;
        assert_true(wf_category_factor(c, 20.0) > wf_category_factor(c + 1, 20.0));
        assert_true(wf_category_turbulence(c, 20.0) < wf_category_turbulence(c + 1, 20.0));
        assert_true(wf_category_length(c, 20.0) > wf_category_length(c + 1, 20.0));
    }
    assert_null(wf_category_named("V"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(peak_pressures),
        cmocka_unit_test(basic_wind),
        cmocka_unit_test(order_and_floor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
