/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_CRITERION_H
#define WF_FAIL_CRITERION_H
/* Failure criteria, one row each: load over resistance of a solved tree, in the whole tree, the stem alone
 * and the branches alone. A new criterion is a value of enum wf_criterion_id, a row in criterion.c and its
 * functions in a file of its own; search and results iterate over the rows. */
#include "fail/breakage.h"
#include <stdbool.h>

enum wf_criterion_id {
    WF_BREAKAGE,
    WF_CRITERIA
}; /* index in wf_criteria; the first is reported as `critical` */

struct wf_criterion {
    const char *name, *source, *validity;
    /* Is the resistance of a row known? */
    bool (*known)(const struct wf_tree *t, size_t row);
    /* Given: tree, its response, its section forces and stresses, the scope (part of the tree). Returned:
     * *out, the place of highest utilisation; unchanged where no resistance is known. */
    void (*utilisation)(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                        enum wf_scope scope, struct wf_worst *out);
};
extern const struct wf_criterion wf_criteria[WF_CRITERIA];

/* Is the resistance of at least one row of a scope known? */
bool wf_criterion_known(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope);

/* Evaluate every criterion in every scope. Given: tree, its response and section forces; response NULL where
 * no equilibrium was found. Returned: worst[criterion][scope]; without a response safety NAN and row -1. */
void wf_criteria_check(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                       struct wf_worst (*worst)[WF_SCOPES]);
#endif
