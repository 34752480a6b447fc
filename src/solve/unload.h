/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_UNLOAD_H
#define WF_SOLVE_UNLOAD_H
/* The stress-free shape of a tree that was measured under its own weight. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"

/* Find the stress-free shape. Given: tree as scanned, its loads (only weight is used), options (root plate,
 * beam model). Returned: *out, a tree of the same rows and materials whose weight bends it into the scanned
 * shape; its rows are arcs (column bend). *left: largest distance of a row's end from its scanned position
 * under that weight [m]; *moved: largest distance between stress-free and scanned position [m]. Errors: as
 * the beam solver's; WF_EINPUT for sections that are not round; WF_EUNSTABLE when no stress-free shape is
 * found that deforms to the scanned one (with these materials the scanned shape is not a stable
 * equilibrium). Method: a tree is statically determinate, so the moments of the scanned shape are known; the
 * curvatures they cause are removed from the base up (Magnus expansion, fourth order). The remaining error
 * of the arcs is removed by iteration: each row's end is moved by its error under weight, seen from its own
 * base. */
enum wf_status wf_unload(const struct wf_tree *tree, const struct wf_loads *l,
                         const struct wf_solve_options *o, struct wf_arena *a, struct wf_tree *out,
                         double *left, double *moved, struct wf_err *e);
#endif
