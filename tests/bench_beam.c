/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed and memory of the structural engine. Times are processor time of this process, the best of several
 * runs; ratios are taken within one run, so that they hold on a busy machine too. */
#include "beam_cases.h"
#include "data/species.h"
#include "load/drag.h"
#include "solve/beam_eliminate.h"
#include "solve/beam_many.h"
#include "solve/modes.h"
#include "study/analysis.h"
#include "study/node.h"
#include "study/sway.h"
#include "study/verdict.h"
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Rows "id,parent,x0,y0,z0,x1,y1,z1,radius0,radius1,level", parent 0 = ground. */
static bool read_tree(struct beam_case *c, const char *path, size_t n)
{
    FILE *f = fopen(path, "r");
    if (!f) return false;
    bool ok = fscanf(f, "%*[^\n]") == 0;
    beam_new(c, n);
    for (size_t i = 0; i < n && ok; i++) {
        int id, parent;
        double a[3], b[3], r[2];
        ok = fscanf(f, "%d,%d,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%*d", &id, &parent, a, a + 1, a + 2, b, b + 1,
                    b + 2, r, r + 1) == 10;
        if (ok) beam_row(c, i, parent - 1, a, b, r[0], r[1]);
    }
    fclose(f);
    if (!ok) beam_free(c);
    return ok;
}

/* A tree of four rows a branch, each branch ending in three: 3^8 of the last level and more. */
static void grow_tree(struct beam_case *c, size_t n)
{
    uint64_t seed = 5;
    beam_new(c, n);
    struct wf_tree *t = &c->tree;
    for (size_t branch = 0; 4 * branch < n; branch++) {
        size_t first = 4 * branch, below = branch ? 4 * ((branch - 1) / 3) + 3 : 0, level = 0;
        for (size_t b = branch; b; b = (b - 1) / 3) level++;
        double r0 = 0.3 * pow(0.5, (double)level), length = 7 * pow(0.66, (double)level), d[3] = { 0, 0, 1 },
               size = 0;
        for (int k = 0; k < 3; k++) d[k] += level ? 0.9 * beam_random(&seed) : 0, size += d[k] * d[k];
        for (size_t k = 0; k < 4 && first + k < n; k++) {
            size_t i = first + k, under = k ? i - 1 : below;
            double a[3] = { 0, 0, 0 }, b[3];
            if (i) a[0] = t->x1[under], a[1] = t->y1[under], a[2] = t->z1[under];
            for (int j = 0; j < 3; j++) b[j] = a[j] + length / 4 * d[j] / sqrt(size);
            double s = (double)k / 4;
            beam_row(c, i, i ? (int32_t)under : -1, a, b, r0 * (1 - 0.4 * s), r0 * (0.9 - 0.4 * s));
        }
    }
}

/* One Newton iteration at the present state, by the parts wf_beam_newton is made of: linearise and eliminate
 * tips to base, correct and place base to tips. */
static void iterate(struct wf_beam *b)
{
    wf_beam_sweep_down(b, true, NULL);
    for (size_t i = 0; i < b->mesh.n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_pose ground;
        const double *L = wf_beam_base(b, i, &ground)->L;
        const double *below = p->parent >= 0 ? b->change[p->parent] : b->root_change[p->row];
        wf_beam_correct(&b->shape[i], L, &b->answer[i], &b->node[i], below, b->dv[i], b->change[i]);
    }
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int k = 0; k < 6; k++) b->shape[i].v[k / 3][k % 3] += b->dv[i][k / 3][k % 3];
    wf_beam_sweep_up(b);
}

/* The least any direct solver of six unknowns a node can do on this tree: from the tips down, factor a 6 x 6
 * block, carry its Schur complement to the parent; then substitute back. */
struct block {
    double D[6][6], C[6][6], f[6]; /* own block, coupling to the parent, right-hand side */
};

