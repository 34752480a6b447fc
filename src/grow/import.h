/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_H
#define WF_GROW_IMPORT_H
/* Trees from the files other programs write, read into the neutral table of grow/qsm.h. */
#include "grow/import_file.h"

struct wf_import_format {
    const char *name;  /* for --format                          */
    const char *title; /* in words                              */
    const char *needs; /* what its rows must hold, for messages */
};
/* Ends at name == NULL. */
extern const struct wf_import_format wf_import_formats[];

struct wf_import_options wf_import_default(void);

/* Read and repair a tree file. Given: path, options, arena for all it keeps, findings. Returned: a sound
 * table (see wf_qsm_repair); findings get every unreadable row (at most 100 of them) and one line for each
 * kind of repair. Errors: WF_EINPUT for a file that is missing, empty, binary, of no known format or beyond
 * repair, or in need of a repair when strict; WF_EMISSING for a MATLAB file when built without libmatio;
 * WF_ENOMEM. */
enum wf_status wf_import_read(const char *path, const struct wf_import_options *o, struct wf_arena *a,
                              struct wf_qsm *out, struct wf_diag *d, struct wf_err *e);
#endif
