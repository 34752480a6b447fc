/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Jobs of one thread by turns (base/abreast.h), and stems of several trees side by side. */
#include "base/abreast.h"
#include "beam_cases.h"
#include "solve/beam_newton.h"
#include "solve/beam_team.h"
#include <stdlib.h>

/* ---- Jobs ---- */

static size_t calls, together[16];

static size_t add_one(void **request, size_t n)
{
    together[calls++] = n;
    for (size_t i = 0; i < n; i++) ++*(int *)request[i];
    return 0;
}

static size_t add_to_first(void **request, size_t n)
{
    together[calls++] = n;
    ++*(int *)request[0];
    for (size_t i = 1; i < n; i++) request[i - 1] = request[i];
    return n - 1;
}

struct jobs {
    wf_abreast_work *work;
    int begun, joins; /* the k-th job joins k times, or so many times */
    int sum[WF_ABREAST];
};

static void *join(void *context)
{
    struct jobs *j = context;
    int own = j->begun++;
    assert_true(wf_abreast_inside());
    for (int i = 0; i < (j->joins ? j->joins : own); i++) wf_abreast_join(j->work, &j->sum[own]);
    return NULL;
}

/* One after another where stacks cannot be exchanged: then nothing comes together. */
static bool exchanged(void)
{
    struct jobs j = { .work = add_one };
    wf_abreast(2, join, &j);
    calls = 0;
    return j.begun == 2;
}

static void jobs_wait_for_each_other(void **state)
{
    (void)state;
    struct jobs j = { .work = add_one };
    if (!exchanged()) skip();
    wf_abreast(4, join, &j);
    assert_int_equal(j.begun, 4);
    for (int k = 0; k < 4; k++) assert_int_equal(j.sum[k], k);
    assert_int_equal(calls, 3);
    for (size_t k = 0; k < 3; k++) assert_int_equal(together[k], 3 - k);
    assert_false(wf_abreast_inside());
}

/* What is left comes again, with what the others ask for next. */
static void work_may_leave_some(void **state)
{
    (void)state;
    struct jobs j = { .work = add_to_first, .joins = 2 };
    if (!exchanged()) skip();
    wf_abreast(3, join, &j);
    for (int k = 0; k < 3; k++) assert_int_equal(j.sum[k], 2);
    static const size_t expected[] = { 3, 3, 2, 2, 1, 1 };
    assert_int_equal(calls, 6);
    for (size_t k = 0; k < 6; k++) assert_int_equal(together[k], expected[k]);
}

static void *jobs_in_a_job(void *context)
{
    struct jobs *j = context;
    struct jobs inner = { .work = j->work, .joins = 1 };
    wf_abreast(2, join, &inner);
    for (int k = 0; k < inner.begun; k++) assert_int_equal(inner.sum[k], 1);
    return join(j);
}

static void jobs_have_jobs(void **state)
{
    (void)state;
    struct jobs j = { .work = add_one, .joins = 1 };
    if (!exchanged()) skip();
    wf_abreast(3, jobs_in_a_job, &j);
    static const size_t expected[] = { 2, 2, 2, 3 };
    assert_int_equal(calls, 4);
    for (size_t k = 0; k < 4; k++) assert_int_equal(together[k], expected[k]);
}

/* Elsewhere work is done at once; one job runs as without others, wherever. */
static void alone(void **state)
{
    (void)state;
    int sum = 0;
    struct jobs j = { .work = add_one, .joins = 3 };
    calls = 0;
    wf_abreast_join(add_one, &sum);
    assert_int_equal(sum, 1);
    wf_abreast(1, join, &j);
    assert_int_equal(j.sum[0], 3);
    for (size_t k = 0; k < calls; k++) assert_int_equal(together[k], 1);
}

/* ---- Stems ---- */

enum { STEMS = 13 };

struct stems {
    int begun;
    struct beam_case c[STEMS];
    struct wf_beam b[STEMS];
};

