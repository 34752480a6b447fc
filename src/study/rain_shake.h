/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_RAIN_SHAKE_H
#define WF_STUDY_RAIN_SHAKE_H
/* Leaves in wind and rain: the push of the wind on the blades, and what a leaf's own motion does to the drops
 * on it. Not of the paper, whose wind slants the fall alone. */
#include "study/rain_scene.h"

struct wf_shake {
    size_t sections;  /* of the blades, leaf by leaf: vein + 1 each                       */
    double *area;     /* vein + 1: of the half of the strip that a section carries [m2]   */
    double *across;   /* vein + 1: its middle, from the vein [m]                          */
    double *velocity; /* 3 sections: at the end of the step before [m/s]                  */
    double *felt;     /* 3 sections: acceleration as drops feel it [m s-2]                */
    double *pull;     /* sections: effective gravity over gravity [-]                     */
    double (*up)[3];  /* sections: effective upward vector in the section's frame [-]     */
    double *force;    /* 9 of the prisms' sections: of the wind in this step [N]          */
    double *was;      /* 9 of them: places before the step [m]                            */
};

/* Memory for a scene. Errors: WF_ENOMEM. */
enum wf_status wf_shake_make(const struct wf_rain_scene *s, struct wf_arena *a, struct wf_shake *out,
                             struct wf_err *e);
/* Push of a horizontal wind on both halves of every blade, by its part along the half's normal and relative
 * to the leaf: 1/2 rho Cd A |un| un with Cd 1.2 of a plate (assumed) and rho 1.2 kg/m3. It is added to load
 * and kept; wf_shake_work gives its work of the step. */
void wf_shake_wind(struct wf_shake *k, const struct wf_rain_scene *s, const double *x, const double *v,
                   const double wind[2], double *load);
double wf_shake_work(const struct wf_shake *k, const struct wf_rain_scene *s, const double *x);
/* Effective gravity on every leaf: gravity less the acceleration of its sections since wf_shake_begin,
 * smoothed over the time in which a drop of 3 mm gives way (assumed 2.4 ms, by its frequency of 66 Hz). */
void wf_shake_move(struct wf_shake *k, const struct wf_rain_scene *s, const double *x, const double *v,
                   double step, double gravity);
/* Begin a step: velocities after the drops have struck. An impact moves a leaf and what sticks to it
 * together: its jump is no acceleration. */
void wf_shake_begin(struct wf_shake *k, const struct wf_rain_scene *s, const double *v);
/* How leaf `leaf` lies in it. */
struct wf_leaf_lie wf_shake_lie(const struct wf_shake *k, const struct wf_rain_scene *s, size_t leaf);
#endif
