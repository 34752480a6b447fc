/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search for the critical wind speed: every outcome, the lowest crossing, failures on the way. */
#include "close.h"
#include "fail/fail.h"
#include <string.h>

struct curve {
    double (*value)(double u);
    double lost_from, lost_to; /* no equilibrium within these speeds */
    enum wf_status lost;
    size_t calls;
};

static enum wf_status criterion(void *ctx, double u, double *value, struct wf_err *e)
{
    struct curve *c = ctx;
    c->calls++;
    if (c->lost && u >= c->lost_from && u <= c->lost_to) return wf_fail(e, c->lost, "lost at %g", u);
    *value = c->value(u);
    return WF_OK;
}

static struct wf_critical search(struct curve c, double max)
{
    struct wf_critical out;
    struct wf_err e = { 0 };
    assert_int_equal(wf_critical_search(criterion, &c, max, 1e-8, &out, &e), WF_OK);
    assert_int_equal(out.evaluations, c.calls);
    assert_true(c.calls < 150);
    return out;
}

static double square(double u) { return 0.5 * u * u; }
static double steep(double u) { return pow(u / 31.4, 9); }
static double flat(double u) { return 1 + pow((u - 20) / 20, 3); }
static double step(double u) { return u < 17.3 ? 0.2 : 5; }
static double hump(double u)
{
    return 2 * exp(-(u - 30) * (u - 30) / 50);
} /* crosses at 30 -+ sqrt(50 ln 2) */
static double heavy(double u) { return 1 + u; }
static double nothing(double u) { return u * NAN; }
static double worse(double u) { return u > 3 ? NAN : 0.1; }
static double infinite(double u) { return u < 40 ? u / 80 : INFINITY; }

static void square_root_of_two(void **state)
{
    (void)state;
    struct wf_critical c = search((struct curve){ .value = square }, 100);
    assert_int_equal(c.outcome, WF_CRITICAL_FOUND);
    assert_close(c.speed, sqrt(2), 1e-8);
    assert_true(c.speed_low <= c.speed && c.speed <= c.speed_high);
    assert_true(square(c.speed_low) < 1 && square(c.speed_high) >= 1);
    assert_true(c.speed_high - c.speed_low <= 1e-8 * c.speed_high);
    assert_close(c.gradient, sqrt(2), 1e-6);
    assert_true(c.evaluations < 20);
}

static void awkward_curves(void **state)
{
    (void)state;
    struct wf_critical c = search((struct curve){ .value = steep }, 90);
    assert_close(c.speed, 31.4, 1e-8);
    assert_close(c.gradient, 9 / 31.4, 1e-4);
    c = search((struct curve){ .value = flat },
               90); /* triple root: slope zero; the value is 1 to rounding nearby */
    assert_int_equal(c.outcome, WF_CRITICAL_FOUND);
    assert_close(c.speed, 20, 1e-5);
    c = search((struct curve){ .value = step }, 50);
    assert_int_equal(c.outcome, WF_CRITICAL_FOUND);
    assert_close(c.speed, 17.3, 1e-8);
    c = search((struct curve){ .value = infinite }, 50);
    assert_close(c.speed, 40, 1e-8);
}

static void lowest_crossing(void **state)
{
    (void)state;
    struct wf_critical c = search((struct curve){ .value = hump }, 100);
    assert_int_equal(c.outcome, WF_CRITICAL_FOUND);
    assert_close(c.speed, 30 - sqrt(50 * log(2)), 1e-8);
    assert_true(c.gradient > 0);
}

static void never_reached(void **state)
{
    (void)state;
    struct wf_critical c = search((struct curve){ .value = steep }, 31);
    assert_int_equal(c.outcome, WF_CRITICAL_ABOVE);
    assert_true(isnan(c.speed) && isnan(c.gradient));
    assert_close(c.speed_low, 0, 0);
    assert_close(c.speed_high, 31, 0);
    c = search((struct curve){ .value = steep }, 31.4); /* reached on the last step exactly */
    assert_int_equal(c.outcome, WF_CRITICAL_FOUND);
}

