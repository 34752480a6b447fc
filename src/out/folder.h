/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FOLDER_H
#define WF_OUT_FOLDER_H
/* A results folder: results.json, tables/, plots/, pages. */
#include "base/file.h"

/* Make FOLDER/tables and FOLDER/plots. Errors: WF_EOUTPUT. */
enum wf_status wf_folder_make(const char *folder, struct wf_err *e);
/* Begin FOLDER/NAME for writing, to be committed or abandoned by the caller. Errors: as wf_file_begin, and
 * WF_EOUTPUT for a name that is too long. */
enum wf_status wf_folder_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e);
#endif
