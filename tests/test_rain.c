/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rain: sizes and speeds of drops, their shapes, hits, water on a leaf; closed forms, budgets, limits. */
#include "base/num.h"
#include "base/random.h"
#include "close.h"
#include "grow/kmeans.h"
#include "load/drop_shape.h"
#include "load/hits.h"
#include "load/leaf_water.h"
#include "load/rain.h"
#include "scratch.h"
#include <string.h>

#define DEGREE (WF_PI / 180)

/* Values of the laws at 0.5, 1, 2, 3, 5 mm as tabulated for Atlas; the five agree within 0.25 m/s. */
static void speeds_of_fall(void **state)
{
    (void)state;
    static const double at[][2] = { { 0.5, 2.02 }, { 1, 4.00 }, { 2, 6.55 }, { 3, 7.95 }, { 5, 9.14 } };
    for (size_t i = 0; i < WF_COUNT(at); i++) {
        double d = at[i][0] * 1e-3, atlas = wf_fall_law_named("atlas")->speed(d);
        assert_close(round(atlas * 100) / 100, at[i][1], 1e-12);
        for (const struct wf_fall_law *l = wf_fall_laws; l->name; l++)
            assert_true(fabs(l->speed(d) - atlas) < 0.25);
    }
    assert_true(wf_fall_law_named("atlas")->speed(1e-4) == 0);
    assert_null(wf_fall_law_named("newton"));
}

/* Marshall and Palmer's drops with Atlas' speeds do not return their own intensity: 1.18, 1.18, 1.13, 1.05 of
 * it at 1, 5, 25 and 100 mm/h; water 0.089, 0.344, 1.33, 4.26 g/m3, in closed form pi rho N0/slope^4. */
static void spectrum(void **state)
{
    (void)state;
    static const double at[][3] = {
        { 1, 1.18, 0.089 }, { 5, 1.18, 0.344 }, { 25, 1.13, 1.33 }, { 100, 1.05, 4.26 }
    };
    for (size_t i = 0; i < WF_COUNT(at); i++) {
        struct wf_spectrum_sums s;
        double r = at[i][0] / 3.6e6, slope = 4.1e3 * pow(at[i][0], -0.21);
        wf_marshall_palmer(r, 0, 30e-3, wf_fall_law_named("atlas"), &s);
        assert_close(s.flux / r, at[i][1], 0.006);
        assert_close(1e3 * s.content, at[i][2], 0.006);
        assert_close(s.content, WF_PI * WF_WATER_DENSITY * 8e6 / pow(slope, 4), 1e-5);
    }
}

static struct wf_rain heavy(void)
{
    return (struct wf_rain){ .law = &wf_fall_laws[0],
                             .intensity = 20 / 3.6e6,
                             .least = 0.5e-3,
                             .largest = 6e-3,
                             .high = { 2, 3 },
                             .slot = 0.1,
                             .seed = 5 };
}

/* What arrives in a minute is the intensity: scaled drops, within four standard deviations of the sum. */
static void intensity_arrives(void **state)
{
    (void)state;
    struct wf_rain r = heavy();
    struct wf_err e = { 0 };
    double sum = 0, square = 0;
    assert_int_equal(wf_rain_make(&r, &e), WF_OK);
    for (uint64_t step = 0; step < 600; step++) {
        size_t n = wf_rain_count(&r, step, (double)step * 0.1, 0.1);
        for (size_t k = 0; k < n; k++) {
            struct wf_raindrop d;
            wf_rain_drop(&r, step, k, &d);
            double v = WF_PI / 6 * pow(d.diameter, 3);
            sum += v, square += v * v;
            assert_true(d.x >= 0 && d.x <= 2 && d.y >= 0 && d.y <= 3 && d.diameter >= 0.5e-3 &&
                        d.diameter <= 6e-3);
        }
    }
    double want = r.intensity * 6 * 60;
    assert_true(fabs(sum - want) < 4 * sqrt(square));
    assert_true(sqrt(square) < 0.05 * want);
}

