/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SPEED_H
#define WF_STUDY_SPEED_H
/* The coupling at one wind speed: wind -> load -> solve -> fail -> figures. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "study/analysis.h"

/* Given: an analysis whose tree, wind, loads, species, solver are set; a speed at the reference height [m/s].
 * Returned: WF_OK and *out; where the solver finds no equilibrium (WF_EUNSTABLE, WF_ENOCONV) also WF_OK with
 * that status in out->status, the totals NAN and the load factor in out->response; another code when the run
 * must end. */
enum wf_status wf_speed_solve(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                              struct wf_arena *a, struct wf_diag *d, struct wf_at_speed *out,
                              struct wf_err *e);

/* The same without keeping columns: only the totals and the worst places of *out hold afterwards. */
enum wf_status wf_speed_totals(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                               struct wf_at_speed *out, struct wf_err *e);

/* The row that ends highest on level 0. */
size_t wf_tip_row(const struct wf_tree *t);
#endif
