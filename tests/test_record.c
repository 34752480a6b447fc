/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Anemometer files: what is bridged, what is refused, what the axes become. */
#include "base/random.h"
#include "close.h"
#include "wind/gust.h"
#include "wind/record.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[64];

static void write_file(const char *text)
{
    strcpy(path, "/tmp/wf_recordXXXXXX");
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), strlen(text));
    close(fd);
}

/* 200 rows at 10 Hz: u = 3, v = 4, w = 1 and a little noise; `spoil` may change a row. */
static char *rows(void (*spoil)(int i, char *row))
{
    char *text = calloc(200, 64), row[128];
    assert_non_null(text);
    strcpy(text, "t_s,u_ms,v_ms,w_ms\n");
    for (int i = 0; i < 200; i++) {
        double n = 0.1 * wf_random_normal(1, 1, (uint64_t)i);
        snprintf(row, sizeof row, "%.1f,%.4f,%.4f,%.4f\n", i / 10.0, 3 + 3 * n, 4 + 4 * n, 1 + n);
        if (spoil) spoil(i, row);
        strcat(text, row);
    }
    return text;
}

static struct wf_record record;
static struct wf_arena arena;
static struct wf_err err;
static struct wf_diag diag;

static enum wf_status read_rows_gap(void (*spoil)(int, char *), double gap)
{
    struct wf_record_request q;
    wf_record_request_default(&q);
    q.gap = gap;
    char *text = rows(spoil);
    write_file(text);
    free(text);
    wf_arena_free(&arena);
    memset(&err, 0, sizeof err);
    diag = (struct wf_diag){ .arena = &arena };
    enum wf_status s = wf_record_read(path, &q, &arena, &diag, &record, &err);
    unlink(path);
    return s;
}

static enum wf_status read_rows(void (*spoil)(int, char *)) { return read_rows_gap(spoil, 5.0); }

static void turned_into_the_wind(void **state)
{
    (void)state;
    assert_int_equal(read_rows(NULL), WF_OK);
    assert_int_equal(record.n, 200);
    assert_close(record.step, 0.1, 1e-9);
    assert_close(record.azimuth, atan2(4, 3), 1e-6);
    assert_close(record.tilt, atan2(1, 5), 2e-2);
    double v = 0, w = 0;
    for (size_t i = 0; i < record.n; i++) v += record.v[i] / 200, w += record.w[i] / 200;
    assert_true(fabs(v) < 1e-12 && fabs(w) < 1e-12);
    assert_close(record.mean, sqrt(26.0), 0.01);
    assert_int_equal(record.unreadable + record.missing + record.gaps, 0);
}

static void holes(int i, char *row)
{
    if (i == 50) strcpy(row, "5.0,NA,4.0,1.0\n");
    if (i == 51) strcpy(row, "5.1,,4.0,1.0\n");
    if (i == 120) strcpy(row, "12.0,3.0,sensor fault,1.0\n");
    if (i == 150 || i == 152) sprintf(row, "%.1f,999,4.0,1.0\n", i / 10.0);
    if (i >= 170 && i < 173) row[0] = '\0'; /* rows that are not there */
}

static void gaps_are_bridged_and_counted(void **state)
{
    (void)state;
    assert_int_equal(read_rows(holes), WF_OK);
    assert_int_equal(record.n, 200);
    assert_int_equal(record.rows, 197);
    assert_int_equal(record.unreadable, 5);
    assert_int_equal(record.missing, 8);
    assert_int_equal(record.gaps, 5);
    assert_int_equal(record.longest, 3);
    for (size_t i = 0; i < record.n; i++) assert_true(isfinite(record.u[i]));
    /* a straight line: the middle of three is the mean of its neighbours */
    assert_close(record.u[171], 0.5 * (record.u[170] + record.u[172]), 1e-12);
    assert_int_equal(diag.errors, 0);
}

