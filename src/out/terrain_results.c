/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/terrain_results.h"
#include "base/csv.h"
#include "out/folder.h"
#include <math.h>

/* Every point of the map, blank line after each row as gnuplot's maps want it. */
static enum wf_status write_points(const struct wf_terrain_site *s, const char *folder, struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    struct wf_file f = { 0 };
    enum wf_status status = wf_folder_begin(&f, folder, "tables/terrain.csv", e);
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

static enum wf_status write_grids(const struct wf_terrain_site *s, const char *folder, struct wf_err *e)
{
    static const char *const name[] = { "tables/height.asc", "tables/topex_deg.asc",
                                        "tables/wind_factor.asc" };
    const double *const value[] = { s->ground.z, s->topex, s->factor };
    for (int i = 0; i < 3; i++) {
        char path[WF_PATH_MAX];
        enum wf_status status = wf_folder_path(folder, name[i], path, e);
        if (!status) status = wf_terrain_write(path, &s->ground, value[i], e);
        if (status) return status;
    }
    struct wf_plot_data p;
    enum wf_status status = wf_plot_data_begin(&p, folder, "run", e);
    if (status) return status;
    wf_plot_data_number(&p, "FROM", 0, s->from * 180 / M_PI);
    wf_plot_data_number(&p, "CELL", 0, s->ground.cell);
    return wf_plot_data_end(&p, e);
}

/* The grid point nearest to each place asked for; the height is interpolated. */
enum wf_status wf_terrain_positions_write(const struct wf_terrain_site *s, const char *file,
                                          const char *folder, struct wf_arena *a, struct wf_diag *d,
                                          struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    struct wf_csv csv = { 0 };
    struct wf_file f = { 0 };
    size_t errors = d->errors;
    enum wf_status status = wf_csv_open(&csv, file, a, d, e);
    if (status) return status;
    size_t cx = wf_csv_need(&csv, "x_m"), cy = wf_csv_need(&csv, "y_m");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a list of positions", file);
    status = wf_folder_begin(&f, folder, "tables/positions.csv", e);
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

void wf_terrain_range(const double *v, size_t n, double *low, double *mean, double *high)
{
    double sum = 0.0, count = 0.0;
    *low = INFINITY, *high = -INFINITY;
    for (size_t i = 0; i < n; i++) {
        if (isnan(v[i])) continue;
        *low = fmin(*low, v[i]);
        *high = fmax(*high, v[i]);
        sum += v[i], count += 1.0;
    }
    *mean = sum / count;
}

static void range_part(struct wf_doc *d, json_t *o, const char *key, const double *v, size_t n)
{
    double low, mean, high;
    wf_terrain_range(v, n, &low, &mean, &high);
    json_t *q = wf_doc_put(d, o, key, wf_doc_object(d));
    wf_doc_number(d, q, "low", low);
    wf_doc_number(d, q, "mean", mean);
    wf_doc_number(d, q, "high", high);
}

static enum wf_status document(const struct wf_terrain_site *s, const struct wf_doc_head *head,
                               const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    const size_t n = t->rows * t->columns;
    const struct {
        const char *key;
        double x;
    } x[] = { { "cell_m", t->cell },
              { "from_deg", s->from * 180 / M_PI },
              { "height_above_ground_m", s->height },
              { "roughness_m", s->roughness },
              { "topex_distance_m", s->distance },
              { "hill_half_width_m", s->speedup.length },
              { "inner_layer_m", s->speedup.inner },
              { "gain", s->speedup.gain },
              { "steepest_slope", s->speedup.steepest } };
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-terrain", head);
    wf_doc_text(&d, o, "file", s->file);
    wf_doc_count(&d, o, "columns", t->columns), wf_doc_count(&d, o, "rows", t->rows);
    for (size_t i = 0; i < sizeof x / sizeof *x; i++) wf_doc_number(&d, o, x[i].key, x[i].x);
    range_part(&d, o, "height_m", t->z, n);
    range_part(&d, o, "topex_deg", s->topex, n);
    range_part(&d, o, "wind_factor", s->factor, n);
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), diag);
    wf_doc_figure(&d, wf_doc_put(&d, o, "figures", wf_doc_array(&d)), "terrain", "terrain", 0);
    return wf_doc_end(&d, o, folder, e);
}

enum wf_status wf_terrain_results_write(const struct wf_terrain_site *s, const struct wf_doc_head *head,
                                        const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    enum wf_status status = wf_folder_make(folder, e);
    if (!status) status = write_points(s, folder, e);
    if (!status) status = write_grids(s, folder, e);
    return status ? status : document(s, head, diag, folder, e);
}
