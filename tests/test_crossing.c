/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search for the lowest crossing by values and slopes, on functions whose crossings are known. */
#include "close.h"
#include "fail/crossing.h"
#include "fail/fail.h"
#include <math.h>

enum { ITEMS_MAX = 3, NODES_MAX = 60 };

typedef double law(double speed);

struct run {
    law *item[ITEMS_MAX];
    size_t items;
    double speed_max, lost; /* no equilibrium from this speed on */
    double trusted;
};

static double slope_of(law *f, double x)
{
    double h = 1e-5 * fmax(x, 1);
    return x > h ? (f(x + h) - f(x - h)) / (2 * h) : 0;
}

/* Search until an outcome. Returned: it, *out and the number of solutions. */
static enum wf_crossing_next search(const struct run *q, double first, struct wf_crossing *out,
                                    size_t *solved)
{
    static float value[NODES_MAX][ITEMS_MAX], slope[NODES_MAX][ITEMS_MAX];
    struct wf_crossing_node node[NODES_MAX];
    const size_t item[ITEMS_MAX] = { 0, 1, 2 };
    double next[2] = { 0, first };
    for (size_t n = 0; n < NODES_MAX; n++) {
        if (n >= 2) {
            enum wf_crossing_next what = wf_crossing_step(node, n, item, q->items, q->speed_max, 1e-6, out);
            *solved = n;
            if (what != WF_CROSSING_SOLVE) return what;
        }
        double speed = n < 2 ? next[n] : out->speed;
        for (size_t i = 0; i < q->items; i++) {
            value[n][i] = (float)q->item[i](speed);
            slope[n][i] = (float)slope_of(q->item[i], speed);
        }
        size_t at = n;
        for (; at > 0 && node[at - 1].speed > speed; at--) node[at] = node[at - 1];
        node[at] = (struct wf_crossing_node){ speed, !(q->lost > 0 && speed >= q->lost),
                                              q->trusted > 0 ? q->trusted : 1, value[n], slope[n] };
    }
    fail_msg("no outcome after %d solutions", NODES_MAX);
    return WF_CROSSING_LOST;
}

static double square(double x) { return 0.2 + x * x / 2000; }    /* 40 m/s */
static double streamlined(double x) { return pow(x / 33, 1.3); } /* 33 m/s */
static double calm(double x) { return 0.5 + 0.001 * x; }
static double sinking(double x) { return 0.95 - 1e-4 * x * x; }
/* a part that snaps: its utilisation rises above 1 near 17.5 m/s and falls again */
static double bump(double x) { return 0.2 + x * x / 3000 + 0.9 * exp(-0.1 * (x - 17.5) * (x - 17.5)); }
/* a corner at 20 m/s */
static double corner(double x) { return x < 20 ? x * x / 800 : 0.5 + 0.01 * (x - 20); }
/* nearly touches 1 at 25 m/s */
static double touch(double x) { return 0.999 - 1e-3 * (x - 25) * (x - 25); }

static void smooth_curves_take_few_solutions(void **state)
{
    (void)state;
    const struct {
        struct run q;
        double want;
    } runs[] = {
        { { { square }, 1, 60, 0, 0 }, 40 },
        { { { streamlined }, 1, 60, 0, 0 }, 33 },
        { { { calm, sinking, square }, 3, 60, 0, 0 }, 40 },
        { { { square, streamlined }, 2, 60, 0, 0 }, 33 },
    };
    for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
        struct wf_crossing out;
        size_t n;
        assert_int_equal(search(&runs[k].q, 10, &out, &n), WF_CROSSING_FOUND);
        assert_close(out.speed, runs[k].want, 2e-6);
        assert_true(n <= 7);
        assert_close(out.gradient, slope_of(runs[k].q.item[runs[k].q.items - 1], out.speed), 1e-3);
        assert_true(out.low < out.speed);
    }
}

