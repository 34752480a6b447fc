/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Design winds: closed numbers of the codes; what is missing or out of range is refused. */
#include "close.h"
#include "load/scene.h"
#include "wind/climate.h"
#include "wind/design.h"
#include "wind/gust_factor.h"
#include <string.h>

static const struct wf_design_words nothing = { .basic = NAN, .pressure = NAN, .years = NAN };

static struct wf_design_wind found(struct wf_design_words w)
{
    struct wf_design_wind out;
    struct wf_err e = { 0 };
    if (wf_design_find(&w, &out, &e)) fail_msg("%s", e.text);
    return out;
}

static double pressure(const char *code, const char *terrain, double z)
{
    const struct wf_design *d = wf_design_named(code);
    return d->pressure(wf_design_terrain_named(d, terrain), z);
}

static void rows(void **state)
{
    (void)state;
    for (const struct wf_design *d = wf_designs; d->name; d++) {
        assert_ptr_equal(wf_design_named(d->name), d);
        assert_true(d->source && d->validity && d->basic && d->gust && d->peak);
        assert_non_null(wf_profile_named(d->profile));
        assert_int_equal(d->shape != NULL, !strcmp(d->profile, "code"));
        for (const struct wf_design_terrain *t = d->terrain; t->name; t++) {
            assert_ptr_equal(wf_design_terrain_named(d, t->name), t);
            assert_true(d->squall(t) > d->mean(t) && d->mean(t) > 0.2);
        }
        assert_non_null(wf_design_terrain_named(d, "II"));
    }
}

/* c_prob; a mean and a gust at a site, of 25 m/s. */
static void eurocode(void **state)
{
    (void)state;
    struct wf_design_words w = nothing;
    w.code = "en1991", w.basic = 25;
    struct wf_design_wind at = found(w);
    assert_close(at.open, 25 * 0.19 * log(200), 1e-12);
    assert_close(at.mean, at.open, 1e-12);
    w.terrain = "III", at = found(w);
    assert_close(at.mean, 25 * 0.19 * pow(6, 0.07) * log(10 / 0.3), 1e-12);
    assert_close(at.gust, at.mean * sqrt(1 + 7 / log(10 / 0.3)), 1e-12);
    w.years = 100, at = found(w);
    double p = 0.01, prob = sqrt((1 - 0.2 * log(-log(1 - p))) / (1 - 0.2 * log(-log(0.98))));
    assert_close(at.basic, 25 * prob, 1e-12);
    assert_close(prob, 1.0385, 1e-4);
    w.years = 50;
    assert_close(found(w).basic, 25, 1e-12);
    assert_close(pressure("en1991", "II", 10), 0.19 * 0.19 * log(200) * (log(200) + 7), 1e-12);
}

/* mu_z at 10, 20, 30 m. */
static void chinese(void **state)
{
    (void)state;
    static const double mu[4][3] = {
        { 1.28, 1.52, 1.67 }, { 1.00, 1.23, 1.39 }, { 0.65, 0.74, 0.88 }, { 0.51, 0.51, 0.51 }
    };
    static const double most[] = { 1.60, 1.70, 2.05, 2.40 }; /* beta_gz at 10 m */
    const struct wf_design *d = wf_design_named("gb50009");
    for (size_t i = 0; i < 4; i++) {
        const struct wf_design_terrain *t = &d->terrain[i];
        for (size_t k = 0; k < 3; k++) assert_close(d->pressure(t, 10.0 * (double)(k + 1)), mu[i][k], 0.008);
        double gust = d->squall(t) / d->mean(t);
        assert_close(gust * gust, most[i], 0.005);
    }
    struct wf_design_words w = nothing;
    w.code = "gb50009", w.pressure = 450, w.terrain = "C";
    struct wf_design_wind at = found(w);
    assert_close(at.open, sqrt(450 * 1.6), 1e-12); /* w0 = v0^2 / 1600 kN/m2 */
    assert_close(at.mean, at.open * sqrt(0.544) * pow(1.5, 0.22), 1e-12);
    assert_true(at.exponent == 0.22 && at.least == 15);
}

/* Hourly means 0.45 and 0.65 of the gust at 10 m; V_bar at 12 m, and the gust at 10 m over open country. */
static void american(void **state)
{
    (void)state;
    struct wf_design_words w = nothing;
    double hour;
    w.code = "asce7", w.basic = 45, w.terrain = "B";
    struct wf_design_wind at = found(w);
    assert_int_equal(wf_wind_average("durst", NULL, at.mean, 600, 3600, &hour, NULL), WF_OK);
    assert_close(hour * pow(1.2, at.exponent), 0.45 * pow(1.2, 0.25) * 45, 1e-9);
    assert_close(hour * pow(1.2, at.exponent), 21.194, 1e-3);
    w.terrain = "C", at = found(w);
    assert_int_equal(wf_wind_average("durst", NULL, at.mean, 600, 3600, &hour, NULL), WF_OK);
    assert_close(hour * pow(1.2, at.exponent), 30.084, 1e-3);
    assert_close(at.gust, 45, 0.02);
    assert_close(pressure("asce7", "B", 30), 0.985, 2e-3);
}

