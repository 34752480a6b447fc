/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The wind inside and behind a tree: exact cases, symmetry, conservation, refusals. */
#include "wind/shelter_laws.h"
#include "close.h"
#include "wind/shelter.h"
#include <string.h>

static const double pi = 3.14159265358979323846;

/* A tree of straight rows, each on its own from the ground up unless it has a parent. */
struct stand {
    struct wf_arena arena;
    struct wf_tree t;
    size_t n;
};

static void begin(struct stand *s, size_t room)
{
    *s = (struct stand){ 0 };
    assert_int_equal(wf_tree_alloc(&s->t, room, &s->arena, NULL), WF_OK);
    s->t.n = 0;
}

static size_t row(struct stand *s, const double from[3], const double to[3], double r0, double r1)
{
    size_t i = s->t.n++;
    s->t.x0[i] = from[0], s->t.y0[i] = from[1], s->t.z0[i] = from[2];
    s->t.x1[i] = to[0], s->t.y1[i] = to[1], s->t.z1[i] = to[2];
    s->t.r0[i] = r0, s->t.r1[i] = r1;
    s->t.id[i] = (int64_t)i + 1;
    return i;
}

static struct wf_wind blow(double azimuth, const char *profile)
{
    return (struct wf_wind){ .sample = wf_profile_named(profile)->sample,
                             .speed = 10,
                             .direction = { cos(azimuth), sin(azimuth), 0 },
                             .reference_height = 10,
                             .exponent = 0.16 };
}

static struct wf_shelter_request ask(const char *law, size_t slabs, size_t cells)
{
    struct wf_shelter_request q;
    wf_shelter_request_default(&q);
    q.law = wf_shelter_law_named(law);
    q.slabs = slabs;
    q.cells = cells;
    return q;
}

static struct wf_shelter make(struct stand *s, const struct wf_wind *w, const struct wf_shelter_request *q)
{
    struct wf_shelter out;
    struct wf_err e = { 0 };
    if (wf_shelter_make(&s->t, w, q, &s->arena, &out, &e)) fail_msg("%s", e.text);
    return out;
}

/* A crown of forked branches, turned by `azimuth`, its left side mirrored when `mirror` is set. */
static void crown(struct stand *s, double azimuth, bool mirror)
{
    double c = cos(azimuth), d = sin(azimuth);
    begin(s, 64);
    for (int pass = 0; pass < 61; pass++) {
        double a = pass == 0 ? 0 : 2.4 * pass, h = pass == 0 ? 0 : 2 + 0.1 * pass,
               l = pass == 0 ? 0 : 3.5 - 0.03 * pass;
        double p0[3] = { 0, 0, h }, p1[3] = { l * cos(a), l * sin(a), pass == 0 ? 9 : h + 0.4 * l };
        if (mirror) p1[1] = -p1[1];
        double q0[3] = { c * p0[0] - d * p0[1], d * p0[0] + c * p0[1], p0[2] },
               q1[3] = { c * p1[0] - d * p1[1], d * p1[0] + c * p1[1], p1[2] };
        size_t i = row(s, q0, q1, pass == 0 ? 0.15 : 0.04, 0.02);
        s->t.parent[i] = pass == 0 ? -1 : 0;
        s->t.sail0[i] = pass == 0 ? 0 : 0.05;
        s->t.sail1[i] = pass == 0 ? 0 : 0.12;
    }
}