static void factor(double D[6][6], double B[6][7])
{
    for (int c = 0; c < 6; c++) {
        double inverse = 1 / D[c][c];
        for (int r = c + 1; r < 6; r++) {
            double m = D[r][c] * inverse;
            for (int k = c + 1; k < 6; k++) D[r][k] -= m * D[c][k];
            for (int k = 0; k < 7; k++) B[r][k] -= m * B[c][k];
        }
    }
    for (int c = 6; c-- > 0;)
        for (int k = 0; k < 7; k++) {
            for (int r = c + 1; r < 6; r++) B[c][k] -= D[c][r] * B[r][k];
            B[c][k] /= D[c][c];
        }
}

static double floor_of(const struct wf_beam *b, struct block *block, double (*x)[7 * 6])
{
    size_t n = b->mesh.n;
    for (size_t i = 0; i < n; i++)
        for (int r = 0; r < 6; r++) {
            for (int c = 0; c < 6; c++)
                block[i].D[r][c] = (r == c ? 30 : 0) + 0.1 * (r - 2 * c),
                block[i].C[r][c] = 1 + 0.1 * (c - r);
            block[i].f[r] = r;
        }
    double start = now();
    for (size_t i = n; i-- > 0;) {
        double B[6][7];
        for (int r = 0; r < 6; r++) {
            for (int c = 0; c < 6; c++) B[r][c] = block[i].C[r][c];
            B[r][6] = block[i].f[r];
        }
        factor(block[i].D, B);
        memcpy(x[i], B, sizeof B);
        int32_t p = b->mesh.part[i].parent;
        if (p < 0) continue;
        for (int r = 0; r < 6; r++)
            for (int m = 0; m < 6; m++) {
                for (int c = 0; c < 6; c++) block[p].D[r][c] -= block[i].C[m][r] * B[m][c];
                block[p].f[r] -= block[i].C[m][r] * B[m][6];
            }
    }
    for (size_t i = 0; i < n; i++) {
        int32_t p = b->mesh.part[i].parent;
        for (int r = 0; r < 6; r++) {
            double sum = x[i][7 * r + 6];
            for (int c = 0; c < 6 && p >= 0; c++) sum -= x[i][7 * r + c] * block[p].f[c];
            block[i].f[r] = sum;
        }
    }
    return now() - start;
}

static double per_element[3];

static void measure(struct beam_case *c, const char *name, double speed, int which)
{
    const int repeats = which == 2 ? 5 : 20, runs = which == 2 ? 3 : 7;
    size_t n = c->tree.n, before = c->arena.used;
    c->options.mesh_tolerance = 0;
    c->loads.gravity = 9.81;
    beam_blow(c, speed, 0, 0);
    struct wf_beam b;
    struct wf_beam_outcome out = { 0 };
    double rest = INFINITY, one = INFINITY, plain = INFINITY;
    size_t bytes = 0;
    struct wf_arena a = { 0 };
    for (int k = 0; k < runs; k++) {
        wf_arena_free(&a);
        double start = now();
        wf_beam_init(&b, &c->tree, &c->loads, &c->options, NULL, &a, &a, &c->err);
        if (wf_beam_settle(&b, &a, &out, &c->err)) printf("%s: %s\n", name, c->err.text);
        rest = fmin(rest, now() - start);
        bytes = a.used;
    }
    size_t iterations = b.iterations, steps = b.steps;
    struct block *block = WF_TAKE(&a, n, struct block);
    double(*x)[42] = wf_arena_take(&a, n, sizeof *x);
    for (int k = 0; k < repeats; k++) {
        double start = now();
        iterate(&b);
        one = fmin(one, now() - start);
        plain = fmin(plain, floor_of(&b, block, x));
    }
    per_element[which] = one / (double)n * 1e9;
    printf("%-5s %2g m/s from rest: %7.3f s, %zu iterations, %zu load steps, load factor %g\n", name, speed,
           rest, iterations, steps, out.load_factor);
    printf("      one iteration %5.0f ns/element; block elimination alone %4.0f ns; ratio %.2f\n",
           per_element[which], plain / (double)n * 1e9, one / plain);
    printf("      memory %zu bytes/element for the solver, %zu for the tree\n", bytes / n, before / n);
    wf_arena_free(&a);
}

