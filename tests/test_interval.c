/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Intervals of critical winds on posts whose answers are known: spread and percentiles in closed form,
 * coverage, one value at a time, threads, seeds, ends of searches, and what is refused. */
#include "base/num.h"
#include "base/random.h"
#include "post.h"
#include "study/interval.h"
#include "study/peak.h"
#include "study/sway.h"
#include <string.h>

/* Whose interval is computed. */
struct sampled {
    struct post post;
    struct wf_interval interval;
};

/* A stiff post of 4 segments: the load grows as the square of the wind. */
static void set_up(struct sampled *p, double height, double radius)
{
    post_begin(&p->post, height, radius);
    p->interval = (struct wf_interval){ 0 };
    p->post.level.youngs_modulus = measured(2e11), p->post.level.shear_modulus = measured(2e10);
    p->post.model.segments = 4;
    p->post.search.speed_max = 200;
}

/* Mean wind at which a rigid post breaks at its base: sigma = 4 M / (pi R^3), M = rho Cd R U^2 H^2 / 2. */
static double breaks_at(double strength, double drag, double height, double radius)
{
    return sqrt(0.5 * WF_PI * strength * radius * radius / (POST_AIR * drag * height * height));
}

static enum wf_status run(struct sampled *p, size_t samples, uint64_t seed, size_t threads)
{
    const double speeds[] = { 10, 40 };
    const struct wf_interval_request q = { samples, seed, threads };
    enum wf_status s =
        wf_analyze(&p->post.species, &p->post.model, &p->post.scenario, &p->post.search, wf_solvers[0],
                   &p->post.options, speeds, 2, &p->post.arena, &p->post.diag, &p->post.an, &p->post.err);
    if (s) fail_msg("%s", p->post.err.text);
    s = wf_interval_run(&p->post.an, &p->post.options, &q, &p->post.arena, &p->interval, &p->post.err);
    if (!s) p->post.an.interval = &p->interval;
    return s;
}

static const struct wf_interval_arm *arm_of(const struct sampled *p, const char *name, struct wf_varied *v)
{
    for (size_t k = 0; k < p->interval.variation.n; k++) {
        *v = p->interval.variation.varied[k];
        if (!strcmp(v->name, name)) return &p->interval.arm[k];
    }
    fail_msg("%s does not vary", name);
    return NULL;
}

/* ln U = ln(strength)/2 - ln(drag)/2 + ln R - ln H: the sum of normal laws. */
static double closed_sd(void) { return sqrt(0.25 * (0.16 * 0.16 + 0.15 * 0.15) + 0.02 * 0.02 + 0.03 * 0.03); }

static void agrees_with_the_closed_form(void **state)
{
    (void)state;
    struct sampled p;
    set_up(&p, 10, 0.1);
    assert_int_equal(run(&p, 1024, 1, 0), WF_OK);
    const struct wf_interval *i = &p.interval;
    double middle = breaks_at(POST_STRENGTH, 1, 10, 0.1), wide = exp(WF_SPREAD_Z * closed_sd());
    assert_close(i->middle, middle, 3e-3);
    /* sampling error of an order statistic: sqrt(0.05 0.95 / 1024) / density = 0.066 standard deviations */
    assert_close(i->low, middle / wide, 0.015);
    assert_close(i->high, middle * wide, 0.015);
    assert_close(i->fit.median, middle, 0.005);
    assert_close(i->fit.beta, closed_sd(), 0.03);
    assert_int_equal(i->n, 1024);
    assert_int_equal(i->lost_by[WF_BREAKAGE], 1024);
    /* safety at 40 m/s: the square of the ratio of the winds */
    assert_close(i->at[1].low, pow(middle / wide / 40, 2), 0.03);
    assert_close(i->at[1].high, pow(middle * wide / 40, 2), 0.03);
    wf_arena_free(&p.post.arena);
}

