/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gust factors of the codes: EN 1991-1-4 against its own spectrum integrated, limits, names of terrain.
 * Worked values: validation/gusts. */
#include "close.h"
#include "wind/gust_factor.h"

static struct wf_gust_case tree(const char *terrain, double height, double breadth, double frequency,
                                double damping)
{
    return (struct wf_gust_case){ .terrain = wf_category_named(terrain),
                                  .height = height,
                                  .breadth = breadth,
                                  .frequency = frequency,
                                  .damping = damping,
                                  .open = 25.0,
                                  .exponent = 2.0 };
}

static struct wf_gust_parts en(struct wf_gust_case c)
{
    const struct wf_gust_rule *r = wf_gust_rule_named("en1991");
    struct wf_gust_parts p;
    c.mean = c.open * wf_category_factor(c.terrain, r->at(c.terrain, c.height));
    r->parts(&c, &p);
    return p;
}

/* The structural factor on the load of the gust is the gust factor on the mean load, at the same height. */
static void two_ways(void **state)
{
    (void)state;
    for (const struct wf_category *c = wf_categories; c->name; c++) {
        struct wf_gust_case q = tree(c->name, 18, 5, 0.3, 0.1);
        struct wf_gust_parts p = en(q);
        double gust = wf_category_gust(c, wf_gust_rule_named("en1991")->at(c, 18));
        assert_close(p.structural * gust * gust, p.factor, 1e-12);
    }
}

/* Mean square of the tip's response of a linear cantilever over that of a load without size, as the integral
 * of S_L over frequency with the size reduction of the resonance and the transfer function of one oscillator.
 */
static double integrated(const struct wf_gust_case *c, double *resonance)
{
    double zs = fmax(0.6 * c->height, c->terrain->least), length = wf_category_length(c->terrain, zs);
    double sum = 0.0, last = 0.0, before = 0.0;
    for (int i = 0; i <= 400000; i++) {
        double n = 0.2 * c->frequency * exp(log(25.0) * i / 400000.0), f = n * length / c->mean;
        double r = n / c->frequency, s = 6.8 * f / pow(1.0 + 10.2 * f, 5.0 / 3.0) / n;
        double transfer = 1.0 / (pow(1.0 - r * r, 2.0) + pow(2.0 * c->damping * r, 2.0));
        double value = s * transfer - s * (r < 1.0); /* beyond the quasi-static part */
        if (i) sum += 0.5 * (value + last) * (n - before);
        last = value, before = n;
    }
    double eh = 4.6 * c->height * c->frequency / c->mean, eb = 4.6 * c->breadth * c->frequency / c->mean;
    double sizes = (1.0 / eh - (1.0 - exp(-2.0 * eh)) / (2.0 * eh * eh)) *
                   (1.0 / eb - (1.0 - exp(-2.0 * eb)) / (2.0 * eb * eb));
    *resonance = sum * sizes;
    return *resonance;
}

/* R^2 against the integral of the same spectrum. */
static void own_integral(void **state)
{
    (void)state;
    static const double damping[] = { 0.01, 0.02 };
    for (size_t i = 0; i < 2; i++) {
        struct wf_gust_case c = tree("III", 20, 6, 0.25, damping[i]);
        struct wf_gust_parts p = en(c);
        double got;
        c.mean = c.open * wf_category_factor(c.terrain, 12.0);
        assert_close(integrated(&c, &got), p.resonance, 0.02);
    }
}

/* The codes' own names of terrain. */
static void called(void **state)
{
    (void)state;
    static const struct {
        const char *rule, *terrain, *name;
    } row[] = { { "gb50009", "0", "A" },  { "gb50009", "II", "B" }, { "gb50009", "III", "C" },
                { "gb50009", "IV", "D" }, { "asce7", "0", "D" },    { "asce7", "II", "C" },
                { "asce7", "III", "B" },  { "en1991", "I", "I" } };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        assert_string_equal(wf_gust_rule_named(row[i].rule)->called(wf_category_named(row[i].terrain)),
                            row[i].name);
}

/* More damping and more size, less load; without size B^2 is that of the height, and a lighter wind less. */
static void order(void **state)
{
    (void)state;
    for (const struct wf_gust_rule *r = wf_gust_rules; r->name; r++) {
        struct wf_gust_case c = tree("II", 20, 6, 0.25, 0.08);
        struct wf_gust_parts p, damped, small;
        c.mean = 25.0;
        r->parts(&c, &p);
        assert_true(p.factor > 1.5 && p.factor < 4.0);
        c.damping = 0.16;
        r->parts(&c, &damped);
        assert_true(damped.factor < p.factor);
        c.damping = 0.08, c.breadth = 0.0;
        r->parts(&c, &small);
        assert_true(small.factor >= p.factor && isfinite(small.factor));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_ways),
        cmocka_unit_test(own_integral),
        cmocka_unit_test(called),
        cmocka_unit_test(order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
