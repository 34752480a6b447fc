/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/progress.h"
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <time.h>

static void (*watcher)(const struct wf_stage *stage);
static struct wf_stage now; /* changed by one thread alone, but for the two below */
static atomic_size_t done;
static atomic_flag showing = ATOMIC_FLAG_INIT; /* held by the thread that shows */
static double run_began, stage_began, shown;

static const double pause = 0.2; /* between two times [s] */

static double clock_now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void wf_progress_watch(void (*show)(const struct wf_stage *stage))
{
    run_began = stage_began = shown = clock_now();
    now = (struct wf_stage){ .of = 0 };
    done = 0;
    watcher = show;
}

void wf_stage_step(size_t steps)
{
    if (!watcher) return;
    (void)atomic_fetch_add(&done, steps);
    if (atomic_flag_test_and_set(&showing)) return;
    double t = clock_now();
    if (t - shown >= pause) {
        struct wf_stage s = now;
        shown = t;
        s.done = done;
        s.seconds = t - stage_began, s.run = t - run_began;
        watcher(&s);
    }
    atomic_flag_clear(&showing);
}

void wf_stage_begin(size_t of, bool about, const char *fmt, ...)
{
    va_list args;
    if (!watcher) return;
    va_start(args, fmt);
    (void)vsnprintf(now.what, sizeof now.what, fmt, args);
    va_end(args);
    now.of = of, now.about = about;
    done = 0;
    stage_began = clock_now();
    wf_stage_step(0);
}

void wf_stage_item(size_t item, size_t items) { now.item = item, now.items = items; }
