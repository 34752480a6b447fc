/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees with bark and cavities: how their rows are cut, stiffness and stress of bent stems against closed
 * forms, the walls that are needed, what is refused. */
#include "beam_cases.h"
#include "branched.h"
#include "data/hollow.h"
#include "data/section.h"
#include "fail/fail.h"
#include "shell.h"
#include "solve/modes.h"
#include "study/walls.h"

static const double length = 4, radius = 0.1, push = 3;

/* A straight upright stem, all of it with one section, pushed at its top towards `angle` by a force so small
 * that it stays straight. */
static void pushed(struct beam_case *c, const struct wf_hollow *h, double angle, struct wf_breakage *b)
{
    static const double up[3] = { 0, 0, 1 };
    beam_stem(c, 6, up, length, radius, radius);
    assert_int_equal(wf_tree_alloc_hollow(&c->tree, &c->arena, &c->err), WF_OK);
    double turn = 0.5 * atan2(h->xy, 0.5 * (h->xx - h->yy));
    for (size_t i = 0; i < c->tree.n; i++) {
        c->tree.section->hollow[i] = h;
        c->tree.section->up[3 * i] = cos(turn), c->tree.section->up[3 * i + 1] = sin(turn);
        c->tree.strength[i] = 40e6;
    }
    c->point[0] =
        (struct wf_point_load){ .segment = 5, .force = { push * cos(angle), push * sin(angle), 0 } };
    c->loads.points = 1;
    c->options.shear_flexible = false;
    assert_int_equal(
        wf_solver_beam.solve(&c->tree, &c->loads, &c->options, &c->arena, &c->out, &c->diag, &c->err), WF_OK);
    assert_int_equal(wf_breakage_check(&c->tree, &c->out, NULL, &c->arena, b, &c->err), WF_OK);
}

/* The top moves by P L^3 / (3 E I) in the principal planes, and in both at once between them; the stress at
 * the base is M over the section modulus in that direction. */
static void an_eccentric_stem_bends(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_hollow h;
    struct wf_err e = { 0 };
    const double off = 0.9;
    assert_int_equal(wf_hollow_round(0.6, 0.3, off, 0, 0, &a, &h, &e), WF_OK);
    double least, most = 0.5 * (h.xx + h.yy) + hypot(0.5 * (h.xx - h.yy), h.xy), r4 = pow(radius, 4), where;
    least = wf_hollow_least(&h, &where) * PI / 4;
    const double turns[] = { 0, PI / 2, 0.4 };
    for (int k = 0; k < 3; k++) {
        struct beam_case c;
        struct wf_breakage b;
        pushed(&c, &h, off + turns[k], &b);
        const double *u = c.out.end + 15;
        double along = u[0] * cos(off) + u[1] * sin(off), across = u[1] * cos(off) - u[0] * sin(off);
        double bend = push * pow(length, 3) / (3 * 9e9 * r4);
        assert_close(along + bend, bend + bend * cos(turns[k]) / least, 2e-7);
        assert_close(across + bend, bend + bend * sin(turns[k]) / most, 2e-7);
        double solid = PI / 4 * pow(radius, 3);
        assert_close(b.stress0[0], push * length / (solid * wf_hollow_modulus(&h, off + turns[k])), 1e-6);
        assert_close(b.safety0[0], 40e6 / b.stress0[0], 1e-12);
        beam_free(&c);
    }
    wf_arena_free(&a);
}

