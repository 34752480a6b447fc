/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tree models: what is read, and every mistake by name. */
#include "close.h"
#include "base/yaml.h"
#include "data/model.h"
#include "edited.h"

static const char good[] = "model: culm_14\n"
                           "name: A culm\n"
                           "stem:\n"
                           "  height: 14 m\n"
                           "  base_radius: 52.5 mm\n"
                           "  taper: {law: linear, tip_share: 0.2}\n"
                           "  segments: 10\n"
                           "  lean: 30 deg\n"
                           "crown:\n"
                           "  base: 5.5 m\n"
                           "  top: 13 m\n"
                           "  leaf_area: 17 m2\n"
                           "  shape: {at: [0, 0.4, 1], share: [0.2, 1, 0.3]}\n";

struct reading {
    struct wf_model model;
    struct wf_diag diag;
    struct wf_err err;
    enum wf_status status;
    char findings[2048];
};

static void read_text(const char *text, struct wf_arena *a, struct reading *r)
{
    struct scratch s;
    memset(r, 0, sizeof *r);
    r->diag.arena = a;
    scratch_write(&s, text, strlen(text));
    r->status = wf_model_read(s.path, a, &r->model, &r->diag, &r->err);
    findings_print(&r->diag, r->findings, sizeof r->findings);
    scratch_remove(&s);
}

static void a_model_is_read_in_si(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_text(good, &a, &r);
    assert_string_equal(r.findings, "");
    assert_int_equal(r.status, WF_OK);
    const struct wf_model *m = &r.model;
    assert_string_equal(m->key, "culm_14");
    assert_null(m->note);
    assert_close(m->height, 14, 0);
    assert_close(m->radius, 0.0525, 1e-15);
    assert_close(m->lean, 3.14159265358979323846 / 6, 1e-15);
    assert_close(m->lean_azimuth, 0, 0);
    assert_int_equal(m->taper, WF_TAPER_LINEAR);
    assert_int_equal(m->segments, 10);
    assert_close(m->crown_top, 13, 0);
    assert_close(m->leaf_area, 17, 0);
    assert_int_equal(m->crown_shape.n, 3);
    wf_arena_free(&a);
}

static void what_is_left_out_has_its_default(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_text("model: m\nname: M\nstem: {height: 2 m, taper: {law: linear, tip_share: 1}}\n", &a, &r);
    assert_int_equal(r.status, WF_OK);
    assert_true(isnan(r.model.radius) && isnan(r.model.crown_base) && isnan(r.model.crown_top));
    assert_int_equal(r.model.segments, 40);
    assert_close(r.model.leaf_area, 0, 0);
    assert_close(r.model.lean, 0, 0);
    read_text("model: m\nname: M\nstem: {height: 2 m, taper: {law: linear, tip_share: 1}}\ncrown: {base: 1 "
              "m, leaf_area: 3 m2}\n",
              &a, &r);
    assert_int_equal(r.status, WF_OK);
    assert_close(r.model.crown_top, 2, 0);
    assert_int_equal(r.model.crown_shape.n, 0);
    wf_arena_free(&a);
}

static void tapers_follow_their_laws(void **state)
{
    (void)state;
    double at[] = { 0, 0.1, 1 }, share[] = { 1, 0.9, 0.2 };
    struct wf_model m = {
        .taper = WF_TAPER_LINEAR, .tip_ratio = 0.2, .power = 0.5, .profile = { 3, at, share }
    };
    assert_close(wf_model_taper(&m, 0), 1, 0);
    assert_close(wf_model_taper(&m, 0.5), 0.6, 1e-15);
    assert_close(wf_model_taper(&m, 1), 0.2, 1e-15);
    m.taper = WF_TAPER_POWER;
    assert_close(wf_model_taper(&m, 0), 1, 1e-15);
    assert_close(wf_model_taper(&m, 0.75), 0.2 + 0.8 * 0.5, 1e-15);
    assert_close(wf_model_taper(&m, 1), 0.2, 0);
    m.taper = WF_TAPER_TABLE;
    assert_close(wf_model_taper(&m, 0.05), 0.95, 1e-15);
    assert_close(wf_model_taper(&m, 0.55), 0.55, 1e-15);
}