/* The number follows the normal curve; a drop does not depend on what was drawn before. */
static void storm(void **state)
{
    (void)state;
    struct wf_rain r = heavy();
    struct wf_err e = { 0 };
    r.intensity = 0, r.rate = 400, r.diameter = 3e-3, r.middle = 10, r.width = 2;
    assert_int_equal(wf_rain_make(&r, &e), WF_OK);
    size_t n = 0, inner = 0;
    for (uint64_t step = 0; step < 20000; step++) {
        double t = (double)step * 1e-3;
        size_t k = wf_rain_count(&r, step, t, 1e-3);
        n += k;
        if (fabs(t - 10) < 2) inner += k;
    }
    double want = 400 * 2 * sqrt(2 * WF_PI);
    assert_true(fabs((double)n - want) < 4 * sqrt(want));
    assert_close((double)inner / (double)n, 0.6827, 0.06);
    struct wf_raindrop a, b;
    wf_rain_drop(&r, 77, 3, &a);
    wf_rain_count(&r, 5, 1, 1e-3);
    wf_rain_drop(&r, 77, 3, &b);
    assert_memory_equal(&a, &b, sizeof a);
    r.jitter = 0.5;
    double mean = 0, spread = 0;
    for (int i = 0; i < 2000; i++) {
        double f = wf_rain_rate_varied(&r, i * 0.1 + 0.05) / fmax(wf_rain_rate(&r, i * 0.1 + 0.05), 1e-300);
        if (i < 200) mean += f / 200, spread += f * f / 200;
    }
    assert_close(mean, 1, 0.15);
    assert_close(sqrt(spread - mean * mean), 0.5, 0.25);
}

static void wrong_rain(void **state)
{
    (void)state;
    for (int k = 0; k < 5; k++) {
        struct wf_rain r = heavy();
        struct wf_err e = { 0 };
        if (k == 0) r.intensity = -1e-6;
        if (k == 1) r.largest = 9e-3;
        if (k == 2) r.intensity = 0, r.diameter = 8.1e-3;
        if (k == 3) r.high[0] = -1;
        if (k == 4) r.jitter = -1;
        assert_int_equal(wf_rain_make(&r, &e), WF_EUSAGE);
        if (k == 1 || k == 2) assert_non_null(strstr(e.text, "break up"));
    }
}

/* Caps: volume by radius and mass; height by its integral over the contact circle; the printed departures. */
static void caps(void **state)
{
    (void)state;
    for (double angle = 20 * DEGREE; angle < 91 * DEGREE; angle += 10 * DEGREE) {
        double m = 5e-6, r = wf_cap_radius(m, angle), base = wf_cap_base(r, angle), volume = 0;
        assert_close(wf_cap_volume(r, angle) * WF_WATER_DENSITY, m, 1e-12);
        for (int i = 0; i < 4000; i++) {
            double x = (i + 0.5) / 4000 * base;
            volume += 2 * WF_PI * x * wf_cap_height(r, angle, x, 1, false) * base / 4000;
        }
        assert_close(volume, wf_cap_volume(r, angle), 1e-3);
        assert_close(wf_cap_height(r, angle, base, 1, false), 0, 1e-9);
    }
    assert_close(wf_cap_volume(1, WF_PI / 3), 5 * WF_PI / 24, 1e-12);
    assert_close(wf_cap_volume_printed(1) / wf_cap_volume(1, WF_PI / 3), 1.8, 1e-12);
    assert_close(wf_cap_height(1, WF_PI / 3, 0, 1, false), 0.5, 1e-12);
    assert_close(wf_cap_height(1, WF_PI / 3, 0, 1, true), 1 - sqrt(0.75), 1e-12);
    assert_close(wf_cap_height(1, WF_PI / 4, 0, 1, true), wf_cap_height(1, WF_PI / 4, 0, 1, false), 1e-12);
    assert_close(wf_cap_radius_printed(1, 1) / wf_cap_radius(1, 1), cbrt(WF_WATER_DENSITY), 1e-12);
    assert_close(wf_cap_omega(1.05, 2), 1.1025, 1e-12);
}

