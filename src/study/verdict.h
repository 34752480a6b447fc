/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_VERDICT_H
#define WF_STUDY_VERDICT_H
/* Loss of the tree: the stem breaks or the tree overturns. The criterion that governs makes the headline;
 * branches do not. docs/failure.md explains the rule. */
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

/* The part that fails first, stem or branch, and by which of the criteria that lose a stem. */
const struct wf_break *wf_verdict_first(const struct wf_break (*breaks)[WF_SCOPES],
                                        enum wf_criterion_id *criterion);

/* Is a row a branch thinner than those that are listed, an->search.branches_from? row -1: none, false. */
bool wf_verdict_twig(const struct wf_analysis *an, int32_t row);

/* Criteria that lose the tree, the nearest to its limit at the strongest given wind first. Returned: how many.
 */
size_t wf_verdict_nearest(const struct wf_analysis *an, enum wf_criterion_id order[WF_CRITERIA]);

/* Is it known where the criterion is reached: at a speed, or at rest? */
bool wf_verdict_reached(const struct wf_critical *c);
/* Results closer than this share are alike: the earlier row of wf_criteria governs. A stem that is hardly
 * twisted breaks by bending. */
#define WF_VERDICT_SAME 1e-6

/* The lowest speed at which the criterion may be reached [m/s]: the critical speed, 0 by self-weight, the
 * end of the search where it is not reached; INFINITY: not known. */
double wf_verdict_bound(const struct wf_critical *c);

/* The least safety against loss of the tree at a wind [-]; NAN: nothing is assessed, or no equilibrium.
 * Returned: *criterion, which it is of; NULL is allowed. */
double wf_verdict_safety(const struct wf_at_speed *at, enum wf_criterion_id *criterion);
/* The strongest given wind that has a solution; NULL: none. */
const struct wf_at_speed *wf_verdict_wind(const struct wf_analysis *an);
/* Is the tree lost below this wind? */
bool wf_verdict_lost(const struct wf_verdict *v, const struct wf_at_speed *at);
/* Why a criterion that loses the tree was not assessed; of a section, the key that the species table lacks.
 * NULL: it was, or there is nothing that it applies to. */
const char *wf_verdict_unassessed(const struct wf_analysis *an, const struct wf_verdict *v,
                                  enum wf_criterion_id c);

/* From this diameter on a rule of timber design lowers the bending strength: 12 in [m]. Strengths of species
 * tables are those of small clear specimens. docs/failure.md has the sources. */
#define WF_SIZE_FROM 0.3048
#define WF_SIZE_UNASSESSED                                                                                   \
    "the strength of small clear specimens is not lowered for the size of the stem, so that the wind in "    \
    "which it breaks may be too high"
/* Diameter of the wood where the stem breaks or is nearest to breaking, where it is above WF_SIZE_FROM, so
 * that the effect of size on strength, which is not computed, may matter [m]; 0: it is not. */
double wf_verdict_size(const struct wf_analysis *an);

#define WF_SOIL_UNASSESSED                                                                                   \
    "the anchorage is the same for every kind of soil: that of other trees, whose soils were not read"
/* Is the anchorage one that the kind of soil does not change? */
bool wf_verdict_any_soil(const struct wf_analysis *an);

/* Branches by thickness, from an->search.branches_from on, each class twice as thick as the one before. */
enum { WF_BRANCH_CLASSES = 6 };
struct wf_branch_class {
    double from, to; /* diameter of the segment [m]; INFINITY: the last */
    size_t segments;
    struct wf_worst worst; /* the segment nearest to failing at wf_verdict_wind; row -1: none is known */
    enum wf_criterion_id criterion; /* by which */
    double fails; /* lowest given wind at which a segment of the class fails [m/s]; NAN: at none */
};
/* Returned: the number of classes up to the thickest branch. */
size_t wf_branch_classes(const struct wf_analysis *an, struct wf_branch_class out[WF_BRANCH_CLASSES]);
#endif