static void without_a_tree_the_wind_is_untouched(void **state)
{
    (void)state;
    for (const struct wf_shelter_law *l = wf_shelter_laws; l->name; l++) {
        struct stand none, tree;
        struct wf_wind w = blow(0.4, "power"), field;
        struct wf_shelter_request q = ask(l->name, 8, 32);
        begin(&none, 1);
        crown(&tree, 0, false);
        struct wf_shelter s = make(&none, &w, &q), t = make(&tree, &w, &q);
        for (int k = 0; k < 50; k++) {
            double x[3] = { -2 + 0.1 * k, 0.03 * k, 0.13 * k }, u[3], du[9], v[3], dv[9];
            w.sample(&w, x, v, dv);
            wf_shelter_field(&s, &field);
            field.sample(&field, x, u, du);
            assert_memory_equal(u, v, sizeof u);
            assert_memory_equal(du, dv, sizeof du);
            double beside[3] = { -9 * sin(0.4), 9 * cos(0.4), x[2] }, before[3] = { -6, -3, x[2] };
            wf_shelter_field(&t, &field);
            w.sample(&w, beside, v, dv);
            field.sample(&field, beside, u, du);
            assert_memory_equal(u, v, sizeof u);
            w.sample(&w, before, v, dv);
            field.sample(&field, before, u, du);
            assert_memory_equal(u, v, sizeof u);
        }
        assert_close(s.slab[8].flux, 1, 0);
        assert_true(t.slab[8].flux < 1);
        wf_arena_free(&none.arena);
        wf_arena_free(&tree.arena);
    }
}

static void a_wall_lets_its_share_through(void **state)
{
    (void)state;
    struct stand s;
    begin(&s, 40);
    for (int k = 0; k < 40; k++)
        row(&s, (double[]){ 0.01 * (k % 3), -8 + 0.4 * k, 0 }, (double[]){ 0.01 * (k % 3), -8 + 0.4 * k, 10 },
            0.3, 0.3);
    for (const struct wf_shelter_law *l = wf_shelter_laws; l->name; l++)
        for (int energy = 0; energy < 2; energy++)
            for (size_t slabs = 1; slabs <= 3; slabs += 2) {
                struct wf_wind w = blow(0, "uniform"), field;
                struct wf_shelter_request q = ask(l->name, slabs, 64);
                q.energy = energy;
                double share = energy ? sqrt(0.2) : 0.2, ratio[3], slope[9], u[3], du[9];
                assert_close(wf_shelter_speed_share(&q), share, 1e-15);
                struct wf_shelter h = make(&s, &w, &q);
                wf_shelter_field(&h, &field);
                for (int k = -20; k <= 20; k++) {
                    const double x[3] = { 2.6, 0.25 * k, 4 + 0.1 * k };
                    wf_shelter_ratio(&h, x, ratio, slope);
                    assert_close(ratio[0], share, 1e-12);
                    assert_close(ratio[1], 0, 1e-12);
                    field.sample(&field, x, u, du);
                    assert_close(u[0], 10 * share, 1e-12);
                }
                size_t full = 0, cells = 0;
                for (size_t k = 0; k < slabs; k++) {
                    full += h.slab[k].full;
                    cells += h.slab[k].cells[WF_CELL_TRANSMITTING];
                }
                assert_true(full > 3000 && cells >= full);
            }
    wf_arena_free(&s.arena);
}

static void coverage_is_that_of_the_geometry_on_every_grid(void **state)
{
    (void)state;
    struct stand s;
    struct wf_wind w = blow(0.3, "uniform");
    double d[3] = { cos(0.3), sin(0.3), 0 }, axis[3] = { 1.5, 2.5, 6 }, along = 0, length = 0;
    begin(&s, 1);
    row(&s, (double[]){ 1, 2, 0.5 }, (double[]){ 2.5, 4.5, 6.5 }, 0.31, 0.12);
    s.t.sail0[0] = 0.3, s.t.sail1[0] = 0.9;
    for (int k = 0; k < 3; k++) along += d[k] * axis[k], length += axis[k] * axis[k];
    length = sqrt(length);
    double cosine = along / length, sine = sqrt(1 - cosine * cosine);
    double want = 0.43 * length * sine + 0.5 * pi * cosine * (0.31 * 0.31 + 0.12 * 0.12);
    for (size_t cells = 8; cells <= 256; cells *= 2)
        for (size_t slabs = 1; slabs <= 16; slabs *= 4) {
            struct wf_shelter_request q = ask("wake", slabs, cells);
            q.crown_drag = 0.5;
            q.sail_share = 0.7;
            struct wf_shelter h = make(&s, &w, &q);
            double wood = 0, leaf = 0;
            for (size_t k = 0; k < slabs; k++) wood += h.slab[k].wood, leaf += h.slab[k].leaf;
            assert_close(wood, want, 1e-11);
            assert_close(leaf, 0.6 * length * 0.7 / 0.5, 1e-11);
        }
    wf_arena_free(&s.arena);
}