/* Subdrops: their cubes sum to that of the drop to rounding, whatever beta and number. */
static void subdrops(void **state)
{
    (void)state;
    for (double beta = 0.1; beta < 1.05; beta += 0.1)
        for (size_t n = 1; n <= 32; n++) {
            double r = wf_tail_first(2e-3, fmin(beta, 1), n), sum = 0;
            for (size_t i = 0; i < n; i++, r *= fmin(beta, 1)) sum += r * r * r;
            assert_close(sum, 8e-9, 1e-12);
        }
}

static void forces(void **state)
{
    (void)state;
    assert_close(wf_drop_retention(4e-3, 40 * DEGREE, 80 * DEGREE),
                 WF_PI / 4 * 0.072 * 4e-3 * (cos(40 * DEGREE) - cos(80 * DEGREE)), 1e-12);
    assert_close(wf_drop_hanging(2e-3, 9.81) * 9.81, 0.072 * WF_PI * 2e-3, 1e-12);
    assert_close(wf_drop_attraction(1e-3, 1e-3, 1e-3), log(2), 1e-12);
    assert_true(wf_drop_attraction(2e-3, 1e-3, 1e-3) == 0);
    /* 2 mm and 5 mm drops on a leaf that yields as 0.3 g: 1.4 and 18 % of the energy stay in both */
    assert_close(4.18e-6 / (4.18e-6 + 3e-4), 0.014, 0.03);
    assert_close(wf_impact_share(1, 1), 0.25, 1e-12);
}

/* ---- Hits ---- */

/* A heap of triangles and frustums in a unit box: boxes find what trying all finds, with few tests. */
static void boxes(void **state)
{
    (void)state;
    enum { N = 600, WAYS = 4000 };
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    double *at = WF_TAKE(&a, 9 * N, double);
    struct wf_body *body = WF_TAKE(&a, N, struct wf_body);
    for (size_t i = 0; i < 9 * N; i++) {
        double near = 0.15 * wf_random_uniform(1, 1, i);
        at[i] = near + wf_random_uniform(1, 2, 3 * (i / 9) + i % 3);
    }
    for (int32_t i = 0; i < N; i++) {
        body[i] = (struct wf_body){ .at = { 3 * i, 3 * i + 1, i % 3 ? 3 * i + 2 : -1 }, .part = i };
        if (i % 3 == 0) body[i].r0 = 0.01, body[i].r1 = 0.005;
    }
    struct wf_hits h;
    assert_int_equal(wf_hits_build(body, N, at, &a, &h, &e), WF_OK);
    size_t tests = 0, found = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (uint64_t i = 0; i < WAYS; i++) {
            double from[3], to[3];
            struct wf_hit one, all;
            for (uint64_t c = 0; c < 3; c++) {
                from[c] = 1.2 * wf_random_uniform(2, i, c) - 0.1;
                to[c] = from[c] + 0.4 * (wf_random_uniform(2, i, 3 + c) - 0.5);
            }
            bool met = wf_hits_first(&h, at, from, to, 2e-3, &one, &tests);
            assert_int_equal(met, wf_hits_first_of_all(&h, at, from, to, 2e-3, &all));
            if (!met) continue;
            found++;
            assert_int_equal(one.part, all.part);
            assert_true(one.when == all.when);
        }
        for (size_t i = 0; i < 9 * N; i++) at[i] = 1.3 * at[i] + 0.05 * sin(40 * at[i]); /* moved */
        wf_hits_refit(&h, at);
    }
    assert_true(found > 500);
    assert_true(tests < (size_t)2 * WAYS * N / 20);
    assert_int_equal(wf_hits_build(body, 0, at, &a, &h, &e), WF_EINPUT);
    wf_arena_free(&a);
}