/* A concentric cavity all along is the ring that the radius columns give. */
static void a_ring_either_way(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_hollow h;
    struct wf_err e = { 0 };
    struct beam_case c, ring;
    struct wf_breakage b, of_ring;
    assert_int_equal(wf_hollow_round(0.7, 0, 0, 0, 0, &a, &h, &e), WF_OK);
    pushed(&c, &h, 0.5, &b);
    pushed(&ring, &h, 0.5, &of_ring);
    ring.tree.section = NULL;
    for (size_t i = 0; i < 6; i++) ring.tree.i0[i] = ring.tree.i1[i] = 0.7 * radius;
    assert_int_equal(wf_solver_beam.solve(&ring.tree, &ring.loads, &ring.options, &ring.arena, &ring.out,
                                          &ring.diag, &ring.err),
                     WF_OK);
    assert_int_equal(wf_breakage_check(&ring.tree, &ring.out, NULL, &ring.arena, &of_ring, &ring.err), WF_OK);
    for (size_t k = 0; k < 12; k++) assert_close(c.out.end[k] + 1, ring.out.end[k] + 1, 1e-10);
    for (size_t i = 0; i < 6; i++) assert_close(b.stress0[i], of_ring.stress0[i], 1e-8);
    assert_close(wf_section_wall(&c.tree, 2, 0.5).thickness, 0.03, 1e-12);
    assert_close(wf_section_wall(&ring.tree, 2, 0.5).thickness, 0.03, 1e-12);
    /* what the cavity holds counts as mass, the ring has none there */
    assert_close(wf_tree_area(&c.tree, 0, 0), PI * radius * radius, 1e-14);
    beam_free(&c), beam_free(&ring);
    wf_arena_free(&a);
}

/* Frequency with a cavity all along: that of the solid stem times sqrt(I / I solid), the mass being the same.
 */
static void frequency_falls(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_hollow h;
    struct wf_err e = { 0 };
    struct beam_case c;
    struct wf_breakage b;
    double hz[2][2], shape[2 * 3 * 6], where;
    assert_int_equal(wf_hollow_round(0.6, 0.3, 0.9, 0, 0, &a, &h, &e), WF_OK);
    pushed(&c, &h, 0, &b);
    c.loads.points = 0;
    assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 2, &c.arena, hz[0], shape, &c.err), WF_OK);
    c.tree.section = NULL;
    assert_int_equal(wf_modes(&c.tree, &c.loads, &c.options, 2, &c.arena, hz[1], shape, &c.err), WF_OK);
    /* rotary inertia, which follows the mass, differs by nothing: 1e-4 is what it makes of the frequency
     * itself */
    assert_close(hz[0][0] / hz[1][0], sqrt(wf_hollow_least(&h, &where)), 1e-4);
    beam_free(&c);
    wf_arena_free(&a);
}

/* Ellipse and rectangle bent obliquely, by their principal axes. */
static void flat_stems_are_stressed(void **state)
{
    (void)state;
    const double w = 0.12, high = 0.2, angle = 0.6;
    for (int shape = 0; shape < 2; shape++) {
        static const double up[3] = { 0, 0, 1 };
        struct beam_case c;
        struct wf_breakage b;
        struct wf_section of;
        beam_stem(&c, 6, up, length, 0.1, 0.1);
        assert_int_equal(wf_tree_alloc_sections(&c.tree, &c.arena, &c.err), WF_OK);
        struct wf_tree_sections *s = c.tree.section;
        for (size_t i = 0; i < 6; i++) {
            s->width0[i] = s->width1[i] = w, s->height0[i] = s->height1[i] = high;
            s->mix0[3 * i + (size_t)shape] = s->mix1[3 * i + (size_t)shape] = 1;
            s->up[3 * i] = 1; /* the height lies along x */
        }
        c.point[0] =
            (struct wf_point_load){ .segment = 5, .force = { push * cos(angle), push * sin(angle), -500 } };
        c.loads.points = 1;
        assert_int_equal(
            wf_solver_beam.solve(&c.tree, &c.loads, &c.options, &c.arena, &c.out, &c.diag, &c.err), WF_OK);
        assert_int_equal(wf_breakage_check(&c.tree, &c.out, NULL, &c.arena, &b, &c.err), WF_OK);
        wf_section_of((enum wf_section_shape)shape, w, high, &of);
        double mx = fabs(c.out.moment0[0]), my = fabs(c.out.moment0[1]); /* about x: bends along the width */
        double high_side = my * high / 2 / of.upright, wide_side = mx * w / 2 / of.lying;
        double bent = shape ? high_side + wide_side : hypot(high_side, wide_side);
        assert_close(b.stress0[0], bent + 500 / of.area, 1e-6);
        if (!shape) assert_close(of.upright, PI / 64 * w * pow(high, 3), 1e-12);
        beam_free(&c);
    }
}

