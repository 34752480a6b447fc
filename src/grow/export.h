#ifndef WF_GROW_EXPORT_H
#define WF_GROW_EXPORT_H
/* A measured tree to files other programs read. */
#include "base/err.h"
#include "grow/qsm.h"
#include <stdio.h>

struct wf_export_format {
    const char *ending; /* of the file's name, ".csv"  */
    const char *title;  /* in words                    */
    void (*write)(const struct wf_qsm *q, FILE *to);
};
/* Ends at ending == NULL.
 * .csv: id, radius, length, start, axis, parent (0 = root), extension (0 = none), branch, branch order,
 * position in branch, added; for tapered rows also the radii at both ends. Read back it gives the same tree.
 * .txt: the same without ids and header, tab separated, in the column order of TreeQSM 2.3's cylinder text.
 * .vtk: VTK legacy PolyData, a line a row; radius at the points, level, id and branch at the cells (ParaView:
 * filter Tube, vary radius by scalar). */
extern const struct wf_export_format wf_export_formats[];

/* Given: a table after wf_qsm_repair and a path whose ending names the format. The file appears complete or
 * not at all. Errors: WF_EUSAGE for another ending, WF_EOUTPUT. */
enum wf_status wf_qsm_write(const struct wf_qsm *q, const char *path, struct wf_err *e);
#endif