static void mirrored_trees_have_mirrored_winds(void **state)
{
    (void)state;
    for (const struct wf_shelter_law *l = wf_shelter_laws; l->name; l++) {
        struct stand left, right;
        struct wf_wind w = blow(0, "power");
        struct wf_shelter_request q = ask(l->name, 16, 48);
        crown(&left, 0, false);
        crown(&right, 0, true);
        struct wf_shelter a = make(&left, &w, &q), b = make(&right, &w, &q);
        double most = 0;
        for (int k = 0; k < 400; k++) {
            double x[3] = { -3 + 0.02 * k, 3.4 * sin(1.7 * k), 1 + 4 * (1 + cos(2.9 * k)) }, r[3], m[3],
                   sl[9];
            wf_shelter_ratio(&a, x, r, sl);
            x[1] = -x[1];
            wf_shelter_ratio(&b, x, m, sl);
            assert_close(m[0], r[0], 1e-9);
            assert_true(fabs(m[1] + r[1]) < 1e-9 && fabs(m[2] - r[2]) < 1e-9);
            most = fmax(most, fabs(1 - r[0]));
        }
        assert_true(most > 0.2);
        wf_arena_free(&left.arena);
        wf_arena_free(&right.arena);
    }
}

static void tree_and_wind_turned_together(void **state)
{
    (void)state;
    for (const struct wf_shelter_law *l = wf_shelter_laws; l->name; l++)
        for (int turn = 1; turn < 4; turn++) {
            struct stand still, turned;
            double angle = 2.1 * turn, c = cos(angle), d = sin(angle);
            struct wf_wind w = blow(0.2, "power"), v = blow(0.2 + angle, "power"), f, g;
            struct wf_shelter_request q = ask(l->name, 16, 48);
            crown(&still, 0, false);
            crown(&turned, angle, false);
            struct wf_shelter a = make(&still, &w, &q), b = make(&turned, &v, &q);
            wf_shelter_field(&a, &f);
            wf_shelter_field(&b, &g);
            for (int k = 0; k < 200; k++) {
                double x[3] = { -3 + 0.04 * k, 3.4 * sin(1.7 * k), 1 + 4 * (1 + cos(2.9 * k)) };
                double y[3] = { c * x[0] - d * x[1], d * x[0] + c * x[1], x[2] }, u[3], p[3], du[9];
                f.sample(&f, x, u, du);
                g.sample(&g, y, p, du);
                assert_true(fabs(c * u[0] - d * u[1] - p[0]) < 1e-8);
                assert_true(fabs(d * u[0] + c * u[1] - p[1]) < 1e-8);
                assert_true(fabs(u[2] - p[2]) < 1e-8);
            }
            wf_arena_free(&still.arena);
            wf_arena_free(&turned.arena);
        }
}

static void gradients_belong_to_the_velocity(void **state)
{
    (void)state;
    for (const struct wf_shelter_law *l = wf_shelter_laws; l->name; l++) {
        struct stand tree;
        struct wf_wind w = blow(0.7, "power"), f;
        struct wf_shelter_request q = ask(l->name, 12, 40);
        crown(&tree, 0, false);
        struct wf_shelter s = make(&tree, &w, &q);
        wf_shelter_field(&s, &f);
        for (int k = 0; k < 200; k++) {
            double x[3] = { -3 + 0.05 * k, 3 * sin(1.3 * k), 1 + 4 * (1 + cos(2.9 * k)) }, u[3], du[9],
                   any[9];
            f.sample(&f, x, u, du);
            for (int j = 0; j < 3; j++) {
                double a[3] = { x[0], x[1], x[2] }, b[3] = { x[0], x[1], x[2] }, lo[3], hi[3];
                a[j] -= 1e-6, b[j] += 1e-6;
                f.sample(&f, a, lo, any);
                f.sample(&f, b, hi, any);
                for (int i = 0; i < 3; i++)
                    assert_true(fabs((hi[i] - lo[i]) / 2e-6 - du[3 * i + j]) <
                                1e-4 * (1 + fabs(du[3 * i + j])));
            }
        }
        wf_arena_free(&tree.arena);
    }
}

