/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elements of one state side by side: the groups, and the answers of one element after the other. */
#include "beam_cases.h"
#include "solve/beam.h"
#include "solve/beam_inertia.h"
#include "solve/beam_newton.h"
#include "solve/beam_small.h"
#include <stdlib.h>

/* A tree at random in a wind and laws by the seed. */
static void grow(struct beam_case *c, uint64_t seed, size_t rows, double speed)
{
    beam_wild(c, rows, seed + 1);
    beam_laws(c, seed);
    beam_profile(&c->wind, seed);
    c->wind.least = 0.5;
    c->wind.speed = speed;
    c->loads.wind = &c->wind;
    c->options.tolerance = 1e-12;
    c->options.mesh_tolerance = 0;
    if (seed % 7 == 3) beam_masses(c);
    if (seed % 8 == 1) c->options.shear_flexible = true;
    if (seed % 5 == 2) c->options.root_stiffness[0] = c->options.root_stiffness[1] = 1e5;
}

/* Ties from two branches to the ground. */
static void tie(struct beam_case *c, struct wf_tie ties[2])
{
    for (int k = 0; k < 2; k++) {
        size_t row = c->tree.n - 1 - 3 * (size_t)k;
        ties[k] = (struct wf_tie){
            .segment = (int32_t)row, .anchor = { 6 - 12 * k, 4, 0 }, .stiffness = 200, .length = 0.1
        };
    }
    c->loads.tie = ties, c->loads.ties = 2;
}

/* The loads of a wind that is faster and denser by about a share. */
static const struct wf_loads *grow_wind(const struct beam_case *c, double share, struct wf_wind *wind,
                                        struct wf_loads *out)
{
    *wind = c->wind, *out = c->loads;
    wind->speed *= sqrt(1 + 2 * share), out->wind_scale *= 1 + 0.5 * share;
    out->wind = wind;
    return out;
}

/* The beam, to be computed by groups or not. */
static void begin(struct beam_case *c, bool groups, struct wf_beam *b)
{
    c->err = (struct wf_err){ 0 };
    if (wf_beam_init(b, &c->tree, &c->loads, &c->options, NULL, &c->arena, &c->arena, &c->err))
        fail_msg("%s", c->err.text);
    if (!groups)
        b->groups.n = 0;
    else
        assert_true(b->groups.n > 0);
}

/* Every element that does not stand on the ground is in one group, after all that stands on it. */
static void every_element_once(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 20; seed++) {
        struct beam_case c;
        struct wf_beam b;
        grow(&c, seed, 20 + 30 * seed, 10);
        begin(&c, true, &b);
        size_t *when = WF_TAKE(&c.arena, b.mesh.n, size_t), found = 0, grounded = 0;
        for (size_t g = 0; g < b.groups.n; g++) {
            const struct wf_beam_group *x = &b.groups.group[g];
            assert_in_range(x->n, 1, WF_GROUP);
            for (int k = 0; k < WF_GROUP; k++) {
                if (k >= x->n) {
                    assert_int_equal(x->id[k], x->id[0]);
                    continue;
                }
                assert_int_equal(when[x->id[k]], 0);
                when[x->id[k]] = g + 1;
                found++;
            }
        }
        for (size_t i = 0; i < b.mesh.n; i++) {
            int32_t below = b.mesh.part[i].parent;
            if (below < 0) {
                assert_int_equal(when[i], 0);
                grounded++;
            } else if (b.mesh.part[below].parent >= 0)
                assert_true(when[i] < when[below]);
        }
        assert_int_equal(found + grounded, b.mesh.n);
        beam_free(&c);
    }
}

/* A single stem has nothing side by side. */
static void no_groups_of_a_stem(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_beam b;
    beam_stem(&c, 40, upright, 20, 0.2, 0.1);
    if (wf_beam_init(&b, &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err))
        fail_msg("%s", c.err.text);
    assert_int_equal(b.groups.n, 0);
    beam_free(&c);
}

static double off(const double *a, const double *b, size_t n)
{
    double most = 0, size = 1e-300;
    for (size_t i = 0; i < n; i++) most = fmax(most, fabs(a[i] - b[i])), size = fmax(size, fabs(b[i]));
    return most / size;
}

/* One sweep far from equilibrium: every number of the tangent, the residual and the forces as of one element
 * after the other; with the guard of the first iteration, and with unstable directions counted. */
