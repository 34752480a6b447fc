/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tree that stands in its shape: the internal forces of its weight are in it. */
#include "beam_cases.h"
#include "fail/fail.h"
#include "solve/beam_many.h"
#include "solve/firm.h"
#include "solve/modes.h"
#include <stdio.h>
#include <stdlib.h>

#define assert_near(got, want, within) assert_true(fabs((got) - (want)) <= (within))

static void stand(struct beam_case *c)
{
    c->loads.gravity = 9.81;
    assert_int_equal(wf_tree_stand(&c->tree, &c->tree, &c->arena, &c->err), WF_OK);
}

/* A crooked tree with branches, curved rows, burden, a mass and shear. */
static void crooked(struct beam_case *c)
{
    beam_tree7(c);
    beam_masses(c);
    c->tree.mass1[3] = 1.5;
    c->tree.bend = WF_TAKE(&c->arena, 21, double);
    c->tree.bend[3] = -0.05, c->tree.bend[4] = 0.1, c->tree.bend[5] = 0; /* across row 1 */
    for (size_t i = 0; i < 7; i++) c->tree.burden0[i] = 0.3, c->tree.burden1[i] = 0.5;
    c->options.shear_flexible = true;
}

static void the_drawn_shape_is_balanced(void **state)
{
    (void)state;
    for (int32_t cut = 1; cut < 40; cut *= 3)
        for (int plate = 0; plate < 2; plate++) {
            struct beam_case c;
            struct wf_beam b;
            int32_t pieces[7];
            crooked(&c);
            stand(&c);
            if (plate) c.options.root_stiffness[0] = c.options.root_stiffness[1] = 4e4;
            for (int i = 0; i < 7; i++) pieces[i] = cut;
            assert_int_equal(
                wf_beam_init(&b, &c.tree, &c.loads, &c.options, pieces, &c.arena, &c.arena, &c.err), WF_OK);
            wf_beam_sweep_up(&b);
            assert_true(wf_beam_sweep_down(&b, false, NULL));
            assert_true(b.misfit.energy > 0);
            assert_true(b.misfit.bending <= 1e-24 * b.misfit.energy);
            assert_true(b.misfit.strain <= 1e-12 * b.misfit.turn);
            assert_int_equal(wf_beam_newton(&b), WF_OK);
            assert_int_equal(b.iterations, 0);
            beam_free(&c);
        }
}

static void still_air_moves_nothing(void **state)
{
    (void)state;
    const struct wf_solver *solver[] = { &wf_solver_beam, &wf_solver_linear };
    for (int k = 0; k < 2; k++) {
        struct beam_case c;
        crooked(&c);
        stand(&c);
        assert_int_equal(beam_try(&c, solver[k]), WF_OK);
        for (int i = 0; i < 21; i++) {
            assert_true(fabs(c.out.end[i]) <= (k ? 1e-15 : 0));
            assert_true(fabs(c.out.turn[i]) <= (k ? 1e-15 : 0));
        }
        double weight = 1.5 * 9.81; /* the whole weight is on the ground */
        for (size_t i = 0; i < 7; i++)
            for (int s = 0; s < 1000; s++) {
                double a = (s + 0.5) / 1000, r = c.tree.r0[i] + a * (c.tree.r1[i] - c.tree.r0[i]);
                weight += 9.81 * wf_tree_length(&c.tree, i) / 1000 * (850 * PI * r * r + 0.3 + 0.2 * a);
            }
        assert_close(c.out.base_force[2], -weight, 1e-6);
        assert_true(c.out.imbalance < 1e-12);
        beam_free(&c);
    }
}

