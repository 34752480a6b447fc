/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables as a workbook: cells, texts that look like formulas, what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "out/workbook.h"
#include "shell.h"

/* Print a sheet of a workbook: "A1 text|..." as python reads the archive. */
#define SHEET(n)                                                                                             \
    "python3 -c 'import zipfile, re, sys; print(re.sub(\"<row|</row>\", \"\\n\", "                           \
    "zipfile.ZipFile(sys.argv[1])"                                                                           \
    ".read(\"xl/worksheets/sheet" n ".xml\").decode()))' $T/"

static void cells_are_text_or_numbers(void **state)
{
    struct wf_workbook *w;
    struct wf_err e = { 0 };
    char path[300];
    (void)state;
    shell("true");
    (void)snprintf(path, sizeof path, "%s/book.xlsx", scratch);
    enum wf_status s = wf_workbook_open(&w, path, "a/b:c", &e);
    if (s == WF_EMISSING) skip();
    if (s) fail_msg("%s", e.text);
    static const char *const row[] = { "=1+1", "-2.5e3", "12 m", "0x10", "+4", "nan", "a\nb & <c>", "" };
    for (size_t r = 0; r < 2; r++)
        for (size_t c = 0; c < 8; c++) wf_workbook_cell(w, r, c, row[c], true);
    if (wf_workbook_close(w, &e)) fail_msg("%s", e.text);
    char command[600];
    (void)snprintf(
        command, sizeof command,
        "cp %s.kept $T/book.xlsx; " SHEET(
            "1") "book.xlsx; python3 -c 'import zipfile, sys; "
                 "print(zipfile.ZipFile(sys.argv[1]).read(\"xl/workbook.xml\").decode())' $T/book.xlsx",
        scratch);
    char kept[300];
    (void)snprintf(kept, sizeof kept, "%s.kept", scratch);
    assert_int_equal(rename(path, kept), 0);
    int code = shell(command);
    remove(kept);
    assert_int_equal(code, 0);
    static const char *const cells[] = { "<t>=1+1</t>",          "<v>-2500</v>",  "<t>12 m</t>",
                                         "<t>0x10</t>",          "<v>4</v>",      "<t>nan</t>",
                                         "a\nb &amp; &lt;c&gt;", "name=\"a_b_c\"" };
    for (size_t k = 0; k < sizeof cells / sizeof *cells; k++)
        if (!strstr(output, cells[k])) fail_msg("no %s in %s", cells[k], output);
    assert_null(strstr(output, "<f>"));
    assert_int_equal(wf_workbook_close(NULL, &e), WF_OK);
    assert_int_equal(wf_workbook_open(&w, "/nowhere/book.xlsx", "a", &e), WF_EOUTPUT);
    assert_null(w);
}

static void a_run_writes_one(void **state)
{
    (void)state;
    if (shell("$W analyze moso_bamboo $RUN --xlsx --quiet --samples 0") == CODE_RUN &&
        strstr(output, "libxlsxwriter"))
        skip();
    static const struct row rows[] = {
        { "$W analyze moso_bamboo $RUN --xlsx --samples 0 && ls $T/out/tables && " SHEET(
              "3") "out/tables/tables.xlsx",
          CODE_OK,
          { "tables.xlsx", "<t>moso_bamboo</t>", "<v>10</v>" } },
        { "$W analyze moso_bamboo $RUN --samples 0; $W report $T/out --no-pdf --xlsx && ls $T/out/tables && "
          "cp $T/out/tables/tables.xlsx $T/a && sleep 1.1 && $W report $T/out --no-pdf --xlsx && cmp $T/a "
          "$T/out/tables/tables.xlsx && echo same",
          CODE_OK,
          { "tables.xlsx", "same" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_are_text_or_numbers),
        cmocka_unit_test(a_run_writes_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