static void wakes_keep_their_loss_and_recover(void **state)
{
    (void)state;
    struct stand s;
    struct wf_wind w = blow(0, "uniform");
    struct wf_shelter_request q = ask("wake", 40, 128);
    begin(&s, 3);
    row(&s, (double[]){ 0, 0, 4 }, (double[]){ 0, 0, 6 }, 0.2, 0.2);
    row(&s, (double[]){ 6, 4, 0 }, (double[]){ 6, 4, 10 }, 1e-6, 1e-6); /* only to widen the grid */
    row(&s, (double[]){ 0, -4, 0 }, (double[]){ 0, -4, 10 }, 1e-6, 1e-6);
    struct wf_shelter h = make(&s, &w, &q);
    size_t cells = h.up * h.across, first = 0;
    double area = h.step[1] * h.step[2], before = 1;
    while (!(h.slab[first].wood > 0)) first++;
    /* the drag of the stem over rho U^2: the loss of momentum in any plane behind it */
    double lost = 0;
    for (size_t c = 0; c < cells; c++) lost += h.part[0][(first + 2) * cells + c] * area;
    assert_true(lost > 0.5 * 0.4 * 2 && lost < 0.8);
    for (size_t p = first + 2; p < h.planes; p++) {
        double sum = 0, peak = 0;
        for (size_t c = 0; c < cells; c++) {
            sum += h.part[0][p * cells + c] * area;
            peak = fmax(peak, h.part[0][p * cells + c]);
        }
        assert_close(sum, lost, 1e-3); /* the hair-thin rows and the tails of the Gaussian */
        assert_true(peak <= before + 1e-6);
        before = peak;
    }
    assert_true(before < 0.35);
    wf_arena_free(&s.arena);
}

static size_t count(const struct wf_shelter *s, enum wf_cell_class c)
{
    size_t n = 0;
    for (size_t k = 0; k < s->slabs; k++) n += s->slab[k].cells[c];
    return n;
}

static void classes_by_their_rules(void **state)
{
    (void)state;
    struct wf_wind w = blow(0, "uniform");
    struct wf_shelter_request q = ask("feng1999", 1, 40);
    struct stand s;
    begin(&s, 8); /* a single stem on a wide grid */
    row(&s, (double[]){ 0, 0, 0 }, (double[]){ 0, 0, 10 }, 0.2, 0.2);
    row(&s, (double[]){ 0, -5, 0 }, (double[]){ 0, -5, 10 }, 1e-9, 1e-9);
    row(&s, (double[]){ 0, 5, 0 }, (double[]){ 0, 5, 10 }, 1e-9, 1e-9);
    struct wf_shelter h = make(&s, &w, &q);
    assert_true(count(&h, WF_CELL_CYLINDER) > 0);
    assert_int_equal(count(&h, WF_CELL_TRANSMITTING) + count(&h, WF_CELL_HOLE) + count(&h, WF_CELL_SLIT), 0);
    for (size_t c = 0; c < h.up * h.across; c++) /* its width is the stem's */
        if (h.class[c] == WF_CELL_CYLINDER && c / h.across > 0 && c / h.across + 3 < h.up)
            assert_close(h.width[c], 0.4, 1e-9);
    wf_arena_free(&s.arena);
    begin(&s, 8); /* four bars around one open cell, the grid's cells 1 m wide */
    row(&s, (double[]){ 0, -10, 0 }, (double[]){ 0, -10, 42 }, 10, 10);
    row(&s, (double[]){ 0, 10.5, 0 }, (double[]){ 0, 10.5, 42 }, 9.5, 9.5);
    row(&s, (double[]){ 0, -20, 10 }, (double[]){ 0, 20, 10 }, 10, 10);
    row(&s, (double[]){ 0, -20, 31.5 }, (double[]){ 0, 20, 31.5 }, 10.5, 10.5);
    q.cells = 44;
    h = make(&s, &w, &q);
    assert_int_equal(count(&h, WF_CELL_HOLE), 1);
    assert_true(count(&h, WF_CELL_TRANSMITTING) > 500);
    s.t.n = 3; /* without the upper beam the opening is a slit up to the top */
    h = make(&s, &w, &q);
    assert_int_equal(count(&h, WF_CELL_HOLE), 0);
    assert_int_equal(count(&h, WF_CELL_SLIT), 22);
    wf_arena_free(&s.arena);
}