/* Turned with its wind about the vertical, it moves alike; a state by itself and one of many agree. */
static void turned_with_its_wind(void **state)
{
    (void)state;
    struct beam_case c[2];
    for (int k = 0; k < 2; k++) {
        const double a = k ? 0.8 : 0, w = 0.3 + a;
        crooked(&c[k]);
        struct wf_tree *t = &c[k].tree;
        for (size_t i = 0; i < 7; i++) {
            double *const x[] = { &t->x0[i], &t->x1[i], &t->bend[3 * i] };
            double *const y[] = { &t->y0[i], &t->y1[i], &t->bend[3 * i + 1] };
            for (int q = 0; q < 3; q++) {
                const double u = *x[q], v = *y[q];
                *x[q] = u * cos(a) - v * sin(a), *y[q] = u * sin(a) + v * cos(a);
            }
        }
        stand(&c[k]);
        beam_blow(&c[k], 15 * cos(w), 15 * sin(w), 0);
        beam_solve(&c[k]);
    }
    for (int i = 0; i < 7; i++) {
        const double *p = c[0].out.end + 3 * i, *q = c[1].out.end + 3 * i;
        double size = sqrt(wf_dot(p, p)), ca = cos(0.8), sa = sin(0.8);
        assert_true(size > 0.01 || i == 0);
        assert_near(q[0], p[0] * ca - p[1] * sa, 1e-9 * (1 + size));
        assert_near(q[1], p[0] * sa + p[1] * ca, 1e-9 * (1 + size));
        assert_near(q[2], p[2], 1e-9 * (1 + size));
    }
    beam_free(&c[0]);
    beam_free(&c[1]);
}

static void side_by_side_as_alone(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_beam_state of[3] = { 0 };
    struct wf_loads loads[3];
    struct wf_wind wind[3];
    crooked(&c);
    stand(&c);
    beam_blow(&c, 10, 4, 0);
    for (int k = 0; k < 3; k++) {
        wind[k] = c.wind, wind[k].speed = 6.0 * k + 2;
        loads[k] = c.loads, loads[k].wind = &wind[k], of[k].loads = &loads[k];
    }
    assert_int_equal(wf_beam_many(&c.tree, of, 3, &c.options, NULL, &c.arena, &c.diag, &c.err), WF_OK);
    for (int k = 0; k < 3; k++) {
        assert_int_equal(of[k].status, WF_OK);
        assert_false(of[k].alone);
        c.loads.wind = &wind[k];
        beam_solve(&c);
        for (int i = 0; i < 21; i++) {
            assert_near(of[k].response.end[i], c.out.end[i], 2e-6);
            assert_near(of[k].response.moment0[i], c.out.moment0[i], 2e-6 * 1000);
        }
    }
    beam_free(&c);
}

/* A leaning stem of 12 rows, of stress-free shape. */
static void leaning(struct beam_case *c, size_t n, double bow)
{
    const double axis[3] = { 0.5, 0.1, sqrt(1 - 0.26) };
    beam_stem(c, n, axis, 12, 0.06, 0.03);
    c->loads.gravity = 9.81;
    for (size_t i = 0; i < n; i++) c->tree.burden0[i] = c->tree.burden1[i] = 1;
    if (!(bow > 0)) return;
    for (size_t i = 0; i < n; i++) {
        double s0 = (double)i / (double)n, s1 = (double)(i + 1) / (double)n;
        c->tree.y0[i] += bow * s0 * s0, c->tree.y1[i] += bow * s1 * s1;
    }
}

static void open_beam(struct beam_case *c, const struct wf_tree *t, const int32_t *pieces, struct wf_beam *b)
{
    assert_int_equal(wf_beam_init(b, t, &c->loads, &c->options, pieces, &c->arena, &c->arena, &c->err),
                     WF_OK);
}

