/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wf_analyze on stems whose answers are known: closed forms, balance of forces, invariance, limits. */
#include "post.h"
#include "study/limits.h"
#include "study/verdict.h"
#include <string.h>

/* Of the post. */
#define HEIGHT 10.0
#define RADIUS 0.1

static void set_up(struct post *b) { post_begin(b, HEIGHT, RADIUS); }

static enum wf_status run(struct post *b, const char *solver, const double *speeds, size_t n)
{
    return wf_analyze(&b->species, &b->model, &b->scenario, &b->search, wf_solver_named(solver), &b->options,
                      speeds, n, &b->arena, &b->diag, &b->an, &b->err);
}

static double sum(const double *v, size_t n)
{
    double s = 0;
    for (size_t i = 0; i < n; i++) s += v[i];
    return s;
}

/* A stiff post: drag 1/2 rho Cd D H U^2, and Euler-Bernoulli's q H^4/(8 E I), q H^3/(6 E I), q H^2/2. */
static void test_closed_forms(void **state)
{
    (void)state;
    static const char *const solvers[] = { "linear", "beam" };
    for (size_t k = 0; k < 2; k++) {
        struct post b;
        set_up(&b);
        assert_int_equal(run(&b, solvers[k], (const double[]){ 2 }, 1), WF_OK);
        const struct wf_at_speed *at = &b.an.at[0];
        double q = 0.5 * 1.2 * 1.0 * 2 * RADIUS * 4, inertia = M_PI / 4 * pow(RADIUS, 4);
        double loose = k ? 1e-4 : 1e-6; /* the bent shape differs by the square of the slope */
        assert_close(at->drag, q * HEIGHT, loose);
        assert_close(at->base_shear, q * HEIGHT, loose);
        assert_close(at->base_moment, q * HEIGHT * HEIGHT / 2, loose);
        assert_close(at->tip_deflection, q * pow(HEIGHT, 4) / (8 * POST_YOUNGS * inertia), loose);
        assert_close(at->tip_angle, q * pow(HEIGHT, 3) / (6 * POST_YOUNGS * inertia), loose);
        assert_close(at->tip_deflection_share, at->tip_deflection / HEIGHT, 1e-12);
        assert_close(sum(at->figures.projected_area, b.an.tree.n), 2 * RADIUS * HEIGHT, loose);
        assert_close(at->breakage.largest_stress, q * HEIGHT * HEIGHT / 2 * RADIUS / inertia, loose);
        assert_true(at->lift <= at->tip_angle * at->drag); /* a leaning axis pushes aside a little */
        assert_close(at->weight, 0, 1e-12);
        wf_arena_free(&b.arena);
    }
}

/* Stress of a stem under loads on its unbent shape grows with U^2: U_c = U sqrt(safety at U). */
static void test_critical_speed(void **state)
{
    (void)state;
    struct post b;
    set_up(&b);
    assert_int_equal(run(&b, "linear", (const double[]){ 20 }, 1), WF_OK);
    assert_int_equal(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_FOUND);
    assert_close(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed,
                 20 * sqrt(b.an.at[0].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety), 2e-6);
    double inertia = M_PI / 4 * pow(RADIUS, 4), moment = POST_STRENGTH * inertia / RADIUS;
    assert_close(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed,
                 sqrt(moment * 2 / (HEIGHT * HEIGHT) / (0.5 * 1.2 * 2 * RADIUS)), 2e-6);
    assert_int_equal(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].row, 0);
    assert_close(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].height, 0, 1e-9);
    double before = b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed;
    /* the sweep begins in still air, is even behind its first, closer stretch, and reaches past the critical
     * speed */
    assert_true(b.an.sweep_n > 35);
    assert_close(b.an.sweep[0].speed, 0, 1e-12);
    assert_close(b.an.sweep[0].tip_deflection, 0, 1e-12);
    for (size_t k = 1; k < b.an.sweep_n; k++)
        assert_close(b.an.sweep[k].speed - b.an.sweep[k - 1].speed, (k > 20 ? 4 : 1) * b.an.sweep[1].speed,
                     1e-9);
    assert_true(b.an.sweep[b.an.sweep_n - 1].speed >= before);
    for (size_t k = 1; k < b.an.sweep_n; k++) /* safety times U^2 stays the same */
        assert_close(b.an.sweep[k].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety *
                         pow(b.an.sweep[k].speed / 20, 2),
                     b.an.at[0].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety, 1e-6);
    wf_arena_free(&b.arena);
    /* a thicker stem stands more, a taller one less */
    set_up(&b);
    b.model.radius = 1.2 * RADIUS;
    assert_int_equal(run(&b, "linear", (const double[]){ 20 }, 1), WF_OK);
    assert_close(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, before * 1.2,
                 2e-6); /* moment ~ r^3, drag ~ r */
    wf_arena_free(&b.arena);
    set_up(&b);
    b.model.height = 2 * HEIGHT;
    assert_int_equal(run(&b, "linear", (const double[]){ 20 }, 1), WF_OK);
    assert_close(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, before / 2, 2e-6);
    wf_arena_free(&b.arena);
}

