/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program as a user meets it: what it prints and its exit code, above all for bad input. */
#include "close.h"
#include "shell.h"

static void test_usage(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W", CODE_INPUT, { "Usage: windfirm COMMAND" } },
        { "$W --help", CODE_OK, { "analyze", "validate" } },
        { "$W --version", CODE_OK, { "windfirm " } },
        { "$W version", CODE_OK, { "windfirm " } },
        { "$W analyze --help", CODE_OK, { "--reference-height LENGTH", "(0.01..1000 m) [10 m]", "beam" } },
        { "$W help compare", CODE_OK, { "Usage: windfirm compare" } },
        { "$W analyse", CODE_INPUT, { "did you mean 'analyze'?" } },
        { "$W qqqqqq", CODE_INPUT, { "unknown command 'qqqqqq'" } },
        { "$W analyze species/moso_bamboo.yaml $RUN --wnd 3",
          CODE_INPUT,
          { "'--wnd'; did you mean '--wind'?" } },
        { "$W analyze species/moso_bamboo.yaml", CODE_INPUT, { "--model is needed" } },
        { "$W analyze species/moso_bamboo.yaml $M", CODE_INPUT, { "--wind is needed" } },
        { "$W analyze $RUN", CODE_INPUT, { "1 argument is needed, 0 given" } },
        { "$W analyze a b $RUN", CODE_INPUT, { "'b' is too many" } },
        { "$W compare species/moso_bamboo.yaml $RUN", CODE_INPUT, { "2 arguments are needed, 1 given" } },
        { "$W analyze species/moso_bamboo.yaml $RUN --solver", CODE_INPUT, { "--solver: needs a value" } },
        { "$W analyze species/moso_bamboo.yaml --wind --model models/culm.yaml",
          CODE_INPUT,
          { "--wind: needs a value" } },
        { "$W analyze species/moso_bamboo.yaml $RUN --wind 5", CODE_INPUT, { "--wind: given twice" } },
        { "$W analyze species/moso_bamboo.yaml $RUN --quiet=yes", CODE_INPUT, { "--quiet: takes no value" } },
        { "$W analyze species/moso_bamboo.yaml $RUN --solver bem --profile lgo",
          CODE_INPUT,
          { "'bem' is none of beam, ", "did you mean 'beam'?", "did you mean 'log'?" } },
        { "$W analyze species/moso_bamboo.yaml $RUN --altitude 1kg --exponent 2",
          CODE_INPUT,
          { "--altitude: ", "--exponent: 2 is outside 0..1" } },
        { "$W species lst", CODE_INPUT, { "did you mean 'list'?" } },
        { "$W species list >/dev/full", CODE_RUN, { "standard output: No space left on device" } },
        { "$W --version >/dev/full", CODE_RUN, { "standard output: No space left on device" } },
        { "$W --help >/dev/full", CODE_RUN, { "standard output: No space left on device" } },
        { "$W --version >&-", CODE_RUN, { "standard output: is closed" } },
        /* the results file must not become what is printed to */
        { "$W analyze oak $RUN >&-; echo $?; head -c 1 $T/out/results.json",
          CODE_OK,
          { "standard output: is closed\n1\n{" } },
        { "$W analyze oak $RUN <&- >&- 2>&-; echo $?; head -c 1 $T/out/results.json; grep -c 'windfirm:' "
          "$T/out/results.json $T/out/tables/*.csv",
          CODE_RUN,
          { "1\n{", "results.json:0" } },
        { "UDUNITS2_XML_PATH=/nowhere $W species show oak", CODE_RUN, { "UDUNITS2_XML_PATH is '/nowhere'" } },
        { "echo '<a>' >$T/u.xml; UDUNITS2_XML_PATH=$T/u.xml $W species show oak",
          CODE_RUN,
          { "is damaged" } },
#ifndef __SANITIZE_ADDRESS__ /* its own memory is above any limit */
        { "sed 's/segments: 40/segments: 20000/' models/culm.yaml >$T/long.yaml; ulimit -d 130000; "
          "$W analyze oak --model $T/long.yaml --wind 10 --no-report -q -o $T/long",
          CODE_RUN,
          { "20001 segments at 1 wind speed need about 0.32 GB of memory" } },
#endif
    };
    CHECK(rows);
}

