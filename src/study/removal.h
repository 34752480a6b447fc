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

/* Read "level:2", "twig" (the name of a level), "id:14" (a segment), parts of one removal apart by '+',
 * removals by ','. Returned: *out[*n] in the arena. Errors: WF_EUSAGE, WF_ENOMEM. */
enum wf_status wf_removals_read(const char *text, struct wf_arena *a, const struct wf_removed **out,
                                size_t *n, struct wf_err *e);

/* Take the scenario's removal off the tree. Given: an analysis whose tree is grown. Errors: WF_EINPUT where
 * there is no such part, or it is of the stem; WF_ENOMEM. */
enum wf_status wf_removal_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e);

/* Would wf_removal_onto find all parts? Errors: as of that. */
enum wf_status wf_removals_check(const struct wf_species *sp, const struct wf_model *m,
                                 const struct wf_removed *what, size_t n, struct wf_err *e);

/* A tree without some branches, in the strongest given wind. */
struct wf_removal {
    const struct wf_removed *what;
    double cut;          /* share of the leaves, or where it has none of the crown's sail, that is gone [-] */
    double drag, weight; /* of the whole tree [N]; NAN: no equilibrium */
    double base_moment;  /* [N m] */
    double safety;       /* the least of the stem against loss [-] */
    double critical;     /* wind in which the tree is lost; NAN: none found [m/s] */
    double searched;     /* none was found up to this wind; NAN: one was, or it is not known [m/s] */
};
struct wf_removals {
    size_t n; /* the first is the tree as it stands */
    const struct wf_removal *item;
};

#ifdef __cplusplus
}
#endif
#endif
