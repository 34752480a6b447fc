/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Streamlining laws: values, continuity, derivative, and the spline against GSL's. */
#include "close.h"
#include "load/drag.h"
#include <gsl/gsl_spline.h>

static const double speed[] = { 2, 5, 6, 11, 20, 23 }, share[] = { 1, 0.9, 0.6, 0.45, 0.28, 0.28 };
static const struct wf_law_values par = { .number = { -0.7, 5 }, .n = 6, .list = { speed, share } };

static double at(const char *law, double u)
{
    double slope;
    return wf_streamline_named(law)->share(&par, u, &slope);
}

static void rows(void **state)
{
    (void)state;
    for (const struct wf_streamline_law *l = wf_streamline_laws; l->law.name; l++) {
        assert_ptr_equal(wf_streamline_named(l->law.name), l);
        assert_true(l->law.source && l->law.validity && l->law.high > l->law.low && l->share);
    }
    assert_null(wf_streamline_named("Vogel"));
    assert_null(wf_streamline_named(NULL));
}

static void rigid_crown(void **state)
{
    (void)state;
    for (double u = 0; u < 60; u += 7) assert_close(at("none", u), 1, 0);
}

static void vogel_law(void **state)
{
    (void)state;
    assert_close(at("vogel", 0), 1, 0);
    assert_close(at("vogel", 5 * exp(-0.0501)), 1, 0);
    for (double u = 5 * exp(0.0501); u < 60; u *= 1.1) assert_close(at("vogel", u), pow(u / 5, -0.7), 1e-14);
    /* force goes with U^(2+V): log slope of U^2 share */
    assert_close(log(at("vogel", 20) * 400 / (at("vogel", 10) * 100)) / log(2), 1.3, 1e-13);
    /* at the corner the rounding departs by exp(V h / 4), as the header states, and nowhere by more */
    assert_close(at("vogel", 5), exp(-0.7 * WF_VOGEL_ROUNDING / 4), 1e-14);
    for (double u = 4; u < 6; u += 0.001)
        assert_close(at("vogel", u), u > 5 ? pow(u / 5, -0.7) : 1,
                     1 - exp(-0.7 * WF_VOGEL_ROUNDING / 4) + 1e-14);
}

static void table_law(void **state)
{
    (void)state;
    for (size_t i = 0; i < 6; i++) assert_close(at("table", speed[i]), share[i], 1e-15);
    assert_close(at("table", 0), 1, 0);
    assert_close(at("table", 50), 0.28, 0);
    double before = 1;
    for (double u = 0; u < 30; u += 0.01) {
        assert_true(at("table", u) <= before + 1e-15);
        before = at("table", u);
    }
    const struct wf_law_values one = { .n = 1, .list = { speed, share + 2 } }, none = { 0 };
    double slope;
    assert_close(wf_streamline_named("table")->share(&one, 1, &slope), 0.6, 0);
    assert_close(wf_streamline_named("table")->share(&one, 2, &slope), 0.6, 0);
    assert_close(wf_streamline_named("table")->share(&none, 9, &slope), 1, 0);
}

static void continuous_derivative(void **state)
{
    (void)state;
    static const char *const law[] = { "none", "vogel", "table" }; /* that `par` is for */
    for (int k = 0; k < 3; k++)
        for (double u = 0.013, before = 0; u < 30; u += 0.0037) {
            const struct wf_streamline_law *l = wf_streamline_named(law[k]);
            double slope, ignored, h = 1e-6;
            l->share(&par, u, &slope);
            double want = (l->share(&par, u + h, &ignored) - l->share(&par, u - h, &ignored)) / (2 * h);
            assert_true(fabs(slope - want) <= 3e-6);
            assert_true(fabs(slope - before) <= 0.01); /* 2.8 per m/s and m/s at most, times the step */
            before = slope;
        }
}

/* Interior slopes are those of Steffen's rule as GSL has it; only the ends differ, on purpose. */
static void steffen_inside(void **state)
{
    (void)state;
    gsl_interp *s = gsl_interp_alloc(gsl_interp_steffen, 6);
    assert_non_null(s);
    gsl_interp_init(s, speed, share, 6);
    for (double u = 5; u <= 20; u += 0.05) {
        double slope;
        assert_close(wf_streamline_named("table")->share(&par, u, &slope),
                     gsl_interp_eval(s, speed, share, u, NULL), 1e-14);
        assert_close(slope, gsl_interp_eval_deriv(s, speed, share, u, NULL), 1e-11);
    }
    gsl_interp_free(s);
}

/* Beyond the evidence the share stays, so that the drag grows as U^2; below it not a bit changes. */
static void held(void **state)
{
    (void)state;
    static const char *const law[] = { "none", "vogel", "table" };
    struct wf_law_values kept = par;
    kept.held = 18;
    for (int k = 0; k < 3; k++) {
        const struct wf_streamline_law *l = wf_streamline_named(law[k]);
        double slope, free_slope, end = l->share(&par, 18, &slope);
        for (double u = 0.3; u < 60; u += 0.7) {
            double there = wf_streamline_share(l, &kept, u, &slope), free = l->share(&par, u, &free_slope);
            assert_true(there == (u > 18 ? end : free));
            assert_true(slope == (u > 18 ? 0 : free_slope));
            assert_true(wf_streamline_share(l, &par, u, &slope) == free);
        }
    }
    double slope, at30 = wf_streamline_share(wf_streamline_named("vogel"), &kept, 30, &slope),
                  at60 = wf_streamline_share(wf_streamline_named("vogel"), &kept, 60, &slope);
    assert_close(at60 * 3600 / (at30 * 900), 4, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows),
        cmocka_unit_test(rigid_crown),
        cmocka_unit_test(vogel_law),
        cmocka_unit_test(table_law),
        cmocka_unit_test(continuous_derivative),
        cmocka_unit_test(steffen_inside),
        cmocka_unit_test(held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