static void test_wind(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze moso_bamboo $M --no-report -o $T/out --wind 36km/h", CODE_OK, { "        10 " } },
        { "$W analyze oak $M --no-report -o $T/out --wind beaufort:8",
          CODE_OK,
          { "        19 ", "gale, 17.2 to 20.8 m/s", "taken as 19.0 m/s" } },
        { "$W analyze oak $M --no-report -o $T/out --wind beaufort:8,30",
          CODE_OK,
          { "        19 ", "        30 " } },
        { "$W analyze oak $M --wind beaufort:99", CODE_INPUT, { "--wind: unknown grade '99'" } },
        { "$W analyze oak $M --wind beufort:8", CODE_INPUT, { "did you mean 'beaufort'?" } },
        { "$W analyze moso_bamboo $M --no-report -o $T/out --wind '18:36:18 km/h'",
          CODE_OK,
          { "         5 ", "        10 " } },
        { "$W analyze moso_bamboo $M --no-report -o $T/out --wind '18, 36 km/h'",
          CODE_OK,
          { "         5 ", "        10 " } },
        { "$W analyze moso_bamboo $M --wind abc", CODE_INPUT, { "--wind: " } },
        { "$W analyze moso_bamboo $M --wind ''", CODE_INPUT, { "--wind: needs a value" } },
        { "$W analyze moso_bamboo $M --wind ,", CODE_INPUT, { "--wind: no wind speed is given" } },
        { "$W analyze moso_bamboo $M --wind nan", CODE_INPUT, { "--wind: " } },
        { "$W analyze moso_bamboo $M --wind 1e999", CODE_INPUT, { "--wind: " } },
        { "$W analyze moso_bamboo $M --wind -5,300",
          CODE_INPUT,
          { "-5 is outside 0..200 m/s", "300 is outside 0..200 m/s" } },
        { "$W analyze moso_bamboo $M --wind 10kg", CODE_INPUT, { "--wind: " } },
        { "$W analyze moso_bamboo $M --wind 10km/h,20",
          CODE_INPUT,
          { "write the unit behind the last number" } },
        { "$W analyze moso_bamboo $M --wind 5:40", CODE_INPUT, { "a range is written from:to:step" } },
        { "$W analyze moso_bamboo $M --wind 40:5:1", CODE_INPUT, { "from the lower to the higher" } },
        { "$W analyze moso_bamboo $M --wind 5:40:0", CODE_INPUT, { "--wind: 0 is outside" } },
        { "$W analyze moso_bamboo $M --wind 0:200:0.001", CODE_INPUT, { "more than 1000 wind speeds" } },
        { "$W analyze moso_bamboo $RUN --profile log --reference-height 5 --displacement 6",
          CODE_INPUT,
          { "reference height 5 m lies within the calm layer" } },
        /* the shape about which a tree sways is tried before load steps, which took 310 iterations */
        { "$W analyze moso_bamboo --model moso_branched --wind 13 --samples 0 --no-report -q -o $T/out; "
          "python3 -c "
          "\"import json; w = json.load(open('$T/out/results.json'))['trees'][0]['winds'][0]; "
          "print(w['iterations'] < 100, w['status'])\"",
          CODE_OK,
          { "True ok" } },
    };
    CHECK(rows);
}

/* A count or a seed that is not whole is refused by every command; none is cut. */
static void test_counts(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak $RUN --threads 1.5", CODE_INPUT, { "--threads: 1.5 is not a whole number" } },
        { "$W series oak $M --keys 2.5 --seed 0.1",
          CODE_INPUT,
          { "--keys: 2.5 is not a whole number", "--seed: 0.1 is not a whole number" } },
        { "$W wind kaimal --points 2.5 --seed 1.5",
          CODE_INPUT,
          { "--points: 2.5 is not a whole number", "--seed: 1.5 is not a whole number" } },
        { "$W shelter -m culm -s oak --slabs 4.5 --cells 32.5 --gap 1.5",
          CODE_INPUT,
          { "--slabs: 4.5 is not a whole number", "--cells: 32.5 is not a whole number",
            "--gap: 1.5 is not a whole number" } },
        { "$W terrain --size 2.5 --seed 0.5",
          CODE_INPUT,
          { "--size: 2.5 is not a whole number", "--seed: 0.5 is not a whole number" } },
    };
    CHECK(rows);
}

