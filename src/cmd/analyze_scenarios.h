/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ANALYZE_SCENARIOS_H
#define WF_CMD_ANALYZE_SCENARIOS_H
/* The scenarios of windfirm analyze and compare: the tree as it stands beside itself with something changed.
 */
#include "cmd/analyze_request.h"

struct wf_analyze_scenario;
struct wf_analyze_list {
    size_t n;
    struct wf_analyze_scenario *item;
};

/* Read the scenarios of the options, each with its tree. Given: the tree as it stands. Errors: mistakes in
 * `d`; any other error is in `e`. */
enum wf_status wf_analyze_list_read(const struct wf_analyze_options *o, const struct wf_model *whole,
                                    struct wf_arena *a, struct wf_diag *d, struct wf_analyze_list *out,
                                    struct wf_err *e);
/* Can they be drawn with this species? Asked before anything is computed. Errors: of the first that cannot.
 */
enum wf_status wf_analyze_list_check(const struct wf_analyze_list *list, const struct wf_species *sp,
                                     struct wf_err *e);
/* Analyse them, after the tree as it stands. Roots and anchorage are those of that; one that stands in its
 * shape stands in it also as it is changed. Returned: an->beside. Errors: of a scenario, with its name. */
enum wf_status wf_analyze_list_run(const struct wf_analyze_list *list, struct wf_arena *a,
                                   struct wf_analysis *an, struct wf_err *e);
#endif
