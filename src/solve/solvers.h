/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_SOLVERS_H
#define WF_SOLVE_SOLVERS_H
/* The table of all solvers. */
#include "solve/solve.h"

extern const struct wf_solver *const wf_solvers[]; /* ends at NULL; the first is the default */
/* Row of that name; NULL when there is none. */
const struct wf_solver *wf_solver_named(const char *name);
#endif
