/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bounded least squares: against all active sets of small linear problems, closed forms, and the conditions
 * of Karush, Kuhn and Tucker for every loss. */
#include "base/random.h"
#include "close.h"
#include "fit/lsq.h"
#include <string.h>

enum { PARAMS = 4, ROWS = 12 };

struct linear {
    double A[ROWS][PARAMS], b[ROWS];
    size_t calls;
};

static bool linear_model(void *ctx, const double *p, double *r, double *J)
{
    struct linear *l = ctx;
    l->calls++;
    for (size_t i = 0; i < ROWS; i++) {
        r[i] = -l->b[i];
        for (size_t k = 0; k < PARAMS; k++) {
            r[i] += l->A[i][k] * p[k];
            if (J) J[PARAMS * i + k] = l->A[i][k];
        }
    }
    return true;
}

static void make(struct linear *l, uint64_t problem)
{
    for (size_t i = 0; i < ROWS; i++) {
        double common = wf_random_normal(5, problem, 1000 + i);
        for (size_t k = 0; k < PARAMS; k++) /* correlated columns: minima lie beyond several bounds */
            l->A[i][k] = 0.8 * common + wf_random_normal(5, problem, PARAMS * i + k);
        l->b[i] = 2 * wf_random_normal(5, problem, 2000 + i);
    }
    l->calls = 0;
}

/* Solve the normal equations of the parameters that are not fixed, by elimination. */
static void solve_free(const struct linear *l, const bool *fixed, double *p)
{
    double N[PARAMS][PARAMS + 1] = { { 0 } };
    for (size_t a = 0; a < PARAMS; a++) {
        if (fixed[a]) {
            N[a][a] = 1, N[a][PARAMS] = p[a];
            continue;
        }
        for (size_t i = 0; i < ROWS; i++) {
            double rest = l->b[i];
            for (size_t k = 0; k < PARAMS; k++)
                if (fixed[k])
                    rest -= l->A[i][k] * p[k];
                else
                    N[a][k] += l->A[i][a] * l->A[i][k];
            N[a][PARAMS] += l->A[i][a] * rest;
        }
    }
    for (size_t c = 0; c < PARAMS; c++)
        for (size_t r = 0; r < PARAMS; r++)
            for (size_t k = PARAMS + 1; r != c && k-- > c;) N[r][k] -= N[r][c] / N[c][c] * N[c][k];
    for (size_t a = 0; a < PARAMS; a++) p[a] = N[a][PARAMS] / N[a][a];
}

static double half_squares(struct linear *l, const double *p)
{
    double r[ROWS], sum = 0;
    linear_model(l, p, r, NULL);
    for (size_t i = 0; i < ROWS; i++) sum += 0.5 * r[i] * r[i];
    return sum;
}

/* The least cost over all 3^n choices of what is low, high or free. */
static double all_active_sets(struct linear *l, const double *low, const double *high, double *best)
{
    double least = INFINITY;
    for (size_t set = 0; set < 81; set++) {
        double p[PARAMS];
        bool fixed[PARAMS], inside = true;
        for (size_t k = 0, s = set; k < PARAMS; k++, s /= 3)
            fixed[k] = s % 3 != 0, p[k] = s % 3 == 1 ? low[k] : high[k];
        solve_free(l, fixed, p);
        for (size_t k = 0; k < PARAMS; k++)
            inside = inside && p[k] >= low[k] - 1e-12 && p[k] <= high[k] + 1e-12;
        double cost = inside ? half_squares(l, p) : INFINITY;
        if (cost < least) least = cost, memcpy(best, p, sizeof p);
    }
    return least;
}

static const double low[PARAMS] = { -0.5, 0, -0.2, -1 }, high[PARAMS] = { 0.3, 0.4, 0.2, 0.1 };

static struct wf_lsq problem_of(struct linear *l)
{
    return (struct wf_lsq){
        .params = PARAMS, .residuals = ROWS, .low = low, .high = high, .model = linear_model, .ctx = l
    };
}

/* Starts: the middle, and every corner, from which most bounds have to be released. */
static void every_active_set(void **state)
{
    (void)state;
    size_t kinds[PARAMS + 1] = { 0 };
    for (uint64_t k = 0; k < 60; k++) {
        struct linear l;
        double want[PARAMS];
        make(&l, k);
        double least = all_active_sets(&l, low, high, want);
        size_t active = 0;
        for (size_t j = 0; j < PARAMS; j++) active += want[j] <= low[j] || want[j] >= high[j];
        kinds[active]++;
        for (size_t corner = 0; corner <= 16; corner++) {
            struct wf_lsq q = problem_of(&l);
            struct wf_lsq_result r;
            struct wf_err e = { 0 };
            double p[PARAMS];
            for (size_t j = 0; j < PARAMS; j++)
                p[j] = corner == 16 ? 0.5 * (low[j] + high[j]) : corner >> j & 1 ? high[j] : low[j];
            l.calls = 0;
            assert_int_equal(wf_lsq_solve(&q, p, &r, &e), WF_OK);
            assert_true(r.converged);
            assert_true(r.cost <= least * (1 + 1e-9));
            assert_close(r.cost, half_squares(&l, p), 1e-12);
            for (size_t j = 0; j < PARAMS; j++) assert_true(fabs(p[j] - want[j]) < 1e-4);
            assert_true(l.calls < 60);
        }
    }
    for (size_t j = 1; j < PARAMS; j++) assert_true(kinds[j] > 2); /* of one, two and three active bounds */
}

