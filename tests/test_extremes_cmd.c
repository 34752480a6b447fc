/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm wind extremes: annual maxima from tables and records, what is printed, written and refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

#define X "$W wind extremes --no-plots -o $T/out "
/* Six years of hours at noon of every day; the largest wind of year y is y - 1990 + 20 m/s, on 15 January. */
#define RECORD(first, last)                                                                                  \
    "awk 'BEGIN { print \"time,speed_ms\"; for (y = " first "; y <= " last                                   \
    "; y++) for (m = 1; m <= 12; m++)"                                                                       \
    " for (d = 1; d <= 28; d++) printf \"%d-%02d-%02dT12:00,%g\\n\", y, m, d, "                              \
    "m == 1 && d == 15 ? y - 1970 : 3 + (7 * m + 3 * d) % 5 }' >$T/r.csv; "

/* By hand: maxima 20 to 25 m/s; on the speed, L-moments: l1 = 22.5, l2 = 7/6, scale = l2 / ln 2 = 1.68314,
 * mode = 21.5285; once in 50 years mode + 3.90194 scale = 28.096. */
static void by_hand(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "printf 'speed_ms\\n20\\n21\\n22\\n23\\n24\\n25\\n' >$T/a.csv; " X
          "--annual $T/a.csv --on speed --method l-moments --periods 50 --wind 28.0961 >$T/p; cat $T/p",
          CODE_OK,
          { "28.10", "50", "0.02" } },
        /* the same in km/h and as hourly means: times 1.0504 by Durst */
        { "printf 'Year;Wind (km/h)\\n2001;72\\n2002;75,6\\n2003;79,2\\n2004;82,8\\n2005;86,4\\n2006;90\\n' "
          ">$T/a.csv; " X "--annual $T/a.csv --column wind_kmh --on speed --method l-moments --periods 50 "
          "--averaging-time 1h",
          CODE_OK,
          { "29.51", "1.05", "few-years" } },
        { RECORD("1990", "1995") X "--record $T/r.csv --on speed --method l-moments --periods 50",
          CODE_OK,
          { "6 years", "28.10" } },
        /* years that begin in July: the first and last are half years */
        { RECORD("1990", "1996") X
          "--record $T/r.csv --year-begins 7 --on speed --method l-moments --periods 50; cat "
          "$T/out/tables/annual.csv",
          CODE_OK,
          { "year-short", "2 years", "1,21" } },
    };
    CHECK(rows);
}

static void climates(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { X "--weibull-scale 5 --periods 10,50 --wind 'hourly:20.43 m/s'",
          CODE_OK,
          { "10-min mean", "21.45" } },
        { X "--dams 15", CODE_OK, { "DAMS 15", "A 5.456" } },
        { X "--weibull-scale 5 --weibull-shape 2.5", CODE_OK, { "weibull-shape" } },
        { X "--annual docs/examples/annual.csv --wind 20,60; cat $T/out/results.json",
          CODE_OK,
          { "< 1e-6", "> 1e6 years", "windfirm-extremes" } },
    };
    CHECK(rows);
}

static void the_storm_of_a_short_year_is_said(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { RECORD("1990", "1996") "echo 1997-01-15T12:00,40 >>$T/r.csv; " X "--record $T/r.csv",
          CODE_OK,
          { "storm-left-out", "40.0 m/s" } },
    };
    CHECK(rows);
}

static void mistakes_are_named(void **state)
{
    (void)state;
    static const struct row rows[] = {
        /* a folder of that name is no subcommand */
        { "W=$(realpath $W); cd $T && $W wind kaimal --duration 20s --no-plots -o extremes && ls extremes",
          CODE_OK,
          { "results.json" } },
        { X, CODE_INPUT, { "one of --annual, --record, --weibull-scale and --dams is needed" } },
        { X "--annual docs/examples/annual.csv --dams 12", CODE_INPUT, { "only one of" } },
        { X "--annual none.csv", CODE_INPUT, { "none.csv" } },
        { "printf 'year,speed_ms\\n2001,20\\n2001,21\\n2003,x\\n2004,-3\\n' >$T/a.csv; " X
          "--annual $T/a.csv",
          CODE_INPUT,
          { "a.csv:3:1: error: year: year 2001 is there already", "a.csv:4:6", "a.csv:5:6" } },
        { "printf 'year,speed_ms\\n2001,20\\n2002,21\\n' >$T/a.csv; " X "--annual $T/a.csv",
          CODE_INPUT,
          { "2 annual maxima" } },
        { "printf 'year,speed_ms\\n1,20\\n2,20\\n3,20\\n4,20\\n5,20\\n' >$T/a.csv; " X "--annual $T/a.csv",
          CODE_INPUT,
          { "too much alike" } },
        { "printf 'year,speed\\n1,20\\n' >$T/a.csv; " X "--annual $T/a.csv", CODE_INPUT, { "speed_ms" } },
        { "printf 'time,speed_ms\\n0,20\\n3600,21\\n' >$T/a.csv; " X "--record $T/a.csv",
          CODE_INPUT,
          { "not dates" } },
        { X "--dams 15 --method gev", CODE_INPUT, { "has no effect without --annual or --record" } },
        { X "--dams 15 --periods 1", CODE_INPUT, { "return periods are above 1" } },
        { X "--dams 15 --periods 50,10", CODE_INPUT, { "ascend" } },
        { X "--dams 15 --periods x", CODE_INPUT, { "'x'" } },
        { X "--annual docs/examples/annual.csv --year-begins 7", CODE_INPUT, { "without --record" } },
        { X "--weibull-scale 5 --weibull-shape 4", CODE_INPUT, { "1.2..3.5" } },
    };
    CHECK(rows);
}

static void pages_are_drawn(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W wind extremes --annual docs/examples/annual.csv --wind 20 -o $T/out && $W report $T/out --lang "
          "zh && grep -c "
          "'50 年一遇' $T/out/extremes.html",
          CODE_OK,
          { "图与页面" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_hand),
        cmocka_unit_test(climates),
        cmocka_unit_test(the_storm_of_a_short_year_is_said),
        cmocka_unit_test(mistakes_are_named),
        cmocka_unit_test(pages_are_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
