/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_QSM_WRITE_H
#define WF_GROW_QSM_WRITE_H
/* Export of a measured tree. The forms are rows of a table, chosen by name or by the ending of the file:
 * .csv: id, radius, length, start, axis, parent (0 = root), extension (0 = none), branch, branch order,
 * position in branch, added; for tapered rows also the radii at both ends. .txt: the same without ids and
 * header, separated by tabs, in the column order of TreeQSM 2.3's cylinder text. .mtg: a multi-scale tree
 * graph; .mat: TreeQSM's structure in a MATLAB file of version 5 (grow/qsm_write.c says which parts). Read
 * back these give the same tree; .txt and .mat have one radius a cylinder, which keeps the volume of a
 * tapered row. .vtk: VTK legacy PolyData, one line for each row; radius at the points, level, id and branch
 * at the cells (ParaView: filter Tube, vary radius by scalar). */
#include "grow/qsm.h"

/* Write a table. Given: a table after wf_qsm_repair; a path; the name of the form (csv, txt, vtk, mtg, mat),
 * or NULL: the ending of the path. A failed export leaves no file. Errors: WF_EUSAGE for a form that is not
 * known, WF_EOUTPUT for a tree that the form cannot hold or a file that cannot be written, WF_ENOMEM. */
enum wf_status wf_qsm_write(const struct wf_qsm *q, const char *path, const char *form, struct wf_err *e);
#endif
