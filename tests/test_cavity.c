/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stems with cavities: sections against closed forms, stress, the tree they are put on, what is refused. */
#include "close.h"
#include "data/cavity.h"
#include "data/hollow.h"
#include "data/section.h"
#include "fail/fail.h"
#include "solve/solve.h"
#include <string.h>

#define PI 3.14159265358979323846

static struct wf_hollow round_one(struct wf_arena *a, double cavity, double offset, double towards,
                                  double opening, double facing)
{
    struct wf_hollow h;
    struct wf_err e = { 0 };
    assert_int_equal(wf_hollow_round(cavity, offset, towards, opening, facing, a, &h, &e), WF_OK);
    return h;
}

static void ring(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    const double i = 0.7;
    struct wf_hollow h = round_one(&a, i, 0, 0, 0, 0);
    double moment = PI / 4 * (1 - pow(i, 4)), along;
    assert_close(h.area, PI * (1 - i * i), 1e-10);
    assert_close(h.xx, moment, 1e-10);
    assert_close(h.yy, moment, 1e-10);
    assert_true(fabs(h.xy) < 1e-12 && fabs(h.centroid[0]) < 1e-12 && fabs(h.centroid[1]) < 1e-12);
    assert_close(h.torsion, 2 * moment, 3e-6); /* its middle is a polygon of 2880 sides */
    assert_close(h.wall, 1 - i, 1e-12);
    assert_false(h.open);
    for (int k = 0; k < 8; k++) assert_close(wf_hollow_modulus(&h, 0.8 * k), 1 - pow(i, 4), 1e-10);
    assert_close(wf_hollow_least(&h, &along), 1 - pow(i, 4), 1e-10);
    wf_arena_free(&a);
}

/* A circle without a circle off its centre: area, centroid and tensor by the parallel axes theorem. */
static void eccentric(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    const double i = 0.5, off = 0.3, angle = 0.7;
    struct wf_hollow h = round_one(&a, i, off, angle, 0, 0);
    double area = PI * (1 - i * i), shift = -PI * i * i * off / area;
    double along = PI / 4 * (1 - pow(i, 4)) - PI * i * i * off * off - area * shift * shift;
    double across = PI / 4 * (1 - pow(i, 4)), where;
    assert_close(h.area, area, 1e-10);
    assert_close(h.centroid[0], shift * cos(angle), 1e-10);
    assert_close(h.centroid[1], shift * sin(angle), 1e-10);
    assert_close(h.wall, 0.2, 1e-12);
    double c = cos(angle), s = sin(angle);
    assert_close(h.xx, along * c * c + across * s * s, 1e-10);
    assert_close(h.yy, along * s * s + across * c * c, 1e-10);
    assert_close(h.xy, (along - across) * c * s, 1e-10);
    assert_close(wf_hollow_least(&h, &where), along * 4 / PI, 1e-10);
    assert_close(fmod(where + 2 * PI, PI), angle, 1e-9);
    /* the farther fibre decides along the offset, the radius across it */
    assert_close(wf_hollow_modulus(&h, angle), along / (1 - shift) * 4 / PI, 1e-10);
    assert_close(wf_hollow_modulus(&h, angle + PI / 2), across * 4 / PI, 1e-10);
    assert_close(wf_hollow_modulus(&h, angle + PI), wf_hollow_modulus(&h, angle), 1e-10);
    wf_arena_free(&a);
}

/* Thin rings with a slit: Saint-Venant's constant is that of the strip, and half a ring has known moments. */
static void open_rings(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    const double i = 0.98, t = 0.02, middle = 0.99;
    struct wf_hollow slit = round_one(&a, i, 0, 0, 1e-3, 0.4), half = round_one(&a, 0.8, 0, 0, PI, 0);
    assert_true(slit.open && half.open);
    assert_close(slit.torsion, (2 * PI - 1e-3) * middle * t * t * t / 3, 1e-5);
    assert_close(slit.area, PI * (1 - i * i) * (1 - 1e-3 / (2 * PI)), 1e-9);
    assert_close(wf_hollow_modulus(&slit, 0.4 + PI / 2), 1 - pow(i, 4), 2e-3);
    double area = PI / 2 * (1 - 0.64), first = 2. / 3 * (1 - 0.512), moment = PI / 8 * (1 - pow(0.8, 4));
    assert_close(half.area, area, 1e-10);
    assert_close(half.centroid[0], -first / area, 1e-10);
    assert_close(half.xx, moment - first * first / area, 1e-9);
    assert_close(half.yy, moment, 1e-10);
    double far = fmax(1 - first / area, first / area); /* its ends lie at x = 0, its back at -1 */
    assert_close(wf_hollow_modulus(&half, 0), half.xx / far * 4 / PI, 1e-9);
    wf_arena_free(&a);
}

