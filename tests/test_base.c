/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors, arena, findings, numbers, near words, UTF-8. */
#include "base/arena.h"
#include "base/err.h"
#include "base/num.h"
#include "base/text.h"
#include "close.h"
#include <stdlib.h>
#include <string.h>

static void first_error_wins(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    assert_int_equal(wf_fail(&e, WF_EINPUT, "row %d", 7), WF_EINPUT);
    assert_int_equal(wf_fail(&e, WF_ENOMEM, "later"), WF_ENOMEM);
    assert_int_equal(e.code, WF_EINPUT);
    assert_string_equal(e.text, "row 7");
    assert_int_equal(wf_fail(NULL, WF_EUSAGE, "nobody listens"), WF_EUSAGE);
    for (int i = 0; i < WF_STATUS_COUNT; i++) assert_true(strlen(wf_status_text((enum wf_status)i)) > 0);
    assert_string_equal(wf_status_text((enum wf_status)99), "unknown status");
}

static void arena_is_aligned_and_zeroed(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    for (size_t n = 0; n < 300; n++) {
        unsigned char *p = wf_arena_take(&a, n, 7);
        assert_non_null(p);
        assert_int_equal((uintptr_t)p % 64, 0);
        for (size_t k = 0; k < 7 * n; k++) assert_int_equal(p[k], 0);
        memset(p, 0xA5, 7 * n);
        char *text = wf_arena_print(&a, "%zu apples", n);
        assert_int_equal(strtoul(text, NULL, 10), n);
    }
    double *large = WF_TAKE(&a, 3000000, double);
    assert_non_null(large);
    large[2999999] = 1;
    assert_null(wf_arena_take(&a, SIZE_MAX / 2, 3));
    assert_null(wf_arena_take(&a, SIZE_MAX - 8, 1));
    wf_arena_free(&a);
    assert_int_equal(a.used, 0);
    assert_string_equal(wf_arena_text(&a, "again"), "again");
    wf_arena_free(&a);
}

/* Blocks that were freed serve other arenas: zeroed where they are handed out, wherever they were written. */
static void spare_blocks_are_zeroed(void **state)
{
    (void)state;
    for (size_t round = 0; round < 40; round++) {
        struct wf_arena a[2] = { { 0 }, { 0 } };
        for (size_t k = 0; k < 12; k++) {
            size_t n = ((round * 7919 + k * 104729) % 300000) + 1;
            unsigned char *p = wf_arena_take(&a[k % 2], n, 3);
            assert_non_null(p);
            for (size_t i = 0; i < 3 * n; i++)
                if (p[i]) fail_msg("byte %zu of %zu is not zero", i, 3 * n);
            memset(p, 0xA5, k % 3 ? 3 * n : n);
        }
        wf_arena_free(&a[round % 2]);
        wf_arena_free(&a[1 - round % 2]);
        if (round % 10 == 9) wf_arena_drop_spare();
    }
}

/* The same of blocks that are larger than any step, and of arenas that are content with a smaller one. */
static void large_spare_blocks_are_zeroed(void **state)
{
    (void)state;
    const size_t n = 40000000;
    for (size_t round = 0; round < 3; round++) {
        struct wf_arena a = { 0 }, other = { 0 };
        unsigned char *first = wf_arena_take(&a, round + 1, 100), *p = wf_arena_take(&a, n - round, 1);
        unsigned char *more = wf_arena_take(&other, n / 100, 1 + round);
        assert_true(first && p && more);
        for (size_t i = 0; i < n - round; i++)
            if (p[i]) fail_msg("round %zu: byte %zu of %zu is not zero", round, i, n);
        for (size_t i = 0; i < n / 100; i++) assert_int_equal(more[i], 0);
        memset(p, 0xA5, n - round), memset(more, 0xA5, n / 100);
        wf_arena_free(&a);
        wf_arena_free(&other);
    }
    wf_arena_drop_spare();
}

