/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_ANALYSIS_H
#define WF_STUDY_ANALYSIS_H
/* One tree in a list of winds: wind -> load -> solve -> fail, and the critical wind speed. */
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The first part of the next: grow the tree, take off what the scenario removes, make its wind field and
 * loads, and put on what holds it. Given: *an with species, model and scenario. Returned: tree, tallness,
 * wind, loads and anchorage of *an. Errors: also of what cannot be done to this tree, such as snow on one
 * without leaves. */
enum wf_status wf_analysis_draw(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d,
                                struct wf_err *e);
/* Grow the tree, make its wind field and loads, and find its state at rest (study/rest.h). Given: *an with
 * species, model, scenario and solver; options of the solutions (NULL: defaults). Returned: tree, tallness,
 * wind (at speed 0) and loads of *an. */
enum wf_status wf_analysis_set_up(struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_arena *a, struct wf_diag *d, struct wf_err *e);

struct wf_nodes; /* study/node.h */
/* Wind speed at which each part of the tree fails by each criterion. Given: an analysis after
 * wf_analysis_set_up with its search, in the direction of its wind. The whole tree and the stem alone are
 * searched; where no branch has a known resistance, the stem's result is that of the whole tree. The
 * branches' result is the tree's where they fail first or nothing fails, else WF_CRITICAL_UNSEARCHED, which
 * is also the outcome of a search that its bound ended. All searches share their solutions, which *nodes
 * gains. */
enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_nodes *nodes, struct wf_break (*out)[WF_SCOPES],
                                  struct wf_err *e);

/* Totals for curves: an->sweep, at speeds from 0 beyond the given and the critical speeds, after
 * wf_analysis_breaks with *nodes. The solutions at hand are nodes; further rows are solved until the nodes
 * predict each other; the other rows are interpolated by cubics of logarithms. Where their time is used up,
 * the given speeds alone, with a warning search-ended. */
enum wf_status wf_analysis_sweep(struct wf_analysis *an, const struct wf_solve_options *o,
                                 struct wf_nodes *nodes, struct wf_arena *a, struct wf_diag *d,
                                 struct wf_err *e);

/* Put onto the tree what depends on the direction of the scenario's wind: how far it may move, and what is
 * left of its anchorage. wf_analysis_set_up does; again where the wind is turned. */
void wf_analysis_turned(struct wf_analysis *an);
/* Does the tree have a row with the wood of that level? Given: an analysis after wf_analysis_set_up. */
bool wf_analysis_grown(const struct wf_analysis *an, size_t level);

/* Given: species, model, scenario, search (NULL: the default), solver, options, n speeds [m/s]. Returned:
 * WF_OK and *out, even where single speeds have no result (their status is the reason); another code when
 * nothing could be computed. */
enum wf_status wf_analyze(const struct wf_species *sp, const struct wf_model *m, const struct wf_scenario *sc,
                          const struct wf_search *search, const struct wf_solver *solver,
                          const struct wf_solve_options *o, const double *speeds, size_t n,
                          struct wf_arena *a, struct wf_diag *d, struct wf_analysis *out, struct wf_err *e);

/* A warning that also a scenario's reader must see. */
#define WF_EVERGREEN "evergreen"
#define WF_ANCHORAGE_SOIL "anchorage-soil"
/* The last step of an analysis, in limits.c: check it against the validity of its laws and methods.
 * Given: an analysis complete except for its warnings. Returned: the warnings added to `d`. */
void wf_limits_check(const struct wf_analysis *an, struct wf_diag *d);
/* The root-linear warning: the plate turns beyond what a constant stiffness holds for at the strongest given
 * wind. Given: the root's stiffness about x and y [N m rad-1]; 0: clamped. */
void wf_limits_root(const struct wf_analysis *an, const double stiffness[2], struct wf_diag *d);

#ifdef __cplusplus
}
#endif
#endif
