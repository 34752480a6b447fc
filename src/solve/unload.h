/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_UNLOAD_H
#define WF_SOLVE_UNLOAD_H
/* The stress-free shape of a tree measured as it hangs under its own weight. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"

/* Given: tree as scanned, its loads (only weight is used), options (root plate, beam model). Returned: *out,
 * a tree of the same rows and materials whose weight bends it back into the scanned one; its rows are arcs
 * (column bend). *left: largest distance of a row's end from its scanned place under that weight [m]; *moved:
 * largest distance between the stress-free and the scanned place [m]. Errors: as the beam solver's;
 * WF_EUNSTABLE when no stress-free shape was found from which the tree comes to rest as scanned (it does not
 * stand so with these materials). Method: a tree is statically determinate, so the moments of the scanned
 * shape are known at once; its curvatures by the material law are taken out of it from the base up (Magnus,
 * fourth order). What the arcs leave is then removed by moving each row's end by the miss of the sagged
 * shape, seen from its own base. */
enum wf_status wf_unload(const struct wf_tree *tree, const struct wf_loads *l,
                         const struct wf_solve_options *o, struct wf_arena *a, struct wf_tree *out,
                         double *left, double *moved, struct wf_err *e);
#endif
