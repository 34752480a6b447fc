/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_CRITERION_H
#define WF_FAIL_CRITERION_H
/* Criteria of failure, one row each: load over resistance of a solved tree, in the whole tree, the stem alone
 * and the branches alone. A new criterion is a value of enum wf_criterion_id, a row in criterion.c and its
 * function in a file of its own; search and results follow the rows. */
#include "fail/breakage.h"
#include <stdbool.h>

enum wf_criterion_id { WF_BREAKAGE, WF_CRITERIA }; /* index in wf_criteria; the first is told as `critical` */

struct wf_criterion {
    const char *name, *source, *validity;
    /* Is the resistance of a row known? */
    bool (*known)(const struct wf_tree *t, size_t row);
    /* Given: tree, its answer, its sections' forces and stresses, the part that counts. Returned: *out. */
    void (*utilisation)(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                        enum wf_scope scope, struct wf_worst *out);
};
extern const struct wf_criterion wf_criteria[WF_CRITERIA];

/* Is the resistance of any row of a scope known? */
bool wf_criterion_known(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope);

/* Every criterion in every scope. Given: tree, its answer, its sections; NULL for an answer that does not
 * exist. Returned: worst; without an answer NAN and row -1. */
void wf_criteria_check(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                       struct wf_worst (*worst)[WF_SCOPES]);
#endif
