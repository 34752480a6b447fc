/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_WIND_RESULTS_H
#define WF_OUT_WIND_RESULTS_H
/* What `windfirm wind` writes: tables and document of a gusty wind or of a wind rose, and a wind streamed to
 * a file block by block, with the memory of one block. */
#include "out/doc.h"
#include "wind/climate.h"
#include "wind/gust_report.h"
#include "wind/rose_record.h"
#include "wind/terrain.h"

/* Write FOLDER/tables/{series,spectrum,histogram,coherence}.csv, plots/run.csv and results.json; the folder
 * is made. diag: warnings of the run. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_wind_results_write(const struct wf_gust_report *r, const struct wf_doc_head *head,
                                     const struct wf_diag *diag, const char *folder, struct wf_err *e);
/* Speeds for which a rose gives the share of time with a stronger wind [m/s]. */
enum { WF_ROSE_CLASSES = 4 };
extern const double wf_rose_classes[WF_ROSE_CLASSES];
/* Write FOLDER/tables/rose.csv, plots/run.csv and results.json of a rose read from `file`, or made from a
 * record (else NULL); then tables/exceedance.csv too. The folder is made. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_rose_results_write(const struct wf_rose *r, const char *file,
                                     const struct wf_rose_record *record, const struct wf_doc_head *head,
                                     const struct wf_diag *diag, const char *folder, struct wf_err *e);

/* Statistics of the wind that was written, and the specified ones. */
struct wf_wind_streamed {
    size_t steps;                    /* written: all, or those before an interrupt                      */
    size_t blocks, block;            /* blocks written, and steps in each                               */
    double seconds;                  /* processor time [s]                                              */
    double mean[WF_COMPONENTS];      /* of the first point, along, across, up [m/s]                     */
    double deviation[WF_COMPONENTS]; /* standard deviation of the first point [m/s]                    */
    double asked[WF_COMPONENTS];     /* the specified one, NAN where the model has none [m/s]           */
    double joint;                    /* mismatch where blocks meet / standard deviation [-]             */
    double coherence;                /* largest error of the coherence; NAN where there is none [-]      */
};

/* Make the wind and write it to `path`: a name that ends in .csv as text, columns as in tables/series.csv;
 * any other as a NumPy array (.npy, format 1.0) of 32-bit floats, steps x points x components.
 * progress: called before each block; may be NULL. After an interrupt the file ends with the steps made so
 * far, which is a warning. Returned: *out. Errors: WF_EOUTPUT, WF_ENOMEM, WF_EINTERRUPTED before the first
 * step, and those of wf_gust_open. */
enum wf_status wf_wind_stream(const struct wf_gust_spec *s, const char *path,
                              void (*progress)(size_t block, size_t blocks), struct wf_arena *a,
                              struct wf_diag *d, struct wf_wind_streamed *out, struct wf_err *e);

/* What `windfirm terrain` computes at every point of a map, and the tables and grids it writes. */

struct wf_terrain_site {
    struct wf_terrain ground;
    struct wf_speedup speedup;
    double *topex, *factor; /* per point: topex-to-distance [deg]; wind over that on level ground [-], NAN
                               where the law of the speed-up does not hold */
    size_t outside;         /* points where it does not */
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
