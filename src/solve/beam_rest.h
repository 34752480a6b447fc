/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_REST_H
#define WF_SOLVE_BEAM_REST_H
/* A tree that stands in its given shape under its own weight (struct wf_tree_standing): its internal forces
 * follow from the shape alone, by one sum from the tips, and enter the elements as the curvature and strain
 * they make. The given shape is then in equilibrium on every mesh. */
#include "solve/beam_mesh.h"

/* Set the state at rest of all elements (k0 and g0 of struct wf_beam_part, `root` of the mesh). Given: a mesh
 * and the weight of a unit mass [m/s2]. A load step that takes a share of the weight gives the same share
 * here, so that the given shape remains an equilibrium. No effect where the tree does not stand. */
void wf_beam_rest(struct wf_beam_mesh *m, double weight);

/* What an element bears in the given shape, in the axes of that shape, at its Gauss points. */
struct wf_beam_rest_part {
    double moment[2][3]; /* [N m] */
    double strain[2][3]; /* stretch and shear [-] */
};
/* The same sum for any mass, of round sections: how the state at rest changes with the masses, in which it is
 * linear. Given: mass per length at the Gauss points of every element [kg/m], the weight of a unit mass.
 * Returned, from `a`: part, one an element; root, per row, for roots: moment on the ground [N m]. Errors:
 * WF_ENOMEM. */
enum wf_status wf_beam_rest_of(const struct wf_beam_mesh *m, double (*mass)[2], double weight,
                               struct wf_arena *a, struct wf_beam_rest_part **part, double (**root)[3],
                               struct wf_err *e);
#endif
