/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_FIBRE_H
#define WF_FAIL_FIBRE_H
/* Stress at the fibres of sections that are not rings. */
#include "data/tree.h"
#include "solve/solve.h"

/* Stresses at share s of row i, which is not a ring: lowest and highest of bending and axial force, tension
 * positive, and the largest shear stress of torsion [Pa]. Given: force and moment that the upper part exerts
 * on the section about the axis [N, N m], direction of the axis on the bent tree. Method: sigma = N/A + g.(p
 * - c) at every fibre p of the outline, with g by the tensor of second moments about the centroid c;
 * ellipses, rectangles and triangles by their principal axes, a triangle either way up; between two shapes
 * that are mixed the larger stress. Torsion of these at most T shorter side / J. The section turns as its
 * row's end. */
struct wf_fibre {
    double low, high, twist;
};
struct wf_fibre wf_fibre_stress(const struct wf_tree *t, const struct wf_response *r, size_t i, double s,
                                const double force[3], const double moment[3], const double axis[3]);
#endif