/* Rays of an ellipse, of a square and of a ring that is open between two rays. */
static void by_rays(void **state)
{
    (void)state;
    enum { N = 720 };
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_hollow h;
    double angle[N], outer[N], sound[N] = { 0 };
    const double b = 0.6;
    for (int k = 0; k < N; k++)
        angle[k] = 2 * PI * k / N, outer[k] = b / hypot(b * cos(angle[k]), sin(angle[k]));
    assert_int_equal(wf_hollow_rays(N, angle, outer, sound, &a, &h, &e), WF_OK);
    assert_close(h.area, PI * b, 5e-5);
    assert_close(h.xx, PI / 4 * b, 1e-4);
    assert_close(h.yy, PI / 4 * b * b * b, 1e-4);
    assert_close(h.torsion, PI * b * b * b / (1 + b * b), 1e-4);
    assert_close(wf_hollow_modulus(&h, PI / 2), b * b, 1e-4);

    double corner[4] = { PI / 4, 3 * PI / 4, 5 * PI / 4, 7 * PI / 4 }, one[4] = { 1, 1, 1, 1 };
    double inner[4] = { 0.5, 0.5, 0.5, 0.5 };
    assert_int_equal(wf_hollow_rays(4, corner, one, inner, &a, &h, &e), WF_OK);
    double side = sqrt(2), hole = side / 2;
    assert_close(h.area, side * side - hole * hole, 1e-13);
    assert_close(h.xx, (pow(side, 4) - pow(hole, 4)) / 12, 1e-13);
    assert_close(wf_hollow_modulus(&h, 0), h.xx / (side / 2) * 4 / PI, 1e-13);
    assert_close(wf_hollow_modulus(&h, PI / 4), h.xx * 4 / PI, 1e-13); /* on its edge */

    for (int k = 0; k < N; k++) outer[k] = 1, sound[k] = k < 180 ? 1 : 0.8; /* no wall from 0 to 89.5 deg */
    assert_int_equal(wf_hollow_rays(N, angle, outer, sound, &a, &h, &e), WF_OK);
    assert_true(h.open);
    double turn = 2 * PI / N, cut = hypot(1 - 0.9 * cos(turn), 0.9 * sin(turn));
    assert_close(h.area, 0.5 * sin(turn) * (539 * (1 - 0.64) + 2 * (1 - 0.8)), 1e-12);
    assert_close(h.torsion, (539 * 2 * 0.9 * sin(turn / 2) * 0.008 + 2 * cut * 0.001) / 3, 1e-12);
    for (int k = 0; k < N; k++) sound[k] = 1;
    assert_int_equal(wf_hollow_rays(N, angle, outer, sound, &a, &h, &e), WF_EINPUT);
    wf_arena_free(&a);
}

/* Axial force and moment together on an eccentric ring, against the sum at single fibres. */
static void stress_with_force(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_hollow h = round_one(&a, 0.5, 0.3, 0, 0, 0);
    const double r = 0.2, force = -3000, mx = 400, my = 900;
    double area = h.area * r * r, cx = h.centroid[0] * r, ixx = h.xx * pow(r, 4), iyy = h.yy * pow(r, 4),
           range[2];
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < 36000; k++) {
        double x = r * cos(k * PI / 18000), y = r * sin(k * PI / 18000);
        double s = force / area + (-my - force * cx) / ixx * (x - cx) + mx / iyy * y;
        low = fmin(low, s), high = fmax(high, s);
    }
    wf_hollow_stress(&h, r, force, mx, my, range);
    assert_close(range[0], low, 1e-7);
    assert_close(range[1], high, 1e-7);
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ring),    cmocka_unit_test(eccentric),         cmocka_unit_test(open_rings),
        cmocka_unit_test(by_rays), cmocka_unit_test(stress_with_force),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
