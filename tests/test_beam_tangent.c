/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The eliminated tangent is exact: a Newton correction leads back to an equilibrium that was left. */
#include "base/vec3.h"
#include "beam_cases.h"
#include "solve/beam_eliminate.h"

/* Largest part of the correction that is wrong, after each unknown of an equilibrium was moved by up to
 * `size`: quadratic convergence means that it falls with size^2. */
static double miss(struct wf_beam *b, double size, uint64_t seed)
{
    size_t n = b->mesh.n;
    struct wf_arena a = { 0 };
    struct wf_beam_shape *rest = WF_TAKE(&a, n, struct wf_beam_shape);
    double(*tilt)[3] = wf_arena_take(&a, b->mesh.tree->n, sizeof *tilt), most = 0;
    memcpy(rest, b->shape, n * sizeof *rest);
    memcpy(tilt, b->tilt, b->mesh.tree->n * sizeof *tilt);
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 6; k++) b->shape[i].v[k / 3][k % 3] += size * beam_random(&seed);
    for (int k = 0; k < 2; k++)
        if (b->options->root_stiffness[k] > 0) b->tilt[0][k] += size * beam_random(&seed);
    struct wf_beam_shape *left = WF_TAKE(&a, n, struct wf_beam_shape);
    b->misfit = (struct wf_beam_misfit){ 0 };
    wf_beam_sweep_up(b);
    assert_true(wf_beam_sweep_down(b, true, NULL));
    wf_beam_sweep_up(b); /* strains follow the forces */
    assert_true(wf_beam_sweep_down(b, true, NULL));
    memcpy(left, b->shape, n * sizeof *left);
    double(*change)[6] = wf_arena_take(&a, n, sizeof *change);
    for (size_t i = 0; i < n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_pose ground;
        const double *base_L = wf_beam_base(b, i, &ground)->L, *from = b->root_change[0];
        if (p->parent >= 0) from = change[p->parent];
        double dv[2][3];
        wf_beam_correct(&b->shape[i], base_L, &b->answer[i], &b->node[i], from, dv, change[i]);
        for (int k = 0; k < 6; k++) {
            double back = left[i].v[k / 3][k % 3] + dv[k / 3][k % 3] - rest[i].v[k / 3][k % 3];
            most = fmax(most, fabs(back));
        }
    }
    for (int k = 0; k < 2; k++) most = fmax(most, fabs(b->tilt[0][k] + b->root_step[0][k] - tilt[0][k]));
    memcpy(b->shape, rest, n * sizeof *rest);
    memcpy(b->tilt, tilt, b->mesh.tree->n * sizeof *tilt);
    wf_arena_free(&a);
    return most;
}

/* Everything at once: wind with a gradient, lift, crowns, weight, masses, dead and follower loads, curved
 * rows, a root plate. */
static void load_all(struct beam_case *c)
{
    struct wf_tree *t = &c->tree;
    c->loads.gravity = 9.81;
    c->wind.sample = wf_profile_named("log")->sample;
    beam_blow(c, 20, 6, 0);
    for (size_t i = 0; i < t->n; i++) t->lift[i] = 0.4, t->sail0[i] = t->sail1[i] = 2 * t->r0[i];
    for (size_t i = 1; i < t->n; i += 3) t->drag[i] = NAN;
    beam_masses(c);
    t->mass1[t->n - 1] = 0.02;
    beam_line(c, 0.1, -0.2, 0.05);
    beam_push(c, 3, WF_POINT_DEAD, 5, 20, -9);
    memcpy(beam_push(c, 2, WF_POINT_FOLLOWER, 30, 10, 20)->moment, (double[]){ 10, 20, 30 },
           sizeof(double[3]));
    c->options.root_stiffness[0] = 2e5, c->options.root_stiffness[1] = 1e5;
    t->bend = WF_TAKE(&c->arena, 3 * t->n, double);
    for (size_t i = 0; i < t->n; i += 2) {
        double d[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] }, k[3];
        wf_cross(d, (double[]){ 0.3, 1, 0.2 }, k);
        for (size_t j = 0; j < 3; j++) t->bend[3 * i + j] = 0.3 * k[j] / wf_dot(d, d);
    }
}

