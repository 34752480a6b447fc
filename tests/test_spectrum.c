/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Target spectra: their integrals, their laws at both ends, and the components' shares. */
#include "close.h"
#include "wind/spectrum.h"
#include <string.h>

static struct wf_spectrum_par at(double speed, double height)
{
    return (struct wf_spectrum_par){ .speed = speed,
                                     .height = height,
                                     .deviation = 2.0,
                                     .length = 80.0,
                                     .share = { 0.75, 0.5 },
                                     .slope = 5.0 / 3.0,
                                     .low = 1.0 / 600.0,
                                     .high = 5.0 };
}

/* The integral over all frequencies is the variance of the component, at any height and speed. */
static void integrals(void **state)
{
    (void)state;
    static const double places[][2] = { { 3, 6 }, { 10, 10 }, { 30, 80 } };
    for (size_t i = 0; i < 3; i++)
        for (const struct wf_spectrum *s = wf_spectra; s->name; s++)
            for (unsigned c = 0; c < s->components; c++) {
                struct wf_spectrum_par p = at(places[i][0], places[i][1]);
                double share = s->ratio(&p, (enum wf_component)c);
                double end = strcmp(s->name, "one-over-f") == 0 ? p.high : 1e7;
                double got = wf_spectrum_variance(s, &p, (enum wf_component)c, 0.0, end);
                assert_close(got, 4.0 * share * share, 2e-5); /* -2/3 tail beyond 10 MHz */
            }
}

/* All but the power law fall as n^(-5/3) at high frequency. */
static void inertial_range(void **state)
{
    (void)state;
    struct wf_spectrum_par p = at(10, 10);
    for (const struct wf_spectrum *s = wf_spectra; s->name; s++)
        for (unsigned c = 0; c < s->components; c++) {
            if (strcmp(s->name, "one-over-f") == 0) continue;
            double slope =
                log10(s->density(&p, (enum wf_component)c, 1e5) / s->density(&p, (enum wf_component)c, 1e4));
            assert_close(slope, -5.0 / 3.0, 1e-3);
        }
}

/* Values worked by hand from the printed forms. */
static void printed_values(void **state)
{
    (void)state;
    struct wf_spectrum_par p = at(10, 20);
    const struct wf_spectrum *kaimal = wf_spectrum_named("kaimal"),
                             *davenport = wf_spectrum_named("davenport");
    const struct wf_spectrum *karman = wf_spectrum_named("von-karman");
    double friction2 = 4.0 / (105.0 / 22.0);
    /* f = n z/U = 1 at n = 0.5 Hz: n S = u*^2 105/34^(5/3) */
    assert_close(0.5 * kaimal->density(&p, WF_ALONG, 0.5), friction2 * 105.0 / pow(34.0, 5.0 / 3.0), 1e-12);
    assert_close(0.5 * kaimal->density(&p, WF_ACROSS, 0.5), friction2 * 17.0 / pow(10.5, 5.0 / 3.0), 1e-12);
    assert_close(0.5 * kaimal->density(&p, WF_UP, 0.5), friction2 * 2.1 / 6.3, 1e-12);
    /* x = 1200 n/U = 1: n S = u*^2 4/2^(4/3), u*^2 = sigma^2/6 */
    assert_close(davenport->density(&p, WF_ALONG, 1.0 / 120.0) / 120.0, 4.0 / 6.0 * 4.0 / pow(2.0, 4.0 / 3.0),
                 1e-12);
    /* n L/U = 1; 70.8 is a rounded constant */
    assert_close(0.125 * karman->density(&p, WF_ALONG, 0.125), 4.0 * 4.0 / pow(71.8, 5.0 / 6.0), 3e-4);
    /* S(0) = 4 sigma^2 L/U fixes the integral length */
    assert_close(karman->density(&p, WF_ALONG, 0.0), 4.0 * 4.0 * 8.0, 1e-12);
}

/* Kaimal's stress: integral of the co-spectrum is -14/(9.6*1.4) u*^2, within 5 % of -u*^2; the correlation
 * of u and w at any frequency stays below 1. */
static void shear_stress(void **state)
{
    (void)state;
    struct wf_spectrum_par p = at(10, 10);
    const struct wf_spectrum *s = wf_spectrum_named("kaimal");
    double sum = 0.0, friction2 = 4.0 / (105.0 / 22.0);
    for (double x = log(1e-6); x < log(1e4); x += 0.01) {
        double f = exp(x), stress = s->shear(&p, f);
        assert_true(fabs(stress) < sqrt(s->density(&p, WF_ALONG, f) * s->density(&p, WF_UP, f)));
        sum += stress * f * 0.01;
    }
    assert_close(sum, -friction2 * 14.0 / (9.6 * 1.4), 1e-3);
    assert_true(fabs(sum + friction2) < 0.05 * friction2);
}

static void averaging_removes_variance(void **state)
{
    (void)state;
    struct wf_spectrum_par p = at(10, 10);
    const struct wf_spectrum *s = wf_spectrum_named("von-karman");
    double whole = wf_spectrum_variance(s, &p, WF_ALONG, 0.0, 5.0);
    double none = wf_spectrum_averaged_variance(s, &p, 1e-6, 5.0);
    double gust = wf_spectrum_averaged_variance(s, &p, 3.0, 5.0);
    assert_close(none, whole, 1e-8);
    assert_true(gust < 0.9 * whole && gust > 0.5 * whole);
}

static void names(void **state)
{
    (void)state;
    assert_null(wf_spectrum_named("kaiman"));
    for (const struct wf_spectrum *s = wf_spectra; s->name; s++)
        assert_true(s->title && s->source && s->validity && (s->components == 1 || s->components == 3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integrals),
        cmocka_unit_test(inertial_range),
        cmocka_unit_test(printed_values),
        cmocka_unit_test(shear_stress),
        cmocka_unit_test(averaging_removes_variance),
        cmocka_unit_test(names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
