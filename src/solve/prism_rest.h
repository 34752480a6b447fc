/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_PRISM_REST_H
#define WF_SOLVE_PRISM_REST_H
/* Prisms at rest and in small motions: equilibrium, lowest and highest frequency. */
#include "solve/prism.h"

/* Equilibrium under forces f (all vertices, nothing on bonded ones: see wf_prism_pass), by Newton's method
 * with load steps. Given and returned: x, the start and the answer. Errors: WF_ENOCONV, WF_ENOMEM. */
enum wf_status wf_prism_settle(const struct wf_prism *p, const double *f, double *x, struct wf_arena *a,
                               struct wf_err *e);
/* A natural frequency at x [Hz]: the lowest that the start vector holds, by inverse iteration. start: 9 per
 * section; NULL: a push that excites all. Errors: WF_ENOCONV, WF_ENOMEM. */
enum wf_status wf_prism_frequency(const struct wf_prism *p, const double *x, const double *start,
                                  struct wf_arena *a, double *frequency, struct wf_err *e);
/* Highest angular frequency at x, an upper estimate: power iteration, 2 % added [rad/s]. Errors: WF_ENOMEM.
 */
enum wf_status wf_prism_fastest(const struct wf_prism *p, const double *x, struct wf_arena *a, double *omega,
                                struct wf_err *e);
#endif
