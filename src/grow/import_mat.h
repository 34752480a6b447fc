/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_MAT_H
#define WF_GROW_IMPORT_MAT_H
/* MATLAB files with TreeQSM models. A version 5 file is checked in full before libmatio reads it. libhdf5,
 * which reads version 7.3, crashes or hangs on damaged files and cannot be guarded from outside. */
#include "grow/import_file.h"

enum { WF_MAT_CYLINDERS_MAX = 5000000 };

/* Version 5; for files from a source that is trusted. WF_EINPUT for version 7.3. */
wf_import_reader wf_import_mat;
/* Versions 5 and 7.3, for a process that does nothing else: it may crash, hang, and use any memory. */
wf_import_reader wf_import_mat_apart;
#endif
