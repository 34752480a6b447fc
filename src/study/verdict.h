/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_VERDICT_H
#define WF_STUDY_VERDICT_H
/* Loss of the tree: the stem breaks or the tree overturns. The criterion that governs makes the headline;
 * branches do not. */
#include "study/speed.h"

struct wf_verdict {
    enum wf_criterion_id criterion; /* the criterion of the lowest wind speed */
    const struct wf_break *loss;    /* its result for the stem; one of `breaks` */
    bool assessed[WF_CRITERIA];     /* criteria that lose the tree and whose resistance is known */
};

/* Given: critical winds by criterion and scope, after wf_analysis_breaks. Returned: the criterion that loses
 * the tree at the lowest wind: self-weight first, then a speed that was found, then the lowest bound of a
 * search without result. */
struct wf_verdict wf_verdict_of(const struct wf_break (*breaks)[WF_SCOPES]);

/* The lowest speed at which the criterion may be reached [m/s]: the critical speed, 0 by self-weight, the
 * end of the search where it is not reached; INFINITY: not known. */
double wf_verdict_bound(const struct wf_critical *c);
#endif