/* Real loads: a power profile, axis drag by Reynolds number, crowns that streamline. Winds all around. */
static void winds(struct beam_case *c, double speed, struct wf_wind *wind, struct wf_loads *loads, size_t n)
{
    for (size_t i = 0; i < c->tree.n; i++) {
        c->tree.drag[i] = NAN;
        c->tree.sail0[i] = c->tree.sail1[i] = c->tree.r0[i] < 0.02 ? 0.05 : 0;
    }
    c->loads.gravity = 9.81;
    for (size_t k = 0; k < n; k++) {
        double azimuth = 2 * PI * (double)k / (double)n;
        wind[k] = c->wind;
        wind[k].sample = wf_profile_named("power")->sample;
        wind[k].exponent = 0.16, wind[k].speed = speed;
        wind[k].direction[0] = cos(azimuth), wind[k].direction[1] = sin(azimuth);
        loads[k] = c->loads;
        loads[k].wind = &wind[k];
        loads[k].streamline = wf_streamline_named("vogel");
        loads[k].streamline_par.number[0] = -0.7, loads[k].streamline_par.number[1] = 5;
    }
}

/* One iteration of several states side by side with real loads, against the block elimination of the same
 * run. */
static void lanes(struct beam_case *c, double speed, int which)
{
    const int repeats = which == 2 ? 5 : 20;
    const struct wf_lanes_kernel *kernel = wf_lanes_kernel(WF_LANES_MOST);
    size_t n = c->tree.n, width = kernel->width;
    struct wf_wind wind[WF_LANES_MOST];
    struct wf_loads loads[WF_LANES_MOST];
    struct wf_lanes_joints joints;
    struct wf_arena a = { 0 };
    struct wf_beam b;
    double one = INFINITY, many = INFINITY, plain = INFINITY;
    winds(c, speed, wind, loads, WF_LANES_MOST);
    wf_beam_init(&b, &c->tree, &loads[0], &c->options, NULL, &a, &a, &c->err);
    wf_lanes_joints_make(&b.mesh, &a, &joints, &c->err);
    struct wf_lanes x = { .mesh = &b.mesh, .joints = &joints, .options = &c->options };
    for (size_t k = 0; k < width; k++) x.loads[k] = &loads[k], x.wanted[k] = true;
    if (wf_beam_newton(&b) || wf_lanes_take(kernel, &x, &a, &a, &c->err)) printf("%s\n", c->err.text);
    kernel->newton(&x);
    struct block *block = WF_TAKE(&a, n, struct block);
    double(*y)[42] = wf_arena_take(&a, n, sizeof *y);
    for (int k = 0; k < repeats; k++) {
        double start = now();
        iterate(&b);
        one = fmin(one, now() - start);
        start = now();
        kernel->iterate(&x);
        many = fmin(many, (now() - start) / (double)width);
        plain = fmin(plain, floor_of(&b, block, y));
    }
    printf(
        "      real loads: one iteration %5.0f ns/element; ratio %.2f; %zu states side by side %5.0f ns per "
        "element and state; ratio %.2f\n",
        one / (double)n * 1e9, one / plain, width, many / (double)n * 1e9, many / plain);
    wf_arena_free(&a);
}

/* Sixteen directions beside one. */
static void directions(struct beam_case *c, double speed)
{
    enum { N = 16 };
    struct wf_wind wind[N];
    struct wf_loads loads[N];
    double one = INFINITY, all = INFINITY;
    size_t alone = 0;
    winds(c, speed, wind, loads, N);
    struct wf_solve_options o = c->options;
    o.mesh_tolerance = 1e-6;
    for (int k = 0; k < 3; k++) {
        struct wf_arena a = { 0 };
        struct wf_beam_state state[N] = { { 0 } };
        struct wf_beam b;
        struct wf_beam_outcome how;
        struct wf_beam_few few = { .pieces = NULL };
        const struct wf_beam_known known = { .few = &few };
        double start = now();
        if (wf_response_alloc(&c->out, c->tree.n, &a, &c->err) ||
            wf_beam_solve(&c->tree, &loads[0], &o, &known, &a, &a, &b, &how, &c->err))
            printf("%s\n", c->err.text);
        else
            wf_beam_read(&b, &c->out);
        one = fmin(one, now() - start);
        for (size_t s = 0; s < N; s++) state[s].loads = &loads[s];
        start = now();
        if (wf_beam_many(&c->tree, state, N, &o, &few, &a, NULL, &c->err)) printf("%s\n", c->err.text);
        all = fmin(all, now() - start);
        alone = 0;
        for (size_t s = 0; s < N; s++) alone += state[s].alone;
        wf_arena_free(&few.memory);
        wf_arena_free(&a);
    }
    printf("      real loads: one direction %.3f s, 16 directions %.3f s (%zu solved alone); ratio %.2f\n",
           one, all, alone, all / one);
}

