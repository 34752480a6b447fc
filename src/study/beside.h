/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_BESIDE_H
#define WF_STUDY_BESIDE_H
/* A tree beside itself: as it stands, and with something done to it or happening to it. */
#include "study/assessment.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What holds it: a cable or rod between two points of it, or a guy to the ground. */
struct wf_beside_hold {
    const char *kind;      /* "cable", "rod", "guy" */
    const char *from, *to; /* its ends; of a guy the height on the stem, and where its anchor lies */
    double force, speed;   /* the largest in the given winds, and the wind [N], [m/s]; NAN: no equilibrium */
    double wind_from; /* of an assessment by directions: where that comes from, clockwise from north [rad];
                         else NAN */
    double critical;  /* in the wind in which the tree is lost [N]; NAN: none, or not known */
    double breaking;  /* load that it breaks at [N]; NAN: not given */
    double safety;    /* against that, in the given winds [-]; NAN: not given, or it does not pull */
};

/* One of them, in the strongest wind given. */
struct wf_beside {
    const char *name; /* what is changed, as it was written; NULL: nothing, the tree as it stands */
    bool removal;     /* by a list of removals alone */
    double cut;       /* share of the crown that is gone [-] */
    double speed;     /* that wind [m/s] */
    double drag, weight, base_moment; /* of the whole tree [N], [N m]; NAN: no equilibrium */
    double safety;                    /* against loss of the tree: of stem and root, as assessed [-] */
    double branches; /* the least of the branches that are listed [-]; NAN: none are, or not known */
    double branch_gusts, damping; /* peak over mean load on branches that have a peak of their own, and the
                                     damping of the sway [-]; NAN: they have none */
    double critical;              /* wind in which the tree is lost; NAN: none found [m/s] */
    double searched;              /* none was found up to this wind; NAN: one was, or it is not known [m/s] */
    size_t holds;
    const struct wf_beside_hold *hold;
    /* of an assessment, in the weakest direction */
    bool assessed;
    double breakage, overturning; /* safeties [-]; NAN: not assessed */
    enum wf_assess_word word;     /* without an interval */
    size_t directions;            /* 0: the same from all */
    const struct wf_assess_direction *direction;
};
struct wf_besides {
    size_t n; /* the first is the tree as it stands */
    const struct wf_beside *item;
};
/* What an analysis says of its tree, but for its name and an assessment. Texts are in the arena. Errors:
 * WF_ENOMEM. */
enum wf_status wf_beside_take(const struct wf_analysis *an, struct wf_arena *a, struct wf_beside *out,
                              struct wf_err *e);
/* What holds the tree of an analysis. Returned: their number; *out in the arena. Errors: WF_ENOMEM. */
enum wf_status wf_beside_holds(const struct wf_analysis *an, struct wf_arena *a, size_t *n,
                               const struct wf_beside_hold **out, struct wf_err *e);

/* Are its branches less safe than of the tree as it stands because gusts load them more? What stays of a
 * smaller crown bears nearly the load it had, and the crown damps its sway less. */
bool wf_beside_gustier(const struct wf_beside *x, const struct wf_beside *stands);
/* Of the warnings of a scenario, those that decide whether it can be: onto the tree as it stands. */
void wf_beside_pass(const struct wf_diag *from, struct wf_diag *to);

/* Can the tree of a scenario be drawn with what is done to it? Errors: as of wf_analysis_draw. */
enum wf_status wf_beside_check(const struct wf_species *sp, const struct wf_model *m,
                               const struct wf_scenario *sc, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
