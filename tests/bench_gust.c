/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Processor time to make 1000 points x 36 000 steps of Kaimal wind in a crown, block by block, over that of
 * the normal numbers alone, which no method can do without. */
#include "base/random.h"
#include "wind/gust.h"
#include <stdio.h>
#include <time.h>

enum { POINTS = 1000, STEPS = 36000 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(void)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_gust_spec s;
    struct wf_gust g;
    static double place[3 * POINTS], line[STEPS];
    for (int i = 0; i < 3 * POINTS; i++) /* 6 m x 6 m x 15 m */
        place[i] = i % 3 == 2 ? 3.0 + 15.0 * wf_random_uniform(1, 1, (uint64_t)i)
                              : 6.0 * wf_random_uniform(1, 1, (uint64_t)i) - 3.0;
    wf_gust_spec_default(wf_gust_named("kaimal"), &s);
    s.points = POINTS, s.place = place, s.steps = STEPS;
    double start = now(), sum = 0.0;
    if (wf_gust_open(&s, &a, &d, &g, &e)) return fprintf(stderr, "%s\n", e.text), 1;
    double opened = now(), *block = WF_TAKE(&a, POINTS * g.block, double);
    if (!block) return 1;
    for (size_t b = 0; b < g.blocks; b++) {
        if (wf_gust_block(&g, b, block, &e)) return fprintf(stderr, "%s\n", e.text), 1;
        sum += block[0];
    }
    double made = now();
    for (size_t p = 0; p < POINTS; p++) {
        wf_random_normals(1, p, 0, STEPS, line);
        sum += line[0];
    }
    double floor = now() - made;
    printf("gusts, %d points x %d steps, kaimal: opened %.2f s, blocks %.2f s; normal numbers alone %.2f s, "
           "ratio %.1f "
           "(checksum %.3f)\n",
           POINTS, STEPS, opened - start, made - opened, floor, (made - start) / floor, sum);
    wf_gust_close(&g);
    wf_arena_free(&a);
    return 0;
}
