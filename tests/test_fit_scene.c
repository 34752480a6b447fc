/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scene of a fit: air, wind profile and site of a test reach its readings, as they reach an analysis. */
#include "close.h"
#include "data/model.h"
#include "data/species.h"
#include "fit/build.h"
#include "fit/fit.h"
#include "fit/predict.h"
#include "load/drag.h"
#include "scratch.h"
#include "shell.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include "wind/terrain.h"

static const double truth = 10e9; /* modulus of the shipped moso bamboo [Pa] */

struct job {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    char folder[64];
    struct wf_calibration calibration;
    struct wf_experiment x;
    struct wf_fit_input input[8];
};

static void put(struct job *j, const char *name, const char *text)
{
    FILE *f = fopen(wf_arena_print(&j->arena, "%s/%s", j->folder, name), "w");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
}

/* A measured profile with little wind below, and a ridge along y with the tree on its crest. */
static void begin(struct job *j)
{
    enum { N = 33, CELL = 50 };
    struct wf_terrain t;
    memset(j, 0, sizeof *j);
    j->diag.arena = &j->arena;
    snprintf(j->folder, sizeof j->folder, "/tmp/windfirm-test-XXXXXX");
    assert_non_null(mkdtemp(j->folder));
    put(j, "mast.csv", "height_m,speed_ms\n4,1\n8,3\n12,8\n20,12\n");
    put(j, "calm.csv", "height_m,speed_ms\n4,1\n8,0\n12,0\n");
    put(j, "words.csv", "height_m,speed_ms\n4,1\n8,x\n");
    assert_int_equal(wf_terrain_alloc(&t, N, N, CELL, &j->arena, &j->err), WF_OK);
    for (size_t i = 0; i < N * N; i++)
        t.z[i] = 40 * exp(-pow((double)(i % N) * CELL - 800, 2) / (2 * 250.0 * 250.0));
    const char *path = wf_arena_print(&j->arena, "%s/ridge.asc", j->folder);
    assert_int_equal(wf_terrain_write(path, &t, NULL, &j->err), WF_OK);
}

static void end(struct job *j)
{
    char command[128];
    snprintf(command, sizeof command, "rm -r %s", j->folder);
    assert_int_equal(system(command), 0);
    wf_arena_free(&j->arena);
}

static enum wf_status build(struct job *j, const char *wind)
{
    const char *path = wf_arena_print(&j->arena, "%s/study.yaml", j->folder);
    put(j, "study.yaml",
        wf_arena_print(&j->arena,
                       "fit: study\nname: Study\ntrees:\n"
                       "  - {name: culm, species: moso_bamboo, model: moso_culm}\n"
                       "tests:\n  - name: wind\n    zero: unloaded\n    wind: {speeds: [7 m/s, 9 m/s]%s%s}\n"
                       "    sensors:\n"
                       "      - {name: middle, kind: deflection, height: 7 m, azimuth: 0 deg, sigma: 1 mm}\n"
                       "      - {name: top, kind: deflection, height: 14 m, azimuth: 0 deg, sigma: 1 mm}\n"
                       "free:\n  - {parameter: level0.youngs_modulus, start: 6 GPa}\n",
                       *wind ? ", " : "", wind));
    struct wf_fit_build b = { .calibration = &j->calibration, .share = ".", .plan = true };
    enum wf_status s = wf_calibration_read(path, &j->arena, &j->calibration, &j->diag, &j->err);
    return s ? s : wf_fit_build(&b, &j->arena, &j->diag, &j->x, j->input, &j->err);
}

/* What an analysis of the same tree in a scene made by hand puts in place of the readings. */
static void make_up(struct job *j, const struct wf_scenario *scene)
{
    const double speed[2] = { 7, 9 };
    struct wf_species sp;
    struct wf_model m;
    struct wf_analysis an;
    struct wf_solve_options o;
    struct wf_search search;
    wf_search_default(&search);
    search.speed_max = 60;
    wf_solve_options_default(&o);
    if (wf_species_read("species/moso_bamboo.yaml", &wf_laws, &j->arena, &sp, &j->diag, &j->err) ||
        wf_model_read("models/moso_culm.yaml", &j->arena, &m, &j->diag, &j->err) ||
        wf_analyze(&sp, &m, scene, &search, wf_solvers[0], &o, speed, 2, &j->arena, &j->diag, &an, &j->err))
        fail_msg("%s", j->err.text);
    assert_int_equal(j->x.data, 4);
    for (size_t i = 0; i < j->x.data; i++) {
        double height = j->x.datum[i].sensor ? 14 : 7;
        size_t row = 0;
        while (fabs(an.tree.z1[row] - height) > 1e-9) row++;
        j->x.datum[i].value = an.at[j->x.datum[i].state].response.end[3 * row];
        j->x.datum[i].sigma = 1e-3;
    }
}

