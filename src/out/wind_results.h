/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_WIND_RESULTS_H
#define WF_OUT_WIND_RESULTS_H
/* What `windfirm wind` leaves: tables and document of a gusty wind, of a wind rose, and a wind written block
 * by block that needs no more memory than a block takes. */
#include "out/doc.h"
#include "wind/gust_report.h"
#include "wind/climate.h"

/* Write FOLDER/tables/{series,spectrum,histogram,coherence}.csv, plots/run.csv and results.json; the folder
 * is made. diag: warnings of the run. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_wind_results_write(const struct wf_gust_report *r, const struct wf_doc_head *head,
                                     const struct wf_diag *diag, const char *folder, struct wf_err *e);
/* Speeds above which a rose tells how often the wind blows [m/s]. */
enum { WF_ROSE_CLASSES = 4 };
extern const double wf_rose_classes[WF_ROSE_CLASSES];
/* Write FOLDER/tables/rose.csv, plots/run.csv and results.json of a rose read from `file`; the folder is
 * made. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_rose_results_write(const struct wf_rose *r, const char *file,
                                     const struct wf_doc_head *head, const struct wf_diag *diag,
                                     const char *folder, struct wf_err *e);

/* What came out, beside what was asked for. */
struct wf_wind_streamed {
    size_t blocks, block;            /* blocks written, and steps in each                               */
    double seconds;                  /* processor time [s]                                              */
    double mean[WF_COMPONENTS];      /* of the first point, along, across, up [m/s]                     */
    double deviation[WF_COMPONENTS]; /* standard deviation of the first point [m/s]                    */
    double asked[WF_COMPONENTS];     /* the one asked for, NAN where the model has none [m/s]           */
    double joint;                    /* mismatch where blocks meet over the standard deviation [-]      */
    double coherence;                /* largest error of the coherence made; NAN where there is none [-] */
};

/* Make the wind and write it to `path`: a name that ends in .csv as text, columns as in tables/series.csv;
 * any other as a NumPy array (.npy, format 1.0) of 32-bit floats, steps x points x components.
 * progress: called before each block; may be NULL. Returned: *out. Errors: WF_EOUTPUT, WF_ENOMEM, and those
 * of wf_gust_open. */
enum wf_status wf_wind_stream(const struct wf_gust_spec *s, const char *path,
                              void (*progress)(size_t block, size_t blocks), struct wf_arena *a,
                              struct wf_diag *d, struct wf_wind_streamed *out, struct wf_err *e);
#endif
