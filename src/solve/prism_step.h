/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_PRISM_STEP_H
#define WF_SOLVE_PRISM_STEP_H
/* Prisms in time: explicit Euler as printed, and an implicit midpoint step that keeps energy. Damping is
 * D = c M: every motion loses energy at the rate c; a motion of frequency f has the ratio c/(4 pi f). */
#include "solve/prism.h"

enum wf_prism_method { WF_PRISM_MIDPOINT, WF_PRISM_EULER };

/* Work done since the start [J]. Over every step: change of kinetic and of spring energy
 *   = weight + load + pushes - damping + solver.
 * solver: what the iterations left; of Euler, what the method adds by itself. */
struct wf_prism_work {
    double weight, load, push, damping, solver;
};

struct wf_prism_motion {
    const struct wf_prism *p;
    enum wf_prism_method method;
    double step;      /* [s] */
    double damping;   /* c [1/s] */
    double internal;  /* of dashpots beside the springs, over their constants: a motion of angular frequency w
                       * gains the ratio internal w/2 [s]; midpoint alone */
    double tolerance; /* of the midpoint equations, over the size of the axes; 0: 1e-13 */
    double gravity;   /* [m s-2] */
    double time;      /* [s] */
    double *x, *v;    /* 9 sections: places [m] and velocities [m/s]; change them only by wf_prism_push */
    double *load;     /* 9 sections: forces of the drops, set by the caller before a step [N] */
    double kinetic, spring; /* energies now [J] */
    struct wf_prism_work work;
    size_t steps, iterations, factors; /* taken; of all steps */
    struct wf_prism_stepper *of;       /* memory of the method */
};

/* Largest stable step of explicit Euler [s]: c/omega^2 = 2 zeta/omega with the highest frequency omega and
 * its damping ratio zeta; 0 where there is no damping. */
double wf_prism_euler_limit(double damping, double fastest);

/* Begin at x (NULL: the rest places), at rest. Given: *m with p, method, step, damping, gravity. Returned:
 * the rest of *m, in the arena. Errors: WF_EUSAGE for a step that is not positive, a negative damping, and
 * for an explicit step above its limit, which is named; WF_ENOMEM. */
enum wf_status wf_prism_begin(struct wf_prism_motion *m, const double *x, struct wf_arena *a,
                              struct wf_err *e);
/* One step. Errors: WF_ENOCONV when the equations of the step cannot be solved. */
enum wf_status wf_prism_advance(struct wf_prism_motion *m, struct wf_err *e);

/* Shares of up to 6 vertices in a point of a blade or an axis. */
struct wf_prism_point {
    int32_t vertex[6];
    double share[6];
    size_t n;
};
void wf_prism_at(const struct wf_prism_point *q, const double *x,
                 double out[3]); /* of places or velocities */
void wf_prism_put(const struct wf_prism_point *q, const double force[3], double *f);
/* Inverse of the mass that a push at a point feels, the same in every direction [1/kg]. */
double wf_prism_yield(const struct wf_prism *p, const struct wf_prism_point *q);
/* An impulse [N s] at a point: velocities change at once, the energy it gives is booked as a push.
 * Returned: that energy [J]. */
double wf_prism_push(struct wf_prism_motion *m, const struct wf_prism_point *q, const double impulse[3]);
#endif