static void what_lies_between_is_found(void **state)
{
    (void)state;
    struct wf_crossing out;
    size_t n;
    /* from above the bump as from below it: its rising side is found, at the step where it shows */
    const struct run q = { { bump, calm }, 2, 60, 0, 0 };
    for (double first = 5; first < 40; first += 5) {
        assert_int_equal(search(&q, first, &out, &n), WF_CROSSING_FOUND);
        assert_close(bump(out.speed), 1, 1e-5);
        assert_true(out.speed < 17.5); /* the ladder has a step on it, at 18.75 m/s */
    }
    const struct run bent = { { corner }, 1, 80, 0, 0 };
    assert_int_equal(search(&bent, 10, &out, &n), WF_CROSSING_FOUND);
    assert_close(out.speed, 70, 1e-5);
    const struct run grazing = { { touch, square }, 2, 60, 0, 0 };
    assert_int_equal(search(&grazing, 10, &out, &n), WF_CROSSING_FOUND);
    assert_close(out.speed, 40, 1e-5);
}

static void nothing_reaches_one(void **state)
{
    (void)state;
    struct wf_crossing out;
    size_t n;
    const struct run q = { { calm, sinking }, 2, 60, 0, 0 };
    assert_int_equal(search(&q, 10, &out, &n), WF_CROSSING_ABOVE);
    assert_true(n <= 9);
    const struct run short_of = { { square }, 1, 39.99, 0, 0 };
    assert_int_equal(search(&short_of, 10, &out, &n), WF_CROSSING_ABOVE);
}

/* Where parts may have snapped, the steps of the ladder are solved wherever a utilisation is not small. */
static void little_trust_takes_the_steps(void **state)
{
    (void)state;
    struct wf_crossing out;
    size_t n, trusting;
    const struct run q = { { square }, 1, 60, 0, 0.3 }, trusted = { { square }, 1, 60, 0, 1 };
    assert_int_equal(search(&q, 10, &out, &n), WF_CROSSING_FOUND);
    assert_close(out.speed, 40, 2e-6);
    assert_int_equal(search(&trusted, 10, &out, &trusting), WF_CROSSING_FOUND);
    assert_true(n >= trusting + 5);
}

static double heavy(double x) { return 1.2 + 0.01 * x; }
static double jump(double x) { return x < 21 ? 0.4 : 1.3; }

static void lost_cases_are_named(void **state)
{
    (void)state;
    struct wf_crossing out;
    size_t n;
    const struct run own_weight = { { heavy }, 1, 60, 0, 0 }, unsolved = { { calm }, 1, 60, 30, 0 },
                     jumping = { { jump }, 1, 60, 0, 0 };
    assert_int_equal(search(&own_weight, 10, &out, &n), WF_CROSSING_LOST);
    assert_int_equal(search(&unsolved, 10, &out, &n), WF_CROSSING_LOST);
    assert_int_equal(search(&jumping, 10, &out, &n), WF_CROSSING_LOST);
    assert_close(out.high, 21, 1e-4);
    assert_int_equal(wf_crossing_step(NULL, 0, NULL, 0, 60, 1e-6, &out), WF_CROSSING_SOLVE);
    assert_close(out.speed, 0, 0);
}

static void cubic_meets_values_and_slopes(void **state)
{
    (void)state;
    const double a = 3, b = 7, h = 1e-6;
    assert_close(wf_crossing_cubic(a, b, 2, 5, -1, 4, a), 2, 1e-14);
    assert_close(wf_crossing_cubic(a, b, 2, 5, -1, 4, b), 5, 1e-14);
    assert_close((wf_crossing_cubic(a, b, 2, 5, -1, 4, a + h) - 2) / h, -1, 1e-5);
    assert_close((5 - wf_crossing_cubic(a, b, 2, 5, -1, 4, b - h)) / h, 4, 1e-5);
    for (double x = a; x <= b; x += 0.5) /* a cubic is met everywhere */
        assert_close(wf_crossing_cubic(a, b, a * a * a, b * b * b, 3 * a * a, 3 * b * b, x), x * x * x,
                     1e-13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smooth_curves_take_few_solutions),
        cmocka_unit_test(what_lies_between_is_found),
        cmocka_unit_test(nothing_reaches_one),
        cmocka_unit_test(little_trust_takes_the_steps),
        cmocka_unit_test(lost_cases_are_named),
        cmocka_unit_test(cubic_meets_values_and_slopes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