static void frequencies(struct beam_case *c)
{
    double f[10], best = INFINITY;
    c->loads.wind = NULL;
    c->loads.gravity = 0;
    for (int k = 0; k < 5; k++) {
        struct wf_arena a = { 0 };
        double start = now();
        if (wf_modes(&c->tree, &c->loads, &c->options, 10, &a, f, NULL, &c->err)) printf("%s\n", c->err.text);
        best = fmin(best, now() - start);
        wf_arena_free(&a);
    }
    printf("      first 10 frequencies: %.3f s (%.4f .. %.4f Hz)\n", best, f[0], f[9]);
}

/* One solution of the linear solver on one element a row. */
static void linear(struct beam_case *c)
{
    double best = INFINITY;
    beam_blow(c, 15, 0, 0);
    c->loads.gravity = 9.81;
    for (int k = 0; k < 5; k++) {
        struct wf_arena a = { 0 };
        double start = now();
        if (wf_solver_linear.solve(&c->tree, &c->loads, &c->options, &a, &c->out, &c->diag, &c->err))
            printf("%s\n", c->err.text);
        best = fmin(best, now() - start);
        wf_arena_free(&a);
    }
    printf("      linear solver: %.3f s, %.0f ns/element\n", best, best / (double)c->tree.n * 1e9);
}

/* The critical wind speeds of stem and branches by all criteria that apply to solid wood, with the sways for
 * the peak load and without. */
static void criticals(struct beam_case *c)
{
    struct wf_tree *t = &c->tree;
    double best[2] = { INFINITY, INFINITY }, loss = NAN;
    struct wf_level level = { .name = "stem" };
    const struct wf_species species = { .name = "wood", .level = &level, .levels = 1 };
    const double anchorage = 2e5, speed = 10;
    for (size_t i = 0; i < t->n; i++) {
        t->strength[i] = 60e6, t->compressive[i] = 27e6, t->shearing[i] = 9e6;
        t->level[i] = i && t->parent[i] != (int32_t)i - 1;
        if (i && !t->level[i]) t->level[i] = t->level[i - 1];
    }
    t->anchorage = anchorage;
    t->room = (struct wf_room){ 6, { 1, 0 }, 0.5 };
    for (int k = 0; k < 6; k++) {
        struct wf_arena a = { 0 };
        struct wf_break out[WF_CRITERIA][WF_SCOPES];
        struct wf_analysis an = { .species = &species,
                                  .solver = &wf_solver_beam,
                                  .tree = *t,
                                  .loads = c->loads,
                                  .wind = c->wind,
                                  .tallness = wf_tree_height(t) };
        wf_scenario_default(&an.scenario);
        an.scenario.peak.damping = 0.03;
        wf_search_default(&an.search);
        an.loads.wind = &an.wind;
        double start = now();
        if (wf_sway_set_up(&an, &c->options, &speed, 1, &a, NULL, &c->err)) printf("%s\n", c->err.text);
        best[0] = fmin(best[0], now() - start);
        struct wf_nodes *nodes = wf_nodes_open(&an, NULL);
        start = now();
        if (!nodes || wf_analysis_breaks(&an, &c->options, nodes, out, &c->err)) printf("%s\n", c->err.text);
        best[1] = fmin(best[1], now() - start);
        loss = wf_verdict_of((const struct wf_break(*)[WF_SCOPES])out).loss->critical.speed;
        wf_nodes_close(nodes);
        wf_arena_free(&a);
    }
    printf(
        "      critical winds by all criteria: sways %.1f ms, search %.1f ms; the tree is lost at %.4f m/s "
        "(bar 50 ms)\n",
        1e3 * best[0], 1e3 * best[1], loss);
}

