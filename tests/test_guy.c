/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cables from a tree to the ground: two bars, the work done on them, cables that are slack, the words of
 * --guy, guys of a tree card. */
#include "beam_cases.h"
#include "grow/card.h"
#include "made.h"
#include "study/guy.h"
#include "study/verdict.h"

static struct wf_tie cable = { .segment = 0, .anchor = { -6, 0, 0 }, .stiffness = 2e5 };

static const double hinge = 2e5; /* [N m/rad]: the cable carries 96 % */

/* A mast of 8 m too stiff to bend on a soft hinge, pushed at its top, held by a cable. */
static void mast(struct beam_case *c)
{
    beam_stem(c, 1, upright, 8, 0.1, 0.1);
    c->tree.youngs[0] = c->tree.shear[0] = 1e16;
    c->options.root_stiffness[0] = c->options.root_stiffness[1] = hinge;
    cable.length = 10;
    c->loads.tie = &cable, c->loads.ties = 1;
    (void)beam_push(c, 0, WF_POINT_DEAD, 0, 0, 0);
}

/* Moment about the hinge of the mast turned by `turn` under a push, by geometry. */
static double out_of_balance(double push, double turn, double *pull)
{
    double x = 8 * sin(turn), z = 8 * cos(turn), length = hypot(x + 6, z);
    *pull = cable.stiffness * (length - cable.length);
    return push * z - *pull * 6 * z / length -
           hinge * turn; /* the cable's lever: 6 m by the sine at its anchor */
}

static void two_bars(void **state)
{
    (void)state;
    struct beam_case c;
    mast(&c);
    for (int k = 1; k <= 5; k++) {
        double push = 3e4 * k, low = 0, high = 1, pull = 0;
        for (int i = 0; i < 100; i++) {
            double middle = 0.5 * (low + high);
            if (out_of_balance(push, middle, &pull) > 0)
                low = middle;
            else
                high = middle;
        }
        c.point[0].force[0] = push;
        beam_solve(&c);
        double at[3] = { c.out.end[0], c.out.end[1], 8 + c.out.end[2] }, force[3];
        assert_close(wf_tie_pull(&cable, at, force, NULL), pull, 1e-7);
        assert_close(c.out.end[0], 8 * sin(low), 1e-7);
        assert_close(c.out.base_moment[1], hinge * low, 1e-6);
        assert_close(c.out.base_force[0], push + force[0], 1e-9);
    }
    beam_free(&c);
}

/* The work of the push is the energy of cable and hinge, 1/2 k stretch^2 + 1/2 c turn^2. */
static void energy(void **state)
{
    (void)state;
    enum { STEPS = 200 };
    struct beam_case c;
    double work = 0, before[2] = { 0, 0 }, pull = 0, force[3];
    mast(&c);
    for (int k = 1; k <= STEPS; k++) {
        double push = 1e5 * k / STEPS;
        c.point[0].force[0] = push;
        beam_solve(&c);
        double at[3] = { c.out.end[0], c.out.end[1], 8 + c.out.end[2] };
        pull = wf_tie_pull(&cable, at, force, NULL);
        work += 0.5 * (push + before[0]) * (c.out.end[0] - before[1]);
        before[0] = push, before[1] = c.out.end[0];
    }
    double turn = asin(c.out.end[0] / 8);
    assert_close(work, 0.5 * pull * pull / cable.stiffness + 0.5 * hinge * turn * turn, 2e-5);
    beam_free(&c);
}

/* A cantilever, small motions: tip stiffness 3 E I / L^3 across, E A / L along; the cable pulls at an angle.
 */
static void cantilever(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_tie tie = { .segment = 3, .anchor = { -6, 0, 0 }, .stiffness = 5e3, .length = 10 };
    beam_stem(&c, 4, upright, 8, 0.05, 0.05);
    (void)beam_push(&c, 3, WF_POINT_DEAD, 1, 0, 0);
    c.loads.tie = &tie, c.loads.ties = 1;
    const double across = 3 * 9e9 * PI * pow(0.05, 4) / 4 / pow(8, 3), along = 9e9 * PI * 0.05 * 0.05 / 8;
    double give = 0.6 * 0.6 / across + 0.8 * 0.8 / along; /* of the tip along the cable, by a unit pull */
    double pull = 0.6 / across / (1 / tie.stiffness + give), force[3];
    beam_solve(&c);
    double at[3] = { c.out.end[9], c.out.end[10], 8 + c.out.end[11] };
    assert_close(wf_tie_pull(&tie, at, force, NULL), pull, 2e-4);
    assert_close(c.out.base_moment[1], 8 * (1 - 0.6 * pull), 3e-4);
    beam_free(&c);
}

