/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Other units of pages and of the terminal: number and unit are turned together, or neither. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "base/arena.h"
#include "base/units.h"
#include "out/page_units.h"
#include "shell.h"
#include <math.h>

static void check_text(const char *system, const char *text, const char *want)
{
    struct wf_arena a = { 0 };
    const char *is = wf_page_units_turned(system, text, NULL, &a);
    assert_non_null(is);
    if (strcmp(is, want) != 0) fail_msg("'%s' became '%s', not '%s'", text, is, want);
    wf_arena_free(&a);
}

#define MARKED(full, shown) WF_MARK full WF_MARK_SHOWN shown WF_MARK_END

static void numbers_are_turned_with_their_units(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "at 20 m/s", "at 45 mph" },
        { "10 m over terrain II", "33 ft over terrain II" },
        { "a girth of 250\xc2\xa0"
          "cm.",
          "a girth of 98.4\xc2\xa0"
          "in." },
        { "60 m/\xe2\x81\xa0s (3-s gust 91.4 m/s)", "134 mph (3-s gust 204 mph)" },
        { "416.7 kN m on the ground", "307.3 kip·ft on the ground" },
        { "32.9 kN m/m3 x d^2", "0.687 kip/ft2 x d^2" },
        { "1,133 kg, 12.0 MPa and 8.3 GPa", "2,498 lb, 1,740 psi and 1,200 ksi" },
        { "id 2, order 0, 812 mm thick", "id 2, order 0, 32.0 in thick" },
        { "13 to 35 m/s", "29 to 78 mph" },
        { "40 to above 60 m/s", "89 to above 134 mph" },
        { "mostly 4-20 m/s", "mostly 9-45 mph" },
        { "between 15 and 41 m/s", "between 34 and 92 mph" },
        { "EN 1991-1-4, 25.2 m/s", "EN 1991-1-4, 56.4 mph" },
        { "1.133e+04 kg", "24,980 lb" },
        { "17.8816 m/s", "40.00 mph" },
        { "−3.0 m", "−9.8 ft" },
        { MARKED("24.96", "25.0") " m/s", "55.8 mph" },
        { MARKED("24.96", "25") WF_MARK_NODE " m/s", "56" WF_MARK_NODE " mph" },
        { MARKED("10", "10") WF_MARK_LIST ", " MARKED("15", "15") WF_MARK_LIST
          " and " MARKED("25", "25") " m/s",
          "22, 34 and 56 mph" },
        { WF_AS_TYPED "40 m/s" WF_AS_TYPED_END " at 10 m", "40 m/s at 33 ft" },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) check_text("imperial", rows[i][0], rows[i][1]);
}

/* Where it is not sure which numbers a unit is for, all of them keep it. */
static void what_is_not_sure_stays(void **state)
{
    (void)state;
    static const char *const stays[] = {
        "in 2016, 25 m/s",
        "15, 20 and 25 m/s",
        "safety 2 and 20 m/s",
        "section 4, 812 mm thick",
        "9.81 m/s²",
        "1.5 m s⁻¹",
        "3 kg m2",
        "2 N s",
        "a 10-min mean, 3-s gusts",
        "4 × 3 m",
        "Table 3 mentions it",
        "Forests 14:533, 42 trees",
        "2026-11-29 14:43:36 UTC",
        "m/s and kN m",
        "1/3 m",
        "12 %",
    };
    for (size_t i = 0; i < sizeof stays / sizeof *stays; i++) check_text("imperial", stays[i], stays[i]);
    check_text("imperial", MARKED("1.9", "1.90") " × 3 m", "1.90 × 3 m");
    check_text("imperial", MARKED("1.9", "1.90") " and " MARKED("3", "3") " m", "1.90 and 3 m");
}

static void other_systems(void **state)
{
    (void)state;
    check_text("metric", MARKED("24.96", "25.0") " m/s", "25.0 m/s");
    check_text("cn", "417 kN m, 8.3 GPa; 796 mm", "417 kN·m, 8,300 MPa; 79.6 cm");
    check_text("cn", "25 m/s at 10 m", "25 m/s at 10 m");
}

/* Every factor against UDUNITS. */
static void factors_are_right(void **state)
{
    (void)state;
    static const struct {
        const char *to, *udunits;
        enum wf_dimension d;
    } known[] = {
        { "mph", "mile/hour", WF_DIM_SPEED },
        { "ft", "foot", WF_DIM_LENGTH },
        { "in", "inch", WF_DIM_LENGTH },
        { "mi", "mile", WF_DIM_LENGTH },
        { "ft²", "foot2", WF_DIM_AREA },
        { "ft2", "foot2", WF_DIM_AREA },
        { "lb", "pound", WF_DIM_MASS },
        { "lb/ft³", "pound/foot3", WF_DIM_DENSITY },
        { "lb/ft3", "pound/foot3", WF_DIM_DENSITY },
        { "lb/ft²", "pound/foot2", WF_DIM_MASS_PER_AREA },
        { "lb/ft2", "pound/foot2", WF_DIM_MASS_PER_AREA },
        { "lbf", "lbf", WF_DIM_FORCE },
        { "lbf·ft", "lbf foot", WF_DIM_MOMENT },
        { "kip·ft", "klbf foot", WF_DIM_MOMENT },
        { "psi", "lbf/inch2", WF_DIM_PRESSURE },
        { "ksi", "klbf/inch2", WF_DIM_PRESSURE },
        { "lbf/ft²", "lbf/foot2", WF_DIM_PRESSURE },
        { "kip/ft2", "klbf/foot2", WF_DIM_PRESSURE },
    };
    static const struct {
        const char *shown, *udunits;
    } plain[] = { { "m²", "m2" }, { "kg/m³", "kg/m3" }, { "kg/m²", "kg/m2" }, { "kN m/m3", "kPa" } };
    struct wf_units *u;
    struct wf_err e = { 0 };
    const struct wf_page_unit *row;
    size_t checked = 0;
    assert_int_equal(wf_units_open(&u, &e), WF_OK);
    for (size_t i = 0; (row = wf_page_unit_row("imperial", i))->from; i++)
        for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
            char from[60], to[60];
            double a, b;
            if (strcmp(known[k].to, row->to) != 0) continue;
            snprintf(from, sizeof from, "1 %s", row->from);
            for (size_t p = 0; p < sizeof plain / sizeof *plain; p++)
                if (!strcmp(plain[p].shown, row->from)) snprintf(from, sizeof from, "1 %s", plain[p].udunits);
            snprintf(to, sizeof to, "%.17g %s", row->factor, known[k].udunits);
            if (wf_quantity_read(u, from, known[k].d, &a, &e) || wf_quantity_read(u, to, known[k].d, &b, &e))
                fail_msg("%s", e.text);
            if (fabs(a - b) > 1e-12 * a) fail_msg("%s: %.17g, not %.17g", row->from, b, a);
            checked++;
        }
    wf_units_close(u);
    assert_true(checked >= 22);
}