/* A crown adds 1/2 rho Cd A U^2 with A = leaf area x frontal share, and its leaves' weight. */
static void test_crown(void **state)
{
    (void)state;
    struct post b;
    set_up(&b);
    b.model.leaf_area = 10;
    b.scenario.gravity = 9.81;
    assert_int_equal(run(&b, "linear", (const double[]){ 10 }, 1), WF_OK);
    const struct wf_at_speed *at = &b.an.at[0];
    double axis = 0.5 * 1.2 * 2 * RADIUS * HEIGHT * 100, crown = 0.5 * 1.2 * 0.5 * 10 * 0.4 * 100;
    assert_close(at->drag, axis + crown, 1e-9);
    assert_close(sum(at->figures.drag, b.an.tree.n), at->drag, 1e-12);
    assert_close(sum(at->figures.projected_area, b.an.tree.n), 2 * RADIUS * HEIGHT + 4, 1e-9);
    assert_close(at->weight, 9.81 * (900 * M_PI * RADIUS * RADIUS * HEIGHT + 0.2 * 10), 1e-9);
    wf_arena_free(&b.arena);
    set_up(&b); /* Vogel: twice the reference speed, area halves */
    b.model.leaf_area = 10;
    b.species.streamlining = (struct wf_law_use){
        .law = "vogel", .parameter = { measured(-1), { .value = 5 } }, .low = 1, .high = 12
    };
    assert_int_equal(run(&b, "linear", (const double[]){ 10, 20 }, 2), WF_OK);
    assert_close(b.an.at[0].drag, axis + crown / 2, 1e-9);
    assert_close(sum(b.an.at[0].figures.projected_area, b.an.tree.n), 2 * RADIUS * HEIGHT + 2, 1e-9);
    assert_non_null(strstr(post_warning(&b, "streamline-range"), "12 m/s"));
    wf_arena_free(&b.arena);
}

/* Far bent: the wind's force by rows is what the base holds, and the direction of the wind does not matter.
 */
static void test_balance(void **state)
{
    (void)state;
    struct post b;
    double before[4] = { 0 };
    static const double azimuth[] = { 0, 1.1, -2.5 };
    for (size_t k = 0; k < 3; k++) {
        set_up(&b);
        b.model.radius = 0.04;
        b.model.leaf_area = 6;
        b.model.tip_ratio = 0.3;
        b.scenario.gravity = 9.81;
        b.scenario.profile = "power";
        b.scenario.azimuth = azimuth[k];
        assert_int_equal(run(&b, "beam", (const double[]){ 12 }, 1), WF_OK);
        const struct wf_at_speed *at = &b.an.at[0];
        assert_true(at->tip_deflection_share > 0.3);
        assert_close(at->base_shear, at->drag, 1e-9);
        assert_close(fabs(at->response.base_force[2]), at->weight + at->lift, 1e-4);
        double now[4] = { at->tip_deflection, at->tip_angle, at->base_moment,
                          b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed };
        for (int i = 0; k && i < 4; i++) assert_close(now[i], before[i], 1e-6);
        memcpy(before, now, sizeof now);
        wf_arena_free(&b.arena);
    }
}

/* The printed drag is the base shear, and at the critical speed the least safety is 1 (rods integrate their
 * load along the way, to 1e-8).
 */
static void test_agreement(void **state)
{
    (void)state;
    static const char *const solver[] = { "beam",    "linear",
                                          "chain",   "chain-as-printed",
                                          "deflect", "deflect-as-printed" };
    for (size_t k = 0; k < sizeof solver / sizeof *solver; k++) {
        struct post b;
        set_up(&b);
        b.model.radius = 0.04;
        b.model.tip_ratio = 0.3;
        b.scenario.gravity = 9.81;
        b.scenario.profile = "power";
        assert_int_equal(run(&b, solver[k], (const double[]){ 7 }, 1), WF_OK);
        assert_close(b.an.at[0].base_shear, b.an.at[0].drag, 1e-9);
        assert_int_equal(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_FOUND);
        double critical = b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed,
               height = b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].height;
        wf_arena_free(&b.arena);
        set_up(&b);
        b.model.radius = 0.04;
        b.model.tip_ratio = 0.3;
        b.scenario.gravity = 9.81;
        b.scenario.profile = "power";
        assert_int_equal(run(&b, solver[k], &critical, 1), WF_OK);
        const struct wf_worst *at = &b.an.at[0].worst[WF_BREAKAGE][WF_SCOPE_TREE];
        assert_close(at->safety, 1, 1e-5);
        const struct wf_tree *t = &b.an.tree;
        assert_close(t->z0[at->row] + at->place * (t->z1[at->row] - t->z0[at->row]), height, 1e-3);
        wf_arena_free(&b.arena);
    }
}

