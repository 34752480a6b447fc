/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Logarithm and exponential of the kernels against long double. */
#include "base/log_exp.h"
#include "close.h"

/* Error of `got` in units of the last place of the double nearest to `right`. */
static double units(double got, long double right)
{
    double near = fabs((double)right);
    double unit = nextafter(near, INFINITY) - near;
    return fabs((double)((got - right) / unit));
}

static void log_to_a_unit(void **state)
{
    (void)state;
    double worst = 0;
    for (int k = 0; k < 400000; k++) {
        double near_one = 0.5 + 1e-5 * k * 0.5, far = exp(-700 + 0.0035 * k);
        worst = fmax(worst, units(real_log(near_one), logl(near_one)));
        worst = fmax(worst, units(real_log(far), logl(far)));
    }
    for (int k = 1; k < 60; k++) {
        double by = ldexp(1, -k);
        worst = fmax(worst, units(real_log(1 + by), logl(1 + by)));
        if (k > 1) worst = fmax(worst, units(real_log(1 - by), logl(1 - by)));
    }
    printf("log: %.3f units\n", worst);
    assert_true(worst < 1);
    assert_true(real_log(1) == 0);
}

static void exp_to_a_unit(void **state)
{
    (void)state;
    double worst = 0;
    for (int k = 0; k < 400000; k++) {
        double small = -1 + 5e-6 * k, large = -708 + 0.00354 * k;
        worst = fmax(worst, units(real_exp(small), expl(small)));
        worst = fmax(worst, units(real_exp(large), expl(large)));
    }
    printf("exp: %.3f units\n", worst);
    assert_true(worst < 1);
    assert_true(real_exp(0) == 1);
}

static void power_to_some_units(void **state)
{
    (void)state;
    double worst = 0;
    for (int k = 1; k < 300; k++)
        for (int a = 0; a <= 40; a++) {
            double x = 1e-3 * k * k, power = -2 + 0.075 * a;
            double most = 2 + 2 * fabs(power * log(x));
            worst = fmax(worst, units(real_power(x, power), powl(x, power)) / most);
        }
    printf("power: %.3f of the bound\n", worst);
    assert_true(worst < 1);
}

/* What the arguments are held to. */
static void outside(void **state)
{
    (void)state;
    assert_true(real_log(0) == real_log(-1) && real_log(0) == real_log(2.2250738585072014e-308));
    assert_true(real_exp(1e9) == real_exp(709) && real_exp(-1e9) == real_exp(-708));
    assert_true(isfinite(real_exp(709)) && real_exp(-708) > 2.3e-308);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(log_to_a_unit),
        cmocka_unit_test(exp_to_a_unit),
        cmocka_unit_test(power_to_some_units),
        cmocka_unit_test(outside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
