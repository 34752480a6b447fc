/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_SETTLE_H
#define WF_SOLVE_BEAM_SETTLE_H
/* What to do when Newton's method stalls: fallbacks that reach equilibrium at full load, or report that there
 * is none; they always terminate. */
#include "solve/beam_newton.h"

struct wf_beam_outcome {
    double load_factor; /* largest share of the load with a stable equilibrium on the path from zero load */
    bool beyond_limit;  /* the solution lies beyond a limit point: the tree fell over to it */
};
/* Equilibrium at the full load, by the first of these that succeeds: Newton from the present shape; load
 * steps; beyond a limit point, creep (each step minimises elastic energy plus a viscous term that fades).
 * Returned: WF_OK; WF_EUNSTABLE with *out giving the last load with a stable equilibrium; WF_ENOMEM. Always
 * terminates. */
enum wf_status wf_beam_settle(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                              struct wf_err *e);

/* The same where Newton's method has failed already. */
enum wf_status wf_beam_step_to_rest(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                                    struct wf_err *e);

/* Where Newton's method (wf_beam_rests) stalls because of a few twigs: load steps, or creep, of these alone,
 * the motion of their bases given; then Newton's method of the whole tree. Such a part carries at most a
 * fifth of the force on the ground. Given: the shape where it stalled; memory from `a`. Of several equilibria
 * of a twig it may find another than the path of the whole tree does. false: the tree does not come to rest
 * so. */
bool wf_beam_settle_parts(struct wf_beam *b, struct wf_arena *a);
/* Newton's method from the shape of a near solution, from which it converges soon or not at all: it is ended
 * where it stalls; and wf_beam_settle_parts after it. a: NULL, without that. */
bool wf_beam_rests_soon(struct wf_beam *b, struct wf_arena *a);
/* To the loads of b by steps of the wind, each from the shape of the one before by wf_beam_rests_soon and halved
 * where that fails. Given: the shape, a solution in a wind of that speed [m/s] and wind_scale; memory from `a`.
 * false: b does not come to rest so; the shape is lost. */
bool wf_beam_approach(struct wf_beam *b, double speed, double scale, struct wf_arena *a);
#endif
