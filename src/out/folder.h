/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FOLDER_H
#define WF_OUT_FOLDER_H
/* What is in a results folder: results.json, tables/, plots/, vtk/, pages. A folder may come from a stranger:
 * the functions that take a descriptor follow no symbolic link below it, and names that results.json lists
 * stay below it. */
#include "base/err.h"
#include "base/file.h"
#include <jansson.h>
#include <stdbool.h>
#include <sys/types.h>

/* FOLDER/NAME. Errors: WF_EOUTPUT for a name that is too long. */
enum wf_status wf_folder_path(const char *folder, const char *name, char path[static WF_PATH_MAX],
                              struct wf_err *e);
/* Make FOLDER/tables and FOLDER/plots. Errors: WF_EOUTPUT. */
enum wf_status wf_folder_make(const char *folder, struct wf_err *e);
/* Begin FOLDER/NAME for writing, to be committed or abandoned by the caller. Errors: as wf_file_begin, and
 * WF_EOUTPUT for a name that is too long. */
enum wf_status wf_folder_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e);

/* A number in a row of a table, behind a comma, with so many digits; what is not finite is an empty cell. */
void wf_folder_cell(FILE *f, double x, int digits);

#define WF_DOCUMENT "results.json"
enum { WF_ROOMS = 3, WF_NAME_MAX = 256 };
extern const char *const wf_folder_rooms[WF_ROOMS]; /* tables, plots, vtk */

/* Is it a name of a file that a run can have made: in one of the rooms, or a page (*.html, *.pdf, *.docx); no empty,
 * hidden or upward parts, no control characters? */
bool wf_folder_names(const char *name);
/* Open the folder that holds `name`, below the folder `dir`. make: folders that are missing are made.
 * Returned: a descriptor and *last, the name in it; -1 and errno. */
int wf_folder_room(int dir, const char *name, bool make, const char **last);
/* Open a regular file for reading. Returned: a descriptor and *size [bytes]; -1 and errno, EINVAL for what is
 * not a regular file. */
int wf_folder_open(int dir, const char *name, size_t *size);
/* What stands at a name: 0 nothing, else the type bits of its mode (S_IFREG, S_IFLNK, ...). */
mode_t wf_folder_kind(int dir, const char *name);
/* Remove a file or link; a folder and all that is in it, to a depth of 4, at depth = 0. */
void wf_folder_unlink(int dir, const char *name);
void wf_folder_remove(int dir, const char *name, int depth);

/* Lists of files, as in results.json: {name, size, sha256}. */

const char *wf_folder_entry(const json_t *x); /* its name */
/* The entry of that name; NULL: none. */
const json_t *wf_folder_listed(const json_t *list, const char *name);
/* Is the file the one of the entry? copy: descriptor that it is copied to on the way, or -1. Returned: NULL
 * when it is, else what is wrong ("is missing", ...). */
const char *wf_folder_mismatch(int dir, const json_t *x, int copy);
/* Read results.json. Returned: its text, to be freed, and *root, NULL when it is not JSON; NULL and errno. */
char *wf_folder_document(int dir, json_t **root);
/* The list "run_files" of a document; NULL when it has none, or one with a name that wf_folder_names refuses
 * or that stands twice. */
json_t *wf_folder_list(const json_t *root);
#endif