/* V_R of 50 years; M_z,cat between the heights of the table. */
static void australian(void **state)
{
    (void)state;
    static const struct {
        const char *region;
        double gust;
    } row[] = { { "A0", 39 },  { "A5", 39 },  { "B1", 44 },  { "C", 1.05 * 52 }, { "D", 1.05 * 60 },
                { "NZ1", 41 }, { "NZ2", 48 }, { "NZ3", 46 }, { "NZ4", 41 } };
    struct wf_design_words w = nothing;
    w.code = "asnzs1170", w.years = 50;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        w.region = row[i].region;
        assert_close(found(w).basic, row[i].gust, 1e-12);
    }
    assert_close(pressure("asnzs1170", "TC3", 25), 0.97 * 0.97, 1e-12);
    assert_close(pressure("asnzs1170", "TC3", 1), 0.83 * 0.83, 1e-12);
    assert_close(pressure("asnzs1170", "TC1", 90), 1.23 * 1.23, 1e-12);
    w.region = "A1", w.terrain = "TC3";
    struct wf_design_wind at = found(w);
    assert_close(at.gust, 39 * 0.83, 1e-12);
    assert_close(at.mean, at.gust / wf_category_gust(wf_category_named("III"), 10), 1e-12);
}

static void swiss(void **state)
{
    (void)state;
    assert_close(pressure("sia261", "II", 10), 1.6 * pow(pow(10.0 / 300, 0.16) + 0.375, 2), 1e-12);
    assert_close(pressure("sia261", "II", 1), pressure("sia261", "II", 5), 1e-15);
    assert_close(pressure("sia261", "IIa", 20), 1.6 * pow(pow(20.0 / 380, 0.19) + 0.375, 2), 1e-12);
    assert_close(pressure("sia261", "III", 20), 1.6 * pow(pow(20.0 / 450, 0.23) + 0.375, 2), 1e-12);
    assert_close(pressure("sia261", "IV", 1), 1.6 * pow(pow(10.0 / 526, 0.30) + 0.375, 2), 1e-12);
}

/* 33 m/s at the tree, at every height, nothing on top. */
static void arborists(void **state)
{
    (void)state;
    struct wf_scenario s;
    struct wf_profile_words w = WF_PROFILE_UNSAID;
    struct wf_err e = { 0 };
    w.design.code = "arborist";
    struct wf_design_wind at = found(w.design);
    assert_close(at.gust, 33, 0);
    wf_scenario_default(&s);
    assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
    assert_string_equal(s.profile, "uniform");
    assert_close(wf_scenario_gust(&s, at.open), 33, 1e-12);
    assert_close(wf_scenario_speed(&s, at.open), at.open, 1e-12);
}

/* The peak load of the Chinese code is below that of the European one, both over the same mean load. */
static void codes_differ(void **state)
{
    (void)state;
    struct wf_gust_case c = { .height = 20, .breadth = 6, .frequency = 0.25, .damping = 0.08, .exponent = 2 };
    struct wf_gust_parts en, gb;
    for (size_t i = 2; i < 4; i++) {
        c.terrain = &wf_categories[i];
        c.open = 25, c.mean = 25 * wf_category_factor(c.terrain, 12);
        wf_gust_rule_named("en1991")->parts(&c, &en);
        c.open = sqrt(0.45 * 1600);
        wf_gust_rule_named("gb50009")->parts(&c, &gb);
        assert_close(gb.factor / en.factor, 0.75, 0.03);
    }
}

static const struct wf_category *site(const char *name)
{
    return wf_category_named(wf_site_kind_named(name)->category);
}

/* A wind named in open country is carried to the site by c_r; one measured at the site is not. */
static void carried(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    for (const struct wf_site_kind *k = wf_site_kinds; k->name; k++) {
        struct wf_profile_words w = WF_PROFILE_UNSAID;
        struct wf_scenario s;
        wf_scenario_default(&s);
        w.site = k->name, w.reference_height = 20;
        assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
        assert_int_equal(wf_scenario_check(&s, &e), WF_OK);
        assert_string_equal(s.profile, "terrain");
        assert_ptr_equal(s.category, site(k->name));
        assert_close(wf_scenario_speed(&s, 30),
                     30 * wf_category_factor(s.category, 20) / wf_category_factor(wf_category_open(), 10),
                     1e-12);
        assert_close(wf_scenario_gust(&s, 30), 30 * sqrt(1 + 7 / log(200)), 1e-12);
        s.speed_up = 1.2;
        assert_close(wf_scenario_speed(&s, 30), 36 * s.carried, 1e-12);
        w.at = "site";
        wf_scenario_default(&s);
        assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
        assert_close(wf_scenario_speed(&s, 30), 30, 0);
        assert_close(wf_scenario_gust(&s, 30), 30 * wf_category_gust(s.category, 20), 1e-12);
    }
}