/* At the end no parameter can lower the cost, with every loss, and with residuals without a loss (priors). */
static void conditions_of_every_loss(void **state)
{
    (void)state;
    for (size_t loss = 0; wf_losses[loss].name; loss++)
        for (uint64_t k = 0; k < 40; k++) {
            struct linear l;
            struct wf_lsq_result r;
            struct wf_err e = { 0 };
            double p[PARAMS] = { 0, 0.2, 0, 0 }, at[ROWS], J[ROWS * PARAMS], size = 0;
            make(&l, 100 + k);
            struct wf_lsq q = problem_of(&l);
            q.loss = (enum wf_loss)loss, q.loss_scale = wf_losses[loss].usual_scale, q.plain = k % 3;
            assert_int_equal(wf_lsq_solve(&q, p, &r, &e), WF_OK);
            assert_true(r.cost <= r.cost0);
            linear_model(&l, p, at, J);
            for (size_t i = 0; i < ROWS; i++) size += at[i] * at[i];
            for (size_t j = 0; j < PARAMS; j++) {
                double g = 0, psi, slope;
                for (size_t i = 0; i < ROWS; i++) {
                    wf_losses[i + q.plain < ROWS ? loss : 0].slopes(q.loss_scale, at[i], &psi, &slope);
                    g += psi * J[PARAMS * i + j];
                }
                double zero = 1e-4 * sqrt(size);
                assert_true(p[j] >= low[j] && p[j] <= high[j]);
                if (p[j] > low[j]) assert_true(g < zero);
                if (p[j] < high[j]) assert_true(g > -zero);
            }
        }
}

/* Rosenbrock 1960: residuals 1 - x and 10 (y - x^2), a curved valley. */
static bool valley(void *ctx, const double *p, double *r, double *J)
{
    size_t *calls = ctx;
    ++*calls;
    r[0] = 1 - p[0], r[1] = 10 * (p[1] - p[0] * p[0]);
    if (J) J[0] = -1, J[1] = 0, J[2] = -20 * p[0], J[3] = 10;
    return true;
}

/* With x at most 1/2 the minimum is (1/2, 1/4), cost 1/8: the valley runs into the bound. */
static void valley_into_a_bound(void **state)
{
    (void)state;
    const double from[2] = { -2, -2 }, to[2] = { 0.5, 2 };
    size_t calls = 0;
    struct wf_lsq q = {
        .params = 2, .residuals = 2, .low = from, .high = to, .model = valley, .ctx = &calls
    };
    struct wf_lsq_result r;
    struct wf_err e = { 0 };
    double p[2] = { -1.2, 1 };
    assert_int_equal(wf_lsq_solve(&q, p, &r, &e), WF_OK);
    assert_true(r.converged);
    assert_close(p[0], 0.5, 1e-12);
    assert_close(p[1], 0.25, 1e-8);
    assert_close(r.cost, 0.125, 1e-10);
    assert_true(calls < 150);
}

/* A start on a bound that is no minimum is left; where all parameters end on bounds the cost is theirs. */
static void corners(void **state)
{
    (void)state;
    const double from[2] = { -2, -2 }, to[2] = { 2, 2 }, corner_low[2] = { -1, 1.5 },
                 corner_high[2] = { 0.5, 2 };
    size_t calls = 0;
    struct wf_lsq q = {
        .params = 2, .residuals = 2, .low = from, .high = to, .model = valley, .ctx = &calls
    };
    struct wf_lsq_result r;
    struct wf_err e = { 0 };
    double p[2] = { -2, -2 };
    assert_int_equal(wf_lsq_solve(&q, p, &r, &e), WF_OK);
    assert_close(p[0], 1, 1e-8);
    assert_close(p[1], 1, 1e-8);
    q.low = corner_low, q.high = corner_high;
    p[0] = 0.5, p[1] = 1.5; /* 10 (y - x^2) presses y down; x to either side */
    assert_int_equal(wf_lsq_solve(&q, p, &r, &e), WF_OK);
    assert_close(p[1], 1.5, 1e-12);
    assert_close(r.cost, 0.5 * (pow(1 - p[0], 2) + 100 * pow(1.5 - p[0] * p[0], 2)), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_active_set),
        cmocka_unit_test(conditions_of_every_loss),
        cmocka_unit_test(valley_into_a_bound),
        cmocka_unit_test(corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