static void sweeps_agree(void **state)
{
    (void)state;
    double worst = 0;
    for (uint64_t seed = 0; seed < 60; seed++) {
        struct beam_case c[2];
        struct wf_beam b[2];
        struct wf_tie ties[2];
        struct wf_beam_stability count[2] = { { .margin = 1e-6 }, { .margin = 1e-6 } };
        struct wf_loads faster[2];
        struct wf_wind wind[2];
        const bool counting = seed % 3 == 1;
        for (int k = 0; k < 2; k++) {
            grow(&c[k], seed, 20 + 5 * seed, seed % 2 ? 12 : 30);
            if (seed % 5 == 4) tie(&c[k], ties);
            begin(&c[k], k, &b[k]);
            b[k].other = grow_wind(&c[k], 1e-3, &wind[k], &faster[k]);
            b[k].off = WF_TAKE(&c[k].arena, b[k].mesh.n, double);
            b[k].weak = WF_TAKE(&c[k].arena, b[k].mesh.n, bool);
            for (size_t i = 0; i < b[k].mesh.n; i++)
                for (int j = 0; j < 6; j++) b[k].shape[i].v[j / 3][j % 3] = 0.05 * sin((double)(7 * i) + j);
            if (seed % 4 == 2)
                assert_int_equal(wf_beam_linearise(&b[k], seed % 8 == 2, &c[k].arena, &c[k].err), WF_OK);
            else {
                b[k].misfit = (struct wf_beam_misfit){ .bending = 1, .energy = 1 };
                wf_beam_sweep_up(&b[k]);
                assert_true(wf_beam_sweep_down(&b[k], true, counting ? &count[k] : NULL));
            }
        }
        const size_t n = b[0].mesh.n;
#define OFF(array, per) off((const double *)b[1].array, (const double *)b[0].array, n *(per))
        double now = fmax(fmax(OFF(pose, 12), OFF(stage, 30)), fmax(OFF(wrench, 6), OFF(load, 6)));
        now = fmax(now, fmax(fmax(OFF(node, 48), OFF(answer, 48)), fmax(OFF(shape, 12), OFF(off, 1))));
        if (b[0].small) now = fmax(now, OFF(small, 150));
        assert_true(b[0].sided == b[1].sided && b[0].sided == (counting && seed % 4 != 2));
        for (int k = 0; k < 2 && b[0].sided; k++) assert_true(wf_beam_side_find(&b[k], NULL));
        if (b[0].sided) now = fmax(now, OFF(side, 12));
#undef OFF
        now = fmax(now, off(&b[1].misfit.bending, &b[0].misfit.bending, 4));
        now = fmax(now, off(b[1].base.n, b[0].base.n, 6));
        if (!(now < 1e-9)) fail_msg("tree %d: off by %g", (int)seed, now);
        worst = fmax(worst, now);
        assert_int_equal(count[0].negative, count[1].negative);
        assert_true(fabs(count[1].bears - count[0].bears) <= 1e-9 * fmax(1, count[0].bears) ||
                    count[0].bears == count[1].bears);
        assert_memory_equal(b[0].weak, b[1].weak, n * sizeof(bool));
        /* forces alone */
        for (int k = 0; k < 2; k++) assert_true(wf_beam_sweep_down(&b[k], false, NULL));
        assert_true(off(&b[1].misfit.bending, &b[0].misfit.bending, 4) < 1e-9);
        beam_free(&c[0]), beam_free(&c[1]);
    }
    printf("sweeps off by %.2g\n", worst);
}

