/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rain on a branch, whole runs: budgets that close, the five effects, shelter, ringing, the printed preset.
 */
#include "data/species.h"
#include "base/num.h"
#include "base/parallel.h"
#include "base/vec3.h"
#include "close.h"
#include "load/load.h"
#include "study/prism_check.h"
#include "study/rain_departures.h"
#include "study/rain_run.h"
#include "study/rain_shake.h"
#include <stdlib.h>
#include <string.h>

struct case_of {
    struct wf_arena a;
    struct wf_diag d;
    struct wf_species sp;
    struct wf_rain_spec spec;
    struct wf_rain_result r;
};

static void start(struct case_of *c, bool printed)
{
    struct wf_err e = { 0 };
    memset(c, 0, sizeof *c);
    c->d.arena = &c->a;
    if (wf_species_read("species/poplar.yaml", &wf_laws, &c->a, &c->sp, &c->d, &e)) fail_msg("%s", e.text);
    wf_rain_spec_default(&c->spec, printed);
    c->spec.scene.species = &c->sp;
    c->spec.grid = 128;
}

static void go(struct case_of *c)
{
    struct wf_err e = { 0 };
    if (wf_rain_run(&c->spec, &c->a, &c->d, &c->r, &e)) fail_msg("%s", e.text);
}

static size_t key_of(const struct wf_rain_result *r, const char *event)
{
    for (size_t k = 0; k < r->keys; k++)
        if (!strcmp(r->key[k].event, event)) return k + 1;
    return 0;
}

static bool warned(const struct wf_diag *d, const char *code)
{
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->code && !strcmp(f->code, code)) return true;
    return false;
}

/* Every effect of the paper in the staged run, as printed and corrected; water to 1e-12, energy to 1e-9. */
static void staged(void **state)
{
    (void)state;
    for (int printed = 0; printed < 2; printed++) {
        struct case_of c;
        start(&c, printed);
        c.spec.staged = true;
        go(&c);
        static const char *const events[] = { "hit", "ran", "merged", "hung", "fell", "rebound", "end" };
        for (size_t i = 0; i < WF_COUNT(events); i++) assert_true(key_of(&c.r, events[i]) > 0);
        assert_true(c.r.water.off <= 1e-12);
        assert_true(c.r.energy.off <= 1e-9);
        assert_true(c.r.energy.damping > 0 && c.r.energy.push > 0);
        /* all that the drops gave is in the books: what went to the leaf is a share of what arrived */
        assert_true(c.r.energy.push < c.r.energy.drops);
        assert_true(printed ? c.r.energy.push > 0.8 * c.r.energy.drops
                            : c.r.energy.push < 0.2 * c.r.energy.drops);
        double up = 0, side = 0, turn = 0, drop = 0;
        for (size_t i = 1; i < c.r.rows; i++) {
            up = fmax(up, fabs(c.r.row[i].tip[2])), side = fmax(side, fabs(c.r.row[i].tip[1]));
            turn = fmax(turn, fabs(c.r.row[i].twist));
            drop = fmax(drop, c.r.row[i - 1].petiole_force - c.r.row[i].petiole_force);
        }
        assert_true(up > 1e-4 && side > 1e-4 && turn > 0.02);
        /* the load of what hung vanishes at once */
        assert_true(drop > 0.9 * 1.7e-5 * 9.8);
        wf_rain_departures(&c.r, &c.d);
        assert_true(warned(&c.d, "assumed-values"));
        assert_int_equal(warned(&c.d, "impact-energy"), printed);
        assert_int_equal(warned(&c.d, "explicit-euler"), printed);
        wf_arena_free(&c.a);
    }
}

/* Rain by intensity in a slanting wind: the water budget closes; the same run gives the same bytes. */
static void random_rain(void **state)
{
    (void)state;
    struct case_of c[2];
    for (int k = 0; k < 2; k++) {
        start(&c[k], false);
        c[k].spec.drops = 0, c[k].spec.rain.intensity = 100 / 3.6e6, c[k].spec.duration = 0.8;
        size_t steps = 802;
        double *wind = WF_TAKE(&c[k].a, 2 * steps, double);
        for (size_t i = 0; i < steps; i++) wind[2 * i] = 3, wind[2 * i + 1] = -1;
        c[k].spec.wind = wind;
        go(&c[k]);
        assert_true(c[k].r.hits > 20);
        assert_true(c[k].r.water.off <= 1e-12);
        assert_true(c[k].r.energy.off <= 1e-9);
    }
    assert_int_equal(c[0].r.rows, c[1].r.rows);
    assert_memory_equal(c[0].r.row, c[1].r.row, c[0].r.rows * sizeof *c[0].r.row);
    assert_int_equal(c[0].r.events, c[1].r.events);
    for (size_t i = 0; i < c[0].r.events; i++)
        assert_true(c[0].r.event[i].time == c[1].r.event[i].time &&
                    c[0].r.event[i].mass == c[1].r.event[i].mass);
    for (int k = 0; k < 2; k++) wf_arena_free(&c[k].a);
}

