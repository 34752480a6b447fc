/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_H
#define WF_GROW_IMPORT_H
/* Import of tree files that other programs write, into the table of grow/qsm.h. */
#include "grow/import_file.h"

struct wf_import_format {
    const char *name;  /* for --format                          */
    const char *title; /* for people                            */
    const char *needs; /* what its rows must hold, for --help   */
};
/* Ends at name == NULL. */
extern const struct wf_import_format wf_import_formats[];

/* Options of an import without any: format by content, repairs allowed, default units. */
struct wf_import_options wf_import_default(void);

/* Read and repair a tree file. Given: path, options, arena for all that is kept. Returned: a valid table (see
 * wf_qsm_repair); in `d` a finding for each unreadable row (at most 100) and one for each kind of repair.
 * A warning `unseen-wood` says that joining the rows adds more than 5 % of wood or spans a gap of more than 1
 * m. Errors: WF_EINPUT for a file that is missing, empty, binary, of no known format or not repairable, for
 * one that holds several trees or, without the option `force`, more than 25 % of unseen wood or a gap of more
 * than 3 m, and with the option `strict` for a file that needs a repair; WF_EMISSING for a MATLAB file when
 * built without libmatio; without the option `mat`, WF_EINPUT for a MATLAB file of version 7.3; WF_EUSAGE for
 * an unknown format; WF_ENOMEM. */
enum wf_status wf_import_read(const char *path, const struct wf_import_options *o, struct wf_arena *a,
                              struct wf_qsm *out, struct wf_diag *d, struct wf_err *e);
#endif
