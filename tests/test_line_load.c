/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The line load: closed cases, limits, and every derivative against central differences. */
#include "close.h"
#include "load/drag.h"
#include "load/load.h"
#include <string.h>

static struct wf_wind wind_row(const char *profile, double speed)
{
    return (struct wf_wind){ .sample = wf_profile_named(profile)->sample,
                             .speed = speed,
                             .direction = { 0.6, 0.8, 0 },
                             .reference_height = 10,
                             .roughness = 0.05,
                             .displacement = 0.4,
                             .exponent = 0.16 };
}

static struct wf_loads in_wind(const struct wf_wind *w)
{
    struct wf_loads l;
    wf_loads_default(&l);
    l.wind = w;
    return l;
}

static struct wf_wind along_x(double speed)
{
    struct wf_wind w = wind_row("uniform", speed);
    memcpy(w.direction, (double[3]){ 1, 0, 0 }, sizeof w.direction);
    return w;
}

static const double origin[3] = { 0, 0, 1 }, up[3] = { 0, 0, 1 }, to_x[3] = { 1, 0, 0 },
                    to_y[3] = { 0, 1, 0 };

static void cylinder_across(void **state)
{
    (void)state;
    struct wf_wind w = along_x(12);
    struct wf_loads l = in_wind(&w);
    struct wf_line_point p = { .diameter = 0.1, .drag = 1.1, .mass = 3 };
    struct wf_line_load f;
    wf_load_on_line(&l, &p, origin, up, &f);
    assert_close(f.force[0], 0.5 * 1.225 * 1.1 * 0.1 * 144, 1e-15);
    assert_close(f.force[1], 0, 0);
    assert_close(f.force[2], -3 * 9.81, 1e-15);
}

static void cylinder_inclined(void **state)
{
    (void)state;
    struct wf_wind w = along_x(12);
    struct wf_loads l = in_wind(&w);
    struct wf_line_point p = { .diameter = 0.1, .drag = 1.1 };
    struct wf_line_load f;
    double half = sqrt(0.5), t[3] = { half, 0, half }, across = 0.5 * 1.225 * 1.1 * 0.1 * 144;
    wf_load_on_line(&l, &p, origin, t, &f);
    /* sin^2 of the angle between wind and axis, pushing across the axis */
    assert_close(f.force[0] * half - f.force[2] * half, across * 0.5, 1e-14);
    assert_close(f.force[0] * half + f.force[2] * half, 0, 1e-14);
    wf_load_on_line(&l, &p, origin, to_x, &f);
    for (int i = 0; i < 3; i++) assert_close(f.force[i], 0, 0);
    for (int i = 0; i < 9; i++) assert_close(f.by_turn[i], 0, 0);
}

static void lift_is_across_wind_and_axis(void **state)
{
    (void)state;
    struct wf_wind w = along_x(12);
    struct wf_loads l = in_wind(&w);
    struct wf_line_point p = { .diameter = 0.1, .drag = 0, .lift = 0.3 };
    struct wf_line_load f;
    wf_load_on_line(&l, &p, origin, up, &f);
    assert_close(f.force[0], 0, 0);
    assert_close(f.force[1], 0.5 * 1.225 * 0.3 * 0.1 * 144, 1e-15); /* z x x = y */
    assert_close(f.force[2], 0, 0);
}

static void crown_goes_with_the_wind(void **state)
{
    (void)state;
    struct wf_wind w = along_x(15);
    struct wf_loads l = in_wind(&w);
    struct wf_line_point p = { .diameter = 0, .drag = 1, .sail = 0.8 };
    struct wf_line_load f;
    double half = sqrt(0.5), t[3] = { half, 0, half };
    wf_load_on_line(&l, &p, origin, t, &f); /* whatever the axis does */
    assert_close(f.force[0], 0.5 * 1.225 * 0.8 * 225, 1e-15);
    assert_close(f.force[2], 0, 0);
    for (int i = 0; i < 9; i++) assert_close(f.by_turn[i], 0, 0);
    l.streamline = wf_streamline_named("vogel");
    l.streamline_par = (struct wf_law_values){ .number = { -0.7, 5 } };
    wf_load_on_line(&l, &p, origin, to_y, &f);
    assert_close(f.force[0], 0.5 * 1.225 * 0.8 * 225 * pow(3, -0.7), 1e-14);
}

