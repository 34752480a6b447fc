/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solutions one after another: the same answers as the beam solver, and derivatives by the wind speed. */
#include "beam_cases.h"
#include "solve/beam.h"
#include "solve/beam_many.h"
#include "solve/track.h"

enum { STEM = 6, BRANCHES = 10, ROWS = STEM + 2 * BRANCHES };

static void young_tree(struct beam_case *c)
{
    uint64_t seed = 3;
    beam_new(c, ROWS);
    c->loads.gravity = 9.81;
    for (int i = 0; i < STEM; i++)
        beam_row(c, (size_t)i, i - 1, (double[]){ 0, 0, 1.5 * i }, (double[]){ 0, 0, 1.5 * (i + 1) },
                 0.08 - 0.01 * i, 0.07 - 0.01 * i);
    for (size_t k = 0; k < BRANCHES; k++) {
        int32_t below = (int32_t)(2 + k % 4);
        double a = 2.4 * (double)k, up = 0.5 + 0.3 * beam_random(&seed),
               from[3] = { 0, 0, 1.5 * (below + 1) };
        for (size_t j = 0; j < 2; j++) {
            size_t row = STEM + 2 * k + j;
            double to[3] = { from[0] + 0.7 * cos(up) * cos(a), from[1] + 0.7 * cos(up) * sin(a),
                             from[2] + 0.7 * sin(up) };
            beam_row(c, row, below, from, to, 0.016 - 0.006 * (double)j, 0.01 - 0.005 * (double)j);
            c->tree.level[row] = 1;
            c->tree.sail0[row] = c->tree.sail1[row] = 0.05;
            memcpy(from, to, sizeof to);
            below = (int32_t)row;
        }
    }
    beam_blow(c, 10, 0, 0);
}

static enum wf_status at_speed(struct beam_case *c, struct wf_track *k, double speed, double step,
                               struct wf_tracked *out)
{
    struct wf_wind wind = c->wind, more = c->wind;
    struct wf_loads loads = c->loads, side = c->loads;
    const struct wf_track_start start = { .share = step / speed };
    wind.speed = speed, more.speed = speed + step;
    loads.wind = speed > 0 ? &wind : NULL;
    side.wind = &more;
    return wf_track_solve(k, &loads, step > 0 ? &side : NULL, &start, &c->arena, out, &c->err);
}

static double largest_difference(const struct wf_response *a, const struct wf_response *b, double *size)
{
    double off = 0;
    *size = 0;
    for (size_t i = 0; i < 3 * a->n; i++) {
        off = fmax(off, fabs(a->moment0[i] - b->moment0[i]));
        *size = fmax(*size, fabs(b->moment0[i]));
    }
    return off;
}

/* The solution of a track at a speed beside one by itself, in c->out. Returned: the largest difference of
 * their moments, over the largest moment. */
static double beside_itself(struct beam_case *c, struct wf_track *k, double speed, struct wf_tracked *r)
{
    double size;
    assert_int_equal(at_speed(c, k, speed, 0, r), WF_OK);
    beam_blow(c, speed, 0, 0);
    if (!(speed > 0)) c->loads.wind = NULL;
    beam_solve(c);
    c->loads.wind = &c->wind;
    double off = largest_difference(&r->at, &c->out, &size);
    return off > 0 ? off / size : 0;
}

static void same_answers_in_any_order(void **state)
{
    (void)state;
    static const double speed[] = { 10, 12, 0, 25, 3, 24, 40, 5 };
    struct beam_case c;
    struct wf_track *k;
    struct wf_tracked r;
    young_tree(&c);
    assert_int_equal(wf_track_open(&c.tree, &c.options, NULL, &k, &c.err), WF_OK);
    for (size_t i = 0; i < sizeof speed / sizeof *speed; i++) {
        assert_true(beside_itself(&c, k, speed[i], &r) <= 2e-6); /* of the mesh, on which they differ */
        assert_true(r.at.imbalance < 1e-11 && !r.irregular);
    }
    wf_track_close(k);
    beam_free(&c);
}

