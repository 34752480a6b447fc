/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages for a word processor: what pandoc makes of them, converted back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"
#include <stdbool.h>

static bool no_pandoc(void)
{
    if (!shell("command -v pandoc && command -v gnuplot")) return false;
    print_message("no pandoc (Debian package pandoc): pages for a word processor were not tried\n");
    return true;
}

#define MADE                                                                                                 \
    "$W compare oak beech --model oak_20m --soil mineral --wind 15,25 --samples 0 --no-pdf -q -o $T/out "    \
    "--docx "                                                                                                \
    "2>&1 >/dev/null | grep -v streamline-range; "

static void numbers_come_back(void **state)
{
    (void)state;
    if (no_pandoc()) skip();
    static const struct row rows[] = {
        { MADE "python3 tests/docx.py $T/out report; ls $T/out/plots | grep -c -e large -e page",
          CODE_RUN,
          { "docx: ", " numbers, 4 pictures", "\n0\n" } },
        { MADE
          "$W report $T/out --lang zh --units cn --docx --no-pdf -q && python3 tests/docx.py $T/out report",
          CODE_OK,
          { "docx: " } },
        /* one that is not made anew does not stay */
        { MADE "$W report $T/out --no-pdf -q && ls $T/out",
          CODE_OK,
          { "plots\nreport.html\nresults.json\n" } },
        { "$W modes oak --model culm --wind 0,10 --no-pdf -q -o $T/out --docx >/dev/null 2>&1; python3 "
          "tests/docx.py $T/out modes",
          CODE_OK,
          { "docx: " } },
    };
    CHECK(rows);
}

/* Names are words in it, whatever they hold. */
static void names_are_words(void **state)
{
    (void)state;
    if (no_pandoc()) skip();
    static const struct row rows[] = {
        { "$W analyze oak --model culm --wind 10 --samples 0 --no-pdf -q -o $T/out --docx --title "
          "'![](/etc/passwd) <img "
          "src=/etc/passwd> `<w:p/>`{=openxml}' >/dev/null 2>&1; pandoc -t plain --wrap none "
          "$T/out/report.docx | head -1",
          CODE_OK,
          { "![](/etc/passwd) <img src=/etc/passwd> `<w:p/>`{=openxml}\n" } },
    };
    CHECK(rows);
}

static void without_pandoc_it_is_refused(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "mkdir $T/bin; PATH=$T/bin $W analyze oak --model culm --wind 10 -o $T/out --docx; echo $?; ls $T",
          CODE_OK,
          { "windfirm analyze: --docx: pandoc is not installed: install the package pandoc", "\n2\nbin\n" } },
        { "$W analyze oak --model culm --wind 10 -o $T/out --docx --no-report", CODE_INPUT, { "--docx" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_come_back),
        cmocka_unit_test(names_are_words),
        cmocka_unit_test(without_pandoc_it_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
