/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SERIES_LEAVES_H
#define WF_STUDY_SERIES_LEAVES_H
/* How leaves hang on a moving tree. A look, not a load: these turns enter no force.
 *
 * Tang et al. 2012, eq 13: turn about the hanging point and about the vertical in proportion to the wind's
 * speed, phi = lambda_1 U(t), psi = lambda_2 U(t), on top of what the branch does. Zhao & Zhang 2013: turns
 * about three axes from three noises, M_x N_x(t), M_y N_y(t), M_z N_z(t) + lambda theta_x. The paper prints
 * no number of a leaf; here each has noises of its own. */
#include <stdint.h>

struct wf_leaf_stand { /* a leaf of size 1 on the unbent tree */
    int32_t row;
    double along;                 /* from the row's end back to the hanging point [m] */
    double axis[3];               /* of the row                                       */
    double direction[3], side[3]; /* unit vectors along and across the leaf           */
};
struct wf_leaf_pose {
    double at[3], tip[3], side[3]; /* hanging point; unit vectors along and across */
};

/* Turn about x by angle[0], then y by angle[1], then z by angle[2]; row-major. */
void wf_leaf_matrix(const double angle[3], double R[9]);
/* Given: turns and ends of the rows, the leaves' own turn R. */
void wf_leaf_place(const struct wf_leaf_stand *s, const double (*turn)[9], const double (*end)[3],
                   const double R[9], struct wf_leaf_pose *out);
/* Eq 13: swing phi about the level axis across the leaf (away from the vertical), then psi about the
 * vertical. Given: leaf as the branch carries it. Returned: *p turned. */
void wf_leaf_swing(double phi, double psi, struct wf_leaf_pose *p);
#endif