/* The bent tree as a new reference: mesh, tangents, curvature and strain as they are. */
static void hand_over(const struct wf_beam *was, struct wf_beam *now)
{
    for (size_t m = 0; m < was->mesh.n; m++) {
        struct wf_beam_pose ground;
        const struct wf_beam_pose *base = wf_beam_base(was, m, &ground);
        struct wf_beam_part *p = &now->mesh.part[m];
        double k[2][3];
        const struct wf_beam_part old = was->mesh.part[m];
        wf_beam_curvature(&old, &was->shape[m], k);
        *p = old;
        for (int j = 0; j < 2; j++) {
            memcpy(p->t[j], was->stage[m].t[j], sizeof p->t[j]);
            m3_apply(base->L, k[j], p->k0[j]);
            m3_apply(base->L, was->shape[m].g[j], now->shape[m].g[j]);
        }
    }
}

static void handed_over_in_memory(void **state)
{
    (void)state;
    for (int bowed = 0; bowed < 2; bowed++) {
        enum { ROWS = 12 };
        struct beam_case c;
        struct wf_beam was, now;
        int32_t pieces[ROWS];
        double start[ROWS][3];
        leaning(&c, ROWS, bowed ? 0.8 : 0);
        c.options.tolerance = 1e-12;
        for (int i = 0; i < ROWS; i++) pieces[i] = bowed ? 24 : 4;
        open_beam(&c, &c.tree, pieces, &was);
        assert_int_equal(wf_beam_newton(&was), WF_OK);
        struct wf_tree bent = c.tree;
        double *x[6];
        for (int q = 0; q < 6; q++) x[q] = WF_TAKE(&c.arena, ROWS, double);
        bent.x0 = x[0], bent.y0 = x[1], bent.z0 = x[2], bent.x1 = x[3], bent.y1 = x[4], bent.z1 = x[5];
        for (int i = 0; i < ROWS; i++)
            for (int q = 0; q < 3; q++) {
                start[i][q] = was.pose[was.mesh.last[i]].r[q];
                x[3 + q][i] = start[i][q];
                x[q][i] = i ? start[i - 1][q] : 0;
            }
        assert_true(fabs(start[ROWS - 1][2] - c.tree.z1[ROWS - 1]) > 0.2);
        open_beam(&c, &bent, pieces, &now);
        hand_over(&was, &now);
        assert_int_equal(wf_beam_newton(&now), WF_OK);
        for (int i = 0; i < ROWS; i++)
            for (int q = 0; q < 3; q++) assert_near(now.pose[now.mesh.last[i]].r[q], start[i][q], 1e-10);
        beam_blow(&c, bowed ? 6 : 12, bowed ? 28 : 0, 0); /* in the plane of the bending, and across it */
        if (!bowed) beam_blow(&c, 24 * 5 / sqrt(26), 24 / sqrt(26), 0);
        was.loads = now.loads = c.loads;
        assert_int_equal(wf_beam_newton(&was), WF_OK);
        assert_int_equal(wf_beam_newton(&now), WF_OK);
        double most = 0;
        for (int i = 0; i < ROWS; i++)
            for (int q = 0; q < 3; q++) {
                most = fmax(most, fabs(was.pose[was.mesh.last[i]].r[q] - start[i][q]));
                assert_near(now.pose[now.mesh.last[i]].r[q], was.pose[was.mesh.last[i]].r[q], 1e-9 * 12);
            }
        assert_true(most > 0.3);
        for (int q = 0; q < 3; q++) assert_near(now.base.m[q], was.base.m[q], 1e-9 * 5000);
        beam_free(&c);
    }
}

enum { FINE = 1024 };

/* Inextensible: a scan shows lengths as they are under weight, which differ by the stretch from those without
 * (7e-6 of the motion in this tree).
 *
 * Displacement of the tip by the wind of the stress-free stem, and the ends of FINE rows under its weight. */