static void printed_flow_of_a_stem(void **state)
{
    (void)state;
    struct stand s;
    struct wf_wind w = blow(0, "uniform");
    struct wf_shelter_request q = ask("feng1999", 64, 128);
    begin(&s, 3);
    row(&s, (double[]){ 0, 0, 0 }, (double[]){ 0, 0, 10 }, 0.5, 0.5);
    row(&s, (double[]){ 4.5, 4, 0 }, (double[]){ 4.5, 4, 10 }, 1e-9, 1e-9);
    row(&s, (double[]){ 0, -4, 0 }, (double[]){ 0, -4, 10 }, 1e-9, 1e-9);
    struct wf_shelter h = make(&s, &w, &q);
    size_t slab = 0;
    while (!h.slab[slab].cells[WF_CELL_CYLINDER]) slab++;
    double centre = h.low[0] + ((double)slab + 0.5) * h.step[0], ratio[3], slope[9];
    for (double a = 3; a <= 6; a += 1) { /* on the axis behind it 1 - (a/x)^2, smoothed by the splines */
        wf_shelter_ratio(&h, (double[]){ centre + a * 0.5, 0, 5 }, ratio, slope);
        assert_close(1 - ratio[0], 1 / (a * a), 0.02);
    }
    wf_arena_free(&s.arena);
}

static void refuses_bad_requests(void **state)
{
    (void)state;
    struct stand s;
    struct wf_wind w = blow(0, "uniform");
    crown(&s, 0, false);
    for (int k = 0; k < 11; k++) {
        struct wf_shelter_request q;
        struct wf_shelter h;
        struct wf_err e = { 0 };
        wf_shelter_request_default(&q);
        if (k == 0) q.slabs = 0;
        if (k == 1) q.cells = 0;
        if (k == 2) q.cells = 1000000;
        if (k == 3) q.transmission = 2;
        if (k == 4) q.transmission = (double)NAN;
        if (k == 5) q.law = wf_shelter_law_named("fog");
        if (k == 6) q.leaf_reach = 0;
        if (k == 7) q.gap = 0;
        if (k == 8) q.slabs = 512, q.cells = 1024;
        if (k == 9) q.wake_growth = -1;
        if (k == 10) q.clear = 0.7;
        assert_int_equal(wf_shelter_make(&s.t, &w, &q, &s.arena, &h, &e), WF_EUSAGE);
        assert_true(strlen(e.text) > 20);
    }
    for (size_t limit = 64; limit < 6000000; limit = limit * 3 / 2) { /* memory: refused until it is enough */
        struct wf_arena a = { .limit = limit };
        struct wf_shelter_request q = ask("wake", 8, 32);
        struct wf_shelter h;
        enum wf_status status = wf_shelter_make(&s.t, &w, &q, &a, &h, NULL);
        assert_true(status == WF_OK || status == WF_ENOMEM);
        assert_true(limit > 1000 || status == WF_ENOMEM);
        assert_true(limit < 4000000 || status == WF_OK);
        wf_arena_free(&a);
    }
    wf_arena_free(&s.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_tree_the_wind_is_untouched),
        cmocka_unit_test(a_wall_lets_its_share_through),
        cmocka_unit_test(coverage_is_that_of_the_geometry_on_every_grid),
        cmocka_unit_test(mirrored_trees_have_mirrored_winds),
        cmocka_unit_test(tree_and_wind_turned_together),
        cmocka_unit_test(gradients_belong_to_the_velocity),
        cmocka_unit_test(wakes_keep_their_loss_and_recover),
        cmocka_unit_test(classes_by_their_rules),
        cmocka_unit_test(printed_flow_of_a_stem),
        cmocka_unit_test(refuses_bad_requests),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