static void test_still_air(void **state)
{
    (void)state;
    struct post b;
    set_up(&b);
    b.scenario.gravity = 9.81;
    assert_int_equal(run(&b, "beam", (const double[]){ 0 }, 1), WF_OK);
    assert_close(b.an.at[0].tip_angle, 0, 1e-12);
    assert_close(b.an.at[0].drag, 0, 1e-12);
    assert_close(b.an.at[0].base_moment, 0, 1e-6);
    assert_true(b.an.at[0].tip_deflection < 1e-4); /* pressed together by its weight, not bent */
    wf_arena_free(&b.arena);
}

/* From 12 in on, of the wood where it breaks, the size of a stem is said to be left out. */
static void test_size(void **state)
{
    (void)state;
    static const struct {
        double radius, bark;
        bool said;
    } stem[] = { { 0.152, 0, false }, { 0.153, 0, true }, { 0.162, 0.01, false }, { 0.163, 0.01, true } };
    for (size_t k = 0; k < WF_COUNT(stem); k++) {
        struct post b;
        set_up(&b);
        b.model.radius = stem[k].radius;
        b.model.bark.thickness = stem[k].bark;
        b.model.bark.kind = stem[k].bark > 0 ? WF_BARK_MEASURED : WF_BARK_NONE;
        assert_int_equal(run(&b, "beam", (const double[]){ 5 }, 1), WF_OK);
        const char *text = post_warning(&b, "size-effect");
        assert_int_equal(text != NULL, stem[k].said);
        if (text) assert_non_null(strstr(text, "18 to 26 % lower")); /* 1 - (50 or 20 mm / 0.306 m)^(1/9) */
        assert_close(wf_verdict_size(&b.an), stem[k].said ? 2 * (stem[k].radius - stem[k].bark) : 0, 1e-9);
        wf_arena_free(&b.arena);
    }
}

static void test_limits(void **state)
{
    (void)state;
    struct post b;
    set_up(&b); /* nothing to say about a stiff post with sources, but that nobody saw one so strong ... */
    assert_int_equal(run(&b, "beam", (const double[]){ 5 }, 1), WF_OK);
    assert_non_null(post_warning(&b, "unverified-safety"));
    assert_non_null(post_warning(&b, "unverified-wind"));
    assert_int_equal(b.diag.warnings, 2);
    wf_arena_free(&b.arena);
    set_up(&b); /* ... but for a small-deflection method's breakage, where the post is far bent */
    assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_OK);
    assert_true(!wf_limits_small_passed(&b.an.at[0]) &&
                wf_limits_small_passed(&b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].at));
    assert_int_equal(b.diag.warnings, 3); /* and the two above */
    assert_non_null(strstr(post_warning(&b, "small-deflection"), "the critical wind speed of "));
    wf_arena_free(&b.arena);

    set_up(&b);
    b.model.radius = 0.03;
    assert_int_equal(run(&b, "linear", (const double[]){ 1, 30 }, 2), WF_OK);
    assert_non_null(post_warning(&b, "small-deflection"));
    assert_non_null(strstr(post_warning(&b, "small-deflection"), "at 30 m/s"));
    wf_arena_free(&b.arena);

    set_up(&b);
    b.level.density.standing = WF_ASSUMED;
    b.level.radius.standing = WF_ASSUMED; /* the model gives the radius, so this one takes no part */
    b.species.preset = "someone2001";
    b.species.crown.frontal_share.standing = WF_ASSUMED;
    b.model.leaf_area = 10;
    assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_OK);
    assert_non_null(strstr(post_warning(&b, "assumed-values"), "stem: density; crown: frontal_share"));
    assert_non_null(strstr(post_warning(&b, "as-printed"), "someone2001"));
    wf_arena_free(&b.arena);

    set_up(&b); /* without leaves the crown's values take no part */
    b.species.crown.frontal_share.standing = WF_ASSUMED;
    assert_int_equal(run(&b, "beam", (const double[]){ 5 }, 1), WF_OK);
    assert_null(post_warning(&b, "assumed-values"));
    wf_arena_free(&b.arena);

    set_up(&b); /* many speeds are named by their ends */
    b.model.radius = 0.03;
    assert_int_equal(run(&b, "linear", (const double[]){ 1, 25, 26, 27, 28, 30 }, 6), WF_OK);
    assert_non_null(strstr(post_warning(&b, "small-deflection"), "at 5 wind speeds from 25 to 30 m/s"));
    wf_arena_free(&b.arena);

    set_up(&b);
    b.level.modulus_of_rupture = (struct wf_value){ .standing = WF_ASSUMED };
    assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_OK);
    assert_int_equal(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_NO_STRENGTH);
    assert_true(isnan(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed));
    assert_true(isnan(b.an.at[0].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety));
    assert_non_null(post_warning(&b, "no-strength"));
    wf_arena_free(&b.arena);

    set_up(&b);
    b.search.speed_max = 10;
    assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_OK);
    assert_int_equal(b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_ABOVE);
    assert_non_null(strstr(post_warning(&b, "critical-above-range"), "10 m/s"));
    wf_arena_free(&b.arena);

    set_up(&b);
    b.scenario.profile = "log";
    b.scenario.displacement = 2;
    assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_OK);
    assert_non_null(strstr(post_warning(&b, "profile-range"), "20 %"));
    wf_arena_free(&b.arena);

    set_up(&b);
    b.level.drag_coefficient = (struct wf_value){ .value = NAN, .standing = WF_ASSUMED };
    b.scenario.air_density = 2000; /* 200 m/s in something thicker than water */
    assert_int_equal(run(&b, "linear", (const double[]){ 200 }, 1), WF_OK);
    assert_non_null(post_warning(&b, "reynolds-range"));
    wf_arena_free(&b.arena);
}