static void original(double tip[3], double end[FINE][3])
{
    struct beam_case c;
    leaning(&c, FINE, 0.8);
    c.options.mesh_tolerance = 1e-9;
    c.options.inextensible = true;
    beam_solve(&c);
    for (size_t i = 0; i < FINE; i++) {
        end[i][0] = c.tree.x1[i] + c.out.end[3 * i];
        end[i][1] = c.tree.y1[i] + c.out.end[3 * i + 1];
        end[i][2] = c.tree.z1[i] + c.out.end[3 * i + 2];
    }
    beam_blow(&c, 3, 14, 0);
    beam_solve(&c);
    const double at[3] = { c.tree.x1[FINE - 1], c.tree.y1[FINE - 1], c.tree.z1[FINE - 1] };
    for (int q = 0; q < 3; q++) tip[q] = at[q] + c.out.end[3 * (FINE - 1) + q] - end[FINE - 1][q];
    beam_free(&c);
}

/* The same tree scanned as n straight segments, written with full precision and read again. */
static double scanned(size_t n, double end[FINE][3], const double tip[3])
{
    struct beam_case c;
    char text[6][40];
    double off = 0, size = 0, here[3] = { 0, 0, 0 };
    leaning(&c, n, 0.8);
    c.options.mesh_tolerance = 1e-9;
    c.options.inextensible = true;
    for (size_t i = 0; i < n; i++) {
        const double *to = end[(i + 1) * FINE / n - 1];
        double read[6];
        for (int q = 0; q < 3; q++) {
            snprintf(text[q], sizeof text[q], "%.9f", here[q]), read[q] = strtod(text[q], NULL);
            snprintf(text[3 + q], sizeof text[q], "%.9f", to[q]), read[3 + q] = strtod(text[3 + q], NULL);
        }
        double s0 = (double)i / (double)n, s1 = (double)(i + 1) / (double)n;
        beam_row(&c, i, (int32_t)i - 1, read, read + 3, 0.06 - 0.03 * s0, 0.06 - 0.03 * s1);
        memcpy(here, to, sizeof here);
    }
    stand(&c);
    beam_blow(&c, 3, 14, 0);
    beam_solve(&c);
    for (size_t q = 0; q < 3; q++) {
        off += pow(c.out.end[3 * (n - 1) + q] - tip[q], 2);
        size += tip[q] * tip[q];
    }
    beam_free(&c);
    return sqrt(off / size);
}

static void written_and_read_as_a_scan(void **state)
{
    (void)state;
    double tip[3], end[FINE][3], before = 0;
    original(tip, end);
    for (size_t n = 8; n <= 128; n *= 2) {
        double off = scanned(n, end, tip);
        print_message("%4zu segments: motion of the tip by the wind off by %.3g (ratio %.3g)\n", n, off,
                      before / off);
        if (n > 8) assert_true(before / off >= 3.5);
        assert_true(off < 0.02);
        before = off;
    }
}

/* What is added later bends the tree; what is taken away lets it rise. */
static void what_comes_later_is_a_load(void **state)
{
    (void)state;
    for (int wet = 0; wet < 2; wet++) {
        struct beam_case c;
        leaning(&c, 12, 0);
        stand(&c);
        for (size_t i = 0; i < 12; i++)
            c.tree.burden0[i] += wet ? 0.5 : -0.5, c.tree.burden1[i] += wet ? 0.5 : -0.5;
        beam_solve(&c);
        assert_true(wet ? c.out.end[35] < -0.05 : c.out.end[35] > 0.05);
        beam_free(&c);
    }
}

/* Its sway about rest is that of the bent tree it was. */
static void sways_as_before(void **state)
{
    (void)state;
    struct beam_case c, d;
    double was[3], now[3];
    leaning(&c, 48, 0);
    c.options.mesh_tolerance = 1e-7;
    assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 3, &c.arena, was, NULL, &c.err), WF_OK);
    beam_solve(&c);
    leaning(&d, 48, 0);
    d.options.mesh_tolerance = 1e-7;
    for (size_t i = 0; i < 48; i++) {
        double *const to[2][3] = { { d.tree.x0, d.tree.y0, d.tree.z0 }, { d.tree.x1, d.tree.y1, d.tree.z1 } };
        for (size_t q = 0; q < 3; q++) {
            to[1][q][i] += c.out.end[3 * i + q];
            if (i) to[0][q][i] = to[1][q][i - 1];
        }
    }
    stand(&d);
    assert_int_equal(wf_modes(&d.tree, &d.loads, &d.options, 3, &d.arena, now, NULL, &d.err), WF_OK);
    for (int k = 0; k < 3; k++) assert_close(now[k], was[k], 3e-4);
    beam_free(&c);
    beam_free(&d);
}