static void without_wind(void **state)
{
    (void)state;
    assert_int_equal(search((struct curve){ .value = heavy }, 50).outcome, WF_CRITICAL_SELF_WEIGHT);
    struct curve falls = { .value = square, .lost_to = 60, .lost = WF_EUNSTABLE };
    struct wf_critical c = search(falls, 50);
    assert_int_equal(c.outcome, WF_CRITICAL_SELF_WEIGHT);
    assert_int_equal(c.evaluations, 1);
    assert_true(isnan(c.speed));
    assert_int_equal(search((struct curve){ .value = nothing }, 50).outcome, WF_CRITICAL_NO_STRENGTH);
}

static void no_answer_beyond_a_speed(void **state)
{
    (void)state;
    struct curve c = { .value = steep, .lost_from = 22.2, .lost_to = 1e9, .lost = WF_ENOCONV };
    struct wf_critical r = search(c, 100);
    assert_int_equal(r.outcome, WF_CRITICAL_UNSOLVED);
    assert_true(isnan(r.speed));
    assert_close(r.speed_low, 22.2, 1e-8);
    assert_close(r.speed_high, 22.2, 1e-8);
    assert_true(r.speed_low < 22.2 && r.speed_high >= 22.2);
}

/* The crossing lies in the same step as the loss, just below it; or it is itself lost. */
static void crossing_before_the_loss(void **state)
{
    (void)state;
    struct curve c = { .value = steep, .lost_from = 31.41, .lost_to = 1e9, .lost = WF_ENOCONV };
    struct wf_critical r = search(c, 100);
    assert_int_equal(r.outcome, WF_CRITICAL_FOUND);
    assert_close(r.speed, 31.4, 1e-8);
    assert_close(r.gradient, 9 / 31.4, 0.01); /* from below alone */
    c.lost_from = 30.5, c.lost_to = 32.5;
    r = search(c, 100);
    assert_int_equal(r.outcome, WF_CRITICAL_UNSOLVED);
    assert_close(r.speed_low, 30.5, 1e-8);
}

static void other_failures_end_the_search(void **state)
{
    (void)state;
    struct wf_critical r;
    struct wf_err e = { 0 };
    struct curve c = { .value = steep, .lost_from = 10, .lost_to = 1e9, .lost = WF_ENOMEM };
    assert_int_equal(wf_critical_search(criterion, &c, 100, 1e-6, &r, &e), WF_ENOMEM);
    assert_non_null(strstr(e.text, "lost at"));
    c.lost_from = 0;
    assert_int_equal(wf_critical_search(criterion, &c, 100, 1e-6, &r, NULL), WF_ENOMEM);
    c = (struct curve){ .value = worse };
    assert_int_equal(wf_critical_search(criterion, &c, 100, 1e-6, &r, NULL), WF_EINTERNAL);
    assert_int_equal(wf_critical_search(criterion, &c, 0, 1e-6, &r, NULL), WF_EUSAGE);
    assert_int_equal(wf_critical_search(criterion, &c, 10, 0, &r, NULL), WF_EUSAGE);
    assert_int_equal(wf_critical_search(criterion, &c, NAN, 1e-6, &r, NULL), WF_EUSAGE);
}

static void outcomes_have_words(void **state)
{
    (void)state;
    for (int o = WF_CRITICAL_FOUND; o <= WF_CRITICAL_UNSOLVED; o++)
        for (int p = WF_CRITICAL_FOUND; p < o; p++)
            assert_string_not_equal(wf_critical_text((enum wf_critical_outcome)o),
                                    wf_critical_text((enum wf_critical_outcome)p));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(square_root_of_two),
        cmocka_unit_test(awkward_curves),
        cmocka_unit_test(lowest_crossing),
        cmocka_unit_test(never_reached),
        cmocka_unit_test(without_wind),
        cmocka_unit_test(no_answer_beyond_a_speed),
        cmocka_unit_test(crossing_before_the_loss),
        cmocka_unit_test(other_failures_end_the_search),
        cmocka_unit_test(outcomes_have_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