static void check(struct beam_case *c)
{
    struct wf_beam b;
    struct wf_beam_outcome out;
    c->options.mesh_tolerance = 0, c->options.tolerance = 1e-12;
    assert_int_equal(wf_beam_init(&b, &c->tree, &c->loads, &c->options, NULL, &c->arena, &c->arena, &c->err),
                     WF_OK);
    if (wf_beam_settle(&b, &c->arena, &out, &c->err)) fail_msg("%s", c->err.text);
    assert_true(out.load_factor == 1 && !out.beyond_limit);
    for (uint64_t seed = 1; seed < 4; seed++) {
        double coarse = miss(&b, 1e-4, seed), fine = miss(&b, 1e-6, seed);
        if (!(fine < 1e-11)) fail_msg("a step of 1e-6 comes back with an error of %g", fine);
        if (!(coarse / fine > 3000)) fail_msg("error %g at 1e-4, %g at 1e-6: not quadratic", coarse, fine);
    }
    beam_free(c);
}

static void of_a_tree(void **state)
{
    (void)state;
    struct beam_case c;
    beam_wild(&c, 30, 11);
    load_all(&c);
    check(&c);
}

/* Strips askew to everything, with their weight to one side. */
static void of_strips(void **state)
{
    (void)state;
    struct beam_case c;
    beam_wild(&c, 30, 11);
    load_all(&c);
    struct wf_tree *t = &c.tree;
    t->bend = NULL;
    assert_int_equal(wf_tree_alloc_sections(t, &c.arena, &c.err), WF_OK);
    for (size_t i = 0; i < t->n; i++) {
        struct wf_tree_sections *s = t->section;
        double d[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] }, *up = s->up + 3 * i;
        wf_cross(d, (double[]){ 0.3, 1, 0.2 }, up);
        double size = sqrt(wf_dot(up, up));
        for (int k = 0; k < 3; k++) up[k] /= size;
        s->width0[i] = 3 * t->r0[i], s->width1[i] = 3 * t->r1[i];
        s->height0[i] = 1.5 * t->r0[i], s->height1[i] = 1.5 * t->r1[i];
        s->mix0[3 * i] = 1, s->mix1[3 * i + 1 + i % 2] = 1;
        s->side0[i] = 40 * t->r0[i], s->side1[i] = -10 * t->r1[i];
    }
    check(&c);
}

static void of_a_clamped_stem_in_wind(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 6, upright, 6, 0.04, 0.02);
    c.loads.gravity = 9.81;
    c.wind.sample = wf_profile_named("power")->sample;
    c.wind.exponent = 0.2;
    beam_blow(&c, 50, 0, 0);
    check(&c);
}

/* Stretch changes the load within an element only to second order: with dead loads the tangent is exact with
 * stretch and shear too. */
static void of_a_flexible_stem(void **state)
{
    (void)state;
    struct beam_case c;
    beam_stem(&c, 6, (double[]){ 0.6, 0, 0.8 }, 2, 0.04, 0.04);
    for (size_t i = 0; i < 6; i++) c.tree.youngs[i] = 4e6, c.tree.shear[i] = 1e6;
    c.options.shear_flexible = true;
    c.loads.gravity = 9.81;
    beam_push(&c, 5, WF_POINT_DEAD, 4, 1, 3);
    struct wf_beam b;
    struct wf_beam_outcome out;
    c.options.tolerance = 1e-12;
    assert_int_equal(wf_beam_init(&b, &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err),
                     WF_OK);
    assert_int_equal(wf_beam_settle(&b, &c.arena, &out, &c.err), WF_OK);
    assert_true(b.misfit.strain < 1e-13 && b.misfit.turn > 1e-3);
    assert_true(miss(&b, 1e-6, 1) < 3e-9);
    beam_free(&c);
}

/* From rest, Newton's misfit falls quadratically: few steps, the last ones squaring. */
static void newton(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_beam b;
    beam_tree7(&c);
    c.loads.gravity = 9.81;
    beam_blow(&c, 60, 0, 0);
    double miss_at[3];
    for (int k = 0; k < 3; k++) {
        c.options.iterations_max = (size_t)(1 + k), c.options.tolerance = 1e-15;
        assert_int_equal(wf_beam_init(&b, &c.tree, &c.loads, &c.options, NULL, &c.arena, &c.arena, &c.err),
                         WF_OK);
        assert_int_equal(wf_beam_newton(&b), WF_ENOCONV);
        miss_at[k] = sqrt(b.misfit.bending / b.misfit.energy);
    }
    assert_true(miss_at[0] < 0.1 && miss_at[0] > 1e-6);
    assert_true(miss_at[1] < 30 * miss_at[0] * miss_at[0] &&
                miss_at[2] < 30 * miss_at[1] * miss_at[1] + 1e-12);
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_a_tree),
        cmocka_unit_test(of_strips),
        cmocka_unit_test(of_a_clamped_stem_in_wind),
        cmocka_unit_test(of_a_flexible_stem),
        cmocka_unit_test(newton),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
