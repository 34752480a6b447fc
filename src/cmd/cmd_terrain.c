/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm terrain: ground made or read, what shelters it and what speeds the wind up. */
#include "base/csv.h"
#include "base/file.h"
#include "cmd/args.h"
#include "cmd/cmd.h"
#include "cmd/wind_tables.h"
#include "wind/terrain.h"
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
    bool no_plots;
};

#define OPTIONS struct terrain_options
static const struct wf_option options[] = {
    PATH("--dem", dem, "FILE", NULL, "heights as an ESRI ASCII grid; without it the ground is made"),
    WHOLE("--size", size, 1, 12, "8", "of made ground: 2^NUMBER + 1 points a side"),
    NUMBER("--cell", cell, "LENGTH", LENGTH, "m", 0.1, 10000, "25",
           "of made ground: distance of neighbouring points"),
    NUMBER("--smoothness", smoothness, "NUMBER", NONE, NULL, 0, 1, "1",
           "of made ground: exponent H, 0 rough to 1 smooth"),
    NUMBER("--relief", relief, "LENGTH", LENGTH, "m", 0.01, 5000, "40",
           "of made ground: standard deviation of the heights"),
    WHOLE("--seed", seed, 0, 9007199254740992.0, "1",
          "of made ground: whole number; the same seed gives the same ground"),
    NUMBER("--from", from, "ANGLE", ANGLE, "deg", -360, 360, "270",
           "direction the wind comes from, clockwise from north"),
    NUMBER("--height", height, "LENGTH", LENGTH, "m", 0.1, 500, "10", "above the ground, for the speed-up"),
    NUMBER("--roughness", roughness, "LENGTH", LENGTH, "m", 1e-5, 10, "0.05",
           "roughness length of the ground"),
    NUMBER("--hill-length", hill_length, "LENGTH", LENGTH, "m", 0, 1e5, "0",
           "half-width of the hills at half height; 0: from the map"),
    NUMBER("--distance", distance, "LENGTH", LENGTH, "m", 1, 1e5, "1000", "how far topex looks"),
    PATH("--positions", positions, "FILE", NULL, "CSV with x_m and y_m: exposure at these places"),
    TEXT("--output", output, "FOLDER", "out/terrain", "where tables, grids and the map go", .letter = "-o"),
    FLAG("--no-plots", no_plots, "write tables and grids only"),
    QUIET("print errors only"),
    { 0 },
};

static const char about[] =
    "  Make ground by the diamond-square rule or read it, and give each place its exposure: "
    "topex-to-distance\n"
    "  (Hannah et al. 1995) and the speed-up of the wind over low hills (Jackson & Hunt 1975).\n"
    "\n"
    "  windfirm terrain --size 8 --relief 40 --seed 3 --from 240\n"
    "  windfirm terrain --dem heights.asc --positions trees.csv -o out/site";

struct site {
    struct wf_terrain ground;
    struct wf_speedup speedup;
    double *topex, *factor; /* [deg], U/U0 [-] */
    size_t unseen;          /* points from which a sight line leaves the map */
    const char *folder;
    double from;
};

static enum wf_status expose_points(const struct terrain_options *o, struct site *s, struct wf_arena *a,
                                    struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    size_t n = t->rows * t->columns;
    const struct wf_speedup_request q = { s->from, o->height, o->roughness, o->hill_length };
    enum wf_status status = wf_terrain_speedup(t, &q, a, &s->speedup, e);
    s->topex = WF_TAKE(a, n, double);
    s->factor = WF_TAKE(a, n, double);
    if (!status && (!s->topex || !s->factor))
        status = wf_fail(e, WF_ENOMEM, "no room for a map of %zu points", n);
    for (size_t i = 0; i < n && !status; i++) {
        double seen;
        s->topex[i] = wf_terrain_topex(t, i % t->columns, i / t->columns, o->distance, &seen) * 180 / M_PI;
        s->unseen += seen < 1.0;
        s->factor[i] = 1.0 + s->speedup.ds[i];
    }
    return status;
}

/* Every point of the map, blank line after each row as gnuplot's maps want it. */
static enum wf_status write_points(const struct site *s, struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    struct wf_file f = { 0 };
    enum wf_status status = wf_wind_begin(&f, s->folder, "tables/terrain.csv", e);
    if (status) return status;
    fprintf(f.stream, "x_m,y_m,height_m,topex_deg,wind_factor\n");
    for (size_t r = 0; r < t->rows; r++) {
        for (size_t c = 0; c < t->columns; c++) {
            size_t i = r * t->columns + c;
            fprintf(f.stream, "%.9g,%.9g,%.6g,%.5g,%.5g\n", t->x0 + (double)c * t->cell,
                    t->y0 + (double)r * t->cell, t->z[i], s->topex[i], s->factor[i]);
        }
        fputc('\n', f.stream);
    }
    return wf_file_commit(&f, e);
}