static const struct edit mistakes[] = {
    { NULL, "model: m\nname: M\n", "1:1: missing key 'stem' (The stem.)" },
    { "model: culm_14\n", "",
      "1:1: missing key 'model' (Key of the model, as its file's name.); for example 'model: moso_culm'" },
    { "  height: 14 m\n", "",
      "4:3: stem: missing key 'height' (Length of the stem from ground to tip.); for example 'height: 14 "
      "m'" },
    { "14 m\n", "1 mm\n", "4:11: stem.height: 1 mm is outside 0.01 m to 150 m" },
    { "14 m\n", "1400 m\n", "4:11: stem.height: 1400 m is outside 0.01 m to 150 m" },
    { "14 m\n", "-14 m\n", "4:11: stem.height: -14 m is outside 0.01 m to 150 m" },
    { "14 m\n", "12 m\n", "11:8: crown.top: 13 m is above the stem's height 12 m" },
    { "52.5 mm", "52.5", "5:16: stem.base_radius: '52.5' has no unit; write for example '52.5 mm'" },
    { "52.5 mm", "0 mm", "5:16: stem.base_radius: 0 mm is outside 0.1 mm to 10000 mm" },
    { "  taper: {law: linear, tip_share: 0.2}\n", "",
      "4:3: stem: needs the key 'taper', for example 'taper: {law: linear, tip_share: 0.19}', or "
      "'sections'" },
    { "law: linear", "law: liner",
      "6:16: stem.taper.law: 'liner' is not one of: table, linear, power; did you mean 'linear'?" },
    { "tip_share: 0.2", "tip_share: 2", "6:35: stem.taper.tip_share: 2 is outside 0.001 to 1.5" },
    { "tip_share: 0.2", "tip_share: 0", "6:35: stem.taper.tip_share: 0 is outside 0.001 to 1.5" },
    { ", tip_share: 0.2", "", "6:10: stem.taper: law 'linear' needs the key 'tip_share'" },
    { "law: linear", "law: power", "6:10: stem.taper: law 'power' needs the key 'power'" },
    { "tip_share: 0.2", "tip_share: 0.2, power: 1", "6:47: stem.taper.power: is not used by law 'linear'" },
    { "law: linear, tip_share: 0.2", "law: power, tip_share: 0.2, power: 9",
      "6:46: stem.taper.power: 9 is outside 0.1 to 5" },
    { "law: linear", "law: table",
      "6:10: stem.taper: law 'table' needs the key 'at'\n6:10: stem.taper: law 'table' needs the key "
      "'share'\n6:34: stem.taper.tip_share: is not used by law 'table'" },
    { "law: linear, tip_share: 0.2", "law: table, at: [0, 0.5], share: [1, 0.5]",
      "6:27: stem.taper.at: runs from 0 to 0.5; it must cover the stem from 0 to 1" },
    { "law: linear, tip_share: 0.2", "law: table, at: [0, 1], share: [0.9, 0.5]",
      "6:43: stem.taper.share[0]: is 0.9; shares are of the base radius, so the first is 1" },
    { "law: linear, tip_share: 0.2", "law: table, at: [0, 0.5, 0.4, 1], share: [1, 0.5, 0.4, 0.2]",
      "6:27: stem.taper.at: 0.4 follows 0.5; the values must ascend" },
    { "law: linear, tip_share: 0.2", "law: table, at: [0, 1], share: [1]",
      "6:42: stem.taper.share: 1 value, but 'at' has 2" },
    { "law: linear, tip_share: 0.2", "law: table, at: [0, 1], share: [1, 0]",
      "6:46: stem.taper.share[1]: 0 is outside 0.001 to 1.5" },
    { "segments: 10", "segments: 0", "7:13: stem.segments: 0 is outside 1 to 20000" },
    { "segments: 10", "segments: ten",
      "7:13: stem.segments: 'ten' is not a whole number; write for example '40'" },
    { "30 deg", "120 deg", "8:9: stem.lean: 120 deg is outside 0 deg to 90 deg" },
    { "30 deg", "30", "8:9: stem.lean: '30' has no unit; write for example '30 deg'" },
    { "lean:", "leaning:", "8:3: stem: unknown key 'leaning'; did you mean 'lean'?" },
    { "  base: 5.5 m\n", "",
      "10:3: crown: missing key 'base' (Where the crown begins, along the stem.); for example 'base: 5.5 "
      "m'" },
    { "5.5 m", "13.5 m", "10:9: crown.base: 13.5 m is not below the crown's top 13 m" },
    { "13 m", "15 m", "11:8: crown.top: 15 m is above the stem's height 14 m" },
    { "  leaf_area: 17 m2\n", "", "10:3: crown: needs the key 'leaf_area', or the model 'frontal_area'" },
    { "17 m2", "17 m",
      "12:14: crown.leaf_area: '17 m': 'm' is not a unit of an area; use one of: m2, cm2, ha" },
    { "17 m2", "-1 m2", "12:14: crown.leaf_area: -1 m2 is outside 0 m2 to 10000 m2" },
    { "[0, 0.4, 1]", "[0, 0.4]", "13:32: crown.shape.share: 3 values, but 'at' has 2" },
    { "[0, 0.4, 1]", "[0.4, 0.4, 1]", "13:15: crown.shape.at: 0.4 follows 0.4; the values must ascend" },
    { "[0.2, 1, 0.3]", "[0, 0, 0]",
      "13:35: crown.shape.share: is 0 everywhere; the leaves must be somewhere" },
    { "[0.2, 1, 0.3]", "[0.2, -1, 0.3]", "13:41: crown.shape.share[1]: -1 is outside 0 to 1e+06" },
};

static void findings_of(const char *text, char *buf, size_t size)
{
    struct wf_arena a = { 0 };
    struct reading r;
    read_text(text, &a, &r);
    assert_int_equal(r.status, WF_EINPUT);
    snprintf(buf, size, "%s", r.findings);
    wf_arena_free(&a);
}

static void every_mistake_is_named(void **state)
{
    (void)state;
    assert_mistakes_are_named(good, mistakes, sizeof mistakes / sizeof *mistakes, findings_of);
}

static void memory_is_refused_at_every_smaller_capacity(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_text(good, &a, &r);
    size_t need = a.used;
    wf_arena_free(&a);
    for (size_t limit = 1; limit <= need; limit += limit + 16 < need ? 11 : 1) {
        struct wf_arena small = { .limit = limit };
        read_text(good, &small, &r);
        assert_int_equal(r.status, limit < need ? WF_ENOMEM : WF_OK);
        wf_arena_free(&small);
    }
}

static void the_schema_is_printed(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    const char *text = wf_yaml_schema(&wf_model_table, &a, &e);
    assert_non_null(text);
    static const char *const lines[] = { "  stem.height  (required)\n", "  crown.shape.share  (required)\n",
                                         "an angle, 0 deg to 90 deg", "default: 40",
                                         "table | linear | power" };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) assert_non_null(strstr(text, lines[i]));
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_model_is_read_in_si),
        cmocka_unit_test(what_is_left_out_has_its_default),
        cmocka_unit_test(tapers_follow_their_laws),
        cmocka_unit_test(every_mistake_is_named),
        cmocka_unit_test(memory_is_refused_at_every_smaller_capacity),
        cmocka_unit_test(the_schema_is_printed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
