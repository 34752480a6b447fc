/* windfirm terrain: ground made or read, what shelters it and what speeds the wind up. */
#include "cmd/pages.h"
#include "out/terrain_results.h"
#include <math.h>
#include <stdio.h>

static const struct wf_option options[] = {
    { .name = "--dem",
      .kind = WF_OPTION_TEXT,
      .value = "FILE",
      .help = "heights as an ESRI ASCII grid; without it the ground is made" },
    { .name = "--size",
      .kind = WF_OPTION_WHOLE,
      .value = "NUMBER",
      .initial = "8",
      .dimension = WF_DIM_NONE,
      .low = 1,
      .high = 12,
      .help = "of made ground: 2^NUMBER + 1 points a side" },
    { .name = "--cell",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "25",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0.1,
      .high = 10000,
      .help = "of made ground: distance of neighbouring points" },
    { .name = "--smoothness",
      .kind = WF_OPTION_NUMBER,
      .value = "NUMBER",
      .initial = "1",
      .dimension = WF_DIM_NONE,
      .low = 0,
      .high = 1,
      .help = "of made ground: exponent H, 0 rough to 1 smooth" },
    { .name = "--relief",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "40",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0.01,
      .high = 5000,
      .help = "of made ground: standard deviation of the heights" },
    { .name = "--seed",
      .kind = WF_OPTION_WHOLE,
      .value = "NUMBER",
      .initial = "1",
      .dimension = WF_DIM_NONE,
      .low = 0,
      .high = 9007199254740992.0,
      .help = "of made ground: whole number; the same seed gives the same ground" },
    { .name = "--from",
      .kind = WF_OPTION_NUMBER,
      .value = "ANGLE",
      .initial = "270",
      .dimension = WF_DIM_ANGLE,
      .unit = "deg",
      .low = -360,
      .high = 360,
      .help = "direction the wind comes from, clockwise from north" },
    { .name = "--height",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "10",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0.1,
      .high = 500,
      .help = "above the ground, for the speed-up" },
    { .name = "--roughness",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "0.05",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 1e-5,
      .high = 10,
      .help = "roughness length of the ground" },
    { .name = "--hill-length",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "0",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0,
      .high = 1e5,
      .help = "half-width of the hills at half height; 0: from the map" },
    { .name = "--distance",
      .kind = WF_OPTION_NUMBER,
      .value = "LENGTH",
      .initial = "1000",
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 1,
      .high = 1e5,
      .help = "how far topex looks" },
    { .name = "--positions",
      .kind = WF_OPTION_TEXT,
      .value = "FILE",
      .help = "CSV with x_m and y_m: exposure at these places" },
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .initial = "out/terrain",
      .help = "where tables, grids and the map go" },
    { .name = "--no-plots", .kind = WF_OPTION_FLAG, .help = "write tables and grids only" },
    WF_LANG_OPTION,
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

static const char about[] =
    "  Make ground by the diamond-square rule or read it, and give each place its exposure: "
    "topex-to-distance\n"
    "  (Hannah et al. 1995) and the speed-up of the wind over low hills (Jackson & Hunt 1975).\n"
    "\n"
    "  windfirm terrain --size 8 --relief 40 --seed 3 --from 240\n"
    "  windfirm terrain --dem heights.asc --positions trees.csv -o out/site";

static enum wf_status look(const struct wf_args *g, struct wf_terrain_site *s, struct wf_arena *a,
                           struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    size_t n = t->rows * t->columns;
    const struct wf_speedup_request q = { s->from, wf_args_number(g, "--height"),
                                          wf_args_number(g, "--roughness"),
                                          wf_args_number(g, "--hill-length") };
    enum wf_status status = wf_terrain_speedup(t, &q, a, &s->speedup, e);
    s->topex = WF_TAKE(a, n, double);
    s->factor = WF_TAKE(a, n, double);
    if (!status && (!s->topex || !s->factor))
        status = wf_fail(e, WF_ENOMEM, "no room for a map of %zu points", n);
    for (size_t i = 0; i < n && !status; i++) {
        double seen;
        s->topex[i] =
            wf_terrain_topex(t, i % t->columns, i / t->columns, wf_args_number(g, "--distance"), &seen) *
            180 / M_PI;
        s->unseen += seen < 1.0;
        s->factor[i] = 1.0 + s->speedup.ds[i];
    }
    return status;
}