static const char plain[] = "model: m\nname: M\nstem: {height: 12 m, base_radius: 150 mm, segments: 10, "
                            "taper: {law: linear, tip_share: 0.4}}\n";

static void grow_with(struct grown *g, const char *more)
{
    char text[1200];
    (void)snprintf(text, sizeof text, "%s%s", plain, more);
    grown_make(g, text);
}

static double mass_of(const struct wf_tree *t)
{
    double m = 0;
    for (size_t i = 0; i < t->n; i++)
        m += t->density[i] * wf_tree_length(t, i) *
             (wf_tree_area(t, i, 0) + 4 * wf_tree_area(t, i, 0.5) + wf_tree_area(t, i, 1)) / 6;
    return m;
}

/* Rows end where cavities do; geometry and mass stay as they were. */
static void rows_are_cut(void **state)
{
    (void)state;
    struct grown sound, g;
    grow_with(&sound, "");
    grow_with(&g, "cavities:\n  - {from: 0.8 m, to: 2.4 m, at: 1.3 m, wall: 60 mm}\n"
                  "  - {from: 6.0 m, to: 7.2 m, at: 6.5 m, wall: 30 mm, centre: 1 cm towards 120 deg, "
                  "opening: 90 deg}\n");
    assert_int_equal(sound.tree.n, 10);
    assert_int_equal(g.tree.n, 11); /* at 0.8 m; the others are ends of rows */
    grown_is_connected(&g.tree);
    assert_close(mass_of(&g.tree), mass_of(&sound.tree), 1e-12);
    size_t in[2] = { 0 };
    for (size_t i = 0; i < g.tree.n; i++) {
        int32_t c = g.tree.section->cavity[i];
        double low = g.tree.z0[i], high = g.tree.z1[i];
        assert_true(c >= -1 && c <= 1);
        bool first = low >= 0.8 - 1e-9 && high <= 2.4 + 1e-9, second = low >= 6 - 1e-9 && high <= 7.2 + 1e-9;
        assert_int_equal(c, first ? 0 : second ? 1 : -1);
        assert_true((g.tree.section->hollow[i] != NULL) == (c >= 0));
        if (c >= 0) in[c]++;
    }
    assert_true(in[0] >= 2 && in[1] >= 1);
    /* at 1.3 m the wood has 150 (1 - 0.6 x 1.3 / 12) mm */
    double r = 150 * (1 - 0.6 * 1.3 / 12);
    for (size_t i = 0; i < g.tree.n; i++) {
        if (g.tree.section->cavity[i] != 0) continue;
        struct wf_wall w = wf_section_wall(&g.tree, i, 0);
        assert_close(w.thickness / w.radius, 60 / r, 1e-9);
        assert_false(w.open);
    }
    assert_true(wf_section_wall(&g.tree, g.tree.n - 1, 0).radius > 0);
    wf_arena_free(&sound.arena), wf_arena_free(&g.arena);
}

/* Measured bark: in proportion to the diameter; by law: the law's. Its mass stays, its section goes. */
static void bark_is_taken_off(void **state)
{
    (void)state;
    struct grown sound, g;
    grow_with(&sound, "");
    grow_with(&g, "bark: 15 mm\n");
    double r = 0.150 * (1 - 0.6 * 1.3 / 12);
    assert_close(mass_of(&g.tree), mass_of(&sound.tree), 1e-12);
    for (size_t i = 0; i < g.tree.n; i++) {
        assert_close(g.tree.r0[i], sound.tree.r0[i], 0);
        assert_close(wf_wood_end(&g.tree, i, 0), g.tree.r0[i] * (1 - 0.015 / r), 1e-12);
    }
    assert_string_equal(g.diag.first->code, "bark");
    struct wf_bark_law oak = { .terms = 3, .coefficient = (double[]){ 9.1, 0.66, 0 }, .share = is(1) };
    assert_close(wf_bark_by_law(&oak, 0.4), 0.5e-3 * (9.1 + 0.66 * 40), 1e-12);
    assert_close(pow(1 - 2 * wf_bark_by_law(&oak, 0.4) / 0.4, 3), 0.76,
                 5e-3); /* the share of Z that is left */
    assert_close(wf_bark_by_law(&oak, 0.05) / 0.05, wf_bark_by_law(&oak, 0.1) / 0.1, 1e-12);
    struct wf_bark_law ash = { .terms = 3, .coefficient = (double[]){ -1.1, 0.96, -0.0043 }, .share = is(1) };
    assert_close(wf_bark_by_law(&ash, 3), wf_bark_by_law(&ash, 2), 1e-12); /* held beyond its maximum */
    wf_arena_free(&sound.arena), wf_arena_free(&g.arena);
}

