/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_MAT_H
#define WF_GROW_IMPORT_MAT_H
/* Reader of MATLAB files (libmatio): the structures that TreeQSM saves and the matrices made from them.
 * Without libmatio every file is WF_EMISSING. */
#include "grow/import_file.h"

wf_import_reader wf_import_mat;
#endif
