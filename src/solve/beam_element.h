/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_ELEMENT_H
#define WF_SOLVE_BEAM_ELEMENT_H
/* One geometrically exact rod element (Simo 1985, Comput. Methods Appl. Mech. Eng. 49:55; Antman 2005,
 * Nonlinear Problems of Elasticity, ch. 8), by two-stage Gauss collocation.
 *
 * Along the arc length s of the unloaded axis the rotation L(s) from the unloaded to the loaded state, the
 * position r(s), and the force n(s) and moment m(s) that the upper part exerts on the section obey L' = [k]x
 * L, r' = L t + g,  n' = -f(r, L t),  m' = -r' x n,   k = G m,  g = H n, with t the unloaded tangent, f the
 * load per unit length, G and H the section's compliances in bending/torsion and stretch/shear, all in
 * global axes. Within an element L(s) = exp(v(s)) L(base); the rotation vector v is a quadratic in s given
 * by its values at the two Gauss points. Gauss collocation makes position, rotation, force and moment at the
 * element's ends accurate to h^4, satisfies the balance of forces and moments exactly on every mesh, and
 * does not lock, because the section's compliances may be zero.
 *
 * A tree that stands in the given shape under its own weight has internal forces n0, m0 in it (struct
 * wf_beam_standing). With k0 = G m0 and g0 = H n0, which rotate with the section, the law becomes k + k0 = G
 * m, r' = L t + H n - g0: L and k are counted from the given shape, n and m are whole. A stress-free shape
 * has k0 = g0 = 0.
 *
 * G is 1/EI across and 1/GJ along the axis. A section that is not round has another 1/EI about its width,
 * whose direction rotates with it, and weight with an offset from the axis adds its moment per length to -m'
 * (struct wf_beam_flat).
 *
 * The only unknowns are the two rotation vectors. For a given shape the internal forces follow by sums from
 * the tips down; the remaining equation is the material law k = G m, solved by Newton's method with its
 * exact derivative (except for the effect of stretch on the load within one element, of relative size
 * (r/h)^2 and below). */
#include "base/vec3.h"
#include "load/load.h"
#include "solve/beam_mesh.h"

struct wf_beam_pose {
    real r[3], L[9]; /* position [m]; rotation from the unloaded to the loaded state, row-major */
};
struct wf_beam_shape { /* unknowns, in the axes that rotate with the element's base */
    real v[2][3];      /* rotation vector at the Gauss points */
    real g[2][3];      /* stretch and shear strain there */
};
struct wf_beam_stage {               /* the deformed element at its Gauss points */
    real r[2][3], rp[2][3], t[2][3]; /* position, r' and unit tangent */
    real k0[2][3], g0[2][3];         /* curvature and strain of the state at rest, rotated with the section */
};
struct wf_beam_wrench {
    real n[3], m[3]; /* force [N], moment [N m] that the upper part exerts on a section */
};
/* Linear relation of a part of the tree: the wrench it exerts on its base changes by K p + k for a change p
 * = (displacement, spin) of the base. */
struct wf_beam_reaction {
    real K[6][6], k[6], side[6]; /* side: in place of k where the loads grow (struct wf_beam_growth) */
};
/* Spins of the element's Gauss points relative to its base for a change p of the base: X p + x. */
struct wf_beam_answer {
    real X[6][6], x[6], side[6]; /* side: as above */
};

/* Position and rotation of the element from its unknowns. Given: base pose. Returned: state at the Gauss
 * points, pose of the end. */
void wf_beam_place(const struct wf_beam_part *p, const struct wf_beam_shape *u,
                   const struct wf_beam_pose *base, struct wf_beam_stage *s, struct wf_beam_pose *end);

/* Rotate the section axes of an element that is not round. Given: *flat as in the mesh. Returned: *flat in
 * the deformed state. */
void wf_beam_turn(const struct wf_beam_shape *u, const double base_L[9], struct wf_beam_flat *flat);

/* Moment of the off-axis weight about the axis, per length [N m/m]; zero for flat NULL. */
void wf_beam_couple(const struct wf_beam_flat *flat, double couple[2][3]);

/* Loads per length at the Gauss points, with their derivatives. */
void wf_beam_load(const struct wf_beam_part *p, const struct wf_loads *l, const struct wf_beam_stage *s,
                  struct wf_line_load load[2]);

/* Internal forces at the Gauss points and the base, from those at the end, by balance. h: length [m]; flat
 * NULL: round section. */
void wf_beam_balance(double h, const struct wf_beam_stage *s, const struct wf_beam_flat *flat,
                     const struct wf_line_load load[2], const struct wf_beam_wrench *end,
                     struct wf_beam_wrench at[2], struct wf_beam_wrench *base);

/* Creep that stiffens an element against motion (NULL: elastic): the moment of the material law becomes G^-1
 * ((1 + rate) k - rate k0), with k0 the curvature (base axes) at the start of the creep step. */
struct wf_beam_creep {
    double rate;
    const real (*k0)[3];
};

/* Curvature change k at the Gauss points in base axes [1/m]. */
void wf_beam_curvature(const struct wf_beam_part *p, const struct wf_beam_shape *u, double k[2][3]);

/* Residual of the material law, summed over the elements, with the scales it is compared with. */
struct wf_beam_misfit {
    double bending; /* energy of the curvature residual, h/4 sum (k - G m).G^-1 (k - G m) [J] */
    double energy;  /* scale of `bending`: h/4 sum m.G m [J]; m at least 1e-3 n h */
    double strain;  /* largest |H n - g| [-] */
    double turn;    /* scale of `strain`: largest |h G m| or |H n| [-] */
};

/* Count of unstable directions: those whose stiffness lies below -margin of the elastic one. A margin above
 * rounding is needed where a direction is neutral (a fallen stem may rotate about the vertical without any
 * work). */
struct wf_beam_stability {
    double margin;
    size_t negative;
    double bears; /* largest force carried at the base of an element found unstable, including all above it
                     [N] */
};

/* Factors kept to solve for small extra loads about the present state (solve/beam_small.h). */
struct wf_beam_small {
    real R[6][6];  /* y = R d, d: change of moment at the Gauss points at a fixed base */
    real P[6][6];  /* change of the end by y */
    real T[6][6];  /* change of the base wrench by y, through the part above and the loads */
    real Vn[2][9]; /* dn_end -> d(r' x n) */
    real Y[2][9];  /* spin -> dr' */
    real n[2][3];  /* force */
};
#endif
