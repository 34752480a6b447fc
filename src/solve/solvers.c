/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam.h"
#include "solve/chain.h"
#include "solve/deflect.h"
#include "solve/rod.h"
#include "solve/solve.h"
#include <string.h>

const struct wf_solver *const wf_solvers[] = { &wf_solver_beam,
                                               &wf_solver_linear,
                                               &wf_solver_chain,
                                               &wf_solver_chain_as_printed,
                                               &wf_solver_rod,
                                               &wf_solver_rod_as_printed,
                                               &wf_solver_deflect,
                                               &wf_solver_deflect_as_printed,
                                               NULL };

const struct wf_solver *wf_solver_named(const char *name)
{
    for (const struct wf_solver *const *s = wf_solvers; *s; s++)
        if (!strcmp((*s)->name, name)) return *s;
    return NULL;
}