/* The tornado has no sampling error. */
static void one_value_at_a_time(void **state)
{
    (void)state;
    struct sampled p;
    struct wf_varied v;
    set_up(&p, 10, 0.1);
    p.post.level.modulus_of_rupture.low = 0.5 * POST_STRENGTH,
    p.post.level.modulus_of_rupture.high = 1.2 * POST_STRENGTH;
    p.post.level.modulus_of_rupture.standing = WF_ASSUMED;
    assert_int_equal(run(&p, 20, 1, 1), WF_OK);
    double middle = breaks_at(POST_STRENGTH, 1, 10, 0.1);
    const struct wf_interval_arm *arm = arm_of(&p, "modulus_of_rupture", &v);
    assert_true(v.ranged);
    assert_close(arm->at_low, middle * sqrt(0.5), 3e-3);
    assert_close(arm->at_high, middle * sqrt(1.2), 3e-3);
    arm = arm_of(&p, "drag_coefficient", &v);
    assert_false(v.ranged);
    assert_close(arm->at_low, middle * exp(0.5 * WF_SPREAD_Z * 0.15), 3e-3);
    arm = arm_of(&p, "height", &v);
    assert_close(arm->at_high, middle * exp(-WF_SPREAD_Z * 0.03), 3e-3);
    arm = arm_of(&p, "youngs_modulus", &v);
    assert_close(arm->at_high, middle, 3e-3);
    wf_interval_warn(&p.post.an, &p.interval, &p.post.diag);
    assert_non_null(p.post.diag.last);
    assert_string_equal(p.post.diag.last->code, "value-decides");
    assert_non_null(strstr(p.post.diag.last->text, "modulus_of_rupture (assumed)"));
    assert_null(strstr(p.post.diag.last->text, "drag_coefficient"));
    wf_arena_free(&p.post.arena);
}

/* The value of each law at its own points, and between. */
static void laws_pass_through_their_points(void **state)
{
    (void)state;
    struct wf_varied v = { .row = wf_spreads, .value = 10, .low = 8, .high = 14 };
    assert_close(wf_varied_at(&v, 0.05), 8, 1e-12);
    assert_close(wf_varied_at(&v, 0.5), 10, 1e-12);
    assert_close(wf_varied_at(&v, 0.95), 14, 1e-12);
    assert_close(wf_varied_at(&v, 0.75), 10 * pow(1.4, 0.67448975019608171 / WF_SPREAD_Z), 1e-9);
    const struct wf_spread line = { "x",  WF_SPREAD_LAWS, WF_SPREAD_NORMAL, 0.1, 0, -INFINITY, -0.4, false,
                                    NULL, "here" };
    v = (struct wf_varied){ .row = &line, .value = -0.7, .low = -0.9, .high = -0.5 };
    assert_close(wf_varied_at(&v, 0.05), -0.9, 1e-12);
    assert_close(wf_varied_at(&v, 0.95), -0.5, 1e-12);
    assert_close(wf_varied_at(&v, 0.9999), -0.4, 1e-12); /* held */
}

/* 200 made-up posts, each with values of its own drawn from the laws that the interval was told: 90 % of them
 * break inside their interval. */
static void covers_what_it_says(void **state)
{
    (void)state;
    enum { TREES = 200, SAMPLES = 64 };
    int inside = 0;
    for (uint64_t t = 0; t < TREES; t++) {
        double z[6], height, radius;
        struct sampled p;
        wf_random_normals(99, t, 0, 6, z);
        height = 8 + 12 * wf_random_uniform(99, 1000 + t, 0);
        radius = height * (0.008 + 0.008 * wf_random_uniform(99, 1000 + t, 1));
        set_up(&p, height, radius);
        assert_int_equal(run(&p, SAMPLES, t, 0), WF_OK);
        double truth = breaks_at(POST_STRENGTH * exp(0.16 * z[0]), exp(0.15 * z[1]),
                                 height * exp(0.03 * z[2]), radius * exp(0.02 * z[3]));
        inside += truth >= p.interval.low && truth <= p.interval.high;
        wf_arena_free(&p.post.arena);
    }
    print_message("inside: %d of %d\n", inside, (int)TREES);
    assert_true(inside >= 0.86 * TREES && inside <= 0.94 * TREES);
}