static void lone_peak(int i, char *row)
{
    if (i == 150) strcpy(row, "15.0,999,4.0,1.0\n");
}
static void many_words(int i, char *row)
{
    if (i % 10 == 7) sprintf(row, "%.1f,error,4.0,1.0\n", i / 10.0);
}
static void long_gap(int i, char *row)
{
    if (i >= 100 && i < 109) row[0] = '\0';
}
static void backwards(int i, char *row)
{
    if (i == 30) strcpy(row, "1.0,3.0,4.0,1.0\n");
}
static void dense(int i, char *row)
{
    if (i == 60) strcpy(row, "5.91,3.0,4.0,1.0\n");
}

static void refusals(void **state)
{
    (void)state;
    assert_int_equal(read_rows(many_words), WF_EINPUT);
    assert_non_null(strstr(err.text, "20 of 200 rows"));
    assert_non_null(strstr(err.text, ":9:5: error:")); /* first bad cell: row 7, line 9, second column */
    assert_non_null(strstr(err.text, "'error'"));
    assert_int_equal(read_rows(long_gap), WF_OK);
    assert_int_equal(read_rows_gap(long_gap, 0.5), WF_EINPUT);
    assert_non_null(strstr(err.text, "no reading from"));
    assert_int_equal(read_rows(lone_peak), WF_EINPUT);
    assert_non_null(strstr(err.text, ":152: error: column 'u_ms': 999 "));
    assert_non_null(strstr(err.text, "--missing 999"));
    assert_non_null(strstr(err.text, "--missing none"));
    assert_int_equal(read_rows(backwards), WF_EINPUT);
    assert_non_null(strstr(err.text, ":32: error: time 1 s is not after"));
    assert_int_equal(read_rows(dense), WF_EINPUT);
    assert_non_null(strstr(err.text, "within the 0.1 s step"));
}

static void missing_column(void **state)
{
    (void)state;
    struct wf_record_request q;
    wf_record_request_default(&q);
    q.part[0] = "u_mss";
    char *text = rows(NULL);
    write_file(text);
    free(text);
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    assert_int_equal(wf_record_read(path, &q, &a, &d, &record, &e), WF_EINPUT);
    assert_int_equal(d.errors, 1);
    assert_non_null(strstr(d.first->text, "u_ms"));
    wf_arena_free(&a);
    unlink(path);
}

/* As a gust model: at its own step the record itself; asked for longer than it lasts, an error. */
static void played_back(void **state)
{
    (void)state;
    struct wf_gust_spec s;
    struct wf_gust g;
    assert_int_equal(read_rows(NULL), WF_OK);
    wf_gust_spec_default(wf_gust_named("record"), &s);
    s.record = &record;
    s.step = record.step;
    s.steps = record.n;
    s.components = 3;
    assert_int_equal(wf_gust_open(&s, &arena, &diag, &g, &err), WF_OK);
    double *block = calloc(3 * g.block, sizeof *block), x[200];
    assert_int_equal(wf_gust_history(&g, 0, 2, block, x, &err), WF_OK);
    for (size_t i = 0; i < 200; i++) assert_true(fabs(x[i] - record.w[i]) < 1e-9);
    assert_int_equal(wf_gust_set(&s, "rescale", 1.0, &err), WF_OK);
    s.speed = 20.0;
    assert_int_equal(wf_gust_open(&s, &arena, &diag, &g, &err), WF_OK);
    assert_int_equal(wf_gust_history(&g, 0, 0, block, x, &err), WF_OK);
    double mean = 0;
    for (size_t i = 0; i < 200; i++) mean += x[i] / 200;
    assert_close(mean, 20.0, 1e-9);
    free(block);
    s.steps = 201;
    assert_int_equal(wf_gust_open(&s, &arena, &diag, &g, &err), WF_EUSAGE);
    assert_non_null(strstr(diag.last->text, "lasts 19.9 s"));
    wf_arena_free(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turned_into_the_wind),
        cmocka_unit_test(gaps_are_bridged_and_counted),
        cmocka_unit_test(refusals),
        cmocka_unit_test(missing_column),
        cmocka_unit_test(played_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