/* A slack twig on a sound stem is stiffened to twice its weight; a slack stem is not. */
static void slack(struct beam_case *c, double twig, double stem)
{
    static const double node[5][3] = { { 0, 0, 0 }, { 0, 0, 5 }, { 0, 0, 9 }, { 0.2, 0, 6 }, { 0.3, 0, 9 } };
    const struct beam_branch b[4] = {
        { 0, 1, stem, stem }, { 1, 2, stem, stem }, { 1, 3, twig, twig }, { 3, 4, twig, twig }
    };
    beam_tree(c, 4, node, b);
    c->tree.level[2] = c->tree.level[3] = 1;
    stand(c);
}

static void slack_parts_are_stiffened(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_firm f;
    double factor;
    slack(&c, 0.003, 0.08);
    const double *was = c.tree.youngs;
    assert_int_equal(wf_firm(&c.tree, &c.loads, &c.options, 0.05, 2, &c.arena, &f, &c.err), WF_OK);
    assert_false(f.gave_up);
    assert_int_equal(f.n, 1);
    assert_int_equal(f.part[0].row, 2);
    assert_true(f.part[0].factor < 1);
    assert_close(f.part[0].raise * f.part[0].factor, 2, 1e-3);
    assert_close(c.tree.youngs[3], 9e9 * f.part[0].raise, 1e-12);
    assert_close(c.tree.youngs[0], 9e9, 0);
    assert_close(was[3], 9e9, 0);
    assert_int_equal(wf_buckling(&c.tree, &c.loads, &c.options, &c.arena, &factor, &c.err), WF_OK);
    assert_close(factor, 2, 0.02);
    beam_solve(&c);
    assert_true(fabs(c.out.end[11]) <= 0);
    beam_free(&c);

    slack(&c, 0.02, 0.08); /* sound */
    assert_int_equal(wf_firm(&c.tree, &c.loads, &c.options, 0.05, 2, &c.arena, &f, &c.err), WF_OK);
    assert_true(!f.n && !f.gave_up);
    beam_free(&c);

    slack(&c, 0.0008, 0.008);
    assert_int_equal(wf_firm(&c.tree, &c.loads, &c.options, 0.05, 2, &c.arena, &f, &c.err), WF_OK);
    assert_true(f.gave_up && !f.root);
    assert_true(f.refused == 0 || f.refused == 1);
    beam_free(&c);

    slack(&c, 0.02, 0.08);
    c.options.root_stiffness[0] = c.options.root_stiffness[1] = 100;
    assert_int_equal(wf_firm(&c.tree, &c.loads, &c.options, 0.05, 2, &c.arena, &f, &c.err), WF_OK);
    assert_true(f.gave_up && f.root);
    beam_free(&c);
}

/* A stem with a pole on it, whose lowest row is thicker and whose upper four rows are light. */
static void pole(struct beam_case *c, double youngs)
{
    beam_new(c, 7);
    for (int i = 0; i < 7; i++) {
        const double at = i < 2 ? 2 * i : i + 2, to = i < 2 ? 2 * i + 2 : i + 3;
        const double radius = i < 2 ? 0.1 : i == 2 ? 0.014 : 0.01;
        beam_row(c, (size_t)i, i - 1, (double[]){ 0, 0, at }, (double[]){ 0, 0, to }, radius, radius);
        c->tree.youngs[i] = youngs, c->tree.shear[i] = youngs / 2.6;
    }
    c->loads.gravity = 9.81;
    assert_int_equal(wf_tree_stand(&c->tree, &c->tree, &c->arena, &c->err), WF_OK);
}

