/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Processor time to make the shelter of the generated tree of 10k segments on 32 slabs of 128 x 128 cells. */
#include "base/csv.h"
#include "cases/build.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"
#include <stdio.h>
#include <time.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(void)
{
    struct wf_arena keep = { 0 };
    struct wf_err e = { 0 };
    struct wf_tree t;
    struct wf_wind wind = { .sample = wf_profile_named("uniform")->sample,
                            .speed = 10,
                            .direction = { 1, 0, 0 },
                            .reference_height = 10 };
    if (wf_case_tree_read("validation/computed_reference/bench_tree_10k.csv", &keep, &t, &e)) {
        fprintf(stderr, "%s\n", e.text);
        return 1;
    }
    for (int leaves = 0; leaves < 2; leaves++) {
        for (size_t i = 0; leaves && i < t.n; i++)
            if (t.level[i] >= 7) t.sail0[i] = t.sail1[i] = 0.02;
        for (const struct wf_shelter_law *l = wf_shelter_laws; l->name; l++) {
            double best = 1e9;
            for (int run = 0; run < 7; run++) {
                struct wf_arena a = { 0 };
                struct wf_shelter s;
                struct wf_shelter_request q;
                wf_shelter_request_default(&q);
                q.law = l;
                double start = now();
                if (wf_shelter_make(&t, &wind, &q, &a, &s, &e)) return 1;
                double took = now() - start;
                best = took < best ? took : best;
                if (run == 6) {
                    struct wf_shelter_slab all = { 0 };
                    for (size_t k = 0; k < s.slabs; k++) {
                        all.wood += s.slab[k].wood, all.leaf += s.slab[k].leaf;
                        for (int c = 0; c < WF_CELL_CLASSES; c++) all.cells[c] += s.slab[k].cells[c];
                    }
                    printf("  wood %.4f m2, leaf %.4f m2, flux behind %.4f; cells of each class", all.wood,
                           all.leaf, s.slab[s.slabs].flux);
                    for (int c = 0; c < WF_CELL_CLASSES; c++) printf(" %zu", all.cells[c]);
                    printf("\n");
                }
                wf_arena_free(&a);
            }
            printf("shelter, %zu segments, 32 x 128 x 128, %s, %s: %.1f ms\n", t.n,
                   leaves ? "leaves" : "bare", l->name, 1e3 * best);
        }
    }
    wf_arena_free(&keep);
    return 0;
}