/* The same takes succeed at one capacity and are refused cleanly at every smaller one. */
static bool takes(size_t limit, size_t *used)
{
    struct wf_arena a = { .limit = limit };
    bool ok = WF_TAKE(&a, 3, double) && wf_arena_text(&a, "moso") && WF_TAKE(&a, 40, double) &&
              wf_arena_print(&a, "%d mm", 52) && WF_TAKE(&a, 2500, double) && wf_arena_take(&a, 0, 8);
    *used = a.used;
    assert_true(!limit || a.used <= limit);
    wf_arena_free(&a);
    return ok;
}

static void arena_refuses_at_every_smaller_capacity(void **state)
{
    (void)state;
    size_t need, used;
    assert_true(takes(0, &need));
    assert_true(takes(need, &used));
    for (size_t limit = 1; limit < need; limit++) assert_false(takes(limit, &used));
}

static void findings_are_kept_in_order(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    char buf[128];
    wf_diag_error(&d, "a.yaml", 3, 5, "%s is wrong", "density");
    wf_diag_error(&d, "a.yaml", 4, 0, "cells");
    wf_diag_error(&d, "a.yaml", 0, 0, "empty");
    wf_diag_error(&d, NULL, 0, 0, "tree");
    wf_diag_warn(&d, "small-deflection", "%d %%", 12);
    wf_diag_warn(&d, "small-deflection", "%d %%", 12);
    wf_diag_warn(&d, "small-deflection", "%d %%", 13);
    assert_int_equal(d.errors, 4);
    assert_int_equal(d.warnings, 2);
    static const char *const want[] = { "a.yaml:3:5: error: density is wrong",
                                        "a.yaml:4: error: cells",
                                        "a.yaml: error: empty",
                                        "error: tree",
                                        "warning [small-deflection]: 12 %",
                                        "warning [small-deflection]: 13 %" };
    const struct wf_finding *f = d.first;
    for (size_t i = 0; i < sizeof want / sizeof *want; i++, f = f->next)
        assert_string_equal(wf_finding_print(f, buf, sizeof buf), want[i]);
    assert_null(f);
    wf_arena_free(&a);
}

static void findings_are_sorted_by_place(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    wf_diag_sort(&d, NULL);
    wf_diag_error(&d, "f", 9, 9, "earlier file");
    struct wf_finding *before = d.last;
    static const size_t place[][2] = { { 3, 1 }, { 0, 0 }, { 1, 7 }, { 3, 1 }, { 1, 2 }, { 2, 0 } };
    for (size_t i = 0; i < 6; i++) wf_diag_error(&d, "g", place[i][0], place[i][1], "%c", (char)('a' + i));
    wf_diag_sort(&d, before);
    char order[8] = "";
    size_t n = 0;
    for (const struct wf_finding *f = before->next; f; f = f->next) order[n++] = f->text[0];
    assert_string_equal(order, "ecfadb");
    assert_ptr_equal(d.first, before);
    wf_diag_sort(&d, NULL);
    assert_string_equal(d.last->text, "b");
    wf_diag_error(&d, "h", 1, 1, "added");
    assert_string_equal(d.last->text, "added");
    wf_arena_free(&a);
}

static void findings_are_counted_without_room(void **state)
{
    (void)state;
    for (size_t limit = 1; limit < 400; limit++) {
        struct wf_arena a = { .limit = limit };
        struct wf_diag d = { .arena = &a };
        for (int i = 0; i < 3; i++) wf_diag_error(&d, "file", 1, 1, "mistake %d", i);
        assert_int_equal(d.errors, 3);
        for (const struct wf_finding *f = d.first; f; f = f->next) assert_memory_equal(f->text, "mistake", 7);
        wf_arena_free(&a);
    }
}

static double number(const char *text, char point, size_t used)
{
    double v = NAN;
    const char *stop = wf_number_read(text, text + strlen(text), point, &v);
    if (!stop) return NAN;
    assert_int_equal(stop - text, used);
    return v;
}