/* The modulus that the readings in hand give. */
static double modulus(struct job *j)
{
    struct wf_fit_param *p;
    struct wf_fit_options o;
    struct wf_fit f;
    size_t n;
    wf_fit_options_default(&o);
    o.profile = false;
    if (wf_fit_params(&j->calibration, NULL, &j->x, false, &j->arena, &p, &n, &j->err) ||
        wf_fit_run(&j->x, p, n, &o, &j->arena, &j->diag, &f, &j->err))
        fail_msg("%s", j->err.text);
    assert_int_equal(n, 1);
    return f.estimate[0].value;
}

/* Readings that an analysis gives in `scene`: a fit whose test has these keys finds the tree; one without
 * them is off by a factor between low and high. */
static void comes_back(struct job *j, const char *keys, const struct wf_scenario *scene, double low,
                       double high)
{
    if (build(j, keys)) fail_msg("%s: %s", keys, j->err.text);
    make_up(j, scene);
    double value[4], with = modulus(j);
    for (size_t i = 0; i < 4; i++) value[i] = j->x.datum[i].value;
    assert_close(with, truth, 1e-3);
    if (build(j, "")) fail_msg("%s", j->err.text);
    for (size_t i = 0; i < 4; i++) j->x.datum[i].value = value[i], j->x.datum[i].sigma = 1e-3;
    double share = modulus(j) / truth;
    if (!(low < share && share < high))
        fail_msg("without '%s' the modulus is %g of the true one, not %g to %g", keys, share, low, high);
}

/* 79 495 Pa at 2000 m, 287.053 J/(kg K): 1.0328 kg/m3 at -5 C, 0.8431 of the standard air. */
static void cold_air_of_a_mountain(void **unused)
{
    (void)unused;
    struct job j;
    struct wf_scenario scene;
    begin(&j);
    wf_scenario_default(&scene);
    scene.peak.method = "mean";
    scene.temperature = 268.15, scene.altitude = 2000;
    comes_back(&j, "temperature: -5 degC, altitude: 2000 m", &scene, 1.1, 1.3);
    if (build(&j, "temperature: -5 degC, altitude: 2000 m")) fail_msg("%s", j.err.text);
    assert_close(j.x.test[0].air_density, 79495 / (287.053 * 268.15), 1e-4);
    wf_scenario_default(&scene);
    scene.peak.method = "mean";
    scene.air_density = 0.9;
    comes_back(&j, "air_density: 0.9 kg/m3", &scene, 1.2, 1.5);
    end(&j);
}

/* Drag goes with the density of the air: without weight the same readings belong to a modulus that many times
 * as large, whatever the deflection, because all loads and all stiffnesses go together. */
static void stiffness_goes_with_the_air(void **unused)
{
    (void)unused;
    struct job j;
    double value[4], reading[4], found[2];
    begin(&j);
    for (int k = 0; k < 2; k++) {
        struct wf_fit_param *p;
        size_t n;
        if (build(&j, k ? "" : "temperature: -5 degC, altitude: 2000 m")) fail_msg("%s", j.err.text);
        j.x.tree[0].loads.gravity = 0;
        for (size_t i = 0; i < j.x.tree[0].tree.n; i++) j.x.tree[0].tree.drag[i] = 1;
        if (!k) {
            if (wf_fit_params(&j.calibration, NULL, &j.x, true, &j.arena, &p, &n, &j.err) ||
                wf_fit_expect(&j.x, p, n, &j.arena, reading, NULL, &j.diag, &j.err))
                fail_msg("%s", j.err.text);
            memcpy(value, reading, sizeof value);
        }
        for (size_t i = 0; i < 4; i++) j.x.datum[i].value = value[i], j.x.datum[i].sigma = 1e-3;
        found[k] = modulus(&j);
    }
    assert_close(found[0], truth, 1e-6);
    assert_close(found[1], truth * 1.225 / (79495 / (287.053 * 268.15)), 1e-4);
    end(&j);
}

