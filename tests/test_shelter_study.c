/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tree solved in its own shelter, and the command as a user meets it. */
#include "cases/build.h"
#include "close.h"
#include "solve/beam.h"
#include "study/sheltered.h"
#include "wind/shelter_laws.h"
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

struct tree {
    struct wf_arena arena;
    struct wf_tree t;
    struct wf_wind wind;
    struct wf_loads loads;
    struct wf_solve_options options;
    struct wf_response open, own;
    struct wf_shelter_request q;
    struct wf_diag d;
};

/* The generated tree of 1000 segments, with leaves on its thin branches, in 15 m/s. */
static void set_up(struct tree *k, const char *law)
{
    struct wf_err e = { 0 };
    *k = (struct tree){ 0 };
    k->d.arena = &k->arena;
    if (wf_case_tree_read("validation/computed_reference/bench_tree_1k.csv", &k->arena, &k->t, &e))
        fail_msg("%s", e.text);
    for (size_t i = 0; i < k->t.n; i++) {
        k->t.youngs[i] = 9e9, k->t.shear[i] = 3.5e9, k->t.density[i] = 800, k->t.drag[i] = 1;
        if (k->t.level[i] >= 5) k->t.sail0[i] = k->t.sail1[i] = 0.4;
    }
    k->wind = (struct wf_wind){ .sample = wf_profile_named("uniform")->sample,
                                .speed = 15,
                                .direction = { 1, 0, 0 },
                                .reference_height = 10 };
    wf_loads_default(&k->loads);
    k->loads.wind = &k->wind;
    wf_solve_options_default(&k->options);
    k->options.mesh_tolerance = 1e-4;
    wf_shelter_request_default(&k->q);
    k->q.law = wf_shelter_law_named(law);
    k->q.slabs = 24;
    k->q.cells = 64;
    assert_int_equal(wf_solver_beam.solve(&k->t, &k->loads, &k->options, &k->arena, &k->open, &k->d, &e),
                     WF_OK);
}

static enum wf_status shelter(struct tree *k, const struct wf_solver *solver, struct wf_sheltered *out)
{
    return wf_sheltered_solve(&k->t, &k->loads, &k->q, solver, &k->options, &k->arena, out, &k->own, &k->d,
                              NULL);
}

static void leeward_branches_meet_less_wind(void **state)
{
    (void)state;
    struct tree k;
    struct wf_sheltered s;
    set_up(&k, "wake");
    assert_int_equal(shelter(&k, &wf_solver_beam, &s), WF_OK);
    assert_true(s.passes < WF_SHELTER_PASSES && s.change <= 1e-3);
    assert_true(k.own.imbalance < 1e-6);
    double n[2] = { 0 }, wind[2] = { 0 };
    for (size_t i = 0; i < k.t.n; i++) {
        if (k.t.level[i] < 5 || fabs(k.t.x1[i]) < 2) continue;
        const double x[3] = { k.t.x1[i] + k.own.end[3 * i], k.t.y1[i] + k.own.end[3 * i + 1],
                              k.t.z1[i] + k.own.end[3 * i + 2] };
        double u[3], du[9];
        s.wind.sample(&s.wind, x, u, du);
        n[k.t.x1[i] > 0] += 1;
        wind[k.t.x1[i] > 0] += u[0];
    }
    double windward = wind[0] / n[0], leeward = wind[1] / n[1];
    assert_true(windward > 14 && leeward < 0.95 * windward);
    assert_true(k.own.base_moment[1] < 0.97 * k.open.base_moment[1]);
    assert_true(k.own.base_moment[1] > 0.6 * k.open.base_moment[1]);
    wf_sheltered_end(&s);
    wf_arena_free(&k.arena);
}

static void a_tree_that_lets_all_through_stands_in_the_open(void **state)
{
    (void)state;
    struct tree k;
    struct wf_sheltered s;
    set_up(&k, "wake");
    k.q.transmission = 1;
    assert_int_equal(shelter(&k, &wf_solver_beam, &s), WF_OK);
    assert_int_equal(s.passes, 1);
    for (size_t i = 0; i < 3 * k.t.n; i++) assert_true(fabs(k.own.end[i] - k.open.end[i]) < 1e-9);
    wf_sheltered_end(&s);
    wf_arena_free(&k.arena);
}

static void small_deflection_and_printed_laws_are_told(void **state)
{
    (void)state;
    struct tree k;
    struct wf_sheltered s;
    bool told = false;
    set_up(&k, "feng1999");
    assert_int_equal(shelter(&k, &wf_solver_linear, &s), WF_OK);
    assert_int_equal(s.passes, 1);
    for (const struct wf_finding *f = k.d.first; f; f = f->next)
        told = told || (f->code && strcmp(f->code, "shelter-as-printed") == 0);
    assert_true(told);
    wf_sheltered_end(&s);
    k.q.slabs = 0;
    assert_int_equal(shelter(&k, &wf_solver_linear, &s), WF_EUSAGE);
    wf_sheltered_end(&s);
    wf_arena_free(&k.arena);
}

#define TREE "--tree tests/data/qsm/plain.csv --species oak --leaf-area 5 "

static void the_command(void **state)
{
    (void)state;
    static const struct {
        const char *options, *expect;
        int code;
    } row[] = {
        { TREE "--slabs 4 --cells 16 --no-plots -o $T", "passes beside", 0 },
        { TREE "--slabs 4 --no-plots -o $T -q && cat $T/plots/run.csv", "LAW,0,\"wake\"", 0 },
        { TREE "--no-plots -o $T --law feng1999 --slabs 4 --transmission 50% --as speed",
          "0.500 of the speed", 0 },
        { TREE "--slabs 4 --no-motion --no-plots -o $T --wind beaufort:8", "4 slabs", 0 },
        { TREE "--slabs 0", "outside 1..512", 2 },
        { TREE "--cells 1e6", "outside 8..1024", 2 },
        { TREE "--cells 0", "outside 8..1024", 2 },
        { TREE "--slabs 512 --cells 1024", "more than", 2 },
        { TREE "--transmission 2", "outside 0..1", 2 },
        { TREE "--law fengg1999", "did you mean 'feng1999'", 2 },
        { TREE "--as power", "energy", 2 },
        { TREE "--model culm", "--model or --tree", 2 },
        { "--species oak", "--model or --tree", 2 },
        { "--model culm", "--species is needed", 2 },
        { "--model culm --species nothing", "nothing", 2 },
        { "--tree tests/data/none.csv --species oak", "none.csv", 2 },
    };
    const char *program = getenv("WINDFIRM");
    if (!program) program = "build/windfirm";
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        char all[1024], output[8192];
        snprintf(all, sizeof all,
                 "{ T=$(mktemp -d); trap 'rm -rf \"$T\"' EXIT\n%s shelter %s\n} 2>&1 </dev/null", program,
                 row[i].options);
        FILE *pipe = popen(all, "r");
        assert_non_null(pipe);
        size_t got = fread(output, 1, sizeof output - 1, pipe);
        output[got] = '\0';
        int status = pclose(pipe);
        if (WEXITSTATUS(status) != row[i].code || !strstr(output, row[i].expect))
            fail_msg("%s: exit %d, want %d and '%s':\n%s", row[i].options, WEXITSTATUS(status), row[i].code,
                     row[i].expect, output);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(leeward_branches_meet_less_wind),
        cmocka_unit_test(a_tree_that_lets_all_through_stands_in_the_open),
        cmocka_unit_test(small_deflection_and_printed_laws_are_told),
        cmocka_unit_test(the_command),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
