/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cables and rods of --cable and --rod: their words, their places on a tree, what they do to it. */
#include "base/num.h"
#include "grow/card.h"
#include "made.h"
#include "study/brace.h"
#include "study/guy.h"
#include "study/removal.h"
#include <string.h>

static void words(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { WF_OK, "" };
    struct wf_brace b[WF_LINKS_MAX];
    size_t n = 0;
    if (wf_braces_read("id:14:id:27@40%:200kN/m; 9 m : id:3 : 1kN/mm : 2kN:breaks 40 kN", false, &a, b, &n,
                       &e))
        fail_msg("%s", e.text);
    if (wf_braces_read("30ft:id:5:1MN/m:-3kN", true, &a, b, &n, &e)) fail_msg("%s", e.text);
    if (wf_braces_read("3m:id:5:100kN/m:breaks 9kN:slack 5cm", false, &a, b, &n, &e)) fail_msg("%s", e.text);
    assert_int_equal(n, 4);
    assert_true(isnan(b[0].end[0].height) && b[0].end[0].id == 14 && b[0].end[1].id == 27);
    assert_close(b[0].end[0].share, 1, 0);
    assert_close(b[0].end[1].share, 0.4, 1e-12);
    assert_string_equal(b[0].end[1].name, "id:27@40%");
    assert_close(b[0].stiffness, 2e5, 1e-12);
    assert_true(isnan(b[0].breaking) && !b[0].rod);
    assert_close(b[1].end[0].height, 9, 1e-12);
    assert_close(b[1].pretension, 2000, 1e-12);
    assert_close(b[1].breaking, 4e4, 1e-12);
    assert_true(b[2].rod);
    assert_close(b[2].end[0].height, 9.144, 1e-12);
    assert_close(b[2].pretension, -3000, 1e-12);
    assert_close(b[3].slack, 0.05, 1e-12);
    wf_arena_free(&a);
}

static void wrong_words(void **state)
{
    (void)state;
    static const struct {
        const char *text, *said;
        bool rod;
    } rows[] = {
        { "id:14:id:27", "it is FROM:TO:STIFFNESS", false },
        { "id:14:id:27:1:2:3:4:5:6:7:8:9", "it is FROM:TO:STIFFNESS", false },
        { "id:x:3m:1kN/m", "id: and the number of a segment", false },
        { "id:5@0%:3m:1kN/m", "id:14@40%", false },
        { "id:5@40:3m:1kN/m", "id:14@40%", false },
        { "id:99999999999999999999:3m:1kN/m", "id: and the number of a segment", false },
        { "3kg:id:4:1kN/m", "height: ", false },
        { "0.1m:id:4:1kN/m", "outside 0.5 to 120 m", false },
        { "3m:id:4:1kN", "stiffness: ", false },
        { "3m:id:4:-1kN/m", "outside 1 N/m to 1 GN/m", false },
        { "3m:id:4:1kN/m:-1kN", "outside 0 to 1000 kN", false },
        { "3m:id:4:1kN/m:slack 5cm:1kN", "either a pretension or slack", false },
        { "3m:id:4:1kN/m:slack 5cm", "a rod pulls and pushes", true },
        { "3m:id:4:1kN/m:breaks 5m", "breaking load: ", false },
        { "3m:id:4:1kN/m,3m:id:5:1N/m,3m:id:6:1N/m,3m:id:7:1N/m,3m:id:8:1N/m,3m:id:9:1N/m,3m:id:1:1N/"
          "m,3m:id:2:1N/m,3m:id:3:1N/m",
          "more than 8 cables and rods", false },
    };
    for (size_t i = 0; i < WF_COUNT(rows); i++) {
        struct wf_arena a = { 0 };
        struct wf_err e = { WF_OK, "" };
        struct wf_brace b[WF_LINKS_MAX];
        size_t n = 0;
        assert_int_equal(wf_braces_read(rows[i].text, rows[i].rod, &a, b, &n, &e), WF_EUSAGE);
        if (!strstr(e.text, rows[i].said) || !strstr(e.text, rows[i].rod ? "--rod: " : "--cable: "))
            fail_msg("%s: %s", rows[i].text, e.text);
        wf_arena_free(&a);
    }
}

