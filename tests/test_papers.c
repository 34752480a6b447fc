/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the papers say of their trees must hold in their runs, as far as it is physics; and what is wrong with
 * the printed methods must show. */
#include "close.h"
#include "data/species.h"
#include "out/series.h"
#include "scratch.h"
#include "series_cases.h"
#include "wind/noise.h"
#include <string.h>

/* Feng et al. 1999: windward branches move much, leeward ones little. With the shelter of the crown all move
 * less than in the free wind, and the leeward ones lose more. */
static void shelter_calms_the_leeward_side(void **state)
{
    (void)state;
    struct wf_series_level level[2];
    for (int k = 0; k < 2; k++) {
        struct made m;
        start(&m, "species/weeping_willow.yaml", "models/papers/willow_few_twigs.yaml");
        m.run.solver = "rod", m.run.wind = 6, m.run.shelter = k ? "feng1999" : "none";
        m.run.gust = "cosine", m.run.intensity = 0.25, m.run.period = 10, m.run.duration = 10,
        m.run.step = 2.5;
        if (try(&m)) fail_msg("%s", m.err.text);
        assert_true(m.series.frames == 4 && m.series.failed == 0);
        level[k] = m.series.level[2];
        wf_arena_free(&m.arena);
    }
    assert_true(level[1].leeward < 0.95 * level[0].leeward);
    assert_true(level[1].windward < level[0].windward);
    assert_true(level[1].leeward / level[1].windward < level[0].leeward / level[0].windward);
}

/* The same on a tree whose shoots do not stream: on every level the windward side moves more, of the whole
 * and of its own part, and shelter takes more of the leeward side. */
static void stiff_shoots_show_the_sides(void **state)
{
    (void)state;
    struct wf_series_level level[2][4];
    for (int k = 0; k < 2; k++) {
        struct made m;
        start(&m, "species/oak.yaml", "models/papers/broadleaf_few_shoots.yaml");
        m.run.wind = 12, m.run.shelter = k ? "wake" : "none";
        m.run.gust = "cosine", m.run.intensity = 0.25, m.run.period = 10, m.run.duration = 10;
        m.run.step = 2.5;
        if (try(&m)) fail_msg("%s", m.err.text);
        assert_true(m.series.levels == 4 && m.series.failed == 0 && m.series.broken == m.series.frames);
        memcpy(level[k], m.series.level, sizeof level[k]);
        wf_arena_free(&m.arena);
    }
    for (int l = 1; l < 4; l++) {
        const struct wf_series_level *open = &level[0][l], *in = &level[1][l];
        assert_true(in->windward > 1.35 * in->leeward && in->own_windward > 1.35 * in->own_leeward);
        assert_true(in->windward < 0.85 * open->windward && in->leeward < 0.8 * open->leeward);
        assert_true(in->leeward / open->leeward < in->windward / open->windward);
    }
}

static double tip(const char *model, const char *preset)
{
    struct made m;
    start(&m, "species/moso_bamboo.yaml", model);
    m.run.preset = preset;
    if (try(&m)) fail_msg("%s", m.err.text);
    double out = m.series.deflection[0];
    wf_arena_free(&m.arena);
    return out;
}

/* Tang et al. 2012: the same culm in 7 and in 43 segments. As printed it stiffens with their number, by beam
 * theory it does not care. */
static void printed_chain_shrinks(void **state)
{
    (void)state;
    const char *few = "models/papers/moso_few_segments.yaml", *many = "models/moso_culm.yaml";
    assert_true(tip(many, "tang2012") < 0.1 * tip(few, "tang2012"));
    assert_close(tip(many, "corrected"), tip(few, "corrected"), 0.02);
}

/* Zhao & Zhang 2013: the strong wind sways the tree more than the breeze, on every level; the corrected
 * scheme is near beam theory, the printed one hardly moves. */
static void strong_wind_sways_more(void **state)
{
    (void)state;
    double most[3] = { 0 }, strong[3];
    for (int k = 0; k < 3; k++) {
        struct made m;
        start(&m, "species/poplar.yaml", "models/zhao2013_ifs.yaml");
        m.run.preset = k == 2 ? "zhao2013" : "corrected", m.run.solver = k == 2 ? NULL : "deflect";
        m.run.gust = "sine-perlin", m.run.intensity = 0.4, m.run.period = 3.934,
        m.run.profile.name = "uniform";
        m.run.wind = k == 1 ? 3.5 : 10, m.run.duration = 3.935, m.run.step = 3.934 / 24;
        if (try(&m)) fail_msg("%s", m.err.text);
        for (size_t f = 0; f < m.series.frames; f++) most[k] = fmax(most[k], m.series.deflection[f]);
        assert_int_equal(m.series.levels, 3);
        for (size_t l = 0; k < 2 && l < 3; l++) {
            if (k == 1) assert_true(m.series.level[l].swing_mean < 0.5 * strong[l]);
            strong[l] = m.series.level[l].swing_mean;
        }
        wf_arena_free(&m.arena);
    }
    assert_true(most[1] < 0.25 * most[0]);
    assert_true(most[2] < 1e-6 * most[0]);
}

