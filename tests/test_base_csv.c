/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables from spreadsheets. */
#include "base/csv.h"
#include "close.h"
#include "scratch.h"
#include <time.h>
#include <unistd.h>

struct table {
    struct scratch file;
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    struct wf_csv csv;
    enum wf_status status;
};

static void open_bytes(struct table *t, const char *text, size_t size)
{
    memset(t, 0, sizeof *t);
    t->diag.arena = &t->arena;
    scratch_write(&t->file, text, size);
    t->status = wf_csv_open(&t->csv, t->file.path, &t->arena, &t->diag, &t->err);
}

static void open_text(struct table *t, const char *text) { open_bytes(t, text, strlen(text)); }

static void close_table(struct table *t)
{
    wf_arena_free(&t->arena);
    scratch_remove(&t->file);
}

/* All rows as "cell|cell/cell|cell". */
static const char *rows(struct table *t)
{
    static char buf[4096];
    size_t n = 0;
    *buf = '\0';
    while (wf_csv_next(&t->csv)) {
        for (size_t i = 0; i < t->csv.columns; i++)
            n += (size_t)snprintf(buf + n, sizeof buf - n, "%s%s",
                                  i   ? "|"
                                  : n ? "/"
                                      : "",
                                  wf_csv_text(&t->csv, i));
        assert_true(n < sizeof buf);
    }
    return buf;
}

static void dialects_are_understood(void **state)
{
    (void)state;
    static const struct {
        const char *text, *want;
        char separator;
    } good[] = {
        { "id,name\n1,oak\n2,fir\n", "1|oak/2|fir", ',' },
        { "id,name\n1,oak\n2,fir", "1|oak/2|fir", ',' },
        { "id,name\r\n1,oak\r\n2,fir\r\n", "1|oak/2|fir", ',' },
        { "id,name\r1,oak\r2,fir\r", "1|oak/2|fir", ',' },
        { "\xEF\xBB\xBFid,name\n1,oak\n", "1|oak", ',' },
        { "id;name\n1;oak, old\n", "1|oak, old", ';' },
        { "id\tname\n1\toak\n\tfir\n3\t\n", "1|oak/|fir/3|", '\t' },
        { " id , name \n 1 , oak \n", "1|oak", ',' },
        { "# made by hand\n\nid,name\n# a remark\n   \n1,oak\n\n\n", "1|oak", ',' },
        { "id,name\n1,\"a, \"\"b\"\"\"\n", "1|a, \"b\"", ',' },
        { "id,name\n1,\"two\nlines\"\n2,fir\n", "1|two\nlines/2|fir", ',' },
        { "id,name\n\"1\" , \"\"\n", "1|", ',' },
        { "\"a;b\",c\n1,2\n", "1|2", ',' },
        { "name\noak\nfir\n", "oak/fir", ',' },
        { "\xE6\xAF\x9B,\xE7\xAB\xB9\n1,2\n", "1|2", ',' },
        { "a,b,\n1,2,\n", "1|2|", ',' },
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        struct table t;
        open_text(&t, good[i].text);
        if (t.status) fail_msg("table %zu: %s", i, t.err.text);
        assert_int_equal(t.csv.separator, good[i].separator);
        assert_string_equal(rows(&t), good[i].want);
        assert_int_equal(t.diag.errors, 0);
        close_table(&t);
    }
}