static void still_air_gives_weight_alone(void **state)
{
    (void)state;
    struct wf_wind w = wind_row("log", 20);
    struct wf_loads l = in_wind(&w);
    struct wf_line_point p = { .diameter = 0.1, .drag = NAN, .lift = 0.2, .sail = 1, .mass = 2 };
    struct wf_line_load f;
    const double below[3] = { 0, 0, 0.4 };
    l.streamline = wf_streamline_named("vogel");
    l.streamline_par = (struct wf_law_values){ .number = { -0.7, 5 } };
    for (int still = 0; still < 2; still++) { /* in the calm layer, and without any wind */
        if (still) l.wind = NULL;
        wf_load_on_line(&l, &p, below, up, &f);
        assert_close(f.force[0], 0, 0);
        assert_close(f.force[1], 0, 0);
        assert_close(f.force[2], -2 * 9.81, 1e-15);
        for (int i = 0; i < 9; i++) {
            assert_close(f.by_place[i], 0, 0);
            assert_close(f.by_turn[i], 0, 0);
        }
    }
}

/* As the wind dies, force / U^2 tends to its limit and derivatives to zero: nothing blows up on the way. */
static void vanishing_wind(void **state)
{
    (void)state;
    struct wf_line_point p = { .diameter = 0.1, .drag = 1.2, .lift = 0.2, .sail = 1 };
    for (double speed = 1; speed > 1e-170; speed *= 1e-9) {
        struct wf_wind w = along_x(speed);
        struct wf_loads l = in_wind(&w);
        struct wf_line_load f;
        wf_load_on_line(&l, &p, origin, up, &f);
        if (speed * speed > 1e-290)
            assert_close(f.force[0] / (speed * speed), 0.5 * 1.225 * (1.2 * 0.1 + 1), 1e-12);
        for (int i = 0; i < 9; i++) assert_true(fabs(f.by_turn[i]) <= speed * speed);
    }
}

static void scales_act_on_the_force(void **state)
{
    (void)state;
    struct wf_wind w = wind_row("power", 9);
    struct wf_loads l = in_wind(&w);
    struct wf_line_point p = { .diameter = 0.2, .drag = NAN, .lift = 0.1, .sail = 0.5, .mass = 7 };
    struct wf_line_load whole, part;
    double t[3] = { 0.36, 0.48, 0.8 };
    l.streamline = wf_streamline_named("vogel");
    l.streamline_par = (struct wf_law_values){ .number = { -0.5, 4 } };
    wf_load_on_line(&l, &p, origin, t, &whole);
    l.wind_scale = 0.25, l.weight_scale = 0.5;
    wf_load_on_line(&l, &p, origin, t, &part);
    assert_close(part.force[0], 0.25 * whole.force[0], 1e-14);
    assert_close(part.force[2] + 0.5 * 7 * 9.81, 0.25 * (whole.force[2] + 7 * 9.81), 1e-12);
    for (int i = 0; i < 9; i++) assert_close(part.by_place[i], 0.25 * whole.by_place[i], 1e-14);
}

/* xorshift64* in -1..1: the points of the derivative test */
static double dice(uint64_t *s)
{
    *s ^= *s >> 12, *s ^= *s << 25, *s ^= *s >> 27;
    return (double)((*s * 2685821657736338717u) >> 11) / 4503599627370496.0 - 1;
}

static void turned(const double t[3], const double spin[3], double out[3])
{
    double a = sqrt(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]), k[3], dot = 0;
    for (int i = 0; i < 3; i++) k[i] = spin[i] / a, dot += k[i] * t[i];
    double x[3] = { k[1] * t[2] - k[2] * t[1], k[2] * t[0] - k[0] * t[2], k[0] * t[1] - k[1] * t[0] };
    for (int i = 0; i < 3; i++) out[i] = t[i] * cos(a) + x[i] * sin(a) + k[i] * dot * (1 - cos(a));
}

/* A gradient in every entry, so that no term of the chain rule can hide. */
static void swirl(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    const double g[9] = { 0.3, -0.5, 0.8, 0.2, 0.7, -0.4, -0.6, 0.1, 0.5 };
    for (int i = 0; i < 3; i++) {
        u[i] = w->speed * w->direction[i] + g[3 * i] * x[0] + g[3 * i + 1] * x[1] + g[3 * i + 2] * x[2];
        for (int j = 0; j < 3; j++) du[3 * i + j] = g[3 * i + j];
    }
}

