/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_SCENARIOS_H
#define WF_CMD_ASSESS_SCENARIOS_H
/* What would change a tree's safety: the scenarios of windfirm assess, and the least reduction of the crown.
 */
#include "cmd/assess_card.h"
#include "study/beside.h"

struct wf_assess_list {
    size_t n;
    struct wf_beside *scenario; /* names until they are run */
    struct wf_assess_case *item;
    const struct wf_assess_fit *fit; /* of which the tree is; NULL: of a card */
    const struct wf_model *whole;    /* the tree as it stands */
    double grown;                    /* of a fit: its height [m] */
};

/* Read the scenarios of the options: the changes given, all together, and the items of --scenarios. Mistakes
 * are in `d`. Errors: WF_ENOMEM; of the units. */
enum wf_status wf_assess_list_read(const struct wf_assess_options *o, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_assess_list *out, struct wf_err *e);
/* Can they be read with this species? Asked before anything is computed. Errors: of the first that cannot. */
enum wf_status wf_assess_list_check(const struct wf_assess_list *list, const struct wf_species *sp,
                                    struct wf_err *e);
/* Assess them, and where the tree as it stands is not safe enough, find the least reduction by a share that
 * reaches the required safety. Given: options of the tree as it stands; its analysis, and *x, its assessment.
 * Returned: scenarios and reduction of *x, and an->beside. Errors: of a scenario, with its name. */
enum wf_status wf_assess_list_run(const struct wf_assess_list *list, const struct wf_assess_options *o,
                                  struct wf_arena *a, struct wf_analysis *an, struct wf_assessment *x,
                                  struct wf_err *e);
#endif
