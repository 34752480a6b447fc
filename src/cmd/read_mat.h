/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_READ_MAT_H
#define WF_CMD_READ_MAT_H
/* MATLAB files are read in a process of their own, because libmatio and libhdf5 crash or hang on some damaged
 * files. The program starts itself with WF_READ_MAT_WORD; that process limits its own time and memory, cannot
 * write files, and answers through a pipe (grow/import_pack.h). */
#include "grow/import_file.h"

#define WF_READ_MAT_WORD "--read-mat"

/* For struct wf_import_options. Errors: those of the reader; WF_EINPUT when it crashes, hangs, reaches a
 * limit or gives an impossible answer; WF_EMISSING when the process cannot be started. */
wf_import_reader wf_read_mat;

/* The other side: `windfirm --read-mat PARENT PATH MODEL`, not for users. Returned: exit code. */
int wf_read_mat_apart(int argc, char **argv);
#endif