/* A rod far beyond Greenhill's height: a result, not a crash. */
static void test_cannot_stand(void **state)
{
    (void)state;
    struct post b;
    set_up(&b);
    b.model.height = 60;
    b.model.radius = 0.03;
    b.scenario.gravity = 9.81;
    assert_int_equal(run(&b, "beam", (const double[]){ 0, 5 }, 2), WF_OK);
    bool said = post_warning(&b, "no-equilibrium") || post_warning(&b, "limit-point");
    assert_true(said || b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome == WF_CRITICAL_SELF_WEIGHT);
    wf_arena_free(&b.arena);
}

static void test_refused(void **state)
{
    (void)state;
    struct post b;
    set_up(&b);
    assert_int_equal(run(&b, "linear", NULL, 0), WF_EUSAGE);
    set_up(&b);
    assert_int_equal(run(&b, "linear", (const double[]){ NAN }, 1), WF_EUSAGE);
    set_up(&b);
    assert_int_equal(run(&b, "linear", (const double[]){ -1 }, 1), WF_EUSAGE);
    set_up(&b);
    b.scenario.profile = "spiral";
    assert_int_equal(run(&b, "linear", (const double[]){ 1 }, 1), WF_EUSAGE);
    assert_non_null(strstr(b.err.text, "spiral"));
    set_up(&b);
    b.scenario.temperature = 15; /* Celsius taken for kelvin */
    assert_int_equal(run(&b, "linear", (const double[]){ 1 }, 1), WF_EUSAGE);
    set_up(&b);
    b.species.streamlining.law = "magic";
    assert_int_equal(run(&b, "linear", (const double[]){ 1 }, 1), WF_EINPUT);
    wf_arena_free(&b.arena);
}

/* Every room too small is refused cleanly. */
static void test_memory(void **state)
{
    (void)state;
    struct post b;
    set_up(&b);
    assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_OK);
    size_t needed = b.arena.used;
    wf_arena_free(&b.arena);
    assert_true(needed > 1000);
    for (size_t part = 0; part < 40; part++) {
        set_up(&b);
        b.arena.limit = 1 + needed * part / 40;
        assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_ENOMEM);
        wf_arena_free(&b.arena);
    }
}

/* How far a critical speed is looked for is no property of the scene. */
static void test_search(void **state)
{
    (void)state;
    struct post b;
    static const double bad[] = { 0, 0.5, 201, NAN };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        set_up(&b);
        b.search.speed_max = bad[k];
        assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_EUSAGE);
        assert_non_null(strstr(b.err.text, "highest speed searched"));
        wf_arena_free(&b.arena);
    }
    set_up(&b);
    b.search.speed_max = 150;
    assert_int_equal(run(&b, "linear", (const double[]){ 5 }, 1), WF_OK);
    assert_close(b.an.search.speed_max, 150, 0);
    wf_arena_free(&b.arena);
}