static void range(const char *name, const char *unit, const double *v, size_t n)
{
    double low, mean, high;
    wf_terrain_range(v, n, &low, &mean, &high);
    printf("%-24s %10.3f %10.3f %10.3f  %s\n", name, low, mean, high, unit);
}

static void print(const struct wf_terrain_site *s)
{
    const struct wf_terrain *t = &s->ground;
    size_t n = t->rows * t->columns;
    printf("%zu x %zu points, %g m apart; wind from %.0f deg\n\n%-24s %10s %10s %10s\n", t->columns, t->rows,
           t->cell, s->from * 180 / M_PI, "", "lowest", "mean", "highest");
    range("height", "m", t->z, n);
    range("topex-to-distance", "deg (high: sheltered)", s->topex, n);
    range("wind / level ground", "", s->factor, n);
    printf("\nhills of half-width %.0f m, inner layer %.1f m, gain %.2f, steepest slope %.2f\n",
           s->speedup.length, s->speedup.inner, s->speedup.gain, s->speedup.steepest);
}

static void warn(const struct wf_terrain_site *s, struct wf_diag *d)
{
    if (s->speedup.steepest > 0.3)
        wf_diag_warn(
            d, "steep",
            "slopes up to %.2f: the linear speed-up holds to about 0.3; beyond, the wind separates in the "
            "lee and is overestimated there",
            s->speedup.steepest);
    if (s->unseen)
        wf_diag_warn(
            d, "map-edge",
            "%.0f %% of the points have a sight line that leaves the map: their topex sees less than "
            "its distance",
            100.0 * (double)s->unseen / (double)(s->ground.rows * s->ground.columns));
}

static enum wf_status run(const struct wf_args *g, const struct wf_doc_head *head, struct wf_terrain_site *s,
                          struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const char *dem = wf_args_text(g, "--dem"), *positions = wf_args_text(g, "--positions"),
               *folder = wf_args_text(g, "--output");
    enum wf_status status =
        dem ? wf_terrain_read(dem, a, &s->ground, e)
            : wf_terrain_make((unsigned)llround(wf_args_number(g, "--size")), wf_args_number(g, "--cell"),
                              wf_args_number(g, "--smoothness"), wf_args_number(g, "--relief"),
                              (uint64_t)llround(wf_args_number(g, "--seed")), a, &s->ground, e);
    s->file = dem;
    s->from = wf_args_number(g, "--from"), s->height = wf_args_number(g, "--height");
    s->roughness = wf_args_number(g, "--roughness"), s->distance = wf_args_number(g, "--distance");
    if (!status) status = look(g, s, a, e);
    if (!status) warn(s, d);
    if (!status) status = wf_terrain_results_write(s, head, d, folder, e);
    if (!status && positions) status = wf_terrain_positions_write(s, positions, folder, a, d, e);
    if (!status && !wf_args_given(g, "--no-plots"))
        status = wf_pages_make(folder, wf_args_text(g, "--lang"), a, e);
    return status;
}

int wf_cmd_terrain(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct wf_args args;
    struct wf_doc_head head;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, options, about, 0, 0, &arena, &args);
    if (code < 0) {
        struct wf_diag d = { .arena = &arena };
        struct wf_terrain_site s = { 0 };
        bool quiet = wf_args_given(&args, "--quiet");
        enum wf_status status = wf_pages_head(argc, argv, &arena, &head, &e);
        if (!status) status = run(&args, &head, &s, &arena, &d, &e);
        wf_print_findings(&d, quiet);
        if (!status && !quiet) {
            print(&s);
            printf("Tables, grids and map: %s\n", wf_args_text(&args, "--output"));
        }
        code = status ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}