/* A leaf of the species' area, and its petiole; without them the defaults stay. */
static void leaf_of_species(void **state)
{
    (void)state;
    struct case_of c;
    start(&c, false);
    for (int given = 0; given < 2; given++) {
        struct wf_scene_spec s = c.spec.scene;
        c.sp.crown.leaf_area = (struct wf_value){ .value = 12e-4, .given = given };
        c.sp.crown.petiole_length = (struct wf_value){ .value = 0.018, .given = given };
        c.sp.crown.petiole_diameter = (struct wf_value){ .value = 9e-4, .given = given };
        c.sp.crown.petiole_modulus = (struct wf_value){ .value = 7e8, .given = given };
        wf_scene_spec_leaf(&s);
        const struct wf_blade b = { s.form, s.leaf_length, s.leaf_length * s.form->breadth / 2 };
        if (given) assert_close(wf_blade_area(&b), 12e-4, 1e-12);
        assert_close(s.petiole, given ? 0.018 : c.spec.scene.petiole, 1e-12);
        assert_close(s.petiole_radius, given ? 4.5e-4 : c.spec.scene.petiole_radius, 1e-12);
        assert_close(s.petiole_youngs, given ? 7e8 : c.spec.scene.petiole_youngs, 1e-12);
        assert_true(given || s.leaf_length == c.spec.scene.leaf_length);
    }
    wf_arena_free(&c.a);
}

/* Effective gravity: a leaf that gains speed upwards at 2 g presses with 3 g on its drops after some drop
 * times; at rest, and through the jump of an impact, with 1. */
static void effective_gravity(void **state)
{
    (void)state;
    struct case_of c;
    struct wf_err e = { 0 };
    struct wf_shake k;
    start(&c, false);
    if (wf_scene_make(&c.spec.scene, 9.81, &c.a, &c.r.scene, &e)) fail_msg("%s", e.text);
    const struct wf_rain_scene *s = &c.r.scene;
    double *v = WF_TAKE(&c.a, 9 * s->prism.sections, double);
    assert_int_equal(wf_shake_make(s, &c.a, &k, &e), WF_OK);
    double area = 0; /* both halves of all strips are the blade */
    for (size_t i = 0; i <= s->spec.vein_prisms; i++) area += 2 * k.area[i];
    assert_close(area, wf_blade_area(&s->blade), 5e-3);
    for (int step = 0; step < 60; step++) {
        wf_shake_begin(&k, s, v);
        for (size_t i = 2; i < 9 * s->prism.sections; i += 3) v[i] += 2 * 9.81 * 1e-3;
        wf_shake_move(&k, s, s->rest, v, 1e-3, 9.81);
    }
    assert_close(k.pull[3], 3, 1e-6);
    struct wf_leaf_lie lie = wf_shake_lie(&k, s, 1);
    double size = sqrt(wf_dot(lie.up[3], lie.up[3]));
    assert_close(size, 3, 1e-6);
    for (int step = 0; step < 60; step++) {
        for (size_t i = 2; i < 9 * s->prism.sections; i += 3) v[i] -= 0.3; /* struck */
        wf_shake_begin(&k, s, v);
        wf_shake_move(&k, s, s->rest, v, 1e-3, 9.81);
    }
    assert_close(k.pull[3], 1, 1e-6);
    wf_arena_free(&c.a);
}