/* The least wall: closed forms of bending and splitting, and the limits at which Huang's modes meet. */
static void walls_needed(void **state)
{
    (void)state;
    const double r = 0.2, moment = 30e3, f = 40e6;
    struct wf_ring_wood w = { .strength = f, .youngs = 7e9, .required = 1 };
    double inner = pow(1 - 4 * moment / (PI * pow(r, 3) * f), 0.25);
    assert_close(wf_wall_needed(moment, 0, r, &w), 1 - inner, 1e-9);
    w.required = 1.5;
    inner = pow(1 - 4 * 1.5 * moment / (PI * pow(r, 3) * f), 0.25);
    assert_close(wf_wall_needed(moment, 0, r, &w), 1 - inner, 1e-9);
    w.tangential = 3e6, w.required = 1, w.strength = 61e6;
    double share = wf_wall_needed(moment, 0, r, &w), t = share * r, middle = r - t / 2;
    assert_true(t / middle < 0.2658); /* below it splitting governs */
    assert_close(moment / (PI * middle * middle * t), sqrt(2. / 3 * 7e9 * 3e6 * t / middle), 1e-8);
    assert_true(isinf(wf_wall_needed(1e7, 0, r, &w)));
    w.strength = 0;
    assert_true(isnan(wf_wall_needed(moment, 0, r, &w)));
}

#define RUN_STEM "$W analyze scots_pine --model $T/m.yaml --wind 20 --no-report -o $T/out "
static const char write_model[] =
    "printf 'model: m\\nname: M\\nstem: {height: 12 m, base_radius: 150 mm, taper: {law: linear, tip_share: "
    "0.4}}\\n"
    "frontal_area: 5 m2\\ncrown: {base: 8 m}\\ncrown_mass: 60 kg\\n' > $T/m.yaml; ";

static void run_on_stem(const char *options, int code, const char *expect)
{
    char command[2000];
    (void)snprintf(command, sizeof command, "%s%s%s", write_model, RUN_STEM, options);
    const struct row one = { command, code, { expect } };
    check(&one, 1);
}

static void mistakes(void **state)
{
    (void)state;
    run_on_stem("--cavity 1.3m:150mm", CODE_INPUT, "the wood of the stem has a radius of 140.2 mm there");
    run_on_stem("--cavity 20m:50mm", CODE_INPUT, "20 m is above the stem, which ends at 12 m");
    run_on_stem("--cavity 1.3m:0mm", CODE_INPUT, "the wall is outside 1 mm to 5 m");
    run_on_stem("--cavity 1.3m:50mm,2m:50mm", CODE_INPUT, "overlaps the one from 0 m to 2.6 m");
    run_on_stem("--cavity 1.3m:none.csv", CODE_INPUT, "there is no such file");
    run_on_stem("--bark 90mm", CODE_INPUT, "at most half the radius");
    run_on_stem("--bark 2m", CODE_INPUT, "outside 0.1 mm to 200 mm");
    run_on_stem("--bark spices", CODE_INPUT, "did you mean 'species'?");
    run_on_stem("--cavity $T/c.yaml", CODE_INPUT, "there is no such file");
    const struct {
        const char *item, *expect;
    } rows[] = {
        { "{at: 1.3 m, wall: 50 mm, opening: 360 deg}",
          "2:39: error: cavities[0].opening: 360 deg is outside" },
        { "{at: 1.3 m, opening: 90 deg}", "an opening is of a cavity" },
        { "{at: 1.3 m, wall: 50 mm, opening: 90 deg}", "needs 'facing'" },
        { "{at: 1.3 m, wall: 0 mm}", "cavities[0].wall: 0 mm is outside" },
        { "{from: 3 m, to: 2 m, at: 2.5 m, wall: 50 mm}", "cavities[0].to: is not above 'from'" },
        { "{from: 3 m, to: 4 m, at: 2.5 m, wall: 50 mm}", "cavities[0].at: is not between" },
        { "{at: 1.3 m, wall: 50 mm, centre: 3 cm}", "is not a distance and a direction" },
        { "{at: 1.3 m, wall: 50 mm, centre: 6 cm towards 0 deg}", "the cavity is larger than the stem" },
        { "{at: 1.3 m, wall: 50 mm, facing: 3 deg}", "is not used without 'opening'" },
        { "{at: 1.3 m}", "needs 'wall', for example" },
        { "{at: 1.3 m, wall: 50 mm, rays: a.csv}", "is not used beside 'rays'" },
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char command[2000];
        (void)snprintf(command, sizeof command,
                       "%sprintf 'cavities:\\n  - %s\\n' > $T/c.yaml; " RUN_STEM "--cavity $T/c.yaml",
                       write_model, rows[k].item);
        const struct row one = { command, CODE_INPUT, { rows[k].expect } };
        check(&one, 1);
    }
}

