/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Laws as rows: every row is complete and smooth; reader, schema and messages follow a table that only this
 * test knows; a case may name a law. */
#include "base/units.h"
#include "cases/read.h"
#include "cases/run.h"
#include "close.h"
#include "base/yaml.h"
#include "data/species.h"
#include "edited.h"
#include "load/drag.h"
#include "load/load.h"
#include <string.h>

/* A value in the middle of what a parameter may be; lists ascend from low to high. */
static void fill(const struct wf_law *l, struct wf_law_values *v, double room[][5])
{
    *v = (struct wf_law_values){ .n = 5 };
    for (size_t k = 0, n = wf_law_count(l); k < n; k++) {
        const struct wf_law_parameter *p = &l->parameter[k];
        v->number[k] = 0.5 * (p->low + p->high);
        for (int i = 0; i < 5; i++) room[k][i] = p->low + (p->high - p->low) * i / 4;
        v->list[k] = room[k];
    }
}

static void complete(const struct wf_law *l)
{
    assert_true(l->name && l->summary && l->source && l->validity && l->low < l->high);
    assert_true(wf_law_count(l) <= WF_LAW_PARAMETERS);
    for (size_t k = 0; k < wf_law_count(l); k++) {
        const struct wf_law_parameter *p = &l->parameter[k];
        assert_true(p->result && p->doc && p->example && p->low < p->high && isfinite(p->low + p->high));
        assert_int_equal(wf_law_find(l, p->name), (int)k);
    }
    assert_int_equal(wf_law_find(l, "nothing"), -1);
}

static void derivative_is_right(double low, double value, double high, double slope, double h)
{
    double want = (high - low) / (2 * h);
    assert_true(isfinite(value) && isfinite(slope));
    assert_true(fabs(slope - want) <= 2e-5 * fabs(slope) + 1e-7 * fabs(value) / h * 1e-2);
}

static void every_streamlining_law_is_smooth(void **state)
{
    (void)state;
    for (const struct wf_streamline_law *l = wf_streamline_laws; l->law.name; l++) {
        struct wf_law_values v;
        double room[WF_LAW_PARAMETERS][5], slope, ignored;
        complete(&l->law);
        fill(&l->law, &v, room);
        assert_true(fabs(l->share(&v, 0, &slope) - l->share(&v, 1e-9, &ignored)) < 1e-6);
        for (double u = 0.013; u < 100; u *= 1.037) {
            double h = 1e-6 * u, value = l->share(&v, u, &slope);
            derivative_is_right(l->share(&v, u - h, &ignored), value, l->share(&v, u + h, &ignored), slope,
                                h);
            assert_true(value >= 0 && value <= 2);
            if (l->rigid) assert_close(value, 1, 0);
        }
        assert_ptr_equal(wf_streamline_named(l->law.name), l);
    }
}

static void every_axis_law_is_smooth(void **state)
{
    (void)state;
    const double diameter = 0.08, viscosity = 1.5e-5;
    for (const struct wf_axis_drag_law *l = wf_axis_drag_laws; l->law.name; l++) {
        struct wf_law_values v;
        double room[WF_LAW_PARAMETERS][5], slope, ignored;
        complete(&l->law);
        fill(&l->law, &v, room);
        assert_true(isfinite(l->coefficient(&v, 0, diameter, viscosity, &slope)));
        for (double re = l->law.low; re < l->law.high; re *= 1.23) {
            double u = re * viscosity / diameter, h = 1e-6 * u;
            double value = l->coefficient(&v, u, diameter, viscosity, &slope);
            derivative_is_right(l->coefficient(&v, u - h, diameter, viscosity, &ignored), value,
                                l->coefficient(&v, u + h, diameter, viscosity, &ignored), slope, h);
            assert_true(value > 0);
        }
        assert_ptr_equal(wf_axis_drag_named(l->law.name), l);
    }
    assert_null(wf_axis_drag_named("birch"));
}