/* Push on blades in a wind: 1/2 rho Cd A un^2 along the normal of each half; its work over a small way. */
static void push_of_wind(void **state)
{
    (void)state;
    struct case_of c;
    struct wf_err e = { 0 };
    struct wf_shake k;
    start(&c, false);
    c.spec.scene.leaves = 1, c.spec.scene.fold = 0, c.spec.scene.droop = 0.5;
    c.spec.scene.petiole_youngs = 1e12; /* it stays as drawn */
    if (wf_scene_make(&c.spec.scene, 9.81, &c.a, &c.r.scene, &e)) fail_msg("%s", e.text);
    const struct wf_rain_scene *s = &c.r.scene;
    size_t n = 9 * s->prism.sections;
    double *v = WF_TAKE(&c.a, n, double), *load = WF_TAKE(&c.a, n, double), *x = WF_TAKE(&c.a, n, double);
    assert_int_equal(wf_shake_make(s, &c.a, &k, &e), WF_OK);
    wf_shake_wind(&k, s, s->rest, v, (const double[]){ 4, 0 }, load);
    double normal[3], sum[3] = { 0 }, work = 0;
    wf_scene_normal(s, s->rest, 0, (const double[]){ 0.04, 0 }, normal);
    double force = 0.5 * 1.2 * 1.2 * wf_blade_area(&s->blade) * pow(4 * normal[0], 2);
    for (size_t i = 0; i < n; i++) sum[i % 3] += load[i];
    assert_close(sqrt(wf_dot(sum, sum)), force, 0.02);
    assert_true(sum[0] > 0);
    for (size_t i = 0; i < n; i++)
        x[i] = s->rest[i] + (i % 3 == 0 ? 1e-3 : 0), work += 1e-3 * load[i] * (i % 3 == 0);
    assert_close(wf_shake_work(&k, s, x), work, 1e-9);
    wf_arena_free(&c.a);
}

/* A steady wind moves the leaves downwind and its work is in the books; nothing of it as printed. Drops that
 * feel the leaves' motion leave them sooner. */
static void wind_on_leaves(void **state)
{
    (void)state;
    double held[2], wind[2 * 802];
    for (size_t i = 0; i < 802; i++) wind[2 * i] = 6, wind[2 * i + 1] = 0;
    for (int k = 0; k < 3; k++) {
        struct case_of c;
        start(&c, k == 2);
        c.spec.wind = wind, c.spec.shaken = k == 1, c.spec.duration = 0.8;
        c.spec.drops = 0, c.spec.rain.intensity = 150 / 3.6e6;
        go(&c);
        assert_true(c.r.water.off <= 1e-12 && c.r.energy.off <= 1e-9);
        if (k < 2) assert_true(c.r.energy.wind > 1e-6 && c.r.row[c.r.rows - 1].tip[0] > 1e-3);
        if (k < 2) held[k] = c.r.water.held;
        if (k == 2) assert_true(c.r.energy.wind == 0);
        wf_rain_departures(&c.r, &c.d);
        assert_int_equal(warned(&c.d, "leaf-drag"), k < 2);
        assert_int_equal(warned(&c.d, "shaking"), k == 1);
        wf_arena_free(&c.a);
    }
    assert_true(held[1] < 0.8 * held[0]);
}

struct pair {
    struct case_of c[2];
};
static enum wf_status one_of(void *context, size_t k, struct wf_err *e)
{
    struct case_of *c = &((struct pair *)context)->c[k];
    return wf_rain_run(&c->spec, &c->a, &c->d, &c->r, e);
}

/* Rain on one thread, and twice on two at once: the same bytes. */
static void threads(void **state)
{
    (void)state;
    static struct pair p[2];
    for (int n = 1; n <= 2; n++) {
        struct wf_err e = { 0 };
        for (int k = 0; k < 2; k++) {
            start(&p[n - 1].c[k], false);
            p[n - 1].c[k].spec.drops = 200, p[n - 1].c[k].spec.duration = 0.8;
        }
        if (wf_parallel(2, (size_t)n, one_of, &p[n - 1], &e)) fail_msg("%s", e.text);
    }
    const struct wf_rain_result *first = &p[0].c[0].r;
    assert_true(first->hits > 5);
    for (int i = 1; i < 4; i++) {
        const struct wf_rain_result *r = &p[i / 2].c[i % 2].r;
        assert_int_equal(r->rows, first->rows);
        assert_memory_equal(r->row, first->row, r->rows * sizeof *r->row);
        assert_memory_equal(&r->water, &first->water, sizeof r->water);
        assert_memory_equal(&r->energy, &first->energy, sizeof r->energy);
    }
    for (int i = 0; i < 4; i++) wf_arena_free(&p[i / 2].c[i % 2].a);
}