/* What stands with soft wood stands with stiffer wood: where the pole would fall as a whole although its
 * light part does not, the light part is stiffened as it is where it falls. */
static void stiffer_wood_stands_too(void **state)
{
    (void)state;
    const double light = 1.01, heavy = 800 * PI * (2 * 0.1 * 0.1 * 2 + 0.014 * 0.014) + light;
    bool stood = false;
    size_t stiffened = 0, refused = 0;
    for (double youngs = 0.2e9; youngs < 10e9; youngs *= 1.15) {
        struct beam_case c;
        struct wf_firm f;
        pole(&c, youngs);
        assert_int_equal(wf_firm(&c.tree, &c.loads, &c.options, light / heavy, 2, &c.arena, &f, &c.err),
                         WF_OK);
        if (stood && f.gave_up) fail_msg("stands with softer wood, and not with %.3g Pa", youngs);
        stood = stood || !f.gave_up;
        refused += f.gave_up, stiffened += !f.gave_up && f.n && f.part[0].factor > 1;
        if (!f.gave_up) beam_solve(&c);
        beam_free(&c);
    }
    assert_true(refused > 2 && stiffened > 0 && stood);
}

/* The change from the state at rest: nothing at rest; in a stiff tree, the plain difference; in one that
 * turns as a whole on its root, the forces at rest turn with it. */
static void change_from_rest(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_response rest, change;
    crooked(&c);
    for (size_t i = 0; i < 7; i++) c.tree.youngs[i] *= 1e5, c.tree.shear[i] *= 1e5;
    stand(&c);
    beam_solve(&c);
    rest = c.out;
    assert_int_equal(wf_response_change(&c.tree, &rest, &rest, &c.arena, &change, &c.err), WF_OK);
    for (int i = 0; i < 21; i++) {
        assert_near(change.moment0[i], 0, 1e-12 * fabs(rest.moment0[i]));
        assert_near(change.force1[i], 0, 1e-12 * fabs(rest.force1[i]));
    }
    beam_blow(&c, 15, 3, 0);
    beam_solve(&c);
    assert_int_equal(wf_response_change(&c.tree, &rest, &c.out, &c.arena, &change, &c.err), WF_OK);
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(c.out.moment0[i] - rest.moment0[i]) > 1 || i == 2);
        assert_near(change.moment0[i], c.out.moment0[i] - rest.moment0[i],
                    1e-4 * fabs(c.out.moment0[i]) + 1e-3);
    }
    c.options.root_stiffness[0] = c.options.root_stiffness[1] = 3e3;
    beam_solve(&c);
    assert_int_equal(wf_response_change(&c.tree, &rest, &c.out, &c.arena, &change, &c.err), WF_OK);
    double R[9], turned[3];
    rotation_matrix(c.out.turn + 3, R);
    assert_true(sqrt(wf_dot(c.out.turn + 3, c.out.turn + 3)) > 0.02);
    m3_apply(R, rest.force1 + 3, turned);
    for (int i = 0; i < 3; i++)
        assert_near(change.force1[3 + i], c.out.force1[3 + i] - turned[i], 1e-9 * fabs(rest.force1[5]));
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_drawn_shape_is_balanced),
        cmocka_unit_test(still_air_moves_nothing),
        cmocka_unit_test(turned_with_its_wind),
        cmocka_unit_test(side_by_side_as_alone),
        cmocka_unit_test(handed_over_in_memory),
        cmocka_unit_test(written_and_read_as_a_scan),
        cmocka_unit_test(what_comes_later_is_a_load),
        cmocka_unit_test(sways_as_before),
        cmocka_unit_test(slack_parts_are_stiffened),
        cmocka_unit_test(stiffer_wood_stands_too),
        cmocka_unit_test(change_from_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
