/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_REMOVAL_H
#define WF_STUDY_REMOVAL_H
/* A tree without some of its branches, beside itself. */
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One part that is taken off, with all that it carries. */
struct wf_removed_part {
    const char *level; /* name or number of a level; NULL: a row */
    long long id;      /* of the row */
};
enum { WF_REMOVED_PARTS = 16, WF_REMOVALS_MAX = 20 };
struct wf_removed {
    const char *name; /* as it was written */
    size_t n;
    struct wf_removed_part part[WF_REMOVED_PARTS];
};

/* Read "level:2", "twig" (the name of a level), "id:14" (a segment), parts of one removal apart by '+'
 * or ';', removals by ','. Returned: *out[*n] in the arena. Errors: WF_EUSAGE, WF_ENOMEM. */
enum wf_status wf_removals_read(const char *text, struct wf_arena *a, const struct wf_removed **out,
                                size_t *n, struct wf_err *e);

/* Take the scenario's removal off the tree. Given: an analysis whose tree is grown. Returned: its tree and
 * `cut`, the share of the leaves that is gone, where it has none of the sail, else of the area of branches.
 * Errors: WF_EINPUT where there is no such part, or it is of the stem; WF_ENOMEM. */
enum wf_status wf_removal_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e);

/* Share of a crown that is gone [-]: of the leaves, where it has none of the sail, else of what branches show
 * from the side. */
double wf_crown_gone(const struct wf_tree *whole, const struct wf_tree *left);

#ifdef __cplusplus
}
#endif
#endif
