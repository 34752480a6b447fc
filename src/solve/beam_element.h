/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_ELEMENT_H
#define WF_SOLVE_BEAM_ELEMENT_H
/* One geometrically exact rod element (Simo 1985, Comput. Methods Appl. Mech. Eng. 49:55; Antman 2005,
 * Nonlinear Problems of Elasticity, ch. 8), by two-stage Gauss collocation.
 *
 * Along the arc length s of the unloaded axis the rotation L(s) from the unloaded to the loaded state, the
 * place r(s), and the force n(s) and moment m(s) that the upper part puts on the section obey L' = [k]x L, r'
 * = L t + g,  n' = -f(r, L t),  m' = -r' x n,   k = G m,  g = H n, with t the unloaded tangent, f the load
 * per unit length, G and H the section's compliances in bending/torsion and stretch/shear, all in global
 * axes. Within an element L(s) = exp(v(s)) L(base); the rotation vector v is a quadratic in s fixed by its
 * values at the two Gauss points. Gauss collocation makes place, rotation, force and moment at the element's
 * ends accurate to h^4, keeps the balance of forces and moments exact on every mesh, and has no locking,
 * because the section's compliances may be zero.
 *
 * G is 1/EI across and 1/GJ along the axis; a section that is not round has another 1/EI about its width,
 * whose direction turns with it, and weight that hangs to one side of the axis adds its moment per length to
 * -m' (struct wf_beam_flat).
 *
 * Unknown are only the two rotation vectors. For a given shape the internal forces follow by sums from the
 * tips down; what is left is the material law k = G m, solved by Newton with its exact derivative (but for
 * the effect of stretch on the load within one element, of relative size (r/h)^2 and below). */
#include "base/vec3.h"
#include "load/load.h"
#include "solve/beam_mesh.h"

struct wf_beam_pose {
    double r[3], L[9];
};
struct wf_beam_shape { /* unknowns; in the axes that turn with the element's base */
    double v[2][3];    /* rotation vector at the Gauss points      */
    double g[2][3];    /* stretch and shear strain there           */
};
struct wf_beam_stage {                 /* the bent element at its Gauss points     */
    double r[2][3], rp[2][3], t[2][3]; /* place, r' and unit tangent    */
};
struct wf_beam_wrench {
    double n[3], m[3];
};
/* Change of the wrench a part hands down for a change p = (place, spin) of its base: K p + k. */
struct wf_beam_reaction {
    double K[6][6], k[6];
};
/* How the element's Gauss points answer a change p of its base: spins relative to the base X p + x. */
struct wf_beam_answer {
    double X[6][6], x[6];
};

/* Place the element on its base: stages and end. */
void wf_beam_place(const struct wf_beam_part *p, const struct wf_beam_shape *u,
                   const struct wf_beam_pose *base, struct wf_beam_stage *s, struct wf_beam_pose *end);

/* Turn what is not round with the element: *flat comes from the mesh. */
void wf_beam_turn(const struct wf_beam_shape *u, const double base_L[9], struct wf_beam_flat *flat);

/* Moment of the burden's weight about the axis, per length [N m/m]; zero for flat NULL. */
void wf_beam_couple(const struct wf_beam_flat *flat, double couple[2][3]);

/* The element's loads at its stages, with their derivatives. */
void wf_beam_load(const struct wf_beam_part *p, const struct wf_loads *l, const struct wf_beam_stage *s,
                  struct wf_line_load load[2]);

/* Internal forces at the stages and at the base, from those at the end.  h: length [m]; flat: NULL = round.
 */
void wf_beam_balance(double h, const struct wf_beam_stage *s, const struct wf_beam_flat *flat,
                     const struct wf_line_load load[2], const struct wf_beam_wrench *end,
                     struct wf_beam_wrench at[2], struct wf_beam_wrench *base);

/* Creep that stiffens an element while it moves: the moment of the material law becomes
 * G^-1 ((1 + rate) k - rate k0), with k0 the curvature (base axes) it starts from. rate = 0: elastic. */
struct wf_beam_creep {
    double rate;
    const double (*k0)[3];
};

/* Curvature change k at the Gauss points in base axes [1/m]. */
void wf_beam_curvature(const struct wf_beam_part *p, const struct wf_beam_shape *u, double k[2][3]);

/* How far the material law is missed. */
struct wf_beam_misfit {
    double bending; /* energy of the missing curvature, h/4 sum (k - G m).G^-1 (k - G m) [J] */
    double energy;  /* h/4 sum m.G m [J], to measure it by; m at least what rounding of n makes */
    double strain;  /* largest |H n - g| [-]                                                   */
    double turn;    /* largest |h G m| or |H n|, to measure the strain by [-]                  */
};

/* Unstable directions: those whose stiffness lies below -margin of the elastic one. A margin above rounding
 * is for answers with a neutral direction (a fallen stem may turn about the vertical at no cost). */
struct wf_beam_stability {
    double margin;
    size_t negative;
    double bears; /* largest force on the base of an element found unstable, with all above it [N] */
};

/* What it takes to answer small extra loads about the present state (beam_vibrate.c). */
struct wf_beam_small {
    double R[6][6];  /* y = R d, d: change of moment at the Gauss points at a fixed base           */
    double P[6][6];  /* change of the end by y                                                    */
    double T[6][6];  /* change of the wrench handed down by y, through the part above and the loads */
    double Vn[2][9]; /* dn_end -> d(r' x n)                                                       */
    double Y[2][9];  /* spin -> dr'                                                               */
    double n[2][3];  /* force                                                                     */
};
#endif
