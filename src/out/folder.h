/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FOLDER_H
#define WF_OUT_FOLDER_H
/* A results folder: results.json, tables/, plots/, pages. */
#include "base/file.h"

/* FOLDER/NAME. Errors: WF_EOUTPUT for a name that is too long. */
enum wf_status wf_folder_path(const char *folder, const char *name, char path[static WF_PATH_MAX],
                              struct wf_err *e);
/* Make FOLDER/tables and FOLDER/plots. Errors: WF_EOUTPUT. */
enum wf_status wf_folder_make(const char *folder, struct wf_err *e);
/* Begin FOLDER/NAME for writing, to be committed or abandoned by the caller. Errors: as wf_file_begin, and
 * WF_EOUTPUT for a name that is too long. */
enum wf_status wf_folder_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e);

/* What the figure scripts must know beside the tables: FOLDER/plots/run.csv, rows "key,index,value". It is
 * data, never a script: reports/plots/facts.gp reads it with gnuplot's column functions. */
struct wf_plot_data {
    struct wf_file f;
};

/* Begin FOLDER/plots/NAME.csv; the folder must exist. Errors: WF_EOUTPUT. */
enum wf_status wf_plot_data_begin(struct wf_plot_data *p, const char *folder, const char *name,
                                  struct wf_err *e);
/* A row with a number; what is not finite is written as NaN. index: from 1 in a list, 0 for a single value.
 */
void wf_plot_data_number(struct wf_plot_data *p, const char *key, size_t index, double x);
void wf_plot_data_count(struct wf_plot_data *p, const char *key, size_t index, size_t n);
/* A row with a text, NULL as an empty one: quoted; what gnuplot's reader would take for an end (quotes,
 * commas, backslashes) is written as an octal escape, control characters as spaces. */
void wf_plot_data_text(struct wf_plot_data *p, const char *key, size_t index, const char *text);
void wf_plot_data_print(struct wf_plot_data *p, const char *key, size_t index, const char *fmt, ...)
    __attribute__((format(printf, 4, 5)));
/* A number that comes as text, from a document. Errors: WF_EINPUT when it is not one number and nothing else.
 */
enum wf_status wf_plot_data_parse(struct wf_plot_data *p, const char *key, size_t index, const char *text,
                                  struct wf_err *e);
/* End: the file takes its name. Errors: as wf_file_commit. */
enum wf_status wf_plot_data_end(struct wf_plot_data *p, struct wf_err *e);
#endif
