/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_BRACE_H
#define WF_STUDY_BRACE_H
/* Braces: cables and rods between two points of a tree, as springs; a cable pulls and never pushes. What
 * holds their ends in the wood is not assessed. */
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where an end is fixed. */
struct wf_brace_point {
    const char *name; /* as it was written */
    double height;    /* on the stem, above its base [m]; NAN: on a segment */
    long long id;     /* of the segment, struct wf_tree */
    double share;     /* of its length [-] */
};
struct wf_brace {
    bool rod;
    struct wf_brace_point end[2];
    double stiffness;  /* force over stretch, EA over the length [N m-1] */
    double pretension; /* in the shape drawn; negative: a rod that pushes [N] */
    double slack;      /* of a cable in the shape drawn [m] */
    double breaking;   /* load that it breaks at [N]; NAN: not given */
};
/* Read "FROM:TO:STIFFNESS[:PRETENSION][:slack LENGTH][:breaks FORCE]", several apart by ',' or ';'. FROM and
 * TO are a height on the stem, "9m", or a segment, "id:14", "id:14@40%". Given: are they rods; *n that are in
 * out[WF_LINKS_MAX] already. Returned: those read behind them, and *n. Errors: WF_EUSAGE, WF_ENOMEM. */
enum wf_status wf_braces_read(const char *text, bool rod, struct wf_arena *a, struct wf_brace *out, size_t *n,
                              struct wf_err *e);

/* Put the scenario's braces among the loads, unstretched but for the pretension in the shape drawn. Rows are
 * cut where braces hold them. Given: an analysis with its loads and guys, whose tree is grown. Errors:
 * WF_EINPUT for a tree without branches, a point that is not there, two ends in one place; WF_ENOMEM. */
enum wf_status wf_braces_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e);

/* The given wind with the largest force in brace k; NULL: there is no equilibrium in any. */
const struct wf_at_speed *wf_brace_worst(const struct wf_analysis *an, size_t k);

#ifdef __cplusplus
}
#endif
#endif