/* Zhao & Zhang 2013, leaf angles: within their amplitude, different from leaf to leaf, the third follows the
 * first by lambda; they bend nothing. */
static void leaves_by_noise(void **state)
{
    (void)state;
    struct made m, still, loose;
    struct made *const all[] = { &m, &still, &loose };
    for (int k = 0; k < 3; k++) {
        start(all[k], "species/poplar.yaml", "models/zhao2013_ifs.yaml");
        struct wf_series_plan_run *r = &all[k]->run;
        r->solver = "deflect", r->gust = "sine-perlin", r->period = 4, r->duration = 4;
        r->leaf_motion = k == 1 ? "eq13" : "noise";
        r->leaf_amplitude = 0.4, r->leaf_follow = k == 2 ? 0 : 0.7;
        if (try(all[k])) fail_msg("%s", all[k]->err.text);
    }
    size_t n = m.series.an.tree.n, frames = m.series.frames;
    assert_memory_equal(m.series.place, still.series.place, 3 * n * frames * sizeof(double));
    double most = 0, apart = 0;
    for (size_t f = 0; f < frames; f++)
        for (size_t i = 0; i < m.series.leaves.n; i += 7) {
            double a[3], b[3], c[3];
            wf_series_leaf_angles(&m.series, i, f, a);
            wf_series_leaf_angles(&loose.series, i, f, b);
            wf_series_leaf_angles(&still.series, i, f, c);
            for (int k = 0; k < 2; k++) assert_close(a[k], b[k], 0);
            assert_close(a[2], b[2] + 0.7 * b[0], 1e-12);
            for (int k = 0; k < 3; k++) most = fmax(most, fabs(b[k]));
            assert_close(c[0], still.series.leaves.swing * still.series.wind[f], 1e-14);
            assert_close(c[1], still.series.leaves.twist * still.series.wind[f], 1e-14);
            wf_series_leaf_angles(&m.series, i + 1, f, c);
            apart += fabs(c[0] - a[0]);
        }
    assert_true(most > 0.15 && most <= 0.4);
    assert_true(apart > 1);
    for (int k = 0; k < 3; k++) wf_arena_free(&all[k]->arena);
}

static void wrong_words(void **state)
{
    (void)state;
    struct made m;
    start(&m, "species/poplar.yaml", "models/zhao2013_ifs.yaml");
    m.run.leaf_motion = "flutter";
    assert_int_equal(try(&m), WF_EUSAGE);
    assert_non_null(strstr(m.err.text, "flutter"));
    wf_arena_free(&m.arena);
}

/* Tables of leaves and of the comparison of methods. */
static void tables(void **state)
{
    (void)state;
    struct made m;
    struct scratch s;
    struct wf_explain x;
    char folder[300], command[600];
    start(&m, "species/poplar.yaml", "models/zhao2013_ifs.yaml");
    m.run.solver = "deflect", m.run.gust = "sine-perlin", m.run.duration = 3, m.run.keys = 2, m.run.wind = 4;
    if (try(&m)) fail_msg("%s", m.err.text);
    if (wf_explain_run(&m.series.an, &m.spec.solve, 4, &m.arena, &m.diag, &x, &m.err))
        fail_msg("%s", m.err.text);
    scratch_write(&s, "", 0);
    snprintf(folder, sizeof folder, "%s.d", s.path);
    const struct wf_series_page_run run = { &m.series, &m.diag };
    const struct wf_explained explained = {
        .run = 1, .name = "tree", .species = m.series.an.species, .of = &x, .tree = &m.series.an.tree, .speed = 4
    };
    const struct wf_series_page page = { .title = "t",
                                         .command = "c",
                                         .date = "d",
                                         .version = "v",
                                         .n = 1,
                                         .run = &run,
                                         .explained = 1,
                                         .explain = &explained };
    if (wf_series_tables(&page, folder, &m.err)) fail_msg("%s", m.err.text);
    assert_int_equal(lines(folder, "tables/leaf_angles.csv", &m.arena), 1 + 12 * m.series.frames);
    assert_int_equal(lines(folder, "tables/leaves.csv", &m.arena), 1 + 2 * 800);
    assert_int_equal(lines(folder, "tables/explain.csv", &m.arena), 1 + 109);
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
    scratch_remove(&s);
    wf_arena_free(&m.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shelter_calms_the_leeward_side),
        cmocka_unit_test(stiff_shoots_show_the_sides),
        cmocka_unit_test(printed_chain_shrinks),
        cmocka_unit_test(strong_wind_sways_more),
        cmocka_unit_test(leaves_by_noise),
        cmocka_unit_test(wrong_words),
        cmocka_unit_test(tables),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