/* Every command records its command line with quotes where a shell needs them: pasted, it runs again. */
/* Steps of a search that are solved by several threads share nothing: the same bytes, every time. */
static void test_threads(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "A='analyze oak --model culm --wind 10 --ice 60mm --samples 0 --no-report -q'; $W $A --threads 1 "
          "-o "
          "$T/one || exit 1; for i in 1 2 3 4 5 6 7 8; do $W $A --threads 8 -o $T/many || exit 1; for f in "
          "summary segments sweep; do cmp $T/one/tables/$f.csv $T/many/tables/$f.csv || exit 1; done; done",
          CODE_OK,
          { NULL } },
    };
    CHECK(rows);
}

static void test_recorded_line(void **state)
{
    (void)state;
#define LINE "; grep -o '\"command\": .*' \"$F/results.json\""
    static const struct row rows[] = {
        { "F=\"$T/it's\"; $W analyze oak $M --wind '10 m/s' --no-report -q -o \"$F\"" LINE,
          CODE_OK,
          { "--wind '10 m/s' --no-report -q -o '", ".scratch/it'\\\\''s'\"" } },
        { "F=\"$T/a b\"; $W explain oak $M --wind '10 m/s' --no-report -q -o \"$F\"" LINE,
          CODE_OK,
          { "--wind '10 m/s' --no-report -q -o '", ".scratch/a b'\"" } },
        { "F=\"$T/a;b\"; $W series oak $M --duration '2 s' --no-report --no-vtk -q -o \"$F\"" LINE,
          CODE_OK,
          { "--duration '2 s' --no-report", ".scratch/a;b'\"" } },
        { "F=\"$T/a(b\"; $W wind kaimal --duration '60 s' --no-plots -q -o \"$F\"" LINE,
          CODE_OK,
          { "--duration '60 s' --no-plots", ".scratch/a(b'\"" } },
        { "F=\"$T/a\\\\b\"; $W fit $S --no-profile --no-rival --no-report -q -o \"$F\"" LINE,
          CODE_OK,
          { "windfirm fit models/field/sample_pull.yaml --no-profile", ".scratch/a\\\\b'\"" } },
        { "F=$T/plain; $W terrain --size 2 --no-plots -q -o $F" LINE,
          CODE_OK,
          { "\"windfirm terrain --size 2 --no-plots -q -o ", ".scratch/plain\"" } },
    };
#undef LINE
    CHECK(rows);
    /* the recorded line, without its JSON escapes, is a command that does the same */
    assert_int_equal(shell("F=\"$T/it's\"; $W wind kaimal --duration '60 s' --no-plots -q -o \"$F\" && "
                           "sed -n 's/\\\\\\\\/\\\\/g; s/.*\"command\": \"windfirm \\(.*\\)\".*/\\1/p' "
                           "\"$F/results.json\" >$T/line && cp -R \"$F\" $T/first && rm -r \"$F\" && "
                           "eval \"$W $(cat $T/line)\" && diff -r $T/first/tables \"$F/tables\""),
                     CODE_OK);
}

/* A wind that does not change has its page too; the papers' models are found from any folder. */
static void test_series(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W series moso_bamboo --model moso_culm --duration 2 --no-vtk -o $T/out && head -c 5 "
          "$T/out/series.pdf",
          CODE_OK,
          { "page: ", "%PDF-" } },
        { "W=$PWD/$W; cd $T && $W papers tang2012 --no-report --no-vtk -o out",
          CODE_OK,
          { "printed, 40 segments" } },
    };
    CHECK(rows);
}

/* Options from a file: what is typed comes first, mistakes know their line, other commands' keys are named.
 */