/* With gusts, weight, leaves and streamlining. */
static void clothe(struct sampled *p)
{
    p->post.model.leaf_area = p->post.model.leaf_area_on = 15;
    p->post.scenario.gravity = 9.81;
    p->post.scenario.peak.method = "en1991";
    p->post.scenario.peak.damping = NAN;
    p->post.scenario.profile = "power";
    p->post.level.youngs_modulus = measured(8e9);
    p->post.level.shear_modulus = measured(5e8);
}

static void bytes_of(const struct wf_interval *i, unsigned char *out, size_t size)
{
    size_t used = 0;
    const struct {
        const void *from;
        size_t bytes;
    } part[] = { { i->critical, i->n * sizeof *i->critical },
                 { i->arm, i->variation.n * sizeof *i->arm },
                 { i->at, i->winds * sizeof *i->at },
                 { &i->fit, sizeof i->fit } };
    memset(out, 0, size);
    for (size_t k = 0; k < 4 && used + part[k].bytes <= size; k++) {
        memcpy(out + used, part[k].from, part[k].bytes);
        used += part[k].bytes;
    }
    assert_true(used > 0);
}

static void same_bytes_for_any_threads(void **state)
{
    (void)state;
    static unsigned char bytes[3][1 << 14];
    for (int k = 0; k < 3; k++) {
        struct sampled p;
        set_up(&p, 12, 0.1);
        clothe(&p);
        assert_int_equal(run(&p, 64, k == 2 ? 2 : 1, k == 1 ? 2 : 1), WF_OK);
        bytes_of(&p.interval, bytes[k], sizeof bytes[k]);
        wf_arena_free(&p.post.arena);
    }
    assert_memory_equal(bytes[0], bytes[1], sizeof bytes[0]);
    assert_memory_not_equal(bytes[0], bytes[2], sizeof bytes[0]); /* another seed */
}

/* What always varies does, and the crown's values with the wood's. */
static void varies_what_acts(void **state)
{
    (void)state;
    static const char *const names[] = { "gusts",   "damping",        "radius",
                                         "height",  "leaf_area",      "frontal_share",
                                         "density", "youngs_modulus", "modulus_of_rupture" };
    struct sampled p;
    struct wf_varied v;
    set_up(&p, 12, 0.1);
    clothe(&p);
    assert_int_equal(run(&p, 20, 1, 0), WF_OK);
    for (size_t k = 0; k < WF_COUNT(names); k++) (void)arm_of(&p, names[k], &v);
    const struct wf_interval_arm *arm = arm_of(&p, "gusts", &v);
    assert_true(arm->at_low > p.interval.middle && p.interval.middle > arm->at_high);
    double ranks[WF_VARIED_MAX * WF_VARIED_MAX];
    size_t n = p.interval.variation.n, wood = 0;
    wf_variation_ranks(&p.interval.variation, ranks);
    for (size_t i = 0; i < n * n; i++) wood += ranks[i] == WF_SPREAD_WOOD;
    assert_int_equal(wood, 6); /* density, E and strength with each other, twice */
    wf_arena_free(&p.post.arena);
}