/* Laws that only this test knows: a parameter shared by two, one of two lists, one with a default. */
static const struct wf_law_parameter stiff[] = {
    { "speed", WF_LAW_NUMBER, WF_DIM_SPEED, "m/s", 1, 50, NULL, "stiff_speed", "Speed of half the area.",
      "9 m/s" },
    { "depth", WF_LAW_VALUE, WF_DIM_NONE, NULL, 0, 1, NULL, "stiff_depth", "Share that goes.", "0.4" },
    { .name = NULL },
};
static const struct wf_law_parameter soft[] = {
    { "rate", WF_LAW_NUMBER, WF_DIM_NONE, NULL, 0, 3, "0.25", "soft_rate", "Rate of it.", "0.3" },
    { "depth", WF_LAW_VALUE, WF_DIM_NONE, NULL, 0, 1, NULL, "stiff_depth", "Share that goes.", "0.4" },
    { "at", WF_LAW_LIST, WF_DIM_SPEED, "m/s", 0, 90, NULL, "soft_at", "Speeds.", "[1 m/s, 2 m/s]" },
    { "left", WF_LAW_LIST, WF_DIM_NONE, NULL, 0, 1, NULL, "soft_left", "Shares.", "[1, 0.5]" },
    { .name = NULL },
};
static const struct wf_law crowns[] = {
    { "stiff", "gives way late", "a test", "never", 0, 1, stiff },
    { "soft", "gives way early", "a test", "never", 0, 1, soft },
    { .name = NULL },
};
static const struct wf_law axes[] = {
    { "bark", "rough", "a test", "never", 0, 1, NULL },
    { "smooth", "polished", "a test", "never", 0, 1, stiff },
    { .name = NULL },
};
static const struct wf_laws own = { { crowns, sizeof *crowns }, { axes, sizeof *axes } };

static const char good[] =
    "species: x\nname: X\naxis_drag: {law: smooth, speed: 9 km/h, depth: 0.3}\nlevels:\n"
    "  - {name: stem, youngs_modulus: 9 GPa, density: 800 kg/m3, radius: 5 cm}\n"
    "crown:\n  drag_coefficient: 0.5\n  leaf_mass_per_area: 0.2 kg/m2\n  frontal_share: 0.3\n"
    "  streamlining: {law: soft, depth: {value: 0.5, low: 0.4}, at: [1 m/s, 3 m/s], left: [1, "
    "0.5]}\n";

static enum wf_status read_own(const char *text, struct wf_arena *a, struct wf_species *sp, char *found,
                               size_t size)
{
    struct scratch s;
    struct wf_diag d = { .arena = a };
    scratch_write(&s, text, strlen(text));
    enum wf_status status = wf_species_read(s.path, &own, a, sp, &d, NULL);
    findings_print(&d, found, size);
    scratch_remove(&s);
    return status;
}

static void reader_follows_the_table(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_species sp;
    char found[2048];
    assert_int_equal(read_own(good, &a, &sp, found, sizeof found), WF_OK);
    assert_string_equal(found, "");
    const struct wf_law_use *u = &sp.streamlining;
    assert_string_equal(u->law, "soft"); /* values stand in the order of its row */
    assert_close(u->parameter[0].value, 0.25, 0);
    assert_close(u->parameter[1].low, 0.4, 0);
    assert_int_equal(u->list[2].n, 2);
    assert_close(u->list[2].v[1], 3, 0);
    assert_close(u->list[3].v[1], 0.5, 0);
    assert_string_equal(sp.axis_drag.law, "smooth");
    assert_close(sp.axis_drag.parameter[0].value, 2.5, 1e-15);
    assert_close(sp.axis_drag.parameter[1].value, 0.3, 0);
    struct wf_loads l;
    struct wf_err e = { 0 };
    wf_loads_default(&l);
    assert_int_equal(wf_loads_laws(&l, &sp, &e), WF_EINPUT); /* the program does not know them */
    assert_string_equal(e.text, "x: unknown streamlining law 'soft'");
    wf_arena_free(&a);
}

static void findings_of(const char *text, char *buf, size_t size)
{
    struct wf_arena a = { 0 };
    struct wf_species sp;
    assert_int_equal(read_own(text, &a, &sp, buf, size), WF_EINPUT);
    wf_arena_free(&a);
}

static void mistakes_follow_the_table(void **state)
{
    (void)state;
    static const struct edit rows[] = {
        { "law: soft", "law: sotf",
          "10:23: crown.streamlining.law: 'sotf' is not one of: stiff, soft; did you mean 'soft'?" },
        { "law: smooth", "law: smoth",
          "3:18: axis_drag.law: 'smoth' is not one of: bark, smooth; did you mean 'smooth'?" },
        { "speed: 9 km/h", "sped: 9 km/h",
          "3:12: axis_drag: law 'smooth' needs the key 'speed'\n3:26: axis_drag: unknown key 'sped'; did you "
          "mean "
          "'speed'?" },
        { "law: smooth", "law: bark",
          "3:31: axis_drag.speed: is for law 'smooth'; the law here is 'bark'\n"
          "3:46: axis_drag.depth: is for law 'smooth'; the law here is 'bark'" },
        { "at: [1 m/s, 3 m/s]", "at: [4 m/s, 3 m/s]",
          "10:64: crown.streamlining.at: 3 follows 4; the values must ascend" },
        { "left: [1, 0.5]", "left: [1, 0.5, 0.2]",
          "10:86: crown.streamlining.left: 3 values, but 'at' has 2" },
        { "depth: 0.3", "depth: 3", "3:48: axis_drag.depth: 3 is outside 0 to 1" },
        { "low: 0.4}", "source: z}", "10:57: crown.streamlining.depth.source: 'z' is not in 'sources'" },
    };
    assert_mistakes_are_named(good, rows, sizeof rows / sizeof *rows, findings_of);
}