/* A leaf that no drop reaches stays dry: the staged drops fall on the first leaf alone. */
static void dry_leaf(void **state)
{
    (void)state;
    struct case_of c;
    start(&c, false);
    c.spec.staged = true, c.spec.scene.leaves = 2;
    go(&c);
    assert_true(c.r.leaf[1].received == 0 && c.r.leaf[1].wetted == 0);
    assert_true(c.r.leaf[0].received > 0);
    wf_arena_free(&c.a);
}

/* After the last drop the tip rings down about as the damping is set. */
static void ringing(void **state)
{
    (void)state;
    struct case_of c;
    start(&c, false);
    c.spec.staged = true, c.spec.scene.leaves = 1;
    go(&c);
    assert_close(c.r.ring_frequency, c.r.frequency, 0.15);
    assert_close(c.r.ring_decrement, 2 * WF_PI * c.spec.damping, 0.15);
    wf_arena_free(&c.a);
    double x[400], f, decrement; /* a known one: 5 Hz, decrement 0.2 */
    for (int i = 0; i < 400; i++) x[i] = exp(-0.2 * 5 * i * 0.005) * sin(2 * WF_PI * 5 * i * 0.005);
    wf_ring_of(x, 400, 0.005, &f, &decrement);
    assert_close(f, 5, 0.01);
    assert_close(decrement, 0.2, 0.03);
    wf_ring_of(x, 10, 0.005, &f, &decrement);
    assert_true(isnan(f) && isnan(decrement));
}

/* Explicit Euler as printed: refused above its limit, with the limit in words. */
static void explicit_step(void **state)
{
    (void)state;
    struct case_of c;
    struct wf_err e = { 0 };
    start(&c, true);
    c.spec.method = WF_PRISM_EULER;
    assert_int_equal(wf_rain_run(&c.spec, &c.a, &c.d, &c.r, &e), WF_EUSAGE);
    assert_non_null(strstr(e.text, "limit"));
    wf_arena_free(&c.a);
}

/* What the paper says of springs without a law: long branches fold and do not come back in time, short ones
 * do; restoring springs bring all back as soon as the short ones. */
static void disorder(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    const struct wf_prism_rod rod = { 0.4, 3e-3, 2e9, 2e9 / 16, 900, 1 };
    struct wf_prism_order o[WF_PRISM_ORDERS];
    if (wf_prism_disorder(&rod, &a, o, &e)) fail_msg("%s", e.text);
    struct wf_prism_answer one = { 0 };
    assert_int_equal(wf_prism_cantilever(&rod, 8, 1e-3, 0, &a, &one, &e), WF_OK);
    assert_true(one.tip > 0 && one.tip < 1e-3 && one.turn == 0); /* held by springs of 1 N/m */
    for (size_t k = 0; k < WF_PRISM_ORDERS; k++) {
        bool held = k >= WF_PRISM_CHECKS, folds = !held && o[k].prisms >= 32;
        assert_int_equal(isnan(o[k].back), folds);
        if (!folds) assert_true(o[k].back < 1.5 && o[k].left < 1e-4);
        if (folds) assert_true(o[k].fold > 35 * WF_PI / 180 && o[k].left > 0.5);
        if (held) assert_true(o[k].fold < 2 * WF_PI / 180 && o[k].sag < 0.02);
    }
    wf_arena_free(&a);
}

static void wrong_runs(void **state)
{
    (void)state;
    for (int k = 0; k < 7; k++) {
        struct case_of c;
        struct wf_err e = { 0 };
        start(&c, false);
        if (k == 0) c.spec.loss = 1.1;
        if (k == 1) c.spec.splash = -0.1;
        if (k == 2) c.spec.step = 0;
        if (k == 3) c.spec.rain.diameter = 8.5e-3;
        if (k == 4) c.spec.grid = 0;
        if (k == 5) c.spec.scene.leaves = 0;
        if (k == 6) c.spec.scene.leaf_length = 0;
        enum wf_status s = wf_rain_run(&c.spec, &c.a, &c.d, &c.r, &e);
        assert_true(s == WF_EUSAGE || s == WF_EINPUT);
        assert_true(strlen(e.text) > 20);
        wf_arena_free(&c.a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(disorder),     cmocka_unit_test(staged),         cmocka_unit_test(effective_gravity),
        cmocka_unit_test(push_of_wind), cmocka_unit_test(wind_on_leaves), cmocka_unit_test(leaf_of_species),
        cmocka_unit_test(threads),      cmocka_unit_test(random_rain),    cmocka_unit_test(dry_leaf),
        cmocka_unit_test(ringing),      cmocka_unit_test(explicit_step),  cmocka_unit_test(wrong_runs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
