/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SLOPED_H
#define WF_STUDY_SLOPED_H
/* Curves of an analysis from the values and slopes at solved wind speeds: stem and branches, which have a
 * peak of the load each, are drawn from the speeds at which each is known. */
#include "study/analysis.h"
#include "study/node.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Two nodes closer than this share of their speed would amplify their mesh errors. */
#define WF_CURVE_GAP 0.02

/* The row of an->sweep nearest to the middle between two speeds; -1: none between them. */
int wf_sloped_middle(const struct wf_analysis *an, double low, double high);

/* Fill an->sweep, whose speeds are set. Given: options as wf_nodes_quick has them; nodes with slopes, to
 * which further ones are added until every part of the curve is known to 0.5 %. Errors: as wf_nodes_solve.
 * Method: cubics by values and slopes, of the speed times the root of the gust load factor, whose corners the
 * curve then has. */
enum wf_status wf_sloped_draw(struct wf_analysis *an, const struct wf_solve_options *o,
                              struct wf_nodes *nodes, struct wf_arena *scratch, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