/* Equilibria, of trees with point loads too. */
static void equilibria_agree(void **state)
{
    (void)state;
    size_t rests = 0;
    double worst = 0;
    for (uint64_t seed = 0; seed < 40; seed++) {
        struct beam_case c[2];
        struct wf_beam b[2];
        bool found[2];
        struct wf_tie ties[2];
        struct wf_point_load push = { .segment = 5, .kind = WF_POINT_FOLLOWER, .force = { 20, 0, 0 } };
        for (int k = 0; k < 2; k++) {
            grow(&c[k], seed, 20 + 5 * seed, seed % 2 ? 8 : 15);
            if (seed % 3 == 0) c[k].loads.point = &push, c[k].loads.points = 1;
            if (seed % 3 == 1) tie(&c[k], ties);
            begin(&c[k], k, &b[k]);
            found[k] = wf_beam_rests(&b[k]);
        }
        assert_int_equal(found[0], found[1]);
        if (found[0]) {
            rests++;
            assert_int_equal(b[0].iterations, b[1].iterations);
            double now = off((double *)b[1].pose, (double *)b[0].pose, 12 * b[0].mesh.n);
            if (!(now < 1e-9)) fail_msg("tree %d: off by %g", (int)seed, now);
            worst = fmax(worst, now);
        }
        beam_free(&c[0]), beam_free(&c[1]);
    }
    printf("%zu trees at rest, off by %.2g\n", rests, worst);
    assert_true(rests > 30);
}

/* The unknowns at a wind that is faster by a share, by itself, as doubles. */
static bool unknowns_at(struct beam_case *c, struct wf_beam *b, double share, double *out)
{
    struct wf_wind wind;
    struct wf_loads loads, now = b->loads;
    b->loads = *grow_wind(c, share, &wind, &loads), b->other = NULL;
    bool found = wf_beam_rests(b) && wf_beam_finish(b);
    memcpy(out, b->shape, b->mesh.n * sizeof *b->shape);
    memcpy(out + 12 * b->mesh.n, &b->base, sizeof b->base);
    b->loads = now;
    return found;
}

/* The change with the wind by the tangent of Newton's method, beside central differences of equilibria: of
 * all rotations, and of the forces on the ground after it is taken. Returned: false where a tree has no
 * equilibrium. */
static bool changes_agree(struct beam_case *c, struct wf_beam *b, double off_by[2])
{
    const double share = 1e-4;
    const size_t n = 12 * b->mesh.n, all = n + 6;
    struct wf_wind wind;
    struct wf_loads other;
    double *low = WF_TAKE(&c->arena, all, double), *high = WF_TAKE(&c->arena, all, double),
           *change = WF_TAKE(&c->arena, all, double), before[6];
    bool found = unknowns_at(c, b, -share, low) && unknowns_at(c, b, share, high);
    b->other = grow_wind(c, share, &wind, &other);
    if (!found || !wf_beam_rests(b)) return false;
    assert_true(wf_beam_side_find(b, NULL) && wf_beam_finish(b));
    memcpy(before, &b->base, sizeof before);
    memcpy(change, b->side, n * sizeof *change);
    assert_true(wf_beam_side_take(b));
    memcpy(change + n, &b->base, sizeof b->base);
    for (size_t i = 0; i < 6; i++) change[n + i] -= before[i];
    for (size_t i = 0; i < all; i++) low[i] = 0.5 * (high[i] - low[i]);
    for (size_t i = 0; i < n; i++) /* strains follow the forces of the step before */
        if (i % 12 >= 6) change[i] = low[i] = 0;
    off_by[0] = off(change, low, n), off_by[1] = off(change + n, low + n, 6);
    return true;
}

static void change_with_the_wind(void **state)
{
    (void)state;
    size_t rests = 0;
    double worst[2] = { 0 }, tied = 0;
    for (uint64_t seed = 0; seed < 60; seed++) {
        struct beam_case c;
        struct wf_beam b;
        struct wf_tie ties[2];
        double now[2];
        const bool held = seed % 4 == 1;
        grow(&c, seed, 20 + 2 * seed, seed % 2 ? 8 : 15);
        if (held) tie(&c, ties);
        begin(&c, seed % 3 != 2, &b);
        if (changes_agree(&c, &b, now)) {
            rests++;
            worst[1] = fmax(worst[1], now[1]);
            *(held ? &tied : worst) = fmax(held ? tied : worst[0], now[0]);
        }
        beam_free(&c);
    }
    printf("%zu trees at rest, changes off by %.2g, with cables by %.2g, of forces on the ground by %.2g\n",
           rests, worst[0], tied, worst[1]);
    assert_true(rests > 45);
    assert_true(worst[0] < 1e-7 && worst[1] < 2e-4); /* forces are those of a wind that is not small */
    assert_true(tied < 2e-3); /* where a cable pulls harder, what it pulls at stretches */
}