static void profiles_of_the_wind(void **unused)
{
    (void)unused;
    struct job j;
    struct wf_scenario scene;
    struct wf_measured_profile mast;
    begin(&j);
    wf_scenario_default(&scene);
    scene.peak.method = "mean";
    scene.profile = "canopy";
    scene.canopy_height = 12, scene.displacement = 8.4, scene.roughness = 1.2, scene.attenuation = 3;
    comes_back(&j, "profile: canopy, canopy_height: 12 m, attenuation: 3", &scene, 0.8, 0.96);
    wf_scenario_default(&scene);
    scene.peak.method = "mean";
    scene.profile = "log", scene.reference_height = 20, scene.displacement = 4, scene.roughness = 0.5;
    comes_back(&j, "profile: log, reference_height: 20 m, displacement: 4 m, roughness: 0.5 m", &scene, 1.1,
               2);
    const char *path = wf_arena_print(&j.arena, "%s/mast.csv", j.folder);
    assert_int_equal(wf_measured_read(path, &j.arena, &j.diag, &mast, &j.err), WF_OK);
    wf_scenario_default(&scene);
    scene.peak.method = "mean";
    scene.profile = "measured", scene.measured = &mast, scene.reference_height = 12;
    comes_back(&j, "profile_file: mast.csv, reference_height: 12 m", &scene, 1.2, 1.5);
    if (build(&j, "profile_file: mast.csv")) fail_msg("%s", j.err.text);
    assert_string_equal(j.input[0].profile, path);
    end(&j);
}

/* The wind blows along +x. North of the model is turned by 30 degrees, so on the map it comes from 240
 * degrees: over the ridge at a slant. */
static void exposure_of_the_site(void **unused)
{
    (void)unused;
    struct job j;
    struct wf_scenario scene;
    double across, slant;
    begin(&j);
    wf_scenario_default(&scene);
    scene.peak.method = "mean";
    scene.speed_up = 1.2;
    comes_back(&j, "speed_up: 1.2", &scene, 0.5, 0.95);
    struct wf_site site = { .file = wf_arena_print(&j.arena, "%s/ridge.asc", j.folder), .x = 800, .y = 800 };
    assert_int_equal(wf_site_read(&site, &j.arena, &j.err), WF_OK);
    assert_int_equal(wf_site_speed_up(&site, 270 * M_PI / 180, 10, 0.03, &across, &j.err), WF_OK);
    assert_int_equal(wf_site_speed_up(&site, 240 * M_PI / 180, 10, 0.03, &slant, &j.err), WF_OK);
    assert_true(across > slant + 0.02 && slant > 1.05);
    scene.speed_up = across;
    comes_back(&j, "dem: ridge.asc, at: \"800,800\"", &scene, 0.5, 0.95);
    scene.speed_up = slant;
    comes_back(&j, "dem: ridge.asc, at: [800, 800], north: 30 deg", &scene, 0.5, 0.97);
    assert_null(j.input[0].profile);
    if (build(&j, "dem: ridge.asc, at: \"800,800\"")) fail_msg("%s", j.err.text);
    assert_string_equal(j.input[0].ground, site.file);
    end(&j);
}

