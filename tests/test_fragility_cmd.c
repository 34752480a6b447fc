/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm fragility, and the interval of analyze and compare: what they print, write and refuse. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

static void prints_and_writes(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W fragility moso_bamboo $M --samples 40 --no-report -o $T/f; wc -l <$T/f/tables/fragility.csv; "
          "wc "
          "-l <$T/f/tables/samples.csv; head -1 $T/f/tables/fragility.csv",
          CODE_OK,
          { "the stem is lost at about 18 m/s mean, ", "(90 % of 40 samples)", "\n102\n41\n",
            "wind_m_s,gust_m_s,share_lost,share_low,share_high,lognormal" } },
        { "$W fragility moso_bamboo $M --samples 40 --no-report -q -o $T/f; cut -d, -f1,3 "
          "$T/f/tables/tornado.csv",
          CODE_OK,
          { "value,status\n", "modulus_of_rupture,assumed", "crown.streamlining.exponent,borrowed",
            "gusts,rule" } },
        /* with a root that is weaker than the stem, its anchorage varies too */
        { "$W fragility oak $M --samples 40 --pull-moment '0.5 kN m' --no-report -o $T/f; grep anchorage "
          "$T/f/tables/tornado.csv | cut -d, -f1-6",
          CODE_OK,
          { "the tree is lost at about", "safety of the stem and root at 10 m/s",
            "anchorage,factor,rule,1,0.581" } },
        /* diaphragms hold each sample's wall: the plain tube splits, the culm with them breaks */
        { "for n in '' '--node-spacing 15cm'; do $W fragility moso_bamboo --model moso_culm --samples 40 $n "
          "--no-report -o $T/f | grep 'how sure'; grep -A1 '\"splitting\"' $T/f/results.json; done",
          CODE_OK,
          { "\"samples\": 35", "lost at about 28 m/s mean", "\"samples\": 0",
            "diaphragms, 0.15 m apart, are counted by judgement" } },
        /* a share of all samples at the highest wind: the ratio rises from 0 to 1 */
        { "$W fragility weeping_willow $M --samples 40 --no-report -q -o $T/f; sed -n '2p;$p' "
          "$T/f/tables/fragility.csv | cut -d, -f3",
          CODE_OK,
          { "0\n1\n" } },
        { "$W analyze moso_bamboo $RUN; grep -c '\"interval\"' $T/out/results.json",
          CODE_OK,
          { "18 m/s mean", "safety of the stem at 10 m/s", "most of it by ",
            "value-decides" } },
        { "$W analyze moso_bamboo $RUN --samples 0; grep -c '\"interval\"' $T/out/results.json",
          CODE_RUN, /* of grep */
          { "critical wind speed" } },
        { "$W compare moso_bamboo weeping_willow $RUN --samples 20; grep -c '\"interval\"' "
          "$T/out/results.json",
          CODE_OK,
          { "18 m/s mean", "11 m/s mean", "(90 % of 20 samples)", "\n2\n" } },
        /* what is not computed where nothing is said, and how to get it */
        { "$W analyze oak --model broadleaf --wind 10 --no-report -o $T/b --search-time 1 | grep lost; true",
          CODE_OK,
          { "no-interval", "--samples 256 computes it" } },
        { "$W analyze moso_bamboo $RUN --solver linear", CODE_OK, { "no-interval", "'beam' does" } },
    };
    CHECK(rows);
}

/* The bytes depend on the seed, not on the threads. */
static void bytes(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for t in 1 2; do $W fragility oak $M --samples 30 --threads $t --no-report -q -o $T/$t; done; "
          "$W fragility oak $M --samples 30 --seed 2 --no-report -q -o $T/3; cd $T; for f in fragility "
          "tornado "
          "samples; do cmp 1/tables/$f.csv 2/tables/$f.csv && echo same $f; done; cmp -s "
          "1/tables/samples.csv "
          "3/tables/samples.csv || echo another",
          CODE_OK,
          { "same fragility", "same tornado", "same samples", "another" } },
    };
    CHECK(rows);
}

static void draws(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W fragility moso_bamboo $M --samples 30 --no-pdf -q -o $T/r && $W report $T/r --no-pdf --lang zh "
          "-q; "
          "grep -c '<figure' $T/r/fragility.html; grep -c 'class=\"missing\"' $T/r/fragility.html; grep -o "
          "'树木损毁的可能性' $T/r/fragility.html | head -1; ls $T/r/plots/fragility.svg",
          CODE_OK,
          { "1\n0\n", "树木损毁的可能性", "fragility.svg" } },
        { "$W analyze moso_bamboo $M --wind 10,20 --samples 30 --no-pdf -q -o $T/r; grep -o 'How sure: the "
          "90 "
          "% interval' $T/r/report.html",
          CODE_OK,
          { "How sure: the 90 % interval" } },
    };
    if (system("command -v gnuplot >/dev/null")) skip();
    CHECK(rows);
}

static void refuses(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W fragility moso_bamboo $M --samples 0 -o $T/f; ls $T", CODE_OK, { "without samples" } },
        { "$W fragility moso_bamboo $M --samples 19 -o $T/f", CODE_INPUT, { "20 to 4096" } },
        { "$W fragility oak $M --node-spacing 15cm -o $T/f",
          CODE_INPUT,
          { "diaphragms are of culms; the stem of Oak is solid" } },
        { "$W fragility moso_bamboo $M --node-spacing 0cm -o $T/f",
          CODE_INPUT,
          { "--node-spacing: 0cm is outside 1..500 cm" } },
        { "$W analyze moso_bamboo $RUN --samples 10; c=$?; ls $T; exit $c", CODE_INPUT, { "20 to 4096" } },
        { "$W analyze moso_bamboo $RUN --samples 5000", CODE_INPUT, { "--samples", "4096" } },
        { "$W analyze moso_bamboo $RUN --solver chain --samples 64",
          CODE_INPUT,
          { "--samples", "no effect with the solver 'chain'" } },
        { "$W analyze moso_bamboo $RUN --preset tang2012 --samples 64",
          CODE_INPUT,
          { "--samples", "which repeats a publication" } },
        { "$W analyze moso_bamboo $RUN --shelter wake --samples 64",
          CODE_INPUT,
          { "--samples", "with --shelter" } },
        { "sed 's/low: 70 MPa/low: 170 MPa/' species/moso_bamboo.yaml >$T/b.yaml; $W fragility $T/b.yaml $M "
          "-o $T/f",
          CODE_INPUT,
          { "b.yaml:", "170 MPa is above the value 100 MPa" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(prints_and_writes),
        cmocka_unit_test(bytes),
        cmocka_unit_test(draws),
        cmocka_unit_test(refuses),
    };
    return cmocka_run_group_tests_name("fragility", tests, NULL, NULL);
}
