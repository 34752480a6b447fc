/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_ROD_INTEGRATE_H
#define WF_SOLVE_ROD_INTEGRATE_H
/* Pieces of rods: each row of a tree is cut into equal arcs, short enough for shooting, and each arc is
 * integrated. */
#include "base/arena.h"
#include "base/vec3.h"
#include "data/tree.h"
#include "load/load.h"
#include <gsl/gsl_odeiv2.h>
#include <stdint.h>

struct wf_rod_pose {
    double r[3],
        q[4]; /* position [m]; rotation from the unloaded to the loaded state, unit quaternion (w, x, y, z) */
};
struct wf_rod_wrench {
    double n[3], m[3]; /* force [N] and moment [N m] that the upper part exerts on a section */
};

struct wf_rod_piece {
    int32_t parent; /* piece below; -1 = ground */
    int32_t row;
    bool last;         /* the row ends here */
    double s0, s1;     /* share of the row's arc at base and end */
    double h;          /* arc length [m] */
    double stiffness;  /* bending stiffness that scales force and moment [N m2] */
    double first_step; /* last step the integrator took here, share of the piece */
    double *step;      /* all steps taken, see rod_integrate.c */
    size_t steps, room;
};

/* Section of a row at fraction s of its arc. */
struct wf_rod_section {
    double ei, gj; /* [N m2] */
    struct wf_line_point line;
    double dead[3]; /* dead line load [N/m] */
};
/* Given: tree, loads (dead line load), row, s (0..1). Returned: *out. */
void wf_rod_section_at(const struct wf_tree *t, const struct wf_loads *l, size_t row, double s,
                       struct wf_rod_section *out);

/* Cut the rows into pieces. Given: tree, loads, least number of pieces per row. Returned: *n pieces in the
 * order of the rows, from the arena; NULL when out of memory. A row under the force N of everything above it
 * is cut so that h sqrt(N/EI), the exponent by which an error at the base grows along a piece, stays below
 * 1.5. */
struct wf_rod_piece *wf_rod_cut(const struct wf_tree *t, const struct wf_loads *l, int32_t least,
                                struct wf_arena *a, size_t *n);

/* out = v rotated by the unit quaternion q */
static inline void wf_rod_turn(const double q[4], const double v[3], double out[3])
{
    double c[3], d[3];
    wf_cross(q + 1, v, c);
    for (int k = 0; k < 3; k++) c[k] += q[0] * v[k];
    wf_cross(q + 1, c, d);
    for (int k = 0; k < 3; k++) out[k] = v[k] + 2 * d[k];
}

/* out = a b, product of quaternions: rotation b, then a */
static inline void wf_rod_times(const double a[4], const double b[4], double out[4])
{
    double c[3], s = a[0] * b[0] - wf_dot(a + 1, b + 1);
    wf_cross(a + 1, b + 1, c);
    for (int k = 0; k < 3; k++) c[k] += a[0] * b[1 + k] + b[0] * a[1 + k];
    out[0] = s;
    memcpy(out + 1, c, sizeof c);
}

/* exp of half a rotation vector */
static inline void wf_rod_quaternion(const double v[3], double q[4])
{
    double angle = sqrt(wf_dot(v, v)), s = angle > 1e-8 ? sin(0.5 * angle) / angle : 0.5;
    q[0] = cos(0.5 * angle);
    for (int k = 0; k < 3; k++) q[1 + k] = s * v[k];
}

/* rotation vector of a unit quaternion, angle in 0..pi */
static inline void wf_rod_vector(const double q[4], double v[3])
{
    double size = sqrt(wf_dot(q + 1, q + 1)), sign = q[0] < 0 ? -1 : 1;
    double f = size > 1e-150 ? sign * 2 * atan2(size, fabs(q[0])) / size : 2 * sign;
    for (int k = 0; k < 3; k++) v[k] = f * q[1 + k];
}

/* One piece of rod as an initial-value problem in arc length, by GSL's adaptive steppers.
 *
 * With t the unit tangent, L the rotation from the unloaded state, n and m the force and moment that the
 * upper part exerts on the section, f the load per length:  r' = t,  L' = [k] L,  n' = -f(r, t),  m' = -t x
 * n, k = m/EI across t and m/GJ along it. L is represented by a unit quaternion.
 *
 * As printed (Feng et al. 1999, eqs 2 and 3): angles phi, theta, psi about the axes e1 (tangent), e2, e3 of
 * the piece's base, tangent (cos theta cos phi, cos theta sin phi, -sin theta). With the bending stiffness
 * EI for the paper's beta and gamma, GJ for its Omega, and C1, C2, C3 the moments about e3, e2, e1: phi'' =
 * (C1' cos phi + C2' sin phi)/(EI cos theta), theta'' = (C2' cos phi - C1' sin phi)/(EI cos theta), psi'' =
 * C3'/GJ + phi'' sin theta. The paper prints the last equation with theta' and with inconsistent units; its
 * derivation is not in the paper. */

enum { WF_ROD_FRAME = 16, WF_ROD_ANGLES = 18, WF_ROD_VARIED = 157 };

struct wf_rod_integrator {
    const struct wf_tree *tree;
    const struct wf_loads *loads;
    struct wf_arena *arena; /* for the steps */
    bool printed;
    bool fixed; /* repeat the steps kept with the pieces */
    gsl_odeiv2_driver *state, *varied;
    gsl_odeiv2_system state_system, varied_system;
    struct wf_rod_piece *piece; /* under way */
    double axis[3];             /* its unloaded tangent, of a straight row */
    double base[4], frame[9];   /* rotation of the base; columns e1, e2, e3 of the loaded base (angles) */
    double place[3];            /* base position [m] */
    double ei, gj;              /* of the whole row: as printed, a segment is uniform */
    const char *fault;          /* why it stopped; NULL = a step could not be taken */
};

/* Open an integrator. t, l and the arena must outlive it. Errors: WF_ENOMEM. */
enum wf_status wf_rod_open(struct wf_rod_integrator *g, const struct wf_tree *t, const struct wf_loads *l,
                           bool printed, struct wf_arena *a, struct wf_err *e);
void wf_rod_close(struct wf_rod_integrator *g);
/* Error accepted per step, in the piece's units (lengths by h, forces by EI/h2, rotations). */
void wf_rod_accuracy(struct wf_rod_integrator *g, double error);

/* Integrate from the base to the end of a piece. Returned: *end, *wrench at the end, tally[3]: moment of the
 * piece's line load about its base [N m]; false when the integration fails. */
bool wf_rod_along(struct wf_rod_integrator *g, struct wf_rod_piece *p, const struct wf_rod_pose *base,
                  const struct wf_rod_wrench *at, struct wf_rod_pose *end, struct wf_rod_wrench *wrench,
                  double tally[3]);

/* Derivative of the end (position, spin, force, moment) by the base (the same), row-major 12 x 12, for the
 * quaternion equations; false when the integration fails. */
bool wf_rod_vary(struct wf_rod_integrator *g, struct wf_rod_piece *p, const struct wf_rod_pose *base,
                 const struct wf_rod_wrench *at, double J[144]);
#endif
