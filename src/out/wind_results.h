/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_WIND_RESULTS_H
#define WF_OUT_WIND_RESULTS_H
/* What `windfirm wind` leaves in its folder. */
#include "out/doc.h"
#include "wind/gust_report.h"
#include "wind/rose.h"

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
#endif