/* A rod between two branches: its force is that of the wind solved for, whatever was solved before. */
static void rods_in_any_order(void **state)
{
    (void)state;
    static const double speed[] = { 10, 0, 25, 3, 24, 40, 5 }, tolerance[] = { 1e-6, 1e-4 };
    enum { FROM = STEM + 1, TO = STEM + 3 };
    for (size_t m = 0; m < sizeof tolerance / sizeof *tolerance; m++) {
        struct beam_case c;
        struct wf_track *k;
        struct wf_tracked r;
        young_tree(&c);
        const struct wf_tree *t = &c.tree;
        struct wf_link rod = { .segment = { FROM, TO }, .stiffness = 2e4, .pushes = true };
        rod.length = 0.98 * sqrt(pow(t->x1[FROM] - t->x1[TO], 2) + pow(t->y1[FROM] - t->y1[TO], 2) +
                                 pow(t->z1[FROM] - t->z1[TO], 2));
        c.loads.link = &rod, c.loads.links = 1;
        c.options.mesh_tolerance = tolerance[m];
        assert_int_equal(wf_track_open(&c.tree, &c.options, NULL, &k, &c.err), WF_OK);
        for (size_t i = 0; i < sizeof speed / sizeof *speed; i++) {
            assert_true(beside_itself(&c, k, speed[i], &r) <= 2 * tolerance[m]);
            assert_true(fabs(r.at.link[0] - c.out.link[0]) <=
                        5 * tolerance[m] * fmax(fabs(c.out.link[0]), 1)); /* [N] */
        }
        wf_track_close(k);
        beam_free(&c);
    }
}

/* The derivative of every moment against central differences of solutions on the same mesh. Given: tolerance
 * of the solutions with derivatives, and the share by which their side's wind is faster. Returned: the
 * largest error, over the largest derivative. */
static double slopes_off(double tolerance, double share)
{
    struct beam_case c;
    struct wf_track *k, *tight;
    struct wf_tracked at, low, high;
    double worst = 0;
    young_tree(&c);
    c.loads.streamline = wf_streamline_named("vogel");
    c.loads.streamline_par.number[0] = -0.7, c.loads.streamline_par.number[1] = 5;
    for (size_t i = 0; i < c.tree.n; i++) c.tree.drag[i] = NAN; /* by the law */
    struct wf_solve_options o = c.options, fine = c.options;
    o.mesh_tolerance = fine.mesh_tolerance = 0;
    o.tolerance = tolerance, fine.tolerance = 1e-12;
    assert_int_equal(wf_track_open(&c.tree, &o, NULL, &k, &c.err), WF_OK);
    assert_int_equal(wf_track_open(&c.tree, &fine, NULL, &tight, &c.err), WF_OK);
    for (double speed = 4; speed < 45; speed *= 1.7) {
        const double step = share * speed, apart = 2e-4 * speed;
        double size = 0, off = 0;
        assert_int_equal(at_speed(&c, tight, speed - apart, 0, &low), WF_OK);
        assert_int_equal(at_speed(&c, tight, speed + apart, 0, &high), WF_OK);
        assert_int_equal(at_speed(&c, k, speed, step, &at), WF_OK);
        assert_true(at.sided);
        for (size_t i = 0; i < 3 * at.at.n; i++) {
            double slope = (at.side.moment0[i] - at.at.moment0[i]) / (step * (1 + 0.5 * share));
            double want = (high.at.moment0[i] - low.at.moment0[i]) / (2 * apart);
            off = fmax(off, fabs(slope - want)), size = fmax(size, fabs(want));
        }
        worst = fmax(worst, off / size);
    }
    wf_track_close(k), wf_track_close(tight);
    beam_free(&c);
    printf("slopes at tolerance %g, share %g: off by %.2g\n", tolerance, share, worst);
    return worst;
}

static void slopes_are_derivatives(void **state)
{
    (void)state;
    assert_true(slopes_off(1e-12, 3e-7) <= 1e-6);
    assert_true(slopes_off(1e-6, 3e-7) <= 1e-6);
    /* as searches solve; in a fast wind the share is so small that what Newton's method has left is not */
    assert_true(slopes_off(3e-4, 1e-8) <= 1e-6);
}

/* A stem that tapers to a twig, with a crown on it: on a coarse mesh too the tip turns as on a fine one. */
static void tip_of_a_coarse_mesh(void **state)
{
    (void)state;
    double turn[2];
    for (int k = 0; k < 2; k++) {
        struct beam_case c;
        struct wf_track *track;
        struct wf_tracked out;
        const struct wf_track_start start = { .share = 3e-7 };
        beam_stem(&c, 28, upright, 20, 0.4, 0.002);
        for (size_t i = 12; i < 28; i++) c.tree.sail0[i] = c.tree.sail1[i] = 1.2;
        beam_blow(&c, 18, 0, 0);
        c.loads.gravity = 9.81;
        c.options.mesh_tolerance = k ? 1e-8 : 1e-3;
        assert_int_equal(wf_track_open(&c.tree, &c.options, NULL, &track, &c.err), WF_OK);
        assert_int_equal(wf_track_solve(track, &c.loads, NULL, &start, &c.arena, &out, &c.err), WF_OK);
        turn[k] = out.at.turn[3 * 27 + 1];
        wf_track_close(track);
        beam_free(&c);
    }
    printf("turn of the tip off by %.2g\n", turn[0] / turn[1] - 1);
    assert_true(fabs(turn[0] / turn[1] - 1) < 3e-3);
}

