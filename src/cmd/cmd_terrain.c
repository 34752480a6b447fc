/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm terrain: generated or measured ground, its sheltered places and where it speeds the wind up. */
#include "base/interrupt.h"
#include "base/progress.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option_groups.h"
#include "out/wind_results.h"
#include <math.h>
#include <stdio.h>

struct terrain_options {
    struct wf_args args;
    const char *dem, *positions; /* NULL: none */
    const char *output;
    size_t size, seed;
    double cell, smoothness, relief, hill_length, distance; /* [m], [-], [m], [m], [m] */
    double from;                                            /* [rad]                   */
    double height, roughness;                               /* [m]                     */
    struct wf_pages pages;
};

/* Options of made ground. */
static bool made_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(((const struct terrain_options *)options)->dem, why,
                            "with ground that is read, --dem");
}

#define OPTIONS struct terrain_options
static const struct wf_option options[] = {
    PATH("--dem", dem, "FILE", NULL, "heights as an ESRI ASCII grid; without it the ground is generated"),
    WHOLE("--size", size, 1, 12, "8", "of generated ground: 2^NUMBER + 1 points a side",
          .unused = made_unused),
    NUMBER("--cell", cell, "LENGTH", LENGTH, "m", 0.1, 10000, "25",
           "of generated ground: distance of neighbouring points", .unused = made_unused),
    NUMBER("--smoothness", smoothness, "NUMBER", NONE, NULL, 0, 1, "1",
           "of generated ground: exponent H, 0 rough to 1 smooth", .unused = made_unused),
    NUMBER("--relief", relief, "LENGTH", LENGTH, "m", 0.01, 5000, "40",
           "of generated ground: standard deviation of the heights", .unused = made_unused),
    WHOLE("--seed", seed, 0, 9007199254740992.0, "1",
          "of generated ground: whole number; the same seed gives the same ground", .unused = made_unused),
    NUMBER("--from", from, "ANGLE", ANGLE, "deg", -360, 360, "270",
           "direction the wind comes from, clockwise from north"),
    NUMBER("--height", height, "LENGTH", LENGTH, "m", 0.1, 500, "10", "above the ground, for the speed-up"),
    NUMBER("--roughness", roughness, "LENGTH", LENGTH, "m", 1e-5, 10, "0.05",
           "roughness length of the ground"),
    NUMBER("--hill-length", hill_length, "LENGTH", LENGTH, "m", 0, 1e5, "0",
           "half-width of the hills at half height; 0: from the map"),
    NUMBER("--distance", distance, "LENGTH", LENGTH, "m", 1, 1e5, "1000", "distance to which topex searches"),
    PATH("--positions", positions, "FILE", NULL, "CSV with x_m and y_m: exposure at these places"),
    TEXT("--output", output, "FOLDER", "out/terrain", "where tables, grids and the map go", .letter = "-o"),
    WF_PAGE_ROWS("--no-plots", pages, "write tables and grids only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "Generate ground by the diamond-square rule or read it, and give each place its exposure: "
    "topex-to-distance (Hannah et al. 1995) and the speed-up of the wind over low hills (Jackson & Hunt "
    "1975).\n"
    "\n"
    "  windfirm terrain --size 8 --relief 40 --seed 3 --from 240\n"
    "  windfirm terrain --dem heights.asc --positions trees.csv -o out/site";

static enum wf_status expose_points(const struct terrain_options *o, struct wf_terrain_site *s,
                                    struct wf_arena *a, struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    size_t n = t->rows * t->columns;
    const struct wf_speedup_request q = { s->from, o->height, o->roughness, o->hill_length };
    enum wf_status status = wf_terrain_speedup(t, &q, a, &s->speedup, e);
    s->topex = WF_TAKE(a, n, double);
    s->factor = WF_TAKE(a, n, double);
    if (!status && (!s->topex || !s->factor))
        status = wf_fail(e, WF_ENOMEM, "not enough memory for a map of %zu points", n);
    wf_stage_begin(t->rows, false, "exposure, rows of the map");
    for (size_t i = 0; i < n && !status; i++) {
        double seen;
        wf_stage_step(i && i % t->columns == 0);
        if (wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted before the map was computed");
        s->topex[i] = wf_terrain_topex(t, i % t->columns, i / t->columns, o->distance, &seen) * 180 / M_PI;
        s->unseen += seen < 1.0;
        bool holds = wf_speedup_holds(1.0 + s->speedup.ds[i]);
        s->factor[i] = holds ? 1.0 + s->speedup.ds[i] : NAN;
        s->outside += !holds;
    }
    if (!status && s->outside == n)
        return wf_fail(
            e, WF_EINPUT,
            "slopes up to %.2f: nowhere on this ground does the linear speed-up give a wind of 0.1 "
            "to 5 times that over level ground",
            s->speedup.steepest);
    return status;
}

static void print_range(const char *name, const char *unit, const double *v, size_t n)
{
    double low, mean, high;
    wf_terrain_range(v, n, &low, &mean, &high);
    wf_show(stdout, "%-24s %10.3f %10.3f %10.3f  %s\n", name, low, mean, high, unit);
}

static void print_site(const struct wf_terrain_site *s)
{
    const struct wf_terrain *t = &s->ground;
    size_t n = t->rows * t->columns;
    wf_show(stdout, "%zu x %zu points, %g m apart; wind from %.0f deg\n\n%-24s %10s %10s %10s\n", t->columns,
            t->rows, t->cell, s->from * 180 / M_PI, "", "lowest", "mean", "highest");
    print_range("height", "m", t->z, n);
    print_range("topex-to-distance", "deg (high: sheltered)", s->topex, n);
    print_range("wind / level ground", "", s->factor, n);
    wf_show(stdout, "\nhills of half-width %.0f m, inner layer %.1f m, gain %.2f, steepest slope %.2f\n",
            s->speedup.length, s->speedup.inner, s->speedup.gain, s->speedup.steepest);
}

static void warn_of_limits(const struct wf_terrain_site *s, struct wf_diag *d)
{
    if (s->speedup.steepest > 0.3)
        wf_diag_warn(
            d, "steep",
            "slopes up to %.2f: the linear speed-up is valid to about 0.3; beyond, the wind separates in the "
            "lee and is overestimated there",
            s->speedup.steepest);
    if (s->outside)
        wf_diag_warn(
            d, "speed-up-outside",
            "at %zu of %zu points the linear speed-up gives a wind below 0.1 or above 5 times that over "
            "level ground, which is outside its law; they have no wind factor",
            s->outside, s->ground.rows * s->ground.columns);
    if (s->unseen)
        wf_diag_warn(d, "map-edge",
                     "%.0f %% of the points have a sight line that leaves the map: their topex covers less "
                     "than its distance",
                     100.0 * (double)s->unseen / (double)(s->ground.rows * s->ground.columns));
}

static enum wf_status survey(const struct terrain_options *o, struct wf_doc_head *head,
                             struct wf_terrain_site *s, struct wf_arena *a, struct wf_diag *d,
                             struct wf_err *e)
{
    enum wf_status status = o->dem ? wf_terrain_read(o->dem, a, &s->ground, e)
                                   : wf_terrain_make((unsigned)o->size, o->cell, o->smoothness, o->relief,
                                                     o->seed, a, &s->ground, e);
    s->file = o->dem;
    s->from = o->from, s->height = o->height, s->roughness = o->roughness, s->distance = o->distance;
    struct wf_run_folder f = { 0 };
    if (!status) status = wf_results_begin(&f, o->output, o->pages.none ? NULL : "terrain", e);
    if (!status) status = expose_points(o, s, a, e);
    wf_progress_clear();
    if (!status) warn_of_limits(s, d);
    wf_doc_head_file(head, "ground", o->dem);
    wf_doc_head_file(head, "data", o->positions);
    if (!status) status = wf_terrain_results_write(s, head, d, f.stage, e);
    if (!status && o->positions) status = wf_terrain_positions_write(s, o->positions, f.stage, a, d, e);
    if (!status) status = wf_results_end(&f, &o->pages, a, NULL, e);
    wf_run_abandon(&f);
    return status;
}

int wf_cmd_terrain(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct terrain_options o;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, options, about, 0, 0, &arena, &o.args);
    if (code < 0) {
        struct wf_diag d = { .arena = &arena };
        struct wf_terrain_site s = { 0 };
        bool quiet = o.args.quiet;
        struct wf_doc_head head;
        enum wf_status status = wf_pages_head(argc, argv, &arena, &head, &e);
        if (!status) status = survey(&o, &head, &s, &arena, &d, &e);
        wf_print_findings(&d, quiet);
        if (!status && !quiet) {
            print_site(&s);
            wf_show(stdout, "Tables, grids and map: %s\n", o.output);
        }
        code = status ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}