/* Pushed towards its anchor a cable does nothing, to the last byte; at rest it is slack. */
static void slack(void **state)
{
    (void)state;
    struct beam_case c;
    double end[12], by[9], force[3];
    struct wf_tie tie = { .segment = 3, .anchor = { -6, 0, 0 }, .stiffness = 5e4, .length = 10 };
    assert_close(wf_tie_pull(&tie, (double[]){ 0, 0, 8 }, force, by), 0, 0);
    for (int k = 0; k < 9; k++) assert_close(by[k], 0, 0);
    beam_stem(&c, 4, upright, 8, 0.05, 0.05);
    (void)beam_push(&c, 3, WF_POINT_DEAD, -20, 0, 0);
    beam_solve(&c);
    memcpy(end, c.out.end, sizeof end);
    c.loads.tie = &tie, c.loads.ties = 1;
    beam_solve(&c);
    assert_memory_equal(end, c.out.end, sizeof end);
    beam_free(&c);
}

/* The derivative of the force, by differences. */
static void derivative(void **state)
{
    (void)state;
    struct wf_tie tie = { .anchor = { -6, 1, 0 }, .stiffness = 3e4, .length = 9 };
    double at[3] = { 0.4, 0.2, 8.3 }, by[9], low[3], high[3], force[3];
    assert_true(wf_tie_pull(&tie, at, force, by) > 0);
    for (int c = 0; c < 3; c++) {
        const double step = 1e-5;
        double here = at[c];
        at[c] = here + step, (void)wf_tie_pull(&tie, at, high, NULL);
        at[c] = here - step, (void)wf_tie_pull(&tie, at, low, NULL);
        at[c] = here;
        for (int r = 0; r < 3; r++)
            if (fabs((high[r] - low[r]) / (2 * step) - by[3 * r + c]) > 1e-3) fail_msg("%d %d", r, c);
    }
}

static void words(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { WF_OK, "" };
    const struct wf_guy *g;
    size_t n;
    if (wf_guys_read("9m:8m:90deg:400kN/m; 30 ft : 500cm : 180 deg : 1kN/mm : 2kN", 0, &a, &g, &n, &e))
        fail_msg("%s", e.text);
    assert_int_equal(n, 2);
    assert_close(g[0].height, 9, 0);
    assert_close(g[0].stiffness, 4e5, 1e-12);
    assert_close(cos(g[0].azimuth), 1, 1e-12); /* east is +x */
    assert_close(g[1].height, 9.144, 1e-12);
    assert_close(g[1].pretension, 2000, 1e-12);
    assert_close(sin(g[1].azimuth), -1, 1e-12);
    static const char *const wrong[][2] = {
        { "9m:8m:90deg", "a guy is HEIGHT:DISTANCE:TOWARDS:STIFFNESS" },
        { "9m:8m:90deg:400kN/m:1kN:2", "a guy is HEIGHT" },
        { "9:8m:90deg:400kN/m", "height: '9' has no unit" },
        { "9m:0m:90deg:400kN/m", "distance of the anchor: '0m' is outside 0.5 to 300 m" },
        { "9m:8m:90deg:400kN", "stiffness" },
        { "9m:8m:90deg:-4kN/m", "stiffness: '-4kN/m' is outside" },
        { "9m:8m:90deg:nan N/m", "stiffness" },
        { "9m:8m:90deg:1N/m,", "height" },
        { "2m:2m:1deg:1N/m;2m:2m:1deg:1N/m;2m:2m:1deg:1N/m;2m:2m:1deg:1N/m;2m:2m:1deg:1N/m;2m:2m:1deg:1N/m;"
          "2m:2m:1deg:1N/m;2m:2m:1deg:1N/m;2m:2m:1deg:1N/m",
          "more than 8 guys" },
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        e = (struct wf_err){ WF_OK, "" };
        assert_int_equal(wf_guys_read(wrong[k][0], 0, &a, &g, &n, &e), WF_EUSAGE);
        if (!strstr(e.text, wrong[k][1])) fail_msg("%s: %s", wrong[k][0], e.text);
    }
    wf_arena_free(&a);
}

