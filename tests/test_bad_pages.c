/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What pages are made of and is not as it should be: one clear line, exit code 2, and the report that was
 * there stays. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

#define MADE                                                                                                 \
    "$W analyze oak --model culm --wind 5,10 --samples 0 --no-pdf -q -o $T/out >/dev/null 2>&1; "            \
    "cp $T/out/report.html $T/before.html; "
#define AGAIN "$W analyze oak --model culm --wind 5,10 --samples 0 --no-pdf -q -o $T/out "
#define REPORT "; $W report $T/out --no-pdf -q; "
/* its exit code; then: the page is the one before */
#define STAYS "echo code $?; cmp $T/before.html $T/out/report.html && echo stays"

static void pictures(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { MADE AGAIN "--photo $T/none.jpg; " STAYS,
          CODE_OK,
          { "/none.jpg: cannot be read: there is no such file", "code 2\nstays" } },
        { MADE AGAIN "--logo README.md; " STAYS,
          CODE_OK,
          { "README.md: is neither a PNG nor a JPEG picture", "code 2\nstays" } },
        { MADE AGAIN "--logo $T; " STAYS, CODE_OK, { "is a folder, a file was expected", "code 2\nstays" } },
        { MADE "head -c 700 tests/data/job/photo.jpg >$T/cut.jpg; " AGAIN "--photo $T/cut.jpg; " STAYS,
          CODE_OK,
          { "/cut.jpg: cannot be read as a picture: it is damaged", "code 2\nstays" } },
        { MADE "head -c 120 tests/data/job/logo.png >$T/cut.png; " AGAIN "--photo $T/cut.png; " STAYS,
          CODE_OK,
          { "/cut.png: cannot be read as a picture: it is damaged", "code 2\nstays" } },
        { MADE "head -c 21000000 /dev/zero >$T/big.png; " AGAIN "--photo $T/big.png; " STAYS,
          CODE_OK,
          { "a picture of more than 20 MB", "code 2\nstays" } },
        { MADE "python3 -c 'import struct, sys, zlib\nc = lambda t, d: struct.pack(\">I\", len(d)) + t + d + "
               "struct.pack(\">I\", zlib.crc32(t + d))\n"
               "open(sys.argv[1], \"wb\").write(b\"\\x89PNG\\r\\n\\x1a\\n\" + c(b\"IHDR\", "
               "struct.pack(\">IIBBBBB\", 50000, 50000, 8, 0, 0, 0, 0)) + "
               "c(b\"IDAT\", zlib.compress(bytes(1000000))) + c(b\"IEND\", b\"\"))' $T/bomb.png; " AGAIN
               "--photo $T/bomb.png; " STAYS,
          CODE_OK,
          { "/bomb.png: cannot be read as a picture", "of more than 40 megapixels", "code 2\nstays" } },
    };
    CHECK(rows);
}

static void words_and_versions(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { MADE AGAIN "--lang fr; " STAYS, CODE_OK, { "--lang: 'fr' is none of en, zh", "code 2\nstays" } },
        { MADE "$W report $T/out --lang fr; " STAYS,
          CODE_OK,
          { "--lang: 'fr' is none of en, zh", "code 2\nstays" } },
        { MADE "$W report $T/out --units imperal; " STAYS,
          CODE_OK,
          { "--units: 'imperal' is none of metric, imperial, cn", "code 2\nstays" } },
        { MADE "sed -i '0,/\"version\": [0-9]*/s//\"version\": 99/' $T/out/results.json" REPORT STAYS,
          CODE_OK,
          { "results of version 99; this program reads version", "code 2\nstays" } },
        { MADE "sed -i '0,/\"version\": [0-9]*/s//\"version\": 0/' $T/out/results.json" REPORT STAYS,
          CODE_OK,
          { "results of version 0; this program reads version", "code 2\nstays" } },
        { MADE "sed -i 's/windfirm-results/other-results/' $T/out/results.json" REPORT STAYS,
          CODE_OK,
          { "is not a results document of windfirm", "code 2\nstays" } },
    };
    CHECK(rows);
}

