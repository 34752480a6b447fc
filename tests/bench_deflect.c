/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frames of a swaying tree a second, and the time of the rod solver. The tree: a stem, 12 branches on it, 8
 * twigs on each, all of 5 segments, and 800 leaves; wind, forces and shape are worked out anew in every
 * frame. */
#include "beam_cases.h"
#include "solve/deflect.h"
#include "solve/rod.h"
#include "study/series.h"
#include "wind/noise.h"
#include <stdio.h>
#include <time.h>

enum { BRANCHES = 12, TWIGS = 8, SEGMENTS = 5, LEAVES = 800 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); /* of this program alone, whatever else the machine does */
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* An axis of five segments from the end of `row` (-1: the ground); returned: its first row. */
static size_t axis(struct beam_case *c, size_t *n, int32_t row, double azimuth, double tilt, double length,
                   double radius)
{
    const struct wf_tree *t = &c->tree;
    double d[3] = { sin(tilt) * cos(azimuth), sin(tilt) * sin(azimuth), cos(tilt) }, a[3] = { 0 }, b[3];
    size_t first = *n;
    if (row >= 0) a[0] = t->x1[row], a[1] = t->y1[row], a[2] = t->z1[row];
    for (int k = 0; k < SEGMENTS; k++, ++*n) {
        for (int j = 0; j < 3; j++) b[j] = a[j] + d[j] * length / SEGMENTS;
        beam_row(c, *n, k ? (int32_t)*n - 1 : row, a, b, radius * (1 - 0.1 * k), radius * (0.9 - 0.1 * k));
        memcpy(a, b, sizeof a);
    }
    return first;
}

static void grow(struct beam_case *c)
{
    size_t n = 0;
    beam_new(c, SEGMENTS * (1 + BRANCHES + BRANCHES * TWIGS));
    size_t stem = axis(c, &n, -1, 0, 0, 5, 0.06);
    for (int i = 0; i < BRANCHES; i++) {
        double azimuth = 2.4 * i;
        size_t branch = axis(c, &n, (int32_t)stem + 1 + i % 4, azimuth, 0.9, 2, 0.02);
        for (int k = 0; k < TWIGS; k++)
            axis(c, &n, (int32_t)branch + 1 + k % 4, azimuth + 2.4 * k, 1.3, 0.7, 0.006);
    }
    beam_blow(c, 10, 0, 0);
}

static void frames(struct beam_case *c, bool printed, double damping)
{
    const struct wf_octaves octaves = { 4, 0.5, 2, 1 };
    struct wf_deflect_scheme scheme = { .printed = printed,
                                        .restoring = printed ? 0.3 : 0,
                                        .damping = damping };
    struct wf_deflect d;
    struct wf_leaf_pose *pose = WF_TAKE(&c->arena, LEAVES, struct wf_leaf_pose);
    struct wf_leaf_stand *stand = WF_TAKE(&c->arena, LEAVES, struct wf_leaf_stand);
    assert_int_equal(wf_deflect_open(&c->tree, &c->loads, &scheme, &c->arena, &d, &c->err), WF_OK);
    for (size_t i = 0; i < LEAVES; i++)
        stand[i] = (struct wf_leaf_stand){ .row = (int32_t)(SEGMENTS * (1 + BRANCHES) + i % 480),
                                           .along = 0.1,
                                           .direction = { 0, 0.6, -0.8 },
                                           .side = { 1, 0, 0 } };
    enum { COUNT = 20000, BATCH = 200 };
    double start = now(), mark = start, best = 0, check = 0;
    for (size_t k = 0; k < COUNT; k++) {
        if (k && k % BATCH == 0) { /* a busy machine shares caches and pipes: the best batch had them alone */
            double time = now();
            best = fmax(best, BATCH / (time - mark)), mark = time;
        }
        double t = (double)k, angle[3], R[9];
        double v = 1 + sin(3.14 / 120 * t) + 0.4 * wf_noise_octaves(1, 7, &octaves, t / 61);
        wf_deflect_frame(&d, v, 1. / 61);
        for (unsigned j = 0; j < 3; j++) angle[j] = 0.5 * wf_noise_octaves(1, 11 + j, &octaves, t / 20);
        angle[2] += 0.3 * angle[0];
        wf_leaf_matrix(angle, R);
        for (size_t i = 0; i < LEAVES; i++)
            wf_leaf_place(&stand[i], (const double(*)[9])d.turn, (const double(*)[3])d.end, R, &pose[i]);
        check += pose[k % LEAVES].tip[0];
    }
    double rate = COUNT / (now() - start);
    printf(
        "deflect%-12s %6.0f frames/s, best of 100 batches %6.0f (545 segments, 800 leaves; checksum %.3f)\n",
        printed       ? "-as-printed"
        : damping > 0 ? ", damped"
                      : "",
        rate, best, check);
}

int main(void)
{
    struct beam_case c;
    grow(&c);
    frames(&c, true, 0.1);
    frames(&c, false, 0);
    frames(&c, false, 0.1);
    beam_free(&c);
    beam_tree7(&c);
    c.loads.gravity = 9.81;
    c.options.inextensible = true;
    beam_blow(&c, 35, 0, 0);
    double start = now();
    for (int k = 0; k < 50; k++) assert_int_equal(beam_try(&c, &wf_solver_rod), WF_OK);
    printf("rod                %6.2f ms (tree of seven branches)\n", (now() - start) / 50 * 1e3);
    beam_free(&c);
}
