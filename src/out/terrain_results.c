/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/terrain_results.h"
#include "base/csv.h"
#include "out/folder.h"
#include "out/plot_data.h"
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
    static const char *const name[] = { "height.asc", "topex_deg.asc", "wind_factor.asc" };
    const double *const value[] = { s->ground.z, s->topex, s->factor };
    for (int i = 0; i < 3; i++) {
        char path[WF_PATH_MAX];
        int n = snprintf(path, sizeof path, "%s/tables/%s", folder, name[i]);
        if (n < 0 || (size_t)n >= sizeof path)
            return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
        enum wf_status status = wf_terrain_write(path, &s->ground, value[i], e);
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

enum wf_status wf_terrain_results_write(const struct wf_terrain_site *s, const char *folder, struct wf_err *e)
{
    enum wf_status status = wf_folder_make(folder, e);
    if (!status) status = write_points(s, folder, e);
    return status ? status : write_grids(s, folder, e);
}
