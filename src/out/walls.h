/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_WALLS_H
#define WF_OUT_WALLS_H
/* Cavities in results.json. */
#include "out/doc.h"
#include "study/analysis.h"

/* `cavities[]` of a tree: docs/results.md. A failure is recorded in the builder. */
json_t *wf_part_walls(struct wf_doc *d, const struct wf_analysis *an);
#endif
