/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_MODES_H
#define WF_OUT_MODES_H
/* Modes of a tree: tables, plot data, document. */
#include "out/doc.h"
#include "study/mode_list.h"

/* Modes as a part of a document: a list of objects. */
json_t *wf_part_modes(struct wf_doc *d, const struct wf_sway_modes *m);
/* Write tables/modes.csv, tables/mode_shapes.csv (of the lowest wind of each season), plots/run.csv and
 * results.json of a folder of its own. Given: name of the tree for the heading. Errors: WF_EOUTPUT,
 * WF_ENOMEM. */
enum wf_status wf_modes_write(const struct wf_mode_list *l, const char *name, const struct wf_diag *findings,
                              const struct wf_doc_head *head, const char *folder, struct wf_err *e);
#endif