static void test_study(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W compare models/studies/bamboo_and_willow.yaml --no-report -o $T/out",
          CODE_OK,
          { "Moso bamboo", "Weeping willow", "        25 ",
            "not used by 'compare': gust, intensity, duration, step" } },
        { "$W compare --study models/studies/bamboo_and_willow.yaml --wind 7 --no-report -o $T/out "
          "&& grep -c '\"role\": \"study\"' $T/out/results.json",
          CODE_OK,
          { "         7 ", "\n1\n" } },
        { "$W analyze oak --study models/studies/bamboo_and_willow.yaml --no-report -q -o $T/out && "
          "$W analyze oak $M --wind 10,15,25 --no-report -q -o $T/two && diff -r $T/out/tables $T/two/tables",
          CODE_OK,
          { "" } },
        { "$W series oak --study models/studies/bamboo_and_willow.yaml --wind 8 --no-report --no-vtk -o "
          "$T/out",
          CODE_OK,
          { "120        " } },
        { "$W wind --study models/studies/bamboo_and_willow.yaml --wind 8 --no-plots -o $T/out",
          CODE_OK,
          { "von-karman", "120 steps of 0.5 s" } },
        { "$W analyze models/studies/bamboo_and_willow.yaml",
          CODE_INPUT,
          { "'weeping_willow' is too many" } },
        { "printf 'study: s\nmodel: culm\nwind: 300\nprofil: log\nsolver: bem\nno_report: maybe\n' > "
          "$T/s.yaml\n"
          "$W analyze oak --study $T/s.yaml",
          CODE_INPUT,
          { "s.yaml:3:7: error: wind: 300 is outside 0..200 m/s", "s.yaml:4:1: error: unknown key 'profil'",
            "s.yaml:5:9: error: solver: 'bem' is none of", "s.yaml:6:12: error: no_report: 'maybe'" } },
        { "printf 'study: s\nmodel: own.yaml\nwind: {a: 1}\n' > $T/s.yaml; cp models/culm.yaml $T/own.yaml\n"
          "$W analyze oak --study $T/s.yaml --wind 5 --no-report -o $T/out && grep own.yaml "
          "$T/out/results.json",
          CODE_OK,
          { "scratch/own.yaml" } },
        { "$W analyze oak --study models/culm.yaml",
          CODE_INPUT,
          { "missing key 'study'", "unknown key 'stem'" } },
        { "$W analyze oak --study nowhere.yaml", CODE_INPUT, { "nowhere.yaml" } },
        { ": > $T/s.yaml; $W analyze oak --study $T/s.yaml", CODE_INPUT, { "the file is empty" } },
        { "$W schema study", CODE_OK, { "root_stiffness", "analyze compare" } },
    };
    CHECK(rows);
}

