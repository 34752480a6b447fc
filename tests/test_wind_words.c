/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Winds as they are typed: averaging times, grades, gusts of the peak load, trees in stands. */
#include "close.h"
#include "shell.h"

#define A "$W analyze oak --model oak_20m --samples 0 --no-report -o $T/w "

static void test_words(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { A "--wind gust:mean:20", CODE_INPUT, { "'mean:20': one word of an averaging time" } },
        { A "--wind gust:beaufort:8", CODE_INPUT, { "'beaufort:8': a grade has its averaging time" } },
        { A "--wind gust:30,gust:36", CODE_INPUT, { "'gust:36': the word stands once, before the first" } },
        { A "--wind 20,hourly:36", CODE_INPUT, { "'hourly:36': the word stands once" } },
        { A "--wind gust:20,beaufort:8", CODE_INPUT, { "'beaufort:8': a grade has its averaging time" } },
        { A "--wind 20,beaufort:8 --averaging-time 3s",
          CODE_OK,
          { "3-s gusts of 20 m/s at 10 m", "10-min means of 13.13 m/s", "taken as 19.0 m/s" } },
        { A "--design en1991 --basic-wind 25 --averaging-time 3s",
          CODE_INPUT,
          { "--averaging-time: has no effect on grades of a scale and design winds" } },
        { A "--design en1991 --basic-wind 25 --return-period 100",
          CODE_OK,
          { "basic wind 25.96 m/s (once in 100 years; from 25 m/s, 10-min mean" } },
        { A "--design asnzs1170 --region A2 --return-period 500 --terrain TC3",
          CODE_OK,
          { "regional gust at 10 m over TC2 of region A2, once in 500 years" } },
        { "$W analyze oak --model oak_20m --samples 0 --no-pdf --lang zh -q -o $T/z --wind gust:36 && grep "
          "-o "
          "'3 s 阵风 36 m.s（[^：]*' $T/z/report.html",
          CODE_OK,
          { "3 s 阵风 36 m/s（换算为 10 min 平均 23.63 m/s" } },
        { "$W analyze oak --model oak_20m --samples 24 --no-pdf -o $T/z --wind 20 --snow 5cm --winter-wind "
          "0.5 && grep -o "
          "'95 % of 24 samples: above 60 .*mean wind (3-s gust 91 ' $T/z/report.html; grep -o 'Only 0.5.* of "
          "these winds "
          "acts' $T/z/report.html",
          CODE_OK,
          { "the stem is lost above 60 m/s mean in more than 95 % of 24 samples; 3-s gust above 91.41",
            "(3-s gust 91 ", "of these winds acts" } },
        { A "--wind 20 --spacing 3", CODE_INPUT, { "--spacing has no effect with --peak en1991" } },
        { A "--design sia261 --basic-pressure 0.9 --site in-stand --spacing 3",
          CODE_INPUT,
          { "--spacing has no effect with --peak en1991" } },
    };
    CHECK(rows);
}

/* A gust that is named is the gust at the peak, however it was converted: 1/2 rho 36^2 in each. */
static void test_gusts(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { A "--peak gust --wind gust:36", CODE_OK, { "620.360 " } },
        { A "--peak gust --wind gust:36 --gust-factor 1.7", CODE_OK, { "620.360 " } },
        { A "--peak gust --wind gust:36 --averaging in-land", CODE_OK, { "620.360 " } },
    };
    CHECK(rows);
}

/* The edge of a stand is not its inside; bare trees meet wind in it. */
static void test_stands(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { A "--wind 20 --spacing 6 --site forest-edge", CODE_OK, { "6 m spacing, 0 m behind its edge" } },
        { A "--wind 20 --spacing 3 --site in-stand", CODE_OK, { "[stand-crowded]" } },
        { A "--wind 20 --spacing 6 --site in-stand", CODE_OK, { "6 m spacing, well inside" } },
        { "$W analyze oak --tree docs/examples/scan.csv --wind 40 --spacing 4 --site in-stand --samples 0 "
          "--no-report -o $T/w && awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i } NR == 2 { print "
          "($c[\"mean_tip_deflection_m\"] > 0.001 ? \"moves\" : \"stands still\") }' $T/w/tables/summary.csv",
          CODE_OK,
          { "moves" } },
    };
    CHECK(rows);
}

/* Where the evidence of a crown's law ends is said though the species table does not say it; so is that the
 * day of a scan is assumed. */
static void test_evidence(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "sed 's/, valid_from: 10 m.s, valid_to: 20 m.s//' species/oak.yaml >$T/oak.yaml; $W analyze "
          "$T/oak.yaml --model "
          "oak_20m --samples 0 --no-report -o $T/w --wind 30",
          CODE_OK,
          { "the evidence for its streamlining law 'vogel' ends at 20 m/s" } },
        { "$W analyze oak --tree docs/examples/scan.csv --leaf-area 20 --wind 10 --samples 0 --no-report -o "
          "$T/w",
          CODE_OK,
          { "[scan-season]" } },
        { "! $W analyze oak --tree docs/examples/scan.csv --leaf-area 20 --scanned leaf_off --wind 10 "
          "--samples 0 "
          "--no-report -o $T/w 2>&1 | grep scan-season && echo none",
          CODE_OK,
          { "none" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_gusts),
        cmocka_unit_test(test_stands),
        cmocka_unit_test(test_evidence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
