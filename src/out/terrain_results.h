/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TERRAIN_RESULTS_H
#define WF_OUT_TERRAIN_RESULTS_H
/* What `windfirm terrain` finds at every point of a map, and the tables and grids it leaves. */
#include "out/doc.h"
#include "wind/terrain.h"

struct wf_terrain_site {
    struct wf_terrain ground;
    struct wf_speedup speedup;
    double *topex, *factor; /* per point: topex-to-distance [deg]; wind over that on level ground [-] */
    size_t unseen;          /* points from which a sight line leaves the map */
    double from;            /* the wind comes from, clockwise from north [rad] */
    double height, roughness, distance; /* above the ground [m]; z0 [m]; reach of topex's sight lines [m] */
    const char *file;                   /* of the heights; NULL: made */
};

/* Lowest, mean and highest of n values; those that are not a number are left out. */
void wf_terrain_range(const double *v, size_t n, double *low, double *mean, double *high);
/* Write FOLDER/tables/{terrain.csv,height.asc,topex_deg.asc,wind_factor.asc}, plots/run.csv and results.json;
 * the folder is made. diag: warnings of the run. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_terrain_results_write(const struct wf_terrain_site *s, const struct wf_doc_head *head,
                                        const struct wf_diag *diag, const char *folder, struct wf_err *e);
/* Write FOLDER/tables/positions.csv: each place of `file` (a CSV with columns x_m and y_m), height
 * interpolated, topex and wind of the nearest point. Errors: WF_EINPUT with every mistake in `d`, WF_EOUTPUT.
 */
enum wf_status wf_terrain_positions_write(const struct wf_terrain_site *s, const char *file,
                                          const char *folder, struct wf_arena *a, struct wf_diag *d,
                                          struct wf_err *e);
#endif