static void mistakes_of_rays(void **state)
{
    (void)state;
    const struct {
        const char *rays, *expect;
    } rows[] = {
        { "0,14,8\\n60,14,8\\n50,14,8\\n120,14,8\\n180,14,8\\n240,14,8\\n300,14,8\\n",
          ":4:1: error: angle_deg: 50 deg does not follow" },
        { "0,14,8\\n60,14,8\\n120,14,8\\n180,14,-1\\n240,14,8\\n300,14,8\\n",
          ":5:8: error: sound_cm: -1 is outside" },
        { "0,14,8\\n60,14,8\\n120,14,16\\n180,14,8\\n240,14,8\\n300,14,8\\n", "is beyond the outline" },
        { "0,14,8\\n60,14,8\\n120,14,8\\n180,14,8\\n240,14,8\\n290,14,8\\n", "the section is not closed" },
        { "0,14,8\\n60,14,8\\n120,14,8\\n200,14,8\\n240,14,8\\n290,14,8\\n", "leaves a gap of 80 deg" },
        { "0,14,8\\n60,14,8\\n120,14,8\\n", "3 rays; a section needs at least 6" },
        { "0,7,3\\n60,7,3\\n120,7,3\\n180,7,3\\n240,7,3\\n300,7,3\\n",
          "the stem has 140.2 mm at that height" },
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char command[2000];
        (void)snprintf(command, sizeof command,
                       "%sprintf 'angle_deg,outer_cm,sound_cm\\n%s' > $T/r.csv; " RUN_STEM
                       "--cavity 1.3m:$T/r.csv",
                       write_model, rows[k].rays);
        const struct row one = { command, CODE_INPUT, { rows[k].expect } };
        check(&one, 1);
    }
}

/* The whole way: a stem with a cavity is reported, breaks in less wind, and its results are read back. */
static void reported(void **state)
{
    (void)state;
    char command[2000];
    (void)snprintf(command, sizeof command,
                   "%s" RUN_STEM "--cavity 1.3m:30mm && grep -c cavities $T/out/results.json", write_model);
    const struct row rows[] = {
        { command,
          CODE_OK,
          { "cavity at 1.3 m: thinnest wall 30 mm of 140 mm wood radius (t/R 0.214)",
            "strength loss 38 % with the wind, at most 38 %", "without the cavity", "least wall" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_eccentric_stem_bends),
        cmocka_unit_test(a_ring_either_way),
        cmocka_unit_test(frequency_falls),
        cmocka_unit_test(flat_stems_are_stressed),
        cmocka_unit_test(rows_are_cut),
        cmocka_unit_test(bark_is_taken_off),
        cmocka_unit_test(walls_needed),
        cmocka_unit_test(mistakes),
        cmocka_unit_test(mistakes_of_rays),
        cmocka_unit_test(reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