/* The same bytes for 1, 4 and 8 lanes. */
static void same_at_any_width(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 24; seed++) {
        struct beam_case c[3];
        struct wf_beam b[3];
        struct wf_loads faster;
        struct wf_wind wind;
        bool found[3];
        static const char *const width[] = { "1", "4", "8" };
        for (int k = 0; k < 3; k++) {
            setenv("WINDFIRM_LANES", width[k], 1);
            grow(&c[k], seed, 60 + 3 * seed, 12);
            begin(&c[k], true, &b[k]);
            if (seed % 4 == 1) b[k].off = WF_TAKE(&c[k].arena, b[k].mesh.n, double);
            b[k].other = grow_wind(&c[k], 1e-3, &wind, &faster);
            (void)wf_beam_rests(&b[k]);
            found[k] = wf_beam_side_find(&b[k], NULL);
            if (seed % 2) (void)wf_beam_linearise(&b[k], true, &c[k].arena, &c[k].err);
        }
        for (int k = 1; k < 3; k++) {
            const size_t n = b[0].mesh.n;
            assert_memory_equal(b[k].pose, b[0].pose, n * sizeof *b[0].pose);
            assert_memory_equal(b[k].node, b[0].node, n * sizeof *b[0].node);
            assert_memory_equal(b[k].answer, b[0].answer, n * sizeof *b[0].answer);
            assert_memory_equal(&b[k].misfit, &b[0].misfit, sizeof b[0].misfit);
            assert_int_equal(found[k], found[0]);
            if (found[0]) assert_memory_equal(b[k].side, b[0].side, n * sizeof *b[0].side);
            if (b[0].small) assert_memory_equal(b[k].small, b[0].small, n * sizeof *b[0].small);
        }
        for (int k = 0; k < 3; k++) beam_free(&c[k]);
    }
    unsetenv("WINDFIRM_LANES");
}

/* ---- The response to inertia ---- */

struct inertia {
    const double *root;
    const wf_four *in;
};

/* Inertia of motions times the square root of the mass, as loads per length. */
static void inertia_of(const void *ctx, const struct wf_beam *b, size_t i, struct wf_beam_disturbance *out)
{
    const struct inertia *x = ctx;
    for (size_t q = 8 * i; q < 8 * i + 8; q++) {
        size_t j = q % 8 / 4, c = q % 4;
        wf_four per_length = 2 / b->mesh.part[i].h * x->root[q] * x->in[q];
        if (c < 3)
            out->force[j][c] = per_length;
        else
            for (size_t k = 0; k < 3; k++) out->couple[j][k] = b->stage[i].t[j][k] * per_length;
    }
}

/* A tree at random about some shape, linearised: with point masses, ties, links and root springs by the seed.
 */
static void grow_linear(struct beam_case *c, uint64_t seed, bool groups, struct wf_tie ties[2],
                        struct wf_link *link, struct wf_beam *b)
{
    grow(c, seed, 20 + 5 * seed, 10);
    for (size_t i = 0; i < c->tree.n && c->tree.mass1; i++) c->tree.mass1[i] = 0.1 * (double)(i % 3);
    if (seed % 5 == 4) tie(c, ties);
    if (seed % 3 == 1) {
        *link = (struct wf_link){
            { 3, (int32_t)c->tree.n - 1 }, .stiffness = 300, .length = 0.5, .pushes = true
        };
        c->loads.link = link, c->loads.links = 1;
    }
    begin(c, groups, b);
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 6; j++) b->shape[i].v[j / 3][j % 3] = 0.02 * sin((double)(7 * i) + j);
    if (wf_beam_linearise(b, true, &c->arena, &c->err)) fail_msg("%s", c->err.text);
}

/* Random motions and the square roots of their masses. */
static wf_four *random_motions(struct beam_case *c, const struct wf_beam *b, double **root)
{
    const size_t size = wf_beam_motion_size(b);
    uint64_t s = 5;
    wf_four *in = WF_TAKE(&c->arena, size, wf_four);
    *root = WF_TAKE(&c->arena, size, double);
    wf_beam_motion_mass(b, *root);
    for (size_t q = 0; q < size; q++) {
        (*root)[q] = sqrt((*root)[q]);
        for (int v = 0; v < 4; v++) in[q][v] = beam_random(&s);
    }
    return in;
}

