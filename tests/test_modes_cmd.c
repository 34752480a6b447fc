/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm modes: what it prints, writes and refuses. */
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
        /* an oak sheds its leaves, a pine does not; a wind of each season has the whole tree and its modes */
        { "$W modes oak --model weeping_willow_tree --wind 0,8 -n 3 --no-report -o $T/o; wc -l "
          "<$T/o/tables/modes.csv; cut "
          "-d, -f2,3,4,5 $T/o/tables/modes.csv",
          CODE_OK,
          { "Without leaves, mean wind 8 m/s", "\n17\n", "leaf_on,0,0,tree\n", "leaf_off,8,3," } },
        { "$W modes scots_pine --model scots_pine --wind 0 -n 2 --no-report -o $T/p; cut -d, -f2,4,5 "
          "$T/p/tables/modes.csv",
          CODE_OK,
          { "of 17.0 m and 217 mm at 1.3 m: 0.309 Hz",
            "leaf_on,0,tree\nleaf_on,1,along\nleaf_on,2,across\n" } },
        { "$W modes oak --model weeping_willow_tree --season leaf_off --wind 0 -n 2 --no-report -o $T/s; cut "
          "-d, -f2 "
          "$T/s/tables/modes.csv | sort | uniq -c",
          CODE_OK,
          { "3 leaf_off\n" } },
        /* rain on the leaves: dry, wet, without leaves; the wet tree is the slowest of them */
        { "$W modes oak --model weeping_willow_tree --wind 0 -n 1 --water-film 0.3mm --no-report -o $T/w; "
          "cut -d, -f2,4 $T/w/tables/modes.csv; awk -F, '$4 == \"0\" { f[$2] = $6 } END { "
          "print f[\"leaf_wet\"] < f[\"leaf_on\"] && f[\"leaf_on\"] < f[\"leaf_off\"] }' "
          "$T/w/tables/modes.csv",
          CODE_OK,
          { "With wet leaves, 0.3 mm of rain on them, still air",
            "leaf_on,0\nleaf_on,1\nleaf_wet,0\nleaf_wet,1\nleaf_off,0\nleaf_off,1\n1\n" } },
        { "$W modes oak $M --wind 0 -n 1 --rain 10mm/h --no-report -o $T/w",
          CODE_OK,
          { "water-storage", "With wet leaves" } },
        /* from a study file, which other commands take too; the command line takes precedence */
        { "printf 'study: s\nspecies: oak\nmodel: culm\nwind: [0, 8]\ncount: 3\nstep: 0.5 s\n' >$T/s.yaml; "
          "$W "
          "modes $T/s.yaml --count "
          "2 --no-report -q -o $T/y; wc -l <$T/y/tables/modes.csv",
          CODE_OK,
          { "13\n" } },
        /* analyze has the lowest modes in still air; a steady wind needs none */
        { "$W analyze oak $M --wind 9 --no-report -q -o $T/n; $W analyze oak $M --wind 9 --peak mean "
          "--no-report -q -o $T/o; for d in n o; "
          "do grep -c turn_along $T/$d/results.json; grep -c '\"frequency\": 0.2' $T/$d/results.json; done; "
          "true",
          CODE_OK,
          { "4\n2\n0\n0\n" } },
        /* --damping is that of every mode; without wind the air adds none */
        { "$W modes oak $M --wind 0 -n 2 --damping 0.07 --no-report -q -o $T/d; cut -d, -f13,14,15 "
          "$T/d/tables/modes.csv",
          CODE_OK,
          { "0.07,0,0.07\n0.07,0,0.07\n" } },
    };
    CHECK(rows);
}

static void redraws(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W modes oak $M --wind 0 -n 4 --no-report -q -o $T/r && $W report $T/r --no-pdf --lang zh -q; "
          "grep -c '<figure' "
          "$T/r/modes.html; grep -c 'class=\"missing\"' $T/r/modes.html; ls $T/r/plots/modes_1.svg",
          CODE_OK,
          { "modes_1.svg" } },
    };
    if (system("command -v gnuplot >/dev/null")) skip();
    CHECK(rows);
}

/* The page of every command whose winds are carried to a site says where they are measured and what the site
 * is. */
static void pages_name_the_site(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W modes oak $M --wind 8 -n 1 --terrain III --no-pdf -q -o $T/a; grep -o 'terrain of the site III "
          "(as given)' $T/a/modes.html",
          CODE_OK,
          { "terrain of the site III (as given)" } },
        { "$W explain oak $M --wind 8 --no-pdf -q -o $T/b; grep -o 'over terrain II; terrain of the site II "
          "(assumed: open country)' "
          "$T/b/explain.html",
          CODE_OK,
          { "(assumed: open country)" } },
        { "$W shelter --species oak $M --wind 8 --site suburb --no-motion --no-pdf -q --lang zh -o $T/c; "
          "grep -o '场地地面类别 III（给定, 郊区）' $T/c/shelter.html",
          CODE_OK,
          { "郊区" } },
    };
    if (system("command -v gnuplot >/dev/null")) skip();
    CHECK(rows);
}

static void refuses(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W modes oak", CODE_INPUT, { "--model is needed" } },
        { "$W modes oak $M -n 0", CODE_INPUT, { "--count" } },
        { "$W modes oak $M --damping 2", CODE_INPUT, { "--damping" } },
        { "$W modes oak $M --storage dipped", CODE_INPUT, { "without --rain" } },
        { "$W modes oak $M --season leaf_off --water-film 0.3mm --no-report -o $T/b",
          CODE_INPUT,
          { "no leaves that could hold rain" } },
        { "$W modes oka $M", CODE_INPUT, { "did you mean 'oak' (Quercus robur)?" } },
    };
    CHECK(rows);
}

/* A planned test of free sway needs no value; a fit does. */
static void plans_sway(void **state)
{
    (void)state;
#define SWAY                                                                                                 \
    "sed '/^tests:/,/^free:/c\\tests:\\n  - name: sway\\n    sensors:\\n      - {name: f, kind: frequency, " \
    "sigma: 0.005 "                                                                                          \
    "Hz}\\nfree:' models/field/sample_pull.yaml | sed "                                                      \
    "\"s|sample_pine.yaml|$PWD/models/field/sample_pine.yaml|\" "                                            \
    ">$T/sway.yaml; "
    static const struct row rows[] = {
        { SWAY "$W simulate-test $T/sway.yaml --free level0.youngs_modulus -o $T/sim; cat $T/sim/sway.csv",
          CODE_OK,
          { "f_Hz\n" } },
        { SWAY "$W fit $T/sway.yaml --no-report -o $T/fit", CODE_INPUT, { "a frequency needs 'value'" } },
    };
#undef SWAY
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(prints_and_writes),   cmocka_unit_test(redraws),
        cmocka_unit_test(pages_name_the_site), cmocka_unit_test(refuses),
        cmocka_unit_test(plans_sway),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