/* Each spoils one thing of a good species table or model. Nothing may be written then. */
static void test_bad_files(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "sed 's/ density:/ densty:/' species/moso_bamboo.yaml >$T/b.yaml; $W analyze $T/b.yaml $RUN",
          CODE_INPUT,
          { "b.yaml:", ": error: ", "densty", "did you mean 'density'?" } },
        { "sed 's/value: 10 GPa/value: 10 GPx/' species/moso_bamboo.yaml >$T/b.yaml; $W analyze $T/b.yaml "
          "$RUN",
          CODE_INPUT,
          { "b.yaml:", ": error: ", "youngs_modulus", "GPx" } },
        { "sed 's/value: 10 GPa/value: 10/' species/moso_bamboo.yaml >$T/b.yaml; $W analyze $T/b.yaml $RUN",
          CODE_INPUT,
          { "b.yaml:", ": error: ", "youngs_modulus", "unit" } },
        { "sed 's/value: 10 GPa/value: 10 kg/' species/moso_bamboo.yaml >$T/b.yaml; $W analyze $T/b.yaml "
          "$RUN",
          CODE_INPUT,
          { "b.yaml:", ": error: ", "youngs_modulus", "pressure" } },
        { "sed 's/value: 10 GPa/value: 10000 GPa/' species/moso_bamboo.yaml >$T/b.yaml; $W analyze $T/b.yaml "
          "$RUN",
          CODE_INPUT,
          { "b.yaml:", ": error: ", "youngs_modulus" } },
        { "sed 's/value: 10 GPa/value: nan GPa/' species/moso_bamboo.yaml >$T/b.yaml; $W analyze $T/b.yaml "
          "$RUN",
          CODE_INPUT,
          { "b.yaml:", ": error: ", "youngs_modulus" } },
        { "sed '/^levels:/,/^crown:/{/^crown:/!d}' species/moso_bamboo.yaml >$T/b.yaml; $W analyze $T/b.yaml "
          "$RUN",
          CODE_INPUT,
          { "b.yaml", "error: ", "levels" } },
        { "sed 's/height: 14 m/heigth: 14 m/' models/culm.yaml >$T/m.yaml; $W analyze moso_bamboo --model "
          "$T/m.yaml "
          "--wind 10 -o $T/out",
          CODE_INPUT,
          { "m.yaml:", ": error: ", "heigth", "did you mean 'height'?" } },
        { ": >$T/b.yaml; $W analyze $T/b.yaml $RUN", CODE_INPUT, { "b.yaml", "error: " } },
        { "printf 'species: \\377\\n' >$T/b.yaml; $W analyze $T/b.yaml $RUN",
          CODE_INPUT,
          { "b.yaml:1:10", "UTF-8" } },
        { "printf 'a: &x [*x]\\n' >$T/b.yaml; $W analyze $T/b.yaml $RUN",
          CODE_INPUT,
          { "b.yaml:", "error: " } },
        { "$W analyze species $RUN", CODE_INPUT, { "species: " } },
        { "$W analyze $T/none.yaml $RUN", CODE_INPUT, { "none.yaml" } },
        { "$W analyze moso_bamboo --model $T/none.yaml --wind 10 -o $T/out", CODE_INPUT, { "none.yaml" } },
        /* every mistake of every file in one go */
        { "sed 's/ density:/ densty:/; s/value: 10 GPa/value: 10 kg/' species/moso_bamboo.yaml >$T/b.yaml\n"
          "sed 's/segments: 40/segments: many/' models/culm.yaml >$T/m.yaml\n"
          "$W compare $T/b.yaml $T/none.yaml --model $T/m.yaml --wind 10 -o $T/out",
          CODE_INPUT,
          { "densty", "youngs_modulus", "none.yaml", "segments" } },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        check(&rows[i], 1);
        char written[4200];
        snprintf(written, sizeof written, "%s >/dev/null 2>&1; ls -A $T/out", rows[i].command);
        assert_int_not_equal(shell(written), 0); /* no output folder */
    }
}

static void test_output(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze moso_bamboo $RUN && ls $T/out $T/out/tables",
          CODE_OK,
          { "critical wind speed", "results.json", "summary.csv", "sweep.csv" } },
        { "$W analyze moso_bamboo $RUN --quiet", CODE_OK, { "" } },
        { "$W analyze moso_bamboo $RUN --solver linear", CODE_OK, { "warning", "small-deflection" } },
        { "$W analyze willow_feng1999 $RUN", CODE_OK, { "as-printed" } },
        /* a folder that cannot be written is found before anything is computed */
        { "$W analyze moso_bamboo $M --wind 10 --no-report -o /dev/null/out",
          CODE_RUN,
          { "/dev/null: is a file" } },
        { ": >$T/taken; $W analyze moso_bamboo $M --wind 10 --no-report -o $T/taken", CODE_RUN, { "taken" } },
        /* without the drawing programs the numbers are complete, and the packages are named */
        { "mkdir $T/empty; PATH=$T/empty $W analyze moso_bamboo $M --wind 10 -o $T/out\ncode=$?\nls $T/out\n"
          "exit $code",
          CODE_OK,
          { "gnuplot-nox", "weasyprint", "plots and pages not complete", "results.json" } },
        { "$W analyze oak $RUN; echo old >$T/out/report.pdf; sleep 0.01; $W analyze oak $RUN",
          CODE_OK,
          { "report.pdf is the page of an earlier run" } },
        /* every wind profile has its words in the report */
        { "for p in uniform log power 'canopy --canopy-height 16 --reference-height 26'; do\n"
          "PATH=$T $W analyze oak $M --wind 10 --profile $p -o $T/out --quiet || exit; done\n"
          "grep -c 'in a stand 16' $T/out/report.html",
          CODE_OK,
          { "1" } },
        { "$W analyze oak $RUN --profile canopy", CODE_INPUT, { "needs the canopy height" } },
        { "$W analyze oak $RUN --profile canopy --displacement 7 --reference-height 20 -q; grep -A1 "
          "'\"canopy_height' "
          "$T/out/results.json",
          CODE_OK,
          { "\"value\": 10" } },
        { "$W report $T/none", CODE_INPUT, { "none" } },
    };
    CHECK(rows);
    /* what is missing is said once */
    assert_int_equal(shell("$W analyze oak $RUN --quiet; PATH=$T $W report $T/out"), CODE_RUN);
    char *first = strstr(output, "gnuplot is not installed");
    assert_non_null(first);
    assert_null(strstr(first + 1, "gnuplot is not installed"));
    assert_int_equal(shell("$W analyze moso_bamboo $RUN --quiet"), CODE_OK);
    assert_string_equal(output, "");
}