/* A drop meets a cylinder at its radius and the drop's, at the right share of its way and of the axis. */
static void cylinder(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_hits h;
    struct wf_hit hit;
    const double at[6] = { 0, 0, 0, 1, 0, 0 }, from[3] = { 0.25, 0, 1 }, to[3] = { 0.25, 0, 0 };
    const struct wf_body body = { .at = { 0, 1, -1 }, .r0 = 0.1, .r1 = 0.1 };
    assert_int_equal(wf_hits_build(&body, 1, at, &a, &h, &e), WF_OK);
    assert_true(wf_hits_first(&h, at, from, to, 0.05, &hit, NULL));
    assert_close(hit.when, 0.85, 1e-12);
    assert_close(hit.weight[0], 0.25, 1e-12);
    wf_arena_free(&a);
}

/* A blade under a larger one: no drop that falls straight reaches it, whatever the boxes. */
static void sheltered(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_hits h;
    const double at[18] = { -1, -1, 0, 3, -1, 0, -1, 3, 0, -2, -2, 1, 6, -2, 1, -2, 6, 1 };
    const struct wf_body body[2] = { { .at = { 0, 1, 2 }, .part = 0 }, { .at = { 3, 4, 5 }, .part = 1 } };
    assert_int_equal(wf_hits_build(body, 2, at, &a, &h, &e), WF_OK);
    for (uint64_t i = 0; i < 1000; i++) {
        struct wf_hit hit;
        double x = wf_random_uniform(9, 1, 2 * i) * 2 - 1, y = wf_random_uniform(9, 1, 2 * i + 1) * 2 - 1;
        assert_true(wf_hits_first(&h, at, (double[]){ x, y, 2 }, (double[]){ x, y, -1 }, 1e-3, &hit, NULL));
        assert_int_equal(hit.part, 1);
    }
    wf_arena_free(&a);
}

/* ---- Water on a leaf ---- */

struct leaf {
    struct wf_arena a;
    struct wf_leaf_water *w;
    struct wf_water_law law;
    double up[2][3];
    struct wf_leaf_lie lie;
};

/* A leaf of 80 mm that slopes down towards its tip. */
static void lay(struct leaf *l, double slope, bool printed, double fold)
{
    struct wf_err e = { 0 };
    const struct wf_blade b = { &wf_leaf_forms[0], 0.08, 0.025 };
    *l = (struct leaf){ 0 };
    wf_water_law_default(&l->law, printed);
    l->w = WF_TAKE(&l->a, 1, struct wf_leaf_water);
    if (wf_leaf_water_make(&b, fold, 128, &l->a, l->w, &e)) fail_msg("%s", e.text);
    for (int i = 0; i < 2; i++) l->up[i][0] = -sin(slope), l->up[i][2] = cos(slope);
    l->lie = (struct wf_leaf_lie){ 2, (const double(*)[3])l->up, NULL };
}

static void add(struct leaf *l, double mass, double x, double y)
{
    wf_leaf_water_add(l->w, &l->law, mass, (double[]){ x, y }, (double[]){ 0, 0 }, 0);
}

static void run(struct leaf *l, int steps)
{
    for (int i = 0; i < steps; i++) wf_leaf_water_step(l->w, &l->law, &l->lie, i * 1e-3, 1e-3);
}

/* Rests below G1 = mu G2 + H and runs above it: adhesion by the width of the contact circle, or as printed.
 */