/* The page: columns and rows as a whole, winds and heights by the results; results.json and tables as ever.
 */
static void a_page_in_other_units(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W assess models/cards/oak.yaml --title '30 m/s and 5 m' --samples 0 --no-pdf -q -o $T/m "
          ">$T/m.txt 2>&1; "
          "$W assess models/cards/oak.yaml --title '30 m/s and 5 m' --samples 0 --no-pdf -q -o $T/i --units "
          "imperial "
          ">$T/i.txt 2>&1; "
          "$W assess models/cards/oak.yaml --title '30 m/s and 5 m' --samples 0 --no-pdf -q -o $T/c --units "
          "cn >/dev/null 2>&1; "
          "cmp $T/m/tables/summary.csv $T/i/tables/summary.csv && cmp $T/m/tables/sweep.csv "
          "$T/c/tables/sweep.csv && "
          "python3 tests/page_units.py $T/m $T/i $T/c",
          CODE_OK,
          { "units: " } },
        { "$W assess models/cards/oak.yaml --samples 0 --no-report -o $T/i --units imperial 2>&1",
          CODE_OK,
          { "  height 66 ft; crown from the side 1,893 ft2", "33 ft over terrain II", " mph mean (",
            "2,498 lb" } },
        { "$W assess models/cards/oak.yaml --samples 0 --no-report -o $T/i --units imperal",
          CODE_INPUT,
          { "'imperal'", "imperial" } },
    };
    CHECK(rows);
}

/* A run in metric and in imperial units: its figures are the same, with other numbers at the axes. */
#define BOTH(command)                                                                                        \
    "for u in metric imperial; do $W " command " --units $u --no-pdf -q -o $T/$u >/dev/null 2>&1; done; "    \
    "python3 tests/figure_units.py $T/imperial labels; python3 tests/figure_units.py $T/metric $T/imperial "

static void figures_of_every_kind(void **state)
{
    (void)state;
    if (shell("command -v gnuplot")) skip();
    static const struct row rows[] = {
        { BOTH("series oak --model culm --wind 8 --duration 4 --step 0.5 --gust cosine --no-vtk --keys 2")
          "same frames_1; grep -c '18.1 mph' $T/imperial/plots/frames_1.svg",
          CODE_OK,
          { "labels looked at\nframes_1: same lines, other numbers\n1\n" } },
        { BOTH("modes oak --model culm --wind 10") "same modes_1",
          CODE_OK,
          { "labels looked at\nmodes_1: same lines, other numbers\n" } },
        { BOTH("wind extremes --annual docs/examples/annual.csv --wind 20") "factor extremes",
          CODE_OK,
          { "labels looked at\nextremes: times 2.24\n" } },
        { BOTH("rain --staged --duration 2") "same rain_scene_1; python3 tests/figure_units.py $T/metric "
                                             "$T/imperial factor rain_ring_1",
          CODE_OK,
          { "labels looked at\nrain_scene_1: same lines, other numbers\nrain_ring_1: times 0.039" } },
        { BOTH("terrain --size 4 --relief 20") "factor", CODE_OK, { "labels looked at\n" } },
        { BOTH("wind kaimal --duration 60 --points 3") "factor", CODE_OK, { "labels looked at\n" } },
        { BOTH("fit models/field/sample_pull.yaml --no-rival") "factor", CODE_OK, { "labels looked at\n" } },
        { BOTH("shelter --model scots_pine --species scots_pine --slabs 4 --cells 16") "factor",
          CODE_OK,
          { "labels looked at\n" } },
        /* drawn again in metric units, nothing is left of the others */
        { "$W wind extremes --annual docs/examples/annual.csv --units imperial --lang zh --no-pdf -q -o $T/a "
          ">/dev/null 2>&1; $W report $T/a --no-pdf >/dev/null; $W wind extremes --annual "
          "docs/examples/annual.csv --no-pdf -q -o $T/b >/dev/null 2>&1; cmp $T/a/plots/extremes.svg "
          "$T/b/plots/extremes.svg && cmp $T/a/plots/run.csv $T/b/plots/run.csv && echo same",
          CODE_OK,
          { "same\n" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(figures_of_every_kind),
        cmocka_unit_test(numbers_are_turned_with_their_units),
        cmocka_unit_test(what_is_not_sure_stays),
        cmocka_unit_test(other_systems),
        cmocka_unit_test(factors_are_right),
        cmocka_unit_test(a_page_in_other_units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
