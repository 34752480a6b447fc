#ifndef WF_CMD_WIND_TABLES_H
#define WF_CMD_WIND_TABLES_H
/* What `windfirm wind` leaves in its folder. */
#include "wind/gust_report.h"

/* Write FOLDER/tables/{series,spectrum,histogram,coherence}.csv and FOLDER/plots/run.gp for the figures. */
enum wf_status wf_wind_tables(const char *folder, const struct wf_gust_report *r, struct wf_err *e);
/* Draw FOLDER/plots/NAME.svg for each of the names, which end at NULL. */
enum wf_status wf_wind_figures(const char *folder, const char *const *name, struct wf_err *e);
/* Begin FOLDER/SUB for writing. */
struct wf_file;
enum wf_status wf_wind_begin(struct wf_file *f, const char *folder, const char *sub, struct wf_err *e);
/* FOLDER/tables and FOLDER/plots. */
enum wf_status wf_wind_folders(const char *folder, struct wf_err *e);
#endif
