/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_SOLVERS_H
#define WF_SOLVE_SOLVERS_H
/* All solvers, as rows. */
#include "solve/solve.h"

extern const struct wf_solver *const wf_solvers[]; /* ends at NULL; the first is the default */
const struct wf_solver *wf_solver_named(const char *name);
#endif