static enum wf_status write_grids(const struct site *s, struct wf_err *e)
{
    static const char *const name[] = { "height.asc", "topex_deg.asc", "wind_factor.asc" };
    const double *const value[] = { s->ground.z, s->topex, s->factor };
    for (int i = 0; i < 3; i++) {
        char path[WF_PATH_MAX];
        int n = snprintf(path, sizeof path, "%s/tables/%s", s->folder, name[i]);
        if (n < 0 || (size_t)n >= sizeof path)
            return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", s->folder);
        enum wf_status status = wf_terrain_write(path, &s->ground, value[i], e);
        if (status) return status;
    }
    struct wf_file f = { 0 };
    enum wf_status status = wf_wind_begin(&f, s->folder, "plots/run.gp", e);
    if (status) return status;
    fprintf(f.stream, "FROM = %.9g\nCELL = %.9g\n", s->from * 180 / M_PI, s->ground.cell);
    return wf_file_commit(&f, e);
}

/* The grid point nearest to each place asked for; the height is interpolated. */
static enum wf_status write_positions(const struct site *s, const char *file, struct wf_arena *a,
                                      struct wf_diag *d, struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    struct wf_csv csv = { 0 };
    struct wf_file f = { 0 };
    size_t errors = d->errors;
    enum wf_status status = wf_csv_open(&csv, file, a, d, e);
    if (status) return status;
    size_t cx = wf_csv_need(&csv, "x_m"), cy = wf_csv_need(&csv, "y_m");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a list of positions", file);
    status = wf_wind_begin(&f, s->folder, "tables/positions.csv", e);
    if (status) return status;
    fprintf(f.stream, "x_m,y_m,height_m,topex_deg,wind_factor\n");
    while (wf_csv_next(&csv)) {
        double x, y;
        if (!wf_csv_number(&csv, cx, -1e9, 1e9, &x) || !wf_csv_number(&csv, cy, -1e9, 1e9, &y)) continue;
        double z = wf_terrain_height(t, x, y);
        if (isnan(z)) {
            wf_csv_mistake(&csv, cx, "%.9g, %.9g lies outside the map or where it has no data", x, y);
            continue;
        }
        size_t i =
            (size_t)llround((y - t->y0) / t->cell) * t->columns + (size_t)llround((x - t->x0) / t->cell);
        fprintf(f.stream, "%.9g,%.9g,%.6g,%.5g,%.5g\n", x, y, z, s->topex[i], s->factor[i]);
    }
    if (d->errors > errors) {
        wf_file_abandon(&f);
        return wf_fail(e, WF_EINPUT, "%s: positions that cannot be used", file);
    }
    return wf_file_commit(&f, e);
}

static void print_range(const char *name, const char *unit, const double *v, size_t n)
{
    double low = INFINITY, high = -INFINITY, sum = 0.0, count = 0.0;
    for (size_t i = 0; i < n; i++) {
        if (isnan(v[i])) continue;
        low = fmin(low, v[i]);
        high = fmax(high, v[i]);
        sum += v[i], count += 1.0;
    }
    printf("%-24s %10.3f %10.3f %10.3f  %s\n", name, low, sum / count, high, unit);
}

static void print_site(const struct site *s)
{
    const struct wf_terrain *t = &s->ground;
    size_t n = t->rows * t->columns;
    printf("%zu x %zu points, %g m apart; wind from %.0f deg\n\n%-24s %10s %10s %10s\n", t->columns, t->rows,
           t->cell, s->from * 180 / M_PI, "", "lowest", "mean", "highest");
    print_range("height", "m", t->z, n);
    print_range("topex-to-distance", "deg (high: sheltered)", s->topex, n);
    print_range("wind / level ground", "", s->factor, n);
    printf("\nhills of half-width %.0f m, inner layer %.1f m, gain %.2f, steepest slope %.2f\n",
           s->speedup.length, s->speedup.inner, s->speedup.gain, s->speedup.steepest);
}

static void warn_of_limits(const struct site *s, struct wf_diag *d)
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

static enum wf_status survey(const struct terrain_options *o, struct site *s, struct wf_arena *a,
                             struct wf_diag *d, struct wf_err *e)
{
    static const char *const figures[] = { "terrain", NULL };
    enum wf_status status = o->dem ? wf_terrain_read(o->dem, a, &s->ground, e)
                                   : wf_terrain_make((unsigned)o->size, o->cell, o->smoothness, o->relief,
                                                     o->seed, a, &s->ground, e);
    s->from = o->from;
    s->folder = o->output;
    if (!status) status = expose_points(o, s, a, e);
    if (!status) status = wf_wind_folders(s->folder, e);
    if (!status) status = write_points(s, e);
    if (!status) status = write_grids(s, e);
    if (!status && o->positions) status = write_positions(s, o->positions, a, d, e);
    if (!status && !o->no_plots) status = wf_wind_figures(s->folder, figures, e);
    if (!status) warn_of_limits(s, d);
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
        struct site s = { 0 };
        bool quiet = o.args.quiet;
        enum wf_status status = survey(&o, &s, &arena, &d, &e);
        wf_print_findings(&d, quiet);
        if (!status && !quiet) {
            print_site(&s);
            printf("Tables, grids and map: %s\n", s.folder);
        }
        code = status ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}