static double critical(struct made *c)
{
    const struct wf_analysis *an = &c->an;
    return wf_verdict_of(an->breaks).loss->critical.speed;
}

/* An oak in a mean wind of 30 m/s towards +x; with cavities its rows have sections. */
static void run_card(struct made *c, const struct wf_guy *guy, size_t n, bool hollow)
{
    static const struct wf_card card = {
        .height = 20, .girth = NAN, .dbh = 0.6, .crown_width = 8, .crown_base = 6
    };
    static struct wf_cavity hole = {
        .from = 0, .to = 2.6, .at = 1.3, .wall = 0.12, .facing = NAN, .file = "here"
    };
    const double speed = 30;
    memset(c, 0, sizeof *c);
    c->diag.arena = &c->arena;
    enum wf_status s =
        wf_species_read("species/oak.yaml", &wf_laws, &c->arena, &c->species, &c->diag, &c->err);
    if (!s) s = wf_card_model(&card, &c->species, &c->arena, &c->model, &c->err);
    if (hollow) c->model.cavity = &hole, c->model.cavities = 1;
    wf_scenario_default(&c->scenario);
    c->scenario.peak.method = "mean", c->scenario.profile = "uniform";
    c->scenario.guy = guy, c->scenario.guys = n;
    wf_search_default(&c->search);
    c->search.bare = true, c->search.speed_max = 150;
    wf_solve_options_default(&c->options);
    if (s) fail_msg("%s", c->err.text);
    made_analyse(c, &speed, 1);
}

/* A guy that is nearly nothing changes nothing, though its row is cut; one that holds takes moment off the
 * foot, more the stiffer it is, and the critical wind rises; towards its anchor it is slack. */
static void card(void **state)
{
    (void)state;
    for (int hollow = 0; hollow < 2; hollow++) {
        struct made bare, cut, held;
        const struct wf_guy none = { .height = 7.3, .distance = 8, .azimuth = PI, .stiffness = 1 };
        struct wf_guy guy = none;
        run_card(&bare, NULL, 0, hollow);
        run_card(&cut, &none, 1, hollow);
        assert_int_equal(cut.an.tree.n, bare.an.tree.n + 1);
        assert_close(cut.an.at[0].base_moment, bare.an.at[0].base_moment, 2e-5);
        assert_close(critical(&cut), critical(&bare), 1e-4);
        double moment = bare.an.at[0].base_moment, pull = 0;
        for (int k = 0; k < 3; k++) {
            guy.stiffness = 3e4 * pow(3, k);
            run_card(&held, &guy, 1, hollow);
            assert_true(held.an.at[0].base_moment < moment && held.an.at[0].tie[0] > pull);
            moment = held.an.at[0].base_moment, pull = held.an.at[0].tie[0];
            size_t row = (size_t)held.an.loads.tie[0].segment;
            assert_close(held.an.tree.z1[row], 7.3, 1e-12);
            wf_arena_free(&held.arena);
        }
        run_card(&held, &guy, 1, hollow);
        assert_true(critical(&held) > critical(&bare));
        wf_arena_free(&held.arena);
        guy.azimuth = 0;
        run_card(&held, &guy, 1, hollow);
        assert_close(held.an.at[0].tie[0], 0, 0);
        assert_close(held.an.at[0].base_moment, bare.an.at[0].base_moment, 2e-5);
        wf_arena_free(&held.arena), wf_arena_free(&cut.arena), wf_arena_free(&bare.arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_bars), cmocka_unit_test(energy),     cmocka_unit_test(cantilever),
        cmocka_unit_test(slack),    cmocka_unit_test(derivative), cmocka_unit_test(words),
        cmocka_unit_test(card),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
