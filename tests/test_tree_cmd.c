/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branched and measured trees on the command line: which tree is meant, seasons, pictures. */
#include "close.h"
#include "shell.h"

#define QSM "tests/data/qsm/"
#define PUBLIC "tests/data/public/"
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

/* The same options where a scan is read, and the part that fails by id, order and diameter. */
static void scans_that_are_doubtful(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W tree info " PUBLIC "two_trees.csv", 2, { "'1' (2 rows", "'2' (2 rows", "--tree-id" } },
        { "$W tree info " PUBLIC "two_trees.csv --tree-id 2", 0, { "0.187459 m3", "1 stem\n" } },
        { "$W import " PUBLIC "two_trees.csv --tree-id 1", 0, { "2 cylinders, height 3.00 m" } },
        { "$W tree info " PUBLIC "radius_na.csv", 0, { "0.221168 m3", "0 lateral branches" } },
        { "$W tree info " PUBLIC "stem_removed.csv --force | head -n 2",
          0,
          { "WARNING", "0.0118 m3 of wood was not scanned, 82.4 % of" } },
        { "$W tree info " PUBLIC "stem_removed.csv", 2, { "82.4 %", "--force" } },
        { "$W analyze oak --tree " PUBLIC "stem_removed.csv " QUICK, 2, { "82.4 %", "--force" } },
        { "$W analyze oak --tree " PUBLIC "stem_removed.csv --force " QUICK,
          1,
          { "does not stand", "--rest stress-free" } },
        { "$W compare oak beech --tree " PUBLIC "stem_removed.csv --force --rest stress-free " QUICK
          "&& grep -c '\"code\": \"unseen-wood\"' $T/out/results.json",
          0,
          { "[unseen-wood]", "\n2\n" } },
        { "$W shelter --species oak --wind 10 --tree " PUBLIC "stem_removed.csv -o $T/out",
          2,
          { "--force" } },
        { "$W shelter --species oak --wind 10 --no-plots --no-motion --slabs 2 --cells 8 --tree " PUBLIC
          "stem_removed.csv --force -o $T/out",
          0,
          { "[unseen-wood]" } },
        { "$W analyze oak --tree " PUBLIC "thick_child.csv --rest stress-free " QUICK
          "&& grep -A3 '\"part\": \"branch of order 1\"' $T/out/results.json",
          0,
          { "id 4, 66 mm on 5 mm", "6.00 m above the ground (id 3, order 1, 5 mm thick)", "\"id\": 3" } },
        { "$W analyze oak --tree " PUBLIC "thick_child.csv " QUICK, 0, { "[stiffened]", "[not-credible]" } },
        { "$W analyze oak --tree " PUBLIC "thick_child.csv --cap-children " QUICK,
          0,
          { "[children-capped]", "id 4, 66 mm on 5 mm" } },
    };
    check(rows, sizeof rows / sizeof *rows);
}

/* Nothing of a long name is lost beside the picture, and no species is named that nobody specified. */
static void pictures_name_what_is_known(void **state)
{
    (void)state;
    if (system("gnuplot --version >/dev/null 2>&1")) skip();
#define LONG "A_SCANNED_OAK_from_the_north_eastern_plot_2016_final_version_reprocessed"
    static const struct row rows[] = {
        { "cp " QSM "normalised.csv $T/" LONG ".csv && $W tree draw $T/" LONG
          ".csv -o $T/a.svg -q; grep -ci beech $T/a.svg; grep -o '[^>]*</text>' $T/a.svg",
          0,
          { "0\n", "A_SCANNED_OAK_<", "from_the_north_eastern_<", "reprocessed<" } },
        { "$W tree draw " QSM "normalised.csv -s beech -o $T/a.svg -q; grep -c 'European beech' $T/a.svg",
          0,
          { "1\n" } },
        { "$W tree draw --model culm -o $T/a.svg -q && ! grep -i beech $T/a.svg", 0, { "" } },
        { "grep -v base_radius models/culm.yaml > $T/m.yaml; $W tree draw --model $T/m.yaml -o $T/a.svg -q; "
          "grep -c 'none; stem as thick' $T/a.svg",
          0,
          { "1\n" } },
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
        cmocka_unit_test(scans_that_are_doubtful),
        cmocka_unit_test(pictures_name_what_is_known),
        cmocka_unit_test(pictures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