static void numbers_are_read_exactly(void **state)
{
    (void)state;
    static const char *const text[] = { "0",
                                        "1",
                                        "-1",
                                        "+2.5",
                                        ".5",
                                        "5.",
                                        "0.1",
                                        "1e3",
                                        "1E-3",
                                        "123456789012345678901234567890",
                                        "9007199254740993",
                                        "0.000001234567890123456789",
                                        "1.7976931348623157e308",
                                        "4.9e-324",
                                        "2.2250738585072011e-308",
                                        "1e22",
                                        "1e23",
                                        "8.988465674311579e+307",
                                        "-0.0",
                                        "000012.50",
                                        "0.30000000000000004",
                                        "123456.789e-7",
                                        "9999999999999999999",
                                        "1e-22",
                                        "3e-23",
                                        "0e99999",
                                        "1234567890123456789e-20" };
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        double want = strtod(text[i], NULL), got = number(text[i], '.', strlen(text[i]));
        assert_memory_equal(&got, &want, sizeof got);
    }
    unsigned long long seed = 42;
    char buf[64];
    for (int i = 0; i < 20000; i++) {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        double v;
        memcpy(&v, &seed, sizeof v);
        if (!isfinite(v)) continue;
        snprintf(buf, sizeof buf, i % 2 ? "%.17g" : "%.9g", v);
        double want = strtod(buf, NULL), got = number(buf, '.', strlen(buf));
        if (isinf(want)) continue;
        assert_memory_equal(&got, &want, sizeof got);
    }
    assert_close(number("3,25", ',', 4), 3.25, 0);
    assert_close(number("1,234567890123456789012345", ',', 26), 1.234567890123456789012345, 0);
    assert_close(number("6.1 GPa", '.', 3), 6.1, 0);
    assert_close(number("5e GPa", '.', 1), 5, 0);
    assert_close(number("5e+", '.', 1), 5, 0);
    assert_close(number("1.2.3", '.', 3), 1.2, 0);
}

static void what_is_no_number(void **state)
{
    (void)state;
    static const char *const text[] = { "",    "-",    "+", ".",  "-.",    "e5",     "nan",   "NaN",
                                        "inf", "-inf", "x", " 1", "1e999", "-1e400", "1e-999" };
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        double v;
        assert_null(wf_number_read(text[i], text[i] + strlen(text[i]), '.', &v));
    }
    assert_close(number("0x10", '.', 1), 0, 0); /* stops before the x */
    char many[400];
    memset(many, '7', sizeof many - 1);
    many[sizeof many - 1] = '\0';
    assert_true(isnan(number(many, '.', 0)));
    many[200] = '\0';
    assert_close(number(many, '.', 200), strtod(many, NULL), 0);
}

static void near_words(void **state)
{
    (void)state;
    static const char *const keys[] = { "density", "radius", "wall", "name" };
    assert_int_equal(wf_word_distance("density", "density"), 0);
    assert_int_equal(wf_word_distance("densty", "density"), 1);
    assert_int_equal(wf_word_distance("desnity", "density"), 1);
    assert_int_equal(wf_word_distance("Density", "density"), 0);
    assert_int_equal(wf_word_distance("kitten", "sitting"), 3);
    assert_int_equal(wf_word_distance("", "abc"), 3);
    assert_int_equal(wf_word_distance("ca", "abc"), 3);
    assert_string_equal(wf_nearest("densty", keys, 4), "density");
    assert_string_equal(wf_nearest("raduis", keys, 4), "radius");
    assert_null(wf_nearest("youngs_modulus", keys, 4));
    assert_string_equal(wf_nearest("den", keys, 4), "density");
    assert_string_equal(wf_nearest("wall_thickness", keys, 4), "wall");
    assert_null(wf_nearest("na", (const char *const[]){ "national" }, 1));
    assert_null(wf_nearest("x", keys, 4));
    char big[100];
    memset(big, 'a', 99);
    big[99] = '\0';
    assert_null(wf_nearest(big, keys, 4));
}