static void threshold(void **state)
{
    (void)state;
    for (int printed = 0; printed < 2; printed++)
        for (int above = 0; above < 2; above++) {
            struct leaf l;
            double slope = 0.6, low = 1e-8, high = 1e-3;
            lay(&l, slope, printed, 0);
            for (int i = 0; i < 200; i++) { /* the mass at which both sides are equal */
                struct wf_leaf_drop d = { .mass = sqrt(low * high) };
                d.base = wf_cap_base(wf_cap_radius(d.mass, l.law.angle), l.law.angle);
                double g = l.law.gravity, hold = wf_leaf_friction(&l.law, &d, g * cos(slope));
                if (d.mass * g * sin(slope) > hold)
                    high = d.mass;
                else
                    low = d.mass;
            }
            add(&l, (above ? 1.001 : 0.999) * low, 0.03, 0);
            run(&l, 20);
            assert_int_equal(l.w->drop[0].state, above ? WF_DROP_RUN : WF_DROP_REST);
            wf_arena_free(&l.a);
        }
}

/* Newton's law down a slope with friction and printed adhesion, before it leaves the leaf. */
static void runs_as_newton(void **state)
{
    (void)state;
    struct leaf l;
    double m = 2e-5, slope = 0.5;
    lay(&l, slope, true, 0);
    add(&l, m, 0.01, 0);
    run(&l, 60);
    double a = l.law.gravity * (sin(slope) - l.law.friction * cos(slope)) - l.law.adhesion / m;
    assert_close(l.w->drop[0].v[0], a * 0.06, 1e-9);
    assert_close(l.w->drop[0].at[0] - 0.01, a * 0.06 * 0.06 / 2, 0.15); /* places are those of cells */
    wf_arena_free(&l.a);
}

/* Two drops merge: mass, momentum and centre are kept to rounding; not when they do not touch. */
static void merging(void **state)
{
    (void)state;
    struct leaf l;
    lay(&l, 0, false, 0);
    const double v[2][2] = { { 0.1, -0.02 }, { -0.05, 0.03 } };
    wf_leaf_water_add(l.w, &l.law, 1e-5, (double[]){ 0.030, 0 }, v[0], 0);
    wf_leaf_water_add(l.w, &l.law, 2e-5, (double[]){ 0.0302, 0 }, v[1], 0);
    wf_leaf_water_add(l.w, &l.law, 1e-5, (double[]){ 0.06, 0 }, (double[]){ 0, 0 }, 0);
    l.law.friction = 0, l.law.receding = l.law.advancing, l.law.film = 0; /* nothing else acts */
    run(&l, 1);
    assert_int_equal(l.w->drops, 2);
    assert_close(l.w->drop[0].mass, 3e-5, 1e-12);
    for (int c = 0; c < 2; c++)
        assert_close(3e-5 * l.w->drop[0].v[c], 1e-5 * v[0][c] + 2e-5 * v[1][c], 1e-12);
    assert_int_equal(l.w->count[WF_WATER_MERGED], 1);
    wf_arena_free(&l.a);
}

/* Hangs at the apex below the limit and falls above it: surface tension along the contact circle. */
static void hanging(void **state)
{
    (void)state;
    for (int printed = 0; printed < 2; printed++)
        for (int above = 0; above < 2; above++) {
            struct leaf l;
            lay(&l, 1.2, printed, 0.1);
            l.law.film = 0;
            double most = wf_leaf_hanging(&l.law);
            assert_close(most, printed ? 5e-4 / 9.8 : 0.072 * WF_PI * 2e-3 / 9.81, 1e-12);
            add(&l, (above ? 1.001 : 0.999) * most, 0.05, 0.003);
            run(&l, 1500);
            assert_int_equal(l.w->drops, above ? 0 : 1);
            if (!above) assert_int_equal(l.w->drop[0].state, WF_DROP_HANG);
            if (!above) assert_close(l.w->drop[0].at[0], 0.08, 1e-9);
            assert_close(l.w->fell, above ? 1.001 * most : 0, 1e-12);
            wf_arena_free(&l.a);
        }
}