static void begin(struct made *c, const char *model)
{
    made_read(c, "species/oak.yaml", model);
    c->scenario.peak.method = "mean", c->scenario.profile = "uniform";
    c->search.bare = true;
}

static enum wf_status analyze(struct made *c, double speed, size_t threads)
{
    c->options.threads = threads;
    return made_try(c, &speed, 1);
}

static struct wf_brace brace_of(const char *text, bool rod)
{
    static struct wf_arena a;
    struct wf_err e = { WF_OK, "" };
    struct wf_brace b[WF_LINKS_MAX];
    size_t n = 0;
    if (wf_braces_read(text, rod, &a, b, &n, &e)) fail_msg("%s", e.text);
    return b[0];
}

/* Rows are cut where a cable and a guy hold them, and both hold the rows that end there. */
static void places(void **state)
{
    (void)state;
    struct made c, bare;
    begin(&bare, "models/broadleaf.yaml");
    assert_int_equal(analyze(&bare, 5, 1), WF_OK);
    begin(&c, "models/broadleaf.yaml");
    const struct wf_guy guy = { .height = 6.3, .distance = 8, .azimuth = 3, .stiffness = 1 };
    const struct wf_brace brace[2] = { brace_of("id:99@40%:4.1m:1N/m", false),
                                       brace_of("id:99@70%:id:58:1N/m", false) };
    c.scenario.guy = &guy, c.scenario.guys = 1;
    c.scenario.brace = brace, c.scenario.braces = 2;
    if (analyze(&c, 5, 1)) fail_msg("%s", c.err.text);
    const struct wf_tree *t = &c.an.tree, *was = &bare.an.tree;
    const struct wf_link *link = c.an.loads.link;
    size_t row = 0, other = 0;
    while (was->id[row] != 99) row++;
    while (was->id[other] != 58) other++;
    assert_int_equal(t->n, was->n + 4);
    for (int k = 0; k < 2; k++) {
        double share = k ? 0.7 : 0.4;
        size_t at = (size_t)link[k].segment[0];
        assert_int_equal(t->id[at], 99);
        assert_close(t->x1[at], wf_between(was->x0[row], was->x1[row], share), 1e-9);
        assert_close(t->z1[at], wf_between(was->z0[row], was->z1[row], share), 1e-9);
    }
    assert_close(t->z1[link[0].segment[1]], 4.1, 1e-9);
    assert_int_equal(t->level[link[0].segment[1]], 0);
    assert_close(t->z1[link[1].segment[1]], was->z1[other], 1e-12);
    assert_close(t->z1[c.an.loads.tie[0].segment], 6.3, 1e-9);
    assert_close(c.an.at[0].base_moment, bare.an.at[0].base_moment, 2e-5); /* nearly nothing changes */
    wf_arena_free(&c.arena), wf_arena_free(&bare.arena);
}

/* A cable between two branches: the stiffer, the larger its force and the less they part; with slack enough
 * it does nothing. The bytes do not depend on the threads. */