/* The same by the answer to any small load. */
static const wf_four *response(struct beam_case *c, struct wf_beam *b, const double *root, const wf_four *in)
{
    const size_t n = b->mesh.n, size = wf_beam_motion_size(b);
    wf_four(*push)[6] = wf_arena_take(&c->arena, n, sizeof *push);
    wf_four(*ends)[6] = wf_arena_take(&c->arena, n, sizeof *ends);
    struct wf_beam_small_answer out = { .ends = ends, .motion = WF_TAKE(&c->arena, size, wf_four) };
    const struct inertia x = { root, in };
    for (size_t q = 8 * n; q < size; q++) push[(q - 8 * n) / 3][(q - 8 * n) % 3] = root[q] * in[q];
    wf_beam_answer_small(b, inertia_of, &x, (const wf_four(*)[6])push, NULL, &out);
    for (size_t q = 8 * n; q < size; q++) out.motion[q] = ends[(q - 8 * n) / 3][(q - 8 * n) % 3];
    for (size_t q = 0; q < size; q++) out.motion[q] *= root[q];
    return out.motion;
}

/* Four vectors at once, and one of them alone; by groups and one element after another. */
static void inertia_agrees(void **state)
{
    (void)state;
    double worst = 0;
    for (uint64_t seed = 0; seed < 60; seed++) {
        struct beam_case c;
        struct wf_beam b;
        struct wf_tie ties[2];
        struct wf_link link;
        struct wf_beam_inertia four, one;
        double *root;
        grow_linear(&c, seed, seed % 4 != 3, ties, &link, &b);
        const size_t size = wf_beam_motion_size(&b);
        wf_four *in = random_motions(&c, &b, &root);
        const wf_four *wanted = response(&c, &b, root, in);
        double *single = WF_TAKE(&c.arena, size, double), *third = WF_TAKE(&c.arena, size, double);
        for (size_t q = 0; q < size; q++) single[q] = in[q][2], third[q] = wanted[q][2];
        assert_int_equal(wf_beam_inertia_open(&b, root, 4, &c.arena, &four, &c.err), WF_OK);
        assert_int_equal(wf_beam_inertia_open(&b, root, 1, &c.arena, &one, &c.err), WF_OK);
        wf_beam_inertia_answer(&four, (double *)in, (double *)in);
        wf_beam_inertia_answer(&one, single, single);
        double now = fmax(off((double *)in, (const double *)wanted, 4 * size), off(single, third, size));
        if (!(now < 1e-9)) fail_msg("tree %d: off by %g", (int)seed, now);
        worst = fmax(worst, now);
        for (size_t i = 0; i < b.mesh.n; i++)
            assert_memory_equal(wf_beam_inertia_end(&four, i, 2), wf_beam_inertia_end(&one, i, 0),
                                6 * sizeof(double));
        beam_free(&c);
    }
    printf("responses to inertia off by %.2g\n", worst);
}

static void inertia_at_any_width(void **state)
{
    (void)state;
    static const char *const width[] = { "1", "4", "8" };
    for (uint64_t seed = 0; seed < 24; seed++) {
        struct beam_case c;
        struct wf_beam b;
        struct wf_tie ties[2];
        struct wf_link link;
        struct wf_beam_inertia x;
        double *root;
        wf_four *out[3];
        grow_linear(&c, seed, true, ties, &link, &b);
        const wf_four *in = random_motions(&c, &b, &root);
        const size_t size = wf_beam_motion_size(&b);
        assert_int_equal(wf_beam_inertia_open(&b, root, 4, &c.arena, &x, &c.err), WF_OK);
        for (int k = 0; k < 3; k++) {
            setenv("WINDFIRM_LANES", width[k], 1);
            out[k] = WF_TAKE(&c.arena, size, wf_four);
            wf_beam_inertia_answer(&x, (const double *)in, (double *)out[k]);
        }
        for (int k = 1; k < 3; k++) assert_memory_equal(out[k], out[0], size * sizeof **out);
        beam_free(&c);
    }
    unsetenv("WINDFIRM_LANES");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_element_once),   cmocka_unit_test(no_groups_of_a_stem),
        cmocka_unit_test(sweeps_agree),         cmocka_unit_test(equilibria_agree),
        cmocka_unit_test(change_with_the_wind), cmocka_unit_test(same_at_any_width),
        cmocka_unit_test(inertia_agrees),       cmocka_unit_test(inertia_at_any_width),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
