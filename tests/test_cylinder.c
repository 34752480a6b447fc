/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cylinder's drag coefficient: the classic curve, bark instead of the drag crisis, smoothness,
 * derivative.
 */
#include "close.h"
#include "load/drag.h"

static double bark(double speed, double diameter, double viscosity, double *derivative)
{
    return wf_axis_drag_named("bark")->coefficient(NULL, speed, diameter, viscosity, derivative);
}

static double cd(double re)
{
    double slope;
    return bark(re, 1, 1, &slope);
}

/* Values every textbook drawing of the curve agrees on. */
static void classic_curve(void **state)
{
    (void)state;
    assert_close(cd(1), 10.5, 1e-12);
    assert_close(cd(1e2), 1.37, 1e-12);
    assert_close(cd(1e3), 1.0, 1e-12);
    assert_close(cd(1e5), 1.2, 1e-12);
}

/* Low end against the theory of Lamb (1911): Cd = 8 pi / (Re (1/2 - Euler's constant + ln(8/Re))), good to
 * some per cent at Re = 0.1, and against the fit of Sucker & Brauer (1975, Waerme- und Stoffuebertragung
 * 8:149-158) below the crisis. */
static void independent_laws(void **state)
{
    (void)state;
    double lamb = 8 * 3.14159265358979324 / (0.1 * (0.5 - 0.57721566490153286 + log(80)));
    assert_close(cd(0.1), lamb, 0.02);
    for (double re = 1; re < 1.5e5; re *= 1.07) {
        double fit = 1.18 + 6.8 / pow(re, 0.89) + 1.96 / sqrt(re) - 4e-4 * re / (1 + 3.64e-7 * re * re);
        assert_close(cd(re), fit, 0.10);
    }
}

/* Bark: no drag crisis. Beyond it the rule of DNV-RP-C205 for marine growth, (29 + 4 log10(k/D)) / 20 up to
 * k/D = 0.01 and 1.05 above, and that of EN 1991-1-4, 1.2 + 0.18 log10(10 k/D) / (1 + 0.4 log10(Re / 1e6)),
 * for furrows of 0.01 to 0.05 diameters. */
static void rough_without_crisis(void **state)
{
    (void)state;
    double before = cd(1e5);
    for (double re = 1e5; re < 5e5; re *= 1.02) {
        assert_true(cd(re) <= before && cd(re) >= 1);
        before = cd(re);
    }
    for (double re = 5e5; re < 1e8; re *= 1.3) {
        double grown = (29 + 4 * log10(0.01)) / 20, part = 1 + 0.4 * fmin(log10(re / 1e6), 1);
        assert_close(cd(re), grown, 1e-12);
        assert_true(cd(re) >= 0.97 * (1.2 + 0.18 * log10(10 * 0.01) / part));
        assert_true(cd(re) <= 1.03 * (1.2 + 0.18 * log10(10 * 0.05) / part));
    }
}

static void ends_are_held(void **state)
{
    (void)state;
    double slope;
    assert_close(bark(0, 0.1, 1.5e-5, &slope), 58, 0);
    assert_close(slope, 0, 0);
    assert_close(bark(1e4, 10, 1.5e-5, &slope), 1.05, 0);
    assert_close(slope, 0, 0);
}

static void derivative_and_smoothness(void **state)
{
    (void)state;
    const double diameter = 0.08, viscosity = 1.46e-5;
    double last = 0, slope;
    for (double re = 0.05; re < 3e7; re *= 1.0123) {
        double u = re * viscosity / diameter, h = 1e-5 * u, ignored, got;
        double value = bark(u, diameter, viscosity, &got);
        double want = (bark(u + h, diameter, viscosity, &ignored) -
                       bark(u - h, diameter, viscosity, &ignored)) /
                      (2 * h);
        assert_true(value > 0);
        assert_true(fabs(got - want) <= 1e-6 * fabs(got) + 1e-8 * value / u);
    }
    /* no jump of value or slope at the points of the table */
    for (int decade = -1; decade <= 7; decade++)
        for (int k = 0; k < 3; k++) {
            double re = pow(10, decade) * (k == 0 ? 1 : k == 1 ? 2 : 5), below, above;
            last = bark(re * (1 - 1e-9), 1, 1, &below);
            assert_close(bark(re * (1 + 1e-9), 1, 1, &above), last, 1e-7);
            assert_true(fabs(above - below) * re <= 1e-6 * last);
        }
    assert_true(bark(1, 1, 1, &slope) > 0 && slope < 0);
}

/* The tabulated slopes are those of the rule in wf_smooth_slope for the tabulated values. */
static void slopes_follow_the_rule(void **state)
{
    (void)state;
    double x[25], y[25], slope;
    for (int i = 0; i < 25; i++) {
        x[i] = i / 3 - 1 + log10(i % 3 == 0 ? 1 : i % 3 == 1 ? 2 : 5);
        y[i] = cd(pow(10, x[i]));
    }
    for (size_t i = 0; i < 25; i++) {
        double re = pow(10, x[i]);
        bark(re, 1, 1, &slope);
        assert_true(fabs(slope * re * log(10) - wf_smooth_slope(x, y, 25, i)) <= 1e-9 * y[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(classic_curve),
        cmocka_unit_test(independent_laws),
        cmocka_unit_test(rough_without_crisis),
        cmocka_unit_test(ends_are_held),
        cmocka_unit_test(derivative_and_smoothness),
        cmocka_unit_test(slopes_follow_the_rule),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
