/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SHELTERED_H
#define WF_STUDY_SHELTERED_H
/* A tree in the wind reduced by its own crown: shape and shelter are iterated to agreement. */
#include "solve/solve.h"
#include "wind/shelter.h"

enum { WF_SHELTER_PASSES = 12 };
struct wf_sheltered {
    struct wf_arena arena;     /* of the shelter; freed by wf_sheltered_end */
    struct wf_shelter shelter; /* of a shape that differs from the solution by `change` */
    struct wf_wind wind;       /* the sheltered field */
    struct wf_loads loads;     /* the given loads in that wind */
    size_t passes;
    double change; /* of the shape in the last pass: largest displacement over tree height [-] */
};

/* Given: tree, loads in the undisturbed wind at its speed, request (its sail_share is set here from the
 * streamlining law at the crown's mean height), solver, options. Returned: the response in the last shelter
 * and *out, which must not be moved while its wind is used; errors of the solver and of wf_shelter_make.
 * Method: solve in the undisturbed wind; make the shelter of the bent shape; solve again in it; until the
 * shape changes by less than a thousandth of the height or WF_SHELTER_PASSES (warning shelter-unsettled).
 * Steps between shapes are relaxed where they alternate (Aitken). Small-deflection solvers use the shelter of
 * the unbent tree: one pass. The mesh tolerance is at least 1e-4, because the field is resolved by its cells
 * only. A law as printed adds the warning shelter-as-printed. */
enum wf_status wf_sheltered_solve(const struct wf_tree *t, const struct wf_loads *l,
                                  const struct wf_shelter_request *q, const struct wf_solver *solver,
                                  const struct wf_solve_options *o, struct wf_arena *a,
                                  struct wf_sheltered *out, struct wf_response *r, struct wf_diag *d,
                                  struct wf_err *e);
/* Free the shelter. Safe on a zeroed struct. */
void wf_sheltered_end(struct wf_sheltered *s);
#endif
