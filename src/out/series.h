/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_SERIES_H
#define WF_OUT_SERIES_H
/* Files of runs in time: tables, plot data, results.json, a VTK time series. */
#include "out/explain.h"
#include "study/series.h"

struct wf_series_page_run {
    const struct wf_series *series;
    const struct wf_diag *diag;
};
struct wf_series_page {
    const char *title, *note, *command, *date, *version;
    size_t n;
    const struct wf_series_page_run *run;
    size_t explained; /* runs whose tree every method bends */
    const struct wf_explained *explain;
};

/* Write FOLDER/tables/series.csv (one row per frame), frames.csv (key frames, one row per segment),
 * leaves.csv (key frames, one row per leaf, where there are leaves), leaf_angles.csv (every frame, the own
 * angles of at most 12 leaves), levels.csv, runs.csv, explain.csv (where runs request it), warnings.csv and
 * trajectories.csv (ends of segments in every frame; of the tips of axes alone where that would be more than
 * 200000 rows), and FOLDER/plots/run.csv and results.json. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_series_tables(const struct wf_series_page *p, const char *folder, struct wf_err *e);

/* Write FOLDER/vtk/RUN.pvd and its frames FOLDER/vtk/RUN_0000.vtp ...: lines from base to end of every
 * segment with radius, level and displacement, for ParaView. At most 60 frames a run, evenly spaced. */
enum wf_status wf_series_vtk(const struct wf_series_page *p, const char *folder, struct wf_err *e);
#endif
