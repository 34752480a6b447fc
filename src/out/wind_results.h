/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_WIND_RESULTS_H
#define WF_OUT_WIND_RESULTS_H
/* What `windfirm wind` leaves in its folder. */
#include "wind/climate.h"
#include "wind/gust_report.h"

/* Write FOLDER/tables/{series,spectrum,histogram,coherence}.csv and FOLDER/plots/run.gp for the figures. */
enum wf_status wf_wind_tables(const char *folder, const struct wf_gust_report *r, struct wf_err *e);
/* Speeds above which a rose tells how often the wind blows [m/s]. */
enum { WF_ROSE_CLASSES = 4 };
extern const double wf_rose_classes[WF_ROSE_CLASSES];
/* Write FOLDER/tables/rose.csv and FOLDER/plots/run.gp; the folder is made. Errors: WF_EOUTPUT. */
enum wf_status wf_wind_rose_write(const char *folder, const struct wf_rose *r, struct wf_err *e);
/* Draw FOLDER/plots/NAME.svg for each of the names, which end at NULL. */
enum wf_status wf_wind_figures(const char *folder, const char *const *name, struct wf_err *e);
#endif