/* A measured tree: a stem and branches of many short rows. */
static void tree_of_short_rows(struct beam_case *c)
{
    enum { TALL = 120, LIMBS = 20, LONG = 8 };
    beam_new(c, TALL + LIMBS * LONG);
    c->loads.gravity = 9.81;
    for (int i = 0; i < TALL; i++)
        beam_row(c, (size_t)i, i - 1, (double[]){ 0, 0, 0.1 * i }, (double[]){ 0, 0, 0.1 * (i + 1) },
                 0.15 - 0.0005 * i, 0.1495 - 0.0005 * i);
    for (int k = 0; k < LIMBS; k++) {
        int32_t below = 39 + 4 * k;
        const double a = 2.4 * k;
        double from[3] = { 0, 0, 0.1 * (below + 1) };
        for (int j = 0; j < LONG; j++) {
            const size_t row = (size_t)(TALL + LONG * k + j);
            double to[3] = { from[0] + 0.1 * cos(a), from[1] + 0.1 * sin(a), from[2] + 0.05 };
            beam_row(c, row, below, from, to, 0.04 - 0.004 * j, 0.036 - 0.004 * j);
            c->tree.level[row] = 1;
            c->tree.sail0[row] = c->tree.sail1[row] = 0.05;
            memcpy(from, to, sizeof to);
            below = (int32_t)row;
        }
    }
}

/* Largest difference of the ends' displacements from those on a much finer mesh, over the largest. */
static double off_finest_response(struct beam_case *c, const struct wf_loads *l,
                                  const struct wf_response *own)
{
    struct wf_response finest;
    struct wf_solve_options fine = c->options;
    double off = 0, size = 0;
    fine.mesh_tolerance = 1e-9;
    assert_int_equal(wf_solver_beam.solve(&c->tree, l, &fine, &c->arena, &finest, NULL, &c->err), WF_OK);
    for (size_t i = 0; i < 3 * c->tree.n; i++) {
        off = fmax(off, fabs(own->end[i] - finest.end[i]));
        size = fmax(size, fabs(finest.end[i]));
    }
    return off / size;
}

static double off_finest(struct beam_case *c, const struct wf_beam *b)
{
    struct wf_response own;
    assert_int_equal(wf_response_alloc(&own, c->tree.n, &c->arena, &c->err), WF_OK);
    wf_beam_read(b, &own);
    return off_finest_response(c, &c->loads, &own);
}

/* One comparison of two meshes leaves one of few elements, which is taken in winds in which it is good by
 * far, and in no other. */
static void few_elements(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_beam_few few = { .pieces = NULL };
    struct wf_beam first, next, strong;
    struct wf_beam_outcome out;
    size_t elements = 0;
    tree_of_short_rows(&c);
    beam_blow(&c, 14, 0, 0);
    struct wf_beam_known known = { .few = &few };
    assert_int_equal(
        wf_beam_solve(&c.tree, &c.loads, &c.options, &known, &c.arena, &c.arena, &first, &out, &c.err),
        WF_OK);
    assert_non_null(few.pieces);
    for (size_t i = 0; i < c.tree.n; i++) elements += (size_t)few.pieces[i];
    assert_true(first.mesh.n >= 2 * c.tree.n && 10 * elements <= 16 * c.tree.n);
    assert_true(off_finest(&c, &first) < 5e-7);

    known.near = &first;
    beam_blow(&c, 13, 0, 0);
    assert_int_equal(
        wf_beam_solve(&c.tree, &c.loads, &c.options, &known, &c.arena, &c.arena, &next, &out, &c.err), WF_OK);
    assert_int_equal(next.mesh.n, elements);
    assert_true(off_finest(&c, &next) < 5e-7);

    beam_blow(&c, 30, 0, 0);
    assert_int_equal(
        wf_beam_solve(&c.tree, &c.loads, &c.options, &known, &c.arena, &c.arena, &strong, &out, &c.err),
        WF_OK);
    assert_true(strong.mesh.n > elements);
    assert_true(off_finest(&c, &strong) < 1e-6);
    wf_arena_free(&few.memory);
    beam_free(&c);
}

