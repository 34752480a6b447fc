/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rain on the leaves of a tree in wind: added mass, lower frequency, dry beside wet. */
#include "close.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/grow.h"
#include "load/interception.h"
#include "load/load.h"
#include "shell.h"
#include "solve/modes.h"
#include <math.h>

struct stand {
    struct wf_arena a;
    struct wf_species sp;
    struct wf_model *m;
    struct wf_tree t;
    struct wf_loads loads;
};

static void grow(struct stand *s, const char *model)
{
    struct wf_err e = { 0 };
    *s = (struct stand){ 0 };
    struct wf_diag d = { .arena = &s->a };
    if (wf_species_read("species/oak.yaml", &wf_laws, &s->a, &s->sp, &d, &e) ||
        wf_model_open(model, &s->a, &s->m, &d, &e) || wf_grow(s->m, &s->sp, &s->a, &s->t, &d, &e))
        fail_msg("%s", e.text);
    wf_loads_default(&s->loads);
}

/* Mass of wood and burden [kg]. */
static double burden(const struct wf_tree *t)
{
    double sum = 0;
    for (size_t i = 0; i < t->n; i++) sum += 0.5 * (t->burden0[i] + t->burden1[i]) * wf_tree_length(t, i);
    return sum;
}

/* The water is film times leaf area, where the leaves are; a tree without leaves holds none. */
static void mass(void **state)
{
    (void)state;
    static const char *const models[] = { "models/culm.yaml", "models/broadleaf.yaml" };
    for (size_t k = 0; k < 2; k++) {
        struct stand s;
        grow(&s, models[k]);
        double before = burden(&s.t), area = wf_tree_leaf_area(&s.t), water = wf_intercept(&s.t, 0.3);
        assert_true(area > 1);
        assert_close(water, 0.3 * area, 1e-12);
        assert_close(burden(&s.t) - before, water, 1e-10);
        for (size_t i = 0; i < s.t.n; i++) s.t.leaf0[i] = s.t.leaf1[i] = 0;
        before = burden(&s.t);
        assert_true(wf_intercept(&s.t, 1.0) == 0 && burden(&s.t) == before);
        wf_arena_free(&s.a);
    }
}

/* f^2 falls as the mass that moves grows: with all mass in the burden, twice the burden gives f/sqrt(2). */
static void frequency(void **state)
{
    (void)state;
    struct stand s;
    struct wf_err e = { 0 };
    struct wf_solve_options o;
    double f[2];
    grow(&s, "models/culm.yaml");
    wf_solve_options_default(&o);
    s.loads.gravity = 0;
    for (size_t i = 0; i < s.t.n; i++) {
        s.t.density[i] = 1e-9;
        s.t.leaf0[i] = s.t.leaf1[i] = 1, s.t.burden0[i] = s.t.burden1[i] = 0.3;
    }
    for (int k = 0; k < 2; k++) {
        if (wf_modes(&s.t, &s.loads, &o, 1, &s.a, &f[k], NULL, &e)) fail_msg("%s", e.text);
        wf_intercept(&s.t, 0.3);
    }
    assert_close(f[1], f[0] / sqrt(2), 1e-5);
    wf_arena_free(&s.a);
}

static void commands(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak -m culm --wind 10 --water-film 0.3mm --no-report -o $T/wet && "
          "grep -c frequencies_Hz $T/wet/results.json",
          CODE_OK,
          { "rain on the leaves: 5.1 kg, 0.3 mm on 17 m2", "dry -> wet: sways at 0.2562 Hz -> 0.1868 Hz" } },
        { "$W analyze oak -m culm --wind 10 --rain 20mm/h --no-report -o $T/wet",
          CODE_OK,
          { "5.1 kg, 0.3 mm", "water-storage" } },
        { "$W analyze oak -m culm --wind 10 --rain 20mm/h --storage dipped --no-report -o $T/wet",
          CODE_OK,
          { "3.23 kg, 0.19 mm" } },
        { "$W analyze oak -m culm --wind 10 --storage dipped", CODE_INPUT, { "without --rain" } },
        { "$W analyze oak -m culm --wind 10 --no-report -o $T/dry | grep -c rain; $W analyze oak -m culm "
          "--wind 10 "
          "--water-film 0mm --no-report -o $T/none -q; cmp $T/dry/tables/summary.csv "
          "$T/none/tables/summary.csv && echo "
          "same",
          CODE_OK,
          { "0", "same" } },
        /* snow and ice beside the tree without: mass 917 pi b (d + b) of the axes and 2 b of the leaves */
        { "$W analyze oak -m culm --wind 10 --ice 0.02mm --no-report -o $T/ice && grep -A1 winter "
          "$T/ice/results.json",
          CODE_OK,
          { "snow and ice: 0.6", "without -> with: sways at 0.2", "at 10 m/s drag ", "\"mass_kg\": 0.6" } },
        /* half the wind named while the ice is there: the moments are those of half the wind */
        { "for w in '20 --winter-wind 0.5' 10; do $W analyze oak -m culm --wind $w --ice 0.02mm --samples 0 "
          "--no-report -q -o $T/half; tail -1 $T/half/tables/summary.csv | cut -d, -f12; done | uniq | wc -l",
          CODE_OK,
          { "1\n" } },
        { "$W analyze oak -m culm --wind 10 --winter-wind 0.5", CODE_INPUT, { "without --snow and --ice" } },
        { "$W analyze oak -m culm --wind 10 --season leaf_off --water-film 0.3mm --no-report -o $T/bare",
          CODE_INPUT,
          { "no leaves that could hold rain" } },
        { "$W analyze oak -m culm --wind 10 --rain 20mm/h --water-film 0.3mm",
          CODE_INPUT,
          { "has no effect" } },
        { "$W analyze oak -m culm --wind 10 --water-film=-1mm", CODE_INPUT, { "--water-film" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(mass), cmocka_unit_test(frequency),
                                        cmocka_unit_test(commands) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