static void utf8_faults_are_placed(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        size_t size, line, column;
    } bad[] = {
        { "ab\xFF", 3, 1, 3 },
        { "ab\n\xC3(", 5, 2, 1 },
        { "\xE6\xAF\x9B\xE7", 4, 1, 2 },
        { "\xC0\x80", 2, 1, 1 },
        { "\xED\xA0\x80", 3, 1, 1 },
        { "\xF4\x90\x80\x80", 4, 1, 1 },
        { "\xE0\x80\x80", 3, 1, 1 },
        { "\xF0\x80\x80\x80", 4, 1, 1 },
        { "12345678901234\0", 15, 1, 15 },
        { "aaaaaaaaaaaaaaaaaaaa\x80", 21, 1, 21 },
    };
    struct wf_utf8_fault fault;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(wf_utf8_valid(bad[i].text, bad[i].size, &fault));
        assert_int_equal(fault.line, bad[i].line);
        assert_int_equal(fault.column, bad[i].column);
    }
    const char *good = "毛竹, Phyllostachys edulis, \xF0\x9F\x8C\xB2, \x7F, ok";
    assert_true(wf_utf8_valid(good, strlen(good), &fault));
    assert_true(wf_utf8_valid("", 0, &fault));
}

/* Text of users: nothing acts on a terminal, nothing is refused by XML, nothing overflows its place. */
static void text_of_users(void **state)
{
    (void)state;
    static const struct {
        const char *given, *terminal, *xml;
    } rows[] = {
        { "plain \xe6\x9f\xb3 \xc2\xb0 '\"`$\\", "plain \xe6\x9f\xb3 \xc2\xb0 '\"`$\\",
          "plain \xe6\x9f\xb3 \xc2\xb0 '\"`$\\" },
        { "two\nlines\t", "two\\x0alines\t", "two\nlines\t" },
        { "\x1b[31mred\r\x7f", "\\x1b[31mred\n\\x7f", "\xef\xbf\xbd[31mred\r\x7f" },
        { "\xc2\x9b"
          "31m",
          "\\u009b31m",
          "\xc2\x9b"
          "31m" },
        { "a\xe2\x80\xae"
          "b\xe2\x81\xa6",
          "a\\u202eb\\u2066",
          "a\xe2\x80\xae"
          "b\xe2\x81\xa6" },
        { "a\xff\xc3", "a\\xff\\xc3", "a\xef\xbf\xbd\xef\xbf\xbd" },
        { "\xef\xbf\xbe\xef\xbf\xbd", "\xef\xbf\xbe\xef\xbf\xbd", "\xef\xbf\xbd\xef\xbf\xbd" },
        { "\xf0\x9f\x8c\xb3", "\xf0\x9f\x8c\xb3", "\xf0\x9f\x8c\xb3" },
        { "", "", "" },
    };
    struct wf_arena a = { 0 };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        assert_string_equal(wf_text_for_terminal(rows[i].given, '\r', &a), rows[i].terminal);
        assert_string_equal(wf_text_for_xml(rows[i].given, &a), rows[i].xml);
    }
    assert_string_equal(wf_text_shortened("abcdef", 6, &a), "abcdef");
    assert_string_equal(wf_text_shortened("abcdefg", 6, &a), "abcde\xe2\x80\xa6");
    assert_string_equal(wf_text_shortened("\xe6\x9f\xb3\xe6\x9f\xb3", 4, &a), "\xe6\x9f\xb3\xe6\x9f\xb3");
    assert_string_equal(wf_text_shortened("\xe6\x9f\xb3\xe6\x9f\xb3"
                                          "b",
                                          4, &a),
                        "\xe6\x9f\xb3\xe2\x80\xa6");
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(first_error_wins),
        cmocka_unit_test(arena_is_aligned_and_zeroed),
        cmocka_unit_test(spare_blocks_are_zeroed),
        cmocka_unit_test(large_spare_blocks_are_zeroed),
        cmocka_unit_test(arena_refuses_at_every_smaller_capacity),
        cmocka_unit_test(findings_are_kept_in_order),
        cmocka_unit_test(findings_are_sorted_by_place),
        cmocka_unit_test(findings_are_counted_without_room),
        cmocka_unit_test(numbers_are_read_exactly),
        cmocka_unit_test(what_is_no_number),
        cmocka_unit_test(near_words),
        cmocka_unit_test(text_of_users),
        cmocka_unit_test(utf8_faults_are_placed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
