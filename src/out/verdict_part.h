/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_VERDICT_PART_H
#define WF_OUT_VERDICT_PART_H
/* Loss of the tree as a part of results.json: the headline, what it was chosen from, what was not assessed,
 * the anchorage, branches by thickness. docs/results.md describes the keys. */
#include "out/doc.h"
#include "study/analysis.h"

/* A section of the tree: its segment's number as in segments.csv, that of the row in the tree's file (a
 * model: the same), its thickness at its thicker end, and its place at s (0 base, 1 end; NAN: the segment as
 * a whole) and height [m]; null for row -1. */
json_t *wf_part_section(struct wf_doc *d, const struct wf_analysis *a, int32_t row, double s, double height);
/* `verdict` of a tree, to be put into the document. */
struct wf_assessment;
/* A tree's safety against the required one (study/assessment.h). */
json_t *wf_part_assessment(struct wf_doc *d, const struct wf_assessment *x);
json_t *wf_part_verdict(struct wf_doc *d, const struct wf_analysis *a);
/* `loss` of a wind direction: criterion, outcome, mean and gust. */
json_t *wf_part_loss(struct wf_doc *d, const struct wf_analysis *a,
                     const struct wf_break (*breaks)[WF_SCOPES]);
/* `unions` of a tree that has them listed: classes, and the WF_UNIONS_SHOWN of the largest aspect ratios. */
json_t *wf_part_unions(struct wf_doc *d, const struct wf_analysis *a);

/* A probability of the critical wind in words, with the bound of its return period: "0.021", "< 1e-6".
 * Returned: text. */
const char *wf_assess_chance(const struct wf_assessment *x, double p, char text[static 40]);
#endif
