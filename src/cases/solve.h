#ifndef WF_CASES_SOLVE_H
#define WF_CASES_SOLVE_H
/* Running what a validation case asks for. */
#include "cases/measure.h"

/* Static answer of one solver. Errors: the solver's. */
enum wf_status wf_setup_solve(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              struct wf_response *r, struct wf_err *e);

/* Drag of the unbent tree along the wind [N]: line load on the undeformed axis, four Gauss points a row
 * (exact for a uniform wind). WF_EINPUT when there is no wind. */
enum wf_status wf_rigid_drag(const struct wf_setup *s, double *drag, struct wf_err *e);

/* Local Vogel exponent d ln F / d ln U - 2 of the base force F along the wind: fourth-order central
 * difference over four runs at U exp(-2h), U exp(-h), U exp(h), U exp(2h), h = 0.01. Errors: the solver's,
 * WF_EINPUT. */
enum wf_status wf_local_vogel(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              double *v, struct wf_err *e);
#endif