/* The crown's top is the highest point of tables/shape.csv, and moves as far as it does there; the page names
 * it where a branch reaches above the stem, and not where none does. $1: columns 1 tree, 3 wind, 8 z, 11
 * loaded z. */
#define MOVED                                                                                                \
    "awk -F, 'FNR == 1 { n++; for (i = 1; i <= NF; i++) c[n, $i] = i; next } "                               \
    "n == 1 && (!($3 in z) || $8 > z[$3]) { z[$3] = $8; m[$3] = sqrt(($9-$6)^2 + ($10-$7)^2 + ($11-$8)^2) "  \
    "} "                                                                                                     \
    "n == 2 && (a = $c[2, \"top_deflection_m\"] / m[$3] - 1)^2 < 1e-14 && $c[2, \"top_height_m\"] == z[$3] " \
    "{ same++; more += a = $c[2, \"top_deflection_m\"] > 1.001 * $c[2, \"tip_deflection_m\"] } "             \
    "END { print same + 0, \"same,\", more + 0, \"more than the tip\" }' "                                   \
    "$T/out/tables/shape.csv $T/out/tables/summary.csv; "

static void test_top(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze scots_pine --model scots_pine --soil mineral --wind 8,16 --samples 0 --no-pdf -o "
          "$T/out "
          "2>$T/said; " MOVED "grep -c -e 'The top of its crown, 17.0 m high on a' $T/out/report.html",
          CODE_OK,
          { "the crown's top, 17.01 m high on a", "2 same, 2 more than the tip", "\n1\n" } },
        { "$W analyze oak $M --wind 10 --samples 0 --no-pdf -o $T/out 2>$T/said; " MOVED
          "grep -c -e 'top of its crown' -e 'Crown’s top' $T/out/report.html",
          CODE_RUN,
          { "1 same, 0 more than the tip\n0\n" } },
    };
    CHECK(rows);
    assert_int_equal(shell("$W analyze oak $M --wind 10 --samples 0 --no-pdf -o $T/out"), CODE_OK);
    assert_null(strstr(output, "crown's top"));
}

static void test_library(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W species list", CODE_OK, { "moso_bamboo", "weeping_willow", "Phyllostachys edulis" } },
        { "$W species show moso_bamboo", CODE_OK, { "youngs_modulus", "10 GPa", "8..14", "tang2012" } },
        { "$W species show nothing", CODE_INPUT, { "nothing" } },
        { "$W schema species", CODE_OK, { "youngs_modulus", "frontal_share" } },
        { "$W schema model", CODE_OK, { "base_radius", "taper" } },
        { "$W schema tree", CODE_INPUT, { "tree" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_usage),  cmocka_unit_test(test_wind),          cmocka_unit_test(test_bad_files),
        cmocka_unit_test(test_output), cmocka_unit_test(test_library),       cmocka_unit_test(test_study),
        cmocka_unit_test(test_counts), cmocka_unit_test(test_recorded_line), cmocka_unit_test(test_series),
        cmocka_unit_test(test_top),    cmocka_unit_test(test_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
