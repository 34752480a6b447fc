/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed of rain: steps of the six-leaf scene, prisms a spring, hits by boxes and by trying all, interception.
 */
#include "base/random.h"
#include "data/species.h"
#include "load/interception.h"
#include "load/load.h"
#include "solve/prism_rest.h"
#include "study/rain_run.h"
#include <stdio.h>
#include <string.h>
#include <time.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int scene(const struct wf_species *sp, size_t drops)
{
    double best = 0;
    struct wf_rain_result r = { 0 };
    for (int i = 0; i < 3; i++) {
        struct wf_arena a = { 0 };
        struct wf_diag d = { .arena = &a };
        struct wf_err e = { 0 };
        struct wf_rain_spec s;
        wf_rain_spec_default(&s, false);
        s.scene.species = sp, s.scene.leaves = 6, s.grid = 512, s.drops = drops, s.duration = 1;
        if (wf_rain_run(&s, &a, &d, &r, &e)) return fprintf(stderr, "%s\n", e.text), 1;
        double rate = (double)r.steps / r.seconds;
        if (rate > best) best = rate;
        wf_arena_free(&a);
    }
    printf(
        "rain, 6 leaves, grid 512, %zu drops, %zu facets: %.0f steps a second (bar 1000); paper %s frames\n",
        drops, r.scene.facets, best, drops == 20 ? "1.07" : "0.13");
    printf("  bodies tried for a drop's way: %.2g of %zu\n", (double)r.tests / (double)r.ways,
           r.scene.facets);
    return 0;
}

/* A branch and leaves swinging after a push, by both methods. */
static int prisms(const struct wf_species *sp)
{
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_rain_scene sc;
    struct wf_scene_spec spec;
    wf_scene_spec_default(&spec);
    spec.species = sp;
    if (wf_scene_make(&spec, 9.81, &a, &sc, &e)) return fprintf(stderr, "%s\n", e.text), 1;
    for (int k = 0; k < 2; k++) {
        struct wf_prism_motion m = { .p = &sc.prism,
                                     .step = 1e-3,
                                     .damping = 4,
                                     .internal = k ? 0 : 5e-4,
                                     .gravity = 9.81,
                                     .tolerance = 1e-12 };
        double omega;
        if (k) {
            m.method = WF_PRISM_EULER;
            if (wf_prism_fastest(&sc.prism, sc.rest, &a, &omega, &e)) return 1;
            m.step = 0.9 * wf_prism_euler_limit(m.damping, omega);
        }
        if (wf_prism_begin(&m, sc.rest, &a, &e)) return fprintf(stderr, "%s\n", e.text), 1;
        struct wf_prism_point q;
        wf_scene_blade_point(&sc, 0, (double[]){ 0.04, 0.005 }, &q);
        wf_prism_push(&m, &q, (double[]){ 0, 0, -1e-4 });
        double from = now();
        size_t n = k ? 20000 : 2000;
        for (size_t i = 0; i < n; i++)
            if (wf_prism_advance(&m, &e)) return fprintf(stderr, "%s\n", e.text), 1;
        printf("prisms, %zu springs, %s: %.0f ns a spring and step (bar %d)\n", sc.prism.springs,
               k ? "explicit Euler" : "implicit midpoint",
               1e9 * (now() - from) / (double)(n * sc.prism.springs), k ? 60 : 400);
    }
    wf_arena_free(&a);
    return 0;
}

/* Ways of drops through six leaves: N x M by the boxes, N x M x P by trying all. */
static int hits(const struct wf_species *sp)
{
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_rain_scene sc;
    struct wf_scene_spec spec;
    wf_scene_spec_default(&spec);
    spec.species = sp, spec.leaves = 6;
    if (wf_scene_make(&spec, 9.81, &a, &sc, &e)) return fprintf(stderr, "%s\n", e.text), 1;
    double spent[2] = { 0 };
    size_t tests = 0, ways = 2000;
    for (int all = 0; all < 2; all++) {
        double from = now();
        for (uint64_t i = 0; i < ways; i++) {
            struct wf_hit h;
            double p[3] = { wf_random_uniform(1, 1, 2 * i) * 0.5,
                            wf_random_uniform(1, 1, 2 * i + 1) * 0.3 - 0.15, 2.3 };
            const double to[3] = { p[0], p[1], 1.8 };
            if (all)
                wf_hits_first_of_all(&sc.hits, sc.place, p, to, 1.5e-3, &h);
            else
                wf_hits_first(&sc.hits, sc.place, p, to, 1.5e-3, &h, &tests);
        }
        spent[all] = now() - from;
    }
    printf("hits, %zu bodies: %.2g us a drop by boxes (%.1f bodies tried), %.2g us by trying all\n",
           sc.hits.n, 1e6 * spent[0] / (double)ways, (double)tests / (double)ways,
           1e6 * spent[1] / (double)ways);
    wf_arena_free(&a);
    return 0;
}

static int interception(void)
{
    enum { N = 100000 };
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_tree t;
    if (wf_tree_alloc(&t, N, &a, &e)) return 1;
    for (size_t i = 0; i < N; i++) t.z1[i] = 0.01, t.leaf0[i] = t.leaf1[i] = 2;
    double from = now(), mass = wf_intercept(&t, 0.3);
    printf("interception, %d segments, %.0f kg: %.1f ms (bar 200)\n", N, mass, 1e3 * (now() - from));
    wf_arena_free(&a);
    return 0;
}

int main(void)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_species sp;
    if (wf_species_read("species/poplar.yaml", &wf_laws, &a, &sp, &d, &e))
        return fprintf(stderr, "%s\n", e.text), 1;
    int bad = scene(&sp, 20) || scene(&sp, 200) || prisms(&sp) || hits(&sp) || interception();
    wf_arena_free(&a);
    return bad;
}