static void largest_gap(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                        const double t[3])
{
    struct wf_line_load f, a, b;
    double size_x = 0, size_w = 0, gap_x = 0, gap_w = 0;
    wf_load_on_line(l, p, x, t, &f);
    for (int i = 0; i < 9; i++) size_x += fabs(f.by_place[i]), size_w += fabs(f.by_turn[i]);
    for (int j = 0; j < 3; j++) {
        const double hx = 1e-5, hw = 1e-5;
        double there[3] = { x[0], x[1], x[2] }, spin[3] = { 0 }, tt[3];
        there[j] = x[j] + hx, wf_load_on_line(l, p, there, t, &a);
        there[j] = x[j] - hx, wf_load_on_line(l, p, there, t, &b);
        for (int i = 0; i < 3; i++)
            gap_x += fabs((a.force[i] - b.force[i]) / (2 * hx) - f.by_place[3 * i + j]);
        spin[j] = hw, turned(t, spin, tt), wf_load_on_line(l, p, x, tt, &a);
        spin[j] = -hw, turned(t, spin, tt), wf_load_on_line(l, p, x, tt, &b);
        for (int i = 0; i < 3; i++)
            gap_w += fabs((a.force[i] - b.force[i]) / (2 * hw) - f.by_turn[3 * i + j]);
    }
    if (!(gap_x <= 1e-6 * size_x + 1e-9) || !(gap_w <= 1e-6 * size_w + 1e-9))
        fail_msg("derivatives off: by place %.3g of %.3g, by turn %.3g of %.3g", gap_x, size_x, gap_w,
                 size_w);
}

static void derivatives(void **state)
{
    (void)state;
    static const double speeds[] = { 2, 6, 11, 20 }, shares[] = { 1, 0.7, 0.4, 0.3 };
    static const char *const profile[] = { "uniform", "log", "power", "swirl" };
    static const char *const law[] = { NULL, "none", "vogel", "table" };
    uint64_t seed = 20111;
    for (int k = 0; k < 2000; k++) {
        const char *name = profile[k % 4];
        struct wf_wind w = wind_row(strcmp(name, "swirl") ? name : "uniform", 8 + 7 * dice(&seed));
        if (!strcmp(name, "swirl")) w.sample = swirl;
        struct wf_loads l = in_wind(&w);
        l.streamline = wf_streamline_named(law[k / 4 % 4]);
        l.streamline_par = (struct wf_law_values){ .number = { -0.7, 5 }, .n = 4, .list = { speeds, shares } };
        struct wf_line_point p = { .diameter = 0.15 + 0.1 * dice(&seed),
                                   .drag = k % 3 ? NAN : 1.1,
                                   .lift = 0.4 * dice(&seed),
                                   .sail = 0.5 + 0.4 * dice(&seed),
                                   .mass = 4 };
        double x[3] = { 5 * dice(&seed), 5 * dice(&seed), 6 + 5 * dice(&seed) }, t[3], size = 0;
        for (int i = 0; i < 3; i++) t[i] = dice(&seed), size += t[i] * t[i];
        for (int i = 0; i < 3; i++) t[i] /= sqrt(size);
        largest_gap(&l, &p, x, t);
    }
}

static void parts_make_the_whole(void **state)
{
    (void)state;
    struct wf_wind w = wind_row("power", 14);
    struct wf_loads l = in_wind(&w);
    struct wf_line_point p = { .diameter = 0.2, .drag = NAN, .lift = 0.3, .sail = 0.5, .mass = 7 };
    struct wf_line_load f;
    struct wf_line_parts q;
    double t[3] = { 0.36, 0.48, 0.8 }, across = 0;
    wf_load_on_line(&l, &p, origin, t, &f);
    wf_load_parts_on_line(&l, &p, origin, t, &q);
    for (int i = 0; i < 3; i++) {
        assert_close(q.drag_axis[i] + q.drag_crown[i] + q.lift[i] + q.weight[i], f.force[i], 1e-14);
        across += q.lift[i] * w.direction[i];
    }
    assert_close(across, 0, 1e-12);
    assert_close(q.drag_crown[0] / q.drag_crown[1], 0.75, 1e-14);
    assert_close(q.weight[2], -7 * 9.81, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cylinder_across),
        cmocka_unit_test(cylinder_inclined),
        cmocka_unit_test(lift_is_across_wind_and_axis),
        cmocka_unit_test(crown_goes_with_the_wind),
        cmocka_unit_test(still_air_gives_weight_alone),
        cmocka_unit_test(vanishing_wind),
        cmocka_unit_test(scales_act_on_the_force),
        cmocka_unit_test(derivatives),
        cmocka_unit_test(parts_make_the_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