static void broken_rows_are_named_and_the_rest_is_kept(void **state)
{
    (void)state;
    static const struct {
        const char *text, *want, *findings;
    } bad[] = {
        { "a,b\n1,2\n3\n4,5\n6,7,8\n9,10\n", "1|2/4|5/9|10",
          "3:0: 1 cells, the header has 2\n5:0: 3 cells, the header has 2" },
        { "a,b\n1,x\"y\n2,3\n", "2|3", "2:3: a quote inside a cell that does not start with one" },
        { "a,b\n1,\"y\n2,3\n", "2|3", "2:3: a quote is opened here and never closed" },
        { "a,b\n1,\"y\" z\n2,3\n", "2|3", "2:3: text follows a closing quote" },
        { "a,b\n1,\"y\n2,\"3\n4,5\n", "4|5",
          "2:3: text follows a closing quote\n3:3: a quote is opened here and never closed" },
        { "a,b\n\"1\n1\",2\n3\n4,5\n", "1\n1|2/4|5", "4:0: 1 cells, the header has 2" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct table t;
        char text[1024];
        open_text(&t, bad[i].text);
        assert_int_equal(t.status, WF_OK);
        assert_string_equal(rows(&t), bad[i].want);
        findings_print(&t.diag, text, sizeof text);
        assert_string_equal(text, bad[i].findings);
        close_table(&t);
    }
}

static void headers_that_cannot_be_used(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        size_t size;
        const char *error, *findings;
    } bad[] = {
        { "", 0, "the table is empty: a header row is expected", "" },
        { "# only\n\n", 8, "the table is empty: a header row is expected", "" },
        { "a,b,A\n", 6, "the header row is not usable", "1:5: column 'A' occurs twice" },
        { "a,\"b\n", 5, "the header row is not usable", "1:3: a quote is opened here and never closed" },
        { "a,b\n\x81\n", 6, ":2:1: byte 0x81 is not UTF-8 text; save the file as UTF-8", "" },
        { "a,\xC3\xA9\n\xFF,1\n", 10, ":2:1: byte 0xFF is not UTF-8 text; save the file as UTF-8", "" },
        { "a,b\n1,\0\n", 8, ":2:3: byte 0x00 is not UTF-8 text; save the file as UTF-8", "" },
        { "\xFF\xFE"
          "a\0\0\xD8",
          6, ":1:1: the file is broken UTF-16 text; save it as UTF-8", "" },
        { "\xFE\xFF\0a\n", 5, ":1:1: the file is broken UTF-16 text", "" },
        { "# missing: none\na,b\n", 20, ":1: error: missing marks are numbers", "" },
        { "\"TOB1\",\"a\",\"b\"\n", 15, "its rows are binary", "" },
        { "[project]\na\n", 12, "sections without [data]", "" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct table t;
        char text[1024];
        open_bytes(&t, bad[i].text, bad[i].size);
        assert_int_equal(t.status, WF_EINPUT);
        assert_non_null(strstr(t.err.text, bad[i].error));
        assert_memory_equal(t.err.text, t.file.path, strlen(t.file.path));
        findings_print(&t.diag, text, sizeof text);
        assert_string_equal(text, bad[i].findings);
        close_table(&t);
    }
}

static void columns_are_found_by_name(void **state)
{
    (void)state;
    struct table t;
    char text[1024];
    open_text(&t, "Tree_ID, Diameter_cm ,height_m\n1,2,3\n");
    assert_int_equal(wf_csv_column(&t.csv, "diameter_CM"), 1);
    assert_int_equal(wf_csv_need(&t.csv, "tree_id"), 0);
    assert_true(wf_csv_column(&t.csv, "nothing") == WF_CSV_NONE);
    assert_true(wf_csv_need(&t.csv, "diametre_cm") == WF_CSV_NONE);
    assert_true(wf_csv_need(&t.csv, "speed") == WF_CSV_NONE);
    findings_print(&t.diag, text, sizeof text);
    assert_string_equal(text,
                        "1:10: column 'diametre_cm' is missing; is it 'Diameter_cm'?\n"
                        "1:0: column 'speed' is missing; the header has: Tree_ID, Diameter_cm, height_m");
    assert_true(wf_csv_next(&t.csv));
    assert_string_equal(wf_csv_text(&t.csv, WF_CSV_NONE), "");
    close_table(&t);
}

static void cells_become_numbers(void **state)
{
    (void)state;
    struct table t;
    char text[2048];
    double v = 7;
    open_text(&t, "id;d\n1;3,25\n2;-1e-3\n3;\n4;tall\n5;3.25\n6;1.234,5\n7;200\n8;nan\n9;1 2\n");
    static const bool ok[] = { true, true, false, false, false, false, false, false, false };
    static const double want[] = { 3.25, -1e-3, -1e-3, -1e-3, -1e-3, -1e-3, -1e-3, -1e-3, -1e-3 };
    for (size_t i = 0; wf_csv_next(&t.csv); i++) {
        assert_int_equal(wf_csv_number(&t.csv, 1, -100, 100, &v), ok[i]);
        assert_close(v, want[i], 0);
    }
    findings_print(&t.diag, text, sizeof text);
    assert_string_equal(text, "4:3: d: is empty, a number is expected\n"
                              "5:3: d: 'tall' is not a number\n"
                              "6:3: d: '3.25': decimal comma and decimal point are mixed in this file\n"
                              "7:3: d: '1.234,5': decimal comma and decimal point are mixed in this file\n"
                              "8:3: d: 200 is outside -100 to 100\n"
                              "9:3: d: 'nan' is not a number\n"
                              "10:3: d: '1 2' is not a number");
    close_table(&t);
}

static void cells_become_whole_numbers(void **state)
{
    (void)state;
    struct table t;
    char text[1024];
    long long v = 0, sum = 0;
    open_text(&t, "id\n12\n-3\n+4\n1.5\nx\n\"\"\n101\n99999999999999999999\n-\n");
    while (wf_csv_next(&t.csv))
        if (wf_csv_integer(&t.csv, 0, -100, 100, &v)) sum += v;
    assert_int_equal(sum, 13);
    findings_print(&t.diag, text, sizeof text);
    assert_string_equal(
        text, "5:1: id: '1.5' is not a whole number\n6:1: id: 'x' is not a whole number\n"
              "7:1: id: is empty, a whole number is expected\n8:1: id: 101 is outside -100 to 100\n"
              "9:1: id: '99999999999999999999' is not a whole number\n10:1: id: '-' is not a whole number");
    close_table(&t);
}

static void many_mistakes_are_counted_not_listed(void **state)
{
    (void)state;
    static char text[16384];
    size_t n = (size_t)snprintf(text, sizeof text, "a,b\n");
    for (int i = 0; i < 1000; i++) n += (size_t)snprintf(text + n, sizeof text - n, "%d\n", i);
    struct table t;
    open_text(&t, text);
    assert_string_equal(rows(&t), "");
    assert_int_equal(t.csv.mistakes, 1000);
    assert_int_equal(t.diag.errors, 1000);
    size_t listed = 0;
    for (const struct wf_finding *f = t.diag.first; f; f = f->next) listed++;
    assert_int_equal(listed, WF_CSV_LISTED + 1);
    assert_string_equal(t.diag.last->text, "more than 100 mistakes; the rest is counted but not listed");
    close_table(&t);
}

/* A wide range of junk must neither crash nor hang: every byte pair in a small table. */
static void junk_is_survived(void **state)
{
    (void)state;
    static const char alphabet[] = ",;\t\"\n\r# a1.-";
    unsigned seed = 1;
    for (int k = 0; k < 400; k++) {
        char text[40];
        for (size_t i = 0; i < sizeof text; i++) {
            seed = seed * 1664525u + 1013904223u;
            text[i] = alphabet[(seed >> 20) % (sizeof alphabet - 1)];
        }
        struct table t;
        open_bytes(&t, text, sizeof text);
        double v;
        for (size_t n = 0; t.status == WF_OK && wf_csv_next(&t.csv); n++) {
            for (size_t i = 0; i < t.csv.columns; i++) {
                assert_int_equal(strlen(wf_csv_text(&t.csv, i)), t.csv.cell[i].size);
                (void)wf_csv_number(&t.csv, i, -1, 1, &v);
            }
            assert_true(n < sizeof text);
        }
        close_table(&t);
    }
}

static void a_long_table_is_quick(void **state)
{
    (void)state;
    enum { ROWS = 200000 };
    char *text = malloc(64 * ROWS);
    size_t n = (size_t)sprintf(text, "id,x,y,z\n");
    for (int i = 0; i < ROWS; i++)
        n += (size_t)sprintf(text + n, "%d,%.6f,%.3f,%.9f\n", i, i * 0.001, i * 0.5, i / 7.0);
    struct table t;
    open_bytes(&t, text, n);
    free(text);
    double v, sum = 0;
    long long id, ids = 0;
    clock_t start = clock();
    while (wf_csv_next(&t.csv)) {
        assert_true(wf_csv_integer(&t.csv, 0, 0, ROWS, &id));
        ids += id;
        for (size_t c = 1; c < 4; c++) {
            assert_true(wf_csv_number(&t.csv, c, 0, 1e9, &v));
            sum += v;
        }
    }
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    print_message("%d rows of 4 cells: %.3f s\n", ROWS, seconds);
    assert_int_equal(ids, (long long)ROWS * (ROWS - 1) / 2);
    double all = (double)ids * (0.001 + 0.5 + 1 / 7.0);
    assert_close(sum, all, 1e-9);
    close_table(&t);
}

/* Each row opens a quote that is never closed: the time must not grow with the square of the size. */
static void open_quotes_are_quick(void **state)
{
    (void)state;
    enum { ROWS = 200000 };
    char *text = malloc(16 * ROWS);
    size_t n = (size_t)sprintf(text, "id,x\n");
    for (int i = 0; i < ROWS; i++) n += (size_t)sprintf(text + n, "\"%06d,1\n5,6\n", i);
    struct table t;
    open_bytes(&t, text, n);
    free(text);
    alarm(60); /* ends the program where the time grows with the square: then it is minutes */
    while (wf_csv_next(&t.csv)) continue;
    alarm(0);
    assert_true(t.diag.errors > 0);
    close_table(&t);
}

static void a_quoted_cell_is_bounded(void **state)
{
    (void)state;
    static const char head[] = "a,b\n1,\"", tail[] = "\"\n2,3\n";
    for (int over = 0; over < 2; over++) {
        size_t long_cell = WF_CSV_QUOTED - 2 + (size_t)over;
        char *text = malloc(WF_CSV_QUOTED + 64);
        memcpy(text, head, sizeof head - 1);
        memset(text + sizeof head - 1, 'x', long_cell);
        memcpy(text + sizeof head - 1 + long_cell, tail, sizeof tail - 1);
        struct table t;
        open_bytes(&t, text, sizeof head - 1 + long_cell + sizeof tail - 1);
        free(text);
        assert_true(wf_csv_next(&t.csv));
        assert_string_equal(wf_csv_text(&t.csv, 0), over ? "2" : "1");
        assert_int_equal(t.diag.errors, over);
        if (over) {
            assert_string_equal(t.diag.first->text, "a quote is opened here and not closed within 64 kB");
            assert_int_equal(t.diag.first->line, 2);
        }
        close_table(&t);
    }
}

/* A spreadsheet's error in the first cell is a missing value, not a comment. */
static void an_error_in_the_first_cell_is_a_row(void **state)
{
    struct table t;
    double v;
    (void)state;
    open_text(&t, "a,b\n#N/A,1\n# a comment, 2\n#DIV/0!,3\n");
    for (int k = 0; k < 2; k++) {
        assert_true(wf_csv_next(&t.csv));
        assert_int_equal(wf_csv_value(&t.csv, 0, &v), WF_CSV_MISSING);
        assert_true(wf_csv_number(&t.csv, 1, 0, 10, &v));
        assert_true(fabs(v - (k ? 3 : 1)) < 1e-12);
    }
    assert_false(wf_csv_next(&t.csv));
    close_table(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dialects_are_understood),
        cmocka_unit_test(broken_rows_are_named_and_the_rest_is_kept),
        cmocka_unit_test(headers_that_cannot_be_used),
        cmocka_unit_test(columns_are_found_by_name),
        cmocka_unit_test(cells_become_numbers),
        cmocka_unit_test(cells_become_whole_numbers),
        cmocka_unit_test(many_mistakes_are_counted_not_listed),
        cmocka_unit_test(junk_is_survived),
        cmocka_unit_test(a_long_table_is_quick),
        cmocka_unit_test(open_quotes_are_quick),
        cmocka_unit_test(a_quoted_cell_is_bounded),
        cmocka_unit_test(an_error_in_the_first_cell_is_a_row),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
