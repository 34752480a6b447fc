/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a run is: base/progress.h, and the line that the program shows on a terminal. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "base/parallel.h"
#include "base/progress.h"
#include "shell.h"
#include <unistd.h>

static struct wf_stage last;
static size_t shows;

static void show(const struct wf_stage *s)
{
    last = *s;
    shows++;
}

static enum wf_status one(void *context, size_t k, struct wf_err *e)
{
    (void)context, (void)k, (void)e;
    wf_stage_step(1);
    return WF_OK;
}

static void steps_are_counted(void **state)
{
    (void)state;
    shows = 0;
    wf_stage_begin(5, false, "nobody looks");
    wf_stage_step(5);
    assert_int_equal(shows, 0);
    wf_progress_watch(show);
    wf_stage_item(2, 3);
    wf_stage_begin(1000, true, "%s", "rows");
    for (int k = 0; k < 1000; k++) wf_stage_step(1);
    size_t at_once = shows; /* this took much less than the pause between two */
    assert_true(at_once <= 3);
    usleep(300000);
    wf_stage_step(0);
    assert_int_equal(shows, at_once + 1);
    assert_int_equal(last.done, 1000);
    assert_int_equal(last.of, 1000);
    assert_true(last.about && last.item == 2 && last.items == 3);
    assert_string_equal(last.what, "rows");
    assert_true(last.seconds >= 0.3 && last.run >= last.seconds);
    /* a stage begins from 0; threads count together */
    wf_stage_begin(500, false, "more");
    assert_int_equal(wf_parallel(500, 4, one, NULL, NULL), WF_OK);
    usleep(300000);
    wf_stage_step(0);
    assert_int_equal(last.done, 500);
    assert_false(last.about);
    wf_progress_watch(NULL);
    wf_stage_step(1);
    assert_int_equal(last.done, 500);
}

/* A run of some 10 s on a terminal, ended there by Ctrl-C when a line with the time left has been shown,
 * after 60 s at the latest. */
#define LONG "wind kaimal --duration 100000 --points 150 --stream $T/w.npy"
#define TERMINAL(command)                                                                                    \
    "{ i=0; until [ $i -ge 60 ] || grep -q ' left' $T/log 2>/dev/null; do sleep 1; i=$((i + 1)); done; "     \
    "printf '\\003'; sleep 4; } | script -qefc \"" command "\" $T/log >/dev/null; code=$?; "                 \
    "tr '\\r' '\\n' <$T/log >$T/lines; "

static void a_line_on_a_terminal(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { TERMINAL("$W " LONG) "grep -E '^blocks of wind: [0-9]+ of [0-9]+, [0-9]+ %, [0-9.]+/s, [0-9]+ "
                               "(s|min) left' "
                               "$T/lines | tail -1 | cut -c 1-14; exit $code",
          130,
          { "blocks of wind" } },
        { "timeout --foreground -s INT 5 $W " LONG
          " >$T/out 2>$T/err; cat $T/err | tr '\\r\\033' '@@'; ! grep -q @ $T/err",
          CODE_OK,
          { "" } },
        { "script -qefc \"timeout --foreground -s INT 5 $W -q " LONG
          "\" $T/log >/dev/null; grep -c left $T/log; true",
          CODE_OK,
          { "0" } },
        { "script -qefc \"$W species list\" $T/log >/dev/null; grep -c \"$(printf '\\033')\" $T/log; true",
          CODE_OK,
          { "0" } },
    };
    if (system("script --version 2>/dev/null | grep -q util-linux")) {
        print_message("skipped: script (util-linux) is not installed\n");
        skip();
    }
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_are_counted),
        cmocka_unit_test(a_line_on_a_terminal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