static void schema_follows_the_table(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    const char *text = wf_yaml_schema(wf_species_table(&own, &a), &a, NULL), *shipped = wf_yaml_schema(wf_species_table(&wf_laws, &a), &a, NULL);
    assert_non_null(strstr(text, "stiff: gives way late; soft: gives way early."));
    assert_non_null(strstr(text, "needed by law stiff, soft, refused by the others"));
    assert_non_null(strstr(text, "if absent: 0.25 by law soft, refused by the others"));
    assert_non_null(strstr(text, "if absent: that of the depth"));
    assert_non_null(strstr(text, "axis_drag.law  (required)"));
    if (!wf_law_row(wf_laws.axis_drag, 1))
        assert_null(strstr(shipped, "axis_drag")); /* one law is no choice */
    wf_arena_free(&a);
}

#define CASE                                                                                                 \
    "kind closed-form\nsource 1/2 rho (Cd D + S (U/U0)^V) U^2, Cd = 1.2 at Re = 1e5\ncantilever 6 m\n"       \
    "radius 0.1 m\nyoungs_modulus 1e6 GPa\npoisson 0.3\nwind 10 0 0 m/s\nair_density 1.2 kg/m3\n"            \
    "air_viscosity 2e-5 m2/s\ncrown_area 0.24 m\nsolver linear\nwant force base 129.6 0 0 N\n"

static void a_case_names_laws(void **state)
{
    (void)state;
    static const struct {
        const char *lines, *finding; /* "": runs and passes */
    } rows[] = {
        { "axis_drag bark\nstreamlining vogel exponent -1 reference_speed 5 m/s\n", "" },
        { "axis_drag bark\nstreamlining table speed 5 10 20 m/s share 1 0.5 0.2\n", "" },
        { "drag_coefficient 1.2\nstreamlining table speed 5 10 m/s share 100 50 %\n", "" },
        { "axis_drag bork\n", "unknown law 'bork'; did you mean 'bark'?" },
        { "axis_drag bark\nstreamlining vogle\n", "unknown law 'vogle'; did you mean 'vogel'?" },
        { "axis_drag bark\nstreamlining vogel -1\n", "'exponent NUMBER' is expected here" },
        { "axis_drag bark\nstreamlining vogel exponent 1 reference_speed 5 m/s\n", "'1' is outside" },
        { "axis_drag bark\nstreamlining table speed 5 10 m/s share 1\n",
          "1 numbers, but the list before has 2" },
        { "axis_drag bark\ndrag_coefficient 1\n", "drag_coefficient" },
        { "", "drag_coefficient (wind) is missing" },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[1024], found[2048];
        struct wf_arena a = { 0 };
        struct wf_diag d = { .arena = &a };
        struct scratch s;
        struct wf_case *list;
        struct wf_verdict v;
        size_t n;
        snprintf(text, sizeof text, "%s%s", CASE, rows[i].lines);
        scratch_write(&s, text, strlen(text));
        enum wf_status status = wf_case_read(s.path, &a, &d, &list, &n, NULL);
        findings_print(&d, found, sizeof found);
        scratch_remove(&s);
        if (!strstr(found, rows[i].finding) || (status == WF_OK) != !*rows[i].finding)
            fail_msg("%s gives '%s'", rows[i].lines, found);
        if (!status) {
            assert_int_equal(wf_case_run(list, 0, 1, &a, &v, NULL), WF_OK);
            assert_int_equal(v.outcome, WF_PASSED);
        }
        wf_arena_free(&a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_streamlining_law_is_smooth), cmocka_unit_test(every_axis_law_is_smooth),
        cmocka_unit_test(reader_follows_the_table),         cmocka_unit_test(mistakes_follow_the_table),
        cmocka_unit_test(schema_follows_the_table),         cmocka_unit_test(a_case_names_laws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
