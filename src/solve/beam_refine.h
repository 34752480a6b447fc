#ifndef WF_SOLVE_BEAM_REFINE_H
#define WF_SOLVE_BEAM_REFINE_H
/* The mesh a tolerance asks for, found by comparing answers on two meshes row by row. */
#include "solve/beam_newton.h"

/* Error of place that the mesh leaves at the worst node [m], from the answers on a mesh and a finer one of
 * the same tree: each row's own part (its end seen from its base) falls with the fourth power of the piece
 * length, and is carried outwards by the reach of what stands on it. share[n]: each row's part of it [m]; a
 * row that was not cut finer keeps what it had. */
double wf_beam_mesh_error(const struct wf_beam *coarse, const struct wf_beam *fine, const double *reach,
                          double *share);

/* Path length from each row's end to its farthest tip [m]. */
void wf_tree_reach(const struct wf_tree *t, double *reach);
#endif