static double children(void)
{
    struct rusage u;
    getrusage(RUSAGE_CHILDREN, &u);
    return (double)(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
           1e-6 * (double)(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

static void compare(const char *self)
{
    char command[4096];
    const char *end = strstr(self, "/tests/");
    if (!end) return;
    for (int report = 0; report < 2; report++) {
        double best = INFINITY;
        int failed = 0;
        snprintf(command, sizeof command,
                 "%.*s/windfirm compare species/moso_bamboo.yaml species/weeping_willow.yaml --model "
                 "models/culm.yaml "
                 "--wind 10,15,25 -o %.*s/bench/compare%d --quiet %s >/dev/null",
                 (int)(end - self), self, (int)(end - self), self, report, report ? "" : "--no-report");
        for (int k = 0; k < (report ? 1 : 3); k++) {
            double start = children();
            failed |= system(command);
            best = fmin(best, children() - start);
        }
        printf("compare of two species %s: %.2f s%s\n", report ? "with report" : "without report", best,
               failed ? " (failed)" : "");
    }
}

/* For comparison with another program: seconds from rest at 40 m/s, seconds for ten frequencies, the first.
 */
static int beside_a_peer(const char *path)
{
    struct beam_case c;
    double rest = INFINITY, modes = INFINITY, f[10];
    if (!read_tree(&c, path, 1000)) return 1;
    c.options.mesh_tolerance = 0;
    for (int k = 0; k < 20; k++) {
        struct wf_arena a = { 0 };
        beam_blow(&c, 40, 0, 0);
        c.loads.gravity = 9.81;
        double start = now();
        if (wf_solver_beam.solve(&c.tree, &c.loads, &c.options, &a, &c.out, &c.diag, &c.err)) return 1;
        rest = fmin(rest, now() - start);
        c.loads.wind = NULL, c.loads.gravity = 0;
        start = now();
        if (wf_modes(&c.tree, &c.loads, &c.options, 10, &a, f, NULL, &c.err)) return 1;
        modes = fmin(modes, now() - start);
        wf_arena_free(&a);
    }
    beam_free(&c);
    printf("%.6f %.6f %.6f\n", rest, modes, f[0]);
    return 0;
}

int main(int argc, char **argv)
{
    static const char *const name[] = { "1k", "10k", "100k" };
    static const double speed[] = { 20, 20, 15 }, mild[] = { 10, 6, 4 };
    const char *reference = getenv("WINDFIRM_REFERENCE");
    char path[3][1024] = { "validation/computed_reference/bench_tree_1k.csv",
                           "validation/computed_reference/bench_tree_10k.csv", "" };
    if (reference) snprintf(path[2], sizeof path[2], "%s/beams/bench_tree_100k.csv", reference);
    if (argc > 1 && !strcmp(argv[1], "peer")) return beside_a_peer(path[0]);
    setvbuf(stdout, NULL, _IOLBF, 0);
    printf("structural engine, processor time, best of several runs\n");
    for (int k = 0; k < 3; k++) {
        struct beam_case c;
        size_t n = k == 0 ? 1000 : k == 1 ? 10000 : 100000;
        if (!read_tree(&c, path[k], n)) {
            printf("%s: a tree grown here stands in for the one of WINDFIRM_REFERENCE\n", name[k]);
            grow_tree(&c, n);
        }
        measure(&c, name[k], speed[k], k);
        lanes(&c, mild[k], k);
        if (k < 2) directions(&c, mild[k]);
        if (k == 0) criticals(&c);
        if (k == 1) frequencies(&c);
        if (k == 2) linear(&c);
        beam_free(&c);
    }
    printf("ns/element 10k : 1k = %.2f, 100k : 1k = %.2f\n", per_element[1] / per_element[0],
           per_element[2] / per_element[0]);
    compare(argc > 0 ? argv[0] : "");
    return 0;
}