/* The wind of a code at any height of its profile is the code's own, whatever the reference height. */
static void profile_of_a_code(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    for (double reference = 5; reference < 50; reference += 15)
        for (size_t i = 0; i < 4; i++) {
            struct wf_profile_words w = WF_PROFILE_UNSAID;
            struct wf_scenario s;
            struct wf_wind wind;
            double u[3], du[9], x[3] = { 0, 0, 33 };
            wf_scenario_default(&s);
            w.design.code = "gb50009", w.design.basic = 27, w.reference_height = reference;
            w.design.terrain = wf_design_named("gb50009")->terrain[i].name;
            assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
            assert_int_equal(wf_scenario_check(&s, &e), WF_OK);
            wf_scenario_wind(&s, &wind);
            wind.speed = wf_scenario_speed(&s, 27);
            wind.sample(&wind, x, u, du);
            assert_close(hypot(u[0], u[1]), 27 * sqrt(pressure("gb50009", w.design.terrain, 33)), 1e-12);
        }
}

static void refused(void **state)
{
    (void)state;
    static const struct {
        struct wf_design_words w;
        const char *says;
    } row[] = {
        { { "en1991", "III", NULL, NAN, NAN, NAN }, "needs its basic wind" },
        { { "en1991", "III", NULL, 25, 500, NAN }, "not both" },
        { { "en1991", "V", NULL, 25, NAN, NAN }, "there are 0, I, II, III, IV" },
        { { "en1991", NULL, NULL, 25, NAN, 1 }, "longer than 1 year" },
        { { "gb50009", NULL, NULL, 25, NAN, 100 }, "no rule for a return period" },
        { { "gb50009", NULL, NULL, 15, NAN, NAN }, "the least of the code is 0.3" },
        { { "asce7", "A", NULL, 45, NAN, NAN }, "there are B, C, D" },
        { { "asce7", "B", NULL, NAN, 900, NAN }, "takes a speed" },
        { { "asnzs1170", NULL, "A1", NAN, NAN, NAN }, "needs --region and --return-period" },
        { { "asnzs1170", NULL, "E", NAN, NAN, 50 }, "unknown region 'E'" },
        { { "asnzs1170", NULL, "A1", NAN, NAN, 3 }, "for 5 and more" },
        { { "sia261", NULL, "A1", 30, NAN, NAN }, "has no regions" },
        { { "arborist", "III", NULL, NAN, NAN, NAN }, "at the tree" },
        { { "din", NULL, NULL, 25, NAN, NAN }, "unknown design wind" },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct wf_design_wind out;
        struct wf_err e = { 0 };
        assert_int_equal(wf_design_find(&row[i].w, &out, &e), WF_EUSAGE);
        if (!strstr(e.text, row[i].says)) fail_msg("'%s' does not say '%s'", e.text, row[i].says);
    }
}

/* Gust over mean at a site: of the winds named, of the code, and lower down over rough ground. */
static void gust_at_the_site(void **state)
{
    (void)state;
    struct wf_scenario s;
    struct wf_err e = { 0 };
    struct wf_profile_words w = WF_PROFILE_UNSAID;
    w.design.terrain = "III";
    wf_scenario_default(&s);
    assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
    assert_close(wf_scenario_squall(&s, 10), sqrt(1 + 7 / log(10 / 0.3)), 1e-12);
    assert_close(wf_scenario_squall(&s, 6), sqrt(1 + 7 / log(6 / 0.3)), 1e-12);
    w.design.terrain = NULL, w.gust_factor = 1.7;
    wf_scenario_default(&s);
    assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
    assert_close(wf_scenario_squall(&s, 10), 1.7, 1e-12);
    w = (struct wf_profile_words)WF_PROFILE_UNSAID;
    w.design.code = "asce7", w.design.terrain = "B", w.design.basic = 45;
    wf_scenario_default(&s);
    assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
    struct wf_design_wind at = found(w.design);
    assert_close(wf_scenario_squall(&s, 10), at.gust / at.mean, 1e-12);
    w.design.code = "arborist", w.design.terrain = NULL, w.design.basic = NAN;
    wf_scenario_default(&s);
    assert_int_equal(wf_scenario_words(&s, &w, &e), WF_OK);
    assert_close(wf_scenario_gust(&s, 1.0), wf_scenario_squall(&s, 3), 1e-12); /* the same at every height */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows),      cmocka_unit_test(eurocode),          cmocka_unit_test(chinese),
        cmocka_unit_test(american),  cmocka_unit_test(australian),        cmocka_unit_test(swiss),
        cmocka_unit_test(arborists), cmocka_unit_test(codes_differ),      cmocka_unit_test(carried),
        cmocka_unit_test(refused),   cmocka_unit_test(profile_of_a_code), cmocka_unit_test(gust_at_the_site),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