/* Water in = held + film + fallen, through runs, merges and falls of many drops; the trace fades by zeta. */
static void budget(void **state)
{
    (void)state;
    struct leaf l;
    lay(&l, 0.8, false, 0.15);
    l.law.advancing = 58 * DEGREE; /* little hysteresis: drops run */
    for (uint64_t i = 0; i < 400; i++) {
        double x = 0.08 * wf_random_uniform(3, 1, 2 * i), w = wf_blade_half(&l.w->blade, x);
        add(&l, 1.4e-5, x, w * (2 * wf_random_uniform(3, 1, 2 * i + 1) - 1));
        run(&l, 5);
    }
    double out = wf_leaf_water_held(l.w) + l.w->film + l.w->fell;
    assert_close(out, l.w->received, 1e-12);
    assert_true(l.w->fell > 0.3 * l.w->received && l.w->film > 0 && l.w->count[WF_WATER_MERGED] > 20);
    assert_true(l.w->wetted <= l.w->cells);
    assert_close(l.w->film, (double)l.w->wetted * l.w->cell[0] * l.w->cell[1] * l.law.film * WF_WATER_DENSITY,
                 0.3);
    double now = 0, later = 0;
    for (size_t i = 0; i < 128; i++) {
        now = fmax(now, wf_leaf_wetness(l.w, &l.law, i, 64, 1));
        later = fmax(later, wf_leaf_wetness(l.w, &l.law, i, 64, 3));
    }
    assert_true(now > 0);
    assert_close(later / now, 0.25, 1e-5);
    wf_arena_free(&l.a);
}

/* Subdrops that a running drop trails have its volume. */
static void tail(void **state)
{
    (void)state;
    struct leaf l;
    lay(&l, 0.7, true, 0.1);
    add(&l, 3e-5, 0.01, 0.004);
    run(&l, 100);
    double r[WF_TAIL_MOST], sum = 0;
    size_t n = wf_leaf_tail(&l.law, &l.w->drop[0], r);
    assert_true(n >= 3 && n <= l.law.tail);
    for (size_t i = 0; i < n; i++) sum += pow(r[i], 3);
    assert_close(sum, pow(l.w->drop[0].radius, 3), 1e-12);
    for (size_t i = 1; i < n; i++) assert_close(r[i] / r[i - 1], 0.8, 1e-12);
    wf_arena_free(&l.a);
}

static void wrong_water(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_leaf_water *w = WF_TAKE(&a, 1, struct wf_leaf_water);
    const struct wf_blade b = { &wf_leaf_forms[0], 0.08, 0.025 }, none = { &wf_leaf_forms[0], 0.08, 0 };
    struct wf_blade_mesh m;
    for (int k = 0; k < 6; k++) {
        struct wf_err e = { 0 };
        struct wf_water_law law;
        wf_water_law_default(&law, false);
        if (k < 2) law.angle = k * WF_PI;
        if (k == 0 || k == 1) assert_int_equal(wf_water_law_check(&law, &e), WF_EUSAGE);
        if (k == 2) assert_int_equal(wf_leaf_water_make(&b, 0, 0, &a, w, &e), WF_EUSAGE);
        if (k == 3) assert_int_equal(wf_leaf_water_make(&b, 0, 4097, &a, w, &e), WF_EUSAGE);
        if (k == 4) assert_int_equal(wf_leaf_water_make(&none, 0, 128, &a, w, &e), WF_EINPUT);
        if (k == 5) assert_int_equal(wf_blade_mesh_make(&none, 8, 4, &a, &m, &e), WF_EINPUT);
        assert_true(strlen(e.text) > 20);
    }
    wf_arena_free(&a);
}

/* Area of a mesh is that of the outline; all triangles look to the same side. */
static void blades(void **state)
{
    (void)state;
    for (const struct wf_leaf_form *f = wf_leaf_forms; f->name; f++) {
        struct wf_arena a = { 0 };
        struct wf_err e = { 0 };
        struct wf_blade_mesh m;
        const struct wf_blade b = { f, 0.1, 0.05 * f->breadth };
        assert_int_equal(wf_blade_mesh_make(&b, 60, 6, &a, &m, &e), WF_OK);
        double sum = 0;
        for (size_t t = 0; t < m.triangles; t++) {
            const double *p = m.at + 2 * m.corner[3 * t], *q = m.at + 2 * m.corner[3 * t + 1],
                         *r = m.at + 2 * m.corner[3 * t + 2];
            double area = ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
            assert_true(area > 0);
            sum += area;
        }
        assert_close(sum, wf_blade_area(&b), 0.01);
        wf_arena_free(&a);
    }
}

