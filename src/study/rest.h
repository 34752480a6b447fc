/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_REST_H
#define WF_STUDY_REST_H
/* The state of a tree at rest: what the shape of its model means, and what follows from it before any wind.
 */
#include "solve/firm.h"
#include "study/speed.h"

/* Rules of this program, not of a publication. */
#define WF_REST_SMALL 0.05   /* of the tree's mass: parts below are stiffened where they would not stand */
#define WF_REST_FIRM 2.0     /* load factor up to which */
#define WF_REST_CREDIBLE 0.5 /* of the strength: what weight alone may use in a drawn part */

/* Given: an analysis with its dry tree, model, solver and loads; options (root plate, beam model). By the
 * shape of the model (struct wf_model): stress_free: nothing. under_weight: the tree stands, with what it
 * carried on the day of the shape; parts that would not stand are stiffened, and listed in the warning
 * 'stiffened'; rows in which weight alone uses more than WF_REST_CREDIBLE of the strength are left out of all
 * scopes, and listed in the warning 'not-credible'. Rows of the stem that carry WF_REST_SMALL of the mass or
 * more are listed but not left out. A solver that takes no standing tree gets its stress-free shape.
 * unloaded: the stress-free shape is found. Errors: WF_EINPUT for a root plate that is softer than the
 * weight above it is high: its equilibrium is that of a tree that lies or hangs, with small stresses;
 * WF_EUNSTABLE where the tree does not stand with this wood
 * or root, or no stress-free shape is found; with the model's `stands_strictly` also where a part would have
 * to be stiffened. */
enum wf_status wf_rest_set_up(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                              struct wf_diag *d, struct wf_err *e);

/* Say of `who` which parts of a standing tree were stiffened: the warning 'stiffened'. */
void wf_rest_warn_of_parts(const char *who, const struct wf_tree *t, const struct wf_firm *f,
                           struct wf_diag *d);
/* Refuse a tree that does not stand (gave_up). else_say: what the user can do otherwise. Returned:
 * WF_EUNSTABLE. */
enum wf_status wf_rest_refuse(const char *who, const char *else_say, const struct wf_tree *t,
                              const struct wf_firm *f, struct wf_err *e);
#endif
