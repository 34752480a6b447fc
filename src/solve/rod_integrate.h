#ifndef WF_SOLVE_ROD_INTEGRATE_H
#define WF_SOLVE_ROD_INTEGRATE_H
/* One piece of rod as an initial-value problem in arc length, by GSL's adaptive steppers.
 *
 * With t the unit tangent, L the turn from the unloaded state, n and m the force and moment the upper part
 * puts on the section, f the load per length:  r' = t,  L' = [k] L,  n' = -f(r, t),  m' = -t x n,
 * k = m/EI across t and m/GJ along it. L is carried as a unit quaternion.
 *
 * As printed (Feng et al. 1999, eqs 2 and 3): angles phi, theta, psi about the axes e1 (tangent), e2, e3 of
 * the piece's base, tangent (cos theta cos phi, cos theta sin phi, -sin theta). With the bending stiffness EI
 * for the paper's beta and gamma, GJ for its Omega, and C1, C2, C3 the moments about e3, e2, e1: phi'' = (C1'
 * cos phi + C2' sin phi)/(EI cos theta), theta'' = (C2' cos phi - C1' sin phi)/(EI cos theta), psi'' = C3'/GJ
 * + phi'' sin theta. The paper prints the last one with theta' and without agreement of units; its own
 * derivation is elsewhere. */
#include "solve/rod_piece.h"
#include <gsl/gsl_odeiv2.h>

enum { WF_ROD_FRAME = 16, WF_ROD_ANGLES = 18, WF_ROD_VARIED = 157 };

struct wf_rod_integrator {
    const struct wf_tree *tree;
    const struct wf_loads *loads;
    struct wf_arena *arena; /* for the steps */
    bool printed;
    bool fixed; /* take the steps kept with the pieces again */
    gsl_odeiv2_driver *state, *varied;
    gsl_odeiv2_system state_system, varied_system;
    struct wf_rod_piece *piece; /* under way */
    double axis[3];             /* its unloaded tangent, where straight */
    double base[4], frame[9];   /* base turn; columns e1, e2, e3 of the loaded base (angles)   */
    double place[3];            /* base place                                                  */
    double ei, gj;              /* of the whole row, as printed: a segment is uniform          */
    const char *fault;          /* why it stopped; NULL = a step could not be taken            */
};

/* t, l and the arena stay where they are. WF_ENOMEM. */
enum wf_status wf_rod_open(struct wf_rod_integrator *g, const struct wf_tree *t, const struct wf_loads *l,
                           bool printed, struct wf_arena *a, struct wf_err *e);
void wf_rod_close(struct wf_rod_integrator *g);
/* Error accepted a step, in the piece's measure (lengths by h, forces by EI/h2, turns). */
void wf_rod_accuracy(struct wf_rod_integrator *g, double error);

/* From the base to the end of a piece. Returned: *end, *wrench at the end, tally[3]: moment of the piece's
 * line load about its base [N m]. false when the integration fails. */
bool wf_rod_along(struct wf_rod_integrator *g, struct wf_rod_piece *p, const struct wf_rod_pose *base,
                  const struct wf_rod_wrench *at, struct wf_rod_pose *end, struct wf_rod_wrench *wrench,
                  double tally[3]);

/* Derivative of the end (place, spin, force, moment) by the base (the same), row-major 12 x 12, of the
 * frame's equations. */
bool wf_rod_vary(struct wf_rod_integrator *g, struct wf_rod_piece *p, const struct wf_rod_pose *base,
                 const struct wf_rod_wrench *at, double J[144]);
#endif