static void places_of_mistakes(void **unused)
{
    (void)unused;
    static const struct {
        const char *wind, *words[2];
    } bad[] = {
        { "temperature: -5", { "8:49: tests[0].wind.temperature: '-5' has no unit" } },
        { "temperature: -80 degC", { "8:49: tests[0].wind.temperature: -80 degC is outside -60 degC" } },
        { "altitude: 9500 m", { "8:46: tests[0].wind.altitude: 9500 m is outside" } },
        { "air_density: 3 kg/m3", { "8:49: tests[0].wind.air_density: 3 kg/m3 is outside" } },
        { "profile: canopi", { "8:45: tests[0].wind.profile: 'canopi' is not one of", "mean 'canopy'" } },
        { "profile: canopy", { "8:45: tests[0].wind.profile: the canopy profile needs the canopy height" } },
        { "profile: log, displacement: 12 m", { "8:45: tests[0].wind.profile: reference height 10 m" } },
        { "profile: measured", { "8:45: tests[0].wind.profile: the profile 'measured' needs" } },
        { "profile: log, profile_file: mast.csv", { "8:45: ", "is for the profile 'measured'" } },
        { "profile_file: none.csv", { "8:50: tests[0].wind.profile_file: ", "cannot be read" } },
        { "profile_file: words.csv", { "3:3: speed_ms: 'x' is not a number", "8:50: " } },
        { "profile_file: calm.csv",
          { "8:50: tests[0].wind.profile_file: the measured profile has speed 0" } },
        { "speed_up: 9", { "8:46: tests[0].wind.speed_up: 9 is outside" } },
        { "speed_up: 2, dem: ridge.asc, at: \"1,2\"",
          { "8:54: tests[0].wind.dem: give one of 'speed_up' and 'dem', not both" } },
        { "dem: ridge.asc", { "8:41: tests[0].wind.dem: needs 'at'" } },
        { "dem: none.asc, at: \"1,2\"", { "8:41: tests[0].wind.dem: ", "cannot be read" } },
        { "dem: mast.csv, at: \"1,2\"", { "8:41: tests[0].wind.dem: ", "mast.csv:1:1: error" } },
        { "dem: ridge.asc, at: \"1,9000\"", { "8:41: tests[0].wind.dem: ", "outside the map" } },
        { "dem: ridge.asc, at: 800", { "8:56: tests[0].wind.at: '800'", "x,y" } },
        { "at: \"1,2\"", { "8:40: tests[0].wind.at: ", "needs 'dem', the heights of the ground" } },
        { "north: 20 deg", { "8:43: tests[0].wind.north: applies only with 'dem'" } },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct job j;
        char all[4000];
        begin(&j);
        assert_int_equal(build(&j, bad[i].wind), WF_EINPUT);
        findings_print(&j.diag, all, sizeof all);
        for (int k = 0; k < 2; k++)
            if (bad[i].words[k] && !strstr(all, bad[i].words[k]))
                fail_msg("'%s' is told as\n%s\nwithout '%s'", bad[i].wind, all, bad[i].words[k]);
        end(&j);
    }
}

/* Names of the profiles are a list beside their rows. */
static void profiles_have_names(void **unused)
{
    (void)unused;
    size_t k = 0;
    for (; wf_profiles[k].name; k++) assert_string_equal(wf_profile_names[k], wf_profiles[k].name);
    assert_null(wf_profile_names[k]);
}

/* Every file that took part is in the results, with its hash; what is made up in a scene is found again. */
static void files_of_a_scene(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { "printf 'height_m,speed_ms\\n2,3\\n5,4\\n20,7\\n' > $T/mast.csv\n"
          "$W terrain --size 5 -q --no-plots -o $T/ground && cp $T/ground/tables/height.asc $T/hill.asc\n"
          "cat >$T/s.yaml <<'END'\nfit: s\nname: s\ntrees:\n"
          "  - {name: culm, species: moso_bamboo, model: moso_culm}\ntests:\n"
          "  - name: gusts\n    time: t_s\n"
          "    wind: {column: wind_m_s, speeds: [8 m/s, 10 m/s], profile_file: mast.csv, altitude: 1500 m,\n"
          "      dem: hill.asc, at: \"300,300\"}\n"
          "    sensors: [{name: top, kind: deflection, height: 14 m, column: top_m, sigma_share: 0.01}]\n"
          "free: [{parameter: level0.youngs_modulus, start: 6 GPa}]\nEND\n"
          "$W simulate-test $T/s.yaml -q -o $T/m && $W fit $T/s.yaml --data $T/m/gusts.csv -q --no-report "
          "--no-rival -o $T/o && cat $T/o/results.json && sha256sum $T/mast.csv",
          CODE_OK,
          { "\"role\": \"profile\"", "\"role\": \"ground\"", "hill.asc\"", "mast.csv\"" } },
    };
    CHECK(rows);
    char *own = strrchr(output, '\n');
    while (own > output && (*own == '\n' || own[-1] != '\n')) own--;
    own[64] = '\0';
    if (strstr(output, own) == own) fail_msg("the profile's hash %s is not in the results", own);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cold_air_of_a_mountain), cmocka_unit_test(stiffness_goes_with_the_air),
        cmocka_unit_test(profiles_of_the_wind),   cmocka_unit_test(exposure_of_the_site),
        cmocka_unit_test(places_of_mistakes),     cmocka_unit_test(profiles_have_names),
        cmocka_unit_test(files_of_a_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