static void holds(void **state)
{
    (void)state;
    static const char *const text[] = { "id:99:id:58:1N/m", "id:99:id:58:5kN/m", "id:99:id:58:50kN/m",
                                        "id:99:id:58:500kN/m", "id:99:id:58:500kN/m:slack 1m" };
    double force = 0, moment = 0;
    for (size_t k = 0; k < WF_COUNT(text); k++) {
        struct made c[2];
        const struct wf_brace brace = brace_of(text[k], false);
        int runs = k == 2 ? 2 : 1;
        for (int i = 0; i < runs; i++) {
            begin(&c[i], "models/broadleaf.yaml");
            c[i].scenario.azimuth = 2; /* parts them */
            c[i].scenario.brace = &brace, c[i].scenario.braces = 1;
            if (analyze(&c[i], 25, i ? 3 : 1)) fail_msg("%s", c[i].err.text);
        }
        if (runs == 2) {
            assert_memory_equal(c[0].an.at[0].link, c[1].an.at[0].link, sizeof c[0].an.at[0].link);
            assert_memory_equal(&c[0].an.breaks[0][0].critical, &c[1].an.breaks[0][0].critical,
                                sizeof(struct wf_critical));
            wf_arena_free(&c[1].arena);
        }
        double now = c[0].an.at[0].link[0];
        if (k == 0) moment = c[0].an.at[0].base_moment;
        if (k < 4)
            assert_true(now > force);
        else
            assert_close(now, 0, 0);
        assert_close(c[0].an.at[0].base_moment, moment, 0.02); /* of the stem it takes nothing */
        assert_true(wf_brace_worst(&c[0].an, 0) == &c[0].an.at[0]);
        force = now;
        wf_arena_free(&c[0].arena);
    }
}

/* What cannot be braced says why. */
static void refusals(void **state)
{
    (void)state;
    static const struct {
        const char *model, *text, *removed, *said;
    } rows[] = {
        { "models/oak_20m.yaml", "3m:5m:1kN/m", NULL,
          "this one has a stem alone (a card draws no branches)" },
        { "models/broadleaf.yaml", "3m:id:9999:1kN/m", NULL, "the tree has no segment 9999; the column" },
        { "models/broadleaf.yaml", "30m:id:58:1kN/m", NULL, "the stem does not reach 30 m" },
        { "models/broadleaf.yaml", "id:58:id:58:1kN/m", NULL,
          "both ends, id:58 and id:58, are in the same place" },
        { "models/broadleaf.yaml", "id:58:id:99:1kN/m:90kN", NULL, "by more than half" },
        { "models/broadleaf.yaml", "3m:id:58:1kN/m", "id:58", "no segment 58, once branches are removed" },
        { "models/broadleaf.yaml", "3m:id:58:1kN/m", "level:1", "no branch is left without 'level:1'" },
    };
    for (size_t i = 0; i < WF_COUNT(rows); i++) {
        struct made c;
        begin(&c, rows[i].model);
        const struct wf_brace brace = brace_of(rows[i].text, false);
        size_t n;
        c.scenario.brace = &brace, c.scenario.braces = 1;
        if (rows[i].removed && wf_removals_read(rows[i].removed, &c.arena, &c.scenario.removed, &n, &c.err))
            fail_msg("%s", c.err.text);
        assert_int_equal(analyze(&c, 10, 1), WF_EINPUT);
        if (!strstr(c.err.text, rows[i].said)) fail_msg("%s: %s", rows[i].text, c.err.text);
        wf_arena_free(&c.arena);
    }
    struct made c;
    const struct wf_brace brace = brace_of("3m:id:58:1kN/m", true);
    const double speed = 10;
    begin(&c, "models/broadleaf.yaml");
    c.scenario.brace = &brace, c.scenario.braces = 1;
    for (size_t k = 0; wf_solvers[k]; k++) {
        if (wf_solvers[k]->ties) continue;
        c.err = (struct wf_err){ WF_OK, "" };
        assert_int_equal(wf_analyze(&c.species, &c.model, &c.scenario, &c.search, wf_solvers[k], &c.options,
                                    &speed, 1, &c.arena, &c.diag, &c.an, &c.err),
                         WF_EUSAGE);
        assert_non_null(strstr(c.err.text, "cables and rods have no effect with the solver"));
    }
    wf_arena_free(&c.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words), cmocka_unit_test(wrong_words), cmocka_unit_test(places),
        cmocka_unit_test(holds), cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
