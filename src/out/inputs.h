/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_INPUTS_H
#define WF_OUT_INPUTS_H
/* The inputs of a run as parts of results.json: species values with range, standing and source; model;
 * scenario; method. Each returns a new object, to be put into the document. */
#include "out/doc.h"
#include "study/analysis.h"

json_t *wf_part_species(struct wf_doc *d, const struct wf_analysis *a);
json_t *wf_part_model(struct wf_doc *d, const struct wf_model *m);
json_t *wf_part_scenario(struct wf_doc *d, const struct wf_analysis *a);
/* Of a scenario the ground, where its winds are measured and how they are carried to the site. */
json_t *wf_part_site(struct wf_doc *d, const struct wf_scenario *s);
json_t *wf_part_method(struct wf_doc *d, const struct wf_analysis *a);
/* What the peak load at a speed was computed from; and the state in the mean wind alone. */
json_t *wf_part_peak(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at);
json_t *wf_part_steady(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at);
struct wf_wetted;
/* Dry and wet: pairs of numbers; null where there is none. */
json_t *wf_part_wetted(struct wf_doc *d, const struct wf_wetted *w);
#endif