/* Each sample is the tree solved anew: the arm of a value is the analysis with that value. */
static void arms_are_analyses(void **state)
{
    (void)state;
    struct sampled p, q;
    struct wf_varied v;
    set_up(&p, 12, 0.1);
    clothe(&p);
    assert_int_equal(run(&p, 20, 1, 0), WF_OK);
    const struct wf_interval_arm *arm = arm_of(&p, "youngs_modulus", &v);
    set_up(&q, 12, 0.1);
    clothe(&q);
    q.post.level.youngs_modulus = measured(v.high);
    q.post.level.shear_modulus = measured(5e8 * v.high / v.value);
    assert_int_equal(run(&q, 20, 1, 0), WF_OK);
    double given = q.post.an.breaks[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed;
    assert_close(arm->at_high / p.interval.middle,
                 given / p.post.an.breaks[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed, 5e-3);
    wf_arena_free(&p.post.arena);
    wf_arena_free(&q.post.arena);
}

/* Frequency and damping of a tree with other values, by ratios, against its own modes. */
static void sways_by_ratios(void **state)
{
    (void)state;
    struct sampled p;
    const double speeds[] = { 10, 20 };
    struct wf_peak *alike;
    struct wf_peak_parts own, by_ratio;
    set_up(&p, 12, 0.1);
    clothe(&p);
    assert_int_equal(run(&p, 20, 1, 0), WF_OK);
    struct wf_level other = p.post.level;
    struct wf_species species = p.post.species;
    other.youngs_modulus.value *= 1.3, other.density.value *= 0.9;
    species.level = &other;
    struct wf_analysis an = p.post.an;
    an.species = &species;
    assert_int_equal(wf_analysis_set_up(&an, &p.post.options, &p.post.arena, &p.post.diag, &p.post.err),
                     WF_OK);
    assert_int_equal(wf_sway_set_up(&an, &p.post.options, speeds, 2, &p.post.arena, NULL, &p.post.err),
                     WF_OK);
    wf_peak_parts_at(an.peak, 10, WF_PART_STEM, &own);
    assert_int_equal(wf_sway_alike(&an, &p.post.an, 20, &p.post.arena, &alike, &p.post.err), WF_OK);
    wf_peak_parts_at(an.peak, 10, WF_PART_STEM, &by_ratio);
    assert_close(by_ratio.frequency, own.frequency, 0.06);
    assert_close(by_ratio.factor, own.factor, 0.02);
    wf_arena_free(&p.post.arena);
}

/* Where the search ends, samples are known to be above it; the law takes that into account. */
static void ends_of_searches(void **state)
{
    (void)state;
    struct sampled p;
    set_up(&p, 10, 0.1);
    double middle = breaks_at(POST_STRENGTH, 1, 10, 0.1);
    p.post.search.speed_max = middle;
    assert_int_equal(run(&p, 256, 1, 0), WF_OK);
    assert_true(isinf(p.interval.high));
    assert_close(p.interval.low, middle * exp(-WF_SPREAD_Z * closed_sd()), 0.03);
    assert_in_range(p.interval.fit.above, 118, 138);
    assert_close(p.interval.fit.median, middle, 0.02);
    assert_close(p.interval.fit.beta, closed_sd(), 0.1);
    assert_true(isfinite(p.interval.point[WF_INTERVAL_POINTS - 1].fit));
    wf_arena_free(&p.post.arena);
    set_up(&p, 10, 0.1);
    p.post.search.speed_max = 20;
    assert_int_equal(run(&p, 20, 1, 0), WF_OK);
    assert_true(isinf(p.interval.low) && isinf(p.interval.middle) && isnan(p.interval.fit.median));
    wf_arena_free(&p.post.arena);
}

static void a_tree_of_other_sizes(void **state)
{
    (void)state;
    struct sampled p;
    set_up(&p, 12, 0.1);
    clothe(&p);
    assert_int_equal(run(&p, 20, 1, 1), WF_OK);
    struct wf_tree *t = &p.post.an.tree;
    double leaves[2] = { 0 };
    for (int k = 0; k < 2; k++) {
        for (size_t i = 0; i < t->n; i++)
            leaves[k] += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
        if (!k) wf_tree_scale(t, 1.1, 0.9);
    }
    assert_close(leaves[1], leaves[0], 1e-12);
    assert_close(wf_tree_height(t), 13.2, 1e-12);
    assert_close(t->r0[0], 0.09, 1e-12);
    wf_arena_free(&p.post.arena);
}

static void refuses(void **state)
{
    (void)state;
    struct sampled p;
    set_up(&p, 10, 0.1);
    assert_int_equal(run(&p, 19, 1, 1), WF_EUSAGE);
    assert_non_null(strstr(p.post.err.text, "20 to 4096"));
    wf_arena_free(&p.post.arena);
    set_up(&p, 10, 0.1);
    assert_int_equal(run(&p, 4097, 1, 1), WF_EUSAGE);
    wf_arena_free(&p.post.arena);
    set_up(&p, 10, 0.1);
    p.post.level.modulus_of_rupture.low = 1.1 * POST_STRENGTH;
    assert_int_equal(run(&p, 20, 1, 1), WF_EINPUT);
    assert_non_null(strstr(p.post.err.text, "modulus_of_rupture: the range"));
    wf_arena_free(&p.post.arena);
    set_up(&p, 10, 0.1);
    p.post.level.modulus_of_rupture = (struct wf_value){ .value = NAN };
    assert_int_equal(run(&p, 20, 1, 1), WF_EUSAGE);
    assert_non_null(strstr(p.post.err.text, "no strength is known"));
    wf_arena_free(&p.post.arena);
}

static void digits(void **state)
{
    (void)state;
    assert_int_equal(wf_interval_decimals(15, 40), 0);
    assert_int_equal(wf_interval_decimals(30.2, 32.1), 1);
    assert_int_equal(wf_interval_decimals(30.21, 30.3), 2);
    assert_int_equal(wf_interval_decimals(30, INFINITY), 0);
}

/* The range of one value alone: digits that tell its ends apart, a tree that would not stand, ends of
 * searches.
 */
static void ranges_in_words(void **state)
{
    (void)state;
    static const struct {
        struct wf_interval_arm arm;
        const char *text; /* NULL: nothing is told */
    } said[] = {
        { { 14.2, 9.4 }, "9 to 14" },
        { { 9.1, 9.4 }, "9.1 to 9.4" },
        { { 9.444, 9.436 }, NULL },
        { { 9.446, 9.434 }, "9.43 to 9.45" },
        { { 9.4361, 9.4362 }, NULL },
        { { NAN, 9.2 }, "not standing to 9" },
        { { 9.2, NAN }, "not standing to 9" },
        { { INFINITY, 14.2 }, "14 to above 60" },
        { { INFINITY, INFINITY }, NULL },
        { { NAN, INFINITY }, "not standing to above 60" },
        { { NAN, NAN }, NULL },
    };
    for (size_t k = 0; k < WF_COUNT(said); k++) {
        struct wf_interval_arm arm = said[k].arm;
        const struct wf_interval i = { .searched_to = 60, .arm = &arm };
        char text[80];
        bool told = wf_interval_arm_text(&i, 0, text, sizeof text);
        assert_int_equal(told, said[k].text != NULL);
        if (told) assert_string_equal(text, said[k].text);
    }
}

/* Where a measured tree would not stand at one end of a value, that value decides, whatever the other end. */
static void falls_at_one_end(void **state)
{
    (void)state;
    struct sampled p;
    struct wf_varied v;
    set_up(&p, 10, 0.1);
    p.post.level.youngs_modulus.standing = WF_BORROWED;
    assert_int_equal(run(&p, 20, 1, 1), WF_OK);
    size_t k = (size_t)(arm_of(&p, "youngs_modulus", &v) - p.interval.arm);
    wf_interval_warn(&p.post.an, &p.interval, &p.post.diag);
    for (const struct wf_finding *f = p.post.diag.first; f; f = f->next)
        assert_null(strstr(f->text, "youngs_modulus (borrowed)"));
    p.interval.arm[k].at_low = NAN;
    wf_interval_warn(&p.post.an, &p.interval, &p.post.diag);
    assert_non_null(p.post.diag.last);
    assert_non_null(strstr(p.post.diag.last->text, "youngs_modulus (borrowed): not standing to 72 m/s"));
    wf_arena_free(&p.post.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_the_closed_form),
        cmocka_unit_test(one_value_at_a_time),
        cmocka_unit_test(laws_pass_through_their_points),
        cmocka_unit_test(covers_what_it_says),
        cmocka_unit_test(same_bytes_for_any_threads),
        cmocka_unit_test(varies_what_acts),
        cmocka_unit_test(arms_are_analyses),
        cmocka_unit_test(sways_by_ratios),
        cmocka_unit_test(ends_of_searches),
        cmocka_unit_test(a_tree_of_other_sizes),
        cmocka_unit_test(refuses),
        cmocka_unit_test(digits),
        cmocka_unit_test(ranges_in_words),
        cmocka_unit_test(falls_at_one_end),
    };
    return cmocka_run_group_tests_name("interval", tests, NULL, NULL);
}
