/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands import and tree info as a user meets them: output and exit code. */
#include "close.h"
#include "shell.h"

static void import_writes_and_reports(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W import $D/simpleforest.csv",
          0,
          { "SimpleForest CSV, 3 cylinders", "[ids-from-zero]", "0 repairs" } },
        { "$W import $D/normalised.csv -o $T/t.csv -q && head -1 $T/t.csv && $W import --strict $T/t.csv",
          0,
          { "id,radius_m,length_m", "5 cylinders, height 4.00 m" } },
        { "$W import $D/plain.csv -o $T/t.obj", 2, { "must end in .csv" } },
        { "$W import $D/plain.csv -o $T/none/t.csv", 1, { "none" } },
        { "$W import $D/plain.csv $D/archi.csv -o $T/t.csv", 2, { "name a folder" } },
        { "$W import $D/warts.csv --strict -q",
          2,
          { "warts.csv:21:10: error: z0: 'one' is not a number", "cycle: 1" } },
        { "$W import $D/plain.csv --format tree", 2, { "treeqsm" } },
        { "$W import --help", 0, { "--length-unit", "simpleforest", "exit code" } },
        { "$W import $T/nothing.csv", 2, { "nothing.csv" } },
        { "$W import $T", 2, { "windfirm: " } },
    };
    CHECK(rows);
}

static void one_broken_tree_does_not_stop_the_rest(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "head -c 3000 /dev/urandom > $T/junk.csv; echo a,b > $T/no.csv\n"
          "$W import $D/plain.csv $T/junk.csv $T/no.csv $D/archi.csv -o $T/all/; c=$?; ls $T/all; exit $c",
          2,
          { "/all/plain.csv\n", "junk.csv", "lacks a parent column", "archi.csv" } },
        { "echo a,b > $T/no.csv; $W tree info --csv -q $T/no.csv $D/plain.csv",
          2,
          { "file,format,cylinders", "\",plain CSV of segments,3,2,2,1,1,2,0.074,0.1," } },
    };
    CHECK(rows);
}

static void info_prints_figures(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W tree info $D/normalised.csv --density 800",
          0,
          { "height              4.000 m", "dbh                 0.1600 m", "mass of wood        61.3239 kg",
            "2 links in the parents' wood, 1 bridges" } },
        { "$W tree info $D/normalised.csv --joint bridge", 0, { "5 segments" } },
        { "$W tree info $D/plain.csv --species moso_bamboo --leaf-area 12",
          0,
          { "leaf area           12 m2", "sail of leaves" } },
        { "$W tree info $D/warts.csv",
          0,
          { "repairs             2 rows that cannot be read", "warts.csv:21" } },
        /* along the stem, not above its base: 0.2 - 0.1 x 1.3 / 2.5 m */
        { "printf 'parent,x0,y0,z0,x1,y1,z1,r0,r1\\n0,0,0,0,1.5,0,2,0.1,0.05\\n' >$T/lean.csv; $W tree info "
          "$T/lean.csv",
          0,
          { "dbh                 0.1480 m at 1.3 m" } },
        { "$W tree inf $D/plain.csv", 2, { "did you mean 'info'?" } },
        { "$W tree info $D/plain.csv --species no_such_tree", 2, { "no_such_tree" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(import_writes_and_reports),
        cmocka_unit_test(one_broken_tree_does_not_stop_the_rest),
        cmocka_unit_test(info_prints_figures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