/* The same side by side, in wind from all around; where the mesh is not good for one state it is for none. */
static void few_elements_side_by_side(void **state)
{
    (void)state;
    enum { N = 6 };
    struct beam_case c;
    struct wf_beam_few few = { .pieces = NULL };
    const struct wf_beam_known known = { .few = &few };
    struct wf_beam first;
    struct wf_beam_outcome out;
    struct wf_wind wind[N];
    struct wf_loads loads[N];
    struct wf_beam_state at[N];
    tree_of_short_rows(&c);
    beam_blow(&c, 14, 0, 0);
    assert_int_equal(
        wf_beam_solve(&c.tree, &c.loads, &c.options, &known, &c.arena, &c.arena, &first, &out, &c.err),
        WF_OK);
    const struct wf_beam_few before = few;
    for (int strong = 0; strong < 2; strong++) {
        for (size_t k = 0; k < N; k++) {
            wind[k] = c.wind, loads[k] = c.loads;
            wind[k].direction[0] = cos((double)k), wind[k].direction[1] = sin((double)k);
            wind[k].speed = strong && k == 3 ? 30 : 13;
            loads[k].wind = &wind[k];
            at[k] = (struct wf_beam_state){ .loads = &loads[k] };
        }
        assert_int_equal(wf_beam_many(&c.tree, at, N, &c.options, &few, &c.arena, NULL, &c.err), WF_OK);
        for (size_t k = 0; k < N; k++) {
            assert_int_equal(at[k].status, WF_OK);
            assert_false(at[k].alone);
            assert_true(off_finest_response(&c, &loads[k], &at[k].response) < 1e-6);
        }
    }
    assert_memory_equal(&few.goods, &before.goods, sizeof few.goods);
    wf_arena_free(&few.memory);
    beam_free(&c);
}

/* A state may begin in the shape of one in a near wind, and one of the track under a gust's load in that of
 * the wind in which the load is as large. */
static void begun_in_near_shapes(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_track *mean, *peak;
    struct wf_tracked r;
    struct wf_beam own, begun;
    struct wf_beam_outcome out;
    const double gusts = 1.5; /* root of the factor of the load */
    young_tree(&c);
    struct wf_solve_options quick = c.options; /* keeps several solutions */
    quick.mesh_tolerance = 1e-3;
    assert_int_equal(wf_track_open(&c.tree, &quick, NULL, &mean, &c.err), WF_OK);
    assert_null(wf_track_near(mean, 10));
    assert_int_equal(at_speed(&c, mean, 10, 0, &r), WF_OK);
    assert_int_equal(at_speed(&c, mean, 25, 0, &r), WF_OK);
    assert_null(wf_track_near(mean, 40));

    beam_blow(&c, 26, 0, 0);
    const struct wf_beam_known near = { .soon = wf_track_near(mean, 26) };
    assert_non_null(near.soon);
    assert_int_equal(
        wf_beam_solve(&c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &own, &out, &c.err), WF_OK);
    assert_int_equal(
        wf_beam_solve(&c.tree, &c.loads, &c.options, &near, &c.arena, &c.arena, &begun, &out, &c.err), WF_OK);
    printf("iterations %zu, unloaded %zu\n", begun.iterations, own.iterations);
    assert_true(begun.iterations < own.iterations);
    assert_true(off_finest(&c, &begun) < 1e-6);

    assert_int_equal(wf_track_open(&c.tree, &c.options, NULL, &peak, &c.err), WF_OK);
    beam_blow(&c, 25 / gusts, 0, 0);
    c.loads.wind_scale = gusts * gusts;
    const struct wf_track_start start = { .paced = mean };
    assert_int_equal(wf_track_solve(peak, &c.loads, NULL, &start, &c.arena, &r, &c.err), WF_OK);
    assert_true(off_finest_response(&c, &c.loads, &r.at) < 1e-6);
    wf_track_close(peak);
    wf_track_close(mean);
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(same_answers_in_any_order),
                                        cmocka_unit_test(rods_in_any_order),
                                        cmocka_unit_test(slopes_are_derivatives),
                                        cmocka_unit_test(tip_of_a_coarse_mesh),
                                        cmocka_unit_test(few_elements),
                                        cmocka_unit_test(few_elements_side_by_side),
                                        cmocka_unit_test(begun_in_near_shapes) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
