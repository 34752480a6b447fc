/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branched and measured trees on the command line: which tree is meant, seasons, pictures. */
#include "close.h"
#include "shell.h"

#define QSM "tests/data/qsm/"
#define QUICK "--wind 10 --no-report --mesh-tolerance 1e-2 -o $T/out "

static void one_tree_is_meant(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze poplar --wind 10", 2, { "--model is needed" } },
        { "$W analyze poplar --model culm --tree " QSM "normalised.csv --wind 10",
          2,
          { "more than one tree" } },
        { "$W analyze poplar --model culm", 2, { "--wind is needed" } },
        { "$W tree draw -o $T/a.svg", 2, { "windfirm tree draw: --model is needed" } },
        { "$W analyze poplar --tree $T/none.csv --wind 10", 2, { "none.csv" } },
    };
    check(rows, sizeof rows / sizeof *rows);
}

static void branched_and_measured_trees_are_analysed(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze poplar --model models/zhao2013_ifs.yaml " QUICK
          "&& grep -c '\"part\": \"' $T/out/results.json",
          0,
          { "the ", " breaks first" } },
        { "$W analyze poplar --model models/zhao2013_ifs.yaml --season leaf_off " QUICK
          "&& grep leaf_off $T/out/results.json && ls $T/out/plots",
          0,
          { "leaf_off", "tree.dat" } },
        { "$W analyze poplar --tree " QSM "normalised.csv --leaf-area 1 " QUICK
          "&& grep measured $T/out/results.json",
          0,
          { "measured" } },
        { "$W analyze poplar --tree " QSM "normalised.csv --unload " QUICK, 0, { "stress-free shape" } },
    };
    check(rows, sizeof rows / sizeof *rows);
}

static void pictures(void **state)
{
    (void)state;
    if (system("gnuplot --version >/dev/null 2>&1")) skip();
    static const struct row rows[] = {
        { "$W tree draw --model models/zhao2013_ifs.yaml -s poplar -o $T/a.svg && grep -c '</svg>' $T/a.svg",
          0,
          { "545 segments -> " } },
        { "$W tree draw " QSM "normalised.csv -o $T/a.png", 0, { "segments" } },
        { "$W tree draw " QSM "normalised.csv -o $T/a.gif", 2, { "ends in .svg, .png or .pdf" } },
        { "$W tree drw x", 2, { "did you mean 'draw'?" } },
    };
    check(rows, sizeof rows / sizeof *rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_tree_is_meant),
        cmocka_unit_test(branched_and_measured_trees_are_analysed),
        cmocka_unit_test(pictures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