/* A given speed at which the tree fails widens the search; one at which it stands does not. */
static void test_searched_further(void **state)
{
    (void)state;
    struct post whole, narrow, above;
    set_up(&whole), set_up(&narrow), set_up(&above);
    assert_int_equal(run(&whole, "beam", (const double[]){ 10, 90 }, 2), WF_OK);
    double critical = whole.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed;
    assert_true(critical > 60 && critical < 90);
    narrow.search.speed_max = 15;
    assert_int_equal(run(&narrow, "beam", (const double[]){ 10, 90 }, 2), WF_OK);
    const struct wf_critical *c = &narrow.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    assert_int_equal(c->outcome, WF_CRITICAL_FOUND);
    assert_close(c->speed, critical, 1e-5);
    assert_non_null(post_warning(&narrow, "searched-further"));
    assert_null(post_warning(&narrow, "critical-above-range"));
    above.search.speed_max = 15;
    assert_int_equal(run(&above, "beam", (const double[]){ 10, 18 }, 2), WF_OK);
    assert_int_equal(above.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_ABOVE);
    assert_null(post_warning(&above, "searched-further"));
    wf_arena_free(&whole.arena), wf_arena_free(&narrow.arena), wf_arena_free(&above.arena);
}

static void count_solved(const struct wf_analysis *an, void *context)
{
    assert_true(an->n == 2 && an->at[1].tip_deflection > 0 && an->sweep == NULL);
    ++*(int *)context;
}

/* The given speeds come first; a search without time says what it did not search. */
static void test_search_ended(void **state)
{
    (void)state;
    struct post b;
    int called = 0;
    set_up(&b);
    b.search.seconds = 1e-9, b.search.solved = count_solved, b.search.context = &called;
    assert_int_equal(run(&b, "rod", (const double[]){ 10, 60 }, 2), WF_OK);
    assert_int_equal(called, 1);
    const struct wf_critical *c = &b.an.breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    assert_int_equal(c->outcome, WF_CRITICAL_UNSEARCHED);
    assert_true(isnan(c->speed) && c->speed_low == 0 && c->speed_high <= 100);
    assert_int_equal(b.an.sweep_n, 2);
    assert_close(b.an.sweep[1].tip_deflection, b.an.at[1].tip_deflection, 0);
    assert_non_null(strstr(post_warning(&b, "search-ended"), "curves"));
    wf_arena_free(&b.arena);
    set_up(&b);
    b.search.seconds = 0;
    assert_int_equal(run(&b, "rod", (const double[]){ 10 }, 1), WF_EUSAGE);
    wf_arena_free(&b.arena);
}

/* A limp pole in a storm lies down, and its tip comes below the ground. */
static void test_through_ground(void **state)
{
    (void)state;
    struct post b;
    set_up(&b);
    b.level.youngs_modulus = measured(POST_YOUNGS / 2000),
    b.level.shear_modulus = measured(POST_YOUNGS / 32000);
    b.scenario.gravity = 9.81;
    assert_int_equal(run(&b, "beam", (const double[]){ 1, 3 }, 2), WF_OK);
    double lowest = 0;
    for (size_t i = 0; i < b.an.tree.n; i++)
        lowest = fmin(lowest, b.an.tree.z1[i] + b.an.at[1].response.end[3 * i + 2]);
    assert_true((lowest < -1e-3) == (post_warning(&b, "through-ground") != NULL));
    assert_true(lowest < -1e-3);
    wf_arena_free(&b.arena);
    set_up(&b);
    assert_int_equal(run(&b, "beam", (const double[]){ 10 }, 1), WF_OK);
    assert_null(post_warning(&b, "through-ground"));
    wf_arena_free(&b.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed_forms), cmocka_unit_test(test_critical_speed),
        cmocka_unit_test(test_crown),        cmocka_unit_test(test_balance),
        cmocka_unit_test(test_agreement),    cmocka_unit_test(test_still_air),
        cmocka_unit_test(test_limits),       cmocka_unit_test(test_cannot_stand),
        cmocka_unit_test(test_refused),      cmocka_unit_test(test_memory),
        cmocka_unit_test(test_search),       cmocka_unit_test(test_searched_further),
        cmocka_unit_test(test_search_ended), cmocka_unit_test(test_through_ground),
        cmocka_unit_test(test_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
