/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_VERDICT_PART_H
#define WF_OUT_VERDICT_PART_H
/* Loss of the tree as a part of results.json: the headline, what it was chosen from, what was not assessed,
 * the anchorage, branches by thickness. docs/results.md describes the keys. */
#include "out/doc.h"
#include "study/analysis.h"

/* `verdict` of a tree, to be put into the document. */
json_t *wf_part_verdict(struct wf_doc *d, const struct wf_analysis *a);
/* `loss` of a wind direction: criterion, outcome, mean and gust. */
json_t *wf_part_loss(struct wf_doc *d, const struct wf_analysis *a,
                     const struct wf_break (*breaks)[WF_SCOPES]);
#endif