static void folders_half_there(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { MADE "rm $T/out/tables/summary.csv" REPORT STAYS,
          CODE_OK,
          { "tables/summary.csv is missing", "code 2\nstays" } },
        { MADE "rm -r $T/out/tables" REPORT STAYS,
          CODE_OK,
          { "tables/shape.csv is missing", "code 2\nstays" } },
        { MADE "rm -r $T/out/plots" REPORT STAYS, CODE_OK, { "plots/run.csv is missing", "code 2\nstays" } },
        { MADE "truncate -s 500 $T/out/tables/shape.csv" REPORT STAYS,
          CODE_OK,
          { "tables/shape.csv is not of this run", "code 2\nstays" } },
        { MADE "truncate -s 2000 $T/out/results.json" REPORT STAYS,
          CODE_OK,
          { "results.json:", "code 2\nstays" } },
        { MADE ": >$T/out/results.json" REPORT STAYS, CODE_OK, { "results.json:", "code 2\nstays" } },
        { MADE "rm $T/out/results.json" REPORT STAYS,
          CODE_OK,
          { "is '", "a results folder?", "code 2\nstays" } },
        { MADE "mkdir $T/out/.windfirm-1; touch $T/out/.windfirm-1/x" REPORT "echo code $?; ls -A $T/out",
          CODE_OK,
          { "code 0\nplots\nreport.html\nresults.json\ntables\n" } },
    };
    CHECK(rows);
}

/* Folders of files that were named from the root are on no page and in no figure. */
static void folders_are_not_said(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "A=$(cd $T && pwd)/secret; mkdir $A; cp species/oak.yaml models/culm.yaml docs/examples/annual.csv "
          "$A; "
          "{ echo direction_deg,frequency,weibull_scale_m_s,weibull_shape; for d in 0 45 90 135 180 225 270 "
          "315; do echo $d,1,6,2; done; } >$A/rose.csv; "
          "$W series $A/oak.yaml --model $A/culm.yaml --wind 8 --duration 2 --step 0.5 --gust cosine "
          "--no-vtk --keys 2 --no-pdf -q -o $T/s >/dev/null 2>&1; "
          "$W analyze $A/oak.yaml --model $A/culm.yaml --wind 10 --samples 0 --directions 8 --climate "
          "$A/rose.csv --no-pdf -q -o $T/a >/dev/null 2>&1; "
          "$W wind rose --file $A/rose.csv --no-pdf -q -o $T/r >/dev/null 2>&1; "
          "$W wind extremes --annual $A/annual.csv --wind 20 --no-pdf -q -o $T/e >/dev/null 2>&1; ls "
          "$T/*/*.html | wc -l; "
          "grep -c secret $T/*/*.html $T/*/plots/*.svg | grep -v :0; grep -l secret $T/*/results.json | wc "
          "-l",
          CODE_OK,
          { "4\n4\n" } },
    };
    CHECK(rows);
}

/* What pages and tables say of the user is words. */
static void names_are_words(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "mkdir $T/d; awk '/^name:/ { print \"name: \\\"a\\xe2\\x80\\xa8b\\xe2\\x80\\xa9<c>&\\\"\"; next } "
          "{ print }' species/oak.yaml >$T/d/oak.yaml; "
          "$W compare $T/d/oak.yaml beech --model culm --wind 5,10 --samples 0 --no-pdf -q -o $T/out "
          ">/dev/null 2>&1; "
          "sed -n 's/.*id=\"live-data\">\\(.*\\)<.script><script>.*/\\1/p' $T/out/report.html >$T/data; test "
          "-s $T/data && "
          "LC_ALL=C grep -c -e '[<>&]' -e \"$(printf '\\342\\200[\\250\\251]')\" $T/data; grep -c -e "
          "\"$T/d\" -e 'windfirm compare' $T/out/report.html",
          CODE_RUN,
          { "0\n0\n" } },
        { "sed 's/^species:.*/species: \"-1+x\"/' species/oak.yaml >$T/k.yaml; sed 's/^species:.*/species: "
          "-x/' species/oak.yaml >$T/l.yaml; "
          "$W compare $T/k.yaml $T/l.yaml --model culm --wind 5 -o $T/out",
          CODE_INPUT,
          { "k.yaml:2:10: error: species: '-1+x': a name",
            "l.yaml:2:10: error: species: '-x': a name does not begin with '-'" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures),           cmocka_unit_test(words_and_versions),
        cmocka_unit_test(folders_half_there), cmocka_unit_test(folders_are_not_said),
        cmocka_unit_test(names_are_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