/* ---- Nodes from points ---- */

/* Points around a quarter of a circle: centres in order along it; same seed, same answer. */
static void clusters(void **state)
{
    (void)state;
    enum { N = 1200, K = 9 };
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_cloud p = { N, WF_TAKE(&a, 3 * N, double) };
    for (size_t i = 0; i < N; i++) {
        double u = WF_PI / 2 * (double)i / N, v = 2.4 * (double)i, r = 1 + 0.02 * cos(v);
        p.at[3 * i] = r * sin(u), p.at[3 * i + 1] = 0.02 * sin(v), p.at[3 * i + 2] = 1 - r * cos(u);
    }
    struct wf_clusters c, again;
    const double base[3] = { 0, 0, 0 };
    assert_int_equal(wf_kmeans(&p, K, 4, base, &a, &c, &e), WF_OK);
    assert_int_equal(wf_kmeans(&p, K, 4, base, &a, &again, &e), WF_OK);
    assert_memory_equal(c.centre, again.centre, 3 * K * sizeof(double));
    size_t all = 0;
    for (size_t k = 0; k < K; k++) {
        all += c.count[k];
        if (k)
            assert_true(atan2(c.centre[3 * k], 1 - c.centre[3 * k + 2]) >
                        atan2(c.centre[3 * k - 3], 1 - c.centre[3 * k - 1]));
    }
    assert_int_equal(all, N);
    assert_int_equal(wf_kmeans(&p, N + 1, 4, base, &a, &c, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "a point for each"));
    for (size_t i = 0; i < 3 * N; i++) p.at[i] = (double)(i / 3 % 2); /* two places alone */
    e = (struct wf_err){ 0 };
    assert_int_equal(wf_kmeans(&p, 4, 4, base, &a, &c, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "stays empty"));
    wf_arena_free(&a);
}

static void clouds(void **state)
{
    (void)state;
    static const char good[] = "# a branch\n0 0 0\n0.1, 0, 1e-2\n\n0.2\t0\t0.02 # end\n",
                      bad[] = "0 0 0\n1 2\n1 x 3\n1 2 3 4\n";
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_cloud p;
    struct scratch s;
    scratch_write(&s, good, sizeof good - 1);
    assert_int_equal(wf_cloud_read(s.path, &a, &p, &d, &e), WF_OK);
    assert_int_equal(p.n, 3);
    assert_close(p.at[5], 1e-2, 1e-15);
    scratch_remove(&s);
    scratch_write(&s, bad, sizeof bad - 1);
    assert_int_equal(wf_cloud_read(s.path, &a, &p, &d, &e), WF_EINPUT);
    assert_int_equal(d.errors, 3);
    assert_int_equal(d.first->line, 2);
    scratch_remove(&s);
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(speeds_of_fall), cmocka_unit_test(spectrum),   cmocka_unit_test(intensity_arrives),
        cmocka_unit_test(storm),          cmocka_unit_test(wrong_rain), cmocka_unit_test(caps),
        cmocka_unit_test(subdrops),       cmocka_unit_test(forces),     cmocka_unit_test(boxes),
        cmocka_unit_test(cylinder),       cmocka_unit_test(sheltered),  cmocka_unit_test(threshold),
        cmocka_unit_test(runs_as_newton), cmocka_unit_test(merging),    cmocka_unit_test(hanging),
        cmocka_unit_test(budget),         cmocka_unit_test(tail),       cmocka_unit_test(wrong_water),
        cmocka_unit_test(blades),         cmocka_unit_test(clusters),   cmocka_unit_test(clouds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