/* A leaning stem of some rows in a wind and laws by the seed; every fourth in still air. */
static void grow(struct beam_case *c, uint64_t seed)
{
    const double axis[3] = { 0.1, 0.02, sqrt(1 - 0.0104) };
    size_t rows = 3 + 5 * seed % 17;
    beam_stem(c, rows, axis, 8, 0.12, 0.03);
    beam_laws(c, seed);
    beam_profile(&c->wind, seed);
    c->wind.least = 0.5;
    c->wind.speed = 6 + (double)seed;
    if (seed % 4) c->loads.wind = &c->wind;
    for (size_t i = 0; i < rows; i++) c->tree.sail0[i] = c->tree.sail1[i] = 0.2;
    c->options.tolerance = 1e-9;
    c->options.mesh_tolerance = 0;
    if (seed % 5 == 2) c->options.root_stiffness[0] = c->options.root_stiffness[1] = 1e5;
    if (seed % 3 == 1) beam_masses(c);
}

static void *rest(void *context)
{
    struct stems *s = context;
    while (s->begun < STEMS) {
        size_t k = (size_t)s->begun++;
        struct beam_case *c = &s->c[k];
        grow(c, k);
        c->err = (struct wf_err){ 0 };
        assert_int_equal(
            wf_beam_init(&s->b[k], &c->tree, &c->loads, &c->options, NULL, &c->arena, &c->arena, &c->err),
            WF_OK);
        assert_true(s->b[k].chain);
        assert_int_equal(wf_beam_newton(&s->b[k]), WF_OK);
        assert_true(wf_beam_stable(&s->b[k]));
        assert_false(s->b[k].apart);
    }
    return NULL;
}

static struct stems *stems_by(size_t copies)
{
    struct stems *s = calloc(1, sizeof *s);
    assert_non_null(s);
    if (copies)
        wf_abreast(copies, rest, s);
    else
        (void)rest(s);
    return s;
}

static void let_go(struct stems *s)
{
    for (int k = 0; k < STEMS; k++) beam_free(&s->c[k]);
    free(s);
}

/* The same bytes whatever else is solved, and the answers of one element after another. */
static void stems_do_not_mix(void **state)
{
    (void)state;
    static const char *const width[] = { "1", "4", "8" };
    const char *named = getenv("WINDFIRM_LANES");
    char own[8] = "";
    if (named) (void)snprintf(own, sizeof own, "%s", named);
    struct stems *one = stems_by(1), *other = stems_by(0);
    for (size_t w = 0; w < 3; w++) {
        (void)setenv("WINDFIRM_LANES", width[w], 1);
        struct stems *many = stems_by(9);
        for (int k = 0; k < STEMS; k++) {
            const struct wf_beam *a = &one->b[k], *b = &many->b[k], *c = &other->b[k];
            size_t n = a->mesh.n;
            assert_int_equal(n, b->mesh.n);
            assert_memory_equal(a->pose, b->pose, n * sizeof *a->pose);
            assert_memory_equal(a->shape, b->shape, n * sizeof *a->shape);
            assert_memory_equal(a->wrench, b->wrench, n * sizeof *a->wrench);
            assert_memory_equal(a->answer, b->answer, n * sizeof *a->answer);
            assert_memory_equal(&a->misfit, &b->misfit, sizeof a->misfit);
            assert_memory_equal(&a->base, &b->base, sizeof a->base);
            for (int i = 0; i < 3; i++) assert_close(a->pose[n - 1].r[i], c->pose[n - 1].r[i], 1e-9 * 8);
        }
        let_go(many);
    }
    if (named)
        (void)setenv("WINDFIRM_LANES", own, 1);
    else
        (void)unsetenv("WINDFIRM_LANES");
    let_go(one), let_go(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(jobs_wait_for_each_other),
                                        cmocka_unit_test(work_may_leave_some),
                                        cmocka_unit_test(jobs_have_jobs), cmocka_unit_test(alone),
                                        cmocka_unit_test(stems_do_not_mix) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
