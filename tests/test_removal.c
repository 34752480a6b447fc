/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branches taken off a tree: the same as a tree drawn without them, what is printed, what is refused. */
#include "close.h"
#include "shell.h"

#define HEAD "printf 'id,parent,x0,y0,z0,x1,y1,z1,radius0,radius1,level\\n"
#define STEM "1,0,0,0,0,0,0,3,0.15,0.14,0\\n2,1,0,0,3,0,0,7,0.14,0.02,0\\n"
#define LIMB "3,1,0,0,3,-1,0.5,5,0.06,0.04,1\\n4,3,-1,0.5,5,-2,0.5,6,0.04,0.01,2\\n"
#define OTHER "5,1,0,0,3,1,0,4,0.05,0.02,1\\n"
#define TREES HEAD STEM LIMB OTHER "' >$T/all.csv; " HEAD STEM OTHER "' >$T/less.csv; "
#define RUN(file, what)                                                                                      \
    "$W analyze ash --tree $T/" file ".csv --wind 20,30 --samples 0 --no-report --soil mineral --search-to " \
    "150 -o $T/o_" file " --remove " what " "
/* The numbers of one line of the table, without its first two columns. */
#define LINE(name) "| grep '^ *" name " .* %' | sed 's/.*%!* *//'"

static void as_drawn(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { TREES RUN("all", "id:3,id:3+id:5,level:1") ">$T/all; " RUN(
              "less", "id:5") ">$T/less; "
                              "cat $T/all " LINE("remove=id:3") " >$T/a; cat $T/all " LINE("remove=id:3+id:5") " >>$T/a; cat $T/all " LINE("remove=level:1") " >>$T/a; cat $T/less " LINE(
                                  "as it stands") " >$T/b; cat $T/less " LINE("remove=id:5") " >>$T/b; "
                                                                                             "cat "
                                                                                             "$T/"
                                                                                             "less"
                                                                                             " " LINE(
                                                                                                 "remove=id:"
                                                                                                 "5") " >>$T/"
                                                                                                      "b; "
                                                                                                      "cmp "
                                                                                                      "$T/a "
                                                                                                      "$T/b "
                                                                                                      "&& wc "
                                                                                                      "-l "
                                                                                                      "<$T/"
                                                                                                      "a; "
                                                                                                      "cat "
                                                                                                      "$T/a",
          CODE_OK,
          { "3\n1.522 " } },
        { TREES RUN(
              "all",
              "id:4") "| grep -c '=id:4 '; grep -c '\"removals\"' $T/o_all/results.json; $W report "
                      "$T/o_all --no-pdf; echo \"[$?]\"; grep -c '<td>remove=id:4</td>' $T/o_all/report.html",
          CODE_OK,
          { "1\n1\n", "[0]\n1\n" } },
    };
    CHECK(rows);
}

static void refused(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { TREES RUN("all", "id:1"), CODE_INPUT, { "--remove id:1: that is of the stem" } },
        { TREES RUN("all", "id:99"), CODE_INPUT, { "has no such branch" } },
        { TREES RUN("all", "level:7+id:3"), CODE_INPUT, { "has no such branch" } },
        { TREES RUN("all", "level:0"), CODE_INPUT, { "that is of the stem" } },
        { TREES RUN("all", "id:3x"), CODE_INPUT, { "'id:3x': id: and the number of a segment" } },
        { TREES RUN("all", "id:99999999999999999999"), CODE_INPUT, { "id: and the number" } },
        { TREES RUN("all", "'id:3++id:4'"), CODE_INPUT, { "a part has no name" } },
        { TREES RUN("all", "'<b>&'"), CODE_INPUT, { "has no such branch" } },
        { TREES RUN("all", "id:3 --solver chain"), CODE_INPUT, { "with the solver 'chain'" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(as_drawn), cmocka_unit_test(refused) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
